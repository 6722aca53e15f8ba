/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Certified tier: plain results, and bounds of their errors that hold. */
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

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf or
     NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qq_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->x, q2->w), qo_0b = KSL_MUL(q1->y, q2->z),
      qo_0c = KSL_MUL(q1->z, q2->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MUL(q1->w, q2->x), qo_0 = qo_0e + qo_0f;
  const double qo_1a = KSL_MUL(q1->z, q2->x), qo_1b = KSL_MUL(q1->x, q2->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->y, q2->w), qo_1e = qo_1c + qo_1d, qo_1f = KSL_MUL(q1->w, q2->y),
      qo_1 = qo_1e + qo_1f;
  const double qo_2a = KSL_MUL(q1->x, q2->y), qo_2b = KSL_MUL(q1->y, q2->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->z, q2->w), qo_2e = qo_2c + qo_2d, qo_2f = KSL_MUL(q1->w, q2->z),
      qo_2 = qo_2e + qo_2f;
  const double qo_3a = KSL_MUL(q1->w, q2->w), qo_3b = KSL_MUL(q1->x, q2->x),
      qo_3c = KSL_MUL(q1->y, q2->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MUL(q1->z, q2->z),
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

/* qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjq_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->w, q2->x), qo_0b = KSL_MUL(q1->x, q2->w), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0e = KSL_MUL(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1b = KSL_MUL(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->w, q2->y), qo_1e = KSL_MUL(q1->y, q2->w), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2b = KSL_MUL(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->w, q2->z), qo_2e = KSL_MUL(q1->z, q2->w), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3b = KSL_MUL(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MUL(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
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

/* qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconj_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->x, q2->w), qo_0b = KSL_MUL(q1->w, q2->x), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0e = KSL_MUL(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1b = KSL_MUL(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->y, q2->w), qo_1e = KSL_MUL(q1->w, q2->y), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2b = KSL_MUL(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->z, q2->w), qo_2e = KSL_MUL(q1->w, q2->z), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3b = KSL_MUL(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MUL(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
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

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
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
static inline void ksl_product_qconjv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
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

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf or
     NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->x, q2->w), qo_0b = KSL_MULF(q1->y, q2->z),
      qo_0c = KSL_MULF(q1->z, q2->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MULF(q1->w, q2->x), qo_0 = qo_0e + qo_0f;
  const float qo_1a = KSL_MULF(q1->z, q2->x), qo_1b = KSL_MULF(q1->x, q2->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->y, q2->w), qo_1e = qo_1c + qo_1d, qo_1f = KSL_MULF(q1->w, q2->y),
      qo_1 = qo_1e + qo_1f;
  const float qo_2a = KSL_MULF(q1->x, q2->y), qo_2b = KSL_MULF(q1->y, q2->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->z, q2->w), qo_2e = qo_2c + qo_2d, qo_2f = KSL_MULF(q1->w, q2->z),
      qo_2 = qo_2e + qo_2f;
  const float qo_3a = KSL_MULF(q1->w, q2->w), qo_3b = KSL_MULF(q1->x, q2->x),
      qo_3c = KSL_MULF(q1->y, q2->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MULF(q1->z, q2->z),
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

/* qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->w, q2->x), qo_0b = KSL_MULF(q1->x, q2->w), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0e = KSL_MULF(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1b = KSL_MULF(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->w, q2->y), qo_1e = KSL_MULF(q1->y, q2->w), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2b = KSL_MULF(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->w, q2->z), qo_2e = KSL_MULF(q1->z, q2->w), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3b = KSL_MULF(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MULF(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
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

/* qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconjf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->x, q2->w), qo_0b = KSL_MULF(q1->w, q2->x), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0e = KSL_MULF(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1b = KSL_MULF(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->y, q2->w), qo_1e = KSL_MULF(q1->w, q2->y), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2b = KSL_MULF(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->z, q2->w), qo_2e = KSL_MULF(q1->w, q2->z), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3b = KSL_MULF(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MULF(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
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

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
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
static inline void ksl_product_qconjvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
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

#endif
