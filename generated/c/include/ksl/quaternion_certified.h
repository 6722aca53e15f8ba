/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_QUATERNION_CERTIFIED_H
#define KSL_QUATERNION_CERTIFIED_H

#include "ksl_types.h"
#include "ksl_exact.h"
#include "ksl_exactf.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_quaternion_scale_certified(ksl_quaternion_t *self, const double a,
    ksl_quaternion_t *self_bound) {
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

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.
   8 mul, 12 add, 8 abs. */
static inline void ksl_axpy_qq_certified(const double a, const ksl_quaternion_t *x,
    ksl_quaternion_t *y, ksl_quaternion_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z;
  const double y_3_new_a = KSL_MUL(a, x->w), y_3_new = y_3_new_a + y->w;
  const double y_0_new_size = fabs(y_0_new_a) + fabs(y->x),
      y_1_new_size = fabs(y_1_new_a) + fabs(y->y), y_2_new_size = fabs(y_2_new_a) + fabs(y->z),
      y_3_new_size = fabs(y_3_new_a) + fabs(y->w);
  const double y_0_new_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_size
          + 2.004168360008973e-292),
      y_1_new_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_size + 2.004168360008973e-292),
      y_2_new_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_size + 2.004168360008973e-292),
      y_3_new_bound = KSL_MUL(2.2204460492503136e-16, y_3_new_size + 2.004168360008973e-292);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
  y_bound->w = y_3_new_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->y, v->z), c_0b = KSL_MUL(q->z, v->y), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->z, v->x), c_1b = KSL_MUL(q->x, v->z), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->x, v->y), c_2b = KSL_MUL(q->y, v->x), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL(q->y, t_2) - KSL_MUL(q->z, t_1) + KSL_MUL(q->w, t_0);
  const double turn_1 = KSL_MUL(q->z, t_0) - KSL_MUL(q->x, t_2) + KSL_MUL(q->w, t_1),
      turn_2 = KSL_MUL(q->x, t_1) - KSL_MUL(q->y, t_0) + KSL_MUL(q->w, t_2);
  const double vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  const double c_0_size = fabs(c_0a) + fabs(c_0b), c_1_size = fabs(c_1a) + fabs(c_1b),
      c_2_size = fabs(c_2a) + fabs(c_2b);
  const double t_0_size = KSL_MUL(2.0, c_0_size + 2.004168360008973e-292),
      t_1_size = KSL_MUL(2.0, c_1_size + 2.004168360008973e-292),
      t_2_size = KSL_MUL(2.0, c_2_size + 2.004168360008973e-292);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z);
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w),
      turn_0_size = KSL_MUL(q_1_abs, t_2_padded) + KSL_MUL(q_2_abs, t_1_padded)
          + KSL_MUL(q_3_abs, t_0_padded);
  const double q_0_abs = fabs(q->x),
      turn_1_size = KSL_MUL(q_2_abs, t_0_padded) + KSL_MUL(q_0_abs, t_2_padded)
          + KSL_MUL(q_3_abs, t_1_padded);
  const double turn_2_size = KSL_MUL(q_0_abs, t_1_padded) + KSL_MUL(q_1_abs, t_0_padded)
          + KSL_MUL(q_3_abs, t_2_padded);
  const double vo_0_size = fabs(v->x) + turn_0_size, vo_1_size = fabs(v->y) + turn_1_size,
      vo_2_size = fabs(v->z) + turn_2_size;
  const double vo_0_bound = KSL_MUL(7.7715611723761e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(7.7715611723761e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(7.7715611723761e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qconjv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->z, v->y), c_0b = KSL_MUL(q->y, v->z), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->x, v->z), c_1b = KSL_MUL(q->z, v->x), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->y, v->x), c_2b = KSL_MUL(q->x, v->y), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL(q->z, t_1) - KSL_MUL(q->y, t_2) + KSL_MUL(q->w, t_0);
  const double turn_1 = KSL_MUL(q->x, t_2) - KSL_MUL(q->z, t_0) + KSL_MUL(q->w, t_1),
      turn_2 = KSL_MUL(q->y, t_0) - KSL_MUL(q->x, t_1) + KSL_MUL(q->w, t_2);
  const double vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  const double c_0_size = fabs(c_0a) + fabs(c_0b), c_1_size = fabs(c_1a) + fabs(c_1b),
      c_2_size = fabs(c_2a) + fabs(c_2b);
  const double t_0_size = KSL_MUL(2.0, c_0_size + 2.004168360008973e-292),
      t_1_size = KSL_MUL(2.0, c_1_size + 2.004168360008973e-292),
      t_2_size = KSL_MUL(2.0, c_2_size + 2.004168360008973e-292);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y);
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w),
      turn_0_size = KSL_MUL(q_2_abs, t_1_padded) + KSL_MUL(q_1_abs, t_2_padded)
          + KSL_MUL(q_3_abs, t_0_padded);
  const double q_0_abs = fabs(q->x),
      turn_1_size = KSL_MUL(q_0_abs, t_2_padded) + KSL_MUL(q_2_abs, t_0_padded)
          + KSL_MUL(q_3_abs, t_1_padded);
  const double turn_2_size = KSL_MUL(q_1_abs, t_0_padded) + KSL_MUL(q_0_abs, t_1_padded)
          + KSL_MUL(q_3_abs, t_2_padded);
  const double vo_0_size = fabs(v->x) + turn_0_size, vo_1_size = fabs(v->y) + turn_1_size,
      vo_2_size = fabs(v->z) + turn_2_size;
  const double vo_0_bound = KSL_MUL(7.7715611723761e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(7.7715611723761e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(7.7715611723761e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->y, q2i->z),
      qo_0c = KSL_MUL(q1i->z, q2i->y), qo_0f = KSL_MUL(q1i->w, q2i->x),
      qo_0 = qo_0a + (qo_0b - qo_0c) + qo_0f;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1f = KSL_MUL(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b + qo_1d + qo_1f;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2f = KSL_MUL(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b + qo_2d + qo_2f;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e);
  const double qo_0_size = fabs(qo_0a) + (fabs(qo_0b) + fabs(qo_0c)) + fabs(qo_0f),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d) + fabs(qo_1f),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d) + fabs(qo_2f),
      qo_3_size = fabs(qo_3a) + (fabs(qo_3b) + fabs(qo_3c) + fabs(qo_3e));
  const double qo_0_bound = KSL_MUL(4.440892098500628e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(4.440892098500628e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(4.440892098500628e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(4.440892098500628e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qqconj_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->w, q2i->x),
      qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0e = KSL_MUL(q1i->y, q2i->z),
      qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e);
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1e = KSL_MUL(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e);
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2e = KSL_MUL(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e);
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3d = KSL_MUL(q1i->z, q2i->z), qo_3f = KSL_MUL(q1i->w, q2i->w),
      qo_3 = qo_3a + qo_3b + qo_3d + qo_3f;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b) + (fabs(qo_0d) + fabs(qo_0e)),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + (fabs(qo_1d) + fabs(qo_1e)),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + (fabs(qo_2d) + fabs(qo_2e)),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b) + fabs(qo_3d) + fabs(qo_3f);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(4.440892098500628e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qconjq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->w, q2i->x), qo_0b = KSL_MUL(q1i->x, q2i->w),
      qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0e = KSL_MUL(q1i->y, q2i->z),
      qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e);
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1d = KSL_MUL(q1i->w, q2i->y), qo_1e = KSL_MUL(q1i->y, q2i->w),
      qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e);
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2d = KSL_MUL(q1i->w, q2i->z), qo_2e = KSL_MUL(q1i->z, q2i->w),
      qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e);
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3d = KSL_MUL(q1i->z, q2i->z), qo_3f = KSL_MUL(q1i->w, q2i->w),
      qo_3 = qo_3a + qo_3b + qo_3d + qo_3f;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b) + (fabs(qo_0d) + fabs(qo_0e)),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + (fabs(qo_1d) + fabs(qo_1e)),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + (fabs(qo_2d) + fabs(qo_2e)),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b) + fabs(qo_3d) + fabs(qo_3f);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(4.440892098500628e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qconjqconj_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->y, q2i->z), qo_0b = KSL_MUL(q1i->z, q2i->y),
      qo_0d = KSL_MUL(q1i->x, q2i->w), qo_0f = KSL_MUL(q1i->w, q2i->x),
      qo_0 = qo_0a - qo_0b - qo_0d - qo_0f;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1f = KSL_MUL(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b - qo_1d - qo_1f;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2f = KSL_MUL(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b - qo_2d - qo_2f;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e);
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b) + fabs(qo_0d) + fabs(qo_0f),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d) + fabs(qo_1f),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d) + fabs(qo_2f),
      qo_3_size = fabs(qo_3a) + (fabs(qo_3b) + fabs(qo_3c) + fabs(qo_3e));
  const double qo_0_bound = KSL_MUL(4.440892098500628e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(4.440892098500628e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(4.440892098500628e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(4.440892098500628e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qxq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->z), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qxqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qxconjq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->w), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->y), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qxconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b;
  const double qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqx_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->y, dci[0]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqxconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqx_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->w, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_2_size = fabs(qo_2a) + fabs(qo_2b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqxconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(qi->z, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_1_size = fabs(qo_1a) + fabs(qo_1b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qyq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->x), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qyqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_1_size = fabs(qo_1a) + fabs(qo_1b), qo_2_size = fabs(qo_2a) + fabs(qo_2b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qyconjq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->z), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->w), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qyconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqy_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqyconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->x, dci[0]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqy_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->z, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->w, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqyconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qzq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->y), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qzqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_2_size = fabs(qo_2a) + fabs(qo_2b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qzconjq_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->x), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->w), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qzconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b;
  const double qo_1_size = fabs(qo_1a) + fabs(qo_1b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqz_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]), qo_0 = qo_0a + qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->x, dci[0]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a + qo_2b;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_quaternion_product_qqzconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a + qo_1b;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_1_size = fabs(qo_1a) + fabs(qo_1b),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqz_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->w, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_1_size = fabs(qo_1a) + fabs(qo_1b), qo_2_size = fabs(qo_2a) + fabs(qo_2b),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_0a) + fabs(qo_0b)
          + 2.004168360008973e-292);
  const double qo_1_bound = KSL_MUL(2.2204460492503136e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(2.2204460492503136e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqzconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->y, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]),
      qo_1 = -(qo_1a + qo_1b);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]),
      qo_2 = -(qo_2a + qo_2b);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b), qo_3_size = fabs(qo_3a) + fabs(qo_3b);
  const double qo_0_bound = KSL_MUL(2.2204460492503136e-16, qo_0_size + 2.004168360008973e-292);
  const double qo_1c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_1a) + fabs(qo_1b)
          + 2.004168360008973e-292);
  const double qo_2c_bound = KSL_MUL(2.2204460492503136e-16, fabs(qo_2a) + fabs(qo_2b)
          + 2.004168360008973e-292);
  const double qo_3_bound = KSL_MUL(2.2204460492503136e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_quaternion_product_qv_certified(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->y, vi->z), qo_0b = KSL_MUL(qi->z, vi->y),
      qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0a - qo_0b + qo_0d;
  const double qo_1a = KSL_MUL(qi->z, vi->x), qo_1b = KSL_MUL(qi->x, vi->z),
      qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1a - qo_1b + qo_1d;
  const double qo_2a = KSL_MUL(qi->x, vi->y), qo_2b = KSL_MUL(qi->y, vi->x),
      qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2a - qo_2b + qo_2d;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y),
      qo_3d = KSL_MUL(qi->z, vi->z), qo_3 = -(qo_3a + qo_3b + qo_3d);
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b) + fabs(qo_0d),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292);
  const double qo_3e_bound = KSL_MUL(3.3306690738754706e-16, fabs(qo_3a) + fabs(qo_3b)
          + fabs(qo_3d) + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3e_bound;
}

/* qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 12 abs. */
static inline void ksl_quaternion_product_qconjv_certified(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->z, vi->y), qo_0b = KSL_MUL(qi->y, vi->z),
      qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0a - qo_0b + qo_0d;
  const double qo_1a = KSL_MUL(qi->x, vi->z), qo_1b = KSL_MUL(qi->z, vi->x),
      qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1a - qo_1b + qo_1d;
  const double qo_2a = KSL_MUL(qi->y, vi->x), qo_2b = KSL_MUL(qi->x, vi->y),
      qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2a - qo_2b + qo_2d;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y),
      qo_3d = KSL_MUL(qi->z, vi->z), qo_3 = qo_3a + qo_3b + qo_3d;
  const double qo_0_size = fabs(qo_0a) + fabs(qo_0b) + fabs(qo_0d),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b) + fabs(qo_3d);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(3.3306690738754706e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_quaternion_product_vq_certified(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->y, qi->z),
      qo_0c = KSL_MUL(vi->z, qi->y), qo_0 = qo_0a + (qo_0b - qo_0c);
  const double qo_1a = KSL_MUL(vi->z, qi->x), qo_1b = KSL_MUL(vi->x, qi->z),
      qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1a - qo_1b + qo_1d;
  const double qo_2a = KSL_MUL(vi->x, qi->y), qo_2b = KSL_MUL(vi->y, qi->x),
      qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2a - qo_2b + qo_2d;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y),
      qo_3d = KSL_MUL(vi->z, qi->z), qo_3 = -(qo_3a + qo_3b + qo_3d);
  const double qo_0_size = fabs(qo_0a) + (fabs(qo_0b) + fabs(qo_0c)),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292);
  const double qo_3e_bound = KSL_MUL(3.3306690738754706e-16, fabs(qo_3a) + fabs(qo_3b)
          + fabs(qo_3d) + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3e_bound;
}

/* qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 12 abs. */
static inline void ksl_quaternion_product_vqconj_certified(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->z, qi->y),
      qo_0c = KSL_MUL(vi->y, qi->z), qo_0 = qo_0a + (qo_0b - qo_0c);
  const double qo_1a = KSL_MUL(vi->x, qi->z), qo_1b = KSL_MUL(vi->z, qi->x),
      qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1a - qo_1b + qo_1d;
  const double qo_2a = KSL_MUL(vi->y, qi->x), qo_2b = KSL_MUL(vi->x, qi->y),
      qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2a - qo_2b + qo_2d;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y),
      qo_3d = KSL_MUL(vi->z, qi->z), qo_3 = qo_3a + qo_3b + qo_3d;
  const double qo_0_size = fabs(qo_0a) + (fabs(qo_0b) + fabs(qo_0c)),
      qo_1_size = fabs(qo_1a) + fabs(qo_1b) + fabs(qo_1d),
      qo_2_size = fabs(qo_2a) + fabs(qo_2b) + fabs(qo_2d),
      qo_3_size = fabs(qo_3a) + fabs(qo_3b) + fabs(qo_3d);
  const double qo_0_bound = KSL_MUL(3.3306690738754706e-16, qo_0_size + 2.004168360008973e-292),
      qo_1_bound = KSL_MUL(3.3306690738754706e-16, qo_1_size + 2.004168360008973e-292),
      qo_2_bound = KSL_MUL(3.3306690738754706e-16, qo_2_size + 2.004168360008973e-292),
      qo_3_bound = KSL_MUL(3.3306690738754706e-16, qo_3_size + 2.004168360008973e-292);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.
   q1i, q2i: quaternion (x, y, z, w), the scalar last; dot_bound: number.
   5 mul, 7 add, 4 abs. */
static inline double ksl_dot_qq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, double *dot_bound) {
  const double dot_a = KSL_MUL(q1i->x, q2i->x), dot_b = KSL_MUL(q1i->y, q2i->y),
      dot_d = KSL_MUL(q1i->z, q2i->z), dot_f = KSL_MUL(q1i->w, q2i->w),
      dot = dot_a + dot_b + dot_d + dot_f;
  const double dot_size = fabs(dot_a) + fabs(dot_b) + fabs(dot_d) + fabs(dot_f);
  const double dot_bound_ = KSL_MUL(4.440892098500628e-16, dot_size + 2.004168360008973e-292);
  *dot_bound = dot_bound_;
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_add_dpiToq_certified(const ksl_vec3_t *dpi, ksl_quaternion_t *qi,
    ksl_quaternion_t *qi_bound) {
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
  const double qi_0_new_a_padded = fabs(qi_0_new_a) + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w);
  const double qi_0_new_c_padded = fabs(qi_0_new_c) + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y);
  const double qi_0_new_e_padded = fabs(qi_0_new_e) + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z), qi_0_abs = fabs(qi->x),
      qi_0_new_size = KSL_MUL(qi_0_new_a_padded, qi_3_abs)
          + (KSL_MUL(qi_0_new_c_padded, qi_1_abs) + KSL_MUL(qi_0_new_e_padded, qi_2_abs))
          + qi_0_abs;
  const double qi_1_new_size = KSL_MUL(qi_0_new_a_padded, qi_2_abs)
          + KSL_MUL(qi_0_new_c_padded, qi_0_abs) + KSL_MUL(qi_0_new_e_padded, qi_3_abs) + qi_1_abs,
      qi_2_new_size = KSL_MUL(qi_0_new_e_padded, qi_0_abs) + KSL_MUL(qi_0_new_a_padded, qi_1_abs)
          + KSL_MUL(qi_0_new_c_padded, qi_3_abs) + qi_2_abs,
      qi_3_new_size = qi_3_abs
          + (KSL_MUL(qi_0_new_a_padded, qi_0_abs) + KSL_MUL(qi_0_new_e_padded, qi_1_abs)
          + KSL_MUL(qi_0_new_c_padded, qi_2_abs));
  const double qi_0_new_bound = KSL_MUL(5.551115123125785e-16, qi_0_new_size
          + 2.004168360008973e-292),
      qi_1_new_bound = KSL_MUL(5.551115123125785e-16, qi_1_new_size + 2.004168360008973e-292),
      qi_2_new_bound = KSL_MUL(5.551115123125785e-16, qi_2_new_size + 2.004168360008973e-292),
      qi_3_new_bound = KSL_MUL(5.551115123125785e-16, qi_3_new_size + 2.004168360008973e-292);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_bound;
  qi_bound->y = qi_1_new_bound;
  qi_bound->z = qi_2_new_bound;
  qi_bound->w = qi_3_new_bound;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
     qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_subtract_dpiFromq_certified(const ksl_vec3_t *dpi, ksl_quaternion_t *qi,
    ksl_quaternion_t *qi_bound) {
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
  const double qi_0_new_a_padded = fabs(qi_0_new_a) + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z);
  const double qi_0_new_c_padded = fabs(qi_0_new_c) + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y);
  const double qi_0_new_f_padded = fabs(qi_0_new_f) + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w), qi_0_abs = fabs(qi->x),
      qi_0_new_size = KSL_MUL(qi_0_new_a_padded, qi_2_abs) + KSL_MUL(qi_0_new_c_padded, qi_1_abs)
          + KSL_MUL(qi_0_new_f_padded, qi_3_abs) + qi_0_abs;
  const double qi_1_new_size = KSL_MUL(qi_0_new_c_padded, qi_0_abs)
          + KSL_MUL(qi_0_new_f_padded, qi_2_abs) + KSL_MUL(qi_0_new_a_padded, qi_3_abs) + qi_1_abs,
      qi_2_new_size = KSL_MUL(qi_0_new_f_padded, qi_1_abs) + KSL_MUL(qi_0_new_a_padded, qi_0_abs)
          + KSL_MUL(qi_0_new_c_padded, qi_3_abs) + qi_2_abs,
      qi_3_new_size = KSL_MUL(qi_0_new_f_padded, qi_0_abs) + KSL_MUL(qi_0_new_a_padded, qi_1_abs)
          + KSL_MUL(qi_0_new_c_padded, qi_2_abs) + qi_3_abs;
  const double qi_0_new_bound = KSL_MUL(5.551115123125785e-16, qi_0_new_size
          + 2.004168360008973e-292),
      qi_1_new_bound = KSL_MUL(5.551115123125785e-16, qi_1_new_size + 2.004168360008973e-292),
      qi_2_new_bound = KSL_MUL(5.551115123125785e-16, qi_2_new_size + 2.004168360008973e-292),
      qi_3_new_bound = KSL_MUL(5.551115123125785e-16, qi_3_new_size + 2.004168360008973e-292);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_bound;
  qi_bound->y = qi_1_new_bound;
  qi_bound->z = qi_2_new_bound;
  qi_bound->w = qi_3_new_bound;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
     unless inf or NaN.
   w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
   43 mul, 40 add, 11 abs. */
static inline void ksl_omega_to_dquaternion_certified(const ksl_vec3_t *w,
    const ksl_quaternion_t *qi, ksl_quaternion_t *dqo, ksl_quaternion_t *dqo_bound) {
  const double dqo_0a = KSL_MUL(0.5, w->x), dqo_0c = KSL_MUL(0.5, w->y),
      dqo_0e = KSL_MUL(0.5, w->z), dqo_0i = KSL_MUL(qi->x, qi->x), dqo_0k = KSL_MUL(qi->y, qi->y),
      dqo_0m = KSL_MUL(qi->z, qi->z), dqo_0o = KSL_MUL(qi->w, qi->w),
      dqo_0p = 1.0 - dqo_0i - dqo_0k - dqo_0m - dqo_0o,
      dqo_0 = KSL_MUL(dqo_0a, qi->w) + (KSL_MUL(dqo_0c, qi->z) - KSL_MUL(dqo_0e, qi->y))
          + KSL_MUL(qi->x, dqo_0p);
  const double dqo_1 = KSL_MUL(dqo_0e, qi->x) - KSL_MUL(dqo_0a, qi->z) + KSL_MUL(dqo_0c, qi->w)
          + KSL_MUL(qi->y, dqo_0p),
      dqo_2 = KSL_MUL(dqo_0a, qi->y) - KSL_MUL(dqo_0c, qi->x) + KSL_MUL(dqo_0e, qi->w)
          + KSL_MUL(qi->z, dqo_0p),
      dqo_3 = KSL_MUL(qi->w, dqo_0p)
          - (KSL_MUL(dqo_0a, qi->x) + KSL_MUL(dqo_0c, qi->y) + KSL_MUL(dqo_0e, qi->z));
  const double dqo_0a_padded = fabs(dqo_0a) + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w);
  const double dqo_0c_padded = fabs(dqo_0c) + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z);
  const double dqo_0e_padded = fabs(dqo_0e) + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y);
  const double dqo_0p_padded = 1.0 + fabs(dqo_0i) + fabs(dqo_0k) + fabs(dqo_0m) + fabs(dqo_0o)
          + 2.004168360008973e-292;
  const double qi_0_abs = fabs(qi->x),
      dqo_0h_size = KSL_MUL(dqo_0a_padded, qi_3_abs)
          + (KSL_MUL(dqo_0c_padded, qi_2_abs) + KSL_MUL(dqo_0e_padded, qi_1_abs)),
      dqo_0_size = dqo_0h_size + KSL_MUL(qi_0_abs, dqo_0p_padded);
  const double dqo_1_size = KSL_MUL(dqo_0e_padded, qi_0_abs) + KSL_MUL(dqo_0a_padded, qi_2_abs)
          + KSL_MUL(dqo_0c_padded, qi_3_abs) + KSL_MUL(qi_1_abs, dqo_0p_padded),
      dqo_2_size = KSL_MUL(dqo_0a_padded, qi_1_abs) + KSL_MUL(dqo_0c_padded, qi_0_abs)
          + KSL_MUL(dqo_0e_padded, qi_3_abs) + KSL_MUL(qi_2_abs, dqo_0p_padded);
  const double dqo_3f_size = KSL_MUL(dqo_0a_padded, qi_0_abs) + KSL_MUL(dqo_0c_padded, qi_1_abs)
          + KSL_MUL(dqo_0e_padded, qi_2_abs),
      dqo_3_size = KSL_MUL(qi_3_abs, dqo_0p_padded) + dqo_3f_size;
  const double dqo_0_bound = KSL_MUL(7.7715611723761e-16, dqo_0_size + 2.004168360008973e-292),
      dqo_1_bound = KSL_MUL(7.7715611723761e-16, dqo_1_size + 2.004168360008973e-292),
      dqo_2_bound = KSL_MUL(7.7715611723761e-16, dqo_2_size + 2.004168360008973e-292),
      dqo_3_bound = KSL_MUL(7.7715611723761e-16, dqo_3_size + 2.004168360008973e-292);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
  dqo_bound->x = dqo_0_bound;
  dqo_bound->y = dqo_1_bound;
  dqo_bound->z = dqo_2_bound;
  dqo_bound->w = dqo_3_bound;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.
   axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select. */
