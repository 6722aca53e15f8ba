/* Made by `coscrew generate`; changes are overwritten. */
/* Vectors of three components.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_VEC3_ACCURATE_H
#define KSL_VEC3_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: vector; a: number.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale_accurate(ksl_vec3_t *self, const double a) {
  const double self_0_new = self->x * a;
  const double self_1_new = self->y * a;
  const double self_2_new = self->z * a;
  const double self_0_new_lo = ksl_product_error(self->x, a, self_0_new),
      self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_lo = ksl_product_error(self->y, a, self_1_new),
      self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_error(self->z, a, self_2_new),
      self_2_new_rounded = self_2_new + self_2_new_lo;
  self->x = self_0_new_rounded;
  self->y = self_1_new_rounded;
  self->z = self_2_new_rounded;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv_accurate(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new_a = a * x->x, y_0_new = y_0_new_a + y->x,
      y_0_new_right = y_0_new - y_0_new_a, y_0_new_left = y_0_new - y_0_new_right,
      y_0_new_left_rest = ksl_product_rest(a, x->x, y_0_new_a, y_0_new_left),
      y_0_new_right_rest = y->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new_a = a * x->y, y_1_new = y_1_new_a + y->y,
      y_1_new_right = y_1_new - y_1_new_a, y_1_new_left = y_1_new - y_1_new_right,
      y_1_new_left_rest = ksl_product_rest(a, x->y, y_1_new_a, y_1_new_left),
      y_1_new_right_rest = y->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new_a = a * x->z, y_2_new = y_2_new_a + y->z,
      y_2_new_right = y_2_new - y_2_new_a, y_2_new_left = y_2_new - y_2_new_right,
      y_2_new_left_rest = ksl_product_rest(a, x->z, y_2_new_a, y_2_new_left),
      y_2_new_right_rest = y->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x, y_0_new_right = y_0_new - x->x,
      y_0_new_left = y_0_new - y_0_new_right, y_0_new_left_rest = x->x - y_0_new_left,
      y_0_new_right_rest = y->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new = x->y + y->y, y_1_new_right = y_1_new - x->y,
      y_1_new_left = y_1_new - y_1_new_right, y_1_new_left_rest = x->y - y_1_new_left,
      y_1_new_right_rest = y->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new = x->z + y->z, y_2_new_right = y_2_new - x->z,
      y_2_new_left = y_2_new - y_2_new_right, y_2_new_left_rest = x->z - y_2_new_left,
      y_2_new_right_rest = y->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = -x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x, y_0_new_right = y->x - y_0_new,
      y_0_new_left = y_0_new + y_0_new_right, y_0_new_left_rest = y->x - y_0_new_left,
      y_0_new_right_rest = x->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest - y_0_new_right_rest;
  const double y_1_new = y->y - x->y, y_1_new_right = y->y - y_1_new,
      y_1_new_left = y_1_new + y_1_new_right, y_1_new_left_rest = y->y - y_1_new_left,
      y_1_new_right_rest = x->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest - y_1_new_right_rest;
  const double y_2_new = y->z - x->z, y_2_new_right = y->z - y_2_new,
      y_2_new_left = y_2_new + y_2_new_right, y_2_new_left_rest = y->z - y_2_new_left,
      y_2_new_right_rest = x->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest - y_2_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av_accurate(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = a * vi->x;
  const double vo_1 = a * vi->y;
  const double vo_2 = a * vi->z;
  const double vo_0_lo = ksl_product_error(a, vi->x, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(a, vi->y, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(a, vi->z, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x, vo_0_right = vo_0 - v1->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v1->x - vo_0_left, vo_0_right_rest = v2->x - vo_0_right,
      vo_0_lo = vo_0_left_rest + vo_0_right_rest;
  const double vo_1 = v1->y + v2->y, vo_1_right = vo_1 - v1->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v1->y - vo_1_left, vo_1_right_rest = v2->y - vo_1_right,
      vo_1_lo = vo_1_left_rest + vo_1_right_rest;
  const double vo_2 = v1->z + v2->z, vo_2_right = vo_2 - v1->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v1->z - vo_2_left, vo_2_right_rest = v2->z - vo_2_right,
      vo_2_lo = vo_2_left_rest + vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x, vo_0_right = v1->x - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = v1->x - vo_0_left, vo_0_right_rest = v2->x - vo_0_right,
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1 = v1->y - v2->y, vo_1_right = v1->y - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = v1->y - vo_1_left, vo_1_right_rest = v2->y - vo_1_right,
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2 = v1->z - v2->z, vo_2_right = v1->z - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = v1->z - vo_2_left, vo_2_right_rest = v2->z - vo_2_right,
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x * k;
  const double vo_1 = v->y * k;
  const double vo_2 = v->z * k;
  const double vo_0_lo = ksl_product_error(v->x, k, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(v->y, k, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(v->z, k, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 11 add, 3 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = v1->x * v2->x, dot_b = v1->y * v2->y, dot_c = dot_a + dot_b,
      dot_c_right = dot_c - dot_a, dot_c_left = dot_c - dot_c_right,
      dot_c_left_rest = ksl_product_rest(v1->x, v2->x, dot_a, dot_c_left),
      dot_c_right_rest = ksl_product_rest(v1->y, v2->y, dot_b, dot_c_right),
      dot_c_lo = dot_c_left_rest + dot_c_right_rest, dot_d = v1->z * v2->z, dot = dot_c + dot_d,
      dot_right = dot - dot_c, dot_left = dot - dot_right, dot_left_rest = dot_c - dot_left,
      dot_right_rest = ksl_product_rest(v1->z, v2->z, dot_d, dot_right),
      dot_lo1 = dot_left_rest + dot_right_rest, dot_lo = dot_lo1 + dot_c_lo;
  const double dot_rounded = dot + dot_lo;
  return dot_rounded;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = k * v->x, vo_0a_lo = ksl_product_error(k, v->x, vo_0a), vo_0 = -vo_0a,
      vo_0_lo = -vo_0a_lo;
  const double vo_1a = k * v->y, vo_1a_lo = ksl_product_error(k, v->y, vo_1a), vo_1 = -vo_1a,
      vo_1_lo = -vo_1a_lo;
  const double vo_2a = k * v->z, vo_2a_lo = ksl_product_error(k, v->z, vo_2a), vo_2 = -vo_2a,
      vo_2_lo = -vo_2a_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = v1->y * v2->z, vo_0b = v1->z * v2->y, vo_0 = vo_0a - vo_0b,
      vo_0_right = vo_0a - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = ksl_product_rest(v1->y, v2->z, vo_0a, vo_0_left),
      vo_0_right_rest = ksl_product_rest(v1->z, v2->y, vo_0b, vo_0_right),
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1a = v1->z * v2->x, vo_1b = v1->x * v2->z, vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = ksl_product_rest(v1->z, v2->x, vo_1a, vo_1_left),
      vo_1_right_rest = ksl_product_rest(v1->x, v2->z, vo_1b, vo_1_right),
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2a = v1->x * v2->y, vo_2b = v1->y * v2->x, vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = ksl_product_rest(v1->x, v2->y, vo_2a, vo_2_left),
      vo_2_right_rest = ksl_product_rest(v1->y, v2->x, vo_2b, vo_2_right),
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = v1->z * v2->y, vo_0b = v1->y * v2->z, vo_0 = vo_0a - vo_0b,
      vo_0_right = vo_0a - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = ksl_product_rest(v1->z, v2->y, vo_0a, vo_0_left),
      vo_0_right_rest = ksl_product_rest(v1->y, v2->z, vo_0b, vo_0_right),
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1a = v1->x * v2->z, vo_1b = v1->z * v2->x, vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = ksl_product_rest(v1->x, v2->z, vo_1a, vo_1_left),
      vo_1_right_rest = ksl_product_rest(v1->z, v2->x, vo_1b, vo_1_right),
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2a = v1->y * v2->x, vo_2b = v1->x * v2->y, vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = ksl_product_rest(v1->y, v2->x, vo_2a, vo_2_left),
      vo_2_right_rest = ksl_product_rest(v1->x, v2->y, vo_2b, vo_2_right),
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k, vo_0_right = vo_0 - v->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = k - vo_0_right,
      vo_0_lo = vo_0_left_rest + vo_0_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k, vo_0_right = v->x - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = k - vo_0_right,
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k, vo_1_right = vo_1 - v->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = k - vo_1_right,
      vo_1_lo = vo_1_left_rest + vo_1_right_rest;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k, vo_1_right = v->y - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = k - vo_1_right,
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k, vo_2_right = vo_2 - v->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = k - vo_2_right,
      vo_2_lo = vo_2_left_rest + vo_2_right_rest;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2_rounded;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k, vo_2_right = v->z - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = k - vo_2_right,
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2_rounded;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec3f_scale_accurate(ksl_vec3f_t *self, const float a) {
  const double self_0_new = (double)self->x * (double)a;
  const double self_1_new = (double)self->y * (double)a;
  const double self_2_new = (double)self->z * (double)a;
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_vvf_accurate(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new_a = (double)a * (double)x->x, y_0_new = y_0_new_a + (double)y->x;
  const double y_1_new_a = (double)a * (double)x->y, y_1_new = y_1_new_a + (double)y->y;
  const double y_2_new_a = (double)a * (double)x->z, y_2_new = y_2_new_a + (double)y->z;
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_vvf_accurate(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new = (double)x->x + (double)y->x;
  const double y_1_new = (double)x->y + (double)y->y;
  const double y_2_new = (double)x->z + (double)y->z;
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_vvf_accurate(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new = (double)y->x - (double)x->x;
  const double y_1_new = (double)y->y - (double)x->y;
  const double y_2_new = (double)y->z - (double)x->z;
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_avf_accurate(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const double vo_0 = (double)a * (double)vi->x;
  const double vo_1 = (double)a * (double)vi->y;
  const double vo_2 = (double)a * (double)vi->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v1->x + (double)v2->x;
  const double vo_1 = (double)v1->y + (double)v2->y;
  const double vo_2 = (double)v1->z + (double)v2->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v1->x - (double)v2->x;
  const double vo_1 = (double)v1->y - (double)v2->y;
  const double vo_2 = (double)v1->z - (double)v2->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec3f_scaled_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x * (double)k;
  const double vo_1 = (double)v->y * (double)k;
  const double vo_2 = (double)v->z * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const double dot_a = (double)v1->x * (double)v2->x, dot_b = (double)v1->y * (double)v2->y,
      dot_c = dot_a + dot_b, dot_d = (double)v1->z * (double)v2->z, dot = dot_c + dot_d;
  return (float)dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_avinvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)k * (double)v->x, vo_0 = -vo_0a;
  const double vo_1a = (double)k * (double)v->y, vo_1 = -vo_1a;
  const double vo_2a = (double)k * (double)v->z, vo_2 = -vo_2a;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_cross_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)v1->y * (double)v2->z, vo_0b = (double)v1->z * (double)v2->y,
      vo_0 = vo_0a - vo_0b;
  const double vo_1a = (double)v1->z * (double)v2->x, vo_1b = (double)v1->x * (double)v2->z,
      vo_1 = vo_1a - vo_1b;
  const double vo_2a = (double)v1->x * (double)v2->y, vo_2b = (double)v1->y * (double)v2->x,
      vo_2 = vo_2a - vo_2b;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_cross_vvinvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)v1->z * (double)v2->y, vo_0b = (double)v1->y * (double)v2->z,
      vo_0 = vo_0a - vo_0b;
  const double vo_1a = (double)v1->x * (double)v2->z, vo_1b = (double)v1->z * (double)v2->x,
      vo_1 = vo_1a - vo_1b;
  const double vo_2a = (double)v1->y * (double)v2->x, vo_2b = (double)v1->x * (double)v2->y,
      vo_2 = vo_2a - vo_2b;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvxf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x + (double)k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = (float)vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvxinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x - (double)k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = (float)vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvyf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_1 = (double)v->y + (double)k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = (float)vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvyinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_1 = (double)v->y - (double)k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = (float)vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvzf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_2 = (double)v->z + (double)k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = (float)vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvzinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_2 = (double)v->z - (double)k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = (float)vo_2;
}

#endif
