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

/* quaternion (w; x, y, z), the scalar first; for rotations, of norm 1; double precision. */
typedef union ksl_quaternion_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double w, x, y, z; };
} ksl_quaternion_t;

/* quaternion (w; x, y, z), the scalar first; for rotations, of norm 1; single precision. */
typedef union ksl_quaternionf_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float w, x, y, z; };
} ksl_quaternionf_t;

/* spatial inertia: mass m, first moment h = m c, second moments about the origin; double precision. */
typedef union ksl_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t h;
    double xx, yy, zz, xy, xz, yz;
  };
} ksl_inertia_t;

/* spatial inertia: mass m, first moment h = m c, second moments about the origin; single precision. */
typedef union ksl_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t h;
    float xx, yy, zz, xy, xz, yz;
  };
} ksl_inertiaf_t;

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

/* a + b - s exactly, s the rounded sum (Knuth, TwoSum). */
static inline double ksl_sum_error(const double a, const double b, const double s) {
  const double t = s - a, u = s - t, v = a - u, w = b - t;
  return v + w;
}

/* a - b - s exactly, s the rounded difference. */
static inline double ksl_difference_error(const double a, const double b, const double s) {
  const double t = s - a, u = s - t, v = a - u, w = b + t;
  return v - w;
}

/* a b - p exactly, p the rounded product: by fma where that is an instruction, else in halves of
   26 bits (Veltkamp, Dekker).  Both give the same bits. */
static inline double ksl_product_error(const double a, const double b, const double p) {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(FP_FAST_FMA)
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
  const double self_0_new = self->x * a, self_0_new_lo = ksl_product_error(self->x, a, self_0_new);
  const double self_1_new = self->y * a, self_1_new_lo = ksl_product_error(self->y, a, self_1_new);
  const double self_2_new = self->z * a, self_2_new_lo = ksl_product_error(self->z, a, self_2_new);
  const double self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  self->x = self_0_new_rounded;
  self->y = self_1_new_rounded;
  self->z = self_2_new_rounded;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + 2 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv_accurate(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new_a = a * x->x, y_0_new_a_lo = ksl_product_error(a, x->x, y_0_new_a),
      y_0_new = y_0_new_a + y->x, y_0_new_error = ksl_sum_error(y_0_new_a, y->x, y_0_new),
      y_0_new_lo = y_0_new_error + y_0_new_a_lo;
  const double y_1_new_a = a * x->y, y_1_new_a_lo = ksl_product_error(a, x->y, y_1_new_a),
      y_1_new = y_1_new_a + y->y, y_1_new_error = ksl_sum_error(y_1_new_a, y->y, y_1_new),
      y_1_new_lo = y_1_new_error + y_1_new_a_lo;
  const double y_2_new_a = a * x->z, y_2_new_a_lo = ksl_product_error(a, x->z, y_2_new_a),
      y_2_new = y_2_new_a + y->z, y_2_new_error = ksl_sum_error(y_2_new_a, y->z, y_2_new),
      y_2_new_lo = y_2_new_error + y_2_new_a_lo;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = x + y.
   x, y: vector.
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x, y_0_new_lo = ksl_sum_error(x->x, y->x, y_0_new);
  const double y_1_new = x->y + y->y, y_1_new_lo = ksl_sum_error(x->y, y->y, y_1_new);
  const double y_2_new = x->z + y->z, y_2_new_lo = ksl_sum_error(x->z, y->z, y_2_new);
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = -x + y.
   x, y: vector.
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x, y_0_new_lo = ksl_difference_error(y->x, x->x, y_0_new);
  const double y_1_new = y->y - x->y, y_1_new_lo = ksl_difference_error(y->y, x->y, y_1_new);
  const double y_2_new = y->z - x->z, y_2_new_lo = ksl_difference_error(y->z, x->z, y_2_new);
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
  const double vo_0 = a * vi->x, vo_0_lo = ksl_product_error(a, vi->x, vo_0);
  const double vo_1 = a * vi->y, vo_1_lo = ksl_product_error(a, vi->y, vo_1);
  const double vo_2 = a * vi->z, vo_2_lo = ksl_product_error(a, vi->z, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x, vo_0_lo = ksl_sum_error(v1->x, v2->x, vo_0);
  const double vo_1 = v1->y + v2->y, vo_1_lo = ksl_sum_error(v1->y, v2->y, vo_1);
  const double vo_2 = v1->z + v2->z, vo_2_lo = ksl_sum_error(v1->z, v2->z, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x, vo_0_lo = ksl_difference_error(v1->x, v2->x, vo_0);
  const double vo_1 = v1->y - v2->y, vo_1_lo = ksl_difference_error(v1->y, v2->y, vo_1);
  const double vo_2 = v1->z - v2->z, vo_2_lo = ksl_difference_error(v1->z, v2->z, vo_2);
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
  const double vo_0 = v->x * k, vo_0_lo = ksl_product_error(v->x, k, vo_0);
  const double vo_1 = v->y * k, vo_1_lo = ksl_product_error(v->y, k, vo_1);
  const double vo_2 = v->z * k, vo_2_lo = ksl_product_error(v->z, k, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* |v| = sqrt(v·v).
   v: vector.
   10 mul, 16 add, 4 product error, 2 sum error, 2 div, 1 sqrt, 3 abs, 6 less, 3 equal, 9 select. */
static inline double ksl_vec3_l2norm_accurate(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm_total = n + n_lo, norm_added = norm_total - n,
      norm_remaining = n_lo - norm_added, norm = norm_total * r, norm_inverse = 1.0 / r,
      norm_back = norm * norm_inverse, norm_lost = norm_total - norm_back,
      norm_rest = norm_lost + norm_remaining, norm_small = norm_rest * r,
      norm_lo = norm_lost == 0.0 ? 0.0 : norm_small;
  const double norm_total = norm + norm_lo,
      norm_rounded = norm_total == norm_total ? norm_total : norm;
  return norm_rounded;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   25 mul, 37 add, 7 product error, 2 sum error, 8 div, 1 sqrt, 3 abs, 6 less, 8 equal, 15
     select. */
static inline void ksl_vec3_normalize_accurate(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = self->x * s;
  const double y_1 = self->y * s;
  const double y_2 = self->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = self->x * up;
  const double enlarged_1 = self->y * up;
  const double enlarged_2 = self->z * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double self_0_new_total = quotient_0 + quotient_0_lo,
      self_0_new_added = self_0_new_total - quotient_0,
      self_0_new_remaining = quotient_0_lo - self_0_new_added, self_0_new = self_0_new_total * down,
      self_0_new_inverse = 1.0 / down, self_0_new_back = self_0_new * self_0_new_inverse,
      self_0_new_lost = self_0_new_total - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_remaining,
      self_0_new_small = self_0_new_rest * down,
      self_0_new_lo = self_0_new_lost == 0.0 ? 0.0 : self_0_new_small;
  const double self_1_new_total = quotient_1 + quotient_1_lo,
      self_1_new_added = self_1_new_total - quotient_1,
      self_1_new_remaining = quotient_1_lo - self_1_new_added, self_1_new = self_1_new_total * down,
      self_1_new_back = self_1_new * self_0_new_inverse,
      self_1_new_lost = self_1_new_total - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_remaining,
      self_1_new_small = self_1_new_rest * down,
      self_1_new_lo = self_1_new_lost == 0.0 ? 0.0 : self_1_new_small;
  const double self_2_new_total = quotient_2 + quotient_2_lo,
      self_2_new_added = self_2_new_total - quotient_2,
      self_2_new_remaining = quotient_2_lo - self_2_new_added, self_2_new = self_2_new_total * down,
      self_2_new_back = self_2_new * self_0_new_inverse,
      self_2_new_lost = self_2_new_total - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_remaining,
      self_2_new_small = self_2_new_rest * down,
      self_2_new_lo = self_2_new_lost == 0.0 ? 0.0 : self_2_new_small;
  const double self_0_new_total = self_0_new + self_0_new_lo,
      self_0_new_rounded = self_0_new_total == self_0_new_total ? self_0_new_total : self_0_new;
  const double self_1_new_total = self_1_new + self_1_new_lo,
      self_1_new_rounded = self_1_new_total == self_1_new_total ? self_1_new_total : self_1_new;
  const double self_2_new_total = self_2_new + self_2_new_lo,
      self_2_new_rounded = self_2_new_total == self_2_new_total ? self_2_new_total : self_2_new;
  self->x = self_0_new_rounded;
  self->y = self_1_new_rounded;
  self->z = self_2_new_rounded;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   25 mul, 37 add, 7 product error, 2 sum error, 8 div, 1 sqrt, 3 abs, 6 less, 8 equal, 15
     select. */
static inline void ksl_vec3_normalized_accurate(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = v->x * up;
  const double enlarged_1 = v->y * up;
  const double enlarged_2 = v->z * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double vo_0_total = quotient_0 + quotient_0_lo, vo_0_added = vo_0_total - quotient_0,
      vo_0_remaining = quotient_0_lo - vo_0_added, vo_0 = vo_0_total * down,
      vo_0_inverse = 1.0 / down, vo_0_back = vo_0 * vo_0_inverse,
      vo_0_lost = vo_0_total - vo_0_back, vo_0_rest = vo_0_lost + vo_0_remaining,
      vo_0_small = vo_0_rest * down, vo_0_lo = vo_0_lost == 0.0 ? 0.0 : vo_0_small;
  const double vo_1_total = quotient_1 + quotient_1_lo, vo_1_added = vo_1_total - quotient_1,
      vo_1_remaining = quotient_1_lo - vo_1_added, vo_1 = vo_1_total * down,
      vo_1_back = vo_1 * vo_0_inverse, vo_1_lost = vo_1_total - vo_1_back,
      vo_1_rest = vo_1_lost + vo_1_remaining, vo_1_small = vo_1_rest * down,
      vo_1_lo = vo_1_lost == 0.0 ? 0.0 : vo_1_small;
  const double vo_2_total = quotient_2 + quotient_2_lo, vo_2_added = vo_2_total - quotient_2,
      vo_2_remaining = quotient_2_lo - vo_2_added, vo_2 = vo_2_total * down,
      vo_2_back = vo_2 * vo_0_inverse, vo_2_lost = vo_2_total - vo_2_back,
      vo_2_rest = vo_2_lost + vo_2_remaining, vo_2_small = vo_2_rest * down,
      vo_2_lo = vo_2_lost == 0.0 ? 0.0 : vo_2_small;
  const double vo_0_total = vo_0 + vo_0_lo,
      vo_0_rounded = vo_0_total == vo_0_total ? vo_0_total : vo_0;
  const double vo_1_total = vo_1 + vo_1_lo,
      vo_1_rounded = vo_1_total == vo_1_total ? vo_1_total : vo_1;
  const double vo_2_total = vo_2 + vo_2_lo,
      vo_2_rounded = vo_2_total == vo_2_total ? vo_2_total : vo_2;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 7 add, 3 product error, 2 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = v1->x * v2->x, dot_a_lo = ksl_product_error(v1->x, v2->x, dot_a),
      dot_b = v1->y * v2->y, dot_b_lo = ksl_product_error(v1->y, v2->y, dot_b),
      dot_c = dot_a + dot_b, dot_c_error = ksl_sum_error(dot_a, dot_b, dot_c),
      dot_c_lo1 = dot_c_error + dot_a_lo, dot_c_lo = dot_c_lo1 + dot_b_lo, dot_d = v1->z * v2->z,
      dot_d_lo = ksl_product_error(v1->z, v2->z, dot_d), dot = dot_c + dot_d,
      dot_error = ksl_sum_error(dot_c, dot_d, dot), dot_lo1 = dot_error + dot_c_lo,
      dot_lo = dot_lo1 + dot_d_lo;
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

/* vo = v / k.
   k: number; v, vo: vector.
   3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select. */
static inline void ksl_product_ainvv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k, vo_0_product = vo_0 * k,
      vo_0_product_error = ksl_product_error(vo_0, k, vo_0_product),
      vo_0_rest = v->x - vo_0_product, vo_0_exact = vo_0_rest - vo_0_product_error,
      vo_0_lo = vo_0_exact / k;
  const double vo_1 = v->y / k, vo_1_product = vo_1 * k,
      vo_1_product_error = ksl_product_error(vo_1, k, vo_1_product),
      vo_1_rest = v->y - vo_1_product, vo_1_exact = vo_1_rest - vo_1_product_error,
      vo_1_lo = vo_1_exact / k;
  const double vo_2 = v->z / k, vo_2_product = vo_2 * k,
      vo_2_product_error = ksl_product_error(vo_2, k, vo_2_product),
      vo_2_rest = v->z - vo_2_product, vo_2_exact = vo_2_rest - vo_2_product_error,
      vo_2_lo = vo_2_exact / k;
  const double vo_0_total = vo_0 + vo_0_lo,
      vo_0_rounded = vo_0_total == vo_0_total ? vo_0_total : vo_0;
  const double vo_1_total = vo_1 + vo_1_lo,
      vo_1_rounded = vo_1_total == vo_1_total ? vo_1_total : vo_1;
  const double vo_2_total = vo_2 + vo_2_lo,
      vo_2_rounded = vo_2_total == vo_2_total ? vo_2_total : vo_2;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = v1->y * v2->z, vo_0a_lo = ksl_product_error(v1->y, v2->z, vo_0a),
      vo_0b = v1->z * v2->y, vo_0b_lo = ksl_product_error(v1->z, v2->y, vo_0b),
      vo_0 = vo_0a - vo_0b, vo_0_error = ksl_difference_error(vo_0a, vo_0b, vo_0),
      vo_0_lo1 = vo_0_error + vo_0a_lo, vo_0_lo = vo_0_lo1 - vo_0b_lo;
  const double vo_1a = v1->z * v2->x, vo_1a_lo = ksl_product_error(v1->z, v2->x, vo_1a),
      vo_1b = v1->x * v2->z, vo_1b_lo = ksl_product_error(v1->x, v2->z, vo_1b),
      vo_1 = vo_1a - vo_1b, vo_1_error = ksl_difference_error(vo_1a, vo_1b, vo_1),
      vo_1_lo1 = vo_1_error + vo_1a_lo, vo_1_lo = vo_1_lo1 - vo_1b_lo;
  const double vo_2a = v1->x * v2->y, vo_2a_lo = ksl_product_error(v1->x, v2->y, vo_2a),
      vo_2b = v1->y * v2->x, vo_2b_lo = ksl_product_error(v1->y, v2->x, vo_2b),
      vo_2 = vo_2a - vo_2b, vo_2_error = ksl_difference_error(vo_2a, vo_2b, vo_2),
      vo_2_lo1 = vo_2_error + vo_2a_lo, vo_2_lo = vo_2_lo1 - vo_2b_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = v1->z * v2->y, vo_0a_lo = ksl_product_error(v1->z, v2->y, vo_0a),
      vo_0b = v1->y * v2->z, vo_0b_lo = ksl_product_error(v1->y, v2->z, vo_0b),
      vo_0 = vo_0a - vo_0b, vo_0_error = ksl_difference_error(vo_0a, vo_0b, vo_0),
      vo_0_lo1 = vo_0_error + vo_0a_lo, vo_0_lo = vo_0_lo1 - vo_0b_lo;
  const double vo_1a = v1->x * v2->z, vo_1a_lo = ksl_product_error(v1->x, v2->z, vo_1a),
      vo_1b = v1->z * v2->x, vo_1b_lo = ksl_product_error(v1->z, v2->x, vo_1b),
      vo_1 = vo_1a - vo_1b, vo_1_error = ksl_difference_error(vo_1a, vo_1b, vo_1),
      vo_1_lo1 = vo_1_error + vo_1a_lo, vo_1_lo = vo_1_lo1 - vo_1b_lo;
  const double vo_2a = v1->y * v2->x, vo_2a_lo = ksl_product_error(v1->y, v2->x, vo_2a),
      vo_2b = v1->x * v2->y, vo_2b_lo = ksl_product_error(v1->x, v2->y, vo_2b),
      vo_2 = vo_2a - vo_2b, vo_2_error = ksl_difference_error(vo_2a, vo_2b, vo_2),
      vo_2_lo1 = vo_2_error + vo_2a_lo, vo_2_lo = vo_2_lo1 - vo_2b_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k, vo_0_lo = ksl_sum_error(v->x, k, vo_0);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k, vo_0_lo = ksl_difference_error(v->x, k, vo_0);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k, vo_1_lo = ksl_sum_error(v->y, k, vo_1);
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k, vo_1_lo = ksl_difference_error(v->y, k, vo_1);
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k, vo_2_lo = ksl_sum_error(v->z, k, vo_2);
  const double vo_2_rounded = vo_2 + vo_2_lo;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2_rounded;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   2 add, 1 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k, vo_2_lo = ksl_difference_error(v->z, k, vo_2);
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

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 6 less, 6 select. */
static inline float ksl_vec3f_l2norm_accurate(const ksl_vec3f_t *v) {
  const double s_size_0 = fabs((double)v->x);
  const double s_size_1 = fabs((double)v->y);
  const double s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)v->x * s;
  const double y_1 = (double)v->y * s;
  const double y_2 = (double)v->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r = 1.0 < s ? 7.888609052210118e-31 : r_b;
  const double norm = n * r;
  return (float)norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3f_normalize_accurate(ksl_vec3f_t *self) {
  const double s_size_0 = fabs((double)self->x);
  const double s_size_1 = fabs((double)self->y);
  const double s_size_2 = fabs((double)self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)self->x * s;
  const double y_1 = (double)self->y * s;
  const double y_2 = (double)self->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)self->x * up;
  const double enlarged_1 = (double)self->y * up;
  const double enlarged_2 = (double)self->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3f_normalized_accurate(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const double s_size_0 = fabs((double)v->x);
  const double s_size_1 = fabs((double)v->y);
  const double s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)v->x * s;
  const double y_1 = (double)v->y * s;
  const double y_2 = (double)v->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)v->x * up;
  const double enlarged_1 = (double)v->y * up;
  const double enlarged_2 = (double)v->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double vo_0 = quotient_0 * down;
  const double vo_1 = quotient_1 * down;
  const double vo_2 = quotient_2 * down;
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

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x / (double)k;
  const double vo_1 = (double)v->y / (double)k;
  const double vo_2 = (double)v->z / (double)k;
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
   12 mul, 19 add, 9 product error, 5 sum error.
   Error <= u |result| + 27 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_mat3x3_determinant_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0a_lo = ksl_product_error(R->m11, R->m22, n_0a),
      n_0b = R->m12 * R->m21, n_0b_lo = ksl_product_error(R->m12, R->m21, n_0b), n_0 = n_0a - n_0b,
      n_0_error = ksl_difference_error(n_0a, n_0b, n_0), n_0_lo1 = n_0_error + n_0a_lo,
      n_0_lo = n_0_lo1 - n_0b_lo;
  const double n_1a = R->m02 * R->m21, n_1a_lo = ksl_product_error(R->m02, R->m21, n_1a),
      n_1b = R->m01 * R->m22, n_1b_lo = ksl_product_error(R->m01, R->m22, n_1b), n_1 = n_1a - n_1b,
      n_1_error = ksl_difference_error(n_1a, n_1b, n_1), n_1_lo1 = n_1_error + n_1a_lo,
      n_1_lo = n_1_lo1 - n_1b_lo;
  const double n_2a = R->m01 * R->m12, n_2a_lo = ksl_product_error(R->m01, R->m12, n_2a),
      n_2b = R->m02 * R->m11, n_2b_lo = ksl_product_error(R->m02, R->m11, n_2b), n_2 = n_2a - n_2b,
      n_2_error = ksl_difference_error(n_2a, n_2b, n_2), n_2_lo1 = n_2_error + n_2a_lo,
      n_2_lo = n_2_lo1 - n_2b_lo;
  const double det_a = R->m00 * n_0, det_a_cross1 = R->m00 * n_0_lo,
      det_a_error = ksl_product_error(R->m00, n_0, det_a), det_a_lo = det_a_error + det_a_cross1,
      det_b = R->m10 * n_1, det_b_cross1 = R->m10 * n_1_lo,
      det_b_error = ksl_product_error(R->m10, n_1, det_b), det_b_lo = det_b_error + det_b_cross1,
      det_c = det_a + det_b, det_c_error = ksl_sum_error(det_a, det_b, det_c),
      det_c_lo1 = det_c_error + det_a_lo, det_c_lo = det_c_lo1 + det_b_lo, det_d = R->m20 * n_2,
      det_d_cross1 = R->m20 * n_2_lo, det_d_error = ksl_product_error(R->m20, n_2, det_d),
      det_d_lo = det_d_error + det_d_cross1, det = det_c + det_d,
      det_error = ksl_sum_error(det_c, det_d, det), det_lo1 = det_error + det_c_lo,
      det_lo = det_lo1 + det_d_lo;
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
   9 mul, 21 add, 9 product error, 6 sum error, 6 neg.
   Error <= u |result| + (R: 0, t: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert_accurate(ksl_SE3_t *self) {
  const double self_03_new_a = self->m00 * self->m03,
      self_03_new_a_lo = ksl_product_error(self->m00, self->m03, self_03_new_a),
      self_03_new_b = self->m10 * self->m13,
      self_03_new_b_lo = ksl_product_error(self->m10, self->m13, self_03_new_b),
      self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_c_error = ksl_sum_error(self_03_new_a, self_03_new_b, self_03_new_c),
      self_03_new_c_lo1 = self_03_new_c_error + self_03_new_a_lo,
      self_03_new_c_lo = self_03_new_c_lo1 + self_03_new_b_lo,
      self_03_new_d = self->m20 * self->m23,
      self_03_new_d_lo = ksl_product_error(self->m20, self->m23, self_03_new_d),
      self_03_new_e = self_03_new_c + self_03_new_d,
      self_03_new_e_error = ksl_sum_error(self_03_new_c, self_03_new_d, self_03_new_e),
      self_03_new_e_lo1 = self_03_new_e_error + self_03_new_c_lo,
      self_03_new_e_lo = self_03_new_e_lo1 + self_03_new_d_lo, self_03_new = -self_03_new_e,
      self_03_new_lo = -self_03_new_e_lo;
  const double self_13_new_a = self->m01 * self->m03,
      self_13_new_a_lo = ksl_product_error(self->m01, self->m03, self_13_new_a),
      self_13_new_b = self->m11 * self->m13,
      self_13_new_b_lo = ksl_product_error(self->m11, self->m13, self_13_new_b),
      self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_c_error = ksl_sum_error(self_13_new_a, self_13_new_b, self_13_new_c),
      self_13_new_c_lo1 = self_13_new_c_error + self_13_new_a_lo,
      self_13_new_c_lo = self_13_new_c_lo1 + self_13_new_b_lo,
      self_13_new_d = self->m21 * self->m23,
      self_13_new_d_lo = ksl_product_error(self->m21, self->m23, self_13_new_d),
      self_13_new_e = self_13_new_c + self_13_new_d,
      self_13_new_e_error = ksl_sum_error(self_13_new_c, self_13_new_d, self_13_new_e),
      self_13_new_e_lo1 = self_13_new_e_error + self_13_new_c_lo,
      self_13_new_e_lo = self_13_new_e_lo1 + self_13_new_d_lo, self_13_new = -self_13_new_e,
      self_13_new_lo = -self_13_new_e_lo;
  const double self_23_new_a = self->m02 * self->m03,
      self_23_new_a_lo = ksl_product_error(self->m02, self->m03, self_23_new_a),
      self_23_new_b = self->m12 * self->m13,
      self_23_new_b_lo = ksl_product_error(self->m12, self->m13, self_23_new_b),
      self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_c_error = ksl_sum_error(self_23_new_a, self_23_new_b, self_23_new_c),
      self_23_new_c_lo1 = self_23_new_c_error + self_23_new_a_lo,
      self_23_new_c_lo = self_23_new_c_lo1 + self_23_new_b_lo,
      self_23_new_d = self->m22 * self->m23,
      self_23_new_d_lo = ksl_product_error(self->m22, self->m23, self_23_new_d),
      self_23_new_e = self_23_new_c + self_23_new_d,
      self_23_new_e_error = ksl_sum_error(self_23_new_c, self_23_new_d, self_23_new_e),
      self_23_new_e_lo1 = self_23_new_e_error + self_23_new_c_lo,
      self_23_new_e_lo = self_23_new_e_lo1 + self_23_new_d_lo, self_23_new = -self_23_new_e,
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
   9 mul, 21 add, 9 product error, 6 sum error, 6 neg.
   Error <= u |result| + (R: 0, t: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted_accurate(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * D->m03, Do_03a_lo = ksl_product_error(D->m00, D->m03, Do_03a),
      Do_03b = D->m10 * D->m13, Do_03b_lo = ksl_product_error(D->m10, D->m13, Do_03b),
      Do_03c = Do_03a + Do_03b, Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c),
      Do_03c_lo1 = Do_03c_error + Do_03a_lo, Do_03c_lo = Do_03c_lo1 + Do_03b_lo,
      Do_03d = D->m20 * D->m23, Do_03d_lo = ksl_product_error(D->m20, D->m23, Do_03d),
      Do_03e = Do_03c + Do_03d, Do_03e_error = ksl_sum_error(Do_03c, Do_03d, Do_03e),
      Do_03e_lo1 = Do_03e_error + Do_03c_lo, Do_03e_lo = Do_03e_lo1 + Do_03d_lo, Do_03 = -Do_03e,
      Do_03_lo = -Do_03e_lo;
  const double Do_13a = D->m01 * D->m03, Do_13a_lo = ksl_product_error(D->m01, D->m03, Do_13a),
      Do_13b = D->m11 * D->m13, Do_13b_lo = ksl_product_error(D->m11, D->m13, Do_13b),
      Do_13c = Do_13a + Do_13b, Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c),
      Do_13c_lo1 = Do_13c_error + Do_13a_lo, Do_13c_lo = Do_13c_lo1 + Do_13b_lo,
      Do_13d = D->m21 * D->m23, Do_13d_lo = ksl_product_error(D->m21, D->m23, Do_13d),
      Do_13e = Do_13c + Do_13d, Do_13e_error = ksl_sum_error(Do_13c, Do_13d, Do_13e),
      Do_13e_lo1 = Do_13e_error + Do_13c_lo, Do_13e_lo = Do_13e_lo1 + Do_13d_lo, Do_13 = -Do_13e,
      Do_13_lo = -Do_13e_lo;
  const double Do_23a = D->m02 * D->m03, Do_23a_lo = ksl_product_error(D->m02, D->m03, Do_23a),
      Do_23b = D->m12 * D->m13, Do_23b_lo = ksl_product_error(D->m12, D->m13, Do_23b),
      Do_23c = Do_23a + Do_23b, Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c),
      Do_23c_lo1 = Do_23c_error + Do_23a_lo, Do_23c_lo = Do_23c_lo1 + Do_23b_lo,
      Do_23d = D->m22 * D->m23, Do_23d_lo = ksl_product_error(D->m22, D->m23, Do_23d),
      Do_23e = Do_23c + Do_23d, Do_23e_error = ksl_sum_error(Do_23c, Do_23d, Do_23e),
      Do_23e_lo1 = Do_23e_error + Do_23c_lo, Do_23e_lo = Do_23e_lo1 + Do_23d_lo, Do_23 = -Do_23e,
      Do_23_lo = -Do_23e_lo;
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
   9 mul, 21 add, 9 product error, 6 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0a_lo = ksl_product_error(R->m00, v->x, vo_0a),
      vo_0b = R->m01 * v->y, vo_0b_lo = ksl_product_error(R->m01, v->y, vo_0b),
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = R->m02 * v->z,
      vo_0d_lo = ksl_product_error(R->m02, v->z, vo_0d), vo_0 = vo_0c + vo_0d,
      vo_0_error = ksl_sum_error(vo_0c, vo_0d, vo_0), vo_0_lo1 = vo_0_error + vo_0c_lo,
      vo_0_lo = vo_0_lo1 + vo_0d_lo;
  const double vo_1a = R->m10 * v->x, vo_1a_lo = ksl_product_error(R->m10, v->x, vo_1a),
      vo_1b = R->m11 * v->y, vo_1b_lo = ksl_product_error(R->m11, v->y, vo_1b),
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = R->m12 * v->z,
      vo_1d_lo = ksl_product_error(R->m12, v->z, vo_1d), vo_1 = vo_1c + vo_1d,
      vo_1_error = ksl_sum_error(vo_1c, vo_1d, vo_1), vo_1_lo1 = vo_1_error + vo_1c_lo,
      vo_1_lo = vo_1_lo1 + vo_1d_lo;
  const double vo_2a = R->m20 * v->x, vo_2a_lo = ksl_product_error(R->m20, v->x, vo_2a),
      vo_2b = R->m21 * v->y, vo_2b_lo = ksl_product_error(R->m21, v->y, vo_2b),
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = R->m22 * v->z,
      vo_2d_lo = ksl_product_error(R->m22, v->z, vo_2d), vo_2 = vo_2c + vo_2d,
      vo_2_error = ksl_sum_error(vo_2c, vo_2d, vo_2), vo_2_lo1 = vo_2_error + vo_2c_lo,
      vo_2_lo = vo_2_lo1 + vo_2d_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 21 add, 9 product error, 6 sum error, 6 neg.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0a_lo = ksl_product_error(R->m00, v->x, vo_0a),
      vo_0b = R->m01 * v->y, vo_0b_lo = ksl_product_error(R->m01, v->y, vo_0b),
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = R->m02 * v->z,
      vo_0d_lo = ksl_product_error(R->m02, v->z, vo_0d), vo_0e = vo_0c + vo_0d,
      vo_0e_error = ksl_sum_error(vo_0c, vo_0d, vo_0e), vo_0e_lo1 = vo_0e_error + vo_0c_lo,
      vo_0e_lo = vo_0e_lo1 + vo_0d_lo, vo_0 = -vo_0e, vo_0_lo = -vo_0e_lo;
  const double vo_1a = R->m10 * v->x, vo_1a_lo = ksl_product_error(R->m10, v->x, vo_1a),
      vo_1b = R->m11 * v->y, vo_1b_lo = ksl_product_error(R->m11, v->y, vo_1b),
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = R->m12 * v->z,
      vo_1d_lo = ksl_product_error(R->m12, v->z, vo_1d), vo_1e = vo_1c + vo_1d,
      vo_1e_error = ksl_sum_error(vo_1c, vo_1d, vo_1e), vo_1e_lo1 = vo_1e_error + vo_1c_lo,
      vo_1e_lo = vo_1e_lo1 + vo_1d_lo, vo_1 = -vo_1e, vo_1_lo = -vo_1e_lo;
  const double vo_2a = R->m20 * v->x, vo_2a_lo = ksl_product_error(R->m20, v->x, vo_2a),
      vo_2b = R->m21 * v->y, vo_2b_lo = ksl_product_error(R->m21, v->y, vo_2b),
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = R->m22 * v->z,
      vo_2d_lo = ksl_product_error(R->m22, v->z, vo_2d), vo_2e = vo_2c + vo_2d,
      vo_2e_error = ksl_sum_error(vo_2c, vo_2d, vo_2e), vo_2e_lo1 = vo_2e_error + vo_2c_lo,
      vo_2e_lo = vo_2e_lo1 + vo_2d_lo, vo_2 = -vo_2e, vo_2_lo = -vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 21 add, 9 product error, 6 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0a_lo = ksl_product_error(R->m00, v->x, vo_0a),
      vo_0b = R->m10 * v->y, vo_0b_lo = ksl_product_error(R->m10, v->y, vo_0b),
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = R->m20 * v->z,
      vo_0d_lo = ksl_product_error(R->m20, v->z, vo_0d), vo_0 = vo_0c + vo_0d,
      vo_0_error = ksl_sum_error(vo_0c, vo_0d, vo_0), vo_0_lo1 = vo_0_error + vo_0c_lo,
      vo_0_lo = vo_0_lo1 + vo_0d_lo;
  const double vo_1a = R->m01 * v->x, vo_1a_lo = ksl_product_error(R->m01, v->x, vo_1a),
      vo_1b = R->m11 * v->y, vo_1b_lo = ksl_product_error(R->m11, v->y, vo_1b),
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = R->m21 * v->z,
      vo_1d_lo = ksl_product_error(R->m21, v->z, vo_1d), vo_1 = vo_1c + vo_1d,
      vo_1_error = ksl_sum_error(vo_1c, vo_1d, vo_1), vo_1_lo1 = vo_1_error + vo_1c_lo,
      vo_1_lo = vo_1_lo1 + vo_1d_lo;
  const double vo_2a = R->m02 * v->x, vo_2a_lo = ksl_product_error(R->m02, v->x, vo_2a),
      vo_2b = R->m12 * v->y, vo_2b_lo = ksl_product_error(R->m12, v->y, vo_2b),
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = R->m22 * v->z,
      vo_2d_lo = ksl_product_error(R->m22, v->z, vo_2d), vo_2 = vo_2c + vo_2d,
      vo_2_error = ksl_sum_error(vo_2c, vo_2d, vo_2), vo_2_lo1 = vo_2_error + vo_2c_lo,
      vo_2_lo = vo_2_lo1 + vo_2d_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 21 add, 9 product error, 6 sum error, 6 neg.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0a_lo = ksl_product_error(R->m00, v->x, vo_0a),
      vo_0b = R->m10 * v->y, vo_0b_lo = ksl_product_error(R->m10, v->y, vo_0b),
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = R->m20 * v->z,
      vo_0d_lo = ksl_product_error(R->m20, v->z, vo_0d), vo_0e = vo_0c + vo_0d,
      vo_0e_error = ksl_sum_error(vo_0c, vo_0d, vo_0e), vo_0e_lo1 = vo_0e_error + vo_0c_lo,
      vo_0e_lo = vo_0e_lo1 + vo_0d_lo, vo_0 = -vo_0e, vo_0_lo = -vo_0e_lo;
  const double vo_1a = R->m01 * v->x, vo_1a_lo = ksl_product_error(R->m01, v->x, vo_1a),
      vo_1b = R->m11 * v->y, vo_1b_lo = ksl_product_error(R->m11, v->y, vo_1b),
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = R->m21 * v->z,
      vo_1d_lo = ksl_product_error(R->m21, v->z, vo_1d), vo_1e = vo_1c + vo_1d,
      vo_1e_error = ksl_sum_error(vo_1c, vo_1d, vo_1e), vo_1e_lo1 = vo_1e_error + vo_1c_lo,
      vo_1e_lo = vo_1e_lo1 + vo_1d_lo, vo_1 = -vo_1e, vo_1_lo = -vo_1e_lo;
  const double vo_2a = R->m02 * v->x, vo_2a_lo = ksl_product_error(R->m02, v->x, vo_2a),
      vo_2b = R->m12 * v->y, vo_2b_lo = ksl_product_error(R->m12, v->y, vo_2b),
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = R->m22 * v->z,
      vo_2d_lo = ksl_product_error(R->m22, v->z, vo_2d), vo_2e = vo_2c + vo_2d,
      vo_2e_error = ksl_sum_error(vo_2c, vo_2d, vo_2e), vo_2e_lo1 = vo_2e_error + vo_2c_lo,
      vo_2e_lo = vo_2e_lo1 + vo_2d_lo, vo_2 = -vo_2e, vo_2_lo = -vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 27 add, 9 product error, 9 sum error.
   Error <= u |result| + 14 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = D->m00 * v->x, vo_0a_lo = ksl_product_error(D->m00, v->x, vo_0a),
      vo_0b = D->m01 * v->y, vo_0b_lo = ksl_product_error(D->m01, v->y, vo_0b),
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = D->m02 * v->z,
      vo_0d_lo = ksl_product_error(D->m02, v->z, vo_0d), vo_0e = vo_0c + vo_0d,
      vo_0e_error = ksl_sum_error(vo_0c, vo_0d, vo_0e), vo_0e_lo1 = vo_0e_error + vo_0c_lo,
      vo_0e_lo = vo_0e_lo1 + vo_0d_lo, vo_0 = vo_0e + D->m03,
      vo_0_error = ksl_sum_error(vo_0e, D->m03, vo_0), vo_0_lo = vo_0_error + vo_0e_lo;
  const double vo_1a = D->m10 * v->x, vo_1a_lo = ksl_product_error(D->m10, v->x, vo_1a),
      vo_1b = D->m11 * v->y, vo_1b_lo = ksl_product_error(D->m11, v->y, vo_1b),
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = D->m12 * v->z,
      vo_1d_lo = ksl_product_error(D->m12, v->z, vo_1d), vo_1e = vo_1c + vo_1d,
      vo_1e_error = ksl_sum_error(vo_1c, vo_1d, vo_1e), vo_1e_lo1 = vo_1e_error + vo_1c_lo,
      vo_1e_lo = vo_1e_lo1 + vo_1d_lo, vo_1 = vo_1e + D->m13,
      vo_1_error = ksl_sum_error(vo_1e, D->m13, vo_1), vo_1_lo = vo_1_error + vo_1e_lo;
  const double vo_2a = D->m20 * v->x, vo_2a_lo = ksl_product_error(D->m20, v->x, vo_2a),
      vo_2b = D->m21 * v->y, vo_2b_lo = ksl_product_error(D->m21, v->y, vo_2b),
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = D->m22 * v->z,
      vo_2d_lo = ksl_product_error(D->m22, v->z, vo_2d), vo_2e = vo_2c + vo_2d,
      vo_2e_error = ksl_sum_error(vo_2c, vo_2d, vo_2e), vo_2e_lo1 = vo_2e_error + vo_2c_lo,
      vo_2e_lo = vo_2e_lo1 + vo_2d_lo, vo_2 = vo_2e + D->m23,
      vo_2_error = ksl_sum_error(vo_2e, D->m23, vo_2), vo_2_lo = vo_2_error + vo_2e_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   18 mul, 33 add, 9 product error, 9 sum error.
   Error <= u |result| + 17 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dinvv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03, p_0_lo = ksl_difference_error(v->x, D->m03, p_0);
  const double p_1 = v->y - D->m13, p_1_lo = ksl_difference_error(v->y, D->m13, p_1);
  const double p_2 = v->z - D->m23, p_2_lo = ksl_difference_error(v->z, D->m23, p_2);
  const double vo_0a = D->m00 * p_0, vo_0a_cross1 = D->m00 * p_0_lo,
      vo_0a_error = ksl_product_error(D->m00, p_0, vo_0a), vo_0a_lo = vo_0a_error + vo_0a_cross1,
      vo_0b = D->m10 * p_1, vo_0b_cross1 = D->m10 * p_1_lo,
      vo_0b_error = ksl_product_error(D->m10, p_1, vo_0b), vo_0b_lo = vo_0b_error + vo_0b_cross1,
      vo_0c = vo_0a + vo_0b, vo_0c_error = ksl_sum_error(vo_0a, vo_0b, vo_0c),
      vo_0c_lo1 = vo_0c_error + vo_0a_lo, vo_0c_lo = vo_0c_lo1 + vo_0b_lo, vo_0d = D->m20 * p_2,
      vo_0d_cross1 = D->m20 * p_2_lo, vo_0d_error = ksl_product_error(D->m20, p_2, vo_0d),
      vo_0d_lo = vo_0d_error + vo_0d_cross1, vo_0 = vo_0c + vo_0d,
      vo_0_error = ksl_sum_error(vo_0c, vo_0d, vo_0), vo_0_lo1 = vo_0_error + vo_0c_lo,
      vo_0_lo = vo_0_lo1 + vo_0d_lo;
  const double vo_1a = D->m01 * p_0, vo_1a_cross1 = D->m01 * p_0_lo,
      vo_1a_error = ksl_product_error(D->m01, p_0, vo_1a), vo_1a_lo = vo_1a_error + vo_1a_cross1,
      vo_1b = D->m11 * p_1, vo_1b_cross1 = D->m11 * p_1_lo,
      vo_1b_error = ksl_product_error(D->m11, p_1, vo_1b), vo_1b_lo = vo_1b_error + vo_1b_cross1,
      vo_1c = vo_1a + vo_1b, vo_1c_error = ksl_sum_error(vo_1a, vo_1b, vo_1c),
      vo_1c_lo1 = vo_1c_error + vo_1a_lo, vo_1c_lo = vo_1c_lo1 + vo_1b_lo, vo_1d = D->m21 * p_2,
      vo_1d_cross1 = D->m21 * p_2_lo, vo_1d_error = ksl_product_error(D->m21, p_2, vo_1d),
      vo_1d_lo = vo_1d_error + vo_1d_cross1, vo_1 = vo_1c + vo_1d,
      vo_1_error = ksl_sum_error(vo_1c, vo_1d, vo_1), vo_1_lo1 = vo_1_error + vo_1c_lo,
      vo_1_lo = vo_1_lo1 + vo_1d_lo;
  const double vo_2a = D->m02 * p_0, vo_2a_cross1 = D->m02 * p_0_lo,
      vo_2a_error = ksl_product_error(D->m02, p_0, vo_2a), vo_2a_lo = vo_2a_error + vo_2a_cross1,
      vo_2b = D->m12 * p_1, vo_2b_cross1 = D->m12 * p_1_lo,
      vo_2b_error = ksl_product_error(D->m12, p_1, vo_2b), vo_2b_lo = vo_2b_error + vo_2b_cross1,
      vo_2c = vo_2a + vo_2b, vo_2c_error = ksl_sum_error(vo_2a, vo_2b, vo_2c),
      vo_2c_lo1 = vo_2c_error + vo_2a_lo, vo_2c_lo = vo_2c_lo1 + vo_2b_lo, vo_2d = D->m22 * p_2,
      vo_2d_cross1 = D->m22 * p_2_lo, vo_2d_error = ksl_product_error(D->m22, p_2, vo_2d),
      vo_2d_lo = vo_2d_error + vo_2d_cross1, vo_2 = vo_2c + vo_2d,
      vo_2_error = ksl_sum_error(vo_2c, vo_2d, vo_2), vo_2_lo1 = vo_2_error + vo_2c_lo,
      vo_2_lo = vo_2_lo1 + vo_2d_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 63 add, 27 product error, 18 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00a_lo = ksl_product_error(R1->m00, R2->m00, Ro_00a),
      Ro_00b = R1->m01 * R2->m10, Ro_00b_lo = ksl_product_error(R1->m01, R2->m10, Ro_00b),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00c),
      Ro_00c_lo1 = Ro_00c_error + Ro_00a_lo, Ro_00c_lo = Ro_00c_lo1 + Ro_00b_lo,
      Ro_00d = R1->m02 * R2->m20, Ro_00d_lo = ksl_product_error(R1->m02, R2->m20, Ro_00d),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_error = ksl_sum_error(Ro_00c, Ro_00d, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00c_lo, Ro_00_lo = Ro_00_lo1 + Ro_00d_lo;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01a_lo = ksl_product_error(R1->m00, R2->m01, Ro_01a),
      Ro_01b = R1->m01 * R2->m11, Ro_01b_lo = ksl_product_error(R1->m01, R2->m11, Ro_01b),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01c),
      Ro_01c_lo1 = Ro_01c_error + Ro_01a_lo, Ro_01c_lo = Ro_01c_lo1 + Ro_01b_lo,
      Ro_01d = R1->m02 * R2->m21, Ro_01d_lo = ksl_product_error(R1->m02, R2->m21, Ro_01d),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_error = ksl_sum_error(Ro_01c, Ro_01d, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01c_lo, Ro_01_lo = Ro_01_lo1 + Ro_01d_lo;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02a_lo = ksl_product_error(R1->m00, R2->m02, Ro_02a),
      Ro_02b = R1->m01 * R2->m12, Ro_02b_lo = ksl_product_error(R1->m01, R2->m12, Ro_02b),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02c),
      Ro_02c_lo1 = Ro_02c_error + Ro_02a_lo, Ro_02c_lo = Ro_02c_lo1 + Ro_02b_lo,
      Ro_02d = R1->m02 * R2->m22, Ro_02d_lo = ksl_product_error(R1->m02, R2->m22, Ro_02d),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_error = ksl_sum_error(Ro_02c, Ro_02d, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02c_lo, Ro_02_lo = Ro_02_lo1 + Ro_02d_lo;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10a_lo = ksl_product_error(R1->m10, R2->m00, Ro_10a),
      Ro_10b = R1->m11 * R2->m10, Ro_10b_lo = ksl_product_error(R1->m11, R2->m10, Ro_10b),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10c),
      Ro_10c_lo1 = Ro_10c_error + Ro_10a_lo, Ro_10c_lo = Ro_10c_lo1 + Ro_10b_lo,
      Ro_10d = R1->m12 * R2->m20, Ro_10d_lo = ksl_product_error(R1->m12, R2->m20, Ro_10d),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_error = ksl_sum_error(Ro_10c, Ro_10d, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10c_lo, Ro_10_lo = Ro_10_lo1 + Ro_10d_lo;
  const double Ro_11a = R1->m10 * R2->m01, Ro_11a_lo = ksl_product_error(R1->m10, R2->m01, Ro_11a),
      Ro_11b = R1->m11 * R2->m11, Ro_11b_lo = ksl_product_error(R1->m11, R2->m11, Ro_11b),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11c),
      Ro_11c_lo1 = Ro_11c_error + Ro_11a_lo, Ro_11c_lo = Ro_11c_lo1 + Ro_11b_lo,
      Ro_11d = R1->m12 * R2->m21, Ro_11d_lo = ksl_product_error(R1->m12, R2->m21, Ro_11d),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_error = ksl_sum_error(Ro_11c, Ro_11d, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11c_lo, Ro_11_lo = Ro_11_lo1 + Ro_11d_lo;
  const double Ro_12a = R1->m10 * R2->m02, Ro_12a_lo = ksl_product_error(R1->m10, R2->m02, Ro_12a),
      Ro_12b = R1->m11 * R2->m12, Ro_12b_lo = ksl_product_error(R1->m11, R2->m12, Ro_12b),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12c),
      Ro_12c_lo1 = Ro_12c_error + Ro_12a_lo, Ro_12c_lo = Ro_12c_lo1 + Ro_12b_lo,
      Ro_12d = R1->m12 * R2->m22, Ro_12d_lo = ksl_product_error(R1->m12, R2->m22, Ro_12d),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_error = ksl_sum_error(Ro_12c, Ro_12d, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12c_lo, Ro_12_lo = Ro_12_lo1 + Ro_12d_lo;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20a_lo = ksl_product_error(R1->m20, R2->m00, Ro_20a),
      Ro_20b = R1->m21 * R2->m10, Ro_20b_lo = ksl_product_error(R1->m21, R2->m10, Ro_20b),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20c),
      Ro_20c_lo1 = Ro_20c_error + Ro_20a_lo, Ro_20c_lo = Ro_20c_lo1 + Ro_20b_lo,
      Ro_20d = R1->m22 * R2->m20, Ro_20d_lo = ksl_product_error(R1->m22, R2->m20, Ro_20d),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_error = ksl_sum_error(Ro_20c, Ro_20d, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20c_lo, Ro_20_lo = Ro_20_lo1 + Ro_20d_lo;
  const double Ro_21a = R1->m20 * R2->m01, Ro_21a_lo = ksl_product_error(R1->m20, R2->m01, Ro_21a),
      Ro_21b = R1->m21 * R2->m11, Ro_21b_lo = ksl_product_error(R1->m21, R2->m11, Ro_21b),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21c),
      Ro_21c_lo1 = Ro_21c_error + Ro_21a_lo, Ro_21c_lo = Ro_21c_lo1 + Ro_21b_lo,
      Ro_21d = R1->m22 * R2->m21, Ro_21d_lo = ksl_product_error(R1->m22, R2->m21, Ro_21d),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_error = ksl_sum_error(Ro_21c, Ro_21d, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21c_lo, Ro_21_lo = Ro_21_lo1 + Ro_21d_lo;
  const double Ro_22a = R1->m20 * R2->m02, Ro_22a_lo = ksl_product_error(R1->m20, R2->m02, Ro_22a),
      Ro_22b = R1->m21 * R2->m12, Ro_22b_lo = ksl_product_error(R1->m21, R2->m12, Ro_22b),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22c),
      Ro_22c_lo1 = Ro_22c_error + Ro_22a_lo, Ro_22c_lo = Ro_22c_lo1 + Ro_22b_lo,
      Ro_22d = R1->m22 * R2->m22, Ro_22d_lo = ksl_product_error(R1->m22, R2->m22, Ro_22d),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_error = ksl_sum_error(Ro_22c, Ro_22d, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22c_lo, Ro_22_lo = Ro_22_lo1 + Ro_22d_lo;
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
   27 mul, 63 add, 27 product error, 18 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrinv_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00a_lo = ksl_product_error(R1->m00, R2->m00, Ro_00a),
      Ro_00b = R1->m01 * R2->m01, Ro_00b_lo = ksl_product_error(R1->m01, R2->m01, Ro_00b),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00c),
      Ro_00c_lo1 = Ro_00c_error + Ro_00a_lo, Ro_00c_lo = Ro_00c_lo1 + Ro_00b_lo,
      Ro_00d = R1->m02 * R2->m02, Ro_00d_lo = ksl_product_error(R1->m02, R2->m02, Ro_00d),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_error = ksl_sum_error(Ro_00c, Ro_00d, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00c_lo, Ro_00_lo = Ro_00_lo1 + Ro_00d_lo;
  const double Ro_01a = R1->m00 * R2->m10, Ro_01a_lo = ksl_product_error(R1->m00, R2->m10, Ro_01a),
      Ro_01b = R1->m01 * R2->m11, Ro_01b_lo = ksl_product_error(R1->m01, R2->m11, Ro_01b),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01c),
      Ro_01c_lo1 = Ro_01c_error + Ro_01a_lo, Ro_01c_lo = Ro_01c_lo1 + Ro_01b_lo,
      Ro_01d = R1->m02 * R2->m12, Ro_01d_lo = ksl_product_error(R1->m02, R2->m12, Ro_01d),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_error = ksl_sum_error(Ro_01c, Ro_01d, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01c_lo, Ro_01_lo = Ro_01_lo1 + Ro_01d_lo;
  const double Ro_02a = R1->m00 * R2->m20, Ro_02a_lo = ksl_product_error(R1->m00, R2->m20, Ro_02a),
      Ro_02b = R1->m01 * R2->m21, Ro_02b_lo = ksl_product_error(R1->m01, R2->m21, Ro_02b),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02c),
      Ro_02c_lo1 = Ro_02c_error + Ro_02a_lo, Ro_02c_lo = Ro_02c_lo1 + Ro_02b_lo,
      Ro_02d = R1->m02 * R2->m22, Ro_02d_lo = ksl_product_error(R1->m02, R2->m22, Ro_02d),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_error = ksl_sum_error(Ro_02c, Ro_02d, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02c_lo, Ro_02_lo = Ro_02_lo1 + Ro_02d_lo;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10a_lo = ksl_product_error(R1->m10, R2->m00, Ro_10a),
      Ro_10b = R1->m11 * R2->m01, Ro_10b_lo = ksl_product_error(R1->m11, R2->m01, Ro_10b),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10c),
      Ro_10c_lo1 = Ro_10c_error + Ro_10a_lo, Ro_10c_lo = Ro_10c_lo1 + Ro_10b_lo,
      Ro_10d = R1->m12 * R2->m02, Ro_10d_lo = ksl_product_error(R1->m12, R2->m02, Ro_10d),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_error = ksl_sum_error(Ro_10c, Ro_10d, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10c_lo, Ro_10_lo = Ro_10_lo1 + Ro_10d_lo;
  const double Ro_11a = R1->m10 * R2->m10, Ro_11a_lo = ksl_product_error(R1->m10, R2->m10, Ro_11a),
      Ro_11b = R1->m11 * R2->m11, Ro_11b_lo = ksl_product_error(R1->m11, R2->m11, Ro_11b),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11c),
      Ro_11c_lo1 = Ro_11c_error + Ro_11a_lo, Ro_11c_lo = Ro_11c_lo1 + Ro_11b_lo,
      Ro_11d = R1->m12 * R2->m12, Ro_11d_lo = ksl_product_error(R1->m12, R2->m12, Ro_11d),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_error = ksl_sum_error(Ro_11c, Ro_11d, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11c_lo, Ro_11_lo = Ro_11_lo1 + Ro_11d_lo;
  const double Ro_12a = R1->m10 * R2->m20, Ro_12a_lo = ksl_product_error(R1->m10, R2->m20, Ro_12a),
      Ro_12b = R1->m11 * R2->m21, Ro_12b_lo = ksl_product_error(R1->m11, R2->m21, Ro_12b),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12c),
      Ro_12c_lo1 = Ro_12c_error + Ro_12a_lo, Ro_12c_lo = Ro_12c_lo1 + Ro_12b_lo,
      Ro_12d = R1->m12 * R2->m22, Ro_12d_lo = ksl_product_error(R1->m12, R2->m22, Ro_12d),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_error = ksl_sum_error(Ro_12c, Ro_12d, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12c_lo, Ro_12_lo = Ro_12_lo1 + Ro_12d_lo;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20a_lo = ksl_product_error(R1->m20, R2->m00, Ro_20a),
      Ro_20b = R1->m21 * R2->m01, Ro_20b_lo = ksl_product_error(R1->m21, R2->m01, Ro_20b),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20c),
      Ro_20c_lo1 = Ro_20c_error + Ro_20a_lo, Ro_20c_lo = Ro_20c_lo1 + Ro_20b_lo,
      Ro_20d = R1->m22 * R2->m02, Ro_20d_lo = ksl_product_error(R1->m22, R2->m02, Ro_20d),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_error = ksl_sum_error(Ro_20c, Ro_20d, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20c_lo, Ro_20_lo = Ro_20_lo1 + Ro_20d_lo;
  const double Ro_21a = R1->m20 * R2->m10, Ro_21a_lo = ksl_product_error(R1->m20, R2->m10, Ro_21a),
      Ro_21b = R1->m21 * R2->m11, Ro_21b_lo = ksl_product_error(R1->m21, R2->m11, Ro_21b),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21c),
      Ro_21c_lo1 = Ro_21c_error + Ro_21a_lo, Ro_21c_lo = Ro_21c_lo1 + Ro_21b_lo,
      Ro_21d = R1->m22 * R2->m12, Ro_21d_lo = ksl_product_error(R1->m22, R2->m12, Ro_21d),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_error = ksl_sum_error(Ro_21c, Ro_21d, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21c_lo, Ro_21_lo = Ro_21_lo1 + Ro_21d_lo;
  const double Ro_22a = R1->m20 * R2->m20, Ro_22a_lo = ksl_product_error(R1->m20, R2->m20, Ro_22a),
      Ro_22b = R1->m21 * R2->m21, Ro_22b_lo = ksl_product_error(R1->m21, R2->m21, Ro_22b),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22c),
      Ro_22c_lo1 = Ro_22c_error + Ro_22a_lo, Ro_22c_lo = Ro_22c_lo1 + Ro_22b_lo,
      Ro_22d = R1->m22 * R2->m22, Ro_22d_lo = ksl_product_error(R1->m22, R2->m22, Ro_22d),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_error = ksl_sum_error(Ro_22c, Ro_22d, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22c_lo, Ro_22_lo = Ro_22_lo1 + Ro_22d_lo;
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
   27 mul, 63 add, 27 product error, 18 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00a_lo = ksl_product_error(R1->m00, R2->m00, Ro_00a),
      Ro_00b = R1->m10 * R2->m10, Ro_00b_lo = ksl_product_error(R1->m10, R2->m10, Ro_00b),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00c),
      Ro_00c_lo1 = Ro_00c_error + Ro_00a_lo, Ro_00c_lo = Ro_00c_lo1 + Ro_00b_lo,
      Ro_00d = R1->m20 * R2->m20, Ro_00d_lo = ksl_product_error(R1->m20, R2->m20, Ro_00d),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_error = ksl_sum_error(Ro_00c, Ro_00d, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00c_lo, Ro_00_lo = Ro_00_lo1 + Ro_00d_lo;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01a_lo = ksl_product_error(R1->m00, R2->m01, Ro_01a),
      Ro_01b = R1->m10 * R2->m11, Ro_01b_lo = ksl_product_error(R1->m10, R2->m11, Ro_01b),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01c),
      Ro_01c_lo1 = Ro_01c_error + Ro_01a_lo, Ro_01c_lo = Ro_01c_lo1 + Ro_01b_lo,
      Ro_01d = R1->m20 * R2->m21, Ro_01d_lo = ksl_product_error(R1->m20, R2->m21, Ro_01d),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_error = ksl_sum_error(Ro_01c, Ro_01d, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01c_lo, Ro_01_lo = Ro_01_lo1 + Ro_01d_lo;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02a_lo = ksl_product_error(R1->m00, R2->m02, Ro_02a),
      Ro_02b = R1->m10 * R2->m12, Ro_02b_lo = ksl_product_error(R1->m10, R2->m12, Ro_02b),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02c),
      Ro_02c_lo1 = Ro_02c_error + Ro_02a_lo, Ro_02c_lo = Ro_02c_lo1 + Ro_02b_lo,
      Ro_02d = R1->m20 * R2->m22, Ro_02d_lo = ksl_product_error(R1->m20, R2->m22, Ro_02d),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_error = ksl_sum_error(Ro_02c, Ro_02d, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02c_lo, Ro_02_lo = Ro_02_lo1 + Ro_02d_lo;
  const double Ro_10a = R1->m01 * R2->m00, Ro_10a_lo = ksl_product_error(R1->m01, R2->m00, Ro_10a),
      Ro_10b = R1->m11 * R2->m10, Ro_10b_lo = ksl_product_error(R1->m11, R2->m10, Ro_10b),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10c),
      Ro_10c_lo1 = Ro_10c_error + Ro_10a_lo, Ro_10c_lo = Ro_10c_lo1 + Ro_10b_lo,
      Ro_10d = R1->m21 * R2->m20, Ro_10d_lo = ksl_product_error(R1->m21, R2->m20, Ro_10d),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_error = ksl_sum_error(Ro_10c, Ro_10d, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10c_lo, Ro_10_lo = Ro_10_lo1 + Ro_10d_lo;
  const double Ro_11a = R1->m01 * R2->m01, Ro_11a_lo = ksl_product_error(R1->m01, R2->m01, Ro_11a),
      Ro_11b = R1->m11 * R2->m11, Ro_11b_lo = ksl_product_error(R1->m11, R2->m11, Ro_11b),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11c),
      Ro_11c_lo1 = Ro_11c_error + Ro_11a_lo, Ro_11c_lo = Ro_11c_lo1 + Ro_11b_lo,
      Ro_11d = R1->m21 * R2->m21, Ro_11d_lo = ksl_product_error(R1->m21, R2->m21, Ro_11d),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_error = ksl_sum_error(Ro_11c, Ro_11d, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11c_lo, Ro_11_lo = Ro_11_lo1 + Ro_11d_lo;
  const double Ro_12a = R1->m01 * R2->m02, Ro_12a_lo = ksl_product_error(R1->m01, R2->m02, Ro_12a),
      Ro_12b = R1->m11 * R2->m12, Ro_12b_lo = ksl_product_error(R1->m11, R2->m12, Ro_12b),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12c),
      Ro_12c_lo1 = Ro_12c_error + Ro_12a_lo, Ro_12c_lo = Ro_12c_lo1 + Ro_12b_lo,
      Ro_12d = R1->m21 * R2->m22, Ro_12d_lo = ksl_product_error(R1->m21, R2->m22, Ro_12d),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_error = ksl_sum_error(Ro_12c, Ro_12d, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12c_lo, Ro_12_lo = Ro_12_lo1 + Ro_12d_lo;
  const double Ro_20a = R1->m02 * R2->m00, Ro_20a_lo = ksl_product_error(R1->m02, R2->m00, Ro_20a),
      Ro_20b = R1->m12 * R2->m10, Ro_20b_lo = ksl_product_error(R1->m12, R2->m10, Ro_20b),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20c),
      Ro_20c_lo1 = Ro_20c_error + Ro_20a_lo, Ro_20c_lo = Ro_20c_lo1 + Ro_20b_lo,
      Ro_20d = R1->m22 * R2->m20, Ro_20d_lo = ksl_product_error(R1->m22, R2->m20, Ro_20d),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_error = ksl_sum_error(Ro_20c, Ro_20d, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20c_lo, Ro_20_lo = Ro_20_lo1 + Ro_20d_lo;
  const double Ro_21a = R1->m02 * R2->m01, Ro_21a_lo = ksl_product_error(R1->m02, R2->m01, Ro_21a),
      Ro_21b = R1->m12 * R2->m11, Ro_21b_lo = ksl_product_error(R1->m12, R2->m11, Ro_21b),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21c),
      Ro_21c_lo1 = Ro_21c_error + Ro_21a_lo, Ro_21c_lo = Ro_21c_lo1 + Ro_21b_lo,
      Ro_21d = R1->m22 * R2->m21, Ro_21d_lo = ksl_product_error(R1->m22, R2->m21, Ro_21d),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_error = ksl_sum_error(Ro_21c, Ro_21d, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21c_lo, Ro_21_lo = Ro_21_lo1 + Ro_21d_lo;
  const double Ro_22a = R1->m02 * R2->m02, Ro_22a_lo = ksl_product_error(R1->m02, R2->m02, Ro_22a),
      Ro_22b = R1->m12 * R2->m12, Ro_22b_lo = ksl_product_error(R1->m12, R2->m12, Ro_22b),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22c),
      Ro_22c_lo1 = Ro_22c_error + Ro_22a_lo, Ro_22c_lo = Ro_22c_lo1 + Ro_22b_lo,
      Ro_22d = R1->m22 * R2->m22, Ro_22d_lo = ksl_product_error(R1->m22, R2->m22, Ro_22d),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_error = ksl_sum_error(Ro_22c, Ro_22d, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22c_lo, Ro_22_lo = Ro_22_lo1 + Ro_22d_lo;
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
   36 mul, 90 add, 36 product error, 27 sum error.
   Error <= u |result| + (R: 10, t: 14) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double Do_00a = D1->m00 * D2->m00, Do_00a_lo = ksl_product_error(D1->m00, D2->m00, Do_00a),
      Do_00b = D1->m01 * D2->m10, Do_00b_lo = ksl_product_error(D1->m01, D2->m10, Do_00b),
      Do_00c = Do_00a + Do_00b, Do_00c_error = ksl_sum_error(Do_00a, Do_00b, Do_00c),
      Do_00c_lo1 = Do_00c_error + Do_00a_lo, Do_00c_lo = Do_00c_lo1 + Do_00b_lo,
      Do_00d = D1->m02 * D2->m20, Do_00d_lo = ksl_product_error(D1->m02, D2->m20, Do_00d),
      Do_00 = Do_00c + Do_00d, Do_00_error = ksl_sum_error(Do_00c, Do_00d, Do_00),
      Do_00_lo1 = Do_00_error + Do_00c_lo, Do_00_lo = Do_00_lo1 + Do_00d_lo;
  const double Do_01a = D1->m00 * D2->m01, Do_01a_lo = ksl_product_error(D1->m00, D2->m01, Do_01a),
      Do_01b = D1->m01 * D2->m11, Do_01b_lo = ksl_product_error(D1->m01, D2->m11, Do_01b),
      Do_01c = Do_01a + Do_01b, Do_01c_error = ksl_sum_error(Do_01a, Do_01b, Do_01c),
      Do_01c_lo1 = Do_01c_error + Do_01a_lo, Do_01c_lo = Do_01c_lo1 + Do_01b_lo,
      Do_01d = D1->m02 * D2->m21, Do_01d_lo = ksl_product_error(D1->m02, D2->m21, Do_01d),
      Do_01 = Do_01c + Do_01d, Do_01_error = ksl_sum_error(Do_01c, Do_01d, Do_01),
      Do_01_lo1 = Do_01_error + Do_01c_lo, Do_01_lo = Do_01_lo1 + Do_01d_lo;
  const double Do_02a = D1->m00 * D2->m02, Do_02a_lo = ksl_product_error(D1->m00, D2->m02, Do_02a),
      Do_02b = D1->m01 * D2->m12, Do_02b_lo = ksl_product_error(D1->m01, D2->m12, Do_02b),
      Do_02c = Do_02a + Do_02b, Do_02c_error = ksl_sum_error(Do_02a, Do_02b, Do_02c),
      Do_02c_lo1 = Do_02c_error + Do_02a_lo, Do_02c_lo = Do_02c_lo1 + Do_02b_lo,
      Do_02d = D1->m02 * D2->m22, Do_02d_lo = ksl_product_error(D1->m02, D2->m22, Do_02d),
      Do_02 = Do_02c + Do_02d, Do_02_error = ksl_sum_error(Do_02c, Do_02d, Do_02),
      Do_02_lo1 = Do_02_error + Do_02c_lo, Do_02_lo = Do_02_lo1 + Do_02d_lo;
  const double Do_03a = D1->m00 * D2->m03, Do_03a_lo = ksl_product_error(D1->m00, D2->m03, Do_03a),
      Do_03b = D1->m01 * D2->m13, Do_03b_lo = ksl_product_error(D1->m01, D2->m13, Do_03b),
      Do_03c = Do_03a + Do_03b, Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c),
      Do_03c_lo1 = Do_03c_error + Do_03a_lo, Do_03c_lo = Do_03c_lo1 + Do_03b_lo,
      Do_03d = D1->m02 * D2->m23, Do_03d_lo = ksl_product_error(D1->m02, D2->m23, Do_03d),
      Do_03e = Do_03c + Do_03d, Do_03e_error = ksl_sum_error(Do_03c, Do_03d, Do_03e),
      Do_03e_lo1 = Do_03e_error + Do_03c_lo, Do_03e_lo = Do_03e_lo1 + Do_03d_lo,
      Do_03 = Do_03e + D1->m03, Do_03_error = ksl_sum_error(Do_03e, D1->m03, Do_03),
      Do_03_lo = Do_03_error + Do_03e_lo;
  const double Do_10a = D1->m10 * D2->m00, Do_10a_lo = ksl_product_error(D1->m10, D2->m00, Do_10a),
      Do_10b = D1->m11 * D2->m10, Do_10b_lo = ksl_product_error(D1->m11, D2->m10, Do_10b),
      Do_10c = Do_10a + Do_10b, Do_10c_error = ksl_sum_error(Do_10a, Do_10b, Do_10c),
      Do_10c_lo1 = Do_10c_error + Do_10a_lo, Do_10c_lo = Do_10c_lo1 + Do_10b_lo,
      Do_10d = D1->m12 * D2->m20, Do_10d_lo = ksl_product_error(D1->m12, D2->m20, Do_10d),
      Do_10 = Do_10c + Do_10d, Do_10_error = ksl_sum_error(Do_10c, Do_10d, Do_10),
      Do_10_lo1 = Do_10_error + Do_10c_lo, Do_10_lo = Do_10_lo1 + Do_10d_lo;
  const double Do_11a = D1->m10 * D2->m01, Do_11a_lo = ksl_product_error(D1->m10, D2->m01, Do_11a),
      Do_11b = D1->m11 * D2->m11, Do_11b_lo = ksl_product_error(D1->m11, D2->m11, Do_11b),
      Do_11c = Do_11a + Do_11b, Do_11c_error = ksl_sum_error(Do_11a, Do_11b, Do_11c),
      Do_11c_lo1 = Do_11c_error + Do_11a_lo, Do_11c_lo = Do_11c_lo1 + Do_11b_lo,
      Do_11d = D1->m12 * D2->m21, Do_11d_lo = ksl_product_error(D1->m12, D2->m21, Do_11d),
      Do_11 = Do_11c + Do_11d, Do_11_error = ksl_sum_error(Do_11c, Do_11d, Do_11),
      Do_11_lo1 = Do_11_error + Do_11c_lo, Do_11_lo = Do_11_lo1 + Do_11d_lo;
  const double Do_12a = D1->m10 * D2->m02, Do_12a_lo = ksl_product_error(D1->m10, D2->m02, Do_12a),
      Do_12b = D1->m11 * D2->m12, Do_12b_lo = ksl_product_error(D1->m11, D2->m12, Do_12b),
      Do_12c = Do_12a + Do_12b, Do_12c_error = ksl_sum_error(Do_12a, Do_12b, Do_12c),
      Do_12c_lo1 = Do_12c_error + Do_12a_lo, Do_12c_lo = Do_12c_lo1 + Do_12b_lo,
      Do_12d = D1->m12 * D2->m22, Do_12d_lo = ksl_product_error(D1->m12, D2->m22, Do_12d),
      Do_12 = Do_12c + Do_12d, Do_12_error = ksl_sum_error(Do_12c, Do_12d, Do_12),
      Do_12_lo1 = Do_12_error + Do_12c_lo, Do_12_lo = Do_12_lo1 + Do_12d_lo;
  const double Do_13a = D1->m10 * D2->m03, Do_13a_lo = ksl_product_error(D1->m10, D2->m03, Do_13a),
      Do_13b = D1->m11 * D2->m13, Do_13b_lo = ksl_product_error(D1->m11, D2->m13, Do_13b),
      Do_13c = Do_13a + Do_13b, Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c),
      Do_13c_lo1 = Do_13c_error + Do_13a_lo, Do_13c_lo = Do_13c_lo1 + Do_13b_lo,
      Do_13d = D1->m12 * D2->m23, Do_13d_lo = ksl_product_error(D1->m12, D2->m23, Do_13d),
      Do_13e = Do_13c + Do_13d, Do_13e_error = ksl_sum_error(Do_13c, Do_13d, Do_13e),
      Do_13e_lo1 = Do_13e_error + Do_13c_lo, Do_13e_lo = Do_13e_lo1 + Do_13d_lo,
      Do_13 = Do_13e + D1->m13, Do_13_error = ksl_sum_error(Do_13e, D1->m13, Do_13),
      Do_13_lo = Do_13_error + Do_13e_lo;
  const double Do_20a = D1->m20 * D2->m00, Do_20a_lo = ksl_product_error(D1->m20, D2->m00, Do_20a),
      Do_20b = D1->m21 * D2->m10, Do_20b_lo = ksl_product_error(D1->m21, D2->m10, Do_20b),
      Do_20c = Do_20a + Do_20b, Do_20c_error = ksl_sum_error(Do_20a, Do_20b, Do_20c),
      Do_20c_lo1 = Do_20c_error + Do_20a_lo, Do_20c_lo = Do_20c_lo1 + Do_20b_lo,
      Do_20d = D1->m22 * D2->m20, Do_20d_lo = ksl_product_error(D1->m22, D2->m20, Do_20d),
      Do_20 = Do_20c + Do_20d, Do_20_error = ksl_sum_error(Do_20c, Do_20d, Do_20),
      Do_20_lo1 = Do_20_error + Do_20c_lo, Do_20_lo = Do_20_lo1 + Do_20d_lo;
  const double Do_21a = D1->m20 * D2->m01, Do_21a_lo = ksl_product_error(D1->m20, D2->m01, Do_21a),
      Do_21b = D1->m21 * D2->m11, Do_21b_lo = ksl_product_error(D1->m21, D2->m11, Do_21b),
      Do_21c = Do_21a + Do_21b, Do_21c_error = ksl_sum_error(Do_21a, Do_21b, Do_21c),
      Do_21c_lo1 = Do_21c_error + Do_21a_lo, Do_21c_lo = Do_21c_lo1 + Do_21b_lo,
      Do_21d = D1->m22 * D2->m21, Do_21d_lo = ksl_product_error(D1->m22, D2->m21, Do_21d),
      Do_21 = Do_21c + Do_21d, Do_21_error = ksl_sum_error(Do_21c, Do_21d, Do_21),
      Do_21_lo1 = Do_21_error + Do_21c_lo, Do_21_lo = Do_21_lo1 + Do_21d_lo;
  const double Do_22a = D1->m20 * D2->m02, Do_22a_lo = ksl_product_error(D1->m20, D2->m02, Do_22a),
      Do_22b = D1->m21 * D2->m12, Do_22b_lo = ksl_product_error(D1->m21, D2->m12, Do_22b),
      Do_22c = Do_22a + Do_22b, Do_22c_error = ksl_sum_error(Do_22a, Do_22b, Do_22c),
      Do_22c_lo1 = Do_22c_error + Do_22a_lo, Do_22c_lo = Do_22c_lo1 + Do_22b_lo,
      Do_22d = D1->m22 * D2->m22, Do_22d_lo = ksl_product_error(D1->m22, D2->m22, Do_22d),
      Do_22 = Do_22c + Do_22d, Do_22_error = ksl_sum_error(Do_22c, Do_22d, Do_22),
      Do_22_lo1 = Do_22_error + Do_22c_lo, Do_22_lo = Do_22_lo1 + Do_22d_lo;
  const double Do_23a = D1->m20 * D2->m03, Do_23a_lo = ksl_product_error(D1->m20, D2->m03, Do_23a),
      Do_23b = D1->m21 * D2->m13, Do_23b_lo = ksl_product_error(D1->m21, D2->m13, Do_23b),
      Do_23c = Do_23a + Do_23b, Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c),
      Do_23c_lo1 = Do_23c_error + Do_23a_lo, Do_23c_lo = Do_23c_lo1 + Do_23b_lo,
      Do_23d = D1->m22 * D2->m23, Do_23d_lo = ksl_product_error(D1->m22, D2->m23, Do_23d),
      Do_23e = Do_23c + Do_23d, Do_23e_error = ksl_sum_error(Do_23c, Do_23d, Do_23e),
      Do_23e_lo1 = Do_23e_error + Do_23c_lo, Do_23e_lo = Do_23e_lo1 + Do_23d_lo,
      Do_23 = Do_23e + D1->m23, Do_23_error = ksl_sum_error(Do_23e, D1->m23, Do_23),
      Do_23_lo = Do_23_error + Do_23e_lo;
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
   45 mul, 99 add, 36 product error, 27 sum error.
   Error <= u |result| + (R: 10, t: 46) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double R_0a = D1->m00 * D2->m00, R_0a_lo = ksl_product_error(D1->m00, D2->m00, R_0a),
      R_0b = D1->m01 * D2->m01, R_0b_lo = ksl_product_error(D1->m01, D2->m01, R_0b),
      R_0c = R_0a + R_0b, R_0c_error = ksl_sum_error(R_0a, R_0b, R_0c),
      R_0c_lo1 = R_0c_error + R_0a_lo, R_0c_lo = R_0c_lo1 + R_0b_lo, R_0d = D1->m02 * D2->m02,
      R_0d_lo = ksl_product_error(D1->m02, D2->m02, R_0d), R_0 = R_0c + R_0d,
      R_0_error = ksl_sum_error(R_0c, R_0d, R_0), R_0_lo1 = R_0_error + R_0c_lo,
      R_0_lo = R_0_lo1 + R_0d_lo;
  const double R_1a = D1->m00 * D2->m10, R_1a_lo = ksl_product_error(D1->m00, D2->m10, R_1a),
      R_1b = D1->m01 * D2->m11, R_1b_lo = ksl_product_error(D1->m01, D2->m11, R_1b),
      R_1c = R_1a + R_1b, R_1c_error = ksl_sum_error(R_1a, R_1b, R_1c),
      R_1c_lo1 = R_1c_error + R_1a_lo, R_1c_lo = R_1c_lo1 + R_1b_lo, R_1d = D1->m02 * D2->m12,
      R_1d_lo = ksl_product_error(D1->m02, D2->m12, R_1d), R_1 = R_1c + R_1d,
      R_1_error = ksl_sum_error(R_1c, R_1d, R_1), R_1_lo1 = R_1_error + R_1c_lo,
      R_1_lo = R_1_lo1 + R_1d_lo;
  const double R_2a = D1->m00 * D2->m20, R_2a_lo = ksl_product_error(D1->m00, D2->m20, R_2a),
      R_2b = D1->m01 * D2->m21, R_2b_lo = ksl_product_error(D1->m01, D2->m21, R_2b),
      R_2c = R_2a + R_2b, R_2c_error = ksl_sum_error(R_2a, R_2b, R_2c),
      R_2c_lo1 = R_2c_error + R_2a_lo, R_2c_lo = R_2c_lo1 + R_2b_lo, R_2d = D1->m02 * D2->m22,
      R_2d_lo = ksl_product_error(D1->m02, D2->m22, R_2d), R_2 = R_2c + R_2d,
      R_2_error = ksl_sum_error(R_2c, R_2d, R_2), R_2_lo1 = R_2_error + R_2c_lo,
      R_2_lo = R_2_lo1 + R_2d_lo;
  const double R_3a = D1->m10 * D2->m00, R_3a_lo = ksl_product_error(D1->m10, D2->m00, R_3a),
      R_3b = D1->m11 * D2->m01, R_3b_lo = ksl_product_error(D1->m11, D2->m01, R_3b),
      R_3c = R_3a + R_3b, R_3c_error = ksl_sum_error(R_3a, R_3b, R_3c),
      R_3c_lo1 = R_3c_error + R_3a_lo, R_3c_lo = R_3c_lo1 + R_3b_lo, R_3d = D1->m12 * D2->m02,
      R_3d_lo = ksl_product_error(D1->m12, D2->m02, R_3d), R_3 = R_3c + R_3d,
      R_3_error = ksl_sum_error(R_3c, R_3d, R_3), R_3_lo1 = R_3_error + R_3c_lo,
      R_3_lo = R_3_lo1 + R_3d_lo;
  const double R_4a = D1->m10 * D2->m10, R_4a_lo = ksl_product_error(D1->m10, D2->m10, R_4a),
      R_4b = D1->m11 * D2->m11, R_4b_lo = ksl_product_error(D1->m11, D2->m11, R_4b),
      R_4c = R_4a + R_4b, R_4c_error = ksl_sum_error(R_4a, R_4b, R_4c),
      R_4c_lo1 = R_4c_error + R_4a_lo, R_4c_lo = R_4c_lo1 + R_4b_lo, R_4d = D1->m12 * D2->m12,
      R_4d_lo = ksl_product_error(D1->m12, D2->m12, R_4d), R_4 = R_4c + R_4d,
      R_4_error = ksl_sum_error(R_4c, R_4d, R_4), R_4_lo1 = R_4_error + R_4c_lo,
      R_4_lo = R_4_lo1 + R_4d_lo;
  const double R_5a = D1->m10 * D2->m20, R_5a_lo = ksl_product_error(D1->m10, D2->m20, R_5a),
      R_5b = D1->m11 * D2->m21, R_5b_lo = ksl_product_error(D1->m11, D2->m21, R_5b),
      R_5c = R_5a + R_5b, R_5c_error = ksl_sum_error(R_5a, R_5b, R_5c),
      R_5c_lo1 = R_5c_error + R_5a_lo, R_5c_lo = R_5c_lo1 + R_5b_lo, R_5d = D1->m12 * D2->m22,
      R_5d_lo = ksl_product_error(D1->m12, D2->m22, R_5d), R_5 = R_5c + R_5d,
      R_5_error = ksl_sum_error(R_5c, R_5d, R_5), R_5_lo1 = R_5_error + R_5c_lo,
      R_5_lo = R_5_lo1 + R_5d_lo;
  const double R_6a = D1->m20 * D2->m00, R_6a_lo = ksl_product_error(D1->m20, D2->m00, R_6a),
      R_6b = D1->m21 * D2->m01, R_6b_lo = ksl_product_error(D1->m21, D2->m01, R_6b),
      R_6c = R_6a + R_6b, R_6c_error = ksl_sum_error(R_6a, R_6b, R_6c),
      R_6c_lo1 = R_6c_error + R_6a_lo, R_6c_lo = R_6c_lo1 + R_6b_lo, R_6d = D1->m22 * D2->m02,
      R_6d_lo = ksl_product_error(D1->m22, D2->m02, R_6d), R_6 = R_6c + R_6d,
      R_6_error = ksl_sum_error(R_6c, R_6d, R_6), R_6_lo1 = R_6_error + R_6c_lo,
      R_6_lo = R_6_lo1 + R_6d_lo;
  const double R_7a = D1->m20 * D2->m10, R_7a_lo = ksl_product_error(D1->m20, D2->m10, R_7a),
      R_7b = D1->m21 * D2->m11, R_7b_lo = ksl_product_error(D1->m21, D2->m11, R_7b),
      R_7c = R_7a + R_7b, R_7c_error = ksl_sum_error(R_7a, R_7b, R_7c),
      R_7c_lo1 = R_7c_error + R_7a_lo, R_7c_lo = R_7c_lo1 + R_7b_lo, R_7d = D1->m22 * D2->m12,
      R_7d_lo = ksl_product_error(D1->m22, D2->m12, R_7d), R_7 = R_7c + R_7d,
      R_7_error = ksl_sum_error(R_7c, R_7d, R_7), R_7_lo1 = R_7_error + R_7c_lo,
      R_7_lo = R_7_lo1 + R_7d_lo;
  const double R_8a = D1->m20 * D2->m20, R_8a_lo = ksl_product_error(D1->m20, D2->m20, R_8a),
      R_8b = D1->m21 * D2->m21, R_8b_lo = ksl_product_error(D1->m21, D2->m21, R_8b),
      R_8c = R_8a + R_8b, R_8c_error = ksl_sum_error(R_8a, R_8b, R_8c),
      R_8c_lo1 = R_8c_error + R_8a_lo, R_8c_lo = R_8c_lo1 + R_8b_lo, R_8d = D1->m22 * D2->m22,
      R_8d_lo = ksl_product_error(D1->m22, D2->m22, R_8d), R_8 = R_8c + R_8d,
      R_8_error = ksl_sum_error(R_8c, R_8d, R_8), R_8_lo1 = R_8_error + R_8c_lo,
      R_8_lo = R_8_lo1 + R_8d_lo;
  const double Do_03a = D2->m03 * R_0, Do_03a_cross1 = D2->m03 * R_0_lo,
      Do_03a_error = ksl_product_error(D2->m03, R_0, Do_03a),
      Do_03a_lo = Do_03a_error + Do_03a_cross1, Do_03b = D2->m13 * R_1,
      Do_03b_cross1 = D2->m13 * R_1_lo, Do_03b_error = ksl_product_error(D2->m13, R_1, Do_03b),
      Do_03b_lo = Do_03b_error + Do_03b_cross1, Do_03c = Do_03a + Do_03b,
      Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c), Do_03c_lo1 = Do_03c_error + Do_03a_lo,
      Do_03c_lo = Do_03c_lo1 + Do_03b_lo, Do_03d = D2->m23 * R_2, Do_03d_cross1 = D2->m23 * R_2_lo,
      Do_03d_error = ksl_product_error(D2->m23, R_2, Do_03d),
      Do_03d_lo = Do_03d_error + Do_03d_cross1, Do_03e = Do_03c + Do_03d,
      Do_03e_error = ksl_sum_error(Do_03c, Do_03d, Do_03e), Do_03e_lo1 = Do_03e_error + Do_03c_lo,
      Do_03e_lo = Do_03e_lo1 + Do_03d_lo, Do_03 = D1->m03 - Do_03e,
      Do_03_error = ksl_difference_error(D1->m03, Do_03e, Do_03),
      Do_03_lo = Do_03_error - Do_03e_lo;
  const double Do_13a = D2->m03 * R_3, Do_13a_cross1 = D2->m03 * R_3_lo,
      Do_13a_error = ksl_product_error(D2->m03, R_3, Do_13a),
      Do_13a_lo = Do_13a_error + Do_13a_cross1, Do_13b = D2->m13 * R_4,
      Do_13b_cross1 = D2->m13 * R_4_lo, Do_13b_error = ksl_product_error(D2->m13, R_4, Do_13b),
      Do_13b_lo = Do_13b_error + Do_13b_cross1, Do_13c = Do_13a + Do_13b,
      Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c), Do_13c_lo1 = Do_13c_error + Do_13a_lo,
      Do_13c_lo = Do_13c_lo1 + Do_13b_lo, Do_13d = D2->m23 * R_5, Do_13d_cross1 = D2->m23 * R_5_lo,
      Do_13d_error = ksl_product_error(D2->m23, R_5, Do_13d),
      Do_13d_lo = Do_13d_error + Do_13d_cross1, Do_13e = Do_13c + Do_13d,
      Do_13e_error = ksl_sum_error(Do_13c, Do_13d, Do_13e), Do_13e_lo1 = Do_13e_error + Do_13c_lo,
      Do_13e_lo = Do_13e_lo1 + Do_13d_lo, Do_13 = D1->m13 - Do_13e,
      Do_13_error = ksl_difference_error(D1->m13, Do_13e, Do_13),
      Do_13_lo = Do_13_error - Do_13e_lo;
  const double Do_23a = D2->m03 * R_6, Do_23a_cross1 = D2->m03 * R_6_lo,
      Do_23a_error = ksl_product_error(D2->m03, R_6, Do_23a),
      Do_23a_lo = Do_23a_error + Do_23a_cross1, Do_23b = D2->m13 * R_7,
      Do_23b_cross1 = D2->m13 * R_7_lo, Do_23b_error = ksl_product_error(D2->m13, R_7, Do_23b),
      Do_23b_lo = Do_23b_error + Do_23b_cross1, Do_23c = Do_23a + Do_23b,
      Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c), Do_23c_lo1 = Do_23c_error + Do_23a_lo,
      Do_23c_lo = Do_23c_lo1 + Do_23b_lo, Do_23d = D2->m23 * R_8, Do_23d_cross1 = D2->m23 * R_8_lo,
      Do_23d_error = ksl_product_error(D2->m23, R_8, Do_23d),
      Do_23d_lo = Do_23d_error + Do_23d_cross1, Do_23e = Do_23c + Do_23d,
      Do_23e_error = ksl_sum_error(Do_23c, Do_23d, Do_23e), Do_23e_lo1 = Do_23e_error + Do_23c_lo,
      Do_23e_lo = Do_23e_lo1 + Do_23d_lo, Do_23 = D1->m23 - Do_23e,
      Do_23_error = ksl_difference_error(D1->m23, Do_23e, Do_23),
      Do_23_lo = Do_23_error - Do_23e_lo;
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
   45 mul, 96 add, 36 product error, 27 sum error.
   Error <= u |result| + (R: 10, t: 17) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03, p_0_lo = ksl_difference_error(D2->m03, D1->m03, p_0);
  const double p_1 = D2->m13 - D1->m13, p_1_lo = ksl_difference_error(D2->m13, D1->m13, p_1);
  const double p_2 = D2->m23 - D1->m23, p_2_lo = ksl_difference_error(D2->m23, D1->m23, p_2);
  const double Do_00a = D1->m00 * D2->m00, Do_00a_lo = ksl_product_error(D1->m00, D2->m00, Do_00a),
      Do_00b = D1->m10 * D2->m10, Do_00b_lo = ksl_product_error(D1->m10, D2->m10, Do_00b),
      Do_00c = Do_00a + Do_00b, Do_00c_error = ksl_sum_error(Do_00a, Do_00b, Do_00c),
      Do_00c_lo1 = Do_00c_error + Do_00a_lo, Do_00c_lo = Do_00c_lo1 + Do_00b_lo,
      Do_00d = D1->m20 * D2->m20, Do_00d_lo = ksl_product_error(D1->m20, D2->m20, Do_00d),
      Do_00 = Do_00c + Do_00d, Do_00_error = ksl_sum_error(Do_00c, Do_00d, Do_00),
      Do_00_lo1 = Do_00_error + Do_00c_lo, Do_00_lo = Do_00_lo1 + Do_00d_lo;
  const double Do_01a = D1->m00 * D2->m01, Do_01a_lo = ksl_product_error(D1->m00, D2->m01, Do_01a),
      Do_01b = D1->m10 * D2->m11, Do_01b_lo = ksl_product_error(D1->m10, D2->m11, Do_01b),
      Do_01c = Do_01a + Do_01b, Do_01c_error = ksl_sum_error(Do_01a, Do_01b, Do_01c),
      Do_01c_lo1 = Do_01c_error + Do_01a_lo, Do_01c_lo = Do_01c_lo1 + Do_01b_lo,
      Do_01d = D1->m20 * D2->m21, Do_01d_lo = ksl_product_error(D1->m20, D2->m21, Do_01d),
      Do_01 = Do_01c + Do_01d, Do_01_error = ksl_sum_error(Do_01c, Do_01d, Do_01),
      Do_01_lo1 = Do_01_error + Do_01c_lo, Do_01_lo = Do_01_lo1 + Do_01d_lo;
  const double Do_02a = D1->m00 * D2->m02, Do_02a_lo = ksl_product_error(D1->m00, D2->m02, Do_02a),
      Do_02b = D1->m10 * D2->m12, Do_02b_lo = ksl_product_error(D1->m10, D2->m12, Do_02b),
      Do_02c = Do_02a + Do_02b, Do_02c_error = ksl_sum_error(Do_02a, Do_02b, Do_02c),
      Do_02c_lo1 = Do_02c_error + Do_02a_lo, Do_02c_lo = Do_02c_lo1 + Do_02b_lo,
      Do_02d = D1->m20 * D2->m22, Do_02d_lo = ksl_product_error(D1->m20, D2->m22, Do_02d),
      Do_02 = Do_02c + Do_02d, Do_02_error = ksl_sum_error(Do_02c, Do_02d, Do_02),
      Do_02_lo1 = Do_02_error + Do_02c_lo, Do_02_lo = Do_02_lo1 + Do_02d_lo;
  const double Do_03a = D1->m00 * p_0, Do_03a_cross1 = D1->m00 * p_0_lo,
      Do_03a_error = ksl_product_error(D1->m00, p_0, Do_03a),
      Do_03a_lo = Do_03a_error + Do_03a_cross1, Do_03b = D1->m10 * p_1,
      Do_03b_cross1 = D1->m10 * p_1_lo, Do_03b_error = ksl_product_error(D1->m10, p_1, Do_03b),
      Do_03b_lo = Do_03b_error + Do_03b_cross1, Do_03c = Do_03a + Do_03b,
      Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c), Do_03c_lo1 = Do_03c_error + Do_03a_lo,
      Do_03c_lo = Do_03c_lo1 + Do_03b_lo, Do_03d = D1->m20 * p_2, Do_03d_cross1 = D1->m20 * p_2_lo,
      Do_03d_error = ksl_product_error(D1->m20, p_2, Do_03d),
      Do_03d_lo = Do_03d_error + Do_03d_cross1, Do_03 = Do_03c + Do_03d,
      Do_03_error = ksl_sum_error(Do_03c, Do_03d, Do_03), Do_03_lo1 = Do_03_error + Do_03c_lo,
      Do_03_lo = Do_03_lo1 + Do_03d_lo;
  const double Do_10a = D1->m01 * D2->m00, Do_10a_lo = ksl_product_error(D1->m01, D2->m00, Do_10a),
      Do_10b = D1->m11 * D2->m10, Do_10b_lo = ksl_product_error(D1->m11, D2->m10, Do_10b),
      Do_10c = Do_10a + Do_10b, Do_10c_error = ksl_sum_error(Do_10a, Do_10b, Do_10c),
      Do_10c_lo1 = Do_10c_error + Do_10a_lo, Do_10c_lo = Do_10c_lo1 + Do_10b_lo,
      Do_10d = D1->m21 * D2->m20, Do_10d_lo = ksl_product_error(D1->m21, D2->m20, Do_10d),
      Do_10 = Do_10c + Do_10d, Do_10_error = ksl_sum_error(Do_10c, Do_10d, Do_10),
      Do_10_lo1 = Do_10_error + Do_10c_lo, Do_10_lo = Do_10_lo1 + Do_10d_lo;
  const double Do_11a = D1->m01 * D2->m01, Do_11a_lo = ksl_product_error(D1->m01, D2->m01, Do_11a),
      Do_11b = D1->m11 * D2->m11, Do_11b_lo = ksl_product_error(D1->m11, D2->m11, Do_11b),
      Do_11c = Do_11a + Do_11b, Do_11c_error = ksl_sum_error(Do_11a, Do_11b, Do_11c),
      Do_11c_lo1 = Do_11c_error + Do_11a_lo, Do_11c_lo = Do_11c_lo1 + Do_11b_lo,
      Do_11d = D1->m21 * D2->m21, Do_11d_lo = ksl_product_error(D1->m21, D2->m21, Do_11d),
      Do_11 = Do_11c + Do_11d, Do_11_error = ksl_sum_error(Do_11c, Do_11d, Do_11),
      Do_11_lo1 = Do_11_error + Do_11c_lo, Do_11_lo = Do_11_lo1 + Do_11d_lo;
  const double Do_12a = D1->m01 * D2->m02, Do_12a_lo = ksl_product_error(D1->m01, D2->m02, Do_12a),
      Do_12b = D1->m11 * D2->m12, Do_12b_lo = ksl_product_error(D1->m11, D2->m12, Do_12b),
      Do_12c = Do_12a + Do_12b, Do_12c_error = ksl_sum_error(Do_12a, Do_12b, Do_12c),
      Do_12c_lo1 = Do_12c_error + Do_12a_lo, Do_12c_lo = Do_12c_lo1 + Do_12b_lo,
      Do_12d = D1->m21 * D2->m22, Do_12d_lo = ksl_product_error(D1->m21, D2->m22, Do_12d),
      Do_12 = Do_12c + Do_12d, Do_12_error = ksl_sum_error(Do_12c, Do_12d, Do_12),
      Do_12_lo1 = Do_12_error + Do_12c_lo, Do_12_lo = Do_12_lo1 + Do_12d_lo;
  const double Do_13a = D1->m01 * p_0, Do_13a_cross1 = D1->m01 * p_0_lo,
      Do_13a_error = ksl_product_error(D1->m01, p_0, Do_13a),
      Do_13a_lo = Do_13a_error + Do_13a_cross1, Do_13b = D1->m11 * p_1,
      Do_13b_cross1 = D1->m11 * p_1_lo, Do_13b_error = ksl_product_error(D1->m11, p_1, Do_13b),
      Do_13b_lo = Do_13b_error + Do_13b_cross1, Do_13c = Do_13a + Do_13b,
      Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c), Do_13c_lo1 = Do_13c_error + Do_13a_lo,
      Do_13c_lo = Do_13c_lo1 + Do_13b_lo, Do_13d = D1->m21 * p_2, Do_13d_cross1 = D1->m21 * p_2_lo,
      Do_13d_error = ksl_product_error(D1->m21, p_2, Do_13d),
      Do_13d_lo = Do_13d_error + Do_13d_cross1, Do_13 = Do_13c + Do_13d,
      Do_13_error = ksl_sum_error(Do_13c, Do_13d, Do_13), Do_13_lo1 = Do_13_error + Do_13c_lo,
      Do_13_lo = Do_13_lo1 + Do_13d_lo;
  const double Do_20a = D1->m02 * D2->m00, Do_20a_lo = ksl_product_error(D1->m02, D2->m00, Do_20a),
      Do_20b = D1->m12 * D2->m10, Do_20b_lo = ksl_product_error(D1->m12, D2->m10, Do_20b),
      Do_20c = Do_20a + Do_20b, Do_20c_error = ksl_sum_error(Do_20a, Do_20b, Do_20c),
      Do_20c_lo1 = Do_20c_error + Do_20a_lo, Do_20c_lo = Do_20c_lo1 + Do_20b_lo,
      Do_20d = D1->m22 * D2->m20, Do_20d_lo = ksl_product_error(D1->m22, D2->m20, Do_20d),
      Do_20 = Do_20c + Do_20d, Do_20_error = ksl_sum_error(Do_20c, Do_20d, Do_20),
      Do_20_lo1 = Do_20_error + Do_20c_lo, Do_20_lo = Do_20_lo1 + Do_20d_lo;
  const double Do_21a = D1->m02 * D2->m01, Do_21a_lo = ksl_product_error(D1->m02, D2->m01, Do_21a),
      Do_21b = D1->m12 * D2->m11, Do_21b_lo = ksl_product_error(D1->m12, D2->m11, Do_21b),
      Do_21c = Do_21a + Do_21b, Do_21c_error = ksl_sum_error(Do_21a, Do_21b, Do_21c),
      Do_21c_lo1 = Do_21c_error + Do_21a_lo, Do_21c_lo = Do_21c_lo1 + Do_21b_lo,
      Do_21d = D1->m22 * D2->m21, Do_21d_lo = ksl_product_error(D1->m22, D2->m21, Do_21d),
      Do_21 = Do_21c + Do_21d, Do_21_error = ksl_sum_error(Do_21c, Do_21d, Do_21),
      Do_21_lo1 = Do_21_error + Do_21c_lo, Do_21_lo = Do_21_lo1 + Do_21d_lo;
  const double Do_22a = D1->m02 * D2->m02, Do_22a_lo = ksl_product_error(D1->m02, D2->m02, Do_22a),
      Do_22b = D1->m12 * D2->m12, Do_22b_lo = ksl_product_error(D1->m12, D2->m12, Do_22b),
      Do_22c = Do_22a + Do_22b, Do_22c_error = ksl_sum_error(Do_22a, Do_22b, Do_22c),
      Do_22c_lo1 = Do_22c_error + Do_22a_lo, Do_22c_lo = Do_22c_lo1 + Do_22b_lo,
      Do_22d = D1->m22 * D2->m22, Do_22d_lo = ksl_product_error(D1->m22, D2->m22, Do_22d),
      Do_22 = Do_22c + Do_22d, Do_22_error = ksl_sum_error(Do_22c, Do_22d, Do_22),
      Do_22_lo1 = Do_22_error + Do_22c_lo, Do_22_lo = Do_22_lo1 + Do_22d_lo;
  const double Do_23a = D1->m02 * p_0, Do_23a_cross1 = D1->m02 * p_0_lo,
      Do_23a_error = ksl_product_error(D1->m02, p_0, Do_23a),
      Do_23a_lo = Do_23a_error + Do_23a_cross1, Do_23b = D1->m12 * p_1,
      Do_23b_cross1 = D1->m12 * p_1_lo, Do_23b_error = ksl_product_error(D1->m12, p_1, Do_23b),
      Do_23b_lo = Do_23b_error + Do_23b_cross1, Do_23c = Do_23a + Do_23b,
      Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c), Do_23c_lo1 = Do_23c_error + Do_23a_lo,
      Do_23c_lo = Do_23c_lo1 + Do_23b_lo, Do_23d = D1->m22 * p_2, Do_23d_cross1 = D1->m22 * p_2_lo,
      Do_23d_error = ksl_product_error(D1->m22, p_2, Do_23d),
      Do_23d_lo = Do_23d_error + Do_23d_cross1, Do_23 = Do_23c + Do_23d,
      Do_23_error = ksl_sum_error(Do_23c, Do_23d, Do_23), Do_23_lo1 = Do_23_error + Do_23c_lo,
      Do_23_lo = Do_23_lo1 + Do_23d_lo;
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
   27 mul, 63 add, 27 product error, 18 sum error.
   Error <= u |result| + (R: 10, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00a_lo = ksl_product_error(D->m00, R->m00, Do_00a),
      Do_00b = D->m01 * R->m10, Do_00b_lo = ksl_product_error(D->m01, R->m10, Do_00b),
      Do_00c = Do_00a + Do_00b, Do_00c_error = ksl_sum_error(Do_00a, Do_00b, Do_00c),
      Do_00c_lo1 = Do_00c_error + Do_00a_lo, Do_00c_lo = Do_00c_lo1 + Do_00b_lo,
      Do_00d = D->m02 * R->m20, Do_00d_lo = ksl_product_error(D->m02, R->m20, Do_00d),
      Do_00 = Do_00c + Do_00d, Do_00_error = ksl_sum_error(Do_00c, Do_00d, Do_00),
      Do_00_lo1 = Do_00_error + Do_00c_lo, Do_00_lo = Do_00_lo1 + Do_00d_lo;
  const double Do_01a = D->m00 * R->m01, Do_01a_lo = ksl_product_error(D->m00, R->m01, Do_01a),
      Do_01b = D->m01 * R->m11, Do_01b_lo = ksl_product_error(D->m01, R->m11, Do_01b),
      Do_01c = Do_01a + Do_01b, Do_01c_error = ksl_sum_error(Do_01a, Do_01b, Do_01c),
      Do_01c_lo1 = Do_01c_error + Do_01a_lo, Do_01c_lo = Do_01c_lo1 + Do_01b_lo,
      Do_01d = D->m02 * R->m21, Do_01d_lo = ksl_product_error(D->m02, R->m21, Do_01d),
      Do_01 = Do_01c + Do_01d, Do_01_error = ksl_sum_error(Do_01c, Do_01d, Do_01),
      Do_01_lo1 = Do_01_error + Do_01c_lo, Do_01_lo = Do_01_lo1 + Do_01d_lo;
  const double Do_02a = D->m00 * R->m02, Do_02a_lo = ksl_product_error(D->m00, R->m02, Do_02a),
      Do_02b = D->m01 * R->m12, Do_02b_lo = ksl_product_error(D->m01, R->m12, Do_02b),
      Do_02c = Do_02a + Do_02b, Do_02c_error = ksl_sum_error(Do_02a, Do_02b, Do_02c),
      Do_02c_lo1 = Do_02c_error + Do_02a_lo, Do_02c_lo = Do_02c_lo1 + Do_02b_lo,
      Do_02d = D->m02 * R->m22, Do_02d_lo = ksl_product_error(D->m02, R->m22, Do_02d),
      Do_02 = Do_02c + Do_02d, Do_02_error = ksl_sum_error(Do_02c, Do_02d, Do_02),
      Do_02_lo1 = Do_02_error + Do_02c_lo, Do_02_lo = Do_02_lo1 + Do_02d_lo;
  const double Do_10a = D->m10 * R->m00, Do_10a_lo = ksl_product_error(D->m10, R->m00, Do_10a),
      Do_10b = D->m11 * R->m10, Do_10b_lo = ksl_product_error(D->m11, R->m10, Do_10b),
      Do_10c = Do_10a + Do_10b, Do_10c_error = ksl_sum_error(Do_10a, Do_10b, Do_10c),
      Do_10c_lo1 = Do_10c_error + Do_10a_lo, Do_10c_lo = Do_10c_lo1 + Do_10b_lo,
      Do_10d = D->m12 * R->m20, Do_10d_lo = ksl_product_error(D->m12, R->m20, Do_10d),
      Do_10 = Do_10c + Do_10d, Do_10_error = ksl_sum_error(Do_10c, Do_10d, Do_10),
      Do_10_lo1 = Do_10_error + Do_10c_lo, Do_10_lo = Do_10_lo1 + Do_10d_lo;
  const double Do_11a = D->m10 * R->m01, Do_11a_lo = ksl_product_error(D->m10, R->m01, Do_11a),
      Do_11b = D->m11 * R->m11, Do_11b_lo = ksl_product_error(D->m11, R->m11, Do_11b),
      Do_11c = Do_11a + Do_11b, Do_11c_error = ksl_sum_error(Do_11a, Do_11b, Do_11c),
      Do_11c_lo1 = Do_11c_error + Do_11a_lo, Do_11c_lo = Do_11c_lo1 + Do_11b_lo,
      Do_11d = D->m12 * R->m21, Do_11d_lo = ksl_product_error(D->m12, R->m21, Do_11d),
      Do_11 = Do_11c + Do_11d, Do_11_error = ksl_sum_error(Do_11c, Do_11d, Do_11),
      Do_11_lo1 = Do_11_error + Do_11c_lo, Do_11_lo = Do_11_lo1 + Do_11d_lo;
  const double Do_12a = D->m10 * R->m02, Do_12a_lo = ksl_product_error(D->m10, R->m02, Do_12a),
      Do_12b = D->m11 * R->m12, Do_12b_lo = ksl_product_error(D->m11, R->m12, Do_12b),
      Do_12c = Do_12a + Do_12b, Do_12c_error = ksl_sum_error(Do_12a, Do_12b, Do_12c),
      Do_12c_lo1 = Do_12c_error + Do_12a_lo, Do_12c_lo = Do_12c_lo1 + Do_12b_lo,
      Do_12d = D->m12 * R->m22, Do_12d_lo = ksl_product_error(D->m12, R->m22, Do_12d),
      Do_12 = Do_12c + Do_12d, Do_12_error = ksl_sum_error(Do_12c, Do_12d, Do_12),
      Do_12_lo1 = Do_12_error + Do_12c_lo, Do_12_lo = Do_12_lo1 + Do_12d_lo;
  const double Do_20a = D->m20 * R->m00, Do_20a_lo = ksl_product_error(D->m20, R->m00, Do_20a),
      Do_20b = D->m21 * R->m10, Do_20b_lo = ksl_product_error(D->m21, R->m10, Do_20b),
      Do_20c = Do_20a + Do_20b, Do_20c_error = ksl_sum_error(Do_20a, Do_20b, Do_20c),
      Do_20c_lo1 = Do_20c_error + Do_20a_lo, Do_20c_lo = Do_20c_lo1 + Do_20b_lo,
      Do_20d = D->m22 * R->m20, Do_20d_lo = ksl_product_error(D->m22, R->m20, Do_20d),
      Do_20 = Do_20c + Do_20d, Do_20_error = ksl_sum_error(Do_20c, Do_20d, Do_20),
      Do_20_lo1 = Do_20_error + Do_20c_lo, Do_20_lo = Do_20_lo1 + Do_20d_lo;
  const double Do_21a = D->m20 * R->m01, Do_21a_lo = ksl_product_error(D->m20, R->m01, Do_21a),
      Do_21b = D->m21 * R->m11, Do_21b_lo = ksl_product_error(D->m21, R->m11, Do_21b),
      Do_21c = Do_21a + Do_21b, Do_21c_error = ksl_sum_error(Do_21a, Do_21b, Do_21c),
      Do_21c_lo1 = Do_21c_error + Do_21a_lo, Do_21c_lo = Do_21c_lo1 + Do_21b_lo,
      Do_21d = D->m22 * R->m21, Do_21d_lo = ksl_product_error(D->m22, R->m21, Do_21d),
      Do_21 = Do_21c + Do_21d, Do_21_error = ksl_sum_error(Do_21c, Do_21d, Do_21),
      Do_21_lo1 = Do_21_error + Do_21c_lo, Do_21_lo = Do_21_lo1 + Do_21d_lo;
  const double Do_22a = D->m20 * R->m02, Do_22a_lo = ksl_product_error(D->m20, R->m02, Do_22a),
      Do_22b = D->m21 * R->m12, Do_22b_lo = ksl_product_error(D->m21, R->m12, Do_22b),
      Do_22c = Do_22a + Do_22b, Do_22c_error = ksl_sum_error(Do_22a, Do_22b, Do_22c),
      Do_22c_lo1 = Do_22c_error + Do_22a_lo, Do_22c_lo = Do_22c_lo1 + Do_22b_lo,
      Do_22d = D->m22 * R->m22, Do_22d_lo = ksl_product_error(D->m22, R->m22, Do_22d),
      Do_22 = Do_22c + Do_22d, Do_22_error = ksl_sum_error(Do_22c, Do_22d, Do_22),
      Do_22_lo1 = Do_22_error + Do_22c_lo, Do_22_lo = Do_22_lo1 + Do_22d_lo;
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
   27 mul, 63 add, 27 product error, 18 sum error.
   Error <= u |result| + (R: 10, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00a_lo = ksl_product_error(D->m00, R->m00, Do_00a),
      Do_00b = D->m01 * R->m01, Do_00b_lo = ksl_product_error(D->m01, R->m01, Do_00b),
      Do_00c = Do_00a + Do_00b, Do_00c_error = ksl_sum_error(Do_00a, Do_00b, Do_00c),
      Do_00c_lo1 = Do_00c_error + Do_00a_lo, Do_00c_lo = Do_00c_lo1 + Do_00b_lo,
      Do_00d = D->m02 * R->m02, Do_00d_lo = ksl_product_error(D->m02, R->m02, Do_00d),
      Do_00 = Do_00c + Do_00d, Do_00_error = ksl_sum_error(Do_00c, Do_00d, Do_00),
      Do_00_lo1 = Do_00_error + Do_00c_lo, Do_00_lo = Do_00_lo1 + Do_00d_lo;
  const double Do_01a = D->m00 * R->m10, Do_01a_lo = ksl_product_error(D->m00, R->m10, Do_01a),
      Do_01b = D->m01 * R->m11, Do_01b_lo = ksl_product_error(D->m01, R->m11, Do_01b),
      Do_01c = Do_01a + Do_01b, Do_01c_error = ksl_sum_error(Do_01a, Do_01b, Do_01c),
      Do_01c_lo1 = Do_01c_error + Do_01a_lo, Do_01c_lo = Do_01c_lo1 + Do_01b_lo,
      Do_01d = D->m02 * R->m12, Do_01d_lo = ksl_product_error(D->m02, R->m12, Do_01d),
      Do_01 = Do_01c + Do_01d, Do_01_error = ksl_sum_error(Do_01c, Do_01d, Do_01),
      Do_01_lo1 = Do_01_error + Do_01c_lo, Do_01_lo = Do_01_lo1 + Do_01d_lo;
  const double Do_02a = D->m00 * R->m20, Do_02a_lo = ksl_product_error(D->m00, R->m20, Do_02a),
      Do_02b = D->m01 * R->m21, Do_02b_lo = ksl_product_error(D->m01, R->m21, Do_02b),
      Do_02c = Do_02a + Do_02b, Do_02c_error = ksl_sum_error(Do_02a, Do_02b, Do_02c),
      Do_02c_lo1 = Do_02c_error + Do_02a_lo, Do_02c_lo = Do_02c_lo1 + Do_02b_lo,
      Do_02d = D->m02 * R->m22, Do_02d_lo = ksl_product_error(D->m02, R->m22, Do_02d),
      Do_02 = Do_02c + Do_02d, Do_02_error = ksl_sum_error(Do_02c, Do_02d, Do_02),
      Do_02_lo1 = Do_02_error + Do_02c_lo, Do_02_lo = Do_02_lo1 + Do_02d_lo;
  const double Do_10a = D->m10 * R->m00, Do_10a_lo = ksl_product_error(D->m10, R->m00, Do_10a),
      Do_10b = D->m11 * R->m01, Do_10b_lo = ksl_product_error(D->m11, R->m01, Do_10b),
      Do_10c = Do_10a + Do_10b, Do_10c_error = ksl_sum_error(Do_10a, Do_10b, Do_10c),
      Do_10c_lo1 = Do_10c_error + Do_10a_lo, Do_10c_lo = Do_10c_lo1 + Do_10b_lo,
      Do_10d = D->m12 * R->m02, Do_10d_lo = ksl_product_error(D->m12, R->m02, Do_10d),
      Do_10 = Do_10c + Do_10d, Do_10_error = ksl_sum_error(Do_10c, Do_10d, Do_10),
      Do_10_lo1 = Do_10_error + Do_10c_lo, Do_10_lo = Do_10_lo1 + Do_10d_lo;
  const double Do_11a = D->m10 * R->m10, Do_11a_lo = ksl_product_error(D->m10, R->m10, Do_11a),
      Do_11b = D->m11 * R->m11, Do_11b_lo = ksl_product_error(D->m11, R->m11, Do_11b),
      Do_11c = Do_11a + Do_11b, Do_11c_error = ksl_sum_error(Do_11a, Do_11b, Do_11c),
      Do_11c_lo1 = Do_11c_error + Do_11a_lo, Do_11c_lo = Do_11c_lo1 + Do_11b_lo,
      Do_11d = D->m12 * R->m12, Do_11d_lo = ksl_product_error(D->m12, R->m12, Do_11d),
      Do_11 = Do_11c + Do_11d, Do_11_error = ksl_sum_error(Do_11c, Do_11d, Do_11),
      Do_11_lo1 = Do_11_error + Do_11c_lo, Do_11_lo = Do_11_lo1 + Do_11d_lo;
  const double Do_12a = D->m10 * R->m20, Do_12a_lo = ksl_product_error(D->m10, R->m20, Do_12a),
      Do_12b = D->m11 * R->m21, Do_12b_lo = ksl_product_error(D->m11, R->m21, Do_12b),
      Do_12c = Do_12a + Do_12b, Do_12c_error = ksl_sum_error(Do_12a, Do_12b, Do_12c),
      Do_12c_lo1 = Do_12c_error + Do_12a_lo, Do_12c_lo = Do_12c_lo1 + Do_12b_lo,
      Do_12d = D->m12 * R->m22, Do_12d_lo = ksl_product_error(D->m12, R->m22, Do_12d),
      Do_12 = Do_12c + Do_12d, Do_12_error = ksl_sum_error(Do_12c, Do_12d, Do_12),
      Do_12_lo1 = Do_12_error + Do_12c_lo, Do_12_lo = Do_12_lo1 + Do_12d_lo;
  const double Do_20a = D->m20 * R->m00, Do_20a_lo = ksl_product_error(D->m20, R->m00, Do_20a),
      Do_20b = D->m21 * R->m01, Do_20b_lo = ksl_product_error(D->m21, R->m01, Do_20b),
      Do_20c = Do_20a + Do_20b, Do_20c_error = ksl_sum_error(Do_20a, Do_20b, Do_20c),
      Do_20c_lo1 = Do_20c_error + Do_20a_lo, Do_20c_lo = Do_20c_lo1 + Do_20b_lo,
      Do_20d = D->m22 * R->m02, Do_20d_lo = ksl_product_error(D->m22, R->m02, Do_20d),
      Do_20 = Do_20c + Do_20d, Do_20_error = ksl_sum_error(Do_20c, Do_20d, Do_20),
      Do_20_lo1 = Do_20_error + Do_20c_lo, Do_20_lo = Do_20_lo1 + Do_20d_lo;
  const double Do_21a = D->m20 * R->m10, Do_21a_lo = ksl_product_error(D->m20, R->m10, Do_21a),
      Do_21b = D->m21 * R->m11, Do_21b_lo = ksl_product_error(D->m21, R->m11, Do_21b),
      Do_21c = Do_21a + Do_21b, Do_21c_error = ksl_sum_error(Do_21a, Do_21b, Do_21c),
      Do_21c_lo1 = Do_21c_error + Do_21a_lo, Do_21c_lo = Do_21c_lo1 + Do_21b_lo,
      Do_21d = D->m22 * R->m12, Do_21d_lo = ksl_product_error(D->m22, R->m12, Do_21d),
      Do_21 = Do_21c + Do_21d, Do_21_error = ksl_sum_error(Do_21c, Do_21d, Do_21),
      Do_21_lo1 = Do_21_error + Do_21c_lo, Do_21_lo = Do_21_lo1 + Do_21d_lo;
  const double Do_22a = D->m20 * R->m20, Do_22a_lo = ksl_product_error(D->m20, R->m20, Do_22a),
      Do_22b = D->m21 * R->m21, Do_22b_lo = ksl_product_error(D->m21, R->m21, Do_22b),
      Do_22c = Do_22a + Do_22b, Do_22c_error = ksl_sum_error(Do_22a, Do_22b, Do_22c),
      Do_22c_lo1 = Do_22c_error + Do_22a_lo, Do_22c_lo = Do_22c_lo1 + Do_22b_lo,
      Do_22d = D->m22 * R->m22, Do_22d_lo = ksl_product_error(D->m22, R->m22, Do_22d),
      Do_22 = Do_22c + Do_22d, Do_22_error = ksl_sum_error(Do_22c, Do_22d, Do_22),
      Do_22_lo1 = Do_22_error + Do_22c_lo, Do_22_lo = Do_22_lo1 + Do_22d_lo;
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
   9 mul, 27 add, 9 product error, 9 sum error.
   Error <= u |result| + (R: 0, t: 14) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03a_lo = ksl_product_error(D->m00, t->x, Do_03a),
      Do_03b = D->m01 * t->y, Do_03b_lo = ksl_product_error(D->m01, t->y, Do_03b),
      Do_03c = Do_03a + Do_03b, Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c),
      Do_03c_lo1 = Do_03c_error + Do_03a_lo, Do_03c_lo = Do_03c_lo1 + Do_03b_lo,
      Do_03d = D->m02 * t->z, Do_03d_lo = ksl_product_error(D->m02, t->z, Do_03d),
      Do_03e = Do_03c + Do_03d, Do_03e_error = ksl_sum_error(Do_03c, Do_03d, Do_03e),
      Do_03e_lo1 = Do_03e_error + Do_03c_lo, Do_03e_lo = Do_03e_lo1 + Do_03d_lo,
      Do_03 = Do_03e + D->m03, Do_03_error = ksl_sum_error(Do_03e, D->m03, Do_03),
      Do_03_lo = Do_03_error + Do_03e_lo;
  const double Do_13a = D->m10 * t->x, Do_13a_lo = ksl_product_error(D->m10, t->x, Do_13a),
      Do_13b = D->m11 * t->y, Do_13b_lo = ksl_product_error(D->m11, t->y, Do_13b),
      Do_13c = Do_13a + Do_13b, Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c),
      Do_13c_lo1 = Do_13c_error + Do_13a_lo, Do_13c_lo = Do_13c_lo1 + Do_13b_lo,
      Do_13d = D->m12 * t->z, Do_13d_lo = ksl_product_error(D->m12, t->z, Do_13d),
      Do_13e = Do_13c + Do_13d, Do_13e_error = ksl_sum_error(Do_13c, Do_13d, Do_13e),
      Do_13e_lo1 = Do_13e_error + Do_13c_lo, Do_13e_lo = Do_13e_lo1 + Do_13d_lo,
      Do_13 = Do_13e + D->m13, Do_13_error = ksl_sum_error(Do_13e, D->m13, Do_13),
      Do_13_lo = Do_13_error + Do_13e_lo;
  const double Do_23a = D->m20 * t->x, Do_23a_lo = ksl_product_error(D->m20, t->x, Do_23a),
      Do_23b = D->m21 * t->y, Do_23b_lo = ksl_product_error(D->m21, t->y, Do_23b),
      Do_23c = Do_23a + Do_23b, Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c),
      Do_23c_lo1 = Do_23c_error + Do_23a_lo, Do_23c_lo = Do_23c_lo1 + Do_23b_lo,
      Do_23d = D->m22 * t->z, Do_23d_lo = ksl_product_error(D->m22, t->z, Do_23d),
      Do_23e = Do_23c + Do_23d, Do_23e_error = ksl_sum_error(Do_23c, Do_23d, Do_23e),
      Do_23e_lo1 = Do_23e_error + Do_23c_lo, Do_23e_lo = Do_23e_lo1 + Do_23d_lo,
      Do_23 = Do_23e + D->m23, Do_23_error = ksl_sum_error(Do_23e, D->m23, Do_23),
      Do_23_lo = Do_23_error + Do_23e_lo;
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
   9 mul, 27 add, 9 product error, 9 sum error.
   Error <= u |result| + (R: 0, t: 14) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03a_lo = ksl_product_error(D->m00, t->x, Do_03a),
      Do_03b = D->m01 * t->y, Do_03b_lo = ksl_product_error(D->m01, t->y, Do_03b),
      Do_03c = Do_03a + Do_03b, Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c),
      Do_03c_lo1 = Do_03c_error + Do_03a_lo, Do_03c_lo = Do_03c_lo1 + Do_03b_lo,
      Do_03d = D->m02 * t->z, Do_03d_lo = ksl_product_error(D->m02, t->z, Do_03d),
      Do_03e = Do_03c + Do_03d, Do_03e_error = ksl_sum_error(Do_03c, Do_03d, Do_03e),
      Do_03e_lo1 = Do_03e_error + Do_03c_lo, Do_03e_lo = Do_03e_lo1 + Do_03d_lo,
      Do_03 = D->m03 - Do_03e, Do_03_error = ksl_difference_error(D->m03, Do_03e, Do_03),
      Do_03_lo = Do_03_error - Do_03e_lo;
  const double Do_13a = D->m10 * t->x, Do_13a_lo = ksl_product_error(D->m10, t->x, Do_13a),
      Do_13b = D->m11 * t->y, Do_13b_lo = ksl_product_error(D->m11, t->y, Do_13b),
      Do_13c = Do_13a + Do_13b, Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c),
      Do_13c_lo1 = Do_13c_error + Do_13a_lo, Do_13c_lo = Do_13c_lo1 + Do_13b_lo,
      Do_13d = D->m12 * t->z, Do_13d_lo = ksl_product_error(D->m12, t->z, Do_13d),
      Do_13e = Do_13c + Do_13d, Do_13e_error = ksl_sum_error(Do_13c, Do_13d, Do_13e),
      Do_13e_lo1 = Do_13e_error + Do_13c_lo, Do_13e_lo = Do_13e_lo1 + Do_13d_lo,
      Do_13 = D->m13 - Do_13e, Do_13_error = ksl_difference_error(D->m13, Do_13e, Do_13),
      Do_13_lo = Do_13_error - Do_13e_lo;
  const double Do_23a = D->m20 * t->x, Do_23a_lo = ksl_product_error(D->m20, t->x, Do_23a),
      Do_23b = D->m21 * t->y, Do_23b_lo = ksl_product_error(D->m21, t->y, Do_23b),
      Do_23c = Do_23a + Do_23b, Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c),
      Do_23c_lo1 = Do_23c_error + Do_23a_lo, Do_23c_lo = Do_23c_lo1 + Do_23b_lo,
      Do_23d = D->m22 * t->z, Do_23d_lo = ksl_product_error(D->m22, t->z, Do_23d),
      Do_23e = Do_23c + Do_23d, Do_23e_error = ksl_sum_error(Do_23c, Do_23d, Do_23e),
      Do_23e_lo1 = Do_23e_error + Do_23c_lo, Do_23e_lo = Do_23e_lo1 + Do_23d_lo,
      Do_23 = D->m23 - Do_23e, Do_23_error = ksl_difference_error(D->m23, Do_23e, Do_23),
      Do_23_lo = Do_23_error - Do_23e_lo;
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
   18 mul, 33 add, 9 product error, 9 sum error.
   Error <= u |result| + (R: 0, t: 17) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03, p_0_lo = ksl_difference_error(t->x, D->m03, p_0);
  const double p_1 = t->y - D->m13, p_1_lo = ksl_difference_error(t->y, D->m13, p_1);
  const double p_2 = t->z - D->m23, p_2_lo = ksl_difference_error(t->z, D->m23, p_2);
  const double Do_03a = D->m00 * p_0, Do_03a_cross1 = D->m00 * p_0_lo,
      Do_03a_error = ksl_product_error(D->m00, p_0, Do_03a),
      Do_03a_lo = Do_03a_error + Do_03a_cross1, Do_03b = D->m10 * p_1,
      Do_03b_cross1 = D->m10 * p_1_lo, Do_03b_error = ksl_product_error(D->m10, p_1, Do_03b),
      Do_03b_lo = Do_03b_error + Do_03b_cross1, Do_03c = Do_03a + Do_03b,
      Do_03c_error = ksl_sum_error(Do_03a, Do_03b, Do_03c), Do_03c_lo1 = Do_03c_error + Do_03a_lo,
      Do_03c_lo = Do_03c_lo1 + Do_03b_lo, Do_03d = D->m20 * p_2, Do_03d_cross1 = D->m20 * p_2_lo,
      Do_03d_error = ksl_product_error(D->m20, p_2, Do_03d),
      Do_03d_lo = Do_03d_error + Do_03d_cross1, Do_03 = Do_03c + Do_03d,
      Do_03_error = ksl_sum_error(Do_03c, Do_03d, Do_03), Do_03_lo1 = Do_03_error + Do_03c_lo,
      Do_03_lo = Do_03_lo1 + Do_03d_lo;
  const double Do_13a = D->m01 * p_0, Do_13a_cross1 = D->m01 * p_0_lo,
      Do_13a_error = ksl_product_error(D->m01, p_0, Do_13a),
      Do_13a_lo = Do_13a_error + Do_13a_cross1, Do_13b = D->m11 * p_1,
      Do_13b_cross1 = D->m11 * p_1_lo, Do_13b_error = ksl_product_error(D->m11, p_1, Do_13b),
      Do_13b_lo = Do_13b_error + Do_13b_cross1, Do_13c = Do_13a + Do_13b,
      Do_13c_error = ksl_sum_error(Do_13a, Do_13b, Do_13c), Do_13c_lo1 = Do_13c_error + Do_13a_lo,
      Do_13c_lo = Do_13c_lo1 + Do_13b_lo, Do_13d = D->m21 * p_2, Do_13d_cross1 = D->m21 * p_2_lo,
      Do_13d_error = ksl_product_error(D->m21, p_2, Do_13d),
      Do_13d_lo = Do_13d_error + Do_13d_cross1, Do_13 = Do_13c + Do_13d,
      Do_13_error = ksl_sum_error(Do_13c, Do_13d, Do_13), Do_13_lo1 = Do_13_error + Do_13c_lo,
      Do_13_lo = Do_13_lo1 + Do_13d_lo;
  const double Do_23a = D->m02 * p_0, Do_23a_cross1 = D->m02 * p_0_lo,
      Do_23a_error = ksl_product_error(D->m02, p_0, Do_23a),
      Do_23a_lo = Do_23a_error + Do_23a_cross1, Do_23b = D->m12 * p_1,
      Do_23b_cross1 = D->m12 * p_1_lo, Do_23b_error = ksl_product_error(D->m12, p_1, Do_23b),
      Do_23b_lo = Do_23b_error + Do_23b_cross1, Do_23c = Do_23a + Do_23b,
      Do_23c_error = ksl_sum_error(Do_23a, Do_23b, Do_23c), Do_23c_lo1 = Do_23c_error + Do_23a_lo,
      Do_23c_lo = Do_23c_lo1 + Do_23b_lo, Do_23d = D->m22 * p_2, Do_23d_cross1 = D->m22 * p_2_lo,
      Do_23d_error = ksl_product_error(D->m22, p_2, Do_23d),
      Do_23d_lo = Do_23d_error + Do_23d_cross1, Do_23 = Do_23c + Do_23d,
      Do_23_error = ksl_sum_error(Do_23c, Do_23d, Do_23), Do_23_lo1 = Do_23_error + Do_23c_lo,
      Do_23_lo = Do_23_lo1 + Do_23d_lo;
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
  const double vo_0 = R->m00 * k, vo_0_lo = ksl_product_error(R->m00, k, vo_0);
  const double vo_1 = R->m10 * k, vo_1_lo = ksl_product_error(R->m10, k, vo_1);
  const double vo_2 = R->m20 * k, vo_2_lo = ksl_product_error(R->m20, k, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01a_lo = ksl_product_error(R->m01, dc[1], Ro_01a),
      Ro_01b = R->m02 * dc[0], Ro_01b_lo = ksl_product_error(R->m02, dc[0], Ro_01b),
      Ro_01 = Ro_01a + Ro_01b, Ro_01_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01a_lo, Ro_01_lo = Ro_01_lo1 + Ro_01b_lo;
  const double Ro_02a = R->m02 * dc[1], Ro_02a_lo = ksl_product_error(R->m02, dc[1], Ro_02a),
      Ro_02b = R->m01 * dc[0], Ro_02b_lo = ksl_product_error(R->m01, dc[0], Ro_02b),
      Ro_02 = Ro_02a - Ro_02b, Ro_02_error = ksl_difference_error(Ro_02a, Ro_02b, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02a_lo, Ro_02_lo = Ro_02_lo1 - Ro_02b_lo;
  const double Ro_11a = R->m11 * dc[1], Ro_11a_lo = ksl_product_error(R->m11, dc[1], Ro_11a),
      Ro_11b = R->m12 * dc[0], Ro_11b_lo = ksl_product_error(R->m12, dc[0], Ro_11b),
      Ro_11 = Ro_11a + Ro_11b, Ro_11_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11a_lo, Ro_11_lo = Ro_11_lo1 + Ro_11b_lo;
  const double Ro_12a = R->m12 * dc[1], Ro_12a_lo = ksl_product_error(R->m12, dc[1], Ro_12a),
      Ro_12b = R->m11 * dc[0], Ro_12b_lo = ksl_product_error(R->m11, dc[0], Ro_12b),
      Ro_12 = Ro_12a - Ro_12b, Ro_12_error = ksl_difference_error(Ro_12a, Ro_12b, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12a_lo, Ro_12_lo = Ro_12_lo1 - Ro_12b_lo;
  const double Ro_21a = R->m21 * dc[1], Ro_21a_lo = ksl_product_error(R->m21, dc[1], Ro_21a),
      Ro_21b = R->m22 * dc[0], Ro_21b_lo = ksl_product_error(R->m22, dc[0], Ro_21b),
      Ro_21 = Ro_21a + Ro_21b, Ro_21_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21a_lo, Ro_21_lo = Ro_21_lo1 + Ro_21b_lo;
  const double Ro_22a = R->m22 * dc[1], Ro_22a_lo = ksl_product_error(R->m22, dc[1], Ro_22a),
      Ro_22b = R->m21 * dc[0], Ro_22b_lo = ksl_product_error(R->m21, dc[0], Ro_22b),
      Ro_22 = Ro_22a - Ro_22b, Ro_22_error = ksl_difference_error(Ro_22a, Ro_22b, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22a_lo, Ro_22_lo = Ro_22_lo1 - Ro_22b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01a_lo = ksl_product_error(D->m01, dc[1], Do_01a),
      Do_01b = D->m02 * dc[0], Do_01b_lo = ksl_product_error(D->m02, dc[0], Do_01b),
      Do_01 = Do_01a + Do_01b, Do_01_error = ksl_sum_error(Do_01a, Do_01b, Do_01),
      Do_01_lo1 = Do_01_error + Do_01a_lo, Do_01_lo = Do_01_lo1 + Do_01b_lo;
  const double Do_02a = D->m02 * dc[1], Do_02a_lo = ksl_product_error(D->m02, dc[1], Do_02a),
      Do_02b = D->m01 * dc[0], Do_02b_lo = ksl_product_error(D->m01, dc[0], Do_02b),
      Do_02 = Do_02a - Do_02b, Do_02_error = ksl_difference_error(Do_02a, Do_02b, Do_02),
      Do_02_lo1 = Do_02_error + Do_02a_lo, Do_02_lo = Do_02_lo1 - Do_02b_lo;
  const double Do_11a = D->m11 * dc[1], Do_11a_lo = ksl_product_error(D->m11, dc[1], Do_11a),
      Do_11b = D->m12 * dc[0], Do_11b_lo = ksl_product_error(D->m12, dc[0], Do_11b),
      Do_11 = Do_11a + Do_11b, Do_11_error = ksl_sum_error(Do_11a, Do_11b, Do_11),
      Do_11_lo1 = Do_11_error + Do_11a_lo, Do_11_lo = Do_11_lo1 + Do_11b_lo;
  const double Do_12a = D->m12 * dc[1], Do_12a_lo = ksl_product_error(D->m12, dc[1], Do_12a),
      Do_12b = D->m11 * dc[0], Do_12b_lo = ksl_product_error(D->m11, dc[0], Do_12b),
      Do_12 = Do_12a - Do_12b, Do_12_error = ksl_difference_error(Do_12a, Do_12b, Do_12),
      Do_12_lo1 = Do_12_error + Do_12a_lo, Do_12_lo = Do_12_lo1 - Do_12b_lo;
  const double Do_21a = D->m21 * dc[1], Do_21a_lo = ksl_product_error(D->m21, dc[1], Do_21a),
      Do_21b = D->m22 * dc[0], Do_21b_lo = ksl_product_error(D->m22, dc[0], Do_21b),
      Do_21 = Do_21a + Do_21b, Do_21_error = ksl_sum_error(Do_21a, Do_21b, Do_21),
      Do_21_lo1 = Do_21_error + Do_21a_lo, Do_21_lo = Do_21_lo1 + Do_21b_lo;
  const double Do_22a = D->m22 * dc[1], Do_22a_lo = ksl_product_error(D->m22, dc[1], Do_22a),
      Do_22b = D->m21 * dc[0], Do_22b_lo = ksl_product_error(D->m21, dc[0], Do_22b),
      Do_22 = Do_22a - Do_22b, Do_22_error = ksl_difference_error(Do_22a, Do_22b, Do_22),
      Do_22_lo1 = Do_22_error + Do_22a_lo, Do_22_lo = Do_22_lo1 - Do_22b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03a_lo = ksl_product_error(D->m00, k, Do_03a),
      Do_03 = Do_03a + D->m03, Do_03_error = ksl_sum_error(Do_03a, D->m03, Do_03),
      Do_03_lo = Do_03_error + Do_03a_lo;
  const double Do_13a = D->m10 * k, Do_13a_lo = ksl_product_error(D->m10, k, Do_13a),
      Do_13 = Do_13a + D->m13, Do_13_error = ksl_sum_error(Do_13a, D->m13, Do_13),
      Do_13_lo = Do_13_error + Do_13a_lo;
  const double Do_23a = D->m20 * k, Do_23a_lo = ksl_product_error(D->m20, k, Do_23a),
      Do_23 = Do_23a + D->m23, Do_23_error = ksl_sum_error(Do_23a, D->m23, Do_23),
      Do_23_lo = Do_23_error + Do_23a_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01a_lo = ksl_product_error(R->m01, dc[1], Ro_01a),
      Ro_01b = R->m02 * dc[0], Ro_01b_lo = ksl_product_error(R->m02, dc[0], Ro_01b),
      Ro_01 = Ro_01a - Ro_01b, Ro_01_error = ksl_difference_error(Ro_01a, Ro_01b, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01a_lo, Ro_01_lo = Ro_01_lo1 - Ro_01b_lo;
  const double Ro_02a = R->m01 * dc[0], Ro_02a_lo = ksl_product_error(R->m01, dc[0], Ro_02a),
      Ro_02b = R->m02 * dc[1], Ro_02b_lo = ksl_product_error(R->m02, dc[1], Ro_02b),
      Ro_02 = Ro_02a + Ro_02b, Ro_02_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02a_lo, Ro_02_lo = Ro_02_lo1 + Ro_02b_lo;
  const double Ro_11a = R->m11 * dc[1], Ro_11a_lo = ksl_product_error(R->m11, dc[1], Ro_11a),
      Ro_11b = R->m12 * dc[0], Ro_11b_lo = ksl_product_error(R->m12, dc[0], Ro_11b),
      Ro_11 = Ro_11a - Ro_11b, Ro_11_error = ksl_difference_error(Ro_11a, Ro_11b, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11a_lo, Ro_11_lo = Ro_11_lo1 - Ro_11b_lo;
  const double Ro_12a = R->m11 * dc[0], Ro_12a_lo = ksl_product_error(R->m11, dc[0], Ro_12a),
      Ro_12b = R->m12 * dc[1], Ro_12b_lo = ksl_product_error(R->m12, dc[1], Ro_12b),
      Ro_12 = Ro_12a + Ro_12b, Ro_12_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12a_lo, Ro_12_lo = Ro_12_lo1 + Ro_12b_lo;
  const double Ro_21a = R->m21 * dc[1], Ro_21a_lo = ksl_product_error(R->m21, dc[1], Ro_21a),
      Ro_21b = R->m22 * dc[0], Ro_21b_lo = ksl_product_error(R->m22, dc[0], Ro_21b),
      Ro_21 = Ro_21a - Ro_21b, Ro_21_error = ksl_difference_error(Ro_21a, Ro_21b, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21a_lo, Ro_21_lo = Ro_21_lo1 - Ro_21b_lo;
  const double Ro_22a = R->m21 * dc[0], Ro_22a_lo = ksl_product_error(R->m21, dc[0], Ro_22a),
      Ro_22b = R->m22 * dc[1], Ro_22b_lo = ksl_product_error(R->m22, dc[1], Ro_22b),
      Ro_22 = Ro_22a + Ro_22b, Ro_22_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22a_lo, Ro_22_lo = Ro_22_lo1 + Ro_22b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01a_lo = ksl_product_error(D->m01, dc[1], Do_01a),
      Do_01b = D->m02 * dc[0], Do_01b_lo = ksl_product_error(D->m02, dc[0], Do_01b),
      Do_01 = Do_01a - Do_01b, Do_01_error = ksl_difference_error(Do_01a, Do_01b, Do_01),
      Do_01_lo1 = Do_01_error + Do_01a_lo, Do_01_lo = Do_01_lo1 - Do_01b_lo;
  const double Do_02a = D->m01 * dc[0], Do_02a_lo = ksl_product_error(D->m01, dc[0], Do_02a),
      Do_02b = D->m02 * dc[1], Do_02b_lo = ksl_product_error(D->m02, dc[1], Do_02b),
      Do_02 = Do_02a + Do_02b, Do_02_error = ksl_sum_error(Do_02a, Do_02b, Do_02),
      Do_02_lo1 = Do_02_error + Do_02a_lo, Do_02_lo = Do_02_lo1 + Do_02b_lo;
  const double Do_11a = D->m11 * dc[1], Do_11a_lo = ksl_product_error(D->m11, dc[1], Do_11a),
      Do_11b = D->m12 * dc[0], Do_11b_lo = ksl_product_error(D->m12, dc[0], Do_11b),
      Do_11 = Do_11a - Do_11b, Do_11_error = ksl_difference_error(Do_11a, Do_11b, Do_11),
      Do_11_lo1 = Do_11_error + Do_11a_lo, Do_11_lo = Do_11_lo1 - Do_11b_lo;
  const double Do_12a = D->m11 * dc[0], Do_12a_lo = ksl_product_error(D->m11, dc[0], Do_12a),
      Do_12b = D->m12 * dc[1], Do_12b_lo = ksl_product_error(D->m12, dc[1], Do_12b),
      Do_12 = Do_12a + Do_12b, Do_12_error = ksl_sum_error(Do_12a, Do_12b, Do_12),
      Do_12_lo1 = Do_12_error + Do_12a_lo, Do_12_lo = Do_12_lo1 + Do_12b_lo;
  const double Do_21a = D->m21 * dc[1], Do_21a_lo = ksl_product_error(D->m21, dc[1], Do_21a),
      Do_21b = D->m22 * dc[0], Do_21b_lo = ksl_product_error(D->m22, dc[0], Do_21b),
      Do_21 = Do_21a - Do_21b, Do_21_error = ksl_difference_error(Do_21a, Do_21b, Do_21),
      Do_21_lo1 = Do_21_error + Do_21a_lo, Do_21_lo = Do_21_lo1 - Do_21b_lo;
  const double Do_22a = D->m21 * dc[0], Do_22a_lo = ksl_product_error(D->m21, dc[0], Do_22a),
      Do_22b = D->m22 * dc[1], Do_22b_lo = ksl_product_error(D->m22, dc[1], Do_22b),
      Do_22 = Do_22a + Do_22b, Do_22_error = ksl_sum_error(Do_22a, Do_22b, Do_22),
      Do_22_lo1 = Do_22_error + Do_22a_lo, Do_22_lo = Do_22_lo1 + Do_22b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03a_lo = ksl_product_error(D->m00, k, Do_03a),
      Do_03 = D->m03 - Do_03a, Do_03_error = ksl_difference_error(D->m03, Do_03a, Do_03),
      Do_03_lo = Do_03_error - Do_03a_lo;
  const double Do_13a = D->m10 * k, Do_13a_lo = ksl_product_error(D->m10, k, Do_13a),
      Do_13 = D->m13 - Do_13a, Do_13_error = ksl_difference_error(D->m13, Do_13a, Do_13),
      Do_13_lo = Do_13_error - Do_13a_lo;
  const double Do_23a = D->m20 * k, Do_23a_lo = ksl_product_error(D->m20, k, Do_23a),
      Do_23 = D->m23 - Do_23a, Do_23_error = ksl_difference_error(D->m23, Do_23a, Do_23),
      Do_23_lo = Do_23_error - Do_23a_lo;
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
  const double vo_0 = R->m01 * k, vo_0_lo = ksl_product_error(R->m01, k, vo_0);
  const double vo_1 = R->m11 * k, vo_1_lo = ksl_product_error(R->m11, k, vo_1);
  const double vo_2 = R->m21 * k, vo_2_lo = ksl_product_error(R->m21, k, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00a_lo = ksl_product_error(R->m00, dc[1], Ro_00a),
      Ro_00b = R->m02 * dc[0], Ro_00b_lo = ksl_product_error(R->m02, dc[0], Ro_00b),
      Ro_00 = Ro_00a - Ro_00b, Ro_00_error = ksl_difference_error(Ro_00a, Ro_00b, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00a_lo, Ro_00_lo = Ro_00_lo1 - Ro_00b_lo;
  const double Ro_02a = R->m00 * dc[0], Ro_02a_lo = ksl_product_error(R->m00, dc[0], Ro_02a),
      Ro_02b = R->m02 * dc[1], Ro_02b_lo = ksl_product_error(R->m02, dc[1], Ro_02b),
      Ro_02 = Ro_02a + Ro_02b, Ro_02_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02a_lo, Ro_02_lo = Ro_02_lo1 + Ro_02b_lo;
  const double Ro_10a = R->m10 * dc[1], Ro_10a_lo = ksl_product_error(R->m10, dc[1], Ro_10a),
      Ro_10b = R->m12 * dc[0], Ro_10b_lo = ksl_product_error(R->m12, dc[0], Ro_10b),
      Ro_10 = Ro_10a - Ro_10b, Ro_10_error = ksl_difference_error(Ro_10a, Ro_10b, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10a_lo, Ro_10_lo = Ro_10_lo1 - Ro_10b_lo;
  const double Ro_12a = R->m10 * dc[0], Ro_12a_lo = ksl_product_error(R->m10, dc[0], Ro_12a),
      Ro_12b = R->m12 * dc[1], Ro_12b_lo = ksl_product_error(R->m12, dc[1], Ro_12b),
      Ro_12 = Ro_12a + Ro_12b, Ro_12_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12a_lo, Ro_12_lo = Ro_12_lo1 + Ro_12b_lo;
  const double Ro_20a = R->m20 * dc[1], Ro_20a_lo = ksl_product_error(R->m20, dc[1], Ro_20a),
      Ro_20b = R->m22 * dc[0], Ro_20b_lo = ksl_product_error(R->m22, dc[0], Ro_20b),
      Ro_20 = Ro_20a - Ro_20b, Ro_20_error = ksl_difference_error(Ro_20a, Ro_20b, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20a_lo, Ro_20_lo = Ro_20_lo1 - Ro_20b_lo;
  const double Ro_22a = R->m20 * dc[0], Ro_22a_lo = ksl_product_error(R->m20, dc[0], Ro_22a),
      Ro_22b = R->m22 * dc[1], Ro_22b_lo = ksl_product_error(R->m22, dc[1], Ro_22b),
      Ro_22 = Ro_22a + Ro_22b, Ro_22_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22a_lo, Ro_22_lo = Ro_22_lo1 + Ro_22b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00a_lo = ksl_product_error(D->m00, dc[1], Do_00a),
      Do_00b = D->m02 * dc[0], Do_00b_lo = ksl_product_error(D->m02, dc[0], Do_00b),
      Do_00 = Do_00a - Do_00b, Do_00_error = ksl_difference_error(Do_00a, Do_00b, Do_00),
      Do_00_lo1 = Do_00_error + Do_00a_lo, Do_00_lo = Do_00_lo1 - Do_00b_lo;
  const double Do_02a = D->m00 * dc[0], Do_02a_lo = ksl_product_error(D->m00, dc[0], Do_02a),
      Do_02b = D->m02 * dc[1], Do_02b_lo = ksl_product_error(D->m02, dc[1], Do_02b),
      Do_02 = Do_02a + Do_02b, Do_02_error = ksl_sum_error(Do_02a, Do_02b, Do_02),
      Do_02_lo1 = Do_02_error + Do_02a_lo, Do_02_lo = Do_02_lo1 + Do_02b_lo;
  const double Do_10a = D->m10 * dc[1], Do_10a_lo = ksl_product_error(D->m10, dc[1], Do_10a),
      Do_10b = D->m12 * dc[0], Do_10b_lo = ksl_product_error(D->m12, dc[0], Do_10b),
      Do_10 = Do_10a - Do_10b, Do_10_error = ksl_difference_error(Do_10a, Do_10b, Do_10),
      Do_10_lo1 = Do_10_error + Do_10a_lo, Do_10_lo = Do_10_lo1 - Do_10b_lo;
  const double Do_12a = D->m10 * dc[0], Do_12a_lo = ksl_product_error(D->m10, dc[0], Do_12a),
      Do_12b = D->m12 * dc[1], Do_12b_lo = ksl_product_error(D->m12, dc[1], Do_12b),
      Do_12 = Do_12a + Do_12b, Do_12_error = ksl_sum_error(Do_12a, Do_12b, Do_12),
      Do_12_lo1 = Do_12_error + Do_12a_lo, Do_12_lo = Do_12_lo1 + Do_12b_lo;
  const double Do_20a = D->m20 * dc[1], Do_20a_lo = ksl_product_error(D->m20, dc[1], Do_20a),
      Do_20b = D->m22 * dc[0], Do_20b_lo = ksl_product_error(D->m22, dc[0], Do_20b),
      Do_20 = Do_20a - Do_20b, Do_20_error = ksl_difference_error(Do_20a, Do_20b, Do_20),
      Do_20_lo1 = Do_20_error + Do_20a_lo, Do_20_lo = Do_20_lo1 - Do_20b_lo;
  const double Do_22a = D->m20 * dc[0], Do_22a_lo = ksl_product_error(D->m20, dc[0], Do_22a),
      Do_22b = D->m22 * dc[1], Do_22b_lo = ksl_product_error(D->m22, dc[1], Do_22b),
      Do_22 = Do_22a + Do_22b, Do_22_error = ksl_sum_error(Do_22a, Do_22b, Do_22),
      Do_22_lo1 = Do_22_error + Do_22a_lo, Do_22_lo = Do_22_lo1 + Do_22b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03a_lo = ksl_product_error(D->m01, k, Do_03a),
      Do_03 = Do_03a + D->m03, Do_03_error = ksl_sum_error(Do_03a, D->m03, Do_03),
      Do_03_lo = Do_03_error + Do_03a_lo;
  const double Do_13a = D->m11 * k, Do_13a_lo = ksl_product_error(D->m11, k, Do_13a),
      Do_13 = Do_13a + D->m13, Do_13_error = ksl_sum_error(Do_13a, D->m13, Do_13),
      Do_13_lo = Do_13_error + Do_13a_lo;
  const double Do_23a = D->m21 * k, Do_23a_lo = ksl_product_error(D->m21, k, Do_23a),
      Do_23 = Do_23a + D->m23, Do_23_error = ksl_sum_error(Do_23a, D->m23, Do_23),
      Do_23_lo = Do_23_error + Do_23a_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00a_lo = ksl_product_error(R->m00, dc[1], Ro_00a),
      Ro_00b = R->m02 * dc[0], Ro_00b_lo = ksl_product_error(R->m02, dc[0], Ro_00b),
      Ro_00 = Ro_00a + Ro_00b, Ro_00_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00a_lo, Ro_00_lo = Ro_00_lo1 + Ro_00b_lo;
  const double Ro_02a = R->m02 * dc[1], Ro_02a_lo = ksl_product_error(R->m02, dc[1], Ro_02a),
      Ro_02b = R->m00 * dc[0], Ro_02b_lo = ksl_product_error(R->m00, dc[0], Ro_02b),
      Ro_02 = Ro_02a - Ro_02b, Ro_02_error = ksl_difference_error(Ro_02a, Ro_02b, Ro_02),
      Ro_02_lo1 = Ro_02_error + Ro_02a_lo, Ro_02_lo = Ro_02_lo1 - Ro_02b_lo;
  const double Ro_10a = R->m10 * dc[1], Ro_10a_lo = ksl_product_error(R->m10, dc[1], Ro_10a),
      Ro_10b = R->m12 * dc[0], Ro_10b_lo = ksl_product_error(R->m12, dc[0], Ro_10b),
      Ro_10 = Ro_10a + Ro_10b, Ro_10_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10a_lo, Ro_10_lo = Ro_10_lo1 + Ro_10b_lo;
  const double Ro_12a = R->m12 * dc[1], Ro_12a_lo = ksl_product_error(R->m12, dc[1], Ro_12a),
      Ro_12b = R->m10 * dc[0], Ro_12b_lo = ksl_product_error(R->m10, dc[0], Ro_12b),
      Ro_12 = Ro_12a - Ro_12b, Ro_12_error = ksl_difference_error(Ro_12a, Ro_12b, Ro_12),
      Ro_12_lo1 = Ro_12_error + Ro_12a_lo, Ro_12_lo = Ro_12_lo1 - Ro_12b_lo;
  const double Ro_20a = R->m20 * dc[1], Ro_20a_lo = ksl_product_error(R->m20, dc[1], Ro_20a),
      Ro_20b = R->m22 * dc[0], Ro_20b_lo = ksl_product_error(R->m22, dc[0], Ro_20b),
      Ro_20 = Ro_20a + Ro_20b, Ro_20_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20a_lo, Ro_20_lo = Ro_20_lo1 + Ro_20b_lo;
  const double Ro_22a = R->m22 * dc[1], Ro_22a_lo = ksl_product_error(R->m22, dc[1], Ro_22a),
      Ro_22b = R->m20 * dc[0], Ro_22b_lo = ksl_product_error(R->m20, dc[0], Ro_22b),
      Ro_22 = Ro_22a - Ro_22b, Ro_22_error = ksl_difference_error(Ro_22a, Ro_22b, Ro_22),
      Ro_22_lo1 = Ro_22_error + Ro_22a_lo, Ro_22_lo = Ro_22_lo1 - Ro_22b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00a_lo = ksl_product_error(D->m00, dc[1], Do_00a),
      Do_00b = D->m02 * dc[0], Do_00b_lo = ksl_product_error(D->m02, dc[0], Do_00b),
      Do_00 = Do_00a + Do_00b, Do_00_error = ksl_sum_error(Do_00a, Do_00b, Do_00),
      Do_00_lo1 = Do_00_error + Do_00a_lo, Do_00_lo = Do_00_lo1 + Do_00b_lo;
  const double Do_02a = D->m02 * dc[1], Do_02a_lo = ksl_product_error(D->m02, dc[1], Do_02a),
      Do_02b = D->m00 * dc[0], Do_02b_lo = ksl_product_error(D->m00, dc[0], Do_02b),
      Do_02 = Do_02a - Do_02b, Do_02_error = ksl_difference_error(Do_02a, Do_02b, Do_02),
      Do_02_lo1 = Do_02_error + Do_02a_lo, Do_02_lo = Do_02_lo1 - Do_02b_lo;
  const double Do_10a = D->m10 * dc[1], Do_10a_lo = ksl_product_error(D->m10, dc[1], Do_10a),
      Do_10b = D->m12 * dc[0], Do_10b_lo = ksl_product_error(D->m12, dc[0], Do_10b),
      Do_10 = Do_10a + Do_10b, Do_10_error = ksl_sum_error(Do_10a, Do_10b, Do_10),
      Do_10_lo1 = Do_10_error + Do_10a_lo, Do_10_lo = Do_10_lo1 + Do_10b_lo;
  const double Do_12a = D->m12 * dc[1], Do_12a_lo = ksl_product_error(D->m12, dc[1], Do_12a),
      Do_12b = D->m10 * dc[0], Do_12b_lo = ksl_product_error(D->m10, dc[0], Do_12b),
      Do_12 = Do_12a - Do_12b, Do_12_error = ksl_difference_error(Do_12a, Do_12b, Do_12),
      Do_12_lo1 = Do_12_error + Do_12a_lo, Do_12_lo = Do_12_lo1 - Do_12b_lo;
  const double Do_20a = D->m20 * dc[1], Do_20a_lo = ksl_product_error(D->m20, dc[1], Do_20a),
      Do_20b = D->m22 * dc[0], Do_20b_lo = ksl_product_error(D->m22, dc[0], Do_20b),
      Do_20 = Do_20a + Do_20b, Do_20_error = ksl_sum_error(Do_20a, Do_20b, Do_20),
      Do_20_lo1 = Do_20_error + Do_20a_lo, Do_20_lo = Do_20_lo1 + Do_20b_lo;
  const double Do_22a = D->m22 * dc[1], Do_22a_lo = ksl_product_error(D->m22, dc[1], Do_22a),
      Do_22b = D->m20 * dc[0], Do_22b_lo = ksl_product_error(D->m20, dc[0], Do_22b),
      Do_22 = Do_22a - Do_22b, Do_22_error = ksl_difference_error(Do_22a, Do_22b, Do_22),
      Do_22_lo1 = Do_22_error + Do_22a_lo, Do_22_lo = Do_22_lo1 - Do_22b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03a_lo = ksl_product_error(D->m01, k, Do_03a),
      Do_03 = D->m03 - Do_03a, Do_03_error = ksl_difference_error(D->m03, Do_03a, Do_03),
      Do_03_lo = Do_03_error - Do_03a_lo;
  const double Do_13a = D->m11 * k, Do_13a_lo = ksl_product_error(D->m11, k, Do_13a),
      Do_13 = D->m13 - Do_13a, Do_13_error = ksl_difference_error(D->m13, Do_13a, Do_13),
      Do_13_lo = Do_13_error - Do_13a_lo;
  const double Do_23a = D->m21 * k, Do_23a_lo = ksl_product_error(D->m21, k, Do_23a),
      Do_23 = D->m23 - Do_23a, Do_23_error = ksl_difference_error(D->m23, Do_23a, Do_23),
      Do_23_lo = Do_23_error - Do_23a_lo;
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
  const double vo_0 = R->m02 * k, vo_0_lo = ksl_product_error(R->m02, k, vo_0);
  const double vo_1 = R->m12 * k, vo_1_lo = ksl_product_error(R->m12, k, vo_1);
  const double vo_2 = R->m22 * k, vo_2_lo = ksl_product_error(R->m22, k, vo_2);
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00a_lo = ksl_product_error(R->m00, dc[1], Ro_00a),
      Ro_00b = R->m01 * dc[0], Ro_00b_lo = ksl_product_error(R->m01, dc[0], Ro_00b),
      Ro_00 = Ro_00a + Ro_00b, Ro_00_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00a_lo, Ro_00_lo = Ro_00_lo1 + Ro_00b_lo;
  const double Ro_01a = R->m01 * dc[1], Ro_01a_lo = ksl_product_error(R->m01, dc[1], Ro_01a),
      Ro_01b = R->m00 * dc[0], Ro_01b_lo = ksl_product_error(R->m00, dc[0], Ro_01b),
      Ro_01 = Ro_01a - Ro_01b, Ro_01_error = ksl_difference_error(Ro_01a, Ro_01b, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01a_lo, Ro_01_lo = Ro_01_lo1 - Ro_01b_lo;
  const double Ro_10a = R->m10 * dc[1], Ro_10a_lo = ksl_product_error(R->m10, dc[1], Ro_10a),
      Ro_10b = R->m11 * dc[0], Ro_10b_lo = ksl_product_error(R->m11, dc[0], Ro_10b),
      Ro_10 = Ro_10a + Ro_10b, Ro_10_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10a_lo, Ro_10_lo = Ro_10_lo1 + Ro_10b_lo;
  const double Ro_11a = R->m11 * dc[1], Ro_11a_lo = ksl_product_error(R->m11, dc[1], Ro_11a),
      Ro_11b = R->m10 * dc[0], Ro_11b_lo = ksl_product_error(R->m10, dc[0], Ro_11b),
      Ro_11 = Ro_11a - Ro_11b, Ro_11_error = ksl_difference_error(Ro_11a, Ro_11b, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11a_lo, Ro_11_lo = Ro_11_lo1 - Ro_11b_lo;
  const double Ro_20a = R->m20 * dc[1], Ro_20a_lo = ksl_product_error(R->m20, dc[1], Ro_20a),
      Ro_20b = R->m21 * dc[0], Ro_20b_lo = ksl_product_error(R->m21, dc[0], Ro_20b),
      Ro_20 = Ro_20a + Ro_20b, Ro_20_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20a_lo, Ro_20_lo = Ro_20_lo1 + Ro_20b_lo;
  const double Ro_21a = R->m21 * dc[1], Ro_21a_lo = ksl_product_error(R->m21, dc[1], Ro_21a),
      Ro_21b = R->m20 * dc[0], Ro_21b_lo = ksl_product_error(R->m20, dc[0], Ro_21b),
      Ro_21 = Ro_21a - Ro_21b, Ro_21_error = ksl_difference_error(Ro_21a, Ro_21b, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21a_lo, Ro_21_lo = Ro_21_lo1 - Ro_21b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00a_lo = ksl_product_error(D->m00, dc[1], Do_00a),
      Do_00b = D->m01 * dc[0], Do_00b_lo = ksl_product_error(D->m01, dc[0], Do_00b),
      Do_00 = Do_00a + Do_00b, Do_00_error = ksl_sum_error(Do_00a, Do_00b, Do_00),
      Do_00_lo1 = Do_00_error + Do_00a_lo, Do_00_lo = Do_00_lo1 + Do_00b_lo;
  const double Do_01a = D->m01 * dc[1], Do_01a_lo = ksl_product_error(D->m01, dc[1], Do_01a),
      Do_01b = D->m00 * dc[0], Do_01b_lo = ksl_product_error(D->m00, dc[0], Do_01b),
      Do_01 = Do_01a - Do_01b, Do_01_error = ksl_difference_error(Do_01a, Do_01b, Do_01),
      Do_01_lo1 = Do_01_error + Do_01a_lo, Do_01_lo = Do_01_lo1 - Do_01b_lo;
  const double Do_10a = D->m10 * dc[1], Do_10a_lo = ksl_product_error(D->m10, dc[1], Do_10a),
      Do_10b = D->m11 * dc[0], Do_10b_lo = ksl_product_error(D->m11, dc[0], Do_10b),
      Do_10 = Do_10a + Do_10b, Do_10_error = ksl_sum_error(Do_10a, Do_10b, Do_10),
      Do_10_lo1 = Do_10_error + Do_10a_lo, Do_10_lo = Do_10_lo1 + Do_10b_lo;
  const double Do_11a = D->m11 * dc[1], Do_11a_lo = ksl_product_error(D->m11, dc[1], Do_11a),
      Do_11b = D->m10 * dc[0], Do_11b_lo = ksl_product_error(D->m10, dc[0], Do_11b),
      Do_11 = Do_11a - Do_11b, Do_11_error = ksl_difference_error(Do_11a, Do_11b, Do_11),
      Do_11_lo1 = Do_11_error + Do_11a_lo, Do_11_lo = Do_11_lo1 - Do_11b_lo;
  const double Do_20a = D->m20 * dc[1], Do_20a_lo = ksl_product_error(D->m20, dc[1], Do_20a),
      Do_20b = D->m21 * dc[0], Do_20b_lo = ksl_product_error(D->m21, dc[0], Do_20b),
      Do_20 = Do_20a + Do_20b, Do_20_error = ksl_sum_error(Do_20a, Do_20b, Do_20),
      Do_20_lo1 = Do_20_error + Do_20a_lo, Do_20_lo = Do_20_lo1 + Do_20b_lo;
  const double Do_21a = D->m21 * dc[1], Do_21a_lo = ksl_product_error(D->m21, dc[1], Do_21a),
      Do_21b = D->m20 * dc[0], Do_21b_lo = ksl_product_error(D->m20, dc[0], Do_21b),
      Do_21 = Do_21a - Do_21b, Do_21_error = ksl_difference_error(Do_21a, Do_21b, Do_21),
      Do_21_lo1 = Do_21_error + Do_21a_lo, Do_21_lo = Do_21_lo1 - Do_21b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03a_lo = ksl_product_error(D->m02, k, Do_03a),
      Do_03 = Do_03a + D->m03, Do_03_error = ksl_sum_error(Do_03a, D->m03, Do_03),
      Do_03_lo = Do_03_error + Do_03a_lo;
  const double Do_13a = D->m12 * k, Do_13a_lo = ksl_product_error(D->m12, k, Do_13a),
      Do_13 = Do_13a + D->m13, Do_13_error = ksl_sum_error(Do_13a, D->m13, Do_13),
      Do_13_lo = Do_13_error + Do_13a_lo;
  const double Do_23a = D->m22 * k, Do_23a_lo = ksl_product_error(D->m22, k, Do_23a),
      Do_23 = Do_23a + D->m23, Do_23_error = ksl_sum_error(Do_23a, D->m23, Do_23),
      Do_23_lo = Do_23_error + Do_23a_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00a_lo = ksl_product_error(R->m00, dc[1], Ro_00a),
      Ro_00b = R->m01 * dc[0], Ro_00b_lo = ksl_product_error(R->m01, dc[0], Ro_00b),
      Ro_00 = Ro_00a - Ro_00b, Ro_00_error = ksl_difference_error(Ro_00a, Ro_00b, Ro_00),
      Ro_00_lo1 = Ro_00_error + Ro_00a_lo, Ro_00_lo = Ro_00_lo1 - Ro_00b_lo;
  const double Ro_01a = R->m00 * dc[0], Ro_01a_lo = ksl_product_error(R->m00, dc[0], Ro_01a),
      Ro_01b = R->m01 * dc[1], Ro_01b_lo = ksl_product_error(R->m01, dc[1], Ro_01b),
      Ro_01 = Ro_01a + Ro_01b, Ro_01_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01),
      Ro_01_lo1 = Ro_01_error + Ro_01a_lo, Ro_01_lo = Ro_01_lo1 + Ro_01b_lo;
  const double Ro_10a = R->m10 * dc[1], Ro_10a_lo = ksl_product_error(R->m10, dc[1], Ro_10a),
      Ro_10b = R->m11 * dc[0], Ro_10b_lo = ksl_product_error(R->m11, dc[0], Ro_10b),
      Ro_10 = Ro_10a - Ro_10b, Ro_10_error = ksl_difference_error(Ro_10a, Ro_10b, Ro_10),
      Ro_10_lo1 = Ro_10_error + Ro_10a_lo, Ro_10_lo = Ro_10_lo1 - Ro_10b_lo;
  const double Ro_11a = R->m10 * dc[0], Ro_11a_lo = ksl_product_error(R->m10, dc[0], Ro_11a),
      Ro_11b = R->m11 * dc[1], Ro_11b_lo = ksl_product_error(R->m11, dc[1], Ro_11b),
      Ro_11 = Ro_11a + Ro_11b, Ro_11_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11),
      Ro_11_lo1 = Ro_11_error + Ro_11a_lo, Ro_11_lo = Ro_11_lo1 + Ro_11b_lo;
  const double Ro_20a = R->m20 * dc[1], Ro_20a_lo = ksl_product_error(R->m20, dc[1], Ro_20a),
      Ro_20b = R->m21 * dc[0], Ro_20b_lo = ksl_product_error(R->m21, dc[0], Ro_20b),
      Ro_20 = Ro_20a - Ro_20b, Ro_20_error = ksl_difference_error(Ro_20a, Ro_20b, Ro_20),
      Ro_20_lo1 = Ro_20_error + Ro_20a_lo, Ro_20_lo = Ro_20_lo1 - Ro_20b_lo;
  const double Ro_21a = R->m20 * dc[0], Ro_21a_lo = ksl_product_error(R->m20, dc[0], Ro_21a),
      Ro_21b = R->m21 * dc[1], Ro_21b_lo = ksl_product_error(R->m21, dc[1], Ro_21b),
      Ro_21 = Ro_21a + Ro_21b, Ro_21_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21),
      Ro_21_lo1 = Ro_21_error + Ro_21a_lo, Ro_21_lo = Ro_21_lo1 + Ro_21b_lo;
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
   12 mul, 24 add, 12 product error, 6 sum error.
   Error <= u |result| + (R: 4, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00a_lo = ksl_product_error(D->m00, dc[1], Do_00a),
      Do_00b = D->m01 * dc[0], Do_00b_lo = ksl_product_error(D->m01, dc[0], Do_00b),
      Do_00 = Do_00a - Do_00b, Do_00_error = ksl_difference_error(Do_00a, Do_00b, Do_00),
      Do_00_lo1 = Do_00_error + Do_00a_lo, Do_00_lo = Do_00_lo1 - Do_00b_lo;
  const double Do_01a = D->m00 * dc[0], Do_01a_lo = ksl_product_error(D->m00, dc[0], Do_01a),
      Do_01b = D->m01 * dc[1], Do_01b_lo = ksl_product_error(D->m01, dc[1], Do_01b),
      Do_01 = Do_01a + Do_01b, Do_01_error = ksl_sum_error(Do_01a, Do_01b, Do_01),
      Do_01_lo1 = Do_01_error + Do_01a_lo, Do_01_lo = Do_01_lo1 + Do_01b_lo;
  const double Do_10a = D->m10 * dc[1], Do_10a_lo = ksl_product_error(D->m10, dc[1], Do_10a),
      Do_10b = D->m11 * dc[0], Do_10b_lo = ksl_product_error(D->m11, dc[0], Do_10b),
      Do_10 = Do_10a - Do_10b, Do_10_error = ksl_difference_error(Do_10a, Do_10b, Do_10),
      Do_10_lo1 = Do_10_error + Do_10a_lo, Do_10_lo = Do_10_lo1 - Do_10b_lo;
  const double Do_11a = D->m10 * dc[0], Do_11a_lo = ksl_product_error(D->m10, dc[0], Do_11a),
      Do_11b = D->m11 * dc[1], Do_11b_lo = ksl_product_error(D->m11, dc[1], Do_11b),
      Do_11 = Do_11a + Do_11b, Do_11_error = ksl_sum_error(Do_11a, Do_11b, Do_11),
      Do_11_lo1 = Do_11_error + Do_11a_lo, Do_11_lo = Do_11_lo1 + Do_11b_lo;
  const double Do_20a = D->m20 * dc[1], Do_20a_lo = ksl_product_error(D->m20, dc[1], Do_20a),
      Do_20b = D->m21 * dc[0], Do_20b_lo = ksl_product_error(D->m21, dc[0], Do_20b),
      Do_20 = Do_20a - Do_20b, Do_20_error = ksl_difference_error(Do_20a, Do_20b, Do_20),
      Do_20_lo1 = Do_20_error + Do_20a_lo, Do_20_lo = Do_20_lo1 - Do_20b_lo;
  const double Do_21a = D->m20 * dc[0], Do_21a_lo = ksl_product_error(D->m20, dc[0], Do_21a),
      Do_21b = D->m21 * dc[1], Do_21b_lo = ksl_product_error(D->m21, dc[1], Do_21b),
      Do_21 = Do_21a + Do_21b, Do_21_error = ksl_sum_error(Do_21a, Do_21b, Do_21),
      Do_21_lo1 = Do_21_error + Do_21a_lo, Do_21_lo = Do_21_lo1 + Do_21b_lo;
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
   3 mul, 9 add, 3 product error, 3 sum error.
   Error <= u |result| + (R: 0, t: 2) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03a_lo = ksl_product_error(D->m02, k, Do_03a),
      Do_03 = D->m03 - Do_03a, Do_03_error = ksl_difference_error(D->m03, Do_03a, Do_03),
      Do_03_lo = Do_03_error - Do_03a_lo;
  const double Do_13a = D->m12 * k, Do_13a_lo = ksl_product_error(D->m12, k, Do_13a),
      Do_13 = D->m13 - Do_13a, Do_13_error = ksl_difference_error(D->m13, Do_13a, Do_13),
      Do_13_lo = Do_13_error - Do_13a_lo;
  const double Do_23a = D->m22 * k, Do_23a_lo = ksl_product_error(D->m22, k, Do_23a),
      Do_23 = D->m23 - Do_23a, Do_23_error = ksl_difference_error(D->m23, Do_23a, Do_23),
      Do_23_lo = Do_23_error - Do_23a_lo;
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
  const double self_0_new = self->m0 * a,
      self_0_new_lo = ksl_product_error(self->m0, a, self_0_new);
  const double self_1_new = self->m1 * a,
      self_1_new_lo = ksl_product_error(self->m1, a, self_1_new);
  const double self_2_new = self->m2 * a,
      self_2_new_lo = ksl_product_error(self->m2, a, self_2_new);
  const double self_3_new = self->m3 * a,
      self_3_new_lo = ksl_product_error(self->m3, a, self_3_new);
  const double self_4_new = self->m4 * a,
      self_4_new_lo = ksl_product_error(self->m4, a, self_4_new);
  const double self_5_new = self->m5 * a,
      self_5_new_lo = ksl_product_error(self->m5, a, self_5_new);
  const double self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_rounded = self_3_new + self_3_new_lo;
  const double self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_rounded = self_5_new + self_5_new_lo;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + 2 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss_accurate(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new_a_lo = ksl_product_error(a, x->m0, y_0_new_a),
      y_0_new = y_0_new_a + y->m0, y_0_new_error = ksl_sum_error(y_0_new_a, y->m0, y_0_new),
      y_0_new_lo = y_0_new_error + y_0_new_a_lo;
  const double y_1_new_a = a * x->m1, y_1_new_a_lo = ksl_product_error(a, x->m1, y_1_new_a),
      y_1_new = y_1_new_a + y->m1, y_1_new_error = ksl_sum_error(y_1_new_a, y->m1, y_1_new),
      y_1_new_lo = y_1_new_error + y_1_new_a_lo;
  const double y_2_new_a = a * x->m2, y_2_new_a_lo = ksl_product_error(a, x->m2, y_2_new_a),
      y_2_new = y_2_new_a + y->m2, y_2_new_error = ksl_sum_error(y_2_new_a, y->m2, y_2_new),
      y_2_new_lo = y_2_new_error + y_2_new_a_lo;
  const double y_3_new_a = a * x->m3, y_3_new_a_lo = ksl_product_error(a, x->m3, y_3_new_a),
      y_3_new = y_3_new_a + y->m3, y_3_new_error = ksl_sum_error(y_3_new_a, y->m3, y_3_new),
      y_3_new_lo = y_3_new_error + y_3_new_a_lo;
  const double y_4_new_a = a * x->m4, y_4_new_a_lo = ksl_product_error(a, x->m4, y_4_new_a),
      y_4_new = y_4_new_a + y->m4, y_4_new_error = ksl_sum_error(y_4_new_a, y->m4, y_4_new),
      y_4_new_lo = y_4_new_error + y_4_new_a_lo;
  const double y_5_new_a = a * x->m5, y_5_new_a_lo = ksl_product_error(a, x->m5, y_5_new_a),
      y_5_new = y_5_new_a + y->m5, y_5_new_error = ksl_sum_error(y_5_new_a, y->m5, y_5_new),
      y_5_new_lo = y_5_new_error + y_5_new_a_lo;
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = x->m0 + y->m0, y_0_new_lo = ksl_sum_error(x->m0, y->m0, y_0_new);
  const double y_1_new = x->m1 + y->m1, y_1_new_lo = ksl_sum_error(x->m1, y->m1, y_1_new);
  const double y_2_new = x->m2 + y->m2, y_2_new_lo = ksl_sum_error(x->m2, y->m2, y_2_new);
  const double y_3_new = x->m3 + y->m3, y_3_new_lo = ksl_sum_error(x->m3, y->m3, y_3_new);
  const double y_4_new = x->m4 + y->m4, y_4_new_lo = ksl_sum_error(x->m4, y->m4, y_4_new);
  const double y_5_new = x->m5 + y->m5, y_5_new_lo = ksl_sum_error(x->m5, y->m5, y_5_new);
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = y->m0 - x->m0, y_0_new_lo = ksl_difference_error(y->m0, x->m0, y_0_new);
  const double y_1_new = y->m1 - x->m1, y_1_new_lo = ksl_difference_error(y->m1, x->m1, y_1_new);
  const double y_2_new = y->m2 - x->m2, y_2_new_lo = ksl_difference_error(y->m2, x->m2, y_2_new);
  const double y_3_new = y->m3 - x->m3, y_3_new_lo = ksl_difference_error(y->m3, x->m3, y_3_new);
  const double y_4_new = y->m4 - x->m4, y_4_new_lo = ksl_difference_error(y->m4, x->m4, y_4_new);
  const double y_5_new = y->m5 - x->m5, y_5_new_lo = ksl_difference_error(y->m5, x->m5, y_5_new);
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
  const double so_0 = a * si->m0, so_0_lo = ksl_product_error(a, si->m0, so_0);
  const double so_1 = a * si->m1, so_1_lo = ksl_product_error(a, si->m1, so_1);
  const double so_2 = a * si->m2, so_2_lo = ksl_product_error(a, si->m2, so_2);
  const double so_3 = a * si->m3, so_3_lo = ksl_product_error(a, si->m3, so_3);
  const double so_4 = a * si->m4, so_4_lo = ksl_product_error(a, si->m4, so_4);
  const double so_5 = a * si->m5, so_5_lo = ksl_product_error(a, si->m5, so_5);
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

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_lo = ksl_sum_error(s1->m0, s2->m0, so_0);
  const double so_1 = s1->m1 + s2->m1, so_1_lo = ksl_sum_error(s1->m1, s2->m1, so_1);
  const double so_2 = s1->m2 + s2->m2, so_2_lo = ksl_sum_error(s1->m2, s2->m2, so_2);
  const double so_3 = s1->m3 + s2->m3, so_3_lo = ksl_sum_error(s1->m3, s2->m3, so_3);
  const double so_4 = s1->m4 + s2->m4, so_4_lo = ksl_sum_error(s1->m4, s2->m4, so_4);
  const double so_5 = s1->m5 + s2->m5, so_5_lo = ksl_sum_error(s1->m5, s2->m5, so_5);
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0, so_0_lo = ksl_difference_error(s1->m0, s2->m0, so_0);
  const double so_1 = s1->m1 - s2->m1, so_1_lo = ksl_difference_error(s1->m1, s2->m1, so_1);
  const double so_2 = s1->m2 - s2->m2, so_2_lo = ksl_difference_error(s1->m2, s2->m2, so_2);
  const double so_3 = s1->m3 - s2->m3, so_3_lo = ksl_difference_error(s1->m3, s2->m3, so_3);
  const double so_4 = s1->m4 - s2->m4, so_4_lo = ksl_difference_error(s1->m4, s2->m4, so_4);
  const double so_5 = s1->m5 - s2->m5, so_5_lo = ksl_difference_error(s1->m5, s2->m5, so_5);
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

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   10 mul, 16 add, 4 product error, 2 sum error, 2 div, 1 sqrt, 6 abs, 9 less, 4 equal, 15
     select. */
static inline double ksl_screw_norm_accurate(const ksl_screw_t *si) {
  const double small_a = fabs(si->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(si->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(si->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3;
  const double p_1 = small == 1.0 ? si->m1 : si->m4;
  const double p_2 = small == 1.0 ? si->m2 : si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm_total = n + n_lo, norm_added = norm_total - n,
      norm_remaining = n_lo - norm_added, norm = norm_total * r, norm_inverse = 1.0 / r,
      norm_back = norm * norm_inverse, norm_lost = norm_total - norm_back,
      norm_rest = norm_lost + norm_remaining, norm_small = norm_rest * r,
      norm_lo = norm_lost == 0.0 ? 0.0 : norm_small;
  const double norm_total = norm + norm_lo,
      norm_rounded = norm_total == norm_total ? norm_total : norm;
  return norm_rounded;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   43 mul, 64 add, 10 product error, 2 sum error, 14 div, 1 sqrt, 6 abs, 9 less, 15 equal, 27
     select. */
static inline void ksl_screw_normalize_accurate(ksl_screw_t *self) {
  const double small_a = fabs(self->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m0 : self->m3;
  const double p_1 = small == 1.0 ? self->m1 : self->m4;
  const double p_2 = small == 1.0 ? self->m2 : self->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = self->m0 * up;
  const double enlarged_1 = self->m1 * up;
  const double enlarged_2 = self->m2 * up;
  const double enlarged_3 = self->m3 * up;
  const double enlarged_4 = self->m4 * up;
  const double enlarged_5 = self->m5 * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double quotient_4 = enlarged_4 / divisor, quotient_4_cross = quotient_4 * divisor_lo,
      quotient_4_product = quotient_4 * divisor,
      quotient_4_product_error = ksl_product_error(quotient_4, divisor, quotient_4_product),
      quotient_4_rest = enlarged_4 - quotient_4_product,
      quotient_4_exact = quotient_4_rest - quotient_4_product_error,
      quotient_4_residual = quotient_4_exact - quotient_4_cross,
      quotient_4_lo = quotient_4_residual / divisor;
  const double quotient_5 = enlarged_5 / divisor, quotient_5_cross = quotient_5 * divisor_lo,
      quotient_5_product = quotient_5 * divisor,
      quotient_5_product_error = ksl_product_error(quotient_5, divisor, quotient_5_product),
      quotient_5_rest = enlarged_5 - quotient_5_product,
      quotient_5_exact = quotient_5_rest - quotient_5_product_error,
      quotient_5_residual = quotient_5_exact - quotient_5_cross,
      quotient_5_lo = quotient_5_residual / divisor;
  const double self_0_new_total = quotient_0 + quotient_0_lo,
      self_0_new_added = self_0_new_total - quotient_0,
      self_0_new_remaining = quotient_0_lo - self_0_new_added, self_0_new = self_0_new_total * down,
      self_0_new_inverse = 1.0 / down, self_0_new_back = self_0_new * self_0_new_inverse,
      self_0_new_lost = self_0_new_total - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_remaining,
      self_0_new_small = self_0_new_rest * down,
      self_0_new_lo = self_0_new_lost == 0.0 ? 0.0 : self_0_new_small;
  const double self_1_new_total = quotient_1 + quotient_1_lo,
      self_1_new_added = self_1_new_total - quotient_1,
      self_1_new_remaining = quotient_1_lo - self_1_new_added, self_1_new = self_1_new_total * down,
      self_1_new_back = self_1_new * self_0_new_inverse,
      self_1_new_lost = self_1_new_total - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_remaining,
      self_1_new_small = self_1_new_rest * down,
      self_1_new_lo = self_1_new_lost == 0.0 ? 0.0 : self_1_new_small;
  const double self_2_new_total = quotient_2 + quotient_2_lo,
      self_2_new_added = self_2_new_total - quotient_2,
      self_2_new_remaining = quotient_2_lo - self_2_new_added, self_2_new = self_2_new_total * down,
      self_2_new_back = self_2_new * self_0_new_inverse,
      self_2_new_lost = self_2_new_total - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_remaining,
      self_2_new_small = self_2_new_rest * down,
      self_2_new_lo = self_2_new_lost == 0.0 ? 0.0 : self_2_new_small;
  const double self_3_new_total = quotient_3 + quotient_3_lo,
      self_3_new_added = self_3_new_total - quotient_3,
      self_3_new_remaining = quotient_3_lo - self_3_new_added, self_3_new = self_3_new_total * down,
      self_3_new_back = self_3_new * self_0_new_inverse,
      self_3_new_lost = self_3_new_total - self_3_new_back,
      self_3_new_rest = self_3_new_lost + self_3_new_remaining,
      self_3_new_small = self_3_new_rest * down,
      self_3_new_lo = self_3_new_lost == 0.0 ? 0.0 : self_3_new_small;
  const double self_4_new_total = quotient_4 + quotient_4_lo,
      self_4_new_added = self_4_new_total - quotient_4,
      self_4_new_remaining = quotient_4_lo - self_4_new_added, self_4_new = self_4_new_total * down,
      self_4_new_back = self_4_new * self_0_new_inverse,
      self_4_new_lost = self_4_new_total - self_4_new_back,
      self_4_new_rest = self_4_new_lost + self_4_new_remaining,
      self_4_new_small = self_4_new_rest * down,
      self_4_new_lo = self_4_new_lost == 0.0 ? 0.0 : self_4_new_small;
  const double self_5_new_total = quotient_5 + quotient_5_lo,
      self_5_new_added = self_5_new_total - quotient_5,
      self_5_new_remaining = quotient_5_lo - self_5_new_added, self_5_new = self_5_new_total * down,
      self_5_new_back = self_5_new * self_0_new_inverse,
      self_5_new_lost = self_5_new_total - self_5_new_back,
      self_5_new_rest = self_5_new_lost + self_5_new_remaining,
      self_5_new_small = self_5_new_rest * down,
      self_5_new_lo = self_5_new_lost == 0.0 ? 0.0 : self_5_new_small;
  const double self_0_new_total = self_0_new + self_0_new_lo,
      self_0_new_rounded = self_0_new_total == self_0_new_total ? self_0_new_total : self_0_new;
  const double self_1_new_total = self_1_new + self_1_new_lo,
      self_1_new_rounded = self_1_new_total == self_1_new_total ? self_1_new_total : self_1_new;
  const double self_2_new_total = self_2_new + self_2_new_lo,
      self_2_new_rounded = self_2_new_total == self_2_new_total ? self_2_new_total : self_2_new;
  const double self_3_new_total = self_3_new + self_3_new_lo,
      self_3_new_rounded = self_3_new_total == self_3_new_total ? self_3_new_total : self_3_new;
  const double self_4_new_total = self_4_new + self_4_new_lo,
      self_4_new_rounded = self_4_new_total == self_4_new_total ? self_4_new_total : self_4_new;
  const double self_5_new_total = self_5_new + self_5_new_lo,
      self_5_new_rounded = self_5_new_total == self_5_new_total ? self_5_new_total : self_5_new;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   43 mul, 64 add, 10 product error, 2 sum error, 14 div, 1 sqrt, 6 abs, 9 less, 15 equal, 27
     select. */
static inline void ksl_screw_normalized_accurate(const ksl_screw_t *si, ksl_screw_t *so) {
  const double small_a = fabs(si->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(si->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(si->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3;
  const double p_1 = small == 1.0 ? si->m1 : si->m4;
  const double p_2 = small == 1.0 ? si->m2 : si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = si->m0 * up;
  const double enlarged_1 = si->m1 * up;
  const double enlarged_2 = si->m2 * up;
  const double enlarged_3 = si->m3 * up;
  const double enlarged_4 = si->m4 * up;
  const double enlarged_5 = si->m5 * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double quotient_4 = enlarged_4 / divisor, quotient_4_cross = quotient_4 * divisor_lo,
      quotient_4_product = quotient_4 * divisor,
      quotient_4_product_error = ksl_product_error(quotient_4, divisor, quotient_4_product),
      quotient_4_rest = enlarged_4 - quotient_4_product,
      quotient_4_exact = quotient_4_rest - quotient_4_product_error,
      quotient_4_residual = quotient_4_exact - quotient_4_cross,
      quotient_4_lo = quotient_4_residual / divisor;
  const double quotient_5 = enlarged_5 / divisor, quotient_5_cross = quotient_5 * divisor_lo,
      quotient_5_product = quotient_5 * divisor,
      quotient_5_product_error = ksl_product_error(quotient_5, divisor, quotient_5_product),
      quotient_5_rest = enlarged_5 - quotient_5_product,
      quotient_5_exact = quotient_5_rest - quotient_5_product_error,
      quotient_5_residual = quotient_5_exact - quotient_5_cross,
      quotient_5_lo = quotient_5_residual / divisor;
  const double so_0_total = quotient_0 + quotient_0_lo, so_0_added = so_0_total - quotient_0,
      so_0_remaining = quotient_0_lo - so_0_added, so_0 = so_0_total * down,
      so_0_inverse = 1.0 / down, so_0_back = so_0 * so_0_inverse,
      so_0_lost = so_0_total - so_0_back, so_0_rest = so_0_lost + so_0_remaining,
      so_0_small = so_0_rest * down, so_0_lo = so_0_lost == 0.0 ? 0.0 : so_0_small;
  const double so_1_total = quotient_1 + quotient_1_lo, so_1_added = so_1_total - quotient_1,
      so_1_remaining = quotient_1_lo - so_1_added, so_1 = so_1_total * down,
      so_1_back = so_1 * so_0_inverse, so_1_lost = so_1_total - so_1_back,
      so_1_rest = so_1_lost + so_1_remaining, so_1_small = so_1_rest * down,
      so_1_lo = so_1_lost == 0.0 ? 0.0 : so_1_small;
  const double so_2_total = quotient_2 + quotient_2_lo, so_2_added = so_2_total - quotient_2,
      so_2_remaining = quotient_2_lo - so_2_added, so_2 = so_2_total * down,
      so_2_back = so_2 * so_0_inverse, so_2_lost = so_2_total - so_2_back,
      so_2_rest = so_2_lost + so_2_remaining, so_2_small = so_2_rest * down,
      so_2_lo = so_2_lost == 0.0 ? 0.0 : so_2_small;
  const double so_3_total = quotient_3 + quotient_3_lo, so_3_added = so_3_total - quotient_3,
      so_3_remaining = quotient_3_lo - so_3_added, so_3 = so_3_total * down,
      so_3_back = so_3 * so_0_inverse, so_3_lost = so_3_total - so_3_back,
      so_3_rest = so_3_lost + so_3_remaining, so_3_small = so_3_rest * down,
      so_3_lo = so_3_lost == 0.0 ? 0.0 : so_3_small;
  const double so_4_total = quotient_4 + quotient_4_lo, so_4_added = so_4_total - quotient_4,
      so_4_remaining = quotient_4_lo - so_4_added, so_4 = so_4_total * down,
      so_4_back = so_4 * so_0_inverse, so_4_lost = so_4_total - so_4_back,
      so_4_rest = so_4_lost + so_4_remaining, so_4_small = so_4_rest * down,
      so_4_lo = so_4_lost == 0.0 ? 0.0 : so_4_small;
  const double so_5_total = quotient_5 + quotient_5_lo, so_5_added = so_5_total - quotient_5,
      so_5_remaining = quotient_5_lo - so_5_added, so_5 = so_5_total * down,
      so_5_back = so_5 * so_0_inverse, so_5_lost = so_5_total - so_5_back,
      so_5_rest = so_5_lost + so_5_remaining, so_5_small = so_5_rest * down,
      so_5_lo = so_5_lost == 0.0 ? 0.0 : so_5_small;
  const double so_0_total = so_0 + so_0_lo,
      so_0_rounded = so_0_total == so_0_total ? so_0_total : so_0;
  const double so_1_total = so_1 + so_1_lo,
      so_1_rounded = so_1_total == so_1_total ? so_1_total : so_1;
  const double so_2_total = so_2 + so_2_lo,
      so_2_rounded = so_2_total == so_2_total ? so_2_total : so_2;
  const double so_3_total = so_3 + so_3_lo,
      so_3_rounded = so_3_total == so_3_total ? so_3_total : so_3;
  const double so_4_total = so_4 + so_4_lo,
      so_4_rounded = so_4_total == so_4_total ? so_4_total : so_4;
  const double so_5_total = so_5 + so_5_lo,
      so_5_rounded = so_5_total == so_5_total ? so_5_total : so_5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_lo = ksl_sum_error(s1->m0, s2->m0, so_0);
  const double so_1 = s1->m1 + s2->m1, so_1_lo = ksl_sum_error(s1->m1, s2->m1, so_1);
  const double so_2 = s1->m2 + s2->m2, so_2_lo = ksl_sum_error(s1->m2, s2->m2, so_2);
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
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + (lin: 7, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adts_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->y * si->m5, so_0a_lo = ksl_product_error(t->y, si->m5, so_0a),
      so_0b = t->z * si->m4, so_0b_lo = ksl_product_error(t->z, si->m4, so_0b),
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0 = so_0c + si->m0,
      so_0_error = ksl_sum_error(so_0c, si->m0, so_0), so_0_lo = so_0_error + so_0c_lo;
  const double so_1a = t->z * si->m3, so_1a_lo = ksl_product_error(t->z, si->m3, so_1a),
      so_1b = t->x * si->m5, so_1b_lo = ksl_product_error(t->x, si->m5, so_1b),
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1 = so_1c + si->m1,
      so_1_error = ksl_sum_error(so_1c, si->m1, so_1), so_1_lo = so_1_error + so_1c_lo;
  const double so_2a = t->x * si->m4, so_2a_lo = ksl_product_error(t->x, si->m4, so_2a),
      so_2b = t->y * si->m3, so_2b_lo = ksl_product_error(t->y, si->m3, so_2b),
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2 = so_2c + si->m2,
      so_2_error = ksl_sum_error(so_2c, si->m2, so_2), so_2_lo = so_2_error + so_2c_lo;
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
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + (lin: 7, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtinvs_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0a_lo = ksl_product_error(t->z, si->m4, so_0a),
      so_0b = t->y * si->m5, so_0b_lo = ksl_product_error(t->y, si->m5, so_0b),
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0 = so_0c + si->m0,
      so_0_error = ksl_sum_error(so_0c, si->m0, so_0), so_0_lo = so_0_error + so_0c_lo;
  const double so_1a = t->x * si->m5, so_1a_lo = ksl_product_error(t->x, si->m5, so_1a),
      so_1b = t->z * si->m3, so_1b_lo = ksl_product_error(t->z, si->m3, so_1b),
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1 = so_1c + si->m1,
      so_1_error = ksl_sum_error(so_1c, si->m1, so_1), so_1_lo = so_1_error + so_1c_lo;
  const double so_2a = t->y * si->m3, so_2a_lo = ksl_product_error(t->y, si->m3, so_2a),
      so_2b = t->x * si->m4, so_2b_lo = ksl_product_error(t->x, si->m4, so_2b),
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2 = so_2c + si->m2,
      so_2_error = ksl_sum_error(so_2c, si->m2, so_2), so_2_lo = so_2_error + so_2c_lo;
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
   6 mul, 18 add, 6 product error, 6 sum error, 3 neg.
   Error <= u |result| + (lin: 7, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsinv_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0a_lo = ksl_product_error(t->z, si->m4, so_0a),
      so_0b = t->y * si->m5, so_0b_lo = ksl_product_error(t->y, si->m5, so_0b),
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0 = so_0c - si->m0,
      so_0_error = ksl_difference_error(so_0c, si->m0, so_0), so_0_lo = so_0_error + so_0c_lo;
  const double so_1a = t->x * si->m5, so_1a_lo = ksl_product_error(t->x, si->m5, so_1a),
      so_1b = t->z * si->m3, so_1b_lo = ksl_product_error(t->z, si->m3, so_1b),
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1 = so_1c - si->m1,
      so_1_error = ksl_difference_error(so_1c, si->m1, so_1), so_1_lo = so_1_error + so_1c_lo;
  const double so_2a = t->y * si->m3, so_2a_lo = ksl_product_error(t->y, si->m3, so_2a),
      so_2b = t->x * si->m4, so_2b_lo = ksl_product_error(t->x, si->m4, so_2b),
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2 = so_2c - si->m2,
      so_2_error = ksl_difference_error(so_2c, si->m2, so_2), so_2_lo = so_2_error + so_2c_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0a_lo = ksl_product_error(R->m00, si->m0, so_0a),
      so_0b = R->m01 * si->m1, so_0b_lo = ksl_product_error(R->m01, si->m1, so_0b),
      so_0c = so_0a + so_0b, so_0c_error = ksl_sum_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 + so_0b_lo, so_0d = R->m02 * si->m2,
      so_0d_lo = ksl_product_error(R->m02, si->m2, so_0d), so_0 = so_0c + so_0d,
      so_0_error = ksl_sum_error(so_0c, so_0d, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + so_0d_lo;
  const double so_1a = R->m10 * si->m0, so_1a_lo = ksl_product_error(R->m10, si->m0, so_1a),
      so_1b = R->m11 * si->m1, so_1b_lo = ksl_product_error(R->m11, si->m1, so_1b),
      so_1c = so_1a + so_1b, so_1c_error = ksl_sum_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 + so_1b_lo, so_1d = R->m12 * si->m2,
      so_1d_lo = ksl_product_error(R->m12, si->m2, so_1d), so_1 = so_1c + so_1d,
      so_1_error = ksl_sum_error(so_1c, so_1d, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + so_1d_lo;
  const double so_2a = R->m20 * si->m0, so_2a_lo = ksl_product_error(R->m20, si->m0, so_2a),
      so_2b = R->m21 * si->m1, so_2b_lo = ksl_product_error(R->m21, si->m1, so_2b),
      so_2c = so_2a + so_2b, so_2c_error = ksl_sum_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 + so_2b_lo, so_2d = R->m22 * si->m2,
      so_2d_lo = ksl_product_error(R->m22, si->m2, so_2d), so_2 = so_2c + so_2d,
      so_2_error = ksl_sum_error(so_2c, so_2d, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + so_2d_lo;
  const double so_3a = R->m00 * si->m3, so_3a_lo = ksl_product_error(R->m00, si->m3, so_3a),
      so_3b = R->m01 * si->m4, so_3b_lo = ksl_product_error(R->m01, si->m4, so_3b),
      so_3c = so_3a + so_3b, so_3c_error = ksl_sum_error(so_3a, so_3b, so_3c),
      so_3c_lo1 = so_3c_error + so_3a_lo, so_3c_lo = so_3c_lo1 + so_3b_lo, so_3d = R->m02 * si->m5,
      so_3d_lo = ksl_product_error(R->m02, si->m5, so_3d), so_3 = so_3c + so_3d,
      so_3_error = ksl_sum_error(so_3c, so_3d, so_3), so_3_lo1 = so_3_error + so_3c_lo,
      so_3_lo = so_3_lo1 + so_3d_lo;
  const double so_4a = R->m10 * si->m3, so_4a_lo = ksl_product_error(R->m10, si->m3, so_4a),
      so_4b = R->m11 * si->m4, so_4b_lo = ksl_product_error(R->m11, si->m4, so_4b),
      so_4c = so_4a + so_4b, so_4c_error = ksl_sum_error(so_4a, so_4b, so_4c),
      so_4c_lo1 = so_4c_error + so_4a_lo, so_4c_lo = so_4c_lo1 + so_4b_lo, so_4d = R->m12 * si->m5,
      so_4d_lo = ksl_product_error(R->m12, si->m5, so_4d), so_4 = so_4c + so_4d,
      so_4_error = ksl_sum_error(so_4c, so_4d, so_4), so_4_lo1 = so_4_error + so_4c_lo,
      so_4_lo = so_4_lo1 + so_4d_lo;
  const double so_5a = R->m20 * si->m3, so_5a_lo = ksl_product_error(R->m20, si->m3, so_5a),
      so_5b = R->m21 * si->m4, so_5b_lo = ksl_product_error(R->m21, si->m4, so_5b),
      so_5c = so_5a + so_5b, so_5c_error = ksl_sum_error(so_5a, so_5b, so_5c),
      so_5c_lo1 = so_5c_error + so_5a_lo, so_5c_lo = so_5c_lo1 + so_5b_lo, so_5d = R->m22 * si->m5,
      so_5d_lo = ksl_product_error(R->m22, si->m5, so_5d), so_5 = so_5c + so_5d,
      so_5_error = ksl_sum_error(so_5c, so_5d, so_5), so_5_lo1 = so_5_error + so_5c_lo,
      so_5_lo = so_5_lo1 + so_5d_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrinvs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0a_lo = ksl_product_error(R->m00, si->m0, so_0a),
      so_0b = R->m10 * si->m1, so_0b_lo = ksl_product_error(R->m10, si->m1, so_0b),
      so_0c = so_0a + so_0b, so_0c_error = ksl_sum_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 + so_0b_lo, so_0d = R->m20 * si->m2,
      so_0d_lo = ksl_product_error(R->m20, si->m2, so_0d), so_0 = so_0c + so_0d,
      so_0_error = ksl_sum_error(so_0c, so_0d, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + so_0d_lo;
  const double so_1a = R->m01 * si->m0, so_1a_lo = ksl_product_error(R->m01, si->m0, so_1a),
      so_1b = R->m11 * si->m1, so_1b_lo = ksl_product_error(R->m11, si->m1, so_1b),
      so_1c = so_1a + so_1b, so_1c_error = ksl_sum_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 + so_1b_lo, so_1d = R->m21 * si->m2,
      so_1d_lo = ksl_product_error(R->m21, si->m2, so_1d), so_1 = so_1c + so_1d,
      so_1_error = ksl_sum_error(so_1c, so_1d, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + so_1d_lo;
  const double so_2a = R->m02 * si->m0, so_2a_lo = ksl_product_error(R->m02, si->m0, so_2a),
      so_2b = R->m12 * si->m1, so_2b_lo = ksl_product_error(R->m12, si->m1, so_2b),
      so_2c = so_2a + so_2b, so_2c_error = ksl_sum_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 + so_2b_lo, so_2d = R->m22 * si->m2,
      so_2d_lo = ksl_product_error(R->m22, si->m2, so_2d), so_2 = so_2c + so_2d,
      so_2_error = ksl_sum_error(so_2c, so_2d, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + so_2d_lo;
  const double so_3a = R->m00 * si->m3, so_3a_lo = ksl_product_error(R->m00, si->m3, so_3a),
      so_3b = R->m10 * si->m4, so_3b_lo = ksl_product_error(R->m10, si->m4, so_3b),
      so_3c = so_3a + so_3b, so_3c_error = ksl_sum_error(so_3a, so_3b, so_3c),
      so_3c_lo1 = so_3c_error + so_3a_lo, so_3c_lo = so_3c_lo1 + so_3b_lo, so_3d = R->m20 * si->m5,
      so_3d_lo = ksl_product_error(R->m20, si->m5, so_3d), so_3 = so_3c + so_3d,
      so_3_error = ksl_sum_error(so_3c, so_3d, so_3), so_3_lo1 = so_3_error + so_3c_lo,
      so_3_lo = so_3_lo1 + so_3d_lo;
  const double so_4a = R->m01 * si->m3, so_4a_lo = ksl_product_error(R->m01, si->m3, so_4a),
      so_4b = R->m11 * si->m4, so_4b_lo = ksl_product_error(R->m11, si->m4, so_4b),
      so_4c = so_4a + so_4b, so_4c_error = ksl_sum_error(so_4a, so_4b, so_4c),
      so_4c_lo1 = so_4c_error + so_4a_lo, so_4c_lo = so_4c_lo1 + so_4b_lo, so_4d = R->m21 * si->m5,
      so_4d_lo = ksl_product_error(R->m21, si->m5, so_4d), so_4 = so_4c + so_4d,
      so_4_error = ksl_sum_error(so_4c, so_4d, so_4), so_4_lo1 = so_4_error + so_4c_lo,
      so_4_lo = so_4_lo1 + so_4d_lo;
  const double so_5a = R->m02 * si->m3, so_5a_lo = ksl_product_error(R->m02, si->m3, so_5a),
      so_5b = R->m12 * si->m4, so_5b_lo = ksl_product_error(R->m12, si->m4, so_5b),
      so_5c = so_5a + so_5b, so_5c_error = ksl_sum_error(so_5a, so_5b, so_5c),
      so_5c_lo1 = so_5c_error + so_5a_lo, so_5c_lo = so_5c_lo1 + so_5b_lo, so_5d = R->m22 * si->m5,
      so_5d_lo = ksl_product_error(R->m22, si->m5, so_5d), so_5 = so_5c + so_5d,
      so_5_error = ksl_sum_error(so_5c, so_5d, so_5), so_5_lo1 = so_5_error + so_5c_lo,
      so_5_lo = so_5_lo1 + so_5d_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error, 12 neg.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsinv_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0a_lo = ksl_product_error(R->m00, si->m0, so_0a),
      so_0b = R->m01 * si->m1, so_0b_lo = ksl_product_error(R->m01, si->m1, so_0b),
      so_0c = so_0a + so_0b, so_0c_error = ksl_sum_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 + so_0b_lo, so_0d = R->m02 * si->m2,
      so_0d_lo = ksl_product_error(R->m02, si->m2, so_0d), so_0e = so_0c + so_0d,
      so_0e_error = ksl_sum_error(so_0c, so_0d, so_0e), so_0e_lo1 = so_0e_error + so_0c_lo,
      so_0e_lo = so_0e_lo1 + so_0d_lo, so_0 = -so_0e, so_0_lo = -so_0e_lo;
  const double so_1a = R->m10 * si->m0, so_1a_lo = ksl_product_error(R->m10, si->m0, so_1a),
      so_1b = R->m11 * si->m1, so_1b_lo = ksl_product_error(R->m11, si->m1, so_1b),
      so_1c = so_1a + so_1b, so_1c_error = ksl_sum_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 + so_1b_lo, so_1d = R->m12 * si->m2,
      so_1d_lo = ksl_product_error(R->m12, si->m2, so_1d), so_1e = so_1c + so_1d,
      so_1e_error = ksl_sum_error(so_1c, so_1d, so_1e), so_1e_lo1 = so_1e_error + so_1c_lo,
      so_1e_lo = so_1e_lo1 + so_1d_lo, so_1 = -so_1e, so_1_lo = -so_1e_lo;
  const double so_2a = R->m20 * si->m0, so_2a_lo = ksl_product_error(R->m20, si->m0, so_2a),
      so_2b = R->m21 * si->m1, so_2b_lo = ksl_product_error(R->m21, si->m1, so_2b),
      so_2c = so_2a + so_2b, so_2c_error = ksl_sum_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 + so_2b_lo, so_2d = R->m22 * si->m2,
      so_2d_lo = ksl_product_error(R->m22, si->m2, so_2d), so_2e = so_2c + so_2d,
      so_2e_error = ksl_sum_error(so_2c, so_2d, so_2e), so_2e_lo1 = so_2e_error + so_2c_lo,
      so_2e_lo = so_2e_lo1 + so_2d_lo, so_2 = -so_2e, so_2_lo = -so_2e_lo;
  const double so_3a = R->m00 * si->m3, so_3a_lo = ksl_product_error(R->m00, si->m3, so_3a),
      so_3b = R->m01 * si->m4, so_3b_lo = ksl_product_error(R->m01, si->m4, so_3b),
      so_3c = so_3a + so_3b, so_3c_error = ksl_sum_error(so_3a, so_3b, so_3c),
      so_3c_lo1 = so_3c_error + so_3a_lo, so_3c_lo = so_3c_lo1 + so_3b_lo, so_3d = R->m02 * si->m5,
      so_3d_lo = ksl_product_error(R->m02, si->m5, so_3d), so_3e = so_3c + so_3d,
      so_3e_error = ksl_sum_error(so_3c, so_3d, so_3e), so_3e_lo1 = so_3e_error + so_3c_lo,
      so_3e_lo = so_3e_lo1 + so_3d_lo, so_3 = -so_3e, so_3_lo = -so_3e_lo;
  const double so_4a = R->m10 * si->m3, so_4a_lo = ksl_product_error(R->m10, si->m3, so_4a),
      so_4b = R->m11 * si->m4, so_4b_lo = ksl_product_error(R->m11, si->m4, so_4b),
      so_4c = so_4a + so_4b, so_4c_error = ksl_sum_error(so_4a, so_4b, so_4c),
      so_4c_lo1 = so_4c_error + so_4a_lo, so_4c_lo = so_4c_lo1 + so_4b_lo, so_4d = R->m12 * si->m5,
      so_4d_lo = ksl_product_error(R->m12, si->m5, so_4d), so_4e = so_4c + so_4d,
      so_4e_error = ksl_sum_error(so_4c, so_4d, so_4e), so_4e_lo1 = so_4e_error + so_4c_lo,
      so_4e_lo = so_4e_lo1 + so_4d_lo, so_4 = -so_4e, so_4_lo = -so_4e_lo;
  const double so_5a = R->m20 * si->m3, so_5a_lo = ksl_product_error(R->m20, si->m3, so_5a),
      so_5b = R->m21 * si->m4, so_5b_lo = ksl_product_error(R->m21, si->m4, so_5b),
      so_5c = so_5a + so_5b, so_5c_error = ksl_sum_error(so_5a, so_5b, so_5c),
      so_5c_lo1 = so_5c_error + so_5a_lo, so_5c_lo = so_5c_lo1 + so_5b_lo, so_5d = R->m22 * si->m5,
      so_5d_lo = ksl_product_error(R->m22, si->m5, so_5d), so_5e = so_5c + so_5d,
      so_5e_error = ksl_sum_error(so_5c, so_5d, so_5e), so_5e_lo1 = so_5e_error + so_5c_lo,
      so_5e_lo = so_5e_lo1 + so_5d_lo, so_5 = -so_5e, so_5_lo = -so_5e_lo;
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
   30 mul, 66 add, 24 product error, 18 sum error.
   Error <= u |result| + (lin: 39, ang: 10) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Ads_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0a_lo = ksl_product_error(D->m00, si->m0, w_0a),
      w_0b = D->m01 * si->m1, w_0b_lo = ksl_product_error(D->m01, si->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * si->m2,
      w_0d_lo = ksl_product_error(D->m02, si->m2, w_0d), w_0 = w_0c + w_0d,
      w_0_error = ksl_sum_error(w_0c, w_0d, w_0), w_0_lo1 = w_0_error + w_0c_lo,
      w_0_lo = w_0_lo1 + w_0d_lo;
  const double w_1a = D->m10 * si->m0, w_1a_lo = ksl_product_error(D->m10, si->m0, w_1a),
      w_1b = D->m11 * si->m1, w_1b_lo = ksl_product_error(D->m11, si->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * si->m2,
      w_1d_lo = ksl_product_error(D->m12, si->m2, w_1d), w_1 = w_1c + w_1d,
      w_1_error = ksl_sum_error(w_1c, w_1d, w_1), w_1_lo1 = w_1_error + w_1c_lo,
      w_1_lo = w_1_lo1 + w_1d_lo;
  const double w_2a = D->m20 * si->m0, w_2a_lo = ksl_product_error(D->m20, si->m0, w_2a),
      w_2b = D->m21 * si->m1, w_2b_lo = ksl_product_error(D->m21, si->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * si->m2,
      w_2d_lo = ksl_product_error(D->m22, si->m2, w_2d), w_2 = w_2c + w_2d,
      w_2_error = ksl_sum_error(w_2c, w_2d, w_2), w_2_lo1 = w_2_error + w_2c_lo,
      w_2_lo = w_2_lo1 + w_2d_lo;
  const double w_3a = D->m00 * si->m3, w_3a_lo = ksl_product_error(D->m00, si->m3, w_3a),
      w_3b = D->m01 * si->m4, w_3b_lo = ksl_product_error(D->m01, si->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * si->m5,
      w_3d_lo = ksl_product_error(D->m02, si->m5, w_3d), w_3 = w_3c + w_3d,
      w_3_error = ksl_sum_error(w_3c, w_3d, w_3), w_3_lo1 = w_3_error + w_3c_lo,
      w_3_lo = w_3_lo1 + w_3d_lo;
  const double w_4a = D->m10 * si->m3, w_4a_lo = ksl_product_error(D->m10, si->m3, w_4a),
      w_4b = D->m11 * si->m4, w_4b_lo = ksl_product_error(D->m11, si->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * si->m5,
      w_4d_lo = ksl_product_error(D->m12, si->m5, w_4d), w_4 = w_4c + w_4d,
      w_4_error = ksl_sum_error(w_4c, w_4d, w_4), w_4_lo1 = w_4_error + w_4c_lo,
      w_4_lo = w_4_lo1 + w_4d_lo;
  const double w_5a = D->m20 * si->m3, w_5a_lo = ksl_product_error(D->m20, si->m3, w_5a),
      w_5b = D->m21 * si->m4, w_5b_lo = ksl_product_error(D->m21, si->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * si->m5,
      w_5d_lo = ksl_product_error(D->m22, si->m5, w_5d), w_5 = w_5c + w_5d,
      w_5_error = ksl_sum_error(w_5c, w_5d, w_5), w_5_lo1 = w_5_error + w_5c_lo,
      w_5_lo = w_5_lo1 + w_5d_lo;
  const double so_0a = D->m13 * w_5, so_0a_cross1 = D->m13 * w_5_lo,
      so_0a_error = ksl_product_error(D->m13, w_5, so_0a), so_0a_lo = so_0a_error + so_0a_cross1,
      so_0b = D->m23 * w_4, so_0b_cross1 = D->m23 * w_4_lo,
      so_0b_error = ksl_product_error(D->m23, w_4, so_0b), so_0b_lo = so_0b_error + so_0b_cross1,
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0 = so_0c + w_0,
      so_0_error = ksl_sum_error(so_0c, w_0, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + w_0_lo;
  const double so_1a = D->m23 * w_3, so_1a_cross1 = D->m23 * w_3_lo,
      so_1a_error = ksl_product_error(D->m23, w_3, so_1a), so_1a_lo = so_1a_error + so_1a_cross1,
      so_1b = D->m03 * w_5, so_1b_cross1 = D->m03 * w_5_lo,
      so_1b_error = ksl_product_error(D->m03, w_5, so_1b), so_1b_lo = so_1b_error + so_1b_cross1,
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1 = so_1c + w_1,
      so_1_error = ksl_sum_error(so_1c, w_1, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + w_1_lo;
  const double so_2a = D->m03 * w_4, so_2a_cross1 = D->m03 * w_4_lo,
      so_2a_error = ksl_product_error(D->m03, w_4, so_2a), so_2a_lo = so_2a_error + so_2a_cross1,
      so_2b = D->m13 * w_3, so_2b_cross1 = D->m13 * w_3_lo,
      so_2b_error = ksl_product_error(D->m13, w_3, so_2b), so_2b_lo = so_2b_error + so_2b_cross1,
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2 = so_2c + w_2,
      so_2_error = ksl_sum_error(so_2c, w_2, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + w_2_lo;
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
   33 mul, 66 add, 24 product error, 18 sum error.
   Error <= u |result| + (lin: 36, ang: 10) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adinvs_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m23 * si->m4, w_0a_lo = ksl_product_error(D->m23, si->m4, w_0a),
      w_0b = D->m13 * si->m5, w_0b_lo = ksl_product_error(D->m13, si->m5, w_0b), w_0c = w_0a - w_0b,
      w_0c_error = ksl_difference_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 - w_0b_lo, w_0 = w_0c + si->m0,
      w_0_error = ksl_sum_error(w_0c, si->m0, w_0), w_0_lo = w_0_error + w_0c_lo;
  const double w_1a = D->m03 * si->m5, w_1a_lo = ksl_product_error(D->m03, si->m5, w_1a),
      w_1b = D->m23 * si->m3, w_1b_lo = ksl_product_error(D->m23, si->m3, w_1b), w_1c = w_1a - w_1b,
      w_1c_error = ksl_difference_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 - w_1b_lo, w_1 = w_1c + si->m1,
      w_1_error = ksl_sum_error(w_1c, si->m1, w_1), w_1_lo = w_1_error + w_1c_lo;
  const double w_2a = D->m13 * si->m3, w_2a_lo = ksl_product_error(D->m13, si->m3, w_2a),
      w_2b = D->m03 * si->m4, w_2b_lo = ksl_product_error(D->m03, si->m4, w_2b), w_2c = w_2a - w_2b,
      w_2c_error = ksl_difference_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 - w_2b_lo, w_2 = w_2c + si->m2,
      w_2_error = ksl_sum_error(w_2c, si->m2, w_2), w_2_lo = w_2_error + w_2c_lo;
  const double so_0a = D->m00 * w_0, so_0a_cross1 = D->m00 * w_0_lo,
      so_0a_error = ksl_product_error(D->m00, w_0, so_0a), so_0a_lo = so_0a_error + so_0a_cross1,
      so_0b = D->m10 * w_1, so_0b_cross1 = D->m10 * w_1_lo,
      so_0b_error = ksl_product_error(D->m10, w_1, so_0b), so_0b_lo = so_0b_error + so_0b_cross1,
      so_0c = so_0a + so_0b, so_0c_error = ksl_sum_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 + so_0b_lo, so_0d = D->m20 * w_2,
      so_0d_cross1 = D->m20 * w_2_lo, so_0d_error = ksl_product_error(D->m20, w_2, so_0d),
      so_0d_lo = so_0d_error + so_0d_cross1, so_0 = so_0c + so_0d,
      so_0_error = ksl_sum_error(so_0c, so_0d, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + so_0d_lo;
  const double so_1a = D->m01 * w_0, so_1a_cross1 = D->m01 * w_0_lo,
      so_1a_error = ksl_product_error(D->m01, w_0, so_1a), so_1a_lo = so_1a_error + so_1a_cross1,
      so_1b = D->m11 * w_1, so_1b_cross1 = D->m11 * w_1_lo,
      so_1b_error = ksl_product_error(D->m11, w_1, so_1b), so_1b_lo = so_1b_error + so_1b_cross1,
      so_1c = so_1a + so_1b, so_1c_error = ksl_sum_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 + so_1b_lo, so_1d = D->m21 * w_2,
      so_1d_cross1 = D->m21 * w_2_lo, so_1d_error = ksl_product_error(D->m21, w_2, so_1d),
      so_1d_lo = so_1d_error + so_1d_cross1, so_1 = so_1c + so_1d,
      so_1_error = ksl_sum_error(so_1c, so_1d, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + so_1d_lo;
  const double so_2a = D->m02 * w_0, so_2a_cross1 = D->m02 * w_0_lo,
      so_2a_error = ksl_product_error(D->m02, w_0, so_2a), so_2a_lo = so_2a_error + so_2a_cross1,
      so_2b = D->m12 * w_1, so_2b_cross1 = D->m12 * w_1_lo,
      so_2b_error = ksl_product_error(D->m12, w_1, so_2b), so_2b_lo = so_2b_error + so_2b_cross1,
      so_2c = so_2a + so_2b, so_2c_error = ksl_sum_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 + so_2b_lo, so_2d = D->m22 * w_2,
      so_2d_cross1 = D->m22 * w_2_lo, so_2d_error = ksl_product_error(D->m22, w_2, so_2d),
      so_2d_lo = so_2d_error + so_2d_cross1, so_2 = so_2c + so_2d,
      so_2_error = ksl_sum_error(so_2c, so_2d, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + so_2d_lo;
  const double so_3a = D->m00 * si->m3, so_3a_lo = ksl_product_error(D->m00, si->m3, so_3a),
      so_3b = D->m10 * si->m4, so_3b_lo = ksl_product_error(D->m10, si->m4, so_3b),
      so_3c = so_3a + so_3b, so_3c_error = ksl_sum_error(so_3a, so_3b, so_3c),
      so_3c_lo1 = so_3c_error + so_3a_lo, so_3c_lo = so_3c_lo1 + so_3b_lo, so_3d = D->m20 * si->m5,
      so_3d_lo = ksl_product_error(D->m20, si->m5, so_3d), so_3 = so_3c + so_3d,
      so_3_error = ksl_sum_error(so_3c, so_3d, so_3), so_3_lo1 = so_3_error + so_3c_lo,
      so_3_lo = so_3_lo1 + so_3d_lo;
  const double so_4a = D->m01 * si->m3, so_4a_lo = ksl_product_error(D->m01, si->m3, so_4a),
      so_4b = D->m11 * si->m4, so_4b_lo = ksl_product_error(D->m11, si->m4, so_4b),
      so_4c = so_4a + so_4b, so_4c_error = ksl_sum_error(so_4a, so_4b, so_4c),
      so_4c_lo1 = so_4c_error + so_4a_lo, so_4c_lo = so_4c_lo1 + so_4b_lo, so_4d = D->m21 * si->m5,
      so_4d_lo = ksl_product_error(D->m21, si->m5, so_4d), so_4 = so_4c + so_4d,
      so_4_error = ksl_sum_error(so_4c, so_4d, so_4), so_4_lo1 = so_4_error + so_4c_lo,
      so_4_lo = so_4_lo1 + so_4d_lo;
  const double so_5a = D->m02 * si->m3, so_5a_lo = ksl_product_error(D->m02, si->m3, so_5a),
      so_5b = D->m12 * si->m4, so_5b_lo = ksl_product_error(D->m12, si->m4, so_5b),
      so_5c = so_5a + so_5b, so_5c_error = ksl_sum_error(so_5a, so_5b, so_5c),
      so_5c_lo1 = so_5c_error + so_5a_lo, so_5c_lo = so_5c_lo1 + so_5b_lo, so_5d = D->m22 * si->m5,
      so_5d_lo = ksl_product_error(D->m22, si->m5, so_5d), so_5 = so_5c + so_5d,
      so_5_error = ksl_sum_error(so_5c, so_5d, so_5), so_5_lo1 = so_5_error + so_5c_lo,
      so_5_lo = so_5_lo1 + so_5d_lo;
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
   30 mul, 66 add, 24 product error, 18 sum error, 12 neg.
   Error <= u |result| + (lin: 39, ang: 10) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsinv_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0a_lo = ksl_product_error(D->m00, si->m0, w_0a),
      w_0b = D->m01 * si->m1, w_0b_lo = ksl_product_error(D->m01, si->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * si->m2,
      w_0d_lo = ksl_product_error(D->m02, si->m2, w_0d), w_0e = w_0c + w_0d,
      w_0e_error = ksl_sum_error(w_0c, w_0d, w_0e), w_0e_lo1 = w_0e_error + w_0c_lo,
      w_0e_lo = w_0e_lo1 + w_0d_lo, w_0 = -w_0e, w_0_lo = -w_0e_lo;
  const double w_1a = D->m10 * si->m0, w_1a_lo = ksl_product_error(D->m10, si->m0, w_1a),
      w_1b = D->m11 * si->m1, w_1b_lo = ksl_product_error(D->m11, si->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * si->m2,
      w_1d_lo = ksl_product_error(D->m12, si->m2, w_1d), w_1e = w_1c + w_1d,
      w_1e_error = ksl_sum_error(w_1c, w_1d, w_1e), w_1e_lo1 = w_1e_error + w_1c_lo,
      w_1e_lo = w_1e_lo1 + w_1d_lo, w_1 = -w_1e, w_1_lo = -w_1e_lo;
  const double w_2a = D->m20 * si->m0, w_2a_lo = ksl_product_error(D->m20, si->m0, w_2a),
      w_2b = D->m21 * si->m1, w_2b_lo = ksl_product_error(D->m21, si->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * si->m2,
      w_2d_lo = ksl_product_error(D->m22, si->m2, w_2d), w_2e = w_2c + w_2d,
      w_2e_error = ksl_sum_error(w_2c, w_2d, w_2e), w_2e_lo1 = w_2e_error + w_2c_lo,
      w_2e_lo = w_2e_lo1 + w_2d_lo, w_2 = -w_2e, w_2_lo = -w_2e_lo;
  const double w_3a = D->m00 * si->m3, w_3a_lo = ksl_product_error(D->m00, si->m3, w_3a),
      w_3b = D->m01 * si->m4, w_3b_lo = ksl_product_error(D->m01, si->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * si->m5,
      w_3d_lo = ksl_product_error(D->m02, si->m5, w_3d), w_3e = w_3c + w_3d,
      w_3e_error = ksl_sum_error(w_3c, w_3d, w_3e), w_3e_lo1 = w_3e_error + w_3c_lo,
      w_3e_lo = w_3e_lo1 + w_3d_lo, w_3 = -w_3e, w_3_lo = -w_3e_lo;
  const double w_4a = D->m10 * si->m3, w_4a_lo = ksl_product_error(D->m10, si->m3, w_4a),
      w_4b = D->m11 * si->m4, w_4b_lo = ksl_product_error(D->m11, si->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * si->m5,
      w_4d_lo = ksl_product_error(D->m12, si->m5, w_4d), w_4e = w_4c + w_4d,
      w_4e_error = ksl_sum_error(w_4c, w_4d, w_4e), w_4e_lo1 = w_4e_error + w_4c_lo,
      w_4e_lo = w_4e_lo1 + w_4d_lo, w_4 = -w_4e, w_4_lo = -w_4e_lo;
  const double w_5a = D->m20 * si->m3, w_5a_lo = ksl_product_error(D->m20, si->m3, w_5a),
      w_5b = D->m21 * si->m4, w_5b_lo = ksl_product_error(D->m21, si->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * si->m5,
      w_5d_lo = ksl_product_error(D->m22, si->m5, w_5d), w_5e = w_5c + w_5d,
      w_5e_error = ksl_sum_error(w_5c, w_5d, w_5e), w_5e_lo1 = w_5e_error + w_5c_lo,
      w_5e_lo = w_5e_lo1 + w_5d_lo, w_5 = -w_5e, w_5_lo = -w_5e_lo;
  const double so_0a = D->m13 * w_5, so_0a_cross1 = D->m13 * w_5_lo,
      so_0a_error = ksl_product_error(D->m13, w_5, so_0a), so_0a_lo = so_0a_error + so_0a_cross1,
      so_0b = D->m23 * w_4, so_0b_cross1 = D->m23 * w_4_lo,
      so_0b_error = ksl_product_error(D->m23, w_4, so_0b), so_0b_lo = so_0b_error + so_0b_cross1,
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0 = so_0c + w_0,
      so_0_error = ksl_sum_error(so_0c, w_0, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + w_0_lo;
  const double so_1a = D->m23 * w_3, so_1a_cross1 = D->m23 * w_3_lo,
      so_1a_error = ksl_product_error(D->m23, w_3, so_1a), so_1a_lo = so_1a_error + so_1a_cross1,
      so_1b = D->m03 * w_5, so_1b_cross1 = D->m03 * w_5_lo,
      so_1b_error = ksl_product_error(D->m03, w_5, so_1b), so_1b_lo = so_1b_error + so_1b_cross1,
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1 = so_1c + w_1,
      so_1_error = ksl_sum_error(so_1c, w_1, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + w_1_lo;
  const double so_2a = D->m03 * w_4, so_2a_cross1 = D->m03 * w_4_lo,
      so_2a_error = ksl_product_error(D->m03, w_4, so_2a), so_2a_lo = so_2a_error + so_2a_cross1,
      so_2b = D->m13 * w_3, so_2b_cross1 = D->m13 * w_3_lo,
      so_2b_error = ksl_product_error(D->m13, w_3, so_2b), so_2b_lo = so_2b_error + so_2b_cross1,
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2 = so_2c + w_2,
      so_2_error = ksl_sum_error(so_2c, w_2, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + w_2_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrx_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m20 * D->m13, so_0a_lo = ksl_product_error(D->m20, D->m13, so_0a),
      so_0b = D->m10 * D->m23, so_0b_lo = ksl_product_error(D->m10, D->m23, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m00 * D->m23, so_1a_lo = ksl_product_error(D->m00, D->m23, so_1a),
      so_1b = D->m20 * D->m03, so_1b_lo = ksl_product_error(D->m20, D->m03, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m10 * D->m03, so_2a_lo = ksl_product_error(D->m10, D->m03, so_2a),
      so_2b = D->m00 * D->m13, so_2b_lo = ksl_product_error(D->m00, D->m13, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsry_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m21 * D->m13, so_0a_lo = ksl_product_error(D->m21, D->m13, so_0a),
      so_0b = D->m11 * D->m23, so_0b_lo = ksl_product_error(D->m11, D->m23, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m01 * D->m23, so_1a_lo = ksl_product_error(D->m01, D->m23, so_1a),
      so_1b = D->m21 * D->m03, so_1b_lo = ksl_product_error(D->m21, D->m03, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m11 * D->m03, so_2a_lo = ksl_product_error(D->m11, D->m03, so_2a),
      so_2b = D->m01 * D->m13, so_2b_lo = ksl_product_error(D->m01, D->m13, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrz_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m22 * D->m13, so_0a_lo = ksl_product_error(D->m22, D->m13, so_0a),
      so_0b = D->m12 * D->m23, so_0b_lo = ksl_product_error(D->m12, D->m23, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m02 * D->m23, so_1a_lo = ksl_product_error(D->m02, D->m23, so_1a),
      so_1b = D->m22 * D->m03, so_1b_lo = ksl_product_error(D->m22, D->m03, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m12 * D->m03, so_2a_lo = ksl_product_error(D->m12, D->m03, so_2a),
      so_2b = D->m02 * D->m13, so_2b_lo = ksl_product_error(D->m02, D->m13, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m10 * D->m23, so_0a_lo = ksl_product_error(D->m10, D->m23, so_0a),
      so_0b = D->m20 * D->m13, so_0b_lo = ksl_product_error(D->m20, D->m13, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m20 * D->m03, so_1a_lo = ksl_product_error(D->m20, D->m03, so_1a),
      so_1b = D->m00 * D->m23, so_1b_lo = ksl_product_error(D->m00, D->m23, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m00 * D->m13, so_2a_lo = ksl_product_error(D->m00, D->m13, so_2a),
      so_2b = D->m10 * D->m03, so_2b_lo = ksl_product_error(D->m10, D->m03, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m11 * D->m23, so_0a_lo = ksl_product_error(D->m11, D->m23, so_0a),
      so_0b = D->m21 * D->m13, so_0b_lo = ksl_product_error(D->m21, D->m13, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m21 * D->m03, so_1a_lo = ksl_product_error(D->m21, D->m03, so_1a),
      so_1b = D->m01 * D->m23, so_1b_lo = ksl_product_error(D->m01, D->m23, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m01 * D->m13, so_2a_lo = ksl_product_error(D->m01, D->m13, so_2a),
      so_2b = D->m11 * D->m03, so_2b_lo = ksl_product_error(D->m11, D->m03, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m12 * D->m23, so_0a_lo = ksl_product_error(D->m12, D->m23, so_0a),
      so_0b = D->m22 * D->m13, so_0b_lo = ksl_product_error(D->m22, D->m13, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m22 * D->m03, so_1a_lo = ksl_product_error(D->m22, D->m03, so_1a),
      so_1b = D->m02 * D->m23, so_1b_lo = ksl_product_error(D->m02, D->m23, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m02 * D->m13, so_2a_lo = ksl_product_error(D->m02, D->m13, so_2a),
      so_2b = D->m12 * D->m03, so_2b_lo = ksl_product_error(D->m12, D->m03, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   18 mul, 36 add, 18 product error, 9 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = D->m20 * D->m13, M_03a_lo = ksl_product_error(D->m20, D->m13, M_03a),
      M_03b = D->m10 * D->m23, M_03b_lo = ksl_product_error(D->m10, D->m23, M_03b),
      M_03 = M_03a - M_03b, M_03_error = ksl_difference_error(M_03a, M_03b, M_03),
      M_03_lo1 = M_03_error + M_03a_lo, M_03_lo = M_03_lo1 - M_03b_lo;
  const double M_04a = D->m21 * D->m13, M_04a_lo = ksl_product_error(D->m21, D->m13, M_04a),
      M_04b = D->m11 * D->m23, M_04b_lo = ksl_product_error(D->m11, D->m23, M_04b),
      M_04 = M_04a - M_04b, M_04_error = ksl_difference_error(M_04a, M_04b, M_04),
      M_04_lo1 = M_04_error + M_04a_lo, M_04_lo = M_04_lo1 - M_04b_lo;
  const double M_05a = D->m22 * D->m13, M_05a_lo = ksl_product_error(D->m22, D->m13, M_05a),
      M_05b = D->m12 * D->m23, M_05b_lo = ksl_product_error(D->m12, D->m23, M_05b),
      M_05 = M_05a - M_05b, M_05_error = ksl_difference_error(M_05a, M_05b, M_05),
      M_05_lo1 = M_05_error + M_05a_lo, M_05_lo = M_05_lo1 - M_05b_lo;
  const double M_13a = D->m00 * D->m23, M_13a_lo = ksl_product_error(D->m00, D->m23, M_13a),
      M_13b = D->m20 * D->m03, M_13b_lo = ksl_product_error(D->m20, D->m03, M_13b),
      M_13 = M_13a - M_13b, M_13_error = ksl_difference_error(M_13a, M_13b, M_13),
      M_13_lo1 = M_13_error + M_13a_lo, M_13_lo = M_13_lo1 - M_13b_lo;
  const double M_14a = D->m01 * D->m23, M_14a_lo = ksl_product_error(D->m01, D->m23, M_14a),
      M_14b = D->m21 * D->m03, M_14b_lo = ksl_product_error(D->m21, D->m03, M_14b),
      M_14 = M_14a - M_14b, M_14_error = ksl_difference_error(M_14a, M_14b, M_14),
      M_14_lo1 = M_14_error + M_14a_lo, M_14_lo = M_14_lo1 - M_14b_lo;
  const double M_15a = D->m02 * D->m23, M_15a_lo = ksl_product_error(D->m02, D->m23, M_15a),
      M_15b = D->m22 * D->m03, M_15b_lo = ksl_product_error(D->m22, D->m03, M_15b),
      M_15 = M_15a - M_15b, M_15_error = ksl_difference_error(M_15a, M_15b, M_15),
      M_15_lo1 = M_15_error + M_15a_lo, M_15_lo = M_15_lo1 - M_15b_lo;
  const double M_23a = D->m10 * D->m03, M_23a_lo = ksl_product_error(D->m10, D->m03, M_23a),
      M_23b = D->m00 * D->m13, M_23b_lo = ksl_product_error(D->m00, D->m13, M_23b),
      M_23 = M_23a - M_23b, M_23_error = ksl_difference_error(M_23a, M_23b, M_23),
      M_23_lo1 = M_23_error + M_23a_lo, M_23_lo = M_23_lo1 - M_23b_lo;
  const double M_24a = D->m11 * D->m03, M_24a_lo = ksl_product_error(D->m11, D->m03, M_24a),
      M_24b = D->m01 * D->m13, M_24b_lo = ksl_product_error(D->m01, D->m13, M_24b),
      M_24 = M_24a - M_24b, M_24_error = ksl_difference_error(M_24a, M_24b, M_24),
      M_24_lo1 = M_24_error + M_24a_lo, M_24_lo = M_24_lo1 - M_24b_lo;
  const double M_25a = D->m12 * D->m03, M_25a_lo = ksl_product_error(D->m12, D->m03, M_25a),
      M_25b = D->m02 * D->m13, M_25b_lo = ksl_product_error(D->m02, D->m13, M_25b),
      M_25 = M_25a - M_25b, M_25_error = ksl_difference_error(M_25a, M_25b, M_25),
      M_25_lo1 = M_25_error + M_25a_lo, M_25_lo = M_25_lo1 - M_25b_lo;
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
   6 mul, 16 add, 6 product error, 5 sum error.
   Error <= u |result| + 18 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_cs_accurate(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = c->m0 * s->m0, power_a_lo = ksl_product_error(c->m0, s->m0, power_a),
      power_b = c->m1 * s->m1, power_b_lo = ksl_product_error(c->m1, s->m1, power_b),
      power_c = power_a + power_b, power_c_error = ksl_sum_error(power_a, power_b, power_c),
      power_c_lo1 = power_c_error + power_a_lo, power_c_lo = power_c_lo1 + power_b_lo,
      power_d = c->m2 * s->m2, power_d_lo = ksl_product_error(c->m2, s->m2, power_d),
      power_e = power_c + power_d, power_e_error = ksl_sum_error(power_c, power_d, power_e),
      power_e_lo1 = power_e_error + power_c_lo, power_e_lo = power_e_lo1 + power_d_lo,
      power_f = c->m3 * s->m3, power_f_lo = ksl_product_error(c->m3, s->m3, power_f),
      power_g = c->m4 * s->m4, power_g_lo = ksl_product_error(c->m4, s->m4, power_g),
      power_h = power_f + power_g, power_h_error = ksl_sum_error(power_f, power_g, power_h),
      power_h_lo1 = power_h_error + power_f_lo, power_h_lo = power_h_lo1 + power_g_lo,
      power_i = c->m5 * s->m5, power_i_lo = ksl_product_error(c->m5, s->m5, power_i),
      power_j = power_h + power_i, power_j_error = ksl_sum_error(power_h, power_i, power_j),
      power_j_lo1 = power_j_error + power_h_lo, power_j_lo = power_j_lo1 + power_i_lo,
      power = power_e + power_j, power_error = ksl_sum_error(power_e, power_j, power),
      power_lo1 = power_error + power_e_lo, power_lo = power_lo1 + power_j_lo;
  const double power_rounded = power + power_lo;
  return power_rounded;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + (lin: 10, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = s1->m1 * s2->m5, so_0a_lo = ksl_product_error(s1->m1, s2->m5, so_0a),
      so_0b = s1->m5 * s2->m1, so_0b_lo = ksl_product_error(s1->m5, s2->m1, so_0b),
      so_0c = so_0a - so_0b, so_0c_error = ksl_difference_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 - so_0b_lo, so_0d = s1->m4 * s2->m2,
      so_0d_lo = ksl_product_error(s1->m4, s2->m2, so_0d), so_0e = s1->m2 * s2->m4,
      so_0e_lo = ksl_product_error(s1->m2, s2->m4, so_0e), so_0f = so_0d - so_0e,
      so_0f_error = ksl_difference_error(so_0d, so_0e, so_0f), so_0f_lo1 = so_0f_error + so_0d_lo,
      so_0f_lo = so_0f_lo1 - so_0e_lo, so_0 = so_0c + so_0f,
      so_0_error = ksl_sum_error(so_0c, so_0f, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + so_0f_lo;
  const double so_1a = s1->m5 * s2->m0, so_1a_lo = ksl_product_error(s1->m5, s2->m0, so_1a),
      so_1b = s1->m0 * s2->m5, so_1b_lo = ksl_product_error(s1->m0, s2->m5, so_1b),
      so_1c = so_1a - so_1b, so_1c_error = ksl_difference_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 - so_1b_lo, so_1d = s1->m2 * s2->m3,
      so_1d_lo = ksl_product_error(s1->m2, s2->m3, so_1d), so_1e = s1->m3 * s2->m2,
      so_1e_lo = ksl_product_error(s1->m3, s2->m2, so_1e), so_1f = so_1d - so_1e,
      so_1f_error = ksl_difference_error(so_1d, so_1e, so_1f), so_1f_lo1 = so_1f_error + so_1d_lo,
      so_1f_lo = so_1f_lo1 - so_1e_lo, so_1 = so_1c + so_1f,
      so_1_error = ksl_sum_error(so_1c, so_1f, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + so_1f_lo;
  const double so_2a = s1->m0 * s2->m4, so_2a_lo = ksl_product_error(s1->m0, s2->m4, so_2a),
      so_2b = s1->m4 * s2->m0, so_2b_lo = ksl_product_error(s1->m4, s2->m0, so_2b),
      so_2c = so_2a - so_2b, so_2c_error = ksl_difference_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 - so_2b_lo, so_2d = s1->m3 * s2->m1,
      so_2d_lo = ksl_product_error(s1->m3, s2->m1, so_2d), so_2e = s1->m1 * s2->m3,
      so_2e_lo = ksl_product_error(s1->m1, s2->m3, so_2e), so_2f = so_2d - so_2e,
      so_2f_error = ksl_difference_error(so_2d, so_2e, so_2f), so_2f_lo1 = so_2f_error + so_2d_lo,
      so_2f_lo = so_2f_lo1 - so_2e_lo, so_2 = so_2c + so_2f,
      so_2_error = ksl_sum_error(so_2c, so_2f, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + so_2f_lo;
  const double so_3a = s1->m4 * s2->m5, so_3a_lo = ksl_product_error(s1->m4, s2->m5, so_3a),
      so_3b = s1->m5 * s2->m4, so_3b_lo = ksl_product_error(s1->m5, s2->m4, so_3b),
      so_3 = so_3a - so_3b, so_3_error = ksl_difference_error(so_3a, so_3b, so_3),
      so_3_lo1 = so_3_error + so_3a_lo, so_3_lo = so_3_lo1 - so_3b_lo;
  const double so_4a = s1->m5 * s2->m3, so_4a_lo = ksl_product_error(s1->m5, s2->m3, so_4a),
      so_4b = s1->m3 * s2->m5, so_4b_lo = ksl_product_error(s1->m3, s2->m5, so_4b),
      so_4 = so_4a - so_4b, so_4_error = ksl_difference_error(so_4a, so_4b, so_4),
      so_4_lo1 = so_4_error + so_4a_lo, so_4_lo = so_4_lo1 - so_4b_lo;
  const double so_5a = s1->m3 * s2->m4, so_5a_lo = ksl_product_error(s1->m3, s2->m4, so_5a),
      so_5b = s1->m4 * s2->m3, so_5b_lo = ksl_product_error(s1->m4, s2->m3, so_5b),
      so_5 = so_5a - so_5b, so_5_error = ksl_difference_error(so_5a, so_5b, so_5),
      so_5_lo1 = so_5_error + so_5a_lo, so_5_lo = so_5_lo1 - so_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 4, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = s1->m4 * s2->m2, so_0a_lo = ksl_product_error(s1->m4, s2->m2, so_0a),
      so_0b = s1->m5 * s2->m1, so_0b_lo = ksl_product_error(s1->m5, s2->m1, so_0b),
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = s1->m5 * s2->m0, so_1a_lo = ksl_product_error(s1->m5, s2->m0, so_1a),
      so_1b = s1->m3 * s2->m2, so_1b_lo = ksl_product_error(s1->m3, s2->m2, so_1b),
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = s1->m3 * s2->m1, so_2a_lo = ksl_product_error(s1->m3, s2->m1, so_2a),
      so_2b = s1->m4 * s2->m0, so_2b_lo = ksl_product_error(s1->m4, s2->m0, so_2b),
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   21 mul, 39 add, 15 product error, 9 sum error.
   Error <= u |result| + (lin: 27, ang: 10) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsra_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = D->m00 * axis->x, a_0a_lo = ksl_product_error(D->m00, axis->x, a_0a),
      a_0b = D->m01 * axis->y, a_0b_lo = ksl_product_error(D->m01, axis->y, a_0b),
      a_0c = a_0a + a_0b, a_0c_error = ksl_sum_error(a_0a, a_0b, a_0c),
      a_0c_lo1 = a_0c_error + a_0a_lo, a_0c_lo = a_0c_lo1 + a_0b_lo, a_0d = D->m02 * axis->z,
      a_0d_lo = ksl_product_error(D->m02, axis->z, a_0d), a_0 = a_0c + a_0d,
      a_0_error = ksl_sum_error(a_0c, a_0d, a_0), a_0_lo1 = a_0_error + a_0c_lo,
      a_0_lo = a_0_lo1 + a_0d_lo;
  const double a_1a = D->m10 * axis->x, a_1a_lo = ksl_product_error(D->m10, axis->x, a_1a),
      a_1b = D->m11 * axis->y, a_1b_lo = ksl_product_error(D->m11, axis->y, a_1b),
      a_1c = a_1a + a_1b, a_1c_error = ksl_sum_error(a_1a, a_1b, a_1c),
      a_1c_lo1 = a_1c_error + a_1a_lo, a_1c_lo = a_1c_lo1 + a_1b_lo, a_1d = D->m12 * axis->z,
      a_1d_lo = ksl_product_error(D->m12, axis->z, a_1d), a_1 = a_1c + a_1d,
      a_1_error = ksl_sum_error(a_1c, a_1d, a_1), a_1_lo1 = a_1_error + a_1c_lo,
      a_1_lo = a_1_lo1 + a_1d_lo;
  const double a_2a = D->m20 * axis->x, a_2a_lo = ksl_product_error(D->m20, axis->x, a_2a),
      a_2b = D->m21 * axis->y, a_2b_lo = ksl_product_error(D->m21, axis->y, a_2b),
      a_2c = a_2a + a_2b, a_2c_error = ksl_sum_error(a_2a, a_2b, a_2c),
      a_2c_lo1 = a_2c_error + a_2a_lo, a_2c_lo = a_2c_lo1 + a_2b_lo, a_2d = D->m22 * axis->z,
      a_2d_lo = ksl_product_error(D->m22, axis->z, a_2d), a_2 = a_2c + a_2d,
      a_2_error = ksl_sum_error(a_2c, a_2d, a_2), a_2_lo1 = a_2_error + a_2c_lo,
      a_2_lo = a_2_lo1 + a_2d_lo;
  const double so_0a = D->m13 * a_2, so_0a_cross1 = D->m13 * a_2_lo,
      so_0a_error = ksl_product_error(D->m13, a_2, so_0a), so_0a_lo = so_0a_error + so_0a_cross1,
      so_0b = D->m23 * a_1, so_0b_cross1 = D->m23 * a_1_lo,
      so_0b_error = ksl_product_error(D->m23, a_1, so_0b), so_0b_lo = so_0b_error + so_0b_cross1,
      so_0 = so_0a - so_0b, so_0_error = ksl_difference_error(so_0a, so_0b, so_0),
      so_0_lo1 = so_0_error + so_0a_lo, so_0_lo = so_0_lo1 - so_0b_lo;
  const double so_1a = D->m23 * a_0, so_1a_cross1 = D->m23 * a_0_lo,
      so_1a_error = ksl_product_error(D->m23, a_0, so_1a), so_1a_lo = so_1a_error + so_1a_cross1,
      so_1b = D->m03 * a_2, so_1b_cross1 = D->m03 * a_2_lo,
      so_1b_error = ksl_product_error(D->m03, a_2, so_1b), so_1b_lo = so_1b_error + so_1b_cross1,
      so_1 = so_1a - so_1b, so_1_error = ksl_difference_error(so_1a, so_1b, so_1),
      so_1_lo1 = so_1_error + so_1a_lo, so_1_lo = so_1_lo1 - so_1b_lo;
  const double so_2a = D->m03 * a_1, so_2a_cross1 = D->m03 * a_1_lo,
      so_2a_error = ksl_product_error(D->m03, a_1, so_2a), so_2a_lo = so_2a_error + so_2a_cross1,
      so_2b = D->m13 * a_0, so_2b_cross1 = D->m13 * a_0_lo,
      so_2b_error = ksl_product_error(D->m13, a_0, so_2b), so_2b_lo = so_2b_error + so_2b_cross1,
      so_2 = so_2a - so_2b, so_2_error = ksl_difference_error(so_2a, so_2b, so_2),
      so_2_lo1 = so_2_error + so_2a_lo, so_2_lo = so_2_lo1 - so_2b_lo;
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
   9 mul, 21 add, 9 product error, 6 sum error.
   Error <= u |result| + (lin: 10, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsta_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = D->m00 * axis->x, so_0a_lo = ksl_product_error(D->m00, axis->x, so_0a),
      so_0b = D->m01 * axis->y, so_0b_lo = ksl_product_error(D->m01, axis->y, so_0b),
      so_0c = so_0a + so_0b, so_0c_error = ksl_sum_error(so_0a, so_0b, so_0c),
      so_0c_lo1 = so_0c_error + so_0a_lo, so_0c_lo = so_0c_lo1 + so_0b_lo, so_0d = D->m02 * axis->z,
      so_0d_lo = ksl_product_error(D->m02, axis->z, so_0d), so_0 = so_0c + so_0d,
      so_0_error = ksl_sum_error(so_0c, so_0d, so_0), so_0_lo1 = so_0_error + so_0c_lo,
      so_0_lo = so_0_lo1 + so_0d_lo;
  const double so_1a = D->m10 * axis->x, so_1a_lo = ksl_product_error(D->m10, axis->x, so_1a),
      so_1b = D->m11 * axis->y, so_1b_lo = ksl_product_error(D->m11, axis->y, so_1b),
      so_1c = so_1a + so_1b, so_1c_error = ksl_sum_error(so_1a, so_1b, so_1c),
      so_1c_lo1 = so_1c_error + so_1a_lo, so_1c_lo = so_1c_lo1 + so_1b_lo, so_1d = D->m12 * axis->z,
      so_1d_lo = ksl_product_error(D->m12, axis->z, so_1d), so_1 = so_1c + so_1d,
      so_1_error = ksl_sum_error(so_1c, so_1d, so_1), so_1_lo1 = so_1_error + so_1c_lo,
      so_1_lo = so_1_lo1 + so_1d_lo;
  const double so_2a = D->m20 * axis->x, so_2a_lo = ksl_product_error(D->m20, axis->x, so_2a),
      so_2b = D->m21 * axis->y, so_2b_lo = ksl_product_error(D->m21, axis->y, so_2b),
      so_2c = so_2a + so_2b, so_2c_error = ksl_sum_error(so_2a, so_2b, so_2c),
      so_2c_lo1 = so_2c_error + so_2a_lo, so_2c_lo = so_2c_lo1 + so_2b_lo, so_2d = D->m22 * axis->z,
      so_2d_lo = ksl_product_error(D->m22, axis->z, so_2d), so_2 = so_2c + so_2d,
      so_2_error = ksl_sum_error(so_2c, so_2d, so_2), so_2_lo1 = so_2_error + so_2c_lo,
      so_2_lo = so_2_lo1 + so_2d_lo;
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

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline float ksl_screwf_norm_accurate(const ksl_screwf_t *si) {
  const double small_a = fabs((double)si->m5),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)si->m4),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)si->m3),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)si->m0 : (double)si->m3;
  const double p_1 = small == 1.0 ? (double)si->m1 : (double)si->m4;
  const double p_2 = small == 1.0 ? (double)si->m2 : (double)si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r = 1.0 < s ? 7.888609052210118e-31 : r_b;
  const double norm = n * r;
  return (float)norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screwf_normalize_accurate(ksl_screwf_t *self) {
  const double small_a = fabs((double)self->m5),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)self->m4),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)self->m3),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)self->m0 : (double)self->m3;
  const double p_1 = small == 1.0 ? (double)self->m1 : (double)self->m4;
  const double p_2 = small == 1.0 ? (double)self->m2 : (double)self->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)self->m0 * up;
  const double enlarged_1 = (double)self->m1 * up;
  const double enlarged_2 = (double)self->m2 * up;
  const double enlarged_3 = (double)self->m3 * up;
  const double enlarged_4 = (double)self->m4 * up;
  const double enlarged_5 = (double)self->m5 * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double quotient_4 = enlarged_4 / divisor;
  const double quotient_5 = enlarged_5 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  const double self_3_new = quotient_3 * down;
  const double self_4_new = quotient_4 * down;
  const double self_5_new = quotient_5 * down;
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screwf_normalized_accurate(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const double small_a = fabs((double)si->m5),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)si->m4),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)si->m3),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)si->m0 : (double)si->m3;
  const double p_1 = small == 1.0 ? (double)si->m1 : (double)si->m4;
  const double p_2 = small == 1.0 ? (double)si->m2 : (double)si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)si->m0 * up;
  const double enlarged_1 = (double)si->m1 * up;
  const double enlarged_2 = (double)si->m2 * up;
  const double enlarged_3 = (double)si->m3 * up;
  const double enlarged_4 = (double)si->m4 * up;
  const double enlarged_5 = (double)si->m5 * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double quotient_4 = enlarged_4 / divisor;
  const double quotient_5 = enlarged_5 / divisor;
  const double so_0 = quotient_0 * down;
  const double so_1 = quotient_1 * down;
  const double so_2 = quotient_2 * down;
  const double so_3 = quotient_3 * down;
  const double so_4 = quotient_4 * down;
  const double so_5 = quotient_5 * down;
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
  const double self_0_new = self->m0 * a,
      self_0_new_lo = ksl_product_error(self->m0, a, self_0_new);
  const double self_1_new = self->m1 * a,
      self_1_new_lo = ksl_product_error(self->m1, a, self_1_new);
  const double self_2_new = self->m2 * a,
      self_2_new_lo = ksl_product_error(self->m2, a, self_2_new);
  const double self_3_new = self->m3 * a,
      self_3_new_lo = ksl_product_error(self->m3, a, self_3_new);
  const double self_4_new = self->m4 * a,
      self_4_new_lo = ksl_product_error(self->m4, a, self_4_new);
  const double self_5_new = self->m5 * a,
      self_5_new_lo = ksl_product_error(self->m5, a, self_5_new);
  const double self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_rounded = self_3_new + self_3_new_lo;
  const double self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_rounded = self_5_new + self_5_new_lo;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + 2 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc_accurate(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new_a_lo = ksl_product_error(a, x->m0, y_0_new_a),
      y_0_new = y_0_new_a + y->m0, y_0_new_error = ksl_sum_error(y_0_new_a, y->m0, y_0_new),
      y_0_new_lo = y_0_new_error + y_0_new_a_lo;
  const double y_1_new_a = a * x->m1, y_1_new_a_lo = ksl_product_error(a, x->m1, y_1_new_a),
      y_1_new = y_1_new_a + y->m1, y_1_new_error = ksl_sum_error(y_1_new_a, y->m1, y_1_new),
      y_1_new_lo = y_1_new_error + y_1_new_a_lo;
  const double y_2_new_a = a * x->m2, y_2_new_a_lo = ksl_product_error(a, x->m2, y_2_new_a),
      y_2_new = y_2_new_a + y->m2, y_2_new_error = ksl_sum_error(y_2_new_a, y->m2, y_2_new),
      y_2_new_lo = y_2_new_error + y_2_new_a_lo;
  const double y_3_new_a = a * x->m3, y_3_new_a_lo = ksl_product_error(a, x->m3, y_3_new_a),
      y_3_new = y_3_new_a + y->m3, y_3_new_error = ksl_sum_error(y_3_new_a, y->m3, y_3_new),
      y_3_new_lo = y_3_new_error + y_3_new_a_lo;
  const double y_4_new_a = a * x->m4, y_4_new_a_lo = ksl_product_error(a, x->m4, y_4_new_a),
      y_4_new = y_4_new_a + y->m4, y_4_new_error = ksl_sum_error(y_4_new_a, y->m4, y_4_new),
      y_4_new_lo = y_4_new_error + y_4_new_a_lo;
  const double y_5_new_a = a * x->m5, y_5_new_a_lo = ksl_product_error(a, x->m5, y_5_new_a),
      y_5_new = y_5_new_a + y->m5, y_5_new_error = ksl_sum_error(y_5_new_a, y->m5, y_5_new),
      y_5_new_lo = y_5_new_error + y_5_new_a_lo;
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = x->m0 + y->m0, y_0_new_lo = ksl_sum_error(x->m0, y->m0, y_0_new);
  const double y_1_new = x->m1 + y->m1, y_1_new_lo = ksl_sum_error(x->m1, y->m1, y_1_new);
  const double y_2_new = x->m2 + y->m2, y_2_new_lo = ksl_sum_error(x->m2, y->m2, y_2_new);
  const double y_3_new = x->m3 + y->m3, y_3_new_lo = ksl_sum_error(x->m3, y->m3, y_3_new);
  const double y_4_new = x->m4 + y->m4, y_4_new_lo = ksl_sum_error(x->m4, y->m4, y_4_new);
  const double y_5_new = x->m5 + y->m5, y_5_new_lo = ksl_sum_error(x->m5, y->m5, y_5_new);
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = y->m0 - x->m0, y_0_new_lo = ksl_difference_error(y->m0, x->m0, y_0_new);
  const double y_1_new = y->m1 - x->m1, y_1_new_lo = ksl_difference_error(y->m1, x->m1, y_1_new);
  const double y_2_new = y->m2 - x->m2, y_2_new_lo = ksl_difference_error(y->m2, x->m2, y_2_new);
  const double y_3_new = y->m3 - x->m3, y_3_new_lo = ksl_difference_error(y->m3, x->m3, y_3_new);
  const double y_4_new = y->m4 - x->m4, y_4_new_lo = ksl_difference_error(y->m4, x->m4, y_4_new);
  const double y_5_new = y->m5 - x->m5, y_5_new_lo = ksl_difference_error(y->m5, x->m5, y_5_new);
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
  const double co_0 = a * ci->m0, co_0_lo = ksl_product_error(a, ci->m0, co_0);
  const double co_1 = a * ci->m1, co_1_lo = ksl_product_error(a, ci->m1, co_1);
  const double co_2 = a * ci->m2, co_2_lo = ksl_product_error(a, ci->m2, co_2);
  const double co_3 = a * ci->m3, co_3_lo = ksl_product_error(a, ci->m3, co_3);
  const double co_4 = a * ci->m4, co_4_lo = ksl_product_error(a, ci->m4, co_4);
  const double co_5 = a * ci->m5, co_5_lo = ksl_product_error(a, ci->m5, co_5);
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

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_lo = ksl_sum_error(c1->m0, c2->m0, co_0);
  const double co_1 = c1->m1 + c2->m1, co_1_lo = ksl_sum_error(c1->m1, c2->m1, co_1);
  const double co_2 = c1->m2 + c2->m2, co_2_lo = ksl_sum_error(c1->m2, c2->m2, co_2);
  const double co_3 = c1->m3 + c2->m3, co_3_lo = ksl_sum_error(c1->m3, c2->m3, co_3);
  const double co_4 = c1->m4 + c2->m4, co_4_lo = ksl_sum_error(c1->m4, c2->m4, co_4);
  const double co_5 = c1->m5 + c2->m5, co_5_lo = ksl_sum_error(c1->m5, c2->m5, co_5);
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
   12 add, 6 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0, co_0_lo = ksl_difference_error(c1->m0, c2->m0, co_0);
  const double co_1 = c1->m1 - c2->m1, co_1_lo = ksl_difference_error(c1->m1, c2->m1, co_1);
  const double co_2 = c1->m2 - c2->m2, co_2_lo = ksl_difference_error(c1->m2, c2->m2, co_2);
  const double co_3 = c1->m3 - c2->m3, co_3_lo = ksl_difference_error(c1->m3, c2->m3, co_3);
  const double co_4 = c1->m4 - c2->m4, co_4_lo = ksl_difference_error(c1->m4, c2->m4, co_4);
  const double co_5 = c1->m5 - c2->m5, co_5_lo = ksl_difference_error(c1->m5, c2->m5, co_5);
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

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   10 mul, 16 add, 4 product error, 2 sum error, 2 div, 1 sqrt, 6 abs, 9 less, 4 equal, 15
     select. */
static inline double ksl_coscrew_norm_accurate(const ksl_coscrew_t *ci) {
  const double small_a = fabs(ci->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(ci->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(ci->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0;
  const double p_1 = small == 1.0 ? ci->m4 : ci->m1;
  const double p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm_total = n + n_lo, norm_added = norm_total - n,
      norm_remaining = n_lo - norm_added, norm = norm_total * r, norm_inverse = 1.0 / r,
      norm_back = norm * norm_inverse, norm_lost = norm_total - norm_back,
      norm_rest = norm_lost + norm_remaining, norm_small = norm_rest * r,
      norm_lo = norm_lost == 0.0 ? 0.0 : norm_small;
  const double norm_total = norm + norm_lo,
      norm_rounded = norm_total == norm_total ? norm_total : norm;
  return norm_rounded;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   43 mul, 64 add, 10 product error, 2 sum error, 14 div, 1 sqrt, 6 abs, 9 less, 15 equal, 27
     select. */
static inline void ksl_coscrew_normalize_accurate(ksl_coscrew_t *self) {
  const double small_a = fabs(self->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m3 : self->m0;
  const double p_1 = small == 1.0 ? self->m4 : self->m1;
  const double p_2 = small == 1.0 ? self->m5 : self->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = self->m0 * up;
  const double enlarged_1 = self->m1 * up;
  const double enlarged_2 = self->m2 * up;
  const double enlarged_3 = self->m3 * up;
  const double enlarged_4 = self->m4 * up;
  const double enlarged_5 = self->m5 * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double quotient_4 = enlarged_4 / divisor, quotient_4_cross = quotient_4 * divisor_lo,
      quotient_4_product = quotient_4 * divisor,
      quotient_4_product_error = ksl_product_error(quotient_4, divisor, quotient_4_product),
      quotient_4_rest = enlarged_4 - quotient_4_product,
      quotient_4_exact = quotient_4_rest - quotient_4_product_error,
      quotient_4_residual = quotient_4_exact - quotient_4_cross,
      quotient_4_lo = quotient_4_residual / divisor;
  const double quotient_5 = enlarged_5 / divisor, quotient_5_cross = quotient_5 * divisor_lo,
      quotient_5_product = quotient_5 * divisor,
      quotient_5_product_error = ksl_product_error(quotient_5, divisor, quotient_5_product),
      quotient_5_rest = enlarged_5 - quotient_5_product,
      quotient_5_exact = quotient_5_rest - quotient_5_product_error,
      quotient_5_residual = quotient_5_exact - quotient_5_cross,
      quotient_5_lo = quotient_5_residual / divisor;
  const double self_0_new_total = quotient_0 + quotient_0_lo,
      self_0_new_added = self_0_new_total - quotient_0,
      self_0_new_remaining = quotient_0_lo - self_0_new_added, self_0_new = self_0_new_total * down,
      self_0_new_inverse = 1.0 / down, self_0_new_back = self_0_new * self_0_new_inverse,
      self_0_new_lost = self_0_new_total - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_remaining,
      self_0_new_small = self_0_new_rest * down,
      self_0_new_lo = self_0_new_lost == 0.0 ? 0.0 : self_0_new_small;
  const double self_1_new_total = quotient_1 + quotient_1_lo,
      self_1_new_added = self_1_new_total - quotient_1,
      self_1_new_remaining = quotient_1_lo - self_1_new_added, self_1_new = self_1_new_total * down,
      self_1_new_back = self_1_new * self_0_new_inverse,
      self_1_new_lost = self_1_new_total - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_remaining,
      self_1_new_small = self_1_new_rest * down,
      self_1_new_lo = self_1_new_lost == 0.0 ? 0.0 : self_1_new_small;
  const double self_2_new_total = quotient_2 + quotient_2_lo,
      self_2_new_added = self_2_new_total - quotient_2,
      self_2_new_remaining = quotient_2_lo - self_2_new_added, self_2_new = self_2_new_total * down,
      self_2_new_back = self_2_new * self_0_new_inverse,
      self_2_new_lost = self_2_new_total - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_remaining,
      self_2_new_small = self_2_new_rest * down,
      self_2_new_lo = self_2_new_lost == 0.0 ? 0.0 : self_2_new_small;
  const double self_3_new_total = quotient_3 + quotient_3_lo,
      self_3_new_added = self_3_new_total - quotient_3,
      self_3_new_remaining = quotient_3_lo - self_3_new_added, self_3_new = self_3_new_total * down,
      self_3_new_back = self_3_new * self_0_new_inverse,
      self_3_new_lost = self_3_new_total - self_3_new_back,
      self_3_new_rest = self_3_new_lost + self_3_new_remaining,
      self_3_new_small = self_3_new_rest * down,
      self_3_new_lo = self_3_new_lost == 0.0 ? 0.0 : self_3_new_small;
  const double self_4_new_total = quotient_4 + quotient_4_lo,
      self_4_new_added = self_4_new_total - quotient_4,
      self_4_new_remaining = quotient_4_lo - self_4_new_added, self_4_new = self_4_new_total * down,
      self_4_new_back = self_4_new * self_0_new_inverse,
      self_4_new_lost = self_4_new_total - self_4_new_back,
      self_4_new_rest = self_4_new_lost + self_4_new_remaining,
      self_4_new_small = self_4_new_rest * down,
      self_4_new_lo = self_4_new_lost == 0.0 ? 0.0 : self_4_new_small;
  const double self_5_new_total = quotient_5 + quotient_5_lo,
      self_5_new_added = self_5_new_total - quotient_5,
      self_5_new_remaining = quotient_5_lo - self_5_new_added, self_5_new = self_5_new_total * down,
      self_5_new_back = self_5_new * self_0_new_inverse,
      self_5_new_lost = self_5_new_total - self_5_new_back,
      self_5_new_rest = self_5_new_lost + self_5_new_remaining,
      self_5_new_small = self_5_new_rest * down,
      self_5_new_lo = self_5_new_lost == 0.0 ? 0.0 : self_5_new_small;
  const double self_0_new_total = self_0_new + self_0_new_lo,
      self_0_new_rounded = self_0_new_total == self_0_new_total ? self_0_new_total : self_0_new;
  const double self_1_new_total = self_1_new + self_1_new_lo,
      self_1_new_rounded = self_1_new_total == self_1_new_total ? self_1_new_total : self_1_new;
  const double self_2_new_total = self_2_new + self_2_new_lo,
      self_2_new_rounded = self_2_new_total == self_2_new_total ? self_2_new_total : self_2_new;
  const double self_3_new_total = self_3_new + self_3_new_lo,
      self_3_new_rounded = self_3_new_total == self_3_new_total ? self_3_new_total : self_3_new;
  const double self_4_new_total = self_4_new + self_4_new_lo,
      self_4_new_rounded = self_4_new_total == self_4_new_total ? self_4_new_total : self_4_new;
  const double self_5_new_total = self_5_new + self_5_new_lo,
      self_5_new_rounded = self_5_new_total == self_5_new_total ? self_5_new_total : self_5_new;
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   43 mul, 64 add, 10 product error, 2 sum error, 14 div, 1 sqrt, 6 abs, 9 less, 15 equal, 27
     select. */
static inline void ksl_coscrew_normalized_accurate(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double small_a = fabs(ci->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(ci->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(ci->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0;
  const double p_1 = small == 1.0 ? ci->m4 : ci->m1;
  const double p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n = sqrt(n_e), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_e - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_e_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = ci->m0 * up;
  const double enlarged_1 = ci->m1 * up;
  const double enlarged_2 = ci->m2 * up;
  const double enlarged_3 = ci->m3 * up;
  const double enlarged_4 = ci->m4 * up;
  const double enlarged_5 = ci->m5 * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double quotient_4 = enlarged_4 / divisor, quotient_4_cross = quotient_4 * divisor_lo,
      quotient_4_product = quotient_4 * divisor,
      quotient_4_product_error = ksl_product_error(quotient_4, divisor, quotient_4_product),
      quotient_4_rest = enlarged_4 - quotient_4_product,
      quotient_4_exact = quotient_4_rest - quotient_4_product_error,
      quotient_4_residual = quotient_4_exact - quotient_4_cross,
      quotient_4_lo = quotient_4_residual / divisor;
  const double quotient_5 = enlarged_5 / divisor, quotient_5_cross = quotient_5 * divisor_lo,
      quotient_5_product = quotient_5 * divisor,
      quotient_5_product_error = ksl_product_error(quotient_5, divisor, quotient_5_product),
      quotient_5_rest = enlarged_5 - quotient_5_product,
      quotient_5_exact = quotient_5_rest - quotient_5_product_error,
      quotient_5_residual = quotient_5_exact - quotient_5_cross,
      quotient_5_lo = quotient_5_residual / divisor;
  const double co_0_total = quotient_0 + quotient_0_lo, co_0_added = co_0_total - quotient_0,
      co_0_remaining = quotient_0_lo - co_0_added, co_0 = co_0_total * down,
      co_0_inverse = 1.0 / down, co_0_back = co_0 * co_0_inverse,
      co_0_lost = co_0_total - co_0_back, co_0_rest = co_0_lost + co_0_remaining,
      co_0_small = co_0_rest * down, co_0_lo = co_0_lost == 0.0 ? 0.0 : co_0_small;
  const double co_1_total = quotient_1 + quotient_1_lo, co_1_added = co_1_total - quotient_1,
      co_1_remaining = quotient_1_lo - co_1_added, co_1 = co_1_total * down,
      co_1_back = co_1 * co_0_inverse, co_1_lost = co_1_total - co_1_back,
      co_1_rest = co_1_lost + co_1_remaining, co_1_small = co_1_rest * down,
      co_1_lo = co_1_lost == 0.0 ? 0.0 : co_1_small;
  const double co_2_total = quotient_2 + quotient_2_lo, co_2_added = co_2_total - quotient_2,
      co_2_remaining = quotient_2_lo - co_2_added, co_2 = co_2_total * down,
      co_2_back = co_2 * co_0_inverse, co_2_lost = co_2_total - co_2_back,
      co_2_rest = co_2_lost + co_2_remaining, co_2_small = co_2_rest * down,
      co_2_lo = co_2_lost == 0.0 ? 0.0 : co_2_small;
  const double co_3_total = quotient_3 + quotient_3_lo, co_3_added = co_3_total - quotient_3,
      co_3_remaining = quotient_3_lo - co_3_added, co_3 = co_3_total * down,
      co_3_back = co_3 * co_0_inverse, co_3_lost = co_3_total - co_3_back,
      co_3_rest = co_3_lost + co_3_remaining, co_3_small = co_3_rest * down,
      co_3_lo = co_3_lost == 0.0 ? 0.0 : co_3_small;
  const double co_4_total = quotient_4 + quotient_4_lo, co_4_added = co_4_total - quotient_4,
      co_4_remaining = quotient_4_lo - co_4_added, co_4 = co_4_total * down,
      co_4_back = co_4 * co_0_inverse, co_4_lost = co_4_total - co_4_back,
      co_4_rest = co_4_lost + co_4_remaining, co_4_small = co_4_rest * down,
      co_4_lo = co_4_lost == 0.0 ? 0.0 : co_4_small;
  const double co_5_total = quotient_5 + quotient_5_lo, co_5_added = co_5_total - quotient_5,
      co_5_remaining = quotient_5_lo - co_5_added, co_5 = co_5_total * down,
      co_5_back = co_5 * co_0_inverse, co_5_lost = co_5_total - co_5_back,
      co_5_rest = co_5_lost + co_5_remaining, co_5_small = co_5_rest * down,
      co_5_lo = co_5_lost == 0.0 ? 0.0 : co_5_small;
  const double co_0_total = co_0 + co_0_lo,
      co_0_rounded = co_0_total == co_0_total ? co_0_total : co_0;
  const double co_1_total = co_1 + co_1_lo,
      co_1_rounded = co_1_total == co_1_total ? co_1_total : co_1;
  const double co_2_total = co_2 + co_2_lo,
      co_2_rounded = co_2_total == co_2_total ? co_2_total : co_2;
  const double co_3_total = co_3 + co_3_lo,
      co_3_rounded = co_3_total == co_3_total ? co_3_total : co_3;
  const double co_4_total = co_4 + co_4_lo,
      co_4_rounded = co_4_total == co_4_total ? co_4_total : co_4;
  const double co_5_total = co_5 + co_5_lo,
      co_5_rounded = co_5_total == co_5_total ? co_5_total : co_5;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add, 3 sum error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_lo = ksl_sum_error(c1->m0, c2->m0, co_0);
  const double co_1 = c1->m1 + c2->m1, co_1_lo = ksl_sum_error(c1->m1, c2->m1, co_1);
  const double co_2 = c1->m2 + c2->m2, co_2_lo = ksl_sum_error(c1->m2, c2->m2, co_2);
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
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + (lin: 0, ang: 7) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->y * ci->m2, co_3a_lo = ksl_product_error(t->y, ci->m2, co_3a),
      co_3b = t->z * ci->m1, co_3b_lo = ksl_product_error(t->z, ci->m1, co_3b),
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + ci->m3,
      co_3_error = ksl_sum_error(co_3c, ci->m3, co_3), co_3_lo = co_3_error + co_3c_lo;
  const double co_4a = t->z * ci->m0, co_4a_lo = ksl_product_error(t->z, ci->m0, co_4a),
      co_4b = t->x * ci->m2, co_4b_lo = ksl_product_error(t->x, ci->m2, co_4b),
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + ci->m4,
      co_4_error = ksl_sum_error(co_4c, ci->m4, co_4), co_4_lo = co_4_error + co_4c_lo;
  const double co_5a = t->x * ci->m1, co_5a_lo = ksl_product_error(t->x, ci->m1, co_5a),
      co_5b = t->y * ci->m0, co_5b_lo = ksl_product_error(t->y, ci->m0, co_5b),
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + ci->m5,
      co_5_error = ksl_sum_error(co_5c, ci->m5, co_5), co_5_lo = co_5_error + co_5c_lo;
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
   6 mul, 18 add, 6 product error, 6 sum error.
   Error <= u |result| + (lin: 0, ang: 7) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtinvc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->z * ci->m1, co_3a_lo = ksl_product_error(t->z, ci->m1, co_3a),
      co_3b = t->y * ci->m2, co_3b_lo = ksl_product_error(t->y, ci->m2, co_3b),
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + ci->m3,
      co_3_error = ksl_sum_error(co_3c, ci->m3, co_3), co_3_lo = co_3_error + co_3c_lo;
  const double co_4a = t->x * ci->m2, co_4a_lo = ksl_product_error(t->x, ci->m2, co_4a),
      co_4b = t->z * ci->m0, co_4b_lo = ksl_product_error(t->z, ci->m0, co_4b),
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + ci->m4,
      co_4_error = ksl_sum_error(co_4c, ci->m4, co_4), co_4_lo = co_4_error + co_4c_lo;
  const double co_5a = t->y * ci->m0, co_5a_lo = ksl_product_error(t->y, ci->m0, co_5a),
      co_5b = t->x * ci->m1, co_5b_lo = ksl_product_error(t->x, ci->m1, co_5b),
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + ci->m5,
      co_5_error = ksl_sum_error(co_5c, ci->m5, co_5), co_5_lo = co_5_error + co_5c_lo;
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
   6 mul, 18 add, 6 product error, 6 sum error, 3 neg.
   Error <= u |result| + (lin: 0, ang: 7) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcinv_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = t->z * ci->m1, co_3a_lo = ksl_product_error(t->z, ci->m1, co_3a),
      co_3b = t->y * ci->m2, co_3b_lo = ksl_product_error(t->y, ci->m2, co_3b),
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c - ci->m3,
      co_3_error = ksl_difference_error(co_3c, ci->m3, co_3), co_3_lo = co_3_error + co_3c_lo;
  const double co_4a = t->x * ci->m2, co_4a_lo = ksl_product_error(t->x, ci->m2, co_4a),
      co_4b = t->z * ci->m0, co_4b_lo = ksl_product_error(t->z, ci->m0, co_4b),
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c - ci->m4,
      co_4_error = ksl_difference_error(co_4c, ci->m4, co_4), co_4_lo = co_4_error + co_4c_lo;
  const double co_5a = t->y * ci->m0, co_5a_lo = ksl_product_error(t->y, ci->m0, co_5a),
      co_5b = t->x * ci->m1, co_5b_lo = ksl_product_error(t->x, ci->m1, co_5b),
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c - ci->m5,
      co_5_error = ksl_difference_error(co_5c, ci->m5, co_5), co_5_lo = co_5_error + co_5c_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0a_lo = ksl_product_error(R->m00, ci->m0, co_0a),
      co_0b = R->m01 * ci->m1, co_0b_lo = ksl_product_error(R->m01, ci->m1, co_0b),
      co_0c = co_0a + co_0b, co_0c_error = ksl_sum_error(co_0a, co_0b, co_0c),
      co_0c_lo1 = co_0c_error + co_0a_lo, co_0c_lo = co_0c_lo1 + co_0b_lo, co_0d = R->m02 * ci->m2,
      co_0d_lo = ksl_product_error(R->m02, ci->m2, co_0d), co_0 = co_0c + co_0d,
      co_0_error = ksl_sum_error(co_0c, co_0d, co_0), co_0_lo1 = co_0_error + co_0c_lo,
      co_0_lo = co_0_lo1 + co_0d_lo;
  const double co_1a = R->m10 * ci->m0, co_1a_lo = ksl_product_error(R->m10, ci->m0, co_1a),
      co_1b = R->m11 * ci->m1, co_1b_lo = ksl_product_error(R->m11, ci->m1, co_1b),
      co_1c = co_1a + co_1b, co_1c_error = ksl_sum_error(co_1a, co_1b, co_1c),
      co_1c_lo1 = co_1c_error + co_1a_lo, co_1c_lo = co_1c_lo1 + co_1b_lo, co_1d = R->m12 * ci->m2,
      co_1d_lo = ksl_product_error(R->m12, ci->m2, co_1d), co_1 = co_1c + co_1d,
      co_1_error = ksl_sum_error(co_1c, co_1d, co_1), co_1_lo1 = co_1_error + co_1c_lo,
      co_1_lo = co_1_lo1 + co_1d_lo;
  const double co_2a = R->m20 * ci->m0, co_2a_lo = ksl_product_error(R->m20, ci->m0, co_2a),
      co_2b = R->m21 * ci->m1, co_2b_lo = ksl_product_error(R->m21, ci->m1, co_2b),
      co_2c = co_2a + co_2b, co_2c_error = ksl_sum_error(co_2a, co_2b, co_2c),
      co_2c_lo1 = co_2c_error + co_2a_lo, co_2c_lo = co_2c_lo1 + co_2b_lo, co_2d = R->m22 * ci->m2,
      co_2d_lo = ksl_product_error(R->m22, ci->m2, co_2d), co_2 = co_2c + co_2d,
      co_2_error = ksl_sum_error(co_2c, co_2d, co_2), co_2_lo1 = co_2_error + co_2c_lo,
      co_2_lo = co_2_lo1 + co_2d_lo;
  const double co_3a = R->m00 * ci->m3, co_3a_lo = ksl_product_error(R->m00, ci->m3, co_3a),
      co_3b = R->m01 * ci->m4, co_3b_lo = ksl_product_error(R->m01, ci->m4, co_3b),
      co_3c = co_3a + co_3b, co_3c_error = ksl_sum_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 + co_3b_lo, co_3d = R->m02 * ci->m5,
      co_3d_lo = ksl_product_error(R->m02, ci->m5, co_3d), co_3 = co_3c + co_3d,
      co_3_error = ksl_sum_error(co_3c, co_3d, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + co_3d_lo;
  const double co_4a = R->m10 * ci->m3, co_4a_lo = ksl_product_error(R->m10, ci->m3, co_4a),
      co_4b = R->m11 * ci->m4, co_4b_lo = ksl_product_error(R->m11, ci->m4, co_4b),
      co_4c = co_4a + co_4b, co_4c_error = ksl_sum_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 + co_4b_lo, co_4d = R->m12 * ci->m5,
      co_4d_lo = ksl_product_error(R->m12, ci->m5, co_4d), co_4 = co_4c + co_4d,
      co_4_error = ksl_sum_error(co_4c, co_4d, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + co_4d_lo;
  const double co_5a = R->m20 * ci->m3, co_5a_lo = ksl_product_error(R->m20, ci->m3, co_5a),
      co_5b = R->m21 * ci->m4, co_5b_lo = ksl_product_error(R->m21, ci->m4, co_5b),
      co_5c = co_5a + co_5b, co_5c_error = ksl_sum_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 + co_5b_lo, co_5d = R->m22 * ci->m5,
      co_5d_lo = ksl_product_error(R->m22, ci->m5, co_5d), co_5 = co_5c + co_5d,
      co_5_error = ksl_sum_error(co_5c, co_5d, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + co_5d_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrinvc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0a_lo = ksl_product_error(R->m00, ci->m0, co_0a),
      co_0b = R->m10 * ci->m1, co_0b_lo = ksl_product_error(R->m10, ci->m1, co_0b),
      co_0c = co_0a + co_0b, co_0c_error = ksl_sum_error(co_0a, co_0b, co_0c),
      co_0c_lo1 = co_0c_error + co_0a_lo, co_0c_lo = co_0c_lo1 + co_0b_lo, co_0d = R->m20 * ci->m2,
      co_0d_lo = ksl_product_error(R->m20, ci->m2, co_0d), co_0 = co_0c + co_0d,
      co_0_error = ksl_sum_error(co_0c, co_0d, co_0), co_0_lo1 = co_0_error + co_0c_lo,
      co_0_lo = co_0_lo1 + co_0d_lo;
  const double co_1a = R->m01 * ci->m0, co_1a_lo = ksl_product_error(R->m01, ci->m0, co_1a),
      co_1b = R->m11 * ci->m1, co_1b_lo = ksl_product_error(R->m11, ci->m1, co_1b),
      co_1c = co_1a + co_1b, co_1c_error = ksl_sum_error(co_1a, co_1b, co_1c),
      co_1c_lo1 = co_1c_error + co_1a_lo, co_1c_lo = co_1c_lo1 + co_1b_lo, co_1d = R->m21 * ci->m2,
      co_1d_lo = ksl_product_error(R->m21, ci->m2, co_1d), co_1 = co_1c + co_1d,
      co_1_error = ksl_sum_error(co_1c, co_1d, co_1), co_1_lo1 = co_1_error + co_1c_lo,
      co_1_lo = co_1_lo1 + co_1d_lo;
  const double co_2a = R->m02 * ci->m0, co_2a_lo = ksl_product_error(R->m02, ci->m0, co_2a),
      co_2b = R->m12 * ci->m1, co_2b_lo = ksl_product_error(R->m12, ci->m1, co_2b),
      co_2c = co_2a + co_2b, co_2c_error = ksl_sum_error(co_2a, co_2b, co_2c),
      co_2c_lo1 = co_2c_error + co_2a_lo, co_2c_lo = co_2c_lo1 + co_2b_lo, co_2d = R->m22 * ci->m2,
      co_2d_lo = ksl_product_error(R->m22, ci->m2, co_2d), co_2 = co_2c + co_2d,
      co_2_error = ksl_sum_error(co_2c, co_2d, co_2), co_2_lo1 = co_2_error + co_2c_lo,
      co_2_lo = co_2_lo1 + co_2d_lo;
  const double co_3a = R->m00 * ci->m3, co_3a_lo = ksl_product_error(R->m00, ci->m3, co_3a),
      co_3b = R->m10 * ci->m4, co_3b_lo = ksl_product_error(R->m10, ci->m4, co_3b),
      co_3c = co_3a + co_3b, co_3c_error = ksl_sum_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 + co_3b_lo, co_3d = R->m20 * ci->m5,
      co_3d_lo = ksl_product_error(R->m20, ci->m5, co_3d), co_3 = co_3c + co_3d,
      co_3_error = ksl_sum_error(co_3c, co_3d, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + co_3d_lo;
  const double co_4a = R->m01 * ci->m3, co_4a_lo = ksl_product_error(R->m01, ci->m3, co_4a),
      co_4b = R->m11 * ci->m4, co_4b_lo = ksl_product_error(R->m11, ci->m4, co_4b),
      co_4c = co_4a + co_4b, co_4c_error = ksl_sum_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 + co_4b_lo, co_4d = R->m21 * ci->m5,
      co_4d_lo = ksl_product_error(R->m21, ci->m5, co_4d), co_4 = co_4c + co_4d,
      co_4_error = ksl_sum_error(co_4c, co_4d, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + co_4d_lo;
  const double co_5a = R->m02 * ci->m3, co_5a_lo = ksl_product_error(R->m02, ci->m3, co_5a),
      co_5b = R->m12 * ci->m4, co_5b_lo = ksl_product_error(R->m12, ci->m4, co_5b),
      co_5c = co_5a + co_5b, co_5c_error = ksl_sum_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 + co_5b_lo, co_5d = R->m22 * ci->m5,
      co_5d_lo = ksl_product_error(R->m22, ci->m5, co_5d), co_5 = co_5c + co_5d,
      co_5_error = ksl_sum_error(co_5c, co_5d, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + co_5d_lo;
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
   18 mul, 42 add, 18 product error, 12 sum error, 12 neg.
   Error <= u |result| + 10 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcinv_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0a_lo = ksl_product_error(R->m00, ci->m0, co_0a),
      co_0b = R->m01 * ci->m1, co_0b_lo = ksl_product_error(R->m01, ci->m1, co_0b),
      co_0c = co_0a + co_0b, co_0c_error = ksl_sum_error(co_0a, co_0b, co_0c),
      co_0c_lo1 = co_0c_error + co_0a_lo, co_0c_lo = co_0c_lo1 + co_0b_lo, co_0d = R->m02 * ci->m2,
      co_0d_lo = ksl_product_error(R->m02, ci->m2, co_0d), co_0e = co_0c + co_0d,
      co_0e_error = ksl_sum_error(co_0c, co_0d, co_0e), co_0e_lo1 = co_0e_error + co_0c_lo,
      co_0e_lo = co_0e_lo1 + co_0d_lo, co_0 = -co_0e, co_0_lo = -co_0e_lo;
  const double co_1a = R->m10 * ci->m0, co_1a_lo = ksl_product_error(R->m10, ci->m0, co_1a),
      co_1b = R->m11 * ci->m1, co_1b_lo = ksl_product_error(R->m11, ci->m1, co_1b),
      co_1c = co_1a + co_1b, co_1c_error = ksl_sum_error(co_1a, co_1b, co_1c),
      co_1c_lo1 = co_1c_error + co_1a_lo, co_1c_lo = co_1c_lo1 + co_1b_lo, co_1d = R->m12 * ci->m2,
      co_1d_lo = ksl_product_error(R->m12, ci->m2, co_1d), co_1e = co_1c + co_1d,
      co_1e_error = ksl_sum_error(co_1c, co_1d, co_1e), co_1e_lo1 = co_1e_error + co_1c_lo,
      co_1e_lo = co_1e_lo1 + co_1d_lo, co_1 = -co_1e, co_1_lo = -co_1e_lo;
  const double co_2a = R->m20 * ci->m0, co_2a_lo = ksl_product_error(R->m20, ci->m0, co_2a),
      co_2b = R->m21 * ci->m1, co_2b_lo = ksl_product_error(R->m21, ci->m1, co_2b),
      co_2c = co_2a + co_2b, co_2c_error = ksl_sum_error(co_2a, co_2b, co_2c),
      co_2c_lo1 = co_2c_error + co_2a_lo, co_2c_lo = co_2c_lo1 + co_2b_lo, co_2d = R->m22 * ci->m2,
      co_2d_lo = ksl_product_error(R->m22, ci->m2, co_2d), co_2e = co_2c + co_2d,
      co_2e_error = ksl_sum_error(co_2c, co_2d, co_2e), co_2e_lo1 = co_2e_error + co_2c_lo,
      co_2e_lo = co_2e_lo1 + co_2d_lo, co_2 = -co_2e, co_2_lo = -co_2e_lo;
  const double co_3a = R->m00 * ci->m3, co_3a_lo = ksl_product_error(R->m00, ci->m3, co_3a),
      co_3b = R->m01 * ci->m4, co_3b_lo = ksl_product_error(R->m01, ci->m4, co_3b),
      co_3c = co_3a + co_3b, co_3c_error = ksl_sum_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 + co_3b_lo, co_3d = R->m02 * ci->m5,
      co_3d_lo = ksl_product_error(R->m02, ci->m5, co_3d), co_3e = co_3c + co_3d,
      co_3e_error = ksl_sum_error(co_3c, co_3d, co_3e), co_3e_lo1 = co_3e_error + co_3c_lo,
      co_3e_lo = co_3e_lo1 + co_3d_lo, co_3 = -co_3e, co_3_lo = -co_3e_lo;
  const double co_4a = R->m10 * ci->m3, co_4a_lo = ksl_product_error(R->m10, ci->m3, co_4a),
      co_4b = R->m11 * ci->m4, co_4b_lo = ksl_product_error(R->m11, ci->m4, co_4b),
      co_4c = co_4a + co_4b, co_4c_error = ksl_sum_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 + co_4b_lo, co_4d = R->m12 * ci->m5,
      co_4d_lo = ksl_product_error(R->m12, ci->m5, co_4d), co_4e = co_4c + co_4d,
      co_4e_error = ksl_sum_error(co_4c, co_4d, co_4e), co_4e_lo1 = co_4e_error + co_4c_lo,
      co_4e_lo = co_4e_lo1 + co_4d_lo, co_4 = -co_4e, co_4_lo = -co_4e_lo;
  const double co_5a = R->m20 * ci->m3, co_5a_lo = ksl_product_error(R->m20, ci->m3, co_5a),
      co_5b = R->m21 * ci->m4, co_5b_lo = ksl_product_error(R->m21, ci->m4, co_5b),
      co_5c = co_5a + co_5b, co_5c_error = ksl_sum_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 + co_5b_lo, co_5d = R->m22 * ci->m5,
      co_5d_lo = ksl_product_error(R->m22, ci->m5, co_5d), co_5e = co_5c + co_5d,
      co_5e_error = ksl_sum_error(co_5c, co_5d, co_5e), co_5e_lo1 = co_5e_error + co_5c_lo,
      co_5e_lo = co_5e_lo1 + co_5d_lo, co_5 = -co_5e, co_5_lo = -co_5e_lo;
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
   30 mul, 66 add, 24 product error, 18 sum error.
   Error <= u |result| + (lin: 10, ang: 39) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0a_lo = ksl_product_error(D->m00, ci->m0, w_0a),
      w_0b = D->m01 * ci->m1, w_0b_lo = ksl_product_error(D->m01, ci->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * ci->m2,
      w_0d_lo = ksl_product_error(D->m02, ci->m2, w_0d), w_0 = w_0c + w_0d,
      w_0_error = ksl_sum_error(w_0c, w_0d, w_0), w_0_lo1 = w_0_error + w_0c_lo,
      w_0_lo = w_0_lo1 + w_0d_lo;
  const double w_1a = D->m10 * ci->m0, w_1a_lo = ksl_product_error(D->m10, ci->m0, w_1a),
      w_1b = D->m11 * ci->m1, w_1b_lo = ksl_product_error(D->m11, ci->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * ci->m2,
      w_1d_lo = ksl_product_error(D->m12, ci->m2, w_1d), w_1 = w_1c + w_1d,
      w_1_error = ksl_sum_error(w_1c, w_1d, w_1), w_1_lo1 = w_1_error + w_1c_lo,
      w_1_lo = w_1_lo1 + w_1d_lo;
  const double w_2a = D->m20 * ci->m0, w_2a_lo = ksl_product_error(D->m20, ci->m0, w_2a),
      w_2b = D->m21 * ci->m1, w_2b_lo = ksl_product_error(D->m21, ci->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * ci->m2,
      w_2d_lo = ksl_product_error(D->m22, ci->m2, w_2d), w_2 = w_2c + w_2d,
      w_2_error = ksl_sum_error(w_2c, w_2d, w_2), w_2_lo1 = w_2_error + w_2c_lo,
      w_2_lo = w_2_lo1 + w_2d_lo;
  const double w_3a = D->m00 * ci->m3, w_3a_lo = ksl_product_error(D->m00, ci->m3, w_3a),
      w_3b = D->m01 * ci->m4, w_3b_lo = ksl_product_error(D->m01, ci->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * ci->m5,
      w_3d_lo = ksl_product_error(D->m02, ci->m5, w_3d), w_3 = w_3c + w_3d,
      w_3_error = ksl_sum_error(w_3c, w_3d, w_3), w_3_lo1 = w_3_error + w_3c_lo,
      w_3_lo = w_3_lo1 + w_3d_lo;
  const double w_4a = D->m10 * ci->m3, w_4a_lo = ksl_product_error(D->m10, ci->m3, w_4a),
      w_4b = D->m11 * ci->m4, w_4b_lo = ksl_product_error(D->m11, ci->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * ci->m5,
      w_4d_lo = ksl_product_error(D->m12, ci->m5, w_4d), w_4 = w_4c + w_4d,
      w_4_error = ksl_sum_error(w_4c, w_4d, w_4), w_4_lo1 = w_4_error + w_4c_lo,
      w_4_lo = w_4_lo1 + w_4d_lo;
  const double w_5a = D->m20 * ci->m3, w_5a_lo = ksl_product_error(D->m20, ci->m3, w_5a),
      w_5b = D->m21 * ci->m4, w_5b_lo = ksl_product_error(D->m21, ci->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * ci->m5,
      w_5d_lo = ksl_product_error(D->m22, ci->m5, w_5d), w_5 = w_5c + w_5d,
      w_5_error = ksl_sum_error(w_5c, w_5d, w_5), w_5_lo1 = w_5_error + w_5c_lo,
      w_5_lo = w_5_lo1 + w_5d_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   33 mul, 66 add, 24 product error, 18 sum error.
   Error <= u |result| + (lin: 10, ang: 36) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdinvc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = D->m23 * ci->m1, w_3a_lo = ksl_product_error(D->m23, ci->m1, w_3a),
      w_3b = D->m13 * ci->m2, w_3b_lo = ksl_product_error(D->m13, ci->m2, w_3b), w_3c = w_3a - w_3b,
      w_3c_error = ksl_difference_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 - w_3b_lo, w_3 = w_3c + ci->m3,
      w_3_error = ksl_sum_error(w_3c, ci->m3, w_3), w_3_lo = w_3_error + w_3c_lo;
  const double w_4a = D->m03 * ci->m2, w_4a_lo = ksl_product_error(D->m03, ci->m2, w_4a),
      w_4b = D->m23 * ci->m0, w_4b_lo = ksl_product_error(D->m23, ci->m0, w_4b), w_4c = w_4a - w_4b,
      w_4c_error = ksl_difference_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 - w_4b_lo, w_4 = w_4c + ci->m4,
      w_4_error = ksl_sum_error(w_4c, ci->m4, w_4), w_4_lo = w_4_error + w_4c_lo;
  const double w_5a = D->m13 * ci->m0, w_5a_lo = ksl_product_error(D->m13, ci->m0, w_5a),
      w_5b = D->m03 * ci->m1, w_5b_lo = ksl_product_error(D->m03, ci->m1, w_5b), w_5c = w_5a - w_5b,
      w_5c_error = ksl_difference_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 - w_5b_lo, w_5 = w_5c + ci->m5,
      w_5_error = ksl_sum_error(w_5c, ci->m5, w_5), w_5_lo = w_5_error + w_5c_lo;
  const double co_0a = D->m00 * ci->m0, co_0a_lo = ksl_product_error(D->m00, ci->m0, co_0a),
      co_0b = D->m10 * ci->m1, co_0b_lo = ksl_product_error(D->m10, ci->m1, co_0b),
      co_0c = co_0a + co_0b, co_0c_error = ksl_sum_error(co_0a, co_0b, co_0c),
      co_0c_lo1 = co_0c_error + co_0a_lo, co_0c_lo = co_0c_lo1 + co_0b_lo, co_0d = D->m20 * ci->m2,
      co_0d_lo = ksl_product_error(D->m20, ci->m2, co_0d), co_0 = co_0c + co_0d,
      co_0_error = ksl_sum_error(co_0c, co_0d, co_0), co_0_lo1 = co_0_error + co_0c_lo,
      co_0_lo = co_0_lo1 + co_0d_lo;
  const double co_1a = D->m01 * ci->m0, co_1a_lo = ksl_product_error(D->m01, ci->m0, co_1a),
      co_1b = D->m11 * ci->m1, co_1b_lo = ksl_product_error(D->m11, ci->m1, co_1b),
      co_1c = co_1a + co_1b, co_1c_error = ksl_sum_error(co_1a, co_1b, co_1c),
      co_1c_lo1 = co_1c_error + co_1a_lo, co_1c_lo = co_1c_lo1 + co_1b_lo, co_1d = D->m21 * ci->m2,
      co_1d_lo = ksl_product_error(D->m21, ci->m2, co_1d), co_1 = co_1c + co_1d,
      co_1_error = ksl_sum_error(co_1c, co_1d, co_1), co_1_lo1 = co_1_error + co_1c_lo,
      co_1_lo = co_1_lo1 + co_1d_lo;
  const double co_2a = D->m02 * ci->m0, co_2a_lo = ksl_product_error(D->m02, ci->m0, co_2a),
      co_2b = D->m12 * ci->m1, co_2b_lo = ksl_product_error(D->m12, ci->m1, co_2b),
      co_2c = co_2a + co_2b, co_2c_error = ksl_sum_error(co_2a, co_2b, co_2c),
      co_2c_lo1 = co_2c_error + co_2a_lo, co_2c_lo = co_2c_lo1 + co_2b_lo, co_2d = D->m22 * ci->m2,
      co_2d_lo = ksl_product_error(D->m22, ci->m2, co_2d), co_2 = co_2c + co_2d,
      co_2_error = ksl_sum_error(co_2c, co_2d, co_2), co_2_lo1 = co_2_error + co_2c_lo,
      co_2_lo = co_2_lo1 + co_2d_lo;
  const double co_3a = D->m00 * w_3, co_3a_cross1 = D->m00 * w_3_lo,
      co_3a_error = ksl_product_error(D->m00, w_3, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m10 * w_4, co_3b_cross1 = D->m10 * w_4_lo,
      co_3b_error = ksl_product_error(D->m10, w_4, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a + co_3b, co_3c_error = ksl_sum_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 + co_3b_lo, co_3d = D->m20 * w_5,
      co_3d_cross1 = D->m20 * w_5_lo, co_3d_error = ksl_product_error(D->m20, w_5, co_3d),
      co_3d_lo = co_3d_error + co_3d_cross1, co_3 = co_3c + co_3d,
      co_3_error = ksl_sum_error(co_3c, co_3d, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + co_3d_lo;
  const double co_4a = D->m01 * w_3, co_4a_cross1 = D->m01 * w_3_lo,
      co_4a_error = ksl_product_error(D->m01, w_3, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m11 * w_4, co_4b_cross1 = D->m11 * w_4_lo,
      co_4b_error = ksl_product_error(D->m11, w_4, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a + co_4b, co_4c_error = ksl_sum_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 + co_4b_lo, co_4d = D->m21 * w_5,
      co_4d_cross1 = D->m21 * w_5_lo, co_4d_error = ksl_product_error(D->m21, w_5, co_4d),
      co_4d_lo = co_4d_error + co_4d_cross1, co_4 = co_4c + co_4d,
      co_4_error = ksl_sum_error(co_4c, co_4d, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + co_4d_lo;
  const double co_5a = D->m02 * w_3, co_5a_cross1 = D->m02 * w_3_lo,
      co_5a_error = ksl_product_error(D->m02, w_3, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m12 * w_4, co_5b_cross1 = D->m12 * w_4_lo,
      co_5b_error = ksl_product_error(D->m12, w_4, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a + co_5b, co_5c_error = ksl_sum_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 + co_5b_lo, co_5d = D->m22 * w_5,
      co_5d_cross1 = D->m22 * w_5_lo, co_5d_error = ksl_product_error(D->m22, w_5, co_5d),
      co_5d_lo = co_5d_error + co_5d_cross1, co_5 = co_5c + co_5d,
      co_5_error = ksl_sum_error(co_5c, co_5d, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + co_5d_lo;
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
   30 mul, 66 add, 24 product error, 18 sum error, 12 neg.
   Error <= u |result| + (lin: 10, ang: 39) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcinv_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0a_lo = ksl_product_error(D->m00, ci->m0, w_0a),
      w_0b = D->m01 * ci->m1, w_0b_lo = ksl_product_error(D->m01, ci->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * ci->m2,
      w_0d_lo = ksl_product_error(D->m02, ci->m2, w_0d), w_0e = w_0c + w_0d,
      w_0e_error = ksl_sum_error(w_0c, w_0d, w_0e), w_0e_lo1 = w_0e_error + w_0c_lo,
      w_0e_lo = w_0e_lo1 + w_0d_lo, w_0 = -w_0e, w_0_lo = -w_0e_lo;
  const double w_1a = D->m10 * ci->m0, w_1a_lo = ksl_product_error(D->m10, ci->m0, w_1a),
      w_1b = D->m11 * ci->m1, w_1b_lo = ksl_product_error(D->m11, ci->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * ci->m2,
      w_1d_lo = ksl_product_error(D->m12, ci->m2, w_1d), w_1e = w_1c + w_1d,
      w_1e_error = ksl_sum_error(w_1c, w_1d, w_1e), w_1e_lo1 = w_1e_error + w_1c_lo,
      w_1e_lo = w_1e_lo1 + w_1d_lo, w_1 = -w_1e, w_1_lo = -w_1e_lo;
  const double w_2a = D->m20 * ci->m0, w_2a_lo = ksl_product_error(D->m20, ci->m0, w_2a),
      w_2b = D->m21 * ci->m1, w_2b_lo = ksl_product_error(D->m21, ci->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * ci->m2,
      w_2d_lo = ksl_product_error(D->m22, ci->m2, w_2d), w_2e = w_2c + w_2d,
      w_2e_error = ksl_sum_error(w_2c, w_2d, w_2e), w_2e_lo1 = w_2e_error + w_2c_lo,
      w_2e_lo = w_2e_lo1 + w_2d_lo, w_2 = -w_2e, w_2_lo = -w_2e_lo;
  const double w_3a = D->m00 * ci->m3, w_3a_lo = ksl_product_error(D->m00, ci->m3, w_3a),
      w_3b = D->m01 * ci->m4, w_3b_lo = ksl_product_error(D->m01, ci->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * ci->m5,
      w_3d_lo = ksl_product_error(D->m02, ci->m5, w_3d), w_3e = w_3c + w_3d,
      w_3e_error = ksl_sum_error(w_3c, w_3d, w_3e), w_3e_lo1 = w_3e_error + w_3c_lo,
      w_3e_lo = w_3e_lo1 + w_3d_lo, w_3 = -w_3e, w_3_lo = -w_3e_lo;
  const double w_4a = D->m10 * ci->m3, w_4a_lo = ksl_product_error(D->m10, ci->m3, w_4a),
      w_4b = D->m11 * ci->m4, w_4b_lo = ksl_product_error(D->m11, ci->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * ci->m5,
      w_4d_lo = ksl_product_error(D->m12, ci->m5, w_4d), w_4e = w_4c + w_4d,
      w_4e_error = ksl_sum_error(w_4c, w_4d, w_4e), w_4e_lo1 = w_4e_error + w_4c_lo,
      w_4e_lo = w_4e_lo1 + w_4d_lo, w_4 = -w_4e, w_4_lo = -w_4e_lo;
  const double w_5a = D->m20 * ci->m3, w_5a_lo = ksl_product_error(D->m20, ci->m3, w_5a),
      w_5b = D->m21 * ci->m4, w_5b_lo = ksl_product_error(D->m21, ci->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * ci->m5,
      w_5d_lo = ksl_product_error(D->m22, ci->m5, w_5d), w_5e = w_5c + w_5d,
      w_5e_error = ksl_sum_error(w_5c, w_5d, w_5e), w_5e_lo1 = w_5e_error + w_5c_lo,
      w_5e_lo = w_5e_lo1 + w_5d_lo, w_5 = -w_5e, w_5_lo = -w_5e_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctx_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m20 * D->m13, co_3a_lo = ksl_product_error(D->m20, D->m13, co_3a),
      co_3b = D->m10 * D->m23, co_3b_lo = ksl_product_error(D->m10, D->m23, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m00 * D->m23, co_4a_lo = ksl_product_error(D->m00, D->m23, co_4a),
      co_4b = D->m20 * D->m03, co_4b_lo = ksl_product_error(D->m20, D->m03, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m10 * D->m03, co_5a_lo = ksl_product_error(D->m10, D->m03, co_5a),
      co_5b = D->m00 * D->m13, co_5b_lo = ksl_product_error(D->m00, D->m13, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hcty_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m21 * D->m13, co_3a_lo = ksl_product_error(D->m21, D->m13, co_3a),
      co_3b = D->m11 * D->m23, co_3b_lo = ksl_product_error(D->m11, D->m23, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m01 * D->m23, co_4a_lo = ksl_product_error(D->m01, D->m23, co_4a),
      co_4b = D->m21 * D->m03, co_4b_lo = ksl_product_error(D->m21, D->m03, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m11 * D->m03, co_5a_lo = ksl_product_error(D->m11, D->m03, co_5a),
      co_5b = D->m01 * D->m13, co_5b_lo = ksl_product_error(D->m01, D->m13, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctz_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m22 * D->m13, co_3a_lo = ksl_product_error(D->m22, D->m13, co_3a),
      co_3b = D->m12 * D->m23, co_3b_lo = ksl_product_error(D->m12, D->m23, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m02 * D->m23, co_4a_lo = ksl_product_error(D->m02, D->m23, co_4a),
      co_4b = D->m22 * D->m03, co_4b_lo = ksl_product_error(D->m22, D->m03, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m12 * D->m03, co_5a_lo = ksl_product_error(D->m12, D->m03, co_5a),
      co_5b = D->m02 * D->m13, co_5b_lo = ksl_product_error(D->m02, D->m13, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = D->m10 * D->m23, co_3a_lo = ksl_product_error(D->m10, D->m23, co_3a),
      co_3b = D->m20 * D->m13, co_3b_lo = ksl_product_error(D->m20, D->m13, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m20 * D->m03, co_4a_lo = ksl_product_error(D->m20, D->m03, co_4a),
      co_4b = D->m00 * D->m23, co_4b_lo = ksl_product_error(D->m00, D->m23, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m00 * D->m13, co_5a_lo = ksl_product_error(D->m00, D->m13, co_5a),
      co_5b = D->m10 * D->m03, co_5b_lo = ksl_product_error(D->m10, D->m03, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = D->m11 * D->m23, co_3a_lo = ksl_product_error(D->m11, D->m23, co_3a),
      co_3b = D->m21 * D->m13, co_3b_lo = ksl_product_error(D->m21, D->m13, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m21 * D->m03, co_4a_lo = ksl_product_error(D->m21, D->m03, co_4a),
      co_4b = D->m01 * D->m23, co_4b_lo = ksl_product_error(D->m01, D->m23, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m01 * D->m13, co_5a_lo = ksl_product_error(D->m01, D->m13, co_5a),
      co_5b = D->m11 * D->m03, co_5b_lo = ksl_product_error(D->m11, D->m03, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error, 3 neg.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = D->m12 * D->m23, co_3a_lo = ksl_product_error(D->m12, D->m23, co_3a),
      co_3b = D->m22 * D->m13, co_3b_lo = ksl_product_error(D->m22, D->m13, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m22 * D->m03, co_4a_lo = ksl_product_error(D->m22, D->m03, co_4a),
      co_4b = D->m02 * D->m23, co_4b_lo = ksl_product_error(D->m02, D->m23, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m02 * D->m13, co_5a_lo = ksl_product_error(D->m02, D->m13, co_5a),
      co_5b = D->m12 * D->m03, co_5b_lo = ksl_product_error(D->m12, D->m03, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   18 mul, 36 add, 18 product error, 9 sum error.
   Error <= u |result| + 4 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = D->m20 * D->m13, M_30a_lo = ksl_product_error(D->m20, D->m13, M_30a),
      M_30b = D->m10 * D->m23, M_30b_lo = ksl_product_error(D->m10, D->m23, M_30b),
      M_30 = M_30a - M_30b, M_30_error = ksl_difference_error(M_30a, M_30b, M_30),
      M_30_lo1 = M_30_error + M_30a_lo, M_30_lo = M_30_lo1 - M_30b_lo;
  const double M_31a = D->m21 * D->m13, M_31a_lo = ksl_product_error(D->m21, D->m13, M_31a),
      M_31b = D->m11 * D->m23, M_31b_lo = ksl_product_error(D->m11, D->m23, M_31b),
      M_31 = M_31a - M_31b, M_31_error = ksl_difference_error(M_31a, M_31b, M_31),
      M_31_lo1 = M_31_error + M_31a_lo, M_31_lo = M_31_lo1 - M_31b_lo;
  const double M_32a = D->m22 * D->m13, M_32a_lo = ksl_product_error(D->m22, D->m13, M_32a),
      M_32b = D->m12 * D->m23, M_32b_lo = ksl_product_error(D->m12, D->m23, M_32b),
      M_32 = M_32a - M_32b, M_32_error = ksl_difference_error(M_32a, M_32b, M_32),
      M_32_lo1 = M_32_error + M_32a_lo, M_32_lo = M_32_lo1 - M_32b_lo;
  const double M_40a = D->m00 * D->m23, M_40a_lo = ksl_product_error(D->m00, D->m23, M_40a),
      M_40b = D->m20 * D->m03, M_40b_lo = ksl_product_error(D->m20, D->m03, M_40b),
      M_40 = M_40a - M_40b, M_40_error = ksl_difference_error(M_40a, M_40b, M_40),
      M_40_lo1 = M_40_error + M_40a_lo, M_40_lo = M_40_lo1 - M_40b_lo;
  const double M_41a = D->m01 * D->m23, M_41a_lo = ksl_product_error(D->m01, D->m23, M_41a),
      M_41b = D->m21 * D->m03, M_41b_lo = ksl_product_error(D->m21, D->m03, M_41b),
      M_41 = M_41a - M_41b, M_41_error = ksl_difference_error(M_41a, M_41b, M_41),
      M_41_lo1 = M_41_error + M_41a_lo, M_41_lo = M_41_lo1 - M_41b_lo;
  const double M_42a = D->m02 * D->m23, M_42a_lo = ksl_product_error(D->m02, D->m23, M_42a),
      M_42b = D->m22 * D->m03, M_42b_lo = ksl_product_error(D->m22, D->m03, M_42b),
      M_42 = M_42a - M_42b, M_42_error = ksl_difference_error(M_42a, M_42b, M_42),
      M_42_lo1 = M_42_error + M_42a_lo, M_42_lo = M_42_lo1 - M_42b_lo;
  const double M_50a = D->m10 * D->m03, M_50a_lo = ksl_product_error(D->m10, D->m03, M_50a),
      M_50b = D->m00 * D->m13, M_50b_lo = ksl_product_error(D->m00, D->m13, M_50b),
      M_50 = M_50a - M_50b, M_50_error = ksl_difference_error(M_50a, M_50b, M_50),
      M_50_lo1 = M_50_error + M_50a_lo, M_50_lo = M_50_lo1 - M_50b_lo;
  const double M_51a = D->m11 * D->m03, M_51a_lo = ksl_product_error(D->m11, D->m03, M_51a),
      M_51b = D->m01 * D->m13, M_51b_lo = ksl_product_error(D->m01, D->m13, M_51b),
      M_51 = M_51a - M_51b, M_51_error = ksl_difference_error(M_51a, M_51b, M_51),
      M_51_lo1 = M_51_error + M_51a_lo, M_51_lo = M_51_lo1 - M_51b_lo;
  const double M_52a = D->m12 * D->m03, M_52a_lo = ksl_product_error(D->m12, D->m03, M_52a),
      M_52b = D->m02 * D->m13, M_52b_lo = ksl_product_error(D->m02, D->m13, M_52b),
      M_52 = M_52a - M_52b, M_52_error = ksl_difference_error(M_52a, M_52b, M_52),
      M_52_lo1 = M_52_error + M_52a_lo, M_52_lo = M_52_lo1 - M_52b_lo;
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
   6 mul, 16 add, 6 product error, 5 sum error.
   Error <= u |result| + 18 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_reciprocal_product_accurate(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = c->m0 * x[3], power_a_lo = ksl_product_error(c->m0, x[3], power_a),
      power_b = c->m1 * x[4], power_b_lo = ksl_product_error(c->m1, x[4], power_b),
      power_c = power_a + power_b, power_c_error = ksl_sum_error(power_a, power_b, power_c),
      power_c_lo1 = power_c_error + power_a_lo, power_c_lo = power_c_lo1 + power_b_lo,
      power_d = c->m2 * x[5], power_d_lo = ksl_product_error(c->m2, x[5], power_d),
      power_e = power_c + power_d, power_e_error = ksl_sum_error(power_c, power_d, power_e),
      power_e_lo1 = power_e_error + power_c_lo, power_e_lo = power_e_lo1 + power_d_lo,
      power_f = c->m3 * x[0], power_f_lo = ksl_product_error(c->m3, x[0], power_f),
      power_g = c->m4 * x[1], power_g_lo = ksl_product_error(c->m4, x[1], power_g),
      power_h = power_f + power_g, power_h_error = ksl_sum_error(power_f, power_g, power_h),
      power_h_lo1 = power_h_error + power_f_lo, power_h_lo = power_h_lo1 + power_g_lo,
      power_i = c->m5 * x[2], power_i_lo = ksl_product_error(c->m5, x[2], power_i),
      power_j = power_h + power_i, power_j_error = ksl_sum_error(power_h, power_i, power_j),
      power_j_lo1 = power_j_error + power_h_lo, power_j_lo = power_j_lo1 + power_i_lo,
      power = power_e + power_j, power_error = ksl_sum_error(power_e, power_j, power),
      power_lo1 = power_error + power_e_lo, power_lo = power_lo1 + power_j_lo;
  const double power_rounded = power + power_lo;
  return power_rounded;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 42 add, 18 product error, 12 sum error.
   Error <= u |result| + (lin: 4, ang: 10) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sc_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_0a = s->m4 * c->m2, co_0a_lo = ksl_product_error(s->m4, c->m2, co_0a),
      co_0b = s->m5 * c->m1, co_0b_lo = ksl_product_error(s->m5, c->m1, co_0b),
      co_0 = co_0a - co_0b, co_0_error = ksl_difference_error(co_0a, co_0b, co_0),
      co_0_lo1 = co_0_error + co_0a_lo, co_0_lo = co_0_lo1 - co_0b_lo;
  const double co_1a = s->m5 * c->m0, co_1a_lo = ksl_product_error(s->m5, c->m0, co_1a),
      co_1b = s->m3 * c->m2, co_1b_lo = ksl_product_error(s->m3, c->m2, co_1b),
      co_1 = co_1a - co_1b, co_1_error = ksl_difference_error(co_1a, co_1b, co_1),
      co_1_lo1 = co_1_error + co_1a_lo, co_1_lo = co_1_lo1 - co_1b_lo;
  const double co_2a = s->m3 * c->m1, co_2a_lo = ksl_product_error(s->m3, c->m1, co_2a),
      co_2b = s->m4 * c->m0, co_2b_lo = ksl_product_error(s->m4, c->m0, co_2b),
      co_2 = co_2a - co_2b, co_2_error = ksl_difference_error(co_2a, co_2b, co_2),
      co_2_lo1 = co_2_error + co_2a_lo, co_2_lo = co_2_lo1 - co_2b_lo;
  const double co_3a = s->m1 * c->m2, co_3a_lo = ksl_product_error(s->m1, c->m2, co_3a),
      co_3b = s->m2 * c->m1, co_3b_lo = ksl_product_error(s->m2, c->m1, co_3b),
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3d = s->m4 * c->m5,
      co_3d_lo = ksl_product_error(s->m4, c->m5, co_3d), co_3e = s->m5 * c->m4,
      co_3e_lo = ksl_product_error(s->m5, c->m4, co_3e), co_3f = co_3d - co_3e,
      co_3f_error = ksl_difference_error(co_3d, co_3e, co_3f), co_3f_lo1 = co_3f_error + co_3d_lo,
      co_3f_lo = co_3f_lo1 - co_3e_lo, co_3 = co_3c + co_3f,
      co_3_error = ksl_sum_error(co_3c, co_3f, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + co_3f_lo;
  const double co_4a = s->m2 * c->m0, co_4a_lo = ksl_product_error(s->m2, c->m0, co_4a),
      co_4b = s->m0 * c->m2, co_4b_lo = ksl_product_error(s->m0, c->m2, co_4b),
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4d = s->m5 * c->m3,
      co_4d_lo = ksl_product_error(s->m5, c->m3, co_4d), co_4e = s->m3 * c->m5,
      co_4e_lo = ksl_product_error(s->m3, c->m5, co_4e), co_4f = co_4d - co_4e,
      co_4f_error = ksl_difference_error(co_4d, co_4e, co_4f), co_4f_lo1 = co_4f_error + co_4d_lo,
      co_4f_lo = co_4f_lo1 - co_4e_lo, co_4 = co_4c + co_4f,
      co_4_error = ksl_sum_error(co_4c, co_4f, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + co_4f_lo;
  const double co_5a = s->m0 * c->m1, co_5a_lo = ksl_product_error(s->m0, c->m1, co_5a),
      co_5b = s->m1 * c->m0, co_5b_lo = ksl_product_error(s->m1, c->m0, co_5b),
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5d = s->m3 * c->m4,
      co_5d_lo = ksl_product_error(s->m3, c->m4, co_5d), co_5e = s->m4 * c->m3,
      co_5e_lo = ksl_product_error(s->m4, c->m3, co_5e), co_5f = co_5d - co_5e,
      co_5f_error = ksl_difference_error(co_5d, co_5e, co_5f), co_5f_lo1 = co_5f_error + co_5d_lo,
      co_5f_lo = co_5f_lo1 - co_5e_lo, co_5 = co_5c + co_5f,
      co_5_error = ksl_sum_error(co_5c, co_5f, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + co_5f_lo;
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
   6 mul, 12 add, 6 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 4) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sca_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_3a = s->m4 * c->m5, co_3a_lo = ksl_product_error(s->m4, c->m5, co_3a),
      co_3b = s->m5 * c->m4, co_3b_lo = ksl_product_error(s->m5, c->m4, co_3b),
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = s->m5 * c->m3, co_4a_lo = ksl_product_error(s->m5, c->m3, co_4a),
      co_4b = s->m3 * c->m5, co_4b_lo = ksl_product_error(s->m3, c->m5, co_4b),
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = s->m3 * c->m4, co_5a_lo = ksl_product_error(s->m3, c->m4, co_5a),
      co_5b = s->m4 * c->m3, co_5b_lo = ksl_product_error(s->m4, c->m3, co_5b),
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 4, ang: 27) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m01 * c->m1, w_0a_lo = ksl_product_error(D->m01, c->m1, w_0a),
      w_0b = D->m02 * c->m2, w_0b_lo = ksl_product_error(D->m02, c->m2, w_0b), w_0 = w_0a + w_0b,
      w_0_error = ksl_sum_error(w_0a, w_0b, w_0), w_0_lo1 = w_0_error + w_0a_lo,
      w_0_lo = w_0_lo1 + w_0b_lo;
  const double w_1a = D->m11 * c->m1, w_1a_lo = ksl_product_error(D->m11, c->m1, w_1a),
      w_1b = D->m12 * c->m2, w_1b_lo = ksl_product_error(D->m12, c->m2, w_1b), w_1 = w_1a + w_1b,
      w_1_error = ksl_sum_error(w_1a, w_1b, w_1), w_1_lo1 = w_1_error + w_1a_lo,
      w_1_lo = w_1_lo1 + w_1b_lo;
  const double w_2a = D->m21 * c->m1, w_2a_lo = ksl_product_error(D->m21, c->m1, w_2a),
      w_2b = D->m22 * c->m2, w_2b_lo = ksl_product_error(D->m22, c->m2, w_2b), w_2 = w_2a + w_2b,
      w_2_error = ksl_sum_error(w_2a, w_2b, w_2), w_2_lo1 = w_2_error + w_2a_lo,
      w_2_lo = w_2_lo1 + w_2b_lo;
  const double w_3a = D->m00 * c->m3, w_3a_lo = ksl_product_error(D->m00, c->m3, w_3a),
      w_3b = D->m01 * c->m4, w_3b_lo = ksl_product_error(D->m01, c->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * c->m5,
      w_3d_lo = ksl_product_error(D->m02, c->m5, w_3d), w_3 = w_3c + w_3d,
      w_3_error = ksl_sum_error(w_3c, w_3d, w_3), w_3_lo1 = w_3_error + w_3c_lo,
      w_3_lo = w_3_lo1 + w_3d_lo;
  const double w_4a = D->m10 * c->m3, w_4a_lo = ksl_product_error(D->m10, c->m3, w_4a),
      w_4b = D->m11 * c->m4, w_4b_lo = ksl_product_error(D->m11, c->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * c->m5,
      w_4d_lo = ksl_product_error(D->m12, c->m5, w_4d), w_4 = w_4c + w_4d,
      w_4_error = ksl_sum_error(w_4c, w_4d, w_4), w_4_lo1 = w_4_error + w_4c_lo,
      w_4_lo = w_4_lo1 + w_4d_lo;
  const double w_5a = D->m20 * c->m3, w_5a_lo = ksl_product_error(D->m20, c->m3, w_5a),
      w_5b = D->m21 * c->m4, w_5b_lo = ksl_product_error(D->m21, c->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * c->m5,
      w_5d_lo = ksl_product_error(D->m22, c->m5, w_5d), w_5 = w_5c + w_5d,
      w_5_error = ksl_sum_error(w_5c, w_5d, w_5), w_5_lo1 = w_5_error + w_5c_lo,
      w_5_lo = w_5_lo1 + w_5d_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 4, ang: 27) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0a_lo = ksl_product_error(D->m00, c->m0, w_0a),
      w_0b = D->m02 * c->m2, w_0b_lo = ksl_product_error(D->m02, c->m2, w_0b), w_0 = w_0a + w_0b,
      w_0_error = ksl_sum_error(w_0a, w_0b, w_0), w_0_lo1 = w_0_error + w_0a_lo,
      w_0_lo = w_0_lo1 + w_0b_lo;
  const double w_1a = D->m10 * c->m0, w_1a_lo = ksl_product_error(D->m10, c->m0, w_1a),
      w_1b = D->m12 * c->m2, w_1b_lo = ksl_product_error(D->m12, c->m2, w_1b), w_1 = w_1a + w_1b,
      w_1_error = ksl_sum_error(w_1a, w_1b, w_1), w_1_lo1 = w_1_error + w_1a_lo,
      w_1_lo = w_1_lo1 + w_1b_lo;
  const double w_2a = D->m20 * c->m0, w_2a_lo = ksl_product_error(D->m20, c->m0, w_2a),
      w_2b = D->m22 * c->m2, w_2b_lo = ksl_product_error(D->m22, c->m2, w_2b), w_2 = w_2a + w_2b,
      w_2_error = ksl_sum_error(w_2a, w_2b, w_2), w_2_lo1 = w_2_error + w_2a_lo,
      w_2_lo = w_2_lo1 + w_2b_lo;
  const double w_3a = D->m00 * c->m3, w_3a_lo = ksl_product_error(D->m00, c->m3, w_3a),
      w_3b = D->m01 * c->m4, w_3b_lo = ksl_product_error(D->m01, c->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * c->m5,
      w_3d_lo = ksl_product_error(D->m02, c->m5, w_3d), w_3 = w_3c + w_3d,
      w_3_error = ksl_sum_error(w_3c, w_3d, w_3), w_3_lo1 = w_3_error + w_3c_lo,
      w_3_lo = w_3_lo1 + w_3d_lo;
  const double w_4a = D->m10 * c->m3, w_4a_lo = ksl_product_error(D->m10, c->m3, w_4a),
      w_4b = D->m11 * c->m4, w_4b_lo = ksl_product_error(D->m11, c->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * c->m5,
      w_4d_lo = ksl_product_error(D->m12, c->m5, w_4d), w_4 = w_4c + w_4d,
      w_4_error = ksl_sum_error(w_4c, w_4d, w_4), w_4_lo1 = w_4_error + w_4c_lo,
      w_4_lo = w_4_lo1 + w_4d_lo;
  const double w_5a = D->m20 * c->m3, w_5a_lo = ksl_product_error(D->m20, c->m3, w_5a),
      w_5b = D->m21 * c->m4, w_5b_lo = ksl_product_error(D->m21, c->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * c->m5,
      w_5d_lo = ksl_product_error(D->m22, c->m5, w_5d), w_5 = w_5c + w_5d,
      w_5_error = ksl_sum_error(w_5c, w_5d, w_5), w_5_lo1 = w_5_error + w_5c_lo,
      w_5_lo = w_5_lo1 + w_5d_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 4, ang: 27) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0a_lo = ksl_product_error(D->m00, c->m0, w_0a),
      w_0b = D->m01 * c->m1, w_0b_lo = ksl_product_error(D->m01, c->m1, w_0b), w_0 = w_0a + w_0b,
      w_0_error = ksl_sum_error(w_0a, w_0b, w_0), w_0_lo1 = w_0_error + w_0a_lo,
      w_0_lo = w_0_lo1 + w_0b_lo;
  const double w_1a = D->m10 * c->m0, w_1a_lo = ksl_product_error(D->m10, c->m0, w_1a),
      w_1b = D->m11 * c->m1, w_1b_lo = ksl_product_error(D->m11, c->m1, w_1b), w_1 = w_1a + w_1b,
      w_1_error = ksl_sum_error(w_1a, w_1b, w_1), w_1_lo1 = w_1_error + w_1a_lo,
      w_1_lo = w_1_lo1 + w_1b_lo;
  const double w_2a = D->m20 * c->m0, w_2a_lo = ksl_product_error(D->m20, c->m0, w_2a),
      w_2b = D->m21 * c->m1, w_2b_lo = ksl_product_error(D->m21, c->m1, w_2b), w_2 = w_2a + w_2b,
      w_2_error = ksl_sum_error(w_2a, w_2b, w_2), w_2_lo1 = w_2_error + w_2a_lo,
      w_2_lo = w_2_lo1 + w_2b_lo;
  const double w_3a = D->m00 * c->m3, w_3a_lo = ksl_product_error(D->m00, c->m3, w_3a),
      w_3b = D->m01 * c->m4, w_3b_lo = ksl_product_error(D->m01, c->m4, w_3b), w_3c = w_3a + w_3b,
      w_3c_error = ksl_sum_error(w_3a, w_3b, w_3c), w_3c_lo1 = w_3c_error + w_3a_lo,
      w_3c_lo = w_3c_lo1 + w_3b_lo, w_3d = D->m02 * c->m5,
      w_3d_lo = ksl_product_error(D->m02, c->m5, w_3d), w_3 = w_3c + w_3d,
      w_3_error = ksl_sum_error(w_3c, w_3d, w_3), w_3_lo1 = w_3_error + w_3c_lo,
      w_3_lo = w_3_lo1 + w_3d_lo;
  const double w_4a = D->m10 * c->m3, w_4a_lo = ksl_product_error(D->m10, c->m3, w_4a),
      w_4b = D->m11 * c->m4, w_4b_lo = ksl_product_error(D->m11, c->m4, w_4b), w_4c = w_4a + w_4b,
      w_4c_error = ksl_sum_error(w_4a, w_4b, w_4c), w_4c_lo1 = w_4c_error + w_4a_lo,
      w_4c_lo = w_4c_lo1 + w_4b_lo, w_4d = D->m12 * c->m5,
      w_4d_lo = ksl_product_error(D->m12, c->m5, w_4d), w_4 = w_4c + w_4d,
      w_4_error = ksl_sum_error(w_4c, w_4d, w_4), w_4_lo1 = w_4_error + w_4c_lo,
      w_4_lo = w_4_lo1 + w_4d_lo;
  const double w_5a = D->m20 * c->m3, w_5a_lo = ksl_product_error(D->m20, c->m3, w_5a),
      w_5b = D->m21 * c->m4, w_5b_lo = ksl_product_error(D->m21, c->m4, w_5b), w_5c = w_5a + w_5b,
      w_5c_error = ksl_sum_error(w_5a, w_5b, w_5c), w_5c_lo1 = w_5c_error + w_5a_lo,
      w_5c_lo = w_5c_lo1 + w_5b_lo, w_5d = D->m22 * c->m5,
      w_5d_lo = ksl_product_error(D->m22, c->m5, w_5d), w_5 = w_5c + w_5d,
      w_5_error = ksl_sum_error(w_5c, w_5d, w_5), w_5_lo1 = w_5_error + w_5c_lo,
      w_5_lo = w_5_lo1 + w_5d_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 10, ang: 39) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0a_lo = ksl_product_error(D->m00, c->m0, w_0a),
      w_0b = D->m01 * c->m1, w_0b_lo = ksl_product_error(D->m01, c->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * c->m2,
      w_0d_lo = ksl_product_error(D->m02, c->m2, w_0d), w_0 = w_0c + w_0d,
      w_0_error = ksl_sum_error(w_0c, w_0d, w_0), w_0_lo1 = w_0_error + w_0c_lo,
      w_0_lo = w_0_lo1 + w_0d_lo;
  const double w_1a = D->m10 * c->m0, w_1a_lo = ksl_product_error(D->m10, c->m0, w_1a),
      w_1b = D->m11 * c->m1, w_1b_lo = ksl_product_error(D->m11, c->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * c->m2,
      w_1d_lo = ksl_product_error(D->m12, c->m2, w_1d), w_1 = w_1c + w_1d,
      w_1_error = ksl_sum_error(w_1c, w_1d, w_1), w_1_lo1 = w_1_error + w_1c_lo,
      w_1_lo = w_1_lo1 + w_1d_lo;
  const double w_2a = D->m20 * c->m0, w_2a_lo = ksl_product_error(D->m20, c->m0, w_2a),
      w_2b = D->m21 * c->m1, w_2b_lo = ksl_product_error(D->m21, c->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * c->m2,
      w_2d_lo = ksl_product_error(D->m22, c->m2, w_2d), w_2 = w_2c + w_2d,
      w_2_error = ksl_sum_error(w_2c, w_2d, w_2), w_2_lo1 = w_2_error + w_2c_lo,
      w_2_lo = w_2_lo1 + w_2d_lo;
  const double w_3a = D->m01 * c->m4, w_3a_lo = ksl_product_error(D->m01, c->m4, w_3a),
      w_3b = D->m02 * c->m5, w_3b_lo = ksl_product_error(D->m02, c->m5, w_3b), w_3 = w_3a + w_3b,
      w_3_error = ksl_sum_error(w_3a, w_3b, w_3), w_3_lo1 = w_3_error + w_3a_lo,
      w_3_lo = w_3_lo1 + w_3b_lo;
  const double w_4a = D->m11 * c->m4, w_4a_lo = ksl_product_error(D->m11, c->m4, w_4a),
      w_4b = D->m12 * c->m5, w_4b_lo = ksl_product_error(D->m12, c->m5, w_4b), w_4 = w_4a + w_4b,
      w_4_error = ksl_sum_error(w_4a, w_4b, w_4), w_4_lo1 = w_4_error + w_4a_lo,
      w_4_lo = w_4_lo1 + w_4b_lo;
  const double w_5a = D->m21 * c->m4, w_5a_lo = ksl_product_error(D->m21, c->m4, w_5a),
      w_5b = D->m22 * c->m5, w_5b_lo = ksl_product_error(D->m22, c->m5, w_5b), w_5 = w_5a + w_5b,
      w_5_error = ksl_sum_error(w_5a, w_5b, w_5), w_5_lo1 = w_5_error + w_5a_lo,
      w_5_lo = w_5_lo1 + w_5b_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 10, ang: 39) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cry_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0a_lo = ksl_product_error(D->m00, c->m0, w_0a),
      w_0b = D->m01 * c->m1, w_0b_lo = ksl_product_error(D->m01, c->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * c->m2,
      w_0d_lo = ksl_product_error(D->m02, c->m2, w_0d), w_0 = w_0c + w_0d,
      w_0_error = ksl_sum_error(w_0c, w_0d, w_0), w_0_lo1 = w_0_error + w_0c_lo,
      w_0_lo = w_0_lo1 + w_0d_lo;
  const double w_1a = D->m10 * c->m0, w_1a_lo = ksl_product_error(D->m10, c->m0, w_1a),
      w_1b = D->m11 * c->m1, w_1b_lo = ksl_product_error(D->m11, c->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * c->m2,
      w_1d_lo = ksl_product_error(D->m12, c->m2, w_1d), w_1 = w_1c + w_1d,
      w_1_error = ksl_sum_error(w_1c, w_1d, w_1), w_1_lo1 = w_1_error + w_1c_lo,
      w_1_lo = w_1_lo1 + w_1d_lo;
  const double w_2a = D->m20 * c->m0, w_2a_lo = ksl_product_error(D->m20, c->m0, w_2a),
      w_2b = D->m21 * c->m1, w_2b_lo = ksl_product_error(D->m21, c->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * c->m2,
      w_2d_lo = ksl_product_error(D->m22, c->m2, w_2d), w_2 = w_2c + w_2d,
      w_2_error = ksl_sum_error(w_2c, w_2d, w_2), w_2_lo1 = w_2_error + w_2c_lo,
      w_2_lo = w_2_lo1 + w_2d_lo;
  const double w_3a = D->m00 * c->m3, w_3a_lo = ksl_product_error(D->m00, c->m3, w_3a),
      w_3b = D->m02 * c->m5, w_3b_lo = ksl_product_error(D->m02, c->m5, w_3b), w_3 = w_3a + w_3b,
      w_3_error = ksl_sum_error(w_3a, w_3b, w_3), w_3_lo1 = w_3_error + w_3a_lo,
      w_3_lo = w_3_lo1 + w_3b_lo;
  const double w_4a = D->m10 * c->m3, w_4a_lo = ksl_product_error(D->m10, c->m3, w_4a),
      w_4b = D->m12 * c->m5, w_4b_lo = ksl_product_error(D->m12, c->m5, w_4b), w_4 = w_4a + w_4b,
      w_4_error = ksl_sum_error(w_4a, w_4b, w_4), w_4_lo1 = w_4_error + w_4a_lo,
      w_4_lo = w_4_lo1 + w_4b_lo;
  const double w_5a = D->m20 * c->m3, w_5a_lo = ksl_product_error(D->m20, c->m3, w_5a),
      w_5b = D->m22 * c->m5, w_5b_lo = ksl_product_error(D->m22, c->m5, w_5b), w_5 = w_5a + w_5b,
      w_5_error = ksl_sum_error(w_5a, w_5b, w_5), w_5_lo1 = w_5_error + w_5a_lo,
      w_5_lo = w_5_lo1 + w_5b_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   27 mul, 57 add, 21 product error, 15 sum error.
   Error <= u |result| + (lin: 10, ang: 39) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0a_lo = ksl_product_error(D->m00, c->m0, w_0a),
      w_0b = D->m01 * c->m1, w_0b_lo = ksl_product_error(D->m01, c->m1, w_0b), w_0c = w_0a + w_0b,
      w_0c_error = ksl_sum_error(w_0a, w_0b, w_0c), w_0c_lo1 = w_0c_error + w_0a_lo,
      w_0c_lo = w_0c_lo1 + w_0b_lo, w_0d = D->m02 * c->m2,
      w_0d_lo = ksl_product_error(D->m02, c->m2, w_0d), w_0 = w_0c + w_0d,
      w_0_error = ksl_sum_error(w_0c, w_0d, w_0), w_0_lo1 = w_0_error + w_0c_lo,
      w_0_lo = w_0_lo1 + w_0d_lo;
  const double w_1a = D->m10 * c->m0, w_1a_lo = ksl_product_error(D->m10, c->m0, w_1a),
      w_1b = D->m11 * c->m1, w_1b_lo = ksl_product_error(D->m11, c->m1, w_1b), w_1c = w_1a + w_1b,
      w_1c_error = ksl_sum_error(w_1a, w_1b, w_1c), w_1c_lo1 = w_1c_error + w_1a_lo,
      w_1c_lo = w_1c_lo1 + w_1b_lo, w_1d = D->m12 * c->m2,
      w_1d_lo = ksl_product_error(D->m12, c->m2, w_1d), w_1 = w_1c + w_1d,
      w_1_error = ksl_sum_error(w_1c, w_1d, w_1), w_1_lo1 = w_1_error + w_1c_lo,
      w_1_lo = w_1_lo1 + w_1d_lo;
  const double w_2a = D->m20 * c->m0, w_2a_lo = ksl_product_error(D->m20, c->m0, w_2a),
      w_2b = D->m21 * c->m1, w_2b_lo = ksl_product_error(D->m21, c->m1, w_2b), w_2c = w_2a + w_2b,
      w_2c_error = ksl_sum_error(w_2a, w_2b, w_2c), w_2c_lo1 = w_2c_error + w_2a_lo,
      w_2c_lo = w_2c_lo1 + w_2b_lo, w_2d = D->m22 * c->m2,
      w_2d_lo = ksl_product_error(D->m22, c->m2, w_2d), w_2 = w_2c + w_2d,
      w_2_error = ksl_sum_error(w_2c, w_2d, w_2), w_2_lo1 = w_2_error + w_2c_lo,
      w_2_lo = w_2_lo1 + w_2d_lo;
  const double w_3a = D->m00 * c->m3, w_3a_lo = ksl_product_error(D->m00, c->m3, w_3a),
      w_3b = D->m01 * c->m4, w_3b_lo = ksl_product_error(D->m01, c->m4, w_3b), w_3 = w_3a + w_3b,
      w_3_error = ksl_sum_error(w_3a, w_3b, w_3), w_3_lo1 = w_3_error + w_3a_lo,
      w_3_lo = w_3_lo1 + w_3b_lo;
  const double w_4a = D->m10 * c->m3, w_4a_lo = ksl_product_error(D->m10, c->m3, w_4a),
      w_4b = D->m11 * c->m4, w_4b_lo = ksl_product_error(D->m11, c->m4, w_4b), w_4 = w_4a + w_4b,
      w_4_error = ksl_sum_error(w_4a, w_4b, w_4), w_4_lo1 = w_4_error + w_4a_lo,
      w_4_lo = w_4_lo1 + w_4b_lo;
  const double w_5a = D->m20 * c->m3, w_5a_lo = ksl_product_error(D->m20, c->m3, w_5a),
      w_5b = D->m21 * c->m4, w_5b_lo = ksl_product_error(D->m21, c->m4, w_5b), w_5 = w_5a + w_5b,
      w_5_error = ksl_sum_error(w_5a, w_5b, w_5), w_5_lo1 = w_5_error + w_5a_lo,
      w_5_lo = w_5_lo1 + w_5b_lo;
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3c = co_3a - co_3b, co_3c_error = ksl_difference_error(co_3a, co_3b, co_3c),
      co_3c_lo1 = co_3c_error + co_3a_lo, co_3c_lo = co_3c_lo1 - co_3b_lo, co_3 = co_3c + w_3,
      co_3_error = ksl_sum_error(co_3c, w_3, co_3), co_3_lo1 = co_3_error + co_3c_lo,
      co_3_lo = co_3_lo1 + w_3_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4c = co_4a - co_4b, co_4c_error = ksl_difference_error(co_4a, co_4b, co_4c),
      co_4c_lo1 = co_4c_error + co_4a_lo, co_4c_lo = co_4c_lo1 - co_4b_lo, co_4 = co_4c + w_4,
      co_4_error = ksl_sum_error(co_4c, w_4, co_4), co_4_lo1 = co_4_error + co_4c_lo,
      co_4_lo = co_4_lo1 + w_4_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5c = co_5a - co_5b, co_5c_error = ksl_difference_error(co_5a, co_5b, co_5c),
      co_5c_lo1 = co_5c_error + co_5a_lo, co_5c_lo = co_5c_lo1 - co_5b_lo, co_5 = co_5c + w_5,
      co_5_error = ksl_sum_error(co_5c, w_5, co_5), co_5_lo1 = co_5_error + co_5c_lo,
      co_5_lo = co_5_lo1 + w_5_lo;
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
   15 mul, 21 add, 9 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m00 * c->m0, w_0_lo = ksl_product_error(D->m00, c->m0, w_0);
  const double w_1 = D->m10 * c->m0, w_1_lo = ksl_product_error(D->m10, c->m0, w_1);
  const double w_2 = D->m20 * c->m0, w_2_lo = ksl_product_error(D->m20, c->m0, w_2);
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   15 mul, 21 add, 9 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m01 * c->m1, w_0_lo = ksl_product_error(D->m01, c->m1, w_0);
  const double w_1 = D->m11 * c->m1, w_1_lo = ksl_product_error(D->m11, c->m1, w_1);
  const double w_2 = D->m21 * c->m1, w_2_lo = ksl_product_error(D->m21, c->m1, w_2);
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
   15 mul, 21 add, 9 product error, 3 sum error.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = D->m02 * c->m2, w_0_lo = ksl_product_error(D->m02, c->m2, w_0);
  const double w_1 = D->m12 * c->m2, w_1_lo = ksl_product_error(D->m12, c->m2, w_1);
  const double w_2 = D->m22 * c->m2, w_2_lo = ksl_product_error(D->m22, c->m2, w_2);
  const double co_3a = D->m13 * w_2, co_3a_cross1 = D->m13 * w_2_lo,
      co_3a_error = ksl_product_error(D->m13, w_2, co_3a), co_3a_lo = co_3a_error + co_3a_cross1,
      co_3b = D->m23 * w_1, co_3b_cross1 = D->m23 * w_1_lo,
      co_3b_error = ksl_product_error(D->m23, w_1, co_3b), co_3b_lo = co_3b_error + co_3b_cross1,
      co_3 = co_3a - co_3b, co_3_error = ksl_difference_error(co_3a, co_3b, co_3),
      co_3_lo1 = co_3_error + co_3a_lo, co_3_lo = co_3_lo1 - co_3b_lo;
  const double co_4a = D->m23 * w_0, co_4a_cross1 = D->m23 * w_0_lo,
      co_4a_error = ksl_product_error(D->m23, w_0, co_4a), co_4a_lo = co_4a_error + co_4a_cross1,
      co_4b = D->m03 * w_2, co_4b_cross1 = D->m03 * w_2_lo,
      co_4b_error = ksl_product_error(D->m03, w_2, co_4b), co_4b_lo = co_4b_error + co_4b_cross1,
      co_4 = co_4a - co_4b, co_4_error = ksl_difference_error(co_4a, co_4b, co_4),
      co_4_lo1 = co_4_error + co_4a_lo, co_4_lo = co_4_lo1 - co_4b_lo;
  const double co_5a = D->m03 * w_1, co_5a_cross1 = D->m03 * w_1_lo,
      co_5a_error = ksl_product_error(D->m03, w_1, co_5a), co_5a_lo = co_5a_error + co_5a_cross1,
      co_5b = D->m13 * w_0, co_5b_cross1 = D->m13 * w_0_lo,
      co_5b_error = ksl_product_error(D->m13, w_0, co_5b), co_5b_lo = co_5b_error + co_5b_cross1,
      co_5 = co_5a - co_5b, co_5_error = ksl_difference_error(co_5a, co_5b, co_5),
      co_5_lo1 = co_5_error + co_5a_lo, co_5_lo = co_5_lo1 - co_5b_lo;
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
  const double w_3 = D->m00 * c->m3, w_3_lo = ksl_product_error(D->m00, c->m3, w_3);
  const double w_4 = D->m10 * c->m3, w_4_lo = ksl_product_error(D->m10, c->m3, w_4);
  const double w_5 = D->m20 * c->m3, w_5_lo = ksl_product_error(D->m20, c->m3, w_5);
  const double w_3_rounded = w_3 + w_3_lo;
  const double w_4_rounded = w_4 + w_4_lo;
  const double w_5_rounded = w_5 + w_5_lo;
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
  const double w_3 = D->m01 * c->m4, w_3_lo = ksl_product_error(D->m01, c->m4, w_3);
  const double w_4 = D->m11 * c->m4, w_4_lo = ksl_product_error(D->m11, c->m4, w_4);
  const double w_5 = D->m21 * c->m4, w_5_lo = ksl_product_error(D->m21, c->m4, w_5);
  const double w_3_rounded = w_3 + w_3_lo;
  const double w_4_rounded = w_4 + w_4_lo;
  const double w_5_rounded = w_5 + w_5_lo;
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
  const double w_3 = D->m02 * c->m5, w_3_lo = ksl_product_error(D->m02, c->m5, w_3);
  const double w_4 = D->m12 * c->m5, w_4_lo = ksl_product_error(D->m12, c->m5, w_4);
  const double w_5 = D->m22 * c->m5, w_5_lo = ksl_product_error(D->m22, c->m5, w_5);
  const double w_3_rounded = w_3 + w_3_lo;
  const double w_4_rounded = w_4 + w_4_lo;
  const double w_5_rounded = w_5 + w_5_lo;
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

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline float ksl_coscrewf_norm_accurate(const ksl_coscrewf_t *ci) {
  const double small_a = fabs((double)ci->m2),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)ci->m1),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)ci->m0),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)ci->m3 : (double)ci->m0;
  const double p_1 = small == 1.0 ? (double)ci->m4 : (double)ci->m1;
  const double p_2 = small == 1.0 ? (double)ci->m5 : (double)ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r = 1.0 < s ? 7.888609052210118e-31 : r_b;
  const double norm = n * r;
  return (float)norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrewf_normalize_accurate(ksl_coscrewf_t *self) {
  const double small_a = fabs((double)self->m2),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)self->m1),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)self->m0),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)self->m3 : (double)self->m0;
  const double p_1 = small == 1.0 ? (double)self->m4 : (double)self->m1;
  const double p_2 = small == 1.0 ? (double)self->m5 : (double)self->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)self->m0 * up;
  const double enlarged_1 = (double)self->m1 * up;
  const double enlarged_2 = (double)self->m2 * up;
  const double enlarged_3 = (double)self->m3 * up;
  const double enlarged_4 = (double)self->m4 * up;
  const double enlarged_5 = (double)self->m5 * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double quotient_4 = enlarged_4 / divisor;
  const double quotient_5 = enlarged_5 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  const double self_3_new = quotient_3 * down;
  const double self_4_new = quotient_4 * down;
  const double self_5_new = quotient_5 * down;
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrewf_normalized_accurate(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double small_a = fabs((double)ci->m2),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)ci->m1),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)ci->m0),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)ci->m3 : (double)ci->m0;
  const double p_1 = small == 1.0 ? (double)ci->m4 : (double)ci->m1;
  const double p_2 = small == 1.0 ? (double)ci->m5 : (double)ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s = s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)ci->m0 * up;
  const double enlarged_1 = (double)ci->m1 * up;
  const double enlarged_2 = (double)ci->m2 * up;
  const double enlarged_3 = (double)ci->m3 * up;
  const double enlarged_4 = (double)ci->m4 * up;
  const double enlarged_5 = (double)ci->m5 * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double quotient_4 = enlarged_4 / divisor;
  const double quotient_5 = enlarged_5 / divisor;
  const double co_0 = quotient_0 * down;
  const double co_1 = quotient_1 * down;
  const double co_2 = quotient_2 * down;
  const double co_3 = quotient_3 * down;
  const double co_4 = quotient_4 * down;
  const double co_5 = quotient_5 * down;
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

/* Quaternions q = (w; v): products, rotations, conversions, interpolation.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_QUATERNION_ACCURATE_H
#define KSL_QUATERNION_ACCURATE_H


/* self = a self.
   self: quaternion (w; x, y, z), the scalar first; a: number.
   4 mul, 4 add, 4 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternion_scale_accurate(ksl_quaternion_t *self, const double a) {
  const double self_0_new = self->w * a, self_0_new_lo = ksl_product_error(self->w, a, self_0_new);
  const double self_1_new = self->x * a, self_1_new_lo = ksl_product_error(self->x, a, self_1_new);
  const double self_2_new = self->y * a, self_2_new_lo = ksl_product_error(self->y, a, self_2_new);
  const double self_3_new = self->z * a, self_3_new_lo = ksl_product_error(self->z, a, self_3_new);
  const double self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_rounded = self_3_new + self_3_new_lo;
  self->w = self_0_new_rounded;
  self->x = self_1_new_rounded;
  self->y = self_2_new_rounded;
  self->z = self_3_new_rounded;
}

/* |q| = sqrt(w^2 + v·v).
   q: quaternion (w; x, y, z), the scalar first.
   12 mul, 19 add, 5 product error, 3 sum error, 2 div, 1 sqrt, 4 abs, 7 less, 3 equal, 10
     select. */
static inline double ksl_quaternion_norm_accurate(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->w);
  const double s_size_1 = fabs(q->x);
  const double s_size_2 = fabs(q->y);
  const double s_size_3 = fabs(q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->w * s;
  const double y_1 = q->x * s;
  const double y_2 = q->y * s;
  const double y_3 = q->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n = sqrt(n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm_total = n + n_lo, norm_added = norm_total - n,
      norm_remaining = n_lo - norm_added, norm = norm_total * r, norm_inverse = 1.0 / r,
      norm_back = norm * norm_inverse, norm_lost = norm_total - norm_back,
      norm_rest = norm_lost + norm_remaining, norm_small = norm_rest * r,
      norm_lo = norm_lost == 0.0 ? 0.0 : norm_small;
  const double norm_total = norm + norm_lo,
      norm_rounded = norm_total == norm_total ? norm_total : norm;
  return norm_rounded;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (w; x, y, z), the scalar first.
   33 mul, 49 add, 9 product error, 3 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
     select. */
static inline void ksl_quaternion_normalize_accurate(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->w);
  const double s_size_1 = fabs(self->x);
  const double s_size_2 = fabs(self->y);
  const double s_size_3 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = self->w * s;
  const double y_1 = self->x * s;
  const double y_2 = self->y * s;
  const double y_3 = self->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n = sqrt(n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = self->w * up;
  const double enlarged_1 = self->x * up;
  const double enlarged_2 = self->y * up;
  const double enlarged_3 = self->z * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double self_0_new_total = quotient_0 + quotient_0_lo,
      self_0_new_added = self_0_new_total - quotient_0,
      self_0_new_remaining = quotient_0_lo - self_0_new_added, self_0_new = self_0_new_total * down,
      self_0_new_inverse = 1.0 / down, self_0_new_back = self_0_new * self_0_new_inverse,
      self_0_new_lost = self_0_new_total - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_remaining,
      self_0_new_small = self_0_new_rest * down,
      self_0_new_lo = self_0_new_lost == 0.0 ? 0.0 : self_0_new_small;
  const double self_1_new_total = quotient_1 + quotient_1_lo,
      self_1_new_added = self_1_new_total - quotient_1,
      self_1_new_remaining = quotient_1_lo - self_1_new_added, self_1_new = self_1_new_total * down,
      self_1_new_back = self_1_new * self_0_new_inverse,
      self_1_new_lost = self_1_new_total - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_remaining,
      self_1_new_small = self_1_new_rest * down,
      self_1_new_lo = self_1_new_lost == 0.0 ? 0.0 : self_1_new_small;
  const double self_2_new_total = quotient_2 + quotient_2_lo,
      self_2_new_added = self_2_new_total - quotient_2,
      self_2_new_remaining = quotient_2_lo - self_2_new_added, self_2_new = self_2_new_total * down,
      self_2_new_back = self_2_new * self_0_new_inverse,
      self_2_new_lost = self_2_new_total - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_remaining,
      self_2_new_small = self_2_new_rest * down,
      self_2_new_lo = self_2_new_lost == 0.0 ? 0.0 : self_2_new_small;
  const double self_3_new_total = quotient_3 + quotient_3_lo,
      self_3_new_added = self_3_new_total - quotient_3,
      self_3_new_remaining = quotient_3_lo - self_3_new_added, self_3_new = self_3_new_total * down,
      self_3_new_back = self_3_new * self_0_new_inverse,
      self_3_new_lost = self_3_new_total - self_3_new_back,
      self_3_new_rest = self_3_new_lost + self_3_new_remaining,
      self_3_new_small = self_3_new_rest * down,
      self_3_new_lo = self_3_new_lost == 0.0 ? 0.0 : self_3_new_small;
  const double self_0_new_total = self_0_new + self_0_new_lo,
      self_0_new_rounded = self_0_new_total == self_0_new_total ? self_0_new_total : self_0_new;
  const double self_1_new_total = self_1_new + self_1_new_lo,
      self_1_new_rounded = self_1_new_total == self_1_new_total ? self_1_new_total : self_1_new;
  const double self_2_new_total = self_2_new + self_2_new_lo,
      self_2_new_rounded = self_2_new_total == self_2_new_total ? self_2_new_total : self_2_new;
  const double self_3_new_total = self_3_new + self_3_new_lo,
      self_3_new_rounded = self_3_new_total == self_3_new_total ? self_3_new_total : self_3_new;
  self->w = self_0_new_rounded;
  self->x = self_1_new_rounded;
  self->y = self_2_new_rounded;
  self->z = self_3_new_rounded;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (w; x, y, z), the scalar first.
   33 mul, 49 add, 9 product error, 3 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
     select. */
static inline void ksl_quaternion_normalized_accurate(const ksl_quaternion_t *q,
    ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->w);
  const double s_size_1 = fabs(q->x);
  const double s_size_2 = fabs(q->y);
  const double s_size_3 = fabs(q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->w * s;
  const double y_1 = q->x * s;
  const double y_2 = q->y * s;
  const double y_3 = q->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n = sqrt(n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = q->w * up;
  const double enlarged_1 = q->x * up;
  const double enlarged_2 = q->y * up;
  const double enlarged_3 = q->z * up;
  const double quotient_0 = enlarged_0 / divisor, quotient_0_cross = quotient_0 * divisor_lo,
      quotient_0_product = quotient_0 * divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / divisor;
  const double quotient_1 = enlarged_1 / divisor, quotient_1_cross = quotient_1 * divisor_lo,
      quotient_1_product = quotient_1 * divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / divisor;
  const double quotient_2 = enlarged_2 / divisor, quotient_2_cross = quotient_2 * divisor_lo,
      quotient_2_product = quotient_2 * divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / divisor;
  const double quotient_3 = enlarged_3 / divisor, quotient_3_cross = quotient_3 * divisor_lo,
      quotient_3_product = quotient_3 * divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / divisor;
  const double qo_0_total = quotient_0 + quotient_0_lo, qo_0_added = qo_0_total - quotient_0,
      qo_0_remaining = quotient_0_lo - qo_0_added, qo_0 = qo_0_total * down,
      qo_0_inverse = 1.0 / down, qo_0_back = qo_0 * qo_0_inverse,
      qo_0_lost = qo_0_total - qo_0_back, qo_0_rest = qo_0_lost + qo_0_remaining,
      qo_0_small = qo_0_rest * down, qo_0_lo = qo_0_lost == 0.0 ? 0.0 : qo_0_small;
  const double qo_1_total = quotient_1 + quotient_1_lo, qo_1_added = qo_1_total - quotient_1,
      qo_1_remaining = quotient_1_lo - qo_1_added, qo_1 = qo_1_total * down,
      qo_1_back = qo_1 * qo_0_inverse, qo_1_lost = qo_1_total - qo_1_back,
      qo_1_rest = qo_1_lost + qo_1_remaining, qo_1_small = qo_1_rest * down,
      qo_1_lo = qo_1_lost == 0.0 ? 0.0 : qo_1_small;
  const double qo_2_total = quotient_2 + quotient_2_lo, qo_2_added = qo_2_total - quotient_2,
      qo_2_remaining = quotient_2_lo - qo_2_added, qo_2 = qo_2_total * down,
      qo_2_back = qo_2 * qo_0_inverse, qo_2_lost = qo_2_total - qo_2_back,
      qo_2_rest = qo_2_lost + qo_2_remaining, qo_2_small = qo_2_rest * down,
      qo_2_lo = qo_2_lost == 0.0 ? 0.0 : qo_2_small;
  const double qo_3_total = quotient_3 + quotient_3_lo, qo_3_added = qo_3_total - quotient_3,
      qo_3_remaining = quotient_3_lo - qo_3_added, qo_3 = qo_3_total * down,
      qo_3_back = qo_3 * qo_0_inverse, qo_3_lost = qo_3_total - qo_3_back,
      qo_3_rest = qo_3_lost + qo_3_remaining, qo_3_small = qo_3_rest * down,
      qo_3_lo = qo_3_lost == 0.0 ? 0.0 : qo_3_small;
  const double qo_0_total = qo_0 + qo_0_lo,
      qo_0_rounded = qo_0_total == qo_0_total ? qo_0_total : qo_0;
  const double qo_1_total = qo_1 + qo_1_lo,
      qo_1_rounded = qo_1_total == qo_1_total ? qo_1_total : qo_1;
  const double qo_2_total = qo_2 + qo_2_lo,
      qo_2_rounded = qo_2_total == qo_2_total ? qo_2_total : qo_2;
  const double qo_3_total = qo_3 + qo_3_lo,
      qo_3_rounded = qo_3_total == qo_3_total ? qo_3_total : qo_3;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1 q2 = (w1 w2 - v1·v2; w1 v2 + w2 v1 + v1 × v2).
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qq_accurate(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a - qo_0f,
      qo_0_error = ksl_difference_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 - qo_0f_lo;
  const double qo_1a = q1->w * q2->x, qo_1a_lo = ksl_product_error(q1->w, q2->x, qo_1a),
      qo_1b = q1->x * q2->w, qo_1b_lo = ksl_product_error(q1->x, q2->w, qo_1b),
      qo_1c = qo_1a + qo_1b, qo_1c_error = ksl_sum_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 + qo_1b_lo, qo_1d = q1->y * q2->z,
      qo_1d_lo = ksl_product_error(q1->y, q2->z, qo_1d), qo_1e = q1->z * q2->y,
      qo_1e_lo = ksl_product_error(q1->z, q2->y, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->w * q2->y, qo_2a_lo = ksl_product_error(q1->w, q2->y, qo_2a),
      qo_2b = q1->z * q2->x, qo_2b_lo = ksl_product_error(q1->z, q2->x, qo_2b),
      qo_2c = q1->x * q2->z, qo_2c_lo = ksl_product_error(q1->x, q2->z, qo_2c),
      qo_2d = qo_2b - qo_2c, qo_2d_error = ksl_difference_error(qo_2b, qo_2c, qo_2d),
      qo_2d_lo1 = qo_2d_error + qo_2b_lo, qo_2d_lo = qo_2d_lo1 - qo_2c_lo, qo_2e = qo_2a + qo_2d,
      qo_2e_error = ksl_sum_error(qo_2a, qo_2d, qo_2e), qo_2e_lo1 = qo_2e_error + qo_2a_lo,
      qo_2e_lo = qo_2e_lo1 + qo_2d_lo, qo_2f = q1->y * q2->w,
      qo_2f_lo = ksl_product_error(q1->y, q2->w, qo_2f), qo_2 = qo_2e + qo_2f,
      qo_2_error = ksl_sum_error(qo_2e, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2e_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->w * q2->z, qo_3a_lo = ksl_product_error(q1->w, q2->z, qo_3a),
      qo_3b = q1->x * q2->y, qo_3b_lo = ksl_product_error(q1->x, q2->y, qo_3b),
      qo_3c = q1->y * q2->x, qo_3c_lo = ksl_product_error(q1->y, q2->x, qo_3c),
      qo_3d = qo_3b - qo_3c, qo_3d_error = ksl_difference_error(qo_3b, qo_3c, qo_3d),
      qo_3d_lo1 = qo_3d_error + qo_3b_lo, qo_3d_lo = qo_3d_lo1 - qo_3c_lo, qo_3e = qo_3a + qo_3d,
      qo_3e_error = ksl_sum_error(qo_3a, qo_3d, qo_3e), qo_3e_lo1 = qo_3e_error + qo_3a_lo,
      qo_3e_lo = qo_3e_lo1 + qo_3d_lo, qo_3f = q1->z * q2->w,
      qo_3f_lo = ksl_product_error(q1->z, q2->w, qo_3f), qo_3 = qo_3e + qo_3f,
      qo_3_error = ksl_sum_error(qo_3e, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3e_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjq_accurate(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a + qo_0f,
      qo_0_error = ksl_sum_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 + qo_0f_lo;
  const double qo_1a = q1->w * q2->x, qo_1a_lo = ksl_product_error(q1->w, q2->x, qo_1a),
      qo_1b = q1->x * q2->w, qo_1b_lo = ksl_product_error(q1->x, q2->w, qo_1b),
      qo_1c = qo_1a - qo_1b, qo_1c_error = ksl_difference_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 - qo_1b_lo, qo_1d = q1->z * q2->y,
      qo_1d_lo = ksl_product_error(q1->z, q2->y, qo_1d), qo_1e = q1->y * q2->z,
      qo_1e_lo = ksl_product_error(q1->y, q2->z, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->w * q2->y, qo_2a_lo = ksl_product_error(q1->w, q2->y, qo_2a),
      qo_2b = q1->y * q2->w, qo_2b_lo = ksl_product_error(q1->y, q2->w, qo_2b),
      qo_2c = qo_2a - qo_2b, qo_2c_error = ksl_difference_error(qo_2a, qo_2b, qo_2c),
      qo_2c_lo1 = qo_2c_error + qo_2a_lo, qo_2c_lo = qo_2c_lo1 - qo_2b_lo, qo_2d = q1->x * q2->z,
      qo_2d_lo = ksl_product_error(q1->x, q2->z, qo_2d), qo_2e = q1->z * q2->x,
      qo_2e_lo = ksl_product_error(q1->z, q2->x, qo_2e), qo_2f = qo_2d - qo_2e,
      qo_2f_error = ksl_difference_error(qo_2d, qo_2e, qo_2f), qo_2f_lo1 = qo_2f_error + qo_2d_lo,
      qo_2f_lo = qo_2f_lo1 - qo_2e_lo, qo_2 = qo_2c + qo_2f,
      qo_2_error = ksl_sum_error(qo_2c, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2c_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->w * q2->z, qo_3a_lo = ksl_product_error(q1->w, q2->z, qo_3a),
      qo_3b = q1->z * q2->w, qo_3b_lo = ksl_product_error(q1->z, q2->w, qo_3b),
      qo_3c = qo_3a - qo_3b, qo_3c_error = ksl_difference_error(qo_3a, qo_3b, qo_3c),
      qo_3c_lo1 = qo_3c_error + qo_3a_lo, qo_3c_lo = qo_3c_lo1 - qo_3b_lo, qo_3d = q1->y * q2->x,
      qo_3d_lo = ksl_product_error(q1->y, q2->x, qo_3d), qo_3e = q1->x * q2->y,
      qo_3e_lo = ksl_product_error(q1->x, q2->y, qo_3e), qo_3f = qo_3d - qo_3e,
      qo_3f_error = ksl_difference_error(qo_3d, qo_3e, qo_3f), qo_3f_lo1 = qo_3f_error + qo_3d_lo,
      qo_3f_lo = qo_3f_lo1 - qo_3e_lo, qo_3 = qo_3c + qo_3f,
      qo_3_error = ksl_sum_error(qo_3c, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3c_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconj_accurate(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a + qo_0f,
      qo_0_error = ksl_sum_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 + qo_0f_lo;
  const double qo_1a = q1->x * q2->w, qo_1a_lo = ksl_product_error(q1->x, q2->w, qo_1a),
      qo_1b = q1->w * q2->x, qo_1b_lo = ksl_product_error(q1->w, q2->x, qo_1b),
      qo_1c = qo_1a - qo_1b, qo_1c_error = ksl_difference_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 - qo_1b_lo, qo_1d = q1->z * q2->y,
      qo_1d_lo = ksl_product_error(q1->z, q2->y, qo_1d), qo_1e = q1->y * q2->z,
      qo_1e_lo = ksl_product_error(q1->y, q2->z, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->y * q2->w, qo_2a_lo = ksl_product_error(q1->y, q2->w, qo_2a),
      qo_2b = q1->w * q2->y, qo_2b_lo = ksl_product_error(q1->w, q2->y, qo_2b),
      qo_2c = qo_2a - qo_2b, qo_2c_error = ksl_difference_error(qo_2a, qo_2b, qo_2c),
      qo_2c_lo1 = qo_2c_error + qo_2a_lo, qo_2c_lo = qo_2c_lo1 - qo_2b_lo, qo_2d = q1->x * q2->z,
      qo_2d_lo = ksl_product_error(q1->x, q2->z, qo_2d), qo_2e = q1->z * q2->x,
      qo_2e_lo = ksl_product_error(q1->z, q2->x, qo_2e), qo_2f = qo_2d - qo_2e,
      qo_2f_error = ksl_difference_error(qo_2d, qo_2e, qo_2f), qo_2f_lo1 = qo_2f_error + qo_2d_lo,
      qo_2f_lo = qo_2f_lo1 - qo_2e_lo, qo_2 = qo_2c + qo_2f,
      qo_2_error = ksl_sum_error(qo_2c, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2c_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->z * q2->w, qo_3a_lo = ksl_product_error(q1->z, q2->w, qo_3a),
      qo_3b = q1->w * q2->z, qo_3b_lo = ksl_product_error(q1->w, q2->z, qo_3b),
      qo_3c = qo_3a - qo_3b, qo_3c_error = ksl_difference_error(qo_3a, qo_3b, qo_3c),
      qo_3c_lo1 = qo_3c_error + qo_3a_lo, qo_3c_lo = qo_3c_lo1 - qo_3b_lo, qo_3d = q1->y * q2->x,
      qo_3d_lo = ksl_product_error(q1->y, q2->x, qo_3d), qo_3e = q1->x * q2->y,
      qo_3e_lo = ksl_product_error(q1->x, q2->y, qo_3e), qo_3f = qo_3d - qo_3e,
      qo_3f_error = ksl_difference_error(qo_3d, qo_3e, qo_3f), qo_3f_lo1 = qo_3f_error + qo_3d_lo,
      qo_3f_lo = qo_3f_lo1 - qo_3e_lo, qo_3 = qo_3c + qo_3f,
      qo_3_error = ksl_sum_error(qo_3c, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3c_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   30 mul, 48 add, 18 product error, 12 sum error.
   Error <= u |result| + 40 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = q->y * v->z, c_0a_lo = ksl_product_error(q->y, v->z, c_0a),
      c_0b = q->z * v->y, c_0b_lo = ksl_product_error(q->z, v->y, c_0b), c_0 = c_0a - c_0b,
      c_0_error = ksl_difference_error(c_0a, c_0b, c_0), c_0_lo1 = c_0_error + c_0a_lo,
      c_0_lo = c_0_lo1 - c_0b_lo;
  const double c_1a = q->z * v->x, c_1a_lo = ksl_product_error(q->z, v->x, c_1a),
      c_1b = q->x * v->z, c_1b_lo = ksl_product_error(q->x, v->z, c_1b), c_1 = c_1a - c_1b,
      c_1_error = ksl_difference_error(c_1a, c_1b, c_1), c_1_lo1 = c_1_error + c_1a_lo,
      c_1_lo = c_1_lo1 - c_1b_lo;
  const double c_2a = q->x * v->y, c_2a_lo = ksl_product_error(q->x, v->y, c_2a),
      c_2b = q->y * v->x, c_2b_lo = ksl_product_error(q->y, v->x, c_2b), c_2 = c_2a - c_2b,
      c_2_error = ksl_difference_error(c_2a, c_2b, c_2), c_2_lo1 = c_2_error + c_2a_lo,
      c_2_lo = c_2_lo1 - c_2b_lo;
  const double t_0 = 2.0 * c_0, t_0_cross1 = 2.0 * c_0_lo,
      t_0_error = ksl_product_error(2.0, c_0, t_0), t_0_lo = t_0_error + t_0_cross1;
  const double t_1 = 2.0 * c_1, t_1_cross1 = 2.0 * c_1_lo,
      t_1_error = ksl_product_error(2.0, c_1, t_1), t_1_lo = t_1_error + t_1_cross1;
  const double t_2 = 2.0 * c_2, t_2_cross1 = 2.0 * c_2_lo,
      t_2_error = ksl_product_error(2.0, c_2, t_2), t_2_lo = t_2_error + t_2_cross1;
  const double turn_0a = q->w * t_0, turn_0a_cross1 = q->w * t_0_lo,
      turn_0a_error = ksl_product_error(q->w, t_0, turn_0a),
      turn_0a_lo = turn_0a_error + turn_0a_cross1, turn_0b = q->y * t_2,
      turn_0b_cross1 = q->y * t_2_lo, turn_0b_error = ksl_product_error(q->y, t_2, turn_0b),
      turn_0b_lo = turn_0b_error + turn_0b_cross1, turn_0c = q->z * t_1,
      turn_0c_cross1 = q->z * t_1_lo, turn_0c_error = ksl_product_error(q->z, t_1, turn_0c),
      turn_0c_lo = turn_0c_error + turn_0c_cross1, turn_0d = turn_0b - turn_0c,
      turn_0d_error = ksl_difference_error(turn_0b, turn_0c, turn_0d),
      turn_0d_lo1 = turn_0d_error + turn_0b_lo, turn_0d_lo = turn_0d_lo1 - turn_0c_lo,
      turn_0 = turn_0a + turn_0d, turn_0_error = ksl_sum_error(turn_0a, turn_0d, turn_0),
      turn_0_lo1 = turn_0_error + turn_0a_lo, turn_0_lo = turn_0_lo1 + turn_0d_lo;
  const double turn_1a = q->w * t_1, turn_1a_cross1 = q->w * t_1_lo,
      turn_1a_error = ksl_product_error(q->w, t_1, turn_1a),
      turn_1a_lo = turn_1a_error + turn_1a_cross1, turn_1b = q->z * t_0,
      turn_1b_cross1 = q->z * t_0_lo, turn_1b_error = ksl_product_error(q->z, t_0, turn_1b),
      turn_1b_lo = turn_1b_error + turn_1b_cross1, turn_1c = q->x * t_2,
      turn_1c_cross1 = q->x * t_2_lo, turn_1c_error = ksl_product_error(q->x, t_2, turn_1c),
      turn_1c_lo = turn_1c_error + turn_1c_cross1, turn_1d = turn_1b - turn_1c,
      turn_1d_error = ksl_difference_error(turn_1b, turn_1c, turn_1d),
      turn_1d_lo1 = turn_1d_error + turn_1b_lo, turn_1d_lo = turn_1d_lo1 - turn_1c_lo,
      turn_1 = turn_1a + turn_1d, turn_1_error = ksl_sum_error(turn_1a, turn_1d, turn_1),
      turn_1_lo1 = turn_1_error + turn_1a_lo, turn_1_lo = turn_1_lo1 + turn_1d_lo;
  const double turn_2a = q->w * t_2, turn_2a_cross1 = q->w * t_2_lo,
      turn_2a_error = ksl_product_error(q->w, t_2, turn_2a),
      turn_2a_lo = turn_2a_error + turn_2a_cross1, turn_2b = q->x * t_1,
      turn_2b_cross1 = q->x * t_1_lo, turn_2b_error = ksl_product_error(q->x, t_1, turn_2b),
      turn_2b_lo = turn_2b_error + turn_2b_cross1, turn_2c = q->y * t_0,
      turn_2c_cross1 = q->y * t_0_lo, turn_2c_error = ksl_product_error(q->y, t_0, turn_2c),
      turn_2c_lo = turn_2c_error + turn_2c_cross1, turn_2d = turn_2b - turn_2c,
      turn_2d_error = ksl_difference_error(turn_2b, turn_2c, turn_2d),
      turn_2d_lo1 = turn_2d_error + turn_2b_lo, turn_2d_lo = turn_2d_lo1 - turn_2c_lo,
      turn_2 = turn_2a + turn_2d, turn_2_error = ksl_sum_error(turn_2a, turn_2d, turn_2),
      turn_2_lo1 = turn_2_error + turn_2a_lo, turn_2_lo = turn_2_lo1 + turn_2d_lo;
  const double vo_0 = v->x + turn_0, vo_0_error = ksl_sum_error(v->x, turn_0, vo_0),
      vo_0_lo = vo_0_error + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_error = ksl_sum_error(v->y, turn_1, vo_1),
      vo_1_lo = vo_1_error + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_error = ksl_sum_error(v->z, turn_2, vo_2),
      vo_2_lo = vo_2_error + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   30 mul, 48 add, 18 product error, 12 sum error.
   Error <= u |result| + 40 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = q->z * v->y, c_0a_lo = ksl_product_error(q->z, v->y, c_0a),
      c_0b = q->y * v->z, c_0b_lo = ksl_product_error(q->y, v->z, c_0b), c_0 = c_0a - c_0b,
      c_0_error = ksl_difference_error(c_0a, c_0b, c_0), c_0_lo1 = c_0_error + c_0a_lo,
      c_0_lo = c_0_lo1 - c_0b_lo;
  const double c_1a = q->x * v->z, c_1a_lo = ksl_product_error(q->x, v->z, c_1a),
      c_1b = q->z * v->x, c_1b_lo = ksl_product_error(q->z, v->x, c_1b), c_1 = c_1a - c_1b,
      c_1_error = ksl_difference_error(c_1a, c_1b, c_1), c_1_lo1 = c_1_error + c_1a_lo,
      c_1_lo = c_1_lo1 - c_1b_lo;
  const double c_2a = q->y * v->x, c_2a_lo = ksl_product_error(q->y, v->x, c_2a),
      c_2b = q->x * v->y, c_2b_lo = ksl_product_error(q->x, v->y, c_2b), c_2 = c_2a - c_2b,
      c_2_error = ksl_difference_error(c_2a, c_2b, c_2), c_2_lo1 = c_2_error + c_2a_lo,
      c_2_lo = c_2_lo1 - c_2b_lo;
  const double t_0 = 2.0 * c_0, t_0_cross1 = 2.0 * c_0_lo,
      t_0_error = ksl_product_error(2.0, c_0, t_0), t_0_lo = t_0_error + t_0_cross1;
  const double t_1 = 2.0 * c_1, t_1_cross1 = 2.0 * c_1_lo,
      t_1_error = ksl_product_error(2.0, c_1, t_1), t_1_lo = t_1_error + t_1_cross1;
  const double t_2 = 2.0 * c_2, t_2_cross1 = 2.0 * c_2_lo,
      t_2_error = ksl_product_error(2.0, c_2, t_2), t_2_lo = t_2_error + t_2_cross1;
  const double turn_0a = q->w * t_0, turn_0a_cross1 = q->w * t_0_lo,
      turn_0a_error = ksl_product_error(q->w, t_0, turn_0a),
      turn_0a_lo = turn_0a_error + turn_0a_cross1, turn_0b = q->z * t_1,
      turn_0b_cross1 = q->z * t_1_lo, turn_0b_error = ksl_product_error(q->z, t_1, turn_0b),
      turn_0b_lo = turn_0b_error + turn_0b_cross1, turn_0c = q->y * t_2,
      turn_0c_cross1 = q->y * t_2_lo, turn_0c_error = ksl_product_error(q->y, t_2, turn_0c),
      turn_0c_lo = turn_0c_error + turn_0c_cross1, turn_0d = turn_0b - turn_0c,
      turn_0d_error = ksl_difference_error(turn_0b, turn_0c, turn_0d),
      turn_0d_lo1 = turn_0d_error + turn_0b_lo, turn_0d_lo = turn_0d_lo1 - turn_0c_lo,
      turn_0 = turn_0a + turn_0d, turn_0_error = ksl_sum_error(turn_0a, turn_0d, turn_0),
      turn_0_lo1 = turn_0_error + turn_0a_lo, turn_0_lo = turn_0_lo1 + turn_0d_lo;
  const double turn_1a = q->w * t_1, turn_1a_cross1 = q->w * t_1_lo,
      turn_1a_error = ksl_product_error(q->w, t_1, turn_1a),
      turn_1a_lo = turn_1a_error + turn_1a_cross1, turn_1b = q->x * t_2,
      turn_1b_cross1 = q->x * t_2_lo, turn_1b_error = ksl_product_error(q->x, t_2, turn_1b),
      turn_1b_lo = turn_1b_error + turn_1b_cross1, turn_1c = q->z * t_0,
      turn_1c_cross1 = q->z * t_0_lo, turn_1c_error = ksl_product_error(q->z, t_0, turn_1c),
      turn_1c_lo = turn_1c_error + turn_1c_cross1, turn_1d = turn_1b - turn_1c,
      turn_1d_error = ksl_difference_error(turn_1b, turn_1c, turn_1d),
      turn_1d_lo1 = turn_1d_error + turn_1b_lo, turn_1d_lo = turn_1d_lo1 - turn_1c_lo,
      turn_1 = turn_1a + turn_1d, turn_1_error = ksl_sum_error(turn_1a, turn_1d, turn_1),
      turn_1_lo1 = turn_1_error + turn_1a_lo, turn_1_lo = turn_1_lo1 + turn_1d_lo;
  const double turn_2a = q->w * t_2, turn_2a_cross1 = q->w * t_2_lo,
      turn_2a_error = ksl_product_error(q->w, t_2, turn_2a),
      turn_2a_lo = turn_2a_error + turn_2a_cross1, turn_2b = q->y * t_0,
      turn_2b_cross1 = q->y * t_0_lo, turn_2b_error = ksl_product_error(q->y, t_0, turn_2b),
      turn_2b_lo = turn_2b_error + turn_2b_cross1, turn_2c = q->x * t_1,
      turn_2c_cross1 = q->x * t_1_lo, turn_2c_error = ksl_product_error(q->x, t_1, turn_2c),
      turn_2c_lo = turn_2c_error + turn_2c_cross1, turn_2d = turn_2b - turn_2c,
      turn_2d_error = ksl_difference_error(turn_2b, turn_2c, turn_2d),
      turn_2d_lo1 = turn_2d_error + turn_2b_lo, turn_2d_lo = turn_2d_lo1 - turn_2c_lo,
      turn_2 = turn_2a + turn_2d, turn_2_error = ksl_sum_error(turn_2a, turn_2d, turn_2),
      turn_2_lo1 = turn_2_error + turn_2a_lo, turn_2_lo = turn_2_lo1 + turn_2d_lo;
  const double vo_0 = v->x + turn_0, vo_0_error = ksl_sum_error(v->x, turn_0, vo_0),
      vo_0_lo = vo_0_error + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_error = ksl_sum_error(v->y, turn_1, vo_1),
      vo_1_lo = vo_1_error + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_error = ksl_sum_error(v->z, turn_2, vo_2),
      vo_2_lo = vo_2_error + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (w; x, y, z), the scalar first; R: rotation or other 3×3 matrix.
   32 mul, 67 add, 18 product error, 15 sum error, 2 div, 9 equal, 9 select. */
static inline void ksl_mat3x3_from_quaternion_accurate(const ksl_quaternion_t *q, ksl_mat3x3_t *R) {
  const double square_a = q->w * q->w, square_a_lo = ksl_product_error(q->w, q->w, square_a),
      square_b = q->x * q->x, square_b_lo = ksl_product_error(q->x, q->x, square_b),
      square_c = square_a + square_b, square_c_error = ksl_sum_error(square_a, square_b, square_c),
      square_c_lo1 = square_c_error + square_a_lo, square_c_lo = square_c_lo1 + square_b_lo,
      square_d = q->y * q->y, square_d_lo = ksl_product_error(q->y, q->y, square_d),
      square_e = square_c + square_d, square_e_error = ksl_sum_error(square_c, square_d, square_e),
      square_e_lo1 = square_e_error + square_c_lo, square_e_lo = square_e_lo1 + square_d_lo,
      square_f = q->z * q->z, square_f_lo = ksl_product_error(q->z, q->z, square_f),
      square = square_e + square_f, square_error = ksl_sum_error(square_e, square_f, square),
      square_lo1 = square_error + square_e_lo, square_lo = square_lo1 + square_f_lo;
  const double scale = 2.0 / square, scale_cross = scale * square_lo,
      scale_product = scale * square,
      scale_product_error = ksl_product_error(scale, square, scale_product),
      scale_rest = 2.0 - scale_product, scale_exact = scale_rest - scale_product_error,
      scale_residual = scale_exact - scale_cross, scale_lo = scale_residual / square;
  const double scale_w = q->w * scale, scale_w_cross1 = q->w * scale_lo,
      scale_w_error = ksl_product_error(q->w, scale, scale_w),
      scale_w_lo = scale_w_error + scale_w_cross1;
  const double beta_v_0 = q->x * scale, beta_v_0_cross1 = q->x * scale_lo,
      beta_v_0_error = ksl_product_error(q->x, scale, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross1;
  const double beta_v_1 = q->y * scale, beta_v_1_cross1 = q->y * scale_lo,
      beta_v_1_error = ksl_product_error(q->y, scale, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross1;
  const double beta_v_2 = q->z * scale, beta_v_2_cross1 = q->z * scale_lo,
      beta_v_2_error = ksl_product_error(q->z, scale, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross1;
  const double m_0 = q->x * beta_v_0, m_0_cross1 = q->x * beta_v_0_lo,
      m_0_error = ksl_product_error(q->x, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross1;
  const double m_1 = q->y * beta_v_1, m_1_cross1 = q->y * beta_v_1_lo,
      m_1_error = ksl_product_error(q->y, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross1;
  const double m_2 = q->z * beta_v_2, m_2_cross1 = q->z * beta_v_2_lo,
      m_2_error = ksl_product_error(q->z, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross1;
  const double m_3 = q->y * beta_v_0, m_3_cross1 = q->y * beta_v_0_lo,
      m_3_error = ksl_product_error(q->y, beta_v_0, m_3), m_3_lo = m_3_error + m_3_cross1;
  const double m_4 = q->z * beta_v_0, m_4_cross1 = q->z * beta_v_0_lo,
      m_4_error = ksl_product_error(q->z, beta_v_0, m_4), m_4_lo = m_4_error + m_4_cross1;
  const double m_5 = q->z * beta_v_1, m_5_cross1 = q->z * beta_v_1_lo,
      m_5_error = ksl_product_error(q->z, beta_v_1, m_5), m_5_lo = m_5_error + m_5_cross1;
  const double others_0 = m_1 + m_2, others_0_error = ksl_sum_error(m_1, m_2, others_0),
      others_0_lo1 = others_0_error + m_1_lo, others_0_lo = others_0_lo1 + m_2_lo;
  const double others_1 = m_0 + m_2, others_1_error = ksl_sum_error(m_0, m_2, others_1),
      others_1_lo1 = others_1_error + m_0_lo, others_1_lo = others_1_lo1 + m_2_lo;
  const double others_2 = m_0 + m_1, others_2_error = ksl_sum_error(m_0, m_1, others_2),
      others_2_lo1 = others_2_error + m_0_lo, others_2_lo = others_2_lo1 + m_1_lo;
  const double alpha_v_0 = q->x * scale_w, alpha_v_0_cross1 = q->x * scale_w_lo,
      alpha_v_0_error = ksl_product_error(q->x, scale_w, alpha_v_0),
      alpha_v_0_lo = alpha_v_0_error + alpha_v_0_cross1;
  const double alpha_v_1 = q->y * scale_w, alpha_v_1_cross1 = q->y * scale_w_lo,
      alpha_v_1_error = ksl_product_error(q->y, scale_w, alpha_v_1),
      alpha_v_1_lo = alpha_v_1_error + alpha_v_1_cross1;
  const double alpha_v_2 = q->z * scale_w, alpha_v_2_cross1 = q->z * scale_w_lo,
      alpha_v_2_error = ksl_product_error(q->z, scale_w, alpha_v_2),
      alpha_v_2_lo = alpha_v_2_error + alpha_v_2_cross1;
  const double R_00 = 1.0 - others_0, R_00_error = ksl_difference_error(1.0, others_0, R_00),
      R_00_lo = R_00_error - others_0_lo;
  const double R_01 = m_3 - alpha_v_2, R_01_error = ksl_difference_error(m_3, alpha_v_2, R_01),
      R_01_lo1 = R_01_error + m_3_lo, R_01_lo = R_01_lo1 - alpha_v_2_lo;
  const double R_02 = m_4 + alpha_v_1, R_02_error = ksl_sum_error(m_4, alpha_v_1, R_02),
      R_02_lo1 = R_02_error + m_4_lo, R_02_lo = R_02_lo1 + alpha_v_1_lo;
  const double R_10 = m_3 + alpha_v_2, R_10_error = ksl_sum_error(m_3, alpha_v_2, R_10),
      R_10_lo1 = R_10_error + m_3_lo, R_10_lo = R_10_lo1 + alpha_v_2_lo;
  const double R_11 = 1.0 - others_1, R_11_error = ksl_difference_error(1.0, others_1, R_11),
      R_11_lo = R_11_error - others_1_lo;
  const double R_12 = m_5 - alpha_v_0, R_12_error = ksl_difference_error(m_5, alpha_v_0, R_12),
      R_12_lo1 = R_12_error + m_5_lo, R_12_lo = R_12_lo1 - alpha_v_0_lo;
  const double R_20 = m_4 - alpha_v_1, R_20_error = ksl_difference_error(m_4, alpha_v_1, R_20),
      R_20_lo1 = R_20_error + m_4_lo, R_20_lo = R_20_lo1 - alpha_v_1_lo;
  const double R_21 = m_5 + alpha_v_0, R_21_error = ksl_sum_error(m_5, alpha_v_0, R_21),
      R_21_lo1 = R_21_error + m_5_lo, R_21_lo = R_21_lo1 + alpha_v_0_lo;
  const double R_22 = 1.0 - others_2, R_22_error = ksl_difference_error(1.0, others_2, R_22),
      R_22_lo = R_22_error - others_2_lo;
  const double R_00_total = R_00 + R_00_lo,
      R_00_rounded = R_00_total == R_00_total ? R_00_total : R_00;
  const double R_01_total = R_01 + R_01_lo,
      R_01_rounded = R_01_total == R_01_total ? R_01_total : R_01;
  const double R_02_total = R_02 + R_02_lo,
      R_02_rounded = R_02_total == R_02_total ? R_02_total : R_02;
  const double R_10_total = R_10 + R_10_lo,
      R_10_rounded = R_10_total == R_10_total ? R_10_total : R_10;
  const double R_11_total = R_11 + R_11_lo,
      R_11_rounded = R_11_total == R_11_total ? R_11_total : R_11;
  const double R_12_total = R_12 + R_12_lo,
      R_12_rounded = R_12_total == R_12_total ? R_12_total : R_12;
  const double R_20_total = R_20 + R_20_lo,
      R_20_rounded = R_20_total == R_20_total ? R_20_total : R_20;
  const double R_21_total = R_21 + R_21_lo,
      R_21_rounded = R_21_total == R_21_total ? R_21_total : R_21;
  const double R_22_total = R_22 + R_22_lo,
      R_22_rounded = R_22_total == R_22_total ? R_22_total : R_22;
  R->m00 = R_00_rounded;
  R->m01 = R_01_rounded;
  R->m02 = R_02_rounded;
  R->m10 = R_10_rounded;
  R->m11 = R_11_rounded;
  R->m12 = R_12_rounded;
  R->m20 = R_20_rounded;
  R->m21 = R_21_rounded;
  R->m22 = R_22_rounded;
}

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (w; x, y, z), the scalar first.
   21 mul, 67 add, 9 product error, 21 sum error, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
     select. */
static inline void ksl_quaternion_from_mat3x3_accurate(const ksl_mat3x3_t *R,
    ksl_quaternion_t *qo) {
  const double p_0 = R->m21 - R->m12, p_0_lo = ksl_difference_error(R->m21, R->m12, p_0);
  const double p_1 = R->m02 - R->m20, p_1_lo = ksl_difference_error(R->m02, R->m20, p_1);
  const double p_2 = R->m10 - R->m01, p_2_lo = ksl_difference_error(R->m10, R->m01, p_2);
  const double s_0 = R->m12 + R->m21, s_0_lo = ksl_sum_error(R->m12, R->m21, s_0);
  const double s_1 = R->m02 + R->m20, s_1_lo = ksl_sum_error(R->m02, R->m20, s_1);
  const double s_2 = R->m01 + R->m10, s_2_lo = ksl_sum_error(R->m01, R->m10, s_2);
  const double d_0a = R->m00 + R->m11, d_0a_lo = ksl_sum_error(R->m00, R->m11, d_0a),
      d_0b = d_0a + R->m22, d_0b_error = ksl_sum_error(d_0a, R->m22, d_0b),
      d_0b_lo = d_0b_error + d_0a_lo, d_0 = d_0b + 1.0, d_0_error = ksl_sum_error(d_0b, 1.0, d_0),
      d_0_lo = d_0_error + d_0b_lo;
  const double d_1a = R->m00 - R->m11, d_1a_lo = ksl_difference_error(R->m00, R->m11, d_1a),
      d_1b = d_1a - R->m22, d_1b_error = ksl_difference_error(d_1a, R->m22, d_1b),
      d_1b_lo = d_1b_error + d_1a_lo, d_1 = d_1b + 1.0, d_1_error = ksl_sum_error(d_1b, 1.0, d_1),
      d_1_lo = d_1_error + d_1b_lo;
  const double d_2a = R->m11 - R->m00, d_2a_lo = ksl_difference_error(R->m11, R->m00, d_2a),
      d_2b = d_2a - R->m22, d_2b_error = ksl_difference_error(d_2a, R->m22, d_2b),
      d_2b_lo = d_2b_error + d_2a_lo, d_2 = d_2b + 1.0, d_2_error = ksl_sum_error(d_2b, 1.0, d_2),
      d_2_lo = d_2_error + d_2b_lo;
  const double d_3a = R->m22 - R->m00, d_3a_lo = ksl_difference_error(R->m22, R->m00, d_3a),
      d_3b = d_3a - R->m11, d_3b_error = ksl_difference_error(d_3a, R->m11, d_3b),
      d_3b_lo = d_3b_error + d_3a_lo, d_3 = d_3b + 1.0, d_3_error = ksl_sum_error(d_3b, 1.0, d_3),
      d_3_lo = d_3_error + d_3b_lo;
  const double low_0 = R->m11 < R->m00 ? p_0 : p_1, low_0_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double low_1 = R->m11 < R->m00 ? d_1 : s_2, low_1_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_2 : d_2, low_2_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_3 = R->m11 < R->m00 ? s_1 : s_0, low_3_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? p_2 : d_0,
      high_0_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double high_1 = R->m00 < high_0a ? s_1 : p_0,
      high_1_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_2 = R->m00 < high_0a ? s_0 : p_1,
      high_2_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_3 = R->m00 < high_0a ? d_3 : p_2,
      high_3_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0 = column_0 < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_0 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_0 < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_0 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_0 < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_0 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3, upper_3a_lo = -column_3_lo,
      upper_3 = column_0 < 0.0 ? upper_3a : column_3,
      upper_3_lo = column_0 < 0.0 ? upper_3a_lo : column_3_lo;
  const double length_a = upper_0 * upper_0, length_a_cross1 = upper_0_lo * upper_0,
      length_a_cross2 = upper_0 * upper_0_lo,
      length_a_error = ksl_product_error(upper_0, upper_0, length_a),
      length_a_lo1 = length_a_error + length_a_cross1, length_a_lo = length_a_lo1 + length_a_cross2,
      length_b = upper_1 * upper_1, length_b_cross1 = upper_1_lo * upper_1,
      length_b_cross2 = upper_1 * upper_1_lo,
      length_b_error = ksl_product_error(upper_1, upper_1, length_b),
      length_b_lo1 = length_b_error + length_b_cross1, length_b_lo = length_b_lo1 + length_b_cross2,
      length_c = length_a + length_b, length_c_error = ksl_sum_error(length_a, length_b, length_c),
      length_c_lo1 = length_c_error + length_a_lo, length_c_lo = length_c_lo1 + length_b_lo,
      length_d = upper_2 * upper_2, length_d_cross1 = upper_2_lo * upper_2,
      length_d_cross2 = upper_2 * upper_2_lo,
      length_d_error = ksl_product_error(upper_2, upper_2, length_d),
      length_d_lo1 = length_d_error + length_d_cross1, length_d_lo = length_d_lo1 + length_d_cross2,
      length_e = length_c + length_d, length_e_error = ksl_sum_error(length_c, length_d, length_e),
      length_e_lo1 = length_e_error + length_c_lo, length_e_lo = length_e_lo1 + length_d_lo,
      length_f = upper_3 * upper_3, length_f_cross1 = upper_3_lo * upper_3,
      length_f_cross2 = upper_3 * upper_3_lo,
      length_f_error = ksl_product_error(upper_3, upper_3, length_f),
      length_f_lo1 = length_f_error + length_f_cross1, length_f_lo = length_f_lo1 + length_f_cross2,
      length_g = length_e + length_f, length_g_error = ksl_sum_error(length_e, length_f, length_g),
      length_g_lo1 = length_g_error + length_e_lo, length_g_lo = length_g_lo1 + length_f_lo,
      length = sqrt(length_g), length_product = length * length,
      length_product_error = ksl_product_error(length, length, length_product),
      length_rest = length_g - length_product, length_exact = length_rest - length_product_error,
      length_residual = length_exact + length_g_lo, length_twice = length + length,
      length_divisor = length == 0.0 ? 1.0 : length_twice,
      length_lo = length_residual / length_divisor;
  const double qo_0 = upper_0 / length, qo_0_cross = qo_0 * length_lo, qo_0_product = qo_0 * length,
      qo_0_product_error = ksl_product_error(qo_0, length, qo_0_product),
      qo_0_rest = upper_0 - qo_0_product, qo_0_exact = qo_0_rest - qo_0_product_error,
      qo_0_lo1 = qo_0_exact + upper_0_lo, qo_0_residual = qo_0_lo1 - qo_0_cross,
      qo_0_lo = qo_0_residual / length;
  const double qo_1 = upper_1 / length, qo_1_cross = qo_1 * length_lo, qo_1_product = qo_1 * length,
      qo_1_product_error = ksl_product_error(qo_1, length, qo_1_product),
      qo_1_rest = upper_1 - qo_1_product, qo_1_exact = qo_1_rest - qo_1_product_error,
      qo_1_lo1 = qo_1_exact + upper_1_lo, qo_1_residual = qo_1_lo1 - qo_1_cross,
      qo_1_lo = qo_1_residual / length;
  const double qo_2 = upper_2 / length, qo_2_cross = qo_2 * length_lo, qo_2_product = qo_2 * length,
      qo_2_product_error = ksl_product_error(qo_2, length, qo_2_product),
      qo_2_rest = upper_2 - qo_2_product, qo_2_exact = qo_2_rest - qo_2_product_error,
      qo_2_lo1 = qo_2_exact + upper_2_lo, qo_2_residual = qo_2_lo1 - qo_2_cross,
      qo_2_lo = qo_2_residual / length;
  const double qo_3 = upper_3 / length, qo_3_cross = qo_3 * length_lo, qo_3_product = qo_3 * length,
      qo_3_product_error = ksl_product_error(qo_3, length, qo_3_product),
      qo_3_rest = upper_3 - qo_3_product, qo_3_exact = qo_3_rest - qo_3_product_error,
      qo_3_lo1 = qo_3_exact + upper_3_lo, qo_3_residual = qo_3_lo1 - qo_3_cross,
      qo_3_lo = qo_3_residual / length;
  const double qo_0_total = qo_0 + qo_0_lo,
      qo_0_rounded = qo_0_total == qo_0_total ? qo_0_total : qo_0;
  const double qo_1_total = qo_1 + qo_1_lo,
      qo_1_rounded = qo_1_total == qo_1_total ? qo_1_total : qo_1;
  const double qo_2_total = qo_2 + qo_2_lo,
      qo_2_rounded = qo_2_total == qo_2_total ? qo_2_total : qo_2;
  const double qo_3_total = qo_3 + qo_3_lo,
      qo_3_rounded = qo_3_total == qo_3_total ? qo_3_total : qo_3;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where angle
     = 0; any multiple of a quaternion.
   q: quaternion (w; x, y, z), the scalar first; axis: vector.
   21 mul, 30 add, 8 product error, 2 sum error, 9 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 7
     equal, 20 select. */
static inline double ksl_axis_angle_from_quaternion_accurate(const ksl_quaternion_t *q,
    ksl_vec3_t *axis) {
  const double upper_0a = -q->w, upper_0 = q->w < 0.0 ? upper_0a : q->w;
  const double upper_1a = -q->x, upper_1 = q->w < 0.0 ? upper_1a : q->x;
  const double upper_2a = -q->y, upper_2 = q->w < 0.0 ? upper_2a : q->y;
  const double upper_3a = -q->z, upper_3 = q->w < 0.0 ? upper_3a : q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_lo = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_b = v_y_1 * v_y_1, v_n_b_lo = ksl_product_error(v_y_1, v_y_1, v_n_b),
      v_n_c = v_n_a + v_n_b, v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c),
      v_n_c_lo1 = v_n_c_error + v_n_a_lo, v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2,
      v_n_d_lo = ksl_product_error(v_y_2, v_y_2, v_n_d), v_n_e = v_n_c + v_n_d,
      v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e), v_n_e_lo1 = v_n_e_error + v_n_c_lo,
      v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n = sqrt(v_n_e), v_n_product = v_n * v_n,
      v_n_product_error = ksl_product_error(v_n, v_n, v_n_product), v_n_rest = v_n_e - v_n_product,
      v_n_exact = v_n_rest - v_n_product_error, v_n_residual = v_n_exact + v_n_e_lo,
      v_n_twice = v_n + v_n, v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice,
      v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_total = v_n + v_n_lo, n_added = n_total - v_n, n_remaining = v_n_lo - n_added,
      n = n_total * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_total - n_back,
      n_rest = n_lost + n_remaining, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half = atan2(n, upper_0), half_cross0 = upper_0 * n_lo,
      half_square0 = upper_0 * upper_0, half_square1 = n * n,
      half_square = half_square0 + half_square1, half_lo = half_cross0 / half_square;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double unit_0 = upper_1 / divisor, unit_0_cross = unit_0 * divisor_lo,
      unit_0_product = unit_0 * divisor,
      unit_0_product_error = ksl_product_error(unit_0, divisor, unit_0_product),
      unit_0_rest = upper_1 - unit_0_product, unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_residual = unit_0_exact - unit_0_cross, unit_0_lo = unit_0_residual / divisor;
  const double unit_1 = upper_2 / divisor, unit_1_cross = unit_1 * divisor_lo,
      unit_1_product = unit_1 * divisor,
      unit_1_product_error = ksl_product_error(unit_1, divisor, unit_1_product),
      unit_1_rest = upper_2 - unit_1_product, unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_residual = unit_1_exact - unit_1_cross, unit_1_lo = unit_1_residual / divisor;
  const double unit_2 = upper_3 / divisor, unit_2_cross = unit_2 * divisor_lo,
      unit_2_product = unit_2 * divisor,
      unit_2_product_error = ksl_product_error(unit_2, divisor, unit_2_product),
      unit_2_rest = upper_3 - unit_2_product, unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_residual = unit_2_exact - unit_2_cross, unit_2_lo = unit_2_residual / divisor;
  const double angle = 2.0 * half, angle_cross1 = 2.0 * half_lo,
      angle_error = ksl_product_error(2.0, half, angle), angle_lo = angle_error + angle_cross1;
  const double axis_0 = n == 0.0 ? 1.0 : unit_0, axis_0_lo = n == 0.0 ? 0.0 : unit_0_lo;
  const double angle_total = angle + angle_lo,
      angle_rounded = angle_total == angle_total ? angle_total : angle;
  const double axis_0_total = axis_0 + axis_0_lo,
      axis_0_rounded = axis_0_total == axis_0_total ? axis_0_total : axis_0;
  const double unit_1_total = unit_1 + unit_1_lo,
      unit_1_rounded = unit_1_total == unit_1_total ? unit_1_total : unit_1;
  const double unit_2_total = unit_2 + unit_2_lo,
      unit_2_rounded = unit_2_total == unit_2_total ? unit_2_total : unit_2;
  return angle_rounded;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (w; x, y, z), the scalar first; vo: vector.
   23 mul, 27 add, 9 product error, 2 sum error, 5 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 6
     equal, 17 select. */
static inline void ksl_quaternion_log_accurate(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double upper_0a = -q->w, upper_0 = q->w < 0.0 ? upper_0a : q->w;
  const double upper_1a = -q->x, upper_1 = q->w < 0.0 ? upper_1a : q->x;
  const double upper_2a = -q->y, upper_2 = q->w < 0.0 ? upper_2a : q->y;
  const double upper_3a = -q->z, upper_3 = q->w < 0.0 ? upper_3a : q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_lo = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_b = v_y_1 * v_y_1, v_n_b_lo = ksl_product_error(v_y_1, v_y_1, v_n_b),
      v_n_c = v_n_a + v_n_b, v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c),
      v_n_c_lo1 = v_n_c_error + v_n_a_lo, v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2,
      v_n_d_lo = ksl_product_error(v_y_2, v_y_2, v_n_d), v_n_e = v_n_c + v_n_d,
      v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e), v_n_e_lo1 = v_n_e_error + v_n_c_lo,
      v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n = sqrt(v_n_e), v_n_product = v_n * v_n,
      v_n_product_error = ksl_product_error(v_n, v_n, v_n_product), v_n_rest = v_n_e - v_n_product,
      v_n_exact = v_n_rest - v_n_product_error, v_n_residual = v_n_exact + v_n_e_lo,
      v_n_twice = v_n + v_n, v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice,
      v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_total = v_n + v_n_lo, n_added = n_total - v_n, n_remaining = v_n_lo - n_added,
      n = n_total * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_total - n_back,
      n_rest = n_lost + n_remaining, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half = atan2(n, upper_0), half_cross0 = upper_0 * n_lo,
      half_square0 = upper_0 * upper_0, half_square1 = n * n,
      half_square = half_square0 + half_square1, half_lo = half_cross0 / half_square;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double theta = 2.0 * half, theta_cross1 = 2.0 * half_lo,
      theta_error = ksl_product_error(2.0, half, theta), theta_lo = theta_error + theta_cross1;
  const double k = theta / divisor, k_cross = k * divisor_lo, k_product = k * divisor,
      k_product_error = ksl_product_error(k, divisor, k_product), k_rest = theta - k_product,
      k_exact = k_rest - k_product_error, k_lo1 = k_exact + theta_lo, k_residual = k_lo1 - k_cross,
      k_lo = k_residual / divisor;
  const double vector_0 = upper_1 * k, vector_0_cross1 = upper_1 * k_lo,
      vector_0_error = ksl_product_error(upper_1, k, vector_0),
      vector_0_lo = vector_0_error + vector_0_cross1;
  const double vector_1 = upper_2 * k, vector_1_cross1 = upper_2 * k_lo,
      vector_1_error = ksl_product_error(upper_2, k, vector_1),
      vector_1_lo = vector_1_error + vector_1_cross1;
  const double vector_2 = upper_3 * k, vector_2_cross1 = upper_3 * k_lo,
      vector_2_error = ksl_product_error(upper_3, k, vector_2),
      vector_2_lo = vector_2_error + vector_2_cross1;
  const double vector_0_total = vector_0 + vector_0_lo,
      vector_0_rounded = vector_0_total == vector_0_total ? vector_0_total : vector_0;
  const double vector_1_total = vector_1 + vector_1_lo,
      vector_1_rounded = vector_1_total == vector_1_total ? vector_1_total : vector_1;
  const double vector_2_total = vector_2 + vector_2_lo,
      vector_2_rounded = vector_2_total == vector_2_total ? vector_2_total : vector_2;
  vo->x = vector_0_rounded;
  vo->y = vector_1_rounded;
  vo->z = vector_2_rounded;
}

/* self = a self.
   self: quaternion (w; x, y, z), the scalar first; a: number.
   4 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternionf_scale_accurate(ksl_quaternionf_t *self, const float a) {
  const double self_0_new = (double)self->w * (double)a;
  const double self_1_new = (double)self->x * (double)a;
  const double self_2_new = (double)self->y * (double)a;
  const double self_3_new = (double)self->z * (double)a;
  self->w = (float)self_0_new;
  self->x = (float)self_1_new;
  self->y = (float)self_2_new;
  self->z = (float)self_3_new;
}

/* |q| = sqrt(w^2 + v·v).
   q: quaternion (w; x, y, z), the scalar first.
   9 mul, 3 add, 1 sqrt, 4 abs, 7 less, 7 select. */
static inline float ksl_quaternionf_norm_accurate(const ksl_quaternionf_t *q) {
  const double s_size_0 = fabs((double)q->w);
  const double s_size_1 = fabs((double)q->x);
  const double s_size_2 = fabs((double)q->y);
  const double s_size_3 = fabs((double)q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)q->w * s;
  const double y_1 = (double)q->x * s;
  const double y_2 = (double)q->y * s;
  const double y_3 = (double)q->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r = 1.0 < s ? 7.888609052210118e-31 : r_b;
  const double norm = n * r;
  return (float)norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (w; x, y, z), the scalar first.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalize_accurate(ksl_quaternionf_t *self) {
  const double s_size_0 = fabs((double)self->w);
  const double s_size_1 = fabs((double)self->x);
  const double s_size_2 = fabs((double)self->y);
  const double s_size_3 = fabs((double)self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)self->w * s;
  const double y_1 = (double)self->x * s;
  const double y_2 = (double)self->y * s;
  const double y_3 = (double)self->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)self->w * up;
  const double enlarged_1 = (double)self->x * up;
  const double enlarged_2 = (double)self->y * up;
  const double enlarged_3 = (double)self->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  const double self_3_new = quotient_3 * down;
  self->w = (float)self_0_new;
  self->x = (float)self_1_new;
  self->y = (float)self_2_new;
  self->z = (float)self_3_new;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalized_accurate(const ksl_quaternionf_t *q,
    ksl_quaternionf_t *qo) {
  const double s_size_0 = fabs((double)q->w);
  const double s_size_1 = fabs((double)q->x);
  const double s_size_2 = fabs((double)q->y);
  const double s_size_3 = fabs((double)q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)q->w * s;
  const double y_1 = (double)q->x * s;
  const double y_2 = (double)q->y * s;
  const double y_3 = (double)q->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)q->w * up;
  const double enlarged_1 = (double)q->x * up;
  const double enlarged_2 = (double)q->y * up;
  const double enlarged_3 = (double)q->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double qo_0 = quotient_0 * down;
  const double qo_1 = quotient_1 * down;
  const double qo_2 = quotient_2 * down;
  const double qo_3 = quotient_3 * down;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1 q2 = (w1 w2 - v1·v2; w1 v2 + w2 v1 + v1 × v2).
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a - qo_0f;
  const double qo_1a = (double)q1->w * (double)q2->x, qo_1b = (double)q1->x * (double)q2->w,
      qo_1c = qo_1a + qo_1b, qo_1d = (double)q1->y * (double)q2->z,
      qo_1e = (double)q1->z * (double)q2->y, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->w * (double)q2->y, qo_2b = (double)q1->z * (double)q2->x,
      qo_2c = (double)q1->x * (double)q2->z, qo_2d = qo_2b - qo_2c, qo_2e = qo_2a + qo_2d,
      qo_2f = (double)q1->y * (double)q2->w, qo_2 = qo_2e + qo_2f;
  const double qo_3a = (double)q1->w * (double)q2->z, qo_3b = (double)q1->x * (double)q2->y,
      qo_3c = (double)q1->y * (double)q2->x, qo_3d = qo_3b - qo_3c, qo_3e = qo_3a + qo_3d,
      qo_3f = (double)q1->z * (double)q2->w, qo_3 = qo_3e + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + (w: 1/8, v: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qconjqf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a + qo_0f;
  const double qo_1a = (double)q1->w * (double)q2->x, qo_1b = (double)q1->x * (double)q2->w,
      qo_1c = qo_1a - qo_1b, qo_1d = (double)q1->z * (double)q2->y,
      qo_1e = (double)q1->y * (double)q2->z, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->w * (double)q2->y, qo_2b = (double)q1->y * (double)q2->w,
      qo_2c = qo_2a - qo_2b, qo_2d = (double)q1->x * (double)q2->z,
      qo_2e = (double)q1->z * (double)q2->x, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1->w * (double)q2->z, qo_3b = (double)q1->z * (double)q2->w,
      qo_3c = qo_3a - qo_3b, qo_3d = (double)q1->y * (double)q2->x,
      qo_3e = (double)q1->x * (double)q2->y, qo_3f = qo_3d - qo_3e, qo_3 = qo_3c + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + (w: 1/8, v: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qqconjf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a + qo_0f;
  const double qo_1a = (double)q1->x * (double)q2->w, qo_1b = (double)q1->w * (double)q2->x,
      qo_1c = qo_1a - qo_1b, qo_1d = (double)q1->z * (double)q2->y,
      qo_1e = (double)q1->y * (double)q2->z, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->y * (double)q2->w, qo_2b = (double)q1->w * (double)q2->y,
      qo_2c = qo_2a - qo_2b, qo_2d = (double)q1->x * (double)q2->z,
      qo_2e = (double)q1->z * (double)q2->x, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1->z * (double)q2->w, qo_3b = (double)q1->w * (double)q2->z,
      qo_3c = qo_3a - qo_3b, qo_3d = (double)q1->y * (double)q2->x,
      qo_3e = (double)q1->x * (double)q2->y, qo_3f = qo_3d - qo_3e, qo_3 = qo_3c + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->y * (double)v->z, c_0b = (double)q->z * (double)v->y,
      c_0 = c_0a - c_0b;
  const double c_1a = (double)q->z * (double)v->x, c_1b = (double)q->x * (double)v->z,
      c_1 = c_1a - c_1b;
  const double c_2a = (double)q->x * (double)v->y, c_2b = (double)q->y * (double)v->x,
      c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = (double)q->w * t_0, turn_0b = (double)q->y * t_2,
      turn_0c = (double)q->z * t_1, turn_0d = turn_0b - turn_0c, turn_0 = turn_0a + turn_0d;
  const double turn_1a = (double)q->w * t_1, turn_1b = (double)q->z * t_0,
      turn_1c = (double)q->x * t_2, turn_1d = turn_1b - turn_1c, turn_1 = turn_1a + turn_1d;
  const double turn_2a = (double)q->w * t_2, turn_2b = (double)q->x * t_1,
      turn_2c = (double)q->y * t_0, turn_2d = turn_2b - turn_2c, turn_2 = turn_2a + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->z * (double)v->y, c_0b = (double)q->y * (double)v->z,
      c_0 = c_0a - c_0b;
  const double c_1a = (double)q->x * (double)v->z, c_1b = (double)q->z * (double)v->x,
      c_1 = c_1a - c_1b;
  const double c_2a = (double)q->y * (double)v->x, c_2b = (double)q->x * (double)v->y,
      c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = (double)q->w * t_0, turn_0b = (double)q->z * t_1,
      turn_0c = (double)q->y * t_2, turn_0d = turn_0b - turn_0c, turn_0 = turn_0a + turn_0d;
  const double turn_1a = (double)q->w * t_1, turn_1b = (double)q->x * t_2,
      turn_1c = (double)q->z * t_0, turn_1d = turn_1b - turn_1c, turn_1 = turn_1a + turn_1d;
  const double turn_2a = (double)q->w * t_2, turn_2b = (double)q->y * t_0,
      turn_2c = (double)q->x * t_1, turn_2d = turn_2b - turn_2c, turn_2 = turn_2a + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (w; x, y, z), the scalar first; R: rotation or other 3×3 matrix.
   17 mul, 15 add, 1 div. */
static inline void ksl_mat3x3f_from_quaternion_accurate(const ksl_quaternionf_t *q,
    ksl_mat3x3f_t *R) {
  const double square_a = (double)q->w * (double)q->w, square_b = (double)q->x * (double)q->x,
      square_c = square_a + square_b, square_d = (double)q->y * (double)q->y,
      square_e = square_c + square_d, square_f = (double)q->z * (double)q->z,
      square = square_e + square_f;
  const double scale = 2.0 / square;
  const double scale_w = (double)q->w * scale;
  const double beta_v_0 = (double)q->x * scale;
  const double beta_v_1 = (double)q->y * scale;
  const double beta_v_2 = (double)q->z * scale;
  const double m_0 = (double)q->x * beta_v_0;
  const double m_1 = (double)q->y * beta_v_1;
  const double m_2 = (double)q->z * beta_v_2;
  const double m_3 = (double)q->y * beta_v_0;
  const double m_4 = (double)q->z * beta_v_0;
  const double m_5 = (double)q->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double alpha_v_0 = (double)q->x * scale_w;
  const double alpha_v_1 = (double)q->y * scale_w;
  const double alpha_v_2 = (double)q->z * scale_w;
  const double R_00 = 1.0 - others_0;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_11 = 1.0 - others_1;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double R_22 = 1.0 - others_2;
  R->m00 = (float)R_00;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)R_11;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)R_22;
}

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (w; x, y, z), the scalar first.
   4 mul, 21 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select. */
static inline void ksl_quaternionf_from_mat3x3_accurate(const ksl_mat3x3f_t *R,
    ksl_quaternionf_t *qo) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double d_0a = (double)R->m00 + (double)R->m11, d_0b = d_0a + (double)R->m22,
      d_0 = d_0b + 1.0;
  const double d_1a = (double)R->m00 - (double)R->m11, d_1b = d_1a - (double)R->m22,
      d_1 = d_1b + 1.0;
  const double d_2a = (double)R->m11 - (double)R->m00, d_2b = d_2a - (double)R->m22,
      d_2 = d_2b + 1.0;
  const double d_3a = (double)R->m22 - (double)R->m00, d_3b = d_3a - (double)R->m11,
      d_3 = d_3b + 1.0;
  const double low_0 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double low_1 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_3 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double high_1 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_2 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_3 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_0 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_0 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_0 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_0 < 0.0 ? upper_3a : column_3;
  const double length_a = upper_0 * upper_0, length_b = upper_1 * upper_1,
      length_c = length_a + length_b, length_d = upper_2 * upper_2, length_e = length_c + length_d,
      length_f = upper_3 * upper_3, length_g = length_e + length_f, length = sqrt(length_g);
  const double qo_0 = upper_0 / length;
  const double qo_1 = upper_1 / length;
  const double qo_2 = upper_2 / length;
  const double qo_3 = upper_3 / length;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where angle
     = 0; any multiple of a quaternion.
   q: quaternion (w; x, y, z), the scalar first; axis: vector.
   8 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 12 select. */
static inline float ksl_axis_angle_from_quaternionf_accurate(const ksl_quaternionf_t *q,
    ksl_vec3f_t *axis) {
  const double upper_0a = -(double)q->w, upper_0 = (double)q->w < 0.0 ? upper_0a : (double)q->w;
  const double upper_1a = -(double)q->x, upper_1 = (double)q->w < 0.0 ? upper_1a : (double)q->x;
  const double upper_2a = -(double)q->y, upper_2 = (double)q->w < 0.0 ? upper_2a : (double)q->y;
  const double upper_3a = -(double)q->z, upper_3 = (double)q->w < 0.0 ? upper_3a : (double)q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = upper_1 / divisor;
  const double unit_1 = upper_2 / divisor;
  const double unit_2 = upper_3 / divisor;
  const double angle = 2.0 * half;
  const double axis_0 = n == 0.0 ? 1.0 : unit_0;
  return (float)angle;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (w; x, y, z), the scalar first; vo: vector.
   11 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 11 select. */
static inline void ksl_quaternionf_log_accurate(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const double upper_0a = -(double)q->w, upper_0 = (double)q->w < 0.0 ? upper_0a : (double)q->w;
  const double upper_1a = -(double)q->x, upper_1 = (double)q->w < 0.0 ? upper_1a : (double)q->x;
  const double upper_2a = -(double)q->y, upper_2 = (double)q->w < 0.0 ? upper_2a : (double)q->y;
  const double upper_3a = -(double)q->z, upper_3 = (double)q->w < 0.0 ? upper_3a : (double)q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = 2.0 * half;
  const double k = theta / divisor;
  const double vector_0 = upper_1 * k;
  const double vector_1 = upper_2 * k;
  const double vector_2 = upper_3 * k;
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

#endif

/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_EXPONENTIAL_ACCURATE_H
#define KSL_EXPONENTIAL_ACCURATE_H


/* vo with exp vo~ = R, |vo| <= π; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; vo: vector.
   39 mul, 78 add, 9 product error, 20 sum error, 6 div, 1 sqrt, 1 atan2, 12 neg, 3 abs, 13 less,
     9 equal, 53 select. */
static inline void ksl_SO3_log_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *vo) {
  const double p_0 = R->m21 - R->m12, p_0_lo = ksl_difference_error(R->m21, R->m12, p_0);
  const double p_1 = R->m02 - R->m20, p_1_lo = ksl_difference_error(R->m02, R->m20, p_1);
  const double p_2 = R->m10 - R->m01, p_2_lo = ksl_difference_error(R->m10, R->m01, p_2);
  const double s_0 = R->m12 + R->m21, s_0_lo = ksl_sum_error(R->m12, R->m21, s_0);
  const double s_1 = R->m02 + R->m20, s_1_lo = ksl_sum_error(R->m02, R->m20, s_1);
  const double s_2 = R->m01 + R->m10, s_2_lo = ksl_sum_error(R->m01, R->m10, s_2);
  const double d_0a = R->m00 + R->m11, d_0a_lo = ksl_sum_error(R->m00, R->m11, d_0a),
      d_0b = d_0a + R->m22, d_0b_error = ksl_sum_error(d_0a, R->m22, d_0b),
      d_0b_lo = d_0b_error + d_0a_lo, d_0 = d_0b + 1.0, d_0_error = ksl_sum_error(d_0b, 1.0, d_0),
      d_0_lo = d_0_error + d_0b_lo;
  const double d_1a = R->m00 - R->m11, d_1a_lo = ksl_difference_error(R->m00, R->m11, d_1a),
      d_1b = d_1a - R->m22, d_1b_error = ksl_difference_error(d_1a, R->m22, d_1b),
      d_1b_lo = d_1b_error + d_1a_lo, d_1 = d_1b + 1.0, d_1_error = ksl_sum_error(d_1b, 1.0, d_1),
      d_1_lo = d_1_error + d_1b_lo;
  const double d_2a = R->m11 - R->m00, d_2a_lo = ksl_difference_error(R->m11, R->m00, d_2a),
      d_2b = d_2a - R->m22, d_2b_error = ksl_difference_error(d_2a, R->m22, d_2b),
      d_2b_lo = d_2b_error + d_2a_lo, d_2 = d_2b + 1.0, d_2_error = ksl_sum_error(d_2b, 1.0, d_2),
      d_2_lo = d_2_error + d_2b_lo;
  const double d_3a = R->m22 - R->m00, d_3a_lo = ksl_difference_error(R->m22, R->m00, d_3a),
      d_3b = d_3a - R->m11, d_3b_error = ksl_difference_error(d_3a, R->m11, d_3b),
      d_3b_lo = d_3b_error + d_3a_lo, d_3 = d_3b + 1.0, d_3_error = ksl_sum_error(d_3b, 1.0, d_3),
      d_3_lo = d_3_error + d_3b_lo;
  const double low_0 = R->m11 < R->m00 ? p_0 : p_1, low_0_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double low_1 = R->m11 < R->m00 ? d_1 : s_2, low_1_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_2 : d_2, low_2_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_3 = R->m11 < R->m00 ? s_1 : s_0, low_3_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? p_2 : d_0,
      high_0_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double high_1 = R->m00 < high_0a ? s_1 : p_0,
      high_1_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_2 = R->m00 < high_0a ? s_0 : p_1,
      high_2_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_3 = R->m00 < high_0a ? d_3 : p_2,
      high_3_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0 = column_0 < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_0 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_0 < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_0 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_0 < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_0 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3, upper_3a_lo = -column_3_lo,
      upper_3 = column_0 < 0.0 ? upper_3a : column_3,
      upper_3_lo = column_0 < 0.0 ? upper_3a_lo : column_3_lo;
  const double v_s_size_0 = fabs(upper_1), v_s_size_0_opposite = -upper_1_lo,
      v_s_size_0_lo = upper_1 < 0.0 ? v_s_size_0_opposite : upper_1_lo;
  const double v_s_size_1 = fabs(upper_2), v_s_size_1_opposite = -upper_2_lo,
      v_s_size_1_lo = upper_2 < 0.0 ? v_s_size_1_opposite : upper_2_lo;
  const double v_s_size_2 = fabs(upper_3), v_s_size_2_opposite = -upper_3_lo,
      v_s_size_2_lo = upper_3 < 0.0 ? v_s_size_2_opposite : upper_3_lo;
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0,
      v_s_largest1_lo = v_s_size_0 < v_s_size_1 ? v_s_size_1_lo : v_s_size_0_lo;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1,
      v_s_largest2_lo = v_s_largest1 < v_s_size_2 ? v_s_size_2_lo : v_s_largest1_lo;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0_total = upper_1 + upper_1_lo, v_y_0_added = v_y_0_total - upper_1,
      v_y_0_remaining = upper_1_lo - v_y_0_added, v_y_0 = v_y_0_total * v_s,
      v_y_0_inverse = 1.0 / v_s, v_y_0_back = v_y_0 * v_y_0_inverse,
      v_y_0_lost = v_y_0_total - v_y_0_back, v_y_0_rest = v_y_0_lost + v_y_0_remaining,
      v_y_0_small = v_y_0_rest * v_s, v_y_0_lo = v_y_0_lost == 0.0 ? 0.0 : v_y_0_small;
  const double v_y_1_total = upper_2 + upper_2_lo, v_y_1_added = v_y_1_total - upper_2,
      v_y_1_remaining = upper_2_lo - v_y_1_added, v_y_1 = v_y_1_total * v_s,
      v_y_1_back = v_y_1 * v_y_0_inverse, v_y_1_lost = v_y_1_total - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_y_1_remaining, v_y_1_small = v_y_1_rest * v_s,
      v_y_1_lo = v_y_1_lost == 0.0 ? 0.0 : v_y_1_small;
  const double v_y_2_total = upper_3 + upper_3_lo, v_y_2_added = v_y_2_total - upper_3,
      v_y_2_remaining = upper_3_lo - v_y_2_added, v_y_2 = v_y_2_total * v_s,
      v_y_2_back = v_y_2 * v_y_0_inverse, v_y_2_lost = v_y_2_total - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_y_2_remaining, v_y_2_small = v_y_2_rest * v_s,
      v_y_2_lo = v_y_2_lost == 0.0 ? 0.0 : v_y_2_small;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_cross1 = v_y_0_lo * v_y_0,
      v_n_a_cross2 = v_y_0 * v_y_0_lo, v_n_a_error = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_a_lo1 = v_n_a_error + v_n_a_cross1, v_n_a_lo = v_n_a_lo1 + v_n_a_cross2,
      v_n_b = v_y_1 * v_y_1, v_n_b_cross1 = v_y_1_lo * v_y_1, v_n_b_cross2 = v_y_1 * v_y_1_lo,
      v_n_b_error = ksl_product_error(v_y_1, v_y_1, v_n_b), v_n_b_lo1 = v_n_b_error + v_n_b_cross1,
      v_n_b_lo = v_n_b_lo1 + v_n_b_cross2, v_n_c = v_n_a + v_n_b,
      v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c), v_n_c_lo1 = v_n_c_error + v_n_a_lo,
      v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2, v_n_d_cross1 = v_y_2_lo * v_y_2,
      v_n_d_cross2 = v_y_2 * v_y_2_lo, v_n_d_error = ksl_product_error(v_y_2, v_y_2, v_n_d),
      v_n_d_lo1 = v_n_d_error + v_n_d_cross1, v_n_d_lo = v_n_d_lo1 + v_n_d_cross2,
      v_n_e = v_n_c + v_n_d, v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e),
      v_n_e_lo1 = v_n_e_error + v_n_c_lo, v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n = sqrt(v_n_e),
      v_n_product = v_n * v_n, v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_total = v_n + v_n_lo, n_added = n_total - v_n, n_remaining = v_n_lo - n_added,
      n = n_total * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_total - n_back,
      n_rest = n_lost + n_remaining, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half = atan2(n, upper_0), half_cross0 = upper_0 * n_lo, half_cross1 = n * upper_0_lo,
      half_cross = half_cross0 - half_cross1, half_square0 = upper_0 * upper_0,
      half_square1 = n * n, half_square = half_square0 + half_square1,
      half_lo = half_cross / half_square;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double theta = 2.0 * half, theta_cross1 = 2.0 * half_lo,
      theta_error = ksl_product_error(2.0, half, theta), theta_lo = theta_error + theta_cross1;
  const double k = theta / divisor, k_cross = k * divisor_lo, k_product = k * divisor,
      k_product_error = ksl_product_error(k, divisor, k_product), k_rest = theta - k_product,
      k_exact = k_rest - k_product_error, k_lo1 = k_exact + theta_lo, k_residual = k_lo1 - k_cross,
      k_lo = k_residual / divisor;
  const double vector_0 = upper_1 * k, vector_0_cross1 = upper_1_lo * k,
      vector_0_cross2 = upper_1 * k_lo, vector_0_error = ksl_product_error(upper_1, k, vector_0),
      vector_0_lo1 = vector_0_error + vector_0_cross1, vector_0_lo = vector_0_lo1 + vector_0_cross2;
  const double vector_1 = upper_2 * k, vector_1_cross1 = upper_2_lo * k,
      vector_1_cross2 = upper_2 * k_lo, vector_1_error = ksl_product_error(upper_2, k, vector_1),
      vector_1_lo1 = vector_1_error + vector_1_cross1, vector_1_lo = vector_1_lo1 + vector_1_cross2;
  const double vector_2 = upper_3 * k, vector_2_cross1 = upper_3_lo * k,
      vector_2_cross2 = upper_3 * k_lo, vector_2_error = ksl_product_error(upper_3, k, vector_2),
      vector_2_lo1 = vector_2_error + vector_2_cross1, vector_2_lo = vector_2_lo1 + vector_2_cross2;
  const double vector_0_total = vector_0 + vector_0_lo,
      vector_0_rounded = vector_0_total == vector_0_total ? vector_0_total : vector_0;
  const double vector_1_total = vector_1 + vector_1_lo,
      vector_1_rounded = vector_1_total == vector_1_total ? vector_1_total : vector_1;
  const double vector_2_total = vector_2 + vector_2_lo,
      vector_2_rounded = vector_2_total == vector_2_total ? vector_2_total : vector_2;
  vo->x = vector_0_rounded;
  vo->y = vector_1_rounded;
  vo->z = vector_2_rounded;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) where angle = 0.
   R: rotation or other 3×3 matrix; axis: vector.
   34 mul, 81 add, 8 product error, 20 sum error, 10 div, 1 sqrt, 1 atan2, 12 neg, 3 abs, 13
     less, 10 equal, 56 select. */
static inline double ksl_axis_angle_from_mat3x3_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *axis) {
  const double p_0 = R->m21 - R->m12, p_0_lo = ksl_difference_error(R->m21, R->m12, p_0);
  const double p_1 = R->m02 - R->m20, p_1_lo = ksl_difference_error(R->m02, R->m20, p_1);
  const double p_2 = R->m10 - R->m01, p_2_lo = ksl_difference_error(R->m10, R->m01, p_2);
  const double s_0 = R->m12 + R->m21, s_0_lo = ksl_sum_error(R->m12, R->m21, s_0);
  const double s_1 = R->m02 + R->m20, s_1_lo = ksl_sum_error(R->m02, R->m20, s_1);
  const double s_2 = R->m01 + R->m10, s_2_lo = ksl_sum_error(R->m01, R->m10, s_2);
  const double d_0a = R->m00 + R->m11, d_0a_lo = ksl_sum_error(R->m00, R->m11, d_0a),
      d_0b = d_0a + R->m22, d_0b_error = ksl_sum_error(d_0a, R->m22, d_0b),
      d_0b_lo = d_0b_error + d_0a_lo, d_0 = d_0b + 1.0, d_0_error = ksl_sum_error(d_0b, 1.0, d_0),
      d_0_lo = d_0_error + d_0b_lo;
  const double d_1a = R->m00 - R->m11, d_1a_lo = ksl_difference_error(R->m00, R->m11, d_1a),
      d_1b = d_1a - R->m22, d_1b_error = ksl_difference_error(d_1a, R->m22, d_1b),
      d_1b_lo = d_1b_error + d_1a_lo, d_1 = d_1b + 1.0, d_1_error = ksl_sum_error(d_1b, 1.0, d_1),
      d_1_lo = d_1_error + d_1b_lo;
  const double d_2a = R->m11 - R->m00, d_2a_lo = ksl_difference_error(R->m11, R->m00, d_2a),
      d_2b = d_2a - R->m22, d_2b_error = ksl_difference_error(d_2a, R->m22, d_2b),
      d_2b_lo = d_2b_error + d_2a_lo, d_2 = d_2b + 1.0, d_2_error = ksl_sum_error(d_2b, 1.0, d_2),
      d_2_lo = d_2_error + d_2b_lo;
  const double d_3a = R->m22 - R->m00, d_3a_lo = ksl_difference_error(R->m22, R->m00, d_3a),
      d_3b = d_3a - R->m11, d_3b_error = ksl_difference_error(d_3a, R->m11, d_3b),
      d_3b_lo = d_3b_error + d_3a_lo, d_3 = d_3b + 1.0, d_3_error = ksl_sum_error(d_3b, 1.0, d_3),
      d_3_lo = d_3_error + d_3b_lo;
  const double low_0 = R->m11 < R->m00 ? p_0 : p_1, low_0_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double low_1 = R->m11 < R->m00 ? d_1 : s_2, low_1_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_2 : d_2, low_2_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_3 = R->m11 < R->m00 ? s_1 : s_0, low_3_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? p_2 : d_0,
      high_0_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double high_1 = R->m00 < high_0a ? s_1 : p_0,
      high_1_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_2 = R->m00 < high_0a ? s_0 : p_1,
      high_2_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_3 = R->m00 < high_0a ? d_3 : p_2,
      high_3_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0 = column_0 < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_0 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_0 < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_0 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_0 < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_0 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3, upper_3a_lo = -column_3_lo,
      upper_3 = column_0 < 0.0 ? upper_3a : column_3,
      upper_3_lo = column_0 < 0.0 ? upper_3a_lo : column_3_lo;
  const double v_s_size_0 = fabs(upper_1), v_s_size_0_opposite = -upper_1_lo,
      v_s_size_0_lo = upper_1 < 0.0 ? v_s_size_0_opposite : upper_1_lo;
  const double v_s_size_1 = fabs(upper_2), v_s_size_1_opposite = -upper_2_lo,
      v_s_size_1_lo = upper_2 < 0.0 ? v_s_size_1_opposite : upper_2_lo;
  const double v_s_size_2 = fabs(upper_3), v_s_size_2_opposite = -upper_3_lo,
      v_s_size_2_lo = upper_3 < 0.0 ? v_s_size_2_opposite : upper_3_lo;
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0,
      v_s_largest1_lo = v_s_size_0 < v_s_size_1 ? v_s_size_1_lo : v_s_size_0_lo;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1,
      v_s_largest2_lo = v_s_largest1 < v_s_size_2 ? v_s_size_2_lo : v_s_largest1_lo;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0_total = upper_1 + upper_1_lo, v_y_0_added = v_y_0_total - upper_1,
      v_y_0_remaining = upper_1_lo - v_y_0_added, v_y_0 = v_y_0_total * v_s,
      v_y_0_inverse = 1.0 / v_s, v_y_0_back = v_y_0 * v_y_0_inverse,
      v_y_0_lost = v_y_0_total - v_y_0_back, v_y_0_rest = v_y_0_lost + v_y_0_remaining,
      v_y_0_small = v_y_0_rest * v_s, v_y_0_lo = v_y_0_lost == 0.0 ? 0.0 : v_y_0_small;
  const double v_y_1_total = upper_2 + upper_2_lo, v_y_1_added = v_y_1_total - upper_2,
      v_y_1_remaining = upper_2_lo - v_y_1_added, v_y_1 = v_y_1_total * v_s,
      v_y_1_back = v_y_1 * v_y_0_inverse, v_y_1_lost = v_y_1_total - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_y_1_remaining, v_y_1_small = v_y_1_rest * v_s,
      v_y_1_lo = v_y_1_lost == 0.0 ? 0.0 : v_y_1_small;
  const double v_y_2_total = upper_3 + upper_3_lo, v_y_2_added = v_y_2_total - upper_3,
      v_y_2_remaining = upper_3_lo - v_y_2_added, v_y_2 = v_y_2_total * v_s,
      v_y_2_back = v_y_2 * v_y_0_inverse, v_y_2_lost = v_y_2_total - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_y_2_remaining, v_y_2_small = v_y_2_rest * v_s,
      v_y_2_lo = v_y_2_lost == 0.0 ? 0.0 : v_y_2_small;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_cross1 = v_y_0_lo * v_y_0,
      v_n_a_cross2 = v_y_0 * v_y_0_lo, v_n_a_error = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_a_lo1 = v_n_a_error + v_n_a_cross1, v_n_a_lo = v_n_a_lo1 + v_n_a_cross2,
      v_n_b = v_y_1 * v_y_1, v_n_b_cross1 = v_y_1_lo * v_y_1, v_n_b_cross2 = v_y_1 * v_y_1_lo,
      v_n_b_error = ksl_product_error(v_y_1, v_y_1, v_n_b), v_n_b_lo1 = v_n_b_error + v_n_b_cross1,
      v_n_b_lo = v_n_b_lo1 + v_n_b_cross2, v_n_c = v_n_a + v_n_b,
      v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c), v_n_c_lo1 = v_n_c_error + v_n_a_lo,
      v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2, v_n_d_cross1 = v_y_2_lo * v_y_2,
      v_n_d_cross2 = v_y_2 * v_y_2_lo, v_n_d_error = ksl_product_error(v_y_2, v_y_2, v_n_d),
      v_n_d_lo1 = v_n_d_error + v_n_d_cross1, v_n_d_lo = v_n_d_lo1 + v_n_d_cross2,
      v_n_e = v_n_c + v_n_d, v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e),
      v_n_e_lo1 = v_n_e_error + v_n_c_lo, v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n = sqrt(v_n_e),
      v_n_product = v_n * v_n, v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_total = v_n + v_n_lo, n_added = n_total - v_n, n_remaining = v_n_lo - n_added,
      n = n_total * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_total - n_back,
      n_rest = n_lost + n_remaining, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half = atan2(n, upper_0), half_cross0 = upper_0 * n_lo, half_cross1 = n * upper_0_lo,
      half_cross = half_cross0 - half_cross1, half_square0 = upper_0 * upper_0,
      half_square1 = n * n, half_square = half_square0 + half_square1,
      half_lo = half_cross / half_square;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double unit_0 = upper_1 / divisor, unit_0_cross = unit_0 * divisor_lo,
      unit_0_product = unit_0 * divisor,
      unit_0_product_error = ksl_product_error(unit_0, divisor, unit_0_product),
      unit_0_rest = upper_1 - unit_0_product, unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_lo1 = unit_0_exact + upper_1_lo, unit_0_residual = unit_0_lo1 - unit_0_cross,
      unit_0_lo = unit_0_residual / divisor;
  const double unit_1 = upper_2 / divisor, unit_1_cross = unit_1 * divisor_lo,
      unit_1_product = unit_1 * divisor,
      unit_1_product_error = ksl_product_error(unit_1, divisor, unit_1_product),
      unit_1_rest = upper_2 - unit_1_product, unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_lo1 = unit_1_exact + upper_2_lo, unit_1_residual = unit_1_lo1 - unit_1_cross,
      unit_1_lo = unit_1_residual / divisor;
  const double unit_2 = upper_3 / divisor, unit_2_cross = unit_2 * divisor_lo,
      unit_2_product = unit_2 * divisor,
      unit_2_product_error = ksl_product_error(unit_2, divisor, unit_2_product),
      unit_2_rest = upper_3 - unit_2_product, unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_lo1 = unit_2_exact + upper_3_lo, unit_2_residual = unit_2_lo1 - unit_2_cross,
      unit_2_lo = unit_2_residual / divisor;
  const double angle = 2.0 * half, angle_cross1 = 2.0 * half_lo,
      angle_error = ksl_product_error(2.0, half, angle), angle_lo = angle_error + angle_cross1;
  const double axis_0 = n == 0.0 ? 1.0 : unit_0, axis_0_lo = n == 0.0 ? 0.0 : unit_0_lo;
  const double angle_total = angle + angle_lo,
      angle_rounded = angle_total == angle_total ? angle_total : angle;
  const double axis_0_total = axis_0 + axis_0_lo,
      axis_0_rounded = axis_0_total == axis_0_total ? axis_0_total : axis_0;
  const double unit_1_total = unit_1 + unit_1_lo,
      unit_1_rounded = unit_1_total == unit_1_total ? unit_1_total : unit_1;
  const double unit_2_total = unit_2 + unit_2_lo,
      unit_2_rounded = unit_2_total == unit_2_total ? unit_2_total : unit_2;
  return angle_rounded;
}

/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   84 mul, 156 add, 51 product error, 42 sum error, 6 neg.
   Error <= u |result| + 75 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_orthonormalize_accurate(ksl_mat3x3_t *self) {
  const double defect_0a = self->m00 * self->m00,
      defect_0a_lo = ksl_product_error(self->m00, self->m00, defect_0a),
      defect_0b = 1.0 - defect_0a,
      defect_0b_error = ksl_difference_error(1.0, defect_0a, defect_0b),
      defect_0b_lo = defect_0b_error - defect_0a_lo, defect_0c = self->m10 * self->m10,
      defect_0c_lo = ksl_product_error(self->m10, self->m10, defect_0c),
      defect_0d = defect_0b - defect_0c,
      defect_0d_error = ksl_difference_error(defect_0b, defect_0c, defect_0d),
      defect_0d_lo1 = defect_0d_error + defect_0b_lo, defect_0d_lo = defect_0d_lo1 - defect_0c_lo,
      defect_0e = self->m20 * self->m20,
      defect_0e_lo = ksl_product_error(self->m20, self->m20, defect_0e),
      defect_0 = defect_0d - defect_0e,
      defect_0_error = ksl_difference_error(defect_0d, defect_0e, defect_0),
      defect_0_lo1 = defect_0_error + defect_0d_lo, defect_0_lo = defect_0_lo1 - defect_0e_lo;
  const double defect_1a = self->m01 * self->m01,
      defect_1a_lo = ksl_product_error(self->m01, self->m01, defect_1a),
      defect_1b = 1.0 - defect_1a,
      defect_1b_error = ksl_difference_error(1.0, defect_1a, defect_1b),
      defect_1b_lo = defect_1b_error - defect_1a_lo, defect_1c = self->m11 * self->m11,
      defect_1c_lo = ksl_product_error(self->m11, self->m11, defect_1c),
      defect_1d = defect_1b - defect_1c,
      defect_1d_error = ksl_difference_error(defect_1b, defect_1c, defect_1d),
      defect_1d_lo1 = defect_1d_error + defect_1b_lo, defect_1d_lo = defect_1d_lo1 - defect_1c_lo,
      defect_1e = self->m21 * self->m21,
      defect_1e_lo = ksl_product_error(self->m21, self->m21, defect_1e),
      defect_1 = defect_1d - defect_1e,
      defect_1_error = ksl_difference_error(defect_1d, defect_1e, defect_1),
      defect_1_lo1 = defect_1_error + defect_1d_lo, defect_1_lo = defect_1_lo1 - defect_1e_lo;
  const double defect_2a = self->m02 * self->m02,
      defect_2a_lo = ksl_product_error(self->m02, self->m02, defect_2a),
      defect_2b = 1.0 - defect_2a,
      defect_2b_error = ksl_difference_error(1.0, defect_2a, defect_2b),
      defect_2b_lo = defect_2b_error - defect_2a_lo, defect_2c = self->m12 * self->m12,
      defect_2c_lo = ksl_product_error(self->m12, self->m12, defect_2c),
      defect_2d = defect_2b - defect_2c,
      defect_2d_error = ksl_difference_error(defect_2b, defect_2c, defect_2d),
      defect_2d_lo1 = defect_2d_error + defect_2b_lo, defect_2d_lo = defect_2d_lo1 - defect_2c_lo,
      defect_2e = self->m22 * self->m22,
      defect_2e_lo = ksl_product_error(self->m22, self->m22, defect_2e),
      defect_2 = defect_2d - defect_2e,
      defect_2_error = ksl_difference_error(defect_2d, defect_2e, defect_2),
      defect_2_lo1 = defect_2_error + defect_2d_lo, defect_2_lo = defect_2_lo1 - defect_2e_lo;
  const double defect_3a = self->m00 * self->m01,
      defect_3a_lo = ksl_product_error(self->m00, self->m01, defect_3a),
      defect_3b = self->m10 * self->m11,
      defect_3b_lo = ksl_product_error(self->m10, self->m11, defect_3b),
      defect_3c = defect_3a + defect_3b,
      defect_3c_error = ksl_sum_error(defect_3a, defect_3b, defect_3c),
      defect_3c_lo1 = defect_3c_error + defect_3a_lo, defect_3c_lo = defect_3c_lo1 + defect_3b_lo,
      defect_3d = self->m20 * self->m21,
      defect_3d_lo = ksl_product_error(self->m20, self->m21, defect_3d),
      defect_3e = defect_3c + defect_3d,
      defect_3e_error = ksl_sum_error(defect_3c, defect_3d, defect_3e),
      defect_3e_lo1 = defect_3e_error + defect_3c_lo, defect_3e_lo = defect_3e_lo1 + defect_3d_lo,
      defect_3 = -defect_3e, defect_3_lo = -defect_3e_lo;
  const double defect_4a = self->m00 * self->m02,
      defect_4a_lo = ksl_product_error(self->m00, self->m02, defect_4a),
      defect_4b = self->m10 * self->m12,
      defect_4b_lo = ksl_product_error(self->m10, self->m12, defect_4b),
      defect_4c = defect_4a + defect_4b,
      defect_4c_error = ksl_sum_error(defect_4a, defect_4b, defect_4c),
      defect_4c_lo1 = defect_4c_error + defect_4a_lo, defect_4c_lo = defect_4c_lo1 + defect_4b_lo,
      defect_4d = self->m20 * self->m22,
      defect_4d_lo = ksl_product_error(self->m20, self->m22, defect_4d),
      defect_4e = defect_4c + defect_4d,
      defect_4e_error = ksl_sum_error(defect_4c, defect_4d, defect_4e),
      defect_4e_lo1 = defect_4e_error + defect_4c_lo, defect_4e_lo = defect_4e_lo1 + defect_4d_lo,
      defect_4 = -defect_4e, defect_4_lo = -defect_4e_lo;
  const double defect_5a = self->m01 * self->m02,
      defect_5a_lo = ksl_product_error(self->m01, self->m02, defect_5a),
      defect_5b = self->m11 * self->m12,
      defect_5b_lo = ksl_product_error(self->m11, self->m12, defect_5b),
      defect_5c = defect_5a + defect_5b,
      defect_5c_error = ksl_sum_error(defect_5a, defect_5b, defect_5c),
      defect_5c_lo1 = defect_5c_error + defect_5a_lo, defect_5c_lo = defect_5c_lo1 + defect_5b_lo,
      defect_5d = self->m21 * self->m22,
      defect_5d_lo = ksl_product_error(self->m21, self->m22, defect_5d),
      defect_5e = defect_5c + defect_5d,
      defect_5e_error = ksl_sum_error(defect_5c, defect_5d, defect_5e),
      defect_5e_lo1 = defect_5e_error + defect_5c_lo, defect_5e_lo = defect_5e_lo1 + defect_5d_lo,
      defect_5 = -defect_5e, defect_5_lo = -defect_5e_lo;
  const double correction_0 = 0.5 * defect_0, correction_0_cross1 = 0.5 * defect_0_lo,
      correction_0_error = ksl_product_error(0.5, defect_0, correction_0),
      correction_0_lo = correction_0_error + correction_0_cross1;
  const double correction_1 = 0.5 * defect_1, correction_1_cross1 = 0.5 * defect_1_lo,
      correction_1_error = ksl_product_error(0.5, defect_1, correction_1),
      correction_1_lo = correction_1_error + correction_1_cross1;
  const double correction_2 = 0.5 * defect_2, correction_2_cross1 = 0.5 * defect_2_lo,
      correction_2_error = ksl_product_error(0.5, defect_2, correction_2),
      correction_2_lo = correction_2_error + correction_2_cross1;
  const double correction_3 = 0.5 * defect_3, correction_3_cross1 = 0.5 * defect_3_lo,
      correction_3_error = ksl_product_error(0.5, defect_3, correction_3),
      correction_3_lo = correction_3_error + correction_3_cross1;
  const double correction_4 = 0.5 * defect_4, correction_4_cross1 = 0.5 * defect_4_lo,
      correction_4_error = ksl_product_error(0.5, defect_4, correction_4),
      correction_4_lo = correction_4_error + correction_4_cross1;
  const double correction_5 = 0.5 * defect_5, correction_5_cross1 = 0.5 * defect_5_lo,
      correction_5_error = ksl_product_error(0.5, defect_5, correction_5),
      correction_5_lo = correction_5_error + correction_5_cross1;
  const double self_00_new_a = self->m00 * correction_0,
      self_00_new_a_cross1 = self->m00 * correction_0_lo,
      self_00_new_a_error = ksl_product_error(self->m00, correction_0, self_00_new_a),
      self_00_new_a_lo = self_00_new_a_error + self_00_new_a_cross1,
      self_00_new_b = self->m01 * correction_3, self_00_new_b_cross1 = self->m01 * correction_3_lo,
      self_00_new_b_error = ksl_product_error(self->m01, correction_3, self_00_new_b),
      self_00_new_b_lo = self_00_new_b_error + self_00_new_b_cross1,
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_c_error = ksl_sum_error(self_00_new_a, self_00_new_b, self_00_new_c),
      self_00_new_c_lo1 = self_00_new_c_error + self_00_new_a_lo,
      self_00_new_c_lo = self_00_new_c_lo1 + self_00_new_b_lo,
      self_00_new_d = self->m02 * correction_4, self_00_new_d_cross1 = self->m02 * correction_4_lo,
      self_00_new_d_error = ksl_product_error(self->m02, correction_4, self_00_new_d),
      self_00_new_d_lo = self_00_new_d_error + self_00_new_d_cross1,
      self_00_new_e = self_00_new_c + self_00_new_d,
      self_00_new_e_error = ksl_sum_error(self_00_new_c, self_00_new_d, self_00_new_e),
      self_00_new_e_lo1 = self_00_new_e_error + self_00_new_c_lo,
      self_00_new_e_lo = self_00_new_e_lo1 + self_00_new_d_lo,
      self_00_new = self->m00 + self_00_new_e,
      self_00_new_error = ksl_sum_error(self->m00, self_00_new_e, self_00_new),
      self_00_new_lo = self_00_new_error + self_00_new_e_lo;
  const double self_01_new_a = self->m00 * correction_3,
      self_01_new_a_cross1 = self->m00 * correction_3_lo,
      self_01_new_a_error = ksl_product_error(self->m00, correction_3, self_01_new_a),
      self_01_new_a_lo = self_01_new_a_error + self_01_new_a_cross1,
      self_01_new_b = self->m01 * correction_1, self_01_new_b_cross1 = self->m01 * correction_1_lo,
      self_01_new_b_error = ksl_product_error(self->m01, correction_1, self_01_new_b),
      self_01_new_b_lo = self_01_new_b_error + self_01_new_b_cross1,
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_c_error = ksl_sum_error(self_01_new_a, self_01_new_b, self_01_new_c),
      self_01_new_c_lo1 = self_01_new_c_error + self_01_new_a_lo,
      self_01_new_c_lo = self_01_new_c_lo1 + self_01_new_b_lo,
      self_01_new_d = self->m02 * correction_5, self_01_new_d_cross1 = self->m02 * correction_5_lo,
      self_01_new_d_error = ksl_product_error(self->m02, correction_5, self_01_new_d),
      self_01_new_d_lo = self_01_new_d_error + self_01_new_d_cross1,
      self_01_new_e = self_01_new_c + self_01_new_d,
      self_01_new_e_error = ksl_sum_error(self_01_new_c, self_01_new_d, self_01_new_e),
      self_01_new_e_lo1 = self_01_new_e_error + self_01_new_c_lo,
      self_01_new_e_lo = self_01_new_e_lo1 + self_01_new_d_lo,
      self_01_new = self_01_new_e + self->m01,
      self_01_new_error = ksl_sum_error(self_01_new_e, self->m01, self_01_new),
      self_01_new_lo = self_01_new_error + self_01_new_e_lo;
  const double self_02_new_a = self->m00 * correction_4,
      self_02_new_a_cross1 = self->m00 * correction_4_lo,
      self_02_new_a_error = ksl_product_error(self->m00, correction_4, self_02_new_a),
      self_02_new_a_lo = self_02_new_a_error + self_02_new_a_cross1,
      self_02_new_b = self->m01 * correction_5, self_02_new_b_cross1 = self->m01 * correction_5_lo,
      self_02_new_b_error = ksl_product_error(self->m01, correction_5, self_02_new_b),
      self_02_new_b_lo = self_02_new_b_error + self_02_new_b_cross1,
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_c_error = ksl_sum_error(self_02_new_a, self_02_new_b, self_02_new_c),
      self_02_new_c_lo1 = self_02_new_c_error + self_02_new_a_lo,
      self_02_new_c_lo = self_02_new_c_lo1 + self_02_new_b_lo,
      self_02_new_d = self->m02 * correction_2, self_02_new_d_cross1 = self->m02 * correction_2_lo,
      self_02_new_d_error = ksl_product_error(self->m02, correction_2, self_02_new_d),
      self_02_new_d_lo = self_02_new_d_error + self_02_new_d_cross1,
      self_02_new_e = self_02_new_c + self_02_new_d,
      self_02_new_e_error = ksl_sum_error(self_02_new_c, self_02_new_d, self_02_new_e),
      self_02_new_e_lo1 = self_02_new_e_error + self_02_new_c_lo,
      self_02_new_e_lo = self_02_new_e_lo1 + self_02_new_d_lo,
      self_02_new = self_02_new_e + self->m02,
      self_02_new_error = ksl_sum_error(self_02_new_e, self->m02, self_02_new),
      self_02_new_lo = self_02_new_error + self_02_new_e_lo;
  const double self_10_new_a = self->m10 * correction_0,
      self_10_new_a_cross1 = self->m10 * correction_0_lo,
      self_10_new_a_error = ksl_product_error(self->m10, correction_0, self_10_new_a),
      self_10_new_a_lo = self_10_new_a_error + self_10_new_a_cross1,
      self_10_new_b = self->m11 * correction_3, self_10_new_b_cross1 = self->m11 * correction_3_lo,
      self_10_new_b_error = ksl_product_error(self->m11, correction_3, self_10_new_b),
      self_10_new_b_lo = self_10_new_b_error + self_10_new_b_cross1,
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_c_error = ksl_sum_error(self_10_new_a, self_10_new_b, self_10_new_c),
      self_10_new_c_lo1 = self_10_new_c_error + self_10_new_a_lo,
      self_10_new_c_lo = self_10_new_c_lo1 + self_10_new_b_lo,
      self_10_new_d = self->m12 * correction_4, self_10_new_d_cross1 = self->m12 * correction_4_lo,
      self_10_new_d_error = ksl_product_error(self->m12, correction_4, self_10_new_d),
      self_10_new_d_lo = self_10_new_d_error + self_10_new_d_cross1,
      self_10_new_e = self_10_new_c + self_10_new_d,
      self_10_new_e_error = ksl_sum_error(self_10_new_c, self_10_new_d, self_10_new_e),
      self_10_new_e_lo1 = self_10_new_e_error + self_10_new_c_lo,
      self_10_new_e_lo = self_10_new_e_lo1 + self_10_new_d_lo,
      self_10_new = self->m10 + self_10_new_e,
      self_10_new_error = ksl_sum_error(self->m10, self_10_new_e, self_10_new),
      self_10_new_lo = self_10_new_error + self_10_new_e_lo;
  const double self_11_new_a = self->m10 * correction_3,
      self_11_new_a_cross1 = self->m10 * correction_3_lo,
      self_11_new_a_error = ksl_product_error(self->m10, correction_3, self_11_new_a),
      self_11_new_a_lo = self_11_new_a_error + self_11_new_a_cross1,
      self_11_new_b = self->m11 * correction_1, self_11_new_b_cross1 = self->m11 * correction_1_lo,
      self_11_new_b_error = ksl_product_error(self->m11, correction_1, self_11_new_b),
      self_11_new_b_lo = self_11_new_b_error + self_11_new_b_cross1,
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_c_error = ksl_sum_error(self_11_new_a, self_11_new_b, self_11_new_c),
      self_11_new_c_lo1 = self_11_new_c_error + self_11_new_a_lo,
      self_11_new_c_lo = self_11_new_c_lo1 + self_11_new_b_lo,
      self_11_new_d = self->m12 * correction_5, self_11_new_d_cross1 = self->m12 * correction_5_lo,
      self_11_new_d_error = ksl_product_error(self->m12, correction_5, self_11_new_d),
      self_11_new_d_lo = self_11_new_d_error + self_11_new_d_cross1,
      self_11_new_e = self_11_new_c + self_11_new_d,
      self_11_new_e_error = ksl_sum_error(self_11_new_c, self_11_new_d, self_11_new_e),
      self_11_new_e_lo1 = self_11_new_e_error + self_11_new_c_lo,
      self_11_new_e_lo = self_11_new_e_lo1 + self_11_new_d_lo,
      self_11_new = self_11_new_e + self->m11,
      self_11_new_error = ksl_sum_error(self_11_new_e, self->m11, self_11_new),
      self_11_new_lo = self_11_new_error + self_11_new_e_lo;
  const double self_12_new_a = self->m10 * correction_4,
      self_12_new_a_cross1 = self->m10 * correction_4_lo,
      self_12_new_a_error = ksl_product_error(self->m10, correction_4, self_12_new_a),
      self_12_new_a_lo = self_12_new_a_error + self_12_new_a_cross1,
      self_12_new_b = self->m11 * correction_5, self_12_new_b_cross1 = self->m11 * correction_5_lo,
      self_12_new_b_error = ksl_product_error(self->m11, correction_5, self_12_new_b),
      self_12_new_b_lo = self_12_new_b_error + self_12_new_b_cross1,
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_c_error = ksl_sum_error(self_12_new_a, self_12_new_b, self_12_new_c),
      self_12_new_c_lo1 = self_12_new_c_error + self_12_new_a_lo,
      self_12_new_c_lo = self_12_new_c_lo1 + self_12_new_b_lo,
      self_12_new_d = self->m12 * correction_2, self_12_new_d_cross1 = self->m12 * correction_2_lo,
      self_12_new_d_error = ksl_product_error(self->m12, correction_2, self_12_new_d),
      self_12_new_d_lo = self_12_new_d_error + self_12_new_d_cross1,
      self_12_new_e = self_12_new_c + self_12_new_d,
      self_12_new_e_error = ksl_sum_error(self_12_new_c, self_12_new_d, self_12_new_e),
      self_12_new_e_lo1 = self_12_new_e_error + self_12_new_c_lo,
      self_12_new_e_lo = self_12_new_e_lo1 + self_12_new_d_lo,
      self_12_new = self_12_new_e + self->m12,
      self_12_new_error = ksl_sum_error(self_12_new_e, self->m12, self_12_new),
      self_12_new_lo = self_12_new_error + self_12_new_e_lo;
  const double self_20_new_a = self->m20 * correction_0,
      self_20_new_a_cross1 = self->m20 * correction_0_lo,
      self_20_new_a_error = ksl_product_error(self->m20, correction_0, self_20_new_a),
      self_20_new_a_lo = self_20_new_a_error + self_20_new_a_cross1,
      self_20_new_b = self->m21 * correction_3, self_20_new_b_cross1 = self->m21 * correction_3_lo,
      self_20_new_b_error = ksl_product_error(self->m21, correction_3, self_20_new_b),
      self_20_new_b_lo = self_20_new_b_error + self_20_new_b_cross1,
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_c_error = ksl_sum_error(self_20_new_a, self_20_new_b, self_20_new_c),
      self_20_new_c_lo1 = self_20_new_c_error + self_20_new_a_lo,
      self_20_new_c_lo = self_20_new_c_lo1 + self_20_new_b_lo,
      self_20_new_d = self->m22 * correction_4, self_20_new_d_cross1 = self->m22 * correction_4_lo,
      self_20_new_d_error = ksl_product_error(self->m22, correction_4, self_20_new_d),
      self_20_new_d_lo = self_20_new_d_error + self_20_new_d_cross1,
      self_20_new_e = self_20_new_c + self_20_new_d,
      self_20_new_e_error = ksl_sum_error(self_20_new_c, self_20_new_d, self_20_new_e),
      self_20_new_e_lo1 = self_20_new_e_error + self_20_new_c_lo,
      self_20_new_e_lo = self_20_new_e_lo1 + self_20_new_d_lo,
      self_20_new = self->m20 + self_20_new_e,
      self_20_new_error = ksl_sum_error(self->m20, self_20_new_e, self_20_new),
      self_20_new_lo = self_20_new_error + self_20_new_e_lo;
  const double self_21_new_a = self->m20 * correction_3,
      self_21_new_a_cross1 = self->m20 * correction_3_lo,
      self_21_new_a_error = ksl_product_error(self->m20, correction_3, self_21_new_a),
      self_21_new_a_lo = self_21_new_a_error + self_21_new_a_cross1,
      self_21_new_b = self->m21 * correction_1, self_21_new_b_cross1 = self->m21 * correction_1_lo,
      self_21_new_b_error = ksl_product_error(self->m21, correction_1, self_21_new_b),
      self_21_new_b_lo = self_21_new_b_error + self_21_new_b_cross1,
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_c_error = ksl_sum_error(self_21_new_a, self_21_new_b, self_21_new_c),
      self_21_new_c_lo1 = self_21_new_c_error + self_21_new_a_lo,
      self_21_new_c_lo = self_21_new_c_lo1 + self_21_new_b_lo,
      self_21_new_d = self->m22 * correction_5, self_21_new_d_cross1 = self->m22 * correction_5_lo,
      self_21_new_d_error = ksl_product_error(self->m22, correction_5, self_21_new_d),
      self_21_new_d_lo = self_21_new_d_error + self_21_new_d_cross1,
      self_21_new_e = self_21_new_c + self_21_new_d,
      self_21_new_e_error = ksl_sum_error(self_21_new_c, self_21_new_d, self_21_new_e),
      self_21_new_e_lo1 = self_21_new_e_error + self_21_new_c_lo,
      self_21_new_e_lo = self_21_new_e_lo1 + self_21_new_d_lo,
      self_21_new = self_21_new_e + self->m21,
      self_21_new_error = ksl_sum_error(self_21_new_e, self->m21, self_21_new),
      self_21_new_lo = self_21_new_error + self_21_new_e_lo;
  const double self_22_new_a = self->m20 * correction_4,
      self_22_new_a_cross1 = self->m20 * correction_4_lo,
      self_22_new_a_error = ksl_product_error(self->m20, correction_4, self_22_new_a),
      self_22_new_a_lo = self_22_new_a_error + self_22_new_a_cross1,
      self_22_new_b = self->m21 * correction_5, self_22_new_b_cross1 = self->m21 * correction_5_lo,
      self_22_new_b_error = ksl_product_error(self->m21, correction_5, self_22_new_b),
      self_22_new_b_lo = self_22_new_b_error + self_22_new_b_cross1,
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_c_error = ksl_sum_error(self_22_new_a, self_22_new_b, self_22_new_c),
      self_22_new_c_lo1 = self_22_new_c_error + self_22_new_a_lo,
      self_22_new_c_lo = self_22_new_c_lo1 + self_22_new_b_lo,
      self_22_new_d = self->m22 * correction_2, self_22_new_d_cross1 = self->m22 * correction_2_lo,
      self_22_new_d_error = ksl_product_error(self->m22, correction_2, self_22_new_d),
      self_22_new_d_lo = self_22_new_d_error + self_22_new_d_cross1,
      self_22_new_e = self_22_new_c + self_22_new_d,
      self_22_new_e_error = ksl_sum_error(self_22_new_c, self_22_new_d, self_22_new_e),
      self_22_new_e_lo1 = self_22_new_e_error + self_22_new_c_lo,
      self_22_new_e_lo = self_22_new_e_lo1 + self_22_new_d_lo,
      self_22_new = self_22_new_e + self->m22,
      self_22_new_error = ksl_sum_error(self_22_new_e, self->m22, self_22_new),
      self_22_new_lo = self_22_new_error + self_22_new_e_lo;
  const double self_00_new_rounded = self_00_new + self_00_new_lo;
  const double self_01_new_rounded = self_01_new + self_01_new_lo;
  const double self_02_new_rounded = self_02_new + self_02_new_lo;
  const double self_10_new_rounded = self_10_new + self_10_new_lo;
  const double self_11_new_rounded = self_11_new + self_11_new_lo;
  const double self_12_new_rounded = self_12_new + self_12_new_lo;
  const double self_20_new_rounded = self_20_new + self_20_new_lo;
  const double self_21_new_rounded = self_21_new + self_21_new_lo;
  const double self_22_new_rounded = self_22_new + self_22_new_lo;
  self->m00 = self_00_new_rounded;
  self->m01 = self_01_new_rounded;
  self->m02 = self_02_new_rounded;
  self->m10 = self_10_new_rounded;
  self->m11 = self_11_new_rounded;
  self->m12 = self_12_new_rounded;
  self->m20 = self_20_new_rounded;
  self->m21 = self_21_new_rounded;
  self->m22 = self_22_new_rounded;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   84 mul, 156 add, 51 product error, 42 sum error, 6 neg.
   Error <= u |result| + 75 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_orthonormalized_accurate(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0a = R->m00 * R->m00,
      defect_0a_lo = ksl_product_error(R->m00, R->m00, defect_0a), defect_0b = 1.0 - defect_0a,
      defect_0b_error = ksl_difference_error(1.0, defect_0a, defect_0b),
      defect_0b_lo = defect_0b_error - defect_0a_lo, defect_0c = R->m10 * R->m10,
      defect_0c_lo = ksl_product_error(R->m10, R->m10, defect_0c),
      defect_0d = defect_0b - defect_0c,
      defect_0d_error = ksl_difference_error(defect_0b, defect_0c, defect_0d),
      defect_0d_lo1 = defect_0d_error + defect_0b_lo, defect_0d_lo = defect_0d_lo1 - defect_0c_lo,
      defect_0e = R->m20 * R->m20, defect_0e_lo = ksl_product_error(R->m20, R->m20, defect_0e),
      defect_0 = defect_0d - defect_0e,
      defect_0_error = ksl_difference_error(defect_0d, defect_0e, defect_0),
      defect_0_lo1 = defect_0_error + defect_0d_lo, defect_0_lo = defect_0_lo1 - defect_0e_lo;
  const double defect_1a = R->m01 * R->m01,
      defect_1a_lo = ksl_product_error(R->m01, R->m01, defect_1a), defect_1b = 1.0 - defect_1a,
      defect_1b_error = ksl_difference_error(1.0, defect_1a, defect_1b),
      defect_1b_lo = defect_1b_error - defect_1a_lo, defect_1c = R->m11 * R->m11,
      defect_1c_lo = ksl_product_error(R->m11, R->m11, defect_1c),
      defect_1d = defect_1b - defect_1c,
      defect_1d_error = ksl_difference_error(defect_1b, defect_1c, defect_1d),
      defect_1d_lo1 = defect_1d_error + defect_1b_lo, defect_1d_lo = defect_1d_lo1 - defect_1c_lo,
      defect_1e = R->m21 * R->m21, defect_1e_lo = ksl_product_error(R->m21, R->m21, defect_1e),
      defect_1 = defect_1d - defect_1e,
      defect_1_error = ksl_difference_error(defect_1d, defect_1e, defect_1),
      defect_1_lo1 = defect_1_error + defect_1d_lo, defect_1_lo = defect_1_lo1 - defect_1e_lo;
  const double defect_2a = R->m02 * R->m02,
      defect_2a_lo = ksl_product_error(R->m02, R->m02, defect_2a), defect_2b = 1.0 - defect_2a,
      defect_2b_error = ksl_difference_error(1.0, defect_2a, defect_2b),
      defect_2b_lo = defect_2b_error - defect_2a_lo, defect_2c = R->m12 * R->m12,
      defect_2c_lo = ksl_product_error(R->m12, R->m12, defect_2c),
      defect_2d = defect_2b - defect_2c,
      defect_2d_error = ksl_difference_error(defect_2b, defect_2c, defect_2d),
      defect_2d_lo1 = defect_2d_error + defect_2b_lo, defect_2d_lo = defect_2d_lo1 - defect_2c_lo,
      defect_2e = R->m22 * R->m22, defect_2e_lo = ksl_product_error(R->m22, R->m22, defect_2e),
      defect_2 = defect_2d - defect_2e,
      defect_2_error = ksl_difference_error(defect_2d, defect_2e, defect_2),
      defect_2_lo1 = defect_2_error + defect_2d_lo, defect_2_lo = defect_2_lo1 - defect_2e_lo;
  const double defect_3a = R->m00 * R->m01,
      defect_3a_lo = ksl_product_error(R->m00, R->m01, defect_3a), defect_3b = R->m10 * R->m11,
      defect_3b_lo = ksl_product_error(R->m10, R->m11, defect_3b),
      defect_3c = defect_3a + defect_3b,
      defect_3c_error = ksl_sum_error(defect_3a, defect_3b, defect_3c),
      defect_3c_lo1 = defect_3c_error + defect_3a_lo, defect_3c_lo = defect_3c_lo1 + defect_3b_lo,
      defect_3d = R->m20 * R->m21, defect_3d_lo = ksl_product_error(R->m20, R->m21, defect_3d),
      defect_3e = defect_3c + defect_3d,
      defect_3e_error = ksl_sum_error(defect_3c, defect_3d, defect_3e),
      defect_3e_lo1 = defect_3e_error + defect_3c_lo, defect_3e_lo = defect_3e_lo1 + defect_3d_lo,
      defect_3 = -defect_3e, defect_3_lo = -defect_3e_lo;
  const double defect_4a = R->m00 * R->m02,
      defect_4a_lo = ksl_product_error(R->m00, R->m02, defect_4a), defect_4b = R->m10 * R->m12,
      defect_4b_lo = ksl_product_error(R->m10, R->m12, defect_4b),
      defect_4c = defect_4a + defect_4b,
      defect_4c_error = ksl_sum_error(defect_4a, defect_4b, defect_4c),
      defect_4c_lo1 = defect_4c_error + defect_4a_lo, defect_4c_lo = defect_4c_lo1 + defect_4b_lo,
      defect_4d = R->m20 * R->m22, defect_4d_lo = ksl_product_error(R->m20, R->m22, defect_4d),
      defect_4e = defect_4c + defect_4d,
      defect_4e_error = ksl_sum_error(defect_4c, defect_4d, defect_4e),
      defect_4e_lo1 = defect_4e_error + defect_4c_lo, defect_4e_lo = defect_4e_lo1 + defect_4d_lo,
      defect_4 = -defect_4e, defect_4_lo = -defect_4e_lo;
  const double defect_5a = R->m01 * R->m02,
      defect_5a_lo = ksl_product_error(R->m01, R->m02, defect_5a), defect_5b = R->m11 * R->m12,
      defect_5b_lo = ksl_product_error(R->m11, R->m12, defect_5b),
      defect_5c = defect_5a + defect_5b,
      defect_5c_error = ksl_sum_error(defect_5a, defect_5b, defect_5c),
      defect_5c_lo1 = defect_5c_error + defect_5a_lo, defect_5c_lo = defect_5c_lo1 + defect_5b_lo,
      defect_5d = R->m21 * R->m22, defect_5d_lo = ksl_product_error(R->m21, R->m22, defect_5d),
      defect_5e = defect_5c + defect_5d,
      defect_5e_error = ksl_sum_error(defect_5c, defect_5d, defect_5e),
      defect_5e_lo1 = defect_5e_error + defect_5c_lo, defect_5e_lo = defect_5e_lo1 + defect_5d_lo,
      defect_5 = -defect_5e, defect_5_lo = -defect_5e_lo;
  const double correction_0 = 0.5 * defect_0, correction_0_cross1 = 0.5 * defect_0_lo,
      correction_0_error = ksl_product_error(0.5, defect_0, correction_0),
      correction_0_lo = correction_0_error + correction_0_cross1;
  const double correction_1 = 0.5 * defect_1, correction_1_cross1 = 0.5 * defect_1_lo,
      correction_1_error = ksl_product_error(0.5, defect_1, correction_1),
      correction_1_lo = correction_1_error + correction_1_cross1;
  const double correction_2 = 0.5 * defect_2, correction_2_cross1 = 0.5 * defect_2_lo,
      correction_2_error = ksl_product_error(0.5, defect_2, correction_2),
      correction_2_lo = correction_2_error + correction_2_cross1;
  const double correction_3 = 0.5 * defect_3, correction_3_cross1 = 0.5 * defect_3_lo,
      correction_3_error = ksl_product_error(0.5, defect_3, correction_3),
      correction_3_lo = correction_3_error + correction_3_cross1;
  const double correction_4 = 0.5 * defect_4, correction_4_cross1 = 0.5 * defect_4_lo,
      correction_4_error = ksl_product_error(0.5, defect_4, correction_4),
      correction_4_lo = correction_4_error + correction_4_cross1;
  const double correction_5 = 0.5 * defect_5, correction_5_cross1 = 0.5 * defect_5_lo,
      correction_5_error = ksl_product_error(0.5, defect_5, correction_5),
      correction_5_lo = correction_5_error + correction_5_cross1;
  const double Ro_00a = R->m00 * correction_0, Ro_00a_cross1 = R->m00 * correction_0_lo,
      Ro_00a_error = ksl_product_error(R->m00, correction_0, Ro_00a),
      Ro_00a_lo = Ro_00a_error + Ro_00a_cross1, Ro_00b = R->m01 * correction_3,
      Ro_00b_cross1 = R->m01 * correction_3_lo,
      Ro_00b_error = ksl_product_error(R->m01, correction_3, Ro_00b),
      Ro_00b_lo = Ro_00b_error + Ro_00b_cross1, Ro_00c = Ro_00a + Ro_00b,
      Ro_00c_error = ksl_sum_error(Ro_00a, Ro_00b, Ro_00c), Ro_00c_lo1 = Ro_00c_error + Ro_00a_lo,
      Ro_00c_lo = Ro_00c_lo1 + Ro_00b_lo, Ro_00d = R->m02 * correction_4,
      Ro_00d_cross1 = R->m02 * correction_4_lo,
      Ro_00d_error = ksl_product_error(R->m02, correction_4, Ro_00d),
      Ro_00d_lo = Ro_00d_error + Ro_00d_cross1, Ro_00e = Ro_00c + Ro_00d,
      Ro_00e_error = ksl_sum_error(Ro_00c, Ro_00d, Ro_00e), Ro_00e_lo1 = Ro_00e_error + Ro_00c_lo,
      Ro_00e_lo = Ro_00e_lo1 + Ro_00d_lo, Ro_00 = R->m00 + Ro_00e,
      Ro_00_error = ksl_sum_error(R->m00, Ro_00e, Ro_00), Ro_00_lo = Ro_00_error + Ro_00e_lo;
  const double Ro_01a = R->m00 * correction_3, Ro_01a_cross1 = R->m00 * correction_3_lo,
      Ro_01a_error = ksl_product_error(R->m00, correction_3, Ro_01a),
      Ro_01a_lo = Ro_01a_error + Ro_01a_cross1, Ro_01b = R->m01 * correction_1,
      Ro_01b_cross1 = R->m01 * correction_1_lo,
      Ro_01b_error = ksl_product_error(R->m01, correction_1, Ro_01b),
      Ro_01b_lo = Ro_01b_error + Ro_01b_cross1, Ro_01c = Ro_01a + Ro_01b,
      Ro_01c_error = ksl_sum_error(Ro_01a, Ro_01b, Ro_01c), Ro_01c_lo1 = Ro_01c_error + Ro_01a_lo,
      Ro_01c_lo = Ro_01c_lo1 + Ro_01b_lo, Ro_01d = R->m02 * correction_5,
      Ro_01d_cross1 = R->m02 * correction_5_lo,
      Ro_01d_error = ksl_product_error(R->m02, correction_5, Ro_01d),
      Ro_01d_lo = Ro_01d_error + Ro_01d_cross1, Ro_01e = Ro_01c + Ro_01d,
      Ro_01e_error = ksl_sum_error(Ro_01c, Ro_01d, Ro_01e), Ro_01e_lo1 = Ro_01e_error + Ro_01c_lo,
      Ro_01e_lo = Ro_01e_lo1 + Ro_01d_lo, Ro_01 = Ro_01e + R->m01,
      Ro_01_error = ksl_sum_error(Ro_01e, R->m01, Ro_01), Ro_01_lo = Ro_01_error + Ro_01e_lo;
  const double Ro_02a = R->m00 * correction_4, Ro_02a_cross1 = R->m00 * correction_4_lo,
      Ro_02a_error = ksl_product_error(R->m00, correction_4, Ro_02a),
      Ro_02a_lo = Ro_02a_error + Ro_02a_cross1, Ro_02b = R->m01 * correction_5,
      Ro_02b_cross1 = R->m01 * correction_5_lo,
      Ro_02b_error = ksl_product_error(R->m01, correction_5, Ro_02b),
      Ro_02b_lo = Ro_02b_error + Ro_02b_cross1, Ro_02c = Ro_02a + Ro_02b,
      Ro_02c_error = ksl_sum_error(Ro_02a, Ro_02b, Ro_02c), Ro_02c_lo1 = Ro_02c_error + Ro_02a_lo,
      Ro_02c_lo = Ro_02c_lo1 + Ro_02b_lo, Ro_02d = R->m02 * correction_2,
      Ro_02d_cross1 = R->m02 * correction_2_lo,
      Ro_02d_error = ksl_product_error(R->m02, correction_2, Ro_02d),
      Ro_02d_lo = Ro_02d_error + Ro_02d_cross1, Ro_02e = Ro_02c + Ro_02d,
      Ro_02e_error = ksl_sum_error(Ro_02c, Ro_02d, Ro_02e), Ro_02e_lo1 = Ro_02e_error + Ro_02c_lo,
      Ro_02e_lo = Ro_02e_lo1 + Ro_02d_lo, Ro_02 = Ro_02e + R->m02,
      Ro_02_error = ksl_sum_error(Ro_02e, R->m02, Ro_02), Ro_02_lo = Ro_02_error + Ro_02e_lo;
  const double Ro_10a = R->m10 * correction_0, Ro_10a_cross1 = R->m10 * correction_0_lo,
      Ro_10a_error = ksl_product_error(R->m10, correction_0, Ro_10a),
      Ro_10a_lo = Ro_10a_error + Ro_10a_cross1, Ro_10b = R->m11 * correction_3,
      Ro_10b_cross1 = R->m11 * correction_3_lo,
      Ro_10b_error = ksl_product_error(R->m11, correction_3, Ro_10b),
      Ro_10b_lo = Ro_10b_error + Ro_10b_cross1, Ro_10c = Ro_10a + Ro_10b,
      Ro_10c_error = ksl_sum_error(Ro_10a, Ro_10b, Ro_10c), Ro_10c_lo1 = Ro_10c_error + Ro_10a_lo,
      Ro_10c_lo = Ro_10c_lo1 + Ro_10b_lo, Ro_10d = R->m12 * correction_4,
      Ro_10d_cross1 = R->m12 * correction_4_lo,
      Ro_10d_error = ksl_product_error(R->m12, correction_4, Ro_10d),
      Ro_10d_lo = Ro_10d_error + Ro_10d_cross1, Ro_10e = Ro_10c + Ro_10d,
      Ro_10e_error = ksl_sum_error(Ro_10c, Ro_10d, Ro_10e), Ro_10e_lo1 = Ro_10e_error + Ro_10c_lo,
      Ro_10e_lo = Ro_10e_lo1 + Ro_10d_lo, Ro_10 = R->m10 + Ro_10e,
      Ro_10_error = ksl_sum_error(R->m10, Ro_10e, Ro_10), Ro_10_lo = Ro_10_error + Ro_10e_lo;
  const double Ro_11a = R->m10 * correction_3, Ro_11a_cross1 = R->m10 * correction_3_lo,
      Ro_11a_error = ksl_product_error(R->m10, correction_3, Ro_11a),
      Ro_11a_lo = Ro_11a_error + Ro_11a_cross1, Ro_11b = R->m11 * correction_1,
      Ro_11b_cross1 = R->m11 * correction_1_lo,
      Ro_11b_error = ksl_product_error(R->m11, correction_1, Ro_11b),
      Ro_11b_lo = Ro_11b_error + Ro_11b_cross1, Ro_11c = Ro_11a + Ro_11b,
      Ro_11c_error = ksl_sum_error(Ro_11a, Ro_11b, Ro_11c), Ro_11c_lo1 = Ro_11c_error + Ro_11a_lo,
      Ro_11c_lo = Ro_11c_lo1 + Ro_11b_lo, Ro_11d = R->m12 * correction_5,
      Ro_11d_cross1 = R->m12 * correction_5_lo,
      Ro_11d_error = ksl_product_error(R->m12, correction_5, Ro_11d),
      Ro_11d_lo = Ro_11d_error + Ro_11d_cross1, Ro_11e = Ro_11c + Ro_11d,
      Ro_11e_error = ksl_sum_error(Ro_11c, Ro_11d, Ro_11e), Ro_11e_lo1 = Ro_11e_error + Ro_11c_lo,
      Ro_11e_lo = Ro_11e_lo1 + Ro_11d_lo, Ro_11 = Ro_11e + R->m11,
      Ro_11_error = ksl_sum_error(Ro_11e, R->m11, Ro_11), Ro_11_lo = Ro_11_error + Ro_11e_lo;
  const double Ro_12a = R->m10 * correction_4, Ro_12a_cross1 = R->m10 * correction_4_lo,
      Ro_12a_error = ksl_product_error(R->m10, correction_4, Ro_12a),
      Ro_12a_lo = Ro_12a_error + Ro_12a_cross1, Ro_12b = R->m11 * correction_5,
      Ro_12b_cross1 = R->m11 * correction_5_lo,
      Ro_12b_error = ksl_product_error(R->m11, correction_5, Ro_12b),
      Ro_12b_lo = Ro_12b_error + Ro_12b_cross1, Ro_12c = Ro_12a + Ro_12b,
      Ro_12c_error = ksl_sum_error(Ro_12a, Ro_12b, Ro_12c), Ro_12c_lo1 = Ro_12c_error + Ro_12a_lo,
      Ro_12c_lo = Ro_12c_lo1 + Ro_12b_lo, Ro_12d = R->m12 * correction_2,
      Ro_12d_cross1 = R->m12 * correction_2_lo,
      Ro_12d_error = ksl_product_error(R->m12, correction_2, Ro_12d),
      Ro_12d_lo = Ro_12d_error + Ro_12d_cross1, Ro_12e = Ro_12c + Ro_12d,
      Ro_12e_error = ksl_sum_error(Ro_12c, Ro_12d, Ro_12e), Ro_12e_lo1 = Ro_12e_error + Ro_12c_lo,
      Ro_12e_lo = Ro_12e_lo1 + Ro_12d_lo, Ro_12 = Ro_12e + R->m12,
      Ro_12_error = ksl_sum_error(Ro_12e, R->m12, Ro_12), Ro_12_lo = Ro_12_error + Ro_12e_lo;
  const double Ro_20a = R->m20 * correction_0, Ro_20a_cross1 = R->m20 * correction_0_lo,
      Ro_20a_error = ksl_product_error(R->m20, correction_0, Ro_20a),
      Ro_20a_lo = Ro_20a_error + Ro_20a_cross1, Ro_20b = R->m21 * correction_3,
      Ro_20b_cross1 = R->m21 * correction_3_lo,
      Ro_20b_error = ksl_product_error(R->m21, correction_3, Ro_20b),
      Ro_20b_lo = Ro_20b_error + Ro_20b_cross1, Ro_20c = Ro_20a + Ro_20b,
      Ro_20c_error = ksl_sum_error(Ro_20a, Ro_20b, Ro_20c), Ro_20c_lo1 = Ro_20c_error + Ro_20a_lo,
      Ro_20c_lo = Ro_20c_lo1 + Ro_20b_lo, Ro_20d = R->m22 * correction_4,
      Ro_20d_cross1 = R->m22 * correction_4_lo,
      Ro_20d_error = ksl_product_error(R->m22, correction_4, Ro_20d),
      Ro_20d_lo = Ro_20d_error + Ro_20d_cross1, Ro_20e = Ro_20c + Ro_20d,
      Ro_20e_error = ksl_sum_error(Ro_20c, Ro_20d, Ro_20e), Ro_20e_lo1 = Ro_20e_error + Ro_20c_lo,
      Ro_20e_lo = Ro_20e_lo1 + Ro_20d_lo, Ro_20 = R->m20 + Ro_20e,
      Ro_20_error = ksl_sum_error(R->m20, Ro_20e, Ro_20), Ro_20_lo = Ro_20_error + Ro_20e_lo;
  const double Ro_21a = R->m20 * correction_3, Ro_21a_cross1 = R->m20 * correction_3_lo,
      Ro_21a_error = ksl_product_error(R->m20, correction_3, Ro_21a),
      Ro_21a_lo = Ro_21a_error + Ro_21a_cross1, Ro_21b = R->m21 * correction_1,
      Ro_21b_cross1 = R->m21 * correction_1_lo,
      Ro_21b_error = ksl_product_error(R->m21, correction_1, Ro_21b),
      Ro_21b_lo = Ro_21b_error + Ro_21b_cross1, Ro_21c = Ro_21a + Ro_21b,
      Ro_21c_error = ksl_sum_error(Ro_21a, Ro_21b, Ro_21c), Ro_21c_lo1 = Ro_21c_error + Ro_21a_lo,
      Ro_21c_lo = Ro_21c_lo1 + Ro_21b_lo, Ro_21d = R->m22 * correction_5,
      Ro_21d_cross1 = R->m22 * correction_5_lo,
      Ro_21d_error = ksl_product_error(R->m22, correction_5, Ro_21d),
      Ro_21d_lo = Ro_21d_error + Ro_21d_cross1, Ro_21e = Ro_21c + Ro_21d,
      Ro_21e_error = ksl_sum_error(Ro_21c, Ro_21d, Ro_21e), Ro_21e_lo1 = Ro_21e_error + Ro_21c_lo,
      Ro_21e_lo = Ro_21e_lo1 + Ro_21d_lo, Ro_21 = Ro_21e + R->m21,
      Ro_21_error = ksl_sum_error(Ro_21e, R->m21, Ro_21), Ro_21_lo = Ro_21_error + Ro_21e_lo;
  const double Ro_22a = R->m20 * correction_4, Ro_22a_cross1 = R->m20 * correction_4_lo,
      Ro_22a_error = ksl_product_error(R->m20, correction_4, Ro_22a),
      Ro_22a_lo = Ro_22a_error + Ro_22a_cross1, Ro_22b = R->m21 * correction_5,
      Ro_22b_cross1 = R->m21 * correction_5_lo,
      Ro_22b_error = ksl_product_error(R->m21, correction_5, Ro_22b),
      Ro_22b_lo = Ro_22b_error + Ro_22b_cross1, Ro_22c = Ro_22a + Ro_22b,
      Ro_22c_error = ksl_sum_error(Ro_22a, Ro_22b, Ro_22c), Ro_22c_lo1 = Ro_22c_error + Ro_22a_lo,
      Ro_22c_lo = Ro_22c_lo1 + Ro_22b_lo, Ro_22d = R->m22 * correction_2,
      Ro_22d_cross1 = R->m22 * correction_2_lo,
      Ro_22d_error = ksl_product_error(R->m22, correction_2, Ro_22d),
      Ro_22d_lo = Ro_22d_error + Ro_22d_cross1, Ro_22e = Ro_22c + Ro_22d,
      Ro_22e_error = ksl_sum_error(Ro_22c, Ro_22d, Ro_22e), Ro_22e_lo1 = Ro_22e_error + Ro_22c_lo,
      Ro_22e_lo = Ro_22e_lo1 + Ro_22d_lo, Ro_22 = Ro_22e + R->m22,
      Ro_22_error = ksl_sum_error(Ro_22e, R->m22, Ro_22), Ro_22_lo = Ro_22_error + Ro_22e_lo;
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

/* vo with exp vo~ = R, |vo| <= π; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; vo: vector.
   11 mul, 20 add, 1 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 10 less, 1 equal, 23 select. */
static inline void ksl_SO3_logf_accurate(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double d_0a = (double)R->m00 + (double)R->m11, d_0b = d_0a + (double)R->m22,
      d_0 = d_0b + 1.0;
  const double d_1a = (double)R->m00 - (double)R->m11, d_1b = d_1a - (double)R->m22,
      d_1 = d_1b + 1.0;
  const double d_2a = (double)R->m11 - (double)R->m00, d_2b = d_2a - (double)R->m22,
      d_2 = d_2b + 1.0;
  const double d_3a = (double)R->m22 - (double)R->m00, d_3b = d_3a - (double)R->m11,
      d_3 = d_3b + 1.0;
  const double low_0 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double low_1 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_3 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double high_1 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_2 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_3 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_0 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_0 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_0 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_0 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = 2.0 * half;
  const double k = theta / divisor;
  const double vector_0 = upper_1 * k;
  const double vector_1 = upper_2 * k;
  const double vector_2 = upper_3 * k;
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) where angle = 0.
   R: rotation or other 3×3 matrix; axis: vector.
   8 mul, 20 add, 3 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 10 less, 1 equal, 24 select. */
static inline float ksl_axis_angle_from_mat3x3f_accurate(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *axis) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double d_0a = (double)R->m00 + (double)R->m11, d_0b = d_0a + (double)R->m22,
      d_0 = d_0b + 1.0;
  const double d_1a = (double)R->m00 - (double)R->m11, d_1b = d_1a - (double)R->m22,
      d_1 = d_1b + 1.0;
  const double d_2a = (double)R->m11 - (double)R->m00, d_2b = d_2a - (double)R->m22,
      d_2 = d_2b + 1.0;
  const double d_3a = (double)R->m22 - (double)R->m00, d_3b = d_3a - (double)R->m11,
      d_3 = d_3b + 1.0;
  const double low_0 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double low_1 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_3 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double high_1 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_2 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_3 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_0 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_0 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_0 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_0 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = upper_1 / divisor;
  const double unit_1 = upper_2 / divisor;
  const double unit_2 = upper_3 / divisor;
  const double angle = 2.0 * half;
  const double axis_0 = n == 0.0 ? 1.0 : unit_0;
  return (float)angle;
}

/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 9/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_orthonormalize_accurate(ksl_mat3x3f_t *self) {
  const double defect_0a = (double)self->m00 * (double)self->m00, defect_0b = 1.0 - defect_0a,
      defect_0c = (double)self->m10 * (double)self->m10, defect_0d = defect_0b - defect_0c,
      defect_0e = (double)self->m20 * (double)self->m20, defect_0 = defect_0d - defect_0e;
  const double defect_1a = (double)self->m01 * (double)self->m01, defect_1b = 1.0 - defect_1a,
      defect_1c = (double)self->m11 * (double)self->m11, defect_1d = defect_1b - defect_1c,
      defect_1e = (double)self->m21 * (double)self->m21, defect_1 = defect_1d - defect_1e;
  const double defect_2a = (double)self->m02 * (double)self->m02, defect_2b = 1.0 - defect_2a,
      defect_2c = (double)self->m12 * (double)self->m12, defect_2d = defect_2b - defect_2c,
      defect_2e = (double)self->m22 * (double)self->m22, defect_2 = defect_2d - defect_2e;
  const double defect_3a = (double)self->m00 * (double)self->m01,
      defect_3b = (double)self->m10 * (double)self->m11, defect_3c = defect_3a + defect_3b,
      defect_3d = (double)self->m20 * (double)self->m21, defect_3e = defect_3c + defect_3d,
      defect_3 = -defect_3e;
  const double defect_4a = (double)self->m00 * (double)self->m02,
      defect_4b = (double)self->m10 * (double)self->m12, defect_4c = defect_4a + defect_4b,
      defect_4d = (double)self->m20 * (double)self->m22, defect_4e = defect_4c + defect_4d,
      defect_4 = -defect_4e;
  const double defect_5a = (double)self->m01 * (double)self->m02,
      defect_5b = (double)self->m11 * (double)self->m12, defect_5c = defect_5a + defect_5b,
      defect_5d = (double)self->m21 * (double)self->m22, defect_5e = defect_5c + defect_5d,
      defect_5 = -defect_5e;
  const double correction_0 = 0.5 * defect_0;
  const double correction_1 = 0.5 * defect_1;
  const double correction_2 = 0.5 * defect_2;
  const double correction_3 = 0.5 * defect_3;
  const double correction_4 = 0.5 * defect_4;
  const double correction_5 = 0.5 * defect_5;
  const double self_00_new_a = (double)self->m00 * correction_0,
      self_00_new_b = (double)self->m01 * correction_3,
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = (double)self->m02 * correction_4,
      self_00_new_e = self_00_new_c + self_00_new_d,
      self_00_new = (double)self->m00 + self_00_new_e;
  const double self_01_new_a = (double)self->m00 * correction_3,
      self_01_new_b = (double)self->m01 * correction_1,
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = (double)self->m02 * correction_5,
      self_01_new_e = self_01_new_c + self_01_new_d,
      self_01_new = self_01_new_e + (double)self->m01;
  const double self_02_new_a = (double)self->m00 * correction_4,
      self_02_new_b = (double)self->m01 * correction_5,
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = (double)self->m02 * correction_2,
      self_02_new_e = self_02_new_c + self_02_new_d,
      self_02_new = self_02_new_e + (double)self->m02;
  const double self_10_new_a = (double)self->m10 * correction_0,
      self_10_new_b = (double)self->m11 * correction_3,
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = (double)self->m12 * correction_4,
      self_10_new_e = self_10_new_c + self_10_new_d,
      self_10_new = (double)self->m10 + self_10_new_e;
  const double self_11_new_a = (double)self->m10 * correction_3,
      self_11_new_b = (double)self->m11 * correction_1,
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = (double)self->m12 * correction_5,
      self_11_new_e = self_11_new_c + self_11_new_d,
      self_11_new = self_11_new_e + (double)self->m11;
  const double self_12_new_a = (double)self->m10 * correction_4,
      self_12_new_b = (double)self->m11 * correction_5,
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = (double)self->m12 * correction_2,
      self_12_new_e = self_12_new_c + self_12_new_d,
      self_12_new = self_12_new_e + (double)self->m12;
  const double self_20_new_a = (double)self->m20 * correction_0,
      self_20_new_b = (double)self->m21 * correction_3,
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = (double)self->m22 * correction_4,
      self_20_new_e = self_20_new_c + self_20_new_d,
      self_20_new = (double)self->m20 + self_20_new_e;
  const double self_21_new_a = (double)self->m20 * correction_3,
      self_21_new_b = (double)self->m21 * correction_1,
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = (double)self->m22 * correction_5,
      self_21_new_e = self_21_new_c + self_21_new_d,
      self_21_new = self_21_new_e + (double)self->m21;
  const double self_22_new_a = (double)self->m20 * correction_4,
      self_22_new_b = (double)self->m21 * correction_5,
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = (double)self->m22 * correction_2,
      self_22_new_e = self_22_new_c + self_22_new_d,
      self_22_new = self_22_new_e + (double)self->m22;
  self->m00 = (float)self_00_new;
  self->m01 = (float)self_01_new;
  self->m02 = (float)self_02_new;
  self->m10 = (float)self_10_new;
  self->m11 = (float)self_11_new;
  self->m12 = (float)self_12_new;
  self->m20 = (float)self_20_new;
  self->m21 = (float)self_21_new;
  self->m22 = (float)self_22_new;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 9/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_orthonormalized_accurate(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const double defect_0a = (double)R->m00 * (double)R->m00, defect_0b = 1.0 - defect_0a,
      defect_0c = (double)R->m10 * (double)R->m10, defect_0d = defect_0b - defect_0c,
      defect_0e = (double)R->m20 * (double)R->m20, defect_0 = defect_0d - defect_0e;
  const double defect_1a = (double)R->m01 * (double)R->m01, defect_1b = 1.0 - defect_1a,
      defect_1c = (double)R->m11 * (double)R->m11, defect_1d = defect_1b - defect_1c,
      defect_1e = (double)R->m21 * (double)R->m21, defect_1 = defect_1d - defect_1e;
  const double defect_2a = (double)R->m02 * (double)R->m02, defect_2b = 1.0 - defect_2a,
      defect_2c = (double)R->m12 * (double)R->m12, defect_2d = defect_2b - defect_2c,
      defect_2e = (double)R->m22 * (double)R->m22, defect_2 = defect_2d - defect_2e;
  const double defect_3a = (double)R->m00 * (double)R->m01,
      defect_3b = (double)R->m10 * (double)R->m11, defect_3c = defect_3a + defect_3b,
      defect_3d = (double)R->m20 * (double)R->m21, defect_3e = defect_3c + defect_3d,
      defect_3 = -defect_3e;
  const double defect_4a = (double)R->m00 * (double)R->m02,
      defect_4b = (double)R->m10 * (double)R->m12, defect_4c = defect_4a + defect_4b,
      defect_4d = (double)R->m20 * (double)R->m22, defect_4e = defect_4c + defect_4d,
      defect_4 = -defect_4e;
  const double defect_5a = (double)R->m01 * (double)R->m02,
      defect_5b = (double)R->m11 * (double)R->m12, defect_5c = defect_5a + defect_5b,
      defect_5d = (double)R->m21 * (double)R->m22, defect_5e = defect_5c + defect_5d,
      defect_5 = -defect_5e;
  const double correction_0 = 0.5 * defect_0;
  const double correction_1 = 0.5 * defect_1;
  const double correction_2 = 0.5 * defect_2;
  const double correction_3 = 0.5 * defect_3;
  const double correction_4 = 0.5 * defect_4;
  const double correction_5 = 0.5 * defect_5;
  const double Ro_00a = (double)R->m00 * correction_0, Ro_00b = (double)R->m01 * correction_3,
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = (double)R->m02 * correction_4, Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = (double)R->m00 + Ro_00e;
  const double Ro_01a = (double)R->m00 * correction_3, Ro_01b = (double)R->m01 * correction_1,
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = (double)R->m02 * correction_5, Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + (double)R->m01;
  const double Ro_02a = (double)R->m00 * correction_4, Ro_02b = (double)R->m01 * correction_5,
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = (double)R->m02 * correction_2, Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + (double)R->m02;
  const double Ro_10a = (double)R->m10 * correction_0, Ro_10b = (double)R->m11 * correction_3,
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = (double)R->m12 * correction_4, Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = (double)R->m10 + Ro_10e;
  const double Ro_11a = (double)R->m10 * correction_3, Ro_11b = (double)R->m11 * correction_1,
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = (double)R->m12 * correction_5, Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + (double)R->m11;
  const double Ro_12a = (double)R->m10 * correction_4, Ro_12b = (double)R->m11 * correction_5,
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = (double)R->m12 * correction_2, Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + (double)R->m12;
  const double Ro_20a = (double)R->m20 * correction_0, Ro_20b = (double)R->m21 * correction_3,
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = (double)R->m22 * correction_4, Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = (double)R->m20 + Ro_20e;
  const double Ro_21a = (double)R->m20 * correction_3, Ro_21b = (double)R->m21 * correction_1,
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = (double)R->m22 * correction_5, Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + (double)R->m21;
  const double Ro_22a = (double)R->m20 * correction_4, Ro_22b = (double)R->m21 * correction_5,
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = (double)R->m22 * correction_2, Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + (double)R->m22;
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

#endif
