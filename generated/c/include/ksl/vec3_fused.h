/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.
   Fused tier: products fused into sums. */
#ifndef KSL_VEC3_FUSED_H
#define KSL_VEC3_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale_fused(ksl_vec3_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_vv_fused(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = fma(a, x->x, y->x);
  const double y_1_new = fma(a, x->y, y->y);
  const double y_2_new = fma(a, x->z, y->z);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv_fused(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x;
  const double y_1_new = x->y + y->y;
  const double y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv_fused(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x;
  const double y_1_new = y->y - x->y;
  const double y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av_fused(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(a, vi->x);
  const double vo_1 = KSL_MUL(a, vi->y);
  const double vo_2 = KSL_MUL(a, vi->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv_fused(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x;
  const double vo_1 = v1->y + v2->y;
  const double vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv_fused(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x;
  const double vo_1 = v1->y - v2->y;
  const double vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1·v2.
   v1, v2: vector.
   1 mul, 2 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_vv_fused(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = KSL_MUL(v1->x, v2->x), dot_c = fma(v1->y, v2->y, dot_a),
      dot = fma(v1->z, v2->z, dot_c);
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv_fused(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(k, v->x), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(k, v->y), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(k, v->z), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.
   v1, v2, vo: vector.
   3 mul, 3 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv_fused(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(v1->y, v2->z), vo_0 = fma(-v1->z, v2->y, vo_0a);
  const double vo_1a = KSL_MUL(v1->z, v2->x), vo_1 = fma(-v1->x, v2->z, vo_1a);
  const double vo_2a = KSL_MUL(v1->x, v2->y), vo_2 = fma(-v1->y, v2->x, vo_2a);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   3 mul, 3 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv_fused(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(v1->z, v2->y), vo_0 = fma(-v1->y, v2->z, vo_0a);
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1 = fma(-v1->z, v2->x, vo_1a);
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2 = fma(-v1->x, v2->y, vo_2a);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv_fused(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scale_fused(ksl_vec3f_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_axpy_vvf_fused(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = fmaf(a, x->x, y->x);
  const float y_1_new = fmaf(a, x->y, y->y);
  const float y_2_new = fmaf(a, x->z, y->z);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vvf_fused(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = x->x + y->x;
  const float y_1_new = x->y + y->y;
  const float y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vvf_fused(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = y->x - x->x;
  const float y_1_new = y->y - x->y;
  const float y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avf_fused(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(a, vi->x);
  const float vo_1 = KSL_MULF(a, vi->y);
  const float vo_2 = KSL_MULF(a, vi->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvf_fused(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const float vo_0 = v1->x + v2->x;
  const float vo_1 = v1->y + v2->y;
  const float vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vvf_fused(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const float vo_0 = v1->x - v2->x;
  const float vo_1 = v1->y - v2->y;
  const float vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scaled_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1·v2.
   v1, v2: vector.
   1 mul, 2 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_vvf_fused(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const float dot_a = KSL_MULF(v1->x, v2->x), dot_c = fmaf(v1->y, v2->y, dot_a),
      dot = fmaf(v1->z, v2->z, dot_c);
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinvf_fused(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(k, v->x), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(k, v->y), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(k, v->z), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.
   v1, v2, vo: vector.
   3 mul, 3 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvf_fused(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(v1->y, v2->z), vo_0 = fmaf(-v1->z, v2->y, vo_0a);
  const float vo_1a = KSL_MULF(v1->z, v2->x), vo_1 = fmaf(-v1->x, v2->z, vo_1a);
  const float vo_2a = KSL_MULF(v1->x, v2->y), vo_2 = fmaf(-v1->y, v2->x, vo_2a);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   3 mul, 3 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinvf_fused(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(v1->z, v2->y), vo_0 = fmaf(-v1->y, v2->z, vo_0a);
  const float vo_1a = KSL_MULF(v1->x, v2->z), vo_1 = fmaf(-v1->z, v2->x, vo_1a);
  const float vo_2a = KSL_MULF(v1->y, v2->x), vo_2 = fmaf(-v1->x, v2->y, vo_2a);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x + k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinvf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x - k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y + k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinvf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y - k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z + k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinvf_fused(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z - k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

#endif