static inline void ksl_quaternion_from_axis_angle_certified(const ksl_vec3_t *axis,
    const double angle, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double half = KSL_MUL(0.5, angle);
  double qo_3; const double sine = ksl_sincos(half, &qo_3);
  double qo_own_error_1; const double sine_own_error_1 = ksl_sincos_error(half, sine, qo_3,
      &qo_own_error_1);
  const double sine_size_1 = 1.0 + (1.8051943758648296e-276 + KSL_MUL(0.5, fabs(angle)));
  const double qo_0 = KSL_MUL(axis->x, sine), qo_1 = KSL_MUL(axis->y, sine),
      qo_2 = KSL_MUL(axis->z, sine);
  const double qo_rest_1 = KSL_MUL(4.3017579231195054e-30, 1.8051943758648296e-276
          + KSL_MUL(fabs(axis->x), sine_size_1)),
      qo_rest_2 = KSL_MUL(4.3017579231195054e-30, 1.8051943758648296e-276
          + KSL_MUL(fabs(axis->y), sine_size_1)),
      qo_rest_3 = KSL_MUL(4.3017579231195054e-30, 1.8051943758648296e-276
          + KSL_MUL(fabs(axis->z), sine_size_1)),
      qo_bound_1 = fabs(ksl_product_error(axis->x, sine, qo_0)
          + KSL_MUL(axis->x, sine_own_error_1)) + qo_rest_1,
      qo_bound_2 = fabs(ksl_product_error(axis->y, sine, qo_1)
          + KSL_MUL(axis->y, sine_own_error_1)) + qo_rest_2,
      qo_bound_3 = fabs(ksl_product_error(axis->z, sine, qo_2)
          + KSL_MUL(axis->z, sine_own_error_1)) + qo_rest_3,
      qo_bound_4 = fabs(qo_own_error_1) + KSL_MUL(4.067564442213936e-30, sine_size_1);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_bound_1;
  qo_bound->y = qo_bound_2;
  qo_bound->z = qo_bound_3;
  qo_bound->w = qo_bound_4;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|
     <= axis_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; axis, axis_bound: vector; angle_bound: number.
   201 mul, 318 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4 copysign,
     35 less, 10 equal, 69 select. */
static inline double ksl_axis_angle_from_quaternion_certified(const ksl_quaternion_t *q,
    ksl_vec3_t *axis, double *angle_bound, ksl_vec3_t *axis_bound) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_inverse_1 = 1.0 / s,
      scaled_s_size_4 = fabs(scaled_s_0);
  const double scaled_s_1 = KSL_MUL(q->y, s), scaled_s_size_8 = fabs(scaled_s_1);
  const double scaled_s_2 = KSL_MUL(q->z, s), scaled_s_size_12 = fabs(scaled_s_2);
  const double scaled_s_3 = KSL_MUL(q->w, s),
      scaled_s_size_15 = q->w == KSL_MUL(scaled_s_3, scaled_s_inverse_1) ? 0.0 : 5e-324,
      scaled_s_size_16 = fabs(scaled_s_3);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0,
      upper_size_3 = 5e-324 + fabs(scaled_s_3 - 0.0),
      upper_size_7 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_4)
          + fabs(upper_0a - scaled_s_0),
      upper_size_8 = (q->x == KSL_MUL(scaled_s_0, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_7;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1,
      upper_size_14 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_8)
          + fabs(upper_1a - scaled_s_1),
      upper_size_15 = (q->y == KSL_MUL(scaled_s_1, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_14;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2,
      upper_size_21 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_12)
          + fabs(upper_2a - scaled_s_2),
      upper_size_22 = (q->z == KSL_MUL(scaled_s_2, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_21;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3,
      upper_size_29 = scaled_s_size_15
          + (KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_16)
          + fabs(upper_3a - scaled_s_3));
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double upper_size_18 = scaled_s_size_8
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_15);
  const double v_s_size_2 = fabs(upper_2);
  const double upper_size_25 = scaled_s_size_12
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_22);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s_b_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_s_size_padded_1 = 1.8051943758648296e-276
          + (scaled_s_size_4
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_8));
  const double v_y_1 = KSL_MUL(upper_1, v_s), v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0),
      v_n_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, fabs(v_y_0)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_a_padded_1))),
      v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(v_s_size_3, 1.8051943758648296e-276 + upper_size_18),
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, fabs(v_y_1)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_b_padded_1))),
      v_n_c = v_n_a + v_n_b, v_n_c_right_1 = v_n_c - v_n_a, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(v_s_size_3, 1.8051943758648296e-276 + upper_size_25),
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, fabs(v_y_2)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_d_padded_1))),
      v_n_e = v_n_c + v_n_d, v_n_e_right_1 = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1) + v_n_c_lo, v_n = sqrt(v_n_e),
      v_n_product_1 = KSL_MUL(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice_1),
      v_n_padded_1 = 1.8051943758648296e-276
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabs(v_n_e_lo) + KSL_MUL(7.235336013082471e-30, v_n_padded_1),
      v_n_size_4 = KSL_MUL(fabs(v_n_e) + KSL_MUL(140737488355328.0, v_n_bound_1), v_n_padded_1
          / v_n / v_n_e), v_n_size_6 = fabs(v_n_lo),
      v_n_size_8 = KSL_MUL(1.5970396877936164e+29, sqrt(v_n_bound_1) + v_n_size_6),
      v_n_size_12 = v_n + (KSL_MUL(4.0, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8);
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r_b_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n = KSL_MUL(v_n, v_r), n_lo = KSL_MUL(v_n - KSL_MUL(n, 1.0 / v_r) + v_n_lo, v_r),
      n_padded_1 = 1.8051943758648296e-276 + v_n_size_12;
  const double half = ksl_atan2(n, upper_3), half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, KSL_MUL(half_part1_1, half_part1_1)
          + KSL_MUL(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MUL(half_part1_1, n_lo) - KSL_MUL(half_part0_1, 0.0))
          / (half_most_1 == 0.0 ? 1.0 : half_divisor2_1),
      half_lo = ksl_atan2_error(n, upper_3, half) + half_more_1,
      half_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(n_padded_1, 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302
          : v_r_b_size_1),
      half_padded_2 = 1.8051943758648296e-276
          + (scaled_s_size_16
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_29)),
      half_size_2 = fabs(n), half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabs(n_lo) + KSL_MUL(6.859394487938082e-30, half_padded_1),
      half_rest_2 = KSL_MUL(3.254051621949822e-30, half_padded_2),
      half_size_11 = (half_rest_2 + (1.8051943758648296e-276 + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_15 = 7.0 + fabs(half_lo),
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MUL(4.875578158636172e+28, half_size_11 < 0.25 ? half_size_19
          : half_size_15);
  const double divisor = v_n == 0.0 ? 1.0 : v_n, divisor_lo = v_n == 0.0 ? 0.0 : v_n_lo,
      divisor_bound_1 = KSL_MUL(6.606712056056508e-30, n_padded_1) + v_n_size_6,
      divisor_size_3 = fabs(v_n - 0.0), divisor_size_7 = divisor_bound_1 + fabs(1.0 - v_n);
  const double unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MUL(unit_0, divisor),
      unit_lo_1 = (v_y_0 - unit_product_1 - ksl_product_error(unit_0, divisor, unit_product_1)
          - KSL_MUL(unit_0, divisor_lo)) / divisor;
  const double divisor_size_10 = (v_n == 0.0 ? 1.0 : v_n_size_12)
          + KSL_MUL(9.054644677292507e+28, divisor_bound_1 < divisor_size_3 ? 0.0 : divisor_size_7);
  const double unit_padded_1 = 1.8051943758648296e-276 + divisor_size_10,
      unit_size_1 = fabs(unit_0), unit_size_2 = fabs(divisor),
      unit_bound_1 = fabs(divisor_lo) + KSL_MUL(1.1389183198259759e-29, unit_padded_1),
      unit_size_7 = KSL_MUL(4.0, unit_bound_1) < unit_size_2 ? unit_size_2 : 0.0,
      unit_reach_1 = unit_size_2 + KSL_MUL(140737488355328.0, unit_bound_1),
      unit_size_11 = unit_size_1
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_1) + v_n_a_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MUL(unit_1, divisor),
      unit_size_12 = fabs(unit_1);
  const double unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MUL(unit_2, divisor),
      unit_size_19 = fabs(unit_2);
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0,
      axis_size_4 = fabs(unit_lo_1)
          + KSL_MUL(1.6442825652790928e-29, 1.8051943758648296e-276 + unit_size_11)
          + fabs(1.0 - unit_0);
  const double angle_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(2.0, fabs(half) + (half_padded_1 + half_padded_2) / half_size_5 + half_size_21);
  const double axis_size_7 = (v_n == 0.0 ? 1.0 : unit_size_11)
          + KSL_MUL(6.250354999637554e+28, divisor_bound_1 < divisor_size_3 ? 0.0 : axis_size_4);
  const double unit_size_18 = unit_size_12
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_12) + v_n_b_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_error_2 = fabs((v_y_1 - unit_product_2
          - ksl_product_error(unit_1, divisor, unit_product_2) - KSL_MUL(unit_1, divisor_lo))
          / divisor);
  const double unit_size_25 = unit_size_19
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_19) + v_n_d_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_error_3 = fabs((v_y_2 - unit_product_3
          - ksl_product_error(unit_2, divisor, unit_product_3) - KSL_MUL(unit_2, divisor_lo))
          / divisor),
      angle_bound_1 = fabs(KSL_MUL(2.0, half_lo)) + KSL_MUL(2.1514956353001486e-29, angle_padded_1),
      axis_bound_2 = fabs(v_n == 0.0 ? 0.0 : unit_lo_1)
          + KSL_MUL(1.644282720444347e-29, 1.8051943758648296e-276 + axis_size_7),
      unit_bound_2 = unit_error_2
          + KSL_MUL(1.6442825652790928e-29, 1.8051943758648296e-276 + unit_size_18),
      unit_bound_3 = unit_error_3
          + KSL_MUL(1.6442825652790928e-29, 1.8051943758648296e-276 + unit_size_25);
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  *angle_bound = angle_bound_1;
  axis_bound->x = axis_bound_2;
  axis_bound->y = unit_bound_2;
  axis_bound->z = unit_bound_3;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error of
     qo| <= qo_bound unless inf or NaN.
   v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   266 mul, 346 add, 17 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1 equal,
     24 select. */
static inline void ksl_quaternion_exp_certified(const ksl_vec3_t *v, ksl_quaternion_t *qo,
    ksl_quaternion_t *qo_bound) {
  const double h_0 = KSL_MUL(0.5, v->x);
  const double h_1 = KSL_MUL(0.5, v->y);
  const double h_2 = KSL_MUL(0.5, v->z);
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
  const double qo_0 = KSL_MUL(h_0, k);
  const double qo_1 = KSL_MUL(h_1, k);
  const double qo_2 = KSL_MUL(h_2, k);
  const double qo_3 = x < 1.0 ? near : cosine;
  const double fine_h_0 = KSL_MUL(0.5, v->x);
  const double fine_h_1 = KSL_MUL(0.5, v->y);
  const double fine_h_2 = KSL_MUL(0.5, v->z);
  const double h_size_0 = fabs(fine_h_0),
      h_size_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, fabs(v->x));
  const double h_size_1 = fabs(fine_h_1),
      h_size_padded_2 = 1.8051943758648296e-276 + KSL_MUL(0.5, fabs(v->y));
  const double h_size_2 = fabs(fine_h_2),
      h_size_padded_3 = 1.8051943758648296e-276 + KSL_MUL(0.5, fabs(v->z));
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_size_1 = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(fine_h_0, s), reduced_1 = KSL_MUL(fine_h_1, s),
      reduced_2 = KSL_MUL(fine_h_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(h_size_padded_1, s_size_1),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(h_size_padded_2, s_size_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right_1 = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest_1 = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right_1),
      reduced_length_a_size_1 = KSL_MUL(reduced_length_a_padded_1, reduced_length_a_padded_1),
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(h_size_padded_3, s_size_1),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right_1 = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest_1 = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right_1),
      reduced_length_c_lo = reduced_length_c_left_rest_1
          + ksl_product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
          + reduced_length_e_right_rest_1 + reduced_length_c_lo,
      reduced_length_c_size_1 = reduced_length_a_size_1
          + KSL_MUL(reduced_length_b_padded_1, reduced_length_b_padded_1),
      reduced_length = sqrt(reduced_length_e),
      reduced_length_product_1 = KSL_MUL(reduced_length, reduced_length),
      reduced_length_exact_1 = reduced_length_e - reduced_length_product_1
          - ksl_product_error(reduced_length, reduced_length, reduced_length_product_1),
      reduced_length_twice_1 = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact_1 + reduced_length_e_lo)
          / (reduced_length == 0.0 ? 1.0 : reduced_length_twice_1),
      reduced_length_padded_1 = 1.8051943758648296e-276
          + (reduced_length_c_size_1
          + KSL_MUL(reduced_length_d_padded_1, reduced_length_d_padded_1)),
      reduced_length_bound_1 = fabs(reduced_length_e_lo)
          + KSL_MUL(3.229399894985818e-30, reduced_length_padded_1),
      reduced_length_reach_1 = fabs(reduced_length_e)
          + KSL_MUL(140737488355328.0, reduced_length_bound_1),
      reduced_length_size_4 = KSL_MUL(reduced_length_reach_1, reduced_length_padded_1
          / reduced_length / reduced_length_e),
      reduced_length_size_8 = KSL_MUL(2.0056767005853705e+29, sqrt(reduced_length_bound_1)
          + fabs(reduced_length_lo));
  const double half_angle = KSL_MUL(reduced_length, up),
      half_angle_lo = KSL_MUL(reduced_length - KSL_MUL(half_angle, 1.0 / up)
          + reduced_length_lo, up);
  const double reduced_length_size_12 = reduced_length
          + (KSL_MUL(4.0, reduced_length_bound_1) < reduced_length_e ? reduced_length_size_4
          : reduced_length_size_8);
  const double half_angle_size_1 = KSL_MUL(1.8051943758648296e-276 + reduced_length_size_12, s
          < 1.0 ? 2.6815615859885194e+154 : 1.0);
  const double y = KSL_MUL(half_angle, half_angle),
      y_padded_1 = 1.8051943758648296e-276 + half_angle_size_1,
      y_bound_1 = fabs(half_angle_lo) + KSL_MUL(5.7192432555642225e-30, y_padded_1),
      y_size_2 = KSL_MUL(y_padded_1, fabs(half_angle) + KSL_MUL(140737488355328.0, y_bound_1));
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1;
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_size_4 = 5e-324 + fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_8 = fabs(1.4901161193847656e-08 - half_angle) + y_bound_1,
      sinc_divisor_size_10 = KSL_MUL(5.762046184631807e+28, y_bound_1 < sinc_divisor_size_4 ? 0.0
          : sinc_divisor_size_8);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 1.8051943758648296e-276 + (1.0 + y_padded_1);
  const double sinc_divisor_size_11 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_1) + sinc_divisor_size_10;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_11,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.789728954546449e-29, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y),
      y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_lo, half_angle) + KSL_MUL(half_angle, half_angle_lo)),
      sinc_b = 1.0 - sinc_a, sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_2 + y_size_2),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.201505264386605e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(2.755262189115544e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2206826306780646e+27, y_bound_1 < sinc_divisor_size_4 ? 0.0
          : sinc_size_5);
  const double fine_qo_0 = KSL_MUL(fine_h_0, sinc),
      fine_qo_padded_1 = 1.8051943758648296e-276
          + ((half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7),
      fine_qo_reach_2 = fabs(sinc)
          + KSL_MUL(140737488355328.0, fabs(sinc_lo)
          + KSL_MUL(8.201506228291972e-28, fine_qo_padded_1)),
      fine_qo_size_2 = KSL_MUL(fine_qo_padded_1, fabs(fine_h_0)
          + KSL_MUL(140737488355328.0, KSL_MUL(1.2325953113446296e-31, h_size_padded_1)));
  const double fine_qo_1 = KSL_MUL(fine_h_1, sinc),
      fine_qo_size_7 = KSL_MUL(fine_qo_padded_1, fabs(fine_h_1)
          + KSL_MUL(140737488355328.0, KSL_MUL(1.2325953113446296e-31, h_size_padded_2)));
  const double fine_qo_2 = KSL_MUL(fine_h_2, sinc),
      fine_qo_size_11 = KSL_MUL(fine_qo_padded_1, fabs(fine_h_2)
          + KSL_MUL(140737488355328.0, KSL_MUL(1.2325953113446296e-31, h_size_padded_3)));
  const double qo_error_2 = KSL_MUL(1.0000000000000009, fabs(ksl_product_error(fine_h_0, sinc,
      fine_qo_0) + KSL_MUL(fine_h_0, sinc_lo) + (fine_qo_0 - qo_0))),
      qo_error_4 = KSL_MUL(1.0000000000000009, fabs(ksl_product_error(fine_h_1, sinc, fine_qo_1)
          + KSL_MUL(fine_h_1, sinc_lo) + (fine_qo_1 - qo_1))),
      qo_error_6 = KSL_MUL(1.0000000000000009, fabs(ksl_product_error(fine_h_2, sinc, fine_qo_2)
          + KSL_MUL(fine_h_2, sinc_lo) + (fine_qo_2 - qo_2))),
      qo_apart_8 = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1) + (c - qo_3),
      qo_bound_1 = qo_error_2
          + KSL_MUL(8.21414129263252e-28, 1.8051943758648296e-276
          + (fine_qo_size_2 + KSL_MUL(fine_qo_reach_2, h_size_padded_1))),
      qo_bound_2 = qo_error_4
          + KSL_MUL(8.21414129263252e-28, 1.8051943758648296e-276
          + (fine_qo_size_7 + KSL_MUL(fine_qo_reach_2, h_size_padded_2))),
      qo_bound_3 = qo_error_6
          + KSL_MUL(8.21414129263252e-28, 1.8051943758648296e-276
          + (fine_qo_size_11 + KSL_MUL(fine_qo_reach_2, h_size_padded_3))),
      qo_bound_4 = KSL_MUL(1.0000000000000009, fabs(qo_apart_8))
          + KSL_MUL(1.0551017099379097e-29, sinc_quotient_padded_1);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_bound_1;
  qo_bound->y = qo_bound_2;
  qo_bound->z = qo_bound_3;
  qo_bound->w = qo_bound_4;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it;
     |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.
   209 mul, 315 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4 copysign,
     35 less, 10 equal, 65 select. */
