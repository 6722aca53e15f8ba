/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_QUATERNION_CERTIFIED_H
#define KSL_QUATERNION_CERTIFIED_H

#include "ksl_types.h"

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

#endif
