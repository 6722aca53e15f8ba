/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Fused tier: products fused into sums. */
#ifndef KSL_QUATERNION_FUSED_H
#define KSL_QUATERNION_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternion_scale_fused(ksl_quaternion_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_qq_fused(const double a, const ksl_quaternion_t *x,
    ksl_quaternion_t *y) {
  const double y_0_new = fma(a, x->x, y->x);
  const double y_1_new = fma(a, x->y, y->y);
  const double y_2_new = fma(a, x->z, y->z);
  const double y_3_new = fma(a, x->w, y->w);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qv_fused(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = KSL_MUL(q->y, v->z), c_0 = fma(-q->z, v->y, c_0a);
  const double c_1a = KSL_MUL(q->z, v->x), c_1 = fma(-q->x, v->z, c_1a);
  const double c_2a = KSL_MUL(q->x, v->y), c_2 = fma(-q->y, v->x, c_2a);
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->y, t_2), turn_0c = fma(-q->z, t_1, turn_0a),
      turn_0 = fma(q->w, t_0, turn_0c);
  const double turn_1a = KSL_MUL(q->z, t_0), turn_1c = fma(-q->x, t_2, turn_1a),
      turn_1 = fma(q->w, t_1, turn_1c);
  const double turn_2a = KSL_MUL(q->x, t_1), turn_2c = fma(-q->y, t_0, turn_2a),
      turn_2 = fma(q->w, t_2, turn_2c);
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qconjv_fused(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = KSL_MUL(q->z, v->y), c_0 = fma(-q->y, v->z, c_0a);
  const double c_1a = KSL_MUL(q->x, v->z), c_1 = fma(-q->z, v->x, c_1a);
  const double c_2a = KSL_MUL(q->y, v->x), c_2 = fma(-q->x, v->y, c_2a);
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->z, t_1), turn_0c = fma(-q->y, t_2, turn_0a),
      turn_0 = fma(q->w, t_0, turn_0c);
  const double turn_1a = KSL_MUL(q->x, t_2), turn_1c = fma(-q->z, t_0, turn_1a),
      turn_1 = fma(q->w, t_1, turn_1c);
  const double turn_2a = KSL_MUL(q->y, t_0), turn_2c = fma(-q->x, t_1, turn_2a),
      turn_2 = fma(q->w, t_2, turn_2c);
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma, 1 neg.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qq_fused(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0b = KSL_MUL(q1i->y, q2i->z), qo_0d = fma(-q1i->z, q2i->y, qo_0b),
      qo_0e = fma(q1i->x, q2i->w, qo_0d), qo_0 = fma(q1i->w, q2i->x, qo_0e);
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1c = fma(-q1i->x, q2i->z, qo_1a),
      qo_1e = fma(q1i->y, q2i->w, qo_1c), qo_1 = fma(q1i->w, q2i->y, qo_1e);
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2c = fma(-q1i->y, q2i->x, qo_2a),
      qo_2e = fma(q1i->z, q2i->w, qo_2c), qo_2 = fma(q1i->w, q2i->z, qo_2e);
  const double qo_3b = KSL_MUL(q1i->x, q2i->x), qo_3d_lead = -qo_3b,
      qo_3d = fma(-q1i->y, q2i->y, qo_3d_lead), qo_3f = fma(-q1i->z, q2i->z, qo_3d),
      qo_3 = fma(q1i->w, q2i->w, qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qqconj_fused(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0c = fma(-q1i->w, q2i->x, qo_0a),
      qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0f = fma(-q1i->y, q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1c = fma(-q1i->z, q2i->x, qo_1a),
      qo_1d = KSL_MUL(q1i->y, q2i->w), qo_1f = fma(-q1i->w, q2i->y, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2c = fma(-q1i->x, q2i->y, qo_2a),
      qo_2d = KSL_MUL(q1i->z, q2i->w), qo_2f = fma(-q1i->w, q2i->z, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3c = fma(q1i->y, q2i->y, qo_3a),
      qo_3e = fma(q1i->z, q2i->z, qo_3c), qo_3 = fma(q1i->w, q2i->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qconjq_fused(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->w, q2i->x), qo_0c = fma(-q1i->x, q2i->w, qo_0a),
      qo_0d = KSL_MUL(q1i->z, q2i->y), qo_0f = fma(-q1i->y, q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1c = fma(-q1i->z, q2i->x, qo_1a),
      qo_1d = KSL_MUL(q1i->w, q2i->y), qo_1f = fma(-q1i->y, q2i->w, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2c = fma(-q1i->x, q2i->y, qo_2a),
      qo_2d = KSL_MUL(q1i->w, q2i->z), qo_2f = fma(-q1i->z, q2i->w, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3c = fma(q1i->y, q2i->y, qo_3a),
      qo_3e = fma(q1i->z, q2i->z, qo_3c), qo_3 = fma(q1i->w, q2i->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma, 1 neg.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqconj_fused(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->y, q2i->z), qo_0c = fma(-q1i->z, q2i->y, qo_0a),
      qo_0e = fma(-q1i->x, q2i->w, qo_0c), qo_0 = fma(-q1i->w, q2i->x, qo_0e);
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1c = fma(-q1i->x, q2i->z, qo_1a),
      qo_1e = fma(-q1i->y, q2i->w, qo_1c), qo_1 = fma(-q1i->w, q2i->y, qo_1e);
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2c = fma(-q1i->y, q2i->x, qo_2a),
      qo_2e = fma(-q1i->z, q2i->w, qo_2c), qo_2 = fma(-q1i->w, q2i->z, qo_2e);
  const double qo_3b = KSL_MUL(q1i->x, q2i->x), qo_3d_lead = -qo_3b,
      qo_3d = fma(-q1i->y, q2i->y, qo_3d_lead), qo_3f = fma(-q1i->z, q2i->z, qo_3d),
      qo_3 = fma(q1i->w, q2i->w, qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0 = fma(dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1 = fma(-dci[0], qi->z, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2 = fma(dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->x, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0 = fma(-dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1 = fma(-dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2c_lead = -qo_2a,
      qo_2 = fma(-dci[1], qi->z, qo_2c_lead);
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0 = fma(-dci[0], qi->w, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1 = fma(dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2 = fma(-dci[0], qi->y, qo_2a);
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0c_lead = -qo_0a,
      qo_0 = fma(-dci[1], qi->x, qo_0c_lead);
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1c_lead = -qo_1a,
      qo_1 = fma(-dci[1], qi->y, qo_1c_lead);
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2 = fma(-dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->x, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqx_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(qi->w, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1 = fma(qi->z, dci[0], qo_1a);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2 = fma(-qi->y, dci[0], qo_2a);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->x, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqxconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(-qi->w, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1 = fma(-qi->z, dci[0], qo_1a);
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2 = fma(qi->z, dci[1], qo_2a);
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqx_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->w, dci[0]), qo_0 = fma(-qi->x, dci[1], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1c_lead = -qo_1a,
      qo_1 = fma(-qi->z, dci[0], qo_1c_lead);
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2 = fma(-qi->z, dci[1], qo_2a);
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqxconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fma(-qi->w, dci[0], qo_0c_lead);
  const double qo_1a = KSL_MUL(qi->z, dci[0]), qo_1 = fma(-qi->y, dci[1], qo_1a);
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2c_lead = -qo_2a,
      qo_2 = fma(-qi->z, dci[1], qo_2c_lead);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->x, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0 = fma(dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1 = fma(dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2 = fma(-dci[0], qi->x, qo_2a);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->y, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0c_lead = -qo_0a,
      qo_0 = fma(-dci[1], qi->x, qo_0c_lead);
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1 = fma(-dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2 = fma(-dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0 = fma(-dci[0], qi->z, qo_0a);
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1 = fma(-dci[0], qi->w, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2 = fma(dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0 = fma(-dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1c_lead = -qo_1a,
      qo_1 = fma(-dci[1], qi->y, qo_1c_lead);
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2c_lead = -qo_2a,
      qo_2 = fma(-dci[1], qi->z, qo_2c_lead);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->y, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqy_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(-qi->z, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1 = fma(qi->w, dci[0], qo_1a);
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2 = fma(qi->z, dci[1], qo_2a);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->y, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqyconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(qi->z, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1 = fma(-qi->w, dci[0], qo_1a);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2 = fma(-qi->x, dci[0], qo_2a);
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqy_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->z, dci[0]), qo_0 = fma(-qi->x, dci[1], qo_0a);
  const double qo_1a = KSL_MUL(qi->w, dci[0]), qo_1 = fma(-qi->y, dci[1], qo_1a);
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2c_lead = -qo_2a,
      qo_2 = fma(-qi->z, dci[1], qo_2c_lead);
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqyconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fma(-qi->z, dci[0], qo_0c_lead);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1c_lead = -qo_1a,
      qo_1 = fma(-qi->w, dci[0], qo_1c_lead);
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2 = fma(-qi->z, dci[1], qo_2a);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->y, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0 = fma(-dci[0], qi->y, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1 = fma(dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2 = fma(dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->z, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0 = fma(-dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1c_lead = -qo_1a,
      qo_1 = fma(-dci[1], qi->y, qo_1c_lead);
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2 = fma(-dci[1], qi->z, qo_2a);
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjq_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0 = fma(dci[1], qi->x, qo_0a);
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1 = fma(-dci[0], qi->x, qo_1a);
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2 = fma(-dci[0], qi->w, qo_2a);
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3 = fma(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjqconj_fused(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0c_lead = -qo_0a,
      qo_0 = fma(-dci[1], qi->x, qo_0c_lead);
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1 = fma(-dci[1], qi->y, qo_1a);
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2c_lead = -qo_2a,
      qo_2 = fma(-dci[1], qi->z, qo_2c_lead);
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3 = fma(-dci[0], qi->z, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqz_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(qi->y, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1 = fma(-qi->x, dci[0], qo_1a);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2 = fma(qi->w, dci[0], qo_2a);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->z, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqzconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0 = fma(-qi->y, dci[0], qo_0a);
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1 = fma(qi->y, dci[1], qo_1a);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2 = fma(-qi->w, dci[0], qo_2a);
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqz_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fma(-qi->y, dci[0], qo_0c_lead);
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1 = fma(-qi->y, dci[1], qo_1a);
  const double qo_2a = KSL_MUL(qi->w, dci[0]), qo_2 = fma(-qi->z, dci[1], qo_2a);
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3 = fma(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqzconj_fused(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->y, dci[0]), qo_0 = fma(-qi->x, dci[1], qo_0a);
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1c_lead = -qo_1a,
      qo_1 = fma(-qi->y, dci[1], qo_1c_lead);
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2c_lead = -qo_2a,
      qo_2 = fma(-qi->w, dci[0], qo_2c_lead);
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3 = fma(-qi->z, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   4 mul, 8 fma, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qv_fused(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->y, vi->z), qo_0c = fma(-qi->z, vi->y, qo_0a),
      qo_0 = fma(qi->w, vi->x, qo_0c);
  const double qo_1a = KSL_MUL(qi->z, vi->x), qo_1c = fma(-qi->x, vi->z, qo_1a),
      qo_1 = fma(qi->w, vi->y, qo_1c);
  const double qo_2a = KSL_MUL(qi->x, vi->y), qo_2c = fma(-qi->y, vi->x, qo_2a),
      qo_2 = fma(qi->w, vi->z, qo_2c);
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3c_lead = -qo_3a,
      qo_3c = fma(-qi->y, vi->y, qo_3c_lead), qo_3 = fma(-qi->z, vi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   4 mul, 8 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjv_fused(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->z, vi->y), qo_0c = fma(-qi->y, vi->z, qo_0a),
      qo_0 = fma(qi->w, vi->x, qo_0c);
  const double qo_1a = KSL_MUL(qi->x, vi->z), qo_1c = fma(-qi->z, vi->x, qo_1a),
      qo_1 = fma(qi->w, vi->y, qo_1c);
  const double qo_2a = KSL_MUL(qi->y, vi->x), qo_2c = fma(-qi->x, vi->y, qo_2a),
      qo_2 = fma(qi->w, vi->z, qo_2c);
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3c = fma(qi->y, vi->y, qo_3a),
      qo_3 = fma(qi->z, vi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 8 fma, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_vq_fused(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0b = KSL_MUL(vi->y, qi->z), qo_0d = fma(-vi->z, qi->y, qo_0b),
      qo_0 = fma(vi->x, qi->w, qo_0d);
  const double qo_1a = KSL_MUL(vi->z, qi->x), qo_1c = fma(-vi->x, qi->z, qo_1a),
      qo_1 = fma(vi->y, qi->w, qo_1c);
  const double qo_2a = KSL_MUL(vi->x, qi->y), qo_2c = fma(-vi->y, qi->x, qo_2a),
      qo_2 = fma(vi->z, qi->w, qo_2c);
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3c_lead = -qo_3a,
      qo_3c = fma(-vi->y, qi->y, qo_3c_lead), qo_3 = fma(-vi->z, qi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 8 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_vqconj_fused(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0b = KSL_MUL(vi->z, qi->y), qo_0d = fma(-vi->y, qi->z, qo_0b),
      qo_0 = fma(vi->x, qi->w, qo_0d);
  const double qo_1a = KSL_MUL(vi->x, qi->z), qo_1c = fma(-vi->z, qi->x, qo_1a),
      qo_1 = fma(vi->y, qi->w, qo_1c);
  const double qo_2a = KSL_MUL(vi->y, qi->x), qo_2c = fma(-vi->x, qi->y, qo_2a),
      qo_2 = fma(vi->z, qi->w, qo_2c);
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3c = fma(vi->y, qi->y, qo_3a),
      qo_3 = fma(vi->z, qi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   1 mul, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_qq_fused(const ksl_quaternion_t *q1i, const ksl_quaternion_t *q2i) {
  const double dot_a = KSL_MUL(q1i->x, q2i->x), dot_c = fma(q1i->y, q2i->y, dot_a),
      dot_e = fma(q1i->z, q2i->z, dot_c), dot = fma(q1i->w, q2i->w, dot_e);
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   7 mul, 4 add, 8 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_add_dpiToq_fused(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->x), qi_0_new_c = KSL_MUL(0.5, dpi->z),
      qi_0_new_d = KSL_MUL(qi_0_new_c, qi->y), qi_0_new_e = KSL_MUL(0.5, dpi->y),
      qi_0_new_g = fma(-qi_0_new_e, qi->z, qi_0_new_d),
      qi_0_new_h = fma(qi_0_new_a, qi->w, qi_0_new_g), qi_0_new = qi_0_new_h + qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_a, qi->z),
      qi_1_new_c = fma(-qi_0_new_c, qi->x, qi_1_new_a),
      qi_1_new_e = fma(qi_0_new_e, qi->w, qi_1_new_c), qi_1_new = qi_1_new_e + qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_e, qi->x),
      qi_2_new_c = fma(-qi_0_new_a, qi->y, qi_2_new_a),
      qi_2_new_e = fma(qi_0_new_c, qi->w, qi_2_new_c), qi_2_new = qi_2_new_e + qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_a, qi->x),
      qi_3_new_c = fma(qi_0_new_e, qi->y, qi_3_new_a),
      qi_3_new_e = fma(qi_0_new_c, qi->z, qi_3_new_c), qi_3_new = qi->w - qi_3_new_e;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   7 mul, 4 add, 8 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_subtract_dpiFromq_fused(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->y), qi_0_new_b = KSL_MUL(qi_0_new_a, qi->z),
      qi_0_new_c = KSL_MUL(0.5, dpi->z), qi_0_new_e = fma(-qi_0_new_c, qi->y, qi_0_new_b),
      qi_0_new_f = KSL_MUL(0.5, dpi->x), qi_0_new_h = fma(-qi_0_new_f, qi->w, qi_0_new_e),
      qi_0_new = qi_0_new_h + qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_c, qi->x),
      qi_1_new_c = fma(-qi_0_new_f, qi->z, qi_1_new_a),
      qi_1_new_e = fma(-qi_0_new_a, qi->w, qi_1_new_c), qi_1_new = qi_1_new_e + qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_f, qi->y),
      qi_2_new_c = fma(-qi_0_new_a, qi->x, qi_2_new_a),
      qi_2_new_e = fma(-qi_0_new_c, qi->w, qi_2_new_c), qi_2_new = qi_2_new_e + qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_f, qi->x),
      qi_3_new_c = fma(qi_0_new_a, qi->y, qi_3_new_a),
      qi_3_new_e = fma(qi_0_new_c, qi->z, qi_3_new_c), qi_3_new = qi_3_new_e + qi->w;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   7 mul, 16 fma, 1 neg.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_omega_to_dquaternion_fused(const ksl_vec3_t *w, const ksl_quaternion_t *qi,
    ksl_quaternion_t *dqo) {
  const double dqo_0a = KSL_MUL(0.5, w->x), dqo_0c = KSL_MUL(0.5, w->y),
      dqo_0d = KSL_MUL(dqo_0c, qi->z), dqo_0e = KSL_MUL(0.5, w->z),
      dqo_0g = fma(-dqo_0e, qi->y, dqo_0d), dqo_0h = fma(dqo_0a, qi->w, dqo_0g),
      dqo_0j = fma(-qi->x, qi->x, 1.0), dqo_0l = fma(-qi->y, qi->y, dqo_0j),
      dqo_0n = fma(-qi->z, qi->z, dqo_0l), dqo_0p = fma(-qi->w, qi->w, dqo_0n),
      dqo_0 = fma(qi->x, dqo_0p, dqo_0h);
  const double dqo_1a = KSL_MUL(dqo_0e, qi->x), dqo_1c = fma(-dqo_0a, qi->z, dqo_1a),
      dqo_1e = fma(dqo_0c, qi->w, dqo_1c), dqo_1 = fma(qi->y, dqo_0p, dqo_1e);
  const double dqo_2a = KSL_MUL(dqo_0a, qi->y), dqo_2c = fma(-dqo_0c, qi->x, dqo_2a),
      dqo_2e = fma(dqo_0e, qi->w, dqo_2c), dqo_2 = fma(qi->z, dqo_0p, dqo_2e);
  const double dqo_3b = KSL_MUL(dqo_0a, qi->x), dqo_3d_lead = -dqo_3b,
      dqo_3d = fma(-dqo_0c, qi->y, dqo_3d_lead), dqo_3f = fma(-dqo_0e, qi->z, dqo_3d),
      dqo_3 = fma(qi->w, dqo_0p, dqo_3f);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
}

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternionf_scale_fused(ksl_quaternionf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_qqf_fused(const float a, const ksl_quaternionf_t *x,
    ksl_quaternionf_t *y) {
  const float y_0_new = fmaf(a, x->x, y->x);
  const float y_1_new = fmaf(a, x->y, y->y);
  const float y_2_new = fmaf(a, x->z, y->z);
  const float y_3_new = fmaf(a, x->w, y->w);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qvf_fused(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0a = KSL_MULF(q->y, v->z), c_0 = fmaf(-q->z, v->y, c_0a);
  const float c_1a = KSL_MULF(q->z, v->x), c_1 = fmaf(-q->x, v->z, c_1a);
  const float c_2a = KSL_MULF(q->x, v->y), c_2 = fmaf(-q->y, v->x, c_2a);
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->y, t_2), turn_0c = fmaf(-q->z, t_1, turn_0a),
      turn_0 = fmaf(q->w, t_0, turn_0c);
  const float turn_1a = KSL_MULF(q->z, t_0), turn_1c = fmaf(-q->x, t_2, turn_1a),
      turn_1 = fmaf(q->w, t_1, turn_1c);
  const float turn_2a = KSL_MULF(q->x, t_1), turn_2c = fmaf(-q->y, t_0, turn_2a),
      turn_2 = fmaf(q->w, t_2, turn_2c);
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qconjvf_fused(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0a = KSL_MULF(q->z, v->y), c_0 = fmaf(-q->y, v->z, c_0a);
  const float c_1a = KSL_MULF(q->x, v->z), c_1 = fmaf(-q->z, v->x, c_1a);
  const float c_2a = KSL_MULF(q->y, v->x), c_2 = fmaf(-q->x, v->y, c_2a);
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->z, t_1), turn_0c = fmaf(-q->y, t_2, turn_0a),
      turn_0 = fmaf(q->w, t_0, turn_0c);
  const float turn_1a = KSL_MULF(q->x, t_2), turn_1c = fmaf(-q->z, t_0, turn_1a),
      turn_1 = fmaf(q->w, t_1, turn_1c);
  const float turn_2a = KSL_MULF(q->y, t_0), turn_2c = fmaf(-q->x, t_1, turn_2a),
      turn_2 = fmaf(q->w, t_2, turn_2c);
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma, 1 neg.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqf_fused(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float qo_0b = KSL_MULF(q1i->y, q2i->z), qo_0d = fmaf(-q1i->z, q2i->y, qo_0b),
      qo_0e = fmaf(q1i->x, q2i->w, qo_0d), qo_0 = fmaf(q1i->w, q2i->x, qo_0e);
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1c = fmaf(-q1i->x, q2i->z, qo_1a),
      qo_1e = fmaf(q1i->y, q2i->w, qo_1c), qo_1 = fmaf(q1i->w, q2i->y, qo_1e);
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2c = fmaf(-q1i->y, q2i->x, qo_2a),
      qo_2e = fmaf(q1i->z, q2i->w, qo_2c), qo_2 = fmaf(q1i->w, q2i->z, qo_2e);
  const float qo_3b = KSL_MULF(q1i->x, q2i->x), qo_3d_lead = -qo_3b,
      qo_3d = fmaf(-q1i->y, q2i->y, qo_3d_lead), qo_3f = fmaf(-q1i->z, q2i->z, qo_3d),
      qo_3 = fmaf(q1i->w, q2i->w, qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconjf_fused(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(q1i->x, q2i->w), qo_0c = fmaf(-q1i->w, q2i->x, qo_0a),
      qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0f = fmaf(-q1i->y, q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1c = fmaf(-q1i->z, q2i->x, qo_1a),
      qo_1d = KSL_MULF(q1i->y, q2i->w), qo_1f = fmaf(-q1i->w, q2i->y, qo_1d), qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2c = fmaf(-q1i->x, q2i->y, qo_2a),
      qo_2d = KSL_MULF(q1i->z, q2i->w), qo_2f = fmaf(-q1i->w, q2i->z, qo_2d), qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3c = fmaf(q1i->y, q2i->y, qo_3a),
      qo_3e = fmaf(q1i->z, q2i->z, qo_3c), qo_3 = fmaf(q1i->w, q2i->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjqf_fused(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(q1i->w, q2i->x), qo_0c = fmaf(-q1i->x, q2i->w, qo_0a),
      qo_0d = KSL_MULF(q1i->z, q2i->y), qo_0f = fmaf(-q1i->y, q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1i->x, q2i->z), qo_1c = fmaf(-q1i->z, q2i->x, qo_1a),
      qo_1d = KSL_MULF(q1i->w, q2i->y), qo_1f = fmaf(-q1i->y, q2i->w, qo_1d), qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1i->y, q2i->x), qo_2c = fmaf(-q1i->x, q2i->y, qo_2a),
      qo_2d = KSL_MULF(q1i->w, q2i->z), qo_2f = fmaf(-q1i->z, q2i->w, qo_2d), qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1i->x, q2i->x), qo_3c = fmaf(q1i->y, q2i->y, qo_3a),
      qo_3e = fmaf(q1i->z, q2i->z, qo_3c), qo_3 = fmaf(q1i->w, q2i->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma, 1 neg.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqconjf_fused(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(q1i->y, q2i->z), qo_0c = fmaf(-q1i->z, q2i->y, qo_0a),
      qo_0e = fmaf(-q1i->x, q2i->w, qo_0c), qo_0 = fmaf(-q1i->w, q2i->x, qo_0e);
  const float qo_1a = KSL_MULF(q1i->z, q2i->x), qo_1c = fmaf(-q1i->x, q2i->z, qo_1a),
      qo_1e = fmaf(-q1i->y, q2i->w, qo_1c), qo_1 = fmaf(-q1i->w, q2i->y, qo_1e);
  const float qo_2a = KSL_MULF(q1i->x, q2i->y), qo_2c = fmaf(-q1i->y, q2i->x, qo_2a),
      qo_2e = fmaf(-q1i->z, q2i->w, qo_2c), qo_2 = fmaf(-q1i->w, q2i->z, qo_2e);
  const float qo_3b = KSL_MULF(q1i->x, q2i->x), qo_3d_lead = -qo_3b,
      qo_3d = fmaf(-q1i->y, q2i->y, qo_3d_lead), qo_3f = fmaf(-q1i->z, q2i->z, qo_3d),
      qo_3 = fmaf(q1i->w, q2i->w, qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0 = fmaf(dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1 = fmaf(-dci[0], qi->z, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2 = fmaf(dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->x, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0 = fmaf(-dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1 = fmaf(-dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-dci[1], qi->z, qo_2c_lead);
  const float qo_3a = KSL_MULF(dci[0], qi->x), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxconjqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0 = fmaf(-dci[0], qi->w, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1 = fmaf(dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2 = fmaf(-dci[0], qi->y, qo_2a);
  const float qo_3a = KSL_MULF(dci[0], qi->x), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxconjqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->w), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-dci[1], qi->x, qo_0c_lead);
  const float qo_1a = KSL_MULF(dci[0], qi->z), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-dci[1], qi->y, qo_1c_lead);
  const float qo_2a = KSL_MULF(dci[0], qi->y), qo_2 = fmaf(-dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->x, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqxf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(qi->w, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1 = fmaf(qi->z, dci[0], qo_1a);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2 = fmaf(-qi->y, dci[0], qo_2a);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->x, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqxconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(-qi->w, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1 = fmaf(-qi->z, dci[0], qo_1a);
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2 = fmaf(qi->z, dci[1], qo_2a);
  const float qo_3a = KSL_MULF(qi->x, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqxf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->w, dci[0]), qo_0 = fmaf(-qi->x, dci[1], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-qi->z, dci[0], qo_1c_lead);
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2 = fmaf(-qi->z, dci[1], qo_2a);
  const float qo_3a = KSL_MULF(qi->x, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqxconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-qi->w, dci[0], qo_0c_lead);
  const float qo_1a = KSL_MULF(qi->z, dci[0]), qo_1 = fmaf(-qi->y, dci[1], qo_1a);
  const float qo_2a = KSL_MULF(qi->y, dci[0]), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-qi->z, dci[1], qo_2c_lead);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->x, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0 = fmaf(dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1 = fmaf(dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2 = fmaf(-dci[0], qi->x, qo_2a);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->y, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-dci[1], qi->x, qo_0c_lead);
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1 = fmaf(-dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2 = fmaf(-dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[0], qi->y), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyconjqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0 = fmaf(-dci[0], qi->z, qo_0a);
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1 = fmaf(-dci[0], qi->w, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2 = fmaf(dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[0], qi->y), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyconjqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->z), qo_0 = fmaf(-dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->w), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-dci[1], qi->y, qo_1c_lead);
  const float qo_2a = KSL_MULF(dci[0], qi->x), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-dci[1], qi->z, qo_2c_lead);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->y, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqyf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(-qi->z, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1 = fmaf(qi->w, dci[0], qo_1a);
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2 = fmaf(qi->z, dci[1], qo_2a);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->y, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqyconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(qi->z, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1 = fmaf(-qi->w, dci[0], qo_1a);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2 = fmaf(-qi->x, dci[0], qo_2a);
  const float qo_3a = KSL_MULF(qi->y, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqyf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->z, dci[0]), qo_0 = fmaf(-qi->x, dci[1], qo_0a);
  const float qo_1a = KSL_MULF(qi->w, dci[0]), qo_1 = fmaf(-qi->y, dci[1], qo_1a);
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-qi->z, dci[1], qo_2c_lead);
  const float qo_3a = KSL_MULF(qi->y, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqyconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-qi->z, dci[0], qo_0c_lead);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-qi->w, dci[0], qo_1c_lead);
  const float qo_2a = KSL_MULF(qi->x, dci[0]), qo_2 = fmaf(-qi->z, dci[1], qo_2a);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->y, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[1], qi->x), qo_0 = fmaf(-dci[0], qi->y, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1 = fmaf(dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2 = fmaf(dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->z, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0 = fmaf(-dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-dci[1], qi->y, qo_1c_lead);
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2 = fmaf(-dci[1], qi->z, qo_2a);
  const float qo_3a = KSL_MULF(dci[0], qi->z), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzconjqf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0 = fmaf(dci[1], qi->x, qo_0a);
  const float qo_1a = KSL_MULF(dci[1], qi->y), qo_1 = fmaf(-dci[0], qi->x, qo_1a);
  const float qo_2a = KSL_MULF(dci[1], qi->z), qo_2 = fmaf(-dci[0], qi->w, qo_2a);
  const float qo_3a = KSL_MULF(dci[0], qi->z), qo_3 = fmaf(dci[1], qi->w, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzconjqconjf_fused(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(dci[0], qi->y), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-dci[1], qi->x, qo_0c_lead);
  const float qo_1a = KSL_MULF(dci[0], qi->x), qo_1 = fmaf(-dci[1], qi->y, qo_1a);
  const float qo_2a = KSL_MULF(dci[0], qi->w), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-dci[1], qi->z, qo_2c_lead);
  const float qo_3a = KSL_MULF(dci[1], qi->w), qo_3 = fmaf(-dci[0], qi->z, qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqzf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(qi->y, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->y, dci[1]), qo_1 = fmaf(-qi->x, dci[0], qo_1a);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2 = fmaf(qi->w, dci[0], qo_2a);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->z, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqzconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0 = fmaf(-qi->y, dci[0], qo_0a);
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1 = fmaf(qi->y, dci[1], qo_1a);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2 = fmaf(-qi->w, dci[0], qo_2a);
  const float qo_3a = KSL_MULF(qi->z, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqzf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->x, dci[1]), qo_0c_lead = -qo_0a,
      qo_0 = fmaf(-qi->y, dci[0], qo_0c_lead);
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1 = fmaf(-qi->y, dci[1], qo_1a);
  const float qo_2a = KSL_MULF(qi->w, dci[0]), qo_2 = fmaf(-qi->z, dci[1], qo_2a);
  const float qo_3a = KSL_MULF(qi->z, dci[0]), qo_3 = fmaf(qi->w, dci[1], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   4 mul, 4 fma, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqzconjf_fused(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->y, dci[0]), qo_0 = fmaf(-qi->x, dci[1], qo_0a);
  const float qo_1a = KSL_MULF(qi->x, dci[0]), qo_1c_lead = -qo_1a,
      qo_1 = fmaf(-qi->y, dci[1], qo_1c_lead);
  const float qo_2a = KSL_MULF(qi->z, dci[1]), qo_2c_lead = -qo_2a,
      qo_2 = fmaf(-qi->w, dci[0], qo_2c_lead);
  const float qo_3a = KSL_MULF(qi->w, dci[1]), qo_3 = fmaf(-qi->z, dci[0], qo_3a);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   4 mul, 8 fma, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qvf_fused(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->y, vi->z), qo_0c = fmaf(-qi->z, vi->y, qo_0a),
      qo_0 = fmaf(qi->w, vi->x, qo_0c);
  const float qo_1a = KSL_MULF(qi->z, vi->x), qo_1c = fmaf(-qi->x, vi->z, qo_1a),
      qo_1 = fmaf(qi->w, vi->y, qo_1c);
  const float qo_2a = KSL_MULF(qi->x, vi->y), qo_2c = fmaf(-qi->y, vi->x, qo_2a),
      qo_2 = fmaf(qi->w, vi->z, qo_2c);
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3c_lead = -qo_3a,
      qo_3c = fmaf(-qi->y, vi->y, qo_3c_lead), qo_3 = fmaf(-qi->z, vi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   4 mul, 8 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjvf_fused(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(qi->z, vi->y), qo_0c = fmaf(-qi->y, vi->z, qo_0a),
      qo_0 = fmaf(qi->w, vi->x, qo_0c);
  const float qo_1a = KSL_MULF(qi->x, vi->z), qo_1c = fmaf(-qi->z, vi->x, qo_1a),
      qo_1 = fmaf(qi->w, vi->y, qo_1c);
  const float qo_2a = KSL_MULF(qi->y, vi->x), qo_2c = fmaf(-qi->x, vi->y, qo_2a),
      qo_2 = fmaf(qi->w, vi->z, qo_2c);
  const float qo_3a = KSL_MULF(qi->x, vi->x), qo_3c = fmaf(qi->y, vi->y, qo_3a),
      qo_3 = fmaf(qi->z, vi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 8 fma, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_vqf_fused(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0b = KSL_MULF(vi->y, qi->z), qo_0d = fmaf(-vi->z, qi->y, qo_0b),
      qo_0 = fmaf(vi->x, qi->w, qo_0d);
  const float qo_1a = KSL_MULF(vi->z, qi->x), qo_1c = fmaf(-vi->x, qi->z, qo_1a),
      qo_1 = fmaf(vi->y, qi->w, qo_1c);
  const float qo_2a = KSL_MULF(vi->x, qi->y), qo_2c = fmaf(-vi->y, qi->x, qo_2a),
      qo_2 = fmaf(vi->z, qi->w, qo_2c);
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3c_lead = -qo_3a,
      qo_3c = fmaf(-vi->y, qi->y, qo_3c_lead), qo_3 = fmaf(-vi->z, qi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 8 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_vqconjf_fused(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0b = KSL_MULF(vi->z, qi->y), qo_0d = fmaf(-vi->y, qi->z, qo_0b),
      qo_0 = fmaf(vi->x, qi->w, qo_0d);
  const float qo_1a = KSL_MULF(vi->x, qi->z), qo_1c = fmaf(-vi->z, qi->x, qo_1a),
      qo_1 = fmaf(vi->y, qi->w, qo_1c);
  const float qo_2a = KSL_MULF(vi->y, qi->x), qo_2c = fmaf(-vi->x, qi->y, qo_2a),
      qo_2 = fmaf(vi->z, qi->w, qo_2c);
  const float qo_3a = KSL_MULF(vi->x, qi->x), qo_3c = fmaf(vi->y, qi->y, qo_3a),
      qo_3 = fmaf(vi->z, qi->z, qo_3c);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   1 mul, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_qqf_fused(const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i) {
  const float dot_a = KSL_MULF(q1i->x, q2i->x), dot_c = fmaf(q1i->y, q2i->y, dot_a),
      dot_e = fmaf(q1i->z, q2i->z, dot_c), dot = fmaf(q1i->w, q2i->w, dot_e);
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   7 mul, 4 add, 8 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_add_dpiToqf_fused(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->x), qi_0_new_c = KSL_MULF(0.5f, dpi->z),
      qi_0_new_d = KSL_MULF(qi_0_new_c, qi->y), qi_0_new_e = KSL_MULF(0.5f, dpi->y),
      qi_0_new_g = fmaf(-qi_0_new_e, qi->z, qi_0_new_d),
      qi_0_new_h = fmaf(qi_0_new_a, qi->w, qi_0_new_g), qi_0_new = qi_0_new_h + qi->x;
  const float qi_1_new_a = KSL_MULF(qi_0_new_a, qi->z),
      qi_1_new_c = fmaf(-qi_0_new_c, qi->x, qi_1_new_a),
      qi_1_new_e = fmaf(qi_0_new_e, qi->w, qi_1_new_c), qi_1_new = qi_1_new_e + qi->y;
  const float qi_2_new_a = KSL_MULF(qi_0_new_e, qi->x),
      qi_2_new_c = fmaf(-qi_0_new_a, qi->y, qi_2_new_a),
      qi_2_new_e = fmaf(qi_0_new_c, qi->w, qi_2_new_c), qi_2_new = qi_2_new_e + qi->z;
  const float qi_3_new_a = KSL_MULF(qi_0_new_a, qi->x),
      qi_3_new_c = fmaf(qi_0_new_e, qi->y, qi_3_new_a),
      qi_3_new_e = fmaf(qi_0_new_c, qi->z, qi_3_new_c), qi_3_new = qi->w - qi_3_new_e;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   7 mul, 4 add, 8 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_subtract_dpiFromqf_fused(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->y), qi_0_new_b = KSL_MULF(qi_0_new_a, qi->z),
      qi_0_new_c = KSL_MULF(0.5f, dpi->z), qi_0_new_e = fmaf(-qi_0_new_c, qi->y, qi_0_new_b),
      qi_0_new_f = KSL_MULF(0.5f, dpi->x), qi_0_new_h = fmaf(-qi_0_new_f, qi->w, qi_0_new_e),
      qi_0_new = qi_0_new_h + qi->x;
  const float qi_1_new_a = KSL_MULF(qi_0_new_c, qi->x),
      qi_1_new_c = fmaf(-qi_0_new_f, qi->z, qi_1_new_a),
      qi_1_new_e = fmaf(-qi_0_new_a, qi->w, qi_1_new_c), qi_1_new = qi_1_new_e + qi->y;
  const float qi_2_new_a = KSL_MULF(qi_0_new_f, qi->y),
      qi_2_new_c = fmaf(-qi_0_new_a, qi->x, qi_2_new_a),
      qi_2_new_e = fmaf(-qi_0_new_c, qi->w, qi_2_new_c), qi_2_new = qi_2_new_e + qi->z;
  const float qi_3_new_a = KSL_MULF(qi_0_new_f, qi->x),
      qi_3_new_c = fmaf(qi_0_new_a, qi->y, qi_3_new_a),
      qi_3_new_e = fmaf(qi_0_new_c, qi->z, qi_3_new_c), qi_3_new = qi_3_new_e + qi->w;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   7 mul, 16 fma, 1 neg.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_omega_to_dquaternionf_fused(const ksl_vec3f_t *w,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *dqo) {
  const float dqo_0a = KSL_MULF(0.5f, w->x), dqo_0c = KSL_MULF(0.5f, w->y),
      dqo_0d = KSL_MULF(dqo_0c, qi->z), dqo_0e = KSL_MULF(0.5f, w->z),
      dqo_0g = fmaf(-dqo_0e, qi->y, dqo_0d), dqo_0h = fmaf(dqo_0a, qi->w, dqo_0g),
      dqo_0j = fmaf(-qi->x, qi->x, 1.0f), dqo_0l = fmaf(-qi->y, qi->y, dqo_0j),
      dqo_0n = fmaf(-qi->z, qi->z, dqo_0l), dqo_0p = fmaf(-qi->w, qi->w, dqo_0n),
      dqo_0 = fmaf(qi->x, dqo_0p, dqo_0h);
  const float dqo_1a = KSL_MULF(dqo_0e, qi->x), dqo_1c = fmaf(-dqo_0a, qi->z, dqo_1a),
      dqo_1e = fmaf(dqo_0c, qi->w, dqo_1c), dqo_1 = fmaf(qi->y, dqo_0p, dqo_1e);
  const float dqo_2a = KSL_MULF(dqo_0a, qi->y), dqo_2c = fmaf(-dqo_0c, qi->x, dqo_2a),
      dqo_2e = fmaf(dqo_0e, qi->w, dqo_2c), dqo_2 = fmaf(qi->z, dqo_0p, dqo_2e);
  const float dqo_3b = KSL_MULF(dqo_0a, qi->x), dqo_3d_lead = -dqo_3b,
      dqo_3d = fmaf(-dqo_0c, qi->y, dqo_3d_lead), dqo_3f = fmaf(-dqo_0e, qi->z, dqo_3d),
      dqo_3 = fmaf(qi->w, dqo_0p, dqo_3f);
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
}

#endif