static inline void ksl_quaternion_log_certified(const ksl_quaternion_t *q, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_inverse_1 = 1.0 / s,
      scaled_s_size_4 = fabs(scaled_s_0);
  const double scaled_s_1 = KSL_MUL(q->y, s), scaled_s_size_8 = fabs(scaled_s_1);
  const double scaled_s_2 = KSL_MUL(q->z, s), scaled_s_size_12 = fabs(scaled_s_2);
  const double scaled_s_3 = KSL_MUL(q->w, s),
      scaled_s_size_15 = q->w == KSL_MUL(scaled_s_3, scaled_s_inverse_1) ? 0.0 : 5e-324,
      scaled_s_size_16 = fabs(scaled_s_3);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0,
      upper_size_3 = 5e-324 + fabs(scaled_s_3 - 0.0),
      upper_size_7 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_4)
          + fabs(upper_0a - scaled_s_0),
      upper_size_8 = (q->x == KSL_MUL(scaled_s_0, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_7;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1,
      upper_size_14 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_8)
          + fabs(upper_1a - scaled_s_1),
      upper_size_15 = (q->y == KSL_MUL(scaled_s_1, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_14;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2,
      upper_size_21 = KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_12)
          + fabs(upper_2a - scaled_s_2),
      upper_size_22 = (q->z == KSL_MUL(scaled_s_2, scaled_s_inverse_1) ? 0.0 : 5e-324)
          + upper_size_21;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3,
      upper_size_29 = scaled_s_size_15
          + (KSL_MUL(1.1093356479670522e-31, 1.8051943758648296e-276 + scaled_s_size_16)
          + fabs(upper_3a - scaled_s_3));
  const double v_s_size_0 = fabs(upper_0),
      v_s_size_padded_1 = 1.8051943758648296e-276
          + (scaled_s_size_4
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_8));
  const double v_s_size_1 = fabs(upper_1);
  const double upper_size_18 = scaled_s_size_8
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_15);
  const double v_s_size_padded_2 = 1.8051943758648296e-276 + upper_size_18;
  const double v_s_size_2 = fabs(upper_2);
  const double upper_size_25 = scaled_s_size_12
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_22);
  const double v_s_size_padded_3 = 1.8051943758648296e-276 + upper_size_25;
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s_b_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0),
      v_n_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, fabs(v_y_0)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_a_padded_1))),
      v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, fabs(v_y_1)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_b_padded_1))),
      v_n_c = v_n_a + v_n_b, v_n_c_right_1 = v_n_c - v_n_a, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, fabs(v_y_2)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.4142893812359766e-30, v_n_d_padded_1))),
      v_n_e = v_n_c + v_n_d, v_n_e_right_1 = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1) + v_n_c_lo, v_n = sqrt(v_n_e),
      v_n_product_1 = KSL_MUL(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice_1),
      v_n_padded_1 = 1.8051943758648296e-276
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabs(v_n_e_lo) + KSL_MUL(7.235336013082471e-30, v_n_padded_1),
      v_n_size_4 = KSL_MUL(fabs(v_n_e) + KSL_MUL(140737488355328.0, v_n_bound_1), v_n_padded_1
          / v_n / v_n_e),
      v_n_size_8 = KSL_MUL(1.5970396877936164e+29, sqrt(v_n_bound_1) + fabs(v_n_lo));
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r_b_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n = KSL_MUL(v_n, v_r), n_lo = KSL_MUL(v_n - KSL_MUL(n, 1.0 / v_r) + v_n_lo, v_r),
      n_padded_1 = 1.8051943758648296e-276
          + (v_n + (KSL_MUL(4.0, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8)),
      n_size_1 = KSL_MUL(n_padded_1, 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302
          : v_r_b_size_1);
  const double half = ksl_atan2(n, upper_3), half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, KSL_MUL(half_part1_1, half_part1_1)
          + KSL_MUL(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MUL(half_part1_1, n_lo) - KSL_MUL(half_part0_1, 0.0))
          / (half_most_1 == 0.0 ? 1.0 : half_divisor2_1),
      half_lo = ksl_atan2_error(n, upper_3, half) + half_more_1,
      half_padded_1 = 1.8051943758648296e-276 + n_size_1,
      half_padded_2 = 1.8051943758648296e-276
          + (scaled_s_size_16
          + KSL_MUL(3.169126500570585e+29, scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_29)),
      half_size_2 = fabs(n), half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabs(n_lo) + KSL_MUL(6.859394487938082e-30, half_padded_1),
      half_rest_2 = KSL_MUL(3.254051621949822e-30, half_padded_2),
      half_size_11 = (half_rest_2 + (1.8051943758648296e-276 + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_15 = 7.0 + fabs(half_lo),
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MUL(4.875578158636172e+28, half_size_11 < 0.25 ? half_size_19
          : half_size_15);
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo,
      divisor_size_8 = fabs(1.0 - n) + half_bound_1;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor, k_product_1 = KSL_MUL(k, divisor),
      k_lo = (theta - k_product_1 - ksl_product_error(k, divisor, k_product_1)
          + KSL_MUL(2.0, half_lo) - KSL_MUL(k, divisor_lo)) / divisor;
  const double divisor_size_11 = (n == 0.0 ? 1.0 : n_size_1)
          + KSL_MUL(7.042501095850493e+28, half_bound_1 < 5e-324 + fabs(n - 0.0) ? 0.0
          : divisor_size_8);
  const double k_padded_2 = 1.8051943758648296e-276 + divisor_size_11, k_size_1 = fabs(k),
      k_size_2 = fabs(divisor),
      k_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(2.0, fabs(half) + (half_padded_1 + half_padded_2) / half_size_5 + half_size_21),
      k_bound_1 = fabs(divisor_lo) + KSL_MUL(1.464323675977526e-29, k_padded_2),
      k_size_8 = (k_padded_1 + KSL_MUL(k_padded_2, k_size_1))
          / (KSL_MUL(4.0, k_bound_1) < k_size_2 ? k_size_2 : 0.0);
  const double vector_0 = KSL_MUL(upper_0, k),
      vector_padded_1 = 1.8051943758648296e-276
          + (k_size_1 + KSL_MUL(k_size_2 + KSL_MUL(140737488355328.0, k_bound_1), k_size_8)
          / k_size_2),
      vector_reach_2 = k_size_1
          + KSL_MUL(140737488355328.0, fabs(k_lo)
          + KSL_MUL(3.097307347238718e-29, vector_padded_1)),
      vector_size_2 = KSL_MUL(vector_padded_1, fabs(upper_0)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.254051621949822e-30, v_s_size_padded_1)));
  const double vector_1 = KSL_MUL(upper_1, k),
      vector_size_6 = KSL_MUL(vector_padded_1, fabs(upper_1)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.254051621949822e-30, v_s_size_padded_2)));
  const double vector_2 = KSL_MUL(upper_2, k),
      vector_size_10 = KSL_MUL(vector_padded_1, fabs(upper_2)
          + KSL_MUL(140737488355328.0, KSL_MUL(3.254051621949822e-30, v_s_size_padded_3)));
  const double vector_rest_2 = KSL_MUL(3.2199508764278064e-29, 1.8051943758648296e-276
          + (vector_size_2 + KSL_MUL(v_s_size_padded_1, vector_reach_2))),
      vector_rest_3 = KSL_MUL(3.2199508764278064e-29, 1.8051943758648296e-276
          + (vector_size_6 + KSL_MUL(v_s_size_padded_2, vector_reach_2))),
      vector_rest_4 = KSL_MUL(3.2199508764278064e-29, 1.8051943758648296e-276
          + (vector_size_10 + KSL_MUL(v_s_size_padded_3, vector_reach_2))),
      vector_bound_2 = fabs(ksl_product_error(upper_0, k, vector_0) + KSL_MUL(upper_0, k_lo))
          + vector_rest_2,
      vector_bound_3 = fabs(ksl_product_error(upper_1, k, vector_1) + KSL_MUL(upper_1, k_lo))
          + vector_rest_3,
      vector_bound_4 = fabs(ksl_product_error(upper_2, k, vector_2) + KSL_MUL(upper_2, k_lo))
          + vector_rest_4;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
  vo_bound->x = vector_bound_2;
  vo_bound->y = vector_bound_3;
  vo_bound->z = vector_bound_4;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_quaternionf_scale_certified(ksl_quaternionf_t *self, const float a,
    ksl_quaternionf_t *self_bound) {
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

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.
   8 mul, 12 add, 8 abs. */
static inline void ksl_axpy_qqf_certified(const float a, const ksl_quaternionf_t *x,
    ksl_quaternionf_t *y, ksl_quaternionf_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->x), y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = KSL_MULF(a, x->y), y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = KSL_MULF(a, x->z), y_2_new = y_2_new_a + y->z;
  const float y_3_new_a = KSL_MULF(a, x->w), y_3_new = y_3_new_a + y->w;
  const float y_0_new_size = fabsf(y_0_new_a) + fabsf(y->x),
      y_1_new_size = fabsf(y_1_new_a) + fabsf(y->y), y_2_new_size = fabsf(y_2_new_a) + fabsf(y->z),
      y_3_new_size = fabsf(y_3_new_a) + fabsf(y->w);
  const float y_0_new_bound = KSL_MULF(1.192093e-07f, y_0_new_size + 1.9721523e-31f),
      y_1_new_bound = KSL_MULF(1.192093e-07f, y_1_new_size + 1.9721523e-31f),
      y_2_new_bound = KSL_MULF(1.192093e-07f, y_2_new_size + 1.9721523e-31f),
      y_3_new_bound = KSL_MULF(1.192093e-07f, y_3_new_size + 1.9721523e-31f);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
  y_bound->w = y_3_new_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->y, v->z), c_0b = KSL_MULF(q->z, v->y), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->z, v->x), c_1b = KSL_MULF(q->x, v->z), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->x, v->y), c_2b = KSL_MULF(q->y, v->x), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0), t_1 = KSL_MULF(2.0f, c_1), t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0 = KSL_MULF(q->y, t_2) - KSL_MULF(q->z, t_1) + KSL_MULF(q->w, t_0);
  const float turn_1 = KSL_MULF(q->z, t_0) - KSL_MULF(q->x, t_2) + KSL_MULF(q->w, t_1),
      turn_2 = KSL_MULF(q->x, t_1) - KSL_MULF(q->y, t_0) + KSL_MULF(q->w, t_2);
  const float vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  const float c_0_size = fabsf(c_0a) + fabsf(c_0b), c_1_size = fabsf(c_1a) + fabsf(c_1b),
      c_2_size = fabsf(c_2a) + fabsf(c_2b);
  const float t_0_size = KSL_MULF(2.0f, c_0_size + 1.9721523e-31f),
      t_1_size = KSL_MULF(2.0f, c_1_size + 1.9721523e-31f),
      t_2_size = KSL_MULF(2.0f, c_2_size + 1.9721523e-31f);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z);
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w),
      turn_0_size = KSL_MULF(q_1_abs, t_2_padded) + KSL_MULF(q_2_abs, t_1_padded)
          + KSL_MULF(q_3_abs, t_0_padded);
  const float q_0_abs = fabsf(q->x),
      turn_1_size = KSL_MULF(q_2_abs, t_0_padded) + KSL_MULF(q_0_abs, t_2_padded)
          + KSL_MULF(q_3_abs, t_1_padded);
  const float turn_2_size = KSL_MULF(q_0_abs, t_1_padded) + KSL_MULF(q_1_abs, t_0_padded)
          + KSL_MULF(q_3_abs, t_2_padded);
  const float vo_0_size = fabsf(v->x) + turn_0_size, vo_1_size = fabsf(v->y) + turn_1_size,
      vo_2_size = fabsf(v->z) + turn_2_size;
  const float vo_0_bound = KSL_MULF(4.1723263e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(4.1723263e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(4.1723263e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qconjvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->z, v->y), c_0b = KSL_MULF(q->y, v->z), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->x, v->z), c_1b = KSL_MULF(q->z, v->x), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->y, v->x), c_2b = KSL_MULF(q->x, v->y), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0), t_1 = KSL_MULF(2.0f, c_1), t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0 = KSL_MULF(q->z, t_1) - KSL_MULF(q->y, t_2) + KSL_MULF(q->w, t_0);
  const float turn_1 = KSL_MULF(q->x, t_2) - KSL_MULF(q->z, t_0) + KSL_MULF(q->w, t_1),
      turn_2 = KSL_MULF(q->y, t_0) - KSL_MULF(q->x, t_1) + KSL_MULF(q->w, t_2);
  const float vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  const float c_0_size = fabsf(c_0a) + fabsf(c_0b), c_1_size = fabsf(c_1a) + fabsf(c_1b),
      c_2_size = fabsf(c_2a) + fabsf(c_2b);
  const float t_0_size = KSL_MULF(2.0f, c_0_size + 1.9721523e-31f),
      t_1_size = KSL_MULF(2.0f, c_1_size + 1.9721523e-31f),
      t_2_size = KSL_MULF(2.0f, c_2_size + 1.9721523e-31f);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y);
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w),
      turn_0_size = KSL_MULF(q_2_abs, t_1_padded) + KSL_MULF(q_1_abs, t_2_padded)
          + KSL_MULF(q_3_abs, t_0_padded);
  const float q_0_abs = fabsf(q->x),
      turn_1_size = KSL_MULF(q_0_abs, t_2_padded) + KSL_MULF(q_2_abs, t_0_padded)
          + KSL_MULF(q_3_abs, t_1_padded);
  const float turn_2_size = KSL_MULF(q_1_abs, t_0_padded) + KSL_MULF(q_0_abs, t_1_padded)
          + KSL_MULF(q_3_abs, t_2_padded);
  const float vo_0_size = fabsf(v->x) + turn_0_size, vo_1_size = fabsf(v->y) + turn_1_size,
      vo_2_size = fabsf(v->z) + turn_2_size;
  const float vo_0_bound = KSL_MULF(4.1723263e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(4.1723263e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(4.1723263e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->x, q2i->w), qo_0b = KSL_MULF(q1i->y, q2i->z),
      qo_0c = KSL_MULF(q1i->z, q2i->y), qo_0f = KSL_MULF(q1i->w, q2i->x),
      qo_0 = qo_0a + (qo_0b - qo_0c) + qo_0f;
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1b = KSL_MULF(q1i->x, q2i->z),
      qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1f = KSL_MULF(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b + qo_1d + qo_1f;
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2b = KSL_MULF(q1i->y, q2i->x),
      qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2f = KSL_MULF(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b + qo_2d + qo_2f;
  const float qo_3a = KSL_MULF(q1i->w, q2i->w), qo_3b = KSL_MULF(q1i->x, q2i->x),
      qo_3c = KSL_MULF(q1i->y, q2i->y), qo_3e = KSL_MULF(q1i->z, q2i->z),
      qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e);
  const float qo_0_size = fabsf(qo_0a) + (fabsf(qo_0b) + fabsf(qo_0c)) + fabsf(qo_0f),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d) + fabsf(qo_1f),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d) + fabsf(qo_2f),
      qo_3_size = fabsf(qo_3a) + (fabsf(qo_3b) + fabsf(qo_3c) + fabsf(qo_3e));
  const float qo_0_bound = KSL_MULF(2.3841864e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(2.3841864e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(2.3841864e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(2.3841864e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconjf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->x, q2i->w), qo_0b = KSL_MULF(q1i->w, q2i->x),
      qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0e = KSL_MULF(q1i->y, q2i->z),
      qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e);
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1b = KSL_MULF(q1i->z, q2i->x),
      qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1e = KSL_MULF(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e);
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2b = KSL_MULF(q1i->x, q2i->y),
      qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2e = KSL_MULF(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e);
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3b = KSL_MULF(q1i->y, q2i->y),
      qo_3d = KSL_MULF(q1i->z, q2i->z), qo_3f = KSL_MULF(q1i->w, q2i->w),
      qo_3 = qo_3a + qo_3b + qo_3d + qo_3f;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b) + (fabsf(qo_0d) + fabsf(qo_0e)),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + (fabsf(qo_1d) + fabsf(qo_1e)),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + (fabsf(qo_2d) + fabsf(qo_2e)),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d) + fabsf(qo_3f);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(2.3841864e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->w, q2i->x), qo_0b = KSL_MULF(q1i->x, q2i->w),
      qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0e = KSL_MULF(q1i->y, q2i->z),
      qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e);
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1b = KSL_MULF(q1i->z, q2i->x),
      qo_1d = KSL_MULF(q1i->w, q2i->y), qo_1e = KSL_MULF(q1i->y, q2i->w),
      qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e);
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2b = KSL_MULF(q1i->x, q2i->y),
      qo_2d = KSL_MULF(q1i->w, q2i->z), qo_2e = KSL_MULF(q1i->z, q2i->w),
      qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e);
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3b = KSL_MULF(q1i->y, q2i->y),
      qo_3d = KSL_MULF(q1i->z, q2i->z), qo_3f = KSL_MULF(q1i->w, q2i->w),
      qo_3 = qo_3a + qo_3b + qo_3d + qo_3f;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b) + (fabsf(qo_0d) + fabsf(qo_0e)),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + (fabsf(qo_1d) + fabsf(qo_1e)),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + (fabsf(qo_2d) + fabsf(qo_2e)),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d) + fabsf(qo_3f);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(2.3841864e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqconjf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->y, q2i->z), qo_0b = KSL_MULF(q1i->z, q2i->y),
      qo_0d = KSL_MULF(q1i->x, q2i->w), qo_0f = KSL_MULF(q1i->w, q2i->x),
      qo_0 = qo_0a - qo_0b - qo_0d - qo_0f;
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1b = KSL_MULF(q1i->x, q2i->z),
      qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1f = KSL_MULF(q1i->w, q2i->y),
      qo_1 = qo_1a - qo_1b - qo_1d - qo_1f;
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2b = KSL_MULF(q1i->y, q2i->x),
      qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2f = KSL_MULF(q1i->w, q2i->z),
      qo_2 = qo_2a - qo_2b - qo_2d - qo_2f;
  const float qo_3a = KSL_MULF(q1i->w, q2i->w), qo_3b = KSL_MULF(q1i->x, q2i->x),
      qo_3c = KSL_MULF(q1i->y, q2i->y), qo_3e = KSL_MULF(q1i->z, q2i->z),
      qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e);
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b) + fabsf(qo_0d) + fabsf(qo_0f),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d) + fabsf(qo_1f),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d) + fabsf(qo_2f),
      qo_3_size = fabsf(qo_3a) + (fabsf(qo_3b) + fabsf(qo_3c) + fabsf(qo_3e));
  const float qo_0_bound = KSL_MULF(2.3841864e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(2.3841864e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(2.3841864e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(2.3841864e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qxqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1b = KSL_MULF(dci[0], qi->z),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->x),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qxqconjf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(dci[0], qi->x), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qxconjqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0b = KSL_MULF(dci[0], qi->w),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2b = KSL_MULF(dci[0], qi->y),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->x), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qxconjqconjf_certified(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->x),
      qo_3 = qo_3a - qo_3b;
  const float qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqxf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->w, dci[0]),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->z, dci[0]),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->y, dci[0]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->x, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqxconjf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->w, dci[0]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->z, dci[0]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(qi->x, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qconjqxf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->w, dci[0]), qo_0b = KSL_MULF(qi->x, dci[1]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->z, dci[0]),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->x, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_2_size = fabsf(qo_2a) + fabsf(qo_2b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qconjqxconjf_certified(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->w, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(qi->z, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->x, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_1_size = fabsf(qo_1a) + fabsf(qo_1b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qyqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2b = KSL_MULF(dci[0], qi->x),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->y),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qyqconjf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->y), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_1_size = fabsf(qo_1a) + fabsf(qo_1b), qo_2_size = fabsf(qo_2a) + fabsf(qo_2b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qyconjqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0b = KSL_MULF(dci[0], qi->z),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1b = KSL_MULF(dci[0], qi->w),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->y), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qyconjqconjf_certified(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->y),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqyf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->z, dci[0]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->w, dci[0]),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->y, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqyconjf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->z, dci[0]),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->w, dci[0]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->x, dci[0]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->y, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qconjqyf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->z, dci[0]), qo_0b = KSL_MULF(qi->x, dci[1]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->w, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(qi->y, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qconjqyconjf_certified(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->z, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->w, dci[0]),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->y, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qzqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0b = KSL_MULF(dci[0], qi->y),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->z),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qzqconjf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->z), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_2_size = fabsf(qo_2a) + fabsf(qo_2b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qzconjqf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1b = KSL_MULF(dci[0], qi->x),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2b = KSL_MULF(dci[0], qi->w),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->z), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qzconjqconjf_certified(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->z),
      qo_3 = qo_3a - qo_3b;
  const float qo_1_size = fabsf(qo_1a) + fabsf(qo_1b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <= qo_bound
     unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqzf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->y, dci[0]),
      qo_0 = qo_0a + qo_0b;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->x, dci[0]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->w, dci[0]),
      qo_2 = qo_2a + qo_2b;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->z, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 8 abs. */
