/* Made by `coscrew generate`; changes are overwritten. */
/* All headers of accurate kernels in one file, for vendoring; it may be included together with
   them. */

/* Types of the spatial algebra, in double and single precision.

   Every quantity is a union, so that it can be reached several ways.  Matrices are stored column by
   column.  Screws s = (v; ω) and coscrews c = (f; τ) have the linear part on top, so that power is
   their dot product.

   All functions: pointers must point to valid objects; an output may be the same object as an
   input; nothing else is read or written.  Every operation is rounded once, in the order written, so
   that results are the same bits everywhere: compile with -ffp-contract=off (and, where the target
   has fused multiply-adds, with gcc's -fno-tree-vectorize: gcc 12 fuses in spite of the former).

   Error bounds are derived from that order, to first order in u: u = 2^-53 in double and 2^-24 in
   single precision. */
#ifndef KSL_TYPES_H
#define KSL_TYPES_H

#include <math.h>
#include <string.h>

#if (defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)) && !defined(KSL_ALLOW_FAST_MATH)
#error "-ffast-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#endif

#if defined(__GNUC__)
#define KSL_VIEW __extension__ struct
#else
#define KSL_VIEW struct
#endif

/* vector (x, y, z); double precision. */
typedef union ksl_vec3_t {
  KSL_VIEW { double at[3]; };
  KSL_VIEW { double x, y, z; };
} ksl_vec3_t;

/* vector (x, y, z); single precision. */
typedef union ksl_vec3f_t {
  KSL_VIEW { float at[3]; };
  KSL_VIEW { float x, y, z; };
} ksl_vec3f_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; double precision. */
typedef union ksl_mat3x3_t {
  KSL_VIEW { double as_array[9]; };
  KSL_VIEW { double at[3][3]; };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3_t v[3]; };
} ksl_mat3x3_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; single precision. */
typedef union ksl_mat3x3f_t {
  KSL_VIEW { float as_array[9]; };
  KSL_VIEW { float at[3][3]; };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3f_t v[3]; };
} ksl_mat3x3f_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; double precision. */
typedef union ksl_SE3_t {
  KSL_VIEW { double as_array[12]; };
  KSL_VIEW { double at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3_t R;
    ksl_vec3_t t;
  };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
    double m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3_t v[4]; };
} ksl_SE3_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; single precision. */
typedef union ksl_SE3f_t {
  KSL_VIEW { float as_array[12]; };
  KSL_VIEW { float at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3f_t R;
    ksl_vec3f_t t;
  };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
    float m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3f_t v[4]; };
} ksl_SE3f_t;

/* screw (lin; ang) = (v; ω); double precision. */
typedef union ksl_screw_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_screw_t;

/* screw (lin; ang) = (v; ω); single precision. */
typedef union ksl_screwf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_screwf_t;

/* coscrew (lin; ang) = (f; τ); double precision. */
typedef union ksl_coscrew_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_coscrew_t;

/* coscrew (lin; ang) = (f; τ); single precision. */
typedef union ksl_coscrewf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_coscrewf_t;

/* 6×6 operator, stored column by column: at[column][row]; double precision. */
typedef union ksl_mat6x6_t {
  KSL_VIEW { double as_array[36]; };
  KSL_VIEW { double at[6][6]; };
} ksl_mat6x6_t;

/* 6×6 operator, stored column by column: at[column][row]; single precision. */
typedef union ksl_mat6x6f_t {
  KSL_VIEW { float as_array[36]; };
  KSL_VIEW { float at[6][6]; };
} ksl_mat6x6f_t;

#endif

/* Exact rounding errors in double precision, for compensated kernels.

   Exact while nothing over- or underflows: products of numbers below 2^996 in magnitude whose own
   magnitude is above 2^-969.  Needs every operation rounded to double on its own: compile with
   -ffp-contract=off, and not for the x87. */
#ifndef KSL_EXACT_H
#define KSL_EXACT_H


#if defined(__FAST_MATH__)
#error "-ffast-math undoes compensated arithmetic"
#endif

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(FP_FAST_FMA)
#define KSL_HAS_FMA 1
#else
#define KSL_HAS_FMA 0
#endif

/* a b - p exactly, p the rounded product: by fma where that is an instruction, else in halves of
   26 bits (Veltkamp, Dekker).  Both give the same bits. */
static inline double ksl_product_error(const double a, const double b, const double p) {
#if KSL_HAS_FMA
  return fma(a, b, -p);
#else
  const double splitter = 134217729.0; /* 2^27 + 1 */
  const double c = splitter * a, d = c - a, a_high = c - d, a_low = a - a_high;
  const double e = splitter * b, f = e - b, b_high = e - f, b_low = b - b_high;
  const double high = a_high * b_high, cross1 = a_high * b_low, cross2 = a_low * b_high;
  const double low = a_low * b_low, g = high - p, h = g + cross1, i = h + cross2;
  return i + low;
#endif
}

/* a b - h rounded once, where p is a b rounded and p - h is exact. */
static inline double ksl_product_rest(
    const double a, const double b, const double p, const double h) {
#if KSL_HAS_FMA
  (void)p;
  return fma(a, b, -h);
#else
  const double rest = p - h, error = ksl_product_error(a, b, p);
  return rest + error;
#endif
}

#endif

/* Vectors of three components.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_VEC3_ACCURATE_H
#define KSL_VEC3_ACCURATE_H


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

/* 3×3 matrices: rotations, and matrices in general.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MAT3X3_ACCURATE_H
#define KSL_MAT3X3_ACCURATE_H


/* det R.
   R: rotation or other 3×3 matrix.
   12 mul, 26 add, 9 product rest.
   Error <= u |result| + 28 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_mat3x3_determinant_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b,
      n_0_right = n_0a - n_0, n_0_left = n_0 + n_0_right,
      n_0_left_rest = ksl_product_rest(R->m11, R->m22, n_0a, n_0_left),
      n_0_right_rest = ksl_product_rest(R->m12, R->m21, n_0b, n_0_right),
      n_0_lo = n_0_left_rest - n_0_right_rest;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1, n_1_left = n_1 + n_1_right,
      n_1_left_rest = ksl_product_rest(R->m02, R->m21, n_1a, n_1_left),
      n_1_right_rest = ksl_product_rest(R->m01, R->m22, n_1b, n_1_right),
      n_1_lo = n_1_left_rest - n_1_right_rest;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2, n_2_left = n_2 + n_2_right,
      n_2_left_rest = ksl_product_rest(R->m01, R->m12, n_2a, n_2_left),
      n_2_right_rest = ksl_product_rest(R->m02, R->m11, n_2b, n_2_right),
      n_2_lo = n_2_left_rest - n_2_right_rest;
  const double det_a = R->m00 * n_0, det_a_cross2 = R->m00 * n_0_lo, det_b = R->m10 * n_1,
      det_b_cross2 = R->m10 * n_1_lo, det_c = det_a + det_b, det_c_right = det_c - det_a,
      det_c_left = det_c - det_c_right,
      det_c_left_rest = ksl_product_rest(R->m00, n_0, det_a, det_c_left),
      det_c_right_rest = ksl_product_rest(R->m10, n_1, det_b, det_c_right),
      det_c_cross = det_a_cross2 + det_b_cross2, det_c_lo1 = det_c_left_rest + det_c_right_rest,
      det_c_lo = det_c_lo1 + det_c_cross, det_d = R->m20 * n_2, det_d_cross2 = R->m20 * n_2_lo,
      det = det_c + det_d, det_right = det - det_c, det_left = det - det_right,
      det_left_rest = det_c - det_left,
      det_right_rest = ksl_product_rest(R->m20, n_2, det_d, det_right),
      det_lo1 = det_left_rest + det_right_rest, det_lo2 = det_lo1 + det_d_cross2,
      det_lo = det_lo2 + det_c_lo;
  const double det_rounded = det + det_lo;
  return det_rounded;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 5/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_mat3x3f_determinant_accurate(const ksl_mat3x3f_t *R) {
  const double n_0a = (double)R->m11 * (double)R->m22, n_0b = (double)R->m12 * (double)R->m21,
      n_0 = n_0a - n_0b;
  const double n_1a = (double)R->m02 * (double)R->m21, n_1b = (double)R->m01 * (double)R->m22,
      n_1 = n_1a - n_1b;
  const double n_2a = (double)R->m01 * (double)R->m12, n_2b = (double)R->m02 * (double)R->m11,
      n_2 = n_2a - n_2b;
  const double det_a = (double)R->m00 * n_0, det_b = (double)R->m10 * n_1, det_c = det_a + det_b,
      det_d = (double)R->m20 * n_2, det = det_c + det_d;
  return (float)det;
}

#endif

/* Displacements D = [R | t].
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SE3_ACCURATE_H
#define KSL_SE3_ACCURATE_H


/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert_accurate(ksl_SE3_t *self) {
  const double self_03_new_a = self->m00 * self->m03, self_03_new_b = self->m10 * self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_c_right = self_03_new_c - self_03_new_a,
      self_03_new_c_left = self_03_new_c - self_03_new_c_right,
      self_03_new_c_left_rest = ksl_product_rest(self->m00, self->m03, self_03_new_a, self_03_new_c_left),
      self_03_new_c_right_rest = ksl_product_rest(self->m10, self->m13, self_03_new_b, self_03_new_c_right),
      self_03_new_c_lo = self_03_new_c_left_rest + self_03_new_c_right_rest,
      self_03_new_d = self->m20 * self->m23, self_03_new_e = self_03_new_c + self_03_new_d,
      self_03_new_e_right = self_03_new_e - self_03_new_c,
      self_03_new_e_left = self_03_new_e - self_03_new_e_right,
      self_03_new_e_left_rest = self_03_new_c - self_03_new_e_left,
      self_03_new_e_right_rest = ksl_product_rest(self->m20, self->m23, self_03_new_d, self_03_new_e_right),
      self_03_new_e_lo1 = self_03_new_e_left_rest + self_03_new_e_right_rest,
      self_03_new_e_lo = self_03_new_e_lo1 + self_03_new_c_lo, self_03_new = -self_03_new_e,
      self_03_new_lo = -self_03_new_e_lo;
  const double self_13_new_a = self->m01 * self->m03, self_13_new_b = self->m11 * self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_c_right = self_13_new_c - self_13_new_a,
      self_13_new_c_left = self_13_new_c - self_13_new_c_right,
      self_13_new_c_left_rest = ksl_product_rest(self->m01, self->m03, self_13_new_a, self_13_new_c_left),
      self_13_new_c_right_rest = ksl_product_rest(self->m11, self->m13, self_13_new_b, self_13_new_c_right),
      self_13_new_c_lo = self_13_new_c_left_rest + self_13_new_c_right_rest,
      self_13_new_d = self->m21 * self->m23, self_13_new_e = self_13_new_c + self_13_new_d,
      self_13_new_e_right = self_13_new_e - self_13_new_c,
      self_13_new_e_left = self_13_new_e - self_13_new_e_right,
      self_13_new_e_left_rest = self_13_new_c - self_13_new_e_left,
      self_13_new_e_right_rest = ksl_product_rest(self->m21, self->m23, self_13_new_d, self_13_new_e_right),
      self_13_new_e_lo1 = self_13_new_e_left_rest + self_13_new_e_right_rest,
      self_13_new_e_lo = self_13_new_e_lo1 + self_13_new_c_lo, self_13_new = -self_13_new_e,
      self_13_new_lo = -self_13_new_e_lo;
  const double self_23_new_a = self->m02 * self->m03, self_23_new_b = self->m12 * self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_c_right = self_23_new_c - self_23_new_a,
      self_23_new_c_left = self_23_new_c - self_23_new_c_right,
      self_23_new_c_left_rest = ksl_product_rest(self->m02, self->m03, self_23_new_a, self_23_new_c_left),
      self_23_new_c_right_rest = ksl_product_rest(self->m12, self->m13, self_23_new_b, self_23_new_c_right),
      self_23_new_c_lo = self_23_new_c_left_rest + self_23_new_c_right_rest,
      self_23_new_d = self->m22 * self->m23, self_23_new_e = self_23_new_c + self_23_new_d,
      self_23_new_e_right = self_23_new_e - self_23_new_c,
      self_23_new_e_left = self_23_new_e - self_23_new_e_right,
      self_23_new_e_left_rest = self_23_new_c - self_23_new_e_left,
      self_23_new_e_right_rest = ksl_product_rest(self->m22, self->m23, self_23_new_d, self_23_new_e_right),
      self_23_new_e_lo1 = self_23_new_e_left_rest + self_23_new_e_right_rest,
      self_23_new_e_lo = self_23_new_e_lo1 + self_23_new_c_lo, self_23_new = -self_23_new_e,
      self_23_new_lo = -self_23_new_e_lo;
  const double self_03_new_rounded = self_03_new + self_03_new_lo;
  const double self_13_new_rounded = self_13_new + self_13_new_lo;
  const double self_23_new_rounded = self_23_new + self_23_new_lo;
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new_rounded;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new_rounded;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new_rounded;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted_accurate(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * D->m03, Do_03b = D->m10 * D->m13, Do_03c = Do_03a + Do_03b,
      Do_03c_right = Do_03c - Do_03a, Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D->m00, D->m03, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D->m10, D->m13, Do_03b, Do_03c_right),
      Do_03c_lo = Do_03c_left_rest + Do_03c_right_rest, Do_03d = D->m20 * D->m23,
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D->m20, D->m23, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo = Do_03e_lo1 + Do_03c_lo,
      Do_03 = -Do_03e, Do_03_lo = -Do_03e_lo;
  const double Do_13a = D->m01 * D->m03, Do_13b = D->m11 * D->m13, Do_13c = Do_13a + Do_13b,
      Do_13c_right = Do_13c - Do_13a, Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D->m01, D->m03, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D->m11, D->m13, Do_13b, Do_13c_right),
      Do_13c_lo = Do_13c_left_rest + Do_13c_right_rest, Do_13d = D->m21 * D->m23,
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D->m21, D->m23, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo = Do_13e_lo1 + Do_13c_lo,
      Do_13 = -Do_13e, Do_13_lo = -Do_13e_lo;
  const double Do_23a = D->m02 * D->m03, Do_23b = D->m12 * D->m13, Do_23c = Do_23a + Do_23b,
      Do_23c_right = Do_23c - Do_23a, Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D->m02, D->m03, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D->m12, D->m13, Do_23b, Do_23c_right),
      Do_23c_lo = Do_23c_left_rest + Do_23c_right_rest, Do_23d = D->m22 * D->m23,
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D->m22, D->m23, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo = Do_23e_lo1 + Do_23c_lo,
      Do_23 = -Do_23e, Do_23_lo = -Do_23e_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert_accurate(ksl_SE3f_t *self) {
  const double self_03_new_a = (double)self->m00 * (double)self->m03,
      self_03_new_b = (double)self->m10 * (double)self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_d = (double)self->m20 * (double)self->m23,
      self_03_new_e = self_03_new_c + self_03_new_d, self_03_new = -self_03_new_e;
  const double self_13_new_a = (double)self->m01 * (double)self->m03,
      self_13_new_b = (double)self->m11 * (double)self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_d = (double)self->m21 * (double)self->m23,
      self_13_new_e = self_13_new_c + self_13_new_d, self_13_new = -self_13_new_e;
  const double self_23_new_a = (double)self->m02 * (double)self->m03,
      self_23_new_b = (double)self->m12 * (double)self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_d = (double)self->m22 * (double)self->m23,
      self_23_new_e = self_23_new_c + self_23_new_d, self_23_new = -self_23_new_e;
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = (float)self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = (float)self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = (float)self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted_accurate(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m00 * (double)D->m03, Do_03b = (double)D->m10 * (double)D->m13,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D->m20 * (double)D->m23, Do_03e = Do_03c + Do_03d,
      Do_03 = -Do_03e;
  const double Do_13a = (double)D->m01 * (double)D->m03, Do_13b = (double)D->m11 * (double)D->m13,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D->m21 * (double)D->m23, Do_13e = Do_13c + Do_13d,
      Do_13 = -Do_13e;
  const double Do_23a = (double)D->m02 * (double)D->m03, Do_23b = (double)D->m12 * (double)D->m13,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D->m22 * (double)D->m23, Do_23e = Do_23c + Do_23d,
      Do_23 = -Do_23e;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

#endif

/* Products between rotations, displacements and vectors.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MATRIX_ACCURATE_H
#define KSL_MATRIX_ACCURATE_H


/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(R->m01, v->y, vo_0b, vo_0c_right),
      vo_0c_lo = vo_0c_left_rest + vo_0c_right_rest, vo_0d = R->m02 * v->z, vo_0 = vo_0c + vo_0d,
      vo_0_right = vo_0 - vo_0c, vo_0_left = vo_0 - vo_0_right, vo_0_left_rest = vo_0c - vo_0_left,
      vo_0_right_rest = ksl_product_rest(R->m02, v->z, vo_0d, vo_0_right),
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo = vo_0_lo1 + vo_0c_lo;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(R->m10, v->x, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right),
      vo_1c_lo = vo_1c_left_rest + vo_1c_right_rest, vo_1d = R->m12 * v->z, vo_1 = vo_1c + vo_1d,
      vo_1_right = vo_1 - vo_1c, vo_1_left = vo_1 - vo_1_right, vo_1_left_rest = vo_1c - vo_1_left,
      vo_1_right_rest = ksl_product_rest(R->m12, v->z, vo_1d, vo_1_right),
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo = vo_1_lo1 + vo_1c_lo;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(R->m20, v->x, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(R->m21, v->y, vo_2b, vo_2c_right),
      vo_2c_lo = vo_2c_left_rest + vo_2c_right_rest, vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d,
      vo_2_right = vo_2 - vo_2c, vo_2_left = vo_2 - vo_2_right, vo_2_left_rest = vo_2c - vo_2_left,
      vo_2_right_rest = ksl_product_rest(R->m22, v->z, vo_2d, vo_2_right),
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo = vo_2_lo1 + vo_2c_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(R->m01, v->y, vo_0b, vo_0c_right),
      vo_0c_lo = vo_0c_left_rest + vo_0c_right_rest, vo_0d = R->m02 * v->z, vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c, vo_0e_left = vo_0e - vo_0e_right,
      vo_0e_left_rest = vo_0c - vo_0e_left,
      vo_0e_right_rest = ksl_product_rest(R->m02, v->z, vo_0d, vo_0e_right),
      vo_0e_lo1 = vo_0e_left_rest + vo_0e_right_rest, vo_0e_lo = vo_0e_lo1 + vo_0c_lo,
      vo_0 = -vo_0e, vo_0_lo = -vo_0e_lo;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(R->m10, v->x, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right),
      vo_1c_lo = vo_1c_left_rest + vo_1c_right_rest, vo_1d = R->m12 * v->z, vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c, vo_1e_left = vo_1e - vo_1e_right,
      vo_1e_left_rest = vo_1c - vo_1e_left,
      vo_1e_right_rest = ksl_product_rest(R->m12, v->z, vo_1d, vo_1e_right),
      vo_1e_lo1 = vo_1e_left_rest + vo_1e_right_rest, vo_1e_lo = vo_1e_lo1 + vo_1c_lo,
      vo_1 = -vo_1e, vo_1_lo = -vo_1e_lo;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(R->m20, v->x, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(R->m21, v->y, vo_2b, vo_2c_right),
      vo_2c_lo = vo_2c_left_rest + vo_2c_right_rest, vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c, vo_2e_left = vo_2e - vo_2e_right,
      vo_2e_left_rest = vo_2c - vo_2e_left,
      vo_2e_right_rest = ksl_product_rest(R->m22, v->z, vo_2d, vo_2e_right),
      vo_2e_lo1 = vo_2e_left_rest + vo_2e_right_rest, vo_2e_lo = vo_2e_lo1 + vo_2c_lo,
      vo_2 = -vo_2e, vo_2_lo = -vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(R->m10, v->y, vo_0b, vo_0c_right),
      vo_0c_lo = vo_0c_left_rest + vo_0c_right_rest, vo_0d = R->m20 * v->z, vo_0 = vo_0c + vo_0d,
      vo_0_right = vo_0 - vo_0c, vo_0_left = vo_0 - vo_0_right, vo_0_left_rest = vo_0c - vo_0_left,
      vo_0_right_rest = ksl_product_rest(R->m20, v->z, vo_0d, vo_0_right),
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo = vo_0_lo1 + vo_0c_lo;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(R->m01, v->x, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right),
      vo_1c_lo = vo_1c_left_rest + vo_1c_right_rest, vo_1d = R->m21 * v->z, vo_1 = vo_1c + vo_1d,
      vo_1_right = vo_1 - vo_1c, vo_1_left = vo_1 - vo_1_right, vo_1_left_rest = vo_1c - vo_1_left,
      vo_1_right_rest = ksl_product_rest(R->m21, v->z, vo_1d, vo_1_right),
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo = vo_1_lo1 + vo_1c_lo;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(R->m02, v->x, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(R->m12, v->y, vo_2b, vo_2c_right),
      vo_2c_lo = vo_2c_left_rest + vo_2c_right_rest, vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d,
      vo_2_right = vo_2 - vo_2c, vo_2_left = vo_2 - vo_2_right, vo_2_left_rest = vo_2c - vo_2_left,
      vo_2_right_rest = ksl_product_rest(R->m22, v->z, vo_2d, vo_2_right),
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo = vo_2_lo1 + vo_2c_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(R->m10, v->y, vo_0b, vo_0c_right),
      vo_0c_lo = vo_0c_left_rest + vo_0c_right_rest, vo_0d = R->m20 * v->z, vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c, vo_0e_left = vo_0e - vo_0e_right,
      vo_0e_left_rest = vo_0c - vo_0e_left,
      vo_0e_right_rest = ksl_product_rest(R->m20, v->z, vo_0d, vo_0e_right),
      vo_0e_lo1 = vo_0e_left_rest + vo_0e_right_rest, vo_0e_lo = vo_0e_lo1 + vo_0c_lo,
      vo_0 = -vo_0e, vo_0_lo = -vo_0e_lo;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(R->m01, v->x, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right),
      vo_1c_lo = vo_1c_left_rest + vo_1c_right_rest, vo_1d = R->m21 * v->z, vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c, vo_1e_left = vo_1e - vo_1e_right,
      vo_1e_left_rest = vo_1c - vo_1e_left,
      vo_1e_right_rest = ksl_product_rest(R->m21, v->z, vo_1d, vo_1e_right),
      vo_1e_lo1 = vo_1e_left_rest + vo_1e_right_rest, vo_1e_lo = vo_1e_lo1 + vo_1c_lo,
      vo_1 = -vo_1e, vo_1_lo = -vo_1e_lo;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(R->m02, v->x, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(R->m12, v->y, vo_2b, vo_2c_right),
      vo_2c_lo = vo_2c_left_rest + vo_2c_right_rest, vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c, vo_2e_left = vo_2e - vo_2e_right,
      vo_2e_left_rest = vo_2c - vo_2e_left,
      vo_2e_right_rest = ksl_product_rest(R->m22, v->z, vo_2d, vo_2e_right),
      vo_2e_lo1 = vo_2e_left_rest + vo_2e_right_rest, vo_2e_lo = vo_2e_lo1 + vo_2c_lo,
      vo_2 = -vo_2e, vo_2_lo = -vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + 15 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = D->m00 * v->x, vo_0b = D->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(D->m00, v->x, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(D->m01, v->y, vo_0b, vo_0c_right),
      vo_0c_lo = vo_0c_left_rest + vo_0c_right_rest, vo_0d = D->m02 * v->z, vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c, vo_0e_left = vo_0e - vo_0e_right,
      vo_0e_left_rest = vo_0c - vo_0e_left,
      vo_0e_right_rest = ksl_product_rest(D->m02, v->z, vo_0d, vo_0e_right),
      vo_0e_lo1 = vo_0e_left_rest + vo_0e_right_rest, vo_0e_lo = vo_0e_lo1 + vo_0c_lo,
      vo_0 = vo_0e + D->m03, vo_0_right = vo_0 - vo_0e, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = vo_0e - vo_0_left, vo_0_right_rest = D->m03 - vo_0_right,
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo = vo_0_lo1 + vo_0e_lo;
  const double vo_1a = D->m10 * v->x, vo_1b = D->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(D->m10, v->x, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(D->m11, v->y, vo_1b, vo_1c_right),
      vo_1c_lo = vo_1c_left_rest + vo_1c_right_rest, vo_1d = D->m12 * v->z, vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c, vo_1e_left = vo_1e - vo_1e_right,
      vo_1e_left_rest = vo_1c - vo_1e_left,
      vo_1e_right_rest = ksl_product_rest(D->m12, v->z, vo_1d, vo_1e_right),
      vo_1e_lo1 = vo_1e_left_rest + vo_1e_right_rest, vo_1e_lo = vo_1e_lo1 + vo_1c_lo,
      vo_1 = vo_1e + D->m13, vo_1_right = vo_1 - vo_1e, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = vo_1e - vo_1_left, vo_1_right_rest = D->m13 - vo_1_right,
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo = vo_1_lo1 + vo_1e_lo;
  const double vo_2a = D->m20 * v->x, vo_2b = D->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(D->m20, v->x, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(D->m21, v->y, vo_2b, vo_2c_right),
      vo_2c_lo = vo_2c_left_rest + vo_2c_right_rest, vo_2d = D->m22 * v->z, vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c, vo_2e_left = vo_2e - vo_2e_right,
      vo_2e_left_rest = vo_2c - vo_2e_left,
      vo_2e_right_rest = ksl_product_rest(D->m22, v->z, vo_2d, vo_2e_right),
      vo_2e_lo1 = vo_2e_left_rest + vo_2e_right_rest, vo_2e_lo = vo_2e_lo1 + vo_2c_lo,
      vo_2 = vo_2e + D->m23, vo_2_right = vo_2 - vo_2e, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = vo_2e - vo_2_left, vo_2_right_rest = D->m23 - vo_2_right,
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo = vo_2_lo1 + vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   18 mul, 60 add, 9 product rest.
   Error <= u |result| + 18 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dinvv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03, p_0_right = v->x - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = v->x - p_0_left, p_0_right_rest = D->m03 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = v->y - D->m13, p_1_right = v->y - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = v->y - p_1_left, p_1_right_rest = D->m13 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = v->z - D->m23, p_2_right = v->z - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = v->z - p_2_left, p_2_right_rest = D->m23 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double vo_0a = D->m00 * p_0, vo_0a_cross2 = D->m00 * p_0_lo, vo_0b = D->m10 * p_1,
      vo_0b_cross2 = D->m10 * p_1_lo, vo_0c = vo_0a + vo_0b, vo_0c_right = vo_0c - vo_0a,
      vo_0c_left = vo_0c - vo_0c_right,
      vo_0c_left_rest = ksl_product_rest(D->m00, p_0, vo_0a, vo_0c_left),
      vo_0c_right_rest = ksl_product_rest(D->m10, p_1, vo_0b, vo_0c_right),
      vo_0c_cross = vo_0a_cross2 + vo_0b_cross2, vo_0c_lo1 = vo_0c_left_rest + vo_0c_right_rest,
      vo_0c_lo = vo_0c_lo1 + vo_0c_cross, vo_0d = D->m20 * p_2, vo_0d_cross2 = D->m20 * p_2_lo,
      vo_0 = vo_0c + vo_0d, vo_0_right = vo_0 - vo_0c, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = vo_0c - vo_0_left,
      vo_0_right_rest = ksl_product_rest(D->m20, p_2, vo_0d, vo_0_right),
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo2 = vo_0_lo1 + vo_0d_cross2,
      vo_0_lo = vo_0_lo2 + vo_0c_lo;
  const double vo_1a = D->m01 * p_0, vo_1a_cross2 = D->m01 * p_0_lo, vo_1b = D->m11 * p_1,
      vo_1b_cross2 = D->m11 * p_1_lo, vo_1c = vo_1a + vo_1b, vo_1c_right = vo_1c - vo_1a,
      vo_1c_left = vo_1c - vo_1c_right,
      vo_1c_left_rest = ksl_product_rest(D->m01, p_0, vo_1a, vo_1c_left),
      vo_1c_right_rest = ksl_product_rest(D->m11, p_1, vo_1b, vo_1c_right),
      vo_1c_cross = vo_1a_cross2 + vo_1b_cross2, vo_1c_lo1 = vo_1c_left_rest + vo_1c_right_rest,
      vo_1c_lo = vo_1c_lo1 + vo_1c_cross, vo_1d = D->m21 * p_2, vo_1d_cross2 = D->m21 * p_2_lo,
      vo_1 = vo_1c + vo_1d, vo_1_right = vo_1 - vo_1c, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = vo_1c - vo_1_left,
      vo_1_right_rest = ksl_product_rest(D->m21, p_2, vo_1d, vo_1_right),
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo2 = vo_1_lo1 + vo_1d_cross2,
      vo_1_lo = vo_1_lo2 + vo_1c_lo;
  const double vo_2a = D->m02 * p_0, vo_2a_cross2 = D->m02 * p_0_lo, vo_2b = D->m12 * p_1,
      vo_2b_cross2 = D->m12 * p_1_lo, vo_2c = vo_2a + vo_2b, vo_2c_right = vo_2c - vo_2a,
      vo_2c_left = vo_2c - vo_2c_right,
      vo_2c_left_rest = ksl_product_rest(D->m02, p_0, vo_2a, vo_2c_left),
      vo_2c_right_rest = ksl_product_rest(D->m12, p_1, vo_2b, vo_2c_right),
      vo_2c_cross = vo_2a_cross2 + vo_2b_cross2, vo_2c_lo1 = vo_2c_left_rest + vo_2c_right_rest,
      vo_2c_lo = vo_2c_lo1 + vo_2c_cross, vo_2d = D->m22 * p_2, vo_2d_cross2 = D->m22 * p_2_lo,
      vo_2 = vo_2c + vo_2d, vo_2_right = vo_2 - vo_2c, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = vo_2c - vo_2_left,
      vo_2_right_rest = ksl_product_rest(D->m22, p_2, vo_2d, vo_2_right),
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo2 = vo_2_lo1 + vo_2d_cross2,
      vo_2_lo = vo_2_lo2 + vo_2c_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00c_right = Ro_00c - Ro_00a, Ro_00c_left = Ro_00c - Ro_00c_right,
      Ro_00c_left_rest = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c_left),
      Ro_00c_right_rest = ksl_product_rest(R1->m01, R2->m10, Ro_00b, Ro_00c_right),
      Ro_00c_lo = Ro_00c_left_rest + Ro_00c_right_rest, Ro_00d = R1->m02 * R2->m20,
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c, Ro_00_left = Ro_00 - Ro_00_right,
      Ro_00_left_rest = Ro_00c - Ro_00_left,
      Ro_00_right_rest = ksl_product_rest(R1->m02, R2->m20, Ro_00d, Ro_00_right),
      Ro_00_lo1 = Ro_00_left_rest + Ro_00_right_rest, Ro_00_lo = Ro_00_lo1 + Ro_00c_lo;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01c_right = Ro_01c - Ro_01a, Ro_01c_left = Ro_01c - Ro_01c_right,
      Ro_01c_left_rest = ksl_product_rest(R1->m00, R2->m01, Ro_01a, Ro_01c_left),
      Ro_01c_right_rest = ksl_product_rest(R1->m01, R2->m11, Ro_01b, Ro_01c_right),
      Ro_01c_lo = Ro_01c_left_rest + Ro_01c_right_rest, Ro_01d = R1->m02 * R2->m21,
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c, Ro_01_left = Ro_01 - Ro_01_right,
      Ro_01_left_rest = Ro_01c - Ro_01_left,
      Ro_01_right_rest = ksl_product_rest(R1->m02, R2->m21, Ro_01d, Ro_01_right),
      Ro_01_lo1 = Ro_01_left_rest + Ro_01_right_rest, Ro_01_lo = Ro_01_lo1 + Ro_01c_lo;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m01 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02c_right = Ro_02c - Ro_02a, Ro_02c_left = Ro_02c - Ro_02c_right,
      Ro_02c_left_rest = ksl_product_rest(R1->m00, R2->m02, Ro_02a, Ro_02c_left),
      Ro_02c_right_rest = ksl_product_rest(R1->m01, R2->m12, Ro_02b, Ro_02c_right),
      Ro_02c_lo = Ro_02c_left_rest + Ro_02c_right_rest, Ro_02d = R1->m02 * R2->m22,
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = Ro_02c - Ro_02_left,
      Ro_02_right_rest = ksl_product_rest(R1->m02, R2->m22, Ro_02d, Ro_02_right),
      Ro_02_lo1 = Ro_02_left_rest + Ro_02_right_rest, Ro_02_lo = Ro_02_lo1 + Ro_02c_lo;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10c_right = Ro_10c - Ro_10a, Ro_10c_left = Ro_10c - Ro_10c_right,
      Ro_10c_left_rest = ksl_product_rest(R1->m10, R2->m00, Ro_10a, Ro_10c_left),
      Ro_10c_right_rest = ksl_product_rest(R1->m11, R2->m10, Ro_10b, Ro_10c_right),
      Ro_10c_lo = Ro_10c_left_rest + Ro_10c_right_rest, Ro_10d = R1->m12 * R2->m20,
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = Ro_10c - Ro_10_left,
      Ro_10_right_rest = ksl_product_rest(R1->m12, R2->m20, Ro_10d, Ro_10_right),
      Ro_10_lo1 = Ro_10_left_rest + Ro_10_right_rest, Ro_10_lo = Ro_10_lo1 + Ro_10c_lo;
  const double Ro_11a = R1->m10 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11c_right = Ro_11c - Ro_11a, Ro_11c_left = Ro_11c - Ro_11c_right,
      Ro_11c_left_rest = ksl_product_rest(R1->m10, R2->m01, Ro_11a, Ro_11c_left),
      Ro_11c_right_rest = ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right),
      Ro_11c_lo = Ro_11c_left_rest + Ro_11c_right_rest, Ro_11d = R1->m12 * R2->m21,
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c, Ro_11_left = Ro_11 - Ro_11_right,
      Ro_11_left_rest = Ro_11c - Ro_11_left,
      Ro_11_right_rest = ksl_product_rest(R1->m12, R2->m21, Ro_11d, Ro_11_right),
      Ro_11_lo1 = Ro_11_left_rest + Ro_11_right_rest, Ro_11_lo = Ro_11_lo1 + Ro_11c_lo;
  const double Ro_12a = R1->m10 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12c_right = Ro_12c - Ro_12a, Ro_12c_left = Ro_12c - Ro_12c_right,
      Ro_12c_left_rest = ksl_product_rest(R1->m10, R2->m02, Ro_12a, Ro_12c_left),
      Ro_12c_right_rest = ksl_product_rest(R1->m11, R2->m12, Ro_12b, Ro_12c_right),
      Ro_12c_lo = Ro_12c_left_rest + Ro_12c_right_rest, Ro_12d = R1->m12 * R2->m22,
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c, Ro_12_left = Ro_12 - Ro_12_right,
      Ro_12_left_rest = Ro_12c - Ro_12_left,
      Ro_12_right_rest = ksl_product_rest(R1->m12, R2->m22, Ro_12d, Ro_12_right),
      Ro_12_lo1 = Ro_12_left_rest + Ro_12_right_rest, Ro_12_lo = Ro_12_lo1 + Ro_12c_lo;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20c_right = Ro_20c - Ro_20a, Ro_20c_left = Ro_20c - Ro_20c_right,
      Ro_20c_left_rest = ksl_product_rest(R1->m20, R2->m00, Ro_20a, Ro_20c_left),
      Ro_20c_right_rest = ksl_product_rest(R1->m21, R2->m10, Ro_20b, Ro_20c_right),
      Ro_20c_lo = Ro_20c_left_rest + Ro_20c_right_rest, Ro_20d = R1->m22 * R2->m20,
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c, Ro_20_left = Ro_20 - Ro_20_right,
      Ro_20_left_rest = Ro_20c - Ro_20_left,
      Ro_20_right_rest = ksl_product_rest(R1->m22, R2->m20, Ro_20d, Ro_20_right),
      Ro_20_lo1 = Ro_20_left_rest + Ro_20_right_rest, Ro_20_lo = Ro_20_lo1 + Ro_20c_lo;
  const double Ro_21a = R1->m20 * R2->m01, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21c_right = Ro_21c - Ro_21a, Ro_21c_left = Ro_21c - Ro_21c_right,
      Ro_21c_left_rest = ksl_product_rest(R1->m20, R2->m01, Ro_21a, Ro_21c_left),
      Ro_21c_right_rest = ksl_product_rest(R1->m21, R2->m11, Ro_21b, Ro_21c_right),
      Ro_21c_lo = Ro_21c_left_rest + Ro_21c_right_rest, Ro_21d = R1->m22 * R2->m21,
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = Ro_21c - Ro_21_left,
      Ro_21_right_rest = ksl_product_rest(R1->m22, R2->m21, Ro_21d, Ro_21_right),
      Ro_21_lo1 = Ro_21_left_rest + Ro_21_right_rest, Ro_21_lo = Ro_21_lo1 + Ro_21c_lo;
  const double Ro_22a = R1->m20 * R2->m02, Ro_22b = R1->m21 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22c_right = Ro_22c - Ro_22a, Ro_22c_left = Ro_22c - Ro_22c_right,
      Ro_22c_left_rest = ksl_product_rest(R1->m20, R2->m02, Ro_22a, Ro_22c_left),
      Ro_22c_right_rest = ksl_product_rest(R1->m21, R2->m12, Ro_22b, Ro_22c_right),
      Ro_22c_lo = Ro_22c_left_rest + Ro_22c_right_rest, Ro_22d = R1->m22 * R2->m22,
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c, Ro_22_left = Ro_22 - Ro_22_right,
      Ro_22_left_rest = Ro_22c - Ro_22_left,
      Ro_22_right_rest = ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right),
      Ro_22_lo1 = Ro_22_left_rest + Ro_22_right_rest, Ro_22_lo = Ro_22_lo1 + Ro_22c_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrinv_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00c_right = Ro_00c - Ro_00a, Ro_00c_left = Ro_00c - Ro_00c_right,
      Ro_00c_left_rest = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c_left),
      Ro_00c_right_rest = ksl_product_rest(R1->m01, R2->m01, Ro_00b, Ro_00c_right),
      Ro_00c_lo = Ro_00c_left_rest + Ro_00c_right_rest, Ro_00d = R1->m02 * R2->m02,
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c, Ro_00_left = Ro_00 - Ro_00_right,
      Ro_00_left_rest = Ro_00c - Ro_00_left,
      Ro_00_right_rest = ksl_product_rest(R1->m02, R2->m02, Ro_00d, Ro_00_right),
      Ro_00_lo1 = Ro_00_left_rest + Ro_00_right_rest, Ro_00_lo = Ro_00_lo1 + Ro_00c_lo;
  const double Ro_01a = R1->m00 * R2->m10, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01c_right = Ro_01c - Ro_01a, Ro_01c_left = Ro_01c - Ro_01c_right,
      Ro_01c_left_rest = ksl_product_rest(R1->m00, R2->m10, Ro_01a, Ro_01c_left),
      Ro_01c_right_rest = ksl_product_rest(R1->m01, R2->m11, Ro_01b, Ro_01c_right),
      Ro_01c_lo = Ro_01c_left_rest + Ro_01c_right_rest, Ro_01d = R1->m02 * R2->m12,
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c, Ro_01_left = Ro_01 - Ro_01_right,
      Ro_01_left_rest = Ro_01c - Ro_01_left,
      Ro_01_right_rest = ksl_product_rest(R1->m02, R2->m12, Ro_01d, Ro_01_right),
      Ro_01_lo1 = Ro_01_left_rest + Ro_01_right_rest, Ro_01_lo = Ro_01_lo1 + Ro_01c_lo;
  const double Ro_02a = R1->m00 * R2->m20, Ro_02b = R1->m01 * R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02c_right = Ro_02c - Ro_02a, Ro_02c_left = Ro_02c - Ro_02c_right,
      Ro_02c_left_rest = ksl_product_rest(R1->m00, R2->m20, Ro_02a, Ro_02c_left),
      Ro_02c_right_rest = ksl_product_rest(R1->m01, R2->m21, Ro_02b, Ro_02c_right),
      Ro_02c_lo = Ro_02c_left_rest + Ro_02c_right_rest, Ro_02d = R1->m02 * R2->m22,
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = Ro_02c - Ro_02_left,
      Ro_02_right_rest = ksl_product_rest(R1->m02, R2->m22, Ro_02d, Ro_02_right),
      Ro_02_lo1 = Ro_02_left_rest + Ro_02_right_rest, Ro_02_lo = Ro_02_lo1 + Ro_02c_lo;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10c_right = Ro_10c - Ro_10a, Ro_10c_left = Ro_10c - Ro_10c_right,
      Ro_10c_left_rest = ksl_product_rest(R1->m10, R2->m00, Ro_10a, Ro_10c_left),
      Ro_10c_right_rest = ksl_product_rest(R1->m11, R2->m01, Ro_10b, Ro_10c_right),
      Ro_10c_lo = Ro_10c_left_rest + Ro_10c_right_rest, Ro_10d = R1->m12 * R2->m02,
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = Ro_10c - Ro_10_left,
      Ro_10_right_rest = ksl_product_rest(R1->m12, R2->m02, Ro_10d, Ro_10_right),
      Ro_10_lo1 = Ro_10_left_rest + Ro_10_right_rest, Ro_10_lo = Ro_10_lo1 + Ro_10c_lo;
  const double Ro_11a = R1->m10 * R2->m10, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11c_right = Ro_11c - Ro_11a, Ro_11c_left = Ro_11c - Ro_11c_right,
      Ro_11c_left_rest = ksl_product_rest(R1->m10, R2->m10, Ro_11a, Ro_11c_left),
      Ro_11c_right_rest = ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right),
      Ro_11c_lo = Ro_11c_left_rest + Ro_11c_right_rest, Ro_11d = R1->m12 * R2->m12,
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c, Ro_11_left = Ro_11 - Ro_11_right,
      Ro_11_left_rest = Ro_11c - Ro_11_left,
      Ro_11_right_rest = ksl_product_rest(R1->m12, R2->m12, Ro_11d, Ro_11_right),
      Ro_11_lo1 = Ro_11_left_rest + Ro_11_right_rest, Ro_11_lo = Ro_11_lo1 + Ro_11c_lo;
  const double Ro_12a = R1->m10 * R2->m20, Ro_12b = R1->m11 * R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12c_right = Ro_12c - Ro_12a, Ro_12c_left = Ro_12c - Ro_12c_right,
      Ro_12c_left_rest = ksl_product_rest(R1->m10, R2->m20, Ro_12a, Ro_12c_left),
      Ro_12c_right_rest = ksl_product_rest(R1->m11, R2->m21, Ro_12b, Ro_12c_right),
      Ro_12c_lo = Ro_12c_left_rest + Ro_12c_right_rest, Ro_12d = R1->m12 * R2->m22,
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c, Ro_12_left = Ro_12 - Ro_12_right,
      Ro_12_left_rest = Ro_12c - Ro_12_left,
      Ro_12_right_rest = ksl_product_rest(R1->m12, R2->m22, Ro_12d, Ro_12_right),
      Ro_12_lo1 = Ro_12_left_rest + Ro_12_right_rest, Ro_12_lo = Ro_12_lo1 + Ro_12c_lo;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20c_right = Ro_20c - Ro_20a, Ro_20c_left = Ro_20c - Ro_20c_right,
      Ro_20c_left_rest = ksl_product_rest(R1->m20, R2->m00, Ro_20a, Ro_20c_left),
      Ro_20c_right_rest = ksl_product_rest(R1->m21, R2->m01, Ro_20b, Ro_20c_right),
      Ro_20c_lo = Ro_20c_left_rest + Ro_20c_right_rest, Ro_20d = R1->m22 * R2->m02,
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c, Ro_20_left = Ro_20 - Ro_20_right,
      Ro_20_left_rest = Ro_20c - Ro_20_left,
      Ro_20_right_rest = ksl_product_rest(R1->m22, R2->m02, Ro_20d, Ro_20_right),
      Ro_20_lo1 = Ro_20_left_rest + Ro_20_right_rest, Ro_20_lo = Ro_20_lo1 + Ro_20c_lo;
  const double Ro_21a = R1->m20 * R2->m10, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21c_right = Ro_21c - Ro_21a, Ro_21c_left = Ro_21c - Ro_21c_right,
      Ro_21c_left_rest = ksl_product_rest(R1->m20, R2->m10, Ro_21a, Ro_21c_left),
      Ro_21c_right_rest = ksl_product_rest(R1->m21, R2->m11, Ro_21b, Ro_21c_right),
      Ro_21c_lo = Ro_21c_left_rest + Ro_21c_right_rest, Ro_21d = R1->m22 * R2->m12,
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = Ro_21c - Ro_21_left,
      Ro_21_right_rest = ksl_product_rest(R1->m22, R2->m12, Ro_21d, Ro_21_right),
      Ro_21_lo1 = Ro_21_left_rest + Ro_21_right_rest, Ro_21_lo = Ro_21_lo1 + Ro_21c_lo;
  const double Ro_22a = R1->m20 * R2->m20, Ro_22b = R1->m21 * R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22c_right = Ro_22c - Ro_22a, Ro_22c_left = Ro_22c - Ro_22c_right,
      Ro_22c_left_rest = ksl_product_rest(R1->m20, R2->m20, Ro_22a, Ro_22c_left),
      Ro_22c_right_rest = ksl_product_rest(R1->m21, R2->m21, Ro_22b, Ro_22c_right),
      Ro_22c_lo = Ro_22c_left_rest + Ro_22c_right_rest, Ro_22d = R1->m22 * R2->m22,
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c, Ro_22_left = Ro_22 - Ro_22_right,
      Ro_22_left_rest = Ro_22c - Ro_22_left,
      Ro_22_right_rest = ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right),
      Ro_22_lo1 = Ro_22_left_rest + Ro_22_right_rest, Ro_22_lo = Ro_22_lo1 + Ro_22c_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m10 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00c_right = Ro_00c - Ro_00a, Ro_00c_left = Ro_00c - Ro_00c_right,
      Ro_00c_left_rest = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c_left),
      Ro_00c_right_rest = ksl_product_rest(R1->m10, R2->m10, Ro_00b, Ro_00c_right),
      Ro_00c_lo = Ro_00c_left_rest + Ro_00c_right_rest, Ro_00d = R1->m20 * R2->m20,
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c, Ro_00_left = Ro_00 - Ro_00_right,
      Ro_00_left_rest = Ro_00c - Ro_00_left,
      Ro_00_right_rest = ksl_product_rest(R1->m20, R2->m20, Ro_00d, Ro_00_right),
      Ro_00_lo1 = Ro_00_left_rest + Ro_00_right_rest, Ro_00_lo = Ro_00_lo1 + Ro_00c_lo;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m10 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01c_right = Ro_01c - Ro_01a, Ro_01c_left = Ro_01c - Ro_01c_right,
      Ro_01c_left_rest = ksl_product_rest(R1->m00, R2->m01, Ro_01a, Ro_01c_left),
      Ro_01c_right_rest = ksl_product_rest(R1->m10, R2->m11, Ro_01b, Ro_01c_right),
      Ro_01c_lo = Ro_01c_left_rest + Ro_01c_right_rest, Ro_01d = R1->m20 * R2->m21,
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c, Ro_01_left = Ro_01 - Ro_01_right,
      Ro_01_left_rest = Ro_01c - Ro_01_left,
      Ro_01_right_rest = ksl_product_rest(R1->m20, R2->m21, Ro_01d, Ro_01_right),
      Ro_01_lo1 = Ro_01_left_rest + Ro_01_right_rest, Ro_01_lo = Ro_01_lo1 + Ro_01c_lo;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m10 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02c_right = Ro_02c - Ro_02a, Ro_02c_left = Ro_02c - Ro_02c_right,
      Ro_02c_left_rest = ksl_product_rest(R1->m00, R2->m02, Ro_02a, Ro_02c_left),
      Ro_02c_right_rest = ksl_product_rest(R1->m10, R2->m12, Ro_02b, Ro_02c_right),
      Ro_02c_lo = Ro_02c_left_rest + Ro_02c_right_rest, Ro_02d = R1->m20 * R2->m22,
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = Ro_02c - Ro_02_left,
      Ro_02_right_rest = ksl_product_rest(R1->m20, R2->m22, Ro_02d, Ro_02_right),
      Ro_02_lo1 = Ro_02_left_rest + Ro_02_right_rest, Ro_02_lo = Ro_02_lo1 + Ro_02c_lo;
  const double Ro_10a = R1->m01 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10c_right = Ro_10c - Ro_10a, Ro_10c_left = Ro_10c - Ro_10c_right,
      Ro_10c_left_rest = ksl_product_rest(R1->m01, R2->m00, Ro_10a, Ro_10c_left),
      Ro_10c_right_rest = ksl_product_rest(R1->m11, R2->m10, Ro_10b, Ro_10c_right),
      Ro_10c_lo = Ro_10c_left_rest + Ro_10c_right_rest, Ro_10d = R1->m21 * R2->m20,
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = Ro_10c - Ro_10_left,
      Ro_10_right_rest = ksl_product_rest(R1->m21, R2->m20, Ro_10d, Ro_10_right),
      Ro_10_lo1 = Ro_10_left_rest + Ro_10_right_rest, Ro_10_lo = Ro_10_lo1 + Ro_10c_lo;
  const double Ro_11a = R1->m01 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11c_right = Ro_11c - Ro_11a, Ro_11c_left = Ro_11c - Ro_11c_right,
      Ro_11c_left_rest = ksl_product_rest(R1->m01, R2->m01, Ro_11a, Ro_11c_left),
      Ro_11c_right_rest = ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right),
      Ro_11c_lo = Ro_11c_left_rest + Ro_11c_right_rest, Ro_11d = R1->m21 * R2->m21,
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c, Ro_11_left = Ro_11 - Ro_11_right,
      Ro_11_left_rest = Ro_11c - Ro_11_left,
      Ro_11_right_rest = ksl_product_rest(R1->m21, R2->m21, Ro_11d, Ro_11_right),
      Ro_11_lo1 = Ro_11_left_rest + Ro_11_right_rest, Ro_11_lo = Ro_11_lo1 + Ro_11c_lo;
  const double Ro_12a = R1->m01 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12c_right = Ro_12c - Ro_12a, Ro_12c_left = Ro_12c - Ro_12c_right,
      Ro_12c_left_rest = ksl_product_rest(R1->m01, R2->m02, Ro_12a, Ro_12c_left),
      Ro_12c_right_rest = ksl_product_rest(R1->m11, R2->m12, Ro_12b, Ro_12c_right),
      Ro_12c_lo = Ro_12c_left_rest + Ro_12c_right_rest, Ro_12d = R1->m21 * R2->m22,
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c, Ro_12_left = Ro_12 - Ro_12_right,
      Ro_12_left_rest = Ro_12c - Ro_12_left,
      Ro_12_right_rest = ksl_product_rest(R1->m21, R2->m22, Ro_12d, Ro_12_right),
      Ro_12_lo1 = Ro_12_left_rest + Ro_12_right_rest, Ro_12_lo = Ro_12_lo1 + Ro_12c_lo;
  const double Ro_20a = R1->m02 * R2->m00, Ro_20b = R1->m12 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20c_right = Ro_20c - Ro_20a, Ro_20c_left = Ro_20c - Ro_20c_right,
      Ro_20c_left_rest = ksl_product_rest(R1->m02, R2->m00, Ro_20a, Ro_20c_left),
      Ro_20c_right_rest = ksl_product_rest(R1->m12, R2->m10, Ro_20b, Ro_20c_right),
      Ro_20c_lo = Ro_20c_left_rest + Ro_20c_right_rest, Ro_20d = R1->m22 * R2->m20,
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c, Ro_20_left = Ro_20 - Ro_20_right,
      Ro_20_left_rest = Ro_20c - Ro_20_left,
      Ro_20_right_rest = ksl_product_rest(R1->m22, R2->m20, Ro_20d, Ro_20_right),
      Ro_20_lo1 = Ro_20_left_rest + Ro_20_right_rest, Ro_20_lo = Ro_20_lo1 + Ro_20c_lo;
  const double Ro_21a = R1->m02 * R2->m01, Ro_21b = R1->m12 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21c_right = Ro_21c - Ro_21a, Ro_21c_left = Ro_21c - Ro_21c_right,
      Ro_21c_left_rest = ksl_product_rest(R1->m02, R2->m01, Ro_21a, Ro_21c_left),
      Ro_21c_right_rest = ksl_product_rest(R1->m12, R2->m11, Ro_21b, Ro_21c_right),
      Ro_21c_lo = Ro_21c_left_rest + Ro_21c_right_rest, Ro_21d = R1->m22 * R2->m21,
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = Ro_21c - Ro_21_left,
      Ro_21_right_rest = ksl_product_rest(R1->m22, R2->m21, Ro_21d, Ro_21_right),
      Ro_21_lo1 = Ro_21_left_rest + Ro_21_right_rest, Ro_21_lo = Ro_21_lo1 + Ro_21c_lo;
  const double Ro_22a = R1->m02 * R2->m02, Ro_22b = R1->m12 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22c_right = Ro_22c - Ro_22a, Ro_22c_left = Ro_22c - Ro_22c_right,
      Ro_22c_left_rest = ksl_product_rest(R1->m02, R2->m02, Ro_22a, Ro_22c_left),
      Ro_22c_right_rest = ksl_product_rest(R1->m12, R2->m12, Ro_22b, Ro_22c_right),
      Ro_22c_lo = Ro_22c_left_rest + Ro_22c_right_rest, Ro_22d = R1->m22 * R2->m22,
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c, Ro_22_left = Ro_22 - Ro_22_right,
      Ro_22_left_rest = Ro_22c - Ro_22_left,
      Ro_22_right_rest = ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right),
      Ro_22_lo1 = Ro_22_left_rest + Ro_22_right_rest, Ro_22_lo = Ro_22_lo1 + Ro_22c_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 153 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m01 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00c_right = Do_00c - Do_00a, Do_00c_left = Do_00c - Do_00c_right,
      Do_00c_left_rest = ksl_product_rest(D1->m00, D2->m00, Do_00a, Do_00c_left),
      Do_00c_right_rest = ksl_product_rest(D1->m01, D2->m10, Do_00b, Do_00c_right),
      Do_00c_lo = Do_00c_left_rest + Do_00c_right_rest, Do_00d = D1->m02 * D2->m20,
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = Do_00c - Do_00_left,
      Do_00_right_rest = ksl_product_rest(D1->m02, D2->m20, Do_00d, Do_00_right),
      Do_00_lo1 = Do_00_left_rest + Do_00_right_rest, Do_00_lo = Do_00_lo1 + Do_00c_lo;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m01 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01c_right = Do_01c - Do_01a, Do_01c_left = Do_01c - Do_01c_right,
      Do_01c_left_rest = ksl_product_rest(D1->m00, D2->m01, Do_01a, Do_01c_left),
      Do_01c_right_rest = ksl_product_rest(D1->m01, D2->m11, Do_01b, Do_01c_right),
      Do_01c_lo = Do_01c_left_rest + Do_01c_right_rest, Do_01d = D1->m02 * D2->m21,
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = Do_01c - Do_01_left,
      Do_01_right_rest = ksl_product_rest(D1->m02, D2->m21, Do_01d, Do_01_right),
      Do_01_lo1 = Do_01_left_rest + Do_01_right_rest, Do_01_lo = Do_01_lo1 + Do_01c_lo;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m01 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02c_right = Do_02c - Do_02a, Do_02c_left = Do_02c - Do_02c_right,
      Do_02c_left_rest = ksl_product_rest(D1->m00, D2->m02, Do_02a, Do_02c_left),
      Do_02c_right_rest = ksl_product_rest(D1->m01, D2->m12, Do_02b, Do_02c_right),
      Do_02c_lo = Do_02c_left_rest + Do_02c_right_rest, Do_02d = D1->m02 * D2->m22,
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = Do_02c - Do_02_left,
      Do_02_right_rest = ksl_product_rest(D1->m02, D2->m22, Do_02d, Do_02_right),
      Do_02_lo1 = Do_02_left_rest + Do_02_right_rest, Do_02_lo = Do_02_lo1 + Do_02c_lo;
  const double Do_03a = D1->m00 * D2->m03, Do_03b = D1->m01 * D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03c_right = Do_03c - Do_03a, Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D1->m00, D2->m03, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D1->m01, D2->m13, Do_03b, Do_03c_right),
      Do_03c_lo = Do_03c_left_rest + Do_03c_right_rest, Do_03d = D1->m02 * D2->m23,
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D1->m02, D2->m23, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo = Do_03e_lo1 + Do_03c_lo,
      Do_03 = Do_03e + D1->m03, Do_03_right = Do_03 - Do_03e, Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = Do_03e - Do_03_left, Do_03_right_rest = D1->m03 - Do_03_right,
      Do_03_lo1 = Do_03_left_rest + Do_03_right_rest, Do_03_lo = Do_03_lo1 + Do_03e_lo;
  const double Do_10a = D1->m10 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10c_right = Do_10c - Do_10a, Do_10c_left = Do_10c - Do_10c_right,
      Do_10c_left_rest = ksl_product_rest(D1->m10, D2->m00, Do_10a, Do_10c_left),
      Do_10c_right_rest = ksl_product_rest(D1->m11, D2->m10, Do_10b, Do_10c_right),
      Do_10c_lo = Do_10c_left_rest + Do_10c_right_rest, Do_10d = D1->m12 * D2->m20,
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = Do_10c - Do_10_left,
      Do_10_right_rest = ksl_product_rest(D1->m12, D2->m20, Do_10d, Do_10_right),
      Do_10_lo1 = Do_10_left_rest + Do_10_right_rest, Do_10_lo = Do_10_lo1 + Do_10c_lo;
  const double Do_11a = D1->m10 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11c_right = Do_11c - Do_11a, Do_11c_left = Do_11c - Do_11c_right,
      Do_11c_left_rest = ksl_product_rest(D1->m10, D2->m01, Do_11a, Do_11c_left),
      Do_11c_right_rest = ksl_product_rest(D1->m11, D2->m11, Do_11b, Do_11c_right),
      Do_11c_lo = Do_11c_left_rest + Do_11c_right_rest, Do_11d = D1->m12 * D2->m21,
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = Do_11c - Do_11_left,
      Do_11_right_rest = ksl_product_rest(D1->m12, D2->m21, Do_11d, Do_11_right),
      Do_11_lo1 = Do_11_left_rest + Do_11_right_rest, Do_11_lo = Do_11_lo1 + Do_11c_lo;
  const double Do_12a = D1->m10 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12c_right = Do_12c - Do_12a, Do_12c_left = Do_12c - Do_12c_right,
      Do_12c_left_rest = ksl_product_rest(D1->m10, D2->m02, Do_12a, Do_12c_left),
      Do_12c_right_rest = ksl_product_rest(D1->m11, D2->m12, Do_12b, Do_12c_right),
      Do_12c_lo = Do_12c_left_rest + Do_12c_right_rest, Do_12d = D1->m12 * D2->m22,
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = Do_12c - Do_12_left,
      Do_12_right_rest = ksl_product_rest(D1->m12, D2->m22, Do_12d, Do_12_right),
      Do_12_lo1 = Do_12_left_rest + Do_12_right_rest, Do_12_lo = Do_12_lo1 + Do_12c_lo;
  const double Do_13a = D1->m10 * D2->m03, Do_13b = D1->m11 * D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13c_right = Do_13c - Do_13a, Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D1->m10, D2->m03, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D1->m11, D2->m13, Do_13b, Do_13c_right),
      Do_13c_lo = Do_13c_left_rest + Do_13c_right_rest, Do_13d = D1->m12 * D2->m23,
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D1->m12, D2->m23, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo = Do_13e_lo1 + Do_13c_lo,
      Do_13 = Do_13e + D1->m13, Do_13_right = Do_13 - Do_13e, Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = Do_13e - Do_13_left, Do_13_right_rest = D1->m13 - Do_13_right,
      Do_13_lo1 = Do_13_left_rest + Do_13_right_rest, Do_13_lo = Do_13_lo1 + Do_13e_lo;
  const double Do_20a = D1->m20 * D2->m00, Do_20b = D1->m21 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20c_right = Do_20c - Do_20a, Do_20c_left = Do_20c - Do_20c_right,
      Do_20c_left_rest = ksl_product_rest(D1->m20, D2->m00, Do_20a, Do_20c_left),
      Do_20c_right_rest = ksl_product_rest(D1->m21, D2->m10, Do_20b, Do_20c_right),
      Do_20c_lo = Do_20c_left_rest + Do_20c_right_rest, Do_20d = D1->m22 * D2->m20,
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = Do_20c - Do_20_left,
      Do_20_right_rest = ksl_product_rest(D1->m22, D2->m20, Do_20d, Do_20_right),
      Do_20_lo1 = Do_20_left_rest + Do_20_right_rest, Do_20_lo = Do_20_lo1 + Do_20c_lo;
  const double Do_21a = D1->m20 * D2->m01, Do_21b = D1->m21 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21c_right = Do_21c - Do_21a, Do_21c_left = Do_21c - Do_21c_right,
      Do_21c_left_rest = ksl_product_rest(D1->m20, D2->m01, Do_21a, Do_21c_left),
      Do_21c_right_rest = ksl_product_rest(D1->m21, D2->m11, Do_21b, Do_21c_right),
      Do_21c_lo = Do_21c_left_rest + Do_21c_right_rest, Do_21d = D1->m22 * D2->m21,
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = Do_21c - Do_21_left,
      Do_21_right_rest = ksl_product_rest(D1->m22, D2->m21, Do_21d, Do_21_right),
      Do_21_lo1 = Do_21_left_rest + Do_21_right_rest, Do_21_lo = Do_21_lo1 + Do_21c_lo;
  const double Do_22a = D1->m20 * D2->m02, Do_22b = D1->m21 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22c_right = Do_22c - Do_22a, Do_22c_left = Do_22c - Do_22c_right,
      Do_22c_left_rest = ksl_product_rest(D1->m20, D2->m02, Do_22a, Do_22c_left),
      Do_22c_right_rest = ksl_product_rest(D1->m21, D2->m12, Do_22b, Do_22c_right),
      Do_22c_lo = Do_22c_left_rest + Do_22c_right_rest, Do_22d = D1->m22 * D2->m22,
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = Do_22c - Do_22_left,
      Do_22_right_rest = ksl_product_rest(D1->m22, D2->m22, Do_22d, Do_22_right),
      Do_22_lo1 = Do_22_left_rest + Do_22_right_rest, Do_22_lo = Do_22_lo1 + Do_22c_lo;
  const double Do_23a = D1->m20 * D2->m03, Do_23b = D1->m21 * D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23c_right = Do_23c - Do_23a, Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D1->m20, D2->m03, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D1->m21, D2->m13, Do_23b, Do_23c_right),
      Do_23c_lo = Do_23c_left_rest + Do_23c_right_rest, Do_23d = D1->m22 * D2->m23,
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D1->m22, D2->m23, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo = Do_23e_lo1 + Do_23c_lo,
      Do_23 = Do_23e + D1->m23, Do_23_right = Do_23 - Do_23e, Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = Do_23e - Do_23_left, Do_23_right_rest = D1->m23 - Do_23_right,
      Do_23_lo1 = Do_23_left_rest + Do_23_right_rest, Do_23_lo = Do_23_lo1 + Do_23e_lo;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   45 mul, 162 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 44) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double R_0a = D1->m00 * D2->m00, R_0b = D1->m01 * D2->m01, R_0c = R_0a + R_0b,
      R_0c_right = R_0c - R_0a, R_0c_left = R_0c - R_0c_right,
      R_0c_left_rest = ksl_product_rest(D1->m00, D2->m00, R_0a, R_0c_left),
      R_0c_right_rest = ksl_product_rest(D1->m01, D2->m01, R_0b, R_0c_right),
      R_0c_lo = R_0c_left_rest + R_0c_right_rest, R_0d = D1->m02 * D2->m02, R_0 = R_0c + R_0d,
      R_0_right = R_0 - R_0c, R_0_left = R_0 - R_0_right, R_0_left_rest = R_0c - R_0_left,
      R_0_right_rest = ksl_product_rest(D1->m02, D2->m02, R_0d, R_0_right),
      R_0_lo1 = R_0_left_rest + R_0_right_rest, R_0_lo = R_0_lo1 + R_0c_lo;
  const double R_1a = D1->m00 * D2->m10, R_1b = D1->m01 * D2->m11, R_1c = R_1a + R_1b,
      R_1c_right = R_1c - R_1a, R_1c_left = R_1c - R_1c_right,
      R_1c_left_rest = ksl_product_rest(D1->m00, D2->m10, R_1a, R_1c_left),
      R_1c_right_rest = ksl_product_rest(D1->m01, D2->m11, R_1b, R_1c_right),
      R_1c_lo = R_1c_left_rest + R_1c_right_rest, R_1d = D1->m02 * D2->m12, R_1 = R_1c + R_1d,
      R_1_right = R_1 - R_1c, R_1_left = R_1 - R_1_right, R_1_left_rest = R_1c - R_1_left,
      R_1_right_rest = ksl_product_rest(D1->m02, D2->m12, R_1d, R_1_right),
      R_1_lo1 = R_1_left_rest + R_1_right_rest, R_1_lo = R_1_lo1 + R_1c_lo;
  const double R_2a = D1->m00 * D2->m20, R_2b = D1->m01 * D2->m21, R_2c = R_2a + R_2b,
      R_2c_right = R_2c - R_2a, R_2c_left = R_2c - R_2c_right,
      R_2c_left_rest = ksl_product_rest(D1->m00, D2->m20, R_2a, R_2c_left),
      R_2c_right_rest = ksl_product_rest(D1->m01, D2->m21, R_2b, R_2c_right),
      R_2c_lo = R_2c_left_rest + R_2c_right_rest, R_2d = D1->m02 * D2->m22, R_2 = R_2c + R_2d,
      R_2_right = R_2 - R_2c, R_2_left = R_2 - R_2_right, R_2_left_rest = R_2c - R_2_left,
      R_2_right_rest = ksl_product_rest(D1->m02, D2->m22, R_2d, R_2_right),
      R_2_lo1 = R_2_left_rest + R_2_right_rest, R_2_lo = R_2_lo1 + R_2c_lo;
  const double R_3a = D1->m10 * D2->m00, R_3b = D1->m11 * D2->m01, R_3c = R_3a + R_3b,
      R_3c_right = R_3c - R_3a, R_3c_left = R_3c - R_3c_right,
      R_3c_left_rest = ksl_product_rest(D1->m10, D2->m00, R_3a, R_3c_left),
      R_3c_right_rest = ksl_product_rest(D1->m11, D2->m01, R_3b, R_3c_right),
      R_3c_lo = R_3c_left_rest + R_3c_right_rest, R_3d = D1->m12 * D2->m02, R_3 = R_3c + R_3d,
      R_3_right = R_3 - R_3c, R_3_left = R_3 - R_3_right, R_3_left_rest = R_3c - R_3_left,
      R_3_right_rest = ksl_product_rest(D1->m12, D2->m02, R_3d, R_3_right),
      R_3_lo1 = R_3_left_rest + R_3_right_rest, R_3_lo = R_3_lo1 + R_3c_lo;
  const double R_4a = D1->m10 * D2->m10, R_4b = D1->m11 * D2->m11, R_4c = R_4a + R_4b,
      R_4c_right = R_4c - R_4a, R_4c_left = R_4c - R_4c_right,
      R_4c_left_rest = ksl_product_rest(D1->m10, D2->m10, R_4a, R_4c_left),
      R_4c_right_rest = ksl_product_rest(D1->m11, D2->m11, R_4b, R_4c_right),
      R_4c_lo = R_4c_left_rest + R_4c_right_rest, R_4d = D1->m12 * D2->m12, R_4 = R_4c + R_4d,
      R_4_right = R_4 - R_4c, R_4_left = R_4 - R_4_right, R_4_left_rest = R_4c - R_4_left,
      R_4_right_rest = ksl_product_rest(D1->m12, D2->m12, R_4d, R_4_right),
      R_4_lo1 = R_4_left_rest + R_4_right_rest, R_4_lo = R_4_lo1 + R_4c_lo;
  const double R_5a = D1->m10 * D2->m20, R_5b = D1->m11 * D2->m21, R_5c = R_5a + R_5b,
      R_5c_right = R_5c - R_5a, R_5c_left = R_5c - R_5c_right,
      R_5c_left_rest = ksl_product_rest(D1->m10, D2->m20, R_5a, R_5c_left),
      R_5c_right_rest = ksl_product_rest(D1->m11, D2->m21, R_5b, R_5c_right),
      R_5c_lo = R_5c_left_rest + R_5c_right_rest, R_5d = D1->m12 * D2->m22, R_5 = R_5c + R_5d,
      R_5_right = R_5 - R_5c, R_5_left = R_5 - R_5_right, R_5_left_rest = R_5c - R_5_left,
      R_5_right_rest = ksl_product_rest(D1->m12, D2->m22, R_5d, R_5_right),
      R_5_lo1 = R_5_left_rest + R_5_right_rest, R_5_lo = R_5_lo1 + R_5c_lo;
  const double R_6a = D1->m20 * D2->m00, R_6b = D1->m21 * D2->m01, R_6c = R_6a + R_6b,
      R_6c_right = R_6c - R_6a, R_6c_left = R_6c - R_6c_right,
      R_6c_left_rest = ksl_product_rest(D1->m20, D2->m00, R_6a, R_6c_left),
      R_6c_right_rest = ksl_product_rest(D1->m21, D2->m01, R_6b, R_6c_right),
      R_6c_lo = R_6c_left_rest + R_6c_right_rest, R_6d = D1->m22 * D2->m02, R_6 = R_6c + R_6d,
      R_6_right = R_6 - R_6c, R_6_left = R_6 - R_6_right, R_6_left_rest = R_6c - R_6_left,
      R_6_right_rest = ksl_product_rest(D1->m22, D2->m02, R_6d, R_6_right),
      R_6_lo1 = R_6_left_rest + R_6_right_rest, R_6_lo = R_6_lo1 + R_6c_lo;
  const double R_7a = D1->m20 * D2->m10, R_7b = D1->m21 * D2->m11, R_7c = R_7a + R_7b,
      R_7c_right = R_7c - R_7a, R_7c_left = R_7c - R_7c_right,
      R_7c_left_rest = ksl_product_rest(D1->m20, D2->m10, R_7a, R_7c_left),
      R_7c_right_rest = ksl_product_rest(D1->m21, D2->m11, R_7b, R_7c_right),
      R_7c_lo = R_7c_left_rest + R_7c_right_rest, R_7d = D1->m22 * D2->m12, R_7 = R_7c + R_7d,
      R_7_right = R_7 - R_7c, R_7_left = R_7 - R_7_right, R_7_left_rest = R_7c - R_7_left,
      R_7_right_rest = ksl_product_rest(D1->m22, D2->m12, R_7d, R_7_right),
      R_7_lo1 = R_7_left_rest + R_7_right_rest, R_7_lo = R_7_lo1 + R_7c_lo;
  const double R_8a = D1->m20 * D2->m20, R_8b = D1->m21 * D2->m21, R_8c = R_8a + R_8b,
      R_8c_right = R_8c - R_8a, R_8c_left = R_8c - R_8c_right,
      R_8c_left_rest = ksl_product_rest(D1->m20, D2->m20, R_8a, R_8c_left),
      R_8c_right_rest = ksl_product_rest(D1->m21, D2->m21, R_8b, R_8c_right),
      R_8c_lo = R_8c_left_rest + R_8c_right_rest, R_8d = D1->m22 * D2->m22, R_8 = R_8c + R_8d,
      R_8_right = R_8 - R_8c, R_8_left = R_8 - R_8_right, R_8_left_rest = R_8c - R_8_left,
      R_8_right_rest = ksl_product_rest(D1->m22, D2->m22, R_8d, R_8_right),
      R_8_lo1 = R_8_left_rest + R_8_right_rest, R_8_lo = R_8_lo1 + R_8c_lo;
  const double Do_03a = D2->m03 * R_0, Do_03a_cross2 = D2->m03 * R_0_lo, Do_03b = D2->m13 * R_1,
      Do_03b_cross2 = D2->m13 * R_1_lo, Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D2->m03, R_0, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D2->m13, R_1, Do_03b, Do_03c_right),
      Do_03c_cross = Do_03a_cross2 + Do_03b_cross2,
      Do_03c_lo1 = Do_03c_left_rest + Do_03c_right_rest, Do_03c_lo = Do_03c_lo1 + Do_03c_cross,
      Do_03d = D2->m23 * R_2, Do_03d_cross2 = D2->m23 * R_2_lo, Do_03e = Do_03c + Do_03d,
      Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D2->m23, R_2, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo2 = Do_03e_lo1 + Do_03d_cross2,
      Do_03e_lo = Do_03e_lo2 + Do_03c_lo, Do_03 = D1->m03 - Do_03e, Do_03_right = D1->m03 - Do_03,
      Do_03_left = Do_03 + Do_03_right, Do_03_left_rest = D1->m03 - Do_03_left,
      Do_03_right_rest = Do_03e - Do_03_right, Do_03_lo1 = Do_03_left_rest - Do_03_right_rest,
      Do_03_lo = Do_03_lo1 - Do_03e_lo;
  const double Do_13a = D2->m03 * R_3, Do_13a_cross2 = D2->m03 * R_3_lo, Do_13b = D2->m13 * R_4,
      Do_13b_cross2 = D2->m13 * R_4_lo, Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D2->m03, R_3, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D2->m13, R_4, Do_13b, Do_13c_right),
      Do_13c_cross = Do_13a_cross2 + Do_13b_cross2,
      Do_13c_lo1 = Do_13c_left_rest + Do_13c_right_rest, Do_13c_lo = Do_13c_lo1 + Do_13c_cross,
      Do_13d = D2->m23 * R_5, Do_13d_cross2 = D2->m23 * R_5_lo, Do_13e = Do_13c + Do_13d,
      Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D2->m23, R_5, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo2 = Do_13e_lo1 + Do_13d_cross2,
      Do_13e_lo = Do_13e_lo2 + Do_13c_lo, Do_13 = D1->m13 - Do_13e, Do_13_right = D1->m13 - Do_13,
      Do_13_left = Do_13 + Do_13_right, Do_13_left_rest = D1->m13 - Do_13_left,
      Do_13_right_rest = Do_13e - Do_13_right, Do_13_lo1 = Do_13_left_rest - Do_13_right_rest,
      Do_13_lo = Do_13_lo1 - Do_13e_lo;
  const double Do_23a = D2->m03 * R_6, Do_23a_cross2 = D2->m03 * R_6_lo, Do_23b = D2->m13 * R_7,
      Do_23b_cross2 = D2->m13 * R_7_lo, Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D2->m03, R_6, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D2->m13, R_7, Do_23b, Do_23c_right),
      Do_23c_cross = Do_23a_cross2 + Do_23b_cross2,
      Do_23c_lo1 = Do_23c_left_rest + Do_23c_right_rest, Do_23c_lo = Do_23c_lo1 + Do_23c_cross,
      Do_23d = D2->m23 * R_8, Do_23d_cross2 = D2->m23 * R_8_lo, Do_23e = Do_23c + Do_23d,
      Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D2->m23, R_8, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo2 = Do_23e_lo1 + Do_23d_cross2,
      Do_23e_lo = Do_23e_lo2 + Do_23c_lo, Do_23 = D1->m23 - Do_23e, Do_23_right = D1->m23 - Do_23,
      Do_23_left = Do_23 + Do_23_right, Do_23_left_rest = D1->m23 - Do_23_left,
      Do_23_right_rest = Do_23e - Do_23_right, Do_23_lo1 = Do_23_left_rest - Do_23_right_rest,
      Do_23_lo = Do_23_lo1 - Do_23e_lo;
  const double R_0_rounded = R_0 + R_0_lo;
  const double R_1_rounded = R_1 + R_1_lo;
  const double R_2_rounded = R_2 + R_2_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double R_3_rounded = R_3 + R_3_lo;
  const double R_4_rounded = R_4 + R_4_lo;
  const double R_5_rounded = R_5 + R_5_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double R_6_rounded = R_6 + R_6_lo;
  const double R_7_rounded = R_7 + R_7_lo;
  const double R_8_rounded = R_8 + R_8_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  Do->m00 = R_0_rounded;
  Do->m01 = R_1_rounded;
  Do->m02 = R_2_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = R_3_rounded;
  Do->m11 = R_4_rounded;
  Do->m12 = R_5_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = R_6_rounded;
  Do->m21 = R_7_rounded;
  Do->m22 = R_8_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   45 mul, 159 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 18) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03, p_0_right = D2->m03 - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = D2->m03 - p_0_left, p_0_right_rest = D1->m03 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = D2->m13 - D1->m13, p_1_right = D2->m13 - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = D2->m13 - p_1_left, p_1_right_rest = D1->m13 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = D2->m23 - D1->m23, p_2_right = D2->m23 - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = D2->m23 - p_2_left, p_2_right_rest = D1->m23 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m10 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00c_right = Do_00c - Do_00a, Do_00c_left = Do_00c - Do_00c_right,
      Do_00c_left_rest = ksl_product_rest(D1->m00, D2->m00, Do_00a, Do_00c_left),
      Do_00c_right_rest = ksl_product_rest(D1->m10, D2->m10, Do_00b, Do_00c_right),
      Do_00c_lo = Do_00c_left_rest + Do_00c_right_rest, Do_00d = D1->m20 * D2->m20,
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = Do_00c - Do_00_left,
      Do_00_right_rest = ksl_product_rest(D1->m20, D2->m20, Do_00d, Do_00_right),
      Do_00_lo1 = Do_00_left_rest + Do_00_right_rest, Do_00_lo = Do_00_lo1 + Do_00c_lo;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m10 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01c_right = Do_01c - Do_01a, Do_01c_left = Do_01c - Do_01c_right,
      Do_01c_left_rest = ksl_product_rest(D1->m00, D2->m01, Do_01a, Do_01c_left),
      Do_01c_right_rest = ksl_product_rest(D1->m10, D2->m11, Do_01b, Do_01c_right),
      Do_01c_lo = Do_01c_left_rest + Do_01c_right_rest, Do_01d = D1->m20 * D2->m21,
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = Do_01c - Do_01_left,
      Do_01_right_rest = ksl_product_rest(D1->m20, D2->m21, Do_01d, Do_01_right),
      Do_01_lo1 = Do_01_left_rest + Do_01_right_rest, Do_01_lo = Do_01_lo1 + Do_01c_lo;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m10 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02c_right = Do_02c - Do_02a, Do_02c_left = Do_02c - Do_02c_right,
      Do_02c_left_rest = ksl_product_rest(D1->m00, D2->m02, Do_02a, Do_02c_left),
      Do_02c_right_rest = ksl_product_rest(D1->m10, D2->m12, Do_02b, Do_02c_right),
      Do_02c_lo = Do_02c_left_rest + Do_02c_right_rest, Do_02d = D1->m20 * D2->m22,
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = Do_02c - Do_02_left,
      Do_02_right_rest = ksl_product_rest(D1->m20, D2->m22, Do_02d, Do_02_right),
      Do_02_lo1 = Do_02_left_rest + Do_02_right_rest, Do_02_lo = Do_02_lo1 + Do_02c_lo;
  const double Do_03a = D1->m00 * p_0, Do_03a_cross2 = D1->m00 * p_0_lo, Do_03b = D1->m10 * p_1,
      Do_03b_cross2 = D1->m10 * p_1_lo, Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D1->m00, p_0, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D1->m10, p_1, Do_03b, Do_03c_right),
      Do_03c_cross = Do_03a_cross2 + Do_03b_cross2,
      Do_03c_lo1 = Do_03c_left_rest + Do_03c_right_rest, Do_03c_lo = Do_03c_lo1 + Do_03c_cross,
      Do_03d = D1->m20 * p_2, Do_03d_cross2 = D1->m20 * p_2_lo, Do_03 = Do_03c + Do_03d,
      Do_03_right = Do_03 - Do_03c, Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = Do_03c - Do_03_left,
      Do_03_right_rest = ksl_product_rest(D1->m20, p_2, Do_03d, Do_03_right),
      Do_03_lo1 = Do_03_left_rest + Do_03_right_rest, Do_03_lo2 = Do_03_lo1 + Do_03d_cross2,
      Do_03_lo = Do_03_lo2 + Do_03c_lo;
  const double Do_10a = D1->m01 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10c_right = Do_10c - Do_10a, Do_10c_left = Do_10c - Do_10c_right,
      Do_10c_left_rest = ksl_product_rest(D1->m01, D2->m00, Do_10a, Do_10c_left),
      Do_10c_right_rest = ksl_product_rest(D1->m11, D2->m10, Do_10b, Do_10c_right),
      Do_10c_lo = Do_10c_left_rest + Do_10c_right_rest, Do_10d = D1->m21 * D2->m20,
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = Do_10c - Do_10_left,
      Do_10_right_rest = ksl_product_rest(D1->m21, D2->m20, Do_10d, Do_10_right),
      Do_10_lo1 = Do_10_left_rest + Do_10_right_rest, Do_10_lo = Do_10_lo1 + Do_10c_lo;
  const double Do_11a = D1->m01 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11c_right = Do_11c - Do_11a, Do_11c_left = Do_11c - Do_11c_right,
      Do_11c_left_rest = ksl_product_rest(D1->m01, D2->m01, Do_11a, Do_11c_left),
      Do_11c_right_rest = ksl_product_rest(D1->m11, D2->m11, Do_11b, Do_11c_right),
      Do_11c_lo = Do_11c_left_rest + Do_11c_right_rest, Do_11d = D1->m21 * D2->m21,
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = Do_11c - Do_11_left,
      Do_11_right_rest = ksl_product_rest(D1->m21, D2->m21, Do_11d, Do_11_right),
      Do_11_lo1 = Do_11_left_rest + Do_11_right_rest, Do_11_lo = Do_11_lo1 + Do_11c_lo;
  const double Do_12a = D1->m01 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12c_right = Do_12c - Do_12a, Do_12c_left = Do_12c - Do_12c_right,
      Do_12c_left_rest = ksl_product_rest(D1->m01, D2->m02, Do_12a, Do_12c_left),
      Do_12c_right_rest = ksl_product_rest(D1->m11, D2->m12, Do_12b, Do_12c_right),
      Do_12c_lo = Do_12c_left_rest + Do_12c_right_rest, Do_12d = D1->m21 * D2->m22,
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = Do_12c - Do_12_left,
      Do_12_right_rest = ksl_product_rest(D1->m21, D2->m22, Do_12d, Do_12_right),
      Do_12_lo1 = Do_12_left_rest + Do_12_right_rest, Do_12_lo = Do_12_lo1 + Do_12c_lo;
  const double Do_13a = D1->m01 * p_0, Do_13a_cross2 = D1->m01 * p_0_lo, Do_13b = D1->m11 * p_1,
      Do_13b_cross2 = D1->m11 * p_1_lo, Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D1->m01, p_0, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D1->m11, p_1, Do_13b, Do_13c_right),
      Do_13c_cross = Do_13a_cross2 + Do_13b_cross2,
      Do_13c_lo1 = Do_13c_left_rest + Do_13c_right_rest, Do_13c_lo = Do_13c_lo1 + Do_13c_cross,
      Do_13d = D1->m21 * p_2, Do_13d_cross2 = D1->m21 * p_2_lo, Do_13 = Do_13c + Do_13d,
      Do_13_right = Do_13 - Do_13c, Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = Do_13c - Do_13_left,
      Do_13_right_rest = ksl_product_rest(D1->m21, p_2, Do_13d, Do_13_right),
      Do_13_lo1 = Do_13_left_rest + Do_13_right_rest, Do_13_lo2 = Do_13_lo1 + Do_13d_cross2,
      Do_13_lo = Do_13_lo2 + Do_13c_lo;
  const double Do_20a = D1->m02 * D2->m00, Do_20b = D1->m12 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20c_right = Do_20c - Do_20a, Do_20c_left = Do_20c - Do_20c_right,
      Do_20c_left_rest = ksl_product_rest(D1->m02, D2->m00, Do_20a, Do_20c_left),
      Do_20c_right_rest = ksl_product_rest(D1->m12, D2->m10, Do_20b, Do_20c_right),
      Do_20c_lo = Do_20c_left_rest + Do_20c_right_rest, Do_20d = D1->m22 * D2->m20,
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = Do_20c - Do_20_left,
      Do_20_right_rest = ksl_product_rest(D1->m22, D2->m20, Do_20d, Do_20_right),
      Do_20_lo1 = Do_20_left_rest + Do_20_right_rest, Do_20_lo = Do_20_lo1 + Do_20c_lo;
  const double Do_21a = D1->m02 * D2->m01, Do_21b = D1->m12 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21c_right = Do_21c - Do_21a, Do_21c_left = Do_21c - Do_21c_right,
      Do_21c_left_rest = ksl_product_rest(D1->m02, D2->m01, Do_21a, Do_21c_left),
      Do_21c_right_rest = ksl_product_rest(D1->m12, D2->m11, Do_21b, Do_21c_right),
      Do_21c_lo = Do_21c_left_rest + Do_21c_right_rest, Do_21d = D1->m22 * D2->m21,
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = Do_21c - Do_21_left,
      Do_21_right_rest = ksl_product_rest(D1->m22, D2->m21, Do_21d, Do_21_right),
      Do_21_lo1 = Do_21_left_rest + Do_21_right_rest, Do_21_lo = Do_21_lo1 + Do_21c_lo;
  const double Do_22a = D1->m02 * D2->m02, Do_22b = D1->m12 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22c_right = Do_22c - Do_22a, Do_22c_left = Do_22c - Do_22c_right,
      Do_22c_left_rest = ksl_product_rest(D1->m02, D2->m02, Do_22a, Do_22c_left),
      Do_22c_right_rest = ksl_product_rest(D1->m12, D2->m12, Do_22b, Do_22c_right),
      Do_22c_lo = Do_22c_left_rest + Do_22c_right_rest, Do_22d = D1->m22 * D2->m22,
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = Do_22c - Do_22_left,
      Do_22_right_rest = ksl_product_rest(D1->m22, D2->m22, Do_22d, Do_22_right),
      Do_22_lo1 = Do_22_left_rest + Do_22_right_rest, Do_22_lo = Do_22_lo1 + Do_22c_lo;
  const double Do_23a = D1->m02 * p_0, Do_23a_cross2 = D1->m02 * p_0_lo, Do_23b = D1->m12 * p_1,
      Do_23b_cross2 = D1->m12 * p_1_lo, Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D1->m02, p_0, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D1->m12, p_1, Do_23b, Do_23c_right),
      Do_23c_cross = Do_23a_cross2 + Do_23b_cross2,
      Do_23c_lo1 = Do_23c_left_rest + Do_23c_right_rest, Do_23c_lo = Do_23c_lo1 + Do_23c_cross,
      Do_23d = D1->m22 * p_2, Do_23d_cross2 = D1->m22 * p_2_lo, Do_23 = Do_23c + Do_23d,
      Do_23_right = Do_23 - Do_23c, Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = Do_23c - Do_23_left,
      Do_23_right_rest = ksl_product_rest(D1->m22, p_2, Do_23d, Do_23_right),
      Do_23_lo1 = Do_23_left_rest + Do_23_right_rest, Do_23_lo2 = Do_23_lo1 + Do_23d_cross2,
      Do_23_lo = Do_23_lo2 + Do_23c_lo;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m10, Do_00c = Do_00a + Do_00b,
      Do_00c_right = Do_00c - Do_00a, Do_00c_left = Do_00c - Do_00c_right,
      Do_00c_left_rest = ksl_product_rest(D->m00, R->m00, Do_00a, Do_00c_left),
      Do_00c_right_rest = ksl_product_rest(D->m01, R->m10, Do_00b, Do_00c_right),
      Do_00c_lo = Do_00c_left_rest + Do_00c_right_rest, Do_00d = D->m02 * R->m20,
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = Do_00c - Do_00_left,
      Do_00_right_rest = ksl_product_rest(D->m02, R->m20, Do_00d, Do_00_right),
      Do_00_lo1 = Do_00_left_rest + Do_00_right_rest, Do_00_lo = Do_00_lo1 + Do_00c_lo;
  const double Do_01a = D->m00 * R->m01, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01c_right = Do_01c - Do_01a, Do_01c_left = Do_01c - Do_01c_right,
      Do_01c_left_rest = ksl_product_rest(D->m00, R->m01, Do_01a, Do_01c_left),
      Do_01c_right_rest = ksl_product_rest(D->m01, R->m11, Do_01b, Do_01c_right),
      Do_01c_lo = Do_01c_left_rest + Do_01c_right_rest, Do_01d = D->m02 * R->m21,
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = Do_01c - Do_01_left,
      Do_01_right_rest = ksl_product_rest(D->m02, R->m21, Do_01d, Do_01_right),
      Do_01_lo1 = Do_01_left_rest + Do_01_right_rest, Do_01_lo = Do_01_lo1 + Do_01c_lo;
  const double Do_02a = D->m00 * R->m02, Do_02b = D->m01 * R->m12, Do_02c = Do_02a + Do_02b,
      Do_02c_right = Do_02c - Do_02a, Do_02c_left = Do_02c - Do_02c_right,
      Do_02c_left_rest = ksl_product_rest(D->m00, R->m02, Do_02a, Do_02c_left),
      Do_02c_right_rest = ksl_product_rest(D->m01, R->m12, Do_02b, Do_02c_right),
      Do_02c_lo = Do_02c_left_rest + Do_02c_right_rest, Do_02d = D->m02 * R->m22,
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = Do_02c - Do_02_left,
      Do_02_right_rest = ksl_product_rest(D->m02, R->m22, Do_02d, Do_02_right),
      Do_02_lo1 = Do_02_left_rest + Do_02_right_rest, Do_02_lo = Do_02_lo1 + Do_02c_lo;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m10, Do_10c = Do_10a + Do_10b,
      Do_10c_right = Do_10c - Do_10a, Do_10c_left = Do_10c - Do_10c_right,
      Do_10c_left_rest = ksl_product_rest(D->m10, R->m00, Do_10a, Do_10c_left),
      Do_10c_right_rest = ksl_product_rest(D->m11, R->m10, Do_10b, Do_10c_right),
      Do_10c_lo = Do_10c_left_rest + Do_10c_right_rest, Do_10d = D->m12 * R->m20,
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = Do_10c - Do_10_left,
      Do_10_right_rest = ksl_product_rest(D->m12, R->m20, Do_10d, Do_10_right),
      Do_10_lo1 = Do_10_left_rest + Do_10_right_rest, Do_10_lo = Do_10_lo1 + Do_10c_lo;
  const double Do_11a = D->m10 * R->m01, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11c_right = Do_11c - Do_11a, Do_11c_left = Do_11c - Do_11c_right,
      Do_11c_left_rest = ksl_product_rest(D->m10, R->m01, Do_11a, Do_11c_left),
      Do_11c_right_rest = ksl_product_rest(D->m11, R->m11, Do_11b, Do_11c_right),
      Do_11c_lo = Do_11c_left_rest + Do_11c_right_rest, Do_11d = D->m12 * R->m21,
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = Do_11c - Do_11_left,
      Do_11_right_rest = ksl_product_rest(D->m12, R->m21, Do_11d, Do_11_right),
      Do_11_lo1 = Do_11_left_rest + Do_11_right_rest, Do_11_lo = Do_11_lo1 + Do_11c_lo;
  const double Do_12a = D->m10 * R->m02, Do_12b = D->m11 * R->m12, Do_12c = Do_12a + Do_12b,
      Do_12c_right = Do_12c - Do_12a, Do_12c_left = Do_12c - Do_12c_right,
      Do_12c_left_rest = ksl_product_rest(D->m10, R->m02, Do_12a, Do_12c_left),
      Do_12c_right_rest = ksl_product_rest(D->m11, R->m12, Do_12b, Do_12c_right),
      Do_12c_lo = Do_12c_left_rest + Do_12c_right_rest, Do_12d = D->m12 * R->m22,
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = Do_12c - Do_12_left,
      Do_12_right_rest = ksl_product_rest(D->m12, R->m22, Do_12d, Do_12_right),
      Do_12_lo1 = Do_12_left_rest + Do_12_right_rest, Do_12_lo = Do_12_lo1 + Do_12c_lo;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m10, Do_20c = Do_20a + Do_20b,
      Do_20c_right = Do_20c - Do_20a, Do_20c_left = Do_20c - Do_20c_right,
      Do_20c_left_rest = ksl_product_rest(D->m20, R->m00, Do_20a, Do_20c_left),
      Do_20c_right_rest = ksl_product_rest(D->m21, R->m10, Do_20b, Do_20c_right),
      Do_20c_lo = Do_20c_left_rest + Do_20c_right_rest, Do_20d = D->m22 * R->m20,
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = Do_20c - Do_20_left,
      Do_20_right_rest = ksl_product_rest(D->m22, R->m20, Do_20d, Do_20_right),
      Do_20_lo1 = Do_20_left_rest + Do_20_right_rest, Do_20_lo = Do_20_lo1 + Do_20c_lo;
  const double Do_21a = D->m20 * R->m01, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21c_right = Do_21c - Do_21a, Do_21c_left = Do_21c - Do_21c_right,
      Do_21c_left_rest = ksl_product_rest(D->m20, R->m01, Do_21a, Do_21c_left),
      Do_21c_right_rest = ksl_product_rest(D->m21, R->m11, Do_21b, Do_21c_right),
      Do_21c_lo = Do_21c_left_rest + Do_21c_right_rest, Do_21d = D->m22 * R->m21,
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = Do_21c - Do_21_left,
      Do_21_right_rest = ksl_product_rest(D->m22, R->m21, Do_21d, Do_21_right),
      Do_21_lo1 = Do_21_left_rest + Do_21_right_rest, Do_21_lo = Do_21_lo1 + Do_21c_lo;
  const double Do_22a = D->m20 * R->m02, Do_22b = D->m21 * R->m12, Do_22c = Do_22a + Do_22b,
      Do_22c_right = Do_22c - Do_22a, Do_22c_left = Do_22c - Do_22c_right,
      Do_22c_left_rest = ksl_product_rest(D->m20, R->m02, Do_22a, Do_22c_left),
      Do_22c_right_rest = ksl_product_rest(D->m21, R->m12, Do_22b, Do_22c_right),
      Do_22c_lo = Do_22c_left_rest + Do_22c_right_rest, Do_22d = D->m22 * R->m22,
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = Do_22c - Do_22_left,
      Do_22_right_rest = ksl_product_rest(D->m22, R->m22, Do_22d, Do_22_right),
      Do_22_lo1 = Do_22_left_rest + Do_22_right_rest, Do_22_lo = Do_22_lo1 + Do_22c_lo;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m01, Do_00c = Do_00a + Do_00b,
      Do_00c_right = Do_00c - Do_00a, Do_00c_left = Do_00c - Do_00c_right,
      Do_00c_left_rest = ksl_product_rest(D->m00, R->m00, Do_00a, Do_00c_left),
      Do_00c_right_rest = ksl_product_rest(D->m01, R->m01, Do_00b, Do_00c_right),
      Do_00c_lo = Do_00c_left_rest + Do_00c_right_rest, Do_00d = D->m02 * R->m02,
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = Do_00c - Do_00_left,
      Do_00_right_rest = ksl_product_rest(D->m02, R->m02, Do_00d, Do_00_right),
      Do_00_lo1 = Do_00_left_rest + Do_00_right_rest, Do_00_lo = Do_00_lo1 + Do_00c_lo;
  const double Do_01a = D->m00 * R->m10, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01c_right = Do_01c - Do_01a, Do_01c_left = Do_01c - Do_01c_right,
      Do_01c_left_rest = ksl_product_rest(D->m00, R->m10, Do_01a, Do_01c_left),
      Do_01c_right_rest = ksl_product_rest(D->m01, R->m11, Do_01b, Do_01c_right),
      Do_01c_lo = Do_01c_left_rest + Do_01c_right_rest, Do_01d = D->m02 * R->m12,
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = Do_01c - Do_01_left,
      Do_01_right_rest = ksl_product_rest(D->m02, R->m12, Do_01d, Do_01_right),
      Do_01_lo1 = Do_01_left_rest + Do_01_right_rest, Do_01_lo = Do_01_lo1 + Do_01c_lo;
  const double Do_02a = D->m00 * R->m20, Do_02b = D->m01 * R->m21, Do_02c = Do_02a + Do_02b,
      Do_02c_right = Do_02c - Do_02a, Do_02c_left = Do_02c - Do_02c_right,
      Do_02c_left_rest = ksl_product_rest(D->m00, R->m20, Do_02a, Do_02c_left),
      Do_02c_right_rest = ksl_product_rest(D->m01, R->m21, Do_02b, Do_02c_right),
      Do_02c_lo = Do_02c_left_rest + Do_02c_right_rest, Do_02d = D->m02 * R->m22,
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = Do_02c - Do_02_left,
      Do_02_right_rest = ksl_product_rest(D->m02, R->m22, Do_02d, Do_02_right),
      Do_02_lo1 = Do_02_left_rest + Do_02_right_rest, Do_02_lo = Do_02_lo1 + Do_02c_lo;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m01, Do_10c = Do_10a + Do_10b,
      Do_10c_right = Do_10c - Do_10a, Do_10c_left = Do_10c - Do_10c_right,
      Do_10c_left_rest = ksl_product_rest(D->m10, R->m00, Do_10a, Do_10c_left),
      Do_10c_right_rest = ksl_product_rest(D->m11, R->m01, Do_10b, Do_10c_right),
      Do_10c_lo = Do_10c_left_rest + Do_10c_right_rest, Do_10d = D->m12 * R->m02,
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = Do_10c - Do_10_left,
      Do_10_right_rest = ksl_product_rest(D->m12, R->m02, Do_10d, Do_10_right),
      Do_10_lo1 = Do_10_left_rest + Do_10_right_rest, Do_10_lo = Do_10_lo1 + Do_10c_lo;
  const double Do_11a = D->m10 * R->m10, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11c_right = Do_11c - Do_11a, Do_11c_left = Do_11c - Do_11c_right,
      Do_11c_left_rest = ksl_product_rest(D->m10, R->m10, Do_11a, Do_11c_left),
      Do_11c_right_rest = ksl_product_rest(D->m11, R->m11, Do_11b, Do_11c_right),
      Do_11c_lo = Do_11c_left_rest + Do_11c_right_rest, Do_11d = D->m12 * R->m12,
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = Do_11c - Do_11_left,
      Do_11_right_rest = ksl_product_rest(D->m12, R->m12, Do_11d, Do_11_right),
      Do_11_lo1 = Do_11_left_rest + Do_11_right_rest, Do_11_lo = Do_11_lo1 + Do_11c_lo;
  const double Do_12a = D->m10 * R->m20, Do_12b = D->m11 * R->m21, Do_12c = Do_12a + Do_12b,
      Do_12c_right = Do_12c - Do_12a, Do_12c_left = Do_12c - Do_12c_right,
      Do_12c_left_rest = ksl_product_rest(D->m10, R->m20, Do_12a, Do_12c_left),
      Do_12c_right_rest = ksl_product_rest(D->m11, R->m21, Do_12b, Do_12c_right),
      Do_12c_lo = Do_12c_left_rest + Do_12c_right_rest, Do_12d = D->m12 * R->m22,
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = Do_12c - Do_12_left,
      Do_12_right_rest = ksl_product_rest(D->m12, R->m22, Do_12d, Do_12_right),
      Do_12_lo1 = Do_12_left_rest + Do_12_right_rest, Do_12_lo = Do_12_lo1 + Do_12c_lo;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m01, Do_20c = Do_20a + Do_20b,
      Do_20c_right = Do_20c - Do_20a, Do_20c_left = Do_20c - Do_20c_right,
      Do_20c_left_rest = ksl_product_rest(D->m20, R->m00, Do_20a, Do_20c_left),
      Do_20c_right_rest = ksl_product_rest(D->m21, R->m01, Do_20b, Do_20c_right),
      Do_20c_lo = Do_20c_left_rest + Do_20c_right_rest, Do_20d = D->m22 * R->m02,
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = Do_20c - Do_20_left,
      Do_20_right_rest = ksl_product_rest(D->m22, R->m02, Do_20d, Do_20_right),
      Do_20_lo1 = Do_20_left_rest + Do_20_right_rest, Do_20_lo = Do_20_lo1 + Do_20c_lo;
  const double Do_21a = D->m20 * R->m10, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21c_right = Do_21c - Do_21a, Do_21c_left = Do_21c - Do_21c_right,
      Do_21c_left_rest = ksl_product_rest(D->m20, R->m10, Do_21a, Do_21c_left),
      Do_21c_right_rest = ksl_product_rest(D->m21, R->m11, Do_21b, Do_21c_right),
      Do_21c_lo = Do_21c_left_rest + Do_21c_right_rest, Do_21d = D->m22 * R->m12,
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = Do_21c - Do_21_left,
      Do_21_right_rest = ksl_product_rest(D->m22, R->m12, Do_21d, Do_21_right),
      Do_21_lo1 = Do_21_left_rest + Do_21_right_rest, Do_21_lo = Do_21_lo1 + Do_21c_lo;
  const double Do_22a = D->m20 * R->m20, Do_22b = D->m21 * R->m21, Do_22c = Do_22a + Do_22b,
      Do_22c_right = Do_22c - Do_22a, Do_22c_left = Do_22c - Do_22c_right,
      Do_22c_left_rest = ksl_product_rest(D->m20, R->m20, Do_22a, Do_22c_left),
      Do_22c_right_rest = ksl_product_rest(D->m21, R->m21, Do_22b, Do_22c_right),
      Do_22c_lo = Do_22c_left_rest + Do_22c_right_rest, Do_22d = D->m22 * R->m22,
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = Do_22c - Do_22_left,
      Do_22_right_rest = ksl_product_rest(D->m22, R->m22, Do_22d, Do_22_right),
      Do_22_lo1 = Do_22_left_rest + Do_22_right_rest, Do_22_lo = Do_22_lo1 + Do_22c_lo;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03c_right = Do_03c - Do_03a, Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D->m00, t->x, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D->m01, t->y, Do_03b, Do_03c_right),
      Do_03c_lo = Do_03c_left_rest + Do_03c_right_rest, Do_03d = D->m02 * t->z,
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D->m02, t->z, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo = Do_03e_lo1 + Do_03c_lo,
      Do_03 = Do_03e + D->m03, Do_03_right = Do_03 - Do_03e, Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = Do_03e - Do_03_left, Do_03_right_rest = D->m03 - Do_03_right,
      Do_03_lo1 = Do_03_left_rest + Do_03_right_rest, Do_03_lo = Do_03_lo1 + Do_03e_lo;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13c_right = Do_13c - Do_13a, Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D->m10, t->x, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D->m11, t->y, Do_13b, Do_13c_right),
      Do_13c_lo = Do_13c_left_rest + Do_13c_right_rest, Do_13d = D->m12 * t->z,
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D->m12, t->z, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo = Do_13e_lo1 + Do_13c_lo,
      Do_13 = Do_13e + D->m13, Do_13_right = Do_13 - Do_13e, Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = Do_13e - Do_13_left, Do_13_right_rest = D->m13 - Do_13_right,
      Do_13_lo1 = Do_13_left_rest + Do_13_right_rest, Do_13_lo = Do_13_lo1 + Do_13e_lo;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23c_right = Do_23c - Do_23a, Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D->m20, t->x, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D->m21, t->y, Do_23b, Do_23c_right),
      Do_23c_lo = Do_23c_left_rest + Do_23c_right_rest, Do_23d = D->m22 * t->z,
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D->m22, t->z, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo = Do_23e_lo1 + Do_23c_lo,
      Do_23 = Do_23e + D->m23, Do_23_right = Do_23 - Do_23e, Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = Do_23e - Do_23_left, Do_23_right_rest = D->m23 - Do_23_right,
      Do_23_lo1 = Do_23_left_rest + Do_23_right_rest, Do_23_lo = Do_23_lo1 + Do_23e_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03c_right = Do_03c - Do_03a, Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D->m00, t->x, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D->m01, t->y, Do_03b, Do_03c_right),
      Do_03c_lo = Do_03c_left_rest + Do_03c_right_rest, Do_03d = D->m02 * t->z,
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D->m02, t->z, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo = Do_03e_lo1 + Do_03c_lo,
      Do_03 = D->m03 - Do_03e, Do_03_right = D->m03 - Do_03, Do_03_left = Do_03 + Do_03_right,
      Do_03_left_rest = D->m03 - Do_03_left, Do_03_right_rest = Do_03e - Do_03_right,
      Do_03_lo1 = Do_03_left_rest - Do_03_right_rest, Do_03_lo = Do_03_lo1 - Do_03e_lo;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13c_right = Do_13c - Do_13a, Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D->m10, t->x, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D->m11, t->y, Do_13b, Do_13c_right),
      Do_13c_lo = Do_13c_left_rest + Do_13c_right_rest, Do_13d = D->m12 * t->z,
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D->m12, t->z, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo = Do_13e_lo1 + Do_13c_lo,
      Do_13 = D->m13 - Do_13e, Do_13_right = D->m13 - Do_13, Do_13_left = Do_13 + Do_13_right,
      Do_13_left_rest = D->m13 - Do_13_left, Do_13_right_rest = Do_13e - Do_13_right,
      Do_13_lo1 = Do_13_left_rest - Do_13_right_rest, Do_13_lo = Do_13_lo1 - Do_13e_lo;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23c_right = Do_23c - Do_23a, Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D->m20, t->x, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D->m21, t->y, Do_23b, Do_23c_right),
      Do_23c_lo = Do_23c_left_rest + Do_23c_right_rest, Do_23d = D->m22 * t->z,
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D->m22, t->z, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo = Do_23e_lo1 + Do_23c_lo,
      Do_23 = D->m23 - Do_23e, Do_23_right = D->m23 - Do_23, Do_23_left = Do_23 + Do_23_right,
      Do_23_left_rest = D->m23 - Do_23_left, Do_23_right_rest = Do_23e - Do_23_right,
      Do_23_lo1 = Do_23_left_rest - Do_23_right_rest, Do_23_lo = Do_23_lo1 - Do_23e_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   18 mul, 60 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 18) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03, p_0_right = t->x - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = t->x - p_0_left, p_0_right_rest = D->m03 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = t->y - D->m13, p_1_right = t->y - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = t->y - p_1_left, p_1_right_rest = D->m13 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = t->z - D->m23, p_2_right = t->z - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = t->z - p_2_left, p_2_right_rest = D->m23 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double Do_03a = D->m00 * p_0, Do_03a_cross2 = D->m00 * p_0_lo, Do_03b = D->m10 * p_1,
      Do_03b_cross2 = D->m10 * p_1_lo, Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D->m00, p_0, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D->m10, p_1, Do_03b, Do_03c_right),
      Do_03c_cross = Do_03a_cross2 + Do_03b_cross2,
      Do_03c_lo1 = Do_03c_left_rest + Do_03c_right_rest, Do_03c_lo = Do_03c_lo1 + Do_03c_cross,
      Do_03d = D->m20 * p_2, Do_03d_cross2 = D->m20 * p_2_lo, Do_03 = Do_03c + Do_03d,
      Do_03_right = Do_03 - Do_03c, Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = Do_03c - Do_03_left,
      Do_03_right_rest = ksl_product_rest(D->m20, p_2, Do_03d, Do_03_right),
      Do_03_lo1 = Do_03_left_rest + Do_03_right_rest, Do_03_lo2 = Do_03_lo1 + Do_03d_cross2,
      Do_03_lo = Do_03_lo2 + Do_03c_lo;
  const double Do_13a = D->m01 * p_0, Do_13a_cross2 = D->m01 * p_0_lo, Do_13b = D->m11 * p_1,
      Do_13b_cross2 = D->m11 * p_1_lo, Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D->m01, p_0, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D->m11, p_1, Do_13b, Do_13c_right),
      Do_13c_cross = Do_13a_cross2 + Do_13b_cross2,
      Do_13c_lo1 = Do_13c_left_rest + Do_13c_right_rest, Do_13c_lo = Do_13c_lo1 + Do_13c_cross,
      Do_13d = D->m21 * p_2, Do_13d_cross2 = D->m21 * p_2_lo, Do_13 = Do_13c + Do_13d,
      Do_13_right = Do_13 - Do_13c, Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = Do_13c - Do_13_left,
      Do_13_right_rest = ksl_product_rest(D->m21, p_2, Do_13d, Do_13_right),
      Do_13_lo1 = Do_13_left_rest + Do_13_right_rest, Do_13_lo2 = Do_13_lo1 + Do_13d_cross2,
      Do_13_lo = Do_13_lo2 + Do_13c_lo;
  const double Do_23a = D->m02 * p_0, Do_23a_cross2 = D->m02 * p_0_lo, Do_23b = D->m12 * p_1,
      Do_23b_cross2 = D->m12 * p_1_lo, Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D->m02, p_0, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D->m12, p_1, Do_23b, Do_23c_right),
      Do_23c_cross = Do_23a_cross2 + Do_23b_cross2,
      Do_23c_lo1 = Do_23c_left_rest + Do_23c_right_rest, Do_23c_lo = Do_23c_lo1 + Do_23c_cross,
      Do_23d = D->m22 * p_2, Do_23d_cross2 = D->m22 * p_2_lo, Do_23 = Do_23c + Do_23d,
      Do_23_right = Do_23 - Do_23c, Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = Do_23c - Do_23_left,
      Do_23_right_rest = ksl_product_rest(D->m22, p_2, Do_23d, Do_23_right),
      Do_23_lo1 = Do_23_left_rest + Do_23_right_rest, Do_23_lo2 = Do_23_lo1 + Do_23d_cross2,
      Do_23_lo = Do_23_lo2 + Do_23c_lo;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtx_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = R->m00 * k;
  const double vo_1 = R->m10 * k;
  const double vo_2 = R->m20 * k;
  const double vo_0_lo = ksl_product_error(R->m00, k, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(R->m10, k, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(R->m20, k, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a + Ro_01b,
      Ro_01_right = Ro_01 - Ro_01a, Ro_01_left = Ro_01 - Ro_01_right,
      Ro_01_left_rest = ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01_left),
      Ro_01_right_rest = ksl_product_rest(R->m02, dc[0], Ro_01b, Ro_01_right),
      Ro_01_lo = Ro_01_left_rest + Ro_01_right_rest;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m01 * dc[0], Ro_02 = Ro_02a - Ro_02b,
      Ro_02_right = Ro_02a - Ro_02, Ro_02_left = Ro_02 + Ro_02_right,
      Ro_02_left_rest = ksl_product_rest(R->m02, dc[1], Ro_02a, Ro_02_left),
      Ro_02_right_rest = ksl_product_rest(R->m01, dc[0], Ro_02b, Ro_02_right),
      Ro_02_lo = Ro_02_left_rest - Ro_02_right_rest;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a + Ro_11b,
      Ro_11_right = Ro_11 - Ro_11a, Ro_11_left = Ro_11 - Ro_11_right,
      Ro_11_left_rest = ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11_left),
      Ro_11_right_rest = ksl_product_rest(R->m12, dc[0], Ro_11b, Ro_11_right),
      Ro_11_lo = Ro_11_left_rest + Ro_11_right_rest;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m11 * dc[0], Ro_12 = Ro_12a - Ro_12b,
      Ro_12_right = Ro_12a - Ro_12, Ro_12_left = Ro_12 + Ro_12_right,
      Ro_12_left_rest = ksl_product_rest(R->m12, dc[1], Ro_12a, Ro_12_left),
      Ro_12_right_rest = ksl_product_rest(R->m11, dc[0], Ro_12b, Ro_12_right),
      Ro_12_lo = Ro_12_left_rest - Ro_12_right_rest;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a + Ro_21b,
      Ro_21_right = Ro_21 - Ro_21a, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21_left),
      Ro_21_right_rest = ksl_product_rest(R->m22, dc[0], Ro_21b, Ro_21_right),
      Ro_21_lo = Ro_21_left_rest + Ro_21_right_rest;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m21 * dc[0], Ro_22 = Ro_22a - Ro_22b,
      Ro_22_right = Ro_22a - Ro_22, Ro_22_left = Ro_22 + Ro_22_right,
      Ro_22_left_rest = ksl_product_rest(R->m22, dc[1], Ro_22a, Ro_22_left),
      Ro_22_right_rest = ksl_product_rest(R->m21, dc[0], Ro_22b, Ro_22_right),
      Ro_22_lo = Ro_22_left_rest - Ro_22_right_rest;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a + Do_01b,
      Do_01_right = Do_01 - Do_01a, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = ksl_product_rest(D->m01, dc[1], Do_01a, Do_01_left),
      Do_01_right_rest = ksl_product_rest(D->m02, dc[0], Do_01b, Do_01_right),
      Do_01_lo = Do_01_left_rest + Do_01_right_rest;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m01 * dc[0], Do_02 = Do_02a - Do_02b,
      Do_02_right = Do_02a - Do_02, Do_02_left = Do_02 + Do_02_right,
      Do_02_left_rest = ksl_product_rest(D->m02, dc[1], Do_02a, Do_02_left),
      Do_02_right_rest = ksl_product_rest(D->m01, dc[0], Do_02b, Do_02_right),
      Do_02_lo = Do_02_left_rest - Do_02_right_rest;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a + Do_11b,
      Do_11_right = Do_11 - Do_11a, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = ksl_product_rest(D->m11, dc[1], Do_11a, Do_11_left),
      Do_11_right_rest = ksl_product_rest(D->m12, dc[0], Do_11b, Do_11_right),
      Do_11_lo = Do_11_left_rest + Do_11_right_rest;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m11 * dc[0], Do_12 = Do_12a - Do_12b,
      Do_12_right = Do_12a - Do_12, Do_12_left = Do_12 + Do_12_right,
      Do_12_left_rest = ksl_product_rest(D->m12, dc[1], Do_12a, Do_12_left),
      Do_12_right_rest = ksl_product_rest(D->m11, dc[0], Do_12b, Do_12_right),
      Do_12_lo = Do_12_left_rest - Do_12_right_rest;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a + Do_21b,
      Do_21_right = Do_21 - Do_21a, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = ksl_product_rest(D->m21, dc[1], Do_21a, Do_21_left),
      Do_21_right_rest = ksl_product_rest(D->m22, dc[0], Do_21b, Do_21_right),
      Do_21_lo = Do_21_left_rest + Do_21_right_rest;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m21 * dc[0], Do_22 = Do_22a - Do_22b,
      Do_22_right = Do_22a - Do_22, Do_22_left = Do_22 + Do_22_right,
      Do_22_left_rest = ksl_product_rest(D->m22, dc[1], Do_22a, Do_22_left),
      Do_22_right_rest = ksl_product_rest(D->m21, dc[0], Do_22b, Do_22_right),
      Do_22_lo = Do_22_left_rest - Do_22_right_rest;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a,
      Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = ksl_product_rest(D->m00, k, Do_03a, Do_03_left),
      Do_03_right_rest = D->m03 - Do_03_right, Do_03_lo = Do_03_left_rest + Do_03_right_rest;
  const double Do_13a = D->m10 * k, Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a,
      Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = ksl_product_rest(D->m10, k, Do_13a, Do_13_left),
      Do_13_right_rest = D->m13 - Do_13_right, Do_13_lo = Do_13_left_rest + Do_13_right_rest;
  const double Do_23a = D->m20 * k, Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a,
      Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = ksl_product_rest(D->m20, k, Do_23a, Do_23_left),
      Do_23_right_rest = D->m23 - Do_23_right, Do_23_lo = Do_23_left_rest + Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * k, vo_0a_lo = ksl_product_error(R->m00, k, vo_0a), vo_0 = -vo_0a,
      vo_0_lo = -vo_0a_lo;
  const double vo_1a = R->m10 * k, vo_1a_lo = ksl_product_error(R->m10, k, vo_1a), vo_1 = -vo_1a,
      vo_1_lo = -vo_1a_lo;
  const double vo_2a = R->m20 * k, vo_2a_lo = ksl_product_error(R->m20, k, vo_2a), vo_2 = -vo_2a,
      vo_2_lo = -vo_2a_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a - Ro_01b,
      Ro_01_right = Ro_01a - Ro_01, Ro_01_left = Ro_01 + Ro_01_right,
      Ro_01_left_rest = ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01_left),
      Ro_01_right_rest = ksl_product_rest(R->m02, dc[0], Ro_01b, Ro_01_right),
      Ro_01_lo = Ro_01_left_rest - Ro_01_right_rest;
  const double Ro_02a = R->m01 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b,
      Ro_02_right = Ro_02 - Ro_02a, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = ksl_product_rest(R->m01, dc[0], Ro_02a, Ro_02_left),
      Ro_02_right_rest = ksl_product_rest(R->m02, dc[1], Ro_02b, Ro_02_right),
      Ro_02_lo = Ro_02_left_rest + Ro_02_right_rest;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a - Ro_11b,
      Ro_11_right = Ro_11a - Ro_11, Ro_11_left = Ro_11 + Ro_11_right,
      Ro_11_left_rest = ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11_left),
      Ro_11_right_rest = ksl_product_rest(R->m12, dc[0], Ro_11b, Ro_11_right),
      Ro_11_lo = Ro_11_left_rest - Ro_11_right_rest;
  const double Ro_12a = R->m11 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b,
      Ro_12_right = Ro_12 - Ro_12a, Ro_12_left = Ro_12 - Ro_12_right,
      Ro_12_left_rest = ksl_product_rest(R->m11, dc[0], Ro_12a, Ro_12_left),
      Ro_12_right_rest = ksl_product_rest(R->m12, dc[1], Ro_12b, Ro_12_right),
      Ro_12_lo = Ro_12_left_rest + Ro_12_right_rest;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a - Ro_21b,
      Ro_21_right = Ro_21a - Ro_21, Ro_21_left = Ro_21 + Ro_21_right,
      Ro_21_left_rest = ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21_left),
      Ro_21_right_rest = ksl_product_rest(R->m22, dc[0], Ro_21b, Ro_21_right),
      Ro_21_lo = Ro_21_left_rest - Ro_21_right_rest;
  const double Ro_22a = R->m21 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b,
      Ro_22_right = Ro_22 - Ro_22a, Ro_22_left = Ro_22 - Ro_22_right,
      Ro_22_left_rest = ksl_product_rest(R->m21, dc[0], Ro_22a, Ro_22_left),
      Ro_22_right_rest = ksl_product_rest(R->m22, dc[1], Ro_22b, Ro_22_right),
      Ro_22_lo = Ro_22_left_rest + Ro_22_right_rest;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a - Do_01b,
      Do_01_right = Do_01a - Do_01, Do_01_left = Do_01 + Do_01_right,
      Do_01_left_rest = ksl_product_rest(D->m01, dc[1], Do_01a, Do_01_left),
      Do_01_right_rest = ksl_product_rest(D->m02, dc[0], Do_01b, Do_01_right),
      Do_01_lo = Do_01_left_rest - Do_01_right_rest;
  const double Do_02a = D->m01 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b,
      Do_02_right = Do_02 - Do_02a, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = ksl_product_rest(D->m01, dc[0], Do_02a, Do_02_left),
      Do_02_right_rest = ksl_product_rest(D->m02, dc[1], Do_02b, Do_02_right),
      Do_02_lo = Do_02_left_rest + Do_02_right_rest;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a - Do_11b,
      Do_11_right = Do_11a - Do_11, Do_11_left = Do_11 + Do_11_right,
      Do_11_left_rest = ksl_product_rest(D->m11, dc[1], Do_11a, Do_11_left),
      Do_11_right_rest = ksl_product_rest(D->m12, dc[0], Do_11b, Do_11_right),
      Do_11_lo = Do_11_left_rest - Do_11_right_rest;
  const double Do_12a = D->m11 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b,
      Do_12_right = Do_12 - Do_12a, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = ksl_product_rest(D->m11, dc[0], Do_12a, Do_12_left),
      Do_12_right_rest = ksl_product_rest(D->m12, dc[1], Do_12b, Do_12_right),
      Do_12_lo = Do_12_left_rest + Do_12_right_rest;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a - Do_21b,
      Do_21_right = Do_21a - Do_21, Do_21_left = Do_21 + Do_21_right,
      Do_21_left_rest = ksl_product_rest(D->m21, dc[1], Do_21a, Do_21_left),
      Do_21_right_rest = ksl_product_rest(D->m22, dc[0], Do_21b, Do_21_right),
      Do_21_lo = Do_21_left_rest - Do_21_right_rest;
  const double Do_22a = D->m21 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b,
      Do_22_right = Do_22 - Do_22a, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = ksl_product_rest(D->m21, dc[0], Do_22a, Do_22_left),
      Do_22_right_rest = ksl_product_rest(D->m22, dc[1], Do_22b, Do_22_right),
      Do_22_lo = Do_22_left_rest + Do_22_right_rest;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03,
      Do_03_left = Do_03 + Do_03_right, Do_03_left_rest = D->m03 - Do_03_left,
      Do_03_right_rest = ksl_product_rest(D->m00, k, Do_03a, Do_03_right),
      Do_03_lo = Do_03_left_rest - Do_03_right_rest;
  const double Do_13a = D->m10 * k, Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13,
      Do_13_left = Do_13 + Do_13_right, Do_13_left_rest = D->m13 - Do_13_left,
      Do_13_right_rest = ksl_product_rest(D->m10, k, Do_13a, Do_13_right),
      Do_13_lo = Do_13_left_rest - Do_13_right_rest;
  const double Do_23a = D->m20 * k, Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23,
      Do_23_left = Do_23 + Do_23_right, Do_23_left_rest = D->m23 - Do_23_left,
      Do_23_right_rest = ksl_product_rest(D->m20, k, Do_23a, Do_23_right),
      Do_23_lo = Do_23_left_rest - Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvty_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = R->m01 * k;
  const double vo_1 = R->m11 * k;
  const double vo_2 = R->m21 * k;
  const double vo_0_lo = ksl_product_error(R->m01, k, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(R->m11, k, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(R->m21, k, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a - Ro_00b,
      Ro_00_right = Ro_00a - Ro_00, Ro_00_left = Ro_00 + Ro_00_right,
      Ro_00_left_rest = ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00_left),
      Ro_00_right_rest = ksl_product_rest(R->m02, dc[0], Ro_00b, Ro_00_right),
      Ro_00_lo = Ro_00_left_rest - Ro_00_right_rest;
  const double Ro_02a = R->m00 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b,
      Ro_02_right = Ro_02 - Ro_02a, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = ksl_product_rest(R->m00, dc[0], Ro_02a, Ro_02_left),
      Ro_02_right_rest = ksl_product_rest(R->m02, dc[1], Ro_02b, Ro_02_right),
      Ro_02_lo = Ro_02_left_rest + Ro_02_right_rest;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a - Ro_10b,
      Ro_10_right = Ro_10a - Ro_10, Ro_10_left = Ro_10 + Ro_10_right,
      Ro_10_left_rest = ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10_left),
      Ro_10_right_rest = ksl_product_rest(R->m12, dc[0], Ro_10b, Ro_10_right),
      Ro_10_lo = Ro_10_left_rest - Ro_10_right_rest;
  const double Ro_12a = R->m10 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b,
      Ro_12_right = Ro_12 - Ro_12a, Ro_12_left = Ro_12 - Ro_12_right,
      Ro_12_left_rest = ksl_product_rest(R->m10, dc[0], Ro_12a, Ro_12_left),
      Ro_12_right_rest = ksl_product_rest(R->m12, dc[1], Ro_12b, Ro_12_right),
      Ro_12_lo = Ro_12_left_rest + Ro_12_right_rest;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a - Ro_20b,
      Ro_20_right = Ro_20a - Ro_20, Ro_20_left = Ro_20 + Ro_20_right,
      Ro_20_left_rest = ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20_left),
      Ro_20_right_rest = ksl_product_rest(R->m22, dc[0], Ro_20b, Ro_20_right),
      Ro_20_lo = Ro_20_left_rest - Ro_20_right_rest;
  const double Ro_22a = R->m20 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b,
      Ro_22_right = Ro_22 - Ro_22a, Ro_22_left = Ro_22 - Ro_22_right,
      Ro_22_left_rest = ksl_product_rest(R->m20, dc[0], Ro_22a, Ro_22_left),
      Ro_22_right_rest = ksl_product_rest(R->m22, dc[1], Ro_22b, Ro_22_right),
      Ro_22_lo = Ro_22_left_rest + Ro_22_right_rest;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a - Do_00b,
      Do_00_right = Do_00a - Do_00, Do_00_left = Do_00 + Do_00_right,
      Do_00_left_rest = ksl_product_rest(D->m00, dc[1], Do_00a, Do_00_left),
      Do_00_right_rest = ksl_product_rest(D->m02, dc[0], Do_00b, Do_00_right),
      Do_00_lo = Do_00_left_rest - Do_00_right_rest;
  const double Do_02a = D->m00 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b,
      Do_02_right = Do_02 - Do_02a, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = ksl_product_rest(D->m00, dc[0], Do_02a, Do_02_left),
      Do_02_right_rest = ksl_product_rest(D->m02, dc[1], Do_02b, Do_02_right),
      Do_02_lo = Do_02_left_rest + Do_02_right_rest;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a - Do_10b,
      Do_10_right = Do_10a - Do_10, Do_10_left = Do_10 + Do_10_right,
      Do_10_left_rest = ksl_product_rest(D->m10, dc[1], Do_10a, Do_10_left),
      Do_10_right_rest = ksl_product_rest(D->m12, dc[0], Do_10b, Do_10_right),
      Do_10_lo = Do_10_left_rest - Do_10_right_rest;
  const double Do_12a = D->m10 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b,
      Do_12_right = Do_12 - Do_12a, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = ksl_product_rest(D->m10, dc[0], Do_12a, Do_12_left),
      Do_12_right_rest = ksl_product_rest(D->m12, dc[1], Do_12b, Do_12_right),
      Do_12_lo = Do_12_left_rest + Do_12_right_rest;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a - Do_20b,
      Do_20_right = Do_20a - Do_20, Do_20_left = Do_20 + Do_20_right,
      Do_20_left_rest = ksl_product_rest(D->m20, dc[1], Do_20a, Do_20_left),
      Do_20_right_rest = ksl_product_rest(D->m22, dc[0], Do_20b, Do_20_right),
      Do_20_lo = Do_20_left_rest - Do_20_right_rest;
  const double Do_22a = D->m20 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b,
      Do_22_right = Do_22 - Do_22a, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = ksl_product_rest(D->m20, dc[0], Do_22a, Do_22_left),
      Do_22_right_rest = ksl_product_rest(D->m22, dc[1], Do_22b, Do_22_right),
      Do_22_lo = Do_22_left_rest + Do_22_right_rest;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = D_m01;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = D_m11;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = D_m21;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a,
      Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = ksl_product_rest(D->m01, k, Do_03a, Do_03_left),
      Do_03_right_rest = D->m03 - Do_03_right, Do_03_lo = Do_03_left_rest + Do_03_right_rest;
  const double Do_13a = D->m11 * k, Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a,
      Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = ksl_product_rest(D->m11, k, Do_13a, Do_13_left),
      Do_13_right_rest = D->m13 - Do_13_right, Do_13_lo = Do_13_left_rest + Do_13_right_rest;
  const double Do_23a = D->m21 * k, Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a,
      Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = ksl_product_rest(D->m21, k, Do_23a, Do_23_left),
      Do_23_right_rest = D->m23 - Do_23_right, Do_23_lo = Do_23_left_rest + Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m01 * k, vo_0a_lo = ksl_product_error(R->m01, k, vo_0a), vo_0 = -vo_0a,
      vo_0_lo = -vo_0a_lo;
  const double vo_1a = R->m11 * k, vo_1a_lo = ksl_product_error(R->m11, k, vo_1a), vo_1 = -vo_1a,
      vo_1_lo = -vo_1a_lo;
  const double vo_2a = R->m21 * k, vo_2a_lo = ksl_product_error(R->m21, k, vo_2a), vo_2 = -vo_2a,
      vo_2_lo = -vo_2a_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a + Ro_00b,
      Ro_00_right = Ro_00 - Ro_00a, Ro_00_left = Ro_00 - Ro_00_right,
      Ro_00_left_rest = ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00_left),
      Ro_00_right_rest = ksl_product_rest(R->m02, dc[0], Ro_00b, Ro_00_right),
      Ro_00_lo = Ro_00_left_rest + Ro_00_right_rest;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m00 * dc[0], Ro_02 = Ro_02a - Ro_02b,
      Ro_02_right = Ro_02a - Ro_02, Ro_02_left = Ro_02 + Ro_02_right,
      Ro_02_left_rest = ksl_product_rest(R->m02, dc[1], Ro_02a, Ro_02_left),
      Ro_02_right_rest = ksl_product_rest(R->m00, dc[0], Ro_02b, Ro_02_right),
      Ro_02_lo = Ro_02_left_rest - Ro_02_right_rest;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a + Ro_10b,
      Ro_10_right = Ro_10 - Ro_10a, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10_left),
      Ro_10_right_rest = ksl_product_rest(R->m12, dc[0], Ro_10b, Ro_10_right),
      Ro_10_lo = Ro_10_left_rest + Ro_10_right_rest;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m10 * dc[0], Ro_12 = Ro_12a - Ro_12b,
      Ro_12_right = Ro_12a - Ro_12, Ro_12_left = Ro_12 + Ro_12_right,
      Ro_12_left_rest = ksl_product_rest(R->m12, dc[1], Ro_12a, Ro_12_left),
      Ro_12_right_rest = ksl_product_rest(R->m10, dc[0], Ro_12b, Ro_12_right),
      Ro_12_lo = Ro_12_left_rest - Ro_12_right_rest;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a + Ro_20b,
      Ro_20_right = Ro_20 - Ro_20a, Ro_20_left = Ro_20 - Ro_20_right,
      Ro_20_left_rest = ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20_left),
      Ro_20_right_rest = ksl_product_rest(R->m22, dc[0], Ro_20b, Ro_20_right),
      Ro_20_lo = Ro_20_left_rest + Ro_20_right_rest;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m20 * dc[0], Ro_22 = Ro_22a - Ro_22b,
      Ro_22_right = Ro_22a - Ro_22, Ro_22_left = Ro_22 + Ro_22_right,
      Ro_22_left_rest = ksl_product_rest(R->m22, dc[1], Ro_22a, Ro_22_left),
      Ro_22_right_rest = ksl_product_rest(R->m20, dc[0], Ro_22b, Ro_22_right),
      Ro_22_lo = Ro_22_left_rest - Ro_22_right_rest;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a + Do_00b,
      Do_00_right = Do_00 - Do_00a, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = ksl_product_rest(D->m00, dc[1], Do_00a, Do_00_left),
      Do_00_right_rest = ksl_product_rest(D->m02, dc[0], Do_00b, Do_00_right),
      Do_00_lo = Do_00_left_rest + Do_00_right_rest;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m00 * dc[0], Do_02 = Do_02a - Do_02b,
      Do_02_right = Do_02a - Do_02, Do_02_left = Do_02 + Do_02_right,
      Do_02_left_rest = ksl_product_rest(D->m02, dc[1], Do_02a, Do_02_left),
      Do_02_right_rest = ksl_product_rest(D->m00, dc[0], Do_02b, Do_02_right),
      Do_02_lo = Do_02_left_rest - Do_02_right_rest;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a + Do_10b,
      Do_10_right = Do_10 - Do_10a, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = ksl_product_rest(D->m10, dc[1], Do_10a, Do_10_left),
      Do_10_right_rest = ksl_product_rest(D->m12, dc[0], Do_10b, Do_10_right),
      Do_10_lo = Do_10_left_rest + Do_10_right_rest;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m10 * dc[0], Do_12 = Do_12a - Do_12b,
      Do_12_right = Do_12a - Do_12, Do_12_left = Do_12 + Do_12_right,
      Do_12_left_rest = ksl_product_rest(D->m12, dc[1], Do_12a, Do_12_left),
      Do_12_right_rest = ksl_product_rest(D->m10, dc[0], Do_12b, Do_12_right),
      Do_12_lo = Do_12_left_rest - Do_12_right_rest;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a + Do_20b,
      Do_20_right = Do_20 - Do_20a, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = ksl_product_rest(D->m20, dc[1], Do_20a, Do_20_left),
      Do_20_right_rest = ksl_product_rest(D->m22, dc[0], Do_20b, Do_20_right),
      Do_20_lo = Do_20_left_rest + Do_20_right_rest;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m20 * dc[0], Do_22 = Do_22a - Do_22b,
      Do_22_right = Do_22a - Do_22, Do_22_left = Do_22 + Do_22_right,
      Do_22_left_rest = ksl_product_rest(D->m22, dc[1], Do_22a, Do_22_left),
      Do_22_right_rest = ksl_product_rest(D->m20, dc[0], Do_22b, Do_22_right),
      Do_22_lo = Do_22_left_rest - Do_22_right_rest;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_02_rounded = Do_02 + Do_02_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_12_rounded = Do_12 + Do_12_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_22_rounded = Do_22 + Do_22_lo;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = D_m01;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = D_m11;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = D_m21;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03,
      Do_03_left = Do_03 + Do_03_right, Do_03_left_rest = D->m03 - Do_03_left,
      Do_03_right_rest = ksl_product_rest(D->m01, k, Do_03a, Do_03_right),
      Do_03_lo = Do_03_left_rest - Do_03_right_rest;
  const double Do_13a = D->m11 * k, Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13,
      Do_13_left = Do_13 + Do_13_right, Do_13_left_rest = D->m13 - Do_13_left,
      Do_13_right_rest = ksl_product_rest(D->m11, k, Do_13a, Do_13_right),
      Do_13_lo = Do_13_left_rest - Do_13_right_rest;
  const double Do_23a = D->m21 * k, Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23,
      Do_23_left = Do_23 + Do_23_right, Do_23_left_rest = D->m23 - Do_23_left,
      Do_23_right_rest = ksl_product_rest(D->m21, k, Do_23a, Do_23_right),
      Do_23_lo = Do_23_left_rest - Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtz_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = R->m02 * k;
  const double vo_1 = R->m12 * k;
  const double vo_2 = R->m22 * k;
  const double vo_0_lo = ksl_product_error(R->m02, k, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(R->m12, k, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(R->m22, k, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a + Ro_00b,
      Ro_00_right = Ro_00 - Ro_00a, Ro_00_left = Ro_00 - Ro_00_right,
      Ro_00_left_rest = ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00_left),
      Ro_00_right_rest = ksl_product_rest(R->m01, dc[0], Ro_00b, Ro_00_right),
      Ro_00_lo = Ro_00_left_rest + Ro_00_right_rest;
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m00 * dc[0], Ro_01 = Ro_01a - Ro_01b,
      Ro_01_right = Ro_01a - Ro_01, Ro_01_left = Ro_01 + Ro_01_right,
      Ro_01_left_rest = ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01_left),
      Ro_01_right_rest = ksl_product_rest(R->m00, dc[0], Ro_01b, Ro_01_right),
      Ro_01_lo = Ro_01_left_rest - Ro_01_right_rest;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a + Ro_10b,
      Ro_10_right = Ro_10 - Ro_10a, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10_left),
      Ro_10_right_rest = ksl_product_rest(R->m11, dc[0], Ro_10b, Ro_10_right),
      Ro_10_lo = Ro_10_left_rest + Ro_10_right_rest;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m10 * dc[0], Ro_11 = Ro_11a - Ro_11b,
      Ro_11_right = Ro_11a - Ro_11, Ro_11_left = Ro_11 + Ro_11_right,
      Ro_11_left_rest = ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11_left),
      Ro_11_right_rest = ksl_product_rest(R->m10, dc[0], Ro_11b, Ro_11_right),
      Ro_11_lo = Ro_11_left_rest - Ro_11_right_rest;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a + Ro_20b,
      Ro_20_right = Ro_20 - Ro_20a, Ro_20_left = Ro_20 - Ro_20_right,
      Ro_20_left_rest = ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20_left),
      Ro_20_right_rest = ksl_product_rest(R->m21, dc[0], Ro_20b, Ro_20_right),
      Ro_20_lo = Ro_20_left_rest + Ro_20_right_rest;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m20 * dc[0], Ro_21 = Ro_21a - Ro_21b,
      Ro_21_right = Ro_21a - Ro_21, Ro_21_left = Ro_21 + Ro_21_right,
      Ro_21_left_rest = ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21_left),
      Ro_21_right_rest = ksl_product_rest(R->m20, dc[0], Ro_21b, Ro_21_right),
      Ro_21_lo = Ro_21_left_rest - Ro_21_right_rest;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a + Do_00b,
      Do_00_right = Do_00 - Do_00a, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = ksl_product_rest(D->m00, dc[1], Do_00a, Do_00_left),
      Do_00_right_rest = ksl_product_rest(D->m01, dc[0], Do_00b, Do_00_right),
      Do_00_lo = Do_00_left_rest + Do_00_right_rest;
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m00 * dc[0], Do_01 = Do_01a - Do_01b,
      Do_01_right = Do_01a - Do_01, Do_01_left = Do_01 + Do_01_right,
      Do_01_left_rest = ksl_product_rest(D->m01, dc[1], Do_01a, Do_01_left),
      Do_01_right_rest = ksl_product_rest(D->m00, dc[0], Do_01b, Do_01_right),
      Do_01_lo = Do_01_left_rest - Do_01_right_rest;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a + Do_10b,
      Do_10_right = Do_10 - Do_10a, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = ksl_product_rest(D->m10, dc[1], Do_10a, Do_10_left),
      Do_10_right_rest = ksl_product_rest(D->m11, dc[0], Do_10b, Do_10_right),
      Do_10_lo = Do_10_left_rest + Do_10_right_rest;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m10 * dc[0], Do_11 = Do_11a - Do_11b,
      Do_11_right = Do_11a - Do_11, Do_11_left = Do_11 + Do_11_right,
      Do_11_left_rest = ksl_product_rest(D->m11, dc[1], Do_11a, Do_11_left),
      Do_11_right_rest = ksl_product_rest(D->m10, dc[0], Do_11b, Do_11_right),
      Do_11_lo = Do_11_left_rest - Do_11_right_rest;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a + Do_20b,
      Do_20_right = Do_20 - Do_20a, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = ksl_product_rest(D->m20, dc[1], Do_20a, Do_20_left),
      Do_20_right_rest = ksl_product_rest(D->m21, dc[0], Do_20b, Do_20_right),
      Do_20_lo = Do_20_left_rest + Do_20_right_rest;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m20 * dc[0], Do_21 = Do_21a - Do_21b,
      Do_21_right = Do_21a - Do_21, Do_21_left = Do_21 + Do_21_right,
      Do_21_left_rest = ksl_product_rest(D->m21, dc[1], Do_21a, Do_21_left),
      Do_21_right_rest = ksl_product_rest(D->m20, dc[0], Do_21b, Do_21_right),
      Do_21_lo = Do_21_left_rest - Do_21_right_rest;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a,
      Do_03_left = Do_03 - Do_03_right,
      Do_03_left_rest = ksl_product_rest(D->m02, k, Do_03a, Do_03_left),
      Do_03_right_rest = D->m03 - Do_03_right, Do_03_lo = Do_03_left_rest + Do_03_right_rest;
  const double Do_13a = D->m12 * k, Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a,
      Do_13_left = Do_13 - Do_13_right,
      Do_13_left_rest = ksl_product_rest(D->m12, k, Do_13a, Do_13_left),
      Do_13_right_rest = D->m13 - Do_13_right, Do_13_lo = Do_13_left_rest + Do_13_right_rest;
  const double Do_23a = D->m22 * k, Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a,
      Do_23_left = Do_23 - Do_23_right,
      Do_23_left_rest = ksl_product_rest(D->m22, k, Do_23a, Do_23_left),
      Do_23_right_rest = D->m23 - Do_23_right, Do_23_lo = Do_23_left_rest + Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m02 * k, vo_0a_lo = ksl_product_error(R->m02, k, vo_0a), vo_0 = -vo_0a,
      vo_0_lo = -vo_0a_lo;
  const double vo_1a = R->m12 * k, vo_1a_lo = ksl_product_error(R->m12, k, vo_1a), vo_1 = -vo_1a,
      vo_1_lo = -vo_1a_lo;
  const double vo_2a = R->m22 * k, vo_2a_lo = ksl_product_error(R->m22, k, vo_2a), vo_2 = -vo_2a,
      vo_2_lo = -vo_2a_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a - Ro_00b,
      Ro_00_right = Ro_00a - Ro_00, Ro_00_left = Ro_00 + Ro_00_right,
      Ro_00_left_rest = ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00_left),
      Ro_00_right_rest = ksl_product_rest(R->m01, dc[0], Ro_00b, Ro_00_right),
      Ro_00_lo = Ro_00_left_rest - Ro_00_right_rest;
  const double Ro_01a = R->m00 * dc[0], Ro_01b = R->m01 * dc[1], Ro_01 = Ro_01a + Ro_01b,
      Ro_01_right = Ro_01 - Ro_01a, Ro_01_left = Ro_01 - Ro_01_right,
      Ro_01_left_rest = ksl_product_rest(R->m00, dc[0], Ro_01a, Ro_01_left),
      Ro_01_right_rest = ksl_product_rest(R->m01, dc[1], Ro_01b, Ro_01_right),
      Ro_01_lo = Ro_01_left_rest + Ro_01_right_rest;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a - Ro_10b,
      Ro_10_right = Ro_10a - Ro_10, Ro_10_left = Ro_10 + Ro_10_right,
      Ro_10_left_rest = ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10_left),
      Ro_10_right_rest = ksl_product_rest(R->m11, dc[0], Ro_10b, Ro_10_right),
      Ro_10_lo = Ro_10_left_rest - Ro_10_right_rest;
  const double Ro_11a = R->m10 * dc[0], Ro_11b = R->m11 * dc[1], Ro_11 = Ro_11a + Ro_11b,
      Ro_11_right = Ro_11 - Ro_11a, Ro_11_left = Ro_11 - Ro_11_right,
      Ro_11_left_rest = ksl_product_rest(R->m10, dc[0], Ro_11a, Ro_11_left),
      Ro_11_right_rest = ksl_product_rest(R->m11, dc[1], Ro_11b, Ro_11_right),
      Ro_11_lo = Ro_11_left_rest + Ro_11_right_rest;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a - Ro_20b,
      Ro_20_right = Ro_20a - Ro_20, Ro_20_left = Ro_20 + Ro_20_right,
      Ro_20_left_rest = ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20_left),
      Ro_20_right_rest = ksl_product_rest(R->m21, dc[0], Ro_20b, Ro_20_right),
      Ro_20_lo = Ro_20_left_rest - Ro_20_right_rest;
  const double Ro_21a = R->m20 * dc[0], Ro_21b = R->m21 * dc[1], Ro_21 = Ro_21a + Ro_21b,
      Ro_21_right = Ro_21 - Ro_21a, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = ksl_product_rest(R->m20, dc[0], Ro_21a, Ro_21_left),
      Ro_21_right_rest = ksl_product_rest(R->m21, dc[1], Ro_21b, Ro_21_right),
      Ro_21_lo = Ro_21_left_rest + Ro_21_right_rest;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a - Do_00b,
      Do_00_right = Do_00a - Do_00, Do_00_left = Do_00 + Do_00_right,
      Do_00_left_rest = ksl_product_rest(D->m00, dc[1], Do_00a, Do_00_left),
      Do_00_right_rest = ksl_product_rest(D->m01, dc[0], Do_00b, Do_00_right),
      Do_00_lo = Do_00_left_rest - Do_00_right_rest;
  const double Do_01a = D->m00 * dc[0], Do_01b = D->m01 * dc[1], Do_01 = Do_01a + Do_01b,
      Do_01_right = Do_01 - Do_01a, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = ksl_product_rest(D->m00, dc[0], Do_01a, Do_01_left),
      Do_01_right_rest = ksl_product_rest(D->m01, dc[1], Do_01b, Do_01_right),
      Do_01_lo = Do_01_left_rest + Do_01_right_rest;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a - Do_10b,
      Do_10_right = Do_10a - Do_10, Do_10_left = Do_10 + Do_10_right,
      Do_10_left_rest = ksl_product_rest(D->m10, dc[1], Do_10a, Do_10_left),
      Do_10_right_rest = ksl_product_rest(D->m11, dc[0], Do_10b, Do_10_right),
      Do_10_lo = Do_10_left_rest - Do_10_right_rest;
  const double Do_11a = D->m10 * dc[0], Do_11b = D->m11 * dc[1], Do_11 = Do_11a + Do_11b,
      Do_11_right = Do_11 - Do_11a, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = ksl_product_rest(D->m10, dc[0], Do_11a, Do_11_left),
      Do_11_right_rest = ksl_product_rest(D->m11, dc[1], Do_11b, Do_11_right),
      Do_11_lo = Do_11_left_rest + Do_11_right_rest;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a - Do_20b,
      Do_20_right = Do_20a - Do_20, Do_20_left = Do_20 + Do_20_right,
      Do_20_left_rest = ksl_product_rest(D->m20, dc[1], Do_20a, Do_20_left),
      Do_20_right_rest = ksl_product_rest(D->m21, dc[0], Do_20b, Do_20_right),
      Do_20_lo = Do_20_left_rest - Do_20_right_rest;
  const double Do_21a = D->m20 * dc[0], Do_21b = D->m21 * dc[1], Do_21 = Do_21a + Do_21b,
      Do_21_right = Do_21 - Do_21a, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = ksl_product_rest(D->m20, dc[0], Do_21a, Do_21_left),
      Do_21_right_rest = ksl_product_rest(D->m21, dc[1], Do_21b, Do_21_right),
      Do_21_lo = Do_21_left_rest + Do_21_right_rest;
  const double Do_00_rounded = Do_00 + Do_00_lo;
  const double Do_01_rounded = Do_01 + Do_01_lo;
  const double Do_10_rounded = Do_10 + Do_10_lo;
  const double Do_11_rounded = Do_11 + Do_11_lo;
  const double Do_20_rounded = Do_20 + Do_20_lo;
  const double Do_21_rounded = Do_21 + Do_21_lo;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03,
      Do_03_left = Do_03 + Do_03_right, Do_03_left_rest = D->m03 - Do_03_left,
      Do_03_right_rest = ksl_product_rest(D->m02, k, Do_03a, Do_03_right),
      Do_03_lo = Do_03_left_rest - Do_03_right_rest;
  const double Do_13a = D->m12 * k, Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13,
      Do_13_left = Do_13 + Do_13_right, Do_13_left_rest = D->m13 - Do_13_left,
      Do_13_right_rest = ksl_product_rest(D->m12, k, Do_13a, Do_13_right),
      Do_13_lo = Do_13_left_rest - Do_13_right_rest;
  const double Do_23a = D->m22 * k, Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23,
      Do_23_left = Do_23 + Do_23_right, Do_23_left_rest = D->m23 - Do_23_left,
      Do_23_right_rest = ksl_product_rest(D->m22, k, Do_23a, Do_23_right),
      Do_23_lo = Do_23_left_rest - Do_23_right_rest;
  const double Do_03_rounded = Do_03 + Do_03_lo;
  const double Do_13_rounded = Do_13 + Do_13_lo;
  const double Do_23_rounded = Do_23 + Do_23_lo;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m00 * (double)v->x, vo_0b = (double)R->m01 * (double)v->y,
      vo_0c = vo_0a + vo_0b, vo_0d = (double)R->m02 * (double)v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = (double)R->m10 * (double)v->x, vo_1b = (double)R->m11 * (double)v->y,
      vo_1c = vo_1a + vo_1b, vo_1d = (double)R->m12 * (double)v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = (double)R->m20 * (double)v->x, vo_2b = (double)R->m21 * (double)v->y,
      vo_2c = vo_2a + vo_2b, vo_2d = (double)R->m22 * (double)v->z, vo_2 = vo_2c + vo_2d;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvinvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m00 * (double)v->x, vo_0b = (double)R->m01 * (double)v->y,
      vo_0c = vo_0a + vo_0b, vo_0d = (double)R->m02 * (double)v->z, vo_0e = vo_0c + vo_0d,
      vo_0 = -vo_0e;
  const double vo_1a = (double)R->m10 * (double)v->x, vo_1b = (double)R->m11 * (double)v->y,
      vo_1c = vo_1a + vo_1b, vo_1d = (double)R->m12 * (double)v->z, vo_1e = vo_1c + vo_1d,
      vo_1 = -vo_1e;
  const double vo_2a = (double)R->m20 * (double)v->x, vo_2b = (double)R->m21 * (double)v->y,
      vo_2c = vo_2a + vo_2b, vo_2d = (double)R->m22 * (double)v->z, vo_2e = vo_2c + vo_2d,
      vo_2 = -vo_2e;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m00 * (double)v->x, vo_0b = (double)R->m10 * (double)v->y,
      vo_0c = vo_0a + vo_0b, vo_0d = (double)R->m20 * (double)v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = (double)R->m01 * (double)v->x, vo_1b = (double)R->m11 * (double)v->y,
      vo_1c = vo_1a + vo_1b, vo_1d = (double)R->m21 * (double)v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = (double)R->m02 * (double)v->x, vo_2b = (double)R->m12 * (double)v->y,
      vo_2c = vo_2a + vo_2b, vo_2d = (double)R->m22 * (double)v->z, vo_2 = vo_2c + vo_2d;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvinvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m00 * (double)v->x, vo_0b = (double)R->m10 * (double)v->y,
      vo_0c = vo_0a + vo_0b, vo_0d = (double)R->m20 * (double)v->z, vo_0e = vo_0c + vo_0d,
      vo_0 = -vo_0e;
  const double vo_1a = (double)R->m01 * (double)v->x, vo_1b = (double)R->m11 * (double)v->y,
      vo_1c = vo_1a + vo_1b, vo_1d = (double)R->m21 * (double)v->z, vo_1e = vo_1c + vo_1d,
      vo_1 = -vo_1e;
  const double vo_2a = (double)R->m02 * (double)v->x, vo_2b = (double)R->m12 * (double)v->y,
      vo_2c = vo_2a + vo_2b, vo_2d = (double)R->m22 * (double)v->z, vo_2e = vo_2c + vo_2d,
      vo_2 = -vo_2e;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)D->m00 * (double)v->x, vo_0b = (double)D->m01 * (double)v->y,
      vo_0c = vo_0a + vo_0b, vo_0d = (double)D->m02 * (double)v->z, vo_0e = vo_0c + vo_0d,
      vo_0 = vo_0e + (double)D->m03;
  const double vo_1a = (double)D->m10 * (double)v->x, vo_1b = (double)D->m11 * (double)v->y,
      vo_1c = vo_1a + vo_1b, vo_1d = (double)D->m12 * (double)v->z, vo_1e = vo_1c + vo_1d,
      vo_1 = vo_1e + (double)D->m13;
  const double vo_2a = (double)D->m20 * (double)v->x, vo_2b = (double)D->m21 * (double)v->y,
      vo_2c = vo_2a + vo_2b, vo_2d = (double)D->m22 * (double)v->z, vo_2e = vo_2c + vo_2d,
      vo_2 = vo_2e + (double)D->m23;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dinvvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double p_0 = (double)v->x - (double)D->m03;
  const double p_1 = (double)v->y - (double)D->m13;
  const double p_2 = (double)v->z - (double)D->m23;
  const double vo_0a = (double)D->m00 * p_0, vo_0b = (double)D->m10 * p_1, vo_0c = vo_0a + vo_0b,
      vo_0d = (double)D->m20 * p_2, vo_0 = vo_0c + vo_0d;
  const double vo_1a = (double)D->m01 * p_0, vo_1b = (double)D->m11 * p_1, vo_1c = vo_1a + vo_1b,
      vo_1d = (double)D->m21 * p_2, vo_1 = vo_1c + vo_1d;
  const double vo_2a = (double)D->m02 * p_0, vo_2b = (double)D->m12 * p_1, vo_2c = vo_2a + vo_2b,
      vo_2d = (double)D->m22 * p_2, vo_2 = vo_2c + vo_2d;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R1->m00 * (double)R2->m00,
      Ro_00b = (double)R1->m01 * (double)R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = (double)R1->m02 * (double)R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = (double)R1->m00 * (double)R2->m01,
      Ro_01b = (double)R1->m01 * (double)R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = (double)R1->m02 * (double)R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = (double)R1->m00 * (double)R2->m02,
      Ro_02b = (double)R1->m01 * (double)R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = (double)R1->m02 * (double)R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = (double)R1->m10 * (double)R2->m00,
      Ro_10b = (double)R1->m11 * (double)R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = (double)R1->m12 * (double)R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = (double)R1->m10 * (double)R2->m01,
      Ro_11b = (double)R1->m11 * (double)R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = (double)R1->m12 * (double)R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = (double)R1->m10 * (double)R2->m02,
      Ro_12b = (double)R1->m11 * (double)R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = (double)R1->m12 * (double)R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = (double)R1->m20 * (double)R2->m00,
      Ro_20b = (double)R1->m21 * (double)R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = (double)R1->m22 * (double)R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = (double)R1->m20 * (double)R2->m01,
      Ro_21b = (double)R1->m21 * (double)R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = (double)R1->m22 * (double)R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = (double)R1->m20 * (double)R2->m02,
      Ro_22b = (double)R1->m21 * (double)R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = (double)R1->m22 * (double)R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrinvf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R1->m00 * (double)R2->m00,
      Ro_00b = (double)R1->m01 * (double)R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = (double)R1->m02 * (double)R2->m02, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = (double)R1->m00 * (double)R2->m10,
      Ro_01b = (double)R1->m01 * (double)R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = (double)R1->m02 * (double)R2->m12, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = (double)R1->m00 * (double)R2->m20,
      Ro_02b = (double)R1->m01 * (double)R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = (double)R1->m02 * (double)R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = (double)R1->m10 * (double)R2->m00,
      Ro_10b = (double)R1->m11 * (double)R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = (double)R1->m12 * (double)R2->m02, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = (double)R1->m10 * (double)R2->m10,
      Ro_11b = (double)R1->m11 * (double)R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = (double)R1->m12 * (double)R2->m12, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = (double)R1->m10 * (double)R2->m20,
      Ro_12b = (double)R1->m11 * (double)R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = (double)R1->m12 * (double)R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = (double)R1->m20 * (double)R2->m00,
      Ro_20b = (double)R1->m21 * (double)R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = (double)R1->m22 * (double)R2->m02, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = (double)R1->m20 * (double)R2->m10,
      Ro_21b = (double)R1->m21 * (double)R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = (double)R1->m22 * (double)R2->m12, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = (double)R1->m20 * (double)R2->m20,
      Ro_22b = (double)R1->m21 * (double)R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = (double)R1->m22 * (double)R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvdrf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R1->m00 * (double)R2->m00,
      Ro_00b = (double)R1->m10 * (double)R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = (double)R1->m20 * (double)R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = (double)R1->m00 * (double)R2->m01,
      Ro_01b = (double)R1->m10 * (double)R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = (double)R1->m20 * (double)R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = (double)R1->m00 * (double)R2->m02,
      Ro_02b = (double)R1->m10 * (double)R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = (double)R1->m20 * (double)R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = (double)R1->m01 * (double)R2->m00,
      Ro_10b = (double)R1->m11 * (double)R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = (double)R1->m21 * (double)R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = (double)R1->m01 * (double)R2->m01,
      Ro_11b = (double)R1->m11 * (double)R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = (double)R1->m21 * (double)R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = (double)R1->m01 * (double)R2->m02,
      Ro_12b = (double)R1->m11 * (double)R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = (double)R1->m21 * (double)R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = (double)R1->m02 * (double)R2->m00,
      Ro_20b = (double)R1->m12 * (double)R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = (double)R1->m22 * (double)R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = (double)R1->m02 * (double)R2->m01,
      Ro_21b = (double)R1->m12 * (double)R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = (double)R1->m22 * (double)R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = (double)R1->m02 * (double)R2->m02,
      Ro_22b = (double)R1->m12 * (double)R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = (double)R1->m22 * (double)R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_ddf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D1->m00 * (double)D2->m00,
      Do_00b = (double)D1->m01 * (double)D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = (double)D1->m02 * (double)D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = (double)D1->m00 * (double)D2->m01,
      Do_01b = (double)D1->m01 * (double)D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = (double)D1->m02 * (double)D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = (double)D1->m00 * (double)D2->m02,
      Do_02b = (double)D1->m01 * (double)D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = (double)D1->m02 * (double)D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = (double)D1->m00 * (double)D2->m03,
      Do_03b = (double)D1->m01 * (double)D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = (double)D1->m02 * (double)D2->m23, Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + (double)D1->m03;
  const double Do_10a = (double)D1->m10 * (double)D2->m00,
      Do_10b = (double)D1->m11 * (double)D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = (double)D1->m12 * (double)D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = (double)D1->m10 * (double)D2->m01,
      Do_11b = (double)D1->m11 * (double)D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = (double)D1->m12 * (double)D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = (double)D1->m10 * (double)D2->m02,
      Do_12b = (double)D1->m11 * (double)D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = (double)D1->m12 * (double)D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = (double)D1->m10 * (double)D2->m03,
      Do_13b = (double)D1->m11 * (double)D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = (double)D1->m12 * (double)D2->m23, Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + (double)D1->m13;
  const double Do_20a = (double)D1->m20 * (double)D2->m00,
      Do_20b = (double)D1->m21 * (double)D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = (double)D1->m22 * (double)D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = (double)D1->m20 * (double)D2->m01,
      Do_21b = (double)D1->m21 * (double)D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = (double)D1->m22 * (double)D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = (double)D1->m20 * (double)D2->m02,
      Do_22b = (double)D1->m21 * (double)D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = (double)D1->m22 * (double)D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = (double)D1->m20 * (double)D2->m03,
      Do_23b = (double)D1->m21 * (double)D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = (double)D1->m22 * (double)D2->m23, Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + (double)D1->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = (float)Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 7/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_ddinvf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double R_0a = (double)D1->m00 * (double)D2->m00, R_0b = (double)D1->m01 * (double)D2->m01,
      R_0c = R_0a + R_0b, R_0d = (double)D1->m02 * (double)D2->m02, R_0 = R_0c + R_0d;
  const double R_1a = (double)D1->m00 * (double)D2->m10, R_1b = (double)D1->m01 * (double)D2->m11,
      R_1c = R_1a + R_1b, R_1d = (double)D1->m02 * (double)D2->m12, R_1 = R_1c + R_1d;
  const double R_2a = (double)D1->m00 * (double)D2->m20, R_2b = (double)D1->m01 * (double)D2->m21,
      R_2c = R_2a + R_2b, R_2d = (double)D1->m02 * (double)D2->m22, R_2 = R_2c + R_2d;
  const double R_3a = (double)D1->m10 * (double)D2->m00, R_3b = (double)D1->m11 * (double)D2->m01,
      R_3c = R_3a + R_3b, R_3d = (double)D1->m12 * (double)D2->m02, R_3 = R_3c + R_3d;
  const double R_4a = (double)D1->m10 * (double)D2->m10, R_4b = (double)D1->m11 * (double)D2->m11,
      R_4c = R_4a + R_4b, R_4d = (double)D1->m12 * (double)D2->m12, R_4 = R_4c + R_4d;
  const double R_5a = (double)D1->m10 * (double)D2->m20, R_5b = (double)D1->m11 * (double)D2->m21,
      R_5c = R_5a + R_5b, R_5d = (double)D1->m12 * (double)D2->m22, R_5 = R_5c + R_5d;
  const double R_6a = (double)D1->m20 * (double)D2->m00, R_6b = (double)D1->m21 * (double)D2->m01,
      R_6c = R_6a + R_6b, R_6d = (double)D1->m22 * (double)D2->m02, R_6 = R_6c + R_6d;
  const double R_7a = (double)D1->m20 * (double)D2->m10, R_7b = (double)D1->m21 * (double)D2->m11,
      R_7c = R_7a + R_7b, R_7d = (double)D1->m22 * (double)D2->m12, R_7 = R_7c + R_7d;
  const double R_8a = (double)D1->m20 * (double)D2->m20, R_8b = (double)D1->m21 * (double)D2->m21,
      R_8c = R_8a + R_8b, R_8d = (double)D1->m22 * (double)D2->m22, R_8 = R_8c + R_8d;
  const double Do_03a = (double)D2->m03 * R_0, Do_03b = (double)D2->m13 * R_1,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D2->m23 * R_2, Do_03e = Do_03c + Do_03d,
      Do_03 = (double)D1->m03 - Do_03e;
  const double Do_13a = (double)D2->m03 * R_3, Do_13b = (double)D2->m13 * R_4,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D2->m23 * R_5, Do_13e = Do_13c + Do_13d,
      Do_13 = (double)D1->m13 - Do_13e;
  const double Do_23a = (double)D2->m03 * R_6, Do_23b = (double)D2->m13 * R_7,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D2->m23 * R_8, Do_23e = Do_23c + Do_23d,
      Do_23 = (double)D1->m23 - Do_23e;
  Do->m00 = (float)R_0;
  Do->m01 = (float)R_1;
  Do->m02 = (float)R_2;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)R_3;
  Do->m11 = (float)R_4;
  Do->m12 = (float)R_5;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)R_6;
  Do->m21 = (float)R_7;
  Do->m22 = (float)R_8;
  Do->m23 = (float)Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_dinvdf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double p_0 = (double)D2->m03 - (double)D1->m03;
  const double p_1 = (double)D2->m13 - (double)D1->m13;
  const double p_2 = (double)D2->m23 - (double)D1->m23;
  const double Do_00a = (double)D1->m00 * (double)D2->m00,
      Do_00b = (double)D1->m10 * (double)D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = (double)D1->m20 * (double)D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = (double)D1->m00 * (double)D2->m01,
      Do_01b = (double)D1->m10 * (double)D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = (double)D1->m20 * (double)D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = (double)D1->m00 * (double)D2->m02,
      Do_02b = (double)D1->m10 * (double)D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = (double)D1->m20 * (double)D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = (double)D1->m00 * p_0, Do_03b = (double)D1->m10 * p_1,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D1->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_10a = (double)D1->m01 * (double)D2->m00,
      Do_10b = (double)D1->m11 * (double)D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = (double)D1->m21 * (double)D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = (double)D1->m01 * (double)D2->m01,
      Do_11b = (double)D1->m11 * (double)D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = (double)D1->m21 * (double)D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = (double)D1->m01 * (double)D2->m02,
      Do_12b = (double)D1->m11 * (double)D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = (double)D1->m21 * (double)D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = (double)D1->m01 * p_0, Do_13b = (double)D1->m11 * p_1,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D1->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_20a = (double)D1->m02 * (double)D2->m00,
      Do_20b = (double)D1->m12 * (double)D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = (double)D1->m22 * (double)D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = (double)D1->m02 * (double)D2->m01,
      Do_21b = (double)D1->m12 * (double)D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = (double)D1->m22 * (double)D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = (double)D1->m02 * (double)D2->m02,
      Do_22b = (double)D1->m12 * (double)D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = (double)D1->m22 * (double)D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = (double)D1->m02 * p_0, Do_23b = (double)D1->m12 * p_1,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D1->m22 * p_2, Do_23 = Do_23c + Do_23d;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = (float)Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf_accurate(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)R->m00, Do_00b = (double)D->m01 * (double)R->m10,
      Do_00c = Do_00a + Do_00b, Do_00d = (double)D->m02 * (double)R->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = (double)D->m00 * (double)R->m01, Do_01b = (double)D->m01 * (double)R->m11,
      Do_01c = Do_01a + Do_01b, Do_01d = (double)D->m02 * (double)R->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = (double)D->m00 * (double)R->m02, Do_02b = (double)D->m01 * (double)R->m12,
      Do_02c = Do_02a + Do_02b, Do_02d = (double)D->m02 * (double)R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = (double)D->m10 * (double)R->m00, Do_10b = (double)D->m11 * (double)R->m10,
      Do_10c = Do_10a + Do_10b, Do_10d = (double)D->m12 * (double)R->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = (double)D->m10 * (double)R->m01, Do_11b = (double)D->m11 * (double)R->m11,
      Do_11c = Do_11a + Do_11b, Do_11d = (double)D->m12 * (double)R->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = (double)D->m10 * (double)R->m02, Do_12b = (double)D->m11 * (double)R->m12,
      Do_12c = Do_12a + Do_12b, Do_12d = (double)D->m12 * (double)R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = (double)D->m20 * (double)R->m00, Do_20b = (double)D->m21 * (double)R->m10,
      Do_20c = Do_20a + Do_20b, Do_20d = (double)D->m22 * (double)R->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = (double)D->m20 * (double)R->m01, Do_21b = (double)D->m21 * (double)R->m11,
      Do_21c = Do_21a + Do_21b, Do_21d = (double)D->m22 * (double)R->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = (double)D->m20 * (double)R->m02, Do_22b = (double)D->m21 * (double)R->m12,
      Do_22c = Do_22a + Do_22b, Do_22d = (double)D->m22 * (double)R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf_accurate(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)R->m00, Do_00b = (double)D->m01 * (double)R->m01,
      Do_00c = Do_00a + Do_00b, Do_00d = (double)D->m02 * (double)R->m02, Do_00 = Do_00c + Do_00d;
  const double Do_01a = (double)D->m00 * (double)R->m10, Do_01b = (double)D->m01 * (double)R->m11,
      Do_01c = Do_01a + Do_01b, Do_01d = (double)D->m02 * (double)R->m12, Do_01 = Do_01c + Do_01d;
  const double Do_02a = (double)D->m00 * (double)R->m20, Do_02b = (double)D->m01 * (double)R->m21,
      Do_02c = Do_02a + Do_02b, Do_02d = (double)D->m02 * (double)R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = (double)D->m10 * (double)R->m00, Do_10b = (double)D->m11 * (double)R->m01,
      Do_10c = Do_10a + Do_10b, Do_10d = (double)D->m12 * (double)R->m02, Do_10 = Do_10c + Do_10d;
  const double Do_11a = (double)D->m10 * (double)R->m10, Do_11b = (double)D->m11 * (double)R->m11,
      Do_11c = Do_11a + Do_11b, Do_11d = (double)D->m12 * (double)R->m12, Do_11 = Do_11c + Do_11d;
  const double Do_12a = (double)D->m10 * (double)R->m20, Do_12b = (double)D->m11 * (double)R->m21,
      Do_12c = Do_12a + Do_12b, Do_12d = (double)D->m12 * (double)R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = (double)D->m20 * (double)R->m00, Do_20b = (double)D->m21 * (double)R->m01,
      Do_20c = Do_20a + Do_20b, Do_20d = (double)D->m22 * (double)R->m02, Do_20 = Do_20c + Do_20d;
  const double Do_21a = (double)D->m20 * (double)R->m10, Do_21b = (double)D->m21 * (double)R->m11,
      Do_21c = Do_21a + Do_21b, Do_21d = (double)D->m22 * (double)R->m12, Do_21 = Do_21c + Do_21d;
  const double Do_22a = (double)D->m20 * (double)R->m20, Do_22b = (double)D->m21 * (double)R->m21,
      Do_22c = Do_22a + Do_22b, Do_22d = (double)D->m22 * (double)R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m00 * (double)t->x, Do_03b = (double)D->m01 * (double)t->y,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D->m02 * (double)t->z, Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + (double)D->m03;
  const double Do_13a = (double)D->m10 * (double)t->x, Do_13b = (double)D->m11 * (double)t->y,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D->m12 * (double)t->z, Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + (double)D->m13;
  const double Do_23a = (double)D->m20 * (double)t->x, Do_23b = (double)D->m21 * (double)t->y,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D->m22 * (double)t->z, Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + (double)D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m00 * (double)t->x, Do_03b = (double)D->m01 * (double)t->y,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D->m02 * (double)t->z, Do_03e = Do_03c + Do_03d,
      Do_03 = (double)D->m03 - Do_03e;
  const double Do_13a = (double)D->m10 * (double)t->x, Do_13b = (double)D->m11 * (double)t->y,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D->m12 * (double)t->z, Do_13e = Do_13c + Do_13d,
      Do_13 = (double)D->m13 - Do_13e;
  const double Do_23a = (double)D->m20 * (double)t->x, Do_23b = (double)D->m21 * (double)t->y,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D->m22 * (double)t->z, Do_23e = Do_23c + Do_23d,
      Do_23 = (double)D->m23 - Do_23e;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double p_0 = (double)t->x - (double)D->m03;
  const double p_1 = (double)t->y - (double)D->m13;
  const double p_2 = (double)t->z - (double)D->m23;
  const double Do_03a = (double)D->m00 * p_0, Do_03b = (double)D->m10 * p_1,
      Do_03c = Do_03a + Do_03b, Do_03d = (double)D->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_13a = (double)D->m01 * p_0, Do_13b = (double)D->m11 * p_1,
      Do_13c = Do_13a + Do_13b, Do_13d = (double)D->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_23a = (double)D->m02 * p_0, Do_23b = (double)D->m12 * p_1,
      Do_23c = Do_23a + Do_23b, Do_23d = (double)D->m22 * p_2, Do_23 = Do_23c + Do_23d;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtxf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m00 * (double)k;
  const double vo_1 = (double)R->m10 * (double)k;
  const double vo_2 = (double)R->m20 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrxf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_01a = (double)R->m01 * (double)dc[1], Ro_01b = (double)R->m02 * (double)dc[0],
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_02a = (double)R->m02 * (double)dc[1], Ro_02b = (double)R->m01 * (double)dc[0],
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_11a = (double)R->m11 * (double)dc[1], Ro_11b = (double)R->m12 * (double)dc[0],
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_12a = (double)R->m12 * (double)dc[1], Ro_12b = (double)R->m11 * (double)dc[0],
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_21a = (double)R->m21 * (double)dc[1], Ro_21b = (double)R->m22 * (double)dc[0],
      Ro_21 = Ro_21a + Ro_21b;
  const double Ro_22a = (double)R->m22 * (double)dc[1], Ro_22b = (double)R->m21 * (double)dc[0],
      Ro_22 = Ro_22a - Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_01a = (double)D->m01 * (double)dc[1], Do_01b = (double)D->m02 * (double)dc[0],
      Do_01 = Do_01a + Do_01b;
  const double Do_02a = (double)D->m02 * (double)dc[1], Do_02b = (double)D->m01 * (double)dc[0],
      Do_02 = Do_02a - Do_02b;
  const double Do_11a = (double)D->m11 * (double)dc[1], Do_11b = (double)D->m12 * (double)dc[0],
      Do_11 = Do_11a + Do_11b;
  const double Do_12a = (double)D->m12 * (double)dc[1], Do_12b = (double)D->m11 * (double)dc[0],
      Do_12 = Do_12a - Do_12b;
  const double Do_21a = (double)D->m21 * (double)dc[1], Do_21b = (double)D->m22 * (double)dc[0],
      Do_21 = Do_21a + Do_21b;
  const double Do_22a = (double)D->m22 * (double)dc[1], Do_22b = (double)D->m21 * (double)dc[0],
      Do_22 = Do_22a - Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m00 * (double)k, Do_03 = Do_03a + (double)D->m03;
  const double Do_13a = (double)D->m10 * (double)k, Do_13 = Do_13a + (double)D->m13;
  const double Do_23a = (double)D->m20 * (double)k, Do_23 = Do_23a + (double)D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtxinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m00 * (double)k, vo_0 = -vo_0a;
  const double vo_1a = (double)R->m10 * (double)k, vo_1 = -vo_1a;
  const double vo_2a = (double)R->m20 * (double)k, vo_2 = -vo_2a;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrxinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_01a = (double)R->m01 * (double)dc[1], Ro_01b = (double)R->m02 * (double)dc[0],
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_02a = (double)R->m01 * (double)dc[0], Ro_02b = (double)R->m02 * (double)dc[1],
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_11a = (double)R->m11 * (double)dc[1], Ro_11b = (double)R->m12 * (double)dc[0],
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_12a = (double)R->m11 * (double)dc[0], Ro_12b = (double)R->m12 * (double)dc[1],
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_21a = (double)R->m21 * (double)dc[1], Ro_21b = (double)R->m22 * (double)dc[0],
      Ro_21 = Ro_21a - Ro_21b;
  const double Ro_22a = (double)R->m21 * (double)dc[0], Ro_22b = (double)R->m22 * (double)dc[1],
      Ro_22 = Ro_22a + Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_01a = (double)D->m01 * (double)dc[1], Do_01b = (double)D->m02 * (double)dc[0],
      Do_01 = Do_01a - Do_01b;
  const double Do_02a = (double)D->m01 * (double)dc[0], Do_02b = (double)D->m02 * (double)dc[1],
      Do_02 = Do_02a + Do_02b;
  const double Do_11a = (double)D->m11 * (double)dc[1], Do_11b = (double)D->m12 * (double)dc[0],
      Do_11 = Do_11a - Do_11b;
  const double Do_12a = (double)D->m11 * (double)dc[0], Do_12b = (double)D->m12 * (double)dc[1],
      Do_12 = Do_12a + Do_12b;
  const double Do_21a = (double)D->m21 * (double)dc[1], Do_21b = (double)D->m22 * (double)dc[0],
      Do_21 = Do_21a - Do_21b;
  const double Do_22a = (double)D->m21 * (double)dc[0], Do_22b = (double)D->m22 * (double)dc[1],
      Do_22 = Do_22a + Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m00 * (double)k, Do_03 = (double)D->m03 - Do_03a;
  const double Do_13a = (double)D->m10 * (double)k, Do_13 = (double)D->m13 - Do_13a;
  const double Do_23a = (double)D->m20 * (double)k, Do_23 = (double)D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtyf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m01 * (double)k;
  const double vo_1 = (double)R->m11 * (double)k;
  const double vo_2 = (double)R->m21 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdryf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R->m00 * (double)dc[1], Ro_00b = (double)R->m02 * (double)dc[0],
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_02a = (double)R->m00 * (double)dc[0], Ro_02b = (double)R->m02 * (double)dc[1],
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_10a = (double)R->m10 * (double)dc[1], Ro_10b = (double)R->m12 * (double)dc[0],
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_12a = (double)R->m10 * (double)dc[0], Ro_12b = (double)R->m12 * (double)dc[1],
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_20a = (double)R->m20 * (double)dc[1], Ro_20b = (double)R->m22 * (double)dc[0],
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_22a = (double)R->m20 * (double)dc[0], Ro_22b = (double)R->m22 * (double)dc[1],
      Ro_22 = Ro_22a + Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)dc[1], Do_00b = (double)D->m02 * (double)dc[0],
      Do_00 = Do_00a - Do_00b;
  const double Do_02a = (double)D->m00 * (double)dc[0], Do_02b = (double)D->m02 * (double)dc[1],
      Do_02 = Do_02a + Do_02b;
  const double Do_10a = (double)D->m10 * (double)dc[1], Do_10b = (double)D->m12 * (double)dc[0],
      Do_10 = Do_10a - Do_10b;
  const double Do_12a = (double)D->m10 * (double)dc[0], Do_12b = (double)D->m12 * (double)dc[1],
      Do_12 = Do_12a + Do_12b;
  const double Do_20a = (double)D->m20 * (double)dc[1], Do_20b = (double)D->m22 * (double)dc[0],
      Do_20 = Do_20a - Do_20b;
  const double Do_22a = (double)D->m20 * (double)dc[0], Do_22b = (double)D->m22 * (double)dc[1],
      Do_22 = Do_22a + Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = D_m01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = D_m11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = D_m21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m01 * (double)k, Do_03 = Do_03a + (double)D->m03;
  const double Do_13a = (double)D->m11 * (double)k, Do_13 = Do_13a + (double)D->m13;
  const double Do_23a = (double)D->m21 * (double)k, Do_23 = Do_23a + (double)D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtyinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m01 * (double)k, vo_0 = -vo_0a;
  const double vo_1a = (double)R->m11 * (double)k, vo_1 = -vo_1a;
  const double vo_2a = (double)R->m21 * (double)k, vo_2 = -vo_2a;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdryinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R->m00 * (double)dc[1], Ro_00b = (double)R->m02 * (double)dc[0],
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_02a = (double)R->m02 * (double)dc[1], Ro_02b = (double)R->m00 * (double)dc[0],
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_10a = (double)R->m10 * (double)dc[1], Ro_10b = (double)R->m12 * (double)dc[0],
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_12a = (double)R->m12 * (double)dc[1], Ro_12b = (double)R->m10 * (double)dc[0],
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_20a = (double)R->m20 * (double)dc[1], Ro_20b = (double)R->m22 * (double)dc[0],
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_22a = (double)R->m22 * (double)dc[1], Ro_22b = (double)R->m20 * (double)dc[0],
      Ro_22 = Ro_22a - Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)dc[1], Do_00b = (double)D->m02 * (double)dc[0],
      Do_00 = Do_00a + Do_00b;
  const double Do_02a = (double)D->m02 * (double)dc[1], Do_02b = (double)D->m00 * (double)dc[0],
      Do_02 = Do_02a - Do_02b;
  const double Do_10a = (double)D->m10 * (double)dc[1], Do_10b = (double)D->m12 * (double)dc[0],
      Do_10 = Do_10a + Do_10b;
  const double Do_12a = (double)D->m12 * (double)dc[1], Do_12b = (double)D->m10 * (double)dc[0],
      Do_12 = Do_12a - Do_12b;
  const double Do_20a = (double)D->m20 * (double)dc[1], Do_20b = (double)D->m22 * (double)dc[0],
      Do_20 = Do_20a + Do_20b;
  const double Do_22a = (double)D->m22 * (double)dc[1], Do_22b = (double)D->m20 * (double)dc[0],
      Do_22 = Do_22a - Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = D_m01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = D_m11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = D_m21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m01 * (double)k, Do_03 = (double)D->m03 - Do_03a;
  const double Do_13a = (double)D->m11 * (double)k, Do_13 = (double)D->m13 - Do_13a;
  const double Do_23a = (double)D->m21 * (double)k, Do_23 = (double)D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtzf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m02 * (double)k;
  const double vo_1 = (double)R->m12 * (double)k;
  const double vo_2 = (double)R->m22 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrzf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R->m00 * (double)dc[1], Ro_00b = (double)R->m01 * (double)dc[0],
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_01a = (double)R->m01 * (double)dc[1], Ro_01b = (double)R->m00 * (double)dc[0],
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_10a = (double)R->m10 * (double)dc[1], Ro_10b = (double)R->m11 * (double)dc[0],
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_11a = (double)R->m11 * (double)dc[1], Ro_11b = (double)R->m10 * (double)dc[0],
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_20a = (double)R->m20 * (double)dc[1], Ro_20b = (double)R->m21 * (double)dc[0],
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_21a = (double)R->m21 * (double)dc[1], Ro_21b = (double)R->m20 * (double)dc[0],
      Ro_21 = Ro_21a - Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)dc[1], Do_00b = (double)D->m01 * (double)dc[0],
      Do_00 = Do_00a + Do_00b;
  const double Do_01a = (double)D->m01 * (double)dc[1], Do_01b = (double)D->m00 * (double)dc[0],
      Do_01 = Do_01a - Do_01b;
  const double Do_10a = (double)D->m10 * (double)dc[1], Do_10b = (double)D->m11 * (double)dc[0],
      Do_10 = Do_10a + Do_10b;
  const double Do_11a = (double)D->m11 * (double)dc[1], Do_11b = (double)D->m10 * (double)dc[0],
      Do_11 = Do_11a - Do_11b;
  const double Do_20a = (double)D->m20 * (double)dc[1], Do_20b = (double)D->m21 * (double)dc[0],
      Do_20 = Do_20a + Do_20b;
  const double Do_21a = (double)D->m21 * (double)dc[1], Do_21b = (double)D->m20 * (double)dc[0],
      Do_21 = Do_21a - Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m02 * (double)k, Do_03 = Do_03a + (double)D->m03;
  const double Do_13a = (double)D->m12 * (double)k, Do_13 = Do_13a + (double)D->m13;
  const double Do_23a = (double)D->m22 * (double)k, Do_23 = Do_23a + (double)D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtzinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)R->m02 * (double)k, vo_0 = -vo_0a;
  const double vo_1a = (double)R->m12 * (double)k, vo_1 = -vo_1a;
  const double vo_2a = (double)R->m22 * (double)k, vo_2 = -vo_2a;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrzinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00a = (double)R->m00 * (double)dc[1], Ro_00b = (double)R->m01 * (double)dc[0],
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_01a = (double)R->m00 * (double)dc[0], Ro_01b = (double)R->m01 * (double)dc[1],
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_10a = (double)R->m10 * (double)dc[1], Ro_10b = (double)R->m11 * (double)dc[0],
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_11a = (double)R->m10 * (double)dc[0], Ro_11b = (double)R->m11 * (double)dc[1],
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_20a = (double)R->m20 * (double)dc[1], Ro_20b = (double)R->m21 * (double)dc[0],
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_21a = (double)R->m20 * (double)dc[0], Ro_21b = (double)R->m21 * (double)dc[1],
      Ro_21 = Ro_21a + Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00a = (double)D->m00 * (double)dc[1], Do_00b = (double)D->m01 * (double)dc[0],
      Do_00 = Do_00a - Do_00b;
  const double Do_01a = (double)D->m00 * (double)dc[0], Do_01b = (double)D->m01 * (double)dc[1],
      Do_01 = Do_01a + Do_01b;
  const double Do_10a = (double)D->m10 * (double)dc[1], Do_10b = (double)D->m11 * (double)dc[0],
      Do_10 = Do_10a - Do_10b;
  const double Do_11a = (double)D->m10 * (double)dc[0], Do_11b = (double)D->m11 * (double)dc[1],
      Do_11 = Do_11a + Do_11b;
  const double Do_20a = (double)D->m20 * (double)dc[1], Do_20b = (double)D->m21 * (double)dc[0],
      Do_20 = Do_20a - Do_20b;
  const double Do_21a = (double)D->m20 * (double)dc[0], Do_21b = (double)D->m21 * (double)dc[1],
      Do_21 = Do_21a + Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03a = (double)D->m02 * (double)k, Do_03 = (double)D->m03 - Do_03a;
  const double Do_13a = (double)D->m12 * (double)k, Do_13 = (double)D->m13 - Do_13a;
  const double Do_23a = (double)D->m22 * (double)k, Do_23 = (double)D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

#endif

/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SCREW_ACCURATE_H
#define KSL_SCREW_ACCURATE_H


/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale_accurate(ksl_screw_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  const double self_0_new_lo = ksl_product_error(self->m0, a, self_0_new),
      self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_lo = ksl_product_error(self->m1, a, self_1_new),
      self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_error(self->m2, a, self_2_new),
      self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_lo = ksl_product_error(self->m3, a, self_3_new),
      self_3_new_rounded = self_3_new + self_3_new_lo;
  const double self_4_new_lo = ksl_product_error(self->m4, a, self_4_new),
      self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_lo = ksl_product_error(self->m5, a, self_5_new),
      self_5_new_rounded = self_5_new + self_5_new_lo;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss_accurate(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0,
      y_0_new_right = y_0_new - y_0_new_a, y_0_new_left = y_0_new - y_0_new_right,
      y_0_new_left_rest = ksl_product_rest(a, x->m0, y_0_new_a, y_0_new_left),
      y_0_new_right_rest = y->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1,
      y_1_new_right = y_1_new - y_1_new_a, y_1_new_left = y_1_new - y_1_new_right,
      y_1_new_left_rest = ksl_product_rest(a, x->m1, y_1_new_a, y_1_new_left),
      y_1_new_right_rest = y->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2,
      y_2_new_right = y_2_new - y_2_new_a, y_2_new_left = y_2_new - y_2_new_right,
      y_2_new_left_rest = ksl_product_rest(a, x->m2, y_2_new_a, y_2_new_left),
      y_2_new_right_rest = y->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3,
      y_3_new_right = y_3_new - y_3_new_a, y_3_new_left = y_3_new - y_3_new_right,
      y_3_new_left_rest = ksl_product_rest(a, x->m3, y_3_new_a, y_3_new_left),
      y_3_new_right_rest = y->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest + y_3_new_right_rest;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4,
      y_4_new_right = y_4_new - y_4_new_a, y_4_new_left = y_4_new - y_4_new_right,
      y_4_new_left_rest = ksl_product_rest(a, x->m4, y_4_new_a, y_4_new_left),
      y_4_new_right_rest = y->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest + y_4_new_right_rest;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5,
      y_5_new_right = y_5_new - y_5_new_a, y_5_new_left = y_5_new - y_5_new_right,
      y_5_new_left_rest = ksl_product_rest(a, x->m5, y_5_new_a, y_5_new_left),
      y_5_new_right_rest = y->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest + y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = x->m0 + y->m0, y_0_new_right = y_0_new - x->m0,
      y_0_new_left = y_0_new - y_0_new_right, y_0_new_left_rest = x->m0 - y_0_new_left,
      y_0_new_right_rest = y->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new = x->m1 + y->m1, y_1_new_right = y_1_new - x->m1,
      y_1_new_left = y_1_new - y_1_new_right, y_1_new_left_rest = x->m1 - y_1_new_left,
      y_1_new_right_rest = y->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new = x->m2 + y->m2, y_2_new_right = y_2_new - x->m2,
      y_2_new_left = y_2_new - y_2_new_right, y_2_new_left_rest = x->m2 - y_2_new_left,
      y_2_new_right_rest = y->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_3_new = x->m3 + y->m3, y_3_new_right = y_3_new - x->m3,
      y_3_new_left = y_3_new - y_3_new_right, y_3_new_left_rest = x->m3 - y_3_new_left,
      y_3_new_right_rest = y->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest + y_3_new_right_rest;
  const double y_4_new = x->m4 + y->m4, y_4_new_right = y_4_new - x->m4,
      y_4_new_left = y_4_new - y_4_new_right, y_4_new_left_rest = x->m4 - y_4_new_left,
      y_4_new_right_rest = y->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest + y_4_new_right_rest;
  const double y_5_new = x->m5 + y->m5, y_5_new_right = y_5_new - x->m5,
      y_5_new_left = y_5_new - y_5_new_right, y_5_new_left_rest = x->m5 - y_5_new_left,
      y_5_new_right_rest = y->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest + y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = y->m0 - x->m0, y_0_new_right = y->m0 - y_0_new,
      y_0_new_left = y_0_new + y_0_new_right, y_0_new_left_rest = y->m0 - y_0_new_left,
      y_0_new_right_rest = x->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest - y_0_new_right_rest;
  const double y_1_new = y->m1 - x->m1, y_1_new_right = y->m1 - y_1_new,
      y_1_new_left = y_1_new + y_1_new_right, y_1_new_left_rest = y->m1 - y_1_new_left,
      y_1_new_right_rest = x->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest - y_1_new_right_rest;
  const double y_2_new = y->m2 - x->m2, y_2_new_right = y->m2 - y_2_new,
      y_2_new_left = y_2_new + y_2_new_right, y_2_new_left_rest = y->m2 - y_2_new_left,
      y_2_new_right_rest = x->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest - y_2_new_right_rest;
  const double y_3_new = y->m3 - x->m3, y_3_new_right = y->m3 - y_3_new,
      y_3_new_left = y_3_new + y_3_new_right, y_3_new_left_rest = y->m3 - y_3_new_left,
      y_3_new_right_rest = x->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest - y_3_new_right_rest;
  const double y_4_new = y->m4 - x->m4, y_4_new_right = y->m4 - y_4_new,
      y_4_new_left = y_4_new + y_4_new_right, y_4_new_left_rest = y->m4 - y_4_new_left,
      y_4_new_right_rest = x->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest - y_4_new_right_rest;
  const double y_5_new = y->m5 - x->m5, y_5_new_right = y->m5 - y_5_new,
      y_5_new_left = y_5_new + y_5_new_right, y_5_new_left_rest = y->m5 - y_5_new_left,
      y_5_new_right_rest = x->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest - y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_as_accurate(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = a * si->m0;
  const double so_1 = a * si->m1;
  const double so_2 = a * si->m2;
  const double so_3 = a * si->m3;
  const double so_4 = a * si->m4;
  const double so_5 = a * si->m5;
  const double so_0_lo = ksl_product_error(a, si->m0, so_0), so_0_rounded = so_0 + so_0_lo;
  const double so_1_lo = ksl_product_error(a, si->m1, so_1), so_1_rounded = so_1 + so_1_lo;
  const double so_2_lo = ksl_product_error(a, si->m2, so_2), so_2_rounded = so_2 + so_2_lo;
  const double so_3_lo = ksl_product_error(a, si->m3, so_3), so_3_rounded = so_3 + so_3_lo;
  const double so_4_lo = ksl_product_error(a, si->m4, so_4), so_4_rounded = so_4 + so_4_lo;
  const double so_5_lo = ksl_product_error(a, si->m5, so_5), so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_right = so_0 - s1->m0, so_0_left = so_0 - so_0_right,
      so_0_left_rest = s1->m0 - so_0_left, so_0_right_rest = s2->m0 - so_0_right,
      so_0_lo = so_0_left_rest + so_0_right_rest;
  const double so_1 = s1->m1 + s2->m1, so_1_right = so_1 - s1->m1, so_1_left = so_1 - so_1_right,
      so_1_left_rest = s1->m1 - so_1_left, so_1_right_rest = s2->m1 - so_1_right,
      so_1_lo = so_1_left_rest + so_1_right_rest;
  const double so_2 = s1->m2 + s2->m2, so_2_right = so_2 - s1->m2, so_2_left = so_2 - so_2_right,
      so_2_left_rest = s1->m2 - so_2_left, so_2_right_rest = s2->m2 - so_2_right,
      so_2_lo = so_2_left_rest + so_2_right_rest;
  const double so_3 = s1->m3 + s2->m3, so_3_right = so_3 - s1->m3, so_3_left = so_3 - so_3_right,
      so_3_left_rest = s1->m3 - so_3_left, so_3_right_rest = s2->m3 - so_3_right,
      so_3_lo = so_3_left_rest + so_3_right_rest;
  const double so_4 = s1->m4 + s2->m4, so_4_right = so_4 - s1->m4, so_4_left = so_4 - so_4_right,
      so_4_left_rest = s1->m4 - so_4_left, so_4_right_rest = s2->m4 - so_4_right,
      so_4_lo = so_4_left_rest + so_4_right_rest;
  const double so_5 = s1->m5 + s2->m5, so_5_right = so_5 - s1->m5, so_5_left = so_5 - so_5_right,
      so_5_left_rest = s1->m5 - so_5_left, so_5_right_rest = s2->m5 - so_5_right,
      so_5_lo = so_5_left_rest + so_5_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0, so_0_right = s1->m0 - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = s1->m0 - so_0_left, so_0_right_rest = s2->m0 - so_0_right,
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1 = s1->m1 - s2->m1, so_1_right = s1->m1 - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = s1->m1 - so_1_left, so_1_right_rest = s2->m1 - so_1_right,
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2 = s1->m2 - s2->m2, so_2_right = s1->m2 - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = s1->m2 - so_2_left, so_2_right_rest = s2->m2 - so_2_right,
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_3 = s1->m3 - s2->m3, so_3_right = s1->m3 - so_3, so_3_left = so_3 + so_3_right,
      so_3_left_rest = s1->m3 - so_3_left, so_3_right_rest = s2->m3 - so_3_right,
      so_3_lo = so_3_left_rest - so_3_right_rest;
  const double so_4 = s1->m4 - s2->m4, so_4_right = s1->m4 - so_4, so_4_left = so_4 + so_4_right,
      so_4_left_rest = s1->m4 - so_4_left, so_4_right_rest = s2->m4 - so_4_right,
      so_4_lo = so_4_left_rest - so_4_right_rest;
  const double so_5 = s1->m5 - s2->m5, so_5_right = s1->m5 - so_5, so_5_left = so_5 + so_5_right,
      so_5_left_rest = s1->m5 - so_5_left, so_5_right_rest = s2->m5 - so_5_right,
      so_5_lo = so_5_left_rest - so_5_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_right = so_0 - s1->m0, so_0_left = so_0 - so_0_right,
      so_0_left_rest = s1->m0 - so_0_left, so_0_right_rest = s2->m0 - so_0_right,
      so_0_lo = so_0_left_rest + so_0_right_rest;
  const double so_1 = s1->m1 + s2->m1, so_1_right = so_1 - s1->m1, so_1_left = so_1 - so_1_right,
      so_1_left_rest = s1->m1 - so_1_left, so_1_right_rest = s2->m1 - so_1_right,
      so_1_lo = so_1_left_rest + so_1_right_rest;
  const double so_2 = s1->m2 + s2->m2, so_2_right = so_2 - s1->m2, so_2_left = so_2 - so_2_right,
      so_2_left_rest = s1->m2 - so_2_left, so_2_right_rest = s2->m2 - so_2_right,
      so_2_lo = so_2_left_rest + so_2_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adts_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->y * si->m5, so_0b = t->z * si->m4, so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(t->y, si->m5, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(t->z, si->m4, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest - so_0c_right_rest, so_0 = so_0c + si->m0,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = si->m0 - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = t->z * si->m3, so_1b = t->x * si->m5, so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(t->z, si->m3, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(t->x, si->m5, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest - so_1c_right_rest, so_1 = so_1c + si->m1,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = si->m1 - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = t->x * si->m4, so_2b = t->y * si->m3, so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(t->x, si->m4, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(t->y, si->m3, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest - so_2c_right_rest, so_2 = so_2c + si->m2,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = si->m2 - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtinvs_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(t->z, si->m4, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(t->y, si->m5, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest - so_0c_right_rest, so_0 = so_0c + si->m0,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = si->m0 - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(t->x, si->m5, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(t->z, si->m3, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest - so_1c_right_rest, so_1 = so_1c + si->m1,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = si->m1 - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(t->y, si->m3, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(t->x, si->m4, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest - so_2c_right_rest, so_2 = so_2c + si->m2,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = si->m2 - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsinv_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(t->z, si->m4, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(t->y, si->m5, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest - so_0c_right_rest, so_0 = so_0c - si->m0,
      so_0_right = so_0c - so_0, so_0_left = so_0 + so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = si->m0 - so_0_right, so_0_lo1 = so_0_left_rest - so_0_right_rest,
      so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(t->x, si->m5, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(t->z, si->m3, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest - so_1c_right_rest, so_1 = so_1c - si->m1,
      so_1_right = so_1c - so_1, so_1_left = so_1 + so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = si->m1 - so_1_right, so_1_lo1 = so_1_left_rest - so_1_right_rest,
      so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(t->y, si->m3, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(t->x, si->m4, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest - so_2c_right_rest, so_2 = so_2c - si->m2,
      so_2_right = so_2c - so_2, so_2_left = so_2 + so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = si->m2 - so_2_right, so_2_lo1 = so_2_left_rest - so_2_right_rest,
      so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_3 = -si->m3;
  const double so_4 = -si->m4;
  const double so_5 = -si->m5;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0c_right = so_0c - so_0a, so_0c_left = so_0c - so_0c_right,
      so_0c_left_rest = ksl_product_rest(R->m00, si->m0, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(R->m01, si->m1, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest + so_0c_right_rest, so_0d = R->m02 * si->m2, so_0 = so_0c + so_0d,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = ksl_product_rest(R->m02, si->m2, so_0d, so_0_right),
      so_0_lo1 = so_0_left_rest + so_0_right_rest, so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1c_right = so_1c - so_1a, so_1c_left = so_1c - so_1c_right,
      so_1c_left_rest = ksl_product_rest(R->m10, si->m0, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest + so_1c_right_rest, so_1d = R->m12 * si->m2, so_1 = so_1c + so_1d,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = ksl_product_rest(R->m12, si->m2, so_1d, so_1_right),
      so_1_lo1 = so_1_left_rest + so_1_right_rest, so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2c_right = so_2c - so_2a, so_2c_left = so_2c - so_2c_right,
      so_2c_left_rest = ksl_product_rest(R->m20, si->m0, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(R->m21, si->m1, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest + so_2c_right_rest, so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = ksl_product_rest(R->m22, si->m2, so_2d, so_2_right),
      so_2_lo1 = so_2_left_rest + so_2_right_rest, so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3c_right = so_3c - so_3a, so_3c_left = so_3c - so_3c_right,
      so_3c_left_rest = ksl_product_rest(R->m00, si->m3, so_3a, so_3c_left),
      so_3c_right_rest = ksl_product_rest(R->m01, si->m4, so_3b, so_3c_right),
      so_3c_lo = so_3c_left_rest + so_3c_right_rest, so_3d = R->m02 * si->m5, so_3 = so_3c + so_3d,
      so_3_right = so_3 - so_3c, so_3_left = so_3 - so_3_right, so_3_left_rest = so_3c - so_3_left,
      so_3_right_rest = ksl_product_rest(R->m02, si->m5, so_3d, so_3_right),
      so_3_lo1 = so_3_left_rest + so_3_right_rest, so_3_lo = so_3_lo1 + so_3c_lo;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4c_right = so_4c - so_4a, so_4c_left = so_4c - so_4c_right,
      so_4c_left_rest = ksl_product_rest(R->m10, si->m3, so_4a, so_4c_left),
      so_4c_right_rest = ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right),
      so_4c_lo = so_4c_left_rest + so_4c_right_rest, so_4d = R->m12 * si->m5, so_4 = so_4c + so_4d,
      so_4_right = so_4 - so_4c, so_4_left = so_4 - so_4_right, so_4_left_rest = so_4c - so_4_left,
      so_4_right_rest = ksl_product_rest(R->m12, si->m5, so_4d, so_4_right),
      so_4_lo1 = so_4_left_rest + so_4_right_rest, so_4_lo = so_4_lo1 + so_4c_lo;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5c_right = so_5c - so_5a, so_5c_left = so_5c - so_5c_right,
      so_5c_left_rest = ksl_product_rest(R->m20, si->m3, so_5a, so_5c_left),
      so_5c_right_rest = ksl_product_rest(R->m21, si->m4, so_5b, so_5c_right),
      so_5c_lo = so_5c_left_rest + so_5c_right_rest, so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d,
      so_5_right = so_5 - so_5c, so_5_left = so_5 - so_5_right, so_5_left_rest = so_5c - so_5_left,
      so_5_right_rest = ksl_product_rest(R->m22, si->m5, so_5d, so_5_right),
      so_5_lo1 = so_5_left_rest + so_5_right_rest, so_5_lo = so_5_lo1 + so_5c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrinvs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m10 * si->m1, so_0c = so_0a + so_0b,
      so_0c_right = so_0c - so_0a, so_0c_left = so_0c - so_0c_right,
      so_0c_left_rest = ksl_product_rest(R->m00, si->m0, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(R->m10, si->m1, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest + so_0c_right_rest, so_0d = R->m20 * si->m2, so_0 = so_0c + so_0d,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = ksl_product_rest(R->m20, si->m2, so_0d, so_0_right),
      so_0_lo1 = so_0_left_rest + so_0_right_rest, so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = R->m01 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1c_right = so_1c - so_1a, so_1c_left = so_1c - so_1c_right,
      so_1c_left_rest = ksl_product_rest(R->m01, si->m0, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest + so_1c_right_rest, so_1d = R->m21 * si->m2, so_1 = so_1c + so_1d,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = ksl_product_rest(R->m21, si->m2, so_1d, so_1_right),
      so_1_lo1 = so_1_left_rest + so_1_right_rest, so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = R->m02 * si->m0, so_2b = R->m12 * si->m1, so_2c = so_2a + so_2b,
      so_2c_right = so_2c - so_2a, so_2c_left = so_2c - so_2c_right,
      so_2c_left_rest = ksl_product_rest(R->m02, si->m0, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(R->m12, si->m1, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest + so_2c_right_rest, so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = ksl_product_rest(R->m22, si->m2, so_2d, so_2_right),
      so_2_lo1 = so_2_left_rest + so_2_right_rest, so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_3a = R->m00 * si->m3, so_3b = R->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3c_right = so_3c - so_3a, so_3c_left = so_3c - so_3c_right,
      so_3c_left_rest = ksl_product_rest(R->m00, si->m3, so_3a, so_3c_left),
      so_3c_right_rest = ksl_product_rest(R->m10, si->m4, so_3b, so_3c_right),
      so_3c_lo = so_3c_left_rest + so_3c_right_rest, so_3d = R->m20 * si->m5, so_3 = so_3c + so_3d,
      so_3_right = so_3 - so_3c, so_3_left = so_3 - so_3_right, so_3_left_rest = so_3c - so_3_left,
      so_3_right_rest = ksl_product_rest(R->m20, si->m5, so_3d, so_3_right),
      so_3_lo1 = so_3_left_rest + so_3_right_rest, so_3_lo = so_3_lo1 + so_3c_lo;
  const double so_4a = R->m01 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4c_right = so_4c - so_4a, so_4c_left = so_4c - so_4c_right,
      so_4c_left_rest = ksl_product_rest(R->m01, si->m3, so_4a, so_4c_left),
      so_4c_right_rest = ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right),
      so_4c_lo = so_4c_left_rest + so_4c_right_rest, so_4d = R->m21 * si->m5, so_4 = so_4c + so_4d,
      so_4_right = so_4 - so_4c, so_4_left = so_4 - so_4_right, so_4_left_rest = so_4c - so_4_left,
      so_4_right_rest = ksl_product_rest(R->m21, si->m5, so_4d, so_4_right),
      so_4_lo1 = so_4_left_rest + so_4_right_rest, so_4_lo = so_4_lo1 + so_4c_lo;
  const double so_5a = R->m02 * si->m3, so_5b = R->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5c_right = so_5c - so_5a, so_5c_left = so_5c - so_5c_right,
      so_5c_left_rest = ksl_product_rest(R->m02, si->m3, so_5a, so_5c_left),
      so_5c_right_rest = ksl_product_rest(R->m12, si->m4, so_5b, so_5c_right),
      so_5c_lo = so_5c_left_rest + so_5c_right_rest, so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d,
      so_5_right = so_5 - so_5c, so_5_left = so_5 - so_5_right, so_5_left_rest = so_5c - so_5_left,
      so_5_right_rest = ksl_product_rest(R->m22, si->m5, so_5d, so_5_right),
      so_5_lo1 = so_5_left_rest + so_5_right_rest, so_5_lo = so_5_lo1 + so_5c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest, 12 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsinv_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0c_right = so_0c - so_0a, so_0c_left = so_0c - so_0c_right,
      so_0c_left_rest = ksl_product_rest(R->m00, si->m0, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(R->m01, si->m1, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest + so_0c_right_rest, so_0d = R->m02 * si->m2, so_0e = so_0c + so_0d,
      so_0e_right = so_0e - so_0c, so_0e_left = so_0e - so_0e_right,
      so_0e_left_rest = so_0c - so_0e_left,
      so_0e_right_rest = ksl_product_rest(R->m02, si->m2, so_0d, so_0e_right),
      so_0e_lo1 = so_0e_left_rest + so_0e_right_rest, so_0e_lo = so_0e_lo1 + so_0c_lo,
      so_0 = -so_0e, so_0_lo = -so_0e_lo;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1c_right = so_1c - so_1a, so_1c_left = so_1c - so_1c_right,
      so_1c_left_rest = ksl_product_rest(R->m10, si->m0, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest + so_1c_right_rest, so_1d = R->m12 * si->m2, so_1e = so_1c + so_1d,
      so_1e_right = so_1e - so_1c, so_1e_left = so_1e - so_1e_right,
      so_1e_left_rest = so_1c - so_1e_left,
      so_1e_right_rest = ksl_product_rest(R->m12, si->m2, so_1d, so_1e_right),
      so_1e_lo1 = so_1e_left_rest + so_1e_right_rest, so_1e_lo = so_1e_lo1 + so_1c_lo,
      so_1 = -so_1e, so_1_lo = -so_1e_lo;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2c_right = so_2c - so_2a, so_2c_left = so_2c - so_2c_right,
      so_2c_left_rest = ksl_product_rest(R->m20, si->m0, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(R->m21, si->m1, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest + so_2c_right_rest, so_2d = R->m22 * si->m2, so_2e = so_2c + so_2d,
      so_2e_right = so_2e - so_2c, so_2e_left = so_2e - so_2e_right,
      so_2e_left_rest = so_2c - so_2e_left,
      so_2e_right_rest = ksl_product_rest(R->m22, si->m2, so_2d, so_2e_right),
      so_2e_lo1 = so_2e_left_rest + so_2e_right_rest, so_2e_lo = so_2e_lo1 + so_2c_lo,
      so_2 = -so_2e, so_2_lo = -so_2e_lo;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3c_right = so_3c - so_3a, so_3c_left = so_3c - so_3c_right,
      so_3c_left_rest = ksl_product_rest(R->m00, si->m3, so_3a, so_3c_left),
      so_3c_right_rest = ksl_product_rest(R->m01, si->m4, so_3b, so_3c_right),
      so_3c_lo = so_3c_left_rest + so_3c_right_rest, so_3d = R->m02 * si->m5, so_3e = so_3c + so_3d,
      so_3e_right = so_3e - so_3c, so_3e_left = so_3e - so_3e_right,
      so_3e_left_rest = so_3c - so_3e_left,
      so_3e_right_rest = ksl_product_rest(R->m02, si->m5, so_3d, so_3e_right),
      so_3e_lo1 = so_3e_left_rest + so_3e_right_rest, so_3e_lo = so_3e_lo1 + so_3c_lo,
      so_3 = -so_3e, so_3_lo = -so_3e_lo;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4c_right = so_4c - so_4a, so_4c_left = so_4c - so_4c_right,
      so_4c_left_rest = ksl_product_rest(R->m10, si->m3, so_4a, so_4c_left),
      so_4c_right_rest = ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right),
      so_4c_lo = so_4c_left_rest + so_4c_right_rest, so_4d = R->m12 * si->m5, so_4e = so_4c + so_4d,
      so_4e_right = so_4e - so_4c, so_4e_left = so_4e - so_4e_right,
      so_4e_left_rest = so_4c - so_4e_left,
      so_4e_right_rest = ksl_product_rest(R->m12, si->m5, so_4d, so_4e_right),
      so_4e_lo1 = so_4e_left_rest + so_4e_right_rest, so_4e_lo = so_4e_lo1 + so_4c_lo,
      so_4 = -so_4e, so_4_lo = -so_4e_lo;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5c_right = so_5c - so_5a, so_5c_left = so_5c - so_5c_right,
      so_5c_left_rest = ksl_product_rest(R->m20, si->m3, so_5a, so_5c_left),
      so_5c_right_rest = ksl_product_rest(R->m21, si->m4, so_5b, so_5c_right),
      so_5c_lo = so_5c_left_rest + so_5c_right_rest, so_5d = R->m22 * si->m5, so_5e = so_5c + so_5d,
      so_5e_right = so_5e - so_5c, so_5e_left = so_5e - so_5e_right,
      so_5e_left_rest = so_5c - so_5e_left,
      so_5e_right_rest = ksl_product_rest(R->m22, si->m5, so_5d, so_5e_right),
      so_5e_lo1 = so_5e_left_rest + so_5e_right_rest, so_5e_lo = so_5e_lo1 + so_5c_lo,
      so_5 = -so_5e, so_5_lo = -so_5e_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   30 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Ads_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, si->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, si->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * si->m2, w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c, w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = ksl_product_rest(D->m02, si->m2, w_0d, w_0_right),
      w_0_lo1 = w_0_left_rest + w_0_right_rest, w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, si->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, si->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * si->m2, w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c, w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = ksl_product_rest(D->m12, si->m2, w_1d, w_1_right),
      w_1_lo1 = w_1_left_rest + w_1_right_rest, w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, si->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, si->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * si->m2, w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c, w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = ksl_product_rest(D->m22, si->m2, w_2d, w_2_right),
      w_2_lo1 = w_2_left_rest + w_2_right_rest, w_2_lo = w_2_lo1 + w_2c_lo;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, si->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, si->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * si->m5, w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c, w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ksl_product_rest(D->m02, si->m5, w_3d, w_3_right),
      w_3_lo1 = w_3_left_rest + w_3_right_rest, w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, si->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, si->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * si->m5, w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c, w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ksl_product_rest(D->m12, si->m5, w_4d, w_4_right),
      w_4_lo1 = w_4_left_rest + w_4_right_rest, w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, si->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, si->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * si->m5, w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c, w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ksl_product_rest(D->m22, si->m5, w_5d, w_5_right),
      w_5_lo1 = w_5_left_rest + w_5_right_rest, w_5_lo = w_5_lo1 + w_5c_lo;
  const double so_0a = D->m13 * w_5, so_0a_cross2 = D->m13 * w_5_lo, so_0b = D->m23 * w_4,
      so_0b_cross2 = D->m23 * w_4_lo, so_0c = so_0a - so_0b, so_0c_right = so_0a - so_0c,
      so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(D->m13, w_5, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(D->m23, w_4, so_0b, so_0c_right),
      so_0c_cross = so_0a_cross2 - so_0b_cross2, so_0c_lo1 = so_0c_left_rest - so_0c_right_rest,
      so_0c_lo = so_0c_lo1 + so_0c_cross, so_0 = so_0c + w_0, so_0_right = so_0 - so_0c,
      so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = w_0 - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo2 = so_0_lo1 + w_0_lo, so_0_lo = so_0_lo2 + so_0c_lo;
  const double so_1a = D->m23 * w_3, so_1a_cross2 = D->m23 * w_3_lo, so_1b = D->m03 * w_5,
      so_1b_cross2 = D->m03 * w_5_lo, so_1c = so_1a - so_1b, so_1c_right = so_1a - so_1c,
      so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(D->m23, w_3, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(D->m03, w_5, so_1b, so_1c_right),
      so_1c_cross = so_1a_cross2 - so_1b_cross2, so_1c_lo1 = so_1c_left_rest - so_1c_right_rest,
      so_1c_lo = so_1c_lo1 + so_1c_cross, so_1 = so_1c + w_1, so_1_right = so_1 - so_1c,
      so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = w_1 - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo2 = so_1_lo1 + w_1_lo, so_1_lo = so_1_lo2 + so_1c_lo;
  const double so_2a = D->m03 * w_4, so_2a_cross2 = D->m03 * w_4_lo, so_2b = D->m13 * w_3,
      so_2b_cross2 = D->m13 * w_3_lo, so_2c = so_2a - so_2b, so_2c_right = so_2a - so_2c,
      so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(D->m03, w_4, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(D->m13, w_3, so_2b, so_2c_right),
      so_2c_cross = so_2a_cross2 - so_2b_cross2, so_2c_lo1 = so_2c_left_rest - so_2c_right_rest,
      so_2c_lo = so_2c_lo1 + so_2c_cross, so_2 = so_2c + w_2, so_2_right = so_2 - so_2c,
      so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = w_2 - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo2 = so_2_lo1 + w_2_lo, so_2_lo = so_2_lo2 + so_2c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double w_3_rounded = w_3 + w_3_lo;
  const double w_4_rounded = w_4 + w_4_lo;
  const double w_5_rounded = w_5 + w_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = w_3_rounded;
  so->m4 = w_4_rounded;
  so->m5 = w_5_rounded;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   33 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adinvs_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m23 * si->m4, w_0b = D->m13 * si->m5, w_0c = w_0a - w_0b,
      w_0c_right = w_0a - w_0c, w_0c_left = w_0c + w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m23, si->m4, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m13, si->m5, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest - w_0c_right_rest, w_0 = w_0c + si->m0, w_0_right = w_0 - w_0c,
      w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = si->m0 - w_0_right, w_0_lo1 = w_0_left_rest + w_0_right_rest,
      w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m03 * si->m5, w_1b = D->m23 * si->m3, w_1c = w_1a - w_1b,
      w_1c_right = w_1a - w_1c, w_1c_left = w_1c + w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m03, si->m5, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m23, si->m3, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest - w_1c_right_rest, w_1 = w_1c + si->m1, w_1_right = w_1 - w_1c,
      w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = si->m1 - w_1_right, w_1_lo1 = w_1_left_rest + w_1_right_rest,
      w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m13 * si->m3, w_2b = D->m03 * si->m4, w_2c = w_2a - w_2b,
      w_2c_right = w_2a - w_2c, w_2c_left = w_2c + w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m13, si->m3, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m03, si->m4, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest - w_2c_right_rest, w_2 = w_2c + si->m2, w_2_right = w_2 - w_2c,
      w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = si->m2 - w_2_right, w_2_lo1 = w_2_left_rest + w_2_right_rest,
      w_2_lo = w_2_lo1 + w_2c_lo;
  const double so_0a = D->m00 * w_0, so_0a_cross2 = D->m00 * w_0_lo, so_0b = D->m10 * w_1,
      so_0b_cross2 = D->m10 * w_1_lo, so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a,
      so_0c_left = so_0c - so_0c_right,
      so_0c_left_rest = ksl_product_rest(D->m00, w_0, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(D->m10, w_1, so_0b, so_0c_right),
      so_0c_cross = so_0a_cross2 + so_0b_cross2, so_0c_lo1 = so_0c_left_rest + so_0c_right_rest,
      so_0c_lo = so_0c_lo1 + so_0c_cross, so_0d = D->m20 * w_2, so_0d_cross2 = D->m20 * w_2_lo,
      so_0 = so_0c + so_0d, so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right,
      so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = ksl_product_rest(D->m20, w_2, so_0d, so_0_right),
      so_0_lo1 = so_0_left_rest + so_0_right_rest, so_0_lo2 = so_0_lo1 + so_0d_cross2,
      so_0_lo = so_0_lo2 + so_0c_lo;
  const double so_1a = D->m01 * w_0, so_1a_cross2 = D->m01 * w_0_lo, so_1b = D->m11 * w_1,
      so_1b_cross2 = D->m11 * w_1_lo, so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a,
      so_1c_left = so_1c - so_1c_right,
      so_1c_left_rest = ksl_product_rest(D->m01, w_0, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(D->m11, w_1, so_1b, so_1c_right),
      so_1c_cross = so_1a_cross2 + so_1b_cross2, so_1c_lo1 = so_1c_left_rest + so_1c_right_rest,
      so_1c_lo = so_1c_lo1 + so_1c_cross, so_1d = D->m21 * w_2, so_1d_cross2 = D->m21 * w_2_lo,
      so_1 = so_1c + so_1d, so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right,
      so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = ksl_product_rest(D->m21, w_2, so_1d, so_1_right),
      so_1_lo1 = so_1_left_rest + so_1_right_rest, so_1_lo2 = so_1_lo1 + so_1d_cross2,
      so_1_lo = so_1_lo2 + so_1c_lo;
  const double so_2a = D->m02 * w_0, so_2a_cross2 = D->m02 * w_0_lo, so_2b = D->m12 * w_1,
      so_2b_cross2 = D->m12 * w_1_lo, so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a,
      so_2c_left = so_2c - so_2c_right,
      so_2c_left_rest = ksl_product_rest(D->m02, w_0, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(D->m12, w_1, so_2b, so_2c_right),
      so_2c_cross = so_2a_cross2 + so_2b_cross2, so_2c_lo1 = so_2c_left_rest + so_2c_right_rest,
      so_2c_lo = so_2c_lo1 + so_2c_cross, so_2d = D->m22 * w_2, so_2d_cross2 = D->m22 * w_2_lo,
      so_2 = so_2c + so_2d, so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right,
      so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = ksl_product_rest(D->m22, w_2, so_2d, so_2_right),
      so_2_lo1 = so_2_left_rest + so_2_right_rest, so_2_lo2 = so_2_lo1 + so_2d_cross2,
      so_2_lo = so_2_lo2 + so_2c_lo;
  const double so_3a = D->m00 * si->m3, so_3b = D->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3c_right = so_3c - so_3a, so_3c_left = so_3c - so_3c_right,
      so_3c_left_rest = ksl_product_rest(D->m00, si->m3, so_3a, so_3c_left),
      so_3c_right_rest = ksl_product_rest(D->m10, si->m4, so_3b, so_3c_right),
      so_3c_lo = so_3c_left_rest + so_3c_right_rest, so_3d = D->m20 * si->m5, so_3 = so_3c + so_3d,
      so_3_right = so_3 - so_3c, so_3_left = so_3 - so_3_right, so_3_left_rest = so_3c - so_3_left,
      so_3_right_rest = ksl_product_rest(D->m20, si->m5, so_3d, so_3_right),
      so_3_lo1 = so_3_left_rest + so_3_right_rest, so_3_lo = so_3_lo1 + so_3c_lo;
  const double so_4a = D->m01 * si->m3, so_4b = D->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4c_right = so_4c - so_4a, so_4c_left = so_4c - so_4c_right,
      so_4c_left_rest = ksl_product_rest(D->m01, si->m3, so_4a, so_4c_left),
      so_4c_right_rest = ksl_product_rest(D->m11, si->m4, so_4b, so_4c_right),
      so_4c_lo = so_4c_left_rest + so_4c_right_rest, so_4d = D->m21 * si->m5, so_4 = so_4c + so_4d,
      so_4_right = so_4 - so_4c, so_4_left = so_4 - so_4_right, so_4_left_rest = so_4c - so_4_left,
      so_4_right_rest = ksl_product_rest(D->m21, si->m5, so_4d, so_4_right),
      so_4_lo1 = so_4_left_rest + so_4_right_rest, so_4_lo = so_4_lo1 + so_4c_lo;
  const double so_5a = D->m02 * si->m3, so_5b = D->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5c_right = so_5c - so_5a, so_5c_left = so_5c - so_5c_right,
      so_5c_left_rest = ksl_product_rest(D->m02, si->m3, so_5a, so_5c_left),
      so_5c_right_rest = ksl_product_rest(D->m12, si->m4, so_5b, so_5c_right),
      so_5c_lo = so_5c_left_rest + so_5c_right_rest, so_5d = D->m22 * si->m5, so_5 = so_5c + so_5d,
      so_5_right = so_5 - so_5c, so_5_left = so_5 - so_5_right, so_5_left_rest = so_5c - so_5_left,
      so_5_right_rest = ksl_product_rest(D->m22, si->m5, so_5d, so_5_right),
      so_5_lo1 = so_5_left_rest + so_5_right_rest, so_5_lo = so_5_lo1 + so_5c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   30 mul, 108 add, 24 product rest, 12 neg.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsinv_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, si->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, si->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * si->m2, w_0e = w_0c + w_0d,
      w_0e_right = w_0e - w_0c, w_0e_left = w_0e - w_0e_right, w_0e_left_rest = w_0c - w_0e_left,
      w_0e_right_rest = ksl_product_rest(D->m02, si->m2, w_0d, w_0e_right),
      w_0e_lo1 = w_0e_left_rest + w_0e_right_rest, w_0e_lo = w_0e_lo1 + w_0c_lo, w_0 = -w_0e,
      w_0_lo = -w_0e_lo;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, si->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, si->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * si->m2, w_1e = w_1c + w_1d,
      w_1e_right = w_1e - w_1c, w_1e_left = w_1e - w_1e_right, w_1e_left_rest = w_1c - w_1e_left,
      w_1e_right_rest = ksl_product_rest(D->m12, si->m2, w_1d, w_1e_right),
      w_1e_lo1 = w_1e_left_rest + w_1e_right_rest, w_1e_lo = w_1e_lo1 + w_1c_lo, w_1 = -w_1e,
      w_1_lo = -w_1e_lo;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, si->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, si->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * si->m2, w_2e = w_2c + w_2d,
      w_2e_right = w_2e - w_2c, w_2e_left = w_2e - w_2e_right, w_2e_left_rest = w_2c - w_2e_left,
      w_2e_right_rest = ksl_product_rest(D->m22, si->m2, w_2d, w_2e_right),
      w_2e_lo1 = w_2e_left_rest + w_2e_right_rest, w_2e_lo = w_2e_lo1 + w_2c_lo, w_2 = -w_2e,
      w_2_lo = -w_2e_lo;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, si->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, si->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * si->m5, w_3e = w_3c + w_3d,
      w_3e_right = w_3e - w_3c, w_3e_left = w_3e - w_3e_right, w_3e_left_rest = w_3c - w_3e_left,
      w_3e_right_rest = ksl_product_rest(D->m02, si->m5, w_3d, w_3e_right),
      w_3e_lo1 = w_3e_left_rest + w_3e_right_rest, w_3e_lo = w_3e_lo1 + w_3c_lo, w_3 = -w_3e,
      w_3_lo = -w_3e_lo;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, si->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, si->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * si->m5, w_4e = w_4c + w_4d,
      w_4e_right = w_4e - w_4c, w_4e_left = w_4e - w_4e_right, w_4e_left_rest = w_4c - w_4e_left,
      w_4e_right_rest = ksl_product_rest(D->m12, si->m5, w_4d, w_4e_right),
      w_4e_lo1 = w_4e_left_rest + w_4e_right_rest, w_4e_lo = w_4e_lo1 + w_4c_lo, w_4 = -w_4e,
      w_4_lo = -w_4e_lo;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, si->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, si->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * si->m5, w_5e = w_5c + w_5d,
      w_5e_right = w_5e - w_5c, w_5e_left = w_5e - w_5e_right, w_5e_left_rest = w_5c - w_5e_left,
      w_5e_right_rest = ksl_product_rest(D->m22, si->m5, w_5d, w_5e_right),
      w_5e_lo1 = w_5e_left_rest + w_5e_right_rest, w_5e_lo = w_5e_lo1 + w_5c_lo, w_5 = -w_5e,
      w_5_lo = -w_5e_lo;
  const double so_0a = D->m13 * w_5, so_0a_cross2 = D->m13 * w_5_lo, so_0b = D->m23 * w_4,
      so_0b_cross2 = D->m23 * w_4_lo, so_0c = so_0a - so_0b, so_0c_right = so_0a - so_0c,
      so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(D->m13, w_5, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(D->m23, w_4, so_0b, so_0c_right),
      so_0c_cross = so_0a_cross2 - so_0b_cross2, so_0c_lo1 = so_0c_left_rest - so_0c_right_rest,
      so_0c_lo = so_0c_lo1 + so_0c_cross, so_0 = so_0c + w_0, so_0_right = so_0 - so_0c,
      so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = w_0 - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo2 = so_0_lo1 + w_0_lo, so_0_lo = so_0_lo2 + so_0c_lo;
  const double so_1a = D->m23 * w_3, so_1a_cross2 = D->m23 * w_3_lo, so_1b = D->m03 * w_5,
      so_1b_cross2 = D->m03 * w_5_lo, so_1c = so_1a - so_1b, so_1c_right = so_1a - so_1c,
      so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(D->m23, w_3, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(D->m03, w_5, so_1b, so_1c_right),
      so_1c_cross = so_1a_cross2 - so_1b_cross2, so_1c_lo1 = so_1c_left_rest - so_1c_right_rest,
      so_1c_lo = so_1c_lo1 + so_1c_cross, so_1 = so_1c + w_1, so_1_right = so_1 - so_1c,
      so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = w_1 - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo2 = so_1_lo1 + w_1_lo, so_1_lo = so_1_lo2 + so_1c_lo;
  const double so_2a = D->m03 * w_4, so_2a_cross2 = D->m03 * w_4_lo, so_2b = D->m13 * w_3,
      so_2b_cross2 = D->m13 * w_3_lo, so_2c = so_2a - so_2b, so_2c_right = so_2a - so_2c,
      so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(D->m03, w_4, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(D->m13, w_3, so_2b, so_2c_right),
      so_2c_cross = so_2a_cross2 - so_2b_cross2, so_2c_lo1 = so_2c_left_rest - so_2c_right_rest,
      so_2c_lo = so_2c_lo1 + so_2c_cross, so_2 = so_2c + w_2, so_2_right = so_2 - so_2c,
      so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = w_2 - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo2 = so_2_lo1 + w_2_lo, so_2_lo = so_2_lo2 + so_2c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double w_3_rounded = w_3 + w_3_lo;
  const double w_4_rounded = w_4 + w_4_lo;
  const double w_5_rounded = w_5 + w_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = w_3_rounded;
  so->m4 = w_4_rounded;
  so->m5 = w_5_rounded;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrx_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m20 * D->m13, so_0b = D->m10 * D->m23, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m20, D->m13, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m10, D->m23, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m00 * D->m23, so_1b = D->m20 * D->m03, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m00, D->m23, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m20, D->m03, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m10 * D->m03, so_2b = D->m00 * D->m13, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m10, D->m03, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m00, D->m13, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsry_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m21 * D->m13, so_0b = D->m11 * D->m23, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m21, D->m13, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m11, D->m23, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m01 * D->m23, so_1b = D->m21 * D->m03, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m01, D->m23, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m21, D->m03, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m11 * D->m03, so_2b = D->m01 * D->m13, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m11, D->m03, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m01, D->m13, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrz_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m22 * D->m13, so_0b = D->m12 * D->m23, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m22, D->m13, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m12, D->m23, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m02 * D->m23, so_1b = D->m22 * D->m03, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m02, D->m23, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m22, D->m03, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m12 * D->m03, so_2b = D->m02 * D->m13, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m12, D->m03, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m02, D->m13, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m10 * D->m23, so_0b = D->m20 * D->m13, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m10, D->m23, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m20, D->m13, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m20 * D->m03, so_1b = D->m00 * D->m23, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m20, D->m03, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m00, D->m23, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m00 * D->m13, so_2b = D->m10 * D->m03, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m00, D->m13, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m10, D->m03, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_3 = -D->m00;
  const double so_4 = -D->m10;
  const double so_5 = -D->m20;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m11 * D->m23, so_0b = D->m21 * D->m13, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m11, D->m23, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m21, D->m13, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m21 * D->m03, so_1b = D->m01 * D->m23, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m21, D->m03, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m01, D->m23, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m01 * D->m13, so_2b = D->m11 * D->m03, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m01, D->m13, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m11, D->m03, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_3 = -D->m01;
  const double so_4 = -D->m11;
  const double so_5 = -D->m21;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m12 * D->m23, so_0b = D->m22 * D->m13, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m12, D->m23, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m22, D->m13, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = D->m22 * D->m03, so_1b = D->m02 * D->m23, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m22, D->m03, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m02, D->m23, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = D->m02 * D->m13, so_2b = D->m12 * D->m03, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m02, D->m13, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m12, D->m03, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_3 = -D->m02;
  const double so_4 = -D->m12;
  const double so_5 = -D->m22;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 45 add, 18 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = D->m20 * D->m13, M_03b = D->m10 * D->m23, M_03 = M_03a - M_03b,
      M_03_right = M_03a - M_03, M_03_left = M_03 + M_03_right,
      M_03_left_rest = ksl_product_rest(D->m20, D->m13, M_03a, M_03_left),
      M_03_right_rest = ksl_product_rest(D->m10, D->m23, M_03b, M_03_right),
      M_03_lo = M_03_left_rest - M_03_right_rest;
  const double M_04a = D->m21 * D->m13, M_04b = D->m11 * D->m23, M_04 = M_04a - M_04b,
      M_04_right = M_04a - M_04, M_04_left = M_04 + M_04_right,
      M_04_left_rest = ksl_product_rest(D->m21, D->m13, M_04a, M_04_left),
      M_04_right_rest = ksl_product_rest(D->m11, D->m23, M_04b, M_04_right),
      M_04_lo = M_04_left_rest - M_04_right_rest;
  const double M_05a = D->m22 * D->m13, M_05b = D->m12 * D->m23, M_05 = M_05a - M_05b,
      M_05_right = M_05a - M_05, M_05_left = M_05 + M_05_right,
      M_05_left_rest = ksl_product_rest(D->m22, D->m13, M_05a, M_05_left),
      M_05_right_rest = ksl_product_rest(D->m12, D->m23, M_05b, M_05_right),
      M_05_lo = M_05_left_rest - M_05_right_rest;
  const double M_13a = D->m00 * D->m23, M_13b = D->m20 * D->m03, M_13 = M_13a - M_13b,
      M_13_right = M_13a - M_13, M_13_left = M_13 + M_13_right,
      M_13_left_rest = ksl_product_rest(D->m00, D->m23, M_13a, M_13_left),
      M_13_right_rest = ksl_product_rest(D->m20, D->m03, M_13b, M_13_right),
      M_13_lo = M_13_left_rest - M_13_right_rest;
  const double M_14a = D->m01 * D->m23, M_14b = D->m21 * D->m03, M_14 = M_14a - M_14b,
      M_14_right = M_14a - M_14, M_14_left = M_14 + M_14_right,
      M_14_left_rest = ksl_product_rest(D->m01, D->m23, M_14a, M_14_left),
      M_14_right_rest = ksl_product_rest(D->m21, D->m03, M_14b, M_14_right),
      M_14_lo = M_14_left_rest - M_14_right_rest;
  const double M_15a = D->m02 * D->m23, M_15b = D->m22 * D->m03, M_15 = M_15a - M_15b,
      M_15_right = M_15a - M_15, M_15_left = M_15 + M_15_right,
      M_15_left_rest = ksl_product_rest(D->m02, D->m23, M_15a, M_15_left),
      M_15_right_rest = ksl_product_rest(D->m22, D->m03, M_15b, M_15_right),
      M_15_lo = M_15_left_rest - M_15_right_rest;
  const double M_23a = D->m10 * D->m03, M_23b = D->m00 * D->m13, M_23 = M_23a - M_23b,
      M_23_right = M_23a - M_23, M_23_left = M_23 + M_23_right,
      M_23_left_rest = ksl_product_rest(D->m10, D->m03, M_23a, M_23_left),
      M_23_right_rest = ksl_product_rest(D->m00, D->m13, M_23b, M_23_right),
      M_23_lo = M_23_left_rest - M_23_right_rest;
  const double M_24a = D->m11 * D->m03, M_24b = D->m01 * D->m13, M_24 = M_24a - M_24b,
      M_24_right = M_24a - M_24, M_24_left = M_24 + M_24_right,
      M_24_left_rest = ksl_product_rest(D->m11, D->m03, M_24a, M_24_left),
      M_24_right_rest = ksl_product_rest(D->m01, D->m13, M_24b, M_24_right),
      M_24_lo = M_24_left_rest - M_24_right_rest;
  const double M_25a = D->m12 * D->m03, M_25b = D->m02 * D->m13, M_25 = M_25a - M_25b,
      M_25_right = M_25a - M_25, M_25_left = M_25 + M_25_right,
      M_25_left_rest = ksl_product_rest(D->m12, D->m03, M_25a, M_25_left),
      M_25_right_rest = ksl_product_rest(D->m02, D->m13, M_25b, M_25_right),
      M_25_lo = M_25_left_rest - M_25_right_rest;
  const double M_03_rounded = M_03 + M_03_lo;
  const double M_04_rounded = M_04 + M_04_lo;
  const double M_05_rounded = M_05 + M_05_lo;
  const double M_13_rounded = M_13 + M_13_lo;
  const double M_14_rounded = M_14 + M_14_lo;
  const double M_15_rounded = M_15 + M_15_lo;
  const double M_23_rounded = M_23 + M_23_lo;
  const double M_24_rounded = M_24 + M_24_lo;
  const double M_25_rounded = M_25 + M_25_lo;
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
  M->at[3][0] = M_03_rounded;
  M->at[4][0] = M_04_rounded;
  M->at[5][0] = M_05_rounded;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13_rounded;
  M->at[4][1] = M_14_rounded;
  M->at[5][1] = M_15_rounded;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23_rounded;
  M->at[4][2] = M_24_rounded;
  M->at[5][2] = M_25_rounded;
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
   6 mul, 29 add, 6 product rest.
   Error <= u |result| + 19 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_cs_accurate(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = c->m0 * s->m0, power_b = c->m1 * s->m1, power_c = power_a + power_b,
      power_c_right = power_c - power_a, power_c_left = power_c - power_c_right,
      power_c_left_rest = ksl_product_rest(c->m0, s->m0, power_a, power_c_left),
      power_c_right_rest = ksl_product_rest(c->m1, s->m1, power_b, power_c_right),
      power_c_lo = power_c_left_rest + power_c_right_rest, power_d = c->m2 * s->m2,
      power_e = power_c + power_d, power_e_right = power_e - power_c,
      power_e_left = power_e - power_e_right, power_e_left_rest = power_c - power_e_left,
      power_e_right_rest = ksl_product_rest(c->m2, s->m2, power_d, power_e_right),
      power_e_lo1 = power_e_left_rest + power_e_right_rest, power_e_lo = power_e_lo1 + power_c_lo,
      power_f = c->m3 * s->m3, power_g = c->m4 * s->m4, power_h = power_f + power_g,
      power_h_right = power_h - power_f, power_h_left = power_h - power_h_right,
      power_h_left_rest = ksl_product_rest(c->m3, s->m3, power_f, power_h_left),
      power_h_right_rest = ksl_product_rest(c->m4, s->m4, power_g, power_h_right),
      power_h_lo = power_h_left_rest + power_h_right_rest, power_i = c->m5 * s->m5,
      power_j = power_h + power_i, power_j_right = power_j - power_h,
      power_j_left = power_j - power_j_right, power_j_left_rest = power_h - power_j_left,
      power_j_right_rest = ksl_product_rest(c->m5, s->m5, power_i, power_j_right),
      power_j_lo1 = power_j_left_rest + power_j_right_rest, power_j_lo = power_j_lo1 + power_h_lo,
      power = power_e + power_j, power_right = power - power_e, power_left = power - power_right,
      power_left_rest = power_e - power_left, power_right_rest = power_j - power_right,
      power_lo1 = power_left_rest + power_right_rest, power_lo2 = power_lo1 + power_j_lo,
      power_lo = power_lo2 + power_e_lo;
  const double power_rounded = power + power_lo;
  return power_rounded;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + (lin: 12, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = s1->m1 * s2->m5, so_0b = s1->m5 * s2->m1, so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0c_left = so_0c + so_0c_right,
      so_0c_left_rest = ksl_product_rest(s1->m1, s2->m5, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(s1->m5, s2->m1, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest - so_0c_right_rest, so_0d = s1->m4 * s2->m2,
      so_0e = s1->m2 * s2->m4, so_0f = so_0d - so_0e, so_0f_right = so_0d - so_0f,
      so_0f_left = so_0f + so_0f_right,
      so_0f_left_rest = ksl_product_rest(s1->m4, s2->m2, so_0d, so_0f_left),
      so_0f_right_rest = ksl_product_rest(s1->m2, s2->m4, so_0e, so_0f_right),
      so_0f_lo = so_0f_left_rest - so_0f_right_rest, so_0 = so_0c + so_0f,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = so_0f - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo2 = so_0_lo1 + so_0f_lo, so_0_lo = so_0_lo2 + so_0c_lo;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m0 * s2->m5, so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1c_left = so_1c + so_1c_right,
      so_1c_left_rest = ksl_product_rest(s1->m5, s2->m0, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(s1->m0, s2->m5, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest - so_1c_right_rest, so_1d = s1->m2 * s2->m3,
      so_1e = s1->m3 * s2->m2, so_1f = so_1d - so_1e, so_1f_right = so_1d - so_1f,
      so_1f_left = so_1f + so_1f_right,
      so_1f_left_rest = ksl_product_rest(s1->m2, s2->m3, so_1d, so_1f_left),
      so_1f_right_rest = ksl_product_rest(s1->m3, s2->m2, so_1e, so_1f_right),
      so_1f_lo = so_1f_left_rest - so_1f_right_rest, so_1 = so_1c + so_1f,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = so_1f - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo2 = so_1_lo1 + so_1f_lo, so_1_lo = so_1_lo2 + so_1c_lo;
  const double so_2a = s1->m0 * s2->m4, so_2b = s1->m4 * s2->m0, so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2c_left = so_2c + so_2c_right,
      so_2c_left_rest = ksl_product_rest(s1->m0, s2->m4, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(s1->m4, s2->m0, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest - so_2c_right_rest, so_2d = s1->m3 * s2->m1,
      so_2e = s1->m1 * s2->m3, so_2f = so_2d - so_2e, so_2f_right = so_2d - so_2f,
      so_2f_left = so_2f + so_2f_right,
      so_2f_left_rest = ksl_product_rest(s1->m3, s2->m1, so_2d, so_2f_left),
      so_2f_right_rest = ksl_product_rest(s1->m1, s2->m3, so_2e, so_2f_right),
      so_2f_lo = so_2f_left_rest - so_2f_right_rest, so_2 = so_2c + so_2f,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = so_2f - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo2 = so_2_lo1 + so_2f_lo, so_2_lo = so_2_lo2 + so_2c_lo;
  const double so_3a = s1->m4 * s2->m5, so_3b = s1->m5 * s2->m4, so_3 = so_3a - so_3b,
      so_3_right = so_3a - so_3, so_3_left = so_3 + so_3_right,
      so_3_left_rest = ksl_product_rest(s1->m4, s2->m5, so_3a, so_3_left),
      so_3_right_rest = ksl_product_rest(s1->m5, s2->m4, so_3b, so_3_right),
      so_3_lo = so_3_left_rest - so_3_right_rest;
  const double so_4a = s1->m5 * s2->m3, so_4b = s1->m3 * s2->m5, so_4 = so_4a - so_4b,
      so_4_right = so_4a - so_4, so_4_left = so_4 + so_4_right,
      so_4_left_rest = ksl_product_rest(s1->m5, s2->m3, so_4a, so_4_left),
      so_4_right_rest = ksl_product_rest(s1->m3, s2->m5, so_4b, so_4_right),
      so_4_lo = so_4_left_rest - so_4_right_rest;
  const double so_5a = s1->m3 * s2->m4, so_5b = s1->m4 * s2->m3, so_5 = so_5a - so_5b,
      so_5_right = so_5a - so_5, so_5_left = so_5 + so_5_right,
      so_5_left_rest = ksl_product_rest(s1->m3, s2->m4, so_5a, so_5_left),
      so_5_right_rest = ksl_product_rest(s1->m4, s2->m3, so_5b, so_5_right),
      so_5_lo = so_5_left_rest - so_5_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double so_3_rounded = so_3 + so_3_lo;
  const double so_4_rounded = so_4 + so_4_lo;
  const double so_5_rounded = so_5 + so_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = s1->m4 * s2->m2, so_0b = s1->m5 * s2->m1, so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0, so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(s1->m4, s2->m2, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(s1->m5, s2->m1, so_0b, so_0_right),
      so_0_lo = so_0_left_rest - so_0_right_rest;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m3 * s2->m2, so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1, so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(s1->m5, s2->m0, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(s1->m3, s2->m2, so_1b, so_1_right),
      so_1_lo = so_1_left_rest - so_1_right_rest;
  const double so_2a = s1->m3 * s2->m1, so_2b = s1->m4 * s2->m0, so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2, so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(s1->m3, s2->m1, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(s1->m4, s2->m0, so_2b, so_2_right),
      so_2_lo = so_2_left_rest - so_2_right_rest;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   21 mul, 54 add, 15 product rest.
   Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsra_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0c_right = a_0c - a_0a, a_0c_left = a_0c - a_0c_right,
      a_0c_left_rest = ksl_product_rest(D->m00, axis->x, a_0a, a_0c_left),
      a_0c_right_rest = ksl_product_rest(D->m01, axis->y, a_0b, a_0c_right),
      a_0c_lo = a_0c_left_rest + a_0c_right_rest, a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d,
      a_0_right = a_0 - a_0c, a_0_left = a_0 - a_0_right, a_0_left_rest = a_0c - a_0_left,
      a_0_right_rest = ksl_product_rest(D->m02, axis->z, a_0d, a_0_right),
      a_0_lo1 = a_0_left_rest + a_0_right_rest, a_0_lo = a_0_lo1 + a_0c_lo;
  const double a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1c_right = a_1c - a_1a, a_1c_left = a_1c - a_1c_right,
      a_1c_left_rest = ksl_product_rest(D->m10, axis->x, a_1a, a_1c_left),
      a_1c_right_rest = ksl_product_rest(D->m11, axis->y, a_1b, a_1c_right),
      a_1c_lo = a_1c_left_rest + a_1c_right_rest, a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d,
      a_1_right = a_1 - a_1c, a_1_left = a_1 - a_1_right, a_1_left_rest = a_1c - a_1_left,
      a_1_right_rest = ksl_product_rest(D->m12, axis->z, a_1d, a_1_right),
      a_1_lo1 = a_1_left_rest + a_1_right_rest, a_1_lo = a_1_lo1 + a_1c_lo;
  const double a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2c_right = a_2c - a_2a, a_2c_left = a_2c - a_2c_right,
      a_2c_left_rest = ksl_product_rest(D->m20, axis->x, a_2a, a_2c_left),
      a_2c_right_rest = ksl_product_rest(D->m21, axis->y, a_2b, a_2c_right),
      a_2c_lo = a_2c_left_rest + a_2c_right_rest, a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d,
      a_2_right = a_2 - a_2c, a_2_left = a_2 - a_2_right, a_2_left_rest = a_2c - a_2_left,
      a_2_right_rest = ksl_product_rest(D->m22, axis->z, a_2d, a_2_right),
      a_2_lo1 = a_2_left_rest + a_2_right_rest, a_2_lo = a_2_lo1 + a_2c_lo;
  const double so_0a = D->m13 * a_2, so_0a_cross2 = D->m13 * a_2_lo, so_0b = D->m23 * a_1,
      so_0b_cross2 = D->m23 * a_1_lo, so_0 = so_0a - so_0b, so_0_right = so_0a - so_0,
      so_0_left = so_0 + so_0_right,
      so_0_left_rest = ksl_product_rest(D->m13, a_2, so_0a, so_0_left),
      so_0_right_rest = ksl_product_rest(D->m23, a_1, so_0b, so_0_right),
      so_0_cross = so_0a_cross2 - so_0b_cross2, so_0_lo1 = so_0_left_rest - so_0_right_rest,
      so_0_lo = so_0_lo1 + so_0_cross;
  const double so_1a = D->m23 * a_0, so_1a_cross2 = D->m23 * a_0_lo, so_1b = D->m03 * a_2,
      so_1b_cross2 = D->m03 * a_2_lo, so_1 = so_1a - so_1b, so_1_right = so_1a - so_1,
      so_1_left = so_1 + so_1_right,
      so_1_left_rest = ksl_product_rest(D->m23, a_0, so_1a, so_1_left),
      so_1_right_rest = ksl_product_rest(D->m03, a_2, so_1b, so_1_right),
      so_1_cross = so_1a_cross2 - so_1b_cross2, so_1_lo1 = so_1_left_rest - so_1_right_rest,
      so_1_lo = so_1_lo1 + so_1_cross;
  const double so_2a = D->m03 * a_1, so_2a_cross2 = D->m03 * a_1_lo, so_2b = D->m13 * a_0,
      so_2b_cross2 = D->m13 * a_0_lo, so_2 = so_2a - so_2b, so_2_right = so_2a - so_2,
      so_2_left = so_2 + so_2_right,
      so_2_left_rest = ksl_product_rest(D->m03, a_1, so_2a, so_2_left),
      so_2_right_rest = ksl_product_rest(D->m13, a_0, so_2b, so_2_right),
      so_2_cross = so_2a_cross2 - so_2b_cross2, so_2_lo1 = so_2_left_rest - so_2_right_rest,
      so_2_lo = so_2_lo1 + so_2_cross;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  const double a_0_rounded = a_0 + a_0_lo;
  const double a_1_rounded = a_1 + a_1_lo;
  const double a_2_rounded = a_2 + a_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = a_0_rounded;
  so->m4 = a_1_rounded;
  so->m5 = a_2_rounded;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsta_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0c_right = so_0c - so_0a, so_0c_left = so_0c - so_0c_right,
      so_0c_left_rest = ksl_product_rest(D->m00, axis->x, so_0a, so_0c_left),
      so_0c_right_rest = ksl_product_rest(D->m01, axis->y, so_0b, so_0c_right),
      so_0c_lo = so_0c_left_rest + so_0c_right_rest, so_0d = D->m02 * axis->z, so_0 = so_0c + so_0d,
      so_0_right = so_0 - so_0c, so_0_left = so_0 - so_0_right, so_0_left_rest = so_0c - so_0_left,
      so_0_right_rest = ksl_product_rest(D->m02, axis->z, so_0d, so_0_right),
      so_0_lo1 = so_0_left_rest + so_0_right_rest, so_0_lo = so_0_lo1 + so_0c_lo;
  const double so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1c_right = so_1c - so_1a, so_1c_left = so_1c - so_1c_right,
      so_1c_left_rest = ksl_product_rest(D->m10, axis->x, so_1a, so_1c_left),
      so_1c_right_rest = ksl_product_rest(D->m11, axis->y, so_1b, so_1c_right),
      so_1c_lo = so_1c_left_rest + so_1c_right_rest, so_1d = D->m12 * axis->z, so_1 = so_1c + so_1d,
      so_1_right = so_1 - so_1c, so_1_left = so_1 - so_1_right, so_1_left_rest = so_1c - so_1_left,
      so_1_right_rest = ksl_product_rest(D->m12, axis->z, so_1d, so_1_right),
      so_1_lo1 = so_1_left_rest + so_1_right_rest, so_1_lo = so_1_lo1 + so_1c_lo;
  const double so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2c_right = so_2c - so_2a, so_2c_left = so_2c - so_2c_right,
      so_2c_left_rest = ksl_product_rest(D->m20, axis->x, so_2a, so_2c_left),
      so_2c_right_rest = ksl_product_rest(D->m21, axis->y, so_2b, so_2c_right),
      so_2c_lo = so_2c_left_rest + so_2c_right_rest, so_2d = D->m22 * axis->z, so_2 = so_2c + so_2d,
      so_2_right = so_2 - so_2c, so_2_left = so_2 - so_2_right, so_2_left_rest = so_2c - so_2_left,
      so_2_right_rest = ksl_product_rest(D->m22, axis->z, so_2d, so_2_right),
      so_2_lo1 = so_2_left_rest + so_2_right_rest, so_2_lo = so_2_lo1 + so_2c_lo;
  const double so_0_rounded = so_0 + so_0_lo;
  const double so_1_rounded = so_1 + so_1_lo;
  const double so_2_rounded = so_2 + so_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_screwf_scale_accurate(ksl_screwf_t *self, const float a) {
  const double self_0_new = (double)self->m0 * (double)a;
  const double self_1_new = (double)self->m1 * (double)a;
  const double self_2_new = (double)self->m2 * (double)a;
  const double self_3_new = (double)self->m3 * (double)a;
  const double self_4_new = (double)self->m4 * (double)a;
  const double self_5_new = (double)self->m5 * (double)a;
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_ssf_accurate(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new_a = (double)a * (double)x->m0, y_0_new = y_0_new_a + (double)y->m0;
  const double y_1_new_a = (double)a * (double)x->m1, y_1_new = y_1_new_a + (double)y->m1;
  const double y_2_new_a = (double)a * (double)x->m2, y_2_new = y_2_new_a + (double)y->m2;
  const double y_3_new_a = (double)a * (double)x->m3, y_3_new = y_3_new_a + (double)y->m3;
  const double y_4_new_a = (double)a * (double)x->m4, y_4_new = y_4_new_a + (double)y->m4;
  const double y_5_new_a = (double)a * (double)x->m5, y_5_new = y_5_new_a + (double)y->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_ssf_accurate(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new = (double)x->m0 + (double)y->m0;
  const double y_1_new = (double)x->m1 + (double)y->m1;
  const double y_2_new = (double)x->m2 + (double)y->m2;
  const double y_3_new = (double)x->m3 + (double)y->m3;
  const double y_4_new = (double)x->m4 + (double)y->m4;
  const double y_5_new = (double)x->m5 + (double)y->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_ssf_accurate(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new = (double)y->m0 - (double)x->m0;
  const double y_1_new = (double)y->m1 - (double)x->m1;
  const double y_2_new = (double)y->m2 - (double)x->m2;
  const double y_3_new = (double)y->m3 - (double)x->m3;
  const double y_4_new = (double)y->m4 - (double)x->m4;
  const double y_5_new = (double)y->m5 - (double)x->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_asf_accurate(const float a, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = (double)a * (double)si->m0;
  const double so_1 = (double)a * (double)si->m1;
  const double so_2 = (double)a * (double)si->m2;
  const double so_3 = (double)a * (double)si->m3;
  const double so_4 = (double)a * (double)si->m4;
  const double so_5 = (double)a * (double)si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 + (double)s2->m0;
  const double so_1 = (double)s1->m1 + (double)s2->m1;
  const double so_2 = (double)s1->m2 + (double)s2->m2;
  const double so_3 = (double)s1->m3 + (double)s2->m3;
  const double so_4 = (double)s1->m4 + (double)s2->m4;
  const double so_5 = (double)s1->m5 + (double)s2->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 - (double)s2->m0;
  const double so_1 = (double)s1->m1 - (double)s2->m1;
  const double so_2 = (double)s1->m2 - (double)s2->m2;
  const double so_3 = (double)s1->m3 - (double)s2->m3;
  const double so_4 = (double)s1->m4 - (double)s2->m4;
  const double so_5 = (double)s1->m5 - (double)s2->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result| + (lin: 1/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_add_sstf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 + (double)s2->m0;
  const double so_1 = (double)s1->m1 + (double)s2->m1;
  const double so_2 = (double)s1->m2 + (double)s2->m2;
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)t->y * (double)si->m5, so_0b = (double)t->z * (double)si->m4,
      so_0c = so_0a - so_0b, so_0 = so_0c + (double)si->m0;
  const double so_1a = (double)t->z * (double)si->m3, so_1b = (double)t->x * (double)si->m5,
      so_1c = so_1a - so_1b, so_1 = so_1c + (double)si->m1;
  const double so_2a = (double)t->x * (double)si->m4, so_2b = (double)t->y * (double)si->m3,
      so_2c = so_2a - so_2b, so_2 = so_2c + (double)si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtinvsf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)t->z * (double)si->m4, so_0b = (double)t->y * (double)si->m5,
      so_0c = so_0a - so_0b, so_0 = so_0c + (double)si->m0;
  const double so_1a = (double)t->x * (double)si->m5, so_1b = (double)t->z * (double)si->m3,
      so_1c = so_1a - so_1b, so_1 = so_1c + (double)si->m1;
  const double so_2a = (double)t->y * (double)si->m3, so_2b = (double)t->x * (double)si->m4,
      so_2c = so_2a - so_2b, so_2 = so_2c + (double)si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsinvf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)t->z * (double)si->m4, so_0b = (double)t->y * (double)si->m5,
      so_0c = so_0a - so_0b, so_0 = so_0c - (double)si->m0;
  const double so_1a = (double)t->x * (double)si->m5, so_1b = (double)t->z * (double)si->m3,
      so_1c = so_1a - so_1b, so_1 = so_1c - (double)si->m1;
  const double so_2a = (double)t->y * (double)si->m3, so_2b = (double)t->x * (double)si->m4,
      so_2c = so_2a - so_2b, so_2 = so_2c - (double)si->m2;
  const double so_3 = -(double)si->m3;
  const double so_4 = -(double)si->m4;
  const double so_5 = -(double)si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)R->m00 * (double)si->m0, so_0b = (double)R->m01 * (double)si->m1,
      so_0c = so_0a + so_0b, so_0d = (double)R->m02 * (double)si->m2, so_0 = so_0c + so_0d;
  const double so_1a = (double)R->m10 * (double)si->m0, so_1b = (double)R->m11 * (double)si->m1,
      so_1c = so_1a + so_1b, so_1d = (double)R->m12 * (double)si->m2, so_1 = so_1c + so_1d;
  const double so_2a = (double)R->m20 * (double)si->m0, so_2b = (double)R->m21 * (double)si->m1,
      so_2c = so_2a + so_2b, so_2d = (double)R->m22 * (double)si->m2, so_2 = so_2c + so_2d;
  const double so_3a = (double)R->m00 * (double)si->m3, so_3b = (double)R->m01 * (double)si->m4,
      so_3c = so_3a + so_3b, so_3d = (double)R->m02 * (double)si->m5, so_3 = so_3c + so_3d;
  const double so_4a = (double)R->m10 * (double)si->m3, so_4b = (double)R->m11 * (double)si->m4,
      so_4c = so_4a + so_4b, so_4d = (double)R->m12 * (double)si->m5, so_4 = so_4c + so_4d;
  const double so_5a = (double)R->m20 * (double)si->m3, so_5b = (double)R->m21 * (double)si->m4,
      so_5c = so_5a + so_5b, so_5d = (double)R->m22 * (double)si->m5, so_5 = so_5c + so_5d;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrinvsf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)R->m00 * (double)si->m0, so_0b = (double)R->m10 * (double)si->m1,
      so_0c = so_0a + so_0b, so_0d = (double)R->m20 * (double)si->m2, so_0 = so_0c + so_0d;
  const double so_1a = (double)R->m01 * (double)si->m0, so_1b = (double)R->m11 * (double)si->m1,
      so_1c = so_1a + so_1b, so_1d = (double)R->m21 * (double)si->m2, so_1 = so_1c + so_1d;
  const double so_2a = (double)R->m02 * (double)si->m0, so_2b = (double)R->m12 * (double)si->m1,
      so_2c = so_2a + so_2b, so_2d = (double)R->m22 * (double)si->m2, so_2 = so_2c + so_2d;
  const double so_3a = (double)R->m00 * (double)si->m3, so_3b = (double)R->m10 * (double)si->m4,
      so_3c = so_3a + so_3b, so_3d = (double)R->m20 * (double)si->m5, so_3 = so_3c + so_3d;
  const double so_4a = (double)R->m01 * (double)si->m3, so_4b = (double)R->m11 * (double)si->m4,
      so_4c = so_4a + so_4b, so_4d = (double)R->m21 * (double)si->m5, so_4 = so_4c + so_4d;
  const double so_5a = (double)R->m02 * (double)si->m3, so_5b = (double)R->m12 * (double)si->m4,
      so_5c = so_5a + so_5b, so_5d = (double)R->m22 * (double)si->m5, so_5 = so_5c + so_5d;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsinvf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0a = (double)R->m00 * (double)si->m0, so_0b = (double)R->m01 * (double)si->m1,
      so_0c = so_0a + so_0b, so_0d = (double)R->m02 * (double)si->m2, so_0e = so_0c + so_0d,
      so_0 = -so_0e;
  const double so_1a = (double)R->m10 * (double)si->m0, so_1b = (double)R->m11 * (double)si->m1,
      so_1c = so_1a + so_1b, so_1d = (double)R->m12 * (double)si->m2, so_1e = so_1c + so_1d,
      so_1 = -so_1e;
  const double so_2a = (double)R->m20 * (double)si->m0, so_2b = (double)R->m21 * (double)si->m1,
      so_2c = so_2a + so_2b, so_2d = (double)R->m22 * (double)si->m2, so_2e = so_2c + so_2d,
      so_2 = -so_2e;
  const double so_3a = (double)R->m00 * (double)si->m3, so_3b = (double)R->m01 * (double)si->m4,
      so_3c = so_3a + so_3b, so_3d = (double)R->m02 * (double)si->m5, so_3e = so_3c + so_3d,
      so_3 = -so_3e;
  const double so_4a = (double)R->m10 * (double)si->m3, so_4b = (double)R->m11 * (double)si->m4,
      so_4c = so_4a + so_4b, so_4d = (double)R->m12 * (double)si->m5, so_4e = so_4c + so_4d,
      so_4 = -so_4e;
  const double so_5a = (double)R->m20 * (double)si->m3, so_5b = (double)R->m21 * (double)si->m4,
      so_5c = so_5a + so_5b, so_5d = (double)R->m22 * (double)si->m5, so_5e = so_5c + so_5d,
      so_5 = -so_5e;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0a = (double)D->m00 * (double)si->m0, w_0b = (double)D->m01 * (double)si->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)si->m2, w_0 = w_0c + w_0d;
  const double w_1a = (double)D->m10 * (double)si->m0, w_1b = (double)D->m11 * (double)si->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)si->m2, w_1 = w_1c + w_1d;
  const double w_2a = (double)D->m20 * (double)si->m0, w_2b = (double)D->m21 * (double)si->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)si->m2, w_2 = w_2c + w_2d;
  const double w_3a = (double)D->m00 * (double)si->m3, w_3b = (double)D->m01 * (double)si->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)si->m5, w_3 = w_3c + w_3d;
  const double w_4a = (double)D->m10 * (double)si->m3, w_4b = (double)D->m11 * (double)si->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)si->m5, w_4 = w_4c + w_4d;
  const double w_5a = (double)D->m20 * (double)si->m3, w_5b = (double)D->m21 * (double)si->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)si->m5, w_5 = w_5c + w_5d;
  const double so_0a = (double)D->m13 * w_5, so_0b = (double)D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = (double)D->m23 * w_3, so_1b = (double)D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = (double)D->m03 * w_4, so_2b = (double)D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)w_3;
  so->m4 = (float)w_4;
  so->m5 = (float)w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adinvsf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0a = (double)D->m23 * (double)si->m4, w_0b = (double)D->m13 * (double)si->m5,
      w_0c = w_0a - w_0b, w_0 = w_0c + (double)si->m0;
  const double w_1a = (double)D->m03 * (double)si->m5, w_1b = (double)D->m23 * (double)si->m3,
      w_1c = w_1a - w_1b, w_1 = w_1c + (double)si->m1;
  const double w_2a = (double)D->m13 * (double)si->m3, w_2b = (double)D->m03 * (double)si->m4,
      w_2c = w_2a - w_2b, w_2 = w_2c + (double)si->m2;
  const double so_0a = (double)D->m00 * w_0, so_0b = (double)D->m10 * w_1, so_0c = so_0a + so_0b,
      so_0d = (double)D->m20 * w_2, so_0 = so_0c + so_0d;
  const double so_1a = (double)D->m01 * w_0, so_1b = (double)D->m11 * w_1, so_1c = so_1a + so_1b,
      so_1d = (double)D->m21 * w_2, so_1 = so_1c + so_1d;
  const double so_2a = (double)D->m02 * w_0, so_2b = (double)D->m12 * w_1, so_2c = so_2a + so_2b,
      so_2d = (double)D->m22 * w_2, so_2 = so_2c + so_2d;
  const double so_3a = (double)D->m00 * (double)si->m3, so_3b = (double)D->m10 * (double)si->m4,
      so_3c = so_3a + so_3b, so_3d = (double)D->m20 * (double)si->m5, so_3 = so_3c + so_3d;
  const double so_4a = (double)D->m01 * (double)si->m3, so_4b = (double)D->m11 * (double)si->m4,
      so_4c = so_4a + so_4b, so_4d = (double)D->m21 * (double)si->m5, so_4 = so_4c + so_4d;
  const double so_5a = (double)D->m02 * (double)si->m3, so_5b = (double)D->m12 * (double)si->m4,
      so_5c = so_5a + so_5b, so_5d = (double)D->m22 * (double)si->m5, so_5 = so_5c + so_5d;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsinvf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0a = (double)D->m00 * (double)si->m0, w_0b = (double)D->m01 * (double)si->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)si->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = (double)D->m10 * (double)si->m0, w_1b = (double)D->m11 * (double)si->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)si->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = (double)D->m20 * (double)si->m0, w_2b = (double)D->m21 * (double)si->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)si->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = (double)D->m00 * (double)si->m3, w_3b = (double)D->m01 * (double)si->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)si->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = (double)D->m10 * (double)si->m3, w_4b = (double)D->m11 * (double)si->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)si->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = (double)D->m20 * (double)si->m3, w_5b = (double)D->m21 * (double)si->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)si->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double so_0a = (double)D->m13 * w_5, so_0b = (double)D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = (double)D->m23 * w_3, so_1b = (double)D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = (double)D->m03 * w_4, so_2b = (double)D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)w_3;
  so->m4 = (float)w_4;
  so->m5 = (float)w_5;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m20 * (double)D->m13, so_0b = (double)D->m10 * (double)D->m23,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m00 * (double)D->m23, so_1b = (double)D->m20 * (double)D->m03,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m10 * (double)D->m03, so_2b = (double)D->m00 * (double)D->m13,
      so_2 = so_2a - so_2b;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m21 * (double)D->m13, so_0b = (double)D->m11 * (double)D->m23,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m01 * (double)D->m23, so_1b = (double)D->m21 * (double)D->m03,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m11 * (double)D->m03, so_2b = (double)D->m01 * (double)D->m13,
      so_2 = so_2a - so_2b;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m22 * (double)D->m13, so_0b = (double)D->m12 * (double)D->m23,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m02 * (double)D->m23, so_1b = (double)D->m22 * (double)D->m03,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m12 * (double)D->m03, so_2b = (double)D->m02 * (double)D->m13,
      so_2 = so_2a - so_2b;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m10 * (double)D->m23, so_0b = (double)D->m20 * (double)D->m13,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m20 * (double)D->m03, so_1b = (double)D->m00 * (double)D->m23,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m00 * (double)D->m13, so_2b = (double)D->m10 * (double)D->m03,
      so_2 = so_2a - so_2b;
  const double so_3 = -(double)D->m00;
  const double so_4 = -(double)D->m10;
  const double so_5 = -(double)D->m20;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m11 * (double)D->m23, so_0b = (double)D->m21 * (double)D->m13,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m21 * (double)D->m03, so_1b = (double)D->m01 * (double)D->m23,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m01 * (double)D->m13, so_2b = (double)D->m11 * (double)D->m03,
      so_2 = so_2a - so_2b;
  const double so_3 = -(double)D->m01;
  const double so_4 = -(double)D->m11;
  const double so_5 = -(double)D->m21;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0a = (double)D->m12 * (double)D->m23, so_0b = (double)D->m22 * (double)D->m13,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m22 * (double)D->m03, so_1b = (double)D->m02 * (double)D->m23,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m02 * (double)D->m13, so_2b = (double)D->m12 * (double)D->m03,
      so_2 = so_2a - so_2b;
  const double so_3 = -(double)D->m02;
  const double so_4 = -(double)D->m12;
  const double so_5 = -(double)D->m22;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_Adf_accurate(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const double M_03a = (double)D->m20 * (double)D->m13, M_03b = (double)D->m10 * (double)D->m23,
      M_03 = M_03a - M_03b;
  const double M_04a = (double)D->m21 * (double)D->m13, M_04b = (double)D->m11 * (double)D->m23,
      M_04 = M_04a - M_04b;
  const double M_05a = (double)D->m22 * (double)D->m13, M_05b = (double)D->m12 * (double)D->m23,
      M_05 = M_05a - M_05b;
  const double M_13a = (double)D->m00 * (double)D->m23, M_13b = (double)D->m20 * (double)D->m03,
      M_13 = M_13a - M_13b;
  const double M_14a = (double)D->m01 * (double)D->m23, M_14b = (double)D->m21 * (double)D->m03,
      M_14 = M_14a - M_14b;
  const double M_15a = (double)D->m02 * (double)D->m23, M_15b = (double)D->m22 * (double)D->m03,
      M_15 = M_15a - M_15b;
  const double M_23a = (double)D->m10 * (double)D->m03, M_23b = (double)D->m00 * (double)D->m13,
      M_23 = M_23a - M_23b;
  const double M_24a = (double)D->m11 * (double)D->m03, M_24b = (double)D->m01 * (double)D->m13,
      M_24 = M_24a - M_24b;
  const double M_25a = (double)D->m12 * (double)D->m03, M_25b = (double)D->m02 * (double)D->m13,
      M_25 = M_25a - M_25b;
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
  M->at[3][0] = (float)M_03;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)M_14;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)M_25;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_csf_accurate(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const double power_a = (double)c->m0 * (double)s->m0, power_b = (double)c->m1 * (double)s->m1,
      power_c = power_a + power_b, power_d = (double)c->m2 * (double)s->m2,
      power_e = power_c + power_d, power_f = (double)c->m3 * (double)s->m3,
      power_g = (double)c->m4 * (double)s->m4, power_h = power_f + power_g,
      power_i = (double)c->m5 * (double)s->m5, power_j = power_h + power_i,
      power = power_e + power_j;
  return (float)power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 3/32, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0a = (double)s1->m1 * (double)s2->m5, so_0b = (double)s1->m5 * (double)s2->m1,
      so_0c = so_0a - so_0b, so_0d = (double)s1->m4 * (double)s2->m2,
      so_0e = (double)s1->m2 * (double)s2->m4, so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const double so_1a = (double)s1->m5 * (double)s2->m0, so_1b = (double)s1->m0 * (double)s2->m5,
      so_1c = so_1a - so_1b, so_1d = (double)s1->m2 * (double)s2->m3,
      so_1e = (double)s1->m3 * (double)s2->m2, so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const double so_2a = (double)s1->m0 * (double)s2->m4, so_2b = (double)s1->m4 * (double)s2->m0,
      so_2c = so_2a - so_2b, so_2d = (double)s1->m3 * (double)s2->m1,
      so_2e = (double)s1->m1 * (double)s2->m3, so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const double so_3a = (double)s1->m4 * (double)s2->m5, so_3b = (double)s1->m5 * (double)s2->m4,
      so_3 = so_3a - so_3b;
  const double so_4a = (double)s1->m5 * (double)s2->m3, so_4b = (double)s1->m3 * (double)s2->m5,
      so_4 = so_4a - so_4b;
  const double so_5a = (double)s1->m3 * (double)s2->m4, so_5b = (double)s1->m4 * (double)s2->m3,
      so_5 = so_5a - so_5b;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sstf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0a = (double)s1->m4 * (double)s2->m2, so_0b = (double)s1->m5 * (double)s2->m1,
      so_0 = so_0a - so_0b;
  const double so_1a = (double)s1->m5 * (double)s2->m0, so_1b = (double)s1->m3 * (double)s2->m2,
      so_1 = so_1a - so_1b;
  const double so_2a = (double)s1->m3 * (double)s2->m1, so_2b = (double)s1->m4 * (double)s2->m0,
      so_2 = so_2a - so_2b;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)0.0;
  so->m4 = (float)0.0;
  so->m5 = (float)0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 5/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsraf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double a_0a = (double)D->m00 * (double)axis->x, a_0b = (double)D->m01 * (double)axis->y,
      a_0c = a_0a + a_0b, a_0d = (double)D->m02 * (double)axis->z, a_0 = a_0c + a_0d;
  const double a_1a = (double)D->m10 * (double)axis->x, a_1b = (double)D->m11 * (double)axis->y,
      a_1c = a_1a + a_1b, a_1d = (double)D->m12 * (double)axis->z, a_1 = a_1c + a_1d;
  const double a_2a = (double)D->m20 * (double)axis->x, a_2b = (double)D->m21 * (double)axis->y,
      a_2c = a_2a + a_2b, a_2d = (double)D->m22 * (double)axis->z, a_2 = a_2c + a_2d;
  const double so_0a = (double)D->m13 * a_2, so_0b = (double)D->m23 * a_1, so_0 = so_0a - so_0b;
  const double so_1a = (double)D->m23 * a_0, so_1b = (double)D->m03 * a_2, so_1 = so_1a - so_1b;
  const double so_2a = (double)D->m03 * a_1, so_2b = (double)D->m13 * a_0, so_2 = so_2a - so_2b;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)a_0;
  so->m4 = (float)a_1;
  so->m5 = (float)a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hstaf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double so_0a = (double)D->m00 * (double)axis->x, so_0b = (double)D->m01 * (double)axis->y,
      so_0c = so_0a + so_0b, so_0d = (double)D->m02 * (double)axis->z, so_0 = so_0c + so_0d;
  const double so_1a = (double)D->m10 * (double)axis->x, so_1b = (double)D->m11 * (double)axis->y,
      so_1c = so_1a + so_1b, so_1d = (double)D->m12 * (double)axis->z, so_1 = so_1c + so_1d;
  const double so_2a = (double)D->m20 * (double)axis->x, so_2b = (double)D->m21 * (double)axis->y,
      so_2c = so_2a + so_2b, so_2d = (double)D->m22 * (double)axis->z, so_2 = so_2c + so_2d;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)0.0;
  so->m4 = (float)0.0;
  so->m5 = (float)0.0;
}

#endif

/* Coscrews: wrenches and momenta, c = (f; τ).
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_COSCREW_ACCURATE_H
#define KSL_COSCREW_ACCURATE_H


/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale_accurate(ksl_coscrew_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  const double self_0_new_lo = ksl_product_error(self->m0, a, self_0_new),
      self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_lo = ksl_product_error(self->m1, a, self_1_new),
      self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_error(self->m2, a, self_2_new),
      self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_lo = ksl_product_error(self->m3, a, self_3_new),
      self_3_new_rounded = self_3_new + self_3_new_lo;
  const double self_4_new_lo = ksl_product_error(self->m4, a, self_4_new),
      self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_lo = ksl_product_error(self->m5, a, self_5_new),
      self_5_new_rounded = self_5_new + self_5_new_lo;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc_accurate(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0,
      y_0_new_right = y_0_new - y_0_new_a, y_0_new_left = y_0_new - y_0_new_right,
      y_0_new_left_rest = ksl_product_rest(a, x->m0, y_0_new_a, y_0_new_left),
      y_0_new_right_rest = y->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1,
      y_1_new_right = y_1_new - y_1_new_a, y_1_new_left = y_1_new - y_1_new_right,
      y_1_new_left_rest = ksl_product_rest(a, x->m1, y_1_new_a, y_1_new_left),
      y_1_new_right_rest = y->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2,
      y_2_new_right = y_2_new - y_2_new_a, y_2_new_left = y_2_new - y_2_new_right,
      y_2_new_left_rest = ksl_product_rest(a, x->m2, y_2_new_a, y_2_new_left),
      y_2_new_right_rest = y->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3,
      y_3_new_right = y_3_new - y_3_new_a, y_3_new_left = y_3_new - y_3_new_right,
      y_3_new_left_rest = ksl_product_rest(a, x->m3, y_3_new_a, y_3_new_left),
      y_3_new_right_rest = y->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest + y_3_new_right_rest;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4,
      y_4_new_right = y_4_new - y_4_new_a, y_4_new_left = y_4_new - y_4_new_right,
      y_4_new_left_rest = ksl_product_rest(a, x->m4, y_4_new_a, y_4_new_left),
      y_4_new_right_rest = y->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest + y_4_new_right_rest;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5,
      y_5_new_right = y_5_new - y_5_new_a, y_5_new_left = y_5_new - y_5_new_right,
      y_5_new_left_rest = ksl_product_rest(a, x->m5, y_5_new_a, y_5_new_left),
      y_5_new_right_rest = y->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest + y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = x->m0 + y->m0, y_0_new_right = y_0_new - x->m0,
      y_0_new_left = y_0_new - y_0_new_right, y_0_new_left_rest = x->m0 - y_0_new_left,
      y_0_new_right_rest = y->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new = x->m1 + y->m1, y_1_new_right = y_1_new - x->m1,
      y_1_new_left = y_1_new - y_1_new_right, y_1_new_left_rest = x->m1 - y_1_new_left,
      y_1_new_right_rest = y->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new = x->m2 + y->m2, y_2_new_right = y_2_new - x->m2,
      y_2_new_left = y_2_new - y_2_new_right, y_2_new_left_rest = x->m2 - y_2_new_left,
      y_2_new_right_rest = y->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_3_new = x->m3 + y->m3, y_3_new_right = y_3_new - x->m3,
      y_3_new_left = y_3_new - y_3_new_right, y_3_new_left_rest = x->m3 - y_3_new_left,
      y_3_new_right_rest = y->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest + y_3_new_right_rest;
  const double y_4_new = x->m4 + y->m4, y_4_new_right = y_4_new - x->m4,
      y_4_new_left = y_4_new - y_4_new_right, y_4_new_left_rest = x->m4 - y_4_new_left,
      y_4_new_right_rest = y->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest + y_4_new_right_rest;
  const double y_5_new = x->m5 + y->m5, y_5_new_right = y_5_new - x->m5,
      y_5_new_left = y_5_new - y_5_new_right, y_5_new_left_rest = x->m5 - y_5_new_left,
      y_5_new_right_rest = y->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest + y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = y->m0 - x->m0, y_0_new_right = y->m0 - y_0_new,
      y_0_new_left = y_0_new + y_0_new_right, y_0_new_left_rest = y->m0 - y_0_new_left,
      y_0_new_right_rest = x->m0 - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest - y_0_new_right_rest;
  const double y_1_new = y->m1 - x->m1, y_1_new_right = y->m1 - y_1_new,
      y_1_new_left = y_1_new + y_1_new_right, y_1_new_left_rest = y->m1 - y_1_new_left,
      y_1_new_right_rest = x->m1 - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest - y_1_new_right_rest;
  const double y_2_new = y->m2 - x->m2, y_2_new_right = y->m2 - y_2_new,
      y_2_new_left = y_2_new + y_2_new_right, y_2_new_left_rest = y->m2 - y_2_new_left,
      y_2_new_right_rest = x->m2 - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest - y_2_new_right_rest;
  const double y_3_new = y->m3 - x->m3, y_3_new_right = y->m3 - y_3_new,
      y_3_new_left = y_3_new + y_3_new_right, y_3_new_left_rest = y->m3 - y_3_new_left,
      y_3_new_right_rest = x->m3 - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest - y_3_new_right_rest;
  const double y_4_new = y->m4 - x->m4, y_4_new_right = y->m4 - y_4_new,
      y_4_new_left = y_4_new + y_4_new_right, y_4_new_left_rest = y->m4 - y_4_new_left,
      y_4_new_right_rest = x->m4 - y_4_new_right,
      y_4_new_lo = y_4_new_left_rest - y_4_new_right_rest;
  const double y_5_new = y->m5 - x->m5, y_5_new_right = y->m5 - y_5_new,
      y_5_new_left = y_5_new + y_5_new_right, y_5_new_left_rest = y->m5 - y_5_new_left,
      y_5_new_right_rest = x->m5 - y_5_new_right,
      y_5_new_lo = y_5_new_left_rest - y_5_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  const double y_4_new_rounded = y_4_new + y_4_new_lo;
  const double y_5_new_rounded = y_5_new + y_5_new_lo;
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ac_accurate(const double a, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = a * ci->m0;
  const double co_1 = a * ci->m1;
  const double co_2 = a * ci->m2;
  const double co_3 = a * ci->m3;
  const double co_4 = a * ci->m4;
  const double co_5 = a * ci->m5;
  const double co_0_lo = ksl_product_error(a, ci->m0, co_0), co_0_rounded = co_0 + co_0_lo;
  const double co_1_lo = ksl_product_error(a, ci->m1, co_1), co_1_rounded = co_1 + co_1_lo;
  const double co_2_lo = ksl_product_error(a, ci->m2, co_2), co_2_rounded = co_2 + co_2_lo;
  const double co_3_lo = ksl_product_error(a, ci->m3, co_3), co_3_rounded = co_3 + co_3_lo;
  const double co_4_lo = ksl_product_error(a, ci->m4, co_4), co_4_rounded = co_4 + co_4_lo;
  const double co_5_lo = ksl_product_error(a, ci->m5, co_5), co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_right = co_0 - c1->m0, co_0_left = co_0 - co_0_right,
      co_0_left_rest = c1->m0 - co_0_left, co_0_right_rest = c2->m0 - co_0_right,
      co_0_lo = co_0_left_rest + co_0_right_rest;
  const double co_1 = c1->m1 + c2->m1, co_1_right = co_1 - c1->m1, co_1_left = co_1 - co_1_right,
      co_1_left_rest = c1->m1 - co_1_left, co_1_right_rest = c2->m1 - co_1_right,
      co_1_lo = co_1_left_rest + co_1_right_rest;
  const double co_2 = c1->m2 + c2->m2, co_2_right = co_2 - c1->m2, co_2_left = co_2 - co_2_right,
      co_2_left_rest = c1->m2 - co_2_left, co_2_right_rest = c2->m2 - co_2_right,
      co_2_lo = co_2_left_rest + co_2_right_rest;
  const double co_3 = c1->m3 + c2->m3, co_3_right = co_3 - c1->m3, co_3_left = co_3 - co_3_right,
      co_3_left_rest = c1->m3 - co_3_left, co_3_right_rest = c2->m3 - co_3_right,
      co_3_lo = co_3_left_rest + co_3_right_rest;
  const double co_4 = c1->m4 + c2->m4, co_4_right = co_4 - c1->m4, co_4_left = co_4 - co_4_right,
      co_4_left_rest = c1->m4 - co_4_left, co_4_right_rest = c2->m4 - co_4_right,
      co_4_lo = co_4_left_rest + co_4_right_rest;
  const double co_5 = c1->m5 + c2->m5, co_5_right = co_5 - c1->m5, co_5_left = co_5 - co_5_right,
      co_5_left_rest = c1->m5 - co_5_left, co_5_right_rest = c2->m5 - co_5_right,
      co_5_lo = co_5_left_rest + co_5_right_rest;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0, co_0_right = c1->m0 - co_0, co_0_left = co_0 + co_0_right,
      co_0_left_rest = c1->m0 - co_0_left, co_0_right_rest = c2->m0 - co_0_right,
      co_0_lo = co_0_left_rest - co_0_right_rest;
  const double co_1 = c1->m1 - c2->m1, co_1_right = c1->m1 - co_1, co_1_left = co_1 + co_1_right,
      co_1_left_rest = c1->m1 - co_1_left, co_1_right_rest = c2->m1 - co_1_right,
      co_1_lo = co_1_left_rest - co_1_right_rest;
  const double co_2 = c1->m2 - c2->m2, co_2_right = c1->m2 - co_2, co_2_left = co_2 + co_2_right,
      co_2_left_rest = c1->m2 - co_2_left, co_2_right_rest = c2->m2 - co_2_right,
      co_2_lo = co_2_left_rest - co_2_right_rest;
  const double co_3 = c1->m3 - c2->m3, co_3_right = c1->m3 - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = c1->m3 - co_3_left, co_3_right_rest = c2->m3 - co_3_right,
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4 = c1->m4 - c2->m4, co_4_right = c1->m4 - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = c1->m4 - co_4_left, co_4_right_rest = c2->m4 - co_4_right,
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5 = c1->m5 - c2->m5, co_5_right = c1->m5 - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = c1->m5 - co_5_left, co_5_right_rest = c2->m5 - co_5_right,
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_right = co_0 - c1->m0, co_0_left = co_0 - co_0_right,
      co_0_left_rest = c1->m0 - co_0_left, co_0_right_rest = c2->m0 - co_0_right,
      co_0_lo = co_0_left_rest + co_0_right_rest;
  const double co_1 = c1->m1 + c2->m1, co_1_right = co_1 - c1->m1, co_1_left = co_1 - co_1_right,
      co_1_left_rest = c1->m1 - co_1_left, co_1_right_rest = c2->m1 - co_1_right,
      co_1_lo = co_1_left_rest + co_1_right_rest;
  const double co_2 = c1->m2 + c2->m2, co_2_right = co_2 - c1->m2, co_2_left = co_2 - co_2_right,
      co_2_left_rest = c1->m2 - co_2_left, co_2_right_rest = c2->m2 - co_2_right,
      co_2_lo = co_2_left_rest + co_2_right_rest;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->y * ci->m2, co_3b = t->z * ci->m1, co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(t->y, ci->m2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(t->z, ci->m1, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest - co_3c_right_rest, co_3 = co_3c + ci->m3,
      co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ci->m3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3c_lo;
  const double co_4a = t->z * ci->m0, co_4b = t->x * ci->m2, co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(t->z, ci->m0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(t->x, ci->m2, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest - co_4c_right_rest, co_4 = co_4c + ci->m4,
      co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ci->m4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4c_lo;
  const double co_5a = t->x * ci->m1, co_5b = t->y * ci->m0, co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(t->x, ci->m1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(t->y, ci->m0, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest - co_5c_right_rest, co_5 = co_5c + ci->m5,
      co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ci->m5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5c_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtinvc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(t->z, ci->m1, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(t->y, ci->m2, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest - co_3c_right_rest, co_3 = co_3c + ci->m3,
      co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ci->m3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3c_lo;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(t->x, ci->m2, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(t->z, ci->m0, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest - co_4c_right_rest, co_4 = co_4c + ci->m4,
      co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ci->m4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4c_lo;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(t->y, ci->m0, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(t->x, ci->m1, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest - co_5c_right_rest, co_5 = co_5c + ci->m5,
      co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ci->m5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5c_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcinv_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(t->z, ci->m1, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(t->y, ci->m2, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest - co_3c_right_rest, co_3 = co_3c - ci->m3,
      co_3_right = co_3c - co_3, co_3_left = co_3 + co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ci->m3 - co_3_right, co_3_lo1 = co_3_left_rest - co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3c_lo;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(t->x, ci->m2, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(t->z, ci->m0, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest - co_4c_right_rest, co_4 = co_4c - ci->m4,
      co_4_right = co_4c - co_4, co_4_left = co_4 + co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ci->m4 - co_4_right, co_4_lo1 = co_4_left_rest - co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4c_lo;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(t->y, ci->m0, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(t->x, ci->m1, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest - co_5c_right_rest, co_5 = co_5c - ci->m5,
      co_5_right = co_5c - co_5, co_5_left = co_5 + co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ci->m5 - co_5_right, co_5_lo1 = co_5_left_rest - co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5c_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0c_right = co_0c - co_0a, co_0c_left = co_0c - co_0c_right,
      co_0c_left_rest = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c_left),
      co_0c_right_rest = ksl_product_rest(R->m01, ci->m1, co_0b, co_0c_right),
      co_0c_lo = co_0c_left_rest + co_0c_right_rest, co_0d = R->m02 * ci->m2, co_0 = co_0c + co_0d,
      co_0_right = co_0 - co_0c, co_0_left = co_0 - co_0_right, co_0_left_rest = co_0c - co_0_left,
      co_0_right_rest = ksl_product_rest(R->m02, ci->m2, co_0d, co_0_right),
      co_0_lo1 = co_0_left_rest + co_0_right_rest, co_0_lo = co_0_lo1 + co_0c_lo;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1c_right = co_1c - co_1a, co_1c_left = co_1c - co_1c_right,
      co_1c_left_rest = ksl_product_rest(R->m10, ci->m0, co_1a, co_1c_left),
      co_1c_right_rest = ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right),
      co_1c_lo = co_1c_left_rest + co_1c_right_rest, co_1d = R->m12 * ci->m2, co_1 = co_1c + co_1d,
      co_1_right = co_1 - co_1c, co_1_left = co_1 - co_1_right, co_1_left_rest = co_1c - co_1_left,
      co_1_right_rest = ksl_product_rest(R->m12, ci->m2, co_1d, co_1_right),
      co_1_lo1 = co_1_left_rest + co_1_right_rest, co_1_lo = co_1_lo1 + co_1c_lo;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2c_right = co_2c - co_2a, co_2c_left = co_2c - co_2c_right,
      co_2c_left_rest = ksl_product_rest(R->m20, ci->m0, co_2a, co_2c_left),
      co_2c_right_rest = ksl_product_rest(R->m21, ci->m1, co_2b, co_2c_right),
      co_2c_lo = co_2c_left_rest + co_2c_right_rest, co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d,
      co_2_right = co_2 - co_2c, co_2_left = co_2 - co_2_right, co_2_left_rest = co_2c - co_2_left,
      co_2_right_rest = ksl_product_rest(R->m22, ci->m2, co_2d, co_2_right),
      co_2_lo1 = co_2_left_rest + co_2_right_rest, co_2_lo = co_2_lo1 + co_2c_lo;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3c_right = co_3c - co_3a, co_3c_left = co_3c - co_3c_right,
      co_3c_left_rest = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(R->m01, ci->m4, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest + co_3c_right_rest, co_3d = R->m02 * ci->m5, co_3 = co_3c + co_3d,
      co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ksl_product_rest(R->m02, ci->m5, co_3d, co_3_right),
      co_3_lo1 = co_3_left_rest + co_3_right_rest, co_3_lo = co_3_lo1 + co_3c_lo;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4c_right = co_4c - co_4a, co_4c_left = co_4c - co_4c_right,
      co_4c_left_rest = ksl_product_rest(R->m10, ci->m3, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest + co_4c_right_rest, co_4d = R->m12 * ci->m5, co_4 = co_4c + co_4d,
      co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ksl_product_rest(R->m12, ci->m5, co_4d, co_4_right),
      co_4_lo1 = co_4_left_rest + co_4_right_rest, co_4_lo = co_4_lo1 + co_4c_lo;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5c_right = co_5c - co_5a, co_5c_left = co_5c - co_5c_right,
      co_5c_left_rest = ksl_product_rest(R->m20, ci->m3, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(R->m21, ci->m4, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest + co_5c_right_rest, co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d,
      co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ksl_product_rest(R->m22, ci->m5, co_5d, co_5_right),
      co_5_lo1 = co_5_left_rest + co_5_right_rest, co_5_lo = co_5_lo1 + co_5c_lo;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrinvc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0c_right = co_0c - co_0a, co_0c_left = co_0c - co_0c_right,
      co_0c_left_rest = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c_left),
      co_0c_right_rest = ksl_product_rest(R->m10, ci->m1, co_0b, co_0c_right),
      co_0c_lo = co_0c_left_rest + co_0c_right_rest, co_0d = R->m20 * ci->m2, co_0 = co_0c + co_0d,
      co_0_right = co_0 - co_0c, co_0_left = co_0 - co_0_right, co_0_left_rest = co_0c - co_0_left,
      co_0_right_rest = ksl_product_rest(R->m20, ci->m2, co_0d, co_0_right),
      co_0_lo1 = co_0_left_rest + co_0_right_rest, co_0_lo = co_0_lo1 + co_0c_lo;
  const double co_1a = R->m01 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1c_right = co_1c - co_1a, co_1c_left = co_1c - co_1c_right,
      co_1c_left_rest = ksl_product_rest(R->m01, ci->m0, co_1a, co_1c_left),
      co_1c_right_rest = ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right),
      co_1c_lo = co_1c_left_rest + co_1c_right_rest, co_1d = R->m21 * ci->m2, co_1 = co_1c + co_1d,
      co_1_right = co_1 - co_1c, co_1_left = co_1 - co_1_right, co_1_left_rest = co_1c - co_1_left,
      co_1_right_rest = ksl_product_rest(R->m21, ci->m2, co_1d, co_1_right),
      co_1_lo1 = co_1_left_rest + co_1_right_rest, co_1_lo = co_1_lo1 + co_1c_lo;
  const double co_2a = R->m02 * ci->m0, co_2b = R->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2c_right = co_2c - co_2a, co_2c_left = co_2c - co_2c_right,
      co_2c_left_rest = ksl_product_rest(R->m02, ci->m0, co_2a, co_2c_left),
      co_2c_right_rest = ksl_product_rest(R->m12, ci->m1, co_2b, co_2c_right),
      co_2c_lo = co_2c_left_rest + co_2c_right_rest, co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d,
      co_2_right = co_2 - co_2c, co_2_left = co_2 - co_2_right, co_2_left_rest = co_2c - co_2_left,
      co_2_right_rest = ksl_product_rest(R->m22, ci->m2, co_2d, co_2_right),
      co_2_lo1 = co_2_left_rest + co_2_right_rest, co_2_lo = co_2_lo1 + co_2c_lo;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m10 * ci->m4, co_3c = co_3a + co_3b,
      co_3c_right = co_3c - co_3a, co_3c_left = co_3c - co_3c_right,
      co_3c_left_rest = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(R->m10, ci->m4, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest + co_3c_right_rest, co_3d = R->m20 * ci->m5, co_3 = co_3c + co_3d,
      co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ksl_product_rest(R->m20, ci->m5, co_3d, co_3_right),
      co_3_lo1 = co_3_left_rest + co_3_right_rest, co_3_lo = co_3_lo1 + co_3c_lo;
  const double co_4a = R->m01 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4c_right = co_4c - co_4a, co_4c_left = co_4c - co_4c_right,
      co_4c_left_rest = ksl_product_rest(R->m01, ci->m3, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest + co_4c_right_rest, co_4d = R->m21 * ci->m5, co_4 = co_4c + co_4d,
      co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ksl_product_rest(R->m21, ci->m5, co_4d, co_4_right),
      co_4_lo1 = co_4_left_rest + co_4_right_rest, co_4_lo = co_4_lo1 + co_4c_lo;
  const double co_5a = R->m02 * ci->m3, co_5b = R->m12 * ci->m4, co_5c = co_5a + co_5b,
      co_5c_right = co_5c - co_5a, co_5c_left = co_5c - co_5c_right,
      co_5c_left_rest = ksl_product_rest(R->m02, ci->m3, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(R->m12, ci->m4, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest + co_5c_right_rest, co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d,
      co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ksl_product_rest(R->m22, ci->m5, co_5d, co_5_right),
      co_5_lo1 = co_5_left_rest + co_5_right_rest, co_5_lo = co_5_lo1 + co_5c_lo;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest, 12 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcinv_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0c_right = co_0c - co_0a, co_0c_left = co_0c - co_0c_right,
      co_0c_left_rest = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c_left),
      co_0c_right_rest = ksl_product_rest(R->m01, ci->m1, co_0b, co_0c_right),
      co_0c_lo = co_0c_left_rest + co_0c_right_rest, co_0d = R->m02 * ci->m2, co_0e = co_0c + co_0d,
      co_0e_right = co_0e - co_0c, co_0e_left = co_0e - co_0e_right,
      co_0e_left_rest = co_0c - co_0e_left,
      co_0e_right_rest = ksl_product_rest(R->m02, ci->m2, co_0d, co_0e_right),
      co_0e_lo1 = co_0e_left_rest + co_0e_right_rest, co_0e_lo = co_0e_lo1 + co_0c_lo,
      co_0 = -co_0e, co_0_lo = -co_0e_lo;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1c_right = co_1c - co_1a, co_1c_left = co_1c - co_1c_right,
      co_1c_left_rest = ksl_product_rest(R->m10, ci->m0, co_1a, co_1c_left),
      co_1c_right_rest = ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right),
      co_1c_lo = co_1c_left_rest + co_1c_right_rest, co_1d = R->m12 * ci->m2, co_1e = co_1c + co_1d,
      co_1e_right = co_1e - co_1c, co_1e_left = co_1e - co_1e_right,
      co_1e_left_rest = co_1c - co_1e_left,
      co_1e_right_rest = ksl_product_rest(R->m12, ci->m2, co_1d, co_1e_right),
      co_1e_lo1 = co_1e_left_rest + co_1e_right_rest, co_1e_lo = co_1e_lo1 + co_1c_lo,
      co_1 = -co_1e, co_1_lo = -co_1e_lo;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2c_right = co_2c - co_2a, co_2c_left = co_2c - co_2c_right,
      co_2c_left_rest = ksl_product_rest(R->m20, ci->m0, co_2a, co_2c_left),
      co_2c_right_rest = ksl_product_rest(R->m21, ci->m1, co_2b, co_2c_right),
      co_2c_lo = co_2c_left_rest + co_2c_right_rest, co_2d = R->m22 * ci->m2, co_2e = co_2c + co_2d,
      co_2e_right = co_2e - co_2c, co_2e_left = co_2e - co_2e_right,
      co_2e_left_rest = co_2c - co_2e_left,
      co_2e_right_rest = ksl_product_rest(R->m22, ci->m2, co_2d, co_2e_right),
      co_2e_lo1 = co_2e_left_rest + co_2e_right_rest, co_2e_lo = co_2e_lo1 + co_2c_lo,
      co_2 = -co_2e, co_2_lo = -co_2e_lo;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3c_right = co_3c - co_3a, co_3c_left = co_3c - co_3c_right,
      co_3c_left_rest = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(R->m01, ci->m4, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest + co_3c_right_rest, co_3d = R->m02 * ci->m5, co_3e = co_3c + co_3d,
      co_3e_right = co_3e - co_3c, co_3e_left = co_3e - co_3e_right,
      co_3e_left_rest = co_3c - co_3e_left,
      co_3e_right_rest = ksl_product_rest(R->m02, ci->m5, co_3d, co_3e_right),
      co_3e_lo1 = co_3e_left_rest + co_3e_right_rest, co_3e_lo = co_3e_lo1 + co_3c_lo,
      co_3 = -co_3e, co_3_lo = -co_3e_lo;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4c_right = co_4c - co_4a, co_4c_left = co_4c - co_4c_right,
      co_4c_left_rest = ksl_product_rest(R->m10, ci->m3, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest + co_4c_right_rest, co_4d = R->m12 * ci->m5, co_4e = co_4c + co_4d,
      co_4e_right = co_4e - co_4c, co_4e_left = co_4e - co_4e_right,
      co_4e_left_rest = co_4c - co_4e_left,
      co_4e_right_rest = ksl_product_rest(R->m12, ci->m5, co_4d, co_4e_right),
      co_4e_lo1 = co_4e_left_rest + co_4e_right_rest, co_4e_lo = co_4e_lo1 + co_4c_lo,
      co_4 = -co_4e, co_4_lo = -co_4e_lo;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5c_right = co_5c - co_5a, co_5c_left = co_5c - co_5c_right,
      co_5c_left_rest = ksl_product_rest(R->m20, ci->m3, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(R->m21, ci->m4, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest + co_5c_right_rest, co_5d = R->m22 * ci->m5, co_5e = co_5c + co_5d,
      co_5e_right = co_5e - co_5c, co_5e_left = co_5e - co_5e_right,
      co_5e_left_rest = co_5c - co_5e_left,
      co_5e_right_rest = ksl_product_rest(R->m22, ci->m5, co_5d, co_5e_right),
      co_5e_lo1 = co_5e_left_rest + co_5e_right_rest, co_5e_lo = co_5e_lo1 + co_5c_lo,
      co_5 = -co_5e, co_5_lo = -co_5e_lo;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   30 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, ci->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, ci->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * ci->m2, w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c, w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = ksl_product_rest(D->m02, ci->m2, w_0d, w_0_right),
      w_0_lo1 = w_0_left_rest + w_0_right_rest, w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, ci->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, ci->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * ci->m2, w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c, w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = ksl_product_rest(D->m12, ci->m2, w_1d, w_1_right),
      w_1_lo1 = w_1_left_rest + w_1_right_rest, w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, ci->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, ci->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * ci->m2, w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c, w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = ksl_product_rest(D->m22, ci->m2, w_2d, w_2_right),
      w_2_lo1 = w_2_left_rest + w_2_right_rest, w_2_lo = w_2_lo1 + w_2c_lo;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, ci->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, ci->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * ci->m5, w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c, w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ksl_product_rest(D->m02, ci->m5, w_3d, w_3_right),
      w_3_lo1 = w_3_left_rest + w_3_right_rest, w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, ci->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, ci->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * ci->m5, w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c, w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ksl_product_rest(D->m12, ci->m5, w_4d, w_4_right),
      w_4_lo1 = w_4_left_rest + w_4_right_rest, w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, ci->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, ci->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * ci->m5, w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c, w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ksl_product_rest(D->m22, ci->m5, w_5d, w_5_right),
      w_5_lo1 = w_5_left_rest + w_5_right_rest, w_5_lo = w_5_lo1 + w_5c_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   33 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdinvc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = D->m23 * ci->m1, w_3b = D->m13 * ci->m2, w_3c = w_3a - w_3b,
      w_3c_right = w_3a - w_3c, w_3c_left = w_3c + w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m23, ci->m1, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m13, ci->m2, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest - w_3c_right_rest, w_3 = w_3c + ci->m3, w_3_right = w_3 - w_3c,
      w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ci->m3 - w_3_right, w_3_lo1 = w_3_left_rest + w_3_right_rest,
      w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m03 * ci->m2, w_4b = D->m23 * ci->m0, w_4c = w_4a - w_4b,
      w_4c_right = w_4a - w_4c, w_4c_left = w_4c + w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m03, ci->m2, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m23, ci->m0, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest - w_4c_right_rest, w_4 = w_4c + ci->m4, w_4_right = w_4 - w_4c,
      w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ci->m4 - w_4_right, w_4_lo1 = w_4_left_rest + w_4_right_rest,
      w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m13 * ci->m0, w_5b = D->m03 * ci->m1, w_5c = w_5a - w_5b,
      w_5c_right = w_5a - w_5c, w_5c_left = w_5c + w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m13, ci->m0, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m03, ci->m1, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest - w_5c_right_rest, w_5 = w_5c + ci->m5, w_5_right = w_5 - w_5c,
      w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ci->m5 - w_5_right, w_5_lo1 = w_5_left_rest + w_5_right_rest,
      w_5_lo = w_5_lo1 + w_5c_lo;
  const double co_0a = D->m00 * ci->m0, co_0b = D->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0c_right = co_0c - co_0a, co_0c_left = co_0c - co_0c_right,
      co_0c_left_rest = ksl_product_rest(D->m00, ci->m0, co_0a, co_0c_left),
      co_0c_right_rest = ksl_product_rest(D->m10, ci->m1, co_0b, co_0c_right),
      co_0c_lo = co_0c_left_rest + co_0c_right_rest, co_0d = D->m20 * ci->m2, co_0 = co_0c + co_0d,
      co_0_right = co_0 - co_0c, co_0_left = co_0 - co_0_right, co_0_left_rest = co_0c - co_0_left,
      co_0_right_rest = ksl_product_rest(D->m20, ci->m2, co_0d, co_0_right),
      co_0_lo1 = co_0_left_rest + co_0_right_rest, co_0_lo = co_0_lo1 + co_0c_lo;
  const double co_1a = D->m01 * ci->m0, co_1b = D->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1c_right = co_1c - co_1a, co_1c_left = co_1c - co_1c_right,
      co_1c_left_rest = ksl_product_rest(D->m01, ci->m0, co_1a, co_1c_left),
      co_1c_right_rest = ksl_product_rest(D->m11, ci->m1, co_1b, co_1c_right),
      co_1c_lo = co_1c_left_rest + co_1c_right_rest, co_1d = D->m21 * ci->m2, co_1 = co_1c + co_1d,
      co_1_right = co_1 - co_1c, co_1_left = co_1 - co_1_right, co_1_left_rest = co_1c - co_1_left,
      co_1_right_rest = ksl_product_rest(D->m21, ci->m2, co_1d, co_1_right),
      co_1_lo1 = co_1_left_rest + co_1_right_rest, co_1_lo = co_1_lo1 + co_1c_lo;
  const double co_2a = D->m02 * ci->m0, co_2b = D->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2c_right = co_2c - co_2a, co_2c_left = co_2c - co_2c_right,
      co_2c_left_rest = ksl_product_rest(D->m02, ci->m0, co_2a, co_2c_left),
      co_2c_right_rest = ksl_product_rest(D->m12, ci->m1, co_2b, co_2c_right),
      co_2c_lo = co_2c_left_rest + co_2c_right_rest, co_2d = D->m22 * ci->m2, co_2 = co_2c + co_2d,
      co_2_right = co_2 - co_2c, co_2_left = co_2 - co_2_right, co_2_left_rest = co_2c - co_2_left,
      co_2_right_rest = ksl_product_rest(D->m22, ci->m2, co_2d, co_2_right),
      co_2_lo1 = co_2_left_rest + co_2_right_rest, co_2_lo = co_2_lo1 + co_2c_lo;
  const double co_3a = D->m00 * w_3, co_3a_cross2 = D->m00 * w_3_lo, co_3b = D->m10 * w_4,
      co_3b_cross2 = D->m10 * w_4_lo, co_3c = co_3a + co_3b, co_3c_right = co_3c - co_3a,
      co_3c_left = co_3c - co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m00, w_3, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m10, w_4, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 + co_3b_cross2, co_3c_lo1 = co_3c_left_rest + co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3d = D->m20 * w_5, co_3d_cross2 = D->m20 * w_5_lo,
      co_3 = co_3c + co_3d, co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right,
      co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = ksl_product_rest(D->m20, w_5, co_3d, co_3_right),
      co_3_lo1 = co_3_left_rest + co_3_right_rest, co_3_lo2 = co_3_lo1 + co_3d_cross2,
      co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m01 * w_3, co_4a_cross2 = D->m01 * w_3_lo, co_4b = D->m11 * w_4,
      co_4b_cross2 = D->m11 * w_4_lo, co_4c = co_4a + co_4b, co_4c_right = co_4c - co_4a,
      co_4c_left = co_4c - co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m01, w_3, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m11, w_4, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 + co_4b_cross2, co_4c_lo1 = co_4c_left_rest + co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4d = D->m21 * w_5, co_4d_cross2 = D->m21 * w_5_lo,
      co_4 = co_4c + co_4d, co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right,
      co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = ksl_product_rest(D->m21, w_5, co_4d, co_4_right),
      co_4_lo1 = co_4_left_rest + co_4_right_rest, co_4_lo2 = co_4_lo1 + co_4d_cross2,
      co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m02 * w_3, co_5a_cross2 = D->m02 * w_3_lo, co_5b = D->m12 * w_4,
      co_5b_cross2 = D->m12 * w_4_lo, co_5c = co_5a + co_5b, co_5c_right = co_5c - co_5a,
      co_5c_left = co_5c - co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m02, w_3, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m12, w_4, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 + co_5b_cross2, co_5c_lo1 = co_5c_left_rest + co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5d = D->m22 * w_5, co_5d_cross2 = D->m22 * w_5_lo,
      co_5 = co_5c + co_5d, co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right,
      co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = ksl_product_rest(D->m22, w_5, co_5d, co_5_right),
      co_5_lo1 = co_5_left_rest + co_5_right_rest, co_5_lo2 = co_5_lo1 + co_5d_cross2,
      co_5_lo = co_5_lo2 + co_5c_lo;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   30 mul, 108 add, 24 product rest, 12 neg.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcinv_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, ci->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, ci->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * ci->m2, w_0e = w_0c + w_0d,
      w_0e_right = w_0e - w_0c, w_0e_left = w_0e - w_0e_right, w_0e_left_rest = w_0c - w_0e_left,
      w_0e_right_rest = ksl_product_rest(D->m02, ci->m2, w_0d, w_0e_right),
      w_0e_lo1 = w_0e_left_rest + w_0e_right_rest, w_0e_lo = w_0e_lo1 + w_0c_lo, w_0 = -w_0e,
      w_0_lo = -w_0e_lo;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, ci->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, ci->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * ci->m2, w_1e = w_1c + w_1d,
      w_1e_right = w_1e - w_1c, w_1e_left = w_1e - w_1e_right, w_1e_left_rest = w_1c - w_1e_left,
      w_1e_right_rest = ksl_product_rest(D->m12, ci->m2, w_1d, w_1e_right),
      w_1e_lo1 = w_1e_left_rest + w_1e_right_rest, w_1e_lo = w_1e_lo1 + w_1c_lo, w_1 = -w_1e,
      w_1_lo = -w_1e_lo;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, ci->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, ci->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * ci->m2, w_2e = w_2c + w_2d,
      w_2e_right = w_2e - w_2c, w_2e_left = w_2e - w_2e_right, w_2e_left_rest = w_2c - w_2e_left,
      w_2e_right_rest = ksl_product_rest(D->m22, ci->m2, w_2d, w_2e_right),
      w_2e_lo1 = w_2e_left_rest + w_2e_right_rest, w_2e_lo = w_2e_lo1 + w_2c_lo, w_2 = -w_2e,
      w_2_lo = -w_2e_lo;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, ci->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, ci->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * ci->m5, w_3e = w_3c + w_3d,
      w_3e_right = w_3e - w_3c, w_3e_left = w_3e - w_3e_right, w_3e_left_rest = w_3c - w_3e_left,
      w_3e_right_rest = ksl_product_rest(D->m02, ci->m5, w_3d, w_3e_right),
      w_3e_lo1 = w_3e_left_rest + w_3e_right_rest, w_3e_lo = w_3e_lo1 + w_3c_lo, w_3 = -w_3e,
      w_3_lo = -w_3e_lo;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, ci->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, ci->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * ci->m5, w_4e = w_4c + w_4d,
      w_4e_right = w_4e - w_4c, w_4e_left = w_4e - w_4e_right, w_4e_left_rest = w_4c - w_4e_left,
      w_4e_right_rest = ksl_product_rest(D->m12, ci->m5, w_4d, w_4e_right),
      w_4e_lo1 = w_4e_left_rest + w_4e_right_rest, w_4e_lo = w_4e_lo1 + w_4c_lo, w_4 = -w_4e,
      w_4_lo = -w_4e_lo;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, ci->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, ci->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * ci->m5, w_5e = w_5c + w_5d,
      w_5e_right = w_5e - w_5c, w_5e_left = w_5e - w_5e_right, w_5e_left_rest = w_5c - w_5e_left,
      w_5e_right_rest = ksl_product_rest(D->m22, ci->m5, w_5d, w_5e_right),
      w_5e_lo1 = w_5e_left_rest + w_5e_right_rest, w_5e_lo = w_5e_lo1 + w_5c_lo, w_5 = -w_5e,
      w_5_lo = -w_5e_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctx_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m20 * D->m13, co_3b = D->m10 * D->m23, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m20, D->m13, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m10, D->m23, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m00 * D->m23, co_4b = D->m20 * D->m03, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m00, D->m23, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m20, D->m03, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m10 * D->m03, co_5b = D->m00 * D->m13, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m10, D->m03, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m00, D->m13, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hcty_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m21 * D->m13, co_3b = D->m11 * D->m23, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m21, D->m13, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m11, D->m23, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m01 * D->m23, co_4b = D->m21 * D->m03, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m01, D->m23, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m21, D->m03, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m11 * D->m03, co_5b = D->m01 * D->m13, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m11, D->m03, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m01, D->m13, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctz_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m22 * D->m13, co_3b = D->m12 * D->m23, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m22, D->m13, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m12, D->m23, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m02 * D->m23, co_4b = D->m22 * D->m03, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m02, D->m23, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m22, D->m03, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m12 * D->m03, co_5b = D->m02 * D->m13, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m12, D->m03, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m02, D->m13, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = D->m10 * D->m23, co_3b = D->m20 * D->m13, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m10, D->m23, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m20, D->m13, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m20 * D->m03, co_4b = D->m00 * D->m23, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m20, D->m03, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m00, D->m23, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m00 * D->m13, co_5b = D->m10 * D->m03, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m00, D->m13, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m10, D->m03, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = D->m11 * D->m23, co_3b = D->m21 * D->m13, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m11, D->m23, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m21, D->m13, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m21 * D->m03, co_4b = D->m01 * D->m23, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m21, D->m03, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m01, D->m23, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m01 * D->m13, co_5b = D->m11 * D->m03, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m01, D->m13, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m11, D->m03, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = D->m12 * D->m23, co_3b = D->m22 * D->m13, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m12, D->m23, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m22, D->m13, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = D->m22 * D->m03, co_4b = D->m02 * D->m23, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m22, D->m03, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m02, D->m23, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = D->m02 * D->m13, co_5b = D->m12 * D->m03, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m02, D->m13, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m12, D->m03, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 45 add, 18 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = D->m20 * D->m13, M_30b = D->m10 * D->m23, M_30 = M_30a - M_30b,
      M_30_right = M_30a - M_30, M_30_left = M_30 + M_30_right,
      M_30_left_rest = ksl_product_rest(D->m20, D->m13, M_30a, M_30_left),
      M_30_right_rest = ksl_product_rest(D->m10, D->m23, M_30b, M_30_right),
      M_30_lo = M_30_left_rest - M_30_right_rest;
  const double M_31a = D->m21 * D->m13, M_31b = D->m11 * D->m23, M_31 = M_31a - M_31b,
      M_31_right = M_31a - M_31, M_31_left = M_31 + M_31_right,
      M_31_left_rest = ksl_product_rest(D->m21, D->m13, M_31a, M_31_left),
      M_31_right_rest = ksl_product_rest(D->m11, D->m23, M_31b, M_31_right),
      M_31_lo = M_31_left_rest - M_31_right_rest;
  const double M_32a = D->m22 * D->m13, M_32b = D->m12 * D->m23, M_32 = M_32a - M_32b,
      M_32_right = M_32a - M_32, M_32_left = M_32 + M_32_right,
      M_32_left_rest = ksl_product_rest(D->m22, D->m13, M_32a, M_32_left),
      M_32_right_rest = ksl_product_rest(D->m12, D->m23, M_32b, M_32_right),
      M_32_lo = M_32_left_rest - M_32_right_rest;
  const double M_40a = D->m00 * D->m23, M_40b = D->m20 * D->m03, M_40 = M_40a - M_40b,
      M_40_right = M_40a - M_40, M_40_left = M_40 + M_40_right,
      M_40_left_rest = ksl_product_rest(D->m00, D->m23, M_40a, M_40_left),
      M_40_right_rest = ksl_product_rest(D->m20, D->m03, M_40b, M_40_right),
      M_40_lo = M_40_left_rest - M_40_right_rest;
  const double M_41a = D->m01 * D->m23, M_41b = D->m21 * D->m03, M_41 = M_41a - M_41b,
      M_41_right = M_41a - M_41, M_41_left = M_41 + M_41_right,
      M_41_left_rest = ksl_product_rest(D->m01, D->m23, M_41a, M_41_left),
      M_41_right_rest = ksl_product_rest(D->m21, D->m03, M_41b, M_41_right),
      M_41_lo = M_41_left_rest - M_41_right_rest;
  const double M_42a = D->m02 * D->m23, M_42b = D->m22 * D->m03, M_42 = M_42a - M_42b,
      M_42_right = M_42a - M_42, M_42_left = M_42 + M_42_right,
      M_42_left_rest = ksl_product_rest(D->m02, D->m23, M_42a, M_42_left),
      M_42_right_rest = ksl_product_rest(D->m22, D->m03, M_42b, M_42_right),
      M_42_lo = M_42_left_rest - M_42_right_rest;
  const double M_50a = D->m10 * D->m03, M_50b = D->m00 * D->m13, M_50 = M_50a - M_50b,
      M_50_right = M_50a - M_50, M_50_left = M_50 + M_50_right,
      M_50_left_rest = ksl_product_rest(D->m10, D->m03, M_50a, M_50_left),
      M_50_right_rest = ksl_product_rest(D->m00, D->m13, M_50b, M_50_right),
      M_50_lo = M_50_left_rest - M_50_right_rest;
  const double M_51a = D->m11 * D->m03, M_51b = D->m01 * D->m13, M_51 = M_51a - M_51b,
      M_51_right = M_51a - M_51, M_51_left = M_51 + M_51_right,
      M_51_left_rest = ksl_product_rest(D->m11, D->m03, M_51a, M_51_left),
      M_51_right_rest = ksl_product_rest(D->m01, D->m13, M_51b, M_51_right),
      M_51_lo = M_51_left_rest - M_51_right_rest;
  const double M_52a = D->m12 * D->m03, M_52b = D->m02 * D->m13, M_52 = M_52a - M_52b,
      M_52_right = M_52a - M_52, M_52_left = M_52 + M_52_right,
      M_52_left_rest = ksl_product_rest(D->m12, D->m03, M_52a, M_52_left),
      M_52_right_rest = ksl_product_rest(D->m02, D->m13, M_52b, M_52_right),
      M_52_lo = M_52_left_rest - M_52_right_rest;
  const double M_30_rounded = M_30 + M_30_lo;
  const double M_31_rounded = M_31 + M_31_lo;
  const double M_32_rounded = M_32 + M_32_lo;
  const double M_40_rounded = M_40 + M_40_lo;
  const double M_41_rounded = M_41 + M_41_lo;
  const double M_42_rounded = M_42 + M_42_lo;
  const double M_50_rounded = M_50 + M_50_lo;
  const double M_51_rounded = M_51 + M_51_lo;
  const double M_52_rounded = M_52 + M_52_lo;
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
  M->at[0][3] = M_30_rounded;
  M->at[1][3] = M_31_rounded;
  M->at[2][3] = M_32_rounded;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40_rounded;
  M->at[1][4] = M_41_rounded;
  M->at[2][4] = M_42_rounded;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50_rounded;
  M->at[1][5] = M_51_rounded;
  M->at[2][5] = M_52_rounded;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 29 add, 6 product rest.
   Error <= u |result| + 19 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_reciprocal_product_accurate(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = c->m0 * x[3], power_b = c->m1 * x[4], power_c = power_a + power_b,
      power_c_right = power_c - power_a, power_c_left = power_c - power_c_right,
      power_c_left_rest = ksl_product_rest(c->m0, x[3], power_a, power_c_left),
      power_c_right_rest = ksl_product_rest(c->m1, x[4], power_b, power_c_right),
      power_c_lo = power_c_left_rest + power_c_right_rest, power_d = c->m2 * x[5],
      power_e = power_c + power_d, power_e_right = power_e - power_c,
      power_e_left = power_e - power_e_right, power_e_left_rest = power_c - power_e_left,
      power_e_right_rest = ksl_product_rest(c->m2, x[5], power_d, power_e_right),
      power_e_lo1 = power_e_left_rest + power_e_right_rest, power_e_lo = power_e_lo1 + power_c_lo,
      power_f = c->m3 * x[0], power_g = c->m4 * x[1], power_h = power_f + power_g,
      power_h_right = power_h - power_f, power_h_left = power_h - power_h_right,
      power_h_left_rest = ksl_product_rest(c->m3, x[0], power_f, power_h_left),
      power_h_right_rest = ksl_product_rest(c->m4, x[1], power_g, power_h_right),
      power_h_lo = power_h_left_rest + power_h_right_rest, power_i = c->m5 * x[2],
      power_j = power_h + power_i, power_j_right = power_j - power_h,
      power_j_left = power_j - power_j_right, power_j_left_rest = power_h - power_j_left,
      power_j_right_rest = ksl_product_rest(c->m5, x[2], power_i, power_j_right),
      power_j_lo1 = power_j_left_rest + power_j_right_rest, power_j_lo = power_j_lo1 + power_h_lo,
      power = power_e + power_j, power_right = power - power_e, power_left = power - power_right,
      power_left_rest = power_e - power_left, power_right_rest = power_j - power_right,
      power_lo1 = power_left_rest + power_right_rest, power_lo2 = power_lo1 + power_j_lo,
      power_lo = power_lo2 + power_e_lo;
  const double power_rounded = power + power_lo;
  return power_rounded;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + (lin: 6, ang: 12) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sc_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_0a = s->m4 * c->m2, co_0b = s->m5 * c->m1, co_0 = co_0a - co_0b,
      co_0_right = co_0a - co_0, co_0_left = co_0 + co_0_right,
      co_0_left_rest = ksl_product_rest(s->m4, c->m2, co_0a, co_0_left),
      co_0_right_rest = ksl_product_rest(s->m5, c->m1, co_0b, co_0_right),
      co_0_lo = co_0_left_rest - co_0_right_rest;
  const double co_1a = s->m5 * c->m0, co_1b = s->m3 * c->m2, co_1 = co_1a - co_1b,
      co_1_right = co_1a - co_1, co_1_left = co_1 + co_1_right,
      co_1_left_rest = ksl_product_rest(s->m5, c->m0, co_1a, co_1_left),
      co_1_right_rest = ksl_product_rest(s->m3, c->m2, co_1b, co_1_right),
      co_1_lo = co_1_left_rest - co_1_right_rest;
  const double co_2a = s->m3 * c->m1, co_2b = s->m4 * c->m0, co_2 = co_2a - co_2b,
      co_2_right = co_2a - co_2, co_2_left = co_2 + co_2_right,
      co_2_left_rest = ksl_product_rest(s->m3, c->m1, co_2a, co_2_left),
      co_2_right_rest = ksl_product_rest(s->m4, c->m0, co_2b, co_2_right),
      co_2_lo = co_2_left_rest - co_2_right_rest;
  const double co_3a = s->m1 * c->m2, co_3b = s->m2 * c->m1, co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(s->m1, c->m2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(s->m2, c->m1, co_3b, co_3c_right),
      co_3c_lo = co_3c_left_rest - co_3c_right_rest, co_3d = s->m4 * c->m5, co_3e = s->m5 * c->m4,
      co_3f = co_3d - co_3e, co_3f_right = co_3d - co_3f, co_3f_left = co_3f + co_3f_right,
      co_3f_left_rest = ksl_product_rest(s->m4, c->m5, co_3d, co_3f_left),
      co_3f_right_rest = ksl_product_rest(s->m5, c->m4, co_3e, co_3f_right),
      co_3f_lo = co_3f_left_rest - co_3f_right_rest, co_3 = co_3c + co_3f,
      co_3_right = co_3 - co_3c, co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = co_3f - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + co_3f_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = s->m2 * c->m0, co_4b = s->m0 * c->m2, co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(s->m2, c->m0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(s->m0, c->m2, co_4b, co_4c_right),
      co_4c_lo = co_4c_left_rest - co_4c_right_rest, co_4d = s->m5 * c->m3, co_4e = s->m3 * c->m5,
      co_4f = co_4d - co_4e, co_4f_right = co_4d - co_4f, co_4f_left = co_4f + co_4f_right,
      co_4f_left_rest = ksl_product_rest(s->m5, c->m3, co_4d, co_4f_left),
      co_4f_right_rest = ksl_product_rest(s->m3, c->m5, co_4e, co_4f_right),
      co_4f_lo = co_4f_left_rest - co_4f_right_rest, co_4 = co_4c + co_4f,
      co_4_right = co_4 - co_4c, co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = co_4f - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + co_4f_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = s->m0 * c->m1, co_5b = s->m1 * c->m0, co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(s->m0, c->m1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(s->m1, c->m0, co_5b, co_5c_right),
      co_5c_lo = co_5c_left_rest - co_5c_right_rest, co_5d = s->m3 * c->m4, co_5e = s->m4 * c->m3,
      co_5f = co_5d - co_5e, co_5f_right = co_5d - co_5f, co_5f_left = co_5f + co_5f_right,
      co_5f_left_rest = ksl_product_rest(s->m3, c->m4, co_5d, co_5f_left),
      co_5f_right_rest = ksl_product_rest(s->m4, c->m3, co_5e, co_5f_right),
      co_5f_lo = co_5f_left_rest - co_5f_right_rest, co_5 = co_5c + co_5f,
      co_5_right = co_5 - co_5c, co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = co_5f - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + co_5f_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double co_0_rounded = co_0 + co_0_lo;
  const double co_1_rounded = co_1 + co_1_lo;
  const double co_2_rounded = co_2 + co_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sca_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_3a = s->m4 * c->m5, co_3b = s->m5 * c->m4, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(s->m4, c->m5, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(s->m5, c->m4, co_3b, co_3_right),
      co_3_lo = co_3_left_rest - co_3_right_rest;
  const double co_4a = s->m5 * c->m3, co_4b = s->m3 * c->m5, co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(s->m5, c->m3, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(s->m3, c->m5, co_4b, co_4_right),
      co_4_lo = co_4_left_rest - co_4_right_rest;
  const double co_5a = s->m3 * c->m4, co_5b = s->m4 * c->m3, co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5, co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(s->m3, c->m4, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(s->m4, c->m3, co_5b, co_5_right),
      co_5_lo = co_5_left_rest - co_5_right_rest;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m01 * c->m1, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a, w_0_left = w_0 - w_0_right,
      w_0_left_rest = ksl_product_rest(D->m01, c->m1, w_0a, w_0_left),
      w_0_right_rest = ksl_product_rest(D->m02, c->m2, w_0b, w_0_right),
      w_0_lo = w_0_left_rest + w_0_right_rest;
  const double w_1a = D->m11 * c->m1, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a, w_1_left = w_1 - w_1_right,
      w_1_left_rest = ksl_product_rest(D->m11, c->m1, w_1a, w_1_left),
      w_1_right_rest = ksl_product_rest(D->m12, c->m2, w_1b, w_1_right),
      w_1_lo = w_1_left_rest + w_1_right_rest;
  const double w_2a = D->m21 * c->m1, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a, w_2_left = w_2 - w_2_right,
      w_2_left_rest = ksl_product_rest(D->m21, c->m1, w_2a, w_2_left),
      w_2_right_rest = ksl_product_rest(D->m22, c->m2, w_2b, w_2_right),
      w_2_lo = w_2_left_rest + w_2_right_rest;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, c->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c, w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ksl_product_rest(D->m02, c->m5, w_3d, w_3_right),
      w_3_lo1 = w_3_left_rest + w_3_right_rest, w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, c->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c, w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ksl_product_rest(D->m12, c->m5, w_4d, w_4_right),
      w_4_lo1 = w_4_left_rest + w_4_right_rest, w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, c->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c, w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ksl_product_rest(D->m22, c->m5, w_5d, w_5_right),
      w_5_lo1 = w_5_left_rest + w_5_right_rest, w_5_lo = w_5_lo1 + w_5c_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a, w_0_left = w_0 - w_0_right,
      w_0_left_rest = ksl_product_rest(D->m00, c->m0, w_0a, w_0_left),
      w_0_right_rest = ksl_product_rest(D->m02, c->m2, w_0b, w_0_right),
      w_0_lo = w_0_left_rest + w_0_right_rest;
  const double w_1a = D->m10 * c->m0, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a, w_1_left = w_1 - w_1_right,
      w_1_left_rest = ksl_product_rest(D->m10, c->m0, w_1a, w_1_left),
      w_1_right_rest = ksl_product_rest(D->m12, c->m2, w_1b, w_1_right),
      w_1_lo = w_1_left_rest + w_1_right_rest;
  const double w_2a = D->m20 * c->m0, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a, w_2_left = w_2 - w_2_right,
      w_2_left_rest = ksl_product_rest(D->m20, c->m0, w_2a, w_2_left),
      w_2_right_rest = ksl_product_rest(D->m22, c->m2, w_2b, w_2_right),
      w_2_lo = w_2_left_rest + w_2_right_rest;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, c->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c, w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ksl_product_rest(D->m02, c->m5, w_3d, w_3_right),
      w_3_lo1 = w_3_left_rest + w_3_right_rest, w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, c->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c, w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ksl_product_rest(D->m12, c->m5, w_4d, w_4_right),
      w_4_lo1 = w_4_left_rest + w_4_right_rest, w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, c->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c, w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ksl_product_rest(D->m22, c->m5, w_5d, w_5_right),
      w_5_lo1 = w_5_left_rest + w_5_right_rest, w_5_lo = w_5_lo1 + w_5c_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a, w_0_left = w_0 - w_0_right,
      w_0_left_rest = ksl_product_rest(D->m00, c->m0, w_0a, w_0_left),
      w_0_right_rest = ksl_product_rest(D->m01, c->m1, w_0b, w_0_right),
      w_0_lo = w_0_left_rest + w_0_right_rest;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a, w_1_left = w_1 - w_1_right,
      w_1_left_rest = ksl_product_rest(D->m10, c->m0, w_1a, w_1_left),
      w_1_right_rest = ksl_product_rest(D->m11, c->m1, w_1b, w_1_right),
      w_1_lo = w_1_left_rest + w_1_right_rest;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a, w_2_left = w_2 - w_2_right,
      w_2_left_rest = ksl_product_rest(D->m20, c->m0, w_2a, w_2_left),
      w_2_right_rest = ksl_product_rest(D->m21, c->m1, w_2b, w_2_right),
      w_2_lo = w_2_left_rest + w_2_right_rest;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3c_left = w_3c - w_3c_right,
      w_3c_left_rest = ksl_product_rest(D->m00, c->m3, w_3a, w_3c_left),
      w_3c_right_rest = ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right),
      w_3c_lo = w_3c_left_rest + w_3c_right_rest, w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c, w_3_left = w_3 - w_3_right, w_3_left_rest = w_3c - w_3_left,
      w_3_right_rest = ksl_product_rest(D->m02, c->m5, w_3d, w_3_right),
      w_3_lo1 = w_3_left_rest + w_3_right_rest, w_3_lo = w_3_lo1 + w_3c_lo;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4c_left = w_4c - w_4c_right,
      w_4c_left_rest = ksl_product_rest(D->m10, c->m3, w_4a, w_4c_left),
      w_4c_right_rest = ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right),
      w_4c_lo = w_4c_left_rest + w_4c_right_rest, w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c, w_4_left = w_4 - w_4_right, w_4_left_rest = w_4c - w_4_left,
      w_4_right_rest = ksl_product_rest(D->m12, c->m5, w_4d, w_4_right),
      w_4_lo1 = w_4_left_rest + w_4_right_rest, w_4_lo = w_4_lo1 + w_4c_lo;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5c_left = w_5c - w_5c_right,
      w_5c_left_rest = ksl_product_rest(D->m20, c->m3, w_5a, w_5c_left),
      w_5c_right_rest = ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right),
      w_5c_lo = w_5c_left_rest + w_5c_right_rest, w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c, w_5_left = w_5 - w_5_right, w_5_left_rest = w_5c - w_5_left,
      w_5_right_rest = ksl_product_rest(D->m22, c->m5, w_5d, w_5_right),
      w_5_lo1 = w_5_left_rest + w_5_right_rest, w_5_lo = w_5_lo1 + w_5c_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, c->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c, w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = ksl_product_rest(D->m02, c->m2, w_0d, w_0_right),
      w_0_lo1 = w_0_left_rest + w_0_right_rest, w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, c->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c, w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = ksl_product_rest(D->m12, c->m2, w_1d, w_1_right),
      w_1_lo1 = w_1_left_rest + w_1_right_rest, w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, c->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c, w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = ksl_product_rest(D->m22, c->m2, w_2d, w_2_right),
      w_2_lo1 = w_2_left_rest + w_2_right_rest, w_2_lo = w_2_lo1 + w_2c_lo;
  const double w_3a = D->m01 * c->m4, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a, w_3_left = w_3 - w_3_right,
      w_3_left_rest = ksl_product_rest(D->m01, c->m4, w_3a, w_3_left),
      w_3_right_rest = ksl_product_rest(D->m02, c->m5, w_3b, w_3_right),
      w_3_lo = w_3_left_rest + w_3_right_rest;
  const double w_4a = D->m11 * c->m4, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a, w_4_left = w_4 - w_4_right,
      w_4_left_rest = ksl_product_rest(D->m11, c->m4, w_4a, w_4_left),
      w_4_right_rest = ksl_product_rest(D->m12, c->m5, w_4b, w_4_right),
      w_4_lo = w_4_left_rest + w_4_right_rest;
  const double w_5a = D->m21 * c->m4, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a, w_5_left = w_5 - w_5_right,
      w_5_left_rest = ksl_product_rest(D->m21, c->m4, w_5a, w_5_left),
      w_5_right_rest = ksl_product_rest(D->m22, c->m5, w_5b, w_5_right),
      w_5_lo = w_5_left_rest + w_5_right_rest;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cry_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, c->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c, w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = ksl_product_rest(D->m02, c->m2, w_0d, w_0_right),
      w_0_lo1 = w_0_left_rest + w_0_right_rest, w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, c->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c, w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = ksl_product_rest(D->m12, c->m2, w_1d, w_1_right),
      w_1_lo1 = w_1_left_rest + w_1_right_rest, w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, c->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c, w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = ksl_product_rest(D->m22, c->m2, w_2d, w_2_right),
      w_2_lo1 = w_2_left_rest + w_2_right_rest, w_2_lo = w_2_lo1 + w_2c_lo;
  const double w_3a = D->m00 * c->m3, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a, w_3_left = w_3 - w_3_right,
      w_3_left_rest = ksl_product_rest(D->m00, c->m3, w_3a, w_3_left),
      w_3_right_rest = ksl_product_rest(D->m02, c->m5, w_3b, w_3_right),
      w_3_lo = w_3_left_rest + w_3_right_rest;
  const double w_4a = D->m10 * c->m3, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a, w_4_left = w_4 - w_4_right,
      w_4_left_rest = ksl_product_rest(D->m10, c->m3, w_4a, w_4_left),
      w_4_right_rest = ksl_product_rest(D->m12, c->m5, w_4b, w_4_right),
      w_4_lo = w_4_left_rest + w_4_right_rest;
  const double w_5a = D->m20 * c->m3, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a, w_5_left = w_5 - w_5_right,
      w_5_left_rest = ksl_product_rest(D->m20, c->m3, w_5a, w_5_left),
      w_5_right_rest = ksl_product_rest(D->m22, c->m5, w_5b, w_5_right),
      w_5_lo = w_5_left_rest + w_5_right_rest;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0c_left = w_0c - w_0c_right,
      w_0c_left_rest = ksl_product_rest(D->m00, c->m0, w_0a, w_0c_left),
      w_0c_right_rest = ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0c_lo = w_0c_left_rest + w_0c_right_rest, w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c, w_0_left = w_0 - w_0_right, w_0_left_rest = w_0c - w_0_left,
      w_0_right_rest = ksl_product_rest(D->m02, c->m2, w_0d, w_0_right),
      w_0_lo1 = w_0_left_rest + w_0_right_rest, w_0_lo = w_0_lo1 + w_0c_lo;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1c_left = w_1c - w_1c_right,
      w_1c_left_rest = ksl_product_rest(D->m10, c->m0, w_1a, w_1c_left),
      w_1c_right_rest = ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1c_lo = w_1c_left_rest + w_1c_right_rest, w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c, w_1_left = w_1 - w_1_right, w_1_left_rest = w_1c - w_1_left,
      w_1_right_rest = ksl_product_rest(D->m12, c->m2, w_1d, w_1_right),
      w_1_lo1 = w_1_left_rest + w_1_right_rest, w_1_lo = w_1_lo1 + w_1c_lo;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2c_left = w_2c - w_2c_right,
      w_2c_left_rest = ksl_product_rest(D->m20, c->m0, w_2a, w_2c_left),
      w_2c_right_rest = ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2c_lo = w_2c_left_rest + w_2c_right_rest, w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c, w_2_left = w_2 - w_2_right, w_2_left_rest = w_2c - w_2_left,
      w_2_right_rest = ksl_product_rest(D->m22, c->m2, w_2d, w_2_right),
      w_2_lo1 = w_2_left_rest + w_2_right_rest, w_2_lo = w_2_lo1 + w_2c_lo;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a, w_3_left = w_3 - w_3_right,
      w_3_left_rest = ksl_product_rest(D->m00, c->m3, w_3a, w_3_left),
      w_3_right_rest = ksl_product_rest(D->m01, c->m4, w_3b, w_3_right),
      w_3_lo = w_3_left_rest + w_3_right_rest;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a, w_4_left = w_4 - w_4_right,
      w_4_left_rest = ksl_product_rest(D->m10, c->m3, w_4a, w_4_left),
      w_4_right_rest = ksl_product_rest(D->m11, c->m4, w_4b, w_4_right),
      w_4_lo = w_4_left_rest + w_4_right_rest;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a, w_5_left = w_5 - w_5_right,
      w_5_left_rest = ksl_product_rest(D->m20, c->m3, w_5a, w_5_left),
      w_5_right_rest = ksl_product_rest(D->m21, c->m4, w_5b, w_5_right),
      w_5_lo = w_5_left_rest + w_5_right_rest;
  const double co_3a = D->m13 * w_2, co_3a_cross2 = D->m13 * w_2_lo, co_3b = D->m23 * w_1,
      co_3b_cross2 = D->m23 * w_1_lo, co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c,
      co_3c_left = co_3c + co_3c_right,
      co_3c_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3c_left),
      co_3c_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3c_right),
      co_3c_cross = co_3a_cross2 - co_3b_cross2, co_3c_lo1 = co_3c_left_rest - co_3c_right_rest,
      co_3c_lo = co_3c_lo1 + co_3c_cross, co_3 = co_3c + w_3, co_3_right = co_3 - co_3c,
      co_3_left = co_3 - co_3_right, co_3_left_rest = co_3c - co_3_left,
      co_3_right_rest = w_3 - co_3_right, co_3_lo1 = co_3_left_rest + co_3_right_rest,
      co_3_lo2 = co_3_lo1 + w_3_lo, co_3_lo = co_3_lo2 + co_3c_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2,
      co_4b_cross2 = D->m03 * w_2_lo, co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c,
      co_4c_left = co_4c + co_4c_right,
      co_4c_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4c_left),
      co_4c_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4c_right),
      co_4c_cross = co_4a_cross2 - co_4b_cross2, co_4c_lo1 = co_4c_left_rest - co_4c_right_rest,
      co_4c_lo = co_4c_lo1 + co_4c_cross, co_4 = co_4c + w_4, co_4_right = co_4 - co_4c,
      co_4_left = co_4 - co_4_right, co_4_left_rest = co_4c - co_4_left,
      co_4_right_rest = w_4 - co_4_right, co_4_lo1 = co_4_left_rest + co_4_right_rest,
      co_4_lo2 = co_4_lo1 + w_4_lo, co_4_lo = co_4_lo2 + co_4c_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c,
      co_5c_left = co_5c + co_5c_right,
      co_5c_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5c_left),
      co_5c_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5c_right),
      co_5c_cross = co_5a_cross2 - co_5b_cross2, co_5c_lo1 = co_5c_left_rest - co_5c_right_rest,
      co_5c_lo = co_5c_lo1 + co_5c_cross, co_5 = co_5c + w_5, co_5_right = co_5 - co_5c,
      co_5_left = co_5 - co_5_right, co_5_left_rest = co_5c - co_5_left,
      co_5_right_rest = w_5 - co_5_right, co_5_lo1 = co_5_left_rest + co_5_right_rest,
      co_5_lo2 = co_5_lo1 + w_5_lo, co_5_lo = co_5_lo2 + co_5c_lo;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m00 * c->m0;
  const double w_1 = D->m10 * c->m0;
  const double w_2 = D->m20 * c->m0;
  const double w_2_lo = ksl_product_error(D->m20, c->m0, w_2), co_3a = D->m13 * w_2,
      co_3a_cross2 = D->m13 * w_2_lo, w_1_lo = ksl_product_error(D->m10, c->m0, w_1),
      co_3b = D->m23 * w_1, co_3b_cross2 = D->m23 * w_1_lo, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3_right),
      co_3_cross = co_3a_cross2 - co_3b_cross2, co_3_lo1 = co_3_left_rest - co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3_cross;
  const double w_0_lo = ksl_product_error(D->m00, c->m0, w_0), co_4a = D->m23 * w_0,
      co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2, co_4b_cross2 = D->m03 * w_2_lo,
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4_right),
      co_4_cross = co_4a_cross2 - co_4b_cross2, co_4_lo1 = co_4_left_rest - co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4_cross;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5 = co_5a - co_5b, co_5_right = co_5a - co_5,
      co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5_right),
      co_5_cross = co_5a_cross2 - co_5b_cross2, co_5_lo1 = co_5_left_rest - co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5_cross;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m01 * c->m1;
  const double w_1 = D->m11 * c->m1;
  const double w_2 = D->m21 * c->m1;
  const double w_2_lo = ksl_product_error(D->m21, c->m1, w_2), co_3a = D->m13 * w_2,
      co_3a_cross2 = D->m13 * w_2_lo, w_1_lo = ksl_product_error(D->m11, c->m1, w_1),
      co_3b = D->m23 * w_1, co_3b_cross2 = D->m23 * w_1_lo, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3_right),
      co_3_cross = co_3a_cross2 - co_3b_cross2, co_3_lo1 = co_3_left_rest - co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3_cross;
  const double w_0_lo = ksl_product_error(D->m01, c->m1, w_0), co_4a = D->m23 * w_0,
      co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2, co_4b_cross2 = D->m03 * w_2_lo,
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4_right),
      co_4_cross = co_4a_cross2 - co_4b_cross2, co_4_lo1 = co_4_left_rest - co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4_cross;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5 = co_5a - co_5b, co_5_right = co_5a - co_5,
      co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5_right),
      co_5_cross = co_5a_cross2 - co_5b_cross2, co_5_lo1 = co_5_left_rest - co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5_cross;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m02 * c->m2;
  const double w_1 = D->m12 * c->m2;
  const double w_2 = D->m22 * c->m2;
  const double w_2_lo = ksl_product_error(D->m22, c->m2, w_2), co_3a = D->m13 * w_2,
      co_3a_cross2 = D->m13 * w_2_lo, w_1_lo = ksl_product_error(D->m12, c->m2, w_1),
      co_3b = D->m23 * w_1, co_3b_cross2 = D->m23 * w_1_lo, co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3, co_3_left = co_3 + co_3_right,
      co_3_left_rest = ksl_product_rest(D->m13, w_2, co_3a, co_3_left),
      co_3_right_rest = ksl_product_rest(D->m23, w_1, co_3b, co_3_right),
      co_3_cross = co_3a_cross2 - co_3b_cross2, co_3_lo1 = co_3_left_rest - co_3_right_rest,
      co_3_lo = co_3_lo1 + co_3_cross;
  const double w_0_lo = ksl_product_error(D->m02, c->m2, w_0), co_4a = D->m23 * w_0,
      co_4a_cross2 = D->m23 * w_0_lo, co_4b = D->m03 * w_2, co_4b_cross2 = D->m03 * w_2_lo,
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4, co_4_left = co_4 + co_4_right,
      co_4_left_rest = ksl_product_rest(D->m23, w_0, co_4a, co_4_left),
      co_4_right_rest = ksl_product_rest(D->m03, w_2, co_4b, co_4_right),
      co_4_cross = co_4a_cross2 - co_4b_cross2, co_4_lo1 = co_4_left_rest - co_4_right_rest,
      co_4_lo = co_4_lo1 + co_4_cross;
  const double co_5a = D->m03 * w_1, co_5a_cross2 = D->m03 * w_1_lo, co_5b = D->m13 * w_0,
      co_5b_cross2 = D->m13 * w_0_lo, co_5 = co_5a - co_5b, co_5_right = co_5a - co_5,
      co_5_left = co_5 + co_5_right,
      co_5_left_rest = ksl_product_rest(D->m03, w_1, co_5a, co_5_left),
      co_5_right_rest = ksl_product_rest(D->m13, w_0, co_5b, co_5_right),
      co_5_cross = co_5a_cross2 - co_5b_cross2, co_5_lo1 = co_5_left_rest - co_5_right_rest,
      co_5_lo = co_5_lo1 + co_5_cross;
  const double w_0_rounded = w_0 + w_0_lo;
  const double w_1_rounded = w_1 + w_1_lo;
  const double w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3 + co_3_lo;
  const double co_4_rounded = co_4 + co_4_lo;
  const double co_5_rounded = co_5 + co_5_lo;
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = D->m00 * c->m3;
  const double w_4 = D->m10 * c->m3;
  const double w_5 = D->m20 * c->m3;
  const double w_3_lo = ksl_product_error(D->m00, c->m3, w_3), w_3_rounded = w_3 + w_3_lo;
  const double w_4_lo = ksl_product_error(D->m10, c->m3, w_4), w_4_rounded = w_4 + w_4_lo;
  const double w_5_lo = ksl_product_error(D->m20, c->m3, w_5), w_5_rounded = w_5 + w_5_lo;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cry_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = D->m01 * c->m4;
  const double w_4 = D->m11 * c->m4;
  const double w_5 = D->m21 * c->m4;
  const double w_3_lo = ksl_product_error(D->m01, c->m4, w_3), w_3_rounded = w_3 + w_3_lo;
  const double w_4_lo = ksl_product_error(D->m11, c->m4, w_4), w_4_rounded = w_4 + w_4_lo;
  const double w_5_lo = ksl_product_error(D->m21, c->m4, w_5), w_5_rounded = w_5 + w_5_lo;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = D->m02 * c->m5;
  const double w_4 = D->m12 * c->m5;
  const double w_5 = D->m22 * c->m5;
  const double w_3_lo = ksl_product_error(D->m02, c->m5, w_3), w_3_rounded = w_3 + w_3_lo;
  const double w_4_lo = ksl_product_error(D->m12, c->m5, w_4), w_4_rounded = w_4 + w_4_lo;
  const double w_5_lo = ksl_product_error(D->m22, c->m5, w_5), w_5_rounded = w_5 + w_5_lo;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_coscrewf_scale_accurate(ksl_coscrewf_t *self, const float a) {
  const double self_0_new = (double)self->m0 * (double)a;
  const double self_1_new = (double)self->m1 * (double)a;
  const double self_2_new = (double)self->m2 * (double)a;
  const double self_3_new = (double)self->m3 * (double)a;
  const double self_4_new = (double)self->m4 * (double)a;
  const double self_5_new = (double)self->m5 * (double)a;
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_ccf_accurate(const float a, const ksl_coscrewf_t *x,
    ksl_coscrewf_t *y) {
  const double y_0_new_a = (double)a * (double)x->m0, y_0_new = y_0_new_a + (double)y->m0;
  const double y_1_new_a = (double)a * (double)x->m1, y_1_new = y_1_new_a + (double)y->m1;
  const double y_2_new_a = (double)a * (double)x->m2, y_2_new = y_2_new_a + (double)y->m2;
  const double y_3_new_a = (double)a * (double)x->m3, y_3_new = y_3_new_a + (double)y->m3;
  const double y_4_new_a = (double)a * (double)x->m4, y_4_new = y_4_new_a + (double)y->m4;
  const double y_5_new_a = (double)a * (double)x->m5, y_5_new = y_5_new_a + (double)y->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_ccf_accurate(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const double y_0_new = (double)x->m0 + (double)y->m0;
  const double y_1_new = (double)x->m1 + (double)y->m1;
  const double y_2_new = (double)x->m2 + (double)y->m2;
  const double y_3_new = (double)x->m3 + (double)y->m3;
  const double y_4_new = (double)x->m4 + (double)y->m4;
  const double y_5_new = (double)x->m5 + (double)y->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_ccf_accurate(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const double y_0_new = (double)y->m0 - (double)x->m0;
  const double y_1_new = (double)y->m1 - (double)x->m1;
  const double y_2_new = (double)y->m2 - (double)x->m2;
  const double y_3_new = (double)y->m3 - (double)x->m3;
  const double y_4_new = (double)y->m4 - (double)x->m4;
  const double y_5_new = (double)y->m5 - (double)x->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_acf_accurate(const float a, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)a * (double)ci->m0;
  const double co_1 = (double)a * (double)ci->m1;
  const double co_2 = (double)a * (double)ci->m2;
  const double co_3 = (double)a * (double)ci->m3;
  const double co_4 = (double)a * (double)ci->m4;
  const double co_5 = (double)a * (double)ci->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_ccf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 + (double)c2->m0;
  const double co_1 = (double)c1->m1 + (double)c2->m1;
  const double co_2 = (double)c1->m2 + (double)c2->m2;
  const double co_3 = (double)c1->m3 + (double)c2->m3;
  const double co_4 = (double)c1->m4 + (double)c2->m4;
  const double co_5 = (double)c1->m5 + (double)c2->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_ccf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 - (double)c2->m0;
  const double co_1 = (double)c1->m1 - (double)c2->m1;
  const double co_2 = (double)c1->m2 - (double)c2->m2;
  const double co_3 = (double)c1->m3 - (double)c2->m3;
  const double co_4 = (double)c1->m4 - (double)c2->m4;
  const double co_5 = (double)c1->m5 - (double)c2->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result| + (lin: 1/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_add_cctf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 + (double)c2->m0;
  const double co_1 = (double)c1->m1 + (double)c2->m1;
  const double co_2 = (double)c1->m2 + (double)c2->m2;
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_3a = (double)t->y * (double)ci->m2, co_3b = (double)t->z * (double)ci->m1,
      co_3c = co_3a - co_3b, co_3 = co_3c + (double)ci->m3;
  const double co_4a = (double)t->z * (double)ci->m0, co_4b = (double)t->x * (double)ci->m2,
      co_4c = co_4a - co_4b, co_4 = co_4c + (double)ci->m4;
  const double co_5a = (double)t->x * (double)ci->m1, co_5b = (double)t->y * (double)ci->m0,
      co_5c = co_5a - co_5b, co_5 = co_5c + (double)ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_3a = (double)t->z * (double)ci->m1, co_3b = (double)t->y * (double)ci->m2,
      co_3c = co_3a - co_3b, co_3 = co_3c + (double)ci->m3;
  const double co_4a = (double)t->x * (double)ci->m2, co_4b = (double)t->z * (double)ci->m0,
      co_4c = co_4a - co_4b, co_4 = co_4c + (double)ci->m4;
  const double co_5a = (double)t->y * (double)ci->m0, co_5b = (double)t->x * (double)ci->m1,
      co_5c = co_5a - co_5b, co_5 = co_5c + (double)ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0 = -(double)ci->m0;
  const double co_1 = -(double)ci->m1;
  const double co_2 = -(double)ci->m2;
  const double co_3a = (double)t->z * (double)ci->m1, co_3b = (double)t->y * (double)ci->m2,
      co_3c = co_3a - co_3b, co_3 = co_3c - (double)ci->m3;
  const double co_4a = (double)t->x * (double)ci->m2, co_4b = (double)t->z * (double)ci->m0,
      co_4c = co_4a - co_4b, co_4 = co_4c - (double)ci->m4;
  const double co_5a = (double)t->y * (double)ci->m0, co_5b = (double)t->x * (double)ci->m1,
      co_5c = co_5a - co_5b, co_5 = co_5c - (double)ci->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcf_accurate(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0a = (double)R->m00 * (double)ci->m0, co_0b = (double)R->m01 * (double)ci->m1,
      co_0c = co_0a + co_0b, co_0d = (double)R->m02 * (double)ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = (double)R->m10 * (double)ci->m0, co_1b = (double)R->m11 * (double)ci->m1,
      co_1c = co_1a + co_1b, co_1d = (double)R->m12 * (double)ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = (double)R->m20 * (double)ci->m0, co_2b = (double)R->m21 * (double)ci->m1,
      co_2c = co_2a + co_2b, co_2d = (double)R->m22 * (double)ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = (double)R->m00 * (double)ci->m3, co_3b = (double)R->m01 * (double)ci->m4,
      co_3c = co_3a + co_3b, co_3d = (double)R->m02 * (double)ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = (double)R->m10 * (double)ci->m3, co_4b = (double)R->m11 * (double)ci->m4,
      co_4c = co_4a + co_4b, co_4d = (double)R->m12 * (double)ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = (double)R->m20 * (double)ci->m3, co_5b = (double)R->m21 * (double)ci->m4,
      co_5c = co_5a + co_5b, co_5d = (double)R->m22 * (double)ci->m5, co_5 = co_5c + co_5d;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrinvcf_accurate(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double co_0a = (double)R->m00 * (double)ci->m0, co_0b = (double)R->m10 * (double)ci->m1,
      co_0c = co_0a + co_0b, co_0d = (double)R->m20 * (double)ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = (double)R->m01 * (double)ci->m0, co_1b = (double)R->m11 * (double)ci->m1,
      co_1c = co_1a + co_1b, co_1d = (double)R->m21 * (double)ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = (double)R->m02 * (double)ci->m0, co_2b = (double)R->m12 * (double)ci->m1,
      co_2c = co_2a + co_2b, co_2d = (double)R->m22 * (double)ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = (double)R->m00 * (double)ci->m3, co_3b = (double)R->m10 * (double)ci->m4,
      co_3c = co_3a + co_3b, co_3d = (double)R->m20 * (double)ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = (double)R->m01 * (double)ci->m3, co_4b = (double)R->m11 * (double)ci->m4,
      co_4c = co_4a + co_4b, co_4d = (double)R->m21 * (double)ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = (double)R->m02 * (double)ci->m3, co_5b = (double)R->m12 * (double)ci->m4,
      co_5c = co_5a + co_5b, co_5d = (double)R->m22 * (double)ci->m5, co_5 = co_5c + co_5d;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcinvf_accurate(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double co_0a = (double)R->m00 * (double)ci->m0, co_0b = (double)R->m01 * (double)ci->m1,
      co_0c = co_0a + co_0b, co_0d = (double)R->m02 * (double)ci->m2, co_0e = co_0c + co_0d,
      co_0 = -co_0e;
  const double co_1a = (double)R->m10 * (double)ci->m0, co_1b = (double)R->m11 * (double)ci->m1,
      co_1c = co_1a + co_1b, co_1d = (double)R->m12 * (double)ci->m2, co_1e = co_1c + co_1d,
      co_1 = -co_1e;
  const double co_2a = (double)R->m20 * (double)ci->m0, co_2b = (double)R->m21 * (double)ci->m1,
      co_2c = co_2a + co_2b, co_2d = (double)R->m22 * (double)ci->m2, co_2e = co_2c + co_2d,
      co_2 = -co_2e;
  const double co_3a = (double)R->m00 * (double)ci->m3, co_3b = (double)R->m01 * (double)ci->m4,
      co_3c = co_3a + co_3b, co_3d = (double)R->m02 * (double)ci->m5, co_3e = co_3c + co_3d,
      co_3 = -co_3e;
  const double co_4a = (double)R->m10 * (double)ci->m3, co_4b = (double)R->m11 * (double)ci->m4,
      co_4c = co_4a + co_4b, co_4d = (double)R->m12 * (double)ci->m5, co_4e = co_4c + co_4d,
      co_4 = -co_4e;
  const double co_5a = (double)R->m20 * (double)ci->m3, co_5b = (double)R->m21 * (double)ci->m4,
      co_5c = co_5a + co_5b, co_5d = (double)R->m22 * (double)ci->m5, co_5e = co_5c + co_5d,
      co_5 = -co_5e;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)ci->m0, w_0b = (double)D->m01 * (double)ci->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)ci->m2, w_0 = w_0c + w_0d;
  const double w_1a = (double)D->m10 * (double)ci->m0, w_1b = (double)D->m11 * (double)ci->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)ci->m2, w_1 = w_1c + w_1d;
  const double w_2a = (double)D->m20 * (double)ci->m0, w_2b = (double)D->m21 * (double)ci->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)ci->m2, w_2 = w_2c + w_2d;
  const double w_3a = (double)D->m00 * (double)ci->m3, w_3b = (double)D->m01 * (double)ci->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)ci->m5, w_3 = w_3c + w_3d;
  const double w_4a = (double)D->m10 * (double)ci->m3, w_4b = (double)D->m11 * (double)ci->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)ci->m5, w_4 = w_4c + w_4d;
  const double w_5a = (double)D->m20 * (double)ci->m3, w_5b = (double)D->m21 * (double)ci->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)ci->m5, w_5 = w_5c + w_5d;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdinvcf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_3a = (double)D->m23 * (double)ci->m1, w_3b = (double)D->m13 * (double)ci->m2,
      w_3c = w_3a - w_3b, w_3 = w_3c + (double)ci->m3;
  const double w_4a = (double)D->m03 * (double)ci->m2, w_4b = (double)D->m23 * (double)ci->m0,
      w_4c = w_4a - w_4b, w_4 = w_4c + (double)ci->m4;
  const double w_5a = (double)D->m13 * (double)ci->m0, w_5b = (double)D->m03 * (double)ci->m1,
      w_5c = w_5a - w_5b, w_5 = w_5c + (double)ci->m5;
  const double co_0a = (double)D->m00 * (double)ci->m0, co_0b = (double)D->m10 * (double)ci->m1,
      co_0c = co_0a + co_0b, co_0d = (double)D->m20 * (double)ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = (double)D->m01 * (double)ci->m0, co_1b = (double)D->m11 * (double)ci->m1,
      co_1c = co_1a + co_1b, co_1d = (double)D->m21 * (double)ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = (double)D->m02 * (double)ci->m0, co_2b = (double)D->m12 * (double)ci->m1,
      co_2c = co_2a + co_2b, co_2d = (double)D->m22 * (double)ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = (double)D->m00 * w_3, co_3b = (double)D->m10 * w_4, co_3c = co_3a + co_3b,
      co_3d = (double)D->m20 * w_5, co_3 = co_3c + co_3d;
  const double co_4a = (double)D->m01 * w_3, co_4b = (double)D->m11 * w_4, co_4c = co_4a + co_4b,
      co_4d = (double)D->m21 * w_5, co_4 = co_4c + co_4d;
  const double co_5a = (double)D->m02 * w_3, co_5b = (double)D->m12 * w_4, co_5c = co_5a + co_5b,
      co_5d = (double)D->m22 * w_5, co_5 = co_5c + co_5d;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcinvf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)ci->m0, w_0b = (double)D->m01 * (double)ci->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)ci->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = (double)D->m10 * (double)ci->m0, w_1b = (double)D->m11 * (double)ci->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)ci->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = (double)D->m20 * (double)ci->m0, w_2b = (double)D->m21 * (double)ci->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)ci->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = (double)D->m00 * (double)ci->m3, w_3b = (double)D->m01 * (double)ci->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)ci->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = (double)D->m10 * (double)ci->m3, w_4b = (double)D->m11 * (double)ci->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)ci->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = (double)D->m20 * (double)ci->m3, w_5b = (double)D->m21 * (double)ci->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)ci->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3a = (double)D->m20 * (double)D->m13, co_3b = (double)D->m10 * (double)D->m23,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m00 * (double)D->m23, co_4b = (double)D->m20 * (double)D->m03,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m10 * (double)D->m03, co_5b = (double)D->m00 * (double)D->m13,
      co_5 = co_5a - co_5b;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3a = (double)D->m21 * (double)D->m13, co_3b = (double)D->m11 * (double)D->m23,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m01 * (double)D->m23, co_4b = (double)D->m21 * (double)D->m03,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m11 * (double)D->m03, co_5b = (double)D->m01 * (double)D->m13,
      co_5 = co_5a - co_5b;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3a = (double)D->m22 * (double)D->m13, co_3b = (double)D->m12 * (double)D->m23,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m02 * (double)D->m23, co_4b = (double)D->m22 * (double)D->m03,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m12 * (double)D->m03, co_5b = (double)D->m02 * (double)D->m13,
      co_5 = co_5a - co_5b;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m00;
  const double co_1 = -(double)D->m10;
  const double co_2 = -(double)D->m20;
  const double co_3a = (double)D->m10 * (double)D->m23, co_3b = (double)D->m20 * (double)D->m13,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m20 * (double)D->m03, co_4b = (double)D->m00 * (double)D->m23,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m00 * (double)D->m13, co_5b = (double)D->m10 * (double)D->m03,
      co_5 = co_5a - co_5b;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m01;
  const double co_1 = -(double)D->m11;
  const double co_2 = -(double)D->m21;
  const double co_3a = (double)D->m11 * (double)D->m23, co_3b = (double)D->m21 * (double)D->m13,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m21 * (double)D->m03, co_4b = (double)D->m01 * (double)D->m23,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m01 * (double)D->m13, co_5b = (double)D->m11 * (double)D->m03,
      co_5 = co_5a - co_5b;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m02;
  const double co_1 = -(double)D->m12;
  const double co_2 = -(double)D->m22;
  const double co_3a = (double)D->m12 * (double)D->m23, co_3b = (double)D->m22 * (double)D->m13,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m22 * (double)D->m03, co_4b = (double)D->m02 * (double)D->m23,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m02 * (double)D->m13, co_5b = (double)D->m12 * (double)D->m03,
      co_5 = co_5a - co_5b;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_CoAdf_accurate(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const double M_30a = (double)D->m20 * (double)D->m13, M_30b = (double)D->m10 * (double)D->m23,
      M_30 = M_30a - M_30b;
  const double M_31a = (double)D->m21 * (double)D->m13, M_31b = (double)D->m11 * (double)D->m23,
      M_31 = M_31a - M_31b;
  const double M_32a = (double)D->m22 * (double)D->m13, M_32b = (double)D->m12 * (double)D->m23,
      M_32 = M_32a - M_32b;
  const double M_40a = (double)D->m00 * (double)D->m23, M_40b = (double)D->m20 * (double)D->m03,
      M_40 = M_40a - M_40b;
  const double M_41a = (double)D->m01 * (double)D->m23, M_41b = (double)D->m21 * (double)D->m03,
      M_41 = M_41a - M_41b;
  const double M_42a = (double)D->m02 * (double)D->m23, M_42b = (double)D->m22 * (double)D->m03,
      M_42 = M_42a - M_42b;
  const double M_50a = (double)D->m10 * (double)D->m03, M_50b = (double)D->m00 * (double)D->m13,
      M_50 = M_50a - M_50b;
  const double M_51a = (double)D->m11 * (double)D->m03, M_51b = (double)D->m01 * (double)D->m13,
      M_51 = M_51a - M_51b;
  const double M_52a = (double)D->m12 * (double)D->m03, M_52b = (double)D->m02 * (double)D->m13,
      M_52 = M_52a - M_52b;
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
  M->at[3][0] = (float)0.0;
  M->at[4][0] = (float)0.0;
  M->at[5][0] = (float)0.0;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = (float)0.0;
  M->at[4][1] = (float)0.0;
  M->at[5][1] = (float)0.0;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = (float)0.0;
  M->at[4][2] = (float)0.0;
  M->at[5][2] = (float)0.0;
  M->at[0][3] = (float)M_30;
  M->at[1][3] = (float)M_31;
  M->at[2][3] = (float)M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = (float)M_40;
  M->at[1][4] = (float)M_41;
  M->at[2][4] = (float)M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = (float)M_50;
  M->at[1][5] = (float)M_51;
  M->at[2][5] = (float)M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_reciprocal_productf_accurate(const ksl_coscrewf_t *c, const float x[6]) {
  const double power_a = (double)c->m0 * (double)x[3], power_b = (double)c->m1 * (double)x[4],
      power_c = power_a + power_b, power_d = (double)c->m2 * (double)x[5],
      power_e = power_c + power_d, power_f = (double)c->m3 * (double)x[0],
      power_g = (double)c->m4 * (double)x[1], power_h = power_f + power_g,
      power_i = (double)c->m5 * (double)x[2], power_j = power_h + power_i,
      power = power_e + power_j;
  return (float)power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_scf_accurate(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double co_0a = (double)s->m4 * (double)c->m2, co_0b = (double)s->m5 * (double)c->m1,
      co_0 = co_0a - co_0b;
  const double co_1a = (double)s->m5 * (double)c->m0, co_1b = (double)s->m3 * (double)c->m2,
      co_1 = co_1a - co_1b;
  const double co_2a = (double)s->m3 * (double)c->m1, co_2b = (double)s->m4 * (double)c->m0,
      co_2 = co_2a - co_2b;
  const double co_3a = (double)s->m1 * (double)c->m2, co_3b = (double)s->m2 * (double)c->m1,
      co_3c = co_3a - co_3b, co_3d = (double)s->m4 * (double)c->m5,
      co_3e = (double)s->m5 * (double)c->m4, co_3f = co_3d - co_3e, co_3 = co_3c + co_3f;
  const double co_4a = (double)s->m2 * (double)c->m0, co_4b = (double)s->m0 * (double)c->m2,
      co_4c = co_4a - co_4b, co_4d = (double)s->m5 * (double)c->m3,
      co_4e = (double)s->m3 * (double)c->m5, co_4f = co_4d - co_4e, co_4 = co_4c + co_4f;
  const double co_5a = (double)s->m0 * (double)c->m1, co_5b = (double)s->m1 * (double)c->m0,
      co_5c = co_5a - co_5b, co_5d = (double)s->m3 * (double)c->m4,
      co_5e = (double)s->m4 * (double)c->m3, co_5f = co_5d - co_5e, co_5 = co_5c + co_5f;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_scaf_accurate(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double co_3a = (double)s->m4 * (double)c->m5, co_3b = (double)s->m5 * (double)c->m4,
      co_3 = co_3a - co_3b;
  const double co_4a = (double)s->m5 * (double)c->m3, co_4b = (double)s->m3 * (double)c->m5,
      co_4 = co_4a - co_4b;
  const double co_5a = (double)s->m3 * (double)c->m4, co_5b = (double)s->m4 * (double)c->m3,
      co_5 = co_5a - co_5b;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m01 * (double)c->m1, w_0b = (double)D->m02 * (double)c->m2,
      w_0 = w_0a + w_0b;
  const double w_1a = (double)D->m11 * (double)c->m1, w_1b = (double)D->m12 * (double)c->m2,
      w_1 = w_1a + w_1b;
  const double w_2a = (double)D->m21 * (double)c->m1, w_2b = (double)D->m22 * (double)c->m2,
      w_2 = w_2a + w_2b;
  const double w_3a = (double)D->m00 * (double)c->m3, w_3b = (double)D->m01 * (double)c->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)c->m5, w_3 = w_3c + w_3d;
  const double w_4a = (double)D->m10 * (double)c->m3, w_4b = (double)D->m11 * (double)c->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)c->m5, w_4 = w_4c + w_4d;
  const double w_5a = (double)D->m20 * (double)c->m3, w_5b = (double)D->m21 * (double)c->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)c->m5, w_5 = w_5c + w_5d;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctyf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)c->m0, w_0b = (double)D->m02 * (double)c->m2,
      w_0 = w_0a + w_0b;
  const double w_1a = (double)D->m10 * (double)c->m0, w_1b = (double)D->m12 * (double)c->m2,
      w_1 = w_1a + w_1b;
  const double w_2a = (double)D->m20 * (double)c->m0, w_2b = (double)D->m22 * (double)c->m2,
      w_2 = w_2a + w_2b;
  const double w_3a = (double)D->m00 * (double)c->m3, w_3b = (double)D->m01 * (double)c->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)c->m5, w_3 = w_3c + w_3d;
  const double w_4a = (double)D->m10 * (double)c->m3, w_4b = (double)D->m11 * (double)c->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)c->m5, w_4 = w_4c + w_4d;
  const double w_5a = (double)D->m20 * (double)c->m3, w_5b = (double)D->m21 * (double)c->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)c->m5, w_5 = w_5c + w_5d;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)c->m0, w_0b = (double)D->m01 * (double)c->m1,
      w_0 = w_0a + w_0b;
  const double w_1a = (double)D->m10 * (double)c->m0, w_1b = (double)D->m11 * (double)c->m1,
      w_1 = w_1a + w_1b;
  const double w_2a = (double)D->m20 * (double)c->m0, w_2b = (double)D->m21 * (double)c->m1,
      w_2 = w_2a + w_2b;
  const double w_3a = (double)D->m00 * (double)c->m3, w_3b = (double)D->m01 * (double)c->m4,
      w_3c = w_3a + w_3b, w_3d = (double)D->m02 * (double)c->m5, w_3 = w_3c + w_3d;
  const double w_4a = (double)D->m10 * (double)c->m3, w_4b = (double)D->m11 * (double)c->m4,
      w_4c = w_4a + w_4b, w_4d = (double)D->m12 * (double)c->m5, w_4 = w_4c + w_4d;
  const double w_5a = (double)D->m20 * (double)c->m3, w_5b = (double)D->m21 * (double)c->m4,
      w_5c = w_5a + w_5b, w_5d = (double)D->m22 * (double)c->m5, w_5 = w_5c + w_5d;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)c->m0, w_0b = (double)D->m01 * (double)c->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)c->m2, w_0 = w_0c + w_0d;
  const double w_1a = (double)D->m10 * (double)c->m0, w_1b = (double)D->m11 * (double)c->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)c->m2, w_1 = w_1c + w_1d;
  const double w_2a = (double)D->m20 * (double)c->m0, w_2b = (double)D->m21 * (double)c->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)c->m2, w_2 = w_2c + w_2d;
  const double w_3a = (double)D->m01 * (double)c->m4, w_3b = (double)D->m02 * (double)c->m5,
      w_3 = w_3a + w_3b;
  const double w_4a = (double)D->m11 * (double)c->m4, w_4b = (double)D->m12 * (double)c->m5,
      w_4 = w_4a + w_4b;
  const double w_5a = (double)D->m21 * (double)c->m4, w_5b = (double)D->m22 * (double)c->m5,
      w_5 = w_5a + w_5b;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cryf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)c->m0, w_0b = (double)D->m01 * (double)c->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)c->m2, w_0 = w_0c + w_0d;
  const double w_1a = (double)D->m10 * (double)c->m0, w_1b = (double)D->m11 * (double)c->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)c->m2, w_1 = w_1c + w_1d;
  const double w_2a = (double)D->m20 * (double)c->m0, w_2b = (double)D->m21 * (double)c->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)c->m2, w_2 = w_2c + w_2d;
  const double w_3a = (double)D->m00 * (double)c->m3, w_3b = (double)D->m02 * (double)c->m5,
      w_3 = w_3a + w_3b;
  const double w_4a = (double)D->m10 * (double)c->m3, w_4b = (double)D->m12 * (double)c->m5,
      w_4 = w_4a + w_4b;
  const double w_5a = (double)D->m20 * (double)c->m3, w_5b = (double)D->m22 * (double)c->m5,
      w_5 = w_5a + w_5b;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0a = (double)D->m00 * (double)c->m0, w_0b = (double)D->m01 * (double)c->m1,
      w_0c = w_0a + w_0b, w_0d = (double)D->m02 * (double)c->m2, w_0 = w_0c + w_0d;
  const double w_1a = (double)D->m10 * (double)c->m0, w_1b = (double)D->m11 * (double)c->m1,
      w_1c = w_1a + w_1b, w_1d = (double)D->m12 * (double)c->m2, w_1 = w_1c + w_1d;
  const double w_2a = (double)D->m20 * (double)c->m0, w_2b = (double)D->m21 * (double)c->m1,
      w_2c = w_2a + w_2b, w_2d = (double)D->m22 * (double)c->m2, w_2 = w_2c + w_2d;
  const double w_3a = (double)D->m00 * (double)c->m3, w_3b = (double)D->m01 * (double)c->m4,
      w_3 = w_3a + w_3b;
  const double w_4a = (double)D->m10 * (double)c->m3, w_4b = (double)D->m11 * (double)c->m4,
      w_4 = w_4a + w_4b;
  const double w_5a = (double)D->m20 * (double)c->m3, w_5b = (double)D->m21 * (double)c->m4,
      w_5 = w_5a + w_5b;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m00 * (double)c->m0;
  const double w_1 = (double)D->m10 * (double)c->m0;
  const double w_2 = (double)D->m20 * (double)c->m0;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctyf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m01 * (double)c->m1;
  const double w_1 = (double)D->m11 * (double)c->m1;
  const double w_2 = (double)D->m21 * (double)c->m1;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m02 * (double)c->m2;
  const double w_1 = (double)D->m12 * (double)c->m2;
  const double w_2 = (double)D->m22 * (double)c->m2;
  const double co_3a = (double)D->m13 * w_2, co_3b = (double)D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = (double)D->m23 * w_0, co_4b = (double)D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = (double)D->m03 * w_1, co_5b = (double)D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_crxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m00 * (double)c->m3;
  const double w_4 = (double)D->m10 * (double)c->m3;
  const double w_5 = (double)D->m20 * (double)c->m3;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_cryf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m01 * (double)c->m4;
  const double w_4 = (double)D->m11 * (double)c->m4;
  const double w_5 = (double)D->m21 * (double)c->m4;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_crzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m02 * (double)c->m5;
  const double w_4 = (double)D->m12 * (double)c->m5;
  const double w_5 = (double)D->m22 * (double)c->m5;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

#endif
