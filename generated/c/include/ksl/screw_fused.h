/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Fused tier: products fused into sums. */
#ifndef KSL_SCREW_FUSED_H
#define KSL_SCREW_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale_fused(ksl_screw_t *self, const double a) {
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
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_ss_fused(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss_fused(const ksl_screw_t *x, ksl_screw_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss_fused(const ksl_screw_t *x, ksl_screw_t *y) {
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

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_as_fused(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(a, si->m0);
  const double so_1 = KSL_MUL(a, si->m1);
  const double so_2 = KSL_MUL(a, si->m2);
  const double so_3 = KSL_MUL(a, si->m3);
  const double so_4 = KSL_MUL(a, si->m4);
  const double so_5 = KSL_MUL(a, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss_fused(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double so_3 = s1->m3 + s2->m3;
  const double so_4 = s1->m4 + s2->m4;
  const double so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss_fused(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0;
  const double so_1 = s1->m1 - s2->m1;
  const double so_2 = s1->m2 - s2->m2;
  const double so_3 = s1->m3 - s2->m3;
  const double so_4 = s1->m4 - s2->m4;
  const double so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst_fused(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adts_fused(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->y, si->m5), so_0c = fma(-t->z, si->m4, so_0a),
      so_0 = so_0c + si->m0;
  const double so_1a = KSL_MUL(t->z, si->m3), so_1c = fma(-t->x, si->m5, so_1a),
      so_1 = so_1c + si->m1;
  const double so_2a = KSL_MUL(t->x, si->m4), so_2c = fma(-t->y, si->m3, so_2a),
      so_2 = so_2c + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvs_fused(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0c = fma(-t->y, si->m5, so_0a),
      so_0 = so_0c + si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1c = fma(-t->z, si->m3, so_1a),
      so_1 = so_1c + si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2c = fma(-t->x, si->m4, so_2a),
      so_2 = so_2c + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinv_fused(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0c = fma(-t->y, si->m5, so_0a),
      so_0 = so_0c - si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1c = fma(-t->z, si->m3, so_1a),
      so_1 = so_1c - si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2c = fma(-t->x, si->m4, so_2a),
      so_2 = so_2c - si->m2;
  const double so_3 = -si->m3;
  const double so_4 = -si->m4;
  const double so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrs_fused(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0c = fma(R->m01, si->m1, so_0a),
      so_0 = fma(R->m02, si->m2, so_0c);
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1c = fma(R->m11, si->m1, so_1a),
      so_1 = fma(R->m12, si->m2, so_1c);
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2c = fma(R->m21, si->m1, so_2a),
      so_2 = fma(R->m22, si->m2, so_2c);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3c = fma(R->m01, si->m4, so_3a),
      so_3 = fma(R->m02, si->m5, so_3c);
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4c = fma(R->m11, si->m4, so_4a),
      so_4 = fma(R->m12, si->m5, so_4c);
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5c = fma(R->m21, si->m4, so_5a),
      so_5 = fma(R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvs_fused(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0c = fma(R->m10, si->m1, so_0a),
      so_0 = fma(R->m20, si->m2, so_0c);
  const double so_1a = KSL_MUL(R->m01, si->m0), so_1c = fma(R->m11, si->m1, so_1a),
      so_1 = fma(R->m21, si->m2, so_1c);
  const double so_2a = KSL_MUL(R->m02, si->m0), so_2c = fma(R->m12, si->m1, so_2a),
      so_2 = fma(R->m22, si->m2, so_2c);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3c = fma(R->m10, si->m4, so_3a),
      so_3 = fma(R->m20, si->m5, so_3c);
  const double so_4a = KSL_MUL(R->m01, si->m3), so_4c = fma(R->m11, si->m4, so_4a),
      so_4 = fma(R->m21, si->m5, so_4c);
  const double so_5a = KSL_MUL(R->m02, si->m3), so_5c = fma(R->m12, si->m4, so_5a),
      so_5 = fma(R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinv_fused(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0c_lead = -so_0a,
      so_0c = fma(-R->m01, si->m1, so_0c_lead), so_0 = fma(-R->m02, si->m2, so_0c);
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1c_lead = -so_1a,
      so_1c = fma(-R->m11, si->m1, so_1c_lead), so_1 = fma(-R->m12, si->m2, so_1c);
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2c_lead = -so_2a,
      so_2c = fma(-R->m21, si->m1, so_2c_lead), so_2 = fma(-R->m22, si->m2, so_2c);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3c_lead = -so_3a,
      so_3c = fma(-R->m01, si->m4, so_3c_lead), so_3 = fma(-R->m02, si->m5, so_3c);
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4c_lead = -so_4a,
      so_4c = fma(-R->m11, si->m4, so_4c_lead), so_4 = fma(-R->m12, si->m5, so_4c);
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5c_lead = -so_5a,
      so_5c = fma(-R->m21, si->m4, so_5c_lead), so_5 = fma(-R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Ads_fused(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0c = fma(D->m01, si->m1, w_0a),
      w_0 = fma(D->m02, si->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1c = fma(D->m11, si->m1, w_1a),
      w_1 = fma(D->m12, si->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2c = fma(D->m21, si->m1, w_2a),
      w_2 = fma(D->m22, si->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3c = fma(D->m01, si->m4, w_3a),
      w_3 = fma(D->m02, si->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4c = fma(D->m11, si->m4, w_4a),
      w_4 = fma(D->m12, si->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5c = fma(D->m21, si->m4, w_5a),
      w_5 = fma(D->m22, si->m5, w_5c);
  const double so_0a = KSL_MUL(D->m13, w_5), so_0c = fma(-D->m23, w_4, so_0a), so_0 = so_0c + w_0;
  const double so_1a = KSL_MUL(D->m23, w_3), so_1c = fma(-D->m03, w_5, so_1a), so_1 = so_1c + w_1;
  const double so_2a = KSL_MUL(D->m03, w_4), so_2c = fma(-D->m13, w_3, so_2a), so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvs_fused(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m23, si->m4), w_0c = fma(-D->m13, si->m5, w_0a),
      w_0 = w_0c + si->m0;
  const double w_1a = KSL_MUL(D->m03, si->m5), w_1c = fma(-D->m23, si->m3, w_1a),
      w_1 = w_1c + si->m1;
  const double w_2a = KSL_MUL(D->m13, si->m3), w_2c = fma(-D->m03, si->m4, w_2a),
      w_2 = w_2c + si->m2;
  const double so_0a = KSL_MUL(D->m00, w_0), so_0c = fma(D->m10, w_1, so_0a),
      so_0 = fma(D->m20, w_2, so_0c);
  const double so_1a = KSL_MUL(D->m01, w_0), so_1c = fma(D->m11, w_1, so_1a),
      so_1 = fma(D->m21, w_2, so_1c);
  const double so_2a = KSL_MUL(D->m02, w_0), so_2c = fma(D->m12, w_1, so_2a),
      so_2 = fma(D->m22, w_2, so_2c);
  const double so_3a = KSL_MUL(D->m00, si->m3), so_3c = fma(D->m10, si->m4, so_3a),
      so_3 = fma(D->m20, si->m5, so_3c);
  const double so_4a = KSL_MUL(D->m01, si->m3), so_4c = fma(D->m11, si->m4, so_4a),
      so_4 = fma(D->m21, si->m5, so_4c);
  const double so_5a = KSL_MUL(D->m02, si->m3), so_5c = fma(D->m12, si->m4, so_5a),
      so_5 = fma(D->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinv_fused(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0c_lead = -w_0a,
      w_0c = fma(-D->m01, si->m1, w_0c_lead), w_0 = fma(-D->m02, si->m2, w_0c);
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1c_lead = -w_1a,
      w_1c = fma(-D->m11, si->m1, w_1c_lead), w_1 = fma(-D->m12, si->m2, w_1c);
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2c_lead = -w_2a,
      w_2c = fma(-D->m21, si->m1, w_2c_lead), w_2 = fma(-D->m22, si->m2, w_2c);
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3c_lead = -w_3a,
      w_3c = fma(-D->m01, si->m4, w_3c_lead), w_3 = fma(-D->m02, si->m5, w_3c);
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4c_lead = -w_4a,
      w_4c = fma(-D->m11, si->m4, w_4c_lead), w_4 = fma(-D->m12, si->m5, w_4c);
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5c_lead = -w_5a,
      w_5c = fma(-D->m21, si->m4, w_5c_lead), w_5 = fma(-D->m22, si->m5, w_5c);
  const double so_0a = KSL_MUL(D->m13, w_5), so_0c = fma(-D->m23, w_4, so_0a), so_0 = so_0c + w_0;
  const double so_1a = KSL_MUL(D->m23, w_3), so_1c = fma(-D->m03, w_5, so_1a), so_1 = so_1c + w_1;
  const double so_2a = KSL_MUL(D->m03, w_4), so_2c = fma(-D->m13, w_3, so_2a), so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrx_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m20, D->m13), so_0 = fma(-D->m10, D->m23, so_0a);
  const double so_1a = KSL_MUL(D->m00, D->m23), so_1 = fma(-D->m20, D->m03, so_1a);
  const double so_2a = KSL_MUL(D->m10, D->m03), so_2 = fma(-D->m00, D->m13, so_2a);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsry_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m21, D->m13), so_0 = fma(-D->m11, D->m23, so_0a);
  const double so_1a = KSL_MUL(D->m01, D->m23), so_1 = fma(-D->m21, D->m03, so_1a);
  const double so_2a = KSL_MUL(D->m11, D->m03), so_2 = fma(-D->m01, D->m13, so_2a);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrz_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m22, D->m13), so_0 = fma(-D->m12, D->m23, so_0a);
  const double so_1a = KSL_MUL(D->m02, D->m23), so_1 = fma(-D->m22, D->m03, so_1a);
  const double so_2a = KSL_MUL(D->m12, D->m03), so_2 = fma(-D->m02, D->m13, so_2a);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinv_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m10, D->m23), so_0 = fma(-D->m20, D->m13, so_0a);
  const double so_1a = KSL_MUL(D->m20, D->m03), so_1 = fma(-D->m00, D->m23, so_1a);
  const double so_2a = KSL_MUL(D->m00, D->m13), so_2 = fma(-D->m10, D->m03, so_2a);
  const double so_3 = -D->m00;
  const double so_4 = -D->m10;
  const double so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinv_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m11, D->m23), so_0 = fma(-D->m21, D->m13, so_0a);
  const double so_1a = KSL_MUL(D->m21, D->m03), so_1 = fma(-D->m01, D->m23, so_1a);
  const double so_2a = KSL_MUL(D->m01, D->m13), so_2 = fma(-D->m11, D->m03, so_2a);
  const double so_3 = -D->m01;
  const double so_4 = -D->m11;
  const double so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinv_fused(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m12, D->m23), so_0 = fma(-D->m22, D->m13, so_0a);
  const double so_1a = KSL_MUL(D->m22, D->m03), so_1 = fma(-D->m02, D->m23, so_1a);
  const double so_2a = KSL_MUL(D->m02, D->m13), so_2 = fma(-D->m12, D->m03, so_2a);
  const double so_3 = -D->m02;
  const double so_4 = -D->m12;
  const double so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   9 mul, 9 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad_fused(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = KSL_MUL(D->m20, D->m13), M_03 = fma(-D->m10, D->m23, M_03a);
  const double M_04a = KSL_MUL(D->m21, D->m13), M_04 = fma(-D->m11, D->m23, M_04a);
  const double M_05a = KSL_MUL(D->m22, D->m13), M_05 = fma(-D->m12, D->m23, M_05a);
  const double M_13a = KSL_MUL(D->m00, D->m23), M_13 = fma(-D->m20, D->m03, M_13a);
  const double M_14a = KSL_MUL(D->m01, D->m23), M_14 = fma(-D->m21, D->m03, M_14a);
  const double M_15a = KSL_MUL(D->m02, D->m23), M_15 = fma(-D->m22, D->m03, M_15a);
  const double M_23a = KSL_MUL(D->m10, D->m03), M_23 = fma(-D->m00, D->m13, M_23a);
  const double M_24a = KSL_MUL(D->m11, D->m03), M_24 = fma(-D->m01, D->m13, M_24a);
  const double M_25a = KSL_MUL(D->m12, D->m03), M_25 = fma(-D->m02, D->m13, M_25a);
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
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   2 mul, 1 add, 4 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_cs_fused(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = KSL_MUL(c->m0, s->m0), power_c = fma(c->m1, s->m1, power_a),
      power_e = fma(c->m2, s->m2, power_c), power_f = KSL_MUL(c->m3, s->m3),
      power_h = fma(c->m4, s->m4, power_f), power_j = fma(c->m5, s->m5, power_h),
      power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 9 fma.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ss_fused(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(s1->m1, s2->m5), so_0c = fma(-s1->m5, s2->m1, so_0a),
      so_0d = KSL_MUL(s1->m4, s2->m2), so_0f = fma(-s1->m2, s2->m4, so_0d), so_0 = so_0c + so_0f;
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1c = fma(-s1->m0, s2->m5, so_1a),
      so_1d = KSL_MUL(s1->m2, s2->m3), so_1f = fma(-s1->m3, s2->m2, so_1d), so_1 = so_1c + so_1f;
  const double so_2a = KSL_MUL(s1->m0, s2->m4), so_2c = fma(-s1->m4, s2->m0, so_2a),
      so_2d = KSL_MUL(s1->m3, s2->m1), so_2f = fma(-s1->m1, s2->m3, so_2d), so_2 = so_2c + so_2f;
  const double so_3a = KSL_MUL(s1->m4, s2->m5), so_3 = fma(-s1->m5, s2->m4, so_3a);
  const double so_4a = KSL_MUL(s1->m5, s2->m3), so_4 = fma(-s1->m3, s2->m5, so_4a);
  const double so_5a = KSL_MUL(s1->m3, s2->m4), so_5 = fma(-s1->m4, s2->m3, so_5a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sst_fused(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(s1->m4, s2->m2), so_0 = fma(-s1->m5, s2->m1, so_0a);
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1 = fma(-s1->m3, s2->m2, so_1a);
  const double so_2a = KSL_MUL(s1->m3, s2->m1), so_2 = fma(-s1->m4, s2->m0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   6 mul, 9 fma.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsra_fused(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0c = fma(D->m01, axis->y, a_0a),
      a_0 = fma(D->m02, axis->z, a_0c);
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1c = fma(D->m11, axis->y, a_1a),
      a_1 = fma(D->m12, axis->z, a_1c);
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2c = fma(D->m21, axis->y, a_2a),
      a_2 = fma(D->m22, axis->z, a_2c);
  const double so_0a = KSL_MUL(D->m13, a_2), so_0 = fma(-D->m23, a_1, so_0a);
  const double so_1a = KSL_MUL(D->m23, a_0), so_1 = fma(-D->m03, a_2, so_1a);
  const double so_2a = KSL_MUL(D->m03, a_1), so_2 = fma(-D->m13, a_0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   3 mul, 6 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsta_fused(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0c = fma(D->m01, axis->y, so_0a),
      so_0 = fma(D->m02, axis->z, so_0c);
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1c = fma(D->m11, axis->y, so_1a),
      so_1 = fma(D->m12, axis->z, so_1c);
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2c = fma(D->m21, axis->y, so_2a),
      so_2 = fma(D->m22, axis->z, so_2c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   6 mul, 9 fma, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainv_fused(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0c_lead = -a_0a,
      a_0c = fma(-D->m01, axis->y, a_0c_lead), a_0 = fma(-D->m02, axis->z, a_0c);
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1c_lead = -a_1a,
      a_1c = fma(-D->m11, axis->y, a_1c_lead), a_1 = fma(-D->m12, axis->z, a_1c);
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2c_lead = -a_2a,
      a_2c = fma(-D->m21, axis->y, a_2c_lead), a_2 = fma(-D->m22, axis->z, a_2c);
  const double so_0a = KSL_MUL(D->m13, a_2), so_0 = fma(-D->m23, a_1, so_0a);
  const double so_1a = KSL_MUL(D->m23, a_0), so_1 = fma(-D->m03, a_2, so_1a);
  const double so_2a = KSL_MUL(D->m03, a_1), so_2 = fma(-D->m13, a_0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainv_fused(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0c_lead = -so_0a,
      so_0c = fma(-D->m01, axis->y, so_0c_lead), so_0 = fma(-D->m02, axis->z, so_0c);
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1c_lead = -so_1a,
      so_1c = fma(-D->m11, axis->y, so_1c_lead), so_1 = fma(-D->m12, axis->z, so_1c);
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2c_lead = -so_2a,
      so_2c = fma(-D->m21, axis->y, so_2c_lead), so_2 = fma(-D->m22, axis->z, so_2c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screwf_scale_fused(ksl_screwf_t *self, const float a) {
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
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_ssf_fused(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ssf_fused(const ksl_screwf_t *x, ksl_screwf_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ssf_fused(const ksl_screwf_t *x, ksl_screwf_t *y) {
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

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_asf_fused(const float a, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(a, si->m0);
  const float so_1 = KSL_MULF(a, si->m1);
  const float so_2 = KSL_MULF(a, si->m2);
  const float so_3 = KSL_MULF(a, si->m3);
  const float so_4 = KSL_MULF(a, si->m4);
  const float so_5 = KSL_MULF(a, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ssf_fused(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float so_3 = s1->m3 + s2->m3;
  const float so_4 = s1->m4 + s2->m4;
  const float so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ssf_fused(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = s1->m0 - s2->m0;
  const float so_1 = s1->m1 - s2->m1;
  const float so_2 = s1->m2 - s2->m2;
  const float so_3 = s1->m3 - s2->m3;
  const float so_4 = s1->m4 - s2->m4;
  const float so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sstf_fused(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsf_fused(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(t->y, si->m5), so_0c = fmaf(-t->z, si->m4, so_0a),
      so_0 = so_0c + si->m0;
  const float so_1a = KSL_MULF(t->z, si->m3), so_1c = fmaf(-t->x, si->m5, so_1a),
      so_1 = so_1c + si->m1;
  const float so_2a = KSL_MULF(t->x, si->m4), so_2c = fmaf(-t->y, si->m3, so_2a),
      so_2 = so_2c + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvsf_fused(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0c = fmaf(-t->y, si->m5, so_0a),
      so_0 = so_0c + si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1c = fmaf(-t->z, si->m3, so_1a),
      so_1 = so_1c + si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2c = fmaf(-t->x, si->m4, so_2a),
      so_2 = so_2c + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 fma, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinvf_fused(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0c = fmaf(-t->y, si->m5, so_0a),
      so_0 = so_0c - si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1c = fmaf(-t->z, si->m3, so_1a),
      so_1 = so_1c - si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2c = fmaf(-t->x, si->m4, so_2a),
      so_2 = so_2c - si->m2;
  const float so_3 = -si->m3;
  const float so_4 = -si->m4;
  const float so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsf_fused(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0c = fmaf(R->m01, si->m1, so_0a),
      so_0 = fmaf(R->m02, si->m2, so_0c);
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1c = fmaf(R->m11, si->m1, so_1a),
      so_1 = fmaf(R->m12, si->m2, so_1c);
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2c = fmaf(R->m21, si->m1, so_2a),
      so_2 = fmaf(R->m22, si->m2, so_2c);
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3c = fmaf(R->m01, si->m4, so_3a),
      so_3 = fmaf(R->m02, si->m5, so_3c);
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4c = fmaf(R->m11, si->m4, so_4a),
      so_4 = fmaf(R->m12, si->m5, so_4c);
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5c = fmaf(R->m21, si->m4, so_5a),
      so_5 = fmaf(R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvsf_fused(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0c = fmaf(R->m10, si->m1, so_0a),
      so_0 = fmaf(R->m20, si->m2, so_0c);
  const float so_1a = KSL_MULF(R->m01, si->m0), so_1c = fmaf(R->m11, si->m1, so_1a),
      so_1 = fmaf(R->m21, si->m2, so_1c);
  const float so_2a = KSL_MULF(R->m02, si->m0), so_2c = fmaf(R->m12, si->m1, so_2a),
      so_2 = fmaf(R->m22, si->m2, so_2c);
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3c = fmaf(R->m10, si->m4, so_3a),
      so_3 = fmaf(R->m20, si->m5, so_3c);
  const float so_4a = KSL_MULF(R->m01, si->m3), so_4c = fmaf(R->m11, si->m4, so_4a),
      so_4 = fmaf(R->m21, si->m5, so_4c);
  const float so_5a = KSL_MULF(R->m02, si->m3), so_5c = fmaf(R->m12, si->m4, so_5a),
      so_5 = fmaf(R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 12 fma, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinvf_fused(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0c_lead = -so_0a,
      so_0c = fmaf(-R->m01, si->m1, so_0c_lead), so_0 = fmaf(-R->m02, si->m2, so_0c);
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1c_lead = -so_1a,
      so_1c = fmaf(-R->m11, si->m1, so_1c_lead), so_1 = fmaf(-R->m12, si->m2, so_1c);
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2c_lead = -so_2a,
      so_2c = fmaf(-R->m21, si->m1, so_2c_lead), so_2 = fmaf(-R->m22, si->m2, so_2c);
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3c_lead = -so_3a,
      so_3c = fmaf(-R->m01, si->m4, so_3c_lead), so_3 = fmaf(-R->m02, si->m5, so_3c);
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4c_lead = -so_4a,
      so_4c = fmaf(-R->m11, si->m4, so_4c_lead), so_4 = fmaf(-R->m12, si->m5, so_4c);
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5c_lead = -so_5a,
      so_5c = fmaf(-R->m21, si->m4, so_5c_lead), so_5 = fmaf(-R->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsf_fused(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0c = fmaf(D->m01, si->m1, w_0a),
      w_0 = fmaf(D->m02, si->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1c = fmaf(D->m11, si->m1, w_1a),
      w_1 = fmaf(D->m12, si->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2c = fmaf(D->m21, si->m1, w_2a),
      w_2 = fmaf(D->m22, si->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3c = fmaf(D->m01, si->m4, w_3a),
      w_3 = fmaf(D->m02, si->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4c = fmaf(D->m11, si->m4, w_4a),
      w_4 = fmaf(D->m12, si->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5c = fmaf(D->m21, si->m4, w_5a),
      w_5 = fmaf(D->m22, si->m5, w_5c);
  const float so_0a = KSL_MULF(D->m13, w_5), so_0c = fmaf(-D->m23, w_4, so_0a), so_0 = so_0c + w_0;
  const float so_1a = KSL_MULF(D->m23, w_3), so_1c = fmaf(-D->m03, w_5, so_1a), so_1 = so_1c + w_1;
  const float so_2a = KSL_MULF(D->m03, w_4), so_2c = fmaf(-D->m13, w_3, so_2a), so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvsf_fused(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = KSL_MULF(D->m23, si->m4), w_0c = fmaf(-D->m13, si->m5, w_0a),
      w_0 = w_0c + si->m0;
  const float w_1a = KSL_MULF(D->m03, si->m5), w_1c = fmaf(-D->m23, si->m3, w_1a),
      w_1 = w_1c + si->m1;
  const float w_2a = KSL_MULF(D->m13, si->m3), w_2c = fmaf(-D->m03, si->m4, w_2a),
      w_2 = w_2c + si->m2;
  const float so_0a = KSL_MULF(D->m00, w_0), so_0c = fmaf(D->m10, w_1, so_0a),
      so_0 = fmaf(D->m20, w_2, so_0c);
  const float so_1a = KSL_MULF(D->m01, w_0), so_1c = fmaf(D->m11, w_1, so_1a),
      so_1 = fmaf(D->m21, w_2, so_1c);
  const float so_2a = KSL_MULF(D->m02, w_0), so_2c = fmaf(D->m12, w_1, so_2a),
      so_2 = fmaf(D->m22, w_2, so_2c);
  const float so_3a = KSL_MULF(D->m00, si->m3), so_3c = fmaf(D->m10, si->m4, so_3a),
      so_3 = fmaf(D->m20, si->m5, so_3c);
  const float so_4a = KSL_MULF(D->m01, si->m3), so_4c = fmaf(D->m11, si->m4, so_4a),
      so_4 = fmaf(D->m21, si->m5, so_4c);
  const float so_5a = KSL_MULF(D->m02, si->m3), so_5c = fmaf(D->m12, si->m4, so_5a),
      so_5 = fmaf(D->m22, si->m5, so_5c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 15 fma, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinvf_fused(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0c_lead = -w_0a,
      w_0c = fmaf(-D->m01, si->m1, w_0c_lead), w_0 = fmaf(-D->m02, si->m2, w_0c);
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1c_lead = -w_1a,
      w_1c = fmaf(-D->m11, si->m1, w_1c_lead), w_1 = fmaf(-D->m12, si->m2, w_1c);
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2c_lead = -w_2a,
      w_2c = fmaf(-D->m21, si->m1, w_2c_lead), w_2 = fmaf(-D->m22, si->m2, w_2c);
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3c_lead = -w_3a,
      w_3c = fmaf(-D->m01, si->m4, w_3c_lead), w_3 = fmaf(-D->m02, si->m5, w_3c);
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4c_lead = -w_4a,
      w_4c = fmaf(-D->m11, si->m4, w_4c_lead), w_4 = fmaf(-D->m12, si->m5, w_4c);
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5c_lead = -w_5a,
      w_5c = fmaf(-D->m21, si->m4, w_5c_lead), w_5 = fmaf(-D->m22, si->m5, w_5c);
  const float so_0a = KSL_MULF(D->m13, w_5), so_0c = fmaf(-D->m23, w_4, so_0a), so_0 = so_0c + w_0;
  const float so_1a = KSL_MULF(D->m23, w_3), so_1c = fmaf(-D->m03, w_5, so_1a), so_1 = so_1c + w_1;
  const float so_2a = KSL_MULF(D->m03, w_4), so_2c = fmaf(-D->m13, w_3, so_2a), so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m20, D->m13), so_0 = fmaf(-D->m10, D->m23, so_0a);
  const float so_1a = KSL_MULF(D->m00, D->m23), so_1 = fmaf(-D->m20, D->m03, so_1a);
  const float so_2a = KSL_MULF(D->m10, D->m03), so_2 = fmaf(-D->m00, D->m13, so_2a);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m21, D->m13), so_0 = fmaf(-D->m11, D->m23, so_0a);
  const float so_1a = KSL_MULF(D->m01, D->m23), so_1 = fmaf(-D->m21, D->m03, so_1a);
  const float so_2a = KSL_MULF(D->m11, D->m03), so_2 = fmaf(-D->m01, D->m13, so_2a);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m22, D->m13), so_0 = fmaf(-D->m12, D->m23, so_0a);
  const float so_1a = KSL_MULF(D->m02, D->m23), so_1 = fmaf(-D->m22, D->m03, so_1a);
  const float so_2a = KSL_MULF(D->m12, D->m03), so_2 = fmaf(-D->m02, D->m13, so_2a);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinvf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m10, D->m23), so_0 = fmaf(-D->m20, D->m13, so_0a);
  const float so_1a = KSL_MULF(D->m20, D->m03), so_1 = fmaf(-D->m00, D->m23, so_1a);
  const float so_2a = KSL_MULF(D->m00, D->m13), so_2 = fmaf(-D->m10, D->m03, so_2a);
  const float so_3 = -D->m00;
  const float so_4 = -D->m10;
  const float so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinvf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m11, D->m23), so_0 = fmaf(-D->m21, D->m13, so_0a);
  const float so_1a = KSL_MULF(D->m21, D->m03), so_1 = fmaf(-D->m01, D->m23, so_1a);
  const float so_2a = KSL_MULF(D->m01, D->m13), so_2 = fmaf(-D->m11, D->m03, so_2a);
  const float so_3 = -D->m01;
  const float so_4 = -D->m11;
  const float so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinvf_fused(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m12, D->m23), so_0 = fmaf(-D->m22, D->m13, so_0a);
  const float so_1a = KSL_MULF(D->m22, D->m03), so_1 = fmaf(-D->m02, D->m23, so_1a);
  const float so_2a = KSL_MULF(D->m02, D->m13), so_2 = fmaf(-D->m12, D->m03, so_2a);
  const float so_3 = -D->m02;
  const float so_4 = -D->m12;
  const float so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   9 mul, 9 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Adf_fused(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_03a = KSL_MULF(D->m20, D->m13), M_03 = fmaf(-D->m10, D->m23, M_03a);
  const float M_04a = KSL_MULF(D->m21, D->m13), M_04 = fmaf(-D->m11, D->m23, M_04a);
  const float M_05a = KSL_MULF(D->m22, D->m13), M_05 = fmaf(-D->m12, D->m23, M_05a);
  const float M_13a = KSL_MULF(D->m00, D->m23), M_13 = fmaf(-D->m20, D->m03, M_13a);
  const float M_14a = KSL_MULF(D->m01, D->m23), M_14 = fmaf(-D->m21, D->m03, M_14a);
  const float M_15a = KSL_MULF(D->m02, D->m23), M_15 = fmaf(-D->m22, D->m03, M_15a);
  const float M_23a = KSL_MULF(D->m10, D->m03), M_23 = fmaf(-D->m00, D->m13, M_23a);
  const float M_24a = KSL_MULF(D->m11, D->m03), M_24 = fmaf(-D->m01, D->m13, M_24a);
  const float M_25a = KSL_MULF(D->m12, D->m03), M_25 = fmaf(-D->m02, D->m13, M_25a);
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
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   2 mul, 1 add, 4 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_csf_fused(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const float power_a = KSL_MULF(c->m0, s->m0), power_c = fmaf(c->m1, s->m1, power_a),
      power_e = fmaf(c->m2, s->m2, power_c), power_f = KSL_MULF(c->m3, s->m3),
      power_h = fmaf(c->m4, s->m4, power_f), power_j = fmaf(c->m5, s->m5, power_h),
      power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   9 mul, 3 add, 9 fma.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ssf_fused(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(s1->m1, s2->m5), so_0c = fmaf(-s1->m5, s2->m1, so_0a),
      so_0d = KSL_MULF(s1->m4, s2->m2), so_0f = fmaf(-s1->m2, s2->m4, so_0d), so_0 = so_0c + so_0f;
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1c = fmaf(-s1->m0, s2->m5, so_1a),
      so_1d = KSL_MULF(s1->m2, s2->m3), so_1f = fmaf(-s1->m3, s2->m2, so_1d), so_1 = so_1c + so_1f;
  const float so_2a = KSL_MULF(s1->m0, s2->m4), so_2c = fmaf(-s1->m4, s2->m0, so_2a),
      so_2d = KSL_MULF(s1->m3, s2->m1), so_2f = fmaf(-s1->m1, s2->m3, so_2d), so_2 = so_2c + so_2f;
  const float so_3a = KSL_MULF(s1->m4, s2->m5), so_3 = fmaf(-s1->m5, s2->m4, so_3a);
  const float so_4a = KSL_MULF(s1->m5, s2->m3), so_4 = fmaf(-s1->m3, s2->m5, so_4a);
  const float so_5a = KSL_MULF(s1->m3, s2->m4), so_5 = fmaf(-s1->m4, s2->m3, so_5a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 mul, 3 fma.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sstf_fused(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(s1->m4, s2->m2), so_0 = fmaf(-s1->m5, s2->m1, so_0a);
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1 = fmaf(-s1->m3, s2->m2, so_1a);
  const float so_2a = KSL_MULF(s1->m3, s2->m1), so_2 = fmaf(-s1->m4, s2->m0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   6 mul, 9 fma.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsraf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0c = fmaf(D->m01, axis->y, a_0a),
      a_0 = fmaf(D->m02, axis->z, a_0c);
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1c = fmaf(D->m11, axis->y, a_1a),
      a_1 = fmaf(D->m12, axis->z, a_1c);
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2c = fmaf(D->m21, axis->y, a_2a),
      a_2 = fmaf(D->m22, axis->z, a_2c);
  const float so_0a = KSL_MULF(D->m13, a_2), so_0 = fmaf(-D->m23, a_1, so_0a);
  const float so_1a = KSL_MULF(D->m23, a_0), so_1 = fmaf(-D->m03, a_2, so_1a);
  const float so_2a = KSL_MULF(D->m03, a_1), so_2 = fmaf(-D->m13, a_0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   3 mul, 6 fma.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstaf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0c = fmaf(D->m01, axis->y, so_0a),
      so_0 = fmaf(D->m02, axis->z, so_0c);
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1c = fmaf(D->m11, axis->y, so_1a),
      so_1 = fmaf(D->m12, axis->z, so_1c);
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2c = fmaf(D->m21, axis->y, so_2a),
      so_2 = fmaf(D->m22, axis->z, so_2c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   6 mul, 9 fma, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0c_lead = -a_0a,
      a_0c = fmaf(-D->m01, axis->y, a_0c_lead), a_0 = fmaf(-D->m02, axis->z, a_0c);
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1c_lead = -a_1a,
      a_1c = fmaf(-D->m11, axis->y, a_1c_lead), a_1 = fmaf(-D->m12, axis->z, a_1c);
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2c_lead = -a_2a,
      a_2c = fmaf(-D->m21, axis->y, a_2c_lead), a_2 = fmaf(-D->m22, axis->z, a_2c);
  const float so_0a = KSL_MULF(D->m13, a_2), so_0 = fmaf(-D->m23, a_1, so_0a);
  const float so_1a = KSL_MULF(D->m23, a_0), so_1 = fmaf(-D->m03, a_2, so_1a);
  const float so_2a = KSL_MULF(D->m03, a_1), so_2 = fmaf(-D->m13, a_0, so_2a);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0c_lead = -so_0a,
      so_0c = fmaf(-D->m01, axis->y, so_0c_lead), so_0 = fmaf(-D->m02, axis->z, so_0c);
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1c_lead = -so_1a,
      so_1c = fmaf(-D->m11, axis->y, so_1c_lead), so_1 = fmaf(-D->m12, axis->z, so_1c);
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2c_lead = -so_2a,
      so_2c = fmaf(-D->m21, axis->y, so_2c_lead), so_2 = fmaf(-D->m22, axis->z, so_2c);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

#endif
