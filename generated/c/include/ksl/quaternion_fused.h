/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
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

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qq_fused(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0b = KSL_MUL(q1->y, q2->z), qo_0d = fma(-q1->z, q2->y, qo_0b),
      qo_0e = fma(q1->x, q2->w, qo_0d), qo_0 = fma(q1->w, q2->x, qo_0e);
  const double qo_1a = KSL_MUL(q1->z, q2->x), qo_1c = fma(-q1->x, q2->z, qo_1a),
      qo_1e = fma(q1->y, q2->w, qo_1c), qo_1 = fma(q1->w, q2->y, qo_1e);
  const double qo_2a = KSL_MUL(q1->x, q2->y), qo_2c = fma(-q1->y, q2->x, qo_2a),
      qo_2e = fma(q1->z, q2->w, qo_2c), qo_2 = fma(q1->w, q2->z, qo_2e);
  const double qo_3b = KSL_MUL(q1->x, q2->x), qo_3d = fma(q1->y, q2->y, qo_3b),
      qo_3f = fma(q1->z, q2->z, qo_3d), qo_3 = fma(q1->w, q2->w, -qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjq_fused(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1->w, q2->x), qo_0c = fma(-q1->x, q2->w, qo_0a),
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0f = fma(-q1->y, q2->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1c = fma(-q1->z, q2->x, qo_1a),
      qo_1d = KSL_MUL(q1->w, q2->y), qo_1f = fma(-q1->y, q2->w, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2c = fma(-q1->x, q2->y, qo_2a),
      qo_2d = KSL_MUL(q1->w, q2->z), qo_2f = fma(-q1->z, q2->w, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3c = fma(q1->y, q2->y, qo_3a),
      qo_3e = fma(q1->z, q2->z, qo_3c), qo_3 = fma(q1->w, q2->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconj_fused(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1->x, q2->w), qo_0c = fma(-q1->w, q2->x, qo_0a),
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0f = fma(-q1->y, q2->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1c = fma(-q1->z, q2->x, qo_1a),
      qo_1d = KSL_MUL(q1->y, q2->w), qo_1f = fma(-q1->w, q2->y, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2c = fma(-q1->x, q2->y, qo_2a),
      qo_2d = KSL_MUL(q1->z, q2->w), qo_2f = fma(-q1->w, q2->z, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3c = fma(q1->y, q2->y, qo_3a),
      qo_3e = fma(q1->z, q2->z, qo_3c), qo_3 = fma(q1->w, q2->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qv_fused(const ksl_quaternion_t *q, const ksl_vec3_t *v,
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
static inline void ksl_product_qconjv_fused(const ksl_quaternion_t *q, const ksl_vec3_t *v,
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

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 12 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqf_fused(const ksl_quaternionf_t *q1, const ksl_quaternionf_t *q2,
    ksl_quaternionf_t *qo) {
  const float qo_0b = KSL_MULF(q1->y, q2->z), qo_0d = fmaf(-q1->z, q2->y, qo_0b),
      qo_0e = fmaf(q1->x, q2->w, qo_0d), qo_0 = fmaf(q1->w, q2->x, qo_0e);
  const float qo_1a = KSL_MULF(q1->z, q2->x), qo_1c = fmaf(-q1->x, q2->z, qo_1a),
      qo_1e = fmaf(q1->y, q2->w, qo_1c), qo_1 = fmaf(q1->w, q2->y, qo_1e);
  const float qo_2a = KSL_MULF(q1->x, q2->y), qo_2c = fmaf(-q1->y, q2->x, qo_2a),
      qo_2e = fmaf(q1->z, q2->w, qo_2c), qo_2 = fmaf(q1->w, q2->z, qo_2e);
  const float qo_3b = KSL_MULF(q1->x, q2->x), qo_3d = fmaf(q1->y, q2->y, qo_3b),
      qo_3f = fmaf(q1->z, q2->z, qo_3d), qo_3 = fmaf(q1->w, q2->w, -qo_3f);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjqf_fused(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(q1->w, q2->x), qo_0c = fmaf(-q1->x, q2->w, qo_0a),
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0f = fmaf(-q1->y, q2->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1c = fmaf(-q1->z, q2->x, qo_1a),
      qo_1d = KSL_MULF(q1->w, q2->y), qo_1f = fmaf(-q1->y, q2->w, qo_1d), qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2c = fmaf(-q1->x, q2->y, qo_2a),
      qo_2d = KSL_MULF(q1->w, q2->z), qo_2f = fmaf(-q1->z, q2->w, qo_2d), qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3c = fmaf(q1->y, q2->y, qo_3a),
      qo_3e = fmaf(q1->z, q2->z, qo_3c), qo_3 = fmaf(q1->w, q2->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   7 mul, 3 add, 9 fma.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconjf_fused(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const float qo_0a = KSL_MULF(q1->x, q2->w), qo_0c = fmaf(-q1->w, q2->x, qo_0a),
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0f = fmaf(-q1->y, q2->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1c = fmaf(-q1->z, q2->x, qo_1a),
      qo_1d = KSL_MULF(q1->y, q2->w), qo_1f = fmaf(-q1->w, q2->y, qo_1d), qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2c = fmaf(-q1->x, q2->y, qo_2a),
      qo_2d = KSL_MULF(q1->z, q2->w), qo_2f = fmaf(-q1->w, q2->z, qo_2d), qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3c = fmaf(q1->y, q2->y, qo_3a),
      qo_3e = fmaf(q1->z, q2->z, qo_3c), qo_3 = fmaf(q1->w, q2->w, qo_3e);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   9 mul, 3 add, 9 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qvf_fused(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
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
static inline void ksl_product_qconjvf_fused(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
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

#endif
