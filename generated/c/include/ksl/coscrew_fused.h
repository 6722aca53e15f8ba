/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).
   Fused tier: products fused into sums. */
#ifndef KSL_COSCREW_FUSED_H
#define KSL_COSCREW_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale_fused(ksl_coscrew_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m0, a);
  const double self_1_new = KSL_MUL(self->m1, a);
  const double self_2_new = KSL_MUL(self->m2, a);
  const double self_3_new = KSL_MUL(self->m3, a);
  const double self_4_new = KSL_MUL(self->m4, a);
  const double self_5_new = KSL_MUL(self->m5, a);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_cc_fused(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = fma(a, x->m0, y->m0);
  const double y_1_new = fma(a, x->m1, y->m1);
  const double y_2_new = fma(a, x->m2, y->m2);
  const double y_3_new = fma(a, x->m3, y->m3);
  const double y_4_new = fma(a, x->m4, y->m4);
  const double y_5_new = fma(a, x->m5, y->m5);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc_fused(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = x->m0 + y->m0;
  const double y_1_new = x->m1 + y->m1;
  const double y_2_new = x->m2 + y->m2;
  const double y_3_new = x->m3 + y->m3;
  const double y_4_new = x->m4 + y->m4;
  const double y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc_fused(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = y->m0 - x->m0;
  const double y_1_new = y->m1 - x->m1;
  const double y_2_new = y->m2 - x->m2;
  const double y_3_new = y->m3 - x->m3;
  const double y_4_new = y->m4 - x->m4;
  const double y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ac_fused(const double a, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(a, ci->m0);
  const double co_1 = KSL_MUL(a, ci->m1);
  const double co_2 = KSL_MUL(a, ci->m2);
  const double co_3 = KSL_MUL(a, ci->m3);
  const double co_4 = KSL_MUL(a, ci->m4);
  const double co_5 = KSL_MUL(a, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc_fused(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double co_3 = c1->m3 + c2->m3;
  const double co_4 = c1->m4 + c2->m4;
  const double co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc_fused(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0;
  const double co_1 = c1->m1 - c2->m1;
  const double co_2 = c1->m2 - c2->m2;
  const double co_3 = c1->m3 - c2->m3;
  const double co_4 = c1->m4 - c2->m4;
  const double co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct_fused(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtc_fused(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(t->y, ci->m2), co_3c = fma(-t->z, ci->m1, co_3a),
      co_3 = co_3c + ci->m3;
  const double co_4a = KSL_MUL(t->z, ci->m0), co_4c = fma(-t->x, ci->m2, co_4a),
      co_4 = co_4c + ci->m4;
  const double co_5a = KSL_MUL(t->x, ci->m1), co_5c = fma(-t->y, ci->m0, co_5a),
      co_5 = co_5c + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvc_fused(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3c = fma(-t->y, ci->m2, co_3a),
      co_3 = co_3c + ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4c = fma(-t->z, ci->m0, co_4a),
      co_4 = co_4c + ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5c = fma(-t->x, ci->m1, co_5a),
      co_5 = co_5c + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinv_fused(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3c = fma(-t->y, ci->m2, co_3a),
      co_3 = co_3c - ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4c = fma(-t->z, ci->m0, co_4a),
      co_4 = co_4c - ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5c = fma(-t->x, ci->m1, co_5a),
      co_5 = co_5c - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrc_fused(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0c = fma(R->m01, ci->m1, co_0a),
      co_0 = fma(R->m02, ci->m2, co_0c);
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1c = fma(R->m11, ci->m1, co_1a),
      co_1 = fma(R->m12, ci->m2, co_1c);
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2c = fma(R->m21, ci->m1, co_2a),
      co_2 = fma(R->m22, ci->m2, co_2c);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3c = fma(R->m01, ci->m4, co_3a),
      co_3 = fma(R->m02, ci->m5, co_3c);
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4c = fma(R->m11, ci->m4, co_4a),
      co_4 = fma(R->m12, ci->m5, co_4c);
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5c = fma(R->m21, ci->m4, co_5a),
      co_5 = fma(R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvc_fused(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0c = fma(R->m10, ci->m1, co_0a),
      co_0 = fma(R->m20, ci->m2, co_0c);
  const double co_1a = KSL_MUL(R->m01, ci->m0), co_1c = fma(R->m11, ci->m1, co_1a),
      co_1 = fma(R->m21, ci->m2, co_1c);
  const double co_2a = KSL_MUL(R->m02, ci->m0), co_2c = fma(R->m12, ci->m1, co_2a),
      co_2 = fma(R->m22, ci->m2, co_2c);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3c = fma(R->m10, ci->m4, co_3a),
      co_3 = fma(R->m20, ci->m5, co_3c);
  const double co_4a = KSL_MUL(R->m01, ci->m3), co_4c = fma(R->m11, ci->m4, co_4a),
      co_4 = fma(R->m21, ci->m5, co_4c);
  const double co_5a = KSL_MUL(R->m02, ci->m3), co_5c = fma(R->m12, ci->m4, co_5a),
      co_5 = fma(R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinv_fused(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0c_lead = -co_0a,
      co_0c = fma(-R->m01, ci->m1, co_0c_lead), co_0 = fma(-R->m02, ci->m2, co_0c);
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1c_lead = -co_1a,
      co_1c = fma(-R->m11, ci->m1, co_1c_lead), co_1 = fma(-R->m12, ci->m2, co_1c);
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2c_lead = -co_2a,
      co_2c = fma(-R->m21, ci->m1, co_2c_lead), co_2 = fma(-R->m22, ci->m2, co_2c);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3c_lead = -co_3a,
      co_3c = fma(-R->m01, ci->m4, co_3c_lead), co_3 = fma(-R->m02, ci->m5, co_3c);
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4c_lead = -co_4a,
      co_4c = fma(-R->m11, ci->m4, co_4c_lead), co_4 = fma(-R->m12, ci->m5, co_4c);
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5c_lead = -co_5a,
      co_5c = fma(-R->m21, ci->m4, co_5c_lead), co_5 = fma(-R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdc_fused(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0c = fma(D->m01, ci->m1, w_0a),
      w_0 = fma(D->m02, ci->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1c = fma(D->m11, ci->m1, w_1a),
      w_1 = fma(D->m12, ci->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2c = fma(D->m21, ci->m1, w_2a),
      w_2 = fma(D->m22, ci->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3c = fma(D->m01, ci->m4, w_3a),
      w_3 = fma(D->m02, ci->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4c = fma(D->m11, ci->m4, w_4a),
      w_4 = fma(D->m12, ci->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5c = fma(D->m21, ci->m4, w_5a),
      w_5 = fma(D->m22, ci->m5, w_5c);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvc_fused(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = KSL_MUL(D->m23, ci->m1), w_3c = fma(-D->m13, ci->m2, w_3a),
      w_3 = w_3c + ci->m3;
  const double w_4a = KSL_MUL(D->m03, ci->m2), w_4c = fma(-D->m23, ci->m0, w_4a),
      w_4 = w_4c + ci->m4;
  const double w_5a = KSL_MUL(D->m13, ci->m0), w_5c = fma(-D->m03, ci->m1, w_5a),
      w_5 = w_5c + ci->m5;
  const double co_0a = KSL_MUL(D->m00, ci->m0), co_0c = fma(D->m10, ci->m1, co_0a),
      co_0 = fma(D->m20, ci->m2, co_0c);
  const double co_1a = KSL_MUL(D->m01, ci->m0), co_1c = fma(D->m11, ci->m1, co_1a),
      co_1 = fma(D->m21, ci->m2, co_1c);
  const double co_2a = KSL_MUL(D->m02, ci->m0), co_2c = fma(D->m12, ci->m1, co_2a),
      co_2 = fma(D->m22, ci->m2, co_2c);
  const double co_3a = KSL_MUL(D->m00, w_3), co_3c = fma(D->m10, w_4, co_3a),
      co_3 = fma(D->m20, w_5, co_3c);
  const double co_4a = KSL_MUL(D->m01, w_3), co_4c = fma(D->m11, w_4, co_4a),
      co_4 = fma(D->m21, w_5, co_4c);
  const double co_5a = KSL_MUL(D->m02, w_3), co_5c = fma(D->m12, w_4, co_5a),
      co_5 = fma(D->m22, w_5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinv_fused(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0c_lead = -w_0a,
      w_0c = fma(-D->m01, ci->m1, w_0c_lead), w_0 = fma(-D->m02, ci->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1c_lead = -w_1a,
      w_1c = fma(-D->m11, ci->m1, w_1c_lead), w_1 = fma(-D->m12, ci->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2c_lead = -w_2a,
      w_2c = fma(-D->m21, ci->m1, w_2c_lead), w_2 = fma(-D->m22, ci->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3c_lead = -w_3a,
      w_3c = fma(-D->m01, ci->m4, w_3c_lead), w_3 = fma(-D->m02, ci->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4c_lead = -w_4a,
      w_4c = fma(-D->m11, ci->m4, w_4c_lead), w_4 = fma(-D->m12, ci->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5c_lead = -w_5a,
      w_5c = fma(-D->m21, ci->m4, w_5c_lead), w_5 = fma(-D->m22, ci->m5, w_5c);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctx_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m20, D->m13), co_3 = fma(-D->m10, D->m23, co_3a);
  const double co_4a = KSL_MUL(D->m00, D->m23), co_4 = fma(-D->m20, D->m03, co_4a);
  const double co_5a = KSL_MUL(D->m10, D->m03), co_5 = fma(-D->m00, D->m13, co_5a);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hcty_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m21, D->m13), co_3 = fma(-D->m11, D->m23, co_3a);
  const double co_4a = KSL_MUL(D->m01, D->m23), co_4 = fma(-D->m21, D->m03, co_4a);
  const double co_5a = KSL_MUL(D->m11, D->m03), co_5 = fma(-D->m01, D->m13, co_5a);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctz_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m22, D->m13), co_3 = fma(-D->m12, D->m23, co_3a);
  const double co_4a = KSL_MUL(D->m02, D->m23), co_4 = fma(-D->m22, D->m03, co_4a);
  const double co_5a = KSL_MUL(D->m12, D->m03), co_5 = fma(-D->m02, D->m13, co_5a);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinv_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = KSL_MUL(D->m10, D->m23), co_3 = fma(-D->m20, D->m13, co_3a);
  const double co_4a = KSL_MUL(D->m20, D->m03), co_4 = fma(-D->m00, D->m23, co_4a);
  const double co_5a = KSL_MUL(D->m00, D->m13), co_5 = fma(-D->m10, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinv_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = KSL_MUL(D->m11, D->m23), co_3 = fma(-D->m21, D->m13, co_3a);
  const double co_4a = KSL_MUL(D->m21, D->m03), co_4 = fma(-D->m01, D->m23, co_4a);
  const double co_5a = KSL_MUL(D->m01, D->m13), co_5 = fma(-D->m11, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinv_fused(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = KSL_MUL(D->m12, D->m23), co_3 = fma(-D->m22, D->m13, co_3a);
  const double co_4a = KSL_MUL(D->m22, D->m03), co_4 = fma(-D->m02, D->m23, co_4a);
  const double co_5a = KSL_MUL(D->m02, D->m13), co_5 = fma(-D->m12, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   9 mul, 9 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd_fused(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = KSL_MUL(D->m20, D->m13), M_30 = fma(-D->m10, D->m23, M_30a);
  const double M_31a = KSL_MUL(D->m21, D->m13), M_31 = fma(-D->m11, D->m23, M_31a);
  const double M_32a = KSL_MUL(D->m22, D->m13), M_32 = fma(-D->m12, D->m23, M_32a);
  const double M_40a = KSL_MUL(D->m00, D->m23), M_40 = fma(-D->m20, D->m03, M_40a);
  const double M_41a = KSL_MUL(D->m01, D->m23), M_41 = fma(-D->m21, D->m03, M_41a);
  const double M_42a = KSL_MUL(D->m02, D->m23), M_42 = fma(-D->m22, D->m03, M_42a);
  const double M_50a = KSL_MUL(D->m10, D->m03), M_50 = fma(-D->m00, D->m13, M_50a);
  const double M_51a = KSL_MUL(D->m11, D->m03), M_51 = fma(-D->m01, D->m13, M_51a);
  const double M_52a = KSL_MUL(D->m12, D->m03), M_52 = fma(-D->m02, D->m13, M_52a);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   2 mul, 1 add, 4 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_reciprocal_product_fused(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = KSL_MUL(c->m0, x[3]), power_c = fma(c->m1, x[4], power_a),
      power_e = fma(c->m2, x[5], power_c), power_f = KSL_MUL(c->m3, x[0]),
      power_h = fma(c->m4, x[1], power_f), power_j = fma(c->m5, x[2], power_h),
      power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 9 fma.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sc_fused(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(s->m4, c->m2), co_0 = fma(-s->m5, c->m1, co_0a);
  const double co_1a = KSL_MUL(s->m5, c->m0), co_1 = fma(-s->m3, c->m2, co_1a);
  const double co_2a = KSL_MUL(s->m3, c->m1), co_2 = fma(-s->m4, c->m0, co_2a);
  const double co_3a = KSL_MUL(s->m1, c->m2), co_3c = fma(-s->m2, c->m1, co_3a),
      co_3d = KSL_MUL(s->m4, c->m5), co_3f = fma(-s->m5, c->m4, co_3d), co_3 = co_3c + co_3f;
  const double co_4a = KSL_MUL(s->m2, c->m0), co_4c = fma(-s->m0, c->m2, co_4a),
      co_4d = KSL_MUL(s->m5, c->m3), co_4f = fma(-s->m3, c->m5, co_4d), co_4 = co_4c + co_4f;
  const double co_5a = KSL_MUL(s->m0, c->m1), co_5c = fma(-s->m1, c->m0, co_5a),
      co_5d = KSL_MUL(s->m3, c->m4), co_5f = fma(-s->m4, c->m3, co_5d), co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sca_fused(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(s->m4, c->m5), co_3 = fma(-s->m5, c->m4, co_3a);
  const double co_4a = KSL_MUL(s->m5, c->m3), co_4 = fma(-s->m3, c->m5, co_4a);
  const double co_5a = KSL_MUL(s->m3, c->m4), co_5 = fma(-s->m4, c->m3, co_5a);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctx_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m01, c->m1), w_0 = fma(D->m02, c->m2, w_0a);
  const double w_1a = KSL_MUL(D->m11, c->m1), w_1 = fma(D->m12, c->m2, w_1a);
  const double w_2a = KSL_MUL(D->m21, c->m1), w_2 = fma(D->m22, c->m2, w_2a);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3c = fma(D->m01, c->m4, w_3a),
      w_3 = fma(D->m02, c->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4c = fma(D->m11, c->m4, w_4a),
      w_4 = fma(D->m12, c->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5c = fma(D->m21, c->m4, w_5a),
      w_5 = fma(D->m22, c->m5, w_5c);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cty_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0 = fma(D->m02, c->m2, w_0a);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1 = fma(D->m12, c->m2, w_1a);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2 = fma(D->m22, c->m2, w_2a);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3c = fma(D->m01, c->m4, w_3a),
      w_3 = fma(D->m02, c->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4c = fma(D->m11, c->m4, w_4a),
      w_4 = fma(D->m12, c->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5c = fma(D->m21, c->m4, w_5a),
      w_5 = fma(D->m22, c->m5, w_5c);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctz_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0 = fma(D->m01, c->m1, w_0a);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1 = fma(D->m11, c->m1, w_1a);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2 = fma(D->m21, c->m1, w_2a);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3c = fma(D->m01, c->m4, w_3a),
      w_3 = fma(D->m02, c->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4c = fma(D->m11, c->m4, w_4a),
      w_4 = fma(D->m12, c->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5c = fma(D->m21, c->m4, w_5a),
      w_5 = fma(D->m22, c->m5, w_5c);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crx_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0c = fma(D->m01, c->m1, w_0a),
      w_0 = fma(D->m02, c->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1c = fma(D->m11, c->m1, w_1a),
      w_1 = fma(D->m12, c->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2c = fma(D->m21, c->m1, w_2a),
      w_2 = fma(D->m22, c->m2, w_2c);
  const double w_3a = KSL_MUL(D->m01, c->m4), w_3 = fma(D->m02, c->m5, w_3a);
  const double w_4a = KSL_MUL(D->m11, c->m4), w_4 = fma(D->m12, c->m5, w_4a);
  const double w_5a = KSL_MUL(D->m21, c->m4), w_5 = fma(D->m22, c->m5, w_5a);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cry_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0c = fma(D->m01, c->m1, w_0a),
      w_0 = fma(D->m02, c->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1c = fma(D->m11, c->m1, w_1a),
      w_1 = fma(D->m12, c->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2c = fma(D->m21, c->m1, w_2a),
      w_2 = fma(D->m22, c->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3 = fma(D->m02, c->m5, w_3a);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4 = fma(D->m12, c->m5, w_4a);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5 = fma(D->m22, c->m5, w_5a);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crz_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0c = fma(D->m01, c->m1, w_0a),
      w_0 = fma(D->m02, c->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1c = fma(D->m11, c->m1, w_1a),
      w_1 = fma(D->m12, c->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2c = fma(D->m21, c->m1, w_2a),
      w_2 = fma(D->m22, c->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3 = fma(D->m01, c->m4, w_3a);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4 = fma(D->m11, c->m4, w_4a);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5 = fma(D->m21, c->m4, w_5a);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3c = fma(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4c = fma(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5c = fma(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctx_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0);
  const double w_1 = KSL_MUL(D->m10, c->m0);
  const double w_2 = KSL_MUL(D->m20, c->m0);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3 = fma(-D->m23, w_1, co_3a);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4 = fma(-D->m03, w_2, co_4a);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5 = fma(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_cty_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m01, c->m1);
  const double w_1 = KSL_MUL(D->m11, c->m1);
  const double w_2 = KSL_MUL(D->m21, c->m1);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3 = fma(-D->m23, w_1, co_3a);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4 = fma(-D->m03, w_2, co_4a);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5 = fma(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctz_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m02, c->m2);
  const double w_1 = KSL_MUL(D->m12, c->m2);
  const double w_2 = KSL_MUL(D->m22, c->m2);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3 = fma(-D->m23, w_1, co_3a);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4 = fma(-D->m03, w_2, co_4a);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5 = fma(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crx_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m00, c->m3);
  const double w_4 = KSL_MUL(D->m10, c->m3);
  const double w_5 = KSL_MUL(D->m20, c->m3);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cry_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m01, c->m4);
  const double w_4 = KSL_MUL(D->m11, c->m4);
  const double w_5 = KSL_MUL(D->m21, c->m4);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crz_fused(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m02, c->m5);
  const double w_4 = KSL_MUL(D->m12, c->m5);
  const double w_5 = KSL_MUL(D->m22, c->m5);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrewf_scale_fused(ksl_coscrewf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->m0, a);
  const float self_1_new = KSL_MULF(self->m1, a);
  const float self_2_new = KSL_MULF(self->m2, a);
  const float self_3_new = KSL_MULF(self->m3, a);
  const float self_4_new = KSL_MULF(self->m4, a);
  const float self_5_new = KSL_MULF(self->m5, a);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_ccf_fused(const float a, const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = fmaf(a, x->m0, y->m0);
  const float y_1_new = fmaf(a, x->m1, y->m1);
  const float y_2_new = fmaf(a, x->m2, y->m2);
  const float y_3_new = fmaf(a, x->m3, y->m3);
  const float y_4_new = fmaf(a, x->m4, y->m4);
  const float y_5_new = fmaf(a, x->m5, y->m5);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ccf_fused(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = x->m0 + y->m0;
  const float y_1_new = x->m1 + y->m1;
  const float y_2_new = x->m2 + y->m2;
  const float y_3_new = x->m3 + y->m3;
  const float y_4_new = x->m4 + y->m4;
  const float y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ccf_fused(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = y->m0 - x->m0;
  const float y_1_new = y->m1 - x->m1;
  const float y_2_new = y->m2 - x->m2;
  const float y_3_new = y->m3 - x->m3;
  const float y_4_new = y->m4 - x->m4;
  const float y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_acf_fused(const float a, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(a, ci->m0);
  const float co_1 = KSL_MULF(a, ci->m1);
  const float co_2 = KSL_MULF(a, ci->m2);
  const float co_3 = KSL_MULF(a, ci->m3);
  const float co_4 = KSL_MULF(a, ci->m4);
  const float co_5 = KSL_MULF(a, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ccf_fused(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float co_3 = c1->m3 + c2->m3;
  const float co_4 = c1->m4 + c2->m4;
  const float co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ccf_fused(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 - c2->m0;
  const float co_1 = c1->m1 - c2->m1;
  const float co_2 = c1->m2 - c2->m2;
  const float co_3 = c1->m3 - c2->m3;
  const float co_4 = c1->m4 - c2->m4;
  const float co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cctf_fused(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcf_fused(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(t->y, ci->m2), co_3c = fmaf(-t->z, ci->m1, co_3a),
      co_3 = co_3c + ci->m3;
  const float co_4a = KSL_MULF(t->z, ci->m0), co_4c = fmaf(-t->x, ci->m2, co_4a),
      co_4 = co_4c + ci->m4;
  const float co_5a = KSL_MULF(t->x, ci->m1), co_5c = fmaf(-t->y, ci->m0, co_5a),
      co_5 = co_5c + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf_fused(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3c = fmaf(-t->y, ci->m2, co_3a),
      co_3 = co_3c + ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4c = fmaf(-t->z, ci->m0, co_4a),
      co_4 = co_4c + ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5c = fmaf(-t->x, ci->m1, co_5a),
      co_5 = co_5c + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf_fused(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3c = fmaf(-t->y, ci->m2, co_3a),
      co_3 = co_3c - ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4c = fmaf(-t->z, ci->m0, co_4a),
      co_4 = co_4c - ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5c = fmaf(-t->x, ci->m1, co_5a),
      co_5 = co_5c - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcf_fused(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0c = fmaf(R->m01, ci->m1, co_0a),
      co_0 = fmaf(R->m02, ci->m2, co_0c);
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1c = fmaf(R->m11, ci->m1, co_1a),
      co_1 = fmaf(R->m12, ci->m2, co_1c);
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2c = fmaf(R->m21, ci->m1, co_2a),
      co_2 = fmaf(R->m22, ci->m2, co_2c);
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3c = fmaf(R->m01, ci->m4, co_3a),
      co_3 = fmaf(R->m02, ci->m5, co_3c);
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4c = fmaf(R->m11, ci->m4, co_4a),
      co_4 = fmaf(R->m12, ci->m5, co_4c);
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5c = fmaf(R->m21, ci->m4, co_5a),
      co_5 = fmaf(R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvcf_fused(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0c = fmaf(R->m10, ci->m1, co_0a),
      co_0 = fmaf(R->m20, ci->m2, co_0c);
  const float co_1a = KSL_MULF(R->m01, ci->m0), co_1c = fmaf(R->m11, ci->m1, co_1a),
      co_1 = fmaf(R->m21, ci->m2, co_1c);
  const float co_2a = KSL_MULF(R->m02, ci->m0), co_2c = fmaf(R->m12, ci->m1, co_2a),
      co_2 = fmaf(R->m22, ci->m2, co_2c);
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3c = fmaf(R->m10, ci->m4, co_3a),
      co_3 = fmaf(R->m20, ci->m5, co_3c);
  const float co_4a = KSL_MULF(R->m01, ci->m3), co_4c = fmaf(R->m11, ci->m4, co_4a),
      co_4 = fmaf(R->m21, ci->m5, co_4c);
  const float co_5a = KSL_MULF(R->m02, ci->m3), co_5c = fmaf(R->m12, ci->m4, co_5a),
      co_5 = fmaf(R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   6 mul, 12 fma, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinvf_fused(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0c_lead = -co_0a,
      co_0c = fmaf(-R->m01, ci->m1, co_0c_lead), co_0 = fmaf(-R->m02, ci->m2, co_0c);
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1c_lead = -co_1a,
      co_1c = fmaf(-R->m11, ci->m1, co_1c_lead), co_1 = fmaf(-R->m12, ci->m2, co_1c);
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2c_lead = -co_2a,
      co_2c = fmaf(-R->m21, ci->m1, co_2c_lead), co_2 = fmaf(-R->m22, ci->m2, co_2c);
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3c_lead = -co_3a,
      co_3c = fmaf(-R->m01, ci->m4, co_3c_lead), co_3 = fmaf(-R->m02, ci->m5, co_3c);
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4c_lead = -co_4a,
      co_4c = fmaf(-R->m11, ci->m4, co_4c_lead), co_4 = fmaf(-R->m12, ci->m5, co_4c);
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5c_lead = -co_5a,
      co_5c = fmaf(-R->m21, ci->m4, co_5c_lead), co_5 = fmaf(-R->m22, ci->m5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0c = fmaf(D->m01, ci->m1, w_0a),
      w_0 = fmaf(D->m02, ci->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1c = fmaf(D->m11, ci->m1, w_1a),
      w_1 = fmaf(D->m12, ci->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2c = fmaf(D->m21, ci->m1, w_2a),
      w_2 = fmaf(D->m22, ci->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3c = fmaf(D->m01, ci->m4, w_3a),
      w_3 = fmaf(D->m02, ci->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4c = fmaf(D->m11, ci->m4, w_4a),
      w_4 = fmaf(D->m12, ci->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5c = fmaf(D->m21, ci->m4, w_5a),
      w_5 = fmaf(D->m22, ci->m5, w_5c);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvcf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_3a = KSL_MULF(D->m23, ci->m1), w_3c = fmaf(-D->m13, ci->m2, w_3a),
      w_3 = w_3c + ci->m3;
  const float w_4a = KSL_MULF(D->m03, ci->m2), w_4c = fmaf(-D->m23, ci->m0, w_4a),
      w_4 = w_4c + ci->m4;
  const float w_5a = KSL_MULF(D->m13, ci->m0), w_5c = fmaf(-D->m03, ci->m1, w_5a),
      w_5 = w_5c + ci->m5;
  const float co_0a = KSL_MULF(D->m00, ci->m0), co_0c = fmaf(D->m10, ci->m1, co_0a),
      co_0 = fmaf(D->m20, ci->m2, co_0c);
  const float co_1a = KSL_MULF(D->m01, ci->m0), co_1c = fmaf(D->m11, ci->m1, co_1a),
      co_1 = fmaf(D->m21, ci->m2, co_1c);
  const float co_2a = KSL_MULF(D->m02, ci->m0), co_2c = fmaf(D->m12, ci->m1, co_2a),
      co_2 = fmaf(D->m22, ci->m2, co_2c);
  const float co_3a = KSL_MULF(D->m00, w_3), co_3c = fmaf(D->m10, w_4, co_3a),
      co_3 = fmaf(D->m20, w_5, co_3c);
  const float co_4a = KSL_MULF(D->m01, w_3), co_4c = fmaf(D->m11, w_4, co_4a),
      co_4 = fmaf(D->m21, w_5, co_4c);
  const float co_5a = KSL_MULF(D->m02, w_3), co_5c = fmaf(D->m12, w_4, co_5a),
      co_5 = fmaf(D->m22, w_5, co_5c);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinvf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0c_lead = -w_0a,
      w_0c = fmaf(-D->m01, ci->m1, w_0c_lead), w_0 = fmaf(-D->m02, ci->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1c_lead = -w_1a,
      w_1c = fmaf(-D->m11, ci->m1, w_1c_lead), w_1 = fmaf(-D->m12, ci->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2c_lead = -w_2a,
      w_2c = fmaf(-D->m21, ci->m1, w_2c_lead), w_2 = fmaf(-D->m22, ci->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3c_lead = -w_3a,
      w_3c = fmaf(-D->m01, ci->m4, w_3c_lead), w_3 = fmaf(-D->m02, ci->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4c_lead = -w_4a,
      w_4c = fmaf(-D->m11, ci->m4, w_4c_lead), w_4 = fmaf(-D->m12, ci->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5c_lead = -w_5a,
      w_5c = fmaf(-D->m21, ci->m4, w_5c_lead), w_5 = fmaf(-D->m22, ci->m5, w_5c);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(D->m20, D->m13), co_3 = fmaf(-D->m10, D->m23, co_3a);
  const float co_4a = KSL_MULF(D->m00, D->m23), co_4 = fmaf(-D->m20, D->m03, co_4a);
  const float co_5a = KSL_MULF(D->m10, D->m03), co_5 = fmaf(-D->m00, D->m13, co_5a);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(D->m21, D->m13), co_3 = fmaf(-D->m11, D->m23, co_3a);
  const float co_4a = KSL_MULF(D->m01, D->m23), co_4 = fmaf(-D->m21, D->m03, co_4a);
  const float co_5a = KSL_MULF(D->m11, D->m03), co_5 = fmaf(-D->m01, D->m13, co_5a);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(D->m22, D->m13), co_3 = fmaf(-D->m12, D->m23, co_3a);
  const float co_4a = KSL_MULF(D->m02, D->m23), co_4 = fmaf(-D->m22, D->m03, co_4a);
  const float co_5a = KSL_MULF(D->m12, D->m03), co_5 = fmaf(-D->m02, D->m13, co_5a);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinvf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m00;
  const float co_1 = -D->m10;
  const float co_2 = -D->m20;
  const float co_3a = KSL_MULF(D->m10, D->m23), co_3 = fmaf(-D->m20, D->m13, co_3a);
  const float co_4a = KSL_MULF(D->m20, D->m03), co_4 = fmaf(-D->m00, D->m23, co_4a);
  const float co_5a = KSL_MULF(D->m00, D->m13), co_5 = fmaf(-D->m10, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinvf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m01;
  const float co_1 = -D->m11;
  const float co_2 = -D->m21;
  const float co_3a = KSL_MULF(D->m11, D->m23), co_3 = fmaf(-D->m21, D->m13, co_3a);
  const float co_4a = KSL_MULF(D->m21, D->m03), co_4 = fmaf(-D->m01, D->m23, co_4a);
  const float co_5a = KSL_MULF(D->m01, D->m13), co_5 = fmaf(-D->m11, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinvf_fused(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m02;
  const float co_1 = -D->m12;
  const float co_2 = -D->m22;
  const float co_3a = KSL_MULF(D->m12, D->m23), co_3 = fmaf(-D->m22, D->m13, co_3a);
  const float co_4a = KSL_MULF(D->m22, D->m03), co_4 = fmaf(-D->m02, D->m23, co_4a);
  const float co_5a = KSL_MULF(D->m02, D->m13), co_5 = fmaf(-D->m12, D->m03, co_5a);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   9 mul, 9 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAdf_fused(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_30a = KSL_MULF(D->m20, D->m13), M_30 = fmaf(-D->m10, D->m23, M_30a);
  const float M_31a = KSL_MULF(D->m21, D->m13), M_31 = fmaf(-D->m11, D->m23, M_31a);
  const float M_32a = KSL_MULF(D->m22, D->m13), M_32 = fmaf(-D->m12, D->m23, M_32a);
  const float M_40a = KSL_MULF(D->m00, D->m23), M_40 = fmaf(-D->m20, D->m03, M_40a);
  const float M_41a = KSL_MULF(D->m01, D->m23), M_41 = fmaf(-D->m21, D->m03, M_41a);
  const float M_42a = KSL_MULF(D->m02, D->m23), M_42 = fmaf(-D->m22, D->m03, M_42a);
  const float M_50a = KSL_MULF(D->m10, D->m03), M_50 = fmaf(-D->m00, D->m13, M_50a);
  const float M_51a = KSL_MULF(D->m11, D->m03), M_51 = fmaf(-D->m01, D->m13, M_51a);
  const float M_52a = KSL_MULF(D->m12, D->m03), M_52 = fmaf(-D->m02, D->m13, M_52a);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   2 mul, 1 add, 4 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_reciprocal_productf_fused(const ksl_coscrewf_t *c, const float x[6]) {
  const float power_a = KSL_MULF(c->m0, x[3]), power_c = fmaf(c->m1, x[4], power_a),
      power_e = fmaf(c->m2, x[5], power_c), power_f = KSL_MULF(c->m3, x[0]),
      power_h = fmaf(c->m4, x[1], power_f), power_j = fmaf(c->m5, x[2], power_h),
      power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 9 fma.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scf_fused(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_0a = KSL_MULF(s->m4, c->m2), co_0 = fmaf(-s->m5, c->m1, co_0a);
  const float co_1a = KSL_MULF(s->m5, c->m0), co_1 = fmaf(-s->m3, c->m2, co_1a);
  const float co_2a = KSL_MULF(s->m3, c->m1), co_2 = fmaf(-s->m4, c->m0, co_2a);
  const float co_3a = KSL_MULF(s->m1, c->m2), co_3c = fmaf(-s->m2, c->m1, co_3a),
      co_3d = KSL_MULF(s->m4, c->m5), co_3f = fmaf(-s->m5, c->m4, co_3d), co_3 = co_3c + co_3f;
  const float co_4a = KSL_MULF(s->m2, c->m0), co_4c = fmaf(-s->m0, c->m2, co_4a),
      co_4d = KSL_MULF(s->m5, c->m3), co_4f = fmaf(-s->m3, c->m5, co_4d), co_4 = co_4c + co_4f;
  const float co_5a = KSL_MULF(s->m0, c->m1), co_5c = fmaf(-s->m1, c->m0, co_5a),
      co_5d = KSL_MULF(s->m3, c->m4), co_5f = fmaf(-s->m4, c->m3, co_5d), co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scaf_fused(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_3a = KSL_MULF(s->m4, c->m5), co_3 = fmaf(-s->m5, c->m4, co_3a);
  const float co_4a = KSL_MULF(s->m5, c->m3), co_4 = fmaf(-s->m3, c->m5, co_4a);
  const float co_5a = KSL_MULF(s->m3, c->m4), co_5 = fmaf(-s->m4, c->m3, co_5a);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctxf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m01, c->m1), w_0 = fmaf(D->m02, c->m2, w_0a);
  const float w_1a = KSL_MULF(D->m11, c->m1), w_1 = fmaf(D->m12, c->m2, w_1a);
  const float w_2a = KSL_MULF(D->m21, c->m1), w_2 = fmaf(D->m22, c->m2, w_2a);
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3c = fmaf(D->m01, c->m4, w_3a),
      w_3 = fmaf(D->m02, c->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4c = fmaf(D->m11, c->m4, w_4a),
      w_4 = fmaf(D->m12, c->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5c = fmaf(D->m21, c->m4, w_5a),
      w_5 = fmaf(D->m22, c->m5, w_5c);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctyf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0 = fmaf(D->m02, c->m2, w_0a);
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1 = fmaf(D->m12, c->m2, w_1a);
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2 = fmaf(D->m22, c->m2, w_2a);
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3c = fmaf(D->m01, c->m4, w_3a),
      w_3 = fmaf(D->m02, c->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4c = fmaf(D->m11, c->m4, w_4a),
      w_4 = fmaf(D->m12, c->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5c = fmaf(D->m21, c->m4, w_5a),
      w_5 = fmaf(D->m22, c->m5, w_5c);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctzf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0 = fmaf(D->m01, c->m1, w_0a);
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1 = fmaf(D->m11, c->m1, w_1a);
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2 = fmaf(D->m21, c->m1, w_2a);
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3c = fmaf(D->m01, c->m4, w_3a),
      w_3 = fmaf(D->m02, c->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4c = fmaf(D->m11, c->m4, w_4a),
      w_4 = fmaf(D->m12, c->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5c = fmaf(D->m21, c->m4, w_5a),
      w_5 = fmaf(D->m22, c->m5, w_5c);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crxf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0c = fmaf(D->m01, c->m1, w_0a),
      w_0 = fmaf(D->m02, c->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1c = fmaf(D->m11, c->m1, w_1a),
      w_1 = fmaf(D->m12, c->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2c = fmaf(D->m21, c->m1, w_2a),
      w_2 = fmaf(D->m22, c->m2, w_2c);
  const float w_3a = KSL_MULF(D->m01, c->m4), w_3 = fmaf(D->m02, c->m5, w_3a);
  const float w_4a = KSL_MULF(D->m11, c->m4), w_4 = fmaf(D->m12, c->m5, w_4a);
  const float w_5a = KSL_MULF(D->m21, c->m4), w_5 = fmaf(D->m22, c->m5, w_5a);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cryf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0c = fmaf(D->m01, c->m1, w_0a),
      w_0 = fmaf(D->m02, c->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1c = fmaf(D->m11, c->m1, w_1a),
      w_1 = fmaf(D->m12, c->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2c = fmaf(D->m21, c->m1, w_2a),
      w_2 = fmaf(D->m22, c->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3 = fmaf(D->m02, c->m5, w_3a);
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4 = fmaf(D->m12, c->m5, w_4a);
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5 = fmaf(D->m22, c->m5, w_5a);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 12 fma.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crzf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0c = fmaf(D->m01, c->m1, w_0a),
      w_0 = fmaf(D->m02, c->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1c = fmaf(D->m11, c->m1, w_1a),
      w_1 = fmaf(D->m12, c->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2c = fmaf(D->m21, c->m1, w_2a),
      w_2 = fmaf(D->m22, c->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3 = fmaf(D->m01, c->m4, w_3a);
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4 = fmaf(D->m11, c->m4, w_4a);
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5 = fmaf(D->m21, c->m4, w_5a);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3c = fmaf(-D->m23, w_1, co_3a), co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4c = fmaf(-D->m03, w_2, co_4a), co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5c = fmaf(-D->m13, w_0, co_5a), co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctxf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0);
  const float w_1 = KSL_MULF(D->m10, c->m0);
  const float w_2 = KSL_MULF(D->m20, c->m0);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3 = fmaf(-D->m23, w_1, co_3a);
  const float co_4a = KSL_MULF(D->m23, w_0), co_4 = fmaf(-D->m03, w_2, co_4a);
  const float co_5a = KSL_MULF(D->m03, w_1), co_5 = fmaf(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctyf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m01, c->m1);
  const float w_1 = KSL_MULF(D->m11, c->m1);
  const float w_2 = KSL_MULF(D->m21, c->m1);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3 = fmaf(-D->m23, w_1, co_3a);
  const float co_4a = KSL_MULF(D->m23, w_0), co_4 = fmaf(-D->m03, w_2, co_4a);
  const float co_5a = KSL_MULF(D->m03, w_1), co_5 = fmaf(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   6 mul, 3 fma.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctzf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m02, c->m2);
  const float w_1 = KSL_MULF(D->m12, c->m2);
  const float w_2 = KSL_MULF(D->m22, c->m2);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3 = fmaf(-D->m23, w_1, co_3a);
  const float co_4a = KSL_MULF(D->m23, w_0), co_4 = fmaf(-D->m03, w_2, co_4a);
  const float co_5a = KSL_MULF(D->m03, w_1), co_5 = fmaf(-D->m13, w_0, co_5a);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crxf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m00, c->m3);
  const float w_4 = KSL_MULF(D->m10, c->m3);
  const float w_5 = KSL_MULF(D->m20, c->m3);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cryf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m01, c->m4);
  const float w_4 = KSL_MULF(D->m11, c->m4);
  const float w_5 = KSL_MULF(D->m21, c->m4);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crzf_fused(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m02, c->m5);
  const float w_4 = KSL_MULF(D->m12, c->m5);
  const float w_5 = KSL_MULF(D->m22, c->m5);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

#endif