static inline void ksl_product_qqzconjf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->y, dci[0]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a + qo_1b;
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->w, dci[0]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->z, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_1_size = fabsf(qo_1a) + fabsf(qo_1b),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qconjqzf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->y, dci[0]),
      qo_0 = -(qo_0a + qo_0b);
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->w, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->z, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_1_size = fabsf(qo_1a) + fabsf(qo_1b), qo_2_size = fabsf(qo_2a) + fabsf(qo_2b),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_0a) + fabsf(qo_0b) + 1.9721523e-31f);
  const float qo_1_bound = KSL_MULF(1.192093e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.192093e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qconjqzconjf_certified(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->y, dci[0]), qo_0b = KSL_MULF(qi->x, dci[1]),
      qo_0 = qo_0a - qo_0b;
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = -(qo_1a + qo_1b);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->w, dci[0]),
      qo_2 = -(qo_2a + qo_2b);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->z, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b), qo_3_size = fabsf(qo_3a) + fabsf(qo_3b);
  const float qo_0_bound = KSL_MULF(1.192093e-07f, qo_0_size + 1.9721523e-31f);
  const float qo_1c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_1a) + fabsf(qo_1b) + 1.9721523e-31f);
  const float qo_2c_bound = KSL_MULF(1.192093e-07f, fabsf(qo_2a) + fabsf(qo_2b) + 1.9721523e-31f);
  const float qo_3_bound = KSL_MULF(1.192093e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1c_bound;
  qo_bound->z = qo_2c_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_product_qvf_certified(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->y, vi->z), qo_0b = KSL_MULF(qi->z, vi->y),
      qo_0d = KSL_MULF(qi->w, vi->x), qo_0 = qo_0a - qo_0b + qo_0d;
  const float qo_1a = KSL_MULF(qi->z, vi->x), qo_1b = KSL_MULF(qi->x, vi->z),
      qo_1d = KSL_MULF(qi->w, vi->y), qo_1 = qo_1a - qo_1b + qo_1d;
  const float qo_2a = KSL_MULF(qi->x, vi->y), qo_2b = KSL_MULF(qi->y, vi->x),
      qo_2d = KSL_MULF(qi->w, vi->z), qo_2 = qo_2a - qo_2b + qo_2d;
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3b = KSL_MULF(qi->y, vi->y),
      qo_3d = KSL_MULF(qi->z, vi->z), qo_3 = -(qo_3a + qo_3b + qo_3d);
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b) + fabsf(qo_0d),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f);
  const float qo_3e_bound = KSL_MULF(1.7881396e-07f, fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d)
          + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3e_bound;
}

/* qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 12 abs. */
static inline void ksl_product_qconjvf_certified(const ksl_quaternionf_t *qi,
    const ksl_vec3f_t *vi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->z, vi->y), qo_0b = KSL_MULF(qi->y, vi->z),
      qo_0d = KSL_MULF(qi->w, vi->x), qo_0 = qo_0a - qo_0b + qo_0d;
  const float qo_1a = KSL_MULF(qi->x, vi->z), qo_1b = KSL_MULF(qi->z, vi->x),
      qo_1d = KSL_MULF(qi->w, vi->y), qo_1 = qo_1a - qo_1b + qo_1d;
  const float qo_2a = KSL_MULF(qi->y, vi->x), qo_2b = KSL_MULF(qi->x, vi->y),
      qo_2d = KSL_MULF(qi->w, vi->z), qo_2 = qo_2a - qo_2b + qo_2d;
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3b = KSL_MULF(qi->y, vi->y),
      qo_3d = KSL_MULF(qi->z, vi->z), qo_3 = qo_3a + qo_3b + qo_3d;
  const float qo_0_size = fabsf(qo_0a) + fabsf(qo_0b) + fabsf(qo_0d),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.7881396e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_product_vqf_certified(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(vi->x, qi->w), qo_0b = KSL_MULF(vi->y, qi->z),
      qo_0c = KSL_MULF(vi->z, qi->y), qo_0 = qo_0a + (qo_0b - qo_0c);
  const float qo_1a = KSL_MULF(vi->z, qi->x), qo_1b = KSL_MULF(vi->x, qi->z),
      qo_1d = KSL_MULF(vi->y, qi->w), qo_1 = qo_1a - qo_1b + qo_1d;
  const float qo_2a = KSL_MULF(vi->x, qi->y), qo_2b = KSL_MULF(vi->y, qi->x),
      qo_2d = KSL_MULF(vi->z, qi->w), qo_2 = qo_2a - qo_2b + qo_2d;
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3b = KSL_MULF(vi->y, qi->y),
      qo_3d = KSL_MULF(vi->z, qi->z), qo_3 = -(qo_3a + qo_3b + qo_3d);
  const float qo_0_size = fabsf(qo_0a) + (fabsf(qo_0b) + fabsf(qo_0c)),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f);
  const float qo_3e_bound = KSL_MULF(1.7881396e-07f, fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d)
          + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3e_bound;
}

/* qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 12 abs. */
static inline void ksl_product_vqconjf_certified(const ksl_vec3f_t *vi,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(vi->x, qi->w), qo_0b = KSL_MULF(vi->z, qi->y),
      qo_0c = KSL_MULF(vi->y, qi->z), qo_0 = qo_0a + (qo_0b - qo_0c);
  const float qo_1a = KSL_MULF(vi->x, qi->z), qo_1b = KSL_MULF(vi->z, qi->x),
      qo_1d = KSL_MULF(vi->y, qi->w), qo_1 = qo_1a - qo_1b + qo_1d;
  const float qo_2a = KSL_MULF(vi->y, qi->x), qo_2b = KSL_MULF(vi->x, qi->y),
      qo_2d = KSL_MULF(vi->z, qi->w), qo_2 = qo_2a - qo_2b + qo_2d;
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3b = KSL_MULF(vi->y, qi->y),
      qo_3d = KSL_MULF(vi->z, qi->z), qo_3 = qo_3a + qo_3b + qo_3d;
  const float qo_0_size = fabsf(qo_0a) + (fabsf(qo_0b) + fabsf(qo_0c)),
      qo_1_size = fabsf(qo_1a) + fabsf(qo_1b) + fabsf(qo_1d),
      qo_2_size = fabsf(qo_2a) + fabsf(qo_2b) + fabsf(qo_2d),
      qo_3_size = fabsf(qo_3a) + fabsf(qo_3b) + fabsf(qo_3d);
  const float qo_0_bound = KSL_MULF(1.7881396e-07f, qo_0_size + 1.9721523e-31f),
      qo_1_bound = KSL_MULF(1.7881396e-07f, qo_1_size + 1.9721523e-31f),
      qo_2_bound = KSL_MULF(1.7881396e-07f, qo_2_size + 1.9721523e-31f),
      qo_3_bound = KSL_MULF(1.7881396e-07f, qo_3_size + 1.9721523e-31f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_bound;
  qo_bound->y = qo_1_bound;
  qo_bound->z = qo_2_bound;
  qo_bound->w = qo_3_bound;
}

/* q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.
   q1i, q2i: quaternion (x, y, z, w), the scalar last; dot_bound: number.
   5 mul, 7 add, 4 abs. */
static inline float ksl_dot_qqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, float *dot_bound) {
  const float dot_a = KSL_MULF(q1i->x, q2i->x), dot_b = KSL_MULF(q1i->y, q2i->y),
      dot_d = KSL_MULF(q1i->z, q2i->z), dot_f = KSL_MULF(q1i->w, q2i->w),
      dot = dot_a + dot_b + dot_d + dot_f;
  const float dot_size = fabsf(dot_a) + fabsf(dot_b) + fabsf(dot_d) + fabsf(dot_f);
  const float dot_bound_ = KSL_MULF(2.3841864e-07f, dot_size + 1.9721523e-31f);
  *dot_bound = dot_bound_;
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_add_dpiToqf_certified(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qi_bound) {
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
  const float qi_0_new_a_padded = fabsf(qi_0_new_a) + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w);
  const float qi_0_new_c_padded = fabsf(qi_0_new_c) + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y);
  const float qi_0_new_e_padded = fabsf(qi_0_new_e) + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z), qi_0_abs = fabsf(qi->x),
      qi_0_new_size = KSL_MULF(qi_0_new_a_padded, qi_3_abs)
          + (KSL_MULF(qi_0_new_c_padded, qi_1_abs) + KSL_MULF(qi_0_new_e_padded, qi_2_abs))
          + qi_0_abs;
  const float qi_1_new_size = KSL_MULF(qi_0_new_a_padded, qi_2_abs)
          + KSL_MULF(qi_0_new_c_padded, qi_0_abs) + KSL_MULF(qi_0_new_e_padded, qi_3_abs)
          + qi_1_abs,
      qi_2_new_size = KSL_MULF(qi_0_new_e_padded, qi_0_abs) + KSL_MULF(qi_0_new_a_padded, qi_1_abs)
          + KSL_MULF(qi_0_new_c_padded, qi_3_abs) + qi_2_abs,
      qi_3_new_size = qi_3_abs
          + (KSL_MULF(qi_0_new_a_padded, qi_0_abs) + KSL_MULF(qi_0_new_e_padded, qi_1_abs)
          + KSL_MULF(qi_0_new_c_padded, qi_2_abs));
  const float qi_0_new_bound = KSL_MULF(2.9802328e-07f, qi_0_new_size + 1.9721523e-31f),
      qi_1_new_bound = KSL_MULF(2.9802328e-07f, qi_1_new_size + 1.9721523e-31f),
      qi_2_new_bound = KSL_MULF(2.9802328e-07f, qi_2_new_size + 1.9721523e-31f),
      qi_3_new_bound = KSL_MULF(2.9802328e-07f, qi_3_new_size + 1.9721523e-31f);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_bound;
  qi_bound->y = qi_1_new_bound;
  qi_bound->z = qi_2_new_bound;
  qi_bound->w = qi_3_new_bound;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
     qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_subtract_dpiFromqf_certified(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qi_bound) {
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
  const float qi_0_new_a_padded = fabsf(qi_0_new_a) + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z);
  const float qi_0_new_c_padded = fabsf(qi_0_new_c) + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y);
  const float qi_0_new_f_padded = fabsf(qi_0_new_f) + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w), qi_0_abs = fabsf(qi->x),
      qi_0_new_size = KSL_MULF(qi_0_new_a_padded, qi_2_abs) + KSL_MULF(qi_0_new_c_padded, qi_1_abs)
          + KSL_MULF(qi_0_new_f_padded, qi_3_abs) + qi_0_abs;
  const float qi_1_new_size = KSL_MULF(qi_0_new_c_padded, qi_0_abs)
          + KSL_MULF(qi_0_new_f_padded, qi_2_abs) + KSL_MULF(qi_0_new_a_padded, qi_3_abs)
          + qi_1_abs,
      qi_2_new_size = KSL_MULF(qi_0_new_f_padded, qi_1_abs) + KSL_MULF(qi_0_new_a_padded, qi_0_abs)
          + KSL_MULF(qi_0_new_c_padded, qi_3_abs) + qi_2_abs,
      qi_3_new_size = KSL_MULF(qi_0_new_f_padded, qi_0_abs) + KSL_MULF(qi_0_new_a_padded, qi_1_abs)
          + KSL_MULF(qi_0_new_c_padded, qi_2_abs) + qi_3_abs;
  const float qi_0_new_bound = KSL_MULF(2.9802328e-07f, qi_0_new_size + 1.9721523e-31f),
      qi_1_new_bound = KSL_MULF(2.9802328e-07f, qi_1_new_size + 1.9721523e-31f),
      qi_2_new_bound = KSL_MULF(2.9802328e-07f, qi_2_new_size + 1.9721523e-31f),
      qi_3_new_bound = KSL_MULF(2.9802328e-07f, qi_3_new_size + 1.9721523e-31f);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_bound;
  qi_bound->y = qi_1_new_bound;
  qi_bound->z = qi_2_new_bound;
  qi_bound->w = qi_3_new_bound;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
     unless inf or NaN.
   w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
   43 mul, 40 add, 11 abs. */
static inline void ksl_omega_to_dquaternionf_certified(const ksl_vec3f_t *w,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *dqo,
    ksl_quaternionf_t *dqo_bound) {
  const float dqo_0a = KSL_MULF(0.5f, w->x), dqo_0c = KSL_MULF(0.5f, w->y),
      dqo_0e = KSL_MULF(0.5f, w->z), dqo_0i = KSL_MULF(qi->x, qi->x),
      dqo_0k = KSL_MULF(qi->y, qi->y), dqo_0m = KSL_MULF(qi->z, qi->z),
      dqo_0o = KSL_MULF(qi->w, qi->w), dqo_0p = 1.0f - dqo_0i - dqo_0k - dqo_0m - dqo_0o,
      dqo_0 = KSL_MULF(dqo_0a, qi->w) + (KSL_MULF(dqo_0c, qi->z) - KSL_MULF(dqo_0e, qi->y))
          + KSL_MULF(qi->x, dqo_0p);
  const float dqo_1 = KSL_MULF(dqo_0e, qi->x) - KSL_MULF(dqo_0a, qi->z) + KSL_MULF(dqo_0c, qi->w)
          + KSL_MULF(qi->y, dqo_0p),
      dqo_2 = KSL_MULF(dqo_0a, qi->y) - KSL_MULF(dqo_0c, qi->x) + KSL_MULF(dqo_0e, qi->w)
          + KSL_MULF(qi->z, dqo_0p),
      dqo_3 = KSL_MULF(qi->w, dqo_0p)
          - (KSL_MULF(dqo_0a, qi->x) + KSL_MULF(dqo_0c, qi->y) + KSL_MULF(dqo_0e, qi->z));
  const float dqo_0a_padded = fabsf(dqo_0a) + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w);
  const float dqo_0c_padded = fabsf(dqo_0c) + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z);
  const float dqo_0e_padded = fabsf(dqo_0e) + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y);
  const float dqo_0p_padded = 1.0f + fabsf(dqo_0i) + fabsf(dqo_0k) + fabsf(dqo_0m) + fabsf(dqo_0o)
          + 1.9721523e-31f;
  const float qi_0_abs = fabsf(qi->x),
      dqo_0h_size = KSL_MULF(dqo_0a_padded, qi_3_abs)
          + (KSL_MULF(dqo_0c_padded, qi_2_abs) + KSL_MULF(dqo_0e_padded, qi_1_abs)),
      dqo_0_size = dqo_0h_size + KSL_MULF(qi_0_abs, dqo_0p_padded);
  const float dqo_1e_size = KSL_MULF(dqo_0e_padded, qi_0_abs) + KSL_MULF(dqo_0a_padded, qi_2_abs)
          + KSL_MULF(dqo_0c_padded, qi_3_abs),
      dqo_1_size = dqo_1e_size + KSL_MULF(qi_1_abs, dqo_0p_padded);
  const float dqo_2e_size = KSL_MULF(dqo_0a_padded, qi_1_abs) + KSL_MULF(dqo_0c_padded, qi_0_abs)
          + KSL_MULF(dqo_0e_padded, qi_3_abs),
      dqo_2_size = dqo_2e_size + KSL_MULF(qi_2_abs, dqo_0p_padded);
  const float dqo_3f_size = KSL_MULF(dqo_0a_padded, qi_0_abs) + KSL_MULF(dqo_0c_padded, qi_1_abs)
          + KSL_MULF(dqo_0e_padded, qi_2_abs),
      dqo_3_size = KSL_MULF(qi_3_abs, dqo_0p_padded) + dqo_3f_size;
  const float dqo_0_bound = KSL_MULF(4.1723263e-07f, dqo_0_size + 1.9721523e-31f),
      dqo_1_bound = KSL_MULF(4.1723263e-07f, dqo_1_size + 1.9721523e-31f),
      dqo_2_bound = KSL_MULF(4.1723263e-07f, dqo_2_size + 1.9721523e-31f),
      dqo_3_bound = KSL_MULF(4.1723263e-07f, dqo_3_size + 1.9721523e-31f);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
  dqo_bound->x = dqo_0_bound;
  dqo_bound->y = dqo_1_bound;
  dqo_bound->z = dqo_2_bound;
  dqo_bound->w = dqo_3_bound;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.
   axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   80 mul, 110 add, 11 product error, 1 div, 11 abs, 1 less, 1 select. */
