/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* All headers of plain kernels in one file, for vendoring; it may be included together with
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

#if !defined(KSL_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "-ffast-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__RECIPROCAL_MATH__)
#error "-freciprocal-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffinite-math-only breaks what is promised of NaN; define KSL_ALLOW_FAST_MATH to accept that"
#endif
#endif

/* The version, for #if KSL_VERSION >= KSL_VERSION_NUMBER(1, 2, 3). */
#define KSL_VERSION_MAJOR 0
#define KSL_VERSION_MINOR 1
#define KSL_VERSION_PATCH 0
#define KSL_VERSION_NUMBER(major, minor, patch) (10000 * (major) + 100 * (minor) + (patch))
#define KSL_VERSION KSL_VERSION_NUMBER(KSL_VERSION_MAJOR, KSL_VERSION_MINOR, KSL_VERSION_PATCH)
#define KSL_VERSION_STRING "0.1.0"

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

/* vector (x, y, z); integer precision. */
typedef union ksl_vec3i_t {
  KSL_VIEW { int at[3]; };
  KSL_VIEW { int x, y, z; };
} ksl_vec3i_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; double precision. */
typedef union ksl_vec4_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double x, y, z, w; };
  KSL_VIEW { ksl_vec3_t r; };
} ksl_vec4_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; single precision. */
typedef union ksl_vec4f_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float x, y, z, w; };
  KSL_VIEW { ksl_vec3f_t r; };
} ksl_vec4f_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; integer precision. */
typedef union ksl_vec4i_t {
  KSL_VIEW { int at[4]; };
  KSL_VIEW { int x, y, z, w; };
  KSL_VIEW { ksl_vec3i_t r; };
} ksl_vec4i_t;

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

/* 4×4 matrix, stored column by column: m32 is row 3, column 2, also at[2][3]; double precision. */
typedef union ksl_mat4x4_t {
  KSL_VIEW { double as_array[16]; };
  KSL_VIEW { double at[4][4]; };
  KSL_VIEW {
    double m00, m10, m20, m30;
    double m01, m11, m21, m31;
    double m02, m12, m22, m32;
    double m03, m13, m23, m33;
  };
  KSL_VIEW { ksl_vec4_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec4_t v[4]; };
} ksl_mat4x4_t;

/* 4×4 matrix, stored column by column: m32 is row 3, column 2, also at[2][3]; single precision. */
typedef union ksl_mat4x4f_t {
  KSL_VIEW { float as_array[16]; };
  KSL_VIEW { float at[4][4]; };
  KSL_VIEW {
    float m00, m10, m20, m30;
    float m01, m11, m21, m31;
    float m02, m12, m22, m32;
    float m03, m13, m23, m33;
  };
  KSL_VIEW { ksl_vec4f_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec4f_t v[4]; };
} ksl_mat4x4f_t;

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

/* quaternion (x, y, z, w), r = (x, y, z); for rotations, of norm 1; double precision. */
typedef union ksl_quaternion_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double x, y, z, w; };
  KSL_VIEW { ksl_vec3_t r; };
} ksl_quaternion_t;

/* quaternion (x, y, z, w), r = (x, y, z); for rotations, of norm 1; single precision. */
typedef union ksl_quaternionf_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float x, y, z, w; };
  KSL_VIEW { ksl_vec3f_t r; };
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

/* Sequences of axes of Euler angles: the first turn is about the first axis, the others about those
   of the body as the turns before have left it. */
typedef enum ksl_axis_enum_t {
  KSL_AXIS_XYZ,
  KSL_AXIS_YZX,
  KSL_AXIS_ZXY,
  KSL_AXIS_XZY,
  KSL_AXIS_YXZ,
  KSL_AXIS_ZYX,
  KSL_AXIS_XYX,
  KSL_AXIS_XZX,
  KSL_AXIS_YXY,
  KSL_AXIS_YZY,
  KSL_AXIS_ZXZ,
  KSL_AXIS_ZYZ,
  KSL_AXIS_INVALID
} ksl_axis_enum_t;

#endif

/* Vectors of three components. */
#ifndef KSL_VEC3_H
#define KSL_VEC3_H

#include <stdbool.h>

/* The vec3 of these entries, in order. */
static inline ksl_vec3_t ksl_vec3(const double x, const double y, const double z) {
  ksl_vec3_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_copy(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vi_x = vi->x;
  const double vi_y = vi->y;
  const double vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale(ksl_vec3_t *self, const double a) {
  const double self_0_new = self->x * a;
  const double self_1_new = self->y * a;
  const double self_2_new = self->z * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_inverted(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = -vi->x;
  const double vo_1 = -vi->y;
  const double vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_invert(ksl_vec3_t *self) {
  const double self_0_new = -self->x;
  const double self_1_new = -self->y;
  const double self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new_a = a * x->x, y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = a * x->y, y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = a * x->z, y_2_new = y_2_new_a + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
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
static inline void ksl_nxpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
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
static inline void ksl_product_av(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = a * vi->x;
  const double vo_1 = a * vi->y;
  const double vo_2 = a * vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
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
static inline void ksl_subtract_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
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
static inline void ksl_vec3_scaled(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x * k;
  const double vo_1 = v->y * k;
  const double vo_2 = v->z * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_swap(ksl_vec3_t *v1, ksl_vec3_t *v2) {
  const double v2_x = v2->x;
  const double v2_y = v2->y;
  const double v2_z = v2->z;
  const double v1_x = v1->x;
  const double v1_y = v1->y;
  const double v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline double ksl_vec3_l2norm(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3_normalize(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = self->x * s;
  const double y_1 = self->y * s;
  const double y_2 = self->z * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = self->x * up;
  const double enlarged_1 = self->y * up;
  const double enlarged_2 = self->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3_normalized(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = v->x * up;
  const double enlarged_1 = v->y * up;
  const double enlarged_2 = v->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double vo_0 = quotient_0 * down;
  const double vo_1 = quotient_1 * down;
  const double vo_2 = quotient_2 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   22 mul, 7 add, 1 sqrt, 1 atan2, 9 abs, 18 less, 18 select. */
static inline double ksl_angle_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double s1_size_0 = fabs(v1->x);
  const double s1_size_1 = fabs(v1->y);
  const double s1_size_2 = fabs(v1->z);
  const double s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const double s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const double s1b = 6.703903964971299e+153 < s1_largest2 ? 3.7291703656001034e-155 : 1.0,
      s1d = s1_largest2 < 256.0 ? 1.3093562431584567e+151 : s1b,
      s1 = s1_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s1d;
  const double scaled_s1_0 = v1->x * s1;
  const double scaled_s1_1 = v1->y * s1;
  const double scaled_s1_2 = v1->z * s1;
  const double s2_size_0 = fabs(v2->x);
  const double s2_size_1 = fabs(v2->y);
  const double s2_size_2 = fabs(v2->z);
  const double s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const double s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const double s2b = 6.703903964971299e+153 < s2_largest2 ? 3.7291703656001034e-155 : 1.0,
      s2d = s2_largest2 < 256.0 ? 1.3093562431584567e+151 : s2b,
      s2 = s2_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s2d;
  const double scaled_s2_0 = v2->x * s2;
  const double scaled_s2_1 = v2->y * s2;
  const double scaled_s2_2 = v2->z * s2;
  const double c_0a = scaled_s1_1 * scaled_s2_2, c_0b = scaled_s1_2 * scaled_s2_1,
      c_0 = c_0a - c_0b;
  const double c_1a = scaled_s1_2 * scaled_s2_0, c_1b = scaled_s1_0 * scaled_s2_2,
      c_1 = c_1a - c_1b;
  const double c_2a = scaled_s1_0 * scaled_s2_1, c_2b = scaled_s1_1 * scaled_s2_0,
      c_2 = c_2a - c_2b;
  const double s_size_0 = fabs(c_0);
  const double s_size_1 = fabs(c_1);
  const double s_size_2 = fabs(c_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = c_0 * s;
  const double y_1 = c_1 * s;
  const double y_2 = c_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double cross = n * r;
  const double dot__a = scaled_s1_0 * scaled_s2_0, dot__b = scaled_s1_1 * scaled_s2_1,
      dot__c = dot__a + dot__b, dot__d = scaled_s1_2 * scaled_s2_2, dot_ = dot__c + dot__d;
  const double angle = atan2(cross, dot_);
  return angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = v1->x * v2->x, dot_b = v1->y * v2->y, dot_c = dot_a + dot_b,
      dot_d = v1->z * v2->z, dot = dot_c + dot_d;
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = k * v->x, vo_0 = -vo_0a;
  const double vo_1a = k * v->y, vo_1 = -vo_1a;
  const double vo_2a = k * v->z, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k;
  const double vo_1 = v->y / k;
  const double vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0a = v1->y * v2->z, vo_0b = v1->z * v2->y, vo_0 = vo_0a - vo_0b;
  const double vo_1a = v1->z * v2->x, vo_1b = v1->x * v2->z, vo_1 = vo_1a - vo_1b;
  const double vo_2a = v1->x * v2->y, vo_2b = v1->y * v2->x, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0a = v1->z * v2->y, vo_0b = v1->y * v2->z, vo_0 = vo_0a - vo_0b;
  const double vo_1a = v1->x * v2->z, vo_1b = v1->z * v2->x, vo_1 = vo_1a - vo_1b;
  const double vo_2a = v1->y * v2->x, vo_2b = v1->x * v2->y, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
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
static inline void ksl_add_vvxinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
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
static inline void ksl_add_vvy(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
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
static inline void ksl_add_vvyinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
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
static inline void ksl_add_vvz(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
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
static inline void ksl_add_vvzinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* The vec3 of these entries, in order. */
static inline ksl_vec3f_t ksl_vec3f(const float x, const float y, const float z) {
  ksl_vec3f_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_copy(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vi_x = vi->x;
  const float vi_y = vi->y;
  const float vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scale(ksl_vec3f_t *self, const float a) {
  const float self_0_new = self->x * a;
  const float self_1_new = self->y * a;
  const float self_2_new = self->z * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_inverted(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = -vi->x;
  const float vo_1 = -vi->y;
  const float vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_invert(ksl_vec3f_t *self) {
  const float self_0_new = -self->x;
  const float self_1_new = -self->y;
  const float self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vvf(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new_a = a * x->x, y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = a * x->y, y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = a * x->z, y_2_new = y_2_new_a + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
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
static inline void ksl_nxpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
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
static inline void ksl_product_avf(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = a * vi->x;
  const float vo_1 = a * vi->y;
  const float vo_2 = a * vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
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
static inline void ksl_subtract_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
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
static inline void ksl_vec3f_scaled(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x * k;
  const float vo_1 = v->y * k;
  const float vo_2 = v->z * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_swap(ksl_vec3f_t *v1, ksl_vec3f_t *v2) {
  const float v2_x = v2->x;
  const float v2_y = v2->y;
  const float v2_z = v2->z;
  const float v1_x = v1->x;
  const float v1_y = v1->y;
  const float v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline float ksl_vec3f_l2norm(const ksl_vec3f_t *v) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalize(ksl_vec3f_t *self) {
  const float s_size_0 = fabsf(self->x);
  const float s_size_1 = fabsf(self->y);
  const float s_size_2 = fabsf(self->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = self->x * s;
  const float y_1 = self->y * s;
  const float y_2 = self->z * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = self->x * up;
  const float enlarged_1 = self->y * up;
  const float enlarged_2 = self->z * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float self_0_new = quotient_0 * down;
  const float self_1_new = quotient_1 * down;
  const float self_2_new = quotient_2 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalized(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = v->x * up;
  const float enlarged_1 = v->y * up;
  const float enlarged_2 = v->z * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float vo_0 = quotient_0 * down;
  const float vo_1 = quotient_1 * down;
  const float vo_2 = quotient_2 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   22 mul, 7 add, 1 sqrt, 1 atan2, 9 abs, 18 less, 18 select. */
static inline float ksl_angle_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const float s1_size_0 = fabsf(v1->x);
  const float s1_size_1 = fabsf(v1->y);
  const float s1_size_2 = fabsf(v1->z);
  const float s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const float s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const float s1b = 4.611686e+18f < s1_largest2 ? 2.7105054e-20f : 1.0f,
      s1d = s1_largest2 < 256.0f ? 1.8014399e+16f : s1b,
      s1 = s1_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s1d;
  const float scaled_s1_0 = v1->x * s1;
  const float scaled_s1_1 = v1->y * s1;
  const float scaled_s1_2 = v1->z * s1;
  const float s2_size_0 = fabsf(v2->x);
  const float s2_size_1 = fabsf(v2->y);
  const float s2_size_2 = fabsf(v2->z);
  const float s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const float s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const float s2b = 4.611686e+18f < s2_largest2 ? 2.7105054e-20f : 1.0f,
      s2d = s2_largest2 < 256.0f ? 1.8014399e+16f : s2b,
      s2 = s2_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s2d;
  const float scaled_s2_0 = v2->x * s2;
  const float scaled_s2_1 = v2->y * s2;
  const float scaled_s2_2 = v2->z * s2;
  const float c_0a = scaled_s1_1 * scaled_s2_2, c_0b = scaled_s1_2 * scaled_s2_1, c_0 = c_0a - c_0b;
  const float c_1a = scaled_s1_2 * scaled_s2_0, c_1b = scaled_s1_0 * scaled_s2_2, c_1 = c_1a - c_1b;
  const float c_2a = scaled_s1_0 * scaled_s2_1, c_2b = scaled_s1_1 * scaled_s2_0, c_2 = c_2a - c_2b;
  const float s_size_0 = fabsf(c_0);
  const float s_size_1 = fabsf(c_1);
  const float s_size_2 = fabsf(c_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = c_0 * s;
  const float y_1 = c_1 * s;
  const float y_2 = c_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float cross = n * r;
  const float dot__a = scaled_s1_0 * scaled_s2_0, dot__b = scaled_s1_1 * scaled_s2_1,
      dot__c = dot__a + dot__b, dot__d = scaled_s1_2 * scaled_s2_2, dot_ = dot__c + dot__d;
  const float angle = atan2f(cross, dot_);
  return angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const float dot_a = v1->x * v2->x, dot_b = v1->y * v2->y, dot_c = dot_a + dot_b,
      dot_d = v1->z * v2->z, dot = dot_c + dot_d;
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = k * v->x, vo_0 = -vo_0a;
  const float vo_1a = k * v->y, vo_1 = -vo_1a;
  const float vo_2a = k * v->z, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0 = v->x / k;
  const float vo_1 = v->y / k;
  const float vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0a = v1->y * v2->z, vo_0b = v1->z * v2->y, vo_0 = vo_0a - vo_0b;
  const float vo_1a = v1->z * v2->x, vo_1b = v1->x * v2->z, vo_1 = vo_1a - vo_1b;
  const float vo_2a = v1->x * v2->y, vo_2b = v1->y * v2->x, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0a = v1->z * v2->y, vo_0b = v1->y * v2->z, vo_0 = vo_0a - vo_0b;
  const float vo_1a = v1->x * v2->z, vo_1b = v1->z * v2->x, vo_1 = vo_1a - vo_1b;
  const float vo_2a = v1->y * v2->x, vo_2b = v1->x * v2->y, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
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
static inline void ksl_add_vvxinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
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
static inline void ksl_add_vvyf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
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
static inline void ksl_add_vvyinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
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
static inline void ksl_add_vvzf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
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
static inline void ksl_add_vvzinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z - k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec3_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3_t *ksl_vec3_alloc(int n) {
  return n > 0 ? (ksl_vec3_t *)calloc((size_t)n, sizeof(ksl_vec3_t)) : NULL;
}

/* n ksl_vec3f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3f_t *ksl_vec3f_alloc(int n) {
  return n > 0 ? (ksl_vec3f_t *)calloc((size_t)n, sizeof(ksl_vec3f_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* The vec3 of these entries, in order. */
static inline ksl_vec3i_t ksl_vec3i(const int x, const int y, const int z) {
  ksl_vec3i_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* Whether all components are equal. */
static inline bool ksl_vec3i_isEqual(const ksl_vec3i_t *v1, const ksl_vec3i_t *v2) {
  return v1->x == v2->x && v1->y == v2->y && v1->z == v2->z;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec3i_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3i_t *ksl_vec3i_alloc(int n) {
  return n > 0 ? (ksl_vec3i_t *)calloc((size_t)n, sizeof(ksl_vec3i_t)) : NULL;
}

#endif

#endif

/* Axes, and sequences of axes of Euler angles. */
#ifndef KSL_AXIS_H
#define KSL_AXIS_H


/* What KSL declares beside formulas. */

/* The axes of a sequence, x 0, y 1, z 2; those of KSL_AXIS_INVALID are -1. */
static inline ksl_vec3i_t ksl_axis_getVector(ksl_axis_enum_t axisType) {
  switch (axisType) {
    case KSL_AXIS_XYZ: return ksl_vec3i(0, 1, 2);
    case KSL_AXIS_YZX: return ksl_vec3i(1, 2, 0);
    case KSL_AXIS_ZXY: return ksl_vec3i(2, 0, 1);
    case KSL_AXIS_XZY: return ksl_vec3i(0, 2, 1);
    case KSL_AXIS_YXZ: return ksl_vec3i(1, 0, 2);
    case KSL_AXIS_ZYX: return ksl_vec3i(2, 1, 0);
    case KSL_AXIS_XYX: return ksl_vec3i(0, 1, 0);
    case KSL_AXIS_XZX: return ksl_vec3i(0, 2, 0);
    case KSL_AXIS_YXY: return ksl_vec3i(1, 0, 1);
    case KSL_AXIS_YZY: return ksl_vec3i(1, 2, 1);
    case KSL_AXIS_ZXZ: return ksl_vec3i(2, 0, 2);
    case KSL_AXIS_ZYZ: return ksl_vec3i(2, 1, 2);
    case KSL_AXIS_INVALID: break;
  }
  return ksl_vec3i(-1, -1, -1);
}

/* The sequence of three axes, x 0, y 1, z 2; KSL_AXIS_INVALID where they are no Euler angles'. */
static inline ksl_axis_enum_t ksl_axis_getEulerAngles(ksl_vec3i_t angles) {
  if (angles.x == 0 && angles.y == 1 && angles.z == 2) {
    return KSL_AXIS_XYZ;
  }
  if (angles.x == 1 && angles.y == 2 && angles.z == 0) {
    return KSL_AXIS_YZX;
  }
  if (angles.x == 2 && angles.y == 0 && angles.z == 1) {
    return KSL_AXIS_ZXY;
  }
  if (angles.x == 0 && angles.y == 2 && angles.z == 1) {
    return KSL_AXIS_XZY;
  }
  if (angles.x == 1 && angles.y == 0 && angles.z == 2) {
    return KSL_AXIS_YXZ;
  }
  if (angles.x == 2 && angles.y == 1 && angles.z == 0) {
    return KSL_AXIS_ZYX;
  }
  if (angles.x == 0 && angles.y == 1 && angles.z == 0) {
    return KSL_AXIS_XYX;
  }
  if (angles.x == 0 && angles.y == 2 && angles.z == 0) {
    return KSL_AXIS_XZX;
  }
  if (angles.x == 1 && angles.y == 0 && angles.z == 1) {
    return KSL_AXIS_YXY;
  }
  if (angles.x == 1 && angles.y == 2 && angles.z == 1) {
    return KSL_AXIS_YZY;
  }
  if (angles.x == 2 && angles.y == 0 && angles.z == 2) {
    return KSL_AXIS_ZXZ;
  }
  if (angles.x == 2 && angles.y == 1 && angles.z == 2) {
    return KSL_AXIS_ZYZ;
  }
  return KSL_AXIS_INVALID;
}

#endif

/* Numbers in arrays: exchanged, and added in multiples. */
#ifndef KSL_ARRAY_H
#define KSL_ARRAY_H


/* What KSL declares beside formulas. */


/* Exchanges two numbers. */
static inline void ksl_swap(double *a, double *b) {
  const double first = *a;
  *a = *b;
  *b = first;
}

/* Exchanges two numbers. */
static inline void ksl_swapf(float *a, float *b) {
  const float first = *a;
  *a = *b;
  *b = first;
}

/* Exchanges two numbers. */
static inline void ksl_swapi(int *a, int *b) {
  const int first = *a;
  *a = *b;
  *b = first;
}

/* y = a x + y, n numbers each. */
static inline void ksl_axpy(
    const int n, const double a, const double *x, double *y) {
  for (int i = 0; i < n; i++) {
    const double product = a * x[i];
    y[i] = product + y[i];
  }
}

/* Exchanges n numbers of a, from stride to stride, with as many of b. */
static inline void ksl_swapArray(
    const int n, double *a, const int a_stride, double *b, const int b_stride) {
  for (int i = 0; i < n; i++) {
    ksl_swap(a + i * a_stride, b + i * b_stride);
  }
}

/* y = a x + y, n numbers each. */
static inline void ksl_axpyf(
    const int n, const float a, const float *x, float *y) {
  for (int i = 0; i < n; i++) {
    const float product = a * x[i];
    y[i] = product + y[i];
  }
}

/* Exchanges n numbers of a, from stride to stride, with as many of b. */
static inline void ksl_swapArrayf(
    const int n, float *a, const int a_stride, float *b, const int b_stride) {
  for (int i = 0; i < n; i++) {
    ksl_swapf(a + i * a_stride, b + i * b_stride);
  }
}

#endif

/* Vectors of four components: of three dimensions, with a homogeneous coordinate behind them. */
#ifndef KSL_VEC4_H
#define KSL_VEC4_H


/* The vec4 of these entries, in order. */
static inline ksl_vec4_t ksl_vec4(const double x, const double y, const double z, const double w) {
  ksl_vec4_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* vo = vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4_copy(const ksl_vec4_t *vi, ksl_vec4_t *vo) {
  const double vi_x = vi->x;
  const double vi_y = vi->y;
  const double vi_z = vi->z;
  const double vi_w = vi->w;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
  vo->w = vi_w;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scale(ksl_vec4_t *self, const double a) {
  const double self_0_new = self->x * a;
  const double self_1_new = self->y * a;
  const double self_2_new = self->z * a;
  const double self_3_new = self->w * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = -vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4_inverted(const ksl_vec4_t *vi, ksl_vec4_t *vo) {
  const double vo_0 = -vi->x;
  const double vo_1 = -vi->y;
  const double vo_2 = -vi->z;
  const double vo_3 = -vi->w;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = -self.
   self: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4_invert(ksl_vec4_t *self) {
  const double self_0_new = -self->x;
  const double self_1_new = -self->y;
  const double self_2_new = -self->z;
  const double self_3_new = -self->w;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scaled(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo) {
  const double vo_0 = v->x * k;
  const double vo_1 = v->y * k;
  const double vo_2 = v->z * k;
  const double vo_3 = v->w * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* v1, v2 = v2, v1.
   v1, v2: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4_swap(ksl_vec4_t *v1, ksl_vec4_t *v2) {
  const double v2_x = v2->x;
  const double v2_y = v2->y;
  const double v2_z = v2->z;
  const double v2_w = v2->w;
  const double v1_x = v1->x;
  const double v1_y = v1->y;
  const double v1_z = v1->z;
  const double v1_w = v1->w;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v1->w = v2_w;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
  v2->w = v1_w;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_vec4_l2norm(const ksl_vec4_t *v) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_size_3 = fabs(v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double y_3 = v->w * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4_normalize(ksl_vec4_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_size_3 = fabs(self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
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

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4_normalized(const ksl_vec4_t *v, ksl_vec4_t *vo) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_size_3 = fabs(v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double y_3 = v->w * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = v->x * up;
  const double enlarged_1 = v->y * up;
  const double enlarged_2 = v->z * up;
  const double enlarged_3 = v->w * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double vo_0 = quotient_0 * down;
  const double vo_1 = quotient_1 * down;
  const double vo_2 = quotient_2 * down;
  const double vo_3 = quotient_3 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* The vec4 of these entries, in order. */
static inline ksl_vec4f_t ksl_vec4f(const float x, const float y, const float z, const float w) {
  ksl_vec4f_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* vo = vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4f_copy(const ksl_vec4f_t *vi, ksl_vec4f_t *vo) {
  const float vi_x = vi->x;
  const float vi_y = vi->y;
  const float vi_z = vi->z;
  const float vi_w = vi->w;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
  vo->w = vi_w;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scale(ksl_vec4f_t *self, const float a) {
  const float self_0_new = self->x * a;
  const float self_1_new = self->y * a;
  const float self_2_new = self->z * a;
  const float self_3_new = self->w * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = -vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4f_inverted(const ksl_vec4f_t *vi, ksl_vec4f_t *vo) {
  const float vo_0 = -vi->x;
  const float vo_1 = -vi->y;
  const float vo_2 = -vi->z;
  const float vo_3 = -vi->w;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = -self.
   self: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4f_invert(ksl_vec4f_t *self) {
  const float self_0_new = -self->x;
  const float self_1_new = -self->y;
  const float self_2_new = -self->z;
  const float self_3_new = -self->w;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scaled(const ksl_vec4f_t *v, const float k, ksl_vec4f_t *vo) {
  const float vo_0 = v->x * k;
  const float vo_1 = v->y * k;
  const float vo_2 = v->z * k;
  const float vo_3 = v->w * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* v1, v2 = v2, v1.
   v1, v2: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4f_swap(ksl_vec4f_t *v1, ksl_vec4f_t *v2) {
  const float v2_x = v2->x;
  const float v2_y = v2->y;
  const float v2_z = v2->z;
  const float v2_w = v2->w;
  const float v1_x = v1->x;
  const float v1_y = v1->y;
  const float v1_z = v1->z;
  const float v1_w = v1->w;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v1->w = v2_w;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
  v2->w = v1_w;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_vec4f_l2norm(const ksl_vec4f_t *v) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_size_3 = fabsf(v->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float y_3 = v->w * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalize(ksl_vec4f_t *self) {
  const float s_size_0 = fabsf(self->x);
  const float s_size_1 = fabsf(self->y);
  const float s_size_2 = fabsf(self->z);
  const float s_size_3 = fabsf(self->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
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

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalized(const ksl_vec4f_t *v, ksl_vec4f_t *vo) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_size_3 = fabsf(v->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float y_3 = v->w * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = v->x * up;
  const float enlarged_1 = v->y * up;
  const float enlarged_2 = v->z * up;
  const float enlarged_3 = v->w * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float vo_0 = quotient_0 * down;
  const float vo_1 = quotient_1 * down;
  const float vo_2 = quotient_2 * down;
  const float vo_3 = quotient_3 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec4_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4_t *ksl_vec4_alloc(int n) {
  return n > 0 ? (ksl_vec4_t *)calloc((size_t)n, sizeof(ksl_vec4_t)) : NULL;
}

/* n ksl_vec4f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4f_t *ksl_vec4f_alloc(int n) {
  return n > 0 ? (ksl_vec4f_t *)calloc((size_t)n, sizeof(ksl_vec4f_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* The vec4 of these entries, in order. */
static inline ksl_vec4i_t ksl_vec4i(const int x, const int y, const int z, const int w) {
  ksl_vec4i_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec4i_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4i_t *ksl_vec4i_alloc(int n) {
  return n > 0 ? (ksl_vec4i_t *)calloc((size_t)n, sizeof(ksl_vec4i_t)) : NULL;
}

#endif

#endif

/* 3×3 matrices: rotations, and matrices in general. */
#ifndef KSL_MAT3X3_H
#define KSL_MAT3X3_H

#include <stdarg.h>

/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3_t ksl_mat3x3(const double m00, const double m01, const double m02,
    const double m10, const double m11, const double m12, const double m20,
    const double m21, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3_t ksl_mat3x3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline double ksl_mat3x3_get(const ksl_mat3x3_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (double)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3_set(ksl_mat3x3_t *R, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_copy(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m01 = R->m01;
  const double R_m02 = R->m02;
  const double R_m10 = R->m10;
  const double R_m11 = R->m11;
  const double R_m12 = R->m12;
  const double R_m20 = R->m20;
  const double R_m21 = R->m21;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setIdentity(ksl_mat3x3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setFromVectors(ksl_mat3x3_t *R, const ksl_vec3_t *x,
    const ksl_vec3_t *y, const ksl_vec3_t *z) {
  const double x_x = x->x;
  const double y_x = y->x;
  const double z_x = z->x;
  const double x_y = x->y;
  const double y_y = y->y;
  const double z_y = z->y;
  const double x_z = x->z;
  const double y_z = y->z;
  const double z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skew(const ksl_vec3_t *v, ksl_mat3x3_t *Ro) {
  const double Ro_01 = -v->z;
  const double Ro_12 = -v->x;
  const double Ro_20 = -v->y;
  const double v_y = v->y;
  const double v_z = v->z;
  const double v_x = v->x;
  Ro->m00 = 0.0;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transpose(ksl_mat3x3_t *self) {
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transposed(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const double det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

/* Ro = R^-1 = adj R / det R; returns det R, or 0 where it cannot be told from 0 (|det R| <= 8 u
     times the sum of its terms' sizes), and Ro = NaN.
   R, Ro: rotation or other 3×3 matrix.
   31 mul, 17 add, 9 div, 10 abs, 1 less, 1 equal, 12 select.
   Ro_ij is off by 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R| at most, m_ji and p the sums of
     the sizes of the terms of the cofactor and of det R; barring over- and underflow. */
static inline double ksl_mat3x3_inverse(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double n0_0a = R->m11 * R->m22, n0_0b = R->m12 * R->m21, n0_0 = n0_0a - n0_0b;
  const double n0_1a = R->m02 * R->m21, n0_1b = R->m01 * R->m22, n0_1 = n0_1a - n0_1b;
  const double n0_2a = R->m01 * R->m12, n0_2b = R->m02 * R->m11, n0_2 = n0_2a - n0_2b;
  const double n1_0a = R->m12 * R->m20, n1_0b = R->m10 * R->m22, n1_0 = n1_0a - n1_0b;
  const double n1_1a = R->m00 * R->m22, n1_1b = R->m02 * R->m20, n1_1 = n1_1a - n1_1b;
  const double n1_2a = R->m02 * R->m10, n1_2b = R->m00 * R->m12, n1_2 = n1_2a - n1_2b;
  const double n2_0a = R->m10 * R->m21, n2_0b = R->m11 * R->m20, n2_0 = n2_0a - n2_0b;
  const double n2_1a = R->m01 * R->m20, n2_1b = R->m00 * R->m21, n2_1 = n2_1a - n2_1b;
  const double n2_2a = R->m00 * R->m11, n2_2b = R->m01 * R->m10, n2_2 = n2_2a - n2_2b;
  const double d_a = R->m00 * n0_0, d_b = R->m10 * n0_1, d_c = d_a + d_b, d_d = R->m20 * n0_2,
      d = d_c + d_d;
  const double size0_0 = fabs(R->m00);
  const double size0_1 = fabs(R->m10);
  const double size0_2 = fabs(R->m20);
  const double size1_0 = fabs(R->m01);
  const double size1_1 = fabs(R->m11);
  const double size1_2 = fabs(R->m21);
  const double size2_0 = fabs(R->m02);
  const double size2_1 = fabs(R->m12);
  const double size2_2 = fabs(R->m22);
  const double permanent_a = size1_1 * size2_2, permanent_b = size1_2 * size2_1,
      permanent_c = permanent_a + permanent_b, permanent_d = size0_0 * permanent_c,
      permanent_e = size1_0 * size2_2, permanent_f = size1_2 * size2_0,
      permanent_g = permanent_e + permanent_f, permanent_h = size0_1 * permanent_g,
      permanent_i = permanent_d + permanent_h, permanent_j = size1_0 * size2_1,
      permanent_k = size1_1 * size2_0, permanent_l = permanent_j + permanent_k,
      permanent_m = size0_2 * permanent_l, permanent = permanent_i + permanent_m;
  const double least_a = permanent * 8.881784197001252e-16,
      least = least_a + 1.0261342003245941e-289;
  const double regular_a = fabs(d), regular = least < regular_a ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d : 1.0;
  const double det = regular == 1.0 ? d : 0.0;
  const double Ro_00a = n0_0 / divisor, Ro_00 = regular == 1.0 ? Ro_00a : (double)NAN;
  const double Ro_01a = n0_1 / divisor, Ro_01 = regular == 1.0 ? Ro_01a : (double)NAN;
  const double Ro_02a = n0_2 / divisor, Ro_02 = regular == 1.0 ? Ro_02a : (double)NAN;
  const double Ro_10a = n1_0 / divisor, Ro_10 = regular == 1.0 ? Ro_10a : (double)NAN;
  const double Ro_11a = n1_1 / divisor, Ro_11 = regular == 1.0 ? Ro_11a : (double)NAN;
  const double Ro_12a = n1_2 / divisor, Ro_12 = regular == 1.0 ? Ro_12a : (double)NAN;
  const double Ro_20a = n2_0 / divisor, Ro_20 = regular == 1.0 ? Ro_20a : (double)NAN;
  const double Ro_21a = n2_1 / divisor, Ro_21 = regular == 1.0 ? Ro_21a : (double)NAN;
  const double Ro_22a = n2_2 / divisor, Ro_22 = regular == 1.0 ? Ro_22a : (double)NAN;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  return det;
}

/* self = orthonormal rows by Gram and Schmidt: the first keeps its direction, the second its
     side of it, the third its side of both; NaN where rows depend on each other to rounding.
   self: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   Rows are perpendicular, and of length 1, but for 4 u; searched, not proved. */
static inline void ksl_mat3x3_normalize(ksl_mat3x3_t *self) {
  const double q0_s_size_0 = fabs(self->m00);
  const double q0_s_size_1 = fabs(self->m01);
  const double q0_s_size_2 = fabs(self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = self->m00 * q0_s;
  const double q0_y_1 = self->m01 * q0_s;
  const double q0_y_2 = self->m02 * q0_s;
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = q0_y_0 * q0_y_0, q0_n_b = q0_y_1 * q0_y_1, q0_n_c = q0_n_a + q0_n_b,
      q0_n_d = q0_y_2 * q0_y_2, q0_n_e = q0_n_c + q0_n_d, q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_enlarged_0 = self->m00 * q0_up;
  const double q0_enlarged_1 = self->m01 * q0_up;
  const double q0_enlarged_2 = self->m02 * q0_up;
  const double q0_quotient_0 = q0_enlarged_0 / q0_divisor;
  const double q0_quotient_1 = q0_enlarged_1 / q0_divisor;
  const double q0_quotient_2 = q0_enlarged_2 / q0_divisor;
  const double q0_0 = q0_quotient_0 * q0_down;
  const double q0_1 = q0_quotient_1 * q0_down;
  const double q0_2 = q0_quotient_2 * q0_down;
  const double u1_s_size_0 = fabs(self->m10);
  const double u1_s_size_1 = fabs(self->m11);
  const double u1_s_size_2 = fabs(self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = self->m10 * u1_s;
  const double u1_y_1 = self->m11 * u1_s;
  const double u1_y_2 = self->m12 * u1_s;
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = u1_y_0 * u1_y_0, u1_n_b = u1_y_1 * u1_y_1, u1_n_c = u1_n_a + u1_n_b,
      u1_n_d = u1_y_2 * u1_y_2, u1_n_e = u1_n_c + u1_n_d, u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_enlarged_0 = self->m10 * u1_up;
  const double u1_enlarged_1 = self->m11 * u1_up;
  const double u1_enlarged_2 = self->m12 * u1_up;
  const double u1_quotient_0 = u1_enlarged_0 / u1_divisor;
  const double u1_quotient_1 = u1_enlarged_1 / u1_divisor;
  const double u1_quotient_2 = u1_enlarged_2 / u1_divisor;
  const double u1_0 = u1_quotient_0 * u1_down;
  const double u1_1 = u1_quotient_1 * u1_down;
  const double u1_2 = u1_quotient_2 * u1_down;
  const double along_a = q0_0 * u1_0, along_b = q0_1 * u1_1, along_c = along_a + along_b,
      along_d = q0_2 * u1_2, along = along_c + along_d;
  const double once_0a = q0_0 * along, once_0 = u1_0 - once_0a;
  const double once_1a = q0_1 * along, once_1 = u1_1 - once_1a;
  const double once_2a = q0_2 * along, once_2 = u1_2 - once_2a;
  const double rest_a = q0_0 * once_0, rest_b = q0_1 * once_1, rest_c = rest_a + rest_b,
      rest_d = q0_2 * once_2, rest = rest_c + rest_d;
  const double twice_0a = q0_0 * rest, twice_0 = once_0 - twice_0a;
  const double twice_1a = q0_1 * rest, twice_1 = once_1 - twice_1a;
  const double twice_2a = q0_2 * rest, twice_2 = once_2 - twice_2a;
  const double n_a = twice_0 * twice_0, n_b = twice_1 * twice_1, n_c = n_a + n_b,
      n_d = twice_2 * twice_2, n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = q0_1 * q1_2, normal_0b = q0_2 * q1_1, normal_0 = normal_0a - normal_0b;
  const double normal_1a = q0_2 * q1_0, normal_1b = q0_0 * q1_2, normal_1 = normal_1a - normal_1b;
  const double normal_2a = q0_0 * q1_1, normal_2b = q0_1 * q1_0, normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs(self->m20);
  const double u2_s_size_1 = fabs(self->m21);
  const double u2_s_size_2 = fabs(self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = self->m20 * u2_s;
  const double u2_y_1 = self->m21 * u2_s;
  const double u2_y_2 = self->m22 * u2_s;
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = u2_y_0 * u2_y_0, u2_n_b = u2_y_1 * u2_y_1, u2_n_c = u2_n_a + u2_n_b,
      u2_n_d = u2_y_2 * u2_y_2, u2_n_e = u2_n_c + u2_n_d, u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_enlarged_0 = self->m20 * u2_up;
  const double u2_enlarged_1 = self->m21 * u2_up;
  const double u2_enlarged_2 = self->m22 * u2_up;
  const double u2_quotient_0 = u2_enlarged_0 / u2_divisor;
  const double u2_quotient_1 = u2_enlarged_1 / u2_divisor;
  const double u2_quotient_2 = u2_enlarged_2 / u2_divisor;
  const double u2_0 = u2_quotient_0 * u2_down;
  const double u2_1 = u2_quotient_1 * u2_down;
  const double u2_2 = u2_quotient_2 * u2_down;
  const double side_a = normal_0 * u2_0, side_b = normal_1 * u2_1, side_c = side_a + side_b,
      side_d = normal_2 * u2_2, side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0;
  const double self_01_new = dependent == 1.0 ? (double)NAN : q0_1;
  const double self_02_new = dependent == 1.0 ? (double)NAN : q0_2;
  const double self_10_new = dependent == 1.0 ? (double)NAN : q1_0;
  const double self_11_new = dependent == 1.0 ? (double)NAN : q1_1;
  const double self_12_new = dependent == 1.0 ? (double)NAN : q1_2;
  const double self_20_new = dependent == 1.0 ? (double)NAN : q2_0;
  const double self_21_new = dependent == 1.0 ? (double)NAN : q2_1;
  const double self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = orthonormal rows by Gram and Schmidt: the first keeps its direction, the second its side
     of it, the third its side of both; NaN where rows depend on each other to rounding.
   R, Ro: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   Rows are perpendicular, and of length 1, but for 4 u; searched, not proved. */
static inline void ksl_mat3x3_normalized(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double q0_s_size_0 = fabs(R->m00);
  const double q0_s_size_1 = fabs(R->m01);
  const double q0_s_size_2 = fabs(R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = R->m00 * q0_s;
  const double q0_y_1 = R->m01 * q0_s;
  const double q0_y_2 = R->m02 * q0_s;
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = q0_y_0 * q0_y_0, q0_n_b = q0_y_1 * q0_y_1, q0_n_c = q0_n_a + q0_n_b,
      q0_n_d = q0_y_2 * q0_y_2, q0_n_e = q0_n_c + q0_n_d, q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_enlarged_0 = R->m00 * q0_up;
  const double q0_enlarged_1 = R->m01 * q0_up;
  const double q0_enlarged_2 = R->m02 * q0_up;
  const double q0_quotient_0 = q0_enlarged_0 / q0_divisor;
  const double q0_quotient_1 = q0_enlarged_1 / q0_divisor;
  const double q0_quotient_2 = q0_enlarged_2 / q0_divisor;
  const double q0_0 = q0_quotient_0 * q0_down;
  const double q0_1 = q0_quotient_1 * q0_down;
  const double q0_2 = q0_quotient_2 * q0_down;
  const double u1_s_size_0 = fabs(R->m10);
  const double u1_s_size_1 = fabs(R->m11);
  const double u1_s_size_2 = fabs(R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = R->m10 * u1_s;
  const double u1_y_1 = R->m11 * u1_s;
  const double u1_y_2 = R->m12 * u1_s;
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = u1_y_0 * u1_y_0, u1_n_b = u1_y_1 * u1_y_1, u1_n_c = u1_n_a + u1_n_b,
      u1_n_d = u1_y_2 * u1_y_2, u1_n_e = u1_n_c + u1_n_d, u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_enlarged_0 = R->m10 * u1_up;
  const double u1_enlarged_1 = R->m11 * u1_up;
  const double u1_enlarged_2 = R->m12 * u1_up;
  const double u1_quotient_0 = u1_enlarged_0 / u1_divisor;
  const double u1_quotient_1 = u1_enlarged_1 / u1_divisor;
  const double u1_quotient_2 = u1_enlarged_2 / u1_divisor;
  const double u1_0 = u1_quotient_0 * u1_down;
  const double u1_1 = u1_quotient_1 * u1_down;
  const double u1_2 = u1_quotient_2 * u1_down;
  const double along_a = q0_0 * u1_0, along_b = q0_1 * u1_1, along_c = along_a + along_b,
      along_d = q0_2 * u1_2, along = along_c + along_d;
  const double once_0a = q0_0 * along, once_0 = u1_0 - once_0a;
  const double once_1a = q0_1 * along, once_1 = u1_1 - once_1a;
  const double once_2a = q0_2 * along, once_2 = u1_2 - once_2a;
  const double rest_a = q0_0 * once_0, rest_b = q0_1 * once_1, rest_c = rest_a + rest_b,
      rest_d = q0_2 * once_2, rest = rest_c + rest_d;
  const double twice_0a = q0_0 * rest, twice_0 = once_0 - twice_0a;
  const double twice_1a = q0_1 * rest, twice_1 = once_1 - twice_1a;
  const double twice_2a = q0_2 * rest, twice_2 = once_2 - twice_2a;
  const double n_a = twice_0 * twice_0, n_b = twice_1 * twice_1, n_c = n_a + n_b,
      n_d = twice_2 * twice_2, n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = q0_1 * q1_2, normal_0b = q0_2 * q1_1, normal_0 = normal_0a - normal_0b;
  const double normal_1a = q0_2 * q1_0, normal_1b = q0_0 * q1_2, normal_1 = normal_1a - normal_1b;
  const double normal_2a = q0_0 * q1_1, normal_2b = q0_1 * q1_0, normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs(R->m20);
  const double u2_s_size_1 = fabs(R->m21);
  const double u2_s_size_2 = fabs(R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = R->m20 * u2_s;
  const double u2_y_1 = R->m21 * u2_s;
  const double u2_y_2 = R->m22 * u2_s;
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = u2_y_0 * u2_y_0, u2_n_b = u2_y_1 * u2_y_1, u2_n_c = u2_n_a + u2_n_b,
      u2_n_d = u2_y_2 * u2_y_2, u2_n_e = u2_n_c + u2_n_d, u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_enlarged_0 = R->m20 * u2_up;
  const double u2_enlarged_1 = R->m21 * u2_up;
  const double u2_enlarged_2 = R->m22 * u2_up;
  const double u2_quotient_0 = u2_enlarged_0 / u2_divisor;
  const double u2_quotient_1 = u2_enlarged_1 / u2_divisor;
  const double u2_quotient_2 = u2_enlarged_2 / u2_divisor;
  const double u2_0 = u2_quotient_0 * u2_down;
  const double u2_1 = u2_quotient_1 * u2_down;
  const double u2_2 = u2_quotient_2 * u2_down;
  const double side_a = normal_0 * u2_0, side_b = normal_1 * u2_1, side_c = side_a + side_b,
      side_d = normal_2 * u2_2, side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0;
  const double Ro_01 = dependent == 1.0 ? (double)NAN : q0_1;
  const double Ro_02 = dependent == 1.0 ? (double)NAN : q0_2;
  const double Ro_10 = dependent == 1.0 ? (double)NAN : q1_0;
  const double Ro_11 = dependent == 1.0 ? (double)NAN : q1_1;
  const double Ro_12 = dependent == 1.0 ? (double)NAN : q1_2;
  const double Ro_20 = dependent == 1.0 ? (double)NAN : q2_0;
  const double Ro_21 = dependent == 1.0 ? (double)NAN : q2_1;
  const double Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1, dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   12 mul, 10 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_setFromAxisDC(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2]) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = axis->x * versine;
  const double versine_axis_1 = axis->y * versine;
  const double versine_axis_2 = axis->z * versine;
  const double m_0 = axis->x * versine_axis_0;
  const double m_1 = axis->y * versine_axis_1;
  const double m_2 = axis->z * versine_axis_2;
  const double m_3 = axis->y * versine_axis_0;
  const double m_4 = axis->z * versine_axis_0;
  const double m_5 = axis->z * versine_axis_1;
  const double sine_axis_0 = axis->x * dc[0];
  const double sine_axis_1 = axis->y * dc[0];
  const double sine_axis_2 = axis->z * dc[0];
  const double R_00 = dc[1] + m_0;
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = dc[1] + m_1;
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = dc[1] + m_2;
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

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   14 mul, 4 add, 3 sin, 3 cos, 3 neg. */
static inline void ksl_mat3x3_from_euler_xyz(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  const double s_0 = sin(angles->x);
  const double s_1 = sin(angles->y);
  const double s_2 = sin(angles->z);
  const double c_0 = cos(angles->x);
  const double c_1 = cos(angles->y);
  const double c_2 = cos(angles->z);
  const double first_0 = c_1 * c_2;
  const double first_1a = s_2 * c_1, first_1 = -first_1a;
  const double first_6a = s_1 * c_2, first_6 = -first_6a;
  const double first_7 = s_1 * s_2;
  const double last_3a = s_2 * c_0, last_3b = s_0 * first_6, last_3 = last_3a - last_3b;
  const double last_4a = c_0 * c_2, last_4b = s_0 * first_7, last_4 = last_4a - last_4b;
  const double last_5a = s_0 * c_1, last_5 = -last_5a;
  const double last_6a = s_0 * s_2, last_6b = c_0 * first_6, last_6 = last_6a + last_6b;
  const double last_7a = s_0 * c_2, last_7b = c_0 * first_7, last_7 = last_7a + last_7b;
  const double last_8 = c_0 * c_1;
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   6 mul, 3 add, 2 div, 1 sqrt, 3 atan2, 1 neg, 1 equal, 3 select.
   The rotation by these angles is R but for 6 u in each entry, near gimbal lock too; searched,
     not proved. */
static inline void ksl_euler_xyz_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = R->m00 * R->m00, n_b = R->m01 * R->m01, n_c = n_a + n_b, n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m00 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine_a = -R->m01, sine = sine_a / divisor;
  const double polar = atan2(sine_a, R->m00);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = R->m10 * sine, left_1b = R->m11 * cosine, left_1 = left_1a + left_1b;
  const double left_2a = R->m20 * sine, left_2b = R->m21 * cosine, left_2 = left_2a + left_2b;
  const double angles_0 = atan2(left_2, left_1);
  const double angles_1 = atan2(R->m02, n);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   14 mul, 4 add, 3 sin, 3 cos, 2 neg. */
static inline void ksl_mat3x3_from_euler_xyx(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  const double s_0 = sin(angles->x);
  const double s_1 = sin(angles->y);
  const double s_2 = sin(angles->z);
  const double c_0 = cos(angles->x);
  const double c_1 = cos(angles->y);
  const double c_2 = cos(angles->z);
  const double first_1 = s_1 * s_2;
  const double first_2 = s_1 * c_2;
  const double first_7 = s_2 * c_1;
  const double first_8 = c_1 * c_2;
  const double last_3 = s_0 * s_1;
  const double last_4a = c_0 * c_2, last_4b = s_0 * first_7, last_4 = last_4a - last_4b;
  const double last_5a = s_0 * first_8, last_5b = s_2 * c_0, last_5c = last_5a + last_5b,
      last_5 = -last_5c;
  const double last_6a = s_1 * c_0, last_6 = -last_6a;
  const double last_7a = s_0 * c_2, last_7b = c_0 * first_7, last_7 = last_7a + last_7b;
  const double last_8a = c_0 * first_8, last_8b = s_0 * s_2, last_8 = last_8a - last_8b;
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   6 mul, 3 add, 2 div, 1 sqrt, 3 atan2, 1 equal, 3 select.
   The rotation by these angles is R but for 6 u in each entry, near gimbal lock too; searched,
     not proved. */
static inline void ksl_euler_xyx_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = R->m01 * R->m01, n_b = R->m02 * R->m02, n_c = n_a + n_b, n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m02 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine = R->m01 / divisor;
  const double polar = atan2(R->m01, R->m02);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = R->m11 * cosine, left_1b = R->m12 * sine, left_1 = left_1a - left_1b;
  const double left_2a = R->m21 * cosine, left_2b = R->m22 * sine, left_2 = left_2a - left_2b;
  const double angles_0 = atan2(left_2, left_1);
  const double angles_1 = atan2(n, R->m00);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the plane xy, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A symmetric, its lower triangle is read.  From V =
     I, steps end in A = diag(eigenvalues), with V A V^T the same throughout.
   A, V: rotation or other 3×3 matrix.
   21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.
   |V A V^T - the same before| <= 12 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3_jacobi(ksl_mat3x3_t *A, ksl_mat3x3_t *V) {
  const double twice = 2.0 * A->m10;
  const double apart = A->m11 - A->m00;
  const double divisor = twice == 0.0 ? 1.0 : twice;
  const double theta = apart / divisor;
  const double absolute = fabs(theta);
  const double size_a = theta * theta, size_b = 1.0 + size_a, size_c = sqrt(size_b),
      size = absolute + size_c;
  const double along_a = -size, along = theta < 0.0 ? along_a : size;
  const double t_a = 1.0 / along, t = twice == 0.0 ? 0.0 : t_a;
  const double secant_a = t * t, secant_b = 1.0 + secant_a, secant = sqrt(secant_b);
  const double c = 1.0 / secant;
  const double s = t * c;
  const double change = A->m10 * t;
  const double zp_a = A->m20 * c, zp_b = A->m21 * s, zp = zp_a - zp_b;
  const double zq_a = A->m20 * s, zq_b = A->m21 * c, zq = zq_a + zq_b;
  const double vp_0a = V->m00 * c, vp_0b = V->m01 * s, vp_0 = vp_0a - vp_0b;
  const double vp_1a = V->m10 * c, vp_1b = V->m11 * s, vp_1 = vp_1a - vp_1b;
  const double vp_2a = V->m20 * c, vp_2b = V->m21 * s, vp_2 = vp_2a - vp_2b;
  const double vq_0a = V->m00 * s, vq_0b = V->m01 * c, vq_0 = vq_0a + vq_0b;
  const double vq_1a = V->m10 * s, vq_1b = V->m11 * c, vq_1 = vq_1a + vq_1b;
  const double vq_2a = V->m20 * s, vq_2b = V->m21 * c, vq_2 = vq_2a + vq_2b;
  const double A_00_new = A->m11 + change;
  const double A_22_new = A->m00 - change;
  const double A_m22 = A->m22;
  const double V_m02 = V->m02;
  const double V_m12 = V->m12;
  const double V_m22 = V->m22;
  A->m00 = A_00_new;
  A->m01 = zq;
  A->m02 = 0.0;
  A->m10 = zq;
  A->m11 = A_m22;
  A->m12 = zp;
  A->m20 = 0.0;
  A->m21 = zp;
  A->m22 = A_22_new;
  V->m00 = vq_0;
  V->m01 = V_m02;
  V->m02 = vp_0;
  V->m10 = vq_1;
  V->m11 = V_m12;
  V->m12 = vp_1;
  V->m20 = vq_2;
  V->m21 = V_m22;
  V->m22 = vp_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2; axis of length 1.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   15 mul, 13 add, 2 sin, 1 cos, 1 less, 1 select.
   Error <= R: 8 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_mat3x3_from_axis_angle(const ksl_vec3_t *axis, const double angle,
    ksl_mat3x3_t *R) {
  const double half = 0.5 * angle;
  const double h = sin(half);
  const double cosine = cos(angle);
  const double versine_a = h * h, versine_b = 2.0 * versine_a, versine_c = 1.0 - cosine,
      versine = cosine < 0.0 ? versine_c : versine_b;
  const double sine = sin(angle);
  const double beta_v_0 = axis->x * versine;
  const double beta_v_1 = axis->y * versine;
  const double beta_v_2 = axis->z * versine;
  const double m_0 = axis->x * beta_v_0;
  const double m_1 = axis->y * beta_v_1;
  const double m_2 = axis->z * beta_v_2;
  const double m_3 = axis->y * beta_v_0;
  const double m_4 = axis->z * beta_v_0;
  const double m_5 = axis->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double alpha_v_0 = axis->x * sine;
  const double alpha_v_1 = axis->y * sine;
  const double alpha_v_2 = axis->z * sine;
  const double R_00 = 1.0 - others_0;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_11 = 1.0 - others_1;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double R_22 = 1.0 - others_2;
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

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) where nothing turns.
   R: rotation or other 3×3 matrix; axis: vector.
   8 mul, 16 add, 3 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 26 select.
   Error <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not
     proved. */
static inline double ksl_axis_angle_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *axis) {
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
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
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

/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3f_t ksl_mat3x3f(const float m00, const float m01, const float m02,
    const float m10, const float m11, const float m12, const float m20,
    const float m21, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3f_t ksl_mat3x3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline float ksl_mat3x3f_get(const ksl_mat3x3f_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (float)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3f_set(ksl_mat3x3f_t *R, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_copy(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m01 = R->m01;
  const float R_m02 = R->m02;
  const float R_m10 = R->m10;
  const float R_m11 = R->m11;
  const float R_m12 = R->m12;
  const float R_m20 = R->m20;
  const float R_m21 = R->m21;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setIdentity(ksl_mat3x3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setFromVectors(ksl_mat3x3f_t *R, const ksl_vec3f_t *x,
    const ksl_vec3f_t *y, const ksl_vec3f_t *z) {
  const float x_x = x->x;
  const float y_x = y->x;
  const float z_x = z->x;
  const float x_y = x->y;
  const float y_y = y->y;
  const float z_y = z->y;
  const float x_z = x->z;
  const float y_z = y->z;
  const float z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skewf(const ksl_vec3f_t *v, ksl_mat3x3f_t *Ro) {
  const float Ro_01 = -v->z;
  const float Ro_12 = -v->x;
  const float Ro_20 = -v->y;
  const float v_y = v->y;
  const float v_z = v->z;
  const float v_x = v->x;
  Ro->m00 = 0.0f;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0f;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0f;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transpose(ksl_mat3x3f_t *self) {
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transposed(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant(const ksl_mat3x3f_t *R) {
  const float n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const float n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const float n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const float det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

/* Ro = R^-1 = adj R / det R; returns det R, or 0 where it cannot be told from 0 (|det R| <= 8 u
     times the sum of its terms' sizes), and Ro = NaN.
   R, Ro: rotation or other 3×3 matrix.
   31 mul, 17 add, 9 div, 10 abs, 1 less, 1 equal, 12 select.
   Ro_ij is off by 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R| at most, m_ji and p the sums of
     the sizes of the terms of the cofactor and of det R; barring over- and underflow. */
static inline float ksl_mat3x3f_inverse(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float n0_0a = R->m11 * R->m22, n0_0b = R->m12 * R->m21, n0_0 = n0_0a - n0_0b;
  const float n0_1a = R->m02 * R->m21, n0_1b = R->m01 * R->m22, n0_1 = n0_1a - n0_1b;
  const float n0_2a = R->m01 * R->m12, n0_2b = R->m02 * R->m11, n0_2 = n0_2a - n0_2b;
  const float n1_0a = R->m12 * R->m20, n1_0b = R->m10 * R->m22, n1_0 = n1_0a - n1_0b;
  const float n1_1a = R->m00 * R->m22, n1_1b = R->m02 * R->m20, n1_1 = n1_1a - n1_1b;
  const float n1_2a = R->m02 * R->m10, n1_2b = R->m00 * R->m12, n1_2 = n1_2a - n1_2b;
  const float n2_0a = R->m10 * R->m21, n2_0b = R->m11 * R->m20, n2_0 = n2_0a - n2_0b;
  const float n2_1a = R->m01 * R->m20, n2_1b = R->m00 * R->m21, n2_1 = n2_1a - n2_1b;
  const float n2_2a = R->m00 * R->m11, n2_2b = R->m01 * R->m10, n2_2 = n2_2a - n2_2b;
  const float d_a = R->m00 * n0_0, d_b = R->m10 * n0_1, d_c = d_a + d_b, d_d = R->m20 * n0_2,
      d = d_c + d_d;
  const float size0_0 = fabsf(R->m00);
  const float size0_1 = fabsf(R->m10);
  const float size0_2 = fabsf(R->m20);
  const float size1_0 = fabsf(R->m01);
  const float size1_1 = fabsf(R->m11);
  const float size1_2 = fabsf(R->m21);
  const float size2_0 = fabsf(R->m02);
  const float size2_1 = fabsf(R->m12);
  const float size2_2 = fabsf(R->m22);
  const float permanent_a = size1_1 * size2_2, permanent_b = size1_2 * size2_1,
      permanent_c = permanent_a + permanent_b, permanent_d = size0_0 * permanent_c,
      permanent_e = size1_0 * size2_2, permanent_f = size1_2 * size2_0,
      permanent_g = permanent_e + permanent_f, permanent_h = size0_1 * permanent_g,
      permanent_i = permanent_d + permanent_h, permanent_j = size1_0 * size2_1,
      permanent_k = size1_1 * size2_0, permanent_l = permanent_j + permanent_k,
      permanent_m = size0_2 * permanent_l, permanent = permanent_i + permanent_m;
  const float least_a = permanent * 4.7683716e-07f, least = least_a + 1.2621775e-29f;
  const float regular_a = fabsf(d), regular = least < regular_a ? 1.0f : 0.0f;
  const float divisor = regular == 1.0f ? d : 1.0f;
  const float det = regular == 1.0f ? d : 0.0f;
  const float Ro_00a = n0_0 / divisor, Ro_00 = regular == 1.0f ? Ro_00a : (float)NAN;
  const float Ro_01a = n0_1 / divisor, Ro_01 = regular == 1.0f ? Ro_01a : (float)NAN;
  const float Ro_02a = n0_2 / divisor, Ro_02 = regular == 1.0f ? Ro_02a : (float)NAN;
  const float Ro_10a = n1_0 / divisor, Ro_10 = regular == 1.0f ? Ro_10a : (float)NAN;
  const float Ro_11a = n1_1 / divisor, Ro_11 = regular == 1.0f ? Ro_11a : (float)NAN;
  const float Ro_12a = n1_2 / divisor, Ro_12 = regular == 1.0f ? Ro_12a : (float)NAN;
  const float Ro_20a = n2_0 / divisor, Ro_20 = regular == 1.0f ? Ro_20a : (float)NAN;
  const float Ro_21a = n2_1 / divisor, Ro_21 = regular == 1.0f ? Ro_21a : (float)NAN;
  const float Ro_22a = n2_2 / divisor, Ro_22 = regular == 1.0f ? Ro_22a : (float)NAN;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  return det;
}

/* self = orthonormal rows by Gram and Schmidt: the first keeps its direction, the second its
     side of it, the third its side of both; NaN where rows depend on each other to rounding.
   self: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   Rows are perpendicular, and of length 1, but for 4 u; searched, not proved. */
static inline void ksl_mat3x3f_normalize(ksl_mat3x3f_t *self) {
  const float q0_s_size_0 = fabsf(self->m00);
  const float q0_s_size_1 = fabsf(self->m01);
  const float q0_s_size_2 = fabsf(self->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = self->m00 * q0_s;
  const float q0_y_1 = self->m01 * q0_s;
  const float q0_y_2 = self->m02 * q0_s;
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n_a = q0_y_0 * q0_y_0, q0_n_b = q0_y_1 * q0_y_1, q0_n_c = q0_n_a + q0_n_b,
      q0_n_d = q0_y_2 * q0_y_2, q0_n_e = q0_n_c + q0_n_d, q0_n = sqrtf(q0_n_e);
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_enlarged_0 = self->m00 * q0_up;
  const float q0_enlarged_1 = self->m01 * q0_up;
  const float q0_enlarged_2 = self->m02 * q0_up;
  const float q0_quotient_0 = q0_enlarged_0 / q0_divisor;
  const float q0_quotient_1 = q0_enlarged_1 / q0_divisor;
  const float q0_quotient_2 = q0_enlarged_2 / q0_divisor;
  const float q0_0 = q0_quotient_0 * q0_down;
  const float q0_1 = q0_quotient_1 * q0_down;
  const float q0_2 = q0_quotient_2 * q0_down;
  const float u1_s_size_0 = fabsf(self->m10);
  const float u1_s_size_1 = fabsf(self->m11);
  const float u1_s_size_2 = fabsf(self->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = self->m10 * u1_s;
  const float u1_y_1 = self->m11 * u1_s;
  const float u1_y_2 = self->m12 * u1_s;
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n_a = u1_y_0 * u1_y_0, u1_n_b = u1_y_1 * u1_y_1, u1_n_c = u1_n_a + u1_n_b,
      u1_n_d = u1_y_2 * u1_y_2, u1_n_e = u1_n_c + u1_n_d, u1_n = sqrtf(u1_n_e);
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_enlarged_0 = self->m10 * u1_up;
  const float u1_enlarged_1 = self->m11 * u1_up;
  const float u1_enlarged_2 = self->m12 * u1_up;
  const float u1_quotient_0 = u1_enlarged_0 / u1_divisor;
  const float u1_quotient_1 = u1_enlarged_1 / u1_divisor;
  const float u1_quotient_2 = u1_enlarged_2 / u1_divisor;
  const float u1_0 = u1_quotient_0 * u1_down;
  const float u1_1 = u1_quotient_1 * u1_down;
  const float u1_2 = u1_quotient_2 * u1_down;
  const float along_a = q0_0 * u1_0, along_b = q0_1 * u1_1, along_c = along_a + along_b,
      along_d = q0_2 * u1_2, along = along_c + along_d;
  const float once_0a = q0_0 * along, once_0 = u1_0 - once_0a;
  const float once_1a = q0_1 * along, once_1 = u1_1 - once_1a;
  const float once_2a = q0_2 * along, once_2 = u1_2 - once_2a;
  const float rest_a = q0_0 * once_0, rest_b = q0_1 * once_1, rest_c = rest_a + rest_b,
      rest_d = q0_2 * once_2, rest = rest_c + rest_d;
  const float twice_0a = q0_0 * rest, twice_0 = once_0 - twice_0a;
  const float twice_1a = q0_1 * rest, twice_1 = once_1 - twice_1a;
  const float twice_2a = q0_2 * rest, twice_2 = once_2 - twice_2a;
  const float n_a = twice_0 * twice_0, n_b = twice_1 * twice_1, n_c = n_a + n_b,
      n_d = twice_2 * twice_2, n_e = n_c + n_d, n = sqrtf(n_e);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor;
  const float q1_1 = twice_1 / divisor;
  const float q1_2 = twice_2 / divisor;
  const float normal_0a = q0_1 * q1_2, normal_0b = q0_2 * q1_1, normal_0 = normal_0a - normal_0b;
  const float normal_1a = q0_2 * q1_0, normal_1b = q0_0 * q1_2, normal_1 = normal_1a - normal_1b;
  const float normal_2a = q0_0 * q1_1, normal_2b = q0_1 * q1_0, normal_2 = normal_2a - normal_2b;
  const float u2_s_size_0 = fabsf(self->m20);
  const float u2_s_size_1 = fabsf(self->m21);
  const float u2_s_size_2 = fabsf(self->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = self->m20 * u2_s;
  const float u2_y_1 = self->m21 * u2_s;
  const float u2_y_2 = self->m22 * u2_s;
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n_a = u2_y_0 * u2_y_0, u2_n_b = u2_y_1 * u2_y_1, u2_n_c = u2_n_a + u2_n_b,
      u2_n_d = u2_y_2 * u2_y_2, u2_n_e = u2_n_c + u2_n_d, u2_n = sqrtf(u2_n_e);
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_enlarged_0 = self->m20 * u2_up;
  const float u2_enlarged_1 = self->m21 * u2_up;
  const float u2_enlarged_2 = self->m22 * u2_up;
  const float u2_quotient_0 = u2_enlarged_0 / u2_divisor;
  const float u2_quotient_1 = u2_enlarged_1 / u2_divisor;
  const float u2_quotient_2 = u2_enlarged_2 / u2_divisor;
  const float u2_0 = u2_quotient_0 * u2_down;
  const float u2_1 = u2_quotient_1 * u2_down;
  const float u2_2 = u2_quotient_2 * u2_down;
  const float side_a = normal_0 * u2_0, side_b = normal_1 * u2_1, side_c = side_a + side_b,
      side_d = normal_2 * u2_2, side = side_c + side_d;
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float self_00_new = dependent == 1.0f ? (float)NAN : q0_0;
  const float self_01_new = dependent == 1.0f ? (float)NAN : q0_1;
  const float self_02_new = dependent == 1.0f ? (float)NAN : q0_2;
  const float self_10_new = dependent == 1.0f ? (float)NAN : q1_0;
  const float self_11_new = dependent == 1.0f ? (float)NAN : q1_1;
  const float self_12_new = dependent == 1.0f ? (float)NAN : q1_2;
  const float self_20_new = dependent == 1.0f ? (float)NAN : q2_0;
  const float self_21_new = dependent == 1.0f ? (float)NAN : q2_1;
  const float self_22_new = dependent == 1.0f ? (float)NAN : q2_2;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = orthonormal rows by Gram and Schmidt: the first keeps its direction, the second its side
     of it, the third its side of both; NaN where rows depend on each other to rounding.
   R, Ro: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   Rows are perpendicular, and of length 1, but for 4 u; searched, not proved. */
static inline void ksl_mat3x3f_normalized(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float q0_s_size_0 = fabsf(R->m00);
  const float q0_s_size_1 = fabsf(R->m01);
  const float q0_s_size_2 = fabsf(R->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = R->m00 * q0_s;
  const float q0_y_1 = R->m01 * q0_s;
  const float q0_y_2 = R->m02 * q0_s;
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n_a = q0_y_0 * q0_y_0, q0_n_b = q0_y_1 * q0_y_1, q0_n_c = q0_n_a + q0_n_b,
      q0_n_d = q0_y_2 * q0_y_2, q0_n_e = q0_n_c + q0_n_d, q0_n = sqrtf(q0_n_e);
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_enlarged_0 = R->m00 * q0_up;
  const float q0_enlarged_1 = R->m01 * q0_up;
  const float q0_enlarged_2 = R->m02 * q0_up;
  const float q0_quotient_0 = q0_enlarged_0 / q0_divisor;
  const float q0_quotient_1 = q0_enlarged_1 / q0_divisor;
  const float q0_quotient_2 = q0_enlarged_2 / q0_divisor;
  const float q0_0 = q0_quotient_0 * q0_down;
  const float q0_1 = q0_quotient_1 * q0_down;
  const float q0_2 = q0_quotient_2 * q0_down;
  const float u1_s_size_0 = fabsf(R->m10);
  const float u1_s_size_1 = fabsf(R->m11);
  const float u1_s_size_2 = fabsf(R->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = R->m10 * u1_s;
  const float u1_y_1 = R->m11 * u1_s;
  const float u1_y_2 = R->m12 * u1_s;
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n_a = u1_y_0 * u1_y_0, u1_n_b = u1_y_1 * u1_y_1, u1_n_c = u1_n_a + u1_n_b,
      u1_n_d = u1_y_2 * u1_y_2, u1_n_e = u1_n_c + u1_n_d, u1_n = sqrtf(u1_n_e);
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_enlarged_0 = R->m10 * u1_up;
  const float u1_enlarged_1 = R->m11 * u1_up;
  const float u1_enlarged_2 = R->m12 * u1_up;
  const float u1_quotient_0 = u1_enlarged_0 / u1_divisor;
  const float u1_quotient_1 = u1_enlarged_1 / u1_divisor;
  const float u1_quotient_2 = u1_enlarged_2 / u1_divisor;
  const float u1_0 = u1_quotient_0 * u1_down;
  const float u1_1 = u1_quotient_1 * u1_down;
  const float u1_2 = u1_quotient_2 * u1_down;
  const float along_a = q0_0 * u1_0, along_b = q0_1 * u1_1, along_c = along_a + along_b,
      along_d = q0_2 * u1_2, along = along_c + along_d;
  const float once_0a = q0_0 * along, once_0 = u1_0 - once_0a;
  const float once_1a = q0_1 * along, once_1 = u1_1 - once_1a;
  const float once_2a = q0_2 * along, once_2 = u1_2 - once_2a;
  const float rest_a = q0_0 * once_0, rest_b = q0_1 * once_1, rest_c = rest_a + rest_b,
      rest_d = q0_2 * once_2, rest = rest_c + rest_d;
  const float twice_0a = q0_0 * rest, twice_0 = once_0 - twice_0a;
  const float twice_1a = q0_1 * rest, twice_1 = once_1 - twice_1a;
  const float twice_2a = q0_2 * rest, twice_2 = once_2 - twice_2a;
  const float n_a = twice_0 * twice_0, n_b = twice_1 * twice_1, n_c = n_a + n_b,
      n_d = twice_2 * twice_2, n_e = n_c + n_d, n = sqrtf(n_e);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor;
  const float q1_1 = twice_1 / divisor;
  const float q1_2 = twice_2 / divisor;
  const float normal_0a = q0_1 * q1_2, normal_0b = q0_2 * q1_1, normal_0 = normal_0a - normal_0b;
  const float normal_1a = q0_2 * q1_0, normal_1b = q0_0 * q1_2, normal_1 = normal_1a - normal_1b;
  const float normal_2a = q0_0 * q1_1, normal_2b = q0_1 * q1_0, normal_2 = normal_2a - normal_2b;
  const float u2_s_size_0 = fabsf(R->m20);
  const float u2_s_size_1 = fabsf(R->m21);
  const float u2_s_size_2 = fabsf(R->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = R->m20 * u2_s;
  const float u2_y_1 = R->m21 * u2_s;
  const float u2_y_2 = R->m22 * u2_s;
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n_a = u2_y_0 * u2_y_0, u2_n_b = u2_y_1 * u2_y_1, u2_n_c = u2_n_a + u2_n_b,
      u2_n_d = u2_y_2 * u2_y_2, u2_n_e = u2_n_c + u2_n_d, u2_n = sqrtf(u2_n_e);
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_enlarged_0 = R->m20 * u2_up;
  const float u2_enlarged_1 = R->m21 * u2_up;
  const float u2_enlarged_2 = R->m22 * u2_up;
  const float u2_quotient_0 = u2_enlarged_0 / u2_divisor;
  const float u2_quotient_1 = u2_enlarged_1 / u2_divisor;
  const float u2_quotient_2 = u2_enlarged_2 / u2_divisor;
  const float u2_0 = u2_quotient_0 * u2_down;
  const float u2_1 = u2_quotient_1 * u2_down;
  const float u2_2 = u2_quotient_2 * u2_down;
  const float side_a = normal_0 * u2_0, side_b = normal_1 * u2_1, side_c = side_a + side_b,
      side_d = normal_2 * u2_2, side = side_c + side_d;
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float Ro_00 = dependent == 1.0f ? (float)NAN : q0_0;
  const float Ro_01 = dependent == 1.0f ? (float)NAN : q0_1;
  const float Ro_02 = dependent == 1.0f ? (float)NAN : q0_2;
  const float Ro_10 = dependent == 1.0f ? (float)NAN : q1_0;
  const float Ro_11 = dependent == 1.0f ? (float)NAN : q1_1;
  const float Ro_12 = dependent == 1.0f ? (float)NAN : q1_2;
  const float Ro_20 = dependent == 1.0f ? (float)NAN : q2_0;
  const float Ro_21 = dependent == 1.0f ? (float)NAN : q2_1;
  const float Ro_22 = dependent == 1.0f ? (float)NAN : q2_2;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1, dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   12 mul, 10 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_setFromAxisDC(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2]) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = axis->x * versine;
  const float versine_axis_1 = axis->y * versine;
  const float versine_axis_2 = axis->z * versine;
  const float m_0 = axis->x * versine_axis_0;
  const float m_1 = axis->y * versine_axis_1;
  const float m_2 = axis->z * versine_axis_2;
  const float m_3 = axis->y * versine_axis_0;
  const float m_4 = axis->z * versine_axis_0;
  const float m_5 = axis->z * versine_axis_1;
  const float sine_axis_0 = axis->x * dc[0];
  const float sine_axis_1 = axis->y * dc[0];
  const float sine_axis_2 = axis->z * dc[0];
  const float R_00 = dc[1] + m_0;
  const float R_01 = m_3 - sine_axis_2;
  const float R_02 = m_4 + sine_axis_1;
  const float R_10 = m_3 + sine_axis_2;
  const float R_11 = dc[1] + m_1;
  const float R_12 = m_5 - sine_axis_0;
  const float R_20 = m_4 - sine_axis_1;
  const float R_21 = m_5 + sine_axis_0;
  const float R_22 = dc[1] + m_2;
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

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   14 mul, 4 add, 3 sin, 3 cos, 3 neg. */
static inline void ksl_mat3x3f_from_euler_xyz(const ksl_vec3f_t *angles, ksl_mat3x3f_t *R) {
  const float s_0 = sinf(angles->x);
  const float s_1 = sinf(angles->y);
  const float s_2 = sinf(angles->z);
  const float c_0 = cosf(angles->x);
  const float c_1 = cosf(angles->y);
  const float c_2 = cosf(angles->z);
  const float first_0 = c_1 * c_2;
  const float first_1a = s_2 * c_1, first_1 = -first_1a;
  const float first_6a = s_1 * c_2, first_6 = -first_6a;
  const float first_7 = s_1 * s_2;
  const float last_3a = s_2 * c_0, last_3b = s_0 * first_6, last_3 = last_3a - last_3b;
  const float last_4a = c_0 * c_2, last_4b = s_0 * first_7, last_4 = last_4a - last_4b;
  const float last_5a = s_0 * c_1, last_5 = -last_5a;
  const float last_6a = s_0 * s_2, last_6b = c_0 * first_6, last_6 = last_6a + last_6b;
  const float last_7a = s_0 * c_2, last_7b = c_0 * first_7, last_7 = last_7a + last_7b;
  const float last_8 = c_0 * c_1;
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   6 mul, 3 add, 2 div, 1 sqrt, 3 atan2, 1 neg, 1 equal, 3 select.
   The rotation by these angles is R but for 6 u in each entry, near gimbal lock too; searched,
     not proved. */
static inline void ksl_euler_xyz_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n_a = R->m00 * R->m00, n_b = R->m01 * R->m01, n_c = n_a + n_b, n = sqrtf(n_c);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m00 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine_a = -R->m01, sine = sine_a / divisor;
  const float polar = atan2f(sine_a, R->m00);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1a = R->m10 * sine, left_1b = R->m11 * cosine, left_1 = left_1a + left_1b;
  const float left_2a = R->m20 * sine, left_2b = R->m21 * cosine, left_2 = left_2a + left_2b;
  const float angles_0 = atan2f(left_2, left_1);
  const float angles_1 = atan2f(R->m02, n);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   14 mul, 4 add, 3 sin, 3 cos, 2 neg. */
static inline void ksl_mat3x3f_from_euler_xyx(const ksl_vec3f_t *angles, ksl_mat3x3f_t *R) {
  const float s_0 = sinf(angles->x);
  const float s_1 = sinf(angles->y);
  const float s_2 = sinf(angles->z);
  const float c_0 = cosf(angles->x);
  const float c_1 = cosf(angles->y);
  const float c_2 = cosf(angles->z);
  const float first_1 = s_1 * s_2;
  const float first_2 = s_1 * c_2;
  const float first_7 = s_2 * c_1;
  const float first_8 = c_1 * c_2;
  const float last_3 = s_0 * s_1;
  const float last_4a = c_0 * c_2, last_4b = s_0 * first_7, last_4 = last_4a - last_4b;
  const float last_5a = s_0 * first_8, last_5b = s_2 * c_0, last_5c = last_5a + last_5b,
      last_5 = -last_5c;
  const float last_6a = s_1 * c_0, last_6 = -last_6a;
  const float last_7a = s_0 * c_2, last_7b = c_0 * first_7, last_7 = last_7a + last_7b;
  const float last_8a = c_0 * first_8, last_8b = s_0 * s_2, last_8 = last_8a - last_8b;
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   6 mul, 3 add, 2 div, 1 sqrt, 3 atan2, 1 equal, 3 select.
   The rotation by these angles is R but for 6 u in each entry, near gimbal lock too; searched,
     not proved. */
static inline void ksl_euler_xyx_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n_a = R->m01 * R->m01, n_b = R->m02 * R->m02, n_c = n_a + n_b, n = sqrtf(n_c);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m02 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine = R->m01 / divisor;
  const float polar = atan2f(R->m01, R->m02);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1a = R->m11 * cosine, left_1b = R->m12 * sine, left_1 = left_1a - left_1b;
  const float left_2a = R->m21 * cosine, left_2b = R->m22 * sine, left_2 = left_2a - left_2b;
  const float angles_0 = atan2f(left_2, left_1);
  const float angles_1 = atan2f(n, R->m00);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the plane xy, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A symmetric, its lower triangle is read.  From V =
     I, steps end in A = diag(eigenvalues), with V A V^T the same throughout.
   A, V: rotation or other 3×3 matrix.
   21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.
   |V A V^T - the same before| <= 12 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3f_jacobi(ksl_mat3x3f_t *A, ksl_mat3x3f_t *V) {
  const float twice = 2.0f * A->m10;
  const float apart = A->m11 - A->m00;
  const float divisor = twice == 0.0f ? 1.0f : twice;
  const float theta = apart / divisor;
  const float absolute = fabsf(theta);
  const float size_a = theta * theta, size_b = 1.0f + size_a, size_c = sqrtf(size_b),
      size = absolute + size_c;
  const float along_a = -size, along = theta < 0.0f ? along_a : size;
  const float t_a = 1.0f / along, t = twice == 0.0f ? 0.0f : t_a;
  const float secant_a = t * t, secant_b = 1.0f + secant_a, secant = sqrtf(secant_b);
  const float c = 1.0f / secant;
  const float s = t * c;
  const float change = A->m10 * t;
  const float zp_a = A->m20 * c, zp_b = A->m21 * s, zp = zp_a - zp_b;
  const float zq_a = A->m20 * s, zq_b = A->m21 * c, zq = zq_a + zq_b;
  const float vp_0a = V->m00 * c, vp_0b = V->m01 * s, vp_0 = vp_0a - vp_0b;
  const float vp_1a = V->m10 * c, vp_1b = V->m11 * s, vp_1 = vp_1a - vp_1b;
  const float vp_2a = V->m20 * c, vp_2b = V->m21 * s, vp_2 = vp_2a - vp_2b;
  const float vq_0a = V->m00 * s, vq_0b = V->m01 * c, vq_0 = vq_0a + vq_0b;
  const float vq_1a = V->m10 * s, vq_1b = V->m11 * c, vq_1 = vq_1a + vq_1b;
  const float vq_2a = V->m20 * s, vq_2b = V->m21 * c, vq_2 = vq_2a + vq_2b;
  const float A_00_new = A->m11 + change;
  const float A_22_new = A->m00 - change;
  const float A_m22 = A->m22;
  const float V_m02 = V->m02;
  const float V_m12 = V->m12;
  const float V_m22 = V->m22;
  A->m00 = A_00_new;
  A->m01 = zq;
  A->m02 = 0.0f;
  A->m10 = zq;
  A->m11 = A_m22;
  A->m12 = zp;
  A->m20 = 0.0f;
  A->m21 = zp;
  A->m22 = A_22_new;
  V->m00 = vq_0;
  V->m01 = V_m02;
  V->m02 = vp_0;
  V->m10 = vq_1;
  V->m11 = V_m12;
  V->m12 = vp_1;
  V->m20 = vq_2;
  V->m21 = V_m22;
  V->m22 = vp_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2; axis of length 1.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   15 mul, 13 add, 2 sin, 1 cos, 1 less, 1 select.
   Error <= R: 8 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_mat3x3f_from_axis_angle(const ksl_vec3f_t *axis, const float angle,
    ksl_mat3x3f_t *R) {
  const float half = 0.5f * angle;
  const float h = sinf(half);
  const float cosine = cosf(angle);
  const float versine_a = h * h, versine_b = 2.0f * versine_a, versine_c = 1.0f - cosine,
      versine = cosine < 0.0f ? versine_c : versine_b;
  const float sine = sinf(angle);
  const float beta_v_0 = axis->x * versine;
  const float beta_v_1 = axis->y * versine;
  const float beta_v_2 = axis->z * versine;
  const float m_0 = axis->x * beta_v_0;
  const float m_1 = axis->y * beta_v_1;
  const float m_2 = axis->z * beta_v_2;
  const float m_3 = axis->y * beta_v_0;
  const float m_4 = axis->z * beta_v_0;
  const float m_5 = axis->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float alpha_v_0 = axis->x * sine;
  const float alpha_v_1 = axis->y * sine;
  const float alpha_v_2 = axis->z * sine;
  const float R_00 = 1.0f - others_0;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_11 = 1.0f - others_1;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float R_22 = 1.0f - others_2;
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

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) where nothing turns.
   R: rotation or other 3×3 matrix; axis: vector.
   8 mul, 16 add, 3 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 26 select.
   Error <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not
     proved. */
static inline float ksl_axis_angle_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *axis) {
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
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
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

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat3x3_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat3x3_t *ksl_mat3x3_alloc(int n) {
  ksl_mat3x3_t *const all =
      n > 0 ? (ksl_mat3x3_t *)calloc((size_t)n, sizeof(ksl_mat3x3_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0;
  }
  return all;
}

/* n ksl_mat3x3f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat3x3f_t *ksl_mat3x3f_alloc(int n) {
  ksl_mat3x3f_t *const all =
      n > 0 ? (ksl_mat3x3f_t *)calloc((size_t)n, sizeof(ksl_mat3x3f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0f;
  }
  return all;
}

#endif

/* What KSL declares beside formulas. */


/* self = self^-1; returns 0, or -3 where self is singular to rounding, and then NaN. */
static inline int ksl_mat3x3_invert(ksl_mat3x3_t *R) {
  return ksl_mat3x3_inverse(R, R) != 0 ? 0 : -3;
}

/* ro = ri^-1; returns 0, or -3 where ri is singular to rounding, and ro NaN. */
static inline int ksl_mat3x3_inverted(
    const ksl_mat3x3_t *ri, ksl_mat3x3_t *ro) {
  return ksl_mat3x3_inverse(ri, ro) != 0 ? 0 : -3;
}

/* Axis and angle of the rotation r, as ksl_axis_angle_from_mat3x3 has them. */
static inline void ksl_mat3x3_getAxisAngle(
    const ksl_mat3x3_t *r, ksl_vec3_t *axis, double *angle) {
  *angle = ksl_axis_angle_from_mat3x3(r, axis);
}

/* The rotation about an axis of any length but zero; of that, the identity. */
static inline void ksl_mat3x3_setFromAxisAngle(
    ksl_mat3x3_t *r, const ksl_vec3_t *axis, const double angle) {
  ksl_vec3_t unit;
  ksl_vec3_normalized(axis, &unit);
  ksl_mat3x3_from_axis_angle(&unit, angle, r);
}

/* r = R_i(x) R_j(y) R_k(z) of angles (x, y, z), the axes i, j, k those of the sequence: each turn is
   about an axis of the body as the turns before have left it.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3_setFromEulerAngles(
    ksl_mat3x3_t *r, const ksl_axis_enum_t axisType, const ksl_vec3_t *angles) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const double sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0 : -1.0;
  const ksl_vec3_t turned =
      ksl_vec3(sign * angles->x, sign * angles->y, sign * angles->z);
  ksl_mat3x3_t R;
  if (axes.x < 0) {
    for (int i = 0; i < 9; i++) { r->as_array[i] = (double)NAN; }
    return;
  }
  if (axes.x == axes.z) {
    ksl_mat3x3_from_euler_xyx(&turned, &R);
  } else {
    ksl_mat3x3_from_euler_xyz(&turned, &R);
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { r->at[own[column]][own[row]] = R.at[column][row]; }
  }
}

/* The angles (x, y, z) of the rotation r = R_i(x) R_j(y) R_k(z), the axes i, j, k those of the
   sequence, next to those of the reference (ksl_vec3_t *) that follows, zeros for NULL: z from 1/8
   turn below it to 3/8 above, x and y from 1/8 turn below to 7/8 above.  In gimbal lock z is a
   multiple of half a turn.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3_getEulerAnglesWithReference(
    const ksl_mat3x3_t *r, const ksl_axis_enum_t axisType, ksl_vec3_t *angles, ...) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const double sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0 : -1.0;
  const double eighth = 0.7853981633974483, half = 3.141592653589793, whole = 6.283185307179586;
  ksl_vec3_t near = ksl_vec3(0, 0, 0), found = near;
  const ksl_vec3_t *reference;
  ksl_mat3x3_t R;
  va_list arguments;
  va_start(arguments, angles);
  reference = va_arg(arguments, const ksl_vec3_t *);
  va_end(arguments);
  if (reference != NULL) { near = *reference; }
  if (axes.x < 0) {
    angles->x = angles->y = angles->z = (double)NAN;
    return;
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { R.at[column][row] = r->at[own[column]][own[row]]; }
  }
  if (axes.x == axes.z) {
    ksl_euler_xyx_from_mat3x3(&R, &found);
  } else {
    ksl_euler_xyz_from_mat3x3(&R, &found);
  }
  {
    const double z = sign * found.z, turns = ceil((near.z - eighth - z) / half);
    const int other = fmod(turns, 2) != 0; /* half a turn of z needs one of x, too */
    const double y = sign * found.y, flipped = axes.x == axes.z ? -y : half - y;
    const double x = sign * found.x + (other ? half : 0), middle = other ? flipped : y;
    angles->x = x + whole * ceil((near.x - eighth - x) / whole);
    angles->y = middle + whole * ceil((near.y - eighth - middle) / whole);
    angles->z = z + half * turns;
  }
}

/* The same; the reference may be left out. */
#define ksl_mat3x3_getEulerAngles(r, ...) \
  ksl_mat3x3_getEulerAnglesWithReference(r, __VA_ARGS__, (ksl_vec3_t *)NULL)

/* Principal axes: A becomes the diagonal matrix of its eigenvalues, the largest first, and the
   columns of v the eigenvectors, a rotation: A before = v A v^T.  A symmetric, its lower triangle
   is read. */
static inline void ksl_mat3x3_pca(ksl_mat3x3_t *A, ksl_mat3x3_t *v) {
  static const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 1}};
  ksl_mat3x3_setIdentity(v);
  /* Off-diagonal entries fall cubically; 12 cycles of three planes leave none above
     u^2 of the largest entry. */
  for (int n = 0; n < 36 && (A->m10 != 0 || A->m20 != 0 || A->m21 != 0); n++) {
    ksl_mat3x3_jacobi(A, v);
  }
  A->m01 = A->m02 = A->m12 = A->m10 = A->m20 = A->m21 = 0;
  for (int n = 0; n < 3; n++) {
    const int i = pairs[n][0], j = pairs[n][1];
    const double value = A->at[i][i];
    if (value < A->at[j][j]) {
      A->at[i][i] = A->at[j][j];
      A->at[j][j] = value;
      ksl_vec3_swap(&v->v[i], &v->v[j]);
      ksl_vec3_invert(&v->v[j]);
    }
  }
}

/* self = self^-1; returns 0, or -3 where self is singular to rounding, and then NaN. */
static inline int ksl_mat3x3f_invert(ksl_mat3x3f_t *R) {
  return ksl_mat3x3f_inverse(R, R) != 0 ? 0 : -3;
}

/* ro = ri^-1; returns 0, or -3 where ri is singular to rounding, and ro NaN. */
static inline int ksl_mat3x3f_inverted(
    const ksl_mat3x3f_t *ri, ksl_mat3x3f_t *ro) {
  return ksl_mat3x3f_inverse(ri, ro) != 0 ? 0 : -3;
}

/* Axis and angle of the rotation r, as ksl_axis_angle_from_mat3x3f has them. */
static inline void ksl_mat3x3f_getAxisAngle(
    const ksl_mat3x3f_t *r, ksl_vec3f_t *axis, float *angle) {
  *angle = ksl_axis_angle_from_mat3x3f(r, axis);
}

/* The rotation about an axis of any length but zero; of that, the identity. */
static inline void ksl_mat3x3f_setFromAxisAngle(
    ksl_mat3x3f_t *r, const ksl_vec3f_t *axis, const float angle) {
  ksl_vec3f_t unit;
  ksl_vec3f_normalized(axis, &unit);
  ksl_mat3x3f_from_axis_angle(&unit, angle, r);
}

/* r = R_i(x) R_j(y) R_k(z) of angles (x, y, z), the axes i, j, k those of the sequence: each turn is
   about an axis of the body as the turns before have left it.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3f_setFromEulerAngles(
    ksl_mat3x3f_t *r, const ksl_axis_enum_t axisType, const ksl_vec3f_t *angles) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const float sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0f : -1.0f;
  const ksl_vec3f_t turned =
      ksl_vec3f(sign * angles->x, sign * angles->y, sign * angles->z);
  ksl_mat3x3f_t R;
  if (axes.x < 0) {
    for (int i = 0; i < 9; i++) { r->as_array[i] = (float)NAN; }
    return;
  }
  if (axes.x == axes.z) {
    ksl_mat3x3f_from_euler_xyx(&turned, &R);
  } else {
    ksl_mat3x3f_from_euler_xyz(&turned, &R);
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { r->at[own[column]][own[row]] = R.at[column][row]; }
  }
}

/* The angles (x, y, z) of the rotation r = R_i(x) R_j(y) R_k(z), the axes i, j, k those of the
   sequence, next to those of the reference (ksl_vec3f_t *) that follows, zeros for NULL: z from 1/8
   turn below it to 3/8 above, x and y from 1/8 turn below to 7/8 above.  In gimbal lock z is a
   multiple of half a turn.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3f_getEulerAnglesWithReference(
    const ksl_mat3x3f_t *r, const ksl_axis_enum_t axisType, ksl_vec3f_t *angles, ...) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const float sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0f : -1.0f;
  const float eighth = 0.7853982f, half = 3.1415927f, whole = 6.2831855f;
  ksl_vec3f_t near = ksl_vec3f(0, 0, 0), found = near;
  const ksl_vec3f_t *reference;
  ksl_mat3x3f_t R;
  va_list arguments;
  va_start(arguments, angles);
  reference = va_arg(arguments, const ksl_vec3f_t *);
  va_end(arguments);
  if (reference != NULL) { near = *reference; }
  if (axes.x < 0) {
    angles->x = angles->y = angles->z = (float)NAN;
    return;
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { R.at[column][row] = r->at[own[column]][own[row]]; }
  }
  if (axes.x == axes.z) {
    ksl_euler_xyx_from_mat3x3f(&R, &found);
  } else {
    ksl_euler_xyz_from_mat3x3f(&R, &found);
  }
  {
    const float z = sign * found.z, turns = ceilf((near.z - eighth - z) / half);
    const int other = fmodf(turns, 2) != 0; /* half a turn of z needs one of x, too */
    const float y = sign * found.y, flipped = axes.x == axes.z ? -y : half - y;
    const float x = sign * found.x + (other ? half : 0), middle = other ? flipped : y;
    angles->x = x + whole * ceilf((near.x - eighth - x) / whole);
    angles->y = middle + whole * ceilf((near.y - eighth - middle) / whole);
    angles->z = z + half * turns;
  }
}

/* The same; the reference may be left out. */
#define ksl_mat3x3f_getEulerAngles(r, ...) \
  ksl_mat3x3f_getEulerAnglesWithReference(r, __VA_ARGS__, (ksl_vec3f_t *)NULL)

/* Principal axes: A becomes the diagonal matrix of its eigenvalues, the largest first, and the
   columns of v the eigenvectors, a rotation: A before = v A v^T.  A symmetric, its lower triangle
   is read. */
static inline void ksl_mat3x3f_pca(ksl_mat3x3f_t *A, ksl_mat3x3f_t *v) {
  static const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 1}};
  ksl_mat3x3f_setIdentity(v);
  /* Off-diagonal entries fall cubically; 12 cycles of three planes leave none above
     u^2 of the largest entry. */
  for (int n = 0; n < 36 && (A->m10 != 0 || A->m20 != 0 || A->m21 != 0); n++) {
    ksl_mat3x3f_jacobi(A, v);
  }
  A->m01 = A->m02 = A->m12 = A->m10 = A->m20 = A->m21 = 0;
  for (int n = 0; n < 3; n++) {
    const int i = pairs[n][0], j = pairs[n][1];
    const float value = A->at[i][i];
    if (value < A->at[j][j]) {
      A->at[i][i] = A->at[j][j];
      A->at[j][j] = value;
      ksl_vec3f_swap(&v->v[i], &v->v[j]);
      ksl_vec3f_invert(&v->v[j]);
    }
  }
}

#endif

/* Displacements D = [R | t]. */
#ifndef KSL_SE3_H
#define KSL_SE3_H


/* The SE3 of these entries, row by row. */
static inline ksl_SE3_t ksl_SE3(const double m00, const double m01, const double m02,
    const double m03, const double m10, const double m11, const double m12,
    const double m13, const double m20, const double m21, const double m22,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3_t ksl_SE3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22, const double m03, const double m13,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3_t ksl_SE3_identity(void) {
  return ksl_SE3(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline double ksl_SE3_get(const ksl_SE3_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (double)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3_set(ksl_SE3_t *D, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3_t ksl_SE3_fromRt(const ksl_mat3x3_t R, const ksl_vec3_t t) {
  ksl_SE3_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_copy(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_setIdentity(ksl_SE3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m03 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m13 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
  self->m23 = 0.0;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getTranslation(const ksl_SE3_t *D, ksl_vec3_t *t) {
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getRotation(const ksl_SE3_t *D, ksl_mat3x3_t *R) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert(ksl_SE3_t *self) {
  const double self_03_new_a = self->m00 * self->m03, self_03_new_b = self->m10 * self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b, self_03_new_d = self->m20 * self->m23,
      self_03_new_e = self_03_new_c + self_03_new_d, self_03_new = -self_03_new_e;
  const double self_13_new_a = self->m01 * self->m03, self_13_new_b = self->m11 * self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b, self_13_new_d = self->m21 * self->m23,
      self_13_new_e = self_13_new_c + self_13_new_d, self_13_new = -self_13_new_e;
  const double self_23_new_a = self->m02 * self->m03, self_23_new_b = self->m12 * self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b, self_23_new_d = self->m22 * self->m23,
      self_23_new_e = self_23_new_c + self_23_new_d, self_23_new = -self_23_new_e;
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_toMat4x4(const ksl_SE3_t *D, ksl_mat4x4_t *M) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  M->m00 = D_m00;
  M->m01 = D_m01;
  M->m02 = D_m02;
  M->m03 = D_m03;
  M->m10 = D_m10;
  M->m11 = D_m11;
  M->m12 = D_m12;
  M->m13 = D_m13;
  M->m20 = D_m20;
  M->m21 = D_m21;
  M->m22 = D_m22;
  M->m23 = D_m23;
  M->m30 = 0.0;
  M->m31 = 0.0;
  M->m32 = 0.0;
  M->m33 = 1.0;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * D->m03, Do_03b = D->m10 * D->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * D->m23, Do_03e = Do_03c + Do_03d, Do_03 = -Do_03e;
  const double Do_13a = D->m01 * D->m03, Do_13b = D->m11 * D->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * D->m23, Do_13e = Do_13c + Do_13d, Do_13 = -Do_13e;
  const double Do_23a = D->m02 * D->m03, Do_23b = D->m12 * D->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * D->m23, Do_23e = Do_23c + Do_23d, Do_23 = -Do_23e;
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
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* The SE3 of these entries, row by row. */
static inline ksl_SE3f_t ksl_SE3f(const float m00, const float m01, const float m02,
    const float m03, const float m10, const float m11, const float m12,
    const float m13, const float m20, const float m21, const float m22,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3f_t ksl_SE3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22, const float m03, const float m13,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3f_t ksl_SE3f_identity(void) {
  return ksl_SE3f(1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline float ksl_SE3f_get(const ksl_SE3f_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (float)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3f_set(ksl_SE3f_t *D, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3f_t ksl_SE3f_fromRt(const ksl_mat3x3f_t R, const ksl_vec3f_t t) {
  ksl_SE3f_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_copy(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_setIdentity(ksl_SE3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m03 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m13 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
  self->m23 = 0.0f;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getTranslation(const ksl_SE3f_t *D, ksl_vec3f_t *t) {
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getRotation(const ksl_SE3f_t *D, ksl_mat3x3f_t *R) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert(ksl_SE3f_t *self) {
  const float self_03_new_a = self->m00 * self->m03, self_03_new_b = self->m10 * self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b, self_03_new_d = self->m20 * self->m23,
      self_03_new_e = self_03_new_c + self_03_new_d, self_03_new = -self_03_new_e;
  const float self_13_new_a = self->m01 * self->m03, self_13_new_b = self->m11 * self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b, self_13_new_d = self->m21 * self->m23,
      self_13_new_e = self_13_new_c + self_13_new_d, self_13_new = -self_13_new_e;
  const float self_23_new_a = self->m02 * self->m03, self_23_new_b = self->m12 * self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b, self_23_new_d = self->m22 * self->m23,
      self_23_new_e = self_23_new_c + self_23_new_d, self_23_new = -self_23_new_e;
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_toMat4x4f(const ksl_SE3f_t *D, ksl_mat4x4f_t *M) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  M->m00 = D_m00;
  M->m01 = D_m01;
  M->m02 = D_m02;
  M->m03 = D_m03;
  M->m10 = D_m10;
  M->m11 = D_m11;
  M->m12 = D_m12;
  M->m13 = D_m13;
  M->m20 = D_m20;
  M->m21 = D_m21;
  M->m22 = D_m22;
  M->m23 = D_m23;
  M->m30 = 0.0f;
  M->m31 = 0.0f;
  M->m32 = 0.0f;
  M->m33 = 1.0f;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * D->m03, Do_03b = D->m10 * D->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * D->m23, Do_03e = Do_03c + Do_03d, Do_03 = -Do_03e;
  const float Do_13a = D->m01 * D->m03, Do_13b = D->m11 * D->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * D->m23, Do_13e = Do_13c + Do_13d, Do_13 = -Do_13e;
  const float Do_23a = D->m02 * D->m03, Do_23b = D->m12 * D->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * D->m23, Do_23e = Do_23c + Do_23d, Do_23 = -Do_23e;
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
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_SE3_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_SE3_t *ksl_SE3_alloc(int n) {
  ksl_SE3_t *const all =
      n > 0 ? (ksl_SE3_t *)calloc((size_t)n, sizeof(ksl_SE3_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0;
  }
  return all;
}

/* n ksl_SE3f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_SE3f_t *ksl_SE3f_alloc(int n) {
  ksl_SE3f_t *const all =
      n > 0 ? (ksl_SE3f_t *)calloc((size_t)n, sizeof(ksl_SE3f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0f;
  }
  return all;
}

#endif

#endif

/* 4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates. */
#ifndef KSL_MAT4X4_H
#define KSL_MAT4X4_H


/* The mat4x4 of these entries, row by row. */
static inline ksl_mat4x4_t ksl_mat4x4(const double m00, const double m01, const double m02,
    const double m03, const double m10, const double m11, const double m12,
    const double m13, const double m20, const double m21, const double m22,
    const double m23, const double m30, const double m31, const double m32,
    const double m33) {
  ksl_mat4x4_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  value.m30 = m30;
  value.m31 = m31;
  value.m32 = m32;
  value.m33 = m33;
  return value;
}

/* The mat4x4 of these entries, column by column. */
static inline ksl_mat4x4_t ksl_mat4x4_cmo(const double m00, const double m10, const double m20,
    const double m30, const double m01, const double m11, const double m21,
    const double m31, const double m02, const double m12, const double m22,
    const double m32, const double m03, const double m13, const double m23,
    const double m33) {
  ksl_mat4x4_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m30 = m30;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m31 = m31;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m32 = m32;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  value.m33 = m33;
  return value;
}

/* The entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; NaN outside. */
static inline double ksl_mat4x4_get(const ksl_mat4x4_t *M, const int row, const int column) {
  return row >= 0 && row < 4 && column >= 0 && column < 4 ? M->at[column][row] : (double)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_mat4x4_set(ksl_mat4x4_t *M, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 4 && column >= 0 && column < 4) {
    M->at[column][row] = value;
  }
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4_t ksl_mat4x4_fromSE3(const ksl_SE3_t D) {
  ksl_mat4x4_t M;
  M.m00 = D.m00;
  M.m01 = D.m01;
  M.m02 = D.m02;
  M.m03 = D.m03;
  M.m10 = D.m10;
  M.m11 = D.m11;
  M.m12 = D.m12;
  M.m13 = D.m13;
  M.m20 = D.m20;
  M.m21 = D.m21;
  M.m22 = D.m22;
  M.m23 = D.m23;
  M.m30 = 0.0;
  M.m31 = 0.0;
  M.m32 = 0.0;
  M.m33 = 1.0;
  return M;
}

/* M = [[R, t], [0, 1]].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4_t ksl_mat4x4_fromRt(const ksl_mat3x3_t R, const ksl_vec3_t t) {
  ksl_mat4x4_t M;
  M.m00 = R.m00;
  M.m01 = R.m01;
  M.m02 = R.m02;
  M.m03 = t.x;
  M.m10 = R.m10;
  M.m11 = R.m11;
  M.m12 = R.m12;
  M.m13 = t.y;
  M.m20 = R.m20;
  M.m21 = R.m21;
  M.m22 = R.m22;
  M.m23 = t.z;
  M.m30 = 0.0;
  M.m31 = 0.0;
  M.m32 = 0.0;
  M.m33 = 1.0;
  return M;
}

/* D = [R | t], the first three rows of M.
   M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_toSE3(const ksl_mat4x4_t *M, ksl_SE3_t *D) {
  const double M_m00 = M->m00;
  const double M_m01 = M->m01;
  const double M_m02 = M->m02;
  const double M_m03 = M->m03;
  const double M_m10 = M->m10;
  const double M_m11 = M->m11;
  const double M_m12 = M->m12;
  const double M_m13 = M->m13;
  const double M_m20 = M->m20;
  const double M_m21 = M->m21;
  const double M_m22 = M->m22;
  const double M_m23 = M->m23;
  D->m00 = M_m00;
  D->m01 = M_m01;
  D->m02 = M_m02;
  D->m03 = M_m03;
  D->m10 = M_m10;
  D->m11 = M_m11;
  D->m12 = M_m12;
  D->m13 = M_m13;
  D->m20 = M_m20;
  D->m21 = M_m21;
  D->m22 = M_m22;
  D->m23 = M_m23;
}

/* self = I.
   self: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_setIdentity(ksl_mat4x4_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m03 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m13 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
  self->m23 = 0.0;
  self->m30 = 0.0;
  self->m31 = 0.0;
  self->m32 = 0.0;
  self->m33 = 1.0;
}

/* t, the first three entries of the last column of M.
   M: 4×4 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_getTranslation(const ksl_mat4x4_t *M, ksl_vec3_t *t) {
  const double M_m03 = M->m03;
  const double M_m13 = M->m13;
  const double M_m23 = M->m23;
  t->x = M_m03;
  t->y = M_m13;
  t->z = M_m23;
}

/* The mat4x4 of these entries, row by row. */
static inline ksl_mat4x4f_t ksl_mat4x4f(const float m00, const float m01, const float m02,
    const float m03, const float m10, const float m11, const float m12,
    const float m13, const float m20, const float m21, const float m22,
    const float m23, const float m30, const float m31, const float m32,
    const float m33) {
  ksl_mat4x4f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  value.m30 = m30;
  value.m31 = m31;
  value.m32 = m32;
  value.m33 = m33;
  return value;
}

/* The mat4x4 of these entries, column by column. */
static inline ksl_mat4x4f_t ksl_mat4x4f_cmo(const float m00, const float m10, const float m20,
    const float m30, const float m01, const float m11, const float m21,
    const float m31, const float m02, const float m12, const float m22,
    const float m32, const float m03, const float m13, const float m23,
    const float m33) {
  ksl_mat4x4f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m30 = m30;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m31 = m31;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m32 = m32;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  value.m33 = m33;
  return value;
}

/* The entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; NaN outside. */
static inline float ksl_mat4x4f_get(const ksl_mat4x4f_t *M, const int row, const int column) {
  return row >= 0 && row < 4 && column >= 0 && column < 4 ? M->at[column][row] : (float)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_mat4x4f_set(ksl_mat4x4f_t *M, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 4 && column >= 0 && column < 4) {
    M->at[column][row] = value;
  }
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4f_t ksl_mat4x4f_fromSE3f(const ksl_SE3f_t D) {
  ksl_mat4x4f_t M;
  M.m00 = D.m00;
  M.m01 = D.m01;
  M.m02 = D.m02;
  M.m03 = D.m03;
  M.m10 = D.m10;
  M.m11 = D.m11;
  M.m12 = D.m12;
  M.m13 = D.m13;
  M.m20 = D.m20;
  M.m21 = D.m21;
  M.m22 = D.m22;
  M.m23 = D.m23;
  M.m30 = 0.0f;
  M.m31 = 0.0f;
  M.m32 = 0.0f;
  M.m33 = 1.0f;
  return M;
}

/* M = [[R, t], [0, 1]].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4f_t ksl_mat4x4f_fromRt(const ksl_mat3x3f_t R, const ksl_vec3f_t t) {
  ksl_mat4x4f_t M;
  M.m00 = R.m00;
  M.m01 = R.m01;
  M.m02 = R.m02;
  M.m03 = t.x;
  M.m10 = R.m10;
  M.m11 = R.m11;
  M.m12 = R.m12;
  M.m13 = t.y;
  M.m20 = R.m20;
  M.m21 = R.m21;
  M.m22 = R.m22;
  M.m23 = t.z;
  M.m30 = 0.0f;
  M.m31 = 0.0f;
  M.m32 = 0.0f;
  M.m33 = 1.0f;
  return M;
}

/* D = [R | t], the first three rows of M.
   M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_toSE3f(const ksl_mat4x4f_t *M, ksl_SE3f_t *D) {
  const float M_m00 = M->m00;
  const float M_m01 = M->m01;
  const float M_m02 = M->m02;
  const float M_m03 = M->m03;
  const float M_m10 = M->m10;
  const float M_m11 = M->m11;
  const float M_m12 = M->m12;
  const float M_m13 = M->m13;
  const float M_m20 = M->m20;
  const float M_m21 = M->m21;
  const float M_m22 = M->m22;
  const float M_m23 = M->m23;
  D->m00 = M_m00;
  D->m01 = M_m01;
  D->m02 = M_m02;
  D->m03 = M_m03;
  D->m10 = M_m10;
  D->m11 = M_m11;
  D->m12 = M_m12;
  D->m13 = M_m13;
  D->m20 = M_m20;
  D->m21 = M_m21;
  D->m22 = M_m22;
  D->m23 = M_m23;
}

/* self = I.
   self: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_setIdentity(ksl_mat4x4f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m03 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m13 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
  self->m23 = 0.0f;
  self->m30 = 0.0f;
  self->m31 = 0.0f;
  self->m32 = 0.0f;
  self->m33 = 1.0f;
}

/* t, the first three entries of the last column of M.
   M: 4×4 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_getTranslation(const ksl_mat4x4f_t *M, ksl_vec3f_t *t) {
  const float M_m03 = M->m03;
  const float M_m13 = M->m13;
  const float M_m23 = M->m23;
  t->x = M_m03;
  t->y = M_m13;
  t->z = M_m23;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat4x4_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat4x4_t *ksl_mat4x4_alloc(int n) {
  ksl_mat4x4_t *const all =
      n > 0 ? (ksl_mat4x4_t *)calloc((size_t)n, sizeof(ksl_mat4x4_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = all[i].m33 = 1.0;
  }
  return all;
}

/* n ksl_mat4x4f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat4x4f_t *ksl_mat4x4f_alloc(int n) {
  ksl_mat4x4f_t *const all =
      n > 0 ? (ksl_mat4x4f_t *)calloc((size_t)n, sizeof(ksl_mat4x4f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = all[i].m33 = 1.0f;
  }
  return all;
}

#endif

#endif

/* 6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them. */
#ifndef KSL_MAT6X6_H
#define KSL_MAT6X6_H


/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline double ksl_mat6x6_get(const ksl_mat6x6_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (double)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6_set(ksl_mat6x6_t *M, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_copy(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_10 = M->at[1][0];
  const double M_at_20 = M->at[2][0];
  const double M_at_30 = M->at[3][0];
  const double M_at_40 = M->at[4][0];
  const double M_at_50 = M->at[5][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_11 = M->at[1][1];
  const double M_at_21 = M->at[2][1];
  const double M_at_31 = M->at[3][1];
  const double M_at_41 = M->at[4][1];
  const double M_at_51 = M->at[5][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_12 = M->at[1][2];
  const double M_at_22 = M->at[2][2];
  const double M_at_32 = M->at[3][2];
  const double M_at_42 = M->at[4][2];
  const double M_at_52 = M->at[5][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_13 = M->at[1][3];
  const double M_at_23 = M->at[2][3];
  const double M_at_33 = M->at[3][3];
  const double M_at_43 = M->at[4][3];
  const double M_at_53 = M->at[5][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_14 = M->at[1][4];
  const double M_at_24 = M->at[2][4];
  const double M_at_34 = M->at[3][4];
  const double M_at_44 = M->at[4][4];
  const double M_at_54 = M->at[5][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_15 = M->at[1][5];
  const double M_at_25 = M->at[2][5];
  const double M_at_35 = M->at[3][5];
  const double M_at_45 = M->at[4][5];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_setIdentity(ksl_mat6x6_t *self) {
  self->at[0][0] = 1.0;
  self->at[1][0] = 0.0;
  self->at[2][0] = 0.0;
  self->at[3][0] = 0.0;
  self->at[4][0] = 0.0;
  self->at[5][0] = 0.0;
  self->at[0][1] = 0.0;
  self->at[1][1] = 1.0;
  self->at[2][1] = 0.0;
  self->at[3][1] = 0.0;
  self->at[4][1] = 0.0;
  self->at[5][1] = 0.0;
  self->at[0][2] = 0.0;
  self->at[1][2] = 0.0;
  self->at[2][2] = 1.0;
  self->at[3][2] = 0.0;
  self->at[4][2] = 0.0;
  self->at[5][2] = 0.0;
  self->at[0][3] = 0.0;
  self->at[1][3] = 0.0;
  self->at[2][3] = 0.0;
  self->at[3][3] = 1.0;
  self->at[4][3] = 0.0;
  self->at[5][3] = 0.0;
  self->at[0][4] = 0.0;
  self->at[1][4] = 0.0;
  self->at[2][4] = 0.0;
  self->at[3][4] = 0.0;
  self->at[4][4] = 1.0;
  self->at[5][4] = 0.0;
  self->at[0][5] = 0.0;
  self->at[1][5] = 0.0;
  self->at[2][5] = 0.0;
  self->at[3][5] = 0.0;
  self->at[4][5] = 0.0;
  self->at[5][5] = 1.0;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_transposed(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_10 = M->at[1][0];
  const double M_at_11 = M->at[1][1];
  const double M_at_12 = M->at[1][2];
  const double M_at_13 = M->at[1][3];
  const double M_at_14 = M->at[1][4];
  const double M_at_15 = M->at[1][5];
  const double M_at_20 = M->at[2][0];
  const double M_at_21 = M->at[2][1];
  const double M_at_22 = M->at[2][2];
  const double M_at_23 = M->at[2][3];
  const double M_at_24 = M->at[2][4];
  const double M_at_25 = M->at[2][5];
  const double M_at_30 = M->at[3][0];
  const double M_at_31 = M->at[3][1];
  const double M_at_32 = M->at[3][2];
  const double M_at_33 = M->at[3][3];
  const double M_at_34 = M->at[3][4];
  const double M_at_35 = M->at[3][5];
  const double M_at_40 = M->at[4][0];
  const double M_at_41 = M->at[4][1];
  const double M_at_42 = M->at[4][2];
  const double M_at_43 = M->at[4][3];
  const double M_at_44 = M->at[4][4];
  const double M_at_45 = M->at[4][5];
  const double M_at_50 = M->at[5][0];
  const double M_at_51 = M->at[5][1];
  const double M_at_52 = M->at[5][2];
  const double M_at_53 = M->at[5][3];
  const double M_at_54 = M->at[5][4];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline float ksl_mat6x6f_get(const ksl_mat6x6f_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (float)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6f_set(ksl_mat6x6f_t *M, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_copy(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_10 = M->at[1][0];
  const float M_at_20 = M->at[2][0];
  const float M_at_30 = M->at[3][0];
  const float M_at_40 = M->at[4][0];
  const float M_at_50 = M->at[5][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_11 = M->at[1][1];
  const float M_at_21 = M->at[2][1];
  const float M_at_31 = M->at[3][1];
  const float M_at_41 = M->at[4][1];
  const float M_at_51 = M->at[5][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_12 = M->at[1][2];
  const float M_at_22 = M->at[2][2];
  const float M_at_32 = M->at[3][2];
  const float M_at_42 = M->at[4][2];
  const float M_at_52 = M->at[5][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_13 = M->at[1][3];
  const float M_at_23 = M->at[2][3];
  const float M_at_33 = M->at[3][3];
  const float M_at_43 = M->at[4][3];
  const float M_at_53 = M->at[5][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_14 = M->at[1][4];
  const float M_at_24 = M->at[2][4];
  const float M_at_34 = M->at[3][4];
  const float M_at_44 = M->at[4][4];
  const float M_at_54 = M->at[5][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_15 = M->at[1][5];
  const float M_at_25 = M->at[2][5];
  const float M_at_35 = M->at[3][5];
  const float M_at_45 = M->at[4][5];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_setIdentity(ksl_mat6x6f_t *self) {
  self->at[0][0] = 1.0f;
  self->at[1][0] = 0.0f;
  self->at[2][0] = 0.0f;
  self->at[3][0] = 0.0f;
  self->at[4][0] = 0.0f;
  self->at[5][0] = 0.0f;
  self->at[0][1] = 0.0f;
  self->at[1][1] = 1.0f;
  self->at[2][1] = 0.0f;
  self->at[3][1] = 0.0f;
  self->at[4][1] = 0.0f;
  self->at[5][1] = 0.0f;
  self->at[0][2] = 0.0f;
  self->at[1][2] = 0.0f;
  self->at[2][2] = 1.0f;
  self->at[3][2] = 0.0f;
  self->at[4][2] = 0.0f;
  self->at[5][2] = 0.0f;
  self->at[0][3] = 0.0f;
  self->at[1][3] = 0.0f;
  self->at[2][3] = 0.0f;
  self->at[3][3] = 1.0f;
  self->at[4][3] = 0.0f;
  self->at[5][3] = 0.0f;
  self->at[0][4] = 0.0f;
  self->at[1][4] = 0.0f;
  self->at[2][4] = 0.0f;
  self->at[3][4] = 0.0f;
  self->at[4][4] = 1.0f;
  self->at[5][4] = 0.0f;
  self->at[0][5] = 0.0f;
  self->at[1][5] = 0.0f;
  self->at[2][5] = 0.0f;
  self->at[3][5] = 0.0f;
  self->at[4][5] = 0.0f;
  self->at[5][5] = 1.0f;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_transposed(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_10 = M->at[1][0];
  const float M_at_11 = M->at[1][1];
  const float M_at_12 = M->at[1][2];
  const float M_at_13 = M->at[1][3];
  const float M_at_14 = M->at[1][4];
  const float M_at_15 = M->at[1][5];
  const float M_at_20 = M->at[2][0];
  const float M_at_21 = M->at[2][1];
  const float M_at_22 = M->at[2][2];
  const float M_at_23 = M->at[2][3];
  const float M_at_24 = M->at[2][4];
  const float M_at_25 = M->at[2][5];
  const float M_at_30 = M->at[3][0];
  const float M_at_31 = M->at[3][1];
  const float M_at_32 = M->at[3][2];
  const float M_at_33 = M->at[3][3];
  const float M_at_34 = M->at[3][4];
  const float M_at_35 = M->at[3][5];
  const float M_at_40 = M->at[4][0];
  const float M_at_41 = M->at[4][1];
  const float M_at_42 = M->at[4][2];
  const float M_at_43 = M->at[4][3];
  const float M_at_44 = M->at[4][4];
  const float M_at_45 = M->at[4][5];
  const float M_at_50 = M->at[5][0];
  const float M_at_51 = M->at[5][1];
  const float M_at_52 = M->at[5][2];
  const float M_at_53 = M->at[5][3];
  const float M_at_54 = M->at[5][4];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat6x6_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_mat6x6_t *ksl_mat6x6_alloc(int n) {
  return n > 0 ? (ksl_mat6x6_t *)calloc((size_t)n, sizeof(ksl_mat6x6_t)) : NULL;
}

/* n ksl_mat6x6f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_mat6x6f_t *ksl_mat6x6f_alloc(int n) {
  return n > 0 ? (ksl_mat6x6f_t *)calloc((size_t)n, sizeof(ksl_mat6x6f_t)) : NULL;
}

#endif

#endif

/* Products between rotations, displacements and vectors. */
#ifndef KSL_MATRIX_H
#define KSL_MATRIX_H


/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = D->m00 * v->x, vo_0b = D->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const double vo_1a = D->m10 * v->x, vo_1b = D->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const double vo_2a = D->m20 * v->x, vo_2b = D->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = D->m00 * p_0, vo_0b = D->m10 * p_1, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m20 * p_2, vo_0 = vo_0c + vo_0d;
  const double vo_1a = D->m01 * p_0, vo_1b = D->m11 * p_1, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m21 * p_2, vo_1 = vo_1c + vo_1d;
  const double vo_2a = D->m02 * p_0, vo_2b = D->m12 * p_1, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * p_2, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m01 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m10 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m10 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m20 * R2->m01, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m20 * R2->m02, Ro_22b = R1->m21 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinv(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m02, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m10, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m12, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m20, Ro_02b = R1->m01 * R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m02, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m10 * R2->m10, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m12, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m10 * R2->m20, Ro_12b = R1->m11 * R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m02, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m20 * R2->m10, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m12, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m20 * R2->m20, Ro_22b = R1->m21 * R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m10 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m20 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m10 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m20 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m10 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m20 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m01 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m21 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m01 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m21 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m01 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m21 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m02 * R2->m00, Ro_20b = R1->m12 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m02 * R2->m01, Ro_21b = R1->m12 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m02 * R2->m02, Ro_22b = R1->m12 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m01 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m02 * D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m01 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m02 * D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m01 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = D1->m00 * D2->m03, Do_03b = D1->m01 * D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * D2->m23, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const double Do_10a = D1->m10 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m12 * D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D1->m10 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m12 * D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D1->m10 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = D1->m10 * D2->m03, Do_13b = D1->m11 * D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * D2->m23, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const double Do_20a = D1->m20 * D2->m00, Do_20b = D1->m21 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D1->m20 * D2->m01, Do_21b = D1->m21 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D1->m20 * D2->m02, Do_22b = D1->m21 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = D1->m20 * D2->m03, Do_23b = D1->m21 * D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * D2->m23, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double R_0a = D1->m00 * D2->m00, R_0b = D1->m01 * D2->m01, R_0c = R_0a + R_0b,
      R_0d = D1->m02 * D2->m02, R_0 = R_0c + R_0d;
  const double R_1a = D1->m00 * D2->m10, R_1b = D1->m01 * D2->m11, R_1c = R_1a + R_1b,
      R_1d = D1->m02 * D2->m12, R_1 = R_1c + R_1d;
  const double R_2a = D1->m00 * D2->m20, R_2b = D1->m01 * D2->m21, R_2c = R_2a + R_2b,
      R_2d = D1->m02 * D2->m22, R_2 = R_2c + R_2d;
  const double R_3a = D1->m10 * D2->m00, R_3b = D1->m11 * D2->m01, R_3c = R_3a + R_3b,
      R_3d = D1->m12 * D2->m02, R_3 = R_3c + R_3d;
  const double R_4a = D1->m10 * D2->m10, R_4b = D1->m11 * D2->m11, R_4c = R_4a + R_4b,
      R_4d = D1->m12 * D2->m12, R_4 = R_4c + R_4d;
  const double R_5a = D1->m10 * D2->m20, R_5b = D1->m11 * D2->m21, R_5c = R_5a + R_5b,
      R_5d = D1->m12 * D2->m22, R_5 = R_5c + R_5d;
  const double R_6a = D1->m20 * D2->m00, R_6b = D1->m21 * D2->m01, R_6c = R_6a + R_6b,
      R_6d = D1->m22 * D2->m02, R_6 = R_6c + R_6d;
  const double R_7a = D1->m20 * D2->m10, R_7b = D1->m21 * D2->m11, R_7c = R_7a + R_7b,
      R_7d = D1->m22 * D2->m12, R_7 = R_7c + R_7d;
  const double R_8a = D1->m20 * D2->m20, R_8b = D1->m21 * D2->m21, R_8c = R_8a + R_8b,
      R_8d = D1->m22 * D2->m22, R_8 = R_8c + R_8d;
  const double Do_03a = D2->m03 * R_0, Do_03b = D2->m13 * R_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D2->m23 * R_2, Do_03e = Do_03c + Do_03d, Do_03 = D1->m03 - Do_03e;
  const double Do_13a = D2->m03 * R_3, Do_13b = D2->m13 * R_4, Do_13c = Do_13a + Do_13b,
      Do_13d = D2->m23 * R_5, Do_13e = Do_13c + Do_13d, Do_13 = D1->m13 - Do_13e;
  const double Do_23a = D2->m03 * R_6, Do_23b = D2->m13 * R_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D2->m23 * R_8, Do_23e = Do_23c + Do_23d, Do_23 = D1->m23 - Do_23e;
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m10 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m20 * D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m10 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m20 * D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m10 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m20 * D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = D1->m00 * p_0, Do_03b = D1->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_10a = D1->m01 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m21 * D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D1->m01 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m21 * D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D1->m01 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m21 * D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = D1->m01 * p_0, Do_13b = D1->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_20a = D1->m02 * D2->m00, Do_20b = D1->m12 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D1->m02 * D2->m01, Do_21b = D1->m12 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D1->m02 * D2->m02, Do_22b = D1->m12 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = D1->m02 * p_0, Do_23b = D1->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * p_2, Do_23 = Do_23c + Do_23d;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D->m00 * R->m01, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D->m00 * R->m02, Do_02b = D->m01 * R->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D->m10 * R->m01, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D->m10 * R->m02, Do_12b = D->m11 * R->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D->m20 * R->m01, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D->m20 * R->m02, Do_22b = D->m21 * R->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m01, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m02, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D->m00 * R->m10, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m12, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D->m00 * R->m20, Do_02b = D->m01 * R->m21, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m01, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m02, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D->m10 * R->m10, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m12, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D->m10 * R->m20, Do_12b = D->m11 * R->m21, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m01, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m02, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D->m20 * R->m10, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m12, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D->m20 * R->m20, Do_22b = D->m21 * R->m21, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D->m03;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D->m13;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = D->m03 - Do_03e;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = D->m13 - Do_13e;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = D->m23 - Do_23e;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = D->m00 * p_0, Do_03b = D->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_13a = D->m01 * p_0, Do_13b = D->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_23a = D->m02 * p_0, Do_23b = D->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * p_2, Do_23 = Do_23c + Do_23d;
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
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtx(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m00 * k;
  const double vo_1 = R->m10 * k;
  const double vo_2 = R->m20 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a + Ro_01b;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m01 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a + Ro_11b;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m11 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a + Ro_21b;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m21 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a + Do_01b;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m01 * dc[0], Do_02 = Do_02a - Do_02b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a + Do_11b;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m11 * dc[0], Do_12 = Do_12a - Do_12b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a + Do_21b;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m21 * dc[0], Do_22 = Do_22a - Do_22b;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m10 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m20 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m10 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m20 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const double Ro_02a = R->m01 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const double Ro_12a = R->m11 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const double Ro_22a = R->m21 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a - Do_01b;
  const double Do_02a = D->m01 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a - Do_11b;
  const double Do_12a = D->m11 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a - Do_21b;
  const double Do_22a = D->m21 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m10 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m20 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvty(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m01 * k;
  const double vo_1 = R->m11 * k;
  const double vo_2 = R->m21 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const double Ro_02a = R->m00 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const double Ro_12a = R->m10 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const double Ro_22a = R->m20 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a - Do_00b;
  const double Do_02a = D->m00 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a - Do_10b;
  const double Do_12a = D->m10 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a - Do_20b;
  const double Do_22a = D->m20 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m11 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m21 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m01 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m11 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m21 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m00 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m10 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m20 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a + Do_00b;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m00 * dc[0], Do_02 = Do_02a - Do_02b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a + Do_10b;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m10 * dc[0], Do_12 = Do_12a - Do_12b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a + Do_20b;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m20 * dc[0], Do_22 = Do_22a - Do_22b;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m11 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m21 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtz(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m02 * k;
  const double vo_1 = R->m12 * k;
  const double vo_2 = R->m22 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m00 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m10 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m20 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a + Do_00b;
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m00 * dc[0], Do_01 = Do_01a - Do_01b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a + Do_10b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m10 * dc[0], Do_11 = Do_11a - Do_11b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a + Do_20b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m20 * dc[0], Do_21 = Do_21a - Do_21b;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m12 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m22 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m02 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m12 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m22 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const double Ro_01a = R->m00 * dc[0], Ro_01b = R->m01 * dc[1], Ro_01 = Ro_01a + Ro_01b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const double Ro_11a = R->m10 * dc[0], Ro_11b = R->m11 * dc[1], Ro_11 = Ro_11a + Ro_11b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const double Ro_21a = R->m20 * dc[0], Ro_21b = R->m21 * dc[1], Ro_21 = Ro_21a + Ro_21b;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a - Do_00b;
  const double Do_01a = D->m00 * dc[0], Do_01b = D->m01 * dc[1], Do_01 = Do_01a + Do_01b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a - Do_10b;
  const double Do_11a = D->m10 * dc[0], Do_11b = D->m11 * dc[1], Do_11 = Do_11a + Do_11b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a - Do_20b;
  const double Do_21a = D->m20 * dc[0], Do_21b = D->m21 * dc[1], Do_21 = Do_21a + Do_21b;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m12 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m22 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0 = vo_0c + vo_0d;
  const float vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1 = vo_1c + vo_1d;
  const float vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0 = vo_0c + vo_0d;
  const float vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1 = vo_1c + vo_1d;
  const float vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = D->m00 * v->x, vo_0b = D->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const float vo_1a = D->m10 * v->x, vo_1b = D->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const float vo_2a = D->m20 * v->x, vo_2b = D->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = D->m00 * p_0, vo_0b = D->m10 * p_1, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m20 * p_2, vo_0 = vo_0c + vo_0d;
  const float vo_1a = D->m01 * p_0, vo_1b = D->m11 * p_1, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m21 * p_2, vo_1 = vo_1c + vo_1d;
  const float vo_2a = D->m02 * p_0, vo_2b = D->m12 * p_1, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * p_2, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m01 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m10 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m10 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m20 * R2->m01, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m20 * R2->m02, Ro_22b = R1->m21 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinvf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m02, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m10, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m12, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m20, Ro_02b = R1->m01 * R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m02, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m10 * R2->m10, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m12, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m10 * R2->m20, Ro_12b = R1->m11 * R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m02, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m20 * R2->m10, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m12, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m20 * R2->m20, Ro_22b = R1->m21 * R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m10 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m20 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m10 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m20 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m10 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m20 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m01 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m21 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m01 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m21 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m01 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m21 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m02 * R2->m00, Ro_20b = R1->m12 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m02 * R2->m01, Ro_21b = R1->m12 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m02 * R2->m02, Ro_22b = R1->m12 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float Do_00a = D1->m00 * D2->m00, Do_00b = D1->m01 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m02 * D2->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D1->m00 * D2->m01, Do_01b = D1->m01 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m02 * D2->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D1->m00 * D2->m02, Do_02b = D1->m01 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * D2->m22, Do_02 = Do_02c + Do_02d;
  const float Do_03a = D1->m00 * D2->m03, Do_03b = D1->m01 * D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * D2->m23, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const float Do_10a = D1->m10 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m12 * D2->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D1->m10 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m12 * D2->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D1->m10 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * D2->m22, Do_12 = Do_12c + Do_12d;
  const float Do_13a = D1->m10 * D2->m03, Do_13b = D1->m11 * D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * D2->m23, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const float Do_20a = D1->m20 * D2->m00, Do_20b = D1->m21 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D1->m20 * D2->m01, Do_21b = D1->m21 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D1->m20 * D2->m02, Do_22b = D1->m21 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const float Do_23a = D1->m20 * D2->m03, Do_23b = D1->m21 * D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * D2->m23, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinvf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float R_0a = D1->m00 * D2->m00, R_0b = D1->m01 * D2->m01, R_0c = R_0a + R_0b,
      R_0d = D1->m02 * D2->m02, R_0 = R_0c + R_0d;
  const float R_1a = D1->m00 * D2->m10, R_1b = D1->m01 * D2->m11, R_1c = R_1a + R_1b,
      R_1d = D1->m02 * D2->m12, R_1 = R_1c + R_1d;
  const float R_2a = D1->m00 * D2->m20, R_2b = D1->m01 * D2->m21, R_2c = R_2a + R_2b,
      R_2d = D1->m02 * D2->m22, R_2 = R_2c + R_2d;
  const float R_3a = D1->m10 * D2->m00, R_3b = D1->m11 * D2->m01, R_3c = R_3a + R_3b,
      R_3d = D1->m12 * D2->m02, R_3 = R_3c + R_3d;
  const float R_4a = D1->m10 * D2->m10, R_4b = D1->m11 * D2->m11, R_4c = R_4a + R_4b,
      R_4d = D1->m12 * D2->m12, R_4 = R_4c + R_4d;
  const float R_5a = D1->m10 * D2->m20, R_5b = D1->m11 * D2->m21, R_5c = R_5a + R_5b,
      R_5d = D1->m12 * D2->m22, R_5 = R_5c + R_5d;
  const float R_6a = D1->m20 * D2->m00, R_6b = D1->m21 * D2->m01, R_6c = R_6a + R_6b,
      R_6d = D1->m22 * D2->m02, R_6 = R_6c + R_6d;
  const float R_7a = D1->m20 * D2->m10, R_7b = D1->m21 * D2->m11, R_7c = R_7a + R_7b,
      R_7d = D1->m22 * D2->m12, R_7 = R_7c + R_7d;
  const float R_8a = D1->m20 * D2->m20, R_8b = D1->m21 * D2->m21, R_8c = R_8a + R_8b,
      R_8d = D1->m22 * D2->m22, R_8 = R_8c + R_8d;
  const float Do_03a = D2->m03 * R_0, Do_03b = D2->m13 * R_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D2->m23 * R_2, Do_03e = Do_03c + Do_03d, Do_03 = D1->m03 - Do_03e;
  const float Do_13a = D2->m03 * R_3, Do_13b = D2->m13 * R_4, Do_13c = Do_13a + Do_13b,
      Do_13d = D2->m23 * R_5, Do_13e = Do_13c + Do_13d, Do_13 = D1->m13 - Do_13e;
  const float Do_23a = D2->m03 * R_6, Do_23b = D2->m13 * R_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D2->m23 * R_8, Do_23e = Do_23c + Do_23d, Do_23 = D1->m23 - Do_23e;
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = D1->m00 * D2->m00, Do_00b = D1->m10 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m20 * D2->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D1->m00 * D2->m01, Do_01b = D1->m10 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m20 * D2->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D1->m00 * D2->m02, Do_02b = D1->m10 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m20 * D2->m22, Do_02 = Do_02c + Do_02d;
  const float Do_03a = D1->m00 * p_0, Do_03b = D1->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const float Do_10a = D1->m01 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m21 * D2->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D1->m01 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m21 * D2->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D1->m01 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m21 * D2->m22, Do_12 = Do_12c + Do_12d;
  const float Do_13a = D1->m01 * p_0, Do_13b = D1->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const float Do_20a = D1->m02 * D2->m00, Do_20b = D1->m12 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D1->m02 * D2->m01, Do_21b = D1->m12 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D1->m02 * D2->m02, Do_22b = D1->m12 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const float Do_23a = D1->m02 * p_0, Do_23b = D1->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * p_2, Do_23 = Do_23c + Do_23d;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R, ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D->m00 * R->m01, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D->m00 * R->m02, Do_02b = D->m01 * R->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const float Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D->m10 * R->m01, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D->m10 * R->m02, Do_12b = D->m11 * R->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const float Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D->m20 * R->m01, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D->m20 * R->m02, Do_22b = D->m21 * R->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m01, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m02, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D->m00 * R->m10, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m12, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D->m00 * R->m20, Do_02b = D->m01 * R->m21, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const float Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m01, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m02, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D->m10 * R->m10, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m12, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D->m10 * R->m20, Do_12b = D->m11 * R->m21, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const float Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m01, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m02, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D->m20 * R->m10, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m12, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D->m20 * R->m20, Do_22b = D->m21 * R->m21, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D->m03;
  const float Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D->m13;
  const float Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = D->m03 - Do_03e;
  const float Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = D->m13 - Do_13e;
  const float Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = D->m23 - Do_23e;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = D->m00 * p_0, Do_03b = D->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const float Do_13a = D->m01 * p_0, Do_13b = D->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const float Do_23a = D->m02 * p_0, Do_23b = D->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * p_2, Do_23 = Do_23c + Do_23d;
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
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m00 * k;
  const float vo_1 = R->m10 * k;
  const float vo_2 = R->m20 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a + Ro_01b;
  const float Ro_02a = R->m02 * dc[1], Ro_02b = R->m01 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a + Ro_11b;
  const float Ro_12a = R->m12 * dc[1], Ro_12b = R->m11 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a + Ro_21b;
  const float Ro_22a = R->m22 * dc[1], Ro_22b = R->m21 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a + Do_01b;
  const float Do_02a = D->m02 * dc[1], Do_02b = D->m01 * dc[0], Do_02 = Do_02a - Do_02b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a + Do_11b;
  const float Do_12a = D->m12 * dc[1], Do_12b = D->m11 * dc[0], Do_12 = Do_12a - Do_12b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a + Do_21b;
  const float Do_22a = D->m22 * dc[1], Do_22b = D->m21 * dc[0], Do_22 = Do_22a - Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m10 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m20 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m10 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m20 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const float Ro_02a = R->m01 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const float Ro_12a = R->m11 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const float Ro_22a = R->m21 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a - Do_01b;
  const float Do_02a = D->m01 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a - Do_11b;
  const float Do_12a = D->m11 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a - Do_21b;
  const float Do_22a = D->m21 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m10 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m20 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m01 * k;
  const float vo_1 = R->m11 * k;
  const float vo_2 = R->m21 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const float Ro_02a = R->m00 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const float Ro_12a = R->m10 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const float Ro_22a = R->m20 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a - Do_00b;
  const float Do_02a = D->m00 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a - Do_10b;
  const float Do_12a = D->m10 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a - Do_20b;
  const float Do_22a = D->m20 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m01 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m11 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m21 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m01 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m11 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m21 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const float Ro_02a = R->m02 * dc[1], Ro_02b = R->m00 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const float Ro_12a = R->m12 * dc[1], Ro_12b = R->m10 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const float Ro_22a = R->m22 * dc[1], Ro_22b = R->m20 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a + Do_00b;
  const float Do_02a = D->m02 * dc[1], Do_02b = D->m00 * dc[0], Do_02 = Do_02a - Do_02b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a + Do_10b;
  const float Do_12a = D->m12 * dc[1], Do_12b = D->m10 * dc[0], Do_12 = Do_12a - Do_12b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a + Do_20b;
  const float Do_22a = D->m22 * dc[1], Do_22b = D->m20 * dc[0], Do_22 = Do_22a - Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m01 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m11 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m21 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m02 * k;
  const float vo_1 = R->m12 * k;
  const float vo_2 = R->m22 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m00 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m10 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m20 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a + Do_00b;
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m00 * dc[0], Do_01 = Do_01a - Do_01b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a + Do_10b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m10 * dc[0], Do_11 = Do_11a - Do_11b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a + Do_20b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m20 * dc[0], Do_21 = Do_21a - Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m02 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m12 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m22 * k, Do_23 = Do_23a + D->m23;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m02 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m12 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m22 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const float Ro_01a = R->m00 * dc[0], Ro_01b = R->m01 * dc[1], Ro_01 = Ro_01a + Ro_01b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const float Ro_11a = R->m10 * dc[0], Ro_11b = R->m11 * dc[1], Ro_11 = Ro_11a + Ro_11b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const float Ro_21a = R->m20 * dc[0], Ro_21b = R->m21 * dc[1], Ro_21 = Ro_21a + Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a - Do_00b;
  const float Do_01a = D->m00 * dc[0], Do_01b = D->m01 * dc[1], Do_01 = Do_01a + Do_01b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a - Do_10b;
  const float Do_11a = D->m10 * dc[0], Do_11b = D->m11 * dc[1], Do_11 = Do_11a + Do_11b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a - Do_20b;
  const float Do_21a = D->m20 * dc[0], Do_21b = D->m21 * dc[1], Do_21 = Do_21a + Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m02 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m12 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m22 * k, Do_23 = D->m23 - Do_23a;
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
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

#endif

/* Sine and cosine of a joint angle. */
#ifndef KSL_TRIG_H
#define KSL_TRIG_H


/* dc = (sin θ, cos θ), θ in rad; accurate as the platform's sin and cos.
   theta: number; dc: (sin θ, cos θ).
   1 sin, 1 cos. */
static inline void ksl_dc(const double theta, double dc[2]) {
  const double dc_0 = sin(theta);
  const double dc_1 = cos(theta);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

/* dc = (sin θ, cos θ), θ in rad; accurate as the platform's sin and cos.
   theta: number; dc: (sin θ, cos θ).
   1 sin, 1 cos. */
static inline void ksl_dcf(const float theta, float dc[2]) {
  const float dc_0 = sinf(theta);
  const float dc_1 = cosf(theta);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

/* What KSL declares beside formulas. */


/* The angle in [0, 360) that is whole turns away; exactly, but for one rounding of
   negative ones. */
static inline double ksl_normalizeDegrees(double angle) {
  const double turn = 360.0, rest = fmod(angle, turn), above = rest + turn;
  const double zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

/* The angle in [0, 2 π) that is whole turns away; exactly, but for one rounding of
   negative ones. */
static inline double ksl_normalizeRadians(double angle) {
  const double turn = 6.283185307179586, rest = fmod(angle, turn), above = rest + turn;
  const double zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

/* The angle in [0, 360) that is whole turns away; exactly, but for one rounding of
   negative ones. */
static inline float ksl_normalizeDegreesf(float angle) {
  const float turn = 360.0f, rest = fmodf(angle, turn), above = rest + turn;
  const float zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

/* The angle in [0, 2 π) that is whole turns away; exactly, but for one rounding of
   negative ones. */
static inline float ksl_normalizeRadiansf(float angle) {
  const float turn = 6.2831855f, rest = fmodf(angle, turn), above = rest + turn;
  const float zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

#endif

/* Screws: twists, spatial velocities and accelerations, s = (v; ω). */
#ifndef KSL_SCREW_H
#define KSL_SCREW_H


/* The screw of these entries, in order. */
static inline ksl_screw_t ksl_screw(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_screw_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_copy(const ksl_screw_t *si, ksl_screw_t *so) {
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale(ksl_screw_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_inverted(const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = -si->m0;
  const double so_1 = -si->m1;
  const double so_2 = -si->m2;
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

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_invert(ksl_screw_t *self) {
  const double self_0_new = -self->m0;
  const double self_1_new = -self->m1;
  const double self_2_new = -self->m2;
  const double self_3_new = -self->m3;
  const double self_4_new = -self->m4;
  const double self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
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
static inline void ksl_xpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
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
static inline void ksl_nxpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
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
static inline void ksl_product_as(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = a * si->m0;
  const double so_1 = a * si->m1;
  const double so_2 = a * si->m2;
  const double so_3 = a * si->m3;
  const double so_4 = a * si->m4;
  const double so_5 = a * si->m5;
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
static inline void ksl_add_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
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
static inline void ksl_subtract_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
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

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline double ksl_screw_norm(const ksl_screw_t *si) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_screw_normalize(ksl_screw_t *self) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = self->m0 * up;
  const double enlarged_1 = self->m1 * up;
  const double enlarged_2 = self->m2 * up;
  const double enlarged_3 = self->m3 * up;
  const double enlarged_4 = self->m4 * up;
  const double enlarged_5 = self->m5 * up;
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
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_screw_normalized(const ksl_screw_t *si, ksl_screw_t *so) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = si->m0 * up;
  const double enlarged_1 = si->m1 * up;
  const double enlarged_2 = si->m2 * up;
  const double enlarged_3 = si->m3 * up;
  const double enlarged_4 = si->m4 * up;
  const double enlarged_5 = si->m5 * up;
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
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_screw_t *so) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screw_to_angular_first(const ksl_screw_t *si, double x[6]) {
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_angular_first(const double x[6], ksl_screw_t *so) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adts(const ksl_vec3_t *t, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0a = t->y * si->m5, so_0b = t->z * si->m4, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = t->z * si->m3, so_1b = t->x * si->m5, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = t->x * si->m4, so_2b = t->y * si->m3, so_2c = so_2a - so_2b,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvs(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
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
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinv(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
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
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrs(const ksl_mat3x3_t *R, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0 = so_0c + so_0d;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1 = so_1c + so_1d;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvs(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m10 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m20 * si->m2, so_0 = so_0c + so_0d;
  const double so_1a = R->m01 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m21 * si->m2, so_1 = so_1c + so_1d;
  const double so_2a = R->m02 * si->m0, so_2b = R->m12 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const double so_3a = R->m00 * si->m3, so_3b = R->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m20 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = R->m01 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m21 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = R->m02 * si->m3, so_5b = R->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinv(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2e = so_2c + so_2d, so_2 = -so_2e;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3e = so_3c + so_3d, so_3 = -so_3e;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4e = so_4c + so_4d, so_4 = -so_4e;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5e = so_5c + so_5d, so_5 = -so_5e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Ads(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5 = w_5c + w_5d;
  const double so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvs(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m23 * si->m4, w_0b = D->m13 * si->m5, w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const double w_1a = D->m03 * si->m5, w_1b = D->m23 * si->m3, w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const double w_2a = D->m13 * si->m3, w_2b = D->m03 * si->m4, w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const double so_0a = D->m00 * w_0, so_0b = D->m10 * w_1, so_0c = so_0a + so_0b,
      so_0d = D->m20 * w_2, so_0 = so_0c + so_0d;
  const double so_1a = D->m01 * w_0, so_1b = D->m11 * w_1, so_1c = so_1a + so_1b,
      so_1d = D->m21 * w_2, so_1 = so_1c + so_1d;
  const double so_2a = D->m02 * w_0, so_2b = D->m12 * w_1, so_2c = so_2a + so_2b,
      so_2d = D->m22 * w_2, so_2 = so_2c + so_2d;
  const double so_3a = D->m00 * si->m3, so_3b = D->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = D->m20 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = D->m01 * si->m3, so_4b = D->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = D->m21 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = D->m02 * si->m3, so_5b = D->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = D->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinv(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hsty(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m20 * D->m13, so_0b = D->m10 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m00 * D->m23, so_1b = D->m20 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m10 * D->m03, so_2b = D->m00 * D->m13, so_2 = so_2a - so_2b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsry(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m21 * D->m13, so_0b = D->m11 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m01 * D->m23, so_1b = D->m21 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m11 * D->m03, so_2b = D->m01 * D->m13, so_2 = so_2a - so_2b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m22 * D->m13, so_0b = D->m12 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m02 * D->m23, so_1b = D->m22 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m12 * D->m03, so_2b = D->m02 * D->m13, so_2 = so_2a - so_2b;
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

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m00;
  const double so_1 = -D->m10;
  const double so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m01;
  const double so_1 = -D->m11;
  const double so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m02;
  const double so_1 = -D->m12;
  const double so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m10 * D->m23, so_0b = D->m20 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m20 * D->m03, so_1b = D->m00 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m00 * D->m13, so_2b = D->m10 * D->m03, so_2 = so_2a - so_2b;
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
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m11 * D->m23, so_0b = D->m21 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m21 * D->m03, so_1b = D->m01 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m01 * D->m13, so_2b = D->m11 * D->m03, so_2 = so_2a - so_2b;
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
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m12 * D->m23, so_0b = D->m22 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m22 * D->m03, so_1b = D->m02 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m02 * D->m13, so_2b = D->m12 * D->m03, so_2 = so_2a - so_2b;
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
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = D->m20 * D->m13, M_03b = D->m10 * D->m23, M_03 = M_03a - M_03b;
  const double M_04a = D->m21 * D->m13, M_04b = D->m11 * D->m23, M_04 = M_04a - M_04b;
  const double M_05a = D->m22 * D->m13, M_05b = D->m12 * D->m23, M_05 = M_05a - M_05b;
  const double M_13a = D->m00 * D->m23, M_13b = D->m20 * D->m03, M_13 = M_13a - M_13b;
  const double M_14a = D->m01 * D->m23, M_14b = D->m21 * D->m03, M_14 = M_14a - M_14b;
  const double M_15a = D->m02 * D->m23, M_15b = D->m22 * D->m03, M_15 = M_15a - M_15b;
  const double M_23a = D->m10 * D->m03, M_23b = D->m00 * D->m13, M_23 = M_23a - M_23b;
  const double M_24a = D->m11 * D->m03, M_24b = D->m01 * D->m13, M_24 = M_24a - M_24b;
  const double M_25a = D->m12 * D->m03, M_25b = D->m02 * D->m13, M_25 = M_25a - M_25b;
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
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_cs(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = c->m0 * s->m0, power_b = c->m1 * s->m1, power_c = power_a + power_b,
      power_d = c->m2 * s->m2, power_e = power_c + power_d, power_f = c->m3 * s->m3,
      power_g = c->m4 * s->m4, power_h = power_f + power_g, power_i = c->m5 * s->m5,
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0a = s1->m1 * s2->m5, so_0b = s1->m5 * s2->m1, so_0c = so_0a - so_0b,
      so_0d = s1->m4 * s2->m2, so_0e = s1->m2 * s2->m4, so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m0 * s2->m5, so_1c = so_1a - so_1b,
      so_1d = s1->m2 * s2->m3, so_1e = s1->m3 * s2->m2, so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const double so_2a = s1->m0 * s2->m4, so_2b = s1->m4 * s2->m0, so_2c = so_2a - so_2b,
      so_2d = s1->m3 * s2->m1, so_2e = s1->m1 * s2->m3, so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const double so_3a = s1->m4 * s2->m5, so_3b = s1->m5 * s2->m4, so_3 = so_3a - so_3b;
  const double so_4a = s1->m5 * s2->m3, so_4b = s1->m3 * s2->m5, so_4 = so_4a - so_4b;
  const double so_5a = s1->m3 * s2->m4, so_5b = s1->m4 * s2->m3, so_5 = so_5a - so_5b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0a = s1->m4 * s2->m2, so_0b = s1->m5 * s2->m1, so_0 = so_0a - so_0b;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m3 * s2->m2, so_1 = so_1a - so_1b;
  const double so_2a = s1->m3 * s2->m1, so_2b = s1->m4 * s2->m0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsra(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const double a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const double a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const double so_0a = D->m13 * a_2, so_0b = D->m23 * a_1, so_0 = so_0a - so_0b;
  const double so_1a = D->m23 * a_0, so_1b = D->m03 * a_2, so_1 = so_1a - so_1b;
  const double so_2a = D->m03 * a_1, so_2b = D->m13 * a_0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsta(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0 = so_0c + so_0d;
  const double so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1 = so_1c + so_1d;
  const double so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2 = so_2c + so_2d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainv(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const double a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const double a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const double so_0a = D->m23 * a_1, so_0b = D->m13 * a_2, so_0 = so_0a - so_0b;
  const double so_1a = D->m03 * a_2, so_1b = D->m23 * a_0, so_1 = so_1a - so_1b;
  const double so_2a = D->m13 * a_0, so_2b = D->m03 * a_1, so_2 = so_2a - so_2b;
  const double so_3 = -a_0;
  const double so_4 = -a_1;
  const double so_5 = -a_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainv(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const double so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const double so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2e = so_2c + so_2d, so_2 = -so_2e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_ad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5;
  const double M_04 = -s->m2;
  const double M_12 = -s->m3;
  const double M_15 = -s->m0;
  const double M_20 = -s->m4;
  const double M_23 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m1 = s->m1;
  const double s_m5 = s->m5;
  const double s_m2 = s->m2;
  const double s_m3 = s->m3;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The screw of these entries, in order. */
static inline ksl_screwf_t ksl_screwf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_screwf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_copy(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screwf_scale(ksl_screwf_t *self, const float a) {
  const float self_0_new = self->m0 * a;
  const float self_1_new = self->m1 * a;
  const float self_2_new = self->m2 * a;
  const float self_3_new = self->m3 * a;
  const float self_4_new = self->m4 * a;
  const float self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_inverted(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = -si->m0;
  const float so_1 = -si->m1;
  const float so_2 = -si->m2;
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

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_invert(ksl_screwf_t *self) {
  const float self_0_new = -self->m0;
  const float self_1_new = -self->m1;
  const float self_2_new = -self->m2;
  const float self_3_new = -self->m3;
  const float self_4_new = -self->m4;
  const float self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ssf(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
  const float y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
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
static inline void ksl_xpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
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
static inline void ksl_nxpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
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
static inline void ksl_product_asf(const float a, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = a * si->m0;
  const float so_1 = a * si->m1;
  const float so_2 = a * si->m2;
  const float so_3 = a * si->m3;
  const float so_4 = a * si->m4;
  const float so_5 = a * si->m5;
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
static inline void ksl_add_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
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
static inline void ksl_subtract_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
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

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_screwf_norm(const ksl_screwf_t *si) {
  const float small_a = fabsf(si->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(si->m4), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(si->m3),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3;
  const float p_1 = small == 1.0f ? si->m1 : si->m4;
  const float p_2 = small == 1.0f ? si->m2 : si->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_screwf_normalize(ksl_screwf_t *self) {
  const float small_a = fabsf(self->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m4), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m3), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m0 : self->m3;
  const float p_1 = small == 1.0f ? self->m1 : self->m4;
  const float p_2 = small == 1.0f ? self->m2 : self->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = self->m0 * up;
  const float enlarged_1 = self->m1 * up;
  const float enlarged_2 = self->m2 * up;
  const float enlarged_3 = self->m3 * up;
  const float enlarged_4 = self->m4 * up;
  const float enlarged_5 = self->m5 * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float quotient_4 = enlarged_4 / divisor;
  const float quotient_5 = enlarged_5 / divisor;
  const float self_0_new = quotient_0 * down;
  const float self_1_new = quotient_1 * down;
  const float self_2_new = quotient_2 * down;
  const float self_3_new = quotient_3 * down;
  const float self_4_new = quotient_4 * down;
  const float self_5_new = quotient_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_screwf_normalized(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float small_a = fabsf(si->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(si->m4), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(si->m3),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3;
  const float p_1 = small == 1.0f ? si->m1 : si->m4;
  const float p_2 = small == 1.0f ? si->m2 : si->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = si->m0 * up;
  const float enlarged_1 = si->m1 * up;
  const float enlarged_2 = si->m2 * up;
  const float enlarged_3 = si->m3 * up;
  const float enlarged_4 = si->m4 * up;
  const float enlarged_5 = si->m5 * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float quotient_4 = enlarged_4 / divisor;
  const float quotient_5 = enlarged_5 / divisor;
  const float so_0 = quotient_0 * down;
  const float so_1 = quotient_1 * down;
  const float so_2 = quotient_2 * down;
  const float so_3 = quotient_3 * down;
  const float so_4 = quotient_4 * down;
  const float so_5 = quotient_5 * down;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_screwf_t *so) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screwf_to_angular_first(const ksl_screwf_t *si, float x[6]) {
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_angular_first(const float x[6], ksl_screwf_t *so) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->y * si->m5, so_0b = t->z * si->m4, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = t->z * si->m3, so_1b = t->x * si->m5, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = t->x * si->m4, so_2b = t->y * si->m3, so_2c = so_2a - so_2b,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
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
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinvf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const float so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const float so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
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
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0 = so_0c + so_0d;
  const float so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1 = so_1c + so_1d;
  const float so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const float so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m10 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m20 * si->m2, so_0 = so_0c + so_0d;
  const float so_1a = R->m01 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m21 * si->m2, so_1 = so_1c + so_1d;
  const float so_2a = R->m02 * si->m0, so_2b = R->m12 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const float so_3a = R->m00 * si->m3, so_3b = R->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m20 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = R->m01 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m21 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = R->m02 * si->m3, so_5b = R->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinvf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const float so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const float so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2e = so_2c + so_2d, so_2 = -so_2e;
  const float so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3e = so_3c + so_3d, so_3 = -so_3e;
  const float so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4e = so_4c + so_4d, so_4 = -so_4e;
  const float so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5e = so_5c + so_5d, so_5 = -so_5e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsf(const ksl_SE3f_t *D, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5 = w_5c + w_5d;
  const float so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b, so_0 = so_0c + w_0;
  const float so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b, so_1 = so_1c + w_1;
  const float so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b, so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvsf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = D->m23 * si->m4, w_0b = D->m13 * si->m5, w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const float w_1a = D->m03 * si->m5, w_1b = D->m23 * si->m3, w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const float w_2a = D->m13 * si->m3, w_2b = D->m03 * si->m4, w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const float so_0a = D->m00 * w_0, so_0b = D->m10 * w_1, so_0c = so_0a + so_0b,
      so_0d = D->m20 * w_2, so_0 = so_0c + so_0d;
  const float so_1a = D->m01 * w_0, so_1b = D->m11 * w_1, so_1c = so_1a + so_1b,
      so_1d = D->m21 * w_2, so_1 = so_1c + so_1d;
  const float so_2a = D->m02 * w_0, so_2b = D->m12 * w_1, so_2c = so_2a + so_2b,
      so_2d = D->m22 * w_2, so_2 = so_2c + so_2d;
  const float so_3a = D->m00 * si->m3, so_3b = D->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = D->m20 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = D->m01 * si->m3, so_4b = D->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = D->m21 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = D->m02 * si->m3, so_5b = D->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = D->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinvf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b, so_0 = so_0c + w_0;
  const float so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b, so_1 = so_1c + w_1;
  const float so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b, so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstyf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m20 * D->m13, so_0b = D->m10 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m00 * D->m23, so_1b = D->m20 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m10 * D->m03, so_2b = D->m00 * D->m13, so_2 = so_2a - so_2b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m21 * D->m13, so_0b = D->m11 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m01 * D->m23, so_1b = D->m21 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m11 * D->m03, so_2b = D->m01 * D->m13, so_2 = so_2a - so_2b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m22 * D->m13, so_0b = D->m12 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m02 * D->m23, so_1b = D->m22 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m12 * D->m03, so_2b = D->m02 * D->m13, so_2 = so_2a - so_2b;
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

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m00;
  const float so_1 = -D->m10;
  const float so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m01;
  const float so_1 = -D->m11;
  const float so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m02;
  const float so_1 = -D->m12;
  const float so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m10 * D->m23, so_0b = D->m20 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m20 * D->m03, so_1b = D->m00 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m00 * D->m13, so_2b = D->m10 * D->m03, so_2 = so_2a - so_2b;
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
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m11 * D->m23, so_0b = D->m21 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m21 * D->m03, so_1b = D->m01 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m01 * D->m13, so_2b = D->m11 * D->m03, so_2 = so_2a - so_2b;
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
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m12 * D->m23, so_0b = D->m22 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m22 * D->m03, so_1b = D->m02 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m02 * D->m13, so_2b = D->m12 * D->m03, so_2 = so_2a - so_2b;
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
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Adf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_03a = D->m20 * D->m13, M_03b = D->m10 * D->m23, M_03 = M_03a - M_03b;
  const float M_04a = D->m21 * D->m13, M_04b = D->m11 * D->m23, M_04 = M_04a - M_04b;
  const float M_05a = D->m22 * D->m13, M_05b = D->m12 * D->m23, M_05 = M_05a - M_05b;
  const float M_13a = D->m00 * D->m23, M_13b = D->m20 * D->m03, M_13 = M_13a - M_13b;
  const float M_14a = D->m01 * D->m23, M_14b = D->m21 * D->m03, M_14 = M_14a - M_14b;
  const float M_15a = D->m02 * D->m23, M_15b = D->m22 * D->m03, M_15 = M_15a - M_15b;
  const float M_23a = D->m10 * D->m03, M_23b = D->m00 * D->m13, M_23 = M_23a - M_23b;
  const float M_24a = D->m11 * D->m03, M_24b = D->m01 * D->m13, M_24 = M_24a - M_24b;
  const float M_25a = D->m12 * D->m03, M_25b = D->m02 * D->m13, M_25 = M_25a - M_25b;
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
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_csf(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const float power_a = c->m0 * s->m0, power_b = c->m1 * s->m1, power_c = power_a + power_b,
      power_d = c->m2 * s->m2, power_e = power_c + power_d, power_f = c->m3 * s->m3,
      power_g = c->m4 * s->m4, power_h = power_f + power_g, power_i = c->m5 * s->m5,
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0a = s1->m1 * s2->m5, so_0b = s1->m5 * s2->m1, so_0c = so_0a - so_0b,
      so_0d = s1->m4 * s2->m2, so_0e = s1->m2 * s2->m4, so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const float so_1a = s1->m5 * s2->m0, so_1b = s1->m0 * s2->m5, so_1c = so_1a - so_1b,
      so_1d = s1->m2 * s2->m3, so_1e = s1->m3 * s2->m2, so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const float so_2a = s1->m0 * s2->m4, so_2b = s1->m4 * s2->m0, so_2c = so_2a - so_2b,
      so_2d = s1->m3 * s2->m1, so_2e = s1->m1 * s2->m3, so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const float so_3a = s1->m4 * s2->m5, so_3b = s1->m5 * s2->m4, so_3 = so_3a - so_3b;
  const float so_4a = s1->m5 * s2->m3, so_4b = s1->m3 * s2->m5, so_4 = so_4a - so_4b;
  const float so_5a = s1->m3 * s2->m4, so_5b = s1->m4 * s2->m3, so_5 = so_5a - so_5b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0a = s1->m4 * s2->m2, so_0b = s1->m5 * s2->m1, so_0 = so_0a - so_0b;
  const float so_1a = s1->m5 * s2->m0, so_1b = s1->m3 * s2->m2, so_1 = so_1a - so_1b;
  const float so_2a = s1->m3 * s2->m1, so_2b = s1->m4 * s2->m0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsraf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const float a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const float a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const float so_0a = D->m13 * a_2, so_0b = D->m23 * a_1, so_0 = so_0a - so_0b;
  const float so_1a = D->m23 * a_0, so_1b = D->m03 * a_2, so_1 = so_1a - so_1b;
  const float so_2a = D->m03 * a_1, so_2b = D->m13 * a_0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstaf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0 = so_0c + so_0d;
  const float so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1 = so_1c + so_1d;
  const float so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2 = so_2c + so_2d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainvf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const float a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const float a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const float so_0a = D->m23 * a_1, so_0b = D->m13 * a_2, so_0 = so_0a - so_0b;
  const float so_1a = D->m03 * a_2, so_1b = D->m23 * a_0, so_1 = so_1a - so_1b;
  const float so_2a = D->m13 * a_0, so_2b = D->m03 * a_1, so_2 = so_2a - so_2b;
  const float so_3 = -a_0;
  const float so_4 = -a_1;
  const float so_5 = -a_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainvf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const float so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const float so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2e = so_2c + so_2d, so_2 = -so_2e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_adf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5;
  const float M_04 = -s->m2;
  const float M_12 = -s->m3;
  const float M_15 = -s->m0;
  const float M_20 = -s->m4;
  const float M_23 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m1 = s->m1;
  const float s_m5 = s->m5;
  const float s_m2 = s->m2;
  const float s_m3 = s->m3;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0f;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_screw_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screw_t *ksl_screw_alloc(int n) {
  return n > 0 ? (ksl_screw_t *)calloc((size_t)n, sizeof(ksl_screw_t)) : NULL;
}

/* n ksl_screwf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screwf_t *ksl_screwf_alloc(int n) {
  return n > 0 ? (ksl_screwf_t *)calloc((size_t)n, sizeof(ksl_screwf_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies row by row, stride
   apart. */
static inline void ksl_screw_copy_rmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies row by row, stride
   apart. */
static inline void ksl_screw_ncopy_rmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies column by column, stride
   apart. */
static inline void ksl_screw_copy_cmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies column by column, stride
   apart. */
static inline void ksl_screw_ncopy_cmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies row by row, stride
   apart. */
static inline void ksl_screwf_copy_rmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies row by row, stride
   apart. */
static inline void ksl_screwf_ncopy_rmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies column by column, stride
   apart. */
static inline void ksl_screwf_copy_cmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies column by column, stride
   apart. */
static inline void ksl_screwf_ncopy_cmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = -si->at[i];
  }
}

/* ksl_hsrxinvf, as KSL spells it, too. */
static inline void ksl_hrxinvf(const ksl_SE3f_t *Di, ksl_screwf_t *ho) {
  ksl_hsrxinvf(Di, ho);
}

#endif

/* Coscrews: wrenches and momenta, c = (f; τ). */
#ifndef KSL_COSCREW_H
#define KSL_COSCREW_H


/* The coscrew of these entries, in order. */
static inline ksl_coscrew_t ksl_coscrew(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_coscrew_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_copy(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale(ksl_coscrew_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_inverted(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3 = -ci->m3;
  const double co_4 = -ci->m4;
  const double co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_invert(ksl_coscrew_t *self) {
  const double self_0_new = -self->m0;
  const double self_1_new = -self->m1;
  const double self_2_new = -self->m2;
  const double self_3_new = -self->m3;
  const double self_4_new = -self->m4;
  const double self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
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
static inline void ksl_xpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
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
static inline void ksl_nxpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
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
static inline void ksl_product_ac(const double a, const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = a * ci->m0;
  const double co_1 = a * ci->m1;
  const double co_2 = a * ci->m2;
  const double co_3 = a * ci->m3;
  const double co_4 = a * ci->m4;
  const double co_5 = a * ci->m5;
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
static inline void ksl_add_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2, ksl_coscrew_t *co) {
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
static inline void ksl_subtract_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
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

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline double ksl_coscrew_norm(const ksl_coscrew_t *ci) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_coscrew_normalize(ksl_coscrew_t *self) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = self->m0 * up;
  const double enlarged_1 = self->m1 * up;
  const double enlarged_2 = self->m2 * up;
  const double enlarged_3 = self->m3 * up;
  const double enlarged_4 = self->m4 * up;
  const double enlarged_5 = self->m5 * up;
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
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_coscrew_normalized(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
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
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double enlarged_0 = ci->m0 * up;
  const double enlarged_1 = ci->m1 * up;
  const double enlarged_2 = ci->m2 * up;
  const double enlarged_3 = ci->m3 * up;
  const double enlarged_4 = ci->m4 * up;
  const double enlarged_5 = ci->m5 * up;
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
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_coscrew_t *co) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_to_angular_first(const ksl_coscrew_t *ci, double x[6]) {
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_angular_first(const double x[6], ksl_coscrew_t *co) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->y * ci->m2, co_3b = t->z * ci->m1, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = t->z * ci->m0, co_4b = t->x * ci->m2, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = t->x * ci->m1, co_5b = t->y * ci->m0, co_5c = co_5a - co_5b,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
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
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinv(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
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
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m20 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = R->m01 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m21 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = R->m02 * ci->m0, co_2b = R->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m10 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m20 * ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = R->m01 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m21 * ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = R->m02 * ci->m3, co_5b = R->m12 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinv(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0e = co_0c + co_0d, co_0 = -co_0e;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1e = co_1c + co_1d, co_1 = -co_1e;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2e = co_2c + co_2d, co_2 = -co_2e;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3e = co_3c + co_3d, co_3 = -co_3e;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4e = co_4c + co_4d, co_4 = -co_4e;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5e = co_5c + co_5d, co_5 = -co_5e;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = D->m23 * ci->m1, w_3b = D->m13 * ci->m2, w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const double w_4a = D->m03 * ci->m2, w_4b = D->m23 * ci->m0, w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const double w_5a = D->m13 * ci->m0, w_5b = D->m03 * ci->m1, w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const double co_0a = D->m00 * ci->m0, co_0b = D->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = D->m20 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = D->m01 * ci->m0, co_1b = D->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = D->m21 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = D->m02 * ci->m0, co_2b = D->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = D->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = D->m00 * w_3, co_3b = D->m10 * w_4, co_3c = co_3a + co_3b,
      co_3d = D->m20 * w_5, co_3 = co_3c + co_3d;
  const double co_4a = D->m01 * w_3, co_4b = D->m11 * w_4, co_4c = co_4a + co_4b,
      co_4d = D->m21 * w_5, co_4 = co_4c + co_4d;
  const double co_5a = D->m02 * w_3, co_5b = D->m12 * w_4, co_5c = co_5a + co_5b,
      co_5d = D->m22 * w_5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinv(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m20 * D->m13, co_3b = D->m10 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m00 * D->m23, co_4b = D->m20 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m10 * D->m03, co_5b = D->m00 * D->m13, co_5 = co_5a - co_5b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hcty(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m21 * D->m13, co_3b = D->m11 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m01 * D->m23, co_4b = D->m21 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m11 * D->m03, co_5b = D->m01 * D->m13, co_5 = co_5a - co_5b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m22 * D->m13, co_3b = D->m12 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m02 * D->m23, co_4b = D->m22 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m12 * D->m03, co_5b = D->m02 * D->m13, co_5 = co_5a - co_5b;
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

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcry(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = D->m10 * D->m23, co_3b = D->m20 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m20 * D->m03, co_4b = D->m00 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m00 * D->m13, co_5b = D->m10 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = D->m11 * D->m23, co_3b = D->m21 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m21 * D->m03, co_4b = D->m01 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m01 * D->m13, co_5b = D->m11 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = D->m12 * D->m23, co_3b = D->m22 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m22 * D->m03, co_4b = D->m02 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m02 * D->m13, co_5b = D->m12 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m00;
  const double co_4 = -D->m10;
  const double co_5 = -D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m01;
  const double co_4 = -D->m11;
  const double co_5 = -D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m02;
  const double co_4 = -D->m12;
  const double co_5 = -D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = D->m20 * D->m13, M_30b = D->m10 * D->m23, M_30 = M_30a - M_30b;
  const double M_31a = D->m21 * D->m13, M_31b = D->m11 * D->m23, M_31 = M_31a - M_31b;
  const double M_32a = D->m22 * D->m13, M_32b = D->m12 * D->m23, M_32 = M_32a - M_32b;
  const double M_40a = D->m00 * D->m23, M_40b = D->m20 * D->m03, M_40 = M_40a - M_40b;
  const double M_41a = D->m01 * D->m23, M_41b = D->m21 * D->m03, M_41 = M_41a - M_41b;
  const double M_42a = D->m02 * D->m23, M_42b = D->m22 * D->m03, M_42 = M_42a - M_42b;
  const double M_50a = D->m10 * D->m03, M_50b = D->m00 * D->m13, M_50 = M_50a - M_50b;
  const double M_51a = D->m11 * D->m03, M_51b = D->m01 * D->m13, M_51 = M_51a - M_51b;
  const double M_52a = D->m12 * D->m03, M_52b = D->m02 * D->m13, M_52 = M_52a - M_52b;
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
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_reciprocal_product(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = c->m0 * x[3], power_b = c->m1 * x[4], power_c = power_a + power_b,
      power_d = c->m2 * x[5], power_e = power_c + power_d, power_f = c->m3 * x[0],
      power_g = c->m4 * x[1], power_h = power_f + power_g, power_i = c->m5 * x[2],
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sc(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_0a = s->m4 * c->m2, co_0b = s->m5 * c->m1, co_0 = co_0a - co_0b;
  const double co_1a = s->m5 * c->m0, co_1b = s->m3 * c->m2, co_1 = co_1a - co_1b;
  const double co_2a = s->m3 * c->m1, co_2b = s->m4 * c->m0, co_2 = co_2a - co_2b;
  const double co_3a = s->m1 * c->m2, co_3b = s->m2 * c->m1, co_3c = co_3a - co_3b,
      co_3d = s->m4 * c->m5, co_3e = s->m5 * c->m4, co_3f = co_3d - co_3e, co_3 = co_3c + co_3f;
  const double co_4a = s->m2 * c->m0, co_4b = s->m0 * c->m2, co_4c = co_4a - co_4b,
      co_4d = s->m5 * c->m3, co_4e = s->m3 * c->m5, co_4f = co_4d - co_4e, co_4 = co_4c + co_4f;
  const double co_5a = s->m0 * c->m1, co_5b = s->m1 * c->m0, co_5c = co_5a - co_5b,
      co_5d = s->m3 * c->m4, co_5e = s->m4 * c->m3, co_5f = co_5d - co_5e, co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sca(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_3a = s->m4 * c->m5, co_3b = s->m5 * c->m4, co_3 = co_3a - co_3b;
  const double co_4a = s->m5 * c->m3, co_4b = s->m3 * c->m5, co_4 = co_4a - co_4b;
  const double co_5a = s->m3 * c->m4, co_5b = s->m4 * c->m3, co_5 = co_5a - co_5b;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m01 * c->m1, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const double w_1a = D->m11 * c->m1, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const double w_2a = D->m21 * c->m1, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const double w_1a = D->m10 * c->m0, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const double w_2a = D->m20 * c->m0, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0 = w_0a + w_0b;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1 = w_1a + w_1b;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m01 * c->m4, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const double w_4a = D->m11 * c->m4, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const double w_5a = D->m21 * c->m4, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * c->m3, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const double w_4a = D->m10 * c->m3, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const double w_5a = D->m20 * c->m3, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3 = w_3a + w_3b;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4 = w_4a + w_4b;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m00 * c->m0;
  const double w_1 = D->m10 * c->m0;
  const double w_2 = D->m20 * c->m0;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m01 * c->m1;
  const double w_1 = D->m11 * c->m1;
  const double w_2 = D->m21 * c->m1;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m02 * c->m2;
  const double w_1 = D->m12 * c->m2;
  const double w_2 = D->m22 * c->m2;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
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
static inline void ksl_working_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m00 * c->m3;
  const double w_4 = D->m10 * c->m3;
  const double w_5 = D->m20 * c->m3;
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
static inline void ksl_working_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m01 * c->m4;
  const double w_4 = D->m11 * c->m4;
  const double w_5 = D->m21 * c->m4;
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
static inline void ksl_working_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m02 * c->m5;
  const double w_4 = D->m12 * c->m5;
  const double w_5 = D->m22 * c->m5;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5;
  const double M_12 = -s->m3;
  const double M_20 = -s->m4;
  const double M_31 = -s->m2;
  const double M_42 = -s->m0;
  const double M_50 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m5 = s->m5;
  const double s_m3 = s->m3;
  const double s_m1 = s->m1;
  const double s_m2 = s->m2;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The coscrew of these entries, in order. */
static inline ksl_coscrewf_t ksl_coscrewf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_coscrewf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_copy(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrewf_scale(ksl_coscrewf_t *self, const float a) {
  const float self_0_new = self->m0 * a;
  const float self_1_new = self->m1 * a;
  const float self_2_new = self->m2 * a;
  const float self_3_new = self->m3 * a;
  const float self_4_new = self->m4 * a;
  const float self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_inverted(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3 = -ci->m3;
  const float co_4 = -ci->m4;
  const float co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_invert(ksl_coscrewf_t *self) {
  const float self_0_new = -self->m0;
  const float self_1_new = -self->m1;
  const float self_2_new = -self->m2;
  const float self_3_new = -self->m3;
  const float self_4_new = -self->m4;
  const float self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ccf(const float a, const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
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
static inline void ksl_xpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
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
static inline void ksl_nxpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
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
static inline void ksl_product_acf(const float a, const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = a * ci->m0;
  const float co_1 = a * ci->m1;
  const float co_2 = a * ci->m2;
  const float co_3 = a * ci->m3;
  const float co_4 = a * ci->m4;
  const float co_5 = a * ci->m5;
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
static inline void ksl_add_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
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
static inline void ksl_subtract_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
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

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_coscrewf_norm(const ksl_coscrewf_t *ci) {
  const float small_a = fabsf(ci->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(ci->m1), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(ci->m0),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0;
  const float p_1 = small == 1.0f ? ci->m4 : ci->m1;
  const float p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_coscrewf_normalize(ksl_coscrewf_t *self) {
  const float small_a = fabsf(self->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m1), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m0), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m3 : self->m0;
  const float p_1 = small == 1.0f ? self->m4 : self->m1;
  const float p_2 = small == 1.0f ? self->m5 : self->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = self->m0 * up;
  const float enlarged_1 = self->m1 * up;
  const float enlarged_2 = self->m2 * up;
  const float enlarged_3 = self->m3 * up;
  const float enlarged_4 = self->m4 * up;
  const float enlarged_5 = self->m5 * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float quotient_4 = enlarged_4 / divisor;
  const float quotient_5 = enlarged_5 / divisor;
  const float self_0_new = quotient_0 * down;
  const float self_1_new = quotient_1 * down;
  const float self_2_new = quotient_2 * down;
  const float self_3_new = quotient_3 * down;
  const float self_4_new = quotient_4 * down;
  const float self_5_new = quotient_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 10 less, 2 equal, 14 select. */
static inline void ksl_coscrewf_normalized(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float small_a = fabsf(ci->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(ci->m1), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(ci->m0),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0;
  const float p_1 = small == 1.0f ? ci->m4 : ci->m1;
  const float p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float divisor = n == 0.0f ? up : n;
  const float enlarged_0 = ci->m0 * up;
  const float enlarged_1 = ci->m1 * up;
  const float enlarged_2 = ci->m2 * up;
  const float enlarged_3 = ci->m3 * up;
  const float enlarged_4 = ci->m4 * up;
  const float enlarged_5 = ci->m5 * up;
  const float quotient_0 = enlarged_0 / divisor;
  const float quotient_1 = enlarged_1 / divisor;
  const float quotient_2 = enlarged_2 / divisor;
  const float quotient_3 = enlarged_3 / divisor;
  const float quotient_4 = enlarged_4 / divisor;
  const float quotient_5 = enlarged_5 / divisor;
  const float co_0 = quotient_0 * down;
  const float co_1 = quotient_1 * down;
  const float co_2 = quotient_2 * down;
  const float co_3 = quotient_3 * down;
  const float co_4 = quotient_4 * down;
  const float co_5 = quotient_5 * down;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_coscrewf_t *co) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_to_angular_first(const ksl_coscrewf_t *ci, float x[6]) {
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_angular_first(const float x[6], ksl_coscrewf_t *co) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cctf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = t->y * ci->m2, co_3b = t->z * ci->m1, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = t->z * ci->m0, co_4b = t->x * ci->m2, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = t->x * ci->m1, co_5b = t->y * ci->m0, co_5c = co_5a - co_5b,
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
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
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
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const float co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const float co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
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
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3 = co_3c + co_3d;
  const float co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4 = co_4c + co_4d;
  const float co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m20 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = R->m01 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m21 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = R->m02 * ci->m0, co_2b = R->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m10 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m20 * ci->m5, co_3 = co_3c + co_3d;
  const float co_4a = R->m01 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m21 * ci->m5, co_4 = co_4c + co_4d;
  const float co_5a = R->m02 * ci->m3, co_5b = R->m12 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinvf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0e = co_0c + co_0d, co_0 = -co_0e;
  const float co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1e = co_1c + co_1d, co_1 = -co_1e;
  const float co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2e = co_2c + co_2d, co_2 = -co_2e;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3e = co_3c + co_3d, co_3 = -co_3e;
  const float co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4e = co_4c + co_4d, co_4 = -co_4e;
  const float co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5e = co_5c + co_5d, co_5 = -co_5e;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_3a = D->m23 * ci->m1, w_3b = D->m13 * ci->m2, w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const float w_4a = D->m03 * ci->m2, w_4b = D->m23 * ci->m0, w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const float w_5a = D->m13 * ci->m0, w_5b = D->m03 * ci->m1, w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const float co_0a = D->m00 * ci->m0, co_0b = D->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = D->m20 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = D->m01 * ci->m0, co_1b = D->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = D->m21 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = D->m02 * ci->m0, co_2b = D->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = D->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = D->m00 * w_3, co_3b = D->m10 * w_4, co_3c = co_3a + co_3b,
      co_3d = D->m20 * w_5, co_3 = co_3c + co_3d;
  const float co_4a = D->m01 * w_3, co_4b = D->m11 * w_4, co_4c = co_4a + co_4b,
      co_4d = D->m21 * w_5, co_4 = co_4c + co_4d;
  const float co_5a = D->m02 * w_3, co_5b = D->m12 * w_4, co_5c = co_5a + co_5b,
      co_5d = D->m22 * w_5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinvf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m20 * D->m13, co_3b = D->m10 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m00 * D->m23, co_4b = D->m20 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m10 * D->m03, co_5b = D->m00 * D->m13, co_5 = co_5a - co_5b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m21 * D->m13, co_3b = D->m11 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m01 * D->m23, co_4b = D->m21 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m11 * D->m03, co_5b = D->m01 * D->m13, co_5 = co_5a - co_5b;
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
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m22 * D->m13, co_3b = D->m12 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m02 * D->m23, co_4b = D->m22 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m12 * D->m03, co_5b = D->m02 * D->m13, co_5 = co_5a - co_5b;
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

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcryf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m00;
  const float co_1 = -D->m10;
  const float co_2 = -D->m20;
  const float co_3a = D->m10 * D->m23, co_3b = D->m20 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m20 * D->m03, co_4b = D->m00 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m00 * D->m13, co_5b = D->m10 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m01;
  const float co_1 = -D->m11;
  const float co_2 = -D->m21;
  const float co_3a = D->m11 * D->m23, co_3b = D->m21 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m21 * D->m03, co_4b = D->m01 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m01 * D->m13, co_5b = D->m11 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m02;
  const float co_1 = -D->m12;
  const float co_2 = -D->m22;
  const float co_3a = D->m12 * D->m23, co_3b = D->m22 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m22 * D->m03, co_4b = D->m02 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m02 * D->m13, co_5b = D->m12 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m00;
  const float co_4 = -D->m10;
  const float co_5 = -D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m01;
  const float co_4 = -D->m11;
  const float co_5 = -D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m02;
  const float co_4 = -D->m12;
  const float co_5 = -D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAdf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_30a = D->m20 * D->m13, M_30b = D->m10 * D->m23, M_30 = M_30a - M_30b;
  const float M_31a = D->m21 * D->m13, M_31b = D->m11 * D->m23, M_31 = M_31a - M_31b;
  const float M_32a = D->m22 * D->m13, M_32b = D->m12 * D->m23, M_32 = M_32a - M_32b;
  const float M_40a = D->m00 * D->m23, M_40b = D->m20 * D->m03, M_40 = M_40a - M_40b;
  const float M_41a = D->m01 * D->m23, M_41b = D->m21 * D->m03, M_41 = M_41a - M_41b;
  const float M_42a = D->m02 * D->m23, M_42b = D->m22 * D->m03, M_42 = M_42a - M_42b;
  const float M_50a = D->m10 * D->m03, M_50b = D->m00 * D->m13, M_50 = M_50a - M_50b;
  const float M_51a = D->m11 * D->m03, M_51b = D->m01 * D->m13, M_51 = M_51a - M_51b;
  const float M_52a = D->m12 * D->m03, M_52b = D->m02 * D->m13, M_52 = M_52a - M_52b;
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
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_reciprocal_productf(const ksl_coscrewf_t *c, const float x[6]) {
  const float power_a = c->m0 * x[3], power_b = c->m1 * x[4], power_c = power_a + power_b,
      power_d = c->m2 * x[5], power_e = power_c + power_d, power_f = c->m3 * x[0],
      power_g = c->m4 * x[1], power_h = power_f + power_g, power_i = c->m5 * x[2],
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_0a = s->m4 * c->m2, co_0b = s->m5 * c->m1, co_0 = co_0a - co_0b;
  const float co_1a = s->m5 * c->m0, co_1b = s->m3 * c->m2, co_1 = co_1a - co_1b;
  const float co_2a = s->m3 * c->m1, co_2b = s->m4 * c->m0, co_2 = co_2a - co_2b;
  const float co_3a = s->m1 * c->m2, co_3b = s->m2 * c->m1, co_3c = co_3a - co_3b,
      co_3d = s->m4 * c->m5, co_3e = s->m5 * c->m4, co_3f = co_3d - co_3e, co_3 = co_3c + co_3f;
  const float co_4a = s->m2 * c->m0, co_4b = s->m0 * c->m2, co_4c = co_4a - co_4b,
      co_4d = s->m5 * c->m3, co_4e = s->m3 * c->m5, co_4f = co_4d - co_4e, co_4 = co_4c + co_4f;
  const float co_5a = s->m0 * c->m1, co_5b = s->m1 * c->m0, co_5c = co_5a - co_5b,
      co_5d = s->m3 * c->m4, co_5e = s->m4 * c->m3, co_5f = co_5d - co_5e, co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scaf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_3a = s->m4 * c->m5, co_3b = s->m5 * c->m4, co_3 = co_3a - co_3b;
  const float co_4a = s->m5 * c->m3, co_4b = s->m3 * c->m5, co_4 = co_4a - co_4b;
  const float co_5a = s->m3 * c->m4, co_5b = s->m4 * c->m3, co_5 = co_5a - co_5b;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m01 * c->m1, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const float w_1a = D->m11 * c->m1, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const float w_2a = D->m21 * c->m1, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const float w_1a = D->m10 * c->m0, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const float w_2a = D->m20 * c->m0, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0 = w_0a + w_0b;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1 = w_1a + w_1b;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m01 * c->m4, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const float w_4a = D->m11 * c->m4, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const float w_5a = D->m21 * c->m4, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * c->m3, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const float w_4a = D->m10 * c->m3, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const float w_5a = D->m20 * c->m3, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3 = w_3a + w_3b;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4 = w_4a + w_4b;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m00 * c->m0;
  const float w_1 = D->m10 * c->m0;
  const float w_2 = D->m20 * c->m0;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m01 * c->m1;
  const float w_1 = D->m11 * c->m1;
  const float w_2 = D->m21 * c->m1;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m02 * c->m2;
  const float w_1 = D->m12 * c->m2;
  const float w_2 = D->m22 * c->m2;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
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
static inline void ksl_working_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m00 * c->m3;
  const float w_4 = D->m10 * c->m3;
  const float w_5 = D->m20 * c->m3;
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
static inline void ksl_working_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m01 * c->m4;
  const float w_4 = D->m11 * c->m4;
  const float w_5 = D->m21 * c->m4;
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
static inline void ksl_working_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m02 * c->m5;
  const float w_4 = D->m12 * c->m5;
  const float w_5 = D->m22 * c->m5;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coadf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5;
  const float M_12 = -s->m3;
  const float M_20 = -s->m4;
  const float M_31 = -s->m2;
  const float M_42 = -s->m0;
  const float M_50 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m5 = s->m5;
  const float s_m3 = s->m3;
  const float s_m1 = s->m1;
  const float s_m2 = s->m2;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0f;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_coscrew_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrew_t *ksl_coscrew_alloc(int n) {
  return n > 0 ? (ksl_coscrew_t *)calloc((size_t)n, sizeof(ksl_coscrew_t)) : NULL;
}

/* n ksl_coscrewf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrewf_t *ksl_coscrewf_alloc(int n) {
  return n > 0 ? (ksl_coscrewf_t *)calloc((size_t)n, sizeof(ksl_coscrewf_t)) : NULL;
}

#endif

#endif

/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation. */
#ifndef KSL_QUATERNION_H
#define KSL_QUATERNION_H


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
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_quaternion_norm(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = q->x * s;
  const double y_1 = q->y * s;
  const double y_2 = q->z * s;
  const double y_3 = q->w * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternion_normalize(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_size_3 = fabs(self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
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
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternion_normalized(const ksl_quaternion_t *q, ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
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
   Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved. */
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
   Error <= qo: 5 u of its largest component for R a rotation; searched, not proved. */
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
   Error <= qo: 3 u of its largest component for |axis| = 1; searched, not proved. */
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
   12 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 20 select.
   Error <= angle: 6 u, axis: 4 u of its largest component; searched, not proved. */
static inline double ksl_axis_angle_from_quaternion(const ksl_quaternion_t *q, ksl_vec3_t *axis) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = q->x * s;
  const double scaled_s_1 = q->y * s;
  const double scaled_s_2 = q->z * s;
  const double scaled_s_3 = q->w * s;
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
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
   43 mul, 53 add, 2 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 2 less, 6 select.
   Error <= qo: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_quaternion_exp(const ksl_vec3_t *v, ksl_quaternion_t *qo) {
  const double h_0 = 0.5 * v->x;
  const double h_1 = 0.5 * v->y;
  const double h_2 = 0.5 * v->z;
  const double size_0 = fabs(h_0);
  const double size_1 = fabs(h_1);
  const double size_2 = fabs(h_2);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = h_0 + grid;
  const double shifted_1 = h_1 + grid;
  const double shifted_2 = h_2 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = h_0 - high_0;
  const double low_1 = h_1 - high_1;
  const double low_2 = h_2 - high_2;
  const double sum_0 = h_0 + high_0;
  const double sum_1 = h_1 + high_1;
  const double sum_2 = h_2 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_k = sine / theta;
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
   15 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 19 select.
   Error <= vo: 6 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_log(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = q->x * s;
  const double scaled_s_1 = q->y * s;
  const double scaled_s_2 = q->z * s;
  const double scaled_s_3 = q->w * s;
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
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
   85 mul, 79 add, 3 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 4 neg, 7 abs, 11 less, 1 equal, 19
     select.
   Error <= qo: 12 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
     searched, not proved. */
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
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
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
  const double exp_size_0 = fabs(step_0);
  const double exp_size_1 = fabs(step_1);
  const double exp_size_2 = fabs(step_2);
  const double exp_sizes_a = exp_size_0 + exp_size_1, exp_sizes = exp_sizes_a + exp_size_2;
  const double exp_grid = exp_sizes * 268435456.0;
  const double exp_shifted_0 = step_0 + exp_grid;
  const double exp_shifted_1 = step_1 + exp_grid;
  const double exp_shifted_2 = step_2 + exp_grid;
  const double exp_high_0 = exp_shifted_0 - exp_grid;
  const double exp_high_1 = exp_shifted_1 - exp_grid;
  const double exp_high_2 = exp_shifted_2 - exp_grid;
  const double exp_low_0 = step_0 - exp_high_0;
  const double exp_low_1 = step_1 - exp_high_1;
  const double exp_low_2 = step_2 - exp_high_2;
  const double exp_sum_0 = step_0 + exp_high_0;
  const double exp_sum_1 = step_1 + exp_high_1;
  const double exp_sum_2 = step_2 + exp_high_2;
  const double exp_squares_a = exp_high_0 * exp_high_0, exp_squares_b = exp_high_1 * exp_high_1,
      exp_squares_c = exp_squares_a + exp_squares_b, exp_squares_d = exp_high_2 * exp_high_2,
      exp_squares = exp_squares_c + exp_squares_d;
  const double exp_cross_a = exp_low_0 * exp_sum_0, exp_cross_b = exp_low_1 * exp_sum_1,
      exp_cross_c = exp_cross_a + exp_cross_b, exp_cross_d = exp_low_2 * exp_sum_2,
      exp_cross = exp_cross_c + exp_cross_d;
  const double exp_x = exp_squares + exp_cross;
  const double exp_theta_a = sqrt(exp_x), exp_theta = exp_x < 1.0 ? 1.0 : exp_theta_a;
  const double exp_theta_shifted = exp_grid + exp_theta;
  const double exp_theta_high = exp_theta_shifted - exp_grid;
  const double exp_theta_low = exp_theta - exp_theta_high;
  const double exp_theta_sum = exp_theta + exp_theta_high;
  const double exp_cross_rest_a = exp_theta_low * exp_theta_sum,
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const double exp_exact_a = exp_theta_high * exp_theta_high, exp_exact = exp_squares - exp_exact_a;
  const double exp_residual = exp_cross_rest + exp_exact;
  const double exp_small_a = 0.5 * exp_residual, exp_small = exp_small_a / exp_theta;
  const double exp_delta_a = fabs(exp_small), exp_delta = exp_delta_a < 0.0078125 ? exp_small : 0.0;
  const double exp_far_sine_a = sin(exp_theta), exp_far_sine = exp_x < 1.0 ? 1.0 : exp_far_sine_a;
  const double exp_far_cosine_a = cos(exp_theta),
      exp_far_cosine = exp_x < 1.0 ? 0.0 : exp_far_cosine_a;
  const double exp_sine_a = exp_delta * exp_far_cosine, exp_sine = exp_sine_a + exp_far_sine;
  const double exp_cosine_a = exp_delta * exp_far_sine, exp_cosine = exp_far_cosine - exp_cosine_a;
  const double exp_far_k = exp_sine / exp_theta;
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
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_quaternionf_norm(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = q->x * s;
  const float y_1 = q->y * s;
  const float y_2 = q->z * s;
  const float y_3 = q->w * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrtf(n_g);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternionf_normalize(ksl_quaternionf_t *self) {
  const float s_size_0 = fabsf(self->x);
  const float s_size_1 = fabsf(self->y);
  const float s_size_2 = fabsf(self->z);
  const float s_size_3 = fabsf(self->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
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
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternionf_normalized(const ksl_quaternionf_t *q, ksl_quaternionf_t *qo) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
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
   Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved. */
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
   Error <= qo: 5 u of its largest component for R a rotation; searched, not proved. */
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
   Error <= qo: 3 u of its largest component for |axis| = 1; searched, not proved. */
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
   12 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 20 select.
   Error <= angle: 6 u, axis: 4 u of its largest component; searched, not proved. */
static inline float ksl_axis_angle_from_quaternionf(const ksl_quaternionf_t *q, ksl_vec3f_t *axis) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = q->x * s;
  const float scaled_s_1 = q->y * s;
  const float scaled_s_2 = q->z * s;
  const float scaled_s_3 = q->w * s;
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
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
   43 mul, 53 add, 2 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 2 less, 6 select.
   Error <= qo: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_quaternionf_exp(const ksl_vec3f_t *v, ksl_quaternionf_t *qo) {
  const float h_0 = 0.5f * v->x;
  const float h_1 = 0.5f * v->y;
  const float h_2 = 0.5f * v->z;
  const float size_0 = fabsf(h_0);
  const float size_1 = fabsf(h_1);
  const float size_2 = fabsf(h_2);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = h_0 + grid;
  const float shifted_1 = h_1 + grid;
  const float shifted_2 = h_2 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = h_0 - high_0;
  const float low_1 = h_1 - high_1;
  const float low_2 = h_2 - high_2;
  const float sum_0 = h_0 + high_0;
  const float sum_1 = h_1 + high_1;
  const float sum_2 = h_2 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_k = sine / theta;
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
   15 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 19 select.
   Error <= vo: 6 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_log(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const float s_size_0 = fabsf(q->x);
  const float s_size_1 = fabsf(q->y);
  const float s_size_2 = fabsf(q->z);
  const float s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = q->x * s;
  const float scaled_s_1 = q->y * s;
  const float scaled_s_2 = q->z * s;
  const float scaled_s_3 = q->w * s;
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
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
   85 mul, 79 add, 3 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 4 neg, 7 abs, 11 less, 1 equal, 19
     select.
   Error <= qo: 12 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
     searched, not proved. */
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
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
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
  const float exp_size_0 = fabsf(step_0);
  const float exp_size_1 = fabsf(step_1);
  const float exp_size_2 = fabsf(step_2);
  const float exp_sizes_a = exp_size_0 + exp_size_1, exp_sizes = exp_sizes_a + exp_size_2;
  const float exp_grid = exp_sizes * 8192.0f;
  const float exp_shifted_0 = step_0 + exp_grid;
  const float exp_shifted_1 = step_1 + exp_grid;
  const float exp_shifted_2 = step_2 + exp_grid;
  const float exp_high_0 = exp_shifted_0 - exp_grid;
  const float exp_high_1 = exp_shifted_1 - exp_grid;
  const float exp_high_2 = exp_shifted_2 - exp_grid;
  const float exp_low_0 = step_0 - exp_high_0;
  const float exp_low_1 = step_1 - exp_high_1;
  const float exp_low_2 = step_2 - exp_high_2;
  const float exp_sum_0 = step_0 + exp_high_0;
  const float exp_sum_1 = step_1 + exp_high_1;
  const float exp_sum_2 = step_2 + exp_high_2;
  const float exp_squares_a = exp_high_0 * exp_high_0, exp_squares_b = exp_high_1 * exp_high_1,
      exp_squares_c = exp_squares_a + exp_squares_b, exp_squares_d = exp_high_2 * exp_high_2,
      exp_squares = exp_squares_c + exp_squares_d;
  const float exp_cross_a = exp_low_0 * exp_sum_0, exp_cross_b = exp_low_1 * exp_sum_1,
      exp_cross_c = exp_cross_a + exp_cross_b, exp_cross_d = exp_low_2 * exp_sum_2,
      exp_cross = exp_cross_c + exp_cross_d;
  const float exp_x = exp_squares + exp_cross;
  const float exp_theta_a = sqrtf(exp_x), exp_theta = exp_x < 1.0f ? 1.0f : exp_theta_a;
  const float exp_theta_shifted = exp_grid + exp_theta;
  const float exp_theta_high = exp_theta_shifted - exp_grid;
  const float exp_theta_low = exp_theta - exp_theta_high;
  const float exp_theta_sum = exp_theta + exp_theta_high;
  const float exp_cross_rest_a = exp_theta_low * exp_theta_sum,
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const float exp_exact_a = exp_theta_high * exp_theta_high, exp_exact = exp_squares - exp_exact_a;
  const float exp_residual = exp_cross_rest + exp_exact;
  const float exp_small_a = 0.5f * exp_residual, exp_small = exp_small_a / exp_theta;
  const float exp_delta_a = fabsf(exp_small),
      exp_delta = exp_delta_a < 0.0078125f ? exp_small : 0.0f;
  const float exp_far_sine_a = sinf(exp_theta), exp_far_sine = exp_x < 1.0f ? 1.0f : exp_far_sine_a;
  const float exp_far_cosine_a = cosf(exp_theta),
      exp_far_cosine = exp_x < 1.0f ? 0.0f : exp_far_cosine_a;
  const float exp_sine_a = exp_delta * exp_far_cosine, exp_sine = exp_sine_a + exp_far_sine;
  const float exp_cosine_a = exp_delta * exp_far_sine, exp_cosine = exp_far_cosine - exp_cosine_a;
  const float exp_far_k = exp_sine / exp_theta;
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

/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation. */
#ifndef KSL_EXPONENTIAL_H
#define KSL_EXPONENTIAL_H


/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   49 mul, 69 add, 3 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 5 less, 11 select.
   Error <= R: (5 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_exp(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double size_0 = fabs(v->x);
  const double size_1 = fabs(v->y);
  const double size_2 = fabs(v->z);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = v->x + grid;
  const double shifted_1 = v->y + grid;
  const double shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0;
  const double low_1 = v->y - high_1;
  const double low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0;
  const double sum_1 = v->y + high_1;
  const double sum_2 = v->z + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g0a = x * g2, g0b = 1.0 - g0a, g0 = x < 1.0 ? g0b : cosine;
  const double beta_v_0 = v->x * g2;
  const double beta_v_1 = v->y * g2;
  const double beta_v_2 = v->z * g2;
  const double m_0 = v->x * beta_v_0;
  const double m_1 = v->y * beta_v_1;
  const double m_2 = v->z * beta_v_2;
  const double m_3 = v->y * beta_v_0;
  const double m_4 = v->z * beta_v_0;
  const double m_5 = v->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = v->x * g1;
  const double alpha_v_1 = v->y * g1;
  const double alpha_v_2 = v->z * g1;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* vo with exp vo~ = R, |vo| <= π; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; vo: vector.
   11 mul, 16 add, 1 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 25 select.
   Error <= vo: 6 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_log(const ksl_mat3x3_t *R, ksl_vec3_t *vo) {
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
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
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

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   60 mul, 81 add, 4 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 6 less, 12 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobian(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double size_0 = fabs(v->x);
  const double size_1 = fabs(v->y);
  const double size_2 = fabs(v->z);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = v->x + grid;
  const double shifted_1 = v->y + grid;
  const double shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0;
  const double low_1 = v->y - high_1;
  const double low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0;
  const double sum_1 = v->y + high_1;
  const double sum_2 = v->z + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g3a = 9.183689863795546e-29 * x, g3b = g3a - 6.446950284384474e-26, g3c = x * g3b,
      g3d = g3c + 3.868170170630684e-23, g3e = x * g3d, g3f = g3e - 1.9572941063391263e-20,
      g3g = x * g3f, g3h = g3g + 8.22063524662433e-18, g3i = x * g3h,
      g3j = g3i - 2.8114572543455206e-15, g3k = x * g3j, g3l = g3k + 7.647163731819816e-13,
      g3m = x * g3l, g3n = g3m - 1.6059043836821613e-10, g3o = x * g3n,
      g3p = g3o + 2.505210838544172e-08, g3q = x * g3p, g3r = g3q - 2.7557319223985893e-06,
      g3s = x * g3r, g3t = g3s + 0.0001984126984126984, g3u = x * g3t,
      g3v = g3u - 0.008333333333333333, g3w = x * g3v, g3x = g3w + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double beta_v_0 = v->x * g3;
  const double beta_v_1 = v->y * g3;
  const double beta_v_2 = v->z * g3;
  const double m_0 = v->x * beta_v_0;
  const double m_1 = v->y * beta_v_1;
  const double m_2 = v->z * beta_v_2;
  const double m_3 = v->y * beta_v_0;
  const double m_4 = v->z * beta_v_0;
  const double m_5 = v->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = v->x * g2;
  const double alpha_v_1 = v->y * g2;
  const double alpha_v_2 = v->z * g2;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   60 mul, 81 add, 4 div, 1 sqrt, 1 sin, 1 cos, 3 neg, 4 abs, 6 less, 12 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobian(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double size_0 = fabs(v->x);
  const double size_1 = fabs(v->y);
  const double size_2 = fabs(v->z);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = v->x + grid;
  const double shifted_1 = v->y + grid;
  const double shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0;
  const double low_1 = v->y - high_1;
  const double low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0;
  const double sum_1 = v->y + high_1;
  const double sum_2 = v->z + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g3a = 9.183689863795546e-29 * x, g3b = g3a - 6.446950284384474e-26, g3c = x * g3b,
      g3d = g3c + 3.868170170630684e-23, g3e = x * g3d, g3f = g3e - 1.9572941063391263e-20,
      g3g = x * g3f, g3h = g3g + 8.22063524662433e-18, g3i = x * g3h,
      g3j = g3i - 2.8114572543455206e-15, g3k = x * g3j, g3l = g3k + 7.647163731819816e-13,
      g3m = x * g3l, g3n = g3m - 1.6059043836821613e-10, g3o = x * g3n,
      g3p = g3o + 2.505210838544172e-08, g3q = x * g3p, g3r = g3q - 2.7557319223985893e-06,
      g3s = x * g3r, g3t = g3s + 0.0001984126984126984, g3u = x * g3t,
      g3v = g3u - 0.008333333333333333, g3w = x * g3v, g3x = g3w + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double beta_v_0 = v->x * g3;
  const double beta_v_1 = v->y * g3;
  const double beta_v_2 = v->z * g3;
  const double m_0 = v->x * beta_v_0;
  const double m_1 = v->y * beta_v_1;
  const double m_2 = v->z * beta_v_2;
  const double m_3 = v->y * beta_v_0;
  const double m_4 = v->z * beta_v_0;
  const double m_5 = v->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = v->x * g2, alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = v->y * g2, alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = v->z * g2, alpha_v_2 = -alpha_v_2a;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     but 0.
   v: vector; R: rotation or other 3×3 matrix.
   43 mul, 63 add, 3 div, 1 sqrt, 1 sin, 1 cos, 3 neg, 4 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_leftJacobianInverse(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double size_0 = fabs(v->x);
  const double size_1 = fabs(v->y);
  const double size_2 = fabs(v->z);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = v->x + grid;
  const double shifted_1 = v->y + grid;
  const double shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0;
  const double low_1 = v->y - high_1;
  const double low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0;
  const double sum_1 = v->y + high_1;
  const double sum_2 = v->z + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent_a = 0.5 * theta, half_cotangent = half_cotangent_a * cotangent;
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_a = 1.455172475614865e-27 * x, b_b = b_a + 5.744790668872202e-26, b_c = x * b_b,
      b_d = b_c + 2.267952452337683e-24, b_e = x * b_d, b_f = b_e + 8.953517427037546e-23,
      b_g = x * b_f, b_h = b_g + 3.534707039629467e-21, b_i = x * b_h,
      b_j = b_i + 1.3954464685812522e-19, b_k = x * b_j, b_l = b_k + 5.5090028283602295e-18,
      b_m = x * b_l, b_n = b_m + 2.174868698558062e-16, b_o = x * b_n,
      b_p = b_o + 8.586062056277845e-15, b_q = x * b_p, b_r = b_q + 3.3896802963225827e-13,
      b_s = x * b_r, b_t = b_s + 1.3382536530684679e-11, b_u = x * b_t,
      b_v = b_u + 5.284190138687493e-10, b_w = x * b_v, b_x = b_w + 2.08767569878681e-08,
      b_y = x * b_x, b_z = b_y + 8.267195767195768e-07, b_aa = x * b_z,
      b_ab = b_aa + 3.306878306878307e-05, b_ac = x * b_ab, b_ad = b_ac + 0.001388888888888889,
      b_ae = x * b_ad, b_af = b_ae + 0.08333333333333333, b = x < 4.0 ? b_af : closed_b;
  const double b_across_a = x * b, b_across_b = 1.0 - b_across_a,
      b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = v->x * b;
  const double beta_v_1 = v->y * b;
  const double beta_v_2 = v->z * b;
  const double m_0 = v->x * beta_v_0;
  const double m_1 = v->y * beta_v_1;
  const double m_2 = v->z * beta_v_2;
  const double m_3 = v->y * beta_v_0;
  const double m_4 = v->z * beta_v_0;
  const double m_5 = v->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = 0.5 * v->x, alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = 0.5 * v->y, alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = 0.5 * v->z, alpha_v_2 = -alpha_v_2a;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     but 0.
   v: vector; R: rotation or other 3×3 matrix.
   43 mul, 63 add, 3 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_rightJacobianInverse(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double size_0 = fabs(v->x);
  const double size_1 = fabs(v->y);
  const double size_2 = fabs(v->z);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = v->x + grid;
  const double shifted_1 = v->y + grid;
  const double shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0;
  const double low_1 = v->y - high_1;
  const double low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0;
  const double sum_1 = v->y + high_1;
  const double sum_2 = v->z + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent_a = 0.5 * theta, half_cotangent = half_cotangent_a * cotangent;
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_a = 1.455172475614865e-27 * x, b_b = b_a + 5.744790668872202e-26, b_c = x * b_b,
      b_d = b_c + 2.267952452337683e-24, b_e = x * b_d, b_f = b_e + 8.953517427037546e-23,
      b_g = x * b_f, b_h = b_g + 3.534707039629467e-21, b_i = x * b_h,
      b_j = b_i + 1.3954464685812522e-19, b_k = x * b_j, b_l = b_k + 5.5090028283602295e-18,
      b_m = x * b_l, b_n = b_m + 2.174868698558062e-16, b_o = x * b_n,
      b_p = b_o + 8.586062056277845e-15, b_q = x * b_p, b_r = b_q + 3.3896802963225827e-13,
      b_s = x * b_r, b_t = b_s + 1.3382536530684679e-11, b_u = x * b_t,
      b_v = b_u + 5.284190138687493e-10, b_w = x * b_v, b_x = b_w + 2.08767569878681e-08,
      b_y = x * b_x, b_z = b_y + 8.267195767195768e-07, b_aa = x * b_z,
      b_ab = b_aa + 3.306878306878307e-05, b_ac = x * b_ab, b_ad = b_ac + 0.001388888888888889,
      b_ae = x * b_ad, b_af = b_ae + 0.08333333333333333, b = x < 4.0 ? b_af : closed_b;
  const double b_across_a = x * b, b_across_b = 1.0 - b_across_a,
      b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = v->x * b;
  const double beta_v_1 = v->y * b;
  const double beta_v_2 = v->z * b;
  const double m_0 = v->x * beta_v_0;
  const double m_1 = v->y * beta_v_1;
  const double m_2 = v->z * beta_v_2;
  const double m_3 = v->y * beta_v_0;
  const double m_4 = v->z * beta_v_0;
  const double m_5 = v->z * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = 0.5 * v->x;
  const double alpha_v_1 = 0.5 * v->y;
  const double alpha_v_2 = 0.5 * v->z;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalize(ksl_mat3x3_t *self) {
  const double defect_0a = self->m00 * self->m00, defect_0b = 1.0 - defect_0a,
      defect_0c = self->m10 * self->m10, defect_0d = defect_0b - defect_0c,
      defect_0e = self->m20 * self->m20, defect_0 = defect_0d - defect_0e;
  const double defect_1a = self->m01 * self->m01, defect_1b = 1.0 - defect_1a,
      defect_1c = self->m11 * self->m11, defect_1d = defect_1b - defect_1c,
      defect_1e = self->m21 * self->m21, defect_1 = defect_1d - defect_1e;
  const double defect_2a = self->m02 * self->m02, defect_2b = 1.0 - defect_2a,
      defect_2c = self->m12 * self->m12, defect_2d = defect_2b - defect_2c,
      defect_2e = self->m22 * self->m22, defect_2 = defect_2d - defect_2e;
  const double defect_3a = self->m00 * self->m01, defect_3b = self->m10 * self->m11,
      defect_3c = defect_3a + defect_3b, defect_3d = self->m20 * self->m21,
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = self->m00 * self->m02, defect_4b = self->m10 * self->m12,
      defect_4c = defect_4a + defect_4b, defect_4d = self->m20 * self->m22,
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = self->m01 * self->m02, defect_5b = self->m11 * self->m12,
      defect_5c = defect_5a + defect_5b, defect_5d = self->m21 * self->m22,
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = 0.5 * defect_0;
  const double correction_1 = 0.5 * defect_1;
  const double correction_2 = 0.5 * defect_2;
  const double correction_3 = 0.5 * defect_3;
  const double correction_4 = 0.5 * defect_4;
  const double correction_5 = 0.5 * defect_5;
  const double self_00_new_a = self->m00 * correction_0, self_00_new_b = self->m01 * correction_3,
      self_00_new_c = self_00_new_a + self_00_new_b, self_00_new_d = self->m02 * correction_4,
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const double self_01_new_a = self->m00 * correction_3, self_01_new_b = self->m01 * correction_1,
      self_01_new_c = self_01_new_a + self_01_new_b, self_01_new_d = self->m02 * correction_5,
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const double self_02_new_a = self->m00 * correction_4, self_02_new_b = self->m01 * correction_5,
      self_02_new_c = self_02_new_a + self_02_new_b, self_02_new_d = self->m02 * correction_2,
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const double self_10_new_a = self->m10 * correction_0, self_10_new_b = self->m11 * correction_3,
      self_10_new_c = self_10_new_a + self_10_new_b, self_10_new_d = self->m12 * correction_4,
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const double self_11_new_a = self->m10 * correction_3, self_11_new_b = self->m11 * correction_1,
      self_11_new_c = self_11_new_a + self_11_new_b, self_11_new_d = self->m12 * correction_5,
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const double self_12_new_a = self->m10 * correction_4, self_12_new_b = self->m11 * correction_5,
      self_12_new_c = self_12_new_a + self_12_new_b, self_12_new_d = self->m12 * correction_2,
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const double self_20_new_a = self->m20 * correction_0, self_20_new_b = self->m21 * correction_3,
      self_20_new_c = self_20_new_a + self_20_new_b, self_20_new_d = self->m22 * correction_4,
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const double self_21_new_a = self->m20 * correction_3, self_21_new_b = self->m21 * correction_1,
      self_21_new_c = self_21_new_a + self_21_new_b, self_21_new_d = self->m22 * correction_5,
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const double self_22_new_a = self->m20 * correction_4, self_22_new_b = self->m21 * correction_5,
      self_22_new_c = self_22_new_a + self_22_new_b, self_22_new_d = self->m22 * correction_2,
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalized(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0a = R->m00 * R->m00, defect_0b = 1.0 - defect_0a,
      defect_0c = R->m10 * R->m10, defect_0d = defect_0b - defect_0c, defect_0e = R->m20 * R->m20,
      defect_0 = defect_0d - defect_0e;
  const double defect_1a = R->m01 * R->m01, defect_1b = 1.0 - defect_1a,
      defect_1c = R->m11 * R->m11, defect_1d = defect_1b - defect_1c, defect_1e = R->m21 * R->m21,
      defect_1 = defect_1d - defect_1e;
  const double defect_2a = R->m02 * R->m02, defect_2b = 1.0 - defect_2a,
      defect_2c = R->m12 * R->m12, defect_2d = defect_2b - defect_2c, defect_2e = R->m22 * R->m22,
      defect_2 = defect_2d - defect_2e;
  const double defect_3a = R->m00 * R->m01, defect_3b = R->m10 * R->m11,
      defect_3c = defect_3a + defect_3b, defect_3d = R->m20 * R->m21,
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = R->m00 * R->m02, defect_4b = R->m10 * R->m12,
      defect_4c = defect_4a + defect_4b, defect_4d = R->m20 * R->m22,
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = R->m01 * R->m02, defect_5b = R->m11 * R->m12,
      defect_5c = defect_5a + defect_5b, defect_5d = R->m21 * R->m22,
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = 0.5 * defect_0;
  const double correction_1 = 0.5 * defect_1;
  const double correction_2 = 0.5 * defect_2;
  const double correction_3 = 0.5 * defect_3;
  const double correction_4 = 0.5 * defect_4;
  const double correction_5 = 0.5 * defect_5;
  const double Ro_00a = R->m00 * correction_0, Ro_00b = R->m01 * correction_3,
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = R->m02 * correction_4, Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const double Ro_01a = R->m00 * correction_3, Ro_01b = R->m01 * correction_1,
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = R->m02 * correction_5, Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const double Ro_02a = R->m00 * correction_4, Ro_02b = R->m01 * correction_5,
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = R->m02 * correction_2, Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const double Ro_10a = R->m10 * correction_0, Ro_10b = R->m11 * correction_3,
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = R->m12 * correction_4, Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const double Ro_11a = R->m10 * correction_3, Ro_11b = R->m11 * correction_1,
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = R->m12 * correction_5, Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const double Ro_12a = R->m10 * correction_4, Ro_12b = R->m11 * correction_5,
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = R->m12 * correction_2, Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const double Ro_20a = R->m20 * correction_0, Ro_20b = R->m21 * correction_3,
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = R->m22 * correction_4, Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const double Ro_21a = R->m20 * correction_3, Ro_21b = R->m21 * correction_1,
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = R->m22 * correction_5, Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const double Ro_22a = R->m20 * correction_4, Ro_22b = R->m21 * correction_5,
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = R->m22 * correction_2, Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   80 mul, 93 add, 4 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 6 less, 13 select.
   Error <= R: (5 + θ/200) u, t: (8 + θ/200) u of its largest component, or of s.lin if that is
     larger for |ω of s| <= 1e13, in single precision 1e5; searched, not proved. */
static inline void ksl_SE3_exp(const ksl_screw_t *s, ksl_SE3_t *D) {
  const double size_0 = fabs(s->m3);
  const double size_1 = fabs(s->m4);
  const double size_2 = fabs(s->m5);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = s->m3 + grid;
  const double shifted_1 = s->m4 + grid;
  const double shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0;
  const double low_1 = s->m4 - high_1;
  const double low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0;
  const double sum_1 = s->m4 + high_1;
  const double sum_2 = s->m5 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g3a = 9.183689863795546e-29 * x, g3b = g3a - 6.446950284384474e-26, g3c = x * g3b,
      g3d = g3c + 3.868170170630684e-23, g3e = x * g3d, g3f = g3e - 1.9572941063391263e-20,
      g3g = x * g3f, g3h = g3g + 8.22063524662433e-18, g3i = x * g3h,
      g3j = g3i - 2.8114572543455206e-15, g3k = x * g3j, g3l = g3k + 7.647163731819816e-13,
      g3m = x * g3l, g3n = g3m - 1.6059043836821613e-10, g3o = x * g3n,
      g3p = g3o + 2.505210838544172e-08, g3q = x * g3p, g3r = g3q - 2.7557319223985893e-06,
      g3s = x * g3r, g3t = g3s + 0.0001984126984126984, g3u = x * g3t,
      g3v = g3u - 0.008333333333333333, g3w = x * g3v, g3x = g3w + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double g0a = x * g2, g0b = 1.0 - g0a, g0 = x < 1.0 ? g0b : cosine;
  const double u_0a = s->m2 * s->m4, u_0b = s->m1 * s->m5, u_0 = u_0a - u_0b;
  const double u_1a = s->m0 * s->m5, u_1b = s->m2 * s->m3, u_1 = u_1a - u_1b;
  const double u_2a = s->m1 * s->m3, u_2b = s->m0 * s->m4, u_2 = u_2a - u_2b;
  const double turned_0 = g2 * u_0;
  const double turned_1 = g2 * u_1;
  const double turned_2 = g2 * u_2;
  const double wv_a = s->m0 * s->m3, wv_b = s->m1 * s->m4, wv_c = wv_a + wv_b, wv_d = s->m2 * s->m5,
      wv = wv_c + wv_d;
  const double pitch = g3 * wv;
  const double along_0 = s->m3 * pitch;
  const double along_1 = s->m4 * pitch;
  const double along_2 = s->m5 * pitch;
  const double beta_v_0 = s->m3 * g2;
  const double beta_v_1 = s->m4 * g2;
  const double beta_v_2 = s->m5 * g2;
  const double m_0 = s->m3 * beta_v_0;
  const double m_1 = s->m4 * beta_v_1;
  const double m_2 = s->m5 * beta_v_2;
  const double m_3 = s->m4 * beta_v_0;
  const double m_4 = s->m5 * beta_v_0;
  const double m_5 = s->m5 * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = s->m3 * g1;
  const double alpha_v_1 = s->m4 * g1;
  const double alpha_v_2 = s->m5 * g1;
  const double across_axis_0 = turned_0 + along_0;
  const double across_axis_1 = turned_1 + along_1;
  const double across_axis_2 = turned_2 + along_2;
  const double D_01 = m_3 - alpha_v_2;
  const double D_02 = m_4 + alpha_v_1;
  const double D_03a = s->m0 * g1, D_03 = D_03a + across_axis_0;
  const double D_10 = m_3 + alpha_v_2;
  const double D_12 = m_5 - alpha_v_0;
  const double D_13a = s->m1 * g1, D_13 = D_13a + across_axis_1;
  const double D_20 = m_4 - alpha_v_1;
  const double D_21 = m_5 + alpha_v_0;
  const double D_23a = s->m2 * g1, D_23 = D_23a + across_axis_2;
  D->m00 = diagonal0;
  D->m01 = D_01;
  D->m02 = D_02;
  D->m03 = D_03;
  D->m10 = D_10;
  D->m11 = diagonal1;
  D->m12 = D_12;
  D->m13 = D_13;
  D->m20 = D_20;
  D->m21 = D_21;
  D->m22 = diagonal2;
  D->m23 = D_23;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   50 mul, 45 add, 3 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 14 less, 1 equal, 29 select.
   Error <= lin: 18 u, ang: 8 u of its largest component for D a rotation; searched, not proved. */
static inline void ksl_SE3_log(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double p_0 = D->m21 - D->m12;
  const double p_1 = D->m02 - D->m20;
  const double p_2 = D->m10 - D->m01;
  const double s_0 = D->m12 + D->m21;
  const double s_1 = D->m02 + D->m20;
  const double s_2 = D->m01 + D->m10;
  const double first_0 = D->m00 + 1.0;
  const double first_1 = 1.0 - D->m00;
  const double others_0 = D->m11 + D->m22;
  const double others_1 = D->m11 - D->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = D->m11 < D->m00 ? d_1 : s_2;
  const double low_1 = D->m11 < D->m00 ? s_2 : d_2;
  const double low_2 = D->m11 < D->m00 ? s_1 : s_0;
  const double low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const double high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const double high_1 = D->m00 < high_0a ? s_0 : p_1;
  const double high_2 = D->m00 < high_0a ? d_3 : p_2;
  const double high_3 = D->m00 < high_0a ? p_2 : d_0;
  const double column_0 = D->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = D->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = D->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = D->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = upper_0 * v_s;
  const double v_y_1 = upper_1 * v_s;
  const double v_y_2 = upper_2 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = 2.0 * half;
  const double k = theta / divisor;
  const double vector_0 = upper_0 * k;
  const double vector_1 = upper_1 * k;
  const double vector_2 = upper_2 * k;
  const double x = theta * theta;
  const double far_sine = x < 1.0 ? 1.0 : n;
  const double cotangent = upper_3 / far_sine;
  const double half_cotangent_a = 0.5 * theta, half_cotangent = half_cotangent_a * cotangent;
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_a = 1.455172475614865e-27 * x, b_b = b_a + 5.744790668872202e-26, b_c = x * b_b,
      b_d = b_c + 2.267952452337683e-24, b_e = x * b_d, b_f = b_e + 8.953517427037546e-23,
      b_g = x * b_f, b_h = b_g + 3.534707039629467e-21, b_i = x * b_h,
      b_j = b_i + 1.3954464685812522e-19, b_k = x * b_j, b_l = b_k + 5.5090028283602295e-18,
      b_m = x * b_l, b_n = b_m + 2.174868698558062e-16, b_o = x * b_n,
      b_p = b_o + 8.586062056277845e-15, b_q = x * b_p, b_r = b_q + 3.3896802963225827e-13,
      b_s = x * b_r, b_t = b_s + 1.3382536530684679e-11, b_u = x * b_t,
      b_v = b_u + 5.284190138687493e-10, b_w = x * b_v, b_x = b_w + 2.08767569878681e-08,
      b_y = x * b_x, b_z = b_y + 8.267195767195768e-07, b_aa = x * b_z,
      b_ab = b_aa + 3.306878306878307e-05, b_ac = x * b_ab, b_ad = b_ac + 0.001388888888888889,
      b_ae = x * b_ad, b_af = b_ae + 0.08333333333333333, b = x < 4.0 ? b_af : closed_b;
  const double b_across_a = x * b, b_across_b = 1.0 - b_across_a,
      b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double wt_a = D->m03 * vector_0, wt_b = D->m13 * vector_1, wt_c = wt_a + wt_b,
      wt_d = D->m23 * vector_2, wt = wt_c + wt_d;
  const double pitch = b * wt;
  const double along_0 = vector_0 * pitch;
  const double along_1 = vector_1 * pitch;
  const double along_2 = vector_2 * pitch;
  const double u_0a = D->m23 * vector_1, u_0b = D->m13 * vector_2, u_0 = u_0a - u_0b;
  const double u_1a = D->m03 * vector_2, u_1b = D->m23 * vector_0, u_1 = u_1a - u_1b;
  const double u_2a = D->m13 * vector_0, u_2b = D->m03 * vector_1, u_2 = u_2a - u_2b;
  const double turned_0 = 0.5 * u_0;
  const double turned_1 = 0.5 * u_1;
  const double turned_2 = 0.5 * u_2;
  const double across_axis_0 = along_0 - turned_0;
  const double across_axis_1 = along_1 - turned_1;
  const double across_axis_2 = along_2 - turned_2;
  const double so_0a = D->m03 * b_across, so_0 = so_0a + across_axis_0;
  const double so_1a = D->m13 * b_across, so_1 = so_1a + across_axis_1;
  const double so_2a = D->m23 * b_across, so_2 = so_2a + across_axis_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 133 add, 6 div, 1 sqrt, 1 sin, 1 cos, 1 neg, 4 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3_leftJacobian(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double size_0 = fabs(s->m3);
  const double size_1 = fabs(s->m4);
  const double size_2 = fabs(s->m5);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = s->m3 + grid;
  const double shifted_1 = s->m4 + grid;
  const double shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0;
  const double low_1 = s->m4 - high_1;
  const double low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0;
  const double sum_1 = s->m4 + high_1;
  const double sum_2 = s->m5 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g3a = 9.183689863795546e-29 * x, g3b = g3a - 6.446950284384474e-26, g3c = x * g3b,
      g3d = g3c + 3.868170170630684e-23, g3e = x * g3d, g3f = g3e - 1.9572941063391263e-20,
      g3g = x * g3f, g3h = g3g + 8.22063524662433e-18, g3i = x * g3h,
      g3j = g3i - 2.8114572543455206e-15, g3k = x * g3j, g3l = g3k + 7.647163731819816e-13,
      g3m = x * g3l, g3n = g3m - 1.6059043836821613e-10, g3o = x * g3n,
      g3p = g3o + 2.505210838544172e-08, g3q = x * g3p, g3r = g3q - 2.7557319223985893e-06,
      g3s = x * g3r, g3t = g3s + 0.0001984126984126984, g3u = x * g3t,
      g3v = g3u - 0.008333333333333333, g3w = x * g3v, g3x = g3w + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double late_x = x < 9.0 ? 1.0 : x;
  const double rate2_rest_a = 2.0 * g2, rate2_rest = g1 - rate2_rest_a;
  const double closed_rate2 = rate2_rest / late_x;
  const double rate3_rest_a = 3.0 * g3, rate3_rest = g2 - rate3_rest_a;
  const double closed_rate3 = rate3_rest / late_x;
  const double rate2a = 8.527712016381578e-29 * x, rate2b = 5.951031031739514e-26 - rate2a,
      rate2c = x * rate2b, rate2d = rate2c - 3.54582265641146e-23, rate2e = x * rate2d,
      rate2f = rate2e + 1.7793582784901146e-20, rate2g = x * rate2f,
      rate2h = rate2g - 7.398571721961897e-18, rate2i = x * rate2h,
      rate2j = rate2i + 2.499073114973796e-15, rate2k = x * rate2j,
      rate2l = rate2k - 6.691268265342339e-13, rate2m = x * rate2l,
      rate2n = rate2m + 1.376489471727567e-10, rate2o = x * rate2n,
      rate2p = rate2o - 2.08767569878681e-08, rate2q = x * rate2p,
      rate2r = rate2q + 2.204585537918871e-06, rate2s = x * rate2r,
      rate2t = rate2s - 0.00014880952380952382, rate2u = x * rate2t,
      rate2v = rate2u + 0.005555555555555556, rate2w = x * rate2v,
      rate2x = rate2w - 0.08333333333333333, rate2 = x < 9.0 ? rate2x : closed_rate2;
  const double rate3a = 2.9405903504764064e-30 * x, rate3b = 2.204085567310931e-27 - rate3a,
      rate3c = x * rate3b, rate3d = rate3c - 1.4183290625645841e-24, rate3e = x * rate3d,
      rate3f = rate3e + 7.736340341261368e-22, rate3g = x * rate3f,
      rate3h = rate3g - 3.523129391410427e-19, rate3i = x * rate3h,
      rate3j = rate3i + 1.3153016394598927e-16, rate3k = x * rate3j,
      rate3l = rate3k - 3.936040156083729e-14, rate3m = x * rate3l,
      rate3n = rate3m + 9.17659647818378e-12, rate3o = x * rate3n,
      rate3p = rate3o - 1.6059043836821615e-09, rate3q = x * rate3p,
      rate3r = rate3q + 2.0041686708353376e-07, rate3s = x * rate3r,
      rate3t = rate3s - 1.6534391534391536e-05, rate3u = x * rate3t,
      rate3v = rate3u + 0.0007936507936507937, rate3w = x * rate3v,
      rate3x = rate3w - 0.016666666666666666, rate3 = x < 9.0 ? rate3x : closed_rate3;
  const double beta_v_0 = s->m3 * g3;
  const double beta_v_1 = s->m4 * g3;
  const double beta_v_2 = s->m5 * g3;
  const double m_0 = s->m3 * beta_v_0;
  const double m_1 = s->m4 * beta_v_1;
  const double m_2 = s->m5 * beta_v_2;
  const double m_3 = s->m4 * beta_v_0;
  const double m_4 = s->m5 * beta_v_0;
  const double m_5 = s->m5 * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = s->m3 * g2;
  const double alpha_v_1 = s->m4 * g2;
  const double alpha_v_2 = s->m5 * g2;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const double rate_turn = rate2 * rate_vw;
  const double rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const double rate_q_0a = s->m0 * g2, rate_q_0b = s->m3 * rate_turn,
      rate_q_0 = rate_q_0a + rate_q_0b;
  const double rate_q_1a = s->m1 * g2, rate_q_1b = s->m4 * rate_turn,
      rate_q_1 = rate_q_1a + rate_q_1b;
  const double rate_q_2a = s->m2 * g2, rate_q_2b = s->m5 * rate_turn,
      rate_q_2 = rate_q_2a + rate_q_2b;
  const double rate_beta_v_0 = s->m0 * g3;
  const double rate_beta_v_1 = s->m1 * g3;
  const double rate_beta_v_2 = s->m2 * g3;
  const double rate_bend_w_0 = s->m3 * rate_bend;
  const double rate_bend_w_1 = s->m4 * rate_bend;
  const double rate_bend_w_2 = s->m5 * rate_bend;
  const double rate_symmetric_0a = s->m3 * rate_beta_v_1, rate_symmetric_0b = s->m4 * rate_beta_v_0,
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = s->m4 * rate_bend_w_0,
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const double rate_symmetric_1a = s->m3 * rate_beta_v_2, rate_symmetric_1b = s->m5 * rate_beta_v_0,
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = s->m5 * rate_bend_w_0,
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const double rate_symmetric_2a = s->m4 * rate_beta_v_2, rate_symmetric_2b = s->m5 * rate_beta_v_1,
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = s->m5 * rate_bend_w_1,
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const double rate_diagonal_0a = s->m4 * rate_bend_w_1, rate_diagonal_0b = s->m5 * rate_bend_w_2,
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0 * s->m4,
      rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1, rate_diagonal_0f = 2.0 * s->m5,
      rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2,
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const double rate_diagonal_1a = s->m3 * rate_bend_w_0,
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0 * s->m3,
      rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 133 add, 6 div, 1 sqrt, 1 sin, 1 cos, 13 neg, 4 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3_rightJacobian(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double size_0 = fabs(s->m3);
  const double size_1 = fabs(s->m4);
  const double size_2 = fabs(s->m5);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = s->m3 + grid;
  const double shifted_1 = s->m4 + grid;
  const double shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0;
  const double low_1 = s->m4 - high_1;
  const double low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0;
  const double sum_1 = s->m4 + high_1;
  const double sum_2 = s->m5 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1a = 6.446950284384474e-26 * x, g1b = g1a - 3.868170170630684e-23, g1c = x * g1b,
      g1d = g1c + 1.9572941063391263e-20, g1e = x * g1d, g1f = g1e - 8.22063524662433e-18,
      g1g = x * g1f, g1h = g1g + 2.8114572543455206e-15, g1i = x * g1h,
      g1j = g1i - 7.647163731819816e-13, g1k = x * g1j, g1l = g1k + 1.6059043836821613e-10,
      g1m = x * g1l, g1n = g1m - 2.505210838544172e-08, g1o = x * g1n,
      g1p = g1o + 2.7557319223985893e-06, g1q = x * g1p, g1r = g1q - 0.0001984126984126984,
      g1s = x * g1r, g1t = g1s + 0.008333333333333333, g1u = x * g1t,
      g1v = g1u - 0.16666666666666666, g1w = x * g1v, g1x = g1w + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2a = 2.4795962632247976e-27 * x, g2b = g2a - 1.6117375710961184e-24, g2c = x * g2b,
      g2d = g2c + 8.896791392450574e-22, g2e = x * g2d, g2f = g2e - 4.110317623312165e-19,
      g2g = x * g2f, g2h = g2g + 1.5619206968586225e-16, g2i = x * g2h,
      g2j = g2i - 4.779477332387385e-14, g2k = x * g2j, g2l = g2k + 1.1470745597729725e-11,
      g2m = x * g2l, g2n = g2m - 2.08767569878681e-09, g2o = x * g2n,
      g2p = g2o + 2.755731922398589e-07, g2q = x * g2p, g2r = g2q - 2.48015873015873e-05,
      g2s = x * g2r, g2t = g2s + 0.001388888888888889, g2u = x * g2t,
      g2v = g2u - 0.041666666666666664, g2w = x * g2v, g2x = g2w + 0.5,
      g2 = x < 1.0 ? g2x : closed2;
  const double g3a = 9.183689863795546e-29 * x, g3b = g3a - 6.446950284384474e-26, g3c = x * g3b,
      g3d = g3c + 3.868170170630684e-23, g3e = x * g3d, g3f = g3e - 1.9572941063391263e-20,
      g3g = x * g3f, g3h = g3g + 8.22063524662433e-18, g3i = x * g3h,
      g3j = g3i - 2.8114572543455206e-15, g3k = x * g3j, g3l = g3k + 7.647163731819816e-13,
      g3m = x * g3l, g3n = g3m - 1.6059043836821613e-10, g3o = x * g3n,
      g3p = g3o + 2.505210838544172e-08, g3q = x * g3p, g3r = g3q - 2.7557319223985893e-06,
      g3s = x * g3r, g3t = g3s + 0.0001984126984126984, g3u = x * g3t,
      g3v = g3u - 0.008333333333333333, g3w = x * g3v, g3x = g3w + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double late_x = x < 9.0 ? 1.0 : x;
  const double rate2_rest_a = 2.0 * g2, rate2_rest = g1 - rate2_rest_a;
  const double closed_rate2 = rate2_rest / late_x;
  const double rate3_rest_a = 3.0 * g3, rate3_rest = g2 - rate3_rest_a;
  const double closed_rate3 = rate3_rest / late_x;
  const double rate2a = 8.527712016381578e-29 * x, rate2b = 5.951031031739514e-26 - rate2a,
      rate2c = x * rate2b, rate2d = rate2c - 3.54582265641146e-23, rate2e = x * rate2d,
      rate2f = rate2e + 1.7793582784901146e-20, rate2g = x * rate2f,
      rate2h = rate2g - 7.398571721961897e-18, rate2i = x * rate2h,
      rate2j = rate2i + 2.499073114973796e-15, rate2k = x * rate2j,
      rate2l = rate2k - 6.691268265342339e-13, rate2m = x * rate2l,
      rate2n = rate2m + 1.376489471727567e-10, rate2o = x * rate2n,
      rate2p = rate2o - 2.08767569878681e-08, rate2q = x * rate2p,
      rate2r = rate2q + 2.204585537918871e-06, rate2s = x * rate2r,
      rate2t = rate2s - 0.00014880952380952382, rate2u = x * rate2t,
      rate2v = rate2u + 0.005555555555555556, rate2w = x * rate2v,
      rate2x = rate2w - 0.08333333333333333, rate2 = x < 9.0 ? rate2x : closed_rate2;
  const double rate3a = 2.9405903504764064e-30 * x, rate3b = 2.204085567310931e-27 - rate3a,
      rate3c = x * rate3b, rate3d = rate3c - 1.4183290625645841e-24, rate3e = x * rate3d,
      rate3f = rate3e + 7.736340341261368e-22, rate3g = x * rate3f,
      rate3h = rate3g - 3.523129391410427e-19, rate3i = x * rate3h,
      rate3j = rate3i + 1.3153016394598927e-16, rate3k = x * rate3j,
      rate3l = rate3k - 3.936040156083729e-14, rate3m = x * rate3l,
      rate3n = rate3m + 9.17659647818378e-12, rate3o = x * rate3n,
      rate3p = rate3o - 1.6059043836821615e-09, rate3q = x * rate3p,
      rate3r = rate3q + 2.0041686708353376e-07, rate3s = x * rate3r,
      rate3t = rate3s - 1.6534391534391536e-05, rate3u = x * rate3t,
      rate3v = rate3u + 0.0007936507936507937, rate3w = x * rate3v,
      rate3x = rate3w - 0.016666666666666666, rate3 = x < 9.0 ? rate3x : closed_rate3;
  const double beta_v_0 = s->m3 * g3;
  const double beta_v_1 = s->m4 * g3;
  const double beta_v_2 = s->m5 * g3;
  const double m_0 = s->m3 * beta_v_0;
  const double m_1 = s->m4 * beta_v_1;
  const double m_2 = s->m5 * beta_v_2;
  const double m_3 = s->m4 * beta_v_0;
  const double m_4 = s->m5 * beta_v_0;
  const double m_5 = s->m5 * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = s->m3 * g2, alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = s->m4 * g2, alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = s->m5 * g2, alpha_v_2 = -alpha_v_2a;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const double rate_turn = rate2 * rate_vw;
  const double rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const double rate_q_0a = s->m0 * g2, rate_q_0b = s->m3 * rate_turn,
      rate_q_0c = rate_q_0a + rate_q_0b, rate_q_0 = -rate_q_0c;
  const double rate_q_1a = s->m1 * g2, rate_q_1b = s->m4 * rate_turn,
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_1 = -rate_q_1c;
  const double rate_q_2a = s->m2 * g2, rate_q_2b = s->m5 * rate_turn,
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_2 = -rate_q_2c;
  const double rate_beta_v_0a = s->m0 * g3, rate_beta_v_0 = -rate_beta_v_0a;
  const double rate_beta_v_1a = s->m1 * g3, rate_beta_v_1 = -rate_beta_v_1a;
  const double rate_beta_v_2a = s->m2 * g3, rate_beta_v_2 = -rate_beta_v_2a;
  const double rate_bend_w_0a = s->m3 * rate_bend, rate_bend_w_0 = -rate_bend_w_0a;
  const double rate_bend_w_1a = s->m4 * rate_bend, rate_bend_w_1 = -rate_bend_w_1a;
  const double rate_bend_w_2a = s->m5 * rate_bend, rate_bend_w_2 = -rate_bend_w_2a;
  const double rate_symmetric_0a = s->m4 * rate_bend_w_0, rate_symmetric_0b = s->m3 * rate_beta_v_1,
      rate_symmetric_0c = s->m4 * rate_beta_v_0,
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d;
  const double rate_symmetric_1a = s->m5 * rate_bend_w_0, rate_symmetric_1b = s->m3 * rate_beta_v_2,
      rate_symmetric_1c = s->m5 * rate_beta_v_0,
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d;
  const double rate_symmetric_2a = s->m5 * rate_bend_w_1, rate_symmetric_2b = s->m4 * rate_beta_v_2,
      rate_symmetric_2c = s->m5 * rate_beta_v_1,
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d;
  const double rate_diagonal_0a = 2.0 * s->m4, rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1,
      rate_diagonal_0c = 2.0 * s->m5, rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2,
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = s->m4 * rate_bend_w_1, rate_diagonal_0g = s->m5 * rate_bend_w_2,
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const double rate_diagonal_1a = 2.0 * s->m3, rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0,
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = s->m3 * rate_bend_w_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π but 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   93 mul, 106 add, 5 div, 1 sqrt, 1 sin, 1 cos, 7 neg, 4 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3_leftJacobianInverse(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double size_0 = fabs(s->m3);
  const double size_1 = fabs(s->m4);
  const double size_2 = fabs(s->m5);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = s->m3 + grid;
  const double shifted_1 = s->m4 + grid;
  const double shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0;
  const double low_1 = s->m4 - high_1;
  const double low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0;
  const double sum_1 = s->m4 + high_1;
  const double sum_2 = s->m5 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent_a = 0.5 * theta, half_cotangent = half_cotangent_a * cotangent;
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_a = 1.455172475614865e-27 * x, b_b = b_a + 5.744790668872202e-26, b_c = x * b_b,
      b_d = b_c + 2.267952452337683e-24, b_e = x * b_d, b_f = b_e + 8.953517427037546e-23,
      b_g = x * b_f, b_h = b_g + 3.534707039629467e-21, b_i = x * b_h,
      b_j = b_i + 1.3954464685812522e-19, b_k = x * b_j, b_l = b_k + 5.5090028283602295e-18,
      b_m = x * b_l, b_n = b_m + 2.174868698558062e-16, b_o = x * b_n,
      b_p = b_o + 8.586062056277845e-15, b_q = x * b_p, b_r = b_q + 3.3896802963225827e-13,
      b_s = x * b_r, b_t = b_s + 1.3382536530684679e-11, b_u = x * b_t,
      b_v = b_u + 5.284190138687493e-10, b_w = x * b_v, b_x = b_w + 2.08767569878681e-08,
      b_y = x * b_x, b_z = b_y + 8.267195767195768e-07, b_aa = x * b_z,
      b_ab = b_aa + 3.306878306878307e-05, b_ac = x * b_ab, b_ad = b_ac + 0.001388888888888889,
      b_ae = x * b_ad, b_af = b_ae + 0.08333333333333333, b = x < 4.0 ? b_af : closed_b;
  const double b_across_a = x * b, b_across_b = 1.0 - b_across_a,
      b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = s->m3 * b;
  const double beta_v_1 = s->m4 * b;
  const double beta_v_2 = s->m5 * b;
  const double m_0 = s->m3 * beta_v_0;
  const double m_1 = s->m4 * beta_v_1;
  const double m_2 = s->m5 * beta_v_2;
  const double m_3 = s->m4 * beta_v_0;
  const double m_4 = s->m5 * beta_v_0;
  const double m_5 = s->m5 * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = 0.5 * s->m3, alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = 0.5 * s->m4, alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = 0.5 * s->m5, alpha_v_2 = -alpha_v_2a;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double b_rate_across_a = 2.0 - half_cotangent, b_rate_across = b_rate_across_a / b_divisor;
  const double b_rate_square_a = cotangent * cotangent, b_rate_square_b = 0.25 * b_rate_square_a,
      b_rate_square = 0.25 + b_rate_square_b;
  const double b_rate_rest = b_rate_square - b_rate_across;
  const double closed_b_rate = b_rate_rest / b_divisor;
  const double b_rate_a = 3.3612243325542163e-29 * x, b_rate_b = b_rate_a + 1.2532382798262054e-27,
      b_rate_c = x * b_rate_b, b_rate_d = b_rate_c + 4.656551921967568e-26, b_rate_e = x * b_rate_d,
      b_rate_f = b_rate_e + 1.7234372006616606e-24, b_rate_g = x * b_rate_f,
      b_rate_h = b_rate_g + 6.350266866545513e-23, b_rate_i = x * b_rate_h,
      b_rate_j = b_rate_i + 2.327914531029762e-21, b_rate_k = x * b_rate_j,
      b_rate_l = b_rate_k + 8.483296895110721e-20, b_rate_m = x * b_rate_l,
      b_rate_n = b_rate_m + 3.069982230878755e-18, b_rate_o = x * b_rate_n,
      b_rate_p = b_rate_o + 1.1018005656720459e-16, b_rate_q = x * b_rate_p,
      b_rate_r = b_rate_q + 3.914763657404511e-15, b_rate_s = x * b_rate_r,
      b_rate_t = b_rate_s + 1.3737699290044552e-13, b_rate_u = x * b_rate_t,
      b_rate_v = b_rate_u + 4.745552414851616e-12, b_rate_w = x * b_rate_v,
      b_rate_x = b_rate_w + 1.6059043836821613e-10, b_rate_y = x * b_rate_x,
      b_rate_z = b_rate_y + 5.2841901386874934e-09, b_rate_aa = x * b_rate_z,
      b_rate_ab = b_rate_aa + 1.670140559029448e-07, b_rate_ac = x * b_rate_ab,
      b_rate_ad = b_rate_ac + 4.96031746031746e-06, b_rate_ae = x * b_rate_ad,
      b_rate_af = b_rate_ae + 0.00013227513227513228, b_rate_ag = x * b_rate_af,
      b_rate_ah = b_rate_ag + 0.002777777777777778, b_rate = x < 4.0 ? b_rate_ah : closed_b_rate;
  const double rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const double rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const double rate_q_0a = 0.5 * s->m0, rate_q_0 = -rate_q_0a;
  const double rate_q_1a = 0.5 * s->m1, rate_q_1 = -rate_q_1a;
  const double rate_q_2a = 0.5 * s->m2, rate_q_2 = -rate_q_2a;
  const double rate_beta_v_0 = s->m0 * b;
  const double rate_beta_v_1 = s->m1 * b;
  const double rate_beta_v_2 = s->m2 * b;
  const double rate_bend_w_0 = s->m3 * rate_bend;
  const double rate_bend_w_1 = s->m4 * rate_bend;
  const double rate_bend_w_2 = s->m5 * rate_bend;
  const double rate_symmetric_0a = s->m3 * rate_beta_v_1, rate_symmetric_0b = s->m4 * rate_beta_v_0,
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = s->m4 * rate_bend_w_0,
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const double rate_symmetric_1a = s->m3 * rate_beta_v_2, rate_symmetric_1b = s->m5 * rate_beta_v_0,
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = s->m5 * rate_bend_w_0,
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const double rate_symmetric_2a = s->m4 * rate_beta_v_2, rate_symmetric_2b = s->m5 * rate_beta_v_1,
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = s->m5 * rate_bend_w_1,
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const double rate_diagonal_0a = s->m4 * rate_bend_w_1, rate_diagonal_0b = s->m5 * rate_bend_w_2,
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0 * s->m4,
      rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1, rate_diagonal_0f = 2.0 * s->m5,
      rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2,
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const double rate_diagonal_1a = s->m3 * rate_bend_w_0,
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0 * s->m3,
      rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π but 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   93 mul, 106 add, 5 div, 1 sqrt, 1 sin, 1 cos, 7 neg, 4 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3_rightJacobianInverse(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double size_0 = fabs(s->m3);
  const double size_1 = fabs(s->m4);
  const double size_2 = fabs(s->m5);
  const double sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const double grid = sizes * 268435456.0;
  const double shifted_0 = s->m3 + grid;
  const double shifted_1 = s->m4 + grid;
  const double shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid;
  const double high_1 = shifted_1 - grid;
  const double high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0;
  const double low_1 = s->m4 - high_1;
  const double low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0;
  const double sum_1 = s->m4 + high_1;
  const double sum_2 = s->m5 + high_2;
  const double squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const double cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const double exact_a = theta_high * theta_high, exact = squares - exact_a;
  const double residual = cross_rest + exact;
  const double small_a = 0.5 * residual, small = small_a / theta;
  const double delta_a = fabs(small), delta = delta_a < 0.0078125 ? small : 0.0;
  const double far_sine_a = sin(theta), far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine_a = cos(theta), far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const double cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent_a = 0.5 * theta, half_cotangent = half_cotangent_a * cotangent;
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_a = 1.455172475614865e-27 * x, b_b = b_a + 5.744790668872202e-26, b_c = x * b_b,
      b_d = b_c + 2.267952452337683e-24, b_e = x * b_d, b_f = b_e + 8.953517427037546e-23,
      b_g = x * b_f, b_h = b_g + 3.534707039629467e-21, b_i = x * b_h,
      b_j = b_i + 1.3954464685812522e-19, b_k = x * b_j, b_l = b_k + 5.5090028283602295e-18,
      b_m = x * b_l, b_n = b_m + 2.174868698558062e-16, b_o = x * b_n,
      b_p = b_o + 8.586062056277845e-15, b_q = x * b_p, b_r = b_q + 3.3896802963225827e-13,
      b_s = x * b_r, b_t = b_s + 1.3382536530684679e-11, b_u = x * b_t,
      b_v = b_u + 5.284190138687493e-10, b_w = x * b_v, b_x = b_w + 2.08767569878681e-08,
      b_y = x * b_x, b_z = b_y + 8.267195767195768e-07, b_aa = x * b_z,
      b_ab = b_aa + 3.306878306878307e-05, b_ac = x * b_ab, b_ad = b_ac + 0.001388888888888889,
      b_ae = x * b_ad, b_af = b_ae + 0.08333333333333333, b = x < 4.0 ? b_af : closed_b;
  const double b_across_a = x * b, b_across_b = 1.0 - b_across_a,
      b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = s->m3 * b;
  const double beta_v_1 = s->m4 * b;
  const double beta_v_2 = s->m5 * b;
  const double m_0 = s->m3 * beta_v_0;
  const double m_1 = s->m4 * beta_v_1;
  const double m_2 = s->m5 * beta_v_2;
  const double m_3 = s->m4 * beta_v_0;
  const double m_4 = s->m5 * beta_v_0;
  const double m_5 = s->m5 * beta_v_1;
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = 0.5 * s->m3;
  const double alpha_v_1 = 0.5 * s->m4;
  const double alpha_v_2 = 0.5 * s->m5;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double b_rate_across_a = 2.0 - half_cotangent, b_rate_across = b_rate_across_a / b_divisor;
  const double b_rate_square_a = cotangent * cotangent, b_rate_square_b = 0.25 * b_rate_square_a,
      b_rate_square = 0.25 + b_rate_square_b;
  const double b_rate_rest = b_rate_square - b_rate_across;
  const double closed_b_rate = b_rate_rest / b_divisor;
  const double b_rate_a = 3.3612243325542163e-29 * x, b_rate_b = b_rate_a + 1.2532382798262054e-27,
      b_rate_c = x * b_rate_b, b_rate_d = b_rate_c + 4.656551921967568e-26, b_rate_e = x * b_rate_d,
      b_rate_f = b_rate_e + 1.7234372006616606e-24, b_rate_g = x * b_rate_f,
      b_rate_h = b_rate_g + 6.350266866545513e-23, b_rate_i = x * b_rate_h,
      b_rate_j = b_rate_i + 2.327914531029762e-21, b_rate_k = x * b_rate_j,
      b_rate_l = b_rate_k + 8.483296895110721e-20, b_rate_m = x * b_rate_l,
      b_rate_n = b_rate_m + 3.069982230878755e-18, b_rate_o = x * b_rate_n,
      b_rate_p = b_rate_o + 1.1018005656720459e-16, b_rate_q = x * b_rate_p,
      b_rate_r = b_rate_q + 3.914763657404511e-15, b_rate_s = x * b_rate_r,
      b_rate_t = b_rate_s + 1.3737699290044552e-13, b_rate_u = x * b_rate_t,
      b_rate_v = b_rate_u + 4.745552414851616e-12, b_rate_w = x * b_rate_v,
      b_rate_x = b_rate_w + 1.6059043836821613e-10, b_rate_y = x * b_rate_x,
      b_rate_z = b_rate_y + 5.2841901386874934e-09, b_rate_aa = x * b_rate_z,
      b_rate_ab = b_rate_aa + 1.670140559029448e-07, b_rate_ac = x * b_rate_ab,
      b_rate_ad = b_rate_ac + 4.96031746031746e-06, b_rate_ae = x * b_rate_ad,
      b_rate_af = b_rate_ae + 0.00013227513227513228, b_rate_ag = x * b_rate_af,
      b_rate_ah = b_rate_ag + 0.002777777777777778, b_rate = x < 4.0 ? b_rate_ah : closed_b_rate;
  const double rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const double rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const double rate_q_0 = 0.5 * s->m0;
  const double rate_q_1 = 0.5 * s->m1;
  const double rate_q_2 = 0.5 * s->m2;
  const double rate_beta_v_0a = s->m0 * b, rate_beta_v_0 = -rate_beta_v_0a;
  const double rate_beta_v_1a = s->m1 * b, rate_beta_v_1 = -rate_beta_v_1a;
  const double rate_beta_v_2a = s->m2 * b, rate_beta_v_2 = -rate_beta_v_2a;
  const double rate_bend_w_0a = s->m3 * rate_bend, rate_bend_w_0 = -rate_bend_w_0a;
  const double rate_bend_w_1a = s->m4 * rate_bend, rate_bend_w_1 = -rate_bend_w_1a;
  const double rate_bend_w_2a = s->m5 * rate_bend, rate_bend_w_2 = -rate_bend_w_2a;
  const double rate_symmetric_0a = s->m4 * rate_bend_w_0, rate_symmetric_0b = s->m3 * rate_beta_v_1,
      rate_symmetric_0c = s->m4 * rate_beta_v_0,
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d;
  const double rate_symmetric_1a = s->m5 * rate_bend_w_0, rate_symmetric_1b = s->m3 * rate_beta_v_2,
      rate_symmetric_1c = s->m5 * rate_beta_v_0,
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d;
  const double rate_symmetric_2a = s->m5 * rate_bend_w_1, rate_symmetric_2b = s->m4 * rate_beta_v_2,
      rate_symmetric_2c = s->m5 * rate_beta_v_1,
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d;
  const double rate_diagonal_0a = 2.0 * s->m4, rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1,
      rate_diagonal_0c = 2.0 * s->m5, rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2,
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = s->m4 * rate_bend_w_1, rate_diagonal_0g = s->m5 * rate_bend_w_2,
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const double rate_diagonal_1a = 2.0 * s->m3, rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0,
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = s->m3 * rate_bend_w_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   208 mul, 192 add, 7 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 5 neg, 7 abs, 20 less, 1 equal, 42
     select.
   Error <= R: 12 u, t: 20 u of its largest component, or of D1.t or D2.t if that is larger for
     D1 a rotation and D2 a rotation and 0 <= k <= 1; searched, not proved. */
static inline void ksl_SE3_interpolated(const ksl_SE3_t *D1, const ksl_SE3_t *D2, const double k,
    ksl_SE3_t *Do) {
  const double apart_0 = D2->m03 - D1->m03;
  const double apart_1 = D2->m13 - D1->m13;
  const double apart_2 = D2->m23 - D1->m23;
  const double between_0a = D1->m00 * D2->m00, between_0b = D1->m10 * D2->m10,
      between_0c = between_0a + between_0b, between_0d = D1->m20 * D2->m20,
      between_0 = between_0c + between_0d;
  const double between_1a = D1->m00 * D2->m01, between_1b = D1->m10 * D2->m11,
      between_1c = between_1a + between_1b, between_1d = D1->m20 * D2->m21,
      between_1 = between_1c + between_1d;
  const double between_2a = D1->m00 * D2->m02, between_2b = D1->m10 * D2->m12,
      between_2c = between_2a + between_2b, between_2d = D1->m20 * D2->m22,
      between_2 = between_2c + between_2d;
  const double between_3a = D1->m00 * apart_0, between_3b = D1->m10 * apart_1,
      between_3c = between_3a + between_3b, between_3d = D1->m20 * apart_2,
      between_3 = between_3c + between_3d;
  const double between_4a = D1->m01 * D2->m00, between_4b = D1->m11 * D2->m10,
      between_4c = between_4a + between_4b, between_4d = D1->m21 * D2->m20,
      between_4 = between_4c + between_4d;
  const double between_5a = D1->m01 * D2->m01, between_5b = D1->m11 * D2->m11,
      between_5c = between_5a + between_5b, between_5d = D1->m21 * D2->m21,
      between_5 = between_5c + between_5d;
  const double between_6a = D1->m01 * D2->m02, between_6b = D1->m11 * D2->m12,
      between_6c = between_6a + between_6b, between_6d = D1->m21 * D2->m22,
      between_6 = between_6c + between_6d;
  const double between_7a = D1->m01 * apart_0, between_7b = D1->m11 * apart_1,
      between_7c = between_7a + between_7b, between_7d = D1->m21 * apart_2,
      between_7 = between_7c + between_7d;
  const double between_8a = D1->m02 * D2->m00, between_8b = D1->m12 * D2->m10,
      between_8c = between_8a + between_8b, between_8d = D1->m22 * D2->m20,
      between_8 = between_8c + between_8d;
  const double between_9a = D1->m02 * D2->m01, between_9b = D1->m12 * D2->m11,
      between_9c = between_9a + between_9b, between_9d = D1->m22 * D2->m21,
      between_9 = between_9c + between_9d;
  const double between_10a = D1->m02 * D2->m02, between_10b = D1->m12 * D2->m12,
      between_10c = between_10a + between_10b, between_10d = D1->m22 * D2->m22,
      between_10 = between_10c + between_10d;
  const double between_11a = D1->m02 * apart_0, between_11b = D1->m12 * apart_1,
      between_11c = between_11a + between_11b, between_11d = D1->m22 * apart_2,
      between_11 = between_11c + between_11d;
  const double log_p_0 = between_9 - between_6;
  const double log_p_1 = between_2 - between_8;
  const double log_p_2 = between_4 - between_1;
  const double log_s_0 = between_6 + between_9;
  const double log_s_1 = between_2 + between_8;
  const double log_s_2 = between_1 + between_4;
  const double log_first_0 = between_0 + 1.0;
  const double log_first_1 = 1.0 - between_0;
  const double log_others_0 = between_5 + between_10;
  const double log_others_1 = between_5 - between_10;
  const double log_d_0 = log_first_0 + log_others_0;
  const double log_d_1 = log_first_0 - log_others_0;
  const double log_d_2 = log_first_1 + log_others_1;
  const double log_d_3 = log_first_1 - log_others_1;
  const double log_low_0 = between_5 < between_0 ? log_d_1 : log_s_2;
  const double log_low_1 = between_5 < between_0 ? log_s_2 : log_d_2;
  const double log_low_2 = between_5 < between_0 ? log_s_1 : log_s_0;
  const double log_low_3 = between_5 < between_0 ? log_p_0 : log_p_1;
  const double log_high_0a = -between_5, log_high_0 = between_0 < log_high_0a ? log_s_1 : log_p_0;
  const double log_high_1 = between_0 < log_high_0a ? log_s_0 : log_p_1;
  const double log_high_2 = between_0 < log_high_0a ? log_d_3 : log_p_2;
  const double log_high_3 = between_0 < log_high_0a ? log_p_2 : log_d_0;
  const double log_column_0 = between_10 < 0.0 ? log_low_0 : log_high_0;
  const double log_column_1 = between_10 < 0.0 ? log_low_1 : log_high_1;
  const double log_column_2 = between_10 < 0.0 ? log_low_2 : log_high_2;
  const double log_column_3 = between_10 < 0.0 ? log_low_3 : log_high_3;
  const double log_upper_0a = -log_column_0,
      log_upper_0 = log_column_3 < 0.0 ? log_upper_0a : log_column_0;
  const double log_upper_1a = -log_column_1,
      log_upper_1 = log_column_3 < 0.0 ? log_upper_1a : log_column_1;
  const double log_upper_2a = -log_column_2,
      log_upper_2 = log_column_3 < 0.0 ? log_upper_2a : log_column_2;
  const double log_upper_3a = -log_column_3,
      log_upper_3 = log_column_3 < 0.0 ? log_upper_3a : log_column_3;
  const double log_v_s_size_0 = fabs(log_upper_0);
  const double log_v_s_size_1 = fabs(log_upper_1);
  const double log_v_s_size_2 = fabs(log_upper_2);
  const double log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const double log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2 : log_v_s_largest1;
  const double log_v_s_b = 6.703903964971299e+153 < log_v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      log_v_s_d = log_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : log_v_s_d;
  const double log_v_y_0 = log_upper_0 * log_v_s;
  const double log_v_y_1 = log_upper_1 * log_v_s;
  const double log_v_y_2 = log_upper_2 * log_v_s;
  const double log_v_n_a = log_v_y_0 * log_v_y_0, log_v_n_b = log_v_y_1 * log_v_y_1,
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_d = log_v_y_2 * log_v_y_2,
      log_v_n_e = log_v_n_c + log_v_n_d, log_v_n = sqrt(log_v_n_e);
  const double log_v_r_b = log_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 7.637340908749012e-152 : log_v_r_b,
      log_v_r = 1.3093562431584567e+151 < log_v_s ? 9.332636185032189e-302 : log_v_r_d;
  const double log_n = log_v_n * log_v_r;
  const double log_half = atan2(log_n, log_upper_3);
  const double log_divisor = log_n == 0.0 ? 1.0 : log_n;
  const double log_theta = 2.0 * log_half;
  const double log_k = log_theta / log_divisor;
  const double log_vector_0 = log_upper_0 * log_k;
  const double log_vector_1 = log_upper_1 * log_k;
  const double log_vector_2 = log_upper_2 * log_k;
  const double log_x = log_theta * log_theta;
  const double log_far_sine = log_x < 1.0 ? 1.0 : log_n;
  const double log_cotangent = log_upper_3 / log_far_sine;
  const double log_half_cotangent_a = 0.5 * log_theta,
      log_half_cotangent = log_half_cotangent_a * log_cotangent;
  const double log_b_rest = 1.0 - log_half_cotangent;
  const double log_b_divisor = log_x < 4.0 ? 4.0 : log_x;
  const double log_closed_b = log_b_rest / log_b_divisor;
  const double log_b_a = 1.455172475614865e-27 * log_x, log_b_b = log_b_a + 5.744790668872202e-26,
      log_b_c = log_x * log_b_b, log_b_d = log_b_c + 2.267952452337683e-24,
      log_b_e = log_x * log_b_d, log_b_f = log_b_e + 8.953517427037546e-23,
      log_b_g = log_x * log_b_f, log_b_h = log_b_g + 3.534707039629467e-21,
      log_b_i = log_x * log_b_h, log_b_j = log_b_i + 1.3954464685812522e-19,
      log_b_k = log_x * log_b_j, log_b_l = log_b_k + 5.5090028283602295e-18,
      log_b_m = log_x * log_b_l, log_b_n = log_b_m + 2.174868698558062e-16,
      log_b_o = log_x * log_b_n, log_b_p = log_b_o + 8.586062056277845e-15,
      log_b_q = log_x * log_b_p, log_b_r = log_b_q + 3.3896802963225827e-13,
      log_b_s = log_x * log_b_r, log_b_t = log_b_s + 1.3382536530684679e-11,
      log_b_u = log_x * log_b_t, log_b_v = log_b_u + 5.284190138687493e-10,
      log_b_w = log_x * log_b_v, log_b_x = log_b_w + 2.08767569878681e-08,
      log_b_y = log_x * log_b_x, log_b_z = log_b_y + 8.267195767195768e-07,
      log_b_aa = log_x * log_b_z, log_b_ab = log_b_aa + 3.306878306878307e-05,
      log_b_ac = log_x * log_b_ab, log_b_ad = log_b_ac + 0.001388888888888889,
      log_b_ae = log_x * log_b_ad, log_b_af = log_b_ae + 0.08333333333333333,
      log_b = log_x < 4.0 ? log_b_af : log_closed_b;
  const double log_b_across_a = log_x * log_b, log_b_across_b = 1.0 - log_b_across_a,
      log_b_across = log_x < 4.0 ? log_b_across_b : log_half_cotangent;
  const double log_wt_a = between_3 * log_vector_0, log_wt_b = between_7 * log_vector_1,
      log_wt_c = log_wt_a + log_wt_b, log_wt_d = between_11 * log_vector_2,
      log_wt = log_wt_c + log_wt_d;
  const double log_pitch = log_b * log_wt;
  const double log_along_0 = log_vector_0 * log_pitch;
  const double log_along_1 = log_vector_1 * log_pitch;
  const double log_along_2 = log_vector_2 * log_pitch;
  const double log_u_0a = between_11 * log_vector_1, log_u_0b = between_7 * log_vector_2,
      log_u_0 = log_u_0a - log_u_0b;
  const double log_u_1a = between_3 * log_vector_2, log_u_1b = between_11 * log_vector_0,
      log_u_1 = log_u_1a - log_u_1b;
  const double log_u_2a = between_7 * log_vector_0, log_u_2b = between_3 * log_vector_1,
      log_u_2 = log_u_2a - log_u_2b;
  const double log_turned_0 = 0.5 * log_u_0;
  const double log_turned_1 = 0.5 * log_u_1;
  const double log_turned_2 = 0.5 * log_u_2;
  const double log_across_axis_0 = log_along_0 - log_turned_0;
  const double log_across_axis_1 = log_along_1 - log_turned_1;
  const double log_across_axis_2 = log_along_2 - log_turned_2;
  const double whole_0a = between_3 * log_b_across, whole_0 = whole_0a + log_across_axis_0;
  const double whole_1a = between_7 * log_b_across, whole_1 = whole_1a + log_across_axis_1;
  const double whole_2a = between_11 * log_b_across, whole_2 = whole_2a + log_across_axis_2;
  const double screw_0 = k * whole_0;
  const double screw_1 = k * whole_1;
  const double screw_2 = k * whole_2;
  const double screw_3 = k * log_vector_0;
  const double screw_4 = k * log_vector_1;
  const double screw_5 = k * log_vector_2;
  const double exp_size_0 = fabs(screw_3);
  const double exp_size_1 = fabs(screw_4);
  const double exp_size_2 = fabs(screw_5);
  const double exp_sizes_a = exp_size_0 + exp_size_1, exp_sizes = exp_sizes_a + exp_size_2;
  const double exp_grid = exp_sizes * 268435456.0;
  const double exp_shifted_0 = screw_3 + exp_grid;
  const double exp_shifted_1 = screw_4 + exp_grid;
  const double exp_shifted_2 = screw_5 + exp_grid;
  const double exp_high_0 = exp_shifted_0 - exp_grid;
  const double exp_high_1 = exp_shifted_1 - exp_grid;
  const double exp_high_2 = exp_shifted_2 - exp_grid;
  const double exp_low_0 = screw_3 - exp_high_0;
  const double exp_low_1 = screw_4 - exp_high_1;
  const double exp_low_2 = screw_5 - exp_high_2;
  const double exp_sum_0 = screw_3 + exp_high_0;
  const double exp_sum_1 = screw_4 + exp_high_1;
  const double exp_sum_2 = screw_5 + exp_high_2;
  const double exp_squares_a = exp_high_0 * exp_high_0, exp_squares_b = exp_high_1 * exp_high_1,
      exp_squares_c = exp_squares_a + exp_squares_b, exp_squares_d = exp_high_2 * exp_high_2,
      exp_squares = exp_squares_c + exp_squares_d;
  const double exp_cross_a = exp_low_0 * exp_sum_0, exp_cross_b = exp_low_1 * exp_sum_1,
      exp_cross_c = exp_cross_a + exp_cross_b, exp_cross_d = exp_low_2 * exp_sum_2,
      exp_cross = exp_cross_c + exp_cross_d;
  const double exp_x = exp_squares + exp_cross;
  const double exp_theta_a = sqrt(exp_x), exp_theta = exp_x < 1.0 ? 1.0 : exp_theta_a;
  const double exp_theta_shifted = exp_grid + exp_theta;
  const double exp_theta_high = exp_theta_shifted - exp_grid;
  const double exp_theta_low = exp_theta - exp_theta_high;
  const double exp_theta_sum = exp_theta + exp_theta_high;
  const double exp_cross_rest_a = exp_theta_low * exp_theta_sum,
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const double exp_exact_a = exp_theta_high * exp_theta_high, exp_exact = exp_squares - exp_exact_a;
  const double exp_residual = exp_cross_rest + exp_exact;
  const double exp_small_a = 0.5 * exp_residual, exp_small = exp_small_a / exp_theta;
  const double exp_delta_a = fabs(exp_small), exp_delta = exp_delta_a < 0.0078125 ? exp_small : 0.0;
  const double exp_far_sine_a = sin(exp_theta), exp_far_sine = exp_x < 1.0 ? 1.0 : exp_far_sine_a;
  const double exp_far_cosine_a = cos(exp_theta),
      exp_far_cosine = exp_x < 1.0 ? 0.0 : exp_far_cosine_a;
  const double exp_sine_a = exp_delta * exp_far_cosine, exp_sine = exp_sine_a + exp_far_sine;
  const double exp_cosine_a = exp_delta * exp_far_sine, exp_cosine = exp_far_cosine - exp_cosine_a;
  const double exp_far_x = exp_x < 1.0 ? 1.0 : exp_x;
  const double exp_middle_x = exp_x < 4.0 ? 4.0 : exp_x;
  const double exp_closed1 = exp_sine / exp_theta;
  const double exp_versine = 1.0 - exp_cosine;
  const double exp_closed2 = exp_versine / exp_far_x;
  const double exp_rest3 = 1.0 - exp_closed1;
  const double exp_closed3 = exp_rest3 / exp_middle_x;
  const double exp_g1a = 6.446950284384474e-26 * exp_x, exp_g1b = exp_g1a - 3.868170170630684e-23,
      exp_g1c = exp_x * exp_g1b, exp_g1d = exp_g1c + 1.9572941063391263e-20,
      exp_g1e = exp_x * exp_g1d, exp_g1f = exp_g1e - 8.22063524662433e-18,
      exp_g1g = exp_x * exp_g1f, exp_g1h = exp_g1g + 2.8114572543455206e-15,
      exp_g1i = exp_x * exp_g1h, exp_g1j = exp_g1i - 7.647163731819816e-13,
      exp_g1k = exp_x * exp_g1j, exp_g1l = exp_g1k + 1.6059043836821613e-10,
      exp_g1m = exp_x * exp_g1l, exp_g1n = exp_g1m - 2.505210838544172e-08,
      exp_g1o = exp_x * exp_g1n, exp_g1p = exp_g1o + 2.7557319223985893e-06,
      exp_g1q = exp_x * exp_g1p, exp_g1r = exp_g1q - 0.0001984126984126984,
      exp_g1s = exp_x * exp_g1r, exp_g1t = exp_g1s + 0.008333333333333333,
      exp_g1u = exp_x * exp_g1t, exp_g1v = exp_g1u - 0.16666666666666666, exp_g1w = exp_x * exp_g1v,
      exp_g1x = exp_g1w + 1.0, exp_g1 = exp_x < 1.0 ? exp_g1x : exp_closed1;
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
      exp_g2w = exp_x * exp_g2v, exp_g2x = exp_g2w + 0.5,
      exp_g2 = exp_x < 1.0 ? exp_g2x : exp_closed2;
  const double exp_g3a = 9.183689863795546e-29 * exp_x, exp_g3b = exp_g3a - 6.446950284384474e-26,
      exp_g3c = exp_x * exp_g3b, exp_g3d = exp_g3c + 3.868170170630684e-23,
      exp_g3e = exp_x * exp_g3d, exp_g3f = exp_g3e - 1.9572941063391263e-20,
      exp_g3g = exp_x * exp_g3f, exp_g3h = exp_g3g + 8.22063524662433e-18,
      exp_g3i = exp_x * exp_g3h, exp_g3j = exp_g3i - 2.8114572543455206e-15,
      exp_g3k = exp_x * exp_g3j, exp_g3l = exp_g3k + 7.647163731819816e-13,
      exp_g3m = exp_x * exp_g3l, exp_g3n = exp_g3m - 1.6059043836821613e-10,
      exp_g3o = exp_x * exp_g3n, exp_g3p = exp_g3o + 2.505210838544172e-08,
      exp_g3q = exp_x * exp_g3p, exp_g3r = exp_g3q - 2.7557319223985893e-06,
      exp_g3s = exp_x * exp_g3r, exp_g3t = exp_g3s + 0.0001984126984126984,
      exp_g3u = exp_x * exp_g3t, exp_g3v = exp_g3u - 0.008333333333333333,
      exp_g3w = exp_x * exp_g3v, exp_g3x = exp_g3w + 0.16666666666666666,
      exp_g3 = exp_x < 4.0 ? exp_g3x : exp_closed3;
  const double exp_g0a = exp_x * exp_g2, exp_g0b = 1.0 - exp_g0a,
      exp_g0 = exp_x < 1.0 ? exp_g0b : exp_cosine;
  const double exp_u_0a = screw_2 * screw_4, exp_u_0b = screw_1 * screw_5,
      exp_u_0 = exp_u_0a - exp_u_0b;
  const double exp_u_1a = screw_0 * screw_5, exp_u_1b = screw_2 * screw_3,
      exp_u_1 = exp_u_1a - exp_u_1b;
  const double exp_u_2a = screw_1 * screw_3, exp_u_2b = screw_0 * screw_4,
      exp_u_2 = exp_u_2a - exp_u_2b;
  const double exp_turned_0 = exp_g2 * exp_u_0;
  const double exp_turned_1 = exp_g2 * exp_u_1;
  const double exp_turned_2 = exp_g2 * exp_u_2;
  const double exp_wv_a = screw_0 * screw_3, exp_wv_b = screw_1 * screw_4,
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_d = screw_2 * screw_5, exp_wv = exp_wv_c + exp_wv_d;
  const double exp_pitch = exp_g3 * exp_wv;
  const double exp_along_0 = screw_3 * exp_pitch;
  const double exp_along_1 = screw_4 * exp_pitch;
  const double exp_along_2 = screw_5 * exp_pitch;
  const double exp_beta_v_0 = screw_3 * exp_g2;
  const double exp_beta_v_1 = screw_4 * exp_g2;
  const double exp_beta_v_2 = screw_5 * exp_g2;
  const double exp_m_0 = screw_3 * exp_beta_v_0;
  const double exp_m_1 = screw_4 * exp_beta_v_1;
  const double exp_m_2 = screw_5 * exp_beta_v_2;
  const double exp_m_3 = screw_4 * exp_beta_v_0;
  const double exp_m_4 = screw_5 * exp_beta_v_0;
  const double exp_m_5 = screw_5 * exp_beta_v_1;
  const double exp_others_0 = exp_m_1 + exp_m_2;
  const double exp_others_1 = exp_m_0 + exp_m_2;
  const double exp_others_2 = exp_m_0 + exp_m_1;
  const double exp_diagonal0a = 1.0 - exp_others_0, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0 = exp_m_0 < exp_others_0 ? exp_diagonal0b : exp_diagonal0a;
  const double exp_diagonal1a = 1.0 - exp_others_1, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1 = exp_m_1 < exp_others_1 ? exp_diagonal1b : exp_diagonal1a;
  const double exp_diagonal2a = 1.0 - exp_others_2, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2 = exp_m_2 < exp_others_2 ? exp_diagonal2b : exp_diagonal2a;
  const double exp_alpha_v_0 = screw_3 * exp_g1;
  const double exp_alpha_v_1 = screw_4 * exp_g1;
  const double exp_alpha_v_2 = screw_5 * exp_g1;
  const double exp_across_axis_0 = exp_turned_0 + exp_along_0;
  const double exp_across_axis_1 = exp_turned_1 + exp_along_1;
  const double exp_across_axis_2 = exp_turned_2 + exp_along_2;
  const double step_1 = exp_m_3 - exp_alpha_v_2;
  const double step_2 = exp_m_4 + exp_alpha_v_1;
  const double step_3a = screw_0 * exp_g1, step_3 = step_3a + exp_across_axis_0;
  const double step_4 = exp_m_3 + exp_alpha_v_2;
  const double step_6 = exp_m_5 - exp_alpha_v_0;
  const double step_7a = screw_1 * exp_g1, step_7 = step_7a + exp_across_axis_1;
  const double step_8 = exp_m_4 - exp_alpha_v_1;
  const double step_9 = exp_m_5 + exp_alpha_v_0;
  const double step_11a = screw_2 * exp_g1, step_11 = step_11a + exp_across_axis_2;
  const double Do_00a = D1->m00 * exp_diagonal0, Do_00b = D1->m01 * step_4,
      Do_00c = D1->m02 * step_8, Do_00d = Do_00b + Do_00c, Do_00 = Do_00a + Do_00d;
  const double Do_01a = D1->m00 * step_1, Do_01b = D1->m02 * step_9, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m01 * exp_diagonal1, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D1->m00 * step_2, Do_02b = D1->m01 * step_6, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * exp_diagonal2, Do_02 = Do_02c + Do_02d;
  const double Do_03a = D1->m00 * step_3, Do_03b = D1->m01 * step_7, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * step_11, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const double Do_10a = D1->m10 * exp_diagonal0, Do_10b = D1->m11 * step_4,
      Do_10c = D1->m12 * step_8, Do_10d = Do_10b + Do_10c, Do_10 = Do_10a + Do_10d;
  const double Do_11a = D1->m10 * step_1, Do_11b = D1->m12 * step_9, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m11 * exp_diagonal1, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D1->m10 * step_2, Do_12b = D1->m11 * step_6, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * exp_diagonal2, Do_12 = Do_12c + Do_12d;
  const double Do_13a = D1->m10 * step_3, Do_13b = D1->m11 * step_7, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * step_11, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const double Do_20a = D1->m20 * exp_diagonal0, Do_20b = D1->m21 * step_4,
      Do_20c = D1->m22 * step_8, Do_20d = Do_20b + Do_20c, Do_20 = Do_20a + Do_20d;
  const double Do_21a = D1->m20 * step_1, Do_21b = D1->m22 * step_9, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m21 * exp_diagonal1, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D1->m20 * step_2, Do_22b = D1->m21 * step_6, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * exp_diagonal2, Do_22 = Do_22c + Do_22d;
  const double Do_23a = D1->m20 * step_3, Do_23b = D1->m21 * step_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * step_11, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   49 mul, 69 add, 3 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 5 less, 11 select.
   Error <= R: (5 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_expf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const float size_0 = fabsf(v->x);
  const float size_1 = fabsf(v->y);
  const float size_2 = fabsf(v->z);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = v->x + grid;
  const float shifted_1 = v->y + grid;
  const float shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0;
  const float low_1 = v->y - high_1;
  const float low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0;
  const float sum_1 = v->y + high_1;
  const float sum_2 = v->z + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g0a = x * g2, g0b = 1.0f - g0a, g0 = x < 1.0f ? g0b : cosine;
  const float beta_v_0 = v->x * g2;
  const float beta_v_1 = v->y * g2;
  const float beta_v_2 = v->z * g2;
  const float m_0 = v->x * beta_v_0;
  const float m_1 = v->y * beta_v_1;
  const float m_2 = v->z * beta_v_2;
  const float m_3 = v->y * beta_v_0;
  const float m_4 = v->z * beta_v_0;
  const float m_5 = v->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = v->x * g1;
  const float alpha_v_1 = v->y * g1;
  const float alpha_v_2 = v->z * g1;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* vo with exp vo~ = R, |vo| <= π; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; vo: vector.
   11 mul, 16 add, 1 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 25 select.
   Error <= vo: 6 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_logf(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo) {
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
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
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

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   60 mul, 81 add, 4 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 6 less, 12 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobianf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const float size_0 = fabsf(v->x);
  const float size_1 = fabsf(v->y);
  const float size_2 = fabsf(v->z);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = v->x + grid;
  const float shifted_1 = v->y + grid;
  const float shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0;
  const float low_1 = v->y - high_1;
  const float low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0;
  const float sum_1 = v->y + high_1;
  const float sum_2 = v->z + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3a = 9.18369e-29f * x, g3b = g3a - 6.4469503e-26f, g3c = x * g3b,
      g3d = g3c + 3.8681703e-23f, g3e = x * g3d, g3f = g3e - 1.9572942e-20f, g3g = x * g3f,
      g3h = g3g + 8.220635e-18f, g3i = x * g3h, g3j = g3i - 2.8114574e-15f, g3k = x * g3j,
      g3l = g3k + 7.6471636e-13f, g3m = x * g3l, g3n = g3m - 1.6059044e-10f, g3o = x * g3n,
      g3p = g3o + 2.5052108e-08f, g3q = x * g3p, g3r = g3q - 2.7557319e-06f, g3s = x * g3r,
      g3t = g3s + 0.0001984127f, g3u = x * g3t, g3v = g3u - 0.008333334f, g3w = x * g3v,
      g3x = g3w + 0.16666667f, g3 = x < 4.0f ? g3x : closed3;
  const float beta_v_0 = v->x * g3;
  const float beta_v_1 = v->y * g3;
  const float beta_v_2 = v->z * g3;
  const float m_0 = v->x * beta_v_0;
  const float m_1 = v->y * beta_v_1;
  const float m_2 = v->z * beta_v_2;
  const float m_3 = v->y * beta_v_0;
  const float m_4 = v->z * beta_v_0;
  const float m_5 = v->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = v->x * g2;
  const float alpha_v_1 = v->y * g2;
  const float alpha_v_2 = v->z * g2;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   60 mul, 81 add, 4 div, 1 sqrt, 1 sin, 1 cos, 3 neg, 4 abs, 6 less, 12 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobianf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const float size_0 = fabsf(v->x);
  const float size_1 = fabsf(v->y);
  const float size_2 = fabsf(v->z);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = v->x + grid;
  const float shifted_1 = v->y + grid;
  const float shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0;
  const float low_1 = v->y - high_1;
  const float low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0;
  const float sum_1 = v->y + high_1;
  const float sum_2 = v->z + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3a = 9.18369e-29f * x, g3b = g3a - 6.4469503e-26f, g3c = x * g3b,
      g3d = g3c + 3.8681703e-23f, g3e = x * g3d, g3f = g3e - 1.9572942e-20f, g3g = x * g3f,
      g3h = g3g + 8.220635e-18f, g3i = x * g3h, g3j = g3i - 2.8114574e-15f, g3k = x * g3j,
      g3l = g3k + 7.6471636e-13f, g3m = x * g3l, g3n = g3m - 1.6059044e-10f, g3o = x * g3n,
      g3p = g3o + 2.5052108e-08f, g3q = x * g3p, g3r = g3q - 2.7557319e-06f, g3s = x * g3r,
      g3t = g3s + 0.0001984127f, g3u = x * g3t, g3v = g3u - 0.008333334f, g3w = x * g3v,
      g3x = g3w + 0.16666667f, g3 = x < 4.0f ? g3x : closed3;
  const float beta_v_0 = v->x * g3;
  const float beta_v_1 = v->y * g3;
  const float beta_v_2 = v->z * g3;
  const float m_0 = v->x * beta_v_0;
  const float m_1 = v->y * beta_v_1;
  const float m_2 = v->z * beta_v_2;
  const float m_3 = v->y * beta_v_0;
  const float m_4 = v->z * beta_v_0;
  const float m_5 = v->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0a = v->x * g2, alpha_v_0 = -alpha_v_0a;
  const float alpha_v_1a = v->y * g2, alpha_v_1 = -alpha_v_1a;
  const float alpha_v_2a = v->z * g2, alpha_v_2 = -alpha_v_2a;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     but 0.
   v: vector; R: rotation or other 3×3 matrix.
   43 mul, 63 add, 3 div, 1 sqrt, 1 sin, 1 cos, 3 neg, 4 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_leftJacobianInversef(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const float size_0 = fabsf(v->x);
  const float size_1 = fabsf(v->y);
  const float size_2 = fabsf(v->z);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = v->x + grid;
  const float shifted_1 = v->y + grid;
  const float shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0;
  const float low_1 = v->y - high_1;
  const float low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0;
  const float sum_1 = v->y + high_1;
  const float sum_2 = v->z + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent_a = 0.5f * theta, half_cotangent = half_cotangent_a * cotangent;
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_a = 1.4551725e-27f * x, b_b = b_a + 5.744791e-26f, b_c = x * b_b,
      b_d = b_c + 2.2679524e-24f, b_e = x * b_d, b_f = b_e + 8.9535176e-23f, b_g = x * b_f,
      b_h = b_g + 3.534707e-21f, b_i = x * b_h, b_j = b_i + 1.3954465e-19f, b_k = x * b_j,
      b_l = b_k + 5.509003e-18f, b_m = x * b_l, b_n = b_m + 2.1748687e-16f, b_o = x * b_n,
      b_p = b_o + 8.586062e-15f, b_q = x * b_p, b_r = b_q + 3.3896803e-13f, b_s = x * b_r,
      b_t = b_s + 1.3382536e-11f, b_u = x * b_t, b_v = b_u + 5.2841903e-10f, b_w = x * b_v,
      b_x = b_w + 2.0876756e-08f, b_y = x * b_x, b_z = b_y + 8.267196e-07f, b_aa = x * b_z,
      b_ab = b_aa + 3.3068784e-05f, b_ac = x * b_ab, b_ad = b_ac + 0.0013888889f, b_ae = x * b_ad,
      b_af = b_ae + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_a = x * b, b_across_b = 1.0f - b_across_a,
      b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = v->x * b;
  const float beta_v_1 = v->y * b;
  const float beta_v_2 = v->z * b;
  const float m_0 = v->x * beta_v_0;
  const float m_1 = v->y * beta_v_1;
  const float m_2 = v->z * beta_v_2;
  const float m_3 = v->y * beta_v_0;
  const float m_4 = v->z * beta_v_0;
  const float m_5 = v->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0a = 0.5f * v->x, alpha_v_0 = -alpha_v_0a;
  const float alpha_v_1a = 0.5f * v->y, alpha_v_1 = -alpha_v_1a;
  const float alpha_v_2a = 0.5f * v->z, alpha_v_2 = -alpha_v_2a;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     but 0.
   v: vector; R: rotation or other 3×3 matrix.
   43 mul, 63 add, 3 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_rightJacobianInversef(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const float size_0 = fabsf(v->x);
  const float size_1 = fabsf(v->y);
  const float size_2 = fabsf(v->z);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = v->x + grid;
  const float shifted_1 = v->y + grid;
  const float shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0;
  const float low_1 = v->y - high_1;
  const float low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0;
  const float sum_1 = v->y + high_1;
  const float sum_2 = v->z + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent_a = 0.5f * theta, half_cotangent = half_cotangent_a * cotangent;
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_a = 1.4551725e-27f * x, b_b = b_a + 5.744791e-26f, b_c = x * b_b,
      b_d = b_c + 2.2679524e-24f, b_e = x * b_d, b_f = b_e + 8.9535176e-23f, b_g = x * b_f,
      b_h = b_g + 3.534707e-21f, b_i = x * b_h, b_j = b_i + 1.3954465e-19f, b_k = x * b_j,
      b_l = b_k + 5.509003e-18f, b_m = x * b_l, b_n = b_m + 2.1748687e-16f, b_o = x * b_n,
      b_p = b_o + 8.586062e-15f, b_q = x * b_p, b_r = b_q + 3.3896803e-13f, b_s = x * b_r,
      b_t = b_s + 1.3382536e-11f, b_u = x * b_t, b_v = b_u + 5.2841903e-10f, b_w = x * b_v,
      b_x = b_w + 2.0876756e-08f, b_y = x * b_x, b_z = b_y + 8.267196e-07f, b_aa = x * b_z,
      b_ab = b_aa + 3.3068784e-05f, b_ac = x * b_ab, b_ad = b_ac + 0.0013888889f, b_ae = x * b_ad,
      b_af = b_ae + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_a = x * b, b_across_b = 1.0f - b_across_a,
      b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = v->x * b;
  const float beta_v_1 = v->y * b;
  const float beta_v_2 = v->z * b;
  const float m_0 = v->x * beta_v_0;
  const float m_1 = v->y * beta_v_1;
  const float m_2 = v->z * beta_v_2;
  const float m_3 = v->y * beta_v_0;
  const float m_4 = v->z * beta_v_0;
  const float m_5 = v->z * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = 0.5f * v->x;
  const float alpha_v_1 = 0.5f * v->y;
  const float alpha_v_2 = 0.5f * v->z;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalize(ksl_mat3x3f_t *self) {
  const float defect_0a = self->m00 * self->m00, defect_0b = 1.0f - defect_0a,
      defect_0c = self->m10 * self->m10, defect_0d = defect_0b - defect_0c,
      defect_0e = self->m20 * self->m20, defect_0 = defect_0d - defect_0e;
  const float defect_1a = self->m01 * self->m01, defect_1b = 1.0f - defect_1a,
      defect_1c = self->m11 * self->m11, defect_1d = defect_1b - defect_1c,
      defect_1e = self->m21 * self->m21, defect_1 = defect_1d - defect_1e;
  const float defect_2a = self->m02 * self->m02, defect_2b = 1.0f - defect_2a,
      defect_2c = self->m12 * self->m12, defect_2d = defect_2b - defect_2c,
      defect_2e = self->m22 * self->m22, defect_2 = defect_2d - defect_2e;
  const float defect_3a = self->m00 * self->m01, defect_3b = self->m10 * self->m11,
      defect_3c = defect_3a + defect_3b, defect_3d = self->m20 * self->m21,
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const float defect_4a = self->m00 * self->m02, defect_4b = self->m10 * self->m12,
      defect_4c = defect_4a + defect_4b, defect_4d = self->m20 * self->m22,
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const float defect_5a = self->m01 * self->m02, defect_5b = self->m11 * self->m12,
      defect_5c = defect_5a + defect_5b, defect_5d = self->m21 * self->m22,
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const float correction_0 = 0.5f * defect_0;
  const float correction_1 = 0.5f * defect_1;
  const float correction_2 = 0.5f * defect_2;
  const float correction_3 = 0.5f * defect_3;
  const float correction_4 = 0.5f * defect_4;
  const float correction_5 = 0.5f * defect_5;
  const float self_00_new_a = self->m00 * correction_0, self_00_new_b = self->m01 * correction_3,
      self_00_new_c = self_00_new_a + self_00_new_b, self_00_new_d = self->m02 * correction_4,
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const float self_01_new_a = self->m00 * correction_3, self_01_new_b = self->m01 * correction_1,
      self_01_new_c = self_01_new_a + self_01_new_b, self_01_new_d = self->m02 * correction_5,
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const float self_02_new_a = self->m00 * correction_4, self_02_new_b = self->m01 * correction_5,
      self_02_new_c = self_02_new_a + self_02_new_b, self_02_new_d = self->m02 * correction_2,
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const float self_10_new_a = self->m10 * correction_0, self_10_new_b = self->m11 * correction_3,
      self_10_new_c = self_10_new_a + self_10_new_b, self_10_new_d = self->m12 * correction_4,
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const float self_11_new_a = self->m10 * correction_3, self_11_new_b = self->m11 * correction_1,
      self_11_new_c = self_11_new_a + self_11_new_b, self_11_new_d = self->m12 * correction_5,
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const float self_12_new_a = self->m10 * correction_4, self_12_new_b = self->m11 * correction_5,
      self_12_new_c = self_12_new_a + self_12_new_b, self_12_new_d = self->m12 * correction_2,
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const float self_20_new_a = self->m20 * correction_0, self_20_new_b = self->m21 * correction_3,
      self_20_new_c = self_20_new_a + self_20_new_b, self_20_new_d = self->m22 * correction_4,
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const float self_21_new_a = self->m20 * correction_3, self_21_new_b = self->m21 * correction_1,
      self_21_new_c = self_21_new_a + self_21_new_b, self_21_new_d = self->m22 * correction_5,
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const float self_22_new_a = self->m20 * correction_4, self_22_new_b = self->m21 * correction_5,
      self_22_new_c = self_22_new_a + self_22_new_b, self_22_new_d = self->m22 * correction_2,
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalized(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float defect_0a = R->m00 * R->m00, defect_0b = 1.0f - defect_0a,
      defect_0c = R->m10 * R->m10, defect_0d = defect_0b - defect_0c, defect_0e = R->m20 * R->m20,
      defect_0 = defect_0d - defect_0e;
  const float defect_1a = R->m01 * R->m01, defect_1b = 1.0f - defect_1a,
      defect_1c = R->m11 * R->m11, defect_1d = defect_1b - defect_1c, defect_1e = R->m21 * R->m21,
      defect_1 = defect_1d - defect_1e;
  const float defect_2a = R->m02 * R->m02, defect_2b = 1.0f - defect_2a,
      defect_2c = R->m12 * R->m12, defect_2d = defect_2b - defect_2c, defect_2e = R->m22 * R->m22,
      defect_2 = defect_2d - defect_2e;
  const float defect_3a = R->m00 * R->m01, defect_3b = R->m10 * R->m11,
      defect_3c = defect_3a + defect_3b, defect_3d = R->m20 * R->m21,
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const float defect_4a = R->m00 * R->m02, defect_4b = R->m10 * R->m12,
      defect_4c = defect_4a + defect_4b, defect_4d = R->m20 * R->m22,
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const float defect_5a = R->m01 * R->m02, defect_5b = R->m11 * R->m12,
      defect_5c = defect_5a + defect_5b, defect_5d = R->m21 * R->m22,
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const float correction_0 = 0.5f * defect_0;
  const float correction_1 = 0.5f * defect_1;
  const float correction_2 = 0.5f * defect_2;
  const float correction_3 = 0.5f * defect_3;
  const float correction_4 = 0.5f * defect_4;
  const float correction_5 = 0.5f * defect_5;
  const float Ro_00a = R->m00 * correction_0, Ro_00b = R->m01 * correction_3,
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = R->m02 * correction_4, Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const float Ro_01a = R->m00 * correction_3, Ro_01b = R->m01 * correction_1,
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = R->m02 * correction_5, Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const float Ro_02a = R->m00 * correction_4, Ro_02b = R->m01 * correction_5,
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = R->m02 * correction_2, Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const float Ro_10a = R->m10 * correction_0, Ro_10b = R->m11 * correction_3,
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = R->m12 * correction_4, Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const float Ro_11a = R->m10 * correction_3, Ro_11b = R->m11 * correction_1,
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = R->m12 * correction_5, Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const float Ro_12a = R->m10 * correction_4, Ro_12b = R->m11 * correction_5,
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = R->m12 * correction_2, Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const float Ro_20a = R->m20 * correction_0, Ro_20b = R->m21 * correction_3,
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = R->m22 * correction_4, Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const float Ro_21a = R->m20 * correction_3, Ro_21b = R->m21 * correction_1,
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = R->m22 * correction_5, Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const float Ro_22a = R->m20 * correction_4, Ro_22b = R->m21 * correction_5,
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = R->m22 * correction_2, Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   80 mul, 93 add, 4 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 6 less, 13 select.
   Error <= R: (5 + θ/200) u, t: (8 + θ/200) u of its largest component, or of s.lin if that is
     larger for |ω of s| <= 1e13, in single precision 1e5; searched, not proved. */
static inline void ksl_SE3f_exp(const ksl_screwf_t *s, ksl_SE3f_t *D) {
  const float size_0 = fabsf(s->m3);
  const float size_1 = fabsf(s->m4);
  const float size_2 = fabsf(s->m5);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = s->m3 + grid;
  const float shifted_1 = s->m4 + grid;
  const float shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0;
  const float low_1 = s->m4 - high_1;
  const float low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0;
  const float sum_1 = s->m4 + high_1;
  const float sum_2 = s->m5 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3a = 9.18369e-29f * x, g3b = g3a - 6.4469503e-26f, g3c = x * g3b,
      g3d = g3c + 3.8681703e-23f, g3e = x * g3d, g3f = g3e - 1.9572942e-20f, g3g = x * g3f,
      g3h = g3g + 8.220635e-18f, g3i = x * g3h, g3j = g3i - 2.8114574e-15f, g3k = x * g3j,
      g3l = g3k + 7.6471636e-13f, g3m = x * g3l, g3n = g3m - 1.6059044e-10f, g3o = x * g3n,
      g3p = g3o + 2.5052108e-08f, g3q = x * g3p, g3r = g3q - 2.7557319e-06f, g3s = x * g3r,
      g3t = g3s + 0.0001984127f, g3u = x * g3t, g3v = g3u - 0.008333334f, g3w = x * g3v,
      g3x = g3w + 0.16666667f, g3 = x < 4.0f ? g3x : closed3;
  const float g0a = x * g2, g0b = 1.0f - g0a, g0 = x < 1.0f ? g0b : cosine;
  const float u_0a = s->m2 * s->m4, u_0b = s->m1 * s->m5, u_0 = u_0a - u_0b;
  const float u_1a = s->m0 * s->m5, u_1b = s->m2 * s->m3, u_1 = u_1a - u_1b;
  const float u_2a = s->m1 * s->m3, u_2b = s->m0 * s->m4, u_2 = u_2a - u_2b;
  const float turned_0 = g2 * u_0;
  const float turned_1 = g2 * u_1;
  const float turned_2 = g2 * u_2;
  const float wv_a = s->m0 * s->m3, wv_b = s->m1 * s->m4, wv_c = wv_a + wv_b, wv_d = s->m2 * s->m5,
      wv = wv_c + wv_d;
  const float pitch = g3 * wv;
  const float along_0 = s->m3 * pitch;
  const float along_1 = s->m4 * pitch;
  const float along_2 = s->m5 * pitch;
  const float beta_v_0 = s->m3 * g2;
  const float beta_v_1 = s->m4 * g2;
  const float beta_v_2 = s->m5 * g2;
  const float m_0 = s->m3 * beta_v_0;
  const float m_1 = s->m4 * beta_v_1;
  const float m_2 = s->m5 * beta_v_2;
  const float m_3 = s->m4 * beta_v_0;
  const float m_4 = s->m5 * beta_v_0;
  const float m_5 = s->m5 * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = s->m3 * g1;
  const float alpha_v_1 = s->m4 * g1;
  const float alpha_v_2 = s->m5 * g1;
  const float across_axis_0 = turned_0 + along_0;
  const float across_axis_1 = turned_1 + along_1;
  const float across_axis_2 = turned_2 + along_2;
  const float D_01 = m_3 - alpha_v_2;
  const float D_02 = m_4 + alpha_v_1;
  const float D_03a = s->m0 * g1, D_03 = D_03a + across_axis_0;
  const float D_10 = m_3 + alpha_v_2;
  const float D_12 = m_5 - alpha_v_0;
  const float D_13a = s->m1 * g1, D_13 = D_13a + across_axis_1;
  const float D_20 = m_4 - alpha_v_1;
  const float D_21 = m_5 + alpha_v_0;
  const float D_23a = s->m2 * g1, D_23 = D_23a + across_axis_2;
  D->m00 = diagonal0;
  D->m01 = D_01;
  D->m02 = D_02;
  D->m03 = D_03;
  D->m10 = D_10;
  D->m11 = diagonal1;
  D->m12 = D_12;
  D->m13 = D_13;
  D->m20 = D_20;
  D->m21 = D_21;
  D->m22 = diagonal2;
  D->m23 = D_23;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   50 mul, 45 add, 3 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 14 less, 1 equal, 29 select.
   Error <= lin: 18 u, ang: 8 u of its largest component for D a rotation; searched, not proved. */
static inline void ksl_SE3f_log(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float p_0 = D->m21 - D->m12;
  const float p_1 = D->m02 - D->m20;
  const float p_2 = D->m10 - D->m01;
  const float s_0 = D->m12 + D->m21;
  const float s_1 = D->m02 + D->m20;
  const float s_2 = D->m01 + D->m10;
  const float first_0 = D->m00 + 1.0f;
  const float first_1 = 1.0f - D->m00;
  const float others_0 = D->m11 + D->m22;
  const float others_1 = D->m11 - D->m22;
  const float d_0 = first_0 + others_0;
  const float d_1 = first_0 - others_0;
  const float d_2 = first_1 + others_1;
  const float d_3 = first_1 - others_1;
  const float low_0 = D->m11 < D->m00 ? d_1 : s_2;
  const float low_1 = D->m11 < D->m00 ? s_2 : d_2;
  const float low_2 = D->m11 < D->m00 ? s_1 : s_0;
  const float low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const float high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const float high_1 = D->m00 < high_0a ? s_0 : p_1;
  const float high_2 = D->m00 < high_0a ? d_3 : p_2;
  const float high_3 = D->m00 < high_0a ? p_2 : d_0;
  const float column_0 = D->m22 < 0.0f ? low_0 : high_0;
  const float column_1 = D->m22 < 0.0f ? low_1 : high_1;
  const float column_2 = D->m22 < 0.0f ? low_2 : high_2;
  const float column_3 = D->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = upper_0 * v_s;
  const float v_y_1 = upper_1 * v_s;
  const float v_y_2 = upper_2 * v_s;
  const float v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = v_n * v_r;
  const float half = atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = 2.0f * half;
  const float k = theta / divisor;
  const float vector_0 = upper_0 * k;
  const float vector_1 = upper_1 * k;
  const float vector_2 = upper_2 * k;
  const float x = theta * theta;
  const float far_sine = x < 1.0f ? 1.0f : n;
  const float cotangent = upper_3 / far_sine;
  const float half_cotangent_a = 0.5f * theta, half_cotangent = half_cotangent_a * cotangent;
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_a = 1.4551725e-27f * x, b_b = b_a + 5.744791e-26f, b_c = x * b_b,
      b_d = b_c + 2.2679524e-24f, b_e = x * b_d, b_f = b_e + 8.9535176e-23f, b_g = x * b_f,
      b_h = b_g + 3.534707e-21f, b_i = x * b_h, b_j = b_i + 1.3954465e-19f, b_k = x * b_j,
      b_l = b_k + 5.509003e-18f, b_m = x * b_l, b_n = b_m + 2.1748687e-16f, b_o = x * b_n,
      b_p = b_o + 8.586062e-15f, b_q = x * b_p, b_r = b_q + 3.3896803e-13f, b_s = x * b_r,
      b_t = b_s + 1.3382536e-11f, b_u = x * b_t, b_v = b_u + 5.2841903e-10f, b_w = x * b_v,
      b_x = b_w + 2.0876756e-08f, b_y = x * b_x, b_z = b_y + 8.267196e-07f, b_aa = x * b_z,
      b_ab = b_aa + 3.3068784e-05f, b_ac = x * b_ab, b_ad = b_ac + 0.0013888889f, b_ae = x * b_ad,
      b_af = b_ae + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_a = x * b, b_across_b = 1.0f - b_across_a,
      b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float wt_a = D->m03 * vector_0, wt_b = D->m13 * vector_1, wt_c = wt_a + wt_b,
      wt_d = D->m23 * vector_2, wt = wt_c + wt_d;
  const float pitch = b * wt;
  const float along_0 = vector_0 * pitch;
  const float along_1 = vector_1 * pitch;
  const float along_2 = vector_2 * pitch;
  const float u_0a = D->m23 * vector_1, u_0b = D->m13 * vector_2, u_0 = u_0a - u_0b;
  const float u_1a = D->m03 * vector_2, u_1b = D->m23 * vector_0, u_1 = u_1a - u_1b;
  const float u_2a = D->m13 * vector_0, u_2b = D->m03 * vector_1, u_2 = u_2a - u_2b;
  const float turned_0 = 0.5f * u_0;
  const float turned_1 = 0.5f * u_1;
  const float turned_2 = 0.5f * u_2;
  const float across_axis_0 = along_0 - turned_0;
  const float across_axis_1 = along_1 - turned_1;
  const float across_axis_2 = along_2 - turned_2;
  const float so_0a = D->m03 * b_across, so_0 = so_0a + across_axis_0;
  const float so_1a = D->m13 * b_across, so_1 = so_1a + across_axis_1;
  const float so_2a = D->m23 * b_across, so_2 = so_2a + across_axis_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 133 add, 6 div, 1 sqrt, 1 sin, 1 cos, 1 neg, 4 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3f_leftJacobian(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float size_0 = fabsf(s->m3);
  const float size_1 = fabsf(s->m4);
  const float size_2 = fabsf(s->m5);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = s->m3 + grid;
  const float shifted_1 = s->m4 + grid;
  const float shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0;
  const float low_1 = s->m4 - high_1;
  const float low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0;
  const float sum_1 = s->m4 + high_1;
  const float sum_2 = s->m5 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3a = 9.18369e-29f * x, g3b = g3a - 6.4469503e-26f, g3c = x * g3b,
      g3d = g3c + 3.8681703e-23f, g3e = x * g3d, g3f = g3e - 1.9572942e-20f, g3g = x * g3f,
      g3h = g3g + 8.220635e-18f, g3i = x * g3h, g3j = g3i - 2.8114574e-15f, g3k = x * g3j,
      g3l = g3k + 7.6471636e-13f, g3m = x * g3l, g3n = g3m - 1.6059044e-10f, g3o = x * g3n,
      g3p = g3o + 2.5052108e-08f, g3q = x * g3p, g3r = g3q - 2.7557319e-06f, g3s = x * g3r,
      g3t = g3s + 0.0001984127f, g3u = x * g3t, g3v = g3u - 0.008333334f, g3w = x * g3v,
      g3x = g3w + 0.16666667f, g3 = x < 4.0f ? g3x : closed3;
  const float late_x = x < 9.0f ? 1.0f : x;
  const float rate2_rest_a = 2.0f * g2, rate2_rest = g1 - rate2_rest_a;
  const float closed_rate2 = rate2_rest / late_x;
  const float rate3_rest_a = 3.0f * g3, rate3_rest = g2 - rate3_rest_a;
  const float closed_rate3 = rate3_rest / late_x;
  const float rate2a = 8.527712e-29f * x, rate2b = 5.951031e-26f - rate2a, rate2c = x * rate2b,
      rate2d = rate2c - 3.5458228e-23f, rate2e = x * rate2d, rate2f = rate2e + 1.7793582e-20f,
      rate2g = x * rate2f, rate2h = rate2g - 7.398571e-18f, rate2i = x * rate2h,
      rate2j = rate2i + 2.499073e-15f, rate2k = x * rate2j, rate2l = rate2k - 6.691268e-13f,
      rate2m = x * rate2l, rate2n = rate2m + 1.3764895e-10f, rate2o = x * rate2n,
      rate2p = rate2o - 2.0876756e-08f, rate2q = x * rate2p, rate2r = rate2q + 2.2045856e-06f,
      rate2s = x * rate2r, rate2t = rate2s - 0.00014880953f, rate2u = x * rate2t,
      rate2v = rate2u + 0.0055555557f, rate2w = x * rate2v, rate2x = rate2w - 0.083333336f,
      rate2 = x < 9.0f ? rate2x : closed_rate2;
  const float rate3a = 2.9405903e-30f * x, rate3b = 2.2040857e-27f - rate3a, rate3c = x * rate3b,
      rate3d = rate3c - 1.418329e-24f, rate3e = x * rate3d, rate3f = rate3e + 7.7363405e-22f,
      rate3g = x * rate3f, rate3h = rate3g - 3.5231295e-19f, rate3i = x * rate3h,
      rate3j = rate3i + 1.3153016e-16f, rate3k = x * rate3j, rate3l = rate3k - 3.93604e-14f,
      rate3m = x * rate3l, rate3n = rate3m + 9.176596e-12f, rate3o = x * rate3n,
      rate3p = rate3o - 1.6059044e-09f, rate3q = x * rate3p, rate3r = rate3q + 2.0041686e-07f,
      rate3s = x * rate3r, rate3t = rate3s - 1.6534392e-05f, rate3u = x * rate3t,
      rate3v = rate3u + 0.0007936508f, rate3w = x * rate3v, rate3x = rate3w - 0.016666668f,
      rate3 = x < 9.0f ? rate3x : closed_rate3;
  const float beta_v_0 = s->m3 * g3;
  const float beta_v_1 = s->m4 * g3;
  const float beta_v_2 = s->m5 * g3;
  const float m_0 = s->m3 * beta_v_0;
  const float m_1 = s->m4 * beta_v_1;
  const float m_2 = s->m5 * beta_v_2;
  const float m_3 = s->m4 * beta_v_0;
  const float m_4 = s->m5 * beta_v_0;
  const float m_5 = s->m5 * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = s->m3 * g2;
  const float alpha_v_1 = s->m4 * g2;
  const float alpha_v_2 = s->m5 * g2;
  const float J_1 = m_3 - alpha_v_2;
  const float J_2 = m_4 + alpha_v_1;
  const float J_3 = m_3 + alpha_v_2;
  const float J_5 = m_5 - alpha_v_0;
  const float J_6 = m_4 - alpha_v_1;
  const float J_7 = m_5 + alpha_v_0;
  const float rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const float rate_turn = rate2 * rate_vw;
  const float rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const float rate_q_0a = s->m0 * g2, rate_q_0b = s->m3 * rate_turn,
      rate_q_0 = rate_q_0a + rate_q_0b;
  const float rate_q_1a = s->m1 * g2, rate_q_1b = s->m4 * rate_turn,
      rate_q_1 = rate_q_1a + rate_q_1b;
  const float rate_q_2a = s->m2 * g2, rate_q_2b = s->m5 * rate_turn,
      rate_q_2 = rate_q_2a + rate_q_2b;
  const float rate_beta_v_0 = s->m0 * g3;
  const float rate_beta_v_1 = s->m1 * g3;
  const float rate_beta_v_2 = s->m2 * g3;
  const float rate_bend_w_0 = s->m3 * rate_bend;
  const float rate_bend_w_1 = s->m4 * rate_bend;
  const float rate_bend_w_2 = s->m5 * rate_bend;
  const float rate_symmetric_0a = s->m3 * rate_beta_v_1, rate_symmetric_0b = s->m4 * rate_beta_v_0,
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = s->m4 * rate_bend_w_0,
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const float rate_symmetric_1a = s->m3 * rate_beta_v_2, rate_symmetric_1b = s->m5 * rate_beta_v_0,
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = s->m5 * rate_bend_w_0,
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const float rate_symmetric_2a = s->m4 * rate_beta_v_2, rate_symmetric_2b = s->m5 * rate_beta_v_1,
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = s->m5 * rate_bend_w_1,
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const float rate_diagonal_0a = s->m4 * rate_bend_w_1, rate_diagonal_0b = s->m5 * rate_bend_w_2,
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0f * s->m4,
      rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1, rate_diagonal_0f = 2.0f * s->m5,
      rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2,
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const float rate_diagonal_1a = s->m3 * rate_bend_w_0,
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0f * s->m3,
      rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const float rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const float M_04 = rate_symmetric_0 - rate_q_2;
  const float M_05 = rate_q_1 + rate_symmetric_1;
  const float M_13 = rate_q_2 + rate_symmetric_0;
  const float M_15 = rate_symmetric_2 - rate_q_0;
  const float M_23 = rate_symmetric_1 - rate_q_1;
  const float M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 133 add, 6 div, 1 sqrt, 1 sin, 1 cos, 13 neg, 4 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3f_rightJacobian(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float size_0 = fabsf(s->m3);
  const float size_1 = fabsf(s->m4);
  const float size_2 = fabsf(s->m5);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = s->m3 + grid;
  const float shifted_1 = s->m4 + grid;
  const float shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0;
  const float low_1 = s->m4 - high_1;
  const float low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0;
  const float sum_1 = s->m4 + high_1;
  const float sum_2 = s->m5 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1a = 6.4469503e-26f * x, g1b = g1a - 3.8681703e-23f, g1c = x * g1b,
      g1d = g1c + 1.9572942e-20f, g1e = x * g1d, g1f = g1e - 8.220635e-18f, g1g = x * g1f,
      g1h = g1g + 2.8114574e-15f, g1i = x * g1h, g1j = g1i - 7.6471636e-13f, g1k = x * g1j,
      g1l = g1k + 1.6059044e-10f, g1m = x * g1l, g1n = g1m - 2.5052108e-08f, g1o = x * g1n,
      g1p = g1o + 2.7557319e-06f, g1q = x * g1p, g1r = g1q - 0.0001984127f, g1s = x * g1r,
      g1t = g1s + 0.008333334f, g1u = x * g1t, g1v = g1u - 0.16666667f, g1w = x * g1v,
      g1x = g1w + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2a = 2.4795963e-27f * x, g2b = g2a - 1.6117376e-24f, g2c = x * g2b,
      g2d = g2c + 8.896791e-22f, g2e = x * g2d, g2f = g2e - 4.1103176e-19f, g2g = x * g2f,
      g2h = g2g + 1.5619207e-16f, g2i = x * g2h, g2j = g2i - 4.7794773e-14f, g2k = x * g2j,
      g2l = g2k + 1.1470745e-11f, g2m = x * g2l, g2n = g2m - 2.0876756e-09f, g2o = x * g2n,
      g2p = g2o + 2.755732e-07f, g2q = x * g2p, g2r = g2q - 2.4801588e-05f, g2s = x * g2r,
      g2t = g2s + 0.0013888889f, g2u = x * g2t, g2v = g2u - 0.041666668f, g2w = x * g2v,
      g2x = g2w + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3a = 9.18369e-29f * x, g3b = g3a - 6.4469503e-26f, g3c = x * g3b,
      g3d = g3c + 3.8681703e-23f, g3e = x * g3d, g3f = g3e - 1.9572942e-20f, g3g = x * g3f,
      g3h = g3g + 8.220635e-18f, g3i = x * g3h, g3j = g3i - 2.8114574e-15f, g3k = x * g3j,
      g3l = g3k + 7.6471636e-13f, g3m = x * g3l, g3n = g3m - 1.6059044e-10f, g3o = x * g3n,
      g3p = g3o + 2.5052108e-08f, g3q = x * g3p, g3r = g3q - 2.7557319e-06f, g3s = x * g3r,
      g3t = g3s + 0.0001984127f, g3u = x * g3t, g3v = g3u - 0.008333334f, g3w = x * g3v,
      g3x = g3w + 0.16666667f, g3 = x < 4.0f ? g3x : closed3;
  const float late_x = x < 9.0f ? 1.0f : x;
  const float rate2_rest_a = 2.0f * g2, rate2_rest = g1 - rate2_rest_a;
  const float closed_rate2 = rate2_rest / late_x;
  const float rate3_rest_a = 3.0f * g3, rate3_rest = g2 - rate3_rest_a;
  const float closed_rate3 = rate3_rest / late_x;
  const float rate2a = 8.527712e-29f * x, rate2b = 5.951031e-26f - rate2a, rate2c = x * rate2b,
      rate2d = rate2c - 3.5458228e-23f, rate2e = x * rate2d, rate2f = rate2e + 1.7793582e-20f,
      rate2g = x * rate2f, rate2h = rate2g - 7.398571e-18f, rate2i = x * rate2h,
      rate2j = rate2i + 2.499073e-15f, rate2k = x * rate2j, rate2l = rate2k - 6.691268e-13f,
      rate2m = x * rate2l, rate2n = rate2m + 1.3764895e-10f, rate2o = x * rate2n,
      rate2p = rate2o - 2.0876756e-08f, rate2q = x * rate2p, rate2r = rate2q + 2.2045856e-06f,
      rate2s = x * rate2r, rate2t = rate2s - 0.00014880953f, rate2u = x * rate2t,
      rate2v = rate2u + 0.0055555557f, rate2w = x * rate2v, rate2x = rate2w - 0.083333336f,
      rate2 = x < 9.0f ? rate2x : closed_rate2;
  const float rate3a = 2.9405903e-30f * x, rate3b = 2.2040857e-27f - rate3a, rate3c = x * rate3b,
      rate3d = rate3c - 1.418329e-24f, rate3e = x * rate3d, rate3f = rate3e + 7.7363405e-22f,
      rate3g = x * rate3f, rate3h = rate3g - 3.5231295e-19f, rate3i = x * rate3h,
      rate3j = rate3i + 1.3153016e-16f, rate3k = x * rate3j, rate3l = rate3k - 3.93604e-14f,
      rate3m = x * rate3l, rate3n = rate3m + 9.176596e-12f, rate3o = x * rate3n,
      rate3p = rate3o - 1.6059044e-09f, rate3q = x * rate3p, rate3r = rate3q + 2.0041686e-07f,
      rate3s = x * rate3r, rate3t = rate3s - 1.6534392e-05f, rate3u = x * rate3t,
      rate3v = rate3u + 0.0007936508f, rate3w = x * rate3v, rate3x = rate3w - 0.016666668f,
      rate3 = x < 9.0f ? rate3x : closed_rate3;
  const float beta_v_0 = s->m3 * g3;
  const float beta_v_1 = s->m4 * g3;
  const float beta_v_2 = s->m5 * g3;
  const float m_0 = s->m3 * beta_v_0;
  const float m_1 = s->m4 * beta_v_1;
  const float m_2 = s->m5 * beta_v_2;
  const float m_3 = s->m4 * beta_v_0;
  const float m_4 = s->m5 * beta_v_0;
  const float m_5 = s->m5 * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0a = s->m3 * g2, alpha_v_0 = -alpha_v_0a;
  const float alpha_v_1a = s->m4 * g2, alpha_v_1 = -alpha_v_1a;
  const float alpha_v_2a = s->m5 * g2, alpha_v_2 = -alpha_v_2a;
  const float J_1 = m_3 - alpha_v_2;
  const float J_2 = m_4 + alpha_v_1;
  const float J_3 = m_3 + alpha_v_2;
  const float J_5 = m_5 - alpha_v_0;
  const float J_6 = m_4 - alpha_v_1;
  const float J_7 = m_5 + alpha_v_0;
  const float rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const float rate_turn = rate2 * rate_vw;
  const float rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const float rate_q_0a = s->m0 * g2, rate_q_0b = s->m3 * rate_turn,
      rate_q_0c = rate_q_0a + rate_q_0b, rate_q_0 = -rate_q_0c;
  const float rate_q_1a = s->m1 * g2, rate_q_1b = s->m4 * rate_turn,
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_1 = -rate_q_1c;
  const float rate_q_2a = s->m2 * g2, rate_q_2b = s->m5 * rate_turn,
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_2 = -rate_q_2c;
  const float rate_beta_v_0a = s->m0 * g3, rate_beta_v_0 = -rate_beta_v_0a;
  const float rate_beta_v_1a = s->m1 * g3, rate_beta_v_1 = -rate_beta_v_1a;
  const float rate_beta_v_2a = s->m2 * g3, rate_beta_v_2 = -rate_beta_v_2a;
  const float rate_bend_w_0a = s->m3 * rate_bend, rate_bend_w_0 = -rate_bend_w_0a;
  const float rate_bend_w_1a = s->m4 * rate_bend, rate_bend_w_1 = -rate_bend_w_1a;
  const float rate_bend_w_2a = s->m5 * rate_bend, rate_bend_w_2 = -rate_bend_w_2a;
  const float rate_symmetric_0a = s->m4 * rate_bend_w_0, rate_symmetric_0b = s->m3 * rate_beta_v_1,
      rate_symmetric_0c = s->m4 * rate_beta_v_0,
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d;
  const float rate_symmetric_1a = s->m5 * rate_bend_w_0, rate_symmetric_1b = s->m3 * rate_beta_v_2,
      rate_symmetric_1c = s->m5 * rate_beta_v_0,
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d;
  const float rate_symmetric_2a = s->m5 * rate_bend_w_1, rate_symmetric_2b = s->m4 * rate_beta_v_2,
      rate_symmetric_2c = s->m5 * rate_beta_v_1,
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d;
  const float rate_diagonal_0a = 2.0f * s->m4, rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1,
      rate_diagonal_0c = 2.0f * s->m5, rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2,
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = s->m4 * rate_bend_w_1, rate_diagonal_0g = s->m5 * rate_bend_w_2,
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const float rate_diagonal_1a = 2.0f * s->m3, rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0,
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = s->m3 * rate_bend_w_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const float rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const float M_04 = rate_symmetric_0 - rate_q_2;
  const float M_05 = rate_q_1 + rate_symmetric_1;
  const float M_13 = rate_q_2 + rate_symmetric_0;
  const float M_15 = rate_symmetric_2 - rate_q_0;
  const float M_23 = rate_symmetric_1 - rate_q_1;
  const float M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π but 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   93 mul, 106 add, 5 div, 1 sqrt, 1 sin, 1 cos, 7 neg, 4 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3f_leftJacobianInverse(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float size_0 = fabsf(s->m3);
  const float size_1 = fabsf(s->m4);
  const float size_2 = fabsf(s->m5);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = s->m3 + grid;
  const float shifted_1 = s->m4 + grid;
  const float shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0;
  const float low_1 = s->m4 - high_1;
  const float low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0;
  const float sum_1 = s->m4 + high_1;
  const float sum_2 = s->m5 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent_a = 0.5f * theta, half_cotangent = half_cotangent_a * cotangent;
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_a = 1.4551725e-27f * x, b_b = b_a + 5.744791e-26f, b_c = x * b_b,
      b_d = b_c + 2.2679524e-24f, b_e = x * b_d, b_f = b_e + 8.9535176e-23f, b_g = x * b_f,
      b_h = b_g + 3.534707e-21f, b_i = x * b_h, b_j = b_i + 1.3954465e-19f, b_k = x * b_j,
      b_l = b_k + 5.509003e-18f, b_m = x * b_l, b_n = b_m + 2.1748687e-16f, b_o = x * b_n,
      b_p = b_o + 8.586062e-15f, b_q = x * b_p, b_r = b_q + 3.3896803e-13f, b_s = x * b_r,
      b_t = b_s + 1.3382536e-11f, b_u = x * b_t, b_v = b_u + 5.2841903e-10f, b_w = x * b_v,
      b_x = b_w + 2.0876756e-08f, b_y = x * b_x, b_z = b_y + 8.267196e-07f, b_aa = x * b_z,
      b_ab = b_aa + 3.3068784e-05f, b_ac = x * b_ab, b_ad = b_ac + 0.0013888889f, b_ae = x * b_ad,
      b_af = b_ae + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_a = x * b, b_across_b = 1.0f - b_across_a,
      b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = s->m3 * b;
  const float beta_v_1 = s->m4 * b;
  const float beta_v_2 = s->m5 * b;
  const float m_0 = s->m3 * beta_v_0;
  const float m_1 = s->m4 * beta_v_1;
  const float m_2 = s->m5 * beta_v_2;
  const float m_3 = s->m4 * beta_v_0;
  const float m_4 = s->m5 * beta_v_0;
  const float m_5 = s->m5 * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0a = 0.5f * s->m3, alpha_v_0 = -alpha_v_0a;
  const float alpha_v_1a = 0.5f * s->m4, alpha_v_1 = -alpha_v_1a;
  const float alpha_v_2a = 0.5f * s->m5, alpha_v_2 = -alpha_v_2a;
  const float J_1 = m_3 - alpha_v_2;
  const float J_2 = m_4 + alpha_v_1;
  const float J_3 = m_3 + alpha_v_2;
  const float J_5 = m_5 - alpha_v_0;
  const float J_6 = m_4 - alpha_v_1;
  const float J_7 = m_5 + alpha_v_0;
  const float b_rate_across_a = 2.0f - half_cotangent, b_rate_across = b_rate_across_a / b_divisor;
  const float b_rate_square_a = cotangent * cotangent, b_rate_square_b = 0.25f * b_rate_square_a,
      b_rate_square = 0.25f + b_rate_square_b;
  const float b_rate_rest = b_rate_square - b_rate_across;
  const float closed_b_rate = b_rate_rest / b_divisor;
  const float b_rate_a = 3.3612244e-29f * x, b_rate_b = b_rate_a + 1.2532382e-27f,
      b_rate_c = x * b_rate_b, b_rate_d = b_rate_c + 4.656552e-26f, b_rate_e = x * b_rate_d,
      b_rate_f = b_rate_e + 1.7234372e-24f, b_rate_g = x * b_rate_f,
      b_rate_h = b_rate_g + 6.350267e-23f, b_rate_i = x * b_rate_h,
      b_rate_j = b_rate_i + 2.3279144e-21f, b_rate_k = x * b_rate_j,
      b_rate_l = b_rate_k + 8.483297e-20f, b_rate_m = x * b_rate_l,
      b_rate_n = b_rate_m + 3.0699822e-18f, b_rate_o = x * b_rate_n,
      b_rate_p = b_rate_o + 1.10180054e-16f, b_rate_q = x * b_rate_p,
      b_rate_r = b_rate_q + 3.9147635e-15f, b_rate_s = x * b_rate_r,
      b_rate_t = b_rate_s + 1.37377e-13f, b_rate_u = x * b_rate_t,
      b_rate_v = b_rate_u + 4.7455525e-12f, b_rate_w = x * b_rate_v,
      b_rate_x = b_rate_w + 1.6059044e-10f, b_rate_y = x * b_rate_x,
      b_rate_z = b_rate_y + 5.28419e-09f, b_rate_aa = x * b_rate_z,
      b_rate_ab = b_rate_aa + 1.6701405e-07f, b_rate_ac = x * b_rate_ab,
      b_rate_ad = b_rate_ac + 4.9603173e-06f, b_rate_ae = x * b_rate_ad,
      b_rate_af = b_rate_ae + 0.00013227513f, b_rate_ag = x * b_rate_af,
      b_rate_ah = b_rate_ag + 0.0027777778f, b_rate = x < 4.0f ? b_rate_ah : closed_b_rate;
  const float rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const float rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const float rate_q_0a = 0.5f * s->m0, rate_q_0 = -rate_q_0a;
  const float rate_q_1a = 0.5f * s->m1, rate_q_1 = -rate_q_1a;
  const float rate_q_2a = 0.5f * s->m2, rate_q_2 = -rate_q_2a;
  const float rate_beta_v_0 = s->m0 * b;
  const float rate_beta_v_1 = s->m1 * b;
  const float rate_beta_v_2 = s->m2 * b;
  const float rate_bend_w_0 = s->m3 * rate_bend;
  const float rate_bend_w_1 = s->m4 * rate_bend;
  const float rate_bend_w_2 = s->m5 * rate_bend;
  const float rate_symmetric_0a = s->m3 * rate_beta_v_1, rate_symmetric_0b = s->m4 * rate_beta_v_0,
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = s->m4 * rate_bend_w_0,
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const float rate_symmetric_1a = s->m3 * rate_beta_v_2, rate_symmetric_1b = s->m5 * rate_beta_v_0,
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = s->m5 * rate_bend_w_0,
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const float rate_symmetric_2a = s->m4 * rate_beta_v_2, rate_symmetric_2b = s->m5 * rate_beta_v_1,
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = s->m5 * rate_bend_w_1,
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const float rate_diagonal_0a = s->m4 * rate_bend_w_1, rate_diagonal_0b = s->m5 * rate_bend_w_2,
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0f * s->m4,
      rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1, rate_diagonal_0f = 2.0f * s->m5,
      rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2,
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const float rate_diagonal_1a = s->m3 * rate_bend_w_0,
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0f * s->m3,
      rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const float rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const float M_04 = rate_symmetric_0 - rate_q_2;
  const float M_05 = rate_q_1 + rate_symmetric_1;
  const float M_13 = rate_q_2 + rate_symmetric_0;
  const float M_15 = rate_symmetric_2 - rate_q_0;
  const float M_23 = rate_symmetric_1 - rate_q_1;
  const float M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π but 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   93 mul, 106 add, 5 div, 1 sqrt, 1 sin, 1 cos, 7 neg, 4 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved. */
static inline void ksl_SE3f_rightJacobianInverse(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float size_0 = fabsf(s->m3);
  const float size_1 = fabsf(s->m4);
  const float size_2 = fabsf(s->m5);
  const float sizes_a = size_0 + size_1, sizes = sizes_a + size_2;
  const float grid = sizes * 8192.0f;
  const float shifted_0 = s->m3 + grid;
  const float shifted_1 = s->m4 + grid;
  const float shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid;
  const float high_1 = shifted_1 - grid;
  const float high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0;
  const float low_1 = s->m4 - high_1;
  const float low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0;
  const float sum_1 = s->m4 + high_1;
  const float sum_2 = s->m5 + high_2;
  const float squares_a = high_0 * high_0, squares_b = high_1 * high_1,
      squares_c = squares_a + squares_b, squares_d = high_2 * high_2,
      squares = squares_c + squares_d;
  const float cross_a = low_0 * sum_0, cross_b = low_1 * sum_1, cross_c = cross_a + cross_b,
      cross_d = low_2 * sum_2, cross = cross_c + cross_d;
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest_a = theta_low * theta_sum, cross_rest = cross - cross_rest_a;
  const float exact_a = theta_high * theta_high, exact = squares - exact_a;
  const float residual = cross_rest + exact;
  const float small_a = 0.5f * residual, small = small_a / theta;
  const float delta_a = fabsf(small), delta = delta_a < 0.0078125f ? small : 0.0f;
  const float far_sine_a = sinf(theta), far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine_a = cosf(theta), far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine_a = delta * far_cosine, sine = sine_a + far_sine;
  const float cosine_a = delta * far_sine, cosine = far_cosine - cosine_a;
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent_a = 0.5f * theta, half_cotangent = half_cotangent_a * cotangent;
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_a = 1.4551725e-27f * x, b_b = b_a + 5.744791e-26f, b_c = x * b_b,
      b_d = b_c + 2.2679524e-24f, b_e = x * b_d, b_f = b_e + 8.9535176e-23f, b_g = x * b_f,
      b_h = b_g + 3.534707e-21f, b_i = x * b_h, b_j = b_i + 1.3954465e-19f, b_k = x * b_j,
      b_l = b_k + 5.509003e-18f, b_m = x * b_l, b_n = b_m + 2.1748687e-16f, b_o = x * b_n,
      b_p = b_o + 8.586062e-15f, b_q = x * b_p, b_r = b_q + 3.3896803e-13f, b_s = x * b_r,
      b_t = b_s + 1.3382536e-11f, b_u = x * b_t, b_v = b_u + 5.2841903e-10f, b_w = x * b_v,
      b_x = b_w + 2.0876756e-08f, b_y = x * b_x, b_z = b_y + 8.267196e-07f, b_aa = x * b_z,
      b_ab = b_aa + 3.3068784e-05f, b_ac = x * b_ab, b_ad = b_ac + 0.0013888889f, b_ae = x * b_ad,
      b_af = b_ae + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_a = x * b, b_across_b = 1.0f - b_across_a,
      b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = s->m3 * b;
  const float beta_v_1 = s->m4 * b;
  const float beta_v_2 = s->m5 * b;
  const float m_0 = s->m3 * beta_v_0;
  const float m_1 = s->m4 * beta_v_1;
  const float m_2 = s->m5 * beta_v_2;
  const float m_3 = s->m4 * beta_v_0;
  const float m_4 = s->m5 * beta_v_0;
  const float m_5 = s->m5 * beta_v_1;
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = 0.5f * s->m3;
  const float alpha_v_1 = 0.5f * s->m4;
  const float alpha_v_2 = 0.5f * s->m5;
  const float J_1 = m_3 - alpha_v_2;
  const float J_2 = m_4 + alpha_v_1;
  const float J_3 = m_3 + alpha_v_2;
  const float J_5 = m_5 - alpha_v_0;
  const float J_6 = m_4 - alpha_v_1;
  const float J_7 = m_5 + alpha_v_0;
  const float b_rate_across_a = 2.0f - half_cotangent, b_rate_across = b_rate_across_a / b_divisor;
  const float b_rate_square_a = cotangent * cotangent, b_rate_square_b = 0.25f * b_rate_square_a,
      b_rate_square = 0.25f + b_rate_square_b;
  const float b_rate_rest = b_rate_square - b_rate_across;
  const float closed_b_rate = b_rate_rest / b_divisor;
  const float b_rate_a = 3.3612244e-29f * x, b_rate_b = b_rate_a + 1.2532382e-27f,
      b_rate_c = x * b_rate_b, b_rate_d = b_rate_c + 4.656552e-26f, b_rate_e = x * b_rate_d,
      b_rate_f = b_rate_e + 1.7234372e-24f, b_rate_g = x * b_rate_f,
      b_rate_h = b_rate_g + 6.350267e-23f, b_rate_i = x * b_rate_h,
      b_rate_j = b_rate_i + 2.3279144e-21f, b_rate_k = x * b_rate_j,
      b_rate_l = b_rate_k + 8.483297e-20f, b_rate_m = x * b_rate_l,
      b_rate_n = b_rate_m + 3.0699822e-18f, b_rate_o = x * b_rate_n,
      b_rate_p = b_rate_o + 1.10180054e-16f, b_rate_q = x * b_rate_p,
      b_rate_r = b_rate_q + 3.9147635e-15f, b_rate_s = x * b_rate_r,
      b_rate_t = b_rate_s + 1.37377e-13f, b_rate_u = x * b_rate_t,
      b_rate_v = b_rate_u + 4.7455525e-12f, b_rate_w = x * b_rate_v,
      b_rate_x = b_rate_w + 1.6059044e-10f, b_rate_y = x * b_rate_x,
      b_rate_z = b_rate_y + 5.28419e-09f, b_rate_aa = x * b_rate_z,
      b_rate_ab = b_rate_aa + 1.6701405e-07f, b_rate_ac = x * b_rate_ab,
      b_rate_ad = b_rate_ac + 4.9603173e-06f, b_rate_ae = x * b_rate_ad,
      b_rate_af = b_rate_ae + 0.00013227513f, b_rate_ag = x * b_rate_af,
      b_rate_ah = b_rate_ag + 0.0027777778f, b_rate = x < 4.0f ? b_rate_ah : closed_b_rate;
  const float rate_vw_a = s->m0 * s->m3, rate_vw_b = s->m1 * s->m4,
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = s->m2 * s->m5, rate_vw = rate_vw_c + rate_vw_d;
  const float rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const float rate_q_0 = 0.5f * s->m0;
  const float rate_q_1 = 0.5f * s->m1;
  const float rate_q_2 = 0.5f * s->m2;
  const float rate_beta_v_0a = s->m0 * b, rate_beta_v_0 = -rate_beta_v_0a;
  const float rate_beta_v_1a = s->m1 * b, rate_beta_v_1 = -rate_beta_v_1a;
  const float rate_beta_v_2a = s->m2 * b, rate_beta_v_2 = -rate_beta_v_2a;
  const float rate_bend_w_0a = s->m3 * rate_bend, rate_bend_w_0 = -rate_bend_w_0a;
  const float rate_bend_w_1a = s->m4 * rate_bend, rate_bend_w_1 = -rate_bend_w_1a;
  const float rate_bend_w_2a = s->m5 * rate_bend, rate_bend_w_2 = -rate_bend_w_2a;
  const float rate_symmetric_0a = s->m4 * rate_bend_w_0, rate_symmetric_0b = s->m3 * rate_beta_v_1,
      rate_symmetric_0c = s->m4 * rate_beta_v_0,
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d;
  const float rate_symmetric_1a = s->m5 * rate_bend_w_0, rate_symmetric_1b = s->m3 * rate_beta_v_2,
      rate_symmetric_1c = s->m5 * rate_beta_v_0,
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d;
  const float rate_symmetric_2a = s->m5 * rate_bend_w_1, rate_symmetric_2b = s->m4 * rate_beta_v_2,
      rate_symmetric_2c = s->m5 * rate_beta_v_1,
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d;
  const float rate_diagonal_0a = 2.0f * s->m4, rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1,
      rate_diagonal_0c = 2.0f * s->m5, rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2,
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = s->m4 * rate_bend_w_1, rate_diagonal_0g = s->m5 * rate_bend_w_2,
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const float rate_diagonal_1a = 2.0f * s->m3, rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0,
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = s->m3 * rate_bend_w_0,
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const float rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const float M_04 = rate_symmetric_0 - rate_q_2;
  const float M_05 = rate_q_1 + rate_symmetric_1;
  const float M_13 = rate_q_2 + rate_symmetric_0;
  const float M_15 = rate_symmetric_2 - rate_q_0;
  const float M_23 = rate_symmetric_1 - rate_q_1;
  const float M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   208 mul, 192 add, 7 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 5 neg, 7 abs, 20 less, 1 equal, 42
     select.
   Error <= R: 12 u, t: 20 u of its largest component, or of D1.t or D2.t if that is larger for
     D1 a rotation and D2 a rotation and 0 <= k <= 1; searched, not proved. */
static inline void ksl_SE3f_interpolated(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    const float k, ksl_SE3f_t *Do) {
  const float apart_0 = D2->m03 - D1->m03;
  const float apart_1 = D2->m13 - D1->m13;
  const float apart_2 = D2->m23 - D1->m23;
  const float between_0a = D1->m00 * D2->m00, between_0b = D1->m10 * D2->m10,
      between_0c = between_0a + between_0b, between_0d = D1->m20 * D2->m20,
      between_0 = between_0c + between_0d;
  const float between_1a = D1->m00 * D2->m01, between_1b = D1->m10 * D2->m11,
      between_1c = between_1a + between_1b, between_1d = D1->m20 * D2->m21,
      between_1 = between_1c + between_1d;
  const float between_2a = D1->m00 * D2->m02, between_2b = D1->m10 * D2->m12,
      between_2c = between_2a + between_2b, between_2d = D1->m20 * D2->m22,
      between_2 = between_2c + between_2d;
  const float between_3a = D1->m00 * apart_0, between_3b = D1->m10 * apart_1,
      between_3c = between_3a + between_3b, between_3d = D1->m20 * apart_2,
      between_3 = between_3c + between_3d;
  const float between_4a = D1->m01 * D2->m00, between_4b = D1->m11 * D2->m10,
      between_4c = between_4a + between_4b, between_4d = D1->m21 * D2->m20,
      between_4 = between_4c + between_4d;
  const float between_5a = D1->m01 * D2->m01, between_5b = D1->m11 * D2->m11,
      between_5c = between_5a + between_5b, between_5d = D1->m21 * D2->m21,
      between_5 = between_5c + between_5d;
  const float between_6a = D1->m01 * D2->m02, between_6b = D1->m11 * D2->m12,
      between_6c = between_6a + between_6b, between_6d = D1->m21 * D2->m22,
      between_6 = between_6c + between_6d;
  const float between_7a = D1->m01 * apart_0, between_7b = D1->m11 * apart_1,
      between_7c = between_7a + between_7b, between_7d = D1->m21 * apart_2,
      between_7 = between_7c + between_7d;
  const float between_8a = D1->m02 * D2->m00, between_8b = D1->m12 * D2->m10,
      between_8c = between_8a + between_8b, between_8d = D1->m22 * D2->m20,
      between_8 = between_8c + between_8d;
  const float between_9a = D1->m02 * D2->m01, between_9b = D1->m12 * D2->m11,
      between_9c = between_9a + between_9b, between_9d = D1->m22 * D2->m21,
      between_9 = between_9c + between_9d;
  const float between_10a = D1->m02 * D2->m02, between_10b = D1->m12 * D2->m12,
      between_10c = between_10a + between_10b, between_10d = D1->m22 * D2->m22,
      between_10 = between_10c + between_10d;
  const float between_11a = D1->m02 * apart_0, between_11b = D1->m12 * apart_1,
      between_11c = between_11a + between_11b, between_11d = D1->m22 * apart_2,
      between_11 = between_11c + between_11d;
  const float log_p_0 = between_9 - between_6;
  const float log_p_1 = between_2 - between_8;
  const float log_p_2 = between_4 - between_1;
  const float log_s_0 = between_6 + between_9;
  const float log_s_1 = between_2 + between_8;
  const float log_s_2 = between_1 + between_4;
  const float log_first_0 = between_0 + 1.0f;
  const float log_first_1 = 1.0f - between_0;
  const float log_others_0 = between_5 + between_10;
  const float log_others_1 = between_5 - between_10;
  const float log_d_0 = log_first_0 + log_others_0;
  const float log_d_1 = log_first_0 - log_others_0;
  const float log_d_2 = log_first_1 + log_others_1;
  const float log_d_3 = log_first_1 - log_others_1;
  const float log_low_0 = between_5 < between_0 ? log_d_1 : log_s_2;
  const float log_low_1 = between_5 < between_0 ? log_s_2 : log_d_2;
  const float log_low_2 = between_5 < between_0 ? log_s_1 : log_s_0;
  const float log_low_3 = between_5 < between_0 ? log_p_0 : log_p_1;
  const float log_high_0a = -between_5, log_high_0 = between_0 < log_high_0a ? log_s_1 : log_p_0;
  const float log_high_1 = between_0 < log_high_0a ? log_s_0 : log_p_1;
  const float log_high_2 = between_0 < log_high_0a ? log_d_3 : log_p_2;
  const float log_high_3 = between_0 < log_high_0a ? log_p_2 : log_d_0;
  const float log_column_0 = between_10 < 0.0f ? log_low_0 : log_high_0;
  const float log_column_1 = between_10 < 0.0f ? log_low_1 : log_high_1;
  const float log_column_2 = between_10 < 0.0f ? log_low_2 : log_high_2;
  const float log_column_3 = between_10 < 0.0f ? log_low_3 : log_high_3;
  const float log_upper_0a = -log_column_0,
      log_upper_0 = log_column_3 < 0.0f ? log_upper_0a : log_column_0;
  const float log_upper_1a = -log_column_1,
      log_upper_1 = log_column_3 < 0.0f ? log_upper_1a : log_column_1;
  const float log_upper_2a = -log_column_2,
      log_upper_2 = log_column_3 < 0.0f ? log_upper_2a : log_column_2;
  const float log_upper_3a = -log_column_3,
      log_upper_3 = log_column_3 < 0.0f ? log_upper_3a : log_column_3;
  const float log_v_s_size_0 = fabsf(log_upper_0);
  const float log_v_s_size_1 = fabsf(log_upper_1);
  const float log_v_s_size_2 = fabsf(log_upper_2);
  const float log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const float log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2 : log_v_s_largest1;
  const float log_v_s_b = 4.611686e+18f < log_v_s_largest2 ? 2.7105054e-20f : 1.0f,
      log_v_s_d = log_v_s_largest2 < 256.0f ? 1.8014399e+16f : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : log_v_s_d;
  const float log_v_y_0 = log_upper_0 * log_v_s;
  const float log_v_y_1 = log_upper_1 * log_v_s;
  const float log_v_y_2 = log_upper_2 * log_v_s;
  const float log_v_n_a = log_v_y_0 * log_v_y_0, log_v_n_b = log_v_y_1 * log_v_y_1,
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_d = log_v_y_2 * log_v_y_2,
      log_v_n_e = log_v_n_c + log_v_n_d, log_v_n = sqrtf(log_v_n_e);
  const float log_v_r_b = log_v_s < 1.0f ? 3.689349e+19f : 1.0f,
      log_v_r_d = 1.0f < log_v_s ? 5.551115e-17f : log_v_r_b,
      log_v_r = 1.8014399e+16f < log_v_s ? 3.081488e-33f : log_v_r_d;
  const float log_n = log_v_n * log_v_r;
  const float log_half = atan2f(log_n, log_upper_3);
  const float log_divisor = log_n == 0.0f ? 1.0f : log_n;
  const float log_theta = 2.0f * log_half;
  const float log_k = log_theta / log_divisor;
  const float log_vector_0 = log_upper_0 * log_k;
  const float log_vector_1 = log_upper_1 * log_k;
  const float log_vector_2 = log_upper_2 * log_k;
  const float log_x = log_theta * log_theta;
  const float log_far_sine = log_x < 1.0f ? 1.0f : log_n;
  const float log_cotangent = log_upper_3 / log_far_sine;
  const float log_half_cotangent_a = 0.5f * log_theta,
      log_half_cotangent = log_half_cotangent_a * log_cotangent;
  const float log_b_rest = 1.0f - log_half_cotangent;
  const float log_b_divisor = log_x < 4.0f ? 4.0f : log_x;
  const float log_closed_b = log_b_rest / log_b_divisor;
  const float log_b_a = 1.4551725e-27f * log_x, log_b_b = log_b_a + 5.744791e-26f,
      log_b_c = log_x * log_b_b, log_b_d = log_b_c + 2.2679524e-24f, log_b_e = log_x * log_b_d,
      log_b_f = log_b_e + 8.9535176e-23f, log_b_g = log_x * log_b_f,
      log_b_h = log_b_g + 3.534707e-21f, log_b_i = log_x * log_b_h,
      log_b_j = log_b_i + 1.3954465e-19f, log_b_k = log_x * log_b_j,
      log_b_l = log_b_k + 5.509003e-18f, log_b_m = log_x * log_b_l,
      log_b_n = log_b_m + 2.1748687e-16f, log_b_o = log_x * log_b_n,
      log_b_p = log_b_o + 8.586062e-15f, log_b_q = log_x * log_b_p,
      log_b_r = log_b_q + 3.3896803e-13f, log_b_s = log_x * log_b_r,
      log_b_t = log_b_s + 1.3382536e-11f, log_b_u = log_x * log_b_t,
      log_b_v = log_b_u + 5.2841903e-10f, log_b_w = log_x * log_b_v,
      log_b_x = log_b_w + 2.0876756e-08f, log_b_y = log_x * log_b_x,
      log_b_z = log_b_y + 8.267196e-07f, log_b_aa = log_x * log_b_z,
      log_b_ab = log_b_aa + 3.3068784e-05f, log_b_ac = log_x * log_b_ab,
      log_b_ad = log_b_ac + 0.0013888889f, log_b_ae = log_x * log_b_ad,
      log_b_af = log_b_ae + 0.083333336f, log_b = log_x < 4.0f ? log_b_af : log_closed_b;
  const float log_b_across_a = log_x * log_b, log_b_across_b = 1.0f - log_b_across_a,
      log_b_across = log_x < 4.0f ? log_b_across_b : log_half_cotangent;
  const float log_wt_a = between_3 * log_vector_0, log_wt_b = between_7 * log_vector_1,
      log_wt_c = log_wt_a + log_wt_b, log_wt_d = between_11 * log_vector_2,
      log_wt = log_wt_c + log_wt_d;
  const float log_pitch = log_b * log_wt;
  const float log_along_0 = log_vector_0 * log_pitch;
  const float log_along_1 = log_vector_1 * log_pitch;
  const float log_along_2 = log_vector_2 * log_pitch;
  const float log_u_0a = between_11 * log_vector_1, log_u_0b = between_7 * log_vector_2,
      log_u_0 = log_u_0a - log_u_0b;
  const float log_u_1a = between_3 * log_vector_2, log_u_1b = between_11 * log_vector_0,
      log_u_1 = log_u_1a - log_u_1b;
  const float log_u_2a = between_7 * log_vector_0, log_u_2b = between_3 * log_vector_1,
      log_u_2 = log_u_2a - log_u_2b;
  const float log_turned_0 = 0.5f * log_u_0;
  const float log_turned_1 = 0.5f * log_u_1;
  const float log_turned_2 = 0.5f * log_u_2;
  const float log_across_axis_0 = log_along_0 - log_turned_0;
  const float log_across_axis_1 = log_along_1 - log_turned_1;
  const float log_across_axis_2 = log_along_2 - log_turned_2;
  const float whole_0a = between_3 * log_b_across, whole_0 = whole_0a + log_across_axis_0;
  const float whole_1a = between_7 * log_b_across, whole_1 = whole_1a + log_across_axis_1;
  const float whole_2a = between_11 * log_b_across, whole_2 = whole_2a + log_across_axis_2;
  const float screw_0 = k * whole_0;
  const float screw_1 = k * whole_1;
  const float screw_2 = k * whole_2;
  const float screw_3 = k * log_vector_0;
  const float screw_4 = k * log_vector_1;
  const float screw_5 = k * log_vector_2;
  const float exp_size_0 = fabsf(screw_3);
  const float exp_size_1 = fabsf(screw_4);
  const float exp_size_2 = fabsf(screw_5);
  const float exp_sizes_a = exp_size_0 + exp_size_1, exp_sizes = exp_sizes_a + exp_size_2;
  const float exp_grid = exp_sizes * 8192.0f;
  const float exp_shifted_0 = screw_3 + exp_grid;
  const float exp_shifted_1 = screw_4 + exp_grid;
  const float exp_shifted_2 = screw_5 + exp_grid;
  const float exp_high_0 = exp_shifted_0 - exp_grid;
  const float exp_high_1 = exp_shifted_1 - exp_grid;
  const float exp_high_2 = exp_shifted_2 - exp_grid;
  const float exp_low_0 = screw_3 - exp_high_0;
  const float exp_low_1 = screw_4 - exp_high_1;
  const float exp_low_2 = screw_5 - exp_high_2;
  const float exp_sum_0 = screw_3 + exp_high_0;
  const float exp_sum_1 = screw_4 + exp_high_1;
  const float exp_sum_2 = screw_5 + exp_high_2;
  const float exp_squares_a = exp_high_0 * exp_high_0, exp_squares_b = exp_high_1 * exp_high_1,
      exp_squares_c = exp_squares_a + exp_squares_b, exp_squares_d = exp_high_2 * exp_high_2,
      exp_squares = exp_squares_c + exp_squares_d;
  const float exp_cross_a = exp_low_0 * exp_sum_0, exp_cross_b = exp_low_1 * exp_sum_1,
      exp_cross_c = exp_cross_a + exp_cross_b, exp_cross_d = exp_low_2 * exp_sum_2,
      exp_cross = exp_cross_c + exp_cross_d;
  const float exp_x = exp_squares + exp_cross;
  const float exp_theta_a = sqrtf(exp_x), exp_theta = exp_x < 1.0f ? 1.0f : exp_theta_a;
  const float exp_theta_shifted = exp_grid + exp_theta;
  const float exp_theta_high = exp_theta_shifted - exp_grid;
  const float exp_theta_low = exp_theta - exp_theta_high;
  const float exp_theta_sum = exp_theta + exp_theta_high;
  const float exp_cross_rest_a = exp_theta_low * exp_theta_sum,
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const float exp_exact_a = exp_theta_high * exp_theta_high, exp_exact = exp_squares - exp_exact_a;
  const float exp_residual = exp_cross_rest + exp_exact;
  const float exp_small_a = 0.5f * exp_residual, exp_small = exp_small_a / exp_theta;
  const float exp_delta_a = fabsf(exp_small),
      exp_delta = exp_delta_a < 0.0078125f ? exp_small : 0.0f;
  const float exp_far_sine_a = sinf(exp_theta), exp_far_sine = exp_x < 1.0f ? 1.0f : exp_far_sine_a;
  const float exp_far_cosine_a = cosf(exp_theta),
      exp_far_cosine = exp_x < 1.0f ? 0.0f : exp_far_cosine_a;
  const float exp_sine_a = exp_delta * exp_far_cosine, exp_sine = exp_sine_a + exp_far_sine;
  const float exp_cosine_a = exp_delta * exp_far_sine, exp_cosine = exp_far_cosine - exp_cosine_a;
  const float exp_far_x = exp_x < 1.0f ? 1.0f : exp_x;
  const float exp_middle_x = exp_x < 4.0f ? 4.0f : exp_x;
  const float exp_closed1 = exp_sine / exp_theta;
  const float exp_versine = 1.0f - exp_cosine;
  const float exp_closed2 = exp_versine / exp_far_x;
  const float exp_rest3 = 1.0f - exp_closed1;
  const float exp_closed3 = exp_rest3 / exp_middle_x;
  const float exp_g1a = 6.4469503e-26f * exp_x, exp_g1b = exp_g1a - 3.8681703e-23f,
      exp_g1c = exp_x * exp_g1b, exp_g1d = exp_g1c + 1.9572942e-20f, exp_g1e = exp_x * exp_g1d,
      exp_g1f = exp_g1e - 8.220635e-18f, exp_g1g = exp_x * exp_g1f,
      exp_g1h = exp_g1g + 2.8114574e-15f, exp_g1i = exp_x * exp_g1h,
      exp_g1j = exp_g1i - 7.6471636e-13f, exp_g1k = exp_x * exp_g1j,
      exp_g1l = exp_g1k + 1.6059044e-10f, exp_g1m = exp_x * exp_g1l,
      exp_g1n = exp_g1m - 2.5052108e-08f, exp_g1o = exp_x * exp_g1n,
      exp_g1p = exp_g1o + 2.7557319e-06f, exp_g1q = exp_x * exp_g1p,
      exp_g1r = exp_g1q - 0.0001984127f, exp_g1s = exp_x * exp_g1r,
      exp_g1t = exp_g1s + 0.008333334f, exp_g1u = exp_x * exp_g1t, exp_g1v = exp_g1u - 0.16666667f,
      exp_g1w = exp_x * exp_g1v, exp_g1x = exp_g1w + 1.0f,
      exp_g1 = exp_x < 1.0f ? exp_g1x : exp_closed1;
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
      exp_g2v = exp_g2u - 0.041666668f, exp_g2w = exp_x * exp_g2v, exp_g2x = exp_g2w + 0.5f,
      exp_g2 = exp_x < 1.0f ? exp_g2x : exp_closed2;
  const float exp_g3a = 9.18369e-29f * exp_x, exp_g3b = exp_g3a - 6.4469503e-26f,
      exp_g3c = exp_x * exp_g3b, exp_g3d = exp_g3c + 3.8681703e-23f, exp_g3e = exp_x * exp_g3d,
      exp_g3f = exp_g3e - 1.9572942e-20f, exp_g3g = exp_x * exp_g3f,
      exp_g3h = exp_g3g + 8.220635e-18f, exp_g3i = exp_x * exp_g3h,
      exp_g3j = exp_g3i - 2.8114574e-15f, exp_g3k = exp_x * exp_g3j,
      exp_g3l = exp_g3k + 7.6471636e-13f, exp_g3m = exp_x * exp_g3l,
      exp_g3n = exp_g3m - 1.6059044e-10f, exp_g3o = exp_x * exp_g3n,
      exp_g3p = exp_g3o + 2.5052108e-08f, exp_g3q = exp_x * exp_g3p,
      exp_g3r = exp_g3q - 2.7557319e-06f, exp_g3s = exp_x * exp_g3r,
      exp_g3t = exp_g3s + 0.0001984127f, exp_g3u = exp_x * exp_g3t,
      exp_g3v = exp_g3u - 0.008333334f, exp_g3w = exp_x * exp_g3v, exp_g3x = exp_g3w + 0.16666667f,
      exp_g3 = exp_x < 4.0f ? exp_g3x : exp_closed3;
  const float exp_g0a = exp_x * exp_g2, exp_g0b = 1.0f - exp_g0a,
      exp_g0 = exp_x < 1.0f ? exp_g0b : exp_cosine;
  const float exp_u_0a = screw_2 * screw_4, exp_u_0b = screw_1 * screw_5,
      exp_u_0 = exp_u_0a - exp_u_0b;
  const float exp_u_1a = screw_0 * screw_5, exp_u_1b = screw_2 * screw_3,
      exp_u_1 = exp_u_1a - exp_u_1b;
  const float exp_u_2a = screw_1 * screw_3, exp_u_2b = screw_0 * screw_4,
      exp_u_2 = exp_u_2a - exp_u_2b;
  const float exp_turned_0 = exp_g2 * exp_u_0;
  const float exp_turned_1 = exp_g2 * exp_u_1;
  const float exp_turned_2 = exp_g2 * exp_u_2;
  const float exp_wv_a = screw_0 * screw_3, exp_wv_b = screw_1 * screw_4,
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_d = screw_2 * screw_5, exp_wv = exp_wv_c + exp_wv_d;
  const float exp_pitch = exp_g3 * exp_wv;
  const float exp_along_0 = screw_3 * exp_pitch;
  const float exp_along_1 = screw_4 * exp_pitch;
  const float exp_along_2 = screw_5 * exp_pitch;
  const float exp_beta_v_0 = screw_3 * exp_g2;
  const float exp_beta_v_1 = screw_4 * exp_g2;
  const float exp_beta_v_2 = screw_5 * exp_g2;
  const float exp_m_0 = screw_3 * exp_beta_v_0;
  const float exp_m_1 = screw_4 * exp_beta_v_1;
  const float exp_m_2 = screw_5 * exp_beta_v_2;
  const float exp_m_3 = screw_4 * exp_beta_v_0;
  const float exp_m_4 = screw_5 * exp_beta_v_0;
  const float exp_m_5 = screw_5 * exp_beta_v_1;
  const float exp_others_0 = exp_m_1 + exp_m_2;
  const float exp_others_1 = exp_m_0 + exp_m_2;
  const float exp_others_2 = exp_m_0 + exp_m_1;
  const float exp_diagonal0a = 1.0f - exp_others_0, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0 = exp_m_0 < exp_others_0 ? exp_diagonal0b : exp_diagonal0a;
  const float exp_diagonal1a = 1.0f - exp_others_1, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1 = exp_m_1 < exp_others_1 ? exp_diagonal1b : exp_diagonal1a;
  const float exp_diagonal2a = 1.0f - exp_others_2, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2 = exp_m_2 < exp_others_2 ? exp_diagonal2b : exp_diagonal2a;
  const float exp_alpha_v_0 = screw_3 * exp_g1;
  const float exp_alpha_v_1 = screw_4 * exp_g1;
  const float exp_alpha_v_2 = screw_5 * exp_g1;
  const float exp_across_axis_0 = exp_turned_0 + exp_along_0;
  const float exp_across_axis_1 = exp_turned_1 + exp_along_1;
  const float exp_across_axis_2 = exp_turned_2 + exp_along_2;
  const float step_1 = exp_m_3 - exp_alpha_v_2;
  const float step_2 = exp_m_4 + exp_alpha_v_1;
  const float step_3a = screw_0 * exp_g1, step_3 = step_3a + exp_across_axis_0;
  const float step_4 = exp_m_3 + exp_alpha_v_2;
  const float step_6 = exp_m_5 - exp_alpha_v_0;
  const float step_7a = screw_1 * exp_g1, step_7 = step_7a + exp_across_axis_1;
  const float step_8 = exp_m_4 - exp_alpha_v_1;
  const float step_9 = exp_m_5 + exp_alpha_v_0;
  const float step_11a = screw_2 * exp_g1, step_11 = step_11a + exp_across_axis_2;
  const float Do_00a = D1->m00 * exp_diagonal0, Do_00b = D1->m01 * step_4,
      Do_00c = D1->m02 * step_8, Do_00d = Do_00b + Do_00c, Do_00 = Do_00a + Do_00d;
  const float Do_01a = D1->m00 * step_1, Do_01b = D1->m02 * step_9, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m01 * exp_diagonal1, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D1->m00 * step_2, Do_02b = D1->m01 * step_6, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * exp_diagonal2, Do_02 = Do_02c + Do_02d;
  const float Do_03a = D1->m00 * step_3, Do_03b = D1->m01 * step_7, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * step_11, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const float Do_10a = D1->m10 * exp_diagonal0, Do_10b = D1->m11 * step_4,
      Do_10c = D1->m12 * step_8, Do_10d = Do_10b + Do_10c, Do_10 = Do_10a + Do_10d;
  const float Do_11a = D1->m10 * step_1, Do_11b = D1->m12 * step_9, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m11 * exp_diagonal1, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D1->m10 * step_2, Do_12b = D1->m11 * step_6, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * exp_diagonal2, Do_12 = Do_12c + Do_12d;
  const float Do_13a = D1->m10 * step_3, Do_13b = D1->m11 * step_7, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * step_11, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const float Do_20a = D1->m20 * exp_diagonal0, Do_20b = D1->m21 * step_4,
      Do_20c = D1->m22 * step_8, Do_20d = Do_20b + Do_20c, Do_20 = Do_20a + Do_20d;
  const float Do_21a = D1->m20 * step_1, Do_21b = D1->m22 * step_9, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m21 * exp_diagonal1, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D1->m20 * step_2, Do_22b = D1->m21 * step_6, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * exp_diagonal2, Do_22 = Do_22c + Do_22d;
  const float Do_23a = D1->m20 * step_3, Do_23b = D1->m21 * step_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * step_11, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

#endif

/* Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b. */
#ifndef KSL_SYMMETRIC_H
#define KSL_SYMMETRIC_H


/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat3x3_ldl(const ksl_mat3x3_t *A, ksl_mat3x3_t *L) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0;
  const double l0_1 = A->m20 / divisor0;
  const double u1_0a = A->m10 * l0_0, u1_0 = A->m11 - u1_0a;
  const double u1_1a = A->m20 * l0_0, u1_1 = A->m21 - u1_1a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2a = A->m20 * l0_1, u2b = A->m22 - u2a, u2c = u1_1 * l1, u2 = u2b - u2c;
  const double part0a = A->m00 / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->m11 ? part1a : A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < A->m22 ? part2a : A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  L->m00 = A->m00;
  L->m01 = 0.0;
  L->m02 = 0.0;
  L->m10 = l0_0;
  L->m11 = u1_0;
  L->m12 = 0.0;
  L->m20 = l0_1;
  L->m21 = l1;
  L->m22 = u2;
  return smallest2;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   6 mul, 6 add, 3 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3_ldl_solve(const ksl_mat3x3_t *L, const ksl_vec3_t *b, ksl_vec3_t *x) {
  const double y1a = L->m10 * b->x, y1 = b->y - y1a;
  const double y2a = L->m20 * b->x, y2b = b->z - y2a, y2c = L->m21 * y1, y2 = y2b - y2c;
  const double z0 = b->x / L->m00;
  const double z1 = y1 / L->m11;
  const double z2 = y2 / L->m22;
  const double x1a = L->m21 * z2, x1 = z1 - x1a;
  const double x0a = L->m10 * x1, x0b = z0 - x0a, x0c = L->m20 * z2, x0 = x0b - x0c;
  x->x = x0;
  x->y = x1;
  x->z = z2;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where A is
     singular to rounding or indefinite (A - 50 u diag A is not positive definite), it is not
     positive, and x not a number.
   A: rotation or other 3×3 matrix; b, x: vector.
   32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat3x3_solve(const ksl_mat3x3_t *A, const ksl_vec3_t *b, ksl_vec3_t *x) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0;
  const double l0_1 = A->m20 / divisor0;
  const double u1_0a = A->m10 * l0_0, u1_0 = A->m11 - u1_0a;
  const double u1_1a = A->m20 * l0_0, u1_1 = A->m21 - u1_1a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2a = A->m20 * l0_1, u2b = A->m22 - u2a, u2c = u1_1 * l1, u2 = u2b - u2c;
  const double divisor2 = 0.0 < u2 ? u2 : 1.0;
  const double part0a = A->m00 / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->m11 ? part1a : A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < A->m22 ? part2a : A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double less_0 = A->m00 * 0.9999999999999944;
  const double less_1 = A->m11 * 0.9999999999999944;
  const double less_2 = A->m22 * 0.9999999999999944;
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = A->m10 / less_divisor0;
  const double less_l0_1 = A->m20 / less_divisor0;
  const double less_u1_0a = A->m10 * less_l0_0, less_u1_0 = less_1 - less_u1_0a;
  const double less_u1_1a = A->m20 * less_l0_0, less_u1_1 = A->m21 - less_u1_1a;
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1 = less_u1_1 / less_divisor1;
  const double less_u2a = A->m20 * less_l0_1, less_u2b = less_2 - less_u2a,
      less_u2c = less_u1_1 * less_l1, less_u2 = less_u2b - less_u2c;
  const double regular_b = 0.0 < less_u2 ? 1.0 : 0.0, regular_c = 0.0 < less_u1_0 ? regular_b : 0.0,
      regular = 0.0 < less_0 ? regular_c : 0.0;
  const double least = smallest2 < 0.0 ? smallest2 : 0.0;
  const double y1a = b->x * l0_0, y1 = b->y - y1a;
  const double y2a = b->x * l0_1, y2b = b->z - y2a, y2c = l1 * y1, y2 = y2b - y2c;
  const double z0 = b->x / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double x1a = l1 * z2, x1 = z1 - x1a;
  const double x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * z2, x0 = x0b - x0c;
  const double residual_0a = A->m00 * x0, residual_0b = b->x - residual_0a,
      residual_0c = A->m10 * x1, residual_0d = residual_0b - residual_0c, residual_0e = A->m20 * z2,
      residual_0 = residual_0d - residual_0e;
  const double residual_1a = A->m10 * x0, residual_1b = b->y - residual_1a,
      residual_1c = A->m11 * x1, residual_1d = residual_1b - residual_1c, residual_1e = A->m21 * z2,
      residual_1 = residual_1d - residual_1e;
  const double residual_2a = A->m20 * x0, residual_2b = b->z - residual_2a,
      residual_2c = A->m21 * x1, residual_2d = residual_2b - residual_2c, residual_2e = A->m22 * z2,
      residual_2 = residual_2d - residual_2e;
  const double refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const double refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_x1a = l1 * refined_z2, refined_x1 = refined_z1 - refined_x1a;
  const double refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_z2, refined_x0 = refined_x0b - refined_x0c;
  const double found_0 = x0 + refined_x0;
  const double found_1 = x1 + refined_x1;
  const double found_2 = z2 + refined_z2;
  const double pivot = regular == 1.0 ? smallest2 : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN;
  const double x_1 = regular == 1.0 ? found_1 : (double)NAN;
  const double x_2 = regular == 1.0 ? found_2 : (double)NAN;
  x->x = x_0;
  x->y = x_1;
  x->z = x_2;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat6x6_ldl(const ksl_mat6x6_t *A, ksl_mat6x6_t *L) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0;
  const double l0_1 = A->at[0][2] / divisor0;
  const double l0_2 = A->at[0][3] / divisor0;
  const double l0_3 = A->at[0][4] / divisor0;
  const double l0_4 = A->at[0][5] / divisor0;
  const double u1_0a = A->at[0][1] * l0_0, u1_0 = A->at[1][1] - u1_0a;
  const double u1_1a = A->at[0][2] * l0_0, u1_1 = A->at[1][2] - u1_1a;
  const double u1_2a = A->at[0][3] * l0_0, u1_2 = A->at[1][3] - u1_2a;
  const double u1_3a = A->at[0][4] * l0_0, u1_3 = A->at[1][4] - u1_3a;
  const double u1_4a = A->at[0][5] * l0_0, u1_4 = A->at[1][5] - u1_4a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1;
  const double l1_1 = u1_2 / divisor1;
  const double l1_2 = u1_3 / divisor1;
  const double l1_3 = u1_4 / divisor1;
  const double u2_0a = A->at[0][2] * l0_1, u2_0b = A->at[2][2] - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const double u2_1a = A->at[0][3] * l0_1, u2_1b = A->at[2][3] - u2_1a, u2_1c = u1_2 * l1_0,
      u2_1 = u2_1b - u2_1c;
  const double u2_2a = A->at[0][4] * l0_1, u2_2b = A->at[2][4] - u2_2a, u2_2c = u1_3 * l1_0,
      u2_2 = u2_2b - u2_2c;
  const double u2_3a = A->at[0][5] * l0_1, u2_3b = A->at[2][5] - u2_3a, u2_3c = u1_4 * l1_0,
      u2_3 = u2_3b - u2_3c;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2;
  const double l2_1 = u2_2 / divisor2;
  const double l2_2 = u2_3 / divisor2;
  const double u3_0a = A->at[0][3] * l0_2, u3_0b = A->at[3][3] - u3_0a, u3_0c = u1_2 * l1_1,
      u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const double u3_1a = A->at[0][4] * l0_2, u3_1b = A->at[3][4] - u3_1a, u3_1c = u1_3 * l1_1,
      u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const double u3_2a = A->at[0][5] * l0_2, u3_2b = A->at[3][5] - u3_2a, u3_2c = u1_4 * l1_1,
      u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3;
  const double l3_1 = u3_2 / divisor3;
  const double u4_0a = A->at[0][4] * l0_3, u4_0b = A->at[4][4] - u4_0a, u4_0c = u1_3 * l1_2,
      u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e, u4_0g = u3_1 * l3_0,
      u4_0 = u4_0f - u4_0g;
  const double u4_1a = A->at[0][5] * l0_3, u4_1b = A->at[4][5] - u4_1a, u4_1c = u1_4 * l1_2,
      u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e, u4_1g = u3_2 * l3_0,
      u4_1 = u4_1f - u4_1g;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5a = A->at[0][5] * l0_4, u5b = A->at[5][5] - u5a, u5c = u1_4 * l1_3,
      u5d = u5b - u5c, u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g,
      u5i = u4_1 * l4, u5 = u5h - u5i;
  const double part0a = A->at[0][0] / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0];
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = 0.0;
  L->at[2][0] = 0.0;
  L->at[3][0] = 0.0;
  L->at[4][0] = 0.0;
  L->at[5][0] = 0.0;
  L->at[0][1] = l0_0;
  L->at[1][1] = u1_0;
  L->at[2][1] = 0.0;
  L->at[3][1] = 0.0;
  L->at[4][1] = 0.0;
  L->at[5][1] = 0.0;
  L->at[0][2] = l0_1;
  L->at[1][2] = l1_0;
  L->at[2][2] = u2_0;
  L->at[3][2] = 0.0;
  L->at[4][2] = 0.0;
  L->at[5][2] = 0.0;
  L->at[0][3] = l0_2;
  L->at[1][3] = l1_1;
  L->at[2][3] = l2_0;
  L->at[3][3] = u3_0;
  L->at[4][3] = 0.0;
  L->at[5][3] = 0.0;
  L->at[0][4] = l0_3;
  L->at[1][4] = l1_2;
  L->at[2][4] = l2_1;
  L->at[3][4] = l3_0;
  L->at[4][4] = u4_0;
  L->at[5][4] = 0.0;
  L->at[0][5] = l0_4;
  L->at[1][5] = l1_3;
  L->at[2][5] = l2_2;
  L->at[3][5] = l3_1;
  L->at[4][5] = l4;
  L->at[5][5] = u5;
  return smallest5;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   30 mul, 30 add, 6 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6_ldl_solve(const ksl_mat6x6_t *L, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double y1a = L->at[0][1] * b->m0, y1 = b->m1 - y1a;
  const double y2a = L->at[0][2] * b->m0, y2b = b->m2 - y2a, y2c = L->at[1][2] * y1, y2 = y2b - y2c;
  const double y3a = L->at[0][3] * b->m0, y3b = b->m3 - y3a, y3c = L->at[1][3] * y1,
      y3d = y3b - y3c, y3e = L->at[2][3] * y2, y3 = y3d - y3e;
  const double y4a = L->at[0][4] * b->m0, y4b = b->m4 - y4a, y4c = L->at[1][4] * y1,
      y4d = y4b - y4c, y4e = L->at[2][4] * y2, y4f = y4d - y4e, y4g = L->at[3][4] * y3,
      y4 = y4f - y4g;
  const double y5a = L->at[0][5] * b->m0, y5b = b->m5 - y5a, y5c = L->at[1][5] * y1,
      y5d = y5b - y5c, y5e = L->at[2][5] * y2, y5f = y5d - y5e, y5g = L->at[3][5] * y3,
      y5h = y5f - y5g, y5i = L->at[4][5] * y4, y5 = y5h - y5i;
  const double z0 = b->m0 / L->at[0][0];
  const double z1 = y1 / L->at[1][1];
  const double z2 = y2 / L->at[2][2];
  const double z3 = y3 / L->at[3][3];
  const double z4 = y4 / L->at[4][4];
  const double z5 = y5 / L->at[5][5];
  const double x4a = L->at[4][5] * z5, x4 = z4 - x4a;
  const double x3a = L->at[3][4] * x4, x3b = z3 - x3a, x3c = L->at[3][5] * z5, x3 = x3b - x3c;
  const double x2a = L->at[2][3] * x3, x2b = z2 - x2a, x2c = L->at[2][4] * x4, x2d = x2b - x2c,
      x2e = L->at[2][5] * z5, x2 = x2d - x2e;
  const double x1a = L->at[1][2] * x2, x1b = z1 - x1a, x1c = L->at[1][3] * x3, x1d = x1b - x1c,
      x1e = L->at[1][4] * x4, x1f = x1d - x1e, x1g = L->at[1][5] * z5, x1 = x1f - x1g;
  const double x0a = L->at[0][1] * x1, x0b = z0 - x0a, x0c = L->at[0][2] * x2, x0d = x0b - x0c,
      x0e = L->at[0][3] * x3, x0f = x0d - x0e, x0g = L->at[0][4] * x4, x0h = x0f - x0g,
      x0i = L->at[0][5] * z5, x0 = x0h - x0i;
  x->m0 = x0;
  x->m1 = x1;
  x->m2 = x2;
  x->m3 = x3;
  x->m4 = x4;
  x->m5 = z5;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where A is
     singular to rounding or indefinite (A - 50 u diag A is not positive definite), it is not
     positive, and x not a number.
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat6x6_solve(const ksl_mat6x6_t *A, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0;
  const double l0_1 = A->at[0][2] / divisor0;
  const double l0_2 = A->at[0][3] / divisor0;
  const double l0_3 = A->at[0][4] / divisor0;
  const double l0_4 = A->at[0][5] / divisor0;
  const double u1_0a = A->at[0][1] * l0_0, u1_0 = A->at[1][1] - u1_0a;
  const double u1_1a = A->at[0][2] * l0_0, u1_1 = A->at[1][2] - u1_1a;
  const double u1_2a = A->at[0][3] * l0_0, u1_2 = A->at[1][3] - u1_2a;
  const double u1_3a = A->at[0][4] * l0_0, u1_3 = A->at[1][4] - u1_3a;
  const double u1_4a = A->at[0][5] * l0_0, u1_4 = A->at[1][5] - u1_4a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1;
  const double l1_1 = u1_2 / divisor1;
  const double l1_2 = u1_3 / divisor1;
  const double l1_3 = u1_4 / divisor1;
  const double u2_0a = A->at[0][2] * l0_1, u2_0b = A->at[2][2] - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const double u2_1a = A->at[0][3] * l0_1, u2_1b = A->at[2][3] - u2_1a, u2_1c = u1_2 * l1_0,
      u2_1 = u2_1b - u2_1c;
  const double u2_2a = A->at[0][4] * l0_1, u2_2b = A->at[2][4] - u2_2a, u2_2c = u1_3 * l1_0,
      u2_2 = u2_2b - u2_2c;
  const double u2_3a = A->at[0][5] * l0_1, u2_3b = A->at[2][5] - u2_3a, u2_3c = u1_4 * l1_0,
      u2_3 = u2_3b - u2_3c;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2;
  const double l2_1 = u2_2 / divisor2;
  const double l2_2 = u2_3 / divisor2;
  const double u3_0a = A->at[0][3] * l0_2, u3_0b = A->at[3][3] - u3_0a, u3_0c = u1_2 * l1_1,
      u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const double u3_1a = A->at[0][4] * l0_2, u3_1b = A->at[3][4] - u3_1a, u3_1c = u1_3 * l1_1,
      u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const double u3_2a = A->at[0][5] * l0_2, u3_2b = A->at[3][5] - u3_2a, u3_2c = u1_4 * l1_1,
      u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3;
  const double l3_1 = u3_2 / divisor3;
  const double u4_0a = A->at[0][4] * l0_3, u4_0b = A->at[4][4] - u4_0a, u4_0c = u1_3 * l1_2,
      u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e, u4_0g = u3_1 * l3_0,
      u4_0 = u4_0f - u4_0g;
  const double u4_1a = A->at[0][5] * l0_3, u4_1b = A->at[4][5] - u4_1a, u4_1c = u1_4 * l1_2,
      u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e, u4_1g = u3_2 * l3_0,
      u4_1 = u4_1f - u4_1g;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5a = A->at[0][5] * l0_4, u5b = A->at[5][5] - u5a, u5c = u1_4 * l1_3,
      u5d = u5b - u5c, u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g,
      u5i = u4_1 * l4, u5 = u5h - u5i;
  const double divisor5 = 0.0 < u5 ? u5 : 1.0;
  const double part0a = A->at[0][0] / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0];
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  const double less_0 = A->at[0][0] * 0.9999999999999944;
  const double less_1 = A->at[1][1] * 0.9999999999999944;
  const double less_2 = A->at[2][2] * 0.9999999999999944;
  const double less_3 = A->at[3][3] * 0.9999999999999944;
  const double less_4 = A->at[4][4] * 0.9999999999999944;
  const double less_5 = A->at[5][5] * 0.9999999999999944;
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = A->at[0][1] / less_divisor0;
  const double less_l0_1 = A->at[0][2] / less_divisor0;
  const double less_l0_2 = A->at[0][3] / less_divisor0;
  const double less_l0_3 = A->at[0][4] / less_divisor0;
  const double less_l0_4 = A->at[0][5] / less_divisor0;
  const double less_u1_0a = A->at[0][1] * less_l0_0, less_u1_0 = less_1 - less_u1_0a;
  const double less_u1_1a = A->at[0][2] * less_l0_0, less_u1_1 = A->at[1][2] - less_u1_1a;
  const double less_u1_2a = A->at[0][3] * less_l0_0, less_u1_2 = A->at[1][3] - less_u1_2a;
  const double less_u1_3a = A->at[0][4] * less_l0_0, less_u1_3 = A->at[1][4] - less_u1_3a;
  const double less_u1_4a = A->at[0][5] * less_l0_0, less_u1_4 = A->at[1][5] - less_u1_4a;
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1_0 = less_u1_1 / less_divisor1;
  const double less_l1_1 = less_u1_2 / less_divisor1;
  const double less_l1_2 = less_u1_3 / less_divisor1;
  const double less_l1_3 = less_u1_4 / less_divisor1;
  const double less_u2_0a = A->at[0][2] * less_l0_1, less_u2_0b = less_2 - less_u2_0a,
      less_u2_0c = less_u1_1 * less_l1_0, less_u2_0 = less_u2_0b - less_u2_0c;
  const double less_u2_1a = A->at[0][3] * less_l0_1, less_u2_1b = A->at[2][3] - less_u2_1a,
      less_u2_1c = less_u1_2 * less_l1_0, less_u2_1 = less_u2_1b - less_u2_1c;
  const double less_u2_2a = A->at[0][4] * less_l0_1, less_u2_2b = A->at[2][4] - less_u2_2a,
      less_u2_2c = less_u1_3 * less_l1_0, less_u2_2 = less_u2_2b - less_u2_2c;
  const double less_u2_3a = A->at[0][5] * less_l0_1, less_u2_3b = A->at[2][5] - less_u2_3a,
      less_u2_3c = less_u1_4 * less_l1_0, less_u2_3 = less_u2_3b - less_u2_3c;
  const double less_divisor2 = 0.0 < less_u2_0 ? less_u2_0 : 1.0;
  const double less_l2_0 = less_u2_1 / less_divisor2;
  const double less_l2_1 = less_u2_2 / less_divisor2;
  const double less_l2_2 = less_u2_3 / less_divisor2;
  const double less_u3_0a = A->at[0][3] * less_l0_2, less_u3_0b = less_3 - less_u3_0a,
      less_u3_0c = less_u1_2 * less_l1_1, less_u3_0d = less_u3_0b - less_u3_0c,
      less_u3_0e = less_u2_1 * less_l2_0, less_u3_0 = less_u3_0d - less_u3_0e;
  const double less_u3_1a = A->at[0][4] * less_l0_2, less_u3_1b = A->at[3][4] - less_u3_1a,
      less_u3_1c = less_u1_3 * less_l1_1, less_u3_1d = less_u3_1b - less_u3_1c,
      less_u3_1e = less_u2_2 * less_l2_0, less_u3_1 = less_u3_1d - less_u3_1e;
  const double less_u3_2a = A->at[0][5] * less_l0_2, less_u3_2b = A->at[3][5] - less_u3_2a,
      less_u3_2c = less_u1_4 * less_l1_1, less_u3_2d = less_u3_2b - less_u3_2c,
      less_u3_2e = less_u2_3 * less_l2_0, less_u3_2 = less_u3_2d - less_u3_2e;
  const double less_divisor3 = 0.0 < less_u3_0 ? less_u3_0 : 1.0;
  const double less_l3_0 = less_u3_1 / less_divisor3;
  const double less_l3_1 = less_u3_2 / less_divisor3;
  const double less_u4_0a = A->at[0][4] * less_l0_3, less_u4_0b = less_4 - less_u4_0a,
      less_u4_0c = less_u1_3 * less_l1_2, less_u4_0d = less_u4_0b - less_u4_0c,
      less_u4_0e = less_u2_2 * less_l2_1, less_u4_0f = less_u4_0d - less_u4_0e,
      less_u4_0g = less_u3_1 * less_l3_0, less_u4_0 = less_u4_0f - less_u4_0g;
  const double less_u4_1a = A->at[0][5] * less_l0_3, less_u4_1b = A->at[4][5] - less_u4_1a,
      less_u4_1c = less_u1_4 * less_l1_2, less_u4_1d = less_u4_1b - less_u4_1c,
      less_u4_1e = less_u2_3 * less_l2_1, less_u4_1f = less_u4_1d - less_u4_1e,
      less_u4_1g = less_u3_2 * less_l3_0, less_u4_1 = less_u4_1f - less_u4_1g;
  const double less_divisor4 = 0.0 < less_u4_0 ? less_u4_0 : 1.0;
  const double less_l4 = less_u4_1 / less_divisor4;
  const double less_u5a = A->at[0][5] * less_l0_4, less_u5b = less_5 - less_u5a,
      less_u5c = less_u1_4 * less_l1_3, less_u5d = less_u5b - less_u5c,
      less_u5e = less_u2_3 * less_l2_2, less_u5f = less_u5d - less_u5e,
      less_u5g = less_u3_2 * less_l3_1, less_u5h = less_u5f - less_u5g,
      less_u5i = less_u4_1 * less_l4, less_u5 = less_u5h - less_u5i;
  const double regular_b = 0.0 < less_u5 ? 1.0 : 0.0, regular_c = 0.0 < less_u4_0 ? regular_b : 0.0,
      regular_d = 0.0 < less_u3_0 ? regular_c : 0.0, regular_e = 0.0 < less_u2_0 ? regular_d : 0.0,
      regular_f = 0.0 < less_u1_0 ? regular_e : 0.0, regular = 0.0 < less_0 ? regular_f : 0.0;
  const double least = smallest5 < 0.0 ? smallest5 : 0.0;
  const double y1a = b->m0 * l0_0, y1 = b->m1 - y1a;
  const double y2a = b->m0 * l0_1, y2b = b->m2 - y2a, y2c = l1_0 * y1, y2 = y2b - y2c;
  const double y3a = b->m0 * l0_2, y3b = b->m3 - y3a, y3c = l1_1 * y1, y3d = y3b - y3c,
      y3e = l2_0 * y2, y3 = y3d - y3e;
  const double y4a = b->m0 * l0_3, y4b = b->m4 - y4a, y4c = l1_2 * y1, y4d = y4b - y4c,
      y4e = l2_1 * y2, y4f = y4d - y4e, y4g = l3_0 * y3, y4 = y4f - y4g;
  const double y5a = b->m0 * l0_4, y5b = b->m5 - y5a, y5c = l1_3 * y1, y5d = y5b - y5c,
      y5e = l2_2 * y2, y5f = y5d - y5e, y5g = l3_1 * y3, y5h = y5f - y5g, y5i = l4 * y4,
      y5 = y5h - y5i;
  const double z0 = b->m0 / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double z3 = y3 / divisor3;
  const double z4 = y4 / divisor4;
  const double z5 = y5 / divisor5;
  const double x4a = l4 * z5, x4 = z4 - x4a;
  const double x3a = l3_0 * x4, x3b = z3 - x3a, x3c = l3_1 * z5, x3 = x3b - x3c;
  const double x2a = l2_0 * x3, x2b = z2 - x2a, x2c = l2_1 * x4, x2d = x2b - x2c, x2e = l2_2 * z5,
      x2 = x2d - x2e;
  const double x1a = l1_0 * x2, x1b = z1 - x1a, x1c = l1_1 * x3, x1d = x1b - x1c, x1e = l1_2 * x4,
      x1f = x1d - x1e, x1g = l1_3 * z5, x1 = x1f - x1g;
  const double x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * x2, x0d = x0b - x0c, x0e = l0_2 * x3,
      x0f = x0d - x0e, x0g = l0_3 * x4, x0h = x0f - x0g, x0i = l0_4 * z5, x0 = x0h - x0i;
  const double residual_0a = A->at[0][0] * x0, residual_0b = b->m0 - residual_0a,
      residual_0c = A->at[0][1] * x1, residual_0d = residual_0b - residual_0c,
      residual_0e = A->at[0][2] * x2, residual_0f = residual_0d - residual_0e,
      residual_0g = A->at[0][3] * x3, residual_0h = residual_0f - residual_0g,
      residual_0i = A->at[0][4] * x4, residual_0j = residual_0h - residual_0i,
      residual_0k = A->at[0][5] * z5, residual_0 = residual_0j - residual_0k;
  const double residual_1a = A->at[0][1] * x0, residual_1b = b->m1 - residual_1a,
      residual_1c = A->at[1][1] * x1, residual_1d = residual_1b - residual_1c,
      residual_1e = A->at[1][2] * x2, residual_1f = residual_1d - residual_1e,
      residual_1g = A->at[1][3] * x3, residual_1h = residual_1f - residual_1g,
      residual_1i = A->at[1][4] * x4, residual_1j = residual_1h - residual_1i,
      residual_1k = A->at[1][5] * z5, residual_1 = residual_1j - residual_1k;
  const double residual_2a = A->at[0][2] * x0, residual_2b = b->m2 - residual_2a,
      residual_2c = A->at[1][2] * x1, residual_2d = residual_2b - residual_2c,
      residual_2e = A->at[2][2] * x2, residual_2f = residual_2d - residual_2e,
      residual_2g = A->at[2][3] * x3, residual_2h = residual_2f - residual_2g,
      residual_2i = A->at[2][4] * x4, residual_2j = residual_2h - residual_2i,
      residual_2k = A->at[2][5] * z5, residual_2 = residual_2j - residual_2k;
  const double residual_3a = A->at[0][3] * x0, residual_3b = b->m3 - residual_3a,
      residual_3c = A->at[1][3] * x1, residual_3d = residual_3b - residual_3c,
      residual_3e = A->at[2][3] * x2, residual_3f = residual_3d - residual_3e,
      residual_3g = A->at[3][3] * x3, residual_3h = residual_3f - residual_3g,
      residual_3i = A->at[3][4] * x4, residual_3j = residual_3h - residual_3i,
      residual_3k = A->at[3][5] * z5, residual_3 = residual_3j - residual_3k;
  const double residual_4a = A->at[0][4] * x0, residual_4b = b->m4 - residual_4a,
      residual_4c = A->at[1][4] * x1, residual_4d = residual_4b - residual_4c,
      residual_4e = A->at[2][4] * x2, residual_4f = residual_4d - residual_4e,
      residual_4g = A->at[3][4] * x3, residual_4h = residual_4f - residual_4g,
      residual_4i = A->at[4][4] * x4, residual_4j = residual_4h - residual_4i,
      residual_4k = A->at[4][5] * z5, residual_4 = residual_4j - residual_4k;
  const double residual_5a = A->at[0][5] * x0, residual_5b = b->m5 - residual_5a,
      residual_5c = A->at[1][5] * x1, residual_5d = residual_5b - residual_5c,
      residual_5e = A->at[2][5] * x2, residual_5f = residual_5d - residual_5e,
      residual_5g = A->at[3][5] * x3, residual_5h = residual_5f - residual_5g,
      residual_5i = A->at[4][5] * x4, residual_5j = residual_5h - residual_5i,
      residual_5k = A->at[5][5] * z5, residual_5 = residual_5j - residual_5k;
  const double refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const double refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1_0 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const double refined_y3a = l0_2 * residual_0, refined_y3b = residual_3 - refined_y3a,
      refined_y3c = l1_1 * refined_y1, refined_y3d = refined_y3b - refined_y3c,
      refined_y3e = l2_0 * refined_y2, refined_y3 = refined_y3d - refined_y3e;
  const double refined_y4a = l0_3 * residual_0, refined_y4b = residual_4 - refined_y4a,
      refined_y4c = l1_2 * refined_y1, refined_y4d = refined_y4b - refined_y4c,
      refined_y4e = l2_1 * refined_y2, refined_y4f = refined_y4d - refined_y4e,
      refined_y4g = l3_0 * refined_y3, refined_y4 = refined_y4f - refined_y4g;
  const double refined_y5a = l0_4 * residual_0, refined_y5b = residual_5 - refined_y5a,
      refined_y5c = l1_3 * refined_y1, refined_y5d = refined_y5b - refined_y5c,
      refined_y5e = l2_2 * refined_y2, refined_y5f = refined_y5d - refined_y5e,
      refined_y5g = l3_1 * refined_y3, refined_y5h = refined_y5f - refined_y5g,
      refined_y5i = l4 * refined_y4, refined_y5 = refined_y5h - refined_y5i;
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_z3 = refined_y3 / divisor3;
  const double refined_z4 = refined_y4 / divisor4;
  const double refined_z5 = refined_y5 / divisor5;
  const double refined_x4a = l4 * refined_z5, refined_x4 = refined_z4 - refined_x4a;
  const double refined_x3a = l3_0 * refined_x4, refined_x3b = refined_z3 - refined_x3a,
      refined_x3c = l3_1 * refined_z5, refined_x3 = refined_x3b - refined_x3c;
  const double refined_x2a = l2_0 * refined_x3, refined_x2b = refined_z2 - refined_x2a,
      refined_x2c = l2_1 * refined_x4, refined_x2d = refined_x2b - refined_x2c,
      refined_x2e = l2_2 * refined_z5, refined_x2 = refined_x2d - refined_x2e;
  const double refined_x1a = l1_0 * refined_x2, refined_x1b = refined_z1 - refined_x1a,
      refined_x1c = l1_1 * refined_x3, refined_x1d = refined_x1b - refined_x1c,
      refined_x1e = l1_2 * refined_x4, refined_x1f = refined_x1d - refined_x1e,
      refined_x1g = l1_3 * refined_z5, refined_x1 = refined_x1f - refined_x1g;
  const double refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_x2, refined_x0d = refined_x0b - refined_x0c,
      refined_x0e = l0_2 * refined_x3, refined_x0f = refined_x0d - refined_x0e,
      refined_x0g = l0_3 * refined_x4, refined_x0h = refined_x0f - refined_x0g,
      refined_x0i = l0_4 * refined_z5, refined_x0 = refined_x0h - refined_x0i;
  const double found_0 = x0 + refined_x0;
  const double found_1 = x1 + refined_x1;
  const double found_2 = x2 + refined_x2;
  const double found_3 = x3 + refined_x3;
  const double found_4 = x4 + refined_x4;
  const double found_5 = z5 + refined_z5;
  const double pivot = regular == 1.0 ? smallest5 : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN;
  const double x_1 = regular == 1.0 ? found_1 : (double)NAN;
  const double x_2 = regular == 1.0 ? found_2 : (double)NAN;
  const double x_3 = regular == 1.0 ? found_3 : (double)NAN;
  const double x_4 = regular == 1.0 ? found_4 : (double)NAN;
  const double x_5 = regular == 1.0 ? found_5 : (double)NAN;
  x->m0 = x_0;
  x->m1 = x_1;
  x->m2 = x_2;
  x->m3 = x_3;
  x->m4 = x_4;
  x->m5 = x_5;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat3x3f_ldl(const ksl_mat3x3f_t *A, ksl_mat3x3f_t *L) {
  const float divisor0 = 0.0f < A->m00 ? A->m00 : 1.0f;
  const float l0_0 = A->m10 / divisor0;
  const float l0_1 = A->m20 / divisor0;
  const float u1_0a = A->m10 * l0_0, u1_0 = A->m11 - u1_0a;
  const float u1_1a = A->m20 * l0_0, u1_1 = A->m21 - u1_1a;
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1 = u1_1 / divisor1;
  const float u2a = A->m20 * l0_1, u2b = A->m22 - u2a, u2c = u1_1 * l1, u2 = u2b - u2c;
  const float part0a = A->m00 / divisor0, part0 = 0.0f < A->m00 ? part0a : A->m00;
  const float own1 = 0.0f < A->m11 ? A->m11 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->m11 ? part1a : A->m11;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->m22 ? A->m22 : 1.0f;
  const float part2a = u2 / own2, part2 = 0.0f < A->m22 ? part2a : A->m22;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  L->m00 = A->m00;
  L->m01 = 0.0f;
  L->m02 = 0.0f;
  L->m10 = l0_0;
  L->m11 = u1_0;
  L->m12 = 0.0f;
  L->m20 = l0_1;
  L->m21 = l1;
  L->m22 = u2;
  return smallest2;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   6 mul, 6 add, 3 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3f_ldl_solve(const ksl_mat3x3f_t *L, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const float y1a = L->m10 * b->x, y1 = b->y - y1a;
  const float y2a = L->m20 * b->x, y2b = b->z - y2a, y2c = L->m21 * y1, y2 = y2b - y2c;
  const float z0 = b->x / L->m00;
  const float z1 = y1 / L->m11;
  const float z2 = y2 / L->m22;
  const float x1a = L->m21 * z2, x1 = z1 - x1a;
  const float x0a = L->m10 * x1, x0b = z0 - x0a, x0c = L->m20 * z2, x0 = x0b - x0c;
  x->x = x0;
  x->y = x1;
  x->z = z2;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where A is
     singular to rounding or indefinite (A - 50 u diag A is not positive definite), it is not
     positive, and x not a number.
   A: rotation or other 3×3 matrix; b, x: vector.
   32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat3x3f_solve(const ksl_mat3x3f_t *A, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const float divisor0 = 0.0f < A->m00 ? A->m00 : 1.0f;
  const float l0_0 = A->m10 / divisor0;
  const float l0_1 = A->m20 / divisor0;
  const float u1_0a = A->m10 * l0_0, u1_0 = A->m11 - u1_0a;
  const float u1_1a = A->m20 * l0_0, u1_1 = A->m21 - u1_1a;
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1 = u1_1 / divisor1;
  const float u2a = A->m20 * l0_1, u2b = A->m22 - u2a, u2c = u1_1 * l1, u2 = u2b - u2c;
  const float divisor2 = 0.0f < u2 ? u2 : 1.0f;
  const float part0a = A->m00 / divisor0, part0 = 0.0f < A->m00 ? part0a : A->m00;
  const float own1 = 0.0f < A->m11 ? A->m11 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->m11 ? part1a : A->m11;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->m22 ? A->m22 : 1.0f;
  const float part2a = u2 / own2, part2 = 0.0f < A->m22 ? part2a : A->m22;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float less_0 = A->m00 * 0.999997f;
  const float less_1 = A->m11 * 0.999997f;
  const float less_2 = A->m22 * 0.999997f;
  const float less_divisor0 = 0.0f < less_0 ? less_0 : 1.0f;
  const float less_l0_0 = A->m10 / less_divisor0;
  const float less_l0_1 = A->m20 / less_divisor0;
  const float less_u1_0a = A->m10 * less_l0_0, less_u1_0 = less_1 - less_u1_0a;
  const float less_u1_1a = A->m20 * less_l0_0, less_u1_1 = A->m21 - less_u1_1a;
  const float less_divisor1 = 0.0f < less_u1_0 ? less_u1_0 : 1.0f;
  const float less_l1 = less_u1_1 / less_divisor1;
  const float less_u2a = A->m20 * less_l0_1, less_u2b = less_2 - less_u2a,
      less_u2c = less_u1_1 * less_l1, less_u2 = less_u2b - less_u2c;
  const float regular_b = 0.0f < less_u2 ? 1.0f : 0.0f,
      regular_c = 0.0f < less_u1_0 ? regular_b : 0.0f, regular = 0.0f < less_0 ? regular_c : 0.0f;
  const float least = smallest2 < 0.0f ? smallest2 : 0.0f;
  const float y1a = b->x * l0_0, y1 = b->y - y1a;
  const float y2a = b->x * l0_1, y2b = b->z - y2a, y2c = l1 * y1, y2 = y2b - y2c;
  const float z0 = b->x / divisor0;
  const float z1 = y1 / divisor1;
  const float z2 = y2 / divisor2;
  const float x1a = l1 * z2, x1 = z1 - x1a;
  const float x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * z2, x0 = x0b - x0c;
  const float residual_0a = A->m00 * x0, residual_0b = b->x - residual_0a,
      residual_0c = A->m10 * x1, residual_0d = residual_0b - residual_0c, residual_0e = A->m20 * z2,
      residual_0 = residual_0d - residual_0e;
  const float residual_1a = A->m10 * x0, residual_1b = b->y - residual_1a,
      residual_1c = A->m11 * x1, residual_1d = residual_1b - residual_1c, residual_1e = A->m21 * z2,
      residual_1 = residual_1d - residual_1e;
  const float residual_2a = A->m20 * x0, residual_2b = b->z - residual_2a,
      residual_2c = A->m21 * x1, residual_2d = residual_2b - residual_2c, residual_2e = A->m22 * z2,
      residual_2 = residual_2d - residual_2e;
  const float refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const float refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const float refined_z0 = residual_0 / divisor0;
  const float refined_z1 = refined_y1 / divisor1;
  const float refined_z2 = refined_y2 / divisor2;
  const float refined_x1a = l1 * refined_z2, refined_x1 = refined_z1 - refined_x1a;
  const float refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_z2, refined_x0 = refined_x0b - refined_x0c;
  const float found_0 = x0 + refined_x0;
  const float found_1 = x1 + refined_x1;
  const float found_2 = z2 + refined_z2;
  const float pivot = regular == 1.0f ? smallest2 : least;
  const float x_0 = regular == 1.0f ? found_0 : (float)NAN;
  const float x_1 = regular == 1.0f ? found_1 : (float)NAN;
  const float x_2 = regular == 1.0f ? found_2 : (float)NAN;
  x->x = x_0;
  x->y = x_1;
  x->z = x_2;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat6x6f_ldl(const ksl_mat6x6f_t *A, ksl_mat6x6f_t *L) {
  const float divisor0 = 0.0f < A->at[0][0] ? A->at[0][0] : 1.0f;
  const float l0_0 = A->at[0][1] / divisor0;
  const float l0_1 = A->at[0][2] / divisor0;
  const float l0_2 = A->at[0][3] / divisor0;
  const float l0_3 = A->at[0][4] / divisor0;
  const float l0_4 = A->at[0][5] / divisor0;
  const float u1_0a = A->at[0][1] * l0_0, u1_0 = A->at[1][1] - u1_0a;
  const float u1_1a = A->at[0][2] * l0_0, u1_1 = A->at[1][2] - u1_1a;
  const float u1_2a = A->at[0][3] * l0_0, u1_2 = A->at[1][3] - u1_2a;
  const float u1_3a = A->at[0][4] * l0_0, u1_3 = A->at[1][4] - u1_3a;
  const float u1_4a = A->at[0][5] * l0_0, u1_4 = A->at[1][5] - u1_4a;
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1;
  const float l1_1 = u1_2 / divisor1;
  const float l1_2 = u1_3 / divisor1;
  const float l1_3 = u1_4 / divisor1;
  const float u2_0a = A->at[0][2] * l0_1, u2_0b = A->at[2][2] - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const float u2_1a = A->at[0][3] * l0_1, u2_1b = A->at[2][3] - u2_1a, u2_1c = u1_2 * l1_0,
      u2_1 = u2_1b - u2_1c;
  const float u2_2a = A->at[0][4] * l0_1, u2_2b = A->at[2][4] - u2_2a, u2_2c = u1_3 * l1_0,
      u2_2 = u2_2b - u2_2c;
  const float u2_3a = A->at[0][5] * l0_1, u2_3b = A->at[2][5] - u2_3a, u2_3c = u1_4 * l1_0,
      u2_3 = u2_3b - u2_3c;
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2_0 = u2_1 / divisor2;
  const float l2_1 = u2_2 / divisor2;
  const float l2_2 = u2_3 / divisor2;
  const float u3_0a = A->at[0][3] * l0_2, u3_0b = A->at[3][3] - u3_0a, u3_0c = u1_2 * l1_1,
      u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const float u3_1a = A->at[0][4] * l0_2, u3_1b = A->at[3][4] - u3_1a, u3_1c = u1_3 * l1_1,
      u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const float u3_2a = A->at[0][5] * l0_2, u3_2b = A->at[3][5] - u3_2a, u3_2c = u1_4 * l1_1,
      u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const float divisor3 = 0.0f < u3_0 ? u3_0 : 1.0f;
  const float l3_0 = u3_1 / divisor3;
  const float l3_1 = u3_2 / divisor3;
  const float u4_0a = A->at[0][4] * l0_3, u4_0b = A->at[4][4] - u4_0a, u4_0c = u1_3 * l1_2,
      u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e, u4_0g = u3_1 * l3_0,
      u4_0 = u4_0f - u4_0g;
  const float u4_1a = A->at[0][5] * l0_3, u4_1b = A->at[4][5] - u4_1a, u4_1c = u1_4 * l1_2,
      u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e, u4_1g = u3_2 * l3_0,
      u4_1 = u4_1f - u4_1g;
  const float divisor4 = 0.0f < u4_0 ? u4_0 : 1.0f;
  const float l4 = u4_1 / divisor4;
  const float u5a = A->at[0][5] * l0_4, u5b = A->at[5][5] - u5a, u5c = u1_4 * l1_3, u5d = u5b - u5c,
      u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g, u5i = u4_1 * l4,
      u5 = u5h - u5i;
  const float part0a = A->at[0][0] / divisor0, part0 = 0.0f < A->at[0][0] ? part0a : A->at[0][0];
  const float own1 = 0.0f < A->at[1][1] ? A->at[1][1] : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->at[1][1] ? part1a : A->at[1][1];
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->at[2][2] ? A->at[2][2] : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < A->at[2][2] ? part2a : A->at[2][2];
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < A->at[3][3] ? A->at[3][3] : 1.0f;
  const float part3a = u3_0 / own3, part3 = 0.0f < A->at[3][3] ? part3a : A->at[3][3];
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  const float own4 = 0.0f < A->at[4][4] ? A->at[4][4] : 1.0f;
  const float part4a = u4_0 / own4, part4 = 0.0f < A->at[4][4] ? part4a : A->at[4][4];
  const float smallest4 = smallest3 < part4 ? smallest3 : part4;
  const float own5 = 0.0f < A->at[5][5] ? A->at[5][5] : 1.0f;
  const float part5a = u5 / own5, part5 = 0.0f < A->at[5][5] ? part5a : A->at[5][5];
  const float smallest5 = smallest4 < part5 ? smallest4 : part5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = 0.0f;
  L->at[2][0] = 0.0f;
  L->at[3][0] = 0.0f;
  L->at[4][0] = 0.0f;
  L->at[5][0] = 0.0f;
  L->at[0][1] = l0_0;
  L->at[1][1] = u1_0;
  L->at[2][1] = 0.0f;
  L->at[3][1] = 0.0f;
  L->at[4][1] = 0.0f;
  L->at[5][1] = 0.0f;
  L->at[0][2] = l0_1;
  L->at[1][2] = l1_0;
  L->at[2][2] = u2_0;
  L->at[3][2] = 0.0f;
  L->at[4][2] = 0.0f;
  L->at[5][2] = 0.0f;
  L->at[0][3] = l0_2;
  L->at[1][3] = l1_1;
  L->at[2][3] = l2_0;
  L->at[3][3] = u3_0;
  L->at[4][3] = 0.0f;
  L->at[5][3] = 0.0f;
  L->at[0][4] = l0_3;
  L->at[1][4] = l1_2;
  L->at[2][4] = l2_1;
  L->at[3][4] = l3_0;
  L->at[4][4] = u4_0;
  L->at[5][4] = 0.0f;
  L->at[0][5] = l0_4;
  L->at[1][5] = l1_3;
  L->at[2][5] = l2_2;
  L->at[3][5] = l3_1;
  L->at[4][5] = l4;
  L->at[5][5] = u5;
  return smallest5;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   30 mul, 30 add, 6 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6f_ldl_solve(const ksl_mat6x6f_t *L, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const float y1a = L->at[0][1] * b->m0, y1 = b->m1 - y1a;
  const float y2a = L->at[0][2] * b->m0, y2b = b->m2 - y2a, y2c = L->at[1][2] * y1, y2 = y2b - y2c;
  const float y3a = L->at[0][3] * b->m0, y3b = b->m3 - y3a, y3c = L->at[1][3] * y1, y3d = y3b - y3c,
      y3e = L->at[2][3] * y2, y3 = y3d - y3e;
  const float y4a = L->at[0][4] * b->m0, y4b = b->m4 - y4a, y4c = L->at[1][4] * y1, y4d = y4b - y4c,
      y4e = L->at[2][4] * y2, y4f = y4d - y4e, y4g = L->at[3][4] * y3, y4 = y4f - y4g;
  const float y5a = L->at[0][5] * b->m0, y5b = b->m5 - y5a, y5c = L->at[1][5] * y1, y5d = y5b - y5c,
      y5e = L->at[2][5] * y2, y5f = y5d - y5e, y5g = L->at[3][5] * y3, y5h = y5f - y5g,
      y5i = L->at[4][5] * y4, y5 = y5h - y5i;
  const float z0 = b->m0 / L->at[0][0];
  const float z1 = y1 / L->at[1][1];
  const float z2 = y2 / L->at[2][2];
  const float z3 = y3 / L->at[3][3];
  const float z4 = y4 / L->at[4][4];
  const float z5 = y5 / L->at[5][5];
  const float x4a = L->at[4][5] * z5, x4 = z4 - x4a;
  const float x3a = L->at[3][4] * x4, x3b = z3 - x3a, x3c = L->at[3][5] * z5, x3 = x3b - x3c;
  const float x2a = L->at[2][3] * x3, x2b = z2 - x2a, x2c = L->at[2][4] * x4, x2d = x2b - x2c,
      x2e = L->at[2][5] * z5, x2 = x2d - x2e;
  const float x1a = L->at[1][2] * x2, x1b = z1 - x1a, x1c = L->at[1][3] * x3, x1d = x1b - x1c,
      x1e = L->at[1][4] * x4, x1f = x1d - x1e, x1g = L->at[1][5] * z5, x1 = x1f - x1g;
  const float x0a = L->at[0][1] * x1, x0b = z0 - x0a, x0c = L->at[0][2] * x2, x0d = x0b - x0c,
      x0e = L->at[0][3] * x3, x0f = x0d - x0e, x0g = L->at[0][4] * x4, x0h = x0f - x0g,
      x0i = L->at[0][5] * z5, x0 = x0h - x0i;
  x->m0 = x0;
  x->m1 = x1;
  x->m2 = x2;
  x->m3 = x3;
  x->m4 = x4;
  x->m5 = z5;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where A is
     singular to rounding or indefinite (A - 50 u diag A is not positive definite), it is not
     positive, and x not a number.
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat6x6f_solve(const ksl_mat6x6f_t *A, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const float divisor0 = 0.0f < A->at[0][0] ? A->at[0][0] : 1.0f;
  const float l0_0 = A->at[0][1] / divisor0;
  const float l0_1 = A->at[0][2] / divisor0;
  const float l0_2 = A->at[0][3] / divisor0;
  const float l0_3 = A->at[0][4] / divisor0;
  const float l0_4 = A->at[0][5] / divisor0;
  const float u1_0a = A->at[0][1] * l0_0, u1_0 = A->at[1][1] - u1_0a;
  const float u1_1a = A->at[0][2] * l0_0, u1_1 = A->at[1][2] - u1_1a;
  const float u1_2a = A->at[0][3] * l0_0, u1_2 = A->at[1][3] - u1_2a;
  const float u1_3a = A->at[0][4] * l0_0, u1_3 = A->at[1][4] - u1_3a;
  const float u1_4a = A->at[0][5] * l0_0, u1_4 = A->at[1][5] - u1_4a;
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1;
  const float l1_1 = u1_2 / divisor1;
  const float l1_2 = u1_3 / divisor1;
  const float l1_3 = u1_4 / divisor1;
  const float u2_0a = A->at[0][2] * l0_1, u2_0b = A->at[2][2] - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const float u2_1a = A->at[0][3] * l0_1, u2_1b = A->at[2][3] - u2_1a, u2_1c = u1_2 * l1_0,
      u2_1 = u2_1b - u2_1c;
  const float u2_2a = A->at[0][4] * l0_1, u2_2b = A->at[2][4] - u2_2a, u2_2c = u1_3 * l1_0,
      u2_2 = u2_2b - u2_2c;
  const float u2_3a = A->at[0][5] * l0_1, u2_3b = A->at[2][5] - u2_3a, u2_3c = u1_4 * l1_0,
      u2_3 = u2_3b - u2_3c;
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2_0 = u2_1 / divisor2;
  const float l2_1 = u2_2 / divisor2;
  const float l2_2 = u2_3 / divisor2;
  const float u3_0a = A->at[0][3] * l0_2, u3_0b = A->at[3][3] - u3_0a, u3_0c = u1_2 * l1_1,
      u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const float u3_1a = A->at[0][4] * l0_2, u3_1b = A->at[3][4] - u3_1a, u3_1c = u1_3 * l1_1,
      u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const float u3_2a = A->at[0][5] * l0_2, u3_2b = A->at[3][5] - u3_2a, u3_2c = u1_4 * l1_1,
      u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const float divisor3 = 0.0f < u3_0 ? u3_0 : 1.0f;
  const float l3_0 = u3_1 / divisor3;
  const float l3_1 = u3_2 / divisor3;
  const float u4_0a = A->at[0][4] * l0_3, u4_0b = A->at[4][4] - u4_0a, u4_0c = u1_3 * l1_2,
      u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e, u4_0g = u3_1 * l3_0,
      u4_0 = u4_0f - u4_0g;
  const float u4_1a = A->at[0][5] * l0_3, u4_1b = A->at[4][5] - u4_1a, u4_1c = u1_4 * l1_2,
      u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e, u4_1g = u3_2 * l3_0,
      u4_1 = u4_1f - u4_1g;
  const float divisor4 = 0.0f < u4_0 ? u4_0 : 1.0f;
  const float l4 = u4_1 / divisor4;
  const float u5a = A->at[0][5] * l0_4, u5b = A->at[5][5] - u5a, u5c = u1_4 * l1_3, u5d = u5b - u5c,
      u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g, u5i = u4_1 * l4,
      u5 = u5h - u5i;
  const float divisor5 = 0.0f < u5 ? u5 : 1.0f;
  const float part0a = A->at[0][0] / divisor0, part0 = 0.0f < A->at[0][0] ? part0a : A->at[0][0];
  const float own1 = 0.0f < A->at[1][1] ? A->at[1][1] : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->at[1][1] ? part1a : A->at[1][1];
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->at[2][2] ? A->at[2][2] : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < A->at[2][2] ? part2a : A->at[2][2];
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < A->at[3][3] ? A->at[3][3] : 1.0f;
  const float part3a = u3_0 / own3, part3 = 0.0f < A->at[3][3] ? part3a : A->at[3][3];
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  const float own4 = 0.0f < A->at[4][4] ? A->at[4][4] : 1.0f;
  const float part4a = u4_0 / own4, part4 = 0.0f < A->at[4][4] ? part4a : A->at[4][4];
  const float smallest4 = smallest3 < part4 ? smallest3 : part4;
  const float own5 = 0.0f < A->at[5][5] ? A->at[5][5] : 1.0f;
  const float part5a = u5 / own5, part5 = 0.0f < A->at[5][5] ? part5a : A->at[5][5];
  const float smallest5 = smallest4 < part5 ? smallest4 : part5;
  const float less_0 = A->at[0][0] * 0.999997f;
  const float less_1 = A->at[1][1] * 0.999997f;
  const float less_2 = A->at[2][2] * 0.999997f;
  const float less_3 = A->at[3][3] * 0.999997f;
  const float less_4 = A->at[4][4] * 0.999997f;
  const float less_5 = A->at[5][5] * 0.999997f;
  const float less_divisor0 = 0.0f < less_0 ? less_0 : 1.0f;
  const float less_l0_0 = A->at[0][1] / less_divisor0;
  const float less_l0_1 = A->at[0][2] / less_divisor0;
  const float less_l0_2 = A->at[0][3] / less_divisor0;
  const float less_l0_3 = A->at[0][4] / less_divisor0;
  const float less_l0_4 = A->at[0][5] / less_divisor0;
  const float less_u1_0a = A->at[0][1] * less_l0_0, less_u1_0 = less_1 - less_u1_0a;
  const float less_u1_1a = A->at[0][2] * less_l0_0, less_u1_1 = A->at[1][2] - less_u1_1a;
  const float less_u1_2a = A->at[0][3] * less_l0_0, less_u1_2 = A->at[1][3] - less_u1_2a;
  const float less_u1_3a = A->at[0][4] * less_l0_0, less_u1_3 = A->at[1][4] - less_u1_3a;
  const float less_u1_4a = A->at[0][5] * less_l0_0, less_u1_4 = A->at[1][5] - less_u1_4a;
  const float less_divisor1 = 0.0f < less_u1_0 ? less_u1_0 : 1.0f;
  const float less_l1_0 = less_u1_1 / less_divisor1;
  const float less_l1_1 = less_u1_2 / less_divisor1;
  const float less_l1_2 = less_u1_3 / less_divisor1;
  const float less_l1_3 = less_u1_4 / less_divisor1;
  const float less_u2_0a = A->at[0][2] * less_l0_1, less_u2_0b = less_2 - less_u2_0a,
      less_u2_0c = less_u1_1 * less_l1_0, less_u2_0 = less_u2_0b - less_u2_0c;
  const float less_u2_1a = A->at[0][3] * less_l0_1, less_u2_1b = A->at[2][3] - less_u2_1a,
      less_u2_1c = less_u1_2 * less_l1_0, less_u2_1 = less_u2_1b - less_u2_1c;
  const float less_u2_2a = A->at[0][4] * less_l0_1, less_u2_2b = A->at[2][4] - less_u2_2a,
      less_u2_2c = less_u1_3 * less_l1_0, less_u2_2 = less_u2_2b - less_u2_2c;
  const float less_u2_3a = A->at[0][5] * less_l0_1, less_u2_3b = A->at[2][5] - less_u2_3a,
      less_u2_3c = less_u1_4 * less_l1_0, less_u2_3 = less_u2_3b - less_u2_3c;
  const float less_divisor2 = 0.0f < less_u2_0 ? less_u2_0 : 1.0f;
  const float less_l2_0 = less_u2_1 / less_divisor2;
  const float less_l2_1 = less_u2_2 / less_divisor2;
  const float less_l2_2 = less_u2_3 / less_divisor2;
  const float less_u3_0a = A->at[0][3] * less_l0_2, less_u3_0b = less_3 - less_u3_0a,
      less_u3_0c = less_u1_2 * less_l1_1, less_u3_0d = less_u3_0b - less_u3_0c,
      less_u3_0e = less_u2_1 * less_l2_0, less_u3_0 = less_u3_0d - less_u3_0e;
  const float less_u3_1a = A->at[0][4] * less_l0_2, less_u3_1b = A->at[3][4] - less_u3_1a,
      less_u3_1c = less_u1_3 * less_l1_1, less_u3_1d = less_u3_1b - less_u3_1c,
      less_u3_1e = less_u2_2 * less_l2_0, less_u3_1 = less_u3_1d - less_u3_1e;
  const float less_u3_2a = A->at[0][5] * less_l0_2, less_u3_2b = A->at[3][5] - less_u3_2a,
      less_u3_2c = less_u1_4 * less_l1_1, less_u3_2d = less_u3_2b - less_u3_2c,
      less_u3_2e = less_u2_3 * less_l2_0, less_u3_2 = less_u3_2d - less_u3_2e;
  const float less_divisor3 = 0.0f < less_u3_0 ? less_u3_0 : 1.0f;
  const float less_l3_0 = less_u3_1 / less_divisor3;
  const float less_l3_1 = less_u3_2 / less_divisor3;
  const float less_u4_0a = A->at[0][4] * less_l0_3, less_u4_0b = less_4 - less_u4_0a,
      less_u4_0c = less_u1_3 * less_l1_2, less_u4_0d = less_u4_0b - less_u4_0c,
      less_u4_0e = less_u2_2 * less_l2_1, less_u4_0f = less_u4_0d - less_u4_0e,
      less_u4_0g = less_u3_1 * less_l3_0, less_u4_0 = less_u4_0f - less_u4_0g;
  const float less_u4_1a = A->at[0][5] * less_l0_3, less_u4_1b = A->at[4][5] - less_u4_1a,
      less_u4_1c = less_u1_4 * less_l1_2, less_u4_1d = less_u4_1b - less_u4_1c,
      less_u4_1e = less_u2_3 * less_l2_1, less_u4_1f = less_u4_1d - less_u4_1e,
      less_u4_1g = less_u3_2 * less_l3_0, less_u4_1 = less_u4_1f - less_u4_1g;
  const float less_divisor4 = 0.0f < less_u4_0 ? less_u4_0 : 1.0f;
  const float less_l4 = less_u4_1 / less_divisor4;
  const float less_u5a = A->at[0][5] * less_l0_4, less_u5b = less_5 - less_u5a,
      less_u5c = less_u1_4 * less_l1_3, less_u5d = less_u5b - less_u5c,
      less_u5e = less_u2_3 * less_l2_2, less_u5f = less_u5d - less_u5e,
      less_u5g = less_u3_2 * less_l3_1, less_u5h = less_u5f - less_u5g,
      less_u5i = less_u4_1 * less_l4, less_u5 = less_u5h - less_u5i;
  const float regular_b = 0.0f < less_u5 ? 1.0f : 0.0f,
      regular_c = 0.0f < less_u4_0 ? regular_b : 0.0f,
      regular_d = 0.0f < less_u3_0 ? regular_c : 0.0f,
      regular_e = 0.0f < less_u2_0 ? regular_d : 0.0f,
      regular_f = 0.0f < less_u1_0 ? regular_e : 0.0f, regular = 0.0f < less_0 ? regular_f : 0.0f;
  const float least = smallest5 < 0.0f ? smallest5 : 0.0f;
  const float y1a = b->m0 * l0_0, y1 = b->m1 - y1a;
  const float y2a = b->m0 * l0_1, y2b = b->m2 - y2a, y2c = l1_0 * y1, y2 = y2b - y2c;
  const float y3a = b->m0 * l0_2, y3b = b->m3 - y3a, y3c = l1_1 * y1, y3d = y3b - y3c,
      y3e = l2_0 * y2, y3 = y3d - y3e;
  const float y4a = b->m0 * l0_3, y4b = b->m4 - y4a, y4c = l1_2 * y1, y4d = y4b - y4c,
      y4e = l2_1 * y2, y4f = y4d - y4e, y4g = l3_0 * y3, y4 = y4f - y4g;
  const float y5a = b->m0 * l0_4, y5b = b->m5 - y5a, y5c = l1_3 * y1, y5d = y5b - y5c,
      y5e = l2_2 * y2, y5f = y5d - y5e, y5g = l3_1 * y3, y5h = y5f - y5g, y5i = l4 * y4,
      y5 = y5h - y5i;
  const float z0 = b->m0 / divisor0;
  const float z1 = y1 / divisor1;
  const float z2 = y2 / divisor2;
  const float z3 = y3 / divisor3;
  const float z4 = y4 / divisor4;
  const float z5 = y5 / divisor5;
  const float x4a = l4 * z5, x4 = z4 - x4a;
  const float x3a = l3_0 * x4, x3b = z3 - x3a, x3c = l3_1 * z5, x3 = x3b - x3c;
  const float x2a = l2_0 * x3, x2b = z2 - x2a, x2c = l2_1 * x4, x2d = x2b - x2c, x2e = l2_2 * z5,
      x2 = x2d - x2e;
  const float x1a = l1_0 * x2, x1b = z1 - x1a, x1c = l1_1 * x3, x1d = x1b - x1c, x1e = l1_2 * x4,
      x1f = x1d - x1e, x1g = l1_3 * z5, x1 = x1f - x1g;
  const float x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * x2, x0d = x0b - x0c, x0e = l0_2 * x3,
      x0f = x0d - x0e, x0g = l0_3 * x4, x0h = x0f - x0g, x0i = l0_4 * z5, x0 = x0h - x0i;
  const float residual_0a = A->at[0][0] * x0, residual_0b = b->m0 - residual_0a,
      residual_0c = A->at[0][1] * x1, residual_0d = residual_0b - residual_0c,
      residual_0e = A->at[0][2] * x2, residual_0f = residual_0d - residual_0e,
      residual_0g = A->at[0][3] * x3, residual_0h = residual_0f - residual_0g,
      residual_0i = A->at[0][4] * x4, residual_0j = residual_0h - residual_0i,
      residual_0k = A->at[0][5] * z5, residual_0 = residual_0j - residual_0k;
  const float residual_1a = A->at[0][1] * x0, residual_1b = b->m1 - residual_1a,
      residual_1c = A->at[1][1] * x1, residual_1d = residual_1b - residual_1c,
      residual_1e = A->at[1][2] * x2, residual_1f = residual_1d - residual_1e,
      residual_1g = A->at[1][3] * x3, residual_1h = residual_1f - residual_1g,
      residual_1i = A->at[1][4] * x4, residual_1j = residual_1h - residual_1i,
      residual_1k = A->at[1][5] * z5, residual_1 = residual_1j - residual_1k;
  const float residual_2a = A->at[0][2] * x0, residual_2b = b->m2 - residual_2a,
      residual_2c = A->at[1][2] * x1, residual_2d = residual_2b - residual_2c,
      residual_2e = A->at[2][2] * x2, residual_2f = residual_2d - residual_2e,
      residual_2g = A->at[2][3] * x3, residual_2h = residual_2f - residual_2g,
      residual_2i = A->at[2][4] * x4, residual_2j = residual_2h - residual_2i,
      residual_2k = A->at[2][5] * z5, residual_2 = residual_2j - residual_2k;
  const float residual_3a = A->at[0][3] * x0, residual_3b = b->m3 - residual_3a,
      residual_3c = A->at[1][3] * x1, residual_3d = residual_3b - residual_3c,
      residual_3e = A->at[2][3] * x2, residual_3f = residual_3d - residual_3e,
      residual_3g = A->at[3][3] * x3, residual_3h = residual_3f - residual_3g,
      residual_3i = A->at[3][4] * x4, residual_3j = residual_3h - residual_3i,
      residual_3k = A->at[3][5] * z5, residual_3 = residual_3j - residual_3k;
  const float residual_4a = A->at[0][4] * x0, residual_4b = b->m4 - residual_4a,
      residual_4c = A->at[1][4] * x1, residual_4d = residual_4b - residual_4c,
      residual_4e = A->at[2][4] * x2, residual_4f = residual_4d - residual_4e,
      residual_4g = A->at[3][4] * x3, residual_4h = residual_4f - residual_4g,
      residual_4i = A->at[4][4] * x4, residual_4j = residual_4h - residual_4i,
      residual_4k = A->at[4][5] * z5, residual_4 = residual_4j - residual_4k;
  const float residual_5a = A->at[0][5] * x0, residual_5b = b->m5 - residual_5a,
      residual_5c = A->at[1][5] * x1, residual_5d = residual_5b - residual_5c,
      residual_5e = A->at[2][5] * x2, residual_5f = residual_5d - residual_5e,
      residual_5g = A->at[3][5] * x3, residual_5h = residual_5f - residual_5g,
      residual_5i = A->at[4][5] * x4, residual_5j = residual_5h - residual_5i,
      residual_5k = A->at[5][5] * z5, residual_5 = residual_5j - residual_5k;
  const float refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const float refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1_0 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const float refined_y3a = l0_2 * residual_0, refined_y3b = residual_3 - refined_y3a,
      refined_y3c = l1_1 * refined_y1, refined_y3d = refined_y3b - refined_y3c,
      refined_y3e = l2_0 * refined_y2, refined_y3 = refined_y3d - refined_y3e;
  const float refined_y4a = l0_3 * residual_0, refined_y4b = residual_4 - refined_y4a,
      refined_y4c = l1_2 * refined_y1, refined_y4d = refined_y4b - refined_y4c,
      refined_y4e = l2_1 * refined_y2, refined_y4f = refined_y4d - refined_y4e,
      refined_y4g = l3_0 * refined_y3, refined_y4 = refined_y4f - refined_y4g;
  const float refined_y5a = l0_4 * residual_0, refined_y5b = residual_5 - refined_y5a,
      refined_y5c = l1_3 * refined_y1, refined_y5d = refined_y5b - refined_y5c,
      refined_y5e = l2_2 * refined_y2, refined_y5f = refined_y5d - refined_y5e,
      refined_y5g = l3_1 * refined_y3, refined_y5h = refined_y5f - refined_y5g,
      refined_y5i = l4 * refined_y4, refined_y5 = refined_y5h - refined_y5i;
  const float refined_z0 = residual_0 / divisor0;
  const float refined_z1 = refined_y1 / divisor1;
  const float refined_z2 = refined_y2 / divisor2;
  const float refined_z3 = refined_y3 / divisor3;
  const float refined_z4 = refined_y4 / divisor4;
  const float refined_z5 = refined_y5 / divisor5;
  const float refined_x4a = l4 * refined_z5, refined_x4 = refined_z4 - refined_x4a;
  const float refined_x3a = l3_0 * refined_x4, refined_x3b = refined_z3 - refined_x3a,
      refined_x3c = l3_1 * refined_z5, refined_x3 = refined_x3b - refined_x3c;
  const float refined_x2a = l2_0 * refined_x3, refined_x2b = refined_z2 - refined_x2a,
      refined_x2c = l2_1 * refined_x4, refined_x2d = refined_x2b - refined_x2c,
      refined_x2e = l2_2 * refined_z5, refined_x2 = refined_x2d - refined_x2e;
  const float refined_x1a = l1_0 * refined_x2, refined_x1b = refined_z1 - refined_x1a,
      refined_x1c = l1_1 * refined_x3, refined_x1d = refined_x1b - refined_x1c,
      refined_x1e = l1_2 * refined_x4, refined_x1f = refined_x1d - refined_x1e,
      refined_x1g = l1_3 * refined_z5, refined_x1 = refined_x1f - refined_x1g;
  const float refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_x2, refined_x0d = refined_x0b - refined_x0c,
      refined_x0e = l0_2 * refined_x3, refined_x0f = refined_x0d - refined_x0e,
      refined_x0g = l0_3 * refined_x4, refined_x0h = refined_x0f - refined_x0g,
      refined_x0i = l0_4 * refined_z5, refined_x0 = refined_x0h - refined_x0i;
  const float found_0 = x0 + refined_x0;
  const float found_1 = x1 + refined_x1;
  const float found_2 = x2 + refined_x2;
  const float found_3 = x3 + refined_x3;
  const float found_4 = x4 + refined_x4;
  const float found_5 = z5 + refined_z5;
  const float pivot = regular == 1.0f ? smallest5 : least;
  const float x_0 = regular == 1.0f ? found_0 : (float)NAN;
  const float x_1 = regular == 1.0f ? found_1 : (float)NAN;
  const float x_2 = regular == 1.0f ? found_2 : (float)NAN;
  const float x_3 = regular == 1.0f ? found_3 : (float)NAN;
  const float x_4 = regular == 1.0f ? found_4 : (float)NAN;
  const float x_5 = regular == 1.0f ? found_5 : (float)NAN;
  x->m0 = x_0;
  x->m1 = x_1;
  x->m2 = x_2;
  x->m3 = x_3;
  x->m4 = x_4;
  x->m5 = x_5;
  return pivot;
}

#endif

/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin. */
#ifndef KSL_INERTIA_H
#define KSL_INERTIA_H


/* The inertia of these entries, in order. */
static inline ksl_inertia_t ksl_inertia(const double m, const double hx, const double hy,
    const double hz, const double xx, const double yy, const double zz,
    const double xy, const double xz, const double yz) {
  ksl_inertia_t value;
  value.m = m;
  value.h.x = hx;
  value.h.y = hy;
  value.h.z = hz;
  value.xx = xx;
  value.yy = yy;
  value.zz = zz;
  value.xy = xy;
  value.xz = xz;
  value.yz = yz;
  return value;
}

/* Bo = Bi.
   Bi, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz
     in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_inertia_copy(const ksl_inertia_t *Bi, ksl_inertia_t *Bo) {
  const double Bi_m = Bi->m;
  const double Bi_h_x = Bi->h.x;
  const double Bi_h_y = Bi->h.y;
  const double Bi_h_z = Bi->h.z;
  const double Bi_xx = Bi->xx;
  const double Bi_yy = Bi->yy;
  const double Bi_zz = Bi->zz;
  const double Bi_xy = Bi->xy;
  const double Bi_xz = Bi->xz;
  const double Bi_yz = Bi->yz;
  Bo->m = Bi_m;
  Bo->h.x = Bi_h_x;
  Bo->h.y = Bi_h_y;
  Bo->h.z = Bi_h_z;
  Bo->xx = Bi_xx;
  Bo->yy = Bi_yy;
  Bo->zz = Bi_zz;
  Bo->xy = Bi_xy;
  Bo->xz = Bi_xz;
  Bo->yz = Bi_yz;
}

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_scale(ksl_inertia_t *self, const double a) {
  const double self_0_new = self->m * a;
  const double self_1_new = self->h.x * a;
  const double self_2_new = self->h.y * a;
  const double self_3_new = self->h.z * a;
  const double self_4_new = self->xx * a;
  const double self_5_new = self->yy * a;
  const double self_6_new = self->zz * a;
  const double self_7_new = self->xy * a;
  const double self_8_new = self->xz * a;
  const double self_9_new = self->yz * a;
  self->m = self_0_new;
  self->h.x = self_1_new;
  self->h.y = self_2_new;
  self->h.z = self_3_new;
  self->xx = self_4_new;
  self->yy = self_5_new;
  self->zz = self_6_new;
  self->xy = self_7_new;
  self->xz = self_8_new;
  self->yz = self_9_new;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_BB(const ksl_inertia_t *B1, const ksl_inertia_t *B2, ksl_inertia_t *Bo) {
  const double Bo_0 = B1->m + B2->m;
  const double Bo_1 = B1->h.x + B2->h.x;
  const double Bo_2 = B1->h.y + B2->h.y;
  const double Bo_3 = B1->h.z + B2->h.z;
  const double Bo_4 = B1->xx + B2->xx;
  const double Bo_5 = B1->yy + B2->yy;
  const double Bo_6 = B1->zz + B2->zz;
  const double Bo_7 = B1->xy + B2->xy;
  const double Bo_8 = B1->xz + B2->xz;
  const double Bo_9 = B1->yz + B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_BB(const ksl_inertia_t *B1, const ksl_inertia_t *B2,
    ksl_inertia_t *Bo) {
  const double Bo_0 = B1->m - B2->m;
  const double Bo_1 = B1->h.x - B2->h.x;
  const double Bo_2 = B1->h.y - B2->h.y;
  const double Bo_3 = B1->h.z - B2->h.z;
  const double Bo_4 = B1->xx - B2->xx;
  const double Bo_5 = B1->yy - B2->yy;
  const double Bo_6 = B1->zz - B2->zz;
  const double Bo_7 = B1->xy - B2->xy;
  const double Bo_8 = B1->xz - B2->xz;
  const double Bo_9 = B1->yz - B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; of the symmetric matrix
     the upper triangle): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   9 mul, 9 add.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_from_com(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_inertia_t *Bo) {
  const double h_0 = m * com->x;
  const double h_1 = m * com->y;
  const double h_2 = m * com->z;
  const double squares_0 = com->x * h_0;
  const double squares_1 = com->y * h_1;
  const double squares_2 = com->z * h_2;
  const double Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const double Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const double Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const double Bo_7a = com->y * h_0, Bo_7 = Ic->m01 - Bo_7a;
  const double Bo_8a = com->z * h_0, Bo_8 = Ic->m02 - Bo_8a;
  const double Bo_9a = com->z * h_1, Bo_9 = Ic->m12 - Bo_9a;
  Bo->m = m;
  Bo->h.x = h_0;
  Bo->h.y = h_1;
  Bo->h.z = h_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 div.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_com(const ksl_inertia_t *B, ksl_vec3_t *vo) {
  const double vo_0 = B->h.x / B->m;
  const double vo_1 = B->h.y / B->m;
  const double vo_2 = B->h.z / B->m;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 div. */
static inline void ksl_inertia_about_com(const ksl_inertia_t *B, ksl_mat3x3_t *Ro) {
  const double c_0 = B->h.x / B->m;
  const double c_1 = B->h.y / B->m;
  const double c_2 = B->h.z / B->m;
  const double squares_0 = B->h.x * c_0;
  const double squares_1 = B->h.y * c_1;
  const double squares_2 = B->h.z * c_2;
  const double about_0a = squares_1 + squares_2, about_0 = B->xx - about_0a;
  const double about_1a = squares_0 + squares_2, about_1 = B->yy - about_1a;
  const double about_2a = squares_0 + squares_1, about_2 = B->zz - about_2a;
  const double about_3a = B->h.x * c_1, about_3 = about_3a + B->xy;
  const double about_4a = B->h.x * c_2, about_4 = about_4a + B->xz;
  const double about_5a = B->h.y * c_2, about_5 = about_5a + B->yz;
  Ro->m00 = about_0;
  Ro->m01 = about_3;
  Ro->m02 = about_4;
  Ro->m10 = about_3;
  Ro->m11 = about_1;
  Ro->m12 = about_5;
  Ro->m20 = about_4;
  Ro->m21 = about_5;
  Ro->m22 = about_2;
}

/* Mo = [[m 1, -h~], [h~, I]].
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Mo: 6×6 operator.
   3 neg.
   Exact. */
static inline void ksl_inertia_matrix(const ksl_inertia_t *B, ksl_mat6x6_t *Mo) {
  const double Mo_05 = -B->h.y;
  const double Mo_13 = -B->h.z;
  const double Mo_24 = -B->h.x;
  const double B_m = B->m;
  const double B_h_z = B->h.z;
  const double B_h_x = B->h.x;
  const double B_h_y = B->h.y;
  const double B_xx = B->xx;
  const double B_xy = B->xy;
  const double B_xz = B->xz;
  const double B_yy = B->yy;
  const double B_yz = B->yz;
  const double B_zz = B->zz;
  Mo->at[0][0] = B_m;
  Mo->at[1][0] = 0.0;
  Mo->at[2][0] = 0.0;
  Mo->at[3][0] = 0.0;
  Mo->at[4][0] = B_h_z;
  Mo->at[5][0] = Mo_05;
  Mo->at[0][1] = 0.0;
  Mo->at[1][1] = B_m;
  Mo->at[2][1] = 0.0;
  Mo->at[3][1] = Mo_13;
  Mo->at[4][1] = 0.0;
  Mo->at[5][1] = B_h_x;
  Mo->at[0][2] = 0.0;
  Mo->at[1][2] = 0.0;
  Mo->at[2][2] = B_m;
  Mo->at[3][2] = B_h_y;
  Mo->at[4][2] = Mo_24;
  Mo->at[5][2] = 0.0;
  Mo->at[0][3] = 0.0;
  Mo->at[1][3] = Mo_13;
  Mo->at[2][3] = B_h_y;
  Mo->at[3][3] = B_xx;
  Mo->at[4][3] = B_xy;
  Mo->at[5][3] = B_xz;
  Mo->at[0][4] = B_h_z;
  Mo->at[1][4] = 0.0;
  Mo->at[2][4] = Mo_24;
  Mo->at[3][4] = B_xy;
  Mo->at[4][4] = B_yy;
  Mo->at[5][4] = B_yz;
  Mo->at[0][5] = Mo_05;
  Mo->at[1][5] = B_h_x;
  Mo->at[2][5] = 0.0;
  Mo->at[3][5] = B_xz;
  Mo->at[4][5] = B_yz;
  Mo->at[5][5] = B_zz;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bs(const ksl_inertia_t *B, const ksl_screw_t *s, ksl_coscrew_t *co) {
  const double co_0a = B->m * s->m0, co_0b = B->h.z * s->m4, co_0c = B->h.y * s->m5,
      co_0d = co_0b - co_0c, co_0 = co_0a + co_0d;
  const double co_1a = B->m * s->m1, co_1b = B->h.x * s->m5, co_1c = B->h.z * s->m3,
      co_1d = co_1b - co_1c, co_1 = co_1a + co_1d;
  const double co_2a = B->m * s->m2, co_2b = B->h.y * s->m3, co_2c = B->h.x * s->m4,
      co_2d = co_2b - co_2c, co_2 = co_2a + co_2d;
  const double co_3a = B->h.y * s->m2, co_3b = B->h.z * s->m1, co_3c = co_3a - co_3b,
      co_3d = B->xx * s->m3, co_3e = B->xy * s->m4, co_3f = co_3d + co_3e, co_3g = B->xz * s->m5,
      co_3h = co_3f + co_3g, co_3 = co_3c + co_3h;
  const double co_4a = B->h.z * s->m0, co_4b = B->h.x * s->m2, co_4c = co_4a - co_4b,
      co_4d = B->yy * s->m4, co_4e = B->xy * s->m3, co_4f = co_4d + co_4e, co_4g = B->yz * s->m5,
      co_4h = co_4f + co_4g, co_4 = co_4c + co_4h;
  const double co_5a = B->h.x * s->m1, co_5b = B->h.y * s->m0, co_5c = co_5a - co_5b,
      co_5d = B->zz * s->m5, co_5e = B->xz * s->m3, co_5f = co_5d + co_5e, co_5g = B->yz * s->m4,
      co_5h = co_5f + co_5g, co_5 = co_5c + co_5h;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   28 mul, 17 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_inertia_energy(const ksl_inertia_t *B, const ksl_screw_t *s) {
  const double across_0a = B->h.z * s->m4, across_0b = B->h.y * s->m5,
      across_0 = across_0a - across_0b;
  const double across_1a = B->h.x * s->m5, across_1b = B->h.z * s->m3,
      across_1 = across_1a - across_1b;
  const double across_2a = B->h.y * s->m3, across_2b = B->h.x * s->m4,
      across_2 = across_2a - across_2b;
  const double twice_across_0 = 2.0 * across_0;
  const double twice_across_1 = 2.0 * across_1;
  const double twice_across_2 = 2.0 * across_2;
  const double p_0a = B->m * s->m0, p_0 = p_0a + twice_across_0;
  const double p_1a = B->m * s->m1, p_1 = p_1a + twice_across_1;
  const double p_2a = B->m * s->m2, p_2 = p_2a + twice_across_2;
  const double L_0a = B->xx * s->m3, L_0b = B->xy * s->m4, L_0c = L_0a + L_0b, L_0d = B->xz * s->m5,
      L_0 = L_0c + L_0d;
  const double L_1a = B->yy * s->m4, L_1b = B->xy * s->m3, L_1c = L_1a + L_1b, L_1d = B->yz * s->m5,
      L_1 = L_1c + L_1d;
  const double L_2a = B->zz * s->m5, L_2b = B->xz * s->m3, L_2c = L_2a + L_2b, L_2d = B->yz * s->m4,
      L_2 = L_2c + L_2d;
  const double twice_a = s->m0 * p_0, twice_b = s->m1 * p_1, twice_c = twice_a + twice_b,
      twice_d = s->m2 * p_2, twice_e = twice_c + twice_d, twice_f = s->m3 * L_0,
      twice_g = s->m4 * L_1, twice_h = twice_f + twice_g, twice_i = s->m5 * L_2,
      twice_j = twice_h + twice_i, twice = twice_e + twice_j;
  const double energy = 0.5 * twice;
  return energy;
}

/* Bo: the body moved by t: h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   18 mul, 18 add.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_shifted(const ksl_vec3_t *t, const ksl_inertia_t *B,
    ksl_inertia_t *Bo) {
  const double mt_0 = t->x * B->m;
  const double mt_1 = t->y * B->m;
  const double mt_2 = t->z * B->m;
  const double half_0 = 0.5 * mt_0;
  const double half_1 = 0.5 * mt_1;
  const double half_2 = 0.5 * mt_2;
  const double n_0 = B->h.x + half_0;
  const double n_1 = B->h.y + half_1;
  const double n_2 = B->h.z + half_2;
  const double tn0 = t->x * n_0;
  const double tn1 = t->y * n_1;
  const double tn2 = t->z * n_2;
  const double own_0 = 2.0 * tn0;
  const double own_1 = 2.0 * tn1;
  const double own_2 = 2.0 * tn2;
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = t->x * n_1, pairs_3b = t->y * n_0, pairs_3 = pairs_3a + pairs_3b;
  const double pairs_4a = t->x * n_2, pairs_4b = t->z * n_0, pairs_4 = pairs_4a + pairs_4b;
  const double pairs_5a = t->y * n_2, pairs_5b = t->z * n_1, pairs_5 = pairs_5a + pairs_5b;
  const double moved_0 = B->h.x + mt_0;
  const double moved_1 = B->h.y + mt_1;
  const double moved_2 = B->h.z + mt_2;
  const double Bo_4 = B->xx + pairs_0;
  const double Bo_5 = B->yy + pairs_1;
  const double Bo_6 = B->zz + pairs_2;
  const double Bo_7 = B->xy - pairs_3;
  const double Bo_8 = B->xz - pairs_4;
  const double Bo_9 = B->yz - pairs_5;
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): the inertia in the frame D takes its own to.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   72 mul, 54 add.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transformed(const ksl_SE3_t *D, const ksl_inertia_t *B,
    ksl_inertia_t *Bo) {
  const double RI_0a = D->m00 * B->xx, RI_0b = D->m01 * B->xy, RI_0c = RI_0a + RI_0b,
      RI_0d = D->m02 * B->xz, RI_0 = RI_0c + RI_0d;
  const double RI_1a = D->m00 * B->xy, RI_1b = D->m01 * B->yy, RI_1c = RI_1a + RI_1b,
      RI_1d = D->m02 * B->yz, RI_1 = RI_1c + RI_1d;
  const double RI_2a = D->m00 * B->xz, RI_2b = D->m01 * B->yz, RI_2c = RI_2a + RI_2b,
      RI_2d = D->m02 * B->zz, RI_2 = RI_2c + RI_2d;
  const double RI_3a = D->m10 * B->xx, RI_3b = D->m11 * B->xy, RI_3c = RI_3a + RI_3b,
      RI_3d = D->m12 * B->xz, RI_3 = RI_3c + RI_3d;
  const double RI_4a = D->m10 * B->xy, RI_4b = D->m11 * B->yy, RI_4c = RI_4a + RI_4b,
      RI_4d = D->m12 * B->yz, RI_4 = RI_4c + RI_4d;
  const double RI_5a = D->m10 * B->xz, RI_5b = D->m11 * B->yz, RI_5c = RI_5a + RI_5b,
      RI_5d = D->m12 * B->zz, RI_5 = RI_5c + RI_5d;
  const double RI_6a = D->m20 * B->xx, RI_6b = D->m21 * B->xy, RI_6c = RI_6a + RI_6b,
      RI_6d = D->m22 * B->xz, RI_6 = RI_6c + RI_6d;
  const double RI_7a = D->m20 * B->xy, RI_7b = D->m21 * B->yy, RI_7c = RI_7a + RI_7b,
      RI_7d = D->m22 * B->yz, RI_7 = RI_7c + RI_7d;
  const double RI_8a = D->m20 * B->xz, RI_8b = D->m21 * B->yz, RI_8c = RI_8a + RI_8b,
      RI_8d = D->m22 * B->zz, RI_8 = RI_8c + RI_8d;
  const double turned_1a = D->m00 * B->h.x, turned_1b = D->m01 * B->h.y,
      turned_1c = turned_1a + turned_1b, turned_1d = D->m02 * B->h.z,
      turned_1 = turned_1c + turned_1d;
  const double turned_2a = D->m10 * B->h.x, turned_2b = D->m11 * B->h.y,
      turned_2c = turned_2a + turned_2b, turned_2d = D->m12 * B->h.z,
      turned_2 = turned_2c + turned_2d;
  const double turned_3a = D->m20 * B->h.x, turned_3b = D->m21 * B->h.y,
      turned_3c = turned_3a + turned_3b, turned_3d = D->m22 * B->h.z,
      turned_3 = turned_3c + turned_3d;
  const double turned_4a = D->m00 * RI_0, turned_4b = D->m01 * RI_1,
      turned_4c = turned_4a + turned_4b, turned_4d = D->m02 * RI_2,
      turned_4 = turned_4c + turned_4d;
  const double turned_5a = D->m10 * RI_3, turned_5b = D->m11 * RI_4,
      turned_5c = turned_5a + turned_5b, turned_5d = D->m12 * RI_5,
      turned_5 = turned_5c + turned_5d;
  const double turned_6a = D->m20 * RI_6, turned_6b = D->m21 * RI_7,
      turned_6c = turned_6a + turned_6b, turned_6d = D->m22 * RI_8,
      turned_6 = turned_6c + turned_6d;
  const double turned_7a = D->m10 * RI_0, turned_7b = D->m11 * RI_1,
      turned_7c = turned_7a + turned_7b, turned_7d = D->m12 * RI_2,
      turned_7 = turned_7c + turned_7d;
  const double turned_8a = D->m20 * RI_0, turned_8b = D->m21 * RI_1,
      turned_8c = turned_8a + turned_8b, turned_8d = D->m22 * RI_2,
      turned_8 = turned_8c + turned_8d;
  const double turned_9a = D->m20 * RI_3, turned_9b = D->m21 * RI_4,
      turned_9c = turned_9a + turned_9b, turned_9d = D->m22 * RI_5,
      turned_9 = turned_9c + turned_9d;
  const double mt_0 = D->m03 * B->m;
  const double mt_1 = D->m13 * B->m;
  const double mt_2 = D->m23 * B->m;
  const double half_0 = 0.5 * mt_0;
  const double half_1 = 0.5 * mt_1;
  const double half_2 = 0.5 * mt_2;
  const double n_0 = turned_1 + half_0;
  const double n_1 = turned_2 + half_1;
  const double n_2 = turned_3 + half_2;
  const double tn0 = D->m03 * n_0;
  const double tn1 = D->m13 * n_1;
  const double tn2 = D->m23 * n_2;
  const double own_0 = 2.0 * tn0;
  const double own_1 = 2.0 * tn1;
  const double own_2 = 2.0 * tn2;
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = D->m03 * n_1, pairs_3b = D->m13 * n_0, pairs_3 = pairs_3a + pairs_3b;
  const double pairs_4a = D->m03 * n_2, pairs_4b = D->m23 * n_0, pairs_4 = pairs_4a + pairs_4b;
  const double pairs_5a = D->m13 * n_2, pairs_5b = D->m23 * n_1, pairs_5 = pairs_5a + pairs_5b;
  const double moved_0 = turned_1 + mt_0;
  const double moved_1 = turned_2 + mt_1;
  const double moved_2 = turned_3 + mt_2;
  const double Bo_4 = turned_4 + pairs_0;
  const double Bo_5 = turned_5 + pairs_1;
  const double Bo_6 = turned_6 + pairs_2;
  const double Bo_7 = turned_7 - pairs_3;
  const double Bo_8 = turned_8 - pairs_4;
  const double Bo_9 = turned_9 - pairs_5;
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each as a part of its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   13 mul, 15 add, 10 div, 3 neg, 9 less, 13 select. */
static inline double ksl_inertia_consistency(const ksl_inertia_t *B) {
  const double trace_a = 0.5 * B->xx, trace_b = 0.5 * B->yy, trace_c = trace_a + trace_b,
      trace_d = 0.5 * B->zz, trace = trace_c + trace_d;
  const double sigma_0 = trace - B->xx;
  const double sigma_1 = trace - B->yy;
  const double sigma_2 = trace - B->zz;
  const double divisor0 = 0.0 < B->m ? B->m : 1.0;
  const double l0_0 = B->h.x / divisor0;
  const double l0_1 = B->h.y / divisor0;
  const double l0_2 = B->h.z / divisor0;
  const double u1_0a = B->h.x * l0_0, u1_0 = sigma_0 - u1_0a;
  const double u1_1a = B->h.y * l0_0, u1_1b = u1_1a + B->xy, u1_1 = -u1_1b;
  const double u1_2a = B->h.z * l0_0, u1_2b = u1_2a + B->xz, u1_2 = -u1_2b;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1;
  const double l1_1 = u1_2 / divisor1;
  const double u2_0a = B->h.y * l0_1, u2_0b = sigma_1 - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const double u2_1a = B->h.z * l0_1, u2_1b = u2_1a + B->yz, u2_1c = u1_2 * l1_0,
      u2_1d = u2_1b + u2_1c, u2_1 = -u2_1d;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2 = u2_1 / divisor2;
  const double u3a = B->h.z * l0_2, u3b = sigma_2 - u3a, u3c = u1_2 * l1_1, u3d = u3b - u3c,
      u3e = u2_1 * l2, u3 = u3d - u3e;
  const double part0a = B->m / divisor0, part0 = 0.0 < B->m ? part0a : B->m;
  const double own1 = 0.0 < sigma_0 ? sigma_0 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < sigma_0 ? part1a : sigma_0;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < sigma_1 ? sigma_1 : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < sigma_1 ? part2a : sigma_1;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < sigma_2 ? sigma_2 : 1.0;
  const double part3a = u3 / own3, part3 = 0.0 < sigma_2 ? part3a : sigma_2;
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  return smallest3;
}

/* The inertia of these entries, in order. */
static inline ksl_inertiaf_t ksl_inertiaf(const float m, const float hx, const float hy,
    const float hz, const float xx, const float yy, const float zz, const float xy,
    const float xz, const float yz) {
  ksl_inertiaf_t value;
  value.m = m;
  value.h.x = hx;
  value.h.y = hy;
  value.h.z = hz;
  value.xx = xx;
  value.yy = yy;
  value.zz = zz;
  value.xy = xy;
  value.xz = xz;
  value.yz = yz;
  return value;
}

/* Bo = Bi.
   Bi, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz
     in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_inertiaf_copy(const ksl_inertiaf_t *Bi, ksl_inertiaf_t *Bo) {
  const float Bi_m = Bi->m;
  const float Bi_h_x = Bi->h.x;
  const float Bi_h_y = Bi->h.y;
  const float Bi_h_z = Bi->h.z;
  const float Bi_xx = Bi->xx;
  const float Bi_yy = Bi->yy;
  const float Bi_zz = Bi->zz;
  const float Bi_xy = Bi->xy;
  const float Bi_xz = Bi->xz;
  const float Bi_yz = Bi->yz;
  Bo->m = Bi_m;
  Bo->h.x = Bi_h_x;
  Bo->h.y = Bi_h_y;
  Bo->h.z = Bi_h_z;
  Bo->xx = Bi_xx;
  Bo->yy = Bi_yy;
  Bo->zz = Bi_zz;
  Bo->xy = Bi_xy;
  Bo->xz = Bi_xz;
  Bo->yz = Bi_yz;
}

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_scale(ksl_inertiaf_t *self, const float a) {
  const float self_0_new = self->m * a;
  const float self_1_new = self->h.x * a;
  const float self_2_new = self->h.y * a;
  const float self_3_new = self->h.z * a;
  const float self_4_new = self->xx * a;
  const float self_5_new = self->yy * a;
  const float self_6_new = self->zz * a;
  const float self_7_new = self->xy * a;
  const float self_8_new = self->xz * a;
  const float self_9_new = self->yz * a;
  self->m = self_0_new;
  self->h.x = self_1_new;
  self->h.y = self_2_new;
  self->h.z = self_3_new;
  self->xx = self_4_new;
  self->yy = self_5_new;
  self->zz = self_6_new;
  self->xy = self_7_new;
  self->xz = self_8_new;
  self->yz = self_9_new;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_BBf(const ksl_inertiaf_t *B1, const ksl_inertiaf_t *B2,
    ksl_inertiaf_t *Bo) {
  const float Bo_0 = B1->m + B2->m;
  const float Bo_1 = B1->h.x + B2->h.x;
  const float Bo_2 = B1->h.y + B2->h.y;
  const float Bo_3 = B1->h.z + B2->h.z;
  const float Bo_4 = B1->xx + B2->xx;
  const float Bo_5 = B1->yy + B2->yy;
  const float Bo_6 = B1->zz + B2->zz;
  const float Bo_7 = B1->xy + B2->xy;
  const float Bo_8 = B1->xz + B2->xz;
  const float Bo_9 = B1->yz + B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_BBf(const ksl_inertiaf_t *B1, const ksl_inertiaf_t *B2,
    ksl_inertiaf_t *Bo) {
  const float Bo_0 = B1->m - B2->m;
  const float Bo_1 = B1->h.x - B2->h.x;
  const float Bo_2 = B1->h.y - B2->h.y;
  const float Bo_3 = B1->h.z - B2->h.z;
  const float Bo_4 = B1->xx - B2->xx;
  const float Bo_5 = B1->yy - B2->yy;
  const float Bo_6 = B1->zz - B2->zz;
  const float Bo_7 = B1->xy - B2->xy;
  const float Bo_8 = B1->xz - B2->xz;
  const float Bo_9 = B1->yz - B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; of the symmetric matrix
     the upper triangle): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   9 mul, 9 add.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_from_com(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_inertiaf_t *Bo) {
  const float h_0 = m * com->x;
  const float h_1 = m * com->y;
  const float h_2 = m * com->z;
  const float squares_0 = com->x * h_0;
  const float squares_1 = com->y * h_1;
  const float squares_2 = com->z * h_2;
  const float Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const float Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const float Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const float Bo_7a = com->y * h_0, Bo_7 = Ic->m01 - Bo_7a;
  const float Bo_8a = com->z * h_0, Bo_8 = Ic->m02 - Bo_8a;
  const float Bo_9a = com->z * h_1, Bo_9 = Ic->m12 - Bo_9a;
  Bo->m = m;
  Bo->h.x = h_0;
  Bo->h.y = h_1;
  Bo->h.z = h_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 div.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_com(const ksl_inertiaf_t *B, ksl_vec3f_t *vo) {
  const float vo_0 = B->h.x / B->m;
  const float vo_1 = B->h.y / B->m;
  const float vo_2 = B->h.z / B->m;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 div. */
static inline void ksl_inertiaf_about_com(const ksl_inertiaf_t *B, ksl_mat3x3f_t *Ro) {
  const float c_0 = B->h.x / B->m;
  const float c_1 = B->h.y / B->m;
  const float c_2 = B->h.z / B->m;
  const float squares_0 = B->h.x * c_0;
  const float squares_1 = B->h.y * c_1;
  const float squares_2 = B->h.z * c_2;
  const float about_0a = squares_1 + squares_2, about_0 = B->xx - about_0a;
  const float about_1a = squares_0 + squares_2, about_1 = B->yy - about_1a;
  const float about_2a = squares_0 + squares_1, about_2 = B->zz - about_2a;
  const float about_3a = B->h.x * c_1, about_3 = about_3a + B->xy;
  const float about_4a = B->h.x * c_2, about_4 = about_4a + B->xz;
  const float about_5a = B->h.y * c_2, about_5 = about_5a + B->yz;
  Ro->m00 = about_0;
  Ro->m01 = about_3;
  Ro->m02 = about_4;
  Ro->m10 = about_3;
  Ro->m11 = about_1;
  Ro->m12 = about_5;
  Ro->m20 = about_4;
  Ro->m21 = about_5;
  Ro->m22 = about_2;
}

/* Mo = [[m 1, -h~], [h~, I]].
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Mo: 6×6 operator.
   3 neg.
   Exact. */
static inline void ksl_inertiaf_matrix(const ksl_inertiaf_t *B, ksl_mat6x6f_t *Mo) {
  const float Mo_05 = -B->h.y;
  const float Mo_13 = -B->h.z;
  const float Mo_24 = -B->h.x;
  const float B_m = B->m;
  const float B_h_z = B->h.z;
  const float B_h_x = B->h.x;
  const float B_h_y = B->h.y;
  const float B_xx = B->xx;
  const float B_xy = B->xy;
  const float B_xz = B->xz;
  const float B_yy = B->yy;
  const float B_yz = B->yz;
  const float B_zz = B->zz;
  Mo->at[0][0] = B_m;
  Mo->at[1][0] = 0.0f;
  Mo->at[2][0] = 0.0f;
  Mo->at[3][0] = 0.0f;
  Mo->at[4][0] = B_h_z;
  Mo->at[5][0] = Mo_05;
  Mo->at[0][1] = 0.0f;
  Mo->at[1][1] = B_m;
  Mo->at[2][1] = 0.0f;
  Mo->at[3][1] = Mo_13;
  Mo->at[4][1] = 0.0f;
  Mo->at[5][1] = B_h_x;
  Mo->at[0][2] = 0.0f;
  Mo->at[1][2] = 0.0f;
  Mo->at[2][2] = B_m;
  Mo->at[3][2] = B_h_y;
  Mo->at[4][2] = Mo_24;
  Mo->at[5][2] = 0.0f;
  Mo->at[0][3] = 0.0f;
  Mo->at[1][3] = Mo_13;
  Mo->at[2][3] = B_h_y;
  Mo->at[3][3] = B_xx;
  Mo->at[4][3] = B_xy;
  Mo->at[5][3] = B_xz;
  Mo->at[0][4] = B_h_z;
  Mo->at[1][4] = 0.0f;
  Mo->at[2][4] = Mo_24;
  Mo->at[3][4] = B_xy;
  Mo->at[4][4] = B_yy;
  Mo->at[5][4] = B_yz;
  Mo->at[0][5] = Mo_05;
  Mo->at[1][5] = B_h_x;
  Mo->at[2][5] = 0.0f;
  Mo->at[3][5] = B_xz;
  Mo->at[4][5] = B_yz;
  Mo->at[5][5] = B_zz;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bsf(const ksl_inertiaf_t *B, const ksl_screwf_t *s,
    ksl_coscrewf_t *co) {
  const float co_0a = B->m * s->m0, co_0b = B->h.z * s->m4, co_0c = B->h.y * s->m5,
      co_0d = co_0b - co_0c, co_0 = co_0a + co_0d;
  const float co_1a = B->m * s->m1, co_1b = B->h.x * s->m5, co_1c = B->h.z * s->m3,
      co_1d = co_1b - co_1c, co_1 = co_1a + co_1d;
  const float co_2a = B->m * s->m2, co_2b = B->h.y * s->m3, co_2c = B->h.x * s->m4,
      co_2d = co_2b - co_2c, co_2 = co_2a + co_2d;
  const float co_3a = B->h.y * s->m2, co_3b = B->h.z * s->m1, co_3c = co_3a - co_3b,
      co_3d = B->xx * s->m3, co_3e = B->xy * s->m4, co_3f = co_3d + co_3e, co_3g = B->xz * s->m5,
      co_3h = co_3f + co_3g, co_3 = co_3c + co_3h;
  const float co_4a = B->h.z * s->m0, co_4b = B->h.x * s->m2, co_4c = co_4a - co_4b,
      co_4d = B->yy * s->m4, co_4e = B->xy * s->m3, co_4f = co_4d + co_4e, co_4g = B->yz * s->m5,
      co_4h = co_4f + co_4g, co_4 = co_4c + co_4h;
  const float co_5a = B->h.x * s->m1, co_5b = B->h.y * s->m0, co_5c = co_5a - co_5b,
      co_5d = B->zz * s->m5, co_5e = B->xz * s->m3, co_5f = co_5d + co_5e, co_5g = B->yz * s->m4,
      co_5h = co_5f + co_5g, co_5 = co_5c + co_5h;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   28 mul, 17 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_inertiaf_energy(const ksl_inertiaf_t *B, const ksl_screwf_t *s) {
  const float across_0a = B->h.z * s->m4, across_0b = B->h.y * s->m5,
      across_0 = across_0a - across_0b;
  const float across_1a = B->h.x * s->m5, across_1b = B->h.z * s->m3,
      across_1 = across_1a - across_1b;
  const float across_2a = B->h.y * s->m3, across_2b = B->h.x * s->m4,
      across_2 = across_2a - across_2b;
  const float twice_across_0 = 2.0f * across_0;
  const float twice_across_1 = 2.0f * across_1;
  const float twice_across_2 = 2.0f * across_2;
  const float p_0a = B->m * s->m0, p_0 = p_0a + twice_across_0;
  const float p_1a = B->m * s->m1, p_1 = p_1a + twice_across_1;
  const float p_2a = B->m * s->m2, p_2 = p_2a + twice_across_2;
  const float L_0a = B->xx * s->m3, L_0b = B->xy * s->m4, L_0c = L_0a + L_0b, L_0d = B->xz * s->m5,
      L_0 = L_0c + L_0d;
  const float L_1a = B->yy * s->m4, L_1b = B->xy * s->m3, L_1c = L_1a + L_1b, L_1d = B->yz * s->m5,
      L_1 = L_1c + L_1d;
  const float L_2a = B->zz * s->m5, L_2b = B->xz * s->m3, L_2c = L_2a + L_2b, L_2d = B->yz * s->m4,
      L_2 = L_2c + L_2d;
  const float twice_a = s->m0 * p_0, twice_b = s->m1 * p_1, twice_c = twice_a + twice_b,
      twice_d = s->m2 * p_2, twice_e = twice_c + twice_d, twice_f = s->m3 * L_0,
      twice_g = s->m4 * L_1, twice_h = twice_f + twice_g, twice_i = s->m5 * L_2,
      twice_j = twice_h + twice_i, twice = twice_e + twice_j;
  const float energy = 0.5f * twice;
  return energy;
}

/* Bo: the body moved by t: h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   18 mul, 18 add.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_shifted(const ksl_vec3f_t *t, const ksl_inertiaf_t *B,
    ksl_inertiaf_t *Bo) {
  const float mt_0 = t->x * B->m;
  const float mt_1 = t->y * B->m;
  const float mt_2 = t->z * B->m;
  const float half_0 = 0.5f * mt_0;
  const float half_1 = 0.5f * mt_1;
  const float half_2 = 0.5f * mt_2;
  const float n_0 = B->h.x + half_0;
  const float n_1 = B->h.y + half_1;
  const float n_2 = B->h.z + half_2;
  const float tn0 = t->x * n_0;
  const float tn1 = t->y * n_1;
  const float tn2 = t->z * n_2;
  const float own_0 = 2.0f * tn0;
  const float own_1 = 2.0f * tn1;
  const float own_2 = 2.0f * tn2;
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = t->x * n_1, pairs_3b = t->y * n_0, pairs_3 = pairs_3a + pairs_3b;
  const float pairs_4a = t->x * n_2, pairs_4b = t->z * n_0, pairs_4 = pairs_4a + pairs_4b;
  const float pairs_5a = t->y * n_2, pairs_5b = t->z * n_1, pairs_5 = pairs_5a + pairs_5b;
  const float moved_0 = B->h.x + mt_0;
  const float moved_1 = B->h.y + mt_1;
  const float moved_2 = B->h.z + mt_2;
  const float Bo_4 = B->xx + pairs_0;
  const float Bo_5 = B->yy + pairs_1;
  const float Bo_6 = B->zz + pairs_2;
  const float Bo_7 = B->xy - pairs_3;
  const float Bo_8 = B->xz - pairs_4;
  const float Bo_9 = B->yz - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): the inertia in the frame D takes its own to.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   72 mul, 54 add.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transformed(const ksl_SE3f_t *D, const ksl_inertiaf_t *B,
    ksl_inertiaf_t *Bo) {
  const float RI_0a = D->m00 * B->xx, RI_0b = D->m01 * B->xy, RI_0c = RI_0a + RI_0b,
      RI_0d = D->m02 * B->xz, RI_0 = RI_0c + RI_0d;
  const float RI_1a = D->m00 * B->xy, RI_1b = D->m01 * B->yy, RI_1c = RI_1a + RI_1b,
      RI_1d = D->m02 * B->yz, RI_1 = RI_1c + RI_1d;
  const float RI_2a = D->m00 * B->xz, RI_2b = D->m01 * B->yz, RI_2c = RI_2a + RI_2b,
      RI_2d = D->m02 * B->zz, RI_2 = RI_2c + RI_2d;
  const float RI_3a = D->m10 * B->xx, RI_3b = D->m11 * B->xy, RI_3c = RI_3a + RI_3b,
      RI_3d = D->m12 * B->xz, RI_3 = RI_3c + RI_3d;
  const float RI_4a = D->m10 * B->xy, RI_4b = D->m11 * B->yy, RI_4c = RI_4a + RI_4b,
      RI_4d = D->m12 * B->yz, RI_4 = RI_4c + RI_4d;
  const float RI_5a = D->m10 * B->xz, RI_5b = D->m11 * B->yz, RI_5c = RI_5a + RI_5b,
      RI_5d = D->m12 * B->zz, RI_5 = RI_5c + RI_5d;
  const float RI_6a = D->m20 * B->xx, RI_6b = D->m21 * B->xy, RI_6c = RI_6a + RI_6b,
      RI_6d = D->m22 * B->xz, RI_6 = RI_6c + RI_6d;
  const float RI_7a = D->m20 * B->xy, RI_7b = D->m21 * B->yy, RI_7c = RI_7a + RI_7b,
      RI_7d = D->m22 * B->yz, RI_7 = RI_7c + RI_7d;
  const float RI_8a = D->m20 * B->xz, RI_8b = D->m21 * B->yz, RI_8c = RI_8a + RI_8b,
      RI_8d = D->m22 * B->zz, RI_8 = RI_8c + RI_8d;
  const float turned_1a = D->m00 * B->h.x, turned_1b = D->m01 * B->h.y,
      turned_1c = turned_1a + turned_1b, turned_1d = D->m02 * B->h.z,
      turned_1 = turned_1c + turned_1d;
  const float turned_2a = D->m10 * B->h.x, turned_2b = D->m11 * B->h.y,
      turned_2c = turned_2a + turned_2b, turned_2d = D->m12 * B->h.z,
      turned_2 = turned_2c + turned_2d;
  const float turned_3a = D->m20 * B->h.x, turned_3b = D->m21 * B->h.y,
      turned_3c = turned_3a + turned_3b, turned_3d = D->m22 * B->h.z,
      turned_3 = turned_3c + turned_3d;
  const float turned_4a = D->m00 * RI_0, turned_4b = D->m01 * RI_1,
      turned_4c = turned_4a + turned_4b, turned_4d = D->m02 * RI_2,
      turned_4 = turned_4c + turned_4d;
  const float turned_5a = D->m10 * RI_3, turned_5b = D->m11 * RI_4,
      turned_5c = turned_5a + turned_5b, turned_5d = D->m12 * RI_5,
      turned_5 = turned_5c + turned_5d;
  const float turned_6a = D->m20 * RI_6, turned_6b = D->m21 * RI_7,
      turned_6c = turned_6a + turned_6b, turned_6d = D->m22 * RI_8,
      turned_6 = turned_6c + turned_6d;
  const float turned_7a = D->m10 * RI_0, turned_7b = D->m11 * RI_1,
      turned_7c = turned_7a + turned_7b, turned_7d = D->m12 * RI_2,
      turned_7 = turned_7c + turned_7d;
  const float turned_8a = D->m20 * RI_0, turned_8b = D->m21 * RI_1,
      turned_8c = turned_8a + turned_8b, turned_8d = D->m22 * RI_2,
      turned_8 = turned_8c + turned_8d;
  const float turned_9a = D->m20 * RI_3, turned_9b = D->m21 * RI_4,
      turned_9c = turned_9a + turned_9b, turned_9d = D->m22 * RI_5,
      turned_9 = turned_9c + turned_9d;
  const float mt_0 = D->m03 * B->m;
  const float mt_1 = D->m13 * B->m;
  const float mt_2 = D->m23 * B->m;
  const float half_0 = 0.5f * mt_0;
  const float half_1 = 0.5f * mt_1;
  const float half_2 = 0.5f * mt_2;
  const float n_0 = turned_1 + half_0;
  const float n_1 = turned_2 + half_1;
  const float n_2 = turned_3 + half_2;
  const float tn0 = D->m03 * n_0;
  const float tn1 = D->m13 * n_1;
  const float tn2 = D->m23 * n_2;
  const float own_0 = 2.0f * tn0;
  const float own_1 = 2.0f * tn1;
  const float own_2 = 2.0f * tn2;
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = D->m03 * n_1, pairs_3b = D->m13 * n_0, pairs_3 = pairs_3a + pairs_3b;
  const float pairs_4a = D->m03 * n_2, pairs_4b = D->m23 * n_0, pairs_4 = pairs_4a + pairs_4b;
  const float pairs_5a = D->m13 * n_2, pairs_5b = D->m23 * n_1, pairs_5 = pairs_5a + pairs_5b;
  const float moved_0 = turned_1 + mt_0;
  const float moved_1 = turned_2 + mt_1;
  const float moved_2 = turned_3 + mt_2;
  const float Bo_4 = turned_4 + pairs_0;
  const float Bo_5 = turned_5 + pairs_1;
  const float Bo_6 = turned_6 + pairs_2;
  const float Bo_7 = turned_7 - pairs_3;
  const float Bo_8 = turned_8 - pairs_4;
  const float Bo_9 = turned_9 - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each as a part of its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   13 mul, 15 add, 10 div, 3 neg, 9 less, 13 select. */
static inline float ksl_inertiaf_consistency(const ksl_inertiaf_t *B) {
  const float trace_a = 0.5f * B->xx, trace_b = 0.5f * B->yy, trace_c = trace_a + trace_b,
      trace_d = 0.5f * B->zz, trace = trace_c + trace_d;
  const float sigma_0 = trace - B->xx;
  const float sigma_1 = trace - B->yy;
  const float sigma_2 = trace - B->zz;
  const float divisor0 = 0.0f < B->m ? B->m : 1.0f;
  const float l0_0 = B->h.x / divisor0;
  const float l0_1 = B->h.y / divisor0;
  const float l0_2 = B->h.z / divisor0;
  const float u1_0a = B->h.x * l0_0, u1_0 = sigma_0 - u1_0a;
  const float u1_1a = B->h.y * l0_0, u1_1b = u1_1a + B->xy, u1_1 = -u1_1b;
  const float u1_2a = B->h.z * l0_0, u1_2b = u1_2a + B->xz, u1_2 = -u1_2b;
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1;
  const float l1_1 = u1_2 / divisor1;
  const float u2_0a = B->h.y * l0_1, u2_0b = sigma_1 - u2_0a, u2_0c = u1_1 * l1_0,
      u2_0 = u2_0b - u2_0c;
  const float u2_1a = B->h.z * l0_1, u2_1b = u2_1a + B->yz, u2_1c = u1_2 * l1_0,
      u2_1d = u2_1b + u2_1c, u2_1 = -u2_1d;
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2 = u2_1 / divisor2;
  const float u3a = B->h.z * l0_2, u3b = sigma_2 - u3a, u3c = u1_2 * l1_1, u3d = u3b - u3c,
      u3e = u2_1 * l2, u3 = u3d - u3e;
  const float part0a = B->m / divisor0, part0 = 0.0f < B->m ? part0a : B->m;
  const float own1 = 0.0f < sigma_0 ? sigma_0 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < sigma_0 ? part1a : sigma_0;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < sigma_1 ? sigma_1 : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < sigma_1 ? part2a : sigma_1;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < sigma_2 ? sigma_2 : 1.0f;
  const float part3a = u3 / own3, part3 = 0.0f < sigma_2 ? part3a : sigma_2;
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  return smallest3;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_inertia_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_inertia_t *ksl_inertia_alloc(int n) {
  return n > 0 ? (ksl_inertia_t *)calloc((size_t)n, sizeof(ksl_inertia_t)) : NULL;
}

/* n ksl_inertiaf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_inertiaf_t *ksl_inertiaf_alloc(int n) {
  return n > 0 ? (ksl_inertiaf_t *)calloc((size_t)n, sizeof(ksl_inertiaf_t)) : NULL;
}

#endif

#endif

/* Detects a build that breaks the promised bits. */
#ifndef KSL_SELFCHECK_H
#define KSL_SELFCHECK_H


/* NULL if arithmetic on double is rounded operation by operation where this is compiled; else
   what is wrong.  Looks at contraction, reassociation, flush-to-zero and excess precision. */
static inline const char *ksl_selfcheck(void) {
  const volatile double given[] = {1.0000000074505806, 1.0000000149011612, 2.2250738585072014e-308,
      1.7976931348623157e+308, 0.5, 1.0, 1.110223057712381e-16};
  const double x = given[0], nearly_square = given[1], smallest = given[2], largest = given[3];
  const double half = given[4], one = given[5], above_half_ulp = given[6];
  const double square = x * x, low = square - nearly_square;
  const double sum = one + smallest, difference = sum - one;
  const double smaller = smallest * half;
  const double twice = largest + largest, back = twice * half, next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -ffast-math";
  }
  if (smaller == 0) {
    return "flush-to-zero: subnormal results become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  return NULL;
}

/* NULL if arithmetic on float is rounded operation by operation where this is compiled; else
   what is wrong.  Looks at contraction, reassociation, flush-to-zero and excess precision. */
static inline const char *ksl_selfcheckf(void) {
  const volatile float given[] = {1.0002441f, 1.0004883f, 1.1754944e-38f, 3.4028235e+38f, 0.5f,
      1.0f, 5.963375e-08f};
  const float x = given[0], nearly_square = given[1], smallest = given[2], largest = given[3];
  const float half = given[4], one = given[5], above_half_ulp = given[6];
  const float square = x * x, low = square - nearly_square;
  const float sum = one + smallest, difference = sum - one;
  const float smaller = smallest * half;
  const float twice = largest + largest, back = twice * half, next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -ffast-math";
  }
  if (smaller == 0) {
    return "flush-to-zero: subnormal results become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  return NULL;
}

#endif
