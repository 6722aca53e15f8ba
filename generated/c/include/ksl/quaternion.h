/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation. */
#ifndef KSL_QUATERNION_H
#define KSL_QUATERNION_H

#include "ksl_types.h"
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
  const double self_0_new = self->x * a;
  const double self_1_new = self->y * a;
  const double self_2_new = self->z * a;
  const double self_3_new = self->w * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
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
  const double qo_0 = -q->x;
  const double qo_1 = -q->y;
  const double qo_2 = -q->z;
  const double q_w = q->w;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = q_w;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 3 add, 1 sqrt, 4 abs, 7 less, 7 select. */
static inline double ksl_quaternion_norm(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->x * s;
  const double y_1 = q->y * s;
  const double y_2 = q->z * s;
  const double y_3 = q->w * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternion_normalize(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_size_3 = fabs(self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = self->x * s;
  const double y_1 = self->y * s;
  const double y_2 = self->z * s;
  const double y_3 = self->w * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = self->x * up;
  const double enlarged_1 = self->y * up;
  const double enlarged_2 = self->z * up;
  const double enlarged_3 = self->w * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  const double self_3_new = quotient_3 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternion_normalized(const ksl_quaternion_t *q, ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->x * s;
  const double y_1 = q->y * s;
  const double y_2 = q->z * s;
  const double y_3 = q->w * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = q->x * up;
  const double enlarged_1 = q->y * up;
  const double enlarged_2 = q->z * up;
  const double enlarged_3 = q->w * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double qo_0 = quotient_0 * down;
  const double qo_1 = quotient_1 * down;
  const double qo_2 = quotient_2 * down;
  const double qo_3 = quotient_3 * down;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qq(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0a = q1->x * q2->w, qo_0b = q1->y * q2->z, qo_0c = q1->z * q2->y,
      qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d, qo_0f = q1->w * q2->x, qo_0 = qo_0e + qo_0f;
  const double qo_1a = q1->z * q2->x, qo_1b = q1->x * q2->z, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * q2->w, qo_1e = qo_1c + qo_1d, qo_1f = q1->w * q2->y, qo_1 = qo_1e + qo_1f;
  const double qo_2a = q1->x * q2->y, qo_2b = q1->y * q2->x, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * q2->w, qo_2e = qo_2c + qo_2d, qo_2f = q1->w * q2->z, qo_2 = qo_2e + qo_2f;
  const double qo_3a = q1->w * q2->w, qo_3b = q1->x * q2->x, qo_3c = q1->y * q2->y,
      qo_3d = qo_3b + qo_3c, qo_3e = q1->z * q2->z, qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjq(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->x, qo_0b = q1->x * q2->w, qo_0c = qo_0a - qo_0b,
      qo_0d = q1->z * q2->y, qo_0e = q1->y * q2->z, qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const double qo_1a = q1->x * q2->z, qo_1b = q1->z * q2->x, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->w * q2->y, qo_1e = q1->y * q2->w, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = q1->y * q2->x, qo_2b = q1->x * q2->y, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->w * q2->z, qo_2e = q1->z * q2->w, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = q1->x * q2->x, qo_3b = q1->y * q2->y, qo_3c = qo_3a + qo_3b,
      qo_3d = q1->z * q2->z, qo_3e = qo_3c + qo_3d, qo_3f = q1->w * q2->w, qo_3 = qo_3e + qo_3f;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconj(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0a = q1->x * q2->w, qo_0b = q1->w * q2->x, qo_0c = qo_0a - qo_0b,
      qo_0d = q1->z * q2->y, qo_0e = q1->y * q2->z, qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const double qo_1a = q1->x * q2->z, qo_1b = q1->z * q2->x, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * q2->w, qo_1e = q1->w * q2->y, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = q1->y * q2->x, qo_2b = q1->x * q2->y, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * q2->w, qo_2e = q1->w * q2->z, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = q1->x * q2->x, qo_3b = q1->y * q2->y, qo_3c = qo_3a + qo_3b,
      qo_3d = q1->z * q2->z, qo_3e = qo_3c + qo_3d, qo_3f = q1->w * q2->w, qo_3 = qo_3e + qo_3f;
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
static inline void ksl_product_qv(const ksl_quaternion_t *q, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double c_0a = q->y * v->z, c_0b = q->z * v->y, c_0 = c_0a - c_0b;
  const double c_1a = q->z * v->x, c_1b = q->x * v->z, c_1 = c_1a - c_1b;
  const double c_2a = q->x * v->y, c_2b = q->y * v->x, c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = q->y * t_2, turn_0b = q->z * t_1, turn_0c = turn_0a - turn_0b,
      turn_0d = q->w * t_0, turn_0 = turn_0c + turn_0d;
  const double turn_1a = q->z * t_0, turn_1b = q->x * t_2, turn_1c = turn_1a - turn_1b,
      turn_1d = q->w * t_1, turn_1 = turn_1c + turn_1d;
  const double turn_2a = q->x * t_1, turn_2b = q->y * t_0, turn_2c = turn_2a - turn_2b,
      turn_2d = q->w * t_2, turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjv(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = q->z * v->y, c_0b = q->y * v->z, c_0 = c_0a - c_0b;
  const double c_1a = q->x * v->z, c_1b = q->z * v->x, c_1 = c_1a - c_1b;
  const double c_2a = q->y * v->x, c_2b = q->x * v->y, c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = q->z * t_1, turn_0b = q->y * t_2, turn_0c = turn_0a - turn_0b,
      turn_0d = q->w * t_0, turn_0 = turn_0c + turn_0d;
  const double turn_1a = q->x * t_2, turn_1b = q->z * t_0, turn_1c = turn_1a - turn_1b,
      turn_1d = q->w * t_1, turn_1 = turn_1c + turn_1d;
  const double turn_2a = q->y * t_0, turn_2b = q->x * t_1, turn_2c = turn_2a - turn_2b,
      turn_2d = q->w * t_2, turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div.
   Error <= R: 5 u of its largest component; searched, not proved. */
static inline void ksl_mat3x3_from_quaternion(const ksl_quaternion_t *q, ksl_mat3x3_t *R) {
  const double squares_0 = q->w * q->w;
  const double squares_1 = q->x * q->x;
  const double squares_2 = q->y * q->y;
  const double squares_3 = q->z * q->z;
  const double pairs_0 = squares_0 + squares_1;
  const double pairs_1 = squares_2 + squares_3;
  const double pairs_2 = squares_0 + squares_2;
  const double pairs_3 = squares_1 + squares_3;
  const double pairs_4 = squares_0 + squares_3;
  const double pairs_5 = squares_1 + squares_2;
  const double square = pairs_0 + pairs_1;
  const double factor = 1.0 / square;
  const double d0 = pairs_0 - pairs_1;
  const double d1 = pairs_2 - pairs_3;
  const double d2 = pairs_4 - pairs_5;
  const double twice = 2.0 * factor;
  const double m_0a = q->x * q->y, m_0b = q->z * q->w, m_0 = m_0a - m_0b;
  const double m_1a = q->x * q->z, m_1b = q->y * q->w, m_1 = m_1a + m_1b;
  const double m_2a = q->y * q->z, m_2b = q->x * q->w, m_2 = m_2a - m_2b;
  const double m_3 = m_0a + m_0b;
  const double m_4 = m_1a - m_1b;
  const double m_5 = m_2b + m_2a;
  const double R_00 = factor * d0;
  const double R_01 = twice * m_0;
  const double R_02 = twice * m_1;
  const double R_10 = twice * m_3;
  const double R_11 = factor * d1;
  const double R_12 = twice * m_2;
  const double R_20 = twice * m_4;
  const double R_21 = twice * m_5;
  const double R_22 = factor * d2;
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

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.
   Error <= qo: 5 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_from_mat3x3(const ksl_mat3x3_t *R, ksl_quaternion_t *qo) {
  const double p_0 = R->m21 - R->m12;
  const double p_1 = R->m02 - R->m20;
  const double p_2 = R->m10 - R->m01;
  const double s_0 = R->m12 + R->m21;
  const double s_1 = R->m02 + R->m20;
  const double s_2 = R->m01 + R->m10;
  const double first_0 = R->m00 + 1.0;
  const double first_1 = 1.0 - R->m00;
  const double others_0 = R->m11 + R->m22;
  const double others_1 = R->m11 - R->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double length_a = upper_0 * upper_0, length_b = upper_1 * upper_1,
      length_c = length_a + length_b, length_d = upper_2 * upper_2, length_e = length_c + length_d,
      length_f = upper_3 * upper_3, length_g = length_e + length_f, length = sqrt(length_g);
  const double qo_0 = upper_0 / length;
  const double qo_1 = upper_1 / length;
  const double qo_2 = upper_2 / length;
  const double qo_3 = upper_3 / length;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 1 sin, 1 cos.
   Error <= qo: 3 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_from_axis_angle(const ksl_vec3_t *axis, const double angle,
    ksl_quaternion_t *qo) {
  const double half = 0.5 * angle;
  const double sine = sin(half);
  const double qo_0 = axis->x * sine;
  const double qo_1 = axis->y * sine;
  const double qo_2 = axis->z * sine;
  const double qo_3 = cos(half);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where
     nothing turns; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   8 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 12 select.
   Error <= angle: 5 u, axis: 4 u of its largest component; searched, not proved. */
static inline double ksl_axis_angle_from_quaternion(const ksl_quaternion_t *q, ksl_vec3_t *axis) {
  const double upper_0a = -q->x, upper_0 = q->w < 0.0 ? upper_0a : q->x;
  const double upper_1a = -q->y, upper_1 = q->w < 0.0 ? upper_1a : q->y;
  const double upper_2a = -q->z, upper_2 = q->w < 0.0 ? upper_2a : q->z;
  const double upper_3a = -q->w, upper_3 = q->w < 0.0 ? upper_3a : q->w;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor;
  const double unit_1 = v_y_1 / divisor;
  const double unit_2 = v_y_2 / divisor;
  const double angle = 2.0 * half;
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   34 mul, 27 add, 1 div, 1 sqrt, 1 sin, 1 cos, 1 less, 5 select.
   Error <= qo: 7 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_exp(const ksl_vec3_t *v, ksl_quaternion_t *qo) {
  const double h_0 = 0.5 * v->x;
  const double h_1 = 0.5 * v->y;
  const double h_2 = 0.5 * v->z;
  const double x_a = h_0 * h_0, x_b = h_1 * h_1, x_c = x_a + x_b, x_d = h_2 * h_2, x = x_c + x_d;
  const double size = sqrt(x);
  const double cosine_a = cos(size), cosine = x < 1.0 ? 1.0 : cosine_a;
  const double sine_a = sin(size), sine = x < 1.0 ? 1.0 : sine_a;
  const double divisor = x < 1.0 ? 2.0 : size;
  const double far_k = sine / divisor;
  const double k_a = 6.446950284384474e-26 * x, k_b = k_a - 3.868170170630684e-23, k_c = x * k_b,
      k_d = k_c + 1.9572941063391263e-20, k_e = x * k_d, k_f = k_e - 8.22063524662433e-18,
      k_g = x * k_f, k_h = k_g + 2.8114572543455206e-15, k_i = x * k_h,
      k_j = k_i - 7.647163731819816e-13, k_k = x * k_j, k_l = k_k + 1.6059043836821613e-10,
      k_m = x * k_l, k_n = k_m - 2.505210838544172e-08, k_o = x * k_n,
      k_p = k_o + 2.7557319223985893e-06, k_q = x * k_p, k_r = k_q - 0.0001984126984126984,
      k_s = x * k_r, k_t = k_s + 0.008333333333333333, k_u = x * k_t,
      k_v = k_u - 0.16666666666666666, k_w = x * k_v, k_x = k_w + 1.0, k = x < 1.0 ? k_x : far_k;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2 = g2w + 0.5;
  const double near_a = x * g2, near = 1.0 - near_a;
  const double qo_0 = h_0 * k;
  const double qo_1 = h_1 * k;
  const double qo_2 = h_2 * k;
  const double qo_3 = x < 1.0 ? near : cosine;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   11 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 11 select.
   Error <= vo: 5 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_log(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double upper_0a = -q->x, upper_0 = q->w < 0.0 ? upper_0a : q->x;
  const double upper_1a = -q->y, upper_1 = q->w < 0.0 ? upper_1a : q->y;
  const double upper_2a = -q->z, upper_2 = q->w < 0.0 ? upper_2a : q->z;
  const double upper_3a = -q->w, upper_3 = q->w < 0.0 ? upper_3a : q->w;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = 2.0 * half;
  const double k = theta / divisor;
  const double vector_0 = upper_0 * k;
  const double vector_1 = upper_1 * k;
  const double vector_2 = upper_2 * k;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   76 mul, 53 add, 2 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 4 neg, 3 abs, 8 less, 1 equal, 16
     select.
   Error <= qo: 12 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_slerp(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    const double k, ksl_quaternion_t *qo) {
  const double between_0a = q1->w * q2->x, between_0b = q1->x * q2->w,
      between_0c = between_0a - between_0b, between_0d = q1->z * q2->y, between_0e = q1->y * q2->z,
      between_0f = between_0d - between_0e, between_0 = between_0c + between_0f;
  const double between_1a = q1->x * q2->z, between_1b = q1->z * q2->x,
      between_1c = between_1a - between_1b, between_1d = q1->w * q2->y, between_1e = q1->y * q2->w,
      between_1f = between_1d - between_1e, between_1 = between_1c + between_1f;
  const double between_2a = q1->y * q2->x, between_2b = q1->x * q2->y,
      between_2c = between_2a - between_2b, between_2d = q1->w * q2->z, between_2e = q1->z * q2->w,
      between_2f = between_2d - between_2e, between_2 = between_2c + between_2f;
  const double between_3a = q1->x * q2->x, between_3b = q1->y * q2->y,
      between_3c = between_3a + between_3b, between_3d = q1->z * q2->z,
      between_3e = between_3c + between_3d, between_3f = q1->w * q2->w,
      between_3 = between_3e + between_3f;
  const double upper_0a = -between_0, upper_0 = between_3 < 0.0 ? upper_0a : between_0;
  const double upper_1a = -between_1, upper_1 = between_3 < 0.0 ? upper_1a : between_1;
  const double upper_2a = -between_2, upper_2 = between_3 < 0.0 ? upper_2a : between_2;
  const double upper_3a = -between_3, upper_3 = between_3 < 0.0 ? upper_3a : between_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double rate = half / divisor;
  const double kv_0 = k * upper_0;
  const double kv_1 = k * upper_1;
  const double kv_2 = k * upper_2;
  const double step_0 = rate * kv_0;
  const double step_1 = rate * kv_1;
  const double step_2 = rate * kv_2;
  const double exp_x_a = step_0 * step_0, exp_x_b = step_1 * step_1, exp_x_c = exp_x_a + exp_x_b,
      exp_x_d = step_2 * step_2, exp_x = exp_x_c + exp_x_d;
  const double exp_size = sqrt(exp_x);
  const double exp_cosine_a = cos(exp_size), exp_cosine = exp_x < 1.0 ? 1.0 : exp_cosine_a;
  const double exp_sine_a = sin(exp_size), exp_sine = exp_x < 1.0 ? 1.0 : exp_sine_a;
  const double exp_divisor = exp_x < 1.0 ? 2.0 : exp_size;
  const double exp_far_k = exp_sine / exp_divisor;
  const double exp_k_a = 6.446950284384474e-26 * exp_x, exp_k_b = exp_k_a - 3.868170170630684e-23,
      exp_k_c = exp_x * exp_k_b, exp_k_d = exp_k_c + 1.9572941063391263e-20,
      exp_k_e = exp_x * exp_k_d, exp_k_f = exp_k_e - 8.22063524662433e-18,
      exp_k_g = exp_x * exp_k_f, exp_k_h = exp_k_g + 2.8114572543455206e-15,
      exp_k_i = exp_x * exp_k_h, exp_k_j = exp_k_i - 7.647163731819816e-13,
      exp_k_k = exp_x * exp_k_j, exp_k_l = exp_k_k + 1.6059043836821613e-10,
      exp_k_m = exp_x * exp_k_l, exp_k_n = exp_k_m - 2.505210838544172e-08,
      exp_k_o = exp_x * exp_k_n, exp_k_p = exp_k_o + 2.7557319223985893e-06,
      exp_k_q = exp_x * exp_k_p, exp_k_r = exp_k_q - 0.0001984126984126984,
      exp_k_s = exp_x * exp_k_r, exp_k_t = exp_k_s + 0.008333333333333333,
      exp_k_u = exp_x * exp_k_t, exp_k_v = exp_k_u - 0.16666666666666666, exp_k_w = exp_x * exp_k_v,
      exp_k_x = exp_k_w + 1.0, exp_k = exp_x < 1.0 ? exp_k_x : exp_far_k;
  const double exp_g2a = 2.4795962632247976e-27 * exp_x, exp_g2b = exp_g2a - 1.6117375710961184e-24,
      exp_g2c = exp_x * exp_g2b, exp_g2d = exp_g2c + 8.896791392450574e-22,
      exp_g2e = exp_x * exp_g2d, exp_g2f = exp_g2e - 4.110317623312165e-19,
      exp_g2g = exp_x * exp_g2f, exp_g2h = exp_g2g + 1.5619206968586225e-16,
      exp_g2i = exp_x * exp_g2h, exp_g2j = exp_g2i - 4.779477332387385e-14,
      exp_g2k = exp_x * exp_g2j, exp_g2l = exp_g2k + 1.1470745597729725e-11,
      exp_g2m = exp_x * exp_g2l, exp_g2n = exp_g2m - 2.08767569878681e-09,
      exp_g2o = exp_x * exp_g2n, exp_g2p = exp_g2o + 2.755731922398589e-07,
      exp_g2q = exp_x * exp_g2p, exp_g2r = exp_g2q - 2.48015873015873e-05,
      exp_g2s = exp_x * exp_g2r, exp_g2t = exp_g2s + 0.001388888888888889,
      exp_g2u = exp_x * exp_g2t, exp_g2v = exp_g2u - 0.041666666666666664,
      exp_g2w = exp_x * exp_g2v, exp_g2 = exp_g2w + 0.5;
  const double exp_near_a = exp_x * exp_g2, exp_near = 1.0 - exp_near_a;
  const double power_0 = step_0 * exp_k;
  const double power_1 = step_1 * exp_k;
  const double power_2 = step_2 * exp_k;
  const double power_3 = exp_x < 1.0 ? exp_near : exp_cosine;
  const double qo_0a = q1->x * power_3, qo_0b = q1->y * power_2, qo_0c = q1->z * power_1,
      qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d, qo_0f = q1->w * power_0, qo_0 = qo_0e + qo_0f;
  const double qo_1a = q1->z * power_0, qo_1b = q1->x * power_2, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * power_3, qo_1e = qo_1c + qo_1d, qo_1f = q1->w * power_1, qo_1 = qo_1e + qo_1f;
  const double qo_2a = q1->x * power_1, qo_2b = q1->y * power_0, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * power_3, qo_2e = qo_2c + qo_2d, qo_2f = q1->w * power_2, qo_2 = qo_2e + qo_2f;
  const double qo_3a = q1->w * power_3, qo_3b = q1->x * power_0, qo_3c = q1->y * power_1,
      qo_3d = qo_3b + qo_3c, qo_3e = q1->z * power_2, qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
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
  const float self_0_new = self->x * a;
  const float self_1_new = self->y * a;
  const float self_2_new = self->z * a;
  const float self_3_new = self->w * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
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
  const float qo_0 = -q->x;
  const float qo_1 = -q->y;
  const float qo_2 = -q->z;
  const float q_w = q->w;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = q_w;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 3 add, 1 sqrt, 4 abs, 7 less, 7 select. */
static inline float ksl_quaternionf_norm(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s = s_largest3 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = q->x * s;
  const float y_1 = q->y * s;
  const float y_2 = q->z * s;
  const float y_3 = q->w * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r = 1.0f < s ? 7.888609e-31f : r_b;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalize(ksl_quaternionf_t *self) {
  const float s_size_0 = fabsf(self->x);
  const float s_size_1 = fabsf(self->y);
  const float s_size_2 = fabsf(self->z);
  const float s_size_3 = fabsf(self->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s = s_largest3 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = self->x * s;
  const float y_1 = self->y * s;
  const float y_2 = self->z * s;
  const float y_3 = self->w * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = self->x * up;
  const float enlarged_1 = self->y * up;
  const float enlarged_2 = self->z * up;
  const float enlarged_3 = self->w * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float self_0_new = quotient_0 * down;
  const float self_1_new = quotient_1 * down;
  const float self_2_new = quotient_2 * down;
  const float self_3_new = quotient_3 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalized(const ksl_quaternionf_t *q, ksl_quaternionf_t *qo) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s = s_largest3 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = q->x * s;
  const float y_1 = q->y * s;
  const float y_2 = q->z * s;
  const float y_3 = q->w * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = q->x * up;
  const float enlarged_1 = q->y * up;
  const float enlarged_2 = q->z * up;
  const float enlarged_3 = q->w * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float qo_0 = quotient_0 * down;
  const float qo_1 = quotient_1 * down;
  const float qo_2 = quotient_2 * down;
  const float qo_3 = quotient_3 * down;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqf(const ksl_quaternionf_t *q1, const ksl_quaternionf_t *q2,
    ksl_quaternionf_t *qo) {
  const float qo_0a = q1->x * q2->w, qo_0b = q1->y * q2->z, qo_0c = q1->z * q2->y,
      qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d, qo_0f = q1->w * q2->x, qo_0 = qo_0e + qo_0f;
  const float qo_1a = q1->z * q2->x, qo_1b = q1->x * q2->z, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * q2->w, qo_1e = qo_1c + qo_1d, qo_1f = q1->w * q2->y, qo_1 = qo_1e + qo_1f;
  const float qo_2a = q1->x * q2->y, qo_2b = q1->y * q2->x, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * q2->w, qo_2e = qo_2c + qo_2d, qo_2f = q1->w * q2->z, qo_2 = qo_2e + qo_2f;
  const float qo_3a = q1->w * q2->w, qo_3b = q1->x * q2->x, qo_3c = q1->y * q2->y,
      qo_3d = qo_3b + qo_3c, qo_3e = q1->z * q2->z, qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjqf(const ksl_quaternionf_t *q1, const ksl_quaternionf_t *q2,
    ksl_quaternionf_t *qo) {
  const float qo_0a = q1->w * q2->x, qo_0b = q1->x * q2->w, qo_0c = qo_0a - qo_0b,
      qo_0d = q1->z * q2->y, qo_0e = q1->y * q2->z, qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const float qo_1a = q1->x * q2->z, qo_1b = q1->z * q2->x, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->w * q2->y, qo_1e = q1->y * q2->w, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const float qo_2a = q1->y * q2->x, qo_2b = q1->x * q2->y, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->w * q2->z, qo_2e = q1->z * q2->w, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const float qo_3a = q1->x * q2->x, qo_3b = q1->y * q2->y, qo_3c = qo_3a + qo_3b,
      qo_3d = q1->z * q2->z, qo_3e = qo_3c + qo_3d, qo_3f = q1->w * q2->w, qo_3 = qo_3e + qo_3f;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconjf(const ksl_quaternionf_t *q1, const ksl_quaternionf_t *q2,
    ksl_quaternionf_t *qo) {
  const float qo_0a = q1->x * q2->w, qo_0b = q1->w * q2->x, qo_0c = qo_0a - qo_0b,
      qo_0d = q1->z * q2->y, qo_0e = q1->y * q2->z, qo_0f = qo_0d - qo_0e, qo_0 = qo_0c + qo_0f;
  const float qo_1a = q1->x * q2->z, qo_1b = q1->z * q2->x, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * q2->w, qo_1e = q1->w * q2->y, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const float qo_2a = q1->y * q2->x, qo_2b = q1->x * q2->y, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * q2->w, qo_2e = q1->w * q2->z, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const float qo_3a = q1->x * q2->x, qo_3b = q1->y * q2->y, qo_3c = qo_3a + qo_3b,
      qo_3d = q1->z * q2->z, qo_3e = qo_3c + qo_3d, qo_3f = q1->w * q2->w, qo_3 = qo_3e + qo_3f;
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
static inline void ksl_product_qvf(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0a = q->y * v->z, c_0b = q->z * v->y, c_0 = c_0a - c_0b;
  const float c_1a = q->z * v->x, c_1b = q->x * v->z, c_1 = c_1a - c_1b;
  const float c_2a = q->x * v->y, c_2b = q->y * v->x, c_2 = c_2a - c_2b;
  const float t_0 = 2.0f * c_0;
  const float t_1 = 2.0f * c_1;
  const float t_2 = 2.0f * c_2;
  const float turn_0a = q->y * t_2, turn_0b = q->z * t_1, turn_0c = turn_0a - turn_0b,
      turn_0d = q->w * t_0, turn_0 = turn_0c + turn_0d;
  const float turn_1a = q->z * t_0, turn_1b = q->x * t_2, turn_1c = turn_1a - turn_1b,
      turn_1d = q->w * t_1, turn_1 = turn_1c + turn_1d;
  const float turn_2a = q->x * t_1, turn_2b = q->y * t_0, turn_2c = turn_2a - turn_2b,
      turn_2d = q->w * t_2, turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjvf(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0a = q->z * v->y, c_0b = q->y * v->z, c_0 = c_0a - c_0b;
  const float c_1a = q->x * v->z, c_1b = q->z * v->x, c_1 = c_1a - c_1b;
  const float c_2a = q->y * v->x, c_2b = q->x * v->y, c_2 = c_2a - c_2b;
  const float t_0 = 2.0f * c_0;
  const float t_1 = 2.0f * c_1;
  const float t_2 = 2.0f * c_2;
  const float turn_0a = q->z * t_1, turn_0b = q->y * t_2, turn_0c = turn_0a - turn_0b,
      turn_0d = q->w * t_0, turn_0 = turn_0c + turn_0d;
  const float turn_1a = q->x * t_2, turn_1b = q->z * t_0, turn_1c = turn_1a - turn_1b,
      turn_1d = q->w * t_1, turn_1 = turn_1c + turn_1d;
  const float turn_2a = q->y * t_0, turn_2b = q->x * t_1, turn_2c = turn_2a - turn_2b,
      turn_2d = q->w * t_2, turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div.
   Error <= R: 5 u of its largest component; searched, not proved. */
static inline void ksl_mat3x3f_from_quaternion(const ksl_quaternionf_t *q, ksl_mat3x3f_t *R) {
  const float squares_0 = q->w * q->w;
  const float squares_1 = q->x * q->x;
  const float squares_2 = q->y * q->y;
  const float squares_3 = q->z * q->z;
  const float pairs_0 = squares_0 + squares_1;
  const float pairs_1 = squares_2 + squares_3;
  const float pairs_2 = squares_0 + squares_2;
  const float pairs_3 = squares_1 + squares_3;
  const float pairs_4 = squares_0 + squares_3;
  const float pairs_5 = squares_1 + squares_2;
  const float square = pairs_0 + pairs_1;
  const float factor = 1.0f / square;
  const float d0 = pairs_0 - pairs_1;
  const float d1 = pairs_2 - pairs_3;
  const float d2 = pairs_4 - pairs_5;
  const float twice = 2.0f * factor;
  const float m_0a = q->x * q->y, m_0b = q->z * q->w, m_0 = m_0a - m_0b;
  const float m_1a = q->x * q->z, m_1b = q->y * q->w, m_1 = m_1a + m_1b;
  const float m_2a = q->y * q->z, m_2b = q->x * q->w, m_2 = m_2a - m_2b;
  const float m_3 = m_0a + m_0b;
  const float m_4 = m_1a - m_1b;
  const float m_5 = m_2b + m_2a;
  const float R_00 = factor * d0;
  const float R_01 = twice * m_0;
  const float R_02 = twice * m_1;
  const float R_10 = twice * m_3;
  const float R_11 = factor * d1;
  const float R_12 = twice * m_2;
  const float R_20 = twice * m_4;
  const float R_21 = twice * m_5;
  const float R_22 = factor * d2;
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

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.
   Error <= qo: 5 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_from_mat3x3(const ksl_mat3x3f_t *R, ksl_quaternionf_t *qo) {
  const float p_0 = R->m21 - R->m12;
  const float p_1 = R->m02 - R->m20;
  const float p_2 = R->m10 - R->m01;
  const float s_0 = R->m12 + R->m21;
  const float s_1 = R->m02 + R->m20;
  const float s_2 = R->m01 + R->m10;
  const float first_0 = R->m00 + 1.0f;
  const float first_1 = 1.0f - R->m00;
  const float others_0 = R->m11 + R->m22;
  const float others_1 = R->m11 - R->m22;
  const float d_0 = first_0 + others_0;
  const float d_1 = first_0 - others_0;
  const float d_2 = first_1 + others_1;
  const float d_3 = first_1 - others_1;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2;
  const float low_1 = R->m11 < R->m00 ? s_2 : d_2;
  const float low_2 = R->m11 < R->m00 ? s_1 : s_0;
  const float low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1;
  const float high_2 = R->m00 < high_0a ? d_3 : p_2;
  const float high_3 = R->m00 < high_0a ? p_2 : d_0;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0;
  const float column_1 = R->m22 < 0.0f ? low_1 : high_1;
  const float column_2 = R->m22 < 0.0f ? low_2 : high_2;
  const float column_3 = R->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float length_a = upper_0 * upper_0, length_b = upper_1 * upper_1,
      length_c = length_a + length_b, length_d = upper_2 * upper_2, length_e = length_c + length_d,
      length_f = upper_3 * upper_3, length_g = length_e + length_f, length = sqrtf(length_g);
  const float qo_0 = upper_0 / length;
  const float qo_1 = upper_1 / length;
  const float qo_2 = upper_2 / length;
  const float qo_3 = upper_3 / length;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 1 sin, 1 cos.
   Error <= qo: 3 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_from_axis_angle(const ksl_vec3f_t *axis, const float angle,
    ksl_quaternionf_t *qo) {
  const float half = 0.5f * angle;
  const float sine = sinf(half);
  const float qo_0 = axis->x * sine;
  const float qo_1 = axis->y * sine;
  const float qo_2 = axis->z * sine;
  const float qo_3 = cosf(half);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where
     nothing turns; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   8 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 12 select.
   Error <= angle: 5 u, axis: 4 u of its largest component; searched, not proved. */
static inline float ksl_axis_angle_from_quaternionf(const ksl_quaternionf_t *q, ksl_vec3f_t *axis) {
  const float upper_0a = -q->x, upper_0 = q->w < 0.0f ? upper_0a : q->x;
  const float upper_1a = -q->y, upper_1 = q->w < 0.0f ? upper_1a : q->y;
  const float upper_2a = -q->z, upper_2 = q->w < 0.0f ? upper_2a : q->z;
  const float upper_3a = -q->w, upper_3 = q->w < 0.0f ? upper_3a : q->w;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s = v_s_largest2 < 8.881784e-16f ? 1.2676506e+30f : v_s_b;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r = 1.0f < v_s ? 7.888609e-31f : v_r_b;
  const float n = v_n * v_r;
  const float half = atan2f(n, upper_3);
  const float divisor = v_n == 0.0f ? 1.0f : v_n;
  const float unit_0 = v_y_0 / divisor;
  const float unit_1 = v_y_1 / divisor;
  const float unit_2 = v_y_2 / divisor;
  const float angle = 2.0f * half;
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   34 mul, 27 add, 1 div, 1 sqrt, 1 sin, 1 cos, 1 less, 5 select.
   Error <= qo: 7 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_exp(const ksl_vec3f_t *v, ksl_quaternionf_t *qo) {
  const float h_0 = 0.5f * v->x;
  const float h_1 = 0.5f * v->y;
  const float h_2 = 0.5f * v->z;
  const float x_a = h_0 * h_0, x_b = h_1 * h_1, x_c = x_a + x_b, x_d = h_2 * h_2, x = x_c + x_d;
  const float size = sqrtf(x);
  const float cosine_a = cosf(size), cosine = x < 1.0f ? 1.0f : cosine_a;
  const float sine_a = sinf(size), sine = x < 1.0f ? 1.0f : sine_a;
  const float divisor = x < 1.0f ? 2.0f : size;
  const float far_k = sine / divisor;
  const float k_a = 6.4469503e-26f * x, k_b = k_a - 3.8681703e-23f, k_c = x * k_b,
      k_d = k_c + 1.9572942e-20f, k_e = x * k_d, k_f = k_e - 8.220635e-18f, k_g = x * k_f,
      k_h = k_g + 2.8114574e-15f, k_i = x * k_h, k_j = k_i - 7.6471636e-13f, k_k = x * k_j,
      k_l = k_k + 1.6059044e-10f, k_m = x * k_l, k_n = k_m - 2.5052108e-08f, k_o = x * k_n,
      k_p = k_o + 2.7557319e-06f, k_q = x * k_p, k_r = k_q - 0.0001984127f, k_s = x * k_r,
      k_t = k_s + 0.008333334f, k_u = x * k_t, k_v = k_u - 0.16666667f, k_w = x * k_v,
      k_x = k_w + 1.0f, k = x < 1.0f ? k_x : far_k;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2 = g2w + 0.5f;
  const float near_a = x * g2, near = 1.0f - near_a;
  const float qo_0 = h_0 * k;
  const float qo_1 = h_1 * k;
  const float qo_2 = h_2 * k;
  const float qo_3 = x < 1.0f ? near : cosine;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   11 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 11 select.
   Error <= vo: 5 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_log(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const float upper_0a = -q->x, upper_0 = q->w < 0.0f ? upper_0a : q->x;
  const float upper_1a = -q->y, upper_1 = q->w < 0.0f ? upper_1a : q->y;
  const float upper_2a = -q->z, upper_2 = q->w < 0.0f ? upper_2a : q->z;
  const float upper_3a = -q->w, upper_3 = q->w < 0.0f ? upper_3a : q->w;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s = v_s_largest2 < 8.881784e-16f ? 1.2676506e+30f : v_s_b;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r = 1.0f < v_s ? 7.888609e-31f : v_r_b;
  const float n = v_n * v_r;
  const float half = atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = 2.0f * half;
  const float k = theta / divisor;
  const float vector_0 = upper_0 * k;
  const float vector_1 = upper_1 * k;
  const float vector_2 = upper_2 * k;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   76 mul, 53 add, 2 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 4 neg, 3 abs, 8 less, 1 equal, 16
     select.
   Error <= qo: 12 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_slerp(const ksl_quaternionf_t *q1, const ksl_quaternionf_t *q2,
    const float k, ksl_quaternionf_t *qo) {
  const float between_0a = q1->w * q2->x, between_0b = q1->x * q2->w,
      between_0c = between_0a - between_0b, between_0d = q1->z * q2->y, between_0e = q1->y * q2->z,
      between_0f = between_0d - between_0e, between_0 = between_0c + between_0f;
  const float between_1a = q1->x * q2->z, between_1b = q1->z * q2->x,
      between_1c = between_1a - between_1b, between_1d = q1->w * q2->y, between_1e = q1->y * q2->w,
      between_1f = between_1d - between_1e, between_1 = between_1c + between_1f;
  const float between_2a = q1->y * q2->x, between_2b = q1->x * q2->y,
      between_2c = between_2a - between_2b, between_2d = q1->w * q2->z, between_2e = q1->z * q2->w,
      between_2f = between_2d - between_2e, between_2 = between_2c + between_2f;
  const float between_3a = q1->x * q2->x, between_3b = q1->y * q2->y,
      between_3c = between_3a + between_3b, between_3d = q1->z * q2->z,
      between_3e = between_3c + between_3d, between_3f = q1->w * q2->w,
      between_3 = between_3e + between_3f;
  const float upper_0a = -between_0, upper_0 = between_3 < 0.0f ? upper_0a : between_0;
  const float upper_1a = -between_1, upper_1 = between_3 < 0.0f ? upper_1a : between_1;
  const float upper_2a = -between_2, upper_2 = between_3 < 0.0f ? upper_2a : between_2;
  const float upper_3a = -between_3, upper_3 = between_3 < 0.0f ? upper_3a : between_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s = v_s_largest2 < 8.881784e-16f ? 1.2676506e+30f : v_s_b;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r = 1.0f < v_s ? 7.888609e-31f : v_r_b;
  const float n = v_n * v_r;
  const float half = atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float rate = half / divisor;
  const float kv_0 = k * upper_0;
  const float kv_1 = k * upper_1;
  const float kv_2 = k * upper_2;
  const float step_0 = rate * kv_0;
  const float step_1 = rate * kv_1;
  const float step_2 = rate * kv_2;
  const float exp_x_a = step_0 * step_0, exp_x_b = step_1 * step_1, exp_x_c = exp_x_a + exp_x_b,
      exp_x_d = step_2 * step_2, exp_x = exp_x_c + exp_x_d;
  const float exp_size = sqrtf(exp_x);
  const float exp_cosine_a = cosf(exp_size), exp_cosine = exp_x < 1.0f ? 1.0f : exp_cosine_a;
  const float exp_sine_a = sinf(exp_size), exp_sine = exp_x < 1.0f ? 1.0f : exp_sine_a;
  const float exp_divisor = exp_x < 1.0f ? 2.0f : exp_size;
  const float exp_far_k = exp_sine / exp_divisor;
  const float exp_k_a = 6.4469503e-26f * exp_x, exp_k_b = exp_k_a - 3.8681703e-23f,
      exp_k_c = exp_x * exp_k_b, exp_k_d = exp_k_c + 1.9572942e-20f, exp_k_e = exp_x * exp_k_d,
      exp_k_f = exp_k_e - 8.220635e-18f, exp_k_g = exp_x * exp_k_f,
      exp_k_h = exp_k_g + 2.8114574e-15f, exp_k_i = exp_x * exp_k_h,
      exp_k_j = exp_k_i - 7.6471636e-13f, exp_k_k = exp_x * exp_k_j,
      exp_k_l = exp_k_k + 1.6059044e-10f, exp_k_m = exp_x * exp_k_l,
      exp_k_n = exp_k_m - 2.5052108e-08f, exp_k_o = exp_x * exp_k_n,
      exp_k_p = exp_k_o + 2.7557319e-06f, exp_k_q = exp_x * exp_k_p,
      exp_k_r = exp_k_q - 0.0001984127f, exp_k_s = exp_x * exp_k_r,
      exp_k_t = exp_k_s + 0.008333334f, exp_k_u = exp_x * exp_k_t, exp_k_v = exp_k_u - 0.16666667f,
      exp_k_w = exp_x * exp_k_v, exp_k_x = exp_k_w + 1.0f,
      exp_k = exp_x < 1.0f ? exp_k_x : exp_far_k;
  const float exp_g2a = 2.4795963e-27f * exp_x, exp_g2b = exp_g2a - 1.6117376e-24f,
      exp_g2c = exp_x * exp_g2b, exp_g2d = exp_g2c + 8.896791e-22f, exp_g2e = exp_x * exp_g2d,
      exp_g2f = exp_g2e - 4.1103176e-19f, exp_g2g = exp_x * exp_g2f,
      exp_g2h = exp_g2g + 1.5619207e-16f, exp_g2i = exp_x * exp_g2h,
      exp_g2j = exp_g2i - 4.7794773e-14f, exp_g2k = exp_x * exp_g2j,
      exp_g2l = exp_g2k + 1.1470745e-11f, exp_g2m = exp_x * exp_g2l,
      exp_g2n = exp_g2m - 2.0876756e-09f, exp_g2o = exp_x * exp_g2n,
      exp_g2p = exp_g2o + 2.755732e-07f, exp_g2q = exp_x * exp_g2p,
      exp_g2r = exp_g2q - 2.4801588e-05f, exp_g2s = exp_x * exp_g2r,
      exp_g2t = exp_g2s + 0.0013888889f, exp_g2u = exp_x * exp_g2t,
      exp_g2v = exp_g2u - 0.041666668f, exp_g2w = exp_x * exp_g2v, exp_g2 = exp_g2w + 0.5f;
  const float exp_near_a = exp_x * exp_g2, exp_near = 1.0f - exp_near_a;
  const float power_0 = step_0 * exp_k;
  const float power_1 = step_1 * exp_k;
  const float power_2 = step_2 * exp_k;
  const float power_3 = exp_x < 1.0f ? exp_near : exp_cosine;
  const float qo_0a = q1->x * power_3, qo_0b = q1->y * power_2, qo_0c = q1->z * power_1,
      qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d, qo_0f = q1->w * power_0, qo_0 = qo_0e + qo_0f;
  const float qo_1a = q1->z * power_0, qo_1b = q1->x * power_2, qo_1c = qo_1a - qo_1b,
      qo_1d = q1->y * power_3, qo_1e = qo_1c + qo_1d, qo_1f = q1->w * power_1, qo_1 = qo_1e + qo_1f;
  const float qo_2a = q1->x * power_1, qo_2b = q1->y * power_0, qo_2c = qo_2a - qo_2b,
      qo_2d = q1->z * power_3, qo_2e = qo_2c + qo_2d, qo_2f = q1->w * power_2, qo_2 = qo_2e + qo_2f;
  const float qo_3a = q1->w * power_3, qo_3b = q1->x * power_0, qo_3c = q1->y * power_1,
      qo_3d = qo_3b + qo_3c, qo_3e = q1->z * power_2, qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
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

#endif