static inline void ksl_quaternionf_from_axis_angle_certified(const ksl_vec3f_t *axis,
    const float angle, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float half = KSL_MULF(0.5f, angle);
  float qo_3; const float sine = ksl_sincosf(half, &qo_3);
  float qo_own_error_1; const float sine_own_error_1 = ksl_sincos_errorf(half, sine, qo_3,
      &qo_own_error_1);
  const float sine_size_1 = 1.0f + (3.3087225e-24f + KSL_MULF(0.5f, fabsf(angle)));
  const float qo_0 = KSL_MULF(axis->x, sine), qo_1 = KSL_MULF(axis->y, sine),
      qo_2 = KSL_MULF(axis->z, sine);
  const float qo_error_2 = fabsf(ksl_product_errorf(axis->x, sine, qo_0)
          + KSL_MULF(axis->x, sine_own_error_1)),
      qo_error_4 = fabsf(ksl_product_errorf(axis->y, sine, qo_1)
          + KSL_MULF(axis->y, sine_own_error_1)),
      qo_error_6 = fabsf(ksl_product_errorf(axis->z, sine, qo_2)
          + KSL_MULF(axis->z, sine_own_error_1)),
      qo_bound_1 = qo_error_2
          + KSL_MULF(1.2399095e-12f, 3.3087225e-24f + KSL_MULF(fabsf(axis->x), sine_size_1)),
      qo_bound_2 = qo_error_4
          + KSL_MULF(1.2399095e-12f, 3.3087225e-24f + KSL_MULF(fabsf(axis->y), sine_size_1)),
      qo_bound_3 = qo_error_6
          + KSL_MULF(1.2399095e-12f, 3.3087225e-24f + KSL_MULF(fabsf(axis->z), sine_size_1)),
      qo_bound_4 = fabsf(qo_own_error_1) + KSL_MULF(1.1724027e-12f, sine_size_1);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_bound_1;
  qo_bound->y = qo_bound_2;
  qo_bound->z = qo_bound_3;
  qo_bound->w = qo_bound_4;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|
     <= axis_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; axis, axis_bound: vector; angle_bound: number.
   167 mul, 259 add, 18 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4 copysign,
     35 less, 10 equal, 69 select. */
static inline float ksl_axis_angle_from_quaternionf_certified(const ksl_quaternionf_t *q,
    ksl_vec3f_t *axis, float *angle_bound, ksl_vec3f_t *axis_bound) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_inverse_1 = 1.0f / s,
      scaled_s_size_4 = fabsf(scaled_s_0);
  const float scaled_s_1 = KSL_MULF(q->y, s), scaled_s_size_8 = fabsf(scaled_s_1);
  const float scaled_s_2 = KSL_MULF(q->z, s), scaled_s_size_12 = fabsf(scaled_s_2);
  const float scaled_s_3 = KSL_MULF(q->w, s),
      scaled_s_size_15 = q->w == KSL_MULF(scaled_s_3, scaled_s_inverse_1) ? 0.0f : 1e-45f,
      scaled_s_size_16 = fabsf(scaled_s_3);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0,
      upper_size_3 = 1e-45f + fabsf(scaled_s_3 - 0.0f),
      upper_size_7 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_4)
          + fabsf(upper_0a - scaled_s_0),
      upper_size_8 = (q->x == KSL_MULF(scaled_s_0, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_7;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1,
      upper_size_14 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_8)
          + fabsf(upper_1a - scaled_s_1),
      upper_size_15 = (q->y == KSL_MULF(scaled_s_1, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_14;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2,
      upper_size_21 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_12)
          + fabsf(upper_2a - scaled_s_2),
      upper_size_22 = (q->z == KSL_MULF(scaled_s_2, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_21;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3,
      upper_size_29 = scaled_s_size_15
          + (KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_16)
          + fabsf(upper_3a - scaled_s_3));
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s_b_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s);
  const float v_s_size_padded_1 = 3.3087225e-24f
          + (scaled_s_size_4
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_8));
  const float v_y_1 = KSL_MULF(upper_1, v_s);
  const float v_s_size_padded_2 = 3.3087225e-24f
          + (scaled_s_size_8
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_15));
  const float v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_s_size_padded_3 = 3.3087225e-24f
          + (scaled_s_size_12
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_22));
  const float v_n_a = KSL_MULF(v_y_0, v_y_0),
      v_n_a_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, fabsf(v_y_0)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_a_padded_1))),
      v_n_b = KSL_MULF(v_y_1, v_y_1),
      v_n_b_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, fabsf(v_y_1)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_b_padded_1))), v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_d = KSL_MULF(v_y_2, v_y_2),
      v_n_d_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, fabsf(v_y_2)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_d_padded_1))), v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1) + v_n_c_lo, v_n = sqrtf(v_n_e),
      v_n_product_1 = KSL_MULF(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_errorf(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0f ? 1.0f : v_n_twice_1),
      v_n_padded_1 = 3.3087225e-24f
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabsf(v_n_e_lo) + KSL_MULF(2.0854824e-12f, v_n_padded_1),
      v_n_size_4 = KSL_MULF(fabsf(v_n_e) + KSL_MULF(262144.0f, v_n_bound_1), v_n_padded_1 / v_n
          / v_n_e), v_n_size_6 = fabsf(v_n_lo),
      v_n_size_8 = KSL_MULF(5.540742e+11f, sqrtf(v_n_bound_1) + v_n_size_6),
      v_n_size_12 = v_n + (KSL_MULF(4.0f, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8);
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r_b_size_1 = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b;
  const float n = KSL_MULF(v_n, v_r), n_lo = KSL_MULF(v_n - KSL_MULF(n, 1.0f / v_r) + v_n_lo, v_r),
      n_padded_1 = 3.3087225e-24f + v_n_size_12;
  const float half = ksl_atan2f(n, upper_3), half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, KSL_MULF(half_part1_1, half_part1_1)
          + KSL_MULF(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MULF(half_part1_1, n_lo) - KSL_MULF(half_part0_1, 0.0f))
          / (half_most_1 == 0.0f ? 1.0f : half_divisor2_1),
      half_lo = ksl_atan2_errorf(n, upper_3, half) + half_more_1,
      half_padded_1 = 3.3087225e-24f
          + KSL_MULF(n_padded_1, 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b_size_1),
      half_padded_2 = 3.3087225e-24f
          + (scaled_s_size_16
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_29)),
      half_size_2 = fabsf(n), half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabsf(n_lo) + KSL_MULF(1.977137e-12f, half_padded_1),
      half_rest_2 = KSL_MULF(9.379186e-13f, half_padded_2),
      half_size_11 = (half_rest_2 + (3.3087225e-24f + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_15 = 7.0f + fabsf(half_lo),
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MULF(1.6915335e+11f, half_size_11 < 0.25f ? half_size_19 : half_size_15);
  const float divisor = v_n == 0.0f ? 1.0f : v_n, divisor_lo = v_n == 0.0f ? 0.0f : v_n_lo,
      divisor_bound_1 = KSL_MULF(1.9042977e-12f, n_padded_1) + v_n_size_6,
      divisor_size_3 = fabsf(v_n - 0.0f), divisor_size_7 = divisor_bound_1 + fabsf(1.0f - v_n);
  const float unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MULF(unit_0, divisor),
      unit_lo_1 = (v_y_0 - unit_product_1 - ksl_product_errorf(unit_0, divisor, unit_product_1)
          - KSL_MULF(unit_0, divisor_lo)) / divisor;
  const float divisor_size_10 = (v_n == 0.0f ? 1.0f : v_n_size_12)
          + KSL_MULF(3.141416e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : divisor_size_7);
  const float unit_padded_1 = 3.3087225e-24f + divisor_size_10, unit_size_1 = fabsf(unit_0),
      unit_size_2 = fabsf(divisor),
      unit_bound_1 = fabsf(divisor_lo) + KSL_MULF(3.2827692e-12f, unit_padded_1),
      unit_size_7 = KSL_MULF(4.0f, unit_bound_1) < unit_size_2 ? unit_size_2 : 0.0f,
      unit_reach_1 = unit_size_2 + KSL_MULF(262144.0f, unit_bound_1),
      unit_size_11 = unit_size_1
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_1) + v_n_a_padded_1)
          / unit_size_7) / unit_size_2;
  const float unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MULF(unit_1, divisor),
      unit_size_12 = fabsf(unit_1);
  const float unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MULF(unit_2, divisor),
      unit_size_19 = fabsf(unit_2);
  const float angle = KSL_MULF(2.0f, half);
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0,
      axis_size_4 = fabsf(unit_lo_1) + KSL_MULF(4.7394384e-12f, 3.3087225e-24f + unit_size_11)
          + fabsf(1.0f - unit_0);
  const float angle_rest_1 = KSL_MULF(6.2013957e-12f, 3.3087225e-24f
          + KSL_MULF(2.0f, fabsf(half) + (half_padded_1 + half_padded_2) / half_size_5
          + half_size_21));
  const float axis_size_7 = (v_n == 0.0f ? 1.0f : unit_size_11)
          + KSL_MULF(2.1684825e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : axis_size_4);
  const float unit_size_18 = unit_size_12
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_12) + v_n_b_padded_1)
          / unit_size_7) / unit_size_2;
  const float unit_error_2 = fabsf((v_y_1 - unit_product_2
          - ksl_product_errorf(unit_1, divisor, unit_product_2) - KSL_MULF(unit_1, divisor_lo))
          / divisor);
  const float unit_size_25 = unit_size_19
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_19) + v_n_d_padded_1)
          / unit_size_7) / unit_size_2;
  const float unit_error_3 = fabsf((v_y_2 - unit_product_3
          - ksl_product_errorf(unit_2, divisor, unit_product_3) - KSL_MULF(unit_2, divisor_lo))
          / divisor), angle_bound_1 = fabsf(KSL_MULF(2.0f, half_lo)) + angle_rest_1,
      axis_bound_2 = fabsf(v_n == 0.0f ? 0.0f : unit_lo_1)
          + KSL_MULF(4.7394397e-12f, 3.3087225e-24f + axis_size_7),
      unit_bound_2 = unit_error_2 + KSL_MULF(4.7394384e-12f, 3.3087225e-24f + unit_size_18),
      unit_bound_3 = unit_error_3 + KSL_MULF(4.7394384e-12f, 3.3087225e-24f + unit_size_25);
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  *angle_bound = angle_bound_1;
  axis_bound->x = axis_bound_2;
  axis_bound->y = unit_bound_2;
  axis_bound->z = unit_bound_3;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error of
     qo| <= qo_bound unless inf or NaN.
   v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   236 mul, 305 add, 14 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1 equal,
     24 select. */
