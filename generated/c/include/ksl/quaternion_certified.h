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
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
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
  const double y_0_new_a_abs = fabs(y_0_new_a), y_0_abs = fabs(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const double y_1_new_a_abs = fabs(y_1_new_a), y_1_abs = fabs(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const double y_2_new_a_abs = fabs(y_2_new_a), y_2_abs = fabs(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const double y_3_new_a_abs = fabs(y_3_new_a), y_3_abs = fabs(y->w),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const double y_0_new_padded = y_0_new_size + 2.004168360008973e-292,
      y_0_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_padded);
  const double y_1_new_padded = y_1_new_size + 2.004168360008973e-292,
      y_1_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_padded);
  const double y_2_new_padded = y_2_new_size + 2.004168360008973e-292,
      y_2_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_padded);
  const double y_3_new_padded = y_3_new_size + 2.004168360008973e-292,
      y_3_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_3_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
  y_bound->w = y_3_new_error_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->y, v->z), c_0b = KSL_MUL(q->z, v->y), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->z, v->x), c_1b = KSL_MUL(q->x, v->z), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->x, v->y), c_2b = KSL_MUL(q->y, v->x), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->y, t_2), turn_0b = KSL_MUL(q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL(q->z, t_0), turn_1b = KSL_MUL(q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL(q->x, t_1), turn_2b = KSL_MUL(q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  const double c_0a_abs = fabs(c_0a), c_0b_abs = fabs(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const double c_1a_abs = fabs(c_1a), c_1b_abs = fabs(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const double c_2a_abs = fabs(c_2a), c_2b_abs = fabs(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const double c_0_padded = c_0_size + 2.004168360008973e-292;
  const double t_0_size = KSL_MUL(2.0, c_0_padded);
  const double c_1_padded = c_1_size + 2.004168360008973e-292;
  const double t_1_size = KSL_MUL(2.0, c_1_padded);
  const double c_2_padded = c_2_size + 2.004168360008973e-292;
  const double t_2_size = KSL_MUL(2.0, c_2_padded);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y), turn_0a_size = KSL_MUL(q_1_abs, t_2_padded);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z), turn_0b_size = KSL_MUL(q_2_abs, t_1_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w), turn_0d_size = KSL_MUL(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const double turn_1a_size = KSL_MUL(q_2_abs, t_0_padded), q_0_abs = fabs(q->x),
      turn_1b_size = KSL_MUL(q_0_abs, t_2_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MUL(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const double turn_2a_size = KSL_MUL(q_0_abs, t_1_padded),
      turn_2b_size = KSL_MUL(q_1_abs, t_0_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MUL(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const double v_0_abs = fabs(v->x), vo_0_size = v_0_abs + turn_0_size;
  const double v_1_abs = fabs(v->y), vo_1_size = v_1_abs + turn_1_size;
  const double v_2_abs = fabs(v->z), vo_2_size = v_2_abs + turn_2_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(7.7715611723761e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(7.7715611723761e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(7.7715611723761e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qconjv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->z, v->y), c_0b = KSL_MUL(q->y, v->z), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->x, v->z), c_1b = KSL_MUL(q->z, v->x), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->y, v->x), c_2b = KSL_MUL(q->x, v->y), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->z, t_1), turn_0b = KSL_MUL(q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL(q->x, t_2), turn_1b = KSL_MUL(q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL(q->y, t_0), turn_2b = KSL_MUL(q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  const double c_0a_abs = fabs(c_0a), c_0b_abs = fabs(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const double c_1a_abs = fabs(c_1a), c_1b_abs = fabs(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const double c_2a_abs = fabs(c_2a), c_2b_abs = fabs(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const double c_0_padded = c_0_size + 2.004168360008973e-292;
  const double t_0_size = KSL_MUL(2.0, c_0_padded);
  const double c_1_padded = c_1_size + 2.004168360008973e-292;
  const double t_1_size = KSL_MUL(2.0, c_1_padded);
  const double c_2_padded = c_2_size + 2.004168360008973e-292;
  const double t_2_size = KSL_MUL(2.0, c_2_padded);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z), turn_0a_size = KSL_MUL(q_2_abs, t_1_padded);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y), turn_0b_size = KSL_MUL(q_1_abs, t_2_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w), turn_0d_size = KSL_MUL(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const double q_0_abs = fabs(q->x), turn_1a_size = KSL_MUL(q_0_abs, t_2_padded),
      turn_1b_size = KSL_MUL(q_2_abs, t_0_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MUL(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const double turn_2a_size = KSL_MUL(q_1_abs, t_0_padded),
      turn_2b_size = KSL_MUL(q_0_abs, t_1_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MUL(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const double v_0_abs = fabs(v->x), vo_0_size = v_0_abs + turn_0_size;
  const double v_1_abs = fabs(v->y), vo_1_size = v_1_abs + turn_1_size;
  const double v_2_abs = fabs(v->z), vo_2_size = v_2_abs + turn_2_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(7.7715611723761e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(7.7715611723761e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(7.7715611723761e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->y, q2i->z),
      qo_0c = KSL_MUL(q1i->z, q2i->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MUL(q1i->w, q2i->x), qo_0 = qo_0e + qo_0f;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1e = qo_1c + qo_1d,
      qo_1f = KSL_MUL(q1i->w, q2i->y), qo_1 = qo_1e + qo_1f;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2e = qo_2c + qo_2d,
      qo_2f = KSL_MUL(q1i->w, q2i->z), qo_2 = qo_2e + qo_2f;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const double qo_0b_abs = fabs(qo_0b), qo_0c_abs = fabs(qo_0c), qo_0d_size = qo_0b_abs + qo_0c_abs,
      qo_0a_abs = fabs(qo_0a), qo_0e_size = qo_0a_abs + qo_0d_size, qo_0f_abs = fabs(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabs(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabs(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const double qo_3b_abs = fabs(qo_3b), qo_3c_abs = fabs(qo_3c), qo_3d_size = qo_3b_abs + qo_3c_abs,
      qo_3e_abs = fabs(qo_3e), qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabs(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(4.440892098500628e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(4.440892098500628e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(4.440892098500628e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qqconj_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->w, q2i->x),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0e = KSL_MUL(q1i->y, q2i->z),
      qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1e = KSL_MUL(q1i->w, q2i->y),
      qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2e = KSL_MUL(q1i->w, q2i->z),
      qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3d = KSL_MUL(q1i->z, q2i->z), qo_3e = qo_3c + qo_3d,
      qo_3f = KSL_MUL(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0e_abs = fabs(qo_0e), qo_0f_size = qo_0d_abs + qo_0e_abs,
      qo_0_size = qo_0c_size + qo_0f_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_abs = fabs(qo_1e), qo_1f_size = qo_1d_abs + qo_1e_abs,
      qo_1_size = qo_1c_size + qo_1f_size;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_abs = fabs(qo_2e), qo_2f_size = qo_2d_abs + qo_2e_abs,
      qo_2_size = qo_2c_size + qo_2f_size;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabs(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qconjq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->w, q2i->x), qo_0b = KSL_MUL(q1i->x, q2i->w),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0e = KSL_MUL(q1i->y, q2i->z),
      qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MUL(q1i->w, q2i->y), qo_1e = KSL_MUL(q1i->y, q2i->w),
      qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MUL(q1i->w, q2i->z), qo_2e = KSL_MUL(q1i->z, q2i->w),
      qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3d = KSL_MUL(q1i->z, q2i->z), qo_3e = qo_3c + qo_3d,
      qo_3f = KSL_MUL(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0e_abs = fabs(qo_0e), qo_0f_size = qo_0d_abs + qo_0e_abs,
      qo_0_size = qo_0c_size + qo_0f_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_abs = fabs(qo_1e), qo_1f_size = qo_1d_abs + qo_1e_abs,
      qo_1_size = qo_1c_size + qo_1f_size;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_abs = fabs(qo_2e), qo_2f_size = qo_2d_abs + qo_2e_abs,
      qo_2_size = qo_2c_size + qo_2f_size;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabs(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_quaternion_product_qconjqconj_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1i->y, q2i->z), qo_0b = KSL_MUL(q1i->z, q2i->y),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MUL(q1i->x, q2i->w), qo_0e = qo_0c - qo_0d,
      qo_0f = KSL_MUL(q1i->w, q2i->x), qo_0 = qo_0e - qo_0f;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1e = qo_1c - qo_1d,
      qo_1f = KSL_MUL(q1i->w, q2i->y), qo_1 = qo_1e - qo_1f;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2e = qo_2c - qo_2d,
      qo_2f = KSL_MUL(q1i->w, q2i->z), qo_2 = qo_2e - qo_2f;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0e_size = qo_0c_size + qo_0d_abs, qo_0f_abs = fabs(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabs(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabs(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const double qo_3b_abs = fabs(qo_3b), qo_3c_abs = fabs(qo_3c), qo_3d_size = qo_3b_abs + qo_3c_abs,
      qo_3e_abs = fabs(qo_3e), qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabs(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(4.440892098500628e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(4.440892098500628e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(4.440892098500628e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qxconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqx_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->w, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqxconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->z, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qyqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qyconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqyconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qzqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qzconjqconj_certified(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqz_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b;
  const double qo_2a = KSL_MUL(qi->w, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0c_padded = qo_0c_size + 2.004168360008973e-292,
      qo_0c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0c_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_quaternion_product_qconjqzconj_certified(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->y, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(2.2204460492503136e-16, qo_0_padded);
  const double qo_1c_padded = qo_1c_size + 2.004168360008973e-292,
      qo_1c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_1c_padded);
  const double qo_2c_padded = qo_2c_size + 2.004168360008973e-292,
      qo_2c_error_bound = KSL_MUL(2.2204460492503136e-16, qo_2c_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(2.2204460492503136e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_quaternion_product_qv_certified(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->y, vi->z), qo_0b = KSL_MUL(qi->z, vi->y), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0c + qo_0d;
  const double qo_1a = KSL_MUL(qi->z, vi->x), qo_1b = KSL_MUL(qi->x, vi->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1c + qo_1d;
  const double qo_2a = KSL_MUL(qi->x, vi->y), qo_2b = KSL_MUL(qi->y, vi->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2c + qo_2d;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(qi->z, vi->z), qo_3e = qo_3c + qo_3d, qo_3 = -qo_3e;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0_size = qo_0c_size + qo_0d_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1_size = qo_1c_size + qo_1d_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2_size = qo_2c_size + qo_2d_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3e_padded = qo_3e_size + 2.004168360008973e-292,
      qo_3e_error_bound = KSL_MUL(3.3306690738754706e-16, qo_3e_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3e_error_bound;
}

/* qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 12 abs. */
static inline void ksl_quaternion_product_qconjv_certified(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(qi->z, vi->y), qo_0b = KSL_MUL(qi->y, vi->z), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0c + qo_0d;
  const double qo_1a = KSL_MUL(qi->x, vi->z), qo_1b = KSL_MUL(qi->z, vi->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1c + qo_1d;
  const double qo_2a = KSL_MUL(qi->y, vi->x), qo_2b = KSL_MUL(qi->x, vi->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2c + qo_2d;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(qi->z, vi->z), qo_3 = qo_3c + qo_3d;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0_size = qo_0c_size + qo_0d_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1_size = qo_1c_size + qo_1d_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2_size = qo_2c_size + qo_2d_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3_size = qo_3c_size + qo_3d_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(3.3306690738754706e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_quaternion_product_vq_certified(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->y, qi->z),
      qo_0c = KSL_MUL(vi->z, qi->y), qo_0d = qo_0b - qo_0c, qo_0 = qo_0a + qo_0d;
  const double qo_1a = KSL_MUL(vi->z, qi->x), qo_1b = KSL_MUL(vi->x, qi->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1c + qo_1d;
  const double qo_2a = KSL_MUL(vi->x, qi->y), qo_2b = KSL_MUL(vi->y, qi->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2c + qo_2d;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(vi->z, qi->z), qo_3e = qo_3c + qo_3d, qo_3 = -qo_3e;
  const double qo_0b_abs = fabs(qo_0b), qo_0c_abs = fabs(qo_0c), qo_0d_size = qo_0b_abs + qo_0c_abs,
      qo_0a_abs = fabs(qo_0a), qo_0_size = qo_0a_abs + qo_0d_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1_size = qo_1c_size + qo_1d_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2_size = qo_2c_size + qo_2d_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3e_padded = qo_3e_size + 2.004168360008973e-292,
      qo_3e_error_bound = KSL_MUL(3.3306690738754706e-16, qo_3e_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3e_error_bound;
}

/* qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 12 abs. */
static inline void ksl_quaternion_product_vqconj_certified(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->z, qi->y),
      qo_0c = KSL_MUL(vi->y, qi->z), qo_0d = qo_0b - qo_0c, qo_0 = qo_0a + qo_0d;
  const double qo_1a = KSL_MUL(vi->x, qi->z), qo_1b = KSL_MUL(vi->z, qi->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1c + qo_1d;
  const double qo_2a = KSL_MUL(vi->y, qi->x), qo_2b = KSL_MUL(vi->x, qi->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2c + qo_2d;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(vi->z, qi->z), qo_3 = qo_3c + qo_3d;
  const double qo_0b_abs = fabs(qo_0b), qo_0c_abs = fabs(qo_0c), qo_0d_size = qo_0b_abs + qo_0c_abs,
      qo_0a_abs = fabs(qo_0a), qo_0_size = qo_0a_abs + qo_0d_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1_size = qo_1c_size + qo_1d_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2_size = qo_2c_size + qo_2d_abs;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3_size = qo_3c_size + qo_3d_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(3.3306690738754706e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.
   q1i, q2i: quaternion (x, y, z, w), the scalar last; dot_bound: number.
   5 mul, 7 add, 4 abs. */
static inline double ksl_dot_qq_certified(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, double *dot_bound) {
  const double dot_a = KSL_MUL(q1i->x, q2i->x), dot_b = KSL_MUL(q1i->y, q2i->y),
      dot_c = dot_a + dot_b, dot_d = KSL_MUL(q1i->z, q2i->z), dot_e = dot_c + dot_d,
      dot_f = KSL_MUL(q1i->w, q2i->w), dot = dot_e + dot_f;
  const double dot_a_abs = fabs(dot_a), dot_b_abs = fabs(dot_b), dot_c_size = dot_a_abs + dot_b_abs,
      dot_d_abs = fabs(dot_d), dot_e_size = dot_c_size + dot_d_abs, dot_f_abs = fabs(dot_f),
      dot_size = dot_e_size + dot_f_abs;
  const double dot_padded = dot_size + 2.004168360008973e-292,
      dot_error_bound = KSL_MUL(4.440892098500628e-16, dot_padded);
  *dot_bound = dot_error_bound;
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_add_dpiToq_certified(const ksl_vec3_t *dpi, ksl_quaternion_t *qi,
    ksl_quaternion_t *qi_bound) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->x), qi_0_new_b = KSL_MUL(qi_0_new_a, qi->w),
      qi_0_new_c = KSL_MUL(0.5, dpi->z), qi_0_new_d = KSL_MUL(qi_0_new_c, qi->y),
      qi_0_new_e = KSL_MUL(0.5, dpi->y), qi_0_new_f = KSL_MUL(qi_0_new_e, qi->z),
      qi_0_new_g = qi_0_new_d - qi_0_new_f, qi_0_new_h = qi_0_new_b + qi_0_new_g,
      qi_0_new = qi_0_new_h + qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_a, qi->z), qi_1_new_b = KSL_MUL(qi_0_new_c, qi->x),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_d = KSL_MUL(qi_0_new_e, qi->w),
      qi_1_new_e = qi_1_new_c + qi_1_new_d, qi_1_new = qi_1_new_e + qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_e, qi->x), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c + qi_2_new_d, qi_2_new = qi_2_new_e + qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_a, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_e, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new = qi->w - qi_3_new_e;
  const double qi_0_new_a_abs = fabs(qi_0_new_a),
      qi_0_new_a_padded = qi_0_new_a_abs + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w), qi_0_new_b_size = KSL_MUL(qi_0_new_a_padded, qi_3_abs);
  const double qi_0_new_c_abs = fabs(qi_0_new_c),
      qi_0_new_c_padded = qi_0_new_c_abs + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y), qi_0_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_1_abs);
  const double qi_0_new_e_abs = fabs(qi_0_new_e),
      qi_0_new_e_padded = qi_0_new_e_abs + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z), qi_0_new_f_size = KSL_MUL(qi_0_new_e_padded, qi_2_abs),
      qi_0_new_g_size = qi_0_new_d_size + qi_0_new_f_size,
      qi_0_new_h_size = qi_0_new_b_size + qi_0_new_g_size, qi_0_abs = fabs(qi->x),
      qi_0_new_size = qi_0_new_h_size + qi_0_abs;
  const double qi_1_new_a_size = KSL_MUL(qi_0_new_a_padded, qi_2_abs),
      qi_1_new_b_size = KSL_MUL(qi_0_new_c_padded, qi_0_abs),
      qi_1_new_c_size = qi_1_new_a_size + qi_1_new_b_size,
      qi_1_new_d_size = KSL_MUL(qi_0_new_e_padded, qi_3_abs),
      qi_1_new_e_size = qi_1_new_c_size + qi_1_new_d_size,
      qi_1_new_size = qi_1_new_e_size + qi_1_abs;
  const double qi_2_new_a_size = KSL_MUL(qi_0_new_e_padded, qi_0_abs),
      qi_2_new_b_size = KSL_MUL(qi_0_new_a_padded, qi_1_abs),
      qi_2_new_c_size = qi_2_new_a_size + qi_2_new_b_size,
      qi_2_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_3_abs),
      qi_2_new_e_size = qi_2_new_c_size + qi_2_new_d_size,
      qi_2_new_size = qi_2_new_e_size + qi_2_abs;
  const double qi_3_new_a_size = KSL_MUL(qi_0_new_a_padded, qi_0_abs),
      qi_3_new_b_size = KSL_MUL(qi_0_new_e_padded, qi_1_abs),
      qi_3_new_c_size = qi_3_new_a_size + qi_3_new_b_size,
      qi_3_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_2_abs),
      qi_3_new_e_size = qi_3_new_c_size + qi_3_new_d_size,
      qi_3_new_size = qi_3_abs + qi_3_new_e_size;
  const double qi_0_new_padded = qi_0_new_size + 2.004168360008973e-292,
      qi_0_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_0_new_padded);
  const double qi_1_new_padded = qi_1_new_size + 2.004168360008973e-292,
      qi_1_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_1_new_padded);
  const double qi_2_new_padded = qi_2_new_size + 2.004168360008973e-292,
      qi_2_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_2_new_padded);
  const double qi_3_new_padded = qi_3_new_size + 2.004168360008973e-292,
      qi_3_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_3_new_padded);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_error_bound;
  qi_bound->y = qi_1_new_error_bound;
  qi_bound->z = qi_2_new_error_bound;
  qi_bound->w = qi_3_new_error_bound;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
     qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_subtract_dpiFromq_certified(const ksl_vec3_t *dpi, ksl_quaternion_t *qi,
    ksl_quaternion_t *qi_bound) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->y), qi_0_new_b = KSL_MUL(qi_0_new_a, qi->z),
      qi_0_new_c = KSL_MUL(0.5, dpi->z), qi_0_new_d = KSL_MUL(qi_0_new_c, qi->y),
      qi_0_new_e = qi_0_new_b - qi_0_new_d, qi_0_new_f = KSL_MUL(0.5, dpi->x),
      qi_0_new_g = KSL_MUL(qi_0_new_f, qi->w), qi_0_new_h = qi_0_new_e - qi_0_new_g,
      qi_0_new = qi_0_new_h + qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_c, qi->x), qi_1_new_b = KSL_MUL(qi_0_new_f, qi->z),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_d = KSL_MUL(qi_0_new_a, qi->w),
      qi_1_new_e = qi_1_new_c - qi_1_new_d, qi_1_new = qi_1_new_e + qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_f, qi->y), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->x),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c - qi_2_new_d, qi_2_new = qi_2_new_e + qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_f, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new = qi_3_new_e + qi->w;
  const double qi_0_new_a_abs = fabs(qi_0_new_a),
      qi_0_new_a_padded = qi_0_new_a_abs + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z), qi_0_new_b_size = KSL_MUL(qi_0_new_a_padded, qi_2_abs);
  const double qi_0_new_c_abs = fabs(qi_0_new_c),
      qi_0_new_c_padded = qi_0_new_c_abs + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y), qi_0_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_1_abs),
      qi_0_new_e_size = qi_0_new_b_size + qi_0_new_d_size;
  const double qi_0_new_f_abs = fabs(qi_0_new_f),
      qi_0_new_f_padded = qi_0_new_f_abs + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w), qi_0_new_g_size = KSL_MUL(qi_0_new_f_padded, qi_3_abs),
      qi_0_new_h_size = qi_0_new_e_size + qi_0_new_g_size, qi_0_abs = fabs(qi->x),
      qi_0_new_size = qi_0_new_h_size + qi_0_abs;
  const double qi_1_new_a_size = KSL_MUL(qi_0_new_c_padded, qi_0_abs),
      qi_1_new_b_size = KSL_MUL(qi_0_new_f_padded, qi_2_abs),
      qi_1_new_c_size = qi_1_new_a_size + qi_1_new_b_size,
      qi_1_new_d_size = KSL_MUL(qi_0_new_a_padded, qi_3_abs),
      qi_1_new_e_size = qi_1_new_c_size + qi_1_new_d_size,
      qi_1_new_size = qi_1_new_e_size + qi_1_abs;
  const double qi_2_new_a_size = KSL_MUL(qi_0_new_f_padded, qi_1_abs),
      qi_2_new_b_size = KSL_MUL(qi_0_new_a_padded, qi_0_abs),
      qi_2_new_c_size = qi_2_new_a_size + qi_2_new_b_size,
      qi_2_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_3_abs),
      qi_2_new_e_size = qi_2_new_c_size + qi_2_new_d_size,
      qi_2_new_size = qi_2_new_e_size + qi_2_abs;
  const double qi_3_new_a_size = KSL_MUL(qi_0_new_f_padded, qi_0_abs),
      qi_3_new_b_size = KSL_MUL(qi_0_new_a_padded, qi_1_abs),
      qi_3_new_c_size = qi_3_new_a_size + qi_3_new_b_size,
      qi_3_new_d_size = KSL_MUL(qi_0_new_c_padded, qi_2_abs),
      qi_3_new_e_size = qi_3_new_c_size + qi_3_new_d_size,
      qi_3_new_size = qi_3_new_e_size + qi_3_abs;
  const double qi_0_new_padded = qi_0_new_size + 2.004168360008973e-292,
      qi_0_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_0_new_padded);
  const double qi_1_new_padded = qi_1_new_size + 2.004168360008973e-292,
      qi_1_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_1_new_padded);
  const double qi_2_new_padded = qi_2_new_size + 2.004168360008973e-292,
      qi_2_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_2_new_padded);
  const double qi_3_new_padded = qi_3_new_size + 2.004168360008973e-292,
      qi_3_new_error_bound = KSL_MUL(5.551115123125785e-16, qi_3_new_padded);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_error_bound;
  qi_bound->y = qi_1_new_error_bound;
  qi_bound->z = qi_2_new_error_bound;
  qi_bound->w = qi_3_new_error_bound;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
     unless inf or NaN.
   w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
   43 mul, 40 add, 11 abs. */
static inline void ksl_omega_to_dquaternion_certified(const ksl_vec3_t *w,
    const ksl_quaternion_t *qi, ksl_quaternion_t *dqo, ksl_quaternion_t *dqo_bound) {
  const double dqo_0a = KSL_MUL(0.5, w->x), dqo_0b = KSL_MUL(dqo_0a, qi->w),
      dqo_0c = KSL_MUL(0.5, w->y), dqo_0d = KSL_MUL(dqo_0c, qi->z), dqo_0e = KSL_MUL(0.5, w->z),
      dqo_0f = KSL_MUL(dqo_0e, qi->y), dqo_0g = dqo_0d - dqo_0f, dqo_0h = dqo_0b + dqo_0g,
      dqo_0i = KSL_MUL(qi->x, qi->x), dqo_0j = 1.0 - dqo_0i, dqo_0k = KSL_MUL(qi->y, qi->y),
      dqo_0l = dqo_0j - dqo_0k, dqo_0m = KSL_MUL(qi->z, qi->z), dqo_0n = dqo_0l - dqo_0m,
      dqo_0o = KSL_MUL(qi->w, qi->w), dqo_0p = dqo_0n - dqo_0o, dqo_0q = KSL_MUL(qi->x, dqo_0p),
      dqo_0 = dqo_0h + dqo_0q;
  const double dqo_1a = KSL_MUL(dqo_0e, qi->x), dqo_1b = KSL_MUL(dqo_0a, qi->z),
      dqo_1c = dqo_1a - dqo_1b, dqo_1d = KSL_MUL(dqo_0c, qi->w), dqo_1e = dqo_1c + dqo_1d,
      dqo_1f = KSL_MUL(qi->y, dqo_0p), dqo_1 = dqo_1e + dqo_1f;
  const double dqo_2a = KSL_MUL(dqo_0a, qi->y), dqo_2b = KSL_MUL(dqo_0c, qi->x),
      dqo_2c = dqo_2a - dqo_2b, dqo_2d = KSL_MUL(dqo_0e, qi->w), dqo_2e = dqo_2c + dqo_2d,
      dqo_2f = KSL_MUL(qi->z, dqo_0p), dqo_2 = dqo_2e + dqo_2f;
  const double dqo_3a = KSL_MUL(qi->w, dqo_0p), dqo_3b = KSL_MUL(dqo_0a, qi->x),
      dqo_3c = KSL_MUL(dqo_0c, qi->y), dqo_3d = dqo_3b + dqo_3c, dqo_3e = KSL_MUL(dqo_0e, qi->z),
      dqo_3f = dqo_3d + dqo_3e, dqo_3 = dqo_3a - dqo_3f;
  const double dqo_0a_abs = fabs(dqo_0a), dqo_0a_padded = dqo_0a_abs + 2.004168360008973e-292;
  const double qi_3_abs = fabs(qi->w), dqo_0b_size = KSL_MUL(dqo_0a_padded, qi_3_abs);
  const double dqo_0c_abs = fabs(dqo_0c), dqo_0c_padded = dqo_0c_abs + 2.004168360008973e-292;
  const double qi_2_abs = fabs(qi->z), dqo_0d_size = KSL_MUL(dqo_0c_padded, qi_2_abs);
  const double dqo_0e_abs = fabs(dqo_0e), dqo_0e_padded = dqo_0e_abs + 2.004168360008973e-292;
  const double qi_1_abs = fabs(qi->y), dqo_0f_size = KSL_MUL(dqo_0e_padded, qi_1_abs),
      dqo_0g_size = dqo_0d_size + dqo_0f_size, dqo_0h_size = dqo_0b_size + dqo_0g_size,
      dqo_0i_abs = fabs(dqo_0i), dqo_0j_size = 1.0 + dqo_0i_abs, dqo_0k_abs = fabs(dqo_0k),
      dqo_0l_size = dqo_0j_size + dqo_0k_abs, dqo_0m_abs = fabs(dqo_0m),
      dqo_0n_size = dqo_0l_size + dqo_0m_abs, dqo_0o_abs = fabs(dqo_0o),
      dqo_0p_size = dqo_0n_size + dqo_0o_abs;
  const double dqo_0p_padded = dqo_0p_size + 2.004168360008973e-292;
  const double qi_0_abs = fabs(qi->x), dqo_0q_size = KSL_MUL(qi_0_abs, dqo_0p_padded),
      dqo_0_size = dqo_0h_size + dqo_0q_size;
  const double dqo_1a_size = KSL_MUL(dqo_0e_padded, qi_0_abs),
      dqo_1b_size = KSL_MUL(dqo_0a_padded, qi_2_abs), dqo_1c_size = dqo_1a_size + dqo_1b_size,
      dqo_1d_size = KSL_MUL(dqo_0c_padded, qi_3_abs), dqo_1e_size = dqo_1c_size + dqo_1d_size,
      dqo_1f_size = KSL_MUL(qi_1_abs, dqo_0p_padded), dqo_1_size = dqo_1e_size + dqo_1f_size;
  const double dqo_2a_size = KSL_MUL(dqo_0a_padded, qi_1_abs),
      dqo_2b_size = KSL_MUL(dqo_0c_padded, qi_0_abs), dqo_2c_size = dqo_2a_size + dqo_2b_size,
      dqo_2d_size = KSL_MUL(dqo_0e_padded, qi_3_abs), dqo_2e_size = dqo_2c_size + dqo_2d_size,
      dqo_2f_size = KSL_MUL(qi_2_abs, dqo_0p_padded), dqo_2_size = dqo_2e_size + dqo_2f_size;
  const double dqo_3a_size = KSL_MUL(qi_3_abs, dqo_0p_padded),
      dqo_3b_size = KSL_MUL(dqo_0a_padded, qi_0_abs),
      dqo_3c_size = KSL_MUL(dqo_0c_padded, qi_1_abs), dqo_3d_size = dqo_3b_size + dqo_3c_size,
      dqo_3e_size = KSL_MUL(dqo_0e_padded, qi_2_abs), dqo_3f_size = dqo_3d_size + dqo_3e_size,
      dqo_3_size = dqo_3a_size + dqo_3f_size;
  const double dqo_0_padded = dqo_0_size + 2.004168360008973e-292,
      dqo_0_error_bound = KSL_MUL(7.7715611723761e-16, dqo_0_padded);
  const double dqo_1_padded = dqo_1_size + 2.004168360008973e-292,
      dqo_1_error_bound = KSL_MUL(7.7715611723761e-16, dqo_1_padded);
  const double dqo_2_padded = dqo_2_size + 2.004168360008973e-292,
      dqo_2_error_bound = KSL_MUL(7.7715611723761e-16, dqo_2_padded);
  const double dqo_3_padded = dqo_3_size + 2.004168360008973e-292,
      dqo_3_error_bound = KSL_MUL(7.7715611723761e-16, dqo_3_padded);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
  dqo_bound->x = dqo_0_error_bound;
  dqo_bound->y = dqo_1_error_bound;
  dqo_bound->z = dqo_2_error_bound;
  dqo_bound->w = dqo_3_error_bound;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.
   axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select. */
static inline void ksl_quaternion_from_axis_angle_certified(const ksl_vec3_t *axis,
    const double angle, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double half = KSL_MUL(0.5, angle), half_size_1 = fabs(angle),
      half_size_2 = KSL_MUL(0.5, half_size_1);
  double qo_3; const double sine = ksl_sincos(half, &qo_3);
  double qo_own_error_1; const double sine_own_error_1 = ksl_sincos_error(half, sine, qo_3,
      &qo_own_error_1);
  const double sine_padded_1 = 1.8051943758648296e-276 + half_size_2,
      sine_size_1 = 1.0 + sine_padded_1;
  const double qo_0 = KSL_MUL(axis->x, sine), qo_cross2_1 = KSL_MUL(axis->x, sine_own_error_1),
      qo_size_1 = fabs(axis->x), qo_size_2 = KSL_MUL(qo_size_1, sine_size_1);
  const double qo_1 = KSL_MUL(axis->y, sine), qo_cross2_2 = KSL_MUL(axis->y, sine_own_error_1),
      qo_size_3 = fabs(axis->y), qo_size_4 = KSL_MUL(qo_size_3, sine_size_1);
  const double qo_2 = KSL_MUL(axis->z, sine), qo_cross2_3 = KSL_MUL(axis->z, sine_own_error_1),
      qo_size_5 = fabs(axis->z), qo_size_6 = KSL_MUL(qo_size_5, sine_size_1);
  const double qo_error_1 = ksl_product_error(axis->x, sine, qo_0),
      qo_lo_1 = qo_error_1 + qo_cross2_1, qo_error_2 = fabs(qo_lo_1),
      qo_padded_1 = 1.8051943758648296e-276 + qo_size_2,
      qo_rest_1 = KSL_MUL(4.3017579231195054e-30, qo_padded_1), qo_bound_1 = qo_error_2 + qo_rest_1,
      qo_error_3 = ksl_product_error(axis->y, sine, qo_1), qo_lo_2 = qo_error_3 + qo_cross2_2,
      qo_error_4 = fabs(qo_lo_2), qo_padded_2 = 1.8051943758648296e-276 + qo_size_4,
      qo_rest_2 = KSL_MUL(4.3017579231195054e-30, qo_padded_2), qo_bound_2 = qo_error_4 + qo_rest_2,
      qo_error_5 = ksl_product_error(axis->z, sine, qo_2), qo_lo_3 = qo_error_5 + qo_cross2_3,
      qo_error_6 = fabs(qo_lo_3), qo_padded_3 = 1.8051943758648296e-276 + qo_size_6,
      qo_rest_3 = KSL_MUL(4.3017579231195054e-30, qo_padded_3), qo_bound_3 = qo_error_6 + qo_rest_3,
      qo_error_7 = fabs(qo_own_error_1), qo_rest_4 = KSL_MUL(4.067564442213936e-30, sine_size_1),
      qo_bound_4 = qo_error_7 + qo_rest_4;
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
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_inverse_1 = 1.0 / s,
      scaled_s_size_1 = KSL_MUL(scaled_s_0, scaled_s_inverse_1),
      scaled_s_size_3 = q->x == scaled_s_size_1 ? 0.0 : 5e-324, scaled_s_size_4 = fabs(scaled_s_0);
  const double scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_size_5 = KSL_MUL(scaled_s_1, scaled_s_inverse_1),
      scaled_s_size_7 = q->y == scaled_s_size_5 ? 0.0 : 5e-324, scaled_s_size_8 = fabs(scaled_s_1);
  const double scaled_s_2 = KSL_MUL(q->z, s),
      scaled_s_size_9 = KSL_MUL(scaled_s_2, scaled_s_inverse_1),
      scaled_s_size_11 = q->z == scaled_s_size_9 ? 0.0 : 5e-324,
      scaled_s_size_12 = fabs(scaled_s_2);
  const double scaled_s_3 = KSL_MUL(q->w, s),
      scaled_s_size_13 = KSL_MUL(scaled_s_3, scaled_s_inverse_1),
      scaled_s_size_15 = q->w == scaled_s_size_13 ? 0.0 : 5e-324,
      scaled_s_size_16 = fabs(scaled_s_3);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0,
      upper_size_1 = scaled_s_3 - 0.0, upper_size_2 = fabs(upper_size_1),
      upper_size_3 = 5e-324 + upper_size_2, upper_size_5 = upper_0a - scaled_s_0,
      upper_size_6 = fabs(upper_size_5), upper_padded_1 = 1.8051943758648296e-276 + scaled_s_size_4,
      upper_rest_1 = KSL_MUL(1.1093356479670522e-31, upper_padded_1),
      upper_size_7 = upper_rest_1 + upper_size_6, upper_size_8 = scaled_s_size_3 + upper_size_7,
      upper_size_9 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_8,
      upper_size_10 = KSL_MUL(3.169126500570585e+29, upper_size_9),
      upper_size_11 = scaled_s_size_4 + upper_size_10;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1,
      upper_size_12 = upper_1a - scaled_s_1, upper_size_13 = fabs(upper_size_12),
      upper_padded_2 = 1.8051943758648296e-276 + scaled_s_size_8,
      upper_rest_2 = KSL_MUL(1.1093356479670522e-31, upper_padded_2),
      upper_size_14 = upper_rest_2 + upper_size_13, upper_size_15 = scaled_s_size_7 + upper_size_14,
      upper_size_16 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_15,
      upper_size_17 = KSL_MUL(3.169126500570585e+29, upper_size_16),
      upper_size_18 = scaled_s_size_8 + upper_size_17;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2,
      upper_size_19 = upper_2a - scaled_s_2, upper_size_20 = fabs(upper_size_19),
      upper_padded_3 = 1.8051943758648296e-276 + scaled_s_size_12,
      upper_rest_3 = KSL_MUL(1.1093356479670522e-31, upper_padded_3),
      upper_size_21 = upper_rest_3 + upper_size_20,
      upper_size_22 = scaled_s_size_11 + upper_size_21,
      upper_size_23 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_22,
      upper_size_24 = KSL_MUL(3.169126500570585e+29, upper_size_23),
      upper_size_25 = scaled_s_size_12 + upper_size_24;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3,
      upper_size_26 = upper_3a - scaled_s_3, upper_size_27 = fabs(upper_size_26),
      upper_padded_4 = 1.8051943758648296e-276 + scaled_s_size_16,
      upper_rest_4 = KSL_MUL(1.1093356479670522e-31, upper_padded_4),
      upper_size_28 = upper_rest_4 + upper_size_27,
      upper_size_29 = scaled_s_size_15 + upper_size_28,
      upper_size_30 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_29,
      upper_size_31 = KSL_MUL(3.169126500570585e+29, upper_size_30),
      upper_size_32 = scaled_s_size_16 + upper_size_31;
  const double v_s_size_0 = fabs(upper_0),
      v_s_size_padded_1 = 1.8051943758648296e-276 + upper_size_11;
  const double v_s_size_1 = fabs(upper_1),
      v_s_size_padded_2 = 1.8051943758648296e-276 + upper_size_18;
  const double v_s_size_2 = fabs(upper_2),
      v_s_size_padded_3 = 1.8051943758648296e-276 + upper_size_25;
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s_b_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_size_1 = KSL_MUL(v_s_size_3, v_s_size_padded_1);
  const double v_y_1 = KSL_MUL(upper_1, v_s), v_y_size_2 = KSL_MUL(v_s_size_3, v_s_size_padded_2);
  const double v_y_2 = KSL_MUL(upper_2, v_s), v_y_size_3 = KSL_MUL(v_s_size_3, v_s_size_padded_3);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_a_padded_1 = 1.8051943758648296e-276 + v_y_size_1,
      v_n_a_size_1 = fabs(v_y_0), v_n_a_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_a_padded_1),
      v_n_a_units_1 = KSL_MUL(140737488355328.0, v_n_a_rest_1),
      v_n_a_reach_1 = v_n_a_size_1 + v_n_a_units_1,
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, v_n_a_reach_1),
      v_n_a_size_3 = v_n_a_size_2 + v_n_a_size_2, v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276 + v_y_size_2, v_n_b_size_1 = fabs(v_y_1),
      v_n_b_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_b_padded_1),
      v_n_b_units_1 = KSL_MUL(140737488355328.0, v_n_b_rest_1),
      v_n_b_reach_1 = v_n_b_size_1 + v_n_b_units_1,
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, v_n_b_reach_1),
      v_n_b_size_3 = v_n_b_size_2 + v_n_b_size_2, v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_c_left_1 = v_n_c - v_n_c_right_1,
      v_n_c_left_rest_1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left_1),
      v_n_c_right_rest_1 = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_c_lo = v_n_c_left_rest_1 + v_n_c_right_rest_1, v_n_c_size_1 = v_n_a_size_3 + v_n_b_size_3,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_d_padded_1 = 1.8051943758648296e-276 + v_y_size_3,
      v_n_d_size_1 = fabs(v_y_2), v_n_d_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_d_padded_1),
      v_n_d_units_1 = KSL_MUL(140737488355328.0, v_n_d_rest_1),
      v_n_d_reach_1 = v_n_d_size_1 + v_n_d_units_1,
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, v_n_d_reach_1),
      v_n_d_size_3 = v_n_d_size_2 + v_n_d_size_2, v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c, v_n_e_left_1 = v_n_e - v_n_e_right_1,
      v_n_e_left_rest_1 = v_n_c - v_n_e_left_1,
      v_n_e_right_rest_1 = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_e_lo1_1 = v_n_e_left_rest_1 + v_n_e_right_rest_1, v_n_e_lo = v_n_e_lo1_1 + v_n_c_lo,
      v_n_e_size_1 = v_n_c_size_1 + v_n_d_size_3, v_n = sqrt(v_n_e),
      v_n_product_1 = KSL_MUL(v_n, v_n),
      v_n_product_error_1 = ksl_product_error(v_n, v_n, v_n_product_1),
      v_n_rest_1 = v_n_e - v_n_product_1, v_n_exact_1 = v_n_rest_1 - v_n_product_error_1,
      v_n_residual_1 = v_n_exact_1 + v_n_e_lo, v_n_twice_1 = v_n + v_n,
      v_n_divisor_1 = v_n == 0.0 ? 1.0 : v_n_twice_1, v_n_lo = v_n_residual_1 / v_n_divisor_1,
      v_n_padded_1 = 1.8051943758648296e-276 + v_n_e_size_1, v_n_size_1 = v_n_padded_1 / v_n,
      v_n_size_2 = v_n_size_1 / v_n_e, v_n_size_3 = fabs(v_n_e), v_n_error_1 = fabs(v_n_e_lo),
      v_n_rest_2 = KSL_MUL(7.235336013082471e-30, v_n_padded_1),
      v_n_bound_1 = v_n_error_1 + v_n_rest_2, v_n_units_1 = KSL_MUL(140737488355328.0, v_n_bound_1),
      v_n_reach_1 = v_n_size_3 + v_n_units_1, v_n_size_4 = KSL_MUL(v_n_reach_1, v_n_size_2),
      v_n_size_5 = sqrt(v_n_bound_1), v_n_size_6 = fabs(v_n_lo),
      v_n_size_7 = v_n_size_5 + v_n_size_6,
      v_n_size_8 = KSL_MUL(1.5970396877936164e+29, v_n_size_7),
      v_n_size_9 = KSL_MUL(4.0, v_n_bound_1),
      v_n_size_11 = v_n_size_9 < v_n_e ? v_n_size_4 : v_n_size_8, v_n_size_12 = v_n + v_n_size_11;
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r_b_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b,
      v_r_size_1 = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b_size_1;
  const double n = KSL_MUL(v_n, v_r), n_inverse_1 = 1.0 / v_r, n_back_1 = KSL_MUL(n, n_inverse_1),
      n_lost_1 = v_n - n_back_1, n_rest_1 = n_lost_1 + v_n_lo, n_lo = KSL_MUL(n_rest_1, v_r),
      n_padded_1 = 1.8051943758648296e-276 + v_n_size_12,
      n_size_1 = KSL_MUL(n_padded_1, v_r_size_1);
  const double half = ksl_atan2(n, upper_3), half_own_error_1 = ksl_atan2_error(n, upper_3, half),
      half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1, half_cross1_1 = KSL_MUL(half_part1_1, n_lo),
      half_cross2_1 = KSL_MUL(half_part0_1, 0.0),
      half_square1_1 = KSL_MUL(half_part1_1, half_part1_1),
      half_square2_1 = KSL_MUL(half_part0_1, half_part0_1),
      half_cross_1 = half_cross1_1 - half_cross2_1, half_square_1 = half_square1_1 + half_square2_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, half_square_1),
      half_safe_1 = half_most_1 == 0.0 ? 1.0 : half_divisor2_1,
      half_more_1 = half_cross_1 / half_safe_1, half_lo = half_own_error_1 + half_more_1,
      half_size_1 = fabs(half), half_padded_1 = 1.8051943758648296e-276 + n_size_1,
      half_padded_2 = 1.8051943758648296e-276 + upper_size_32, half_size_2 = fabs(n),
      half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_error_1 = fabs(n_lo), half_rest_1 = KSL_MUL(6.859394487938082e-30, half_padded_1),
      half_bound_1 = half_error_1 + half_rest_1,
      half_rest_2 = KSL_MUL(3.254051621949822e-30, half_padded_2),
      half_size_6 = 1.8051943758648296e-276 + half_bound_1, half_size_7 = half_rest_2 + half_size_6,
      half_size_8 = half_padded_1 + half_padded_2, half_size_9 = half_size_8 / half_size_5,
      half_size_10 = half_size_1 + half_size_9, half_size_11 = half_size_7 / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_14 = fabs(half_lo),
      half_size_15 = 7.0 + half_size_14,
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_20 = half_size_11 < 0.25 ? half_size_19 : half_size_15,
      half_size_21 = KSL_MUL(4.875578158636172e+28, half_size_20),
      half_size_22 = half_size_10 + half_size_21;
  const double divisor = v_n == 0.0 ? 1.0 : v_n, divisor_lo = v_n == 0.0 ? 0.0 : v_n_lo,
      divisor_size_1 = v_n == 0.0 ? 1.0 : v_n_size_12,
      divisor_rest_1 = KSL_MUL(6.606712056056508e-30, n_padded_1),
      divisor_bound_1 = divisor_rest_1 + v_n_size_6, divisor_size_2 = v_n - 0.0,
      divisor_size_3 = fabs(divisor_size_2), divisor_size_5 = 1.0 - v_n,
      divisor_size_6 = fabs(divisor_size_5), divisor_size_7 = divisor_bound_1 + divisor_size_6,
      divisor_size_8 = divisor_bound_1 < divisor_size_3 ? 0.0 : divisor_size_7,
      divisor_size_9 = KSL_MUL(9.054644677292507e+28, divisor_size_8),
      divisor_size_10 = divisor_size_1 + divisor_size_9;
  const double unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MUL(unit_0, divisor),
      unit_product_error_1 = ksl_product_error(unit_0, divisor, unit_product_1),
      unit_rest_1 = v_y_0 - unit_product_1, unit_exact_1 = unit_rest_1 - unit_product_error_1,
      unit_cross_1 = KSL_MUL(unit_0, divisor_lo), unit_residual_1 = unit_exact_1 - unit_cross_1,
      unit_lo_1 = unit_residual_1 / divisor,
      unit_padded_1 = 1.8051943758648296e-276 + divisor_size_10, unit_size_1 = fabs(unit_0),
      unit_size_2 = fabs(divisor), unit_size_3 = KSL_MUL(unit_padded_1, unit_size_1),
      unit_size_4 = unit_size_3 + v_n_a_padded_1, unit_error_1 = fabs(divisor_lo),
      unit_rest_2 = KSL_MUL(1.1389183198259759e-29, unit_padded_1),
      unit_bound_1 = unit_error_1 + unit_rest_2, unit_size_5 = KSL_MUL(4.0, unit_bound_1),
      unit_size_7 = unit_size_5 < unit_size_2 ? unit_size_2 : 0.0,
      unit_size_8 = unit_size_4 / unit_size_7,
      unit_units_1 = KSL_MUL(140737488355328.0, unit_bound_1),
      unit_reach_1 = unit_size_2 + unit_units_1, unit_size_9 = KSL_MUL(unit_reach_1, unit_size_8),
      unit_size_10 = unit_size_9 / unit_size_2, unit_size_11 = unit_size_1 + unit_size_10;
  const double unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MUL(unit_1, divisor),
      unit_product_error_2 = ksl_product_error(unit_1, divisor, unit_product_2),
      unit_rest_3 = v_y_1 - unit_product_2, unit_exact_2 = unit_rest_3 - unit_product_error_2,
      unit_cross_2 = KSL_MUL(unit_1, divisor_lo), unit_residual_2 = unit_exact_2 - unit_cross_2,
      unit_lo_2 = unit_residual_2 / divisor, unit_size_12 = fabs(unit_1),
      unit_size_13 = KSL_MUL(unit_padded_1, unit_size_12),
      unit_size_14 = unit_size_13 + v_n_b_padded_1, unit_size_15 = unit_size_14 / unit_size_7,
      unit_size_16 = KSL_MUL(unit_reach_1, unit_size_15), unit_size_17 = unit_size_16 / unit_size_2,
      unit_size_18 = unit_size_12 + unit_size_17;
  const double unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MUL(unit_2, divisor),
      unit_product_error_3 = ksl_product_error(unit_2, divisor, unit_product_3),
      unit_rest_4 = v_y_2 - unit_product_3, unit_exact_3 = unit_rest_4 - unit_product_error_3,
      unit_cross_3 = KSL_MUL(unit_2, divisor_lo), unit_residual_3 = unit_exact_3 - unit_cross_3,
      unit_lo_3 = unit_residual_3 / divisor, unit_size_19 = fabs(unit_2),
      unit_size_20 = KSL_MUL(unit_padded_1, unit_size_19),
      unit_size_21 = unit_size_20 + v_n_d_padded_1, unit_size_22 = unit_size_21 / unit_size_7,
      unit_size_23 = KSL_MUL(unit_reach_1, unit_size_22), unit_size_24 = unit_size_23 / unit_size_2,
      unit_size_25 = unit_size_19 + unit_size_24;
  const double angle = KSL_MUL(2.0, half), angle_cross2_1 = KSL_MUL(2.0, half_lo),
      angle_size_1 = KSL_MUL(2.0, half_size_22);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0, axis_lo_1 = v_n == 0.0 ? 0.0 : unit_lo_1,
      axis_size_1 = v_n == 0.0 ? 1.0 : unit_size_11, axis_size_2 = 1.0 - unit_0,
      axis_size_3 = fabs(axis_size_2), axis_error_1 = fabs(unit_lo_1),
      axis_padded_1 = 1.8051943758648296e-276 + unit_size_11,
      axis_rest_1 = KSL_MUL(1.6442825652790928e-29, axis_padded_1),
      axis_bound_1 = axis_error_1 + axis_rest_1, axis_size_4 = axis_bound_1 + axis_size_3,
      axis_size_5 = divisor_bound_1 < divisor_size_3 ? 0.0 : axis_size_4,
      axis_size_6 = KSL_MUL(6.250354999637554e+28, axis_size_5),
      axis_size_7 = axis_size_1 + axis_size_6;
  const double angle_error_1 = fabs(angle_cross2_1),
      angle_padded_1 = 1.8051943758648296e-276 + angle_size_1,
      angle_rest_1 = KSL_MUL(2.1514956353001486e-29, angle_padded_1),
      angle_bound_1 = angle_error_1 + angle_rest_1, axis_error_2 = fabs(axis_lo_1),
      axis_padded_2 = 1.8051943758648296e-276 + axis_size_7,
      axis_rest_2 = KSL_MUL(1.644282720444347e-29, axis_padded_2),
      axis_bound_2 = axis_error_2 + axis_rest_2, unit_error_2 = fabs(unit_lo_2),
      unit_padded_2 = 1.8051943758648296e-276 + unit_size_18,
      unit_rest_5 = KSL_MUL(1.6442825652790928e-29, unit_padded_2),
      unit_bound_2 = unit_error_2 + unit_rest_5, unit_error_3 = fabs(unit_lo_3),
      unit_padded_3 = 1.8051943758648296e-276 + unit_size_25,
      unit_rest_6 = KSL_MUL(1.6442825652790928e-29, unit_padded_3),
      unit_bound_3 = unit_error_3 + unit_rest_6;
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
  const double size_0 = fabs(h_0);
  const double size_1 = fabs(h_1);
  const double size_2 = fabs(h_2);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = h_0 + grid;
  const double shifted_1 = h_1 + grid;
  const double shifted_2 = h_2 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = h_0 - high_0;
  const double low_1 = h_1 - high_1;
  const double low_2 = h_2 - high_2;
  const double sum_0 = h_0 + high_0;
  const double sum_1 = h_1 + high_1;
  const double sum_2 = h_2 + high_2;
  const double squares_a = KSL_MUL(high_0, high_0), squares_b = KSL_MUL(high_1, high_1),
      squares_c = squares_a + squares_b, squares_d = KSL_MUL(high_2, high_2),
      squares = squares_c + squares_d;
  const double cross_a = KSL_MUL(low_0, sum_0), cross_b = KSL_MUL(low_1, sum_1),
      cross_c = cross_a + cross_b, cross_d = KSL_MUL(low_2, sum_2), cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = KSL_MUL(theta_low, theta_sum), cross_rest = cross - cross_rest_a;
  const double exact_a = KSL_MUL(theta_high, theta_high), exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = KSL_MUL(0.5, residual), small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = KSL_MUL(delta, far_cosine), sine = sine_a + far_sine;
  const double cosine_a = KSL_MUL(delta, far_sine), cosine = far_cosine - cosine_a;
  const double far_k = sine / theta;
  const double k_a = KSL_MUL(6.446950284384474e-26, x), k_b = k_a - 3.868170170630684e-23,
      k_c = KSL_MUL(x, k_b), k_d = k_c + 1.9572941063391263e-20, k_e = KSL_MUL(x, k_d),
      k_f = k_e - 8.22063524662433e-18, k_g = KSL_MUL(x, k_f), k_h = k_g + 2.8114572543455206e-15,
      k_i = KSL_MUL(x, k_h), k_j = k_i - 7.647163731819816e-13, k_k = KSL_MUL(x, k_j),
      k_l = k_k + 1.6059043836821613e-10, k_m = KSL_MUL(x, k_l), k_n = k_m - 2.505210838544172e-08,
      k_o = KSL_MUL(x, k_n), k_p = k_o + 2.7557319223985893e-06, k_q = KSL_MUL(x, k_p),
      k_r = k_q - 0.0001984126984126984, k_s = KSL_MUL(x, k_r), k_t = k_s + 0.008333333333333333,
      k_u = KSL_MUL(x, k_t), k_v = k_u - 0.16666666666666666, k_w = KSL_MUL(x, k_v),
      k_x = k_w + 1.0, k = x < 1.0 ? k_x : far_k;
  const double g2a = KSL_MUL(2.4795962632247976e-27, x), g2b = g2a - 1.6117375710961184e-24,
      g2c = KSL_MUL(x, g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_MUL(x, g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_MUL(x, g2f), g2h = g2g + 1.5619206968586225e-16,
      g2i = KSL_MUL(x, g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_MUL(x, g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_MUL(x, g2l), g2n = g2m - 2.08767569878681e-09,
      g2o = KSL_MUL(x, g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_MUL(x, g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_MUL(x, g2r), g2t = g2s + 0.001388888888888889,
      g2u = KSL_MUL(x, g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_MUL(x, g2v),
      g2 = g2w + 0.5;
  const double near_a = KSL_MUL(x, g2), near = 1.0 - near_a;
  const double qo_0 = KSL_MUL(h_0, k);
  const double qo_1 = KSL_MUL(h_1, k);
  const double qo_2 = KSL_MUL(h_2, k);
  const double qo_3 = x < 1.0 ? near : cosine;
  const double fine_h_0 = KSL_MUL(0.5, v->x), fine_h_size_3 = fabs(v->x),
      fine_h_size_4 = KSL_MUL(0.5, fine_h_size_3);
  const double fine_h_1 = KSL_MUL(0.5, v->y), fine_h_size_5 = fabs(v->y),
      fine_h_size_6 = KSL_MUL(0.5, fine_h_size_5);
  const double fine_h_2 = KSL_MUL(0.5, v->z), fine_h_size_7 = fabs(v->z),
      fine_h_size_8 = KSL_MUL(0.5, fine_h_size_7);
  const double fine_h_size_0 = fabs(fine_h_0),
      fine_h_size_padded_1 = 1.8051943758648296e-276 + fine_h_size_4,
      fine_h_size_rest_1 = KSL_MUL(1.2325953113446296e-31, fine_h_size_padded_1);
  const double fine_h_size_1 = fabs(fine_h_1),
      fine_h_size_padded_2 = 1.8051943758648296e-276 + fine_h_size_6,
      fine_h_size_rest_2 = KSL_MUL(1.2325953113446296e-31, fine_h_size_padded_2);
  const double fine_h_size_2 = fabs(fine_h_2),
      fine_h_size_padded_3 = 1.8051943758648296e-276 + fine_h_size_8,
      fine_h_size_rest_3 = KSL_MUL(1.2325953113446296e-31, fine_h_size_padded_3);
  const double fine_h_largest1 = fine_h_size_0 < fine_h_size_1 ? fine_h_size_1 : fine_h_size_0;
  const double fine_h_largest2 = fine_h_largest1 < fine_h_size_2 ? fine_h_size_2 : fine_h_largest1;
  const double fine_s = 6.703903964971299e+153 < fine_h_largest2 ? 3.7291703656001034e-155 : 1.0,
      fine_s_size_1 = 6.703903964971299e+153 < fine_h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double fine_reduced_0 = KSL_MUL(fine_h_0, fine_s),
      fine_reduced_size_1 = KSL_MUL(fine_h_size_padded_1, fine_s_size_1);
  const double fine_reduced_1 = KSL_MUL(fine_h_1, fine_s),
      fine_reduced_size_2 = KSL_MUL(fine_h_size_padded_2, fine_s_size_1);
  const double fine_reduced_2 = KSL_MUL(fine_h_2, fine_s),
      fine_reduced_size_3 = KSL_MUL(fine_h_size_padded_3, fine_s_size_1);
  const double fine_up = fine_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      fine_up_size_1 = fine_s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double fine_reduced_length_a = KSL_MUL(fine_reduced_0, fine_reduced_0),
      fine_reduced_length_a_padded_1 = 1.8051943758648296e-276 + fine_reduced_size_1,
      fine_reduced_length_a_size_1 = KSL_MUL(fine_reduced_length_a_padded_1,
          fine_reduced_length_a_padded_1),
      fine_reduced_length_b = KSL_MUL(fine_reduced_1, fine_reduced_1),
      fine_reduced_length_b_padded_1 = 1.8051943758648296e-276 + fine_reduced_size_2,
      fine_reduced_length_b_size_1 = KSL_MUL(fine_reduced_length_b_padded_1,
          fine_reduced_length_b_padded_1),
      fine_reduced_length_c = fine_reduced_length_a + fine_reduced_length_b,
      fine_reduced_length_c_right_1 = fine_reduced_length_c - fine_reduced_length_a,
      fine_reduced_length_c_left_1 = fine_reduced_length_c - fine_reduced_length_c_right_1,
      fine_reduced_length_c_left_rest_1 = ksl_product_rest(fine_reduced_0, fine_reduced_0,
          fine_reduced_length_a, fine_reduced_length_c_left_1),
      fine_reduced_length_c_right_rest_1 = ksl_product_rest(fine_reduced_1, fine_reduced_1,
          fine_reduced_length_b, fine_reduced_length_c_right_1),
      fine_reduced_length_c_lo = fine_reduced_length_c_left_rest_1 +
          fine_reduced_length_c_right_rest_1,
      fine_reduced_length_c_size_1 = fine_reduced_length_a_size_1 + fine_reduced_length_b_size_1,
      fine_reduced_length_d = KSL_MUL(fine_reduced_2, fine_reduced_2),
      fine_reduced_length_d_padded_1 = 1.8051943758648296e-276 + fine_reduced_size_3,
      fine_reduced_length_d_size_1 = KSL_MUL(fine_reduced_length_d_padded_1,
          fine_reduced_length_d_padded_1),
      fine_reduced_length_e = fine_reduced_length_c + fine_reduced_length_d,
      fine_reduced_length_e_right_1 = fine_reduced_length_e - fine_reduced_length_c,
      fine_reduced_length_e_left_1 = fine_reduced_length_e - fine_reduced_length_e_right_1,
      fine_reduced_length_e_left_rest_1 = fine_reduced_length_c - fine_reduced_length_e_left_1,
      fine_reduced_length_e_right_rest_1 = ksl_product_rest(fine_reduced_2, fine_reduced_2,
          fine_reduced_length_d, fine_reduced_length_e_right_1),
      fine_reduced_length_e_lo1_1 = fine_reduced_length_e_left_rest_1 +
          fine_reduced_length_e_right_rest_1,
      fine_reduced_length_e_lo = fine_reduced_length_e_lo1_1 + fine_reduced_length_c_lo,
      fine_reduced_length_e_size_1 = fine_reduced_length_c_size_1 + fine_reduced_length_d_size_1,
      fine_reduced_length = sqrt(fine_reduced_length_e),
      fine_reduced_length_product_1 = KSL_MUL(fine_reduced_length, fine_reduced_length),
      fine_reduced_length_product_error_1 = ksl_product_error(fine_reduced_length,
          fine_reduced_length, fine_reduced_length_product_1),
      fine_reduced_length_rest_1 = fine_reduced_length_e - fine_reduced_length_product_1,
      fine_reduced_length_exact_1 = fine_reduced_length_rest_1 -
          fine_reduced_length_product_error_1,
      fine_reduced_length_residual_1 = fine_reduced_length_exact_1 + fine_reduced_length_e_lo,
      fine_reduced_length_twice_1 = fine_reduced_length + fine_reduced_length,
      fine_reduced_length_divisor_1 = fine_reduced_length == 0.0 ? 1.0 :
          fine_reduced_length_twice_1,
      fine_reduced_length_lo = fine_reduced_length_residual_1 / fine_reduced_length_divisor_1,
      fine_reduced_length_padded_1 = 1.8051943758648296e-276 + fine_reduced_length_e_size_1,
      fine_reduced_length_size_1 = fine_reduced_length_padded_1 / fine_reduced_length,
      fine_reduced_length_size_2 = fine_reduced_length_size_1 / fine_reduced_length_e,
      fine_reduced_length_size_3 = fabs(fine_reduced_length_e),
      fine_reduced_length_error_1 = fabs(fine_reduced_length_e_lo),
      fine_reduced_length_rest_2 = KSL_MUL(3.229399894985818e-30, fine_reduced_length_padded_1),
      fine_reduced_length_bound_1 = fine_reduced_length_error_1 + fine_reduced_length_rest_2,
      fine_reduced_length_units_1 = KSL_MUL(140737488355328.0, fine_reduced_length_bound_1),
      fine_reduced_length_reach_1 = fine_reduced_length_size_3 + fine_reduced_length_units_1,
      fine_reduced_length_size_4 = KSL_MUL(fine_reduced_length_reach_1, fine_reduced_length_size_2),
      fine_reduced_length_size_5 = sqrt(fine_reduced_length_bound_1),
      fine_reduced_length_size_6 = fabs(fine_reduced_length_lo),
      fine_reduced_length_size_7 = fine_reduced_length_size_5 + fine_reduced_length_size_6,
      fine_reduced_length_size_8 = KSL_MUL(2.0056767005853705e+29, fine_reduced_length_size_7),
      fine_reduced_length_size_9 = KSL_MUL(4.0, fine_reduced_length_bound_1),
      fine_reduced_length_size_11 = fine_reduced_length_size_9 < fine_reduced_length_e ?
          fine_reduced_length_size_4 : fine_reduced_length_size_8,
      fine_reduced_length_size_12 = fine_reduced_length + fine_reduced_length_size_11;
  const double fine_half_angle = KSL_MUL(fine_reduced_length, fine_up),
      fine_half_angle_inverse_1 = 1.0 / fine_up,
      fine_half_angle_back_1 = KSL_MUL(fine_half_angle, fine_half_angle_inverse_1),
      fine_half_angle_lost_1 = fine_reduced_length - fine_half_angle_back_1,
      fine_half_angle_rest_1 = fine_half_angle_lost_1 + fine_reduced_length_lo,
      fine_half_angle_lo = KSL_MUL(fine_half_angle_rest_1, fine_up),
      fine_half_angle_padded_1 = 1.8051943758648296e-276 + fine_reduced_length_size_12,
      fine_half_angle_size_1 = KSL_MUL(fine_half_angle_padded_1, fine_up_size_1);
  const double fine_y = KSL_MUL(fine_half_angle, fine_half_angle),
      fine_y_cross1_1 = KSL_MUL(fine_half_angle_lo, fine_half_angle),
      fine_y_cross2_1 = KSL_MUL(fine_half_angle, fine_half_angle_lo),
      fine_y_cross_1 = fine_y_cross1_1 + fine_y_cross2_1,
      fine_y_padded_1 = 1.8051943758648296e-276 + fine_half_angle_size_1,
      fine_y_size_1 = fabs(fine_half_angle), fine_y_error_1 = fabs(fine_half_angle_lo),
      fine_y_rest_1 = KSL_MUL(5.7192432555642225e-30, fine_y_padded_1),
      fine_y_bound_1 = fine_y_error_1 + fine_y_rest_1,
      fine_y_units_1 = KSL_MUL(140737488355328.0, fine_y_bound_1),
      fine_y_reach_1 = fine_y_size_1 + fine_y_units_1,
      fine_y_size_2 = KSL_MUL(fine_y_padded_1, fine_y_reach_1),
      fine_y_size_3 = fine_y_size_2 + fine_y_size_2;
  double fine_c; const double fine_sine = ksl_sincos(fine_half_angle, &fine_c);
  double fine_c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(fine_half_angle,
      fine_sine, fine_c, &fine_c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(fine_half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_slope1_1 = KSL_MUL(fine_sine_half_cos_1, fine_c),
      fine_sine_slope2_1 = KSL_MUL(fine_sine_half_sin_1, fine_sine),
      fine_sine_slope_1 = fine_sine_slope1_1 - fine_sine_slope2_1,
      fine_sine_more_1 = KSL_MUL(fine_sine_slope_1, fine_sine_twice_1),
      fine_sine_lo = fine_sine_own_error_1 + fine_sine_more_1,
      fine_sine_size_1 = 1.0 + fine_y_padded_1;
  const double fine_c_slope1_1 = KSL_MUL(fine_sine_half_cos_1, fine_sine),
      fine_c_slope2_1 = KSL_MUL(fine_sine_half_sin_1, fine_c),
      fine_c_slope_1 = fine_c_slope1_1 + fine_c_slope2_1,
      fine_c_more_1 = KSL_MUL(fine_c_slope_1, fine_sine_twice_1),
      fine_c_lo = fine_c_own_error_1 - fine_c_more_1;
  const double fine_sinc_divisor = fine_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
      : fine_half_angle,
      fine_sinc_divisor_lo = fine_half_angle < 1.4901161193847656e-08 ? 0.0 : fine_half_angle_lo,
      fine_sinc_divisor_size_1 = fine_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
          fine_half_angle_size_1,
      fine_sinc_divisor_size_2 = fine_half_angle - 1.4901161193847656e-08,
      fine_sinc_divisor_size_3 = fabs(fine_sinc_divisor_size_2),
      fine_sinc_divisor_size_4 = 5e-324 + fine_sinc_divisor_size_3,
      fine_sinc_divisor_size_6 = 1.4901161193847656e-08 - fine_half_angle,
      fine_sinc_divisor_size_7 = fabs(fine_sinc_divisor_size_6),
      fine_sinc_divisor_size_8 = fine_sinc_divisor_size_7 + fine_y_bound_1,
      fine_sinc_divisor_size_9 = fine_y_bound_1 < fine_sinc_divisor_size_4 ? 0.0 :
          fine_sinc_divisor_size_8,
      fine_sinc_divisor_size_10 = KSL_MUL(5.762046184631807e+28, fine_sinc_divisor_size_9),
      fine_sinc_divisor_size_11 = fine_sinc_divisor_size_1 + fine_sinc_divisor_size_10;
  const double fine_sinc_quotient = fine_sine / fine_sinc_divisor,
      fine_sinc_quotient_product_1 = KSL_MUL(fine_sinc_quotient, fine_sinc_divisor),
      fine_sinc_quotient_product_error_1 = ksl_product_error(fine_sinc_quotient, fine_sinc_divisor,
          fine_sinc_quotient_product_1),
      fine_sinc_quotient_rest_1 = fine_sine - fine_sinc_quotient_product_1,
      fine_sinc_quotient_exact_1 = fine_sinc_quotient_rest_1 - fine_sinc_quotient_product_error_1,
      fine_sinc_quotient_numerator_1 = fine_sinc_quotient_exact_1 + fine_sine_lo,
      fine_sinc_quotient_cross_1 = KSL_MUL(fine_sinc_quotient, fine_sinc_divisor_lo),
      fine_sinc_quotient_residual_1 = fine_sinc_quotient_numerator_1 - fine_sinc_quotient_cross_1,
      fine_sinc_quotient_lo = fine_sinc_quotient_residual_1 / fine_sinc_divisor,
      fine_sinc_quotient_padded_1 = 1.8051943758648296e-276 + fine_sine_size_1,
      fine_sinc_quotient_padded_2 = 1.8051943758648296e-276 + fine_sinc_divisor_size_11,
      fine_sinc_quotient_size_1 = fabs(fine_sinc_quotient),
      fine_sinc_quotient_size_2 = fabs(fine_sinc_divisor),
      fine_sinc_quotient_size_3 = KSL_MUL(fine_sinc_quotient_padded_2, fine_sinc_quotient_size_1),
      fine_sinc_quotient_size_4 = fine_sinc_quotient_padded_1 + fine_sinc_quotient_size_3,
      fine_sinc_quotient_error_1 = fabs(fine_sinc_divisor_lo),
      fine_sinc_quotient_rest_2 = KSL_MUL(1.789728954546449e-29, fine_sinc_quotient_padded_2),
      fine_sinc_quotient_bound_1 = fine_sinc_quotient_error_1 + fine_sinc_quotient_rest_2,
      fine_sinc_quotient_size_5 = KSL_MUL(4.0, fine_sinc_quotient_bound_1),
      fine_sinc_quotient_size_7 = fine_sinc_quotient_size_5 < fine_sinc_quotient_size_2 ?
          fine_sinc_quotient_size_2 : 0.0,
      fine_sinc_quotient_size_8 = fine_sinc_quotient_size_4 / fine_sinc_quotient_size_7,
      fine_sinc_quotient_units_1 = KSL_MUL(140737488355328.0, fine_sinc_quotient_bound_1),
      fine_sinc_quotient_reach_1 = fine_sinc_quotient_size_2 + fine_sinc_quotient_units_1,
      fine_sinc_quotient_size_9 = KSL_MUL(fine_sinc_quotient_reach_1, fine_sinc_quotient_size_8),
      fine_sinc_quotient_size_10 = fine_sinc_quotient_size_9 / fine_sinc_quotient_size_2,
      fine_sinc_quotient_size_11 = fine_sinc_quotient_size_1 + fine_sinc_quotient_size_10;
  const double fine_y_error_2 = ksl_product_error(fine_half_angle, fine_half_angle, fine_y),
      fine_y_lo = fine_y_error_2 + fine_y_cross_1,
      fine_sinc_a = KSL_MUL(0.16666666666666666, fine_y),
      fine_sinc_a_cross1_1 = KSL_MUL(9.25185853854297e-18, fine_y),
      fine_sinc_a_cross2_1 = KSL_MUL(0.16666666666666666, fine_y_lo),
      fine_sinc_a_cross_1 = fine_sinc_a_cross1_1 + fine_sinc_a_cross2_1,
      fine_sinc_a_size_1 = KSL_MUL(2290649224.7000003, fine_y_size_3),
      fine_sinc_b = 1.0 - fine_sinc_a, fine_sinc_b_right_1 = 1.0 - fine_sinc_b,
      fine_sinc_b_left_1 = fine_sinc_b + fine_sinc_b_right_1,
      fine_sinc_b_left_rest_1 = 1.0 - fine_sinc_b_left_1,
      fine_sinc_b_right_rest_1 = ksl_product_rest(0.16666666666666666, fine_y, fine_sinc_a,
          fine_sinc_b_right_1),
      fine_sinc_b_lo1_1 = fine_sinc_b_left_rest_1 - fine_sinc_b_right_rest_1,
      fine_sinc_b_lo = fine_sinc_b_lo1_1 - fine_sinc_a_cross_1,
      fine_sinc_b_size_1 = 1.0 + fine_sinc_a_size_1,
      fine_sinc = fine_half_angle < 1.4901161193847656e-08 ? fine_sinc_b : fine_sinc_quotient,
      fine_sinc_lo = fine_half_angle < 1.4901161193847656e-08 ? fine_sinc_b_lo :
          fine_sinc_quotient_lo,
      fine_sinc_size_1 = fine_half_angle < 1.4901161193847656e-08 ? fine_sinc_b_size_1 :
          fine_sinc_quotient_size_11,
      fine_sinc_size_2 = fine_sinc_b - fine_sinc_quotient,
      fine_sinc_size_3 = fabs(fine_sinc_size_2), fine_sinc_error_1 = fabs(fine_sinc_b_lo),
      fine_sinc_padded_1 = 1.8051943758648296e-276 + fine_sinc_b_size_1,
      fine_sinc_rest_1 = KSL_MUL(8.201505264386605e-28, fine_sinc_padded_1),
      fine_sinc_bound_1 = fine_sinc_error_1 + fine_sinc_rest_1,
      fine_sinc_error_2 = fabs(fine_sinc_quotient_lo),
      fine_sinc_padded_2 = 1.8051943758648296e-276 + fine_sinc_quotient_size_11,
      fine_sinc_rest_2 = KSL_MUL(2.755262189115544e-29, fine_sinc_padded_2),
      fine_sinc_bound_2 = fine_sinc_error_2 + fine_sinc_rest_2,
      fine_sinc_size_4 = fine_sinc_bound_1 + fine_sinc_size_3,
      fine_sinc_size_5 = fine_sinc_bound_2 + fine_sinc_size_4,
      fine_sinc_size_6 = fine_y_bound_1 < fine_sinc_divisor_size_4 ? 0.0 : fine_sinc_size_5,
      fine_sinc_size_7 = KSL_MUL(1.2206826306780646e+27, fine_sinc_size_6),
      fine_sinc_size_8 = fine_sinc_size_1 + fine_sinc_size_7;
  const double fine_qo_0 = KSL_MUL(fine_h_0, fine_sinc),
      fine_qo_cross2_1 = KSL_MUL(fine_h_0, fine_sinc_lo),
      fine_qo_padded_1 = 1.8051943758648296e-276 + fine_sinc_size_8,
      fine_qo_size_1 = fabs(fine_h_0),
      fine_qo_units_1 = KSL_MUL(140737488355328.0, fine_h_size_rest_1),
      fine_qo_reach_1 = fine_qo_size_1 + fine_qo_units_1,
      fine_qo_size_2 = KSL_MUL(fine_qo_padded_1, fine_qo_reach_1), fine_qo_size_3 = fabs(fine_sinc),
      fine_qo_error_1 = fabs(fine_sinc_lo),
      fine_qo_rest_1 = KSL_MUL(8.201506228291972e-28, fine_qo_padded_1),
      fine_qo_bound_1 = fine_qo_error_1 + fine_qo_rest_1,
      fine_qo_units_2 = KSL_MUL(140737488355328.0, fine_qo_bound_1),
      fine_qo_reach_2 = fine_qo_size_3 + fine_qo_units_2,
      fine_qo_size_4 = KSL_MUL(fine_h_size_padded_1, fine_qo_reach_2),
      fine_qo_size_5 = fine_qo_size_2 + fine_qo_size_4;
  const double fine_qo_1 = KSL_MUL(fine_h_1, fine_sinc),
      fine_qo_cross2_2 = KSL_MUL(fine_h_1, fine_sinc_lo), fine_qo_size_6 = fabs(fine_h_1),
      fine_qo_units_3 = KSL_MUL(140737488355328.0, fine_h_size_rest_2),
      fine_qo_reach_3 = fine_qo_size_6 + fine_qo_units_3,
      fine_qo_size_7 = KSL_MUL(fine_qo_padded_1, fine_qo_reach_3),
      fine_qo_size_8 = KSL_MUL(fine_h_size_padded_2, fine_qo_reach_2),
      fine_qo_size_9 = fine_qo_size_7 + fine_qo_size_8;
  const double fine_qo_2 = KSL_MUL(fine_h_2, fine_sinc),
      fine_qo_cross2_3 = KSL_MUL(fine_h_2, fine_sinc_lo), fine_qo_size_10 = fabs(fine_h_2),
      fine_qo_units_4 = KSL_MUL(140737488355328.0, fine_h_size_rest_3),
      fine_qo_reach_4 = fine_qo_size_10 + fine_qo_units_4,
      fine_qo_size_11 = KSL_MUL(fine_qo_padded_1, fine_qo_reach_4),
      fine_qo_size_12 = KSL_MUL(fine_h_size_padded_3, fine_qo_reach_2),
      fine_qo_size_13 = fine_qo_size_11 + fine_qo_size_12;
  const double fine_qo_error_2 = ksl_product_error(fine_h_0, fine_sinc, fine_qo_0),
      fine_qo_lo_1 = fine_qo_error_2 + fine_qo_cross2_1, qo_apart_1 = fine_qo_0 - qo_0,
      qo_apart_2 = fine_qo_lo_1 + qo_apart_1, qo_error_1 = fabs(qo_apart_2),
      qo_error_2 = KSL_MUL(1.0000000000000009, qo_error_1),
      qo_padded_1 = 1.8051943758648296e-276 + fine_qo_size_5,
      qo_rest_1 = KSL_MUL(8.21414129263252e-28, qo_padded_1), qo_bound_1 = qo_error_2 + qo_rest_1,
      fine_qo_error_3 = ksl_product_error(fine_h_1, fine_sinc, fine_qo_1),
      fine_qo_lo_2 = fine_qo_error_3 + fine_qo_cross2_2, qo_apart_3 = fine_qo_1 - qo_1,
      qo_apart_4 = fine_qo_lo_2 + qo_apart_3, qo_error_3 = fabs(qo_apart_4),
      qo_error_4 = KSL_MUL(1.0000000000000009, qo_error_3),
      qo_padded_2 = 1.8051943758648296e-276 + fine_qo_size_9,
      qo_rest_2 = KSL_MUL(8.21414129263252e-28, qo_padded_2), qo_bound_2 = qo_error_4 + qo_rest_2,
      fine_qo_error_4 = ksl_product_error(fine_h_2, fine_sinc, fine_qo_2),
      fine_qo_lo_3 = fine_qo_error_4 + fine_qo_cross2_3, qo_apart_5 = fine_qo_2 - qo_2,
      qo_apart_6 = fine_qo_lo_3 + qo_apart_5, qo_error_5 = fabs(qo_apart_6),
      qo_error_6 = KSL_MUL(1.0000000000000009, qo_error_5),
      qo_padded_3 = 1.8051943758648296e-276 + fine_qo_size_13,
      qo_rest_3 = KSL_MUL(8.21414129263252e-28, qo_padded_3), qo_bound_3 = qo_error_6 + qo_rest_3,
      qo_apart_7 = fine_c - qo_3, qo_apart_8 = fine_c_lo + qo_apart_7,
      qo_error_7 = fabs(qo_apart_8), qo_error_8 = KSL_MUL(1.0000000000000009, qo_error_7),
      qo_rest_4 = KSL_MUL(1.0551017099379097e-29, fine_sinc_quotient_padded_1),
      qo_bound_4 = qo_error_8 + qo_rest_4;
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
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_inverse_1 = 1.0 / s,
      scaled_s_size_1 = KSL_MUL(scaled_s_0, scaled_s_inverse_1),
      scaled_s_size_3 = q->x == scaled_s_size_1 ? 0.0 : 5e-324, scaled_s_size_4 = fabs(scaled_s_0);
  const double scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_size_5 = KSL_MUL(scaled_s_1, scaled_s_inverse_1),
      scaled_s_size_7 = q->y == scaled_s_size_5 ? 0.0 : 5e-324, scaled_s_size_8 = fabs(scaled_s_1);
  const double scaled_s_2 = KSL_MUL(q->z, s),
      scaled_s_size_9 = KSL_MUL(scaled_s_2, scaled_s_inverse_1),
      scaled_s_size_11 = q->z == scaled_s_size_9 ? 0.0 : 5e-324,
      scaled_s_size_12 = fabs(scaled_s_2);
  const double scaled_s_3 = KSL_MUL(q->w, s),
      scaled_s_size_13 = KSL_MUL(scaled_s_3, scaled_s_inverse_1),
      scaled_s_size_15 = q->w == scaled_s_size_13 ? 0.0 : 5e-324,
      scaled_s_size_16 = fabs(scaled_s_3);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0,
      upper_size_1 = scaled_s_3 - 0.0, upper_size_2 = fabs(upper_size_1),
      upper_size_3 = 5e-324 + upper_size_2, upper_size_5 = upper_0a - scaled_s_0,
      upper_size_6 = fabs(upper_size_5), upper_padded_1 = 1.8051943758648296e-276 + scaled_s_size_4,
      upper_rest_1 = KSL_MUL(1.1093356479670522e-31, upper_padded_1),
      upper_size_7 = upper_rest_1 + upper_size_6, upper_size_8 = scaled_s_size_3 + upper_size_7,
      upper_size_9 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_8,
      upper_size_10 = KSL_MUL(3.169126500570585e+29, upper_size_9),
      upper_size_11 = scaled_s_size_4 + upper_size_10;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1,
      upper_size_12 = upper_1a - scaled_s_1, upper_size_13 = fabs(upper_size_12),
      upper_padded_2 = 1.8051943758648296e-276 + scaled_s_size_8,
      upper_rest_2 = KSL_MUL(1.1093356479670522e-31, upper_padded_2),
      upper_size_14 = upper_rest_2 + upper_size_13, upper_size_15 = scaled_s_size_7 + upper_size_14,
      upper_size_16 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_15,
      upper_size_17 = KSL_MUL(3.169126500570585e+29, upper_size_16),
      upper_size_18 = scaled_s_size_8 + upper_size_17;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2,
      upper_size_19 = upper_2a - scaled_s_2, upper_size_20 = fabs(upper_size_19),
      upper_padded_3 = 1.8051943758648296e-276 + scaled_s_size_12,
      upper_rest_3 = KSL_MUL(1.1093356479670522e-31, upper_padded_3),
      upper_size_21 = upper_rest_3 + upper_size_20,
      upper_size_22 = scaled_s_size_11 + upper_size_21,
      upper_size_23 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_22,
      upper_size_24 = KSL_MUL(3.169126500570585e+29, upper_size_23),
      upper_size_25 = scaled_s_size_12 + upper_size_24;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3,
      upper_size_26 = upper_3a - scaled_s_3, upper_size_27 = fabs(upper_size_26),
      upper_padded_4 = 1.8051943758648296e-276 + scaled_s_size_16,
      upper_rest_4 = KSL_MUL(1.1093356479670522e-31, upper_padded_4),
      upper_size_28 = upper_rest_4 + upper_size_27,
      upper_size_29 = scaled_s_size_15 + upper_size_28,
      upper_size_30 = scaled_s_size_15 < upper_size_3 ? 0.0 : upper_size_29,
      upper_size_31 = KSL_MUL(3.169126500570585e+29, upper_size_30),
      upper_size_32 = scaled_s_size_16 + upper_size_31;
  const double v_s_size_0 = fabs(upper_0),
      v_s_size_padded_1 = 1.8051943758648296e-276 + upper_size_11,
      v_s_size_rest_1 = KSL_MUL(3.254051621949822e-30, v_s_size_padded_1);
  const double v_s_size_1 = fabs(upper_1),
      v_s_size_padded_2 = 1.8051943758648296e-276 + upper_size_18,
      v_s_size_rest_2 = KSL_MUL(3.254051621949822e-30, v_s_size_padded_2);
  const double v_s_size_2 = fabs(upper_2),
      v_s_size_padded_3 = 1.8051943758648296e-276 + upper_size_25,
      v_s_size_rest_3 = KSL_MUL(3.254051621949822e-30, v_s_size_padded_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s_b_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_size_1 = KSL_MUL(v_s_size_3, v_s_size_padded_1);
  const double v_y_1 = KSL_MUL(upper_1, v_s), v_y_size_2 = KSL_MUL(v_s_size_3, v_s_size_padded_2);
  const double v_y_2 = KSL_MUL(upper_2, v_s), v_y_size_3 = KSL_MUL(v_s_size_3, v_s_size_padded_3);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_a_padded_1 = 1.8051943758648296e-276 + v_y_size_1,
      v_n_a_size_1 = fabs(v_y_0), v_n_a_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_a_padded_1),
      v_n_a_units_1 = KSL_MUL(140737488355328.0, v_n_a_rest_1),
      v_n_a_reach_1 = v_n_a_size_1 + v_n_a_units_1,
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, v_n_a_reach_1),
      v_n_a_size_3 = v_n_a_size_2 + v_n_a_size_2, v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276 + v_y_size_2, v_n_b_size_1 = fabs(v_y_1),
      v_n_b_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_b_padded_1),
      v_n_b_units_1 = KSL_MUL(140737488355328.0, v_n_b_rest_1),
      v_n_b_reach_1 = v_n_b_size_1 + v_n_b_units_1,
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, v_n_b_reach_1),
      v_n_b_size_3 = v_n_b_size_2 + v_n_b_size_2, v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_c_left_1 = v_n_c - v_n_c_right_1,
      v_n_c_left_rest_1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left_1),
      v_n_c_right_rest_1 = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_c_lo = v_n_c_left_rest_1 + v_n_c_right_rest_1, v_n_c_size_1 = v_n_a_size_3 + v_n_b_size_3,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_d_padded_1 = 1.8051943758648296e-276 + v_y_size_3,
      v_n_d_size_1 = fabs(v_y_2), v_n_d_rest_1 = KSL_MUL(3.4142893812359766e-30, v_n_d_padded_1),
      v_n_d_units_1 = KSL_MUL(140737488355328.0, v_n_d_rest_1),
      v_n_d_reach_1 = v_n_d_size_1 + v_n_d_units_1,
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, v_n_d_reach_1),
      v_n_d_size_3 = v_n_d_size_2 + v_n_d_size_2, v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c, v_n_e_left_1 = v_n_e - v_n_e_right_1,
      v_n_e_left_rest_1 = v_n_c - v_n_e_left_1,
      v_n_e_right_rest_1 = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_e_lo1_1 = v_n_e_left_rest_1 + v_n_e_right_rest_1, v_n_e_lo = v_n_e_lo1_1 + v_n_c_lo,
      v_n_e_size_1 = v_n_c_size_1 + v_n_d_size_3, v_n = sqrt(v_n_e),
      v_n_product_1 = KSL_MUL(v_n, v_n),
      v_n_product_error_1 = ksl_product_error(v_n, v_n, v_n_product_1),
      v_n_rest_1 = v_n_e - v_n_product_1, v_n_exact_1 = v_n_rest_1 - v_n_product_error_1,
      v_n_residual_1 = v_n_exact_1 + v_n_e_lo, v_n_twice_1 = v_n + v_n,
      v_n_divisor_1 = v_n == 0.0 ? 1.0 : v_n_twice_1, v_n_lo = v_n_residual_1 / v_n_divisor_1,
      v_n_padded_1 = 1.8051943758648296e-276 + v_n_e_size_1, v_n_size_1 = v_n_padded_1 / v_n,
      v_n_size_2 = v_n_size_1 / v_n_e, v_n_size_3 = fabs(v_n_e), v_n_error_1 = fabs(v_n_e_lo),
      v_n_rest_2 = KSL_MUL(7.235336013082471e-30, v_n_padded_1),
      v_n_bound_1 = v_n_error_1 + v_n_rest_2, v_n_units_1 = KSL_MUL(140737488355328.0, v_n_bound_1),
      v_n_reach_1 = v_n_size_3 + v_n_units_1, v_n_size_4 = KSL_MUL(v_n_reach_1, v_n_size_2),
      v_n_size_5 = sqrt(v_n_bound_1), v_n_size_6 = fabs(v_n_lo),
      v_n_size_7 = v_n_size_5 + v_n_size_6,
      v_n_size_8 = KSL_MUL(1.5970396877936164e+29, v_n_size_7),
      v_n_size_9 = KSL_MUL(4.0, v_n_bound_1),
      v_n_size_11 = v_n_size_9 < v_n_e ? v_n_size_4 : v_n_size_8, v_n_size_12 = v_n + v_n_size_11;
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r_b_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b,
      v_r_size_1 = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b_size_1;
  const double n = KSL_MUL(v_n, v_r), n_inverse_1 = 1.0 / v_r, n_back_1 = KSL_MUL(n, n_inverse_1),
      n_lost_1 = v_n - n_back_1, n_rest_1 = n_lost_1 + v_n_lo, n_lo = KSL_MUL(n_rest_1, v_r),
      n_padded_1 = 1.8051943758648296e-276 + v_n_size_12,
      n_size_1 = KSL_MUL(n_padded_1, v_r_size_1);
  const double half = ksl_atan2(n, upper_3), half_own_error_1 = ksl_atan2_error(n, upper_3, half),
      half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1, half_cross1_1 = KSL_MUL(half_part1_1, n_lo),
      half_cross2_1 = KSL_MUL(half_part0_1, 0.0),
      half_square1_1 = KSL_MUL(half_part1_1, half_part1_1),
      half_square2_1 = KSL_MUL(half_part0_1, half_part0_1),
      half_cross_1 = half_cross1_1 - half_cross2_1, half_square_1 = half_square1_1 + half_square2_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, half_square_1),
      half_safe_1 = half_most_1 == 0.0 ? 1.0 : half_divisor2_1,
      half_more_1 = half_cross_1 / half_safe_1, half_lo = half_own_error_1 + half_more_1,
      half_size_1 = fabs(half), half_padded_1 = 1.8051943758648296e-276 + n_size_1,
      half_padded_2 = 1.8051943758648296e-276 + upper_size_32, half_size_2 = fabs(n),
      half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_error_1 = fabs(n_lo), half_rest_1 = KSL_MUL(6.859394487938082e-30, half_padded_1),
      half_bound_1 = half_error_1 + half_rest_1,
      half_rest_2 = KSL_MUL(3.254051621949822e-30, half_padded_2),
      half_size_6 = 1.8051943758648296e-276 + half_bound_1, half_size_7 = half_rest_2 + half_size_6,
      half_size_8 = half_padded_1 + half_padded_2, half_size_9 = half_size_8 / half_size_5,
      half_size_10 = half_size_1 + half_size_9, half_size_11 = half_size_7 / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_14 = fabs(half_lo),
      half_size_15 = 7.0 + half_size_14,
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_20 = half_size_11 < 0.25 ? half_size_19 : half_size_15,
      half_size_21 = KSL_MUL(4.875578158636172e+28, half_size_20),
      half_size_22 = half_size_10 + half_size_21;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo,
      divisor_size_1 = n == 0.0 ? 1.0 : n_size_1, divisor_size_2 = n - 0.0,
      divisor_size_3 = fabs(divisor_size_2), divisor_size_4 = 5e-324 + divisor_size_3,
      divisor_size_6 = 1.0 - n, divisor_size_7 = fabs(divisor_size_6),
      divisor_size_8 = divisor_size_7 + half_bound_1,
      divisor_size_9 = half_bound_1 < divisor_size_4 ? 0.0 : divisor_size_8,
      divisor_size_10 = KSL_MUL(7.042501095850493e+28, divisor_size_9),
      divisor_size_11 = divisor_size_1 + divisor_size_10;
  const double theta = KSL_MUL(2.0, half), theta_cross2_1 = KSL_MUL(2.0, half_lo),
      theta_size_1 = KSL_MUL(2.0, half_size_22);
  const double k = theta / divisor, k_product_1 = KSL_MUL(k, divisor),
      k_product_error_1 = ksl_product_error(k, divisor, k_product_1),
      k_rest_1 = theta - k_product_1, k_exact_1 = k_rest_1 - k_product_error_1,
      k_numerator_1 = k_exact_1 + theta_cross2_1, k_cross_1 = KSL_MUL(k, divisor_lo),
      k_residual_1 = k_numerator_1 - k_cross_1, k_lo = k_residual_1 / divisor,
      k_padded_1 = 1.8051943758648296e-276 + theta_size_1,
      k_padded_2 = 1.8051943758648296e-276 + divisor_size_11, k_size_1 = fabs(k),
      k_size_2 = fabs(divisor), k_size_3 = KSL_MUL(k_padded_2, k_size_1),
      k_size_4 = k_padded_1 + k_size_3, k_error_1 = fabs(divisor_lo),
      k_rest_2 = KSL_MUL(1.464323675977526e-29, k_padded_2), k_bound_1 = k_error_1 + k_rest_2,
      k_size_5 = KSL_MUL(4.0, k_bound_1), k_size_7 = k_size_5 < k_size_2 ? k_size_2 : 0.0,
      k_size_8 = k_size_4 / k_size_7, k_units_1 = KSL_MUL(140737488355328.0, k_bound_1),
      k_reach_1 = k_size_2 + k_units_1, k_size_9 = KSL_MUL(k_reach_1, k_size_8),
      k_size_10 = k_size_9 / k_size_2, k_size_11 = k_size_1 + k_size_10;
  const double vector_0 = KSL_MUL(upper_0, k), vector_cross2_1 = KSL_MUL(upper_0, k_lo),
      vector_padded_1 = 1.8051943758648296e-276 + k_size_11, vector_size_1 = fabs(upper_0),
      vector_units_1 = KSL_MUL(140737488355328.0, v_s_size_rest_1),
      vector_reach_1 = vector_size_1 + vector_units_1,
      vector_size_2 = KSL_MUL(vector_padded_1, vector_reach_1), vector_error_1 = fabs(k_lo),
      vector_rest_1 = KSL_MUL(3.097307347238718e-29, vector_padded_1),
      vector_bound_1 = vector_error_1 + vector_rest_1,
      vector_units_2 = KSL_MUL(140737488355328.0, vector_bound_1),
      vector_reach_2 = k_size_1 + vector_units_2,
      vector_size_3 = KSL_MUL(v_s_size_padded_1, vector_reach_2),
      vector_size_4 = vector_size_2 + vector_size_3;
  const double vector_1 = KSL_MUL(upper_1, k), vector_cross2_2 = KSL_MUL(upper_1, k_lo),
      vector_size_5 = fabs(upper_1), vector_units_3 = KSL_MUL(140737488355328.0, v_s_size_rest_2),
      vector_reach_3 = vector_size_5 + vector_units_3,
      vector_size_6 = KSL_MUL(vector_padded_1, vector_reach_3),
      vector_size_7 = KSL_MUL(v_s_size_padded_2, vector_reach_2),
      vector_size_8 = vector_size_6 + vector_size_7;
  const double vector_2 = KSL_MUL(upper_2, k), vector_cross2_3 = KSL_MUL(upper_2, k_lo),
      vector_size_9 = fabs(upper_2), vector_units_4 = KSL_MUL(140737488355328.0, v_s_size_rest_3),
      vector_reach_4 = vector_size_9 + vector_units_4,
      vector_size_10 = KSL_MUL(vector_padded_1, vector_reach_4),
      vector_size_11 = KSL_MUL(v_s_size_padded_3, vector_reach_2),
      vector_size_12 = vector_size_10 + vector_size_11;
  const double vector_error_2 = ksl_product_error(upper_0, k, vector_0),
      vector_lo_1 = vector_error_2 + vector_cross2_1, vector_error_3 = fabs(vector_lo_1),
      vector_padded_2 = 1.8051943758648296e-276 + vector_size_4,
      vector_rest_2 = KSL_MUL(3.2199508764278064e-29, vector_padded_2),
      vector_bound_2 = vector_error_3 + vector_rest_2,
      vector_error_4 = ksl_product_error(upper_1, k, vector_1),
      vector_lo_2 = vector_error_4 + vector_cross2_2, vector_error_5 = fabs(vector_lo_2),
      vector_padded_3 = 1.8051943758648296e-276 + vector_size_8,
      vector_rest_3 = KSL_MUL(3.2199508764278064e-29, vector_padded_3),
      vector_bound_3 = vector_error_5 + vector_rest_3,
      vector_error_6 = ksl_product_error(upper_2, k, vector_2),
      vector_lo_3 = vector_error_6 + vector_cross2_3, vector_error_7 = fabs(vector_lo_3),
      vector_padded_4 = 1.8051943758648296e-276 + vector_size_12,
      vector_rest_4 = KSL_MUL(3.2199508764278064e-29, vector_padded_4),
      vector_bound_4 = vector_error_7 + vector_rest_4;
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
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
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
  const float y_0_new_a_abs = fabsf(y_0_new_a), y_0_abs = fabsf(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const float y_1_new_a_abs = fabsf(y_1_new_a), y_1_abs = fabsf(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const float y_2_new_a_abs = fabsf(y_2_new_a), y_2_abs = fabsf(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const float y_3_new_a_abs = fabsf(y_3_new_a), y_3_abs = fabsf(y->w),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const float y_0_new_padded = y_0_new_size + 1.9721523e-31f,
      y_0_new_error_bound = KSL_MULF(1.192093e-07f, y_0_new_padded);
  const float y_1_new_padded = y_1_new_size + 1.9721523e-31f,
      y_1_new_error_bound = KSL_MULF(1.192093e-07f, y_1_new_padded);
  const float y_2_new_padded = y_2_new_size + 1.9721523e-31f,
      y_2_new_error_bound = KSL_MULF(1.192093e-07f, y_2_new_padded);
  const float y_3_new_padded = y_3_new_size + 1.9721523e-31f,
      y_3_new_error_bound = KSL_MULF(1.192093e-07f, y_3_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
  y_bound->w = y_3_new_error_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->y, v->z), c_0b = KSL_MULF(q->z, v->y), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->z, v->x), c_1b = KSL_MULF(q->x, v->z), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->x, v->y), c_2b = KSL_MULF(q->y, v->x), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->y, t_2), turn_0b = KSL_MULF(q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MULF(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const float turn_1a = KSL_MULF(q->z, t_0), turn_1b = KSL_MULF(q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MULF(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const float turn_2a = KSL_MULF(q->x, t_1), turn_2b = KSL_MULF(q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MULF(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  const float c_0a_abs = fabsf(c_0a), c_0b_abs = fabsf(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const float c_1a_abs = fabsf(c_1a), c_1b_abs = fabsf(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const float c_2a_abs = fabsf(c_2a), c_2b_abs = fabsf(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const float c_0_padded = c_0_size + 1.9721523e-31f;
  const float t_0_size = KSL_MULF(2.0f, c_0_padded);
  const float c_1_padded = c_1_size + 1.9721523e-31f;
  const float t_1_size = KSL_MULF(2.0f, c_1_padded);
  const float c_2_padded = c_2_size + 1.9721523e-31f;
  const float t_2_size = KSL_MULF(2.0f, c_2_padded);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y), turn_0a_size = KSL_MULF(q_1_abs, t_2_padded);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z), turn_0b_size = KSL_MULF(q_2_abs, t_1_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w), turn_0d_size = KSL_MULF(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const float turn_1a_size = KSL_MULF(q_2_abs, t_0_padded), q_0_abs = fabsf(q->x),
      turn_1b_size = KSL_MULF(q_0_abs, t_2_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MULF(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const float turn_2a_size = KSL_MULF(q_0_abs, t_1_padded),
      turn_2b_size = KSL_MULF(q_1_abs, t_0_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MULF(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const float v_0_abs = fabsf(v->x), vo_0_size = v_0_abs + turn_0_size;
  const float v_1_abs = fabsf(v->y), vo_1_size = v_1_abs + turn_1_size;
  const float v_2_abs = fabsf(v->z), vo_2_size = v_2_abs + turn_2_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(4.1723263e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(4.1723263e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(4.1723263e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_rotate_qconjvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->z, v->y), c_0b = KSL_MULF(q->y, v->z), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->x, v->z), c_1b = KSL_MULF(q->z, v->x), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->y, v->x), c_2b = KSL_MULF(q->x, v->y), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->z, t_1), turn_0b = KSL_MULF(q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MULF(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const float turn_1a = KSL_MULF(q->x, t_2), turn_1b = KSL_MULF(q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MULF(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const float turn_2a = KSL_MULF(q->y, t_0), turn_2b = KSL_MULF(q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MULF(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  const float c_0a_abs = fabsf(c_0a), c_0b_abs = fabsf(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const float c_1a_abs = fabsf(c_1a), c_1b_abs = fabsf(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const float c_2a_abs = fabsf(c_2a), c_2b_abs = fabsf(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const float c_0_padded = c_0_size + 1.9721523e-31f;
  const float t_0_size = KSL_MULF(2.0f, c_0_padded);
  const float c_1_padded = c_1_size + 1.9721523e-31f;
  const float t_1_size = KSL_MULF(2.0f, c_1_padded);
  const float c_2_padded = c_2_size + 1.9721523e-31f;
  const float t_2_size = KSL_MULF(2.0f, c_2_padded);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z), turn_0a_size = KSL_MULF(q_2_abs, t_1_padded);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y), turn_0b_size = KSL_MULF(q_1_abs, t_2_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w), turn_0d_size = KSL_MULF(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const float q_0_abs = fabsf(q->x), turn_1a_size = KSL_MULF(q_0_abs, t_2_padded),
      turn_1b_size = KSL_MULF(q_2_abs, t_0_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MULF(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const float turn_2a_size = KSL_MULF(q_1_abs, t_0_padded),
      turn_2b_size = KSL_MULF(q_0_abs, t_1_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MULF(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const float v_0_abs = fabsf(v->x), vo_0_size = v_0_abs + turn_0_size;
  const float v_1_abs = fabsf(v->y), vo_1_size = v_1_abs + turn_1_size;
  const float v_2_abs = fabsf(v->z), vo_2_size = v_2_abs + turn_2_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(4.1723263e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(4.1723263e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(4.1723263e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->x, q2i->w), qo_0b = KSL_MULF(q1i->y, q2i->z),
      qo_0c = KSL_MULF(q1i->z, q2i->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MULF(q1i->w, q2i->x), qo_0 = qo_0e + qo_0f;
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1b = KSL_MULF(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1e = qo_1c + qo_1d,
      qo_1f = KSL_MULF(q1i->w, q2i->y), qo_1 = qo_1e + qo_1f;
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2b = KSL_MULF(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2e = qo_2c + qo_2d,
      qo_2f = KSL_MULF(q1i->w, q2i->z), qo_2 = qo_2e + qo_2f;
  const float qo_3a = KSL_MULF(q1i->w, q2i->w), qo_3b = KSL_MULF(q1i->x, q2i->x),
      qo_3c = KSL_MULF(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MULF(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const float qo_0b_abs = fabsf(qo_0b), qo_0c_abs = fabsf(qo_0c),
      qo_0d_size = qo_0b_abs + qo_0c_abs, qo_0a_abs = fabsf(qo_0a),
      qo_0e_size = qo_0a_abs + qo_0d_size, qo_0f_abs = fabsf(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabsf(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabsf(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const float qo_3b_abs = fabsf(qo_3b), qo_3c_abs = fabsf(qo_3c),
      qo_3d_size = qo_3b_abs + qo_3c_abs, qo_3e_abs = fabsf(qo_3e),
      qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabsf(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(2.3841864e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(2.3841864e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(2.3841864e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconjf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->x, q2i->w), qo_0b = KSL_MULF(q1i->w, q2i->x),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0e = KSL_MULF(q1i->y, q2i->z),
      qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1b = KSL_MULF(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1e = KSL_MULF(q1i->w, q2i->y),
      qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2b = KSL_MULF(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2e = KSL_MULF(q1i->w, q2i->z),
      qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3b = KSL_MULF(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3d = KSL_MULF(q1i->z, q2i->z), qo_3e = qo_3c + qo_3d,
      qo_3f = KSL_MULF(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d), qo_0e_abs = fabsf(qo_0e),
      qo_0f_size = qo_0d_abs + qo_0e_abs, qo_0_size = qo_0c_size + qo_0f_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d), qo_1e_abs = fabsf(qo_1e),
      qo_1f_size = qo_1d_abs + qo_1e_abs, qo_1_size = qo_1c_size + qo_1f_size;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d), qo_2e_abs = fabsf(qo_2e),
      qo_2f_size = qo_2d_abs + qo_2e_abs, qo_2_size = qo_2c_size + qo_2f_size;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabsf(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->w, q2i->x), qo_0b = KSL_MULF(q1i->x, q2i->w),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0e = KSL_MULF(q1i->y, q2i->z),
      qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1b = KSL_MULF(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MULF(q1i->w, q2i->y), qo_1e = KSL_MULF(q1i->y, q2i->w),
      qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2b = KSL_MULF(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MULF(q1i->w, q2i->z), qo_2e = KSL_MULF(q1i->z, q2i->w),
      qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3b = KSL_MULF(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3d = KSL_MULF(q1i->z, q2i->z), qo_3e = qo_3c + qo_3d,
      qo_3f = KSL_MULF(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d), qo_0e_abs = fabsf(qo_0e),
      qo_0f_size = qo_0d_abs + qo_0e_abs, qo_0_size = qo_0c_size + qo_0f_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d), qo_1e_abs = fabsf(qo_1e),
      qo_1f_size = qo_1d_abs + qo_1e_abs, qo_1_size = qo_1c_size + qo_1f_size;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d), qo_2e_abs = fabsf(qo_2e),
      qo_2f_size = qo_2d_abs + qo_2e_abs, qo_2_size = qo_2c_size + qo_2f_size;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabsf(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.
   q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqconjf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo,
    ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1i->y, q2i->z), qo_0b = KSL_MULF(q1i->z, q2i->y),
      qo_0c = qo_0a - qo_0b, qo_0d = KSL_MULF(q1i->x, q2i->w), qo_0e = qo_0c - qo_0d,
      qo_0f = KSL_MULF(q1i->w, q2i->x), qo_0 = qo_0e - qo_0f;
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1b = KSL_MULF(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1e = qo_1c - qo_1d,
      qo_1f = KSL_MULF(q1i->w, q2i->y), qo_1 = qo_1e - qo_1f;
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2b = KSL_MULF(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2e = qo_2c - qo_2d,
      qo_2f = KSL_MULF(q1i->w, q2i->z), qo_2 = qo_2e - qo_2f;
  const float qo_3a = KSL_MULF(q1i->w, q2i->w), qo_3b = KSL_MULF(q1i->x, q2i->x),
      qo_3c = KSL_MULF(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MULF(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d),
      qo_0e_size = qo_0c_size + qo_0d_abs, qo_0f_abs = fabsf(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabsf(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabsf(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const float qo_3b_abs = fabsf(qo_3b), qo_3c_abs = fabsf(qo_3c),
      qo_3d_size = qo_3b_abs + qo_3c_abs, qo_3e_abs = fabsf(qo_3e),
      qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabsf(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(2.3841864e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(2.3841864e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(2.3841864e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(dci[0], qi->x), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qxconjqconjf_certified(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->x),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->x, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qconjqxconjf_certified(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->w, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(qi->z, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->x, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qyqconjf_certified(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->y), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->y),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(qi->y, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qconjqyconjf_certified(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->z, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1b = KSL_MULF(qi->w, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->y, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(dci[0], qi->z), qo_3b = KSL_MULF(dci[1], qi->w),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   12 mul, 12 add, 2 neg, 8 abs. */
static inline void ksl_product_qzconjqconjf_certified(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0b = KSL_MULF(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1b = KSL_MULF(dci[1], qi->y),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2b = KSL_MULF(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3b = KSL_MULF(dci[0], qi->z),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
     qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   12 mul, 12 add, 1 neg, 8 abs. */
static inline void ksl_product_qconjqzf_certified(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0b = KSL_MULF(qi->y, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0 = -qo_0c;
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1b = KSL_MULF(qi->y, dci[1]),
      qo_1 = qo_1a - qo_1b;
  const float qo_2a = KSL_MULF(qi->w, dci[0]), qo_2b = KSL_MULF(qi->z, dci[1]),
      qo_2 = qo_2a - qo_2b;
  const float qo_3a = KSL_MULF(qi->z, dci[0]), qo_3b = KSL_MULF(qi->w, dci[1]),
      qo_3 = qo_3a + qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b), qo_1_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b), qo_2_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0c_padded = qo_0c_size + 1.9721523e-31f,
      qo_0c_error_bound = KSL_MULF(1.192093e-07f, qo_0c_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.192093e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.192093e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0c_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
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
      qo_1c = qo_1a + qo_1b, qo_1 = -qo_1c;
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2b = KSL_MULF(qi->w, dci[0]),
      qo_2c = qo_2a + qo_2b, qo_2 = -qo_2c;
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3b = KSL_MULF(qi->z, dci[0]),
      qo_3 = qo_3a - qo_3b;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b), qo_0_size = qo_0a_abs + qo_0b_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b), qo_3_size = qo_3a_abs + qo_3b_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.192093e-07f, qo_0_padded);
  const float qo_1c_padded = qo_1c_size + 1.9721523e-31f,
      qo_1c_error_bound = KSL_MULF(1.192093e-07f, qo_1c_padded);
  const float qo_2c_padded = qo_2c_size + 1.9721523e-31f,
      qo_2c_error_bound = KSL_MULF(1.192093e-07f, qo_2c_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.192093e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1c_error_bound;
  qo_bound->z = qo_2c_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_product_qvf_certified(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->y, vi->z), qo_0b = KSL_MULF(qi->z, vi->y), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(qi->w, vi->x), qo_0 = qo_0c + qo_0d;
  const float qo_1a = KSL_MULF(qi->z, vi->x), qo_1b = KSL_MULF(qi->x, vi->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(qi->w, vi->y), qo_1 = qo_1c + qo_1d;
  const float qo_2a = KSL_MULF(qi->x, vi->y), qo_2b = KSL_MULF(qi->y, vi->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(qi->w, vi->z), qo_2 = qo_2c + qo_2d;
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3b = KSL_MULF(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(qi->z, vi->z), qo_3e = qo_3c + qo_3d, qo_3 = -qo_3e;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d),
      qo_0_size = qo_0c_size + qo_0d_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1_size = qo_1c_size + qo_1d_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2_size = qo_2c_size + qo_2d_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3e_padded = qo_3e_size + 1.9721523e-31f,
      qo_3e_error_bound = KSL_MULF(1.7881396e-07f, qo_3e_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3e_error_bound;
}

/* qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.
   qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
   16 mul, 20 add, 12 abs. */
static inline void ksl_product_qconjvf_certified(const ksl_quaternionf_t *qi,
    const ksl_vec3f_t *vi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(qi->z, vi->y), qo_0b = KSL_MULF(qi->y, vi->z), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(qi->w, vi->x), qo_0 = qo_0c + qo_0d;
  const float qo_1a = KSL_MULF(qi->x, vi->z), qo_1b = KSL_MULF(qi->z, vi->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(qi->w, vi->y), qo_1 = qo_1c + qo_1d;
  const float qo_2a = KSL_MULF(qi->y, vi->x), qo_2b = KSL_MULF(qi->x, vi->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(qi->w, vi->z), qo_2 = qo_2c + qo_2d;
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3b = KSL_MULF(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(qi->z, vi->z), qo_3 = qo_3c + qo_3d;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d),
      qo_0_size = qo_0c_size + qo_0d_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1_size = qo_1c_size + qo_1d_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2_size = qo_2c_size + qo_2d_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3_size = qo_3c_size + qo_3d_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.7881396e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 1 neg, 12 abs. */
static inline void ksl_product_vqf_certified(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(vi->x, qi->w), qo_0b = KSL_MULF(vi->y, qi->z),
      qo_0c = KSL_MULF(vi->z, qi->y), qo_0d = qo_0b - qo_0c, qo_0 = qo_0a + qo_0d;
  const float qo_1a = KSL_MULF(vi->z, qi->x), qo_1b = KSL_MULF(vi->x, qi->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(vi->y, qi->w), qo_1 = qo_1c + qo_1d;
  const float qo_2a = KSL_MULF(vi->x, qi->y), qo_2b = KSL_MULF(vi->y, qi->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(vi->z, qi->w), qo_2 = qo_2c + qo_2d;
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3b = KSL_MULF(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(vi->z, qi->z), qo_3e = qo_3c + qo_3d, qo_3 = -qo_3e;
  const float qo_0b_abs = fabsf(qo_0b), qo_0c_abs = fabsf(qo_0c),
      qo_0d_size = qo_0b_abs + qo_0c_abs, qo_0a_abs = fabsf(qo_0a),
      qo_0_size = qo_0a_abs + qo_0d_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1_size = qo_1c_size + qo_1d_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2_size = qo_2c_size + qo_2d_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3e_padded = qo_3e_size + 1.9721523e-31f,
      qo_3e_error_bound = KSL_MULF(1.7881396e-07f, qo_3e_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3e_error_bound;
}

/* qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.
   vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   16 mul, 20 add, 12 abs. */
static inline void ksl_product_vqconjf_certified(const ksl_vec3f_t *vi,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(vi->x, qi->w), qo_0b = KSL_MULF(vi->z, qi->y),
      qo_0c = KSL_MULF(vi->y, qi->z), qo_0d = qo_0b - qo_0c, qo_0 = qo_0a + qo_0d;
  const float qo_1a = KSL_MULF(vi->x, qi->z), qo_1b = KSL_MULF(vi->z, qi->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(vi->y, qi->w), qo_1 = qo_1c + qo_1d;
  const float qo_2a = KSL_MULF(vi->y, qi->x), qo_2b = KSL_MULF(vi->x, qi->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(vi->z, qi->w), qo_2 = qo_2c + qo_2d;
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3b = KSL_MULF(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(vi->z, qi->z), qo_3 = qo_3c + qo_3d;
  const float qo_0b_abs = fabsf(qo_0b), qo_0c_abs = fabsf(qo_0c),
      qo_0d_size = qo_0b_abs + qo_0c_abs, qo_0a_abs = fabsf(qo_0a),
      qo_0_size = qo_0a_abs + qo_0d_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1_size = qo_1c_size + qo_1d_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2_size = qo_2c_size + qo_2d_abs;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3_size = qo_3c_size + qo_3d_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(1.7881396e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.
   q1i, q2i: quaternion (x, y, z, w), the scalar last; dot_bound: number.
   5 mul, 7 add, 4 abs. */
static inline float ksl_dot_qqf_certified(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, float *dot_bound) {
  const float dot_a = KSL_MULF(q1i->x, q2i->x), dot_b = KSL_MULF(q1i->y, q2i->y),
      dot_c = dot_a + dot_b, dot_d = KSL_MULF(q1i->z, q2i->z), dot_e = dot_c + dot_d,
      dot_f = KSL_MULF(q1i->w, q2i->w), dot = dot_e + dot_f;
  const float dot_a_abs = fabsf(dot_a), dot_b_abs = fabsf(dot_b),
      dot_c_size = dot_a_abs + dot_b_abs, dot_d_abs = fabsf(dot_d),
      dot_e_size = dot_c_size + dot_d_abs, dot_f_abs = fabsf(dot_f),
      dot_size = dot_e_size + dot_f_abs;
  const float dot_padded = dot_size + 1.9721523e-31f,
      dot_error_bound = KSL_MULF(2.3841864e-07f, dot_padded);
  *dot_bound = dot_error_bound;
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_add_dpiToqf_certified(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qi_bound) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->x), qi_0_new_b = KSL_MULF(qi_0_new_a, qi->w),
      qi_0_new_c = KSL_MULF(0.5f, dpi->z), qi_0_new_d = KSL_MULF(qi_0_new_c, qi->y),
      qi_0_new_e = KSL_MULF(0.5f, dpi->y), qi_0_new_f = KSL_MULF(qi_0_new_e, qi->z),
      qi_0_new_g = qi_0_new_d - qi_0_new_f, qi_0_new_h = qi_0_new_b + qi_0_new_g,
      qi_0_new = qi_0_new_h + qi->x;
  const float qi_1_new_a = KSL_MULF(qi_0_new_a, qi->z), qi_1_new_b = KSL_MULF(qi_0_new_c, qi->x),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_d = KSL_MULF(qi_0_new_e, qi->w),
      qi_1_new_e = qi_1_new_c + qi_1_new_d, qi_1_new = qi_1_new_e + qi->y;
  const float qi_2_new_a = KSL_MULF(qi_0_new_e, qi->x), qi_2_new_b = KSL_MULF(qi_0_new_a, qi->y),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_d = KSL_MULF(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c + qi_2_new_d, qi_2_new = qi_2_new_e + qi->z;
  const float qi_3_new_a = KSL_MULF(qi_0_new_a, qi->x), qi_3_new_b = KSL_MULF(qi_0_new_e, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_d = KSL_MULF(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new = qi->w - qi_3_new_e;
  const float qi_0_new_a_abs = fabsf(qi_0_new_a),
      qi_0_new_a_padded = qi_0_new_a_abs + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w), qi_0_new_b_size = KSL_MULF(qi_0_new_a_padded, qi_3_abs);
  const float qi_0_new_c_abs = fabsf(qi_0_new_c),
      qi_0_new_c_padded = qi_0_new_c_abs + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y), qi_0_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_1_abs);
  const float qi_0_new_e_abs = fabsf(qi_0_new_e),
      qi_0_new_e_padded = qi_0_new_e_abs + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z), qi_0_new_f_size = KSL_MULF(qi_0_new_e_padded, qi_2_abs),
      qi_0_new_g_size = qi_0_new_d_size + qi_0_new_f_size,
      qi_0_new_h_size = qi_0_new_b_size + qi_0_new_g_size, qi_0_abs = fabsf(qi->x),
      qi_0_new_size = qi_0_new_h_size + qi_0_abs;
  const float qi_1_new_a_size = KSL_MULF(qi_0_new_a_padded, qi_2_abs),
      qi_1_new_b_size = KSL_MULF(qi_0_new_c_padded, qi_0_abs),
      qi_1_new_c_size = qi_1_new_a_size + qi_1_new_b_size,
      qi_1_new_d_size = KSL_MULF(qi_0_new_e_padded, qi_3_abs),
      qi_1_new_e_size = qi_1_new_c_size + qi_1_new_d_size,
      qi_1_new_size = qi_1_new_e_size + qi_1_abs;
  const float qi_2_new_a_size = KSL_MULF(qi_0_new_e_padded, qi_0_abs),
      qi_2_new_b_size = KSL_MULF(qi_0_new_a_padded, qi_1_abs),
      qi_2_new_c_size = qi_2_new_a_size + qi_2_new_b_size,
      qi_2_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_3_abs),
      qi_2_new_e_size = qi_2_new_c_size + qi_2_new_d_size,
      qi_2_new_size = qi_2_new_e_size + qi_2_abs;
  const float qi_3_new_a_size = KSL_MULF(qi_0_new_a_padded, qi_0_abs),
      qi_3_new_b_size = KSL_MULF(qi_0_new_e_padded, qi_1_abs),
      qi_3_new_c_size = qi_3_new_a_size + qi_3_new_b_size,
      qi_3_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_2_abs),
      qi_3_new_e_size = qi_3_new_c_size + qi_3_new_d_size,
      qi_3_new_size = qi_3_abs + qi_3_new_e_size;
  const float qi_0_new_padded = qi_0_new_size + 1.9721523e-31f,
      qi_0_new_error_bound = KSL_MULF(2.9802328e-07f, qi_0_new_padded);
  const float qi_1_new_padded = qi_1_new_size + 1.9721523e-31f,
      qi_1_new_error_bound = KSL_MULF(2.9802328e-07f, qi_1_new_padded);
  const float qi_2_new_padded = qi_2_new_size + 1.9721523e-31f,
      qi_2_new_error_bound = KSL_MULF(2.9802328e-07f, qi_2_new_padded);
  const float qi_3_new_padded = qi_3_new_size + 1.9721523e-31f,
      qi_3_new_error_bound = KSL_MULF(2.9802328e-07f, qi_3_new_padded);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_error_bound;
  qi_bound->y = qi_1_new_error_bound;
  qi_bound->z = qi_2_new_error_bound;
  qi_bound->w = qi_3_new_error_bound;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
     qi_bound unless inf or NaN.
   dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
   31 mul, 31 add, 7 abs. */
static inline void ksl_subtract_dpiFromqf_certified(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qi_bound) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->y), qi_0_new_b = KSL_MULF(qi_0_new_a, qi->z),
      qi_0_new_c = KSL_MULF(0.5f, dpi->z), qi_0_new_d = KSL_MULF(qi_0_new_c, qi->y),
      qi_0_new_e = qi_0_new_b - qi_0_new_d, qi_0_new_f = KSL_MULF(0.5f, dpi->x),
      qi_0_new_g = KSL_MULF(qi_0_new_f, qi->w), qi_0_new_h = qi_0_new_e - qi_0_new_g,
      qi_0_new = qi_0_new_h + qi->x;
  const float qi_1_new_a = KSL_MULF(qi_0_new_c, qi->x), qi_1_new_b = KSL_MULF(qi_0_new_f, qi->z),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_d = KSL_MULF(qi_0_new_a, qi->w),
      qi_1_new_e = qi_1_new_c - qi_1_new_d, qi_1_new = qi_1_new_e + qi->y;
  const float qi_2_new_a = KSL_MULF(qi_0_new_f, qi->y), qi_2_new_b = KSL_MULF(qi_0_new_a, qi->x),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_d = KSL_MULF(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c - qi_2_new_d, qi_2_new = qi_2_new_e + qi->z;
  const float qi_3_new_a = KSL_MULF(qi_0_new_f, qi->x), qi_3_new_b = KSL_MULF(qi_0_new_a, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_d = KSL_MULF(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new = qi_3_new_e + qi->w;
  const float qi_0_new_a_abs = fabsf(qi_0_new_a),
      qi_0_new_a_padded = qi_0_new_a_abs + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z), qi_0_new_b_size = KSL_MULF(qi_0_new_a_padded, qi_2_abs);
  const float qi_0_new_c_abs = fabsf(qi_0_new_c),
      qi_0_new_c_padded = qi_0_new_c_abs + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y), qi_0_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_1_abs),
      qi_0_new_e_size = qi_0_new_b_size + qi_0_new_d_size;
  const float qi_0_new_f_abs = fabsf(qi_0_new_f),
      qi_0_new_f_padded = qi_0_new_f_abs + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w), qi_0_new_g_size = KSL_MULF(qi_0_new_f_padded, qi_3_abs),
      qi_0_new_h_size = qi_0_new_e_size + qi_0_new_g_size, qi_0_abs = fabsf(qi->x),
      qi_0_new_size = qi_0_new_h_size + qi_0_abs;
  const float qi_1_new_a_size = KSL_MULF(qi_0_new_c_padded, qi_0_abs),
      qi_1_new_b_size = KSL_MULF(qi_0_new_f_padded, qi_2_abs),
      qi_1_new_c_size = qi_1_new_a_size + qi_1_new_b_size,
      qi_1_new_d_size = KSL_MULF(qi_0_new_a_padded, qi_3_abs),
      qi_1_new_e_size = qi_1_new_c_size + qi_1_new_d_size,
      qi_1_new_size = qi_1_new_e_size + qi_1_abs;
  const float qi_2_new_a_size = KSL_MULF(qi_0_new_f_padded, qi_1_abs),
      qi_2_new_b_size = KSL_MULF(qi_0_new_a_padded, qi_0_abs),
      qi_2_new_c_size = qi_2_new_a_size + qi_2_new_b_size,
      qi_2_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_3_abs),
      qi_2_new_e_size = qi_2_new_c_size + qi_2_new_d_size,
      qi_2_new_size = qi_2_new_e_size + qi_2_abs;
  const float qi_3_new_a_size = KSL_MULF(qi_0_new_f_padded, qi_0_abs),
      qi_3_new_b_size = KSL_MULF(qi_0_new_a_padded, qi_1_abs),
      qi_3_new_c_size = qi_3_new_a_size + qi_3_new_b_size,
      qi_3_new_d_size = KSL_MULF(qi_0_new_c_padded, qi_2_abs),
      qi_3_new_e_size = qi_3_new_c_size + qi_3_new_d_size,
      qi_3_new_size = qi_3_new_e_size + qi_3_abs;
  const float qi_0_new_padded = qi_0_new_size + 1.9721523e-31f,
      qi_0_new_error_bound = KSL_MULF(2.9802328e-07f, qi_0_new_padded);
  const float qi_1_new_padded = qi_1_new_size + 1.9721523e-31f,
      qi_1_new_error_bound = KSL_MULF(2.9802328e-07f, qi_1_new_padded);
  const float qi_2_new_padded = qi_2_new_size + 1.9721523e-31f,
      qi_2_new_error_bound = KSL_MULF(2.9802328e-07f, qi_2_new_padded);
  const float qi_3_new_padded = qi_3_new_size + 1.9721523e-31f,
      qi_3_new_error_bound = KSL_MULF(2.9802328e-07f, qi_3_new_padded);
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
  qi_bound->x = qi_0_new_error_bound;
  qi_bound->y = qi_1_new_error_bound;
  qi_bound->z = qi_2_new_error_bound;
  qi_bound->w = qi_3_new_error_bound;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
     unless inf or NaN.
   w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
   43 mul, 40 add, 11 abs. */
static inline void ksl_omega_to_dquaternionf_certified(const ksl_vec3f_t *w,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *dqo,
    ksl_quaternionf_t *dqo_bound) {
  const float dqo_0a = KSL_MULF(0.5f, w->x), dqo_0b = KSL_MULF(dqo_0a, qi->w),
      dqo_0c = KSL_MULF(0.5f, w->y), dqo_0d = KSL_MULF(dqo_0c, qi->z),
      dqo_0e = KSL_MULF(0.5f, w->z), dqo_0f = KSL_MULF(dqo_0e, qi->y), dqo_0g = dqo_0d - dqo_0f,
      dqo_0h = dqo_0b + dqo_0g, dqo_0i = KSL_MULF(qi->x, qi->x), dqo_0j = 1.0f - dqo_0i,
      dqo_0k = KSL_MULF(qi->y, qi->y), dqo_0l = dqo_0j - dqo_0k, dqo_0m = KSL_MULF(qi->z, qi->z),
      dqo_0n = dqo_0l - dqo_0m, dqo_0o = KSL_MULF(qi->w, qi->w), dqo_0p = dqo_0n - dqo_0o,
      dqo_0q = KSL_MULF(qi->x, dqo_0p), dqo_0 = dqo_0h + dqo_0q;
  const float dqo_1a = KSL_MULF(dqo_0e, qi->x), dqo_1b = KSL_MULF(dqo_0a, qi->z),
      dqo_1c = dqo_1a - dqo_1b, dqo_1d = KSL_MULF(dqo_0c, qi->w), dqo_1e = dqo_1c + dqo_1d,
      dqo_1f = KSL_MULF(qi->y, dqo_0p), dqo_1 = dqo_1e + dqo_1f;
  const float dqo_2a = KSL_MULF(dqo_0a, qi->y), dqo_2b = KSL_MULF(dqo_0c, qi->x),
      dqo_2c = dqo_2a - dqo_2b, dqo_2d = KSL_MULF(dqo_0e, qi->w), dqo_2e = dqo_2c + dqo_2d,
      dqo_2f = KSL_MULF(qi->z, dqo_0p), dqo_2 = dqo_2e + dqo_2f;
  const float dqo_3a = KSL_MULF(qi->w, dqo_0p), dqo_3b = KSL_MULF(dqo_0a, qi->x),
      dqo_3c = KSL_MULF(dqo_0c, qi->y), dqo_3d = dqo_3b + dqo_3c, dqo_3e = KSL_MULF(dqo_0e, qi->z),
      dqo_3f = dqo_3d + dqo_3e, dqo_3 = dqo_3a - dqo_3f;
  const float dqo_0a_abs = fabsf(dqo_0a), dqo_0a_padded = dqo_0a_abs + 1.9721523e-31f;
  const float qi_3_abs = fabsf(qi->w), dqo_0b_size = KSL_MULF(dqo_0a_padded, qi_3_abs);
  const float dqo_0c_abs = fabsf(dqo_0c), dqo_0c_padded = dqo_0c_abs + 1.9721523e-31f;
  const float qi_2_abs = fabsf(qi->z), dqo_0d_size = KSL_MULF(dqo_0c_padded, qi_2_abs);
  const float dqo_0e_abs = fabsf(dqo_0e), dqo_0e_padded = dqo_0e_abs + 1.9721523e-31f;
  const float qi_1_abs = fabsf(qi->y), dqo_0f_size = KSL_MULF(dqo_0e_padded, qi_1_abs),
      dqo_0g_size = dqo_0d_size + dqo_0f_size, dqo_0h_size = dqo_0b_size + dqo_0g_size,
      dqo_0i_abs = fabsf(dqo_0i), dqo_0j_size = 1.0f + dqo_0i_abs, dqo_0k_abs = fabsf(dqo_0k),
      dqo_0l_size = dqo_0j_size + dqo_0k_abs, dqo_0m_abs = fabsf(dqo_0m),
      dqo_0n_size = dqo_0l_size + dqo_0m_abs, dqo_0o_abs = fabsf(dqo_0o),
      dqo_0p_size = dqo_0n_size + dqo_0o_abs;
  const float dqo_0p_padded = dqo_0p_size + 1.9721523e-31f;
  const float qi_0_abs = fabsf(qi->x), dqo_0q_size = KSL_MULF(qi_0_abs, dqo_0p_padded),
      dqo_0_size = dqo_0h_size + dqo_0q_size;
  const float dqo_1a_size = KSL_MULF(dqo_0e_padded, qi_0_abs),
      dqo_1b_size = KSL_MULF(dqo_0a_padded, qi_2_abs), dqo_1c_size = dqo_1a_size + dqo_1b_size,
      dqo_1d_size = KSL_MULF(dqo_0c_padded, qi_3_abs), dqo_1e_size = dqo_1c_size + dqo_1d_size,
      dqo_1f_size = KSL_MULF(qi_1_abs, dqo_0p_padded), dqo_1_size = dqo_1e_size + dqo_1f_size;
  const float dqo_2a_size = KSL_MULF(dqo_0a_padded, qi_1_abs),
      dqo_2b_size = KSL_MULF(dqo_0c_padded, qi_0_abs), dqo_2c_size = dqo_2a_size + dqo_2b_size,
      dqo_2d_size = KSL_MULF(dqo_0e_padded, qi_3_abs), dqo_2e_size = dqo_2c_size + dqo_2d_size,
      dqo_2f_size = KSL_MULF(qi_2_abs, dqo_0p_padded), dqo_2_size = dqo_2e_size + dqo_2f_size;
  const float dqo_3a_size = KSL_MULF(qi_3_abs, dqo_0p_padded),
      dqo_3b_size = KSL_MULF(dqo_0a_padded, qi_0_abs),
      dqo_3c_size = KSL_MULF(dqo_0c_padded, qi_1_abs), dqo_3d_size = dqo_3b_size + dqo_3c_size,
      dqo_3e_size = KSL_MULF(dqo_0e_padded, qi_2_abs), dqo_3f_size = dqo_3d_size + dqo_3e_size,
      dqo_3_size = dqo_3a_size + dqo_3f_size;
  const float dqo_0_padded = dqo_0_size + 1.9721523e-31f,
      dqo_0_error_bound = KSL_MULF(4.1723263e-07f, dqo_0_padded);
  const float dqo_1_padded = dqo_1_size + 1.9721523e-31f,
      dqo_1_error_bound = KSL_MULF(4.1723263e-07f, dqo_1_padded);
  const float dqo_2_padded = dqo_2_size + 1.9721523e-31f,
      dqo_2_error_bound = KSL_MULF(4.1723263e-07f, dqo_2_padded);
  const float dqo_3_padded = dqo_3_size + 1.9721523e-31f,
      dqo_3_error_bound = KSL_MULF(4.1723263e-07f, dqo_3_padded);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
  dqo_bound->x = dqo_0_error_bound;
  dqo_bound->y = dqo_1_error_bound;
  dqo_bound->z = dqo_2_error_bound;
  dqo_bound->w = dqo_3_error_bound;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.
   axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   80 mul, 110 add, 11 product error, 1 div, 11 abs, 1 less, 1 select. */
static inline void ksl_quaternionf_from_axis_angle_certified(const ksl_vec3f_t *axis,
    const float angle, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float half = KSL_MULF(0.5f, angle), half_size_1 = fabsf(angle),
      half_size_2 = KSL_MULF(0.5f, half_size_1);
  float qo_3; const float sine = ksl_sincosf(half, &qo_3);
  float qo_own_error_1; const float sine_own_error_1 = ksl_sincos_errorf(half, sine, qo_3,
      &qo_own_error_1);
  const float sine_padded_1 = 3.3087225e-24f + half_size_2, sine_size_1 = 1.0f + sine_padded_1;
  const float qo_0 = KSL_MULF(axis->x, sine), qo_cross2_1 = KSL_MULF(axis->x, sine_own_error_1),
      qo_size_1 = fabsf(axis->x), qo_size_2 = KSL_MULF(qo_size_1, sine_size_1);
  const float qo_1 = KSL_MULF(axis->y, sine), qo_cross2_2 = KSL_MULF(axis->y, sine_own_error_1),
      qo_size_3 = fabsf(axis->y), qo_size_4 = KSL_MULF(qo_size_3, sine_size_1);
  const float qo_2 = KSL_MULF(axis->z, sine), qo_cross2_3 = KSL_MULF(axis->z, sine_own_error_1),
      qo_size_5 = fabsf(axis->z), qo_size_6 = KSL_MULF(qo_size_5, sine_size_1);
  const float qo_error_1 = ksl_product_errorf(axis->x, sine, qo_0),
      qo_lo_1 = qo_error_1 + qo_cross2_1, qo_error_2 = fabsf(qo_lo_1),
      qo_padded_1 = 3.3087225e-24f + qo_size_2, qo_rest_1 = KSL_MULF(1.2399095e-12f, qo_padded_1),
      qo_bound_1 = qo_error_2 + qo_rest_1, qo_error_3 = ksl_product_errorf(axis->y, sine, qo_1),
      qo_lo_2 = qo_error_3 + qo_cross2_2, qo_error_4 = fabsf(qo_lo_2),
      qo_padded_2 = 3.3087225e-24f + qo_size_4, qo_rest_2 = KSL_MULF(1.2399095e-12f, qo_padded_2),
      qo_bound_2 = qo_error_4 + qo_rest_2, qo_error_5 = ksl_product_errorf(axis->z, sine, qo_2),
      qo_lo_3 = qo_error_5 + qo_cross2_3, qo_error_6 = fabsf(qo_lo_3),
      qo_padded_3 = 3.3087225e-24f + qo_size_6, qo_rest_3 = KSL_MULF(1.2399095e-12f, qo_padded_3),
      qo_bound_3 = qo_error_6 + qo_rest_3, qo_error_7 = fabsf(qo_own_error_1),
      qo_rest_4 = KSL_MULF(1.1724027e-12f, sine_size_1), qo_bound_4 = qo_error_7 + qo_rest_4;
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
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_inverse_1 = 1.0f / s,
      scaled_s_size_1 = KSL_MULF(scaled_s_0, scaled_s_inverse_1),
      scaled_s_size_3 = q->x == scaled_s_size_1 ? 0.0f : 1e-45f,
      scaled_s_size_4 = fabsf(scaled_s_0);
  const float scaled_s_1 = KSL_MULF(q->y, s),
      scaled_s_size_5 = KSL_MULF(scaled_s_1, scaled_s_inverse_1),
      scaled_s_size_7 = q->y == scaled_s_size_5 ? 0.0f : 1e-45f,
      scaled_s_size_8 = fabsf(scaled_s_1);
  const float scaled_s_2 = KSL_MULF(q->z, s),
      scaled_s_size_9 = KSL_MULF(scaled_s_2, scaled_s_inverse_1),
      scaled_s_size_11 = q->z == scaled_s_size_9 ? 0.0f : 1e-45f,
      scaled_s_size_12 = fabsf(scaled_s_2);
  const float scaled_s_3 = KSL_MULF(q->w, s),
      scaled_s_size_13 = KSL_MULF(scaled_s_3, scaled_s_inverse_1),
      scaled_s_size_15 = q->w == scaled_s_size_13 ? 0.0f : 1e-45f,
      scaled_s_size_16 = fabsf(scaled_s_3);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0,
      upper_size_1 = scaled_s_3 - 0.0f, upper_size_2 = fabsf(upper_size_1),
      upper_size_3 = 1e-45f + upper_size_2, upper_size_5 = upper_0a - scaled_s_0,
      upper_size_6 = fabsf(upper_size_5), upper_padded_1 = 3.3087225e-24f + scaled_s_size_4,
      upper_rest_1 = KSL_MULF(3.197449e-14f, upper_padded_1),
      upper_size_7 = upper_rest_1 + upper_size_6, upper_size_8 = scaled_s_size_3 + upper_size_7,
      upper_size_9 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_8,
      upper_size_10 = KSL_MULF(1.0995137e+12f, upper_size_9),
      upper_size_11 = scaled_s_size_4 + upper_size_10;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1,
      upper_size_12 = upper_1a - scaled_s_1, upper_size_13 = fabsf(upper_size_12),
      upper_padded_2 = 3.3087225e-24f + scaled_s_size_8,
      upper_rest_2 = KSL_MULF(3.197449e-14f, upper_padded_2),
      upper_size_14 = upper_rest_2 + upper_size_13, upper_size_15 = scaled_s_size_7 + upper_size_14,
      upper_size_16 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_15,
      upper_size_17 = KSL_MULF(1.0995137e+12f, upper_size_16),
      upper_size_18 = scaled_s_size_8 + upper_size_17;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2,
      upper_size_19 = upper_2a - scaled_s_2, upper_size_20 = fabsf(upper_size_19),
      upper_padded_3 = 3.3087225e-24f + scaled_s_size_12,
      upper_rest_3 = KSL_MULF(3.197449e-14f, upper_padded_3),
      upper_size_21 = upper_rest_3 + upper_size_20,
      upper_size_22 = scaled_s_size_11 + upper_size_21,
      upper_size_23 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_22,
      upper_size_24 = KSL_MULF(1.0995137e+12f, upper_size_23),
      upper_size_25 = scaled_s_size_12 + upper_size_24;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3,
      upper_size_26 = upper_3a - scaled_s_3, upper_size_27 = fabsf(upper_size_26),
      upper_padded_4 = 3.3087225e-24f + scaled_s_size_16,
      upper_rest_4 = KSL_MULF(3.197449e-14f, upper_padded_4),
      upper_size_28 = upper_rest_4 + upper_size_27,
      upper_size_29 = scaled_s_size_15 + upper_size_28,
      upper_size_30 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_29,
      upper_size_31 = KSL_MULF(1.0995137e+12f, upper_size_30),
      upper_size_32 = scaled_s_size_16 + upper_size_31;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_padded_1 = 3.3087225e-24f + upper_size_11;
  const float v_s_size_1 = fabsf(upper_1), v_s_size_padded_2 = 3.3087225e-24f + upper_size_18;
  const float v_s_size_2 = fabsf(upper_2), v_s_size_padded_3 = 3.3087225e-24f + upper_size_25;
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s_b_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_size_1 = KSL_MULF(v_s_size_3, v_s_size_padded_1);
  const float v_y_1 = KSL_MULF(upper_1, v_s), v_y_size_2 = KSL_MULF(v_s_size_3, v_s_size_padded_2);
  const float v_y_2 = KSL_MULF(upper_2, v_s), v_y_size_3 = KSL_MULF(v_s_size_3, v_s_size_padded_3);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0), v_n_a_padded_1 = 3.3087225e-24f + v_y_size_1,
      v_n_a_size_1 = fabsf(v_y_0), v_n_a_rest_1 = KSL_MULF(9.841079e-13f, v_n_a_padded_1),
      v_n_a_units_1 = KSL_MULF(262144.0f, v_n_a_rest_1),
      v_n_a_reach_1 = v_n_a_size_1 + v_n_a_units_1,
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, v_n_a_reach_1),
      v_n_a_size_3 = v_n_a_size_2 + v_n_a_size_2, v_n_b = KSL_MULF(v_y_1, v_y_1),
      v_n_b_padded_1 = 3.3087225e-24f + v_y_size_2, v_n_b_size_1 = fabsf(v_y_1),
      v_n_b_rest_1 = KSL_MULF(9.841079e-13f, v_n_b_padded_1),
      v_n_b_units_1 = KSL_MULF(262144.0f, v_n_b_rest_1),
      v_n_b_reach_1 = v_n_b_size_1 + v_n_b_units_1,
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, v_n_b_reach_1),
      v_n_b_size_3 = v_n_b_size_2 + v_n_b_size_2, v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_c_left_1 = v_n_c - v_n_c_right_1,
      v_n_c_left_rest_1 = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c_left_1),
      v_n_c_right_rest_1 = ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_c_lo = v_n_c_left_rest_1 + v_n_c_right_rest_1, v_n_c_size_1 = v_n_a_size_3 + v_n_b_size_3,
      v_n_d = KSL_MULF(v_y_2, v_y_2), v_n_d_padded_1 = 3.3087225e-24f + v_y_size_3,
      v_n_d_size_1 = fabsf(v_y_2), v_n_d_rest_1 = KSL_MULF(9.841079e-13f, v_n_d_padded_1),
      v_n_d_units_1 = KSL_MULF(262144.0f, v_n_d_rest_1),
      v_n_d_reach_1 = v_n_d_size_1 + v_n_d_units_1,
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, v_n_d_reach_1),
      v_n_d_size_3 = v_n_d_size_2 + v_n_d_size_2, v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c, v_n_e_left_1 = v_n_e - v_n_e_right_1,
      v_n_e_left_rest_1 = v_n_c - v_n_e_left_1,
      v_n_e_right_rest_1 = ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_e_lo1_1 = v_n_e_left_rest_1 + v_n_e_right_rest_1, v_n_e_lo = v_n_e_lo1_1 + v_n_c_lo,
      v_n_e_size_1 = v_n_c_size_1 + v_n_d_size_3, v_n = sqrtf(v_n_e),
      v_n_product_1 = KSL_MULF(v_n, v_n),
      v_n_product_error_1 = ksl_product_errorf(v_n, v_n, v_n_product_1),
      v_n_rest_1 = v_n_e - v_n_product_1, v_n_exact_1 = v_n_rest_1 - v_n_product_error_1,
      v_n_residual_1 = v_n_exact_1 + v_n_e_lo, v_n_twice_1 = v_n + v_n,
      v_n_divisor_1 = v_n == 0.0f ? 1.0f : v_n_twice_1, v_n_lo = v_n_residual_1 / v_n_divisor_1,
      v_n_padded_1 = 3.3087225e-24f + v_n_e_size_1, v_n_size_1 = v_n_padded_1 / v_n,
      v_n_size_2 = v_n_size_1 / v_n_e, v_n_size_3 = fabsf(v_n_e), v_n_error_1 = fabsf(v_n_e_lo),
      v_n_rest_2 = KSL_MULF(2.0854824e-12f, v_n_padded_1), v_n_bound_1 = v_n_error_1 + v_n_rest_2,
      v_n_units_1 = KSL_MULF(262144.0f, v_n_bound_1), v_n_reach_1 = v_n_size_3 + v_n_units_1,
      v_n_size_4 = KSL_MULF(v_n_reach_1, v_n_size_2), v_n_size_5 = sqrtf(v_n_bound_1),
      v_n_size_6 = fabsf(v_n_lo), v_n_size_7 = v_n_size_5 + v_n_size_6,
      v_n_size_8 = KSL_MULF(5.540742e+11f, v_n_size_7), v_n_size_9 = KSL_MULF(4.0f, v_n_bound_1),
      v_n_size_11 = v_n_size_9 < v_n_e ? v_n_size_4 : v_n_size_8, v_n_size_12 = v_n + v_n_size_11;
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r_b_size_1 = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b,
      v_r_size_1 = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b_size_1;
  const float n = KSL_MULF(v_n, v_r), n_inverse_1 = 1.0f / v_r, n_back_1 = KSL_MULF(n, n_inverse_1),
      n_lost_1 = v_n - n_back_1, n_rest_1 = n_lost_1 + v_n_lo, n_lo = KSL_MULF(n_rest_1, v_r),
      n_padded_1 = 3.3087225e-24f + v_n_size_12, n_size_1 = KSL_MULF(n_padded_1, v_r_size_1);
  const float half = ksl_atan2f(n, upper_3), half_own_error_1 = ksl_atan2_errorf(n, upper_3, half),
      half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1, half_cross1_1 = KSL_MULF(half_part1_1, n_lo),
      half_cross2_1 = KSL_MULF(half_part0_1, 0.0f),
      half_square1_1 = KSL_MULF(half_part1_1, half_part1_1),
      half_square2_1 = KSL_MULF(half_part0_1, half_part0_1),
      half_cross_1 = half_cross1_1 - half_cross2_1, half_square_1 = half_square1_1 + half_square2_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, half_square_1),
      half_safe_1 = half_most_1 == 0.0f ? 1.0f : half_divisor2_1,
      half_more_1 = half_cross_1 / half_safe_1, half_lo = half_own_error_1 + half_more_1,
      half_size_1 = fabsf(half), half_padded_1 = 3.3087225e-24f + n_size_1,
      half_padded_2 = 3.3087225e-24f + upper_size_32, half_size_2 = fabsf(n),
      half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_error_1 = fabsf(n_lo), half_rest_1 = KSL_MULF(1.977137e-12f, half_padded_1),
      half_bound_1 = half_error_1 + half_rest_1,
      half_rest_2 = KSL_MULF(9.379186e-13f, half_padded_2),
      half_size_6 = 3.3087225e-24f + half_bound_1, half_size_7 = half_rest_2 + half_size_6,
      half_size_8 = half_padded_1 + half_padded_2, half_size_9 = half_size_8 / half_size_5,
      half_size_10 = half_size_1 + half_size_9, half_size_11 = half_size_7 / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_14 = fabsf(half_lo),
      half_size_15 = 7.0f + half_size_14,
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_20 = half_size_11 < 0.25f ? half_size_19 : half_size_15,
      half_size_21 = KSL_MULF(1.6915335e+11f, half_size_20),
      half_size_22 = half_size_10 + half_size_21;
  const float divisor = v_n == 0.0f ? 1.0f : v_n, divisor_lo = v_n == 0.0f ? 0.0f : v_n_lo,
      divisor_size_1 = v_n == 0.0f ? 1.0f : v_n_size_12,
      divisor_rest_1 = KSL_MULF(1.9042977e-12f, n_padded_1),
      divisor_bound_1 = divisor_rest_1 + v_n_size_6, divisor_size_2 = v_n - 0.0f,
      divisor_size_3 = fabsf(divisor_size_2), divisor_size_5 = 1.0f - v_n,
      divisor_size_6 = fabsf(divisor_size_5), divisor_size_7 = divisor_bound_1 + divisor_size_6,
      divisor_size_8 = divisor_bound_1 < divisor_size_3 ? 0.0f : divisor_size_7,
      divisor_size_9 = KSL_MULF(3.141416e+11f, divisor_size_8),
      divisor_size_10 = divisor_size_1 + divisor_size_9;
  const float unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MULF(unit_0, divisor),
      unit_product_error_1 = ksl_product_errorf(unit_0, divisor, unit_product_1),
      unit_rest_1 = v_y_0 - unit_product_1, unit_exact_1 = unit_rest_1 - unit_product_error_1,
      unit_cross_1 = KSL_MULF(unit_0, divisor_lo), unit_residual_1 = unit_exact_1 - unit_cross_1,
      unit_lo_1 = unit_residual_1 / divisor, unit_padded_1 = 3.3087225e-24f + divisor_size_10,
      unit_size_1 = fabsf(unit_0), unit_size_2 = fabsf(divisor),
      unit_size_3 = KSL_MULF(unit_padded_1, unit_size_1),
      unit_size_4 = unit_size_3 + v_n_a_padded_1, unit_error_1 = fabsf(divisor_lo),
      unit_rest_2 = KSL_MULF(3.2827692e-12f, unit_padded_1),
      unit_bound_1 = unit_error_1 + unit_rest_2, unit_size_5 = KSL_MULF(4.0f, unit_bound_1),
      unit_size_7 = unit_size_5 < unit_size_2 ? unit_size_2 : 0.0f,
      unit_size_8 = unit_size_4 / unit_size_7, unit_units_1 = KSL_MULF(262144.0f, unit_bound_1),
      unit_reach_1 = unit_size_2 + unit_units_1, unit_size_9 = KSL_MULF(unit_reach_1, unit_size_8),
      unit_size_10 = unit_size_9 / unit_size_2, unit_size_11 = unit_size_1 + unit_size_10;
  const float unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MULF(unit_1, divisor),
      unit_product_error_2 = ksl_product_errorf(unit_1, divisor, unit_product_2),
      unit_rest_3 = v_y_1 - unit_product_2, unit_exact_2 = unit_rest_3 - unit_product_error_2,
      unit_cross_2 = KSL_MULF(unit_1, divisor_lo), unit_residual_2 = unit_exact_2 - unit_cross_2,
      unit_lo_2 = unit_residual_2 / divisor, unit_size_12 = fabsf(unit_1),
      unit_size_13 = KSL_MULF(unit_padded_1, unit_size_12),
      unit_size_14 = unit_size_13 + v_n_b_padded_1, unit_size_15 = unit_size_14 / unit_size_7,
      unit_size_16 = KSL_MULF(unit_reach_1, unit_size_15),
      unit_size_17 = unit_size_16 / unit_size_2, unit_size_18 = unit_size_12 + unit_size_17;
  const float unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MULF(unit_2, divisor),
      unit_product_error_3 = ksl_product_errorf(unit_2, divisor, unit_product_3),
      unit_rest_4 = v_y_2 - unit_product_3, unit_exact_3 = unit_rest_4 - unit_product_error_3,
      unit_cross_3 = KSL_MULF(unit_2, divisor_lo), unit_residual_3 = unit_exact_3 - unit_cross_3,
      unit_lo_3 = unit_residual_3 / divisor, unit_size_19 = fabsf(unit_2),
      unit_size_20 = KSL_MULF(unit_padded_1, unit_size_19),
      unit_size_21 = unit_size_20 + v_n_d_padded_1, unit_size_22 = unit_size_21 / unit_size_7,
      unit_size_23 = KSL_MULF(unit_reach_1, unit_size_22),
      unit_size_24 = unit_size_23 / unit_size_2, unit_size_25 = unit_size_19 + unit_size_24;
  const float angle = KSL_MULF(2.0f, half), angle_cross2_1 = KSL_MULF(2.0f, half_lo),
      angle_size_1 = KSL_MULF(2.0f, half_size_22);
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0, axis_lo_1 = v_n == 0.0f ? 0.0f : unit_lo_1,
      axis_size_1 = v_n == 0.0f ? 1.0f : unit_size_11, axis_size_2 = 1.0f - unit_0,
      axis_size_3 = fabsf(axis_size_2), axis_error_1 = fabsf(unit_lo_1),
      axis_padded_1 = 3.3087225e-24f + unit_size_11,
      axis_rest_1 = KSL_MULF(4.7394384e-12f, axis_padded_1),
      axis_bound_1 = axis_error_1 + axis_rest_1, axis_size_4 = axis_bound_1 + axis_size_3,
      axis_size_5 = divisor_bound_1 < divisor_size_3 ? 0.0f : axis_size_4,
      axis_size_6 = KSL_MULF(2.1684825e+11f, axis_size_5), axis_size_7 = axis_size_1 + axis_size_6;
  const float angle_error_1 = fabsf(angle_cross2_1), angle_padded_1 = 3.3087225e-24f + angle_size_1,
      angle_rest_1 = KSL_MULF(6.2013957e-12f, angle_padded_1),
      angle_bound_1 = angle_error_1 + angle_rest_1, axis_error_2 = fabsf(axis_lo_1),
      axis_padded_2 = 3.3087225e-24f + axis_size_7,
      axis_rest_2 = KSL_MULF(4.7394397e-12f, axis_padded_2),
      axis_bound_2 = axis_error_2 + axis_rest_2, unit_error_2 = fabsf(unit_lo_2),
      unit_padded_2 = 3.3087225e-24f + unit_size_18,
      unit_rest_5 = KSL_MULF(4.7394384e-12f, unit_padded_2),
      unit_bound_2 = unit_error_2 + unit_rest_5, unit_error_3 = fabsf(unit_lo_3),
      unit_padded_3 = 3.3087225e-24f + unit_size_25,
      unit_rest_6 = KSL_MULF(4.7394384e-12f, unit_padded_3),
      unit_bound_3 = unit_error_3 + unit_rest_6;
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
  const float size_0 = fabsf(h_0);
  const float size_1 = fabsf(h_1);
  const float size_2 = fabsf(h_2);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = h_0 + grid;
  const float shifted_1 = h_1 + grid;
  const float shifted_2 = h_2 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = h_0 - high_0;
  const float low_1 = h_1 - high_1;
  const float low_2 = h_2 - high_2;
  const float sum_0 = h_0 + high_0;
  const float sum_1 = h_1 + high_1;
  const float sum_2 = h_2 + high_2;
  const float squares_a = KSL_MULF(high_0, high_0), squares_b = KSL_MULF(high_1, high_1),
      squares_c = squares_a + squares_b, squares_d = KSL_MULF(high_2, high_2),
      squares = squares_c + squares_d;
  const float cross_a = KSL_MULF(low_0, sum_0), cross_b = KSL_MULF(low_1, sum_1),
      cross_c = cross_a + cross_b, cross_d = KSL_MULF(low_2, sum_2), cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = KSL_MULF(theta_low, theta_sum), cross_rest = cross - cross_rest_a;
  const float exact_a = KSL_MULF(theta_high, theta_high), exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = KSL_MULF(0.5f, residual), small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = KSL_MULF(delta, far_cosine), sine = sine_a + far_sine;
  const float cosine_a = KSL_MULF(delta, far_sine), cosine = far_cosine - cosine_a;
  const float far_k = sine / theta;
  const float k_a = KSL_MULF(6.4469503e-26f, x), k_b = k_a - 3.8681703e-23f, k_c = KSL_MULF(x, k_b),
      k_d = k_c + 1.9572942e-20f, k_e = KSL_MULF(x, k_d), k_f = k_e - 8.220635e-18f,
      k_g = KSL_MULF(x, k_f), k_h = k_g + 2.8114574e-15f, k_i = KSL_MULF(x, k_h),
      k_j = k_i - 7.6471636e-13f, k_k = KSL_MULF(x, k_j), k_l = k_k + 1.6059044e-10f,
      k_m = KSL_MULF(x, k_l), k_n = k_m - 2.5052108e-08f, k_o = KSL_MULF(x, k_n),
      k_p = k_o + 2.7557319e-06f, k_q = KSL_MULF(x, k_p), k_r = k_q - 0.0001984127f,
      k_s = KSL_MULF(x, k_r), k_t = k_s + 0.008333334f, k_u = KSL_MULF(x, k_t),
      k_v = k_u - 0.16666667f, k_w = KSL_MULF(x, k_v), k_x = k_w + 1.0f, k = x < 1.0f ? k_x : far_k;
  const float g2a = KSL_MULF(2.4795963e-27f, x), g2b = g2a - 1.6117376e-24f, g2c = KSL_MULF(x, g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_MULF(x, g2d), g2f = g2e - 4.1103176e-19f,
      g2g = KSL_MULF(x, g2f), g2h = g2g + 1.5619207e-16f, g2i = KSL_MULF(x, g2h),
      g2j = g2i - 4.7794773e-14f, g2k = KSL_MULF(x, g2j), g2l = g2k + 1.1470745e-11f,
      g2m = KSL_MULF(x, g2l), g2n = g2m - 2.0876756e-09f, g2o = KSL_MULF(x, g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_MULF(x, g2p), g2r = g2q - 2.4801588e-05f,
      g2s = KSL_MULF(x, g2r), g2t = g2s + 0.0013888889f, g2u = KSL_MULF(x, g2t),
      g2v = g2u - 0.041666668f, g2w = KSL_MULF(x, g2v), g2 = g2w + 0.5f;
  const float near_a = KSL_MULF(x, g2), near = 1.0f - near_a;
  const float qo_0 = KSL_MULF(h_0, k);
  const float qo_1 = KSL_MULF(h_1, k);
  const float qo_2 = KSL_MULF(h_2, k);
  const float qo_3 = x < 1.0f ? near : cosine;
  const float fine_h_0 = KSL_MULF(0.5f, v->x), fine_h_size_3 = fabsf(v->x),
      fine_h_size_4 = KSL_MULF(0.5f, fine_h_size_3);
  const float fine_h_1 = KSL_MULF(0.5f, v->y), fine_h_size_5 = fabsf(v->y),
      fine_h_size_6 = KSL_MULF(0.5f, fine_h_size_5);
  const float fine_h_2 = KSL_MULF(0.5f, v->z), fine_h_size_7 = fabsf(v->z),
      fine_h_size_8 = KSL_MULF(0.5f, fine_h_size_7);
  const float fine_h_size_0 = fabsf(fine_h_0),
      fine_h_size_padded_1 = 3.3087225e-24f + fine_h_size_4,
      fine_h_size_rest_1 = KSL_MULF(3.5527347e-14f, fine_h_size_padded_1);
  const float fine_h_size_1 = fabsf(fine_h_1),
      fine_h_size_padded_2 = 3.3087225e-24f + fine_h_size_6,
      fine_h_size_rest_2 = KSL_MULF(3.5527347e-14f, fine_h_size_padded_2);
  const float fine_h_size_2 = fabsf(fine_h_2),
      fine_h_size_padded_3 = 3.3087225e-24f + fine_h_size_8,
      fine_h_size_rest_3 = KSL_MULF(3.5527347e-14f, fine_h_size_padded_3);
  const float fine_h_largest1 = fine_h_size_0 < fine_h_size_1 ? fine_h_size_1 : fine_h_size_0;
  const float fine_h_largest2 = fine_h_largest1 < fine_h_size_2 ? fine_h_size_2 : fine_h_largest1;
  const float fine_s = 4.611686e+18f < fine_h_largest2 ? 2.7105054e-20f : 1.0f,
      fine_s_size_1 = 4.611686e+18f < fine_h_largest2 ? 2.7105054e-20f : 1.0f;
  const float fine_reduced_0 = KSL_MULF(fine_h_0, fine_s),
      fine_reduced_size_1 = KSL_MULF(fine_h_size_padded_1, fine_s_size_1);
  const float fine_reduced_1 = KSL_MULF(fine_h_1, fine_s),
      fine_reduced_size_2 = KSL_MULF(fine_h_size_padded_2, fine_s_size_1);
  const float fine_reduced_2 = KSL_MULF(fine_h_2, fine_s),
      fine_reduced_size_3 = KSL_MULF(fine_h_size_padded_3, fine_s_size_1);
  const float fine_up = fine_s < 1.0f ? 3.689349e+19f : 1.0f,
      fine_up_size_1 = fine_s < 1.0f ? 3.689349e+19f : 1.0f;
  const float fine_reduced_length_a = KSL_MULF(fine_reduced_0, fine_reduced_0),
      fine_reduced_length_a_padded_1 = 3.3087225e-24f + fine_reduced_size_1,
      fine_reduced_length_a_size_1 = KSL_MULF(fine_reduced_length_a_padded_1,
          fine_reduced_length_a_padded_1),
      fine_reduced_length_b = KSL_MULF(fine_reduced_1, fine_reduced_1),
      fine_reduced_length_b_padded_1 = 3.3087225e-24f + fine_reduced_size_2,
      fine_reduced_length_b_size_1 = KSL_MULF(fine_reduced_length_b_padded_1,
          fine_reduced_length_b_padded_1),
      fine_reduced_length_c = fine_reduced_length_a + fine_reduced_length_b,
      fine_reduced_length_c_right_1 = fine_reduced_length_c - fine_reduced_length_a,
      fine_reduced_length_c_left_1 = fine_reduced_length_c - fine_reduced_length_c_right_1,
      fine_reduced_length_c_left_rest_1 = ksl_product_restf(fine_reduced_0, fine_reduced_0,
          fine_reduced_length_a, fine_reduced_length_c_left_1),
      fine_reduced_length_c_right_rest_1 = ksl_product_restf(fine_reduced_1, fine_reduced_1,
          fine_reduced_length_b, fine_reduced_length_c_right_1),
      fine_reduced_length_c_lo = fine_reduced_length_c_left_rest_1 +
          fine_reduced_length_c_right_rest_1,
      fine_reduced_length_c_size_1 = fine_reduced_length_a_size_1 + fine_reduced_length_b_size_1,
      fine_reduced_length_d = KSL_MULF(fine_reduced_2, fine_reduced_2),
      fine_reduced_length_d_padded_1 = 3.3087225e-24f + fine_reduced_size_3,
      fine_reduced_length_d_size_1 = KSL_MULF(fine_reduced_length_d_padded_1,
          fine_reduced_length_d_padded_1),
      fine_reduced_length_e = fine_reduced_length_c + fine_reduced_length_d,
      fine_reduced_length_e_right_1 = fine_reduced_length_e - fine_reduced_length_c,
      fine_reduced_length_e_left_1 = fine_reduced_length_e - fine_reduced_length_e_right_1,
      fine_reduced_length_e_left_rest_1 = fine_reduced_length_c - fine_reduced_length_e_left_1,
      fine_reduced_length_e_right_rest_1 = ksl_product_restf(fine_reduced_2, fine_reduced_2,
          fine_reduced_length_d, fine_reduced_length_e_right_1),
      fine_reduced_length_e_lo1_1 = fine_reduced_length_e_left_rest_1 +
          fine_reduced_length_e_right_rest_1,
      fine_reduced_length_e_lo = fine_reduced_length_e_lo1_1 + fine_reduced_length_c_lo,
      fine_reduced_length_e_size_1 = fine_reduced_length_c_size_1 + fine_reduced_length_d_size_1,
      fine_reduced_length = sqrtf(fine_reduced_length_e),
      fine_reduced_length_product_1 = KSL_MULF(fine_reduced_length, fine_reduced_length),
      fine_reduced_length_product_error_1 = ksl_product_errorf(fine_reduced_length,
          fine_reduced_length, fine_reduced_length_product_1),
      fine_reduced_length_rest_1 = fine_reduced_length_e - fine_reduced_length_product_1,
      fine_reduced_length_exact_1 = fine_reduced_length_rest_1 -
          fine_reduced_length_product_error_1,
      fine_reduced_length_residual_1 = fine_reduced_length_exact_1 + fine_reduced_length_e_lo,
      fine_reduced_length_twice_1 = fine_reduced_length + fine_reduced_length,
      fine_reduced_length_divisor_1 = fine_reduced_length == 0.0f ? 1.0f :
          fine_reduced_length_twice_1,
      fine_reduced_length_lo = fine_reduced_length_residual_1 / fine_reduced_length_divisor_1,
      fine_reduced_length_padded_1 = 3.3087225e-24f + fine_reduced_length_e_size_1,
      fine_reduced_length_size_1 = fine_reduced_length_padded_1 / fine_reduced_length,
      fine_reduced_length_size_2 = fine_reduced_length_size_1 / fine_reduced_length_e,
      fine_reduced_length_size_3 = fabsf(fine_reduced_length_e),
      fine_reduced_length_error_1 = fabsf(fine_reduced_length_e_lo),
      fine_reduced_length_rest_2 = KSL_MULF(9.308236e-13f, fine_reduced_length_padded_1),
      fine_reduced_length_bound_1 = fine_reduced_length_error_1 + fine_reduced_length_rest_2,
      fine_reduced_length_units_1 = KSL_MULF(262144.0f, fine_reduced_length_bound_1),
      fine_reduced_length_reach_1 = fine_reduced_length_size_3 + fine_reduced_length_units_1,
      fine_reduced_length_size_4 = KSL_MULF(fine_reduced_length_reach_1,
          fine_reduced_length_size_2),
      fine_reduced_length_size_5 = sqrtf(fine_reduced_length_bound_1),
      fine_reduced_length_size_6 = fabsf(fine_reduced_length_lo),
      fine_reduced_length_size_7 = fine_reduced_length_size_5 + fine_reduced_length_size_6,
      fine_reduced_length_size_8 = KSL_MULF(6.958476e+11f, fine_reduced_length_size_7),
      fine_reduced_length_size_9 = KSL_MULF(4.0f, fine_reduced_length_bound_1),
      fine_reduced_length_size_11 = fine_reduced_length_size_9 < fine_reduced_length_e ?
          fine_reduced_length_size_4 : fine_reduced_length_size_8,
      fine_reduced_length_size_12 = fine_reduced_length + fine_reduced_length_size_11;
  const float fine_half_angle = KSL_MULF(fine_reduced_length, fine_up),
      fine_half_angle_inverse_1 = 1.0f / fine_up,
      fine_half_angle_back_1 = KSL_MULF(fine_half_angle, fine_half_angle_inverse_1),
      fine_half_angle_lost_1 = fine_reduced_length - fine_half_angle_back_1,
      fine_half_angle_rest_1 = fine_half_angle_lost_1 + fine_reduced_length_lo,
      fine_half_angle_lo = KSL_MULF(fine_half_angle_rest_1, fine_up),
      fine_half_angle_padded_1 = 3.3087225e-24f + fine_reduced_length_size_12,
      fine_half_angle_size_1 = KSL_MULF(fine_half_angle_padded_1, fine_up_size_1);
  const float fine_y = KSL_MULF(fine_half_angle, fine_half_angle),
      fine_y_cross1_1 = KSL_MULF(fine_half_angle_lo, fine_half_angle),
      fine_y_cross2_1 = KSL_MULF(fine_half_angle, fine_half_angle_lo),
      fine_y_cross_1 = fine_y_cross1_1 + fine_y_cross2_1,
      fine_y_padded_1 = 3.3087225e-24f + fine_half_angle_size_1,
      fine_y_size_1 = fabsf(fine_half_angle), fine_y_error_1 = fabsf(fine_half_angle_lo),
      fine_y_rest_1 = KSL_MULF(1.6484983e-12f, fine_y_padded_1),
      fine_y_bound_1 = fine_y_error_1 + fine_y_rest_1,
      fine_y_units_1 = KSL_MULF(262144.0f, fine_y_bound_1),
      fine_y_reach_1 = fine_y_size_1 + fine_y_units_1,
      fine_y_size_2 = KSL_MULF(fine_y_padded_1, fine_y_reach_1),
      fine_y_size_3 = fine_y_size_2 + fine_y_size_2;
  float fine_c; const float fine_sine = ksl_sincosf(fine_half_angle, &fine_c);
  float fine_c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(fine_half_angle,
      fine_sine, fine_c, &fine_c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(fine_half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_slope1_1 = KSL_MULF(fine_sine_half_cos_1, fine_c),
      fine_sine_slope2_1 = KSL_MULF(fine_sine_half_sin_1, fine_sine),
      fine_sine_slope_1 = fine_sine_slope1_1 - fine_sine_slope2_1,
      fine_sine_more_1 = KSL_MULF(fine_sine_slope_1, fine_sine_twice_1),
      fine_sine_lo = fine_sine_own_error_1 + fine_sine_more_1,
      fine_sine_size_1 = 1.0f + fine_y_padded_1;
  const float fine_c_slope1_1 = KSL_MULF(fine_sine_half_cos_1, fine_sine),
      fine_c_slope2_1 = KSL_MULF(fine_sine_half_sin_1, fine_c),
      fine_c_slope_1 = fine_c_slope1_1 + fine_c_slope2_1,
      fine_c_more_1 = KSL_MULF(fine_c_slope_1, fine_sine_twice_1),
      fine_c_lo = fine_c_own_error_1 - fine_c_more_1;
  const float fine_sinc_divisor = fine_half_angle < 1.4901161e-08f ? 1.4901161e-08f :
      fine_half_angle,
      fine_sinc_divisor_lo = fine_half_angle < 1.4901161e-08f ? 0.0f : fine_half_angle_lo,
      fine_sinc_divisor_size_1 = fine_half_angle < 1.4901161e-08f ? 1.4901161e-08f :
          fine_half_angle_size_1,
      fine_sinc_divisor_size_2 = fine_half_angle - 1.4901161e-08f,
      fine_sinc_divisor_size_3 = fabsf(fine_sinc_divisor_size_2),
      fine_sinc_divisor_size_4 = 1e-45f + fine_sinc_divisor_size_3,
      fine_sinc_divisor_size_6 = 1.4901161e-08f - fine_half_angle,
      fine_sinc_divisor_size_7 = fabsf(fine_sinc_divisor_size_6),
      fine_sinc_divisor_size_8 = fine_sinc_divisor_size_7 + fine_y_bound_1,
      fine_sinc_divisor_size_9 = fine_y_bound_1 < fine_sinc_divisor_size_4 ? 0.0f :
          fine_sinc_divisor_size_8,
      fine_sinc_divisor_size_10 = KSL_MULF(1.9990821e+11f, fine_sinc_divisor_size_9),
      fine_sinc_divisor_size_11 = fine_sinc_divisor_size_1 + fine_sinc_divisor_size_10;
  const float fine_sinc_quotient = fine_sine / fine_sinc_divisor,
      fine_sinc_quotient_product_1 = KSL_MULF(fine_sinc_quotient, fine_sinc_divisor),
      fine_sinc_quotient_product_error_1 = ksl_product_errorf(fine_sinc_quotient, fine_sinc_divisor,
          fine_sinc_quotient_product_1),
      fine_sinc_quotient_rest_1 = fine_sine - fine_sinc_quotient_product_1,
      fine_sinc_quotient_exact_1 = fine_sinc_quotient_rest_1 - fine_sinc_quotient_product_error_1,
      fine_sinc_quotient_numerator_1 = fine_sinc_quotient_exact_1 + fine_sine_lo,
      fine_sinc_quotient_cross_1 = KSL_MULF(fine_sinc_quotient, fine_sinc_divisor_lo),
      fine_sinc_quotient_residual_1 = fine_sinc_quotient_numerator_1 - fine_sinc_quotient_cross_1,
      fine_sinc_quotient_lo = fine_sinc_quotient_residual_1 / fine_sinc_divisor,
      fine_sinc_quotient_padded_1 = 3.3087225e-24f + fine_sine_size_1,
      fine_sinc_quotient_padded_2 = 3.3087225e-24f + fine_sinc_divisor_size_11,
      fine_sinc_quotient_size_1 = fabsf(fine_sinc_quotient),
      fine_sinc_quotient_size_2 = fabsf(fine_sinc_divisor),
      fine_sinc_quotient_size_3 = KSL_MULF(fine_sinc_quotient_padded_2, fine_sinc_quotient_size_1),
      fine_sinc_quotient_size_4 = fine_sinc_quotient_padded_1 + fine_sinc_quotient_size_3,
      fine_sinc_quotient_error_1 = fabsf(fine_sinc_divisor_lo),
      fine_sinc_quotient_rest_2 = KSL_MULF(5.1586396e-12f, fine_sinc_quotient_padded_2),
      fine_sinc_quotient_bound_1 = fine_sinc_quotient_error_1 + fine_sinc_quotient_rest_2,
      fine_sinc_quotient_size_5 = KSL_MULF(4.0f, fine_sinc_quotient_bound_1),
      fine_sinc_quotient_size_7 = fine_sinc_quotient_size_5 < fine_sinc_quotient_size_2 ?
          fine_sinc_quotient_size_2 : 0.0f,
      fine_sinc_quotient_size_8 = fine_sinc_quotient_size_4 / fine_sinc_quotient_size_7,
      fine_sinc_quotient_units_1 = KSL_MULF(262144.0f, fine_sinc_quotient_bound_1),
      fine_sinc_quotient_reach_1 = fine_sinc_quotient_size_2 + fine_sinc_quotient_units_1,
      fine_sinc_quotient_size_9 = KSL_MULF(fine_sinc_quotient_reach_1, fine_sinc_quotient_size_8),
      fine_sinc_quotient_size_10 = fine_sinc_quotient_size_9 / fine_sinc_quotient_size_2,
      fine_sinc_quotient_size_11 = fine_sinc_quotient_size_1 + fine_sinc_quotient_size_10;
  const float fine_y_error_2 = ksl_product_errorf(fine_half_angle, fine_half_angle, fine_y),
      fine_y_lo = fine_y_error_2 + fine_y_cross_1, fine_sinc_a = KSL_MULF(0.16666667f, fine_y),
      fine_sinc_a_cross1_1 = KSL_MULF(-4.967054e-09f, fine_y),
      fine_sinc_a_cross2_1 = KSL_MULF(0.16666667f, fine_y_lo),
      fine_sinc_a_cross_1 = fine_sinc_a_cross1_1 + fine_sinc_a_cross2_1,
      fine_sinc_a_size_1 = KSL_MULF(0.16666669f, fine_y_size_3), fine_sinc_b = 1.0f - fine_sinc_a,
      fine_sinc_b_right_1 = 1.0f - fine_sinc_b,
      fine_sinc_b_left_1 = fine_sinc_b + fine_sinc_b_right_1,
      fine_sinc_b_left_rest_1 = 1.0f - fine_sinc_b_left_1,
      fine_sinc_b_right_rest_1 = ksl_product_restf(0.16666667f, fine_y, fine_sinc_a,
          fine_sinc_b_right_1),
      fine_sinc_b_lo1_1 = fine_sinc_b_left_rest_1 - fine_sinc_b_right_rest_1,
      fine_sinc_b_lo = fine_sinc_b_lo1_1 - fine_sinc_a_cross_1,
      fine_sinc_b_size_1 = 1.0f + fine_sinc_a_size_1,
      fine_sinc = fine_half_angle < 1.4901161e-08f ? fine_sinc_b : fine_sinc_quotient,
      fine_sinc_lo = fine_half_angle < 1.4901161e-08f ? fine_sinc_b_lo : fine_sinc_quotient_lo,
      fine_sinc_size_1 = fine_half_angle < 1.4901161e-08f ? fine_sinc_b_size_1 :
          fine_sinc_quotient_size_11,
      fine_sinc_size_2 = fine_sinc_b - fine_sinc_quotient,
      fine_sinc_size_3 = fabsf(fine_sinc_size_2), fine_sinc_error_1 = fabsf(fine_sinc_b_lo),
      fine_sinc_padded_1 = 3.3087225e-24f + fine_sinc_b_size_1,
      fine_sinc_rest_1 = KSL_MULF(2.3639474e-10f, fine_sinc_padded_1),
      fine_sinc_bound_1 = fine_sinc_error_1 + fine_sinc_rest_1,
      fine_sinc_error_2 = fabsf(fine_sinc_quotient_lo),
      fine_sinc_padded_2 = 3.3087225e-24f + fine_sinc_quotient_size_11,
      fine_sinc_rest_2 = KSL_MULF(7.941701e-12f, fine_sinc_padded_2),
      fine_sinc_bound_2 = fine_sinc_error_2 + fine_sinc_rest_2,
      fine_sinc_size_4 = fine_sinc_bound_1 + fine_sinc_size_3,
      fine_sinc_size_5 = fine_sinc_bound_2 + fine_sinc_size_4,
      fine_sinc_size_6 = fine_y_bound_1 < fine_sinc_divisor_size_4 ? 0.0f : fine_sinc_size_5,
      fine_sinc_size_7 = KSL_MULF(4.235067e+09f, fine_sinc_size_6),
      fine_sinc_size_8 = fine_sinc_size_1 + fine_sinc_size_7;
  const float fine_qo_0 = KSL_MULF(fine_h_0, fine_sinc),
      fine_qo_cross2_1 = KSL_MULF(fine_h_0, fine_sinc_lo),
      fine_qo_padded_1 = 3.3087225e-24f + fine_sinc_size_8, fine_qo_size_1 = fabsf(fine_h_0),
      fine_qo_units_1 = KSL_MULF(262144.0f, fine_h_size_rest_1),
      fine_qo_reach_1 = fine_qo_size_1 + fine_qo_units_1,
      fine_qo_size_2 = KSL_MULF(fine_qo_padded_1, fine_qo_reach_1),
      fine_qo_size_3 = fabsf(fine_sinc), fine_qo_error_1 = fabsf(fine_sinc_lo),
      fine_qo_rest_1 = KSL_MULF(2.3639482e-10f, fine_qo_padded_1),
      fine_qo_bound_1 = fine_qo_error_1 + fine_qo_rest_1,
      fine_qo_units_2 = KSL_MULF(262144.0f, fine_qo_bound_1),
      fine_qo_reach_2 = fine_qo_size_3 + fine_qo_units_2,
      fine_qo_size_4 = KSL_MULF(fine_h_size_padded_1, fine_qo_reach_2),
      fine_qo_size_5 = fine_qo_size_2 + fine_qo_size_4;
  const float fine_qo_1 = KSL_MULF(fine_h_1, fine_sinc),
      fine_qo_cross2_2 = KSL_MULF(fine_h_1, fine_sinc_lo), fine_qo_size_6 = fabsf(fine_h_1),
      fine_qo_units_3 = KSL_MULF(262144.0f, fine_h_size_rest_2),
      fine_qo_reach_3 = fine_qo_size_6 + fine_qo_units_3,
      fine_qo_size_7 = KSL_MULF(fine_qo_padded_1, fine_qo_reach_3),
      fine_qo_size_8 = KSL_MULF(fine_h_size_padded_2, fine_qo_reach_2),
      fine_qo_size_9 = fine_qo_size_7 + fine_qo_size_8;
  const float fine_qo_2 = KSL_MULF(fine_h_2, fine_sinc),
      fine_qo_cross2_3 = KSL_MULF(fine_h_2, fine_sinc_lo), fine_qo_size_10 = fabsf(fine_h_2),
      fine_qo_units_4 = KSL_MULF(262144.0f, fine_h_size_rest_3),
      fine_qo_reach_4 = fine_qo_size_10 + fine_qo_units_4,
      fine_qo_size_11 = KSL_MULF(fine_qo_padded_1, fine_qo_reach_4),
      fine_qo_size_12 = KSL_MULF(fine_h_size_padded_3, fine_qo_reach_2),
      fine_qo_size_13 = fine_qo_size_11 + fine_qo_size_12;
  const float fine_qo_error_2 = ksl_product_errorf(fine_h_0, fine_sinc, fine_qo_0),
      fine_qo_lo_1 = fine_qo_error_2 + fine_qo_cross2_1, qo_apart_1 = fine_qo_0 - qo_0,
      qo_apart_2 = fine_qo_lo_1 + qo_apart_1, qo_error_1 = fabsf(qo_apart_2),
      qo_error_2 = KSL_MULF(1.0000005f, qo_error_1), qo_padded_1 = 3.3087225e-24f + fine_qo_size_5,
      qo_rest_1 = KSL_MULF(2.3676172e-10f, qo_padded_1), qo_bound_1 = qo_error_2 + qo_rest_1,
      fine_qo_error_3 = ksl_product_errorf(fine_h_1, fine_sinc, fine_qo_1),
      fine_qo_lo_2 = fine_qo_error_3 + fine_qo_cross2_2, qo_apart_3 = fine_qo_1 - qo_1,
      qo_apart_4 = fine_qo_lo_2 + qo_apart_3, qo_error_3 = fabsf(qo_apart_4),
      qo_error_4 = KSL_MULF(1.0000005f, qo_error_3), qo_padded_2 = 3.3087225e-24f + fine_qo_size_9,
      qo_rest_2 = KSL_MULF(2.3676172e-10f, qo_padded_2), qo_bound_2 = qo_error_4 + qo_rest_2,
      fine_qo_error_4 = ksl_product_errorf(fine_h_2, fine_sinc, fine_qo_2),
      fine_qo_lo_3 = fine_qo_error_4 + fine_qo_cross2_3, qo_apart_5 = fine_qo_2 - qo_2,
      qo_apart_6 = fine_qo_lo_3 + qo_apart_5, qo_error_5 = fabsf(qo_apart_6),
      qo_error_6 = KSL_MULF(1.0000005f, qo_error_5), qo_padded_3 = 3.3087225e-24f + fine_qo_size_13,
      qo_rest_3 = KSL_MULF(2.3676172e-10f, qo_padded_3), qo_bound_3 = qo_error_6 + qo_rest_3,
      qo_apart_7 = fine_c - qo_3, qo_apart_8 = fine_c_lo + qo_apart_7,
      qo_error_7 = fabsf(qo_apart_8), qo_error_8 = KSL_MULF(1.0000005f, qo_error_7),
      qo_rest_4 = KSL_MULF(3.041182e-12f, fine_sinc_quotient_padded_1),
      qo_bound_4 = qo_error_8 + qo_rest_4;
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
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_inverse_1 = 1.0f / s,
      scaled_s_size_1 = KSL_MULF(scaled_s_0, scaled_s_inverse_1),
      scaled_s_size_3 = q->x == scaled_s_size_1 ? 0.0f : 1e-45f,
      scaled_s_size_4 = fabsf(scaled_s_0);
  const float scaled_s_1 = KSL_MULF(q->y, s),
      scaled_s_size_5 = KSL_MULF(scaled_s_1, scaled_s_inverse_1),
      scaled_s_size_7 = q->y == scaled_s_size_5 ? 0.0f : 1e-45f,
      scaled_s_size_8 = fabsf(scaled_s_1);
  const float scaled_s_2 = KSL_MULF(q->z, s),
      scaled_s_size_9 = KSL_MULF(scaled_s_2, scaled_s_inverse_1),
      scaled_s_size_11 = q->z == scaled_s_size_9 ? 0.0f : 1e-45f,
      scaled_s_size_12 = fabsf(scaled_s_2);
  const float scaled_s_3 = KSL_MULF(q->w, s),
      scaled_s_size_13 = KSL_MULF(scaled_s_3, scaled_s_inverse_1),
      scaled_s_size_15 = q->w == scaled_s_size_13 ? 0.0f : 1e-45f,
      scaled_s_size_16 = fabsf(scaled_s_3);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0,
      upper_size_1 = scaled_s_3 - 0.0f, upper_size_2 = fabsf(upper_size_1),
      upper_size_3 = 1e-45f + upper_size_2, upper_size_5 = upper_0a - scaled_s_0,
      upper_size_6 = fabsf(upper_size_5), upper_padded_1 = 3.3087225e-24f + scaled_s_size_4,
      upper_rest_1 = KSL_MULF(3.197449e-14f, upper_padded_1),
      upper_size_7 = upper_rest_1 + upper_size_6, upper_size_8 = scaled_s_size_3 + upper_size_7,
      upper_size_9 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_8,
      upper_size_10 = KSL_MULF(1.0995137e+12f, upper_size_9),
      upper_size_11 = scaled_s_size_4 + upper_size_10;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1,
      upper_size_12 = upper_1a - scaled_s_1, upper_size_13 = fabsf(upper_size_12),
      upper_padded_2 = 3.3087225e-24f + scaled_s_size_8,
      upper_rest_2 = KSL_MULF(3.197449e-14f, upper_padded_2),
      upper_size_14 = upper_rest_2 + upper_size_13, upper_size_15 = scaled_s_size_7 + upper_size_14,
      upper_size_16 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_15,
      upper_size_17 = KSL_MULF(1.0995137e+12f, upper_size_16),
      upper_size_18 = scaled_s_size_8 + upper_size_17;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2,
      upper_size_19 = upper_2a - scaled_s_2, upper_size_20 = fabsf(upper_size_19),
      upper_padded_3 = 3.3087225e-24f + scaled_s_size_12,
      upper_rest_3 = KSL_MULF(3.197449e-14f, upper_padded_3),
      upper_size_21 = upper_rest_3 + upper_size_20,
      upper_size_22 = scaled_s_size_11 + upper_size_21,
      upper_size_23 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_22,
      upper_size_24 = KSL_MULF(1.0995137e+12f, upper_size_23),
      upper_size_25 = scaled_s_size_12 + upper_size_24;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3,
      upper_size_26 = upper_3a - scaled_s_3, upper_size_27 = fabsf(upper_size_26),
      upper_padded_4 = 3.3087225e-24f + scaled_s_size_16,
      upper_rest_4 = KSL_MULF(3.197449e-14f, upper_padded_4),
      upper_size_28 = upper_rest_4 + upper_size_27,
      upper_size_29 = scaled_s_size_15 + upper_size_28,
      upper_size_30 = scaled_s_size_15 < upper_size_3 ? 0.0f : upper_size_29,
      upper_size_31 = KSL_MULF(1.0995137e+12f, upper_size_30),
      upper_size_32 = scaled_s_size_16 + upper_size_31;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_padded_1 = 3.3087225e-24f + upper_size_11,
      v_s_size_rest_1 = KSL_MULF(9.379186e-13f, v_s_size_padded_1);
  const float v_s_size_1 = fabsf(upper_1), v_s_size_padded_2 = 3.3087225e-24f + upper_size_18,
      v_s_size_rest_2 = KSL_MULF(9.379186e-13f, v_s_size_padded_2);
  const float v_s_size_2 = fabsf(upper_2), v_s_size_padded_3 = 3.3087225e-24f + upper_size_25,
      v_s_size_rest_3 = KSL_MULF(9.379186e-13f, v_s_size_padded_3);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s_b_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_size_1 = KSL_MULF(v_s_size_3, v_s_size_padded_1);
  const float v_y_1 = KSL_MULF(upper_1, v_s), v_y_size_2 = KSL_MULF(v_s_size_3, v_s_size_padded_2);
  const float v_y_2 = KSL_MULF(upper_2, v_s), v_y_size_3 = KSL_MULF(v_s_size_3, v_s_size_padded_3);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0), v_n_a_padded_1 = 3.3087225e-24f + v_y_size_1,
      v_n_a_size_1 = fabsf(v_y_0), v_n_a_rest_1 = KSL_MULF(9.841079e-13f, v_n_a_padded_1),
      v_n_a_units_1 = KSL_MULF(262144.0f, v_n_a_rest_1),
      v_n_a_reach_1 = v_n_a_size_1 + v_n_a_units_1,
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, v_n_a_reach_1),
      v_n_a_size_3 = v_n_a_size_2 + v_n_a_size_2, v_n_b = KSL_MULF(v_y_1, v_y_1),
      v_n_b_padded_1 = 3.3087225e-24f + v_y_size_2, v_n_b_size_1 = fabsf(v_y_1),
      v_n_b_rest_1 = KSL_MULF(9.841079e-13f, v_n_b_padded_1),
      v_n_b_units_1 = KSL_MULF(262144.0f, v_n_b_rest_1),
      v_n_b_reach_1 = v_n_b_size_1 + v_n_b_units_1,
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, v_n_b_reach_1),
      v_n_b_size_3 = v_n_b_size_2 + v_n_b_size_2, v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a, v_n_c_left_1 = v_n_c - v_n_c_right_1,
      v_n_c_left_rest_1 = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c_left_1),
      v_n_c_right_rest_1 = ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1),
      v_n_c_lo = v_n_c_left_rest_1 + v_n_c_right_rest_1, v_n_c_size_1 = v_n_a_size_3 + v_n_b_size_3,
      v_n_d = KSL_MULF(v_y_2, v_y_2), v_n_d_padded_1 = 3.3087225e-24f + v_y_size_3,
      v_n_d_size_1 = fabsf(v_y_2), v_n_d_rest_1 = KSL_MULF(9.841079e-13f, v_n_d_padded_1),
      v_n_d_units_1 = KSL_MULF(262144.0f, v_n_d_rest_1),
      v_n_d_reach_1 = v_n_d_size_1 + v_n_d_units_1,
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, v_n_d_reach_1),
      v_n_d_size_3 = v_n_d_size_2 + v_n_d_size_2, v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c, v_n_e_left_1 = v_n_e - v_n_e_right_1,
      v_n_e_left_rest_1 = v_n_c - v_n_e_left_1,
      v_n_e_right_rest_1 = ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_e_lo1_1 = v_n_e_left_rest_1 + v_n_e_right_rest_1, v_n_e_lo = v_n_e_lo1_1 + v_n_c_lo,
      v_n_e_size_1 = v_n_c_size_1 + v_n_d_size_3, v_n = sqrtf(v_n_e),
      v_n_product_1 = KSL_MULF(v_n, v_n),
      v_n_product_error_1 = ksl_product_errorf(v_n, v_n, v_n_product_1),
      v_n_rest_1 = v_n_e - v_n_product_1, v_n_exact_1 = v_n_rest_1 - v_n_product_error_1,
      v_n_residual_1 = v_n_exact_1 + v_n_e_lo, v_n_twice_1 = v_n + v_n,
      v_n_divisor_1 = v_n == 0.0f ? 1.0f : v_n_twice_1, v_n_lo = v_n_residual_1 / v_n_divisor_1,
      v_n_padded_1 = 3.3087225e-24f + v_n_e_size_1, v_n_size_1 = v_n_padded_1 / v_n,
      v_n_size_2 = v_n_size_1 / v_n_e, v_n_size_3 = fabsf(v_n_e), v_n_error_1 = fabsf(v_n_e_lo),
      v_n_rest_2 = KSL_MULF(2.0854824e-12f, v_n_padded_1), v_n_bound_1 = v_n_error_1 + v_n_rest_2,
      v_n_units_1 = KSL_MULF(262144.0f, v_n_bound_1), v_n_reach_1 = v_n_size_3 + v_n_units_1,
      v_n_size_4 = KSL_MULF(v_n_reach_1, v_n_size_2), v_n_size_5 = sqrtf(v_n_bound_1),
      v_n_size_6 = fabsf(v_n_lo), v_n_size_7 = v_n_size_5 + v_n_size_6,
      v_n_size_8 = KSL_MULF(5.540742e+11f, v_n_size_7), v_n_size_9 = KSL_MULF(4.0f, v_n_bound_1),
      v_n_size_11 = v_n_size_9 < v_n_e ? v_n_size_4 : v_n_size_8, v_n_size_12 = v_n + v_n_size_11;
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r_b_size_1 = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b,
      v_r_size_1 = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b_size_1;
  const float n = KSL_MULF(v_n, v_r), n_inverse_1 = 1.0f / v_r, n_back_1 = KSL_MULF(n, n_inverse_1),
      n_lost_1 = v_n - n_back_1, n_rest_1 = n_lost_1 + v_n_lo, n_lo = KSL_MULF(n_rest_1, v_r),
      n_padded_1 = 3.3087225e-24f + v_n_size_12, n_size_1 = KSL_MULF(n_padded_1, v_r_size_1);
  const float half = ksl_atan2f(n, upper_3), half_own_error_1 = ksl_atan2_errorf(n, upper_3, half),
      half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1, half_cross1_1 = KSL_MULF(half_part1_1, n_lo),
      half_cross2_1 = KSL_MULF(half_part0_1, 0.0f),
      half_square1_1 = KSL_MULF(half_part1_1, half_part1_1),
      half_square2_1 = KSL_MULF(half_part0_1, half_part0_1),
      half_cross_1 = half_cross1_1 - half_cross2_1, half_square_1 = half_square1_1 + half_square2_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, half_square_1),
      half_safe_1 = half_most_1 == 0.0f ? 1.0f : half_divisor2_1,
      half_more_1 = half_cross_1 / half_safe_1, half_lo = half_own_error_1 + half_more_1,
      half_size_1 = fabsf(half), half_padded_1 = 3.3087225e-24f + n_size_1,
      half_padded_2 = 3.3087225e-24f + upper_size_32, half_size_2 = fabsf(n),
      half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_error_1 = fabsf(n_lo), half_rest_1 = KSL_MULF(1.977137e-12f, half_padded_1),
      half_bound_1 = half_error_1 + half_rest_1,
      half_rest_2 = KSL_MULF(9.379186e-13f, half_padded_2),
      half_size_6 = 3.3087225e-24f + half_bound_1, half_size_7 = half_rest_2 + half_size_6,
      half_size_8 = half_padded_1 + half_padded_2, half_size_9 = half_size_8 / half_size_5,
      half_size_10 = half_size_1 + half_size_9, half_size_11 = half_size_7 / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_14 = fabsf(half_lo),
      half_size_15 = 7.0f + half_size_14,
      half_size_18 = half_rest_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_20 = half_size_11 < 0.25f ? half_size_19 : half_size_15,
      half_size_21 = KSL_MULF(1.6915335e+11f, half_size_20),
      half_size_22 = half_size_10 + half_size_21;
  const float divisor = n == 0.0f ? 1.0f : n, divisor_lo = n == 0.0f ? 0.0f : n_lo,
      divisor_size_1 = n == 0.0f ? 1.0f : n_size_1, divisor_size_2 = n - 0.0f,
      divisor_size_3 = fabsf(divisor_size_2), divisor_size_4 = 1e-45f + divisor_size_3,
      divisor_size_6 = 1.0f - n, divisor_size_7 = fabsf(divisor_size_6),
      divisor_size_8 = divisor_size_7 + half_bound_1,
      divisor_size_9 = half_bound_1 < divisor_size_4 ? 0.0f : divisor_size_8,
      divisor_size_10 = KSL_MULF(2.443323e+11f, divisor_size_9),
      divisor_size_11 = divisor_size_1 + divisor_size_10;
  const float theta = KSL_MULF(2.0f, half), theta_cross2_1 = KSL_MULF(2.0f, half_lo),
      theta_size_1 = KSL_MULF(2.0f, half_size_22);
  const float k = theta / divisor, k_product_1 = KSL_MULF(k, divisor),
      k_product_error_1 = ksl_product_errorf(k, divisor, k_product_1),
      k_rest_1 = theta - k_product_1, k_exact_1 = k_rest_1 - k_product_error_1,
      k_numerator_1 = k_exact_1 + theta_cross2_1, k_cross_1 = KSL_MULF(k, divisor_lo),
      k_residual_1 = k_numerator_1 - k_cross_1, k_lo = k_residual_1 / divisor,
      k_padded_1 = 3.3087225e-24f + theta_size_1, k_padded_2 = 3.3087225e-24f + divisor_size_11,
      k_size_1 = fabsf(k), k_size_2 = fabsf(divisor), k_size_3 = KSL_MULF(k_padded_2, k_size_1),
      k_size_4 = k_padded_1 + k_size_3, k_error_1 = fabsf(divisor_lo),
      k_rest_2 = KSL_MULF(4.2207045e-12f, k_padded_2), k_bound_1 = k_error_1 + k_rest_2,
      k_size_5 = KSL_MULF(4.0f, k_bound_1), k_size_7 = k_size_5 < k_size_2 ? k_size_2 : 0.0f,
      k_size_8 = k_size_4 / k_size_7, k_units_1 = KSL_MULF(262144.0f, k_bound_1),
      k_reach_1 = k_size_2 + k_units_1, k_size_9 = KSL_MULF(k_reach_1, k_size_8),
      k_size_10 = k_size_9 / k_size_2, k_size_11 = k_size_1 + k_size_10;
  const float vector_0 = KSL_MULF(upper_0, k), vector_cross2_1 = KSL_MULF(upper_0, k_lo),
      vector_padded_1 = 3.3087225e-24f + k_size_11, vector_size_1 = fabsf(upper_0),
      vector_units_1 = KSL_MULF(262144.0f, v_s_size_rest_1),
      vector_reach_1 = vector_size_1 + vector_units_1,
      vector_size_2 = KSL_MULF(vector_padded_1, vector_reach_1), vector_error_1 = fabsf(k_lo),
      vector_rest_1 = KSL_MULF(8.927625e-12f, vector_padded_1),
      vector_bound_1 = vector_error_1 + vector_rest_1,
      vector_units_2 = KSL_MULF(262144.0f, vector_bound_1),
      vector_reach_2 = k_size_1 + vector_units_2,
      vector_size_3 = KSL_MULF(v_s_size_padded_1, vector_reach_2),
      vector_size_4 = vector_size_2 + vector_size_3;
  const float vector_1 = KSL_MULF(upper_1, k), vector_cross2_2 = KSL_MULF(upper_1, k_lo),
      vector_size_5 = fabsf(upper_1), vector_units_3 = KSL_MULF(262144.0f, v_s_size_rest_2),
      vector_reach_3 = vector_size_5 + vector_units_3,
      vector_size_6 = KSL_MULF(vector_padded_1, vector_reach_3),
      vector_size_7 = KSL_MULF(v_s_size_padded_2, vector_reach_2),
      vector_size_8 = vector_size_6 + vector_size_7;
  const float vector_2 = KSL_MULF(upper_2, k), vector_cross2_3 = KSL_MULF(upper_2, k_lo),
      vector_size_9 = fabsf(upper_2), vector_units_4 = KSL_MULF(262144.0f, v_s_size_rest_3),
      vector_reach_4 = vector_size_9 + vector_units_4,
      vector_size_10 = KSL_MULF(vector_padded_1, vector_reach_4),
      vector_size_11 = KSL_MULF(v_s_size_padded_3, vector_reach_2),
      vector_size_12 = vector_size_10 + vector_size_11;
  const float vector_error_2 = ksl_product_errorf(upper_0, k, vector_0),
      vector_lo_1 = vector_error_2 + vector_cross2_1, vector_error_3 = fabsf(vector_lo_1),
      vector_padded_2 = 3.3087225e-24f + vector_size_4,
      vector_rest_2 = KSL_MULF(9.281226e-12f, vector_padded_2),
      vector_bound_2 = vector_error_3 + vector_rest_2,
      vector_error_4 = ksl_product_errorf(upper_1, k, vector_1),
      vector_lo_2 = vector_error_4 + vector_cross2_2, vector_error_5 = fabsf(vector_lo_2),
      vector_padded_3 = 3.3087225e-24f + vector_size_8,
      vector_rest_3 = KSL_MULF(9.281226e-12f, vector_padded_3),
      vector_bound_3 = vector_error_5 + vector_rest_3,
      vector_error_6 = ksl_product_errorf(upper_2, k, vector_2),
      vector_lo_3 = vector_error_6 + vector_cross2_3, vector_error_7 = fabsf(vector_lo_3),
      vector_padded_4 = 3.3087225e-24f + vector_size_12,
      vector_rest_4 = KSL_MULF(9.281226e-12f, vector_padded_4),
      vector_bound_4 = vector_error_7 + vector_rest_4;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
  vo_bound->x = vector_bound_2;
  vo_bound->y = vector_bound_3;
  vo_bound->z = vector_bound_4;
}

#endif