static inline void ksl_quaternionf_exp_certified(const ksl_vec3f_t *v, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float h_0 = KSL_MULF(0.5f, v->x);
  const float h_1 = KSL_MULF(0.5f, v->y);
  const float h_2 = KSL_MULF(0.5f, v->z);
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
  const float qo_0 = KSL_MULF(h_0, k);
  const float qo_1 = KSL_MULF(h_1, k);
  const float qo_2 = KSL_MULF(h_2, k);
  const float qo_3 = x < 1.0f ? near : cosine;
  const float fine_h_0 = KSL_MULF(0.5f, v->x);
  const float fine_h_1 = KSL_MULF(0.5f, v->y);
  const float fine_h_2 = KSL_MULF(0.5f, v->z);
  const float h_size_0 = fabsf(fine_h_0),
      h_size_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, fabsf(v->x));
  const float h_size_1 = fabsf(fine_h_1),
      h_size_padded_2 = 3.3087225e-24f + KSL_MULF(0.5f, fabsf(v->y));
  const float h_size_2 = fabsf(fine_h_2),
      h_size_padded_3 = 3.3087225e-24f + KSL_MULF(0.5f, fabsf(v->z));
  const float h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const float h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const float s = 4.611686e+18f < h_largest2 ? 2.7105054e-20f : 1.0f,
      s_size_1 = 4.611686e+18f < h_largest2 ? 2.7105054e-20f : 1.0f;
  const float reduced_0 = KSL_MULF(fine_h_0, s), reduced_1 = KSL_MULF(fine_h_1, s),
      reduced_2 = KSL_MULF(fine_h_2, s);
  const float up = s < 1.0f ? 3.689349e+19f : 1.0f;
  const float reduced_length_a = KSL_MULF(reduced_0, reduced_0),
      reduced_length_a_padded_1 = 3.3087225e-24f + KSL_MULF(h_size_padded_1, s_size_1),
      reduced_length_b = KSL_MULF(reduced_1, reduced_1),
      reduced_length_b_padded_1 = 3.3087225e-24f + KSL_MULF(h_size_padded_2, s_size_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right_1 = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest_1 = ksl_product_restf(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right_1),
      reduced_length_a_size_1 = KSL_MULF(reduced_length_a_padded_1, reduced_length_a_padded_1),
      reduced_length_d = KSL_MULF(reduced_2, reduced_2),
      reduced_length_d_padded_1 = 3.3087225e-24f + KSL_MULF(h_size_padded_3, s_size_1),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right_1 = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest_1 = ksl_product_restf(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right_1),
      reduced_length_c_lo = reduced_length_c_left_rest_1
          + ksl_product_restf(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
          + reduced_length_e_right_rest_1 + reduced_length_c_lo,
      reduced_length_c_size_1 = reduced_length_a_size_1
          + KSL_MULF(reduced_length_b_padded_1, reduced_length_b_padded_1),
      reduced_length = sqrtf(reduced_length_e),
      reduced_length_product_1 = KSL_MULF(reduced_length, reduced_length),
      reduced_length_exact_1 = reduced_length_e - reduced_length_product_1
          - ksl_product_errorf(reduced_length, reduced_length, reduced_length_product_1),
      reduced_length_twice_1 = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact_1 + reduced_length_e_lo)
          / (reduced_length == 0.0f ? 1.0f : reduced_length_twice_1),
      reduced_length_padded_1 = 3.3087225e-24f
          + (reduced_length_c_size_1
          + KSL_MULF(reduced_length_d_padded_1, reduced_length_d_padded_1)),
      reduced_length_bound_1 = fabsf(reduced_length_e_lo)
          + KSL_MULF(9.308236e-13f, reduced_length_padded_1),
      reduced_length_reach_1 = fabsf(reduced_length_e)
          + KSL_MULF(262144.0f, reduced_length_bound_1),
      reduced_length_size_4 = KSL_MULF(reduced_length_reach_1, reduced_length_padded_1
          / reduced_length / reduced_length_e),
      reduced_length_size_8 = KSL_MULF(6.958476e+11f, sqrtf(reduced_length_bound_1)
          + fabsf(reduced_length_lo));
  const float half_angle = KSL_MULF(reduced_length, up),
      half_angle_lo = KSL_MULF(reduced_length - KSL_MULF(half_angle, 1.0f / up)
          + reduced_length_lo, up);
  const float reduced_length_size_12 = reduced_length
          + (KSL_MULF(4.0f, reduced_length_bound_1) < reduced_length_e ? reduced_length_size_4
          : reduced_length_size_8);
  const float half_angle_size_1 = KSL_MULF(3.3087225e-24f + reduced_length_size_12, s < 1.0f
          ? 3.689349e+19f : 1.0f);
  const float y = KSL_MULF(half_angle, half_angle), y_padded_1 = 3.3087225e-24f + half_angle_size_1,
      y_bound_1 = fabsf(half_angle_lo) + KSL_MULF(1.6484983e-12f, y_padded_1),
      y_size_2 = KSL_MULF(y_padded_1, fabsf(half_angle) + KSL_MULF(262144.0f, y_bound_1));
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1;
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_size_4 = 1e-45f + fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_8 = fabsf(1.4901161e-08f - half_angle) + y_bound_1,
      sinc_divisor_size_10 = KSL_MULF(1.9990821e+11f, y_bound_1 < sinc_divisor_size_4 ? 0.0f
          : sinc_divisor_size_8);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 3.3087225e-24f + (1.0f + y_padded_1),
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_1)
          + sinc_divisor_size_10), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(5.1586396e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0f,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y),
      y_lo = ksl_product_errorf(half_angle, half_angle, y)
          + (KSL_MULF(half_angle_lo, half_angle) + KSL_MULF(half_angle, half_angle_lo)),
      sinc_b = 1.0f - sinc_a, sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_2 + y_size_2),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3639474e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(7.941701e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.235067e+09f, y_bound_1 < sinc_divisor_size_4 ? 0.0f : sinc_size_5);
  const float fine_qo_0 = KSL_MULF(fine_h_0, sinc),
      fine_qo_padded_1 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11) + sinc_size_7),
      fine_qo_reach_2 = fabsf(sinc)
          + KSL_MULF(262144.0f, fabsf(sinc_lo) + KSL_MULF(2.3639482e-10f, fine_qo_padded_1)),
      fine_qo_size_2 = KSL_MULF(fine_qo_padded_1, fabsf(fine_h_0)
          + KSL_MULF(262144.0f, KSL_MULF(3.5527347e-14f, h_size_padded_1)));
  const float fine_qo_1 = KSL_MULF(fine_h_1, sinc),
      fine_qo_size_7 = KSL_MULF(fine_qo_padded_1, fabsf(fine_h_1)
          + KSL_MULF(262144.0f, KSL_MULF(3.5527347e-14f, h_size_padded_2)));
  const float fine_qo_2 = KSL_MULF(fine_h_2, sinc),
      fine_qo_size_11 = KSL_MULF(fine_qo_padded_1, fabsf(fine_h_2)
          + KSL_MULF(262144.0f, KSL_MULF(3.5527347e-14f, h_size_padded_3)));
  const float qo_error_2 = KSL_MULF(1.0000005f, fabsf(ksl_product_errorf(fine_h_0, sinc, fine_qo_0)
          + KSL_MULF(fine_h_0, sinc_lo) + (fine_qo_0 - qo_0))),
      qo_error_4 = KSL_MULF(1.0000005f, fabsf(ksl_product_errorf(fine_h_1, sinc, fine_qo_1)
          + KSL_MULF(fine_h_1, sinc_lo) + (fine_qo_1 - qo_1))),
      qo_error_6 = KSL_MULF(1.0000005f, fabsf(ksl_product_errorf(fine_h_2, sinc, fine_qo_2)
          + KSL_MULF(fine_h_2, sinc_lo) + (fine_qo_2 - qo_2))),
      qo_apart_8 = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1) + (c - qo_3),
      qo_bound_1 = qo_error_2
          + KSL_MULF(2.3676172e-10f, 3.3087225e-24f
          + (fine_qo_size_2 + KSL_MULF(fine_qo_reach_2, h_size_padded_1))),
      qo_bound_2 = qo_error_4
          + KSL_MULF(2.3676172e-10f, 3.3087225e-24f
          + (fine_qo_size_7 + KSL_MULF(fine_qo_reach_2, h_size_padded_2))),
      qo_bound_3 = qo_error_6
          + KSL_MULF(2.3676172e-10f, 3.3087225e-24f
          + (fine_qo_size_11 + KSL_MULF(fine_qo_reach_2, h_size_padded_3))),
      qo_bound_4 = KSL_MULF(1.0000005f, fabsf(qo_apart_8))
          + KSL_MULF(3.041182e-12f, sinc_quotient_padded_1);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_bound_1;
  qo_bound->y = qo_bound_2;
  qo_bound->z = qo_bound_3;
  qo_bound->w = qo_bound_4;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it;
     |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.
   175 mul, 256 add, 19 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4 copysign,
     35 less, 10 equal, 65 select. */
static inline void ksl_quaternionf_log_certified(const ksl_quaternionf_t *q, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_inverse_1 = 1.0f / s,
      scaled_s_size_4 = fabsf(scaled_s_0);
  const float scaled_s_1 = KSL_MULF(q->y, s), scaled_s_size_8 = fabsf(scaled_s_1);
  const float scaled_s_2 = KSL_MULF(q->z, s), scaled_s_size_12 = fabsf(scaled_s_2);
  const float scaled_s_3 = KSL_MULF(q->w, s),
      scaled_s_size_15 = q->w == KSL_MULF(scaled_s_3, scaled_s_inverse_1) ? 0.0f : 1e-45f,
      scaled_s_size_16 = fabsf(scaled_s_3);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0,
      upper_size_3 = 1e-45f + fabsf(scaled_s_3 - 0.0f),
      upper_size_7 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_4)
          + fabsf(upper_0a - scaled_s_0),
      upper_size_8 = (q->x == KSL_MULF(scaled_s_0, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_7;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1,
      upper_size_14 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_8)
          + fabsf(upper_1a - scaled_s_1),
      upper_size_15 = (q->y == KSL_MULF(scaled_s_1, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_14;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2,
      upper_size_21 = KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_12)
          + fabsf(upper_2a - scaled_s_2),
      upper_size_22 = (q->z == KSL_MULF(scaled_s_2, scaled_s_inverse_1) ? 0.0f : 1e-45f)
          + upper_size_21;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3,
      upper_size_29 = scaled_s_size_15
          + (KSL_MULF(3.197449e-14f, 3.3087225e-24f + scaled_s_size_16)
          + fabsf(upper_3a - scaled_s_3));
  const float v_s_size_0 = fabsf(upper_0),
      v_s_size_padded_1 = 3.3087225e-24f
          + (scaled_s_size_4
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_8));
  const float v_s_size_1 = fabsf(upper_1),
      v_s_size_padded_2 = 3.3087225e-24f
          + (scaled_s_size_8
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_15));
  const float v_s_size_2 = fabsf(upper_2),
      v_s_size_padded_3 = 3.3087225e-24f
          + (scaled_s_size_12
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_22));
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s_b_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0),
      v_n_a_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, fabsf(v_y_0)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_a_padded_1))),
      v_n_b = KSL_MULF(v_y_1, v_y_1),
      v_n_b_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, fabsf(v_y_1)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_b_padded_1))), v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_d = KSL_MULF(v_y_2, v_y_2),
      v_n_d_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, fabsf(v_y_2)
          + KSL_MULF(262144.0f, KSL_MULF(9.841079e-13f, v_n_d_padded_1))), v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1) + v_n_c_lo, v_n = sqrtf(v_n_e),
      v_n_product_1 = KSL_MULF(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_errorf(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0f ? 1.0f : v_n_twice_1),
      v_n_padded_1 = 3.3087225e-24f
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabsf(v_n_e_lo) + KSL_MULF(2.0854824e-12f, v_n_padded_1),
      v_n_size_4 = KSL_MULF(fabsf(v_n_e) + KSL_MULF(262144.0f, v_n_bound_1), v_n_padded_1 / v_n
          / v_n_e), v_n_size_8 = KSL_MULF(5.540742e+11f, sqrtf(v_n_bound_1) + fabsf(v_n_lo));
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r_b_size_1 = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b;
  const float n = KSL_MULF(v_n, v_r), n_lo = KSL_MULF(v_n - KSL_MULF(n, 1.0f / v_r) + v_n_lo, v_r),
      n_padded_1 = 3.3087225e-24f
          + (v_n + (KSL_MULF(4.0f, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8)),
      n_size_1 = KSL_MULF(n_padded_1, 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b_size_1);
  const float half = ksl_atan2f(n, upper_3), half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, KSL_MULF(half_part1_1, half_part1_1)
          + KSL_MULF(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MULF(half_part1_1, n_lo) - KSL_MULF(half_part0_1, 0.0f))
          / (half_most_1 == 0.0f ? 1.0f : half_divisor2_1),
      half_lo = ksl_atan2_errorf(n, upper_3, half) + half_more_1,
      half_padded_1 = 3.3087225e-24f + n_size_1,
      half_padded_2 = 3.3087225e-24f
          + (scaled_s_size_16
          + KSL_MULF(1.0995137e+12f, scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_29)),
      half_size_2 = fabsf(n), half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabsf(n_lo) + KSL_MULF(1.977137e-12f, half_padded_1),
      half_rest_2 = KSL_MULF(9.379186e-13f, half_padded_2),
      half_size_11 = (half_rest_2 + (3.3087225e-24f + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_15 = 7.0f + fabsf(half_lo),
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MULF(1.6915335e+11f, half_size_11 < 0.25f ? half_size_19 : half_size_15);
  const float divisor = n == 0.0f ? 1.0f : n, divisor_lo = n == 0.0f ? 0.0f : n_lo,
      divisor_size_8 = fabsf(1.0f - n) + half_bound_1;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor, k_product_1 = KSL_MULF(k, divisor),
      k_lo = (theta - k_product_1 - ksl_product_errorf(k, divisor, k_product_1)
          + KSL_MULF(2.0f, half_lo) - KSL_MULF(k, divisor_lo)) / divisor;
  const float divisor_size_11 = (n == 0.0f ? 1.0f : n_size_1)
          + KSL_MULF(2.443323e+11f, half_bound_1 < 1e-45f + fabsf(n - 0.0f) ? 0.0f
          : divisor_size_8);
  const float k_padded_2 = 3.3087225e-24f + divisor_size_11, k_size_1 = fabsf(k),
      k_size_2 = fabsf(divisor),
      k_padded_1 = 3.3087225e-24f
          + KSL_MULF(2.0f, fabsf(half) + (half_padded_1 + half_padded_2) / half_size_5
          + half_size_21), k_bound_1 = fabsf(divisor_lo) + KSL_MULF(4.2207045e-12f, k_padded_2),
      k_size_8 = (k_padded_1 + KSL_MULF(k_padded_2, k_size_1))
          / (KSL_MULF(4.0f, k_bound_1) < k_size_2 ? k_size_2 : 0.0f);
  const float vector_0 = KSL_MULF(upper_0, k),
      vector_padded_1 = 3.3087225e-24f
          + (k_size_1 + KSL_MULF(k_size_2 + KSL_MULF(262144.0f, k_bound_1), k_size_8) / k_size_2),
      vector_reach_2 = k_size_1
          + KSL_MULF(262144.0f, fabsf(k_lo) + KSL_MULF(8.927625e-12f, vector_padded_1)),
      vector_size_2 = KSL_MULF(vector_padded_1, fabsf(upper_0)
          + KSL_MULF(262144.0f, KSL_MULF(9.379186e-13f, v_s_size_padded_1)));
  const float vector_1 = KSL_MULF(upper_1, k),
      vector_size_6 = KSL_MULF(vector_padded_1, fabsf(upper_1)
          + KSL_MULF(262144.0f, KSL_MULF(9.379186e-13f, v_s_size_padded_2)));
  const float vector_2 = KSL_MULF(upper_2, k),
      vector_size_10 = KSL_MULF(vector_padded_1, fabsf(upper_2)
          + KSL_MULF(262144.0f, KSL_MULF(9.379186e-13f, v_s_size_padded_3)));
  const float vector_rest_2 = KSL_MULF(9.281226e-12f, 3.3087225e-24f
          + (vector_size_2 + KSL_MULF(v_s_size_padded_1, vector_reach_2))),
      vector_rest_3 = KSL_MULF(9.281226e-12f, 3.3087225e-24f
          + (vector_size_6 + KSL_MULF(v_s_size_padded_2, vector_reach_2))),
      vector_rest_4 = KSL_MULF(9.281226e-12f, 3.3087225e-24f
          + (vector_size_10 + KSL_MULF(v_s_size_padded_3, vector_reach_2))),
      vector_bound_2 = fabsf(ksl_product_errorf(upper_0, k, vector_0) + KSL_MULF(upper_0, k_lo))
          + vector_rest_2,
      vector_bound_3 = fabsf(ksl_product_errorf(upper_1, k, vector_1) + KSL_MULF(upper_1, k_lo))
          + vector_rest_3,
      vector_bound_4 = fabsf(ksl_product_errorf(upper_2, k, vector_2) + KSL_MULF(upper_2, k_lo))
          + vector_rest_4;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
  vo_bound->x = vector_bound_2;
  vo_bound->y = vector_bound_3;
  vo_bound->z = vector_bound_4;
}

#endif
