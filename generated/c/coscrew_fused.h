/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All headers of fused kernels in one file, for vendoring; it may be included together with
   them. */

/* Keeps every operation rounded once, in the order written, under every set of flags that compiles.
   Flags that would break this are refused, unless KSL_ALLOW_FAST_MATH is defined. */
#ifndef KSL_ROUNDING_H
#define KSL_ROUNDING_H

#if !defined(KSL_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "-ffast-math breaks the bits promised here; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__RECIPROCAL_MATH__)
#error "-freciprocal-math breaks the bits promised here; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__NO_SIGNED_ZEROS__)
#error "-fno-signed-zeros breaks the bits promised here; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffinite-math-only breaks what is promised of NaN; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 1
#error "floats are computed in double: compile with -fexcess-precision=fast; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "the x87 rounds twice: compile with -msse2 -mfpmath=sse; \
define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__GNUC__) && !defined(__clang__) && !defined(__STRICT_ANSI__) && \
    (defined(__x86_64__) || defined(__aarch64__)) && __GCC_IEC_559 == 0
#error "-funsafe-math-optimizations or a part of it breaks the bits promised here; \
define KSL_ALLOW_FAST_MATH to accept that"
#endif
#if defined(__GNUC__) && !defined(__clang__) && !defined(__cplusplus)
__extension__ _Static_assert(sizeof(.5) == __SIZEOF_DOUBLE__,
    "-fsingle-precision-constant breaks the bits promised here; "
    "define KSL_ALLOW_FAST_MATH to accept that");
#elif defined(__GNUC__) && !defined(__clang__) && __cplusplus >= 201103L
static_assert(sizeof(.5) == __SIZEOF_DOUBLE__,
    "-fsingle-precision-constant breaks the bits promised here; "
    "define KSL_ALLOW_FAST_MATH to accept that");
#elif defined(__GNUC__) && !defined(__clang__)
typedef char
    KSL_ALLOW_FAST_MATH_accepts_fsingle_precision_constant
    [sizeof(.5) == __SIZEOF_DOUBLE__ ? 1 : -1];
#endif
#endif

#include <float.h>
#if DBL_MANT_DIG != 53
#error "double has not 64 bits here, so results would be wrong: \
generate the headers with --precision single"
#endif

/* Whether the target has a fused multiply-add instruction, in double precision (KSL_HAS_FMA) and in
   single (KSL_HAS_FMAF).  Both may be defined before this is included. */
#ifndef KSL_HAS_FMA
#if defined(__FMA__) || defined(__FMA4__) || defined(__FP_FAST_FMA) || defined(__aarch64__) || \
    defined(__s390x__) || defined(__powerpc64__) || \
    (defined(__riscv_flen) && __riscv_flen >= 64) || \
    (defined(__ARM_FEATURE_FMA) && defined(__ARM_FP) && (__ARM_FP & 8))
#define KSL_HAS_FMA 1
#else
#define KSL_HAS_FMA 0
#endif
#endif
#ifndef KSL_HAS_FMAF
#if KSL_HAS_FMA || defined(__ARM_FEATURE_FMA) || defined(__FP_FAST_FMAF) || defined(__riscv_flen)
#define KSL_HAS_FMAF 1
#else
#define KSL_HAS_FMAF 0
#endif
#endif

/* Keeps gcc from contracting across statements.  gcc ignores a lone flag -fassociative-math, but
   any such pragma would put it in force; hence no-associative-math.  The pragma holds to the end of
   the compiled file: functions with different options would not be inlined. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off", "no-associative-math")
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#endif
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 14 && defined(__riscv_vector)
#pragma GCC optimize("no-tree-vectorize") /* the vectoriser contracts in spite of the pragma */
#endif

#ifndef KSL_MUL
/* KSL_MUL(a, b) is a b, rounded to double on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which no macro reveals, clang fuses every product into a sum.  So the
   product is written as an fma with -0, which changes no bit, hidden so that clang cannot fold it.
   Defining KSL_CONTRACT_OFF says that the flag is not given, and saves this time. */
static inline double ksl_minus_zero(void) {
  double zero = -0.0;
#if defined(__x86_64__) || defined(__i386__)
  __asm__("" : "+x"(zero));
#elif defined(__aarch64__) || defined(__arm__)
  __asm__("" : "+w"(zero));
#else
  __asm__("" : "+f"(zero));
#endif
  return zero;
}
#define KSL_MUL(a, b) __builtin_fma(a, b, ksl_minus_zero())
#elif defined(__GNUC__) && !defined(__clang__) && (__GNUC__ == 12 || __GNUC__ == 13) && \
    (defined(__x86_64__) || defined(__i386__))
/* The vectoriser of these versions contracts in spite of flag and pragma where sums and differences
   alternate. */
#define KSL_MUL(a, b) __builtin_assoc_barrier((a) * (b))
#else
#define KSL_MUL(a, b) ((a) * (b))
#endif
#endif

#ifndef KSL_MULF
/* KSL_MULF(a, b) is a b, rounded to float on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMAF && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which no macro reveals, clang fuses every product into a sum.  So the
   product is written as an fma with -0, which changes no bit, hidden so that clang cannot fold it.
   Defining KSL_CONTRACT_OFF says that the flag is not given, and saves this time. */
static inline float ksl_minus_zerof(void) {
  float zero = -0.0f;
#if defined(__x86_64__) || defined(__i386__)
  __asm__("" : "+x"(zero));
#elif defined(__aarch64__) || defined(__arm__)
  __asm__("" : "+w"(zero));
#else
  __asm__("" : "+f"(zero));
#endif
  return zero;
}
#define KSL_MULF(a, b) __builtin_fmaf(a, b, ksl_minus_zerof())
#elif defined(__GNUC__) && !defined(__clang__) && (__GNUC__ == 12 || __GNUC__ == 13) && \
    (defined(__x86_64__) || defined(__i386__))
/* The vectoriser of these versions contracts in spite of flag and pragma where sums and differences
   alternate. */
#define KSL_MULF(a, b) __builtin_assoc_barrier((a) * (b))
#else
#define KSL_MULF(a, b) ((a) * (b))
#endif
#endif

#endif

/* Types of the spatial algebra, in double and single precision.

   Every quantity is a union of several views.  Matrices are stored column by column.  Screws
   s = (v; ω) and coscrews c = (f; τ) have the linear part on top, so that power is their dot product.

   All functions: pointers must point to valid objects; an output may be the same object as an
   input; nothing else is read or written.  Every operation is rounded once, in the order written, so
   that results have the same bits on every machine, under every set of flags that compiles.

   Error bounds are derived from that order, to first order in u: u = 2^-53 in double and 2^-24 in
   single precision. */
#ifndef KSL_TYPES_H
#define KSL_TYPES_H

#include <math.h>
#include <string.h>


/* The version, for #if KSL_VERSION >= KSL_VERSION_NUMBER(1, 2, 3). */
#define KSL_VERSION_MAJOR 0
#define KSL_VERSION_MINOR 2
#define KSL_VERSION_PATCH 0
#define KSL_VERSION_NUMBER(major, minor, patch) (10000 * (major) + 100 * (minor) + (patch))
#define KSL_VERSION KSL_VERSION_NUMBER(KSL_VERSION_MAJOR, KSL_VERSION_MINOR, KSL_VERSION_PATCH)
#define KSL_VERSION_STRING "0.2.0"

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

/* inertia: mass m, first moment mt = m c, moments about the centre of mass c; double precision. */
typedef union ksl_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t mt;
    double Ixx, Iyy, Izz, Ixy, Iyz, Izx;
  };
  KSL_VIEW {
    double mass;
    ksl_vec3_t mr;
    double diagonal[3];
    double Iyx, Izy, Ixz;
  };
} ksl_inertia_t;

/* inertia: mass m, first moment mt = m c, moments about the centre of mass c; single precision. */
typedef union ksl_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t mt;
    float Ixx, Iyy, Izz, Ixy, Iyz, Izx;
  };
  KSL_VIEW {
    float mass;
    ksl_vec3f_t mr;
    float diagonal[3];
    float Iyx, Izy, Ixz;
  };
} ksl_inertiaf_t;

/* spatial inertia: mass m, first moment h = m c, moments about the origin; double precision. */
typedef union ksl_spatial_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t h;
    double xx, yy, zz, xy, xz, yz;
  };
} ksl_spatial_inertia_t;

/* spatial inertia: mass m, first moment h = m c, moments about the origin; single precision. */
typedef union ksl_spatial_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t h;
    float xx, yy, zz, xy, xz, yz;
  };
} ksl_spatial_inertiaf_t;

/* Sequences of axes of Euler angles.  Each rotation is about a current axis of the body, that is, as
   rotated by those before it. */
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

/* Vectors of three components.
   Fused tier: products fused into sums. */
#ifndef KSL_VEC3_FUSED_H
#define KSL_VEC3_FUSED_H


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

/* Vectors of four components: three dimensions and a homogeneous coordinate.
   Fused tier: products fused into sums. */
#ifndef KSL_VEC4_FUSED_H
#define KSL_VEC4_FUSED_H


/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scale_fused(ksl_vec4_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scaled_fused(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_3 = KSL_MUL(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scale_fused(ksl_vec4f_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scaled_fused(const ksl_vec4f_t *v, const float k, ksl_vec4f_t *vo) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  const float vo_3 = KSL_MULF(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

#endif

/* 3×3 matrices: rotations, and matrices in general.
   Fused tier: products fused into sums. */
#ifndef KSL_MAT3X3_FUSED_H
#define KSL_MAT3X3_FUSED_H


/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensor_fused(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro) {
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00a_lead = -ww_1, Ro_00 = Ro_00a_lead - ww_2;
  const double Ro_01 = ww_3 - dw->z;
  const double Ro_02 = dw->y + ww_4;
  const double Ro_10 = dw->z + ww_3;
  const double Ro_11a_lead = -ww_0, Ro_11 = Ro_11a_lead - ww_2;
  const double Ro_12 = ww_5 - dw->x;
  const double Ro_20 = ww_4 - dw->y;
  const double Ro_21 = dw->x + ww_5;
  const double Ro_22a_lead = -ww_0, Ro_22 = Ro_22a_lead - ww_1;
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

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant_fused(const ksl_mat3x3_t *R) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0 = fma(-R->m12, R->m21, n_0a);
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1 = fma(-R->m01, R->m22, n_1a);
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2 = fma(-R->m02, R->m11, n_2a);
  const double det_a = KSL_MUL(R->m00, n_0), det_c = fma(R->m10, n_1, det_a),
      det = fma(R->m20, n_2, det_c);
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   9 mul, 7 add, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_setFromAxisDC_fused(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2]) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = KSL_MUL(axis->x, versine);
  const double versine_axis_1 = KSL_MUL(axis->y, versine);
  const double versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]);
  const double sine_axis_1 = KSL_MUL(axis->y, dc[0]);
  const double sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = fma(axis->x, versine_axis_0, dc[1]);
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = fma(axis->y, versine_axis_1, dc[1]);
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = fma(axis->z, versine_axis_2, dc[1]);
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

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensorf_fused(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro) {
  const float ww_0 = KSL_MULF(w->x, w->x);
  const float ww_1 = KSL_MULF(w->y, w->y);
  const float ww_2 = KSL_MULF(w->z, w->z);
  const float ww_3 = KSL_MULF(w->x, w->y);
  const float ww_4 = KSL_MULF(w->x, w->z);
  const float ww_5 = KSL_MULF(w->y, w->z);
  const float Ro_00a_lead = -ww_1, Ro_00 = Ro_00a_lead - ww_2;
  const float Ro_01 = ww_3 - dw->z;
  const float Ro_02 = dw->y + ww_4;
  const float Ro_10 = dw->z + ww_3;
  const float Ro_11a_lead = -ww_0, Ro_11 = Ro_11a_lead - ww_2;
  const float Ro_12 = ww_5 - dw->x;
  const float Ro_20 = ww_4 - dw->y;
  const float Ro_21 = dw->x + ww_5;
  const float Ro_22a_lead = -ww_0, Ro_22 = Ro_22a_lead - ww_1;
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

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant_fused(const ksl_mat3x3f_t *R) {
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0 = fmaf(-R->m12, R->m21, n_0a);
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1 = fmaf(-R->m01, R->m22, n_1a);
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2 = fmaf(-R->m02, R->m11, n_2a);
  const float det_a = KSL_MULF(R->m00, n_0), det_c = fmaf(R->m10, n_1, det_a),
      det = fmaf(R->m20, n_2, det_c);
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   9 mul, 7 add, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_setFromAxisDC_fused(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2]) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = KSL_MULF(axis->x, versine);
  const float versine_axis_1 = KSL_MULF(axis->y, versine);
  const float versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_3 = KSL_MULF(axis->y, versine_axis_0);
  const float m_4 = KSL_MULF(axis->z, versine_axis_0);
  const float m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]);
  const float sine_axis_1 = KSL_MULF(axis->y, dc[0]);
  const float sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = fmaf(axis->x, versine_axis_0, dc[1]);
  const float R_01 = m_3 - sine_axis_2;
  const float R_02 = m_4 + sine_axis_1;
  const float R_10 = m_3 + sine_axis_2;
  const float R_11 = fmaf(axis->y, versine_axis_1, dc[1]);
  const float R_12 = m_5 - sine_axis_0;
  const float R_20 = m_4 - sine_axis_1;
  const float R_21 = m_5 + sine_axis_0;
  const float R_22 = fmaf(axis->z, versine_axis_2, dc[1]);
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

#endif

/* Displacements D = [R | t].
   Fused tier: products fused into sums. */
#ifndef KSL_SE3_FUSED_H
#define KSL_SE3_FUSED_H


/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert_fused(ksl_SE3_t *self) {
  const double self_03_new_a = KSL_MUL(self->m00, self->m03), self_03_new_c_lead = -self_03_new_a,
      self_03_new_c = fma(-self->m10, self->m13, self_03_new_c_lead),
      self_03_new = fma(-self->m20, self->m23, self_03_new_c);
  const double self_13_new_a = KSL_MUL(self->m01, self->m03), self_13_new_c_lead = -self_13_new_a,
      self_13_new_c = fma(-self->m11, self->m13, self_13_new_c_lead),
      self_13_new = fma(-self->m21, self->m23, self_13_new_c);
  const double self_23_new_a = KSL_MUL(self->m02, self->m03), self_23_new_c_lead = -self_23_new_a,
      self_23_new_c = fma(-self->m12, self->m13, self_23_new_c_lead),
      self_23_new = fma(-self->m22, self->m23, self_23_new_c);
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

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted_fused(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, D->m03), Do_03c_lead = -Do_03a,
      Do_03c = fma(-D->m10, D->m13, Do_03c_lead), Do_03 = fma(-D->m20, D->m23, Do_03c);
  const double Do_13a = KSL_MUL(D->m01, D->m03), Do_13c_lead = -Do_13a,
      Do_13c = fma(-D->m11, D->m13, Do_13c_lead), Do_13 = fma(-D->m21, D->m23, Do_13c);
  const double Do_23a = KSL_MUL(D->m02, D->m03), Do_23c_lead = -Do_23a,
      Do_23c = fma(-D->m12, D->m13, Do_23c_lead), Do_23 = fma(-D->m22, D->m23, Do_23c);
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

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert_fused(ksl_SE3f_t *self) {
  const float self_03_new_a = KSL_MULF(self->m00, self->m03), self_03_new_c_lead = -self_03_new_a,
      self_03_new_c = fmaf(-self->m10, self->m13, self_03_new_c_lead),
      self_03_new = fmaf(-self->m20, self->m23, self_03_new_c);
  const float self_13_new_a = KSL_MULF(self->m01, self->m03), self_13_new_c_lead = -self_13_new_a,
      self_13_new_c = fmaf(-self->m11, self->m13, self_13_new_c_lead),
      self_13_new = fmaf(-self->m21, self->m23, self_13_new_c);
  const float self_23_new_a = KSL_MULF(self->m02, self->m03), self_23_new_c_lead = -self_23_new_a,
      self_23_new_c = fmaf(-self->m12, self->m13, self_23_new_c_lead),
      self_23_new = fmaf(-self->m22, self->m23, self_23_new_c);
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

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted_fused(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, D->m03), Do_03c_lead = -Do_03a,
      Do_03c = fmaf(-D->m10, D->m13, Do_03c_lead), Do_03 = fmaf(-D->m20, D->m23, Do_03c);
  const float Do_13a = KSL_MULF(D->m01, D->m03), Do_13c_lead = -Do_13a,
      Do_13c = fmaf(-D->m11, D->m13, Do_13c_lead), Do_13 = fmaf(-D->m21, D->m23, Do_13c);
  const float Do_23a = KSL_MULF(D->m02, D->m03), Do_23c_lead = -Do_23a,
      Do_23c = fmaf(-D->m12, D->m13, Do_23c_lead), Do_23 = fmaf(-D->m22, D->m23, Do_23c);
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

#endif

/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.
   Fused tier: products fused into sums. */
#ifndef KSL_MAT6X6_FUSED_H
#define KSL_MAT6X6_FUSED_H


/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   48 mul, 96 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_rotated_fused(const ksl_mat3x3_t *R, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double RM_0a = KSL_MUL(R->m00, M->at[0][0]), RM_0c = fma(R->m01, M->at[0][1], RM_0a),
      RM_0 = fma(R->m02, M->at[0][2], RM_0c);
  const double RM_1a = KSL_MUL(R->m00, M->at[0][1]), RM_1c = fma(R->m01, M->at[1][1], RM_1a),
      RM_1 = fma(R->m02, M->at[1][2], RM_1c);
  const double RM_2a = KSL_MUL(R->m00, M->at[0][2]), RM_2c = fma(R->m01, M->at[1][2], RM_2a),
      RM_2 = fma(R->m02, M->at[2][2], RM_2c);
  const double RM_3a = KSL_MUL(R->m10, M->at[0][0]), RM_3c = fma(R->m11, M->at[0][1], RM_3a),
      RM_3 = fma(R->m12, M->at[0][2], RM_3c);
  const double RM_4a = KSL_MUL(R->m10, M->at[0][1]), RM_4c = fma(R->m11, M->at[1][1], RM_4a),
      RM_4 = fma(R->m12, M->at[1][2], RM_4c);
  const double RM_5a = KSL_MUL(R->m10, M->at[0][2]), RM_5c = fma(R->m11, M->at[1][2], RM_5a),
      RM_5 = fma(R->m12, M->at[2][2], RM_5c);
  const double RM_6a = KSL_MUL(R->m20, M->at[0][0]), RM_6c = fma(R->m21, M->at[0][1], RM_6a),
      RM_6 = fma(R->m22, M->at[0][2], RM_6c);
  const double RM_7a = KSL_MUL(R->m20, M->at[0][1]), RM_7c = fma(R->m21, M->at[1][1], RM_7a),
      RM_7 = fma(R->m22, M->at[1][2], RM_7c);
  const double RM_8a = KSL_MUL(R->m20, M->at[0][2]), RM_8c = fma(R->m21, M->at[1][2], RM_8a),
      RM_8 = fma(R->m22, M->at[2][2], RM_8c);
  const double linear_0a = KSL_MUL(R->m00, RM_0), linear_0c = fma(R->m01, RM_1, linear_0a),
      linear_0 = fma(R->m02, RM_2, linear_0c);
  const double linear_1a = KSL_MUL(R->m00, RM_3), linear_1c = fma(R->m01, RM_4, linear_1a),
      linear_1 = fma(R->m02, RM_5, linear_1c);
  const double linear_2a = KSL_MUL(R->m10, RM_3), linear_2c = fma(R->m11, RM_4, linear_2a),
      linear_2 = fma(R->m12, RM_5, linear_2c);
  const double linear_3a = KSL_MUL(R->m00, RM_6), linear_3c = fma(R->m01, RM_7, linear_3a),
      linear_3 = fma(R->m02, RM_8, linear_3c);
  const double linear_4a = KSL_MUL(R->m10, RM_6), linear_4c = fma(R->m11, RM_7, linear_4a),
      linear_4 = fma(R->m12, RM_8, linear_4c);
  const double linear_5a = KSL_MUL(R->m20, RM_6), linear_5c = fma(R->m21, RM_7, linear_5a),
      linear_5 = fma(R->m22, RM_8, linear_5c);
  const double RH_0a = KSL_MUL(R->m00, M->at[0][3]), RH_0c = fma(R->m01, M->at[0][4], RH_0a),
      RH_0 = fma(R->m02, M->at[0][5], RH_0c);
  const double RH_1a = KSL_MUL(R->m00, M->at[1][3]), RH_1c = fma(R->m01, M->at[1][4], RH_1a),
      RH_1 = fma(R->m02, M->at[1][5], RH_1c);
  const double RH_2a = KSL_MUL(R->m00, M->at[2][3]), RH_2c = fma(R->m01, M->at[2][4], RH_2a),
      RH_2 = fma(R->m02, M->at[2][5], RH_2c);
  const double RH_3a = KSL_MUL(R->m10, M->at[0][3]), RH_3c = fma(R->m11, M->at[0][4], RH_3a),
      RH_3 = fma(R->m12, M->at[0][5], RH_3c);
  const double RH_4a = KSL_MUL(R->m10, M->at[1][3]), RH_4c = fma(R->m11, M->at[1][4], RH_4a),
      RH_4 = fma(R->m12, M->at[1][5], RH_4c);
  const double RH_5a = KSL_MUL(R->m10, M->at[2][3]), RH_5c = fma(R->m11, M->at[2][4], RH_5a),
      RH_5 = fma(R->m12, M->at[2][5], RH_5c);
  const double RH_6a = KSL_MUL(R->m20, M->at[0][3]), RH_6c = fma(R->m21, M->at[0][4], RH_6a),
      RH_6 = fma(R->m22, M->at[0][5], RH_6c);
  const double RH_7a = KSL_MUL(R->m20, M->at[1][3]), RH_7c = fma(R->m21, M->at[1][4], RH_7a),
      RH_7 = fma(R->m22, M->at[1][5], RH_7c);
  const double RH_8a = KSL_MUL(R->m20, M->at[2][3]), RH_8c = fma(R->m21, M->at[2][4], RH_8a),
      RH_8 = fma(R->m22, M->at[2][5], RH_8c);
  const double coupling_0a = KSL_MUL(R->m00, RH_0), coupling_0c = fma(R->m01, RH_1, coupling_0a),
      coupling_0 = fma(R->m02, RH_2, coupling_0c);
  const double coupling_1a = KSL_MUL(R->m10, RH_0), coupling_1c = fma(R->m11, RH_1, coupling_1a),
      coupling_1 = fma(R->m12, RH_2, coupling_1c);
  const double coupling_2a = KSL_MUL(R->m20, RH_0), coupling_2c = fma(R->m21, RH_1, coupling_2a),
      coupling_2 = fma(R->m22, RH_2, coupling_2c);
  const double coupling_3a = KSL_MUL(R->m00, RH_3), coupling_3c = fma(R->m01, RH_4, coupling_3a),
      coupling_3 = fma(R->m02, RH_5, coupling_3c);
  const double coupling_4a = KSL_MUL(R->m10, RH_3), coupling_4c = fma(R->m11, RH_4, coupling_4a),
      coupling_4 = fma(R->m12, RH_5, coupling_4c);
  const double coupling_5a = KSL_MUL(R->m20, RH_3), coupling_5c = fma(R->m21, RH_4, coupling_5a),
      coupling_5 = fma(R->m22, RH_5, coupling_5c);
  const double coupling_6a = KSL_MUL(R->m00, RH_6), coupling_6c = fma(R->m01, RH_7, coupling_6a),
      coupling_6 = fma(R->m02, RH_8, coupling_6c);
  const double coupling_7a = KSL_MUL(R->m10, RH_6), coupling_7c = fma(R->m11, RH_7, coupling_7a),
      coupling_7 = fma(R->m12, RH_8, coupling_7c);
  const double coupling_8a = KSL_MUL(R->m20, RH_6), coupling_8c = fma(R->m21, RH_7, coupling_8a),
      coupling_8 = fma(R->m22, RH_8, coupling_8c);
  const double RI_0a = KSL_MUL(R->m00, M->at[3][3]), RI_0c = fma(R->m01, M->at[3][4], RI_0a),
      RI_0 = fma(R->m02, M->at[3][5], RI_0c);
  const double RI_1a = KSL_MUL(R->m00, M->at[3][4]), RI_1c = fma(R->m01, M->at[4][4], RI_1a),
      RI_1 = fma(R->m02, M->at[4][5], RI_1c);
  const double RI_2a = KSL_MUL(R->m00, M->at[3][5]), RI_2c = fma(R->m01, M->at[4][5], RI_2a),
      RI_2 = fma(R->m02, M->at[5][5], RI_2c);
  const double RI_3a = KSL_MUL(R->m10, M->at[3][3]), RI_3c = fma(R->m11, M->at[3][4], RI_3a),
      RI_3 = fma(R->m12, M->at[3][5], RI_3c);
  const double RI_4a = KSL_MUL(R->m10, M->at[3][4]), RI_4c = fma(R->m11, M->at[4][4], RI_4a),
      RI_4 = fma(R->m12, M->at[4][5], RI_4c);
  const double RI_5a = KSL_MUL(R->m10, M->at[3][5]), RI_5c = fma(R->m11, M->at[4][5], RI_5a),
      RI_5 = fma(R->m12, M->at[5][5], RI_5c);
  const double RI_6a = KSL_MUL(R->m20, M->at[3][3]), RI_6c = fma(R->m21, M->at[3][4], RI_6a),
      RI_6 = fma(R->m22, M->at[3][5], RI_6c);
  const double RI_7a = KSL_MUL(R->m20, M->at[3][4]), RI_7c = fma(R->m21, M->at[4][4], RI_7a),
      RI_7 = fma(R->m22, M->at[4][5], RI_7c);
  const double RI_8a = KSL_MUL(R->m20, M->at[3][5]), RI_8c = fma(R->m21, M->at[4][5], RI_8a),
      RI_8 = fma(R->m22, M->at[5][5], RI_8c);
  const double angular_0a = KSL_MUL(R->m00, RI_0), angular_0c = fma(R->m01, RI_1, angular_0a),
      angular_0 = fma(R->m02, RI_2, angular_0c);
  const double angular_1a = KSL_MUL(R->m00, RI_3), angular_1c = fma(R->m01, RI_4, angular_1a),
      angular_1 = fma(R->m02, RI_5, angular_1c);
  const double angular_2a = KSL_MUL(R->m10, RI_3), angular_2c = fma(R->m11, RI_4, angular_2a),
      angular_2 = fma(R->m12, RI_5, angular_2c);
  const double angular_3a = KSL_MUL(R->m00, RI_6), angular_3c = fma(R->m01, RI_7, angular_3a),
      angular_3 = fma(R->m02, RI_8, angular_3c);
  const double angular_4a = KSL_MUL(R->m10, RI_6), angular_4c = fma(R->m11, RI_7, angular_4a),
      angular_4 = fma(R->m12, RI_8, angular_4c);
  const double angular_5a = KSL_MUL(R->m20, RI_6), angular_5c = fma(R->m21, RI_7, angular_5a),
      angular_5 = fma(R->m22, RI_8, angular_5c);
  Mo->at[0][0] = linear_0;
  Mo->at[1][0] = linear_1;
  Mo->at[2][0] = linear_3;
  Mo->at[3][0] = coupling_0;
  Mo->at[4][0] = coupling_3;
  Mo->at[5][0] = coupling_6;
  Mo->at[0][1] = linear_1;
  Mo->at[1][1] = linear_2;
  Mo->at[2][1] = linear_4;
  Mo->at[3][1] = coupling_1;
  Mo->at[4][1] = coupling_4;
  Mo->at[5][1] = coupling_7;
  Mo->at[0][2] = linear_3;
  Mo->at[1][2] = linear_4;
  Mo->at[2][2] = linear_5;
  Mo->at[3][2] = coupling_2;
  Mo->at[4][2] = coupling_5;
  Mo->at[5][2] = coupling_8;
  Mo->at[0][3] = coupling_0;
  Mo->at[1][3] = coupling_1;
  Mo->at[2][3] = coupling_2;
  Mo->at[3][3] = angular_0;
  Mo->at[4][3] = angular_1;
  Mo->at[5][3] = angular_3;
  Mo->at[0][4] = coupling_3;
  Mo->at[1][4] = coupling_4;
  Mo->at[2][4] = coupling_5;
  Mo->at[3][4] = angular_1;
  Mo->at[4][4] = angular_2;
  Mo->at[5][4] = angular_4;
  Mo->at[0][5] = coupling_6;
  Mo->at[1][5] = coupling_7;
  Mo->at[2][5] = coupling_8;
  Mo->at[3][5] = angular_3;
  Mo->at[4][5] = angular_4;
  Mo->at[5][5] = angular_5;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read.
   t: vector; M, Mo: 6×6 operator.
   21 mul, 24 add, 18 fma.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_shifted_fused(const ksl_vec3_t *t, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double G_0a = KSL_MUL(t->y, M->at[0][2]), G_0b = KSL_MUL(t->z, M->at[0][1]),
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const double G_1a = KSL_MUL(t->y, M->at[1][2]), G_1c = fma(-t->z, M->at[1][1], G_1a),
      G_1 = G_1c + M->at[1][3];
  const double G_2a = KSL_MUL(t->y, M->at[2][2]), G_2c = fma(-t->z, M->at[1][2], G_2a),
      G_2 = G_2c + M->at[2][3];
  const double G_3a = KSL_MUL(t->z, M->at[0][0]), G_3c = fma(-t->x, M->at[0][2], G_3a),
      G_3 = G_3c + M->at[0][4];
  const double G_4a = KSL_MUL(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const double G_5a = KSL_MUL(t->z, M->at[0][2]), G_5c = fma(-t->x, M->at[2][2], G_5a),
      G_5 = G_5c + M->at[2][4];
  const double G_6a = KSL_MUL(t->x, M->at[0][1]), G_6c = fma(-t->y, M->at[0][0], G_6a),
      G_6 = G_6c + M->at[0][5];
  const double G_7a = KSL_MUL(t->x, M->at[1][1]), G_7c = fma(-t->y, M->at[0][1], G_7a),
      G_7 = G_7c + M->at[1][5];
  const double G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const double moved_0a = KSL_MUL(t->y, M->at[2][3]), moved_0c = fma(-t->z, M->at[1][3], moved_0a),
      moved_0d = KSL_MUL(t->y, G_2), moved_0f = fma(-t->z, G_1, moved_0d),
      moved_0g = moved_0c + moved_0f, moved_0 = moved_0g + M->at[3][3];
  const double moved_1a = KSL_MUL(t->z, M->at[0][3]), moved_1c = fma(-t->x, M->at[2][3], moved_1a),
      moved_1d = KSL_MUL(t->y, G_5), moved_1f = fma(-t->z, G_4, moved_1d),
      moved_1g = moved_1c + moved_1f, moved_1 = moved_1g + M->at[3][4];
  const double moved_2a = KSL_MUL(t->z, M->at[0][4]), moved_2c = fma(-t->x, M->at[2][4], moved_2a),
      moved_2d = KSL_MUL(t->z, G_3), moved_2f = fma(-t->x, G_5, moved_2d),
      moved_2g = moved_2c + moved_2f, moved_2 = moved_2g + M->at[4][4];
  const double moved_3a = KSL_MUL(t->x, M->at[1][3]), moved_3c = fma(-t->y, M->at[0][3], moved_3a),
      moved_3d = KSL_MUL(t->y, G_8), moved_3f = fma(-t->z, G_7, moved_3d),
      moved_3g = moved_3c + moved_3f, moved_3 = moved_3g + M->at[3][5];
  const double moved_4a = KSL_MUL(t->x, M->at[1][4]), moved_4c = fma(-t->y, M->at[0][4], moved_4a),
      moved_4d = KSL_MUL(t->z, G_6), moved_4f = fma(-t->x, G_8, moved_4d),
      moved_4g = moved_4c + moved_4f, moved_4 = moved_4g + M->at[4][5];
  const double moved_5a = KSL_MUL(t->x, M->at[1][5]), moved_5c = fma(-t->y, M->at[0][5], moved_5a),
      moved_5d = KSL_MUL(t->x, G_7), moved_5f = fma(-t->y, G_6, moved_5d),
      moved_5g = moved_5c + moved_5f, moved_5 = moved_5g + M->at[5][5];
  const double M_at_00 = M->at[0][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_11 = M->at[1][1];
  const double M_at_12 = M->at[1][2];
  const double M_at_22 = M->at[2][2];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = G_0;
  Mo->at[4][0] = G_3;
  Mo->at[5][0] = G_6;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = G_1;
  Mo->at[4][1] = G_4;
  Mo->at[5][1] = G_7;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = G_2;
  Mo->at[4][2] = G_5;
  Mo->at[5][2] = G_8;
  Mo->at[0][3] = G_0;
  Mo->at[1][3] = G_1;
  Mo->at[2][3] = G_2;
  Mo->at[3][3] = moved_0;
  Mo->at[4][3] = moved_1;
  Mo->at[5][3] = moved_3;
  Mo->at[0][4] = G_3;
  Mo->at[1][4] = G_4;
  Mo->at[2][4] = G_5;
  Mo->at[3][4] = moved_1;
  Mo->at[4][4] = moved_2;
  Mo->at[5][4] = moved_4;
  Mo->at[0][5] = G_6;
  Mo->at[1][5] = G_7;
  Mo->at[2][5] = G_8;
  Mo->at[3][5] = moved_3;
  Mo->at[4][5] = moved_4;
  Mo->at[5][5] = moved_5;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   48 mul, 96 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_rotated_fused(const ksl_mat3x3f_t *R, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float RM_0a = KSL_MULF(R->m00, M->at[0][0]), RM_0c = fmaf(R->m01, M->at[0][1], RM_0a),
      RM_0 = fmaf(R->m02, M->at[0][2], RM_0c);
  const float RM_1a = KSL_MULF(R->m00, M->at[0][1]), RM_1c = fmaf(R->m01, M->at[1][1], RM_1a),
      RM_1 = fmaf(R->m02, M->at[1][2], RM_1c);
  const float RM_2a = KSL_MULF(R->m00, M->at[0][2]), RM_2c = fmaf(R->m01, M->at[1][2], RM_2a),
      RM_2 = fmaf(R->m02, M->at[2][2], RM_2c);
  const float RM_3a = KSL_MULF(R->m10, M->at[0][0]), RM_3c = fmaf(R->m11, M->at[0][1], RM_3a),
      RM_3 = fmaf(R->m12, M->at[0][2], RM_3c);
  const float RM_4a = KSL_MULF(R->m10, M->at[0][1]), RM_4c = fmaf(R->m11, M->at[1][1], RM_4a),
      RM_4 = fmaf(R->m12, M->at[1][2], RM_4c);
  const float RM_5a = KSL_MULF(R->m10, M->at[0][2]), RM_5c = fmaf(R->m11, M->at[1][2], RM_5a),
      RM_5 = fmaf(R->m12, M->at[2][2], RM_5c);
  const float RM_6a = KSL_MULF(R->m20, M->at[0][0]), RM_6c = fmaf(R->m21, M->at[0][1], RM_6a),
      RM_6 = fmaf(R->m22, M->at[0][2], RM_6c);
  const float RM_7a = KSL_MULF(R->m20, M->at[0][1]), RM_7c = fmaf(R->m21, M->at[1][1], RM_7a),
      RM_7 = fmaf(R->m22, M->at[1][2], RM_7c);
  const float RM_8a = KSL_MULF(R->m20, M->at[0][2]), RM_8c = fmaf(R->m21, M->at[1][2], RM_8a),
      RM_8 = fmaf(R->m22, M->at[2][2], RM_8c);
  const float linear_0a = KSL_MULF(R->m00, RM_0), linear_0c = fmaf(R->m01, RM_1, linear_0a),
      linear_0 = fmaf(R->m02, RM_2, linear_0c);
  const float linear_1a = KSL_MULF(R->m00, RM_3), linear_1c = fmaf(R->m01, RM_4, linear_1a),
      linear_1 = fmaf(R->m02, RM_5, linear_1c);
  const float linear_2a = KSL_MULF(R->m10, RM_3), linear_2c = fmaf(R->m11, RM_4, linear_2a),
      linear_2 = fmaf(R->m12, RM_5, linear_2c);
  const float linear_3a = KSL_MULF(R->m00, RM_6), linear_3c = fmaf(R->m01, RM_7, linear_3a),
      linear_3 = fmaf(R->m02, RM_8, linear_3c);
  const float linear_4a = KSL_MULF(R->m10, RM_6), linear_4c = fmaf(R->m11, RM_7, linear_4a),
      linear_4 = fmaf(R->m12, RM_8, linear_4c);
  const float linear_5a = KSL_MULF(R->m20, RM_6), linear_5c = fmaf(R->m21, RM_7, linear_5a),
      linear_5 = fmaf(R->m22, RM_8, linear_5c);
  const float RH_0a = KSL_MULF(R->m00, M->at[0][3]), RH_0c = fmaf(R->m01, M->at[0][4], RH_0a),
      RH_0 = fmaf(R->m02, M->at[0][5], RH_0c);
  const float RH_1a = KSL_MULF(R->m00, M->at[1][3]), RH_1c = fmaf(R->m01, M->at[1][4], RH_1a),
      RH_1 = fmaf(R->m02, M->at[1][5], RH_1c);
  const float RH_2a = KSL_MULF(R->m00, M->at[2][3]), RH_2c = fmaf(R->m01, M->at[2][4], RH_2a),
      RH_2 = fmaf(R->m02, M->at[2][5], RH_2c);
  const float RH_3a = KSL_MULF(R->m10, M->at[0][3]), RH_3c = fmaf(R->m11, M->at[0][4], RH_3a),
      RH_3 = fmaf(R->m12, M->at[0][5], RH_3c);
  const float RH_4a = KSL_MULF(R->m10, M->at[1][3]), RH_4c = fmaf(R->m11, M->at[1][4], RH_4a),
      RH_4 = fmaf(R->m12, M->at[1][5], RH_4c);
  const float RH_5a = KSL_MULF(R->m10, M->at[2][3]), RH_5c = fmaf(R->m11, M->at[2][4], RH_5a),
      RH_5 = fmaf(R->m12, M->at[2][5], RH_5c);
  const float RH_6a = KSL_MULF(R->m20, M->at[0][3]), RH_6c = fmaf(R->m21, M->at[0][4], RH_6a),
      RH_6 = fmaf(R->m22, M->at[0][5], RH_6c);
  const float RH_7a = KSL_MULF(R->m20, M->at[1][3]), RH_7c = fmaf(R->m21, M->at[1][4], RH_7a),
      RH_7 = fmaf(R->m22, M->at[1][5], RH_7c);
  const float RH_8a = KSL_MULF(R->m20, M->at[2][3]), RH_8c = fmaf(R->m21, M->at[2][4], RH_8a),
      RH_8 = fmaf(R->m22, M->at[2][5], RH_8c);
  const float coupling_0a = KSL_MULF(R->m00, RH_0), coupling_0c = fmaf(R->m01, RH_1, coupling_0a),
      coupling_0 = fmaf(R->m02, RH_2, coupling_0c);
  const float coupling_1a = KSL_MULF(R->m10, RH_0), coupling_1c = fmaf(R->m11, RH_1, coupling_1a),
      coupling_1 = fmaf(R->m12, RH_2, coupling_1c);
  const float coupling_2a = KSL_MULF(R->m20, RH_0), coupling_2c = fmaf(R->m21, RH_1, coupling_2a),
      coupling_2 = fmaf(R->m22, RH_2, coupling_2c);
  const float coupling_3a = KSL_MULF(R->m00, RH_3), coupling_3c = fmaf(R->m01, RH_4, coupling_3a),
      coupling_3 = fmaf(R->m02, RH_5, coupling_3c);
  const float coupling_4a = KSL_MULF(R->m10, RH_3), coupling_4c = fmaf(R->m11, RH_4, coupling_4a),
      coupling_4 = fmaf(R->m12, RH_5, coupling_4c);
  const float coupling_5a = KSL_MULF(R->m20, RH_3), coupling_5c = fmaf(R->m21, RH_4, coupling_5a),
      coupling_5 = fmaf(R->m22, RH_5, coupling_5c);
  const float coupling_6a = KSL_MULF(R->m00, RH_6), coupling_6c = fmaf(R->m01, RH_7, coupling_6a),
      coupling_6 = fmaf(R->m02, RH_8, coupling_6c);
  const float coupling_7a = KSL_MULF(R->m10, RH_6), coupling_7c = fmaf(R->m11, RH_7, coupling_7a),
      coupling_7 = fmaf(R->m12, RH_8, coupling_7c);
  const float coupling_8a = KSL_MULF(R->m20, RH_6), coupling_8c = fmaf(R->m21, RH_7, coupling_8a),
      coupling_8 = fmaf(R->m22, RH_8, coupling_8c);
  const float RI_0a = KSL_MULF(R->m00, M->at[3][3]), RI_0c = fmaf(R->m01, M->at[3][4], RI_0a),
      RI_0 = fmaf(R->m02, M->at[3][5], RI_0c);
  const float RI_1a = KSL_MULF(R->m00, M->at[3][4]), RI_1c = fmaf(R->m01, M->at[4][4], RI_1a),
      RI_1 = fmaf(R->m02, M->at[4][5], RI_1c);
  const float RI_2a = KSL_MULF(R->m00, M->at[3][5]), RI_2c = fmaf(R->m01, M->at[4][5], RI_2a),
      RI_2 = fmaf(R->m02, M->at[5][5], RI_2c);
  const float RI_3a = KSL_MULF(R->m10, M->at[3][3]), RI_3c = fmaf(R->m11, M->at[3][4], RI_3a),
      RI_3 = fmaf(R->m12, M->at[3][5], RI_3c);
  const float RI_4a = KSL_MULF(R->m10, M->at[3][4]), RI_4c = fmaf(R->m11, M->at[4][4], RI_4a),
      RI_4 = fmaf(R->m12, M->at[4][5], RI_4c);
  const float RI_5a = KSL_MULF(R->m10, M->at[3][5]), RI_5c = fmaf(R->m11, M->at[4][5], RI_5a),
      RI_5 = fmaf(R->m12, M->at[5][5], RI_5c);
  const float RI_6a = KSL_MULF(R->m20, M->at[3][3]), RI_6c = fmaf(R->m21, M->at[3][4], RI_6a),
      RI_6 = fmaf(R->m22, M->at[3][5], RI_6c);
  const float RI_7a = KSL_MULF(R->m20, M->at[3][4]), RI_7c = fmaf(R->m21, M->at[4][4], RI_7a),
      RI_7 = fmaf(R->m22, M->at[4][5], RI_7c);
  const float RI_8a = KSL_MULF(R->m20, M->at[3][5]), RI_8c = fmaf(R->m21, M->at[4][5], RI_8a),
      RI_8 = fmaf(R->m22, M->at[5][5], RI_8c);
  const float angular_0a = KSL_MULF(R->m00, RI_0), angular_0c = fmaf(R->m01, RI_1, angular_0a),
      angular_0 = fmaf(R->m02, RI_2, angular_0c);
  const float angular_1a = KSL_MULF(R->m00, RI_3), angular_1c = fmaf(R->m01, RI_4, angular_1a),
      angular_1 = fmaf(R->m02, RI_5, angular_1c);
  const float angular_2a = KSL_MULF(R->m10, RI_3), angular_2c = fmaf(R->m11, RI_4, angular_2a),
      angular_2 = fmaf(R->m12, RI_5, angular_2c);
  const float angular_3a = KSL_MULF(R->m00, RI_6), angular_3c = fmaf(R->m01, RI_7, angular_3a),
      angular_3 = fmaf(R->m02, RI_8, angular_3c);
  const float angular_4a = KSL_MULF(R->m10, RI_6), angular_4c = fmaf(R->m11, RI_7, angular_4a),
      angular_4 = fmaf(R->m12, RI_8, angular_4c);
  const float angular_5a = KSL_MULF(R->m20, RI_6), angular_5c = fmaf(R->m21, RI_7, angular_5a),
      angular_5 = fmaf(R->m22, RI_8, angular_5c);
  Mo->at[0][0] = linear_0;
  Mo->at[1][0] = linear_1;
  Mo->at[2][0] = linear_3;
  Mo->at[3][0] = coupling_0;
  Mo->at[4][0] = coupling_3;
  Mo->at[5][0] = coupling_6;
  Mo->at[0][1] = linear_1;
  Mo->at[1][1] = linear_2;
  Mo->at[2][1] = linear_4;
  Mo->at[3][1] = coupling_1;
  Mo->at[4][1] = coupling_4;
  Mo->at[5][1] = coupling_7;
  Mo->at[0][2] = linear_3;
  Mo->at[1][2] = linear_4;
  Mo->at[2][2] = linear_5;
  Mo->at[3][2] = coupling_2;
  Mo->at[4][2] = coupling_5;
  Mo->at[5][2] = coupling_8;
  Mo->at[0][3] = coupling_0;
  Mo->at[1][3] = coupling_1;
  Mo->at[2][3] = coupling_2;
  Mo->at[3][3] = angular_0;
  Mo->at[4][3] = angular_1;
  Mo->at[5][3] = angular_3;
  Mo->at[0][4] = coupling_3;
  Mo->at[1][4] = coupling_4;
  Mo->at[2][4] = coupling_5;
  Mo->at[3][4] = angular_1;
  Mo->at[4][4] = angular_2;
  Mo->at[5][4] = angular_4;
  Mo->at[0][5] = coupling_6;
  Mo->at[1][5] = coupling_7;
  Mo->at[2][5] = coupling_8;
  Mo->at[3][5] = angular_3;
  Mo->at[4][5] = angular_4;
  Mo->at[5][5] = angular_5;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read.
   t: vector; M, Mo: 6×6 operator.
   21 mul, 24 add, 18 fma.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_shifted_fused(const ksl_vec3f_t *t, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float G_0a = KSL_MULF(t->y, M->at[0][2]), G_0b = KSL_MULF(t->z, M->at[0][1]),
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const float G_1a = KSL_MULF(t->y, M->at[1][2]), G_1c = fmaf(-t->z, M->at[1][1], G_1a),
      G_1 = G_1c + M->at[1][3];
  const float G_2a = KSL_MULF(t->y, M->at[2][2]), G_2c = fmaf(-t->z, M->at[1][2], G_2a),
      G_2 = G_2c + M->at[2][3];
  const float G_3a = KSL_MULF(t->z, M->at[0][0]), G_3c = fmaf(-t->x, M->at[0][2], G_3a),
      G_3 = G_3c + M->at[0][4];
  const float G_4a = KSL_MULF(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const float G_5a = KSL_MULF(t->z, M->at[0][2]), G_5c = fmaf(-t->x, M->at[2][2], G_5a),
      G_5 = G_5c + M->at[2][4];
  const float G_6a = KSL_MULF(t->x, M->at[0][1]), G_6c = fmaf(-t->y, M->at[0][0], G_6a),
      G_6 = G_6c + M->at[0][5];
  const float G_7a = KSL_MULF(t->x, M->at[1][1]), G_7c = fmaf(-t->y, M->at[0][1], G_7a),
      G_7 = G_7c + M->at[1][5];
  const float G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const float moved_0a = KSL_MULF(t->y, M->at[2][3]), moved_0c = fmaf(-t->z, M->at[1][3], moved_0a),
      moved_0d = KSL_MULF(t->y, G_2), moved_0f = fmaf(-t->z, G_1, moved_0d),
      moved_0g = moved_0c + moved_0f, moved_0 = moved_0g + M->at[3][3];
  const float moved_1a = KSL_MULF(t->z, M->at[0][3]), moved_1c = fmaf(-t->x, M->at[2][3], moved_1a),
      moved_1d = KSL_MULF(t->y, G_5), moved_1f = fmaf(-t->z, G_4, moved_1d),
      moved_1g = moved_1c + moved_1f, moved_1 = moved_1g + M->at[3][4];
  const float moved_2a = KSL_MULF(t->z, M->at[0][4]), moved_2c = fmaf(-t->x, M->at[2][4], moved_2a),
      moved_2d = KSL_MULF(t->z, G_3), moved_2f = fmaf(-t->x, G_5, moved_2d),
      moved_2g = moved_2c + moved_2f, moved_2 = moved_2g + M->at[4][4];
  const float moved_3a = KSL_MULF(t->x, M->at[1][3]), moved_3c = fmaf(-t->y, M->at[0][3], moved_3a),
      moved_3d = KSL_MULF(t->y, G_8), moved_3f = fmaf(-t->z, G_7, moved_3d),
      moved_3g = moved_3c + moved_3f, moved_3 = moved_3g + M->at[3][5];
  const float moved_4a = KSL_MULF(t->x, M->at[1][4]), moved_4c = fmaf(-t->y, M->at[0][4], moved_4a),
      moved_4d = KSL_MULF(t->z, G_6), moved_4f = fmaf(-t->x, G_8, moved_4d),
      moved_4g = moved_4c + moved_4f, moved_4 = moved_4g + M->at[4][5];
  const float moved_5a = KSL_MULF(t->x, M->at[1][5]), moved_5c = fmaf(-t->y, M->at[0][5], moved_5a),
      moved_5d = KSL_MULF(t->x, G_7), moved_5f = fmaf(-t->y, G_6, moved_5d),
      moved_5g = moved_5c + moved_5f, moved_5 = moved_5g + M->at[5][5];
  const float M_at_00 = M->at[0][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_11 = M->at[1][1];
  const float M_at_12 = M->at[1][2];
  const float M_at_22 = M->at[2][2];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = G_0;
  Mo->at[4][0] = G_3;
  Mo->at[5][0] = G_6;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = G_1;
  Mo->at[4][1] = G_4;
  Mo->at[5][1] = G_7;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = G_2;
  Mo->at[4][2] = G_5;
  Mo->at[5][2] = G_8;
  Mo->at[0][3] = G_0;
  Mo->at[1][3] = G_1;
  Mo->at[2][3] = G_2;
  Mo->at[3][3] = moved_0;
  Mo->at[4][3] = moved_1;
  Mo->at[5][3] = moved_3;
  Mo->at[0][4] = G_3;
  Mo->at[1][4] = G_4;
  Mo->at[2][4] = G_5;
  Mo->at[3][4] = moved_1;
  Mo->at[4][4] = moved_2;
  Mo->at[5][4] = moved_4;
  Mo->at[0][5] = G_6;
  Mo->at[1][5] = G_7;
  Mo->at[2][5] = G_8;
  Mo->at[3][5] = moved_3;
  Mo->at[4][5] = moved_4;
  Mo->at[5][5] = moved_5;
}

#endif

/* Products between rotations, displacements and vectors.
   Fused tier: products fused into sums. */
#ifndef KSL_MATRIX_FUSED_H
#define KSL_MATRIX_FUSED_H


/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c = fma(R->m01, v->y, vo_0a),
      vo_0 = fma(R->m02, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1c = fma(R->m11, v->y, vo_1a),
      vo_1 = fma(R->m12, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2c = fma(R->m21, v->y, vo_2a),
      vo_2 = fma(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fma(-R->m01, v->y, vo_0c_lead), vo_0 = fma(-R->m02, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fma(-R->m11, v->y, vo_1c_lead), vo_1 = fma(-R->m12, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fma(-R->m21, v->y, vo_2c_lead), vo_2 = fma(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c = fma(R->m10, v->y, vo_0a),
      vo_0 = fma(R->m20, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1c = fma(R->m11, v->y, vo_1a),
      vo_1 = fma(R->m21, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2c = fma(R->m12, v->y, vo_2a),
      vo_2 = fma(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fma(-R->m10, v->y, vo_0c_lead), vo_0 = fma(-R->m20, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fma(-R->m11, v->y, vo_1c_lead), vo_1 = fma(-R->m21, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fma(-R->m12, v->y, vo_2c_lead), vo_2 = fma(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dv_fused(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0c = fma(D->m01, v->y, vo_0a),
      vo_0e = fma(D->m02, v->z, vo_0c), vo_0 = vo_0e + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1c = fma(D->m11, v->y, vo_1a),
      vo_1e = fma(D->m12, v->z, vo_1c), vo_1 = vo_1e + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2c = fma(D->m21, v->y, vo_2a),
      vo_2e = fma(D->m22, v->z, vo_2c), vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvv_fused(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0c = fma(D->m10, p_1, vo_0a),
      vo_0 = fma(D->m20, p_2, vo_0c);
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1c = fma(D->m11, p_1, vo_1a),
      vo_1 = fma(D->m21, p_2, vo_1c);
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2c = fma(D->m12, p_1, vo_2a),
      vo_2 = fma(D->m22, p_2, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdr_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m01, R2->m10, Ro_00a),
      Ro_00 = fma(R1->m02, R2->m20, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01c = fma(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m02, R2->m21, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02c = fma(R1->m01, R2->m12, Ro_02a),
      Ro_02 = fma(R1->m02, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10c = fma(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fma(R1->m12, R2->m20, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m12, R2->m21, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12c = fma(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fma(R1->m12, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20c = fma(R1->m21, R2->m10, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m20, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21c = fma(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m21, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22c = fma(R1->m21, R2->m12, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinv_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m01, R2->m01, Ro_00a),
      Ro_00 = fma(R1->m02, R2->m02, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01c = fma(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m02, R2->m12, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02c = fma(R1->m01, R2->m21, Ro_02a),
      Ro_02 = fma(R1->m02, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10c = fma(R1->m11, R2->m01, Ro_10a),
      Ro_10 = fma(R1->m12, R2->m02, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m12, R2->m12, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12c = fma(R1->m11, R2->m21, Ro_12a),
      Ro_12 = fma(R1->m12, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20c = fma(R1->m21, R2->m01, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m02, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21c = fma(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m12, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22c = fma(R1->m21, R2->m21, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdr_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m10, R2->m10, Ro_00a),
      Ro_00 = fma(R1->m20, R2->m20, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01c = fma(R1->m10, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m20, R2->m21, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02c = fma(R1->m10, R2->m12, Ro_02a),
      Ro_02 = fma(R1->m20, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10c = fma(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fma(R1->m21, R2->m20, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m21, R2->m21, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12c = fma(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fma(R1->m21, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20c = fma(R1->m12, R2->m10, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m20, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21c = fma(R1->m12, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m21, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22c = fma(R1->m12, R2->m12, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00c = fma(D1->m01, D2->m10, Do_00a),
      Do_00 = fma(D1->m02, D2->m20, Do_00c);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01c = fma(D1->m01, D2->m11, Do_01a),
      Do_01 = fma(D1->m02, D2->m21, Do_01c);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02c = fma(D1->m01, D2->m12, Do_02a),
      Do_02 = fma(D1->m02, D2->m22, Do_02c);
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03c = fma(D1->m01, D2->m13, Do_03a),
      Do_03e = fma(D1->m02, D2->m23, Do_03c), Do_03 = Do_03e + D1->m03;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10c = fma(D1->m11, D2->m10, Do_10a),
      Do_10 = fma(D1->m12, D2->m20, Do_10c);
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11c = fma(D1->m11, D2->m11, Do_11a),
      Do_11 = fma(D1->m12, D2->m21, Do_11c);
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12c = fma(D1->m11, D2->m12, Do_12a),
      Do_12 = fma(D1->m12, D2->m22, Do_12c);
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13c = fma(D1->m11, D2->m13, Do_13a),
      Do_13e = fma(D1->m12, D2->m23, Do_13c), Do_13 = Do_13e + D1->m13;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20c = fma(D1->m21, D2->m10, Do_20a),
      Do_20 = fma(D1->m22, D2->m20, Do_20c);
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21c = fma(D1->m21, D2->m11, Do_21a),
      Do_21 = fma(D1->m22, D2->m21, Do_21c);
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22c = fma(D1->m21, D2->m12, Do_22a),
      Do_22 = fma(D1->m22, D2->m22, Do_22c);
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23c = fma(D1->m21, D2->m13, Do_23a),
      Do_23e = fma(D1->m22, D2->m23, Do_23c), Do_23 = Do_23e + D1->m23;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0c = fma(D1->m01, D2->m01, R_0a),
      R_0 = fma(D1->m02, D2->m02, R_0c);
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1c = fma(D1->m01, D2->m11, R_1a),
      R_1 = fma(D1->m02, D2->m12, R_1c);
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2c = fma(D1->m01, D2->m21, R_2a),
      R_2 = fma(D1->m02, D2->m22, R_2c);
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3c = fma(D1->m11, D2->m01, R_3a),
      R_3 = fma(D1->m12, D2->m02, R_3c);
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4c = fma(D1->m11, D2->m11, R_4a),
      R_4 = fma(D1->m12, D2->m12, R_4c);
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5c = fma(D1->m11, D2->m21, R_5a),
      R_5 = fma(D1->m12, D2->m22, R_5c);
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6c = fma(D1->m21, D2->m01, R_6a),
      R_6 = fma(D1->m22, D2->m02, R_6c);
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7c = fma(D1->m21, D2->m11, R_7a),
      R_7 = fma(D1->m22, D2->m12, R_7c);
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8c = fma(D1->m21, D2->m21, R_8a),
      R_8 = fma(D1->m22, D2->m22, R_8c);
  const double Do_03a = KSL_MUL(D2->m03, R_0), Do_03c = fma(D2->m13, R_1, Do_03a),
      Do_03e = fma(D2->m23, R_2, Do_03c), Do_03 = D1->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D2->m03, R_3), Do_13c = fma(D2->m13, R_4, Do_13a),
      Do_13e = fma(D2->m23, R_5, Do_13c), Do_13 = D1->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D2->m03, R_6), Do_23c = fma(D2->m13, R_7, Do_23a),
      Do_23e = fma(D2->m23, R_8, Do_23c), Do_23 = D1->m23 - Do_23e;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00c = fma(D1->m10, D2->m10, Do_00a),
      Do_00 = fma(D1->m20, D2->m20, Do_00c);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01c = fma(D1->m10, D2->m11, Do_01a),
      Do_01 = fma(D1->m20, D2->m21, Do_01c);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02c = fma(D1->m10, D2->m12, Do_02a),
      Do_02 = fma(D1->m20, D2->m22, Do_02c);
  const double Do_03a = KSL_MUL(D1->m00, p_0), Do_03c = fma(D1->m10, p_1, Do_03a),
      Do_03 = fma(D1->m20, p_2, Do_03c);
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10c = fma(D1->m11, D2->m10, Do_10a),
      Do_10 = fma(D1->m21, D2->m20, Do_10c);
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11c = fma(D1->m11, D2->m11, Do_11a),
      Do_11 = fma(D1->m21, D2->m21, Do_11c);
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12c = fma(D1->m11, D2->m12, Do_12a),
      Do_12 = fma(D1->m21, D2->m22, Do_12c);
  const double Do_13a = KSL_MUL(D1->m01, p_0), Do_13c = fma(D1->m11, p_1, Do_13a),
      Do_13 = fma(D1->m21, p_2, Do_13c);
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20c = fma(D1->m12, D2->m10, Do_20a),
      Do_20 = fma(D1->m22, D2->m20, Do_20c);
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21c = fma(D1->m12, D2->m11, Do_21a),
      Do_21 = fma(D1->m22, D2->m21, Do_21c);
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22c = fma(D1->m12, D2->m12, Do_22a),
      Do_22 = fma(D1->m22, D2->m22, Do_22c);
  const double Do_23a = KSL_MUL(D1->m02, p_0), Do_23c = fma(D1->m12, p_1, Do_23a),
      Do_23 = fma(D1->m22, p_2, Do_23c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr_fused(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00c = fma(D->m01, R->m10, Do_00a),
      Do_00 = fma(D->m02, R->m20, Do_00c);
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01c = fma(D->m01, R->m11, Do_01a),
      Do_01 = fma(D->m02, R->m21, Do_01c);
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02c = fma(D->m01, R->m12, Do_02a),
      Do_02 = fma(D->m02, R->m22, Do_02c);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10c = fma(D->m11, R->m10, Do_10a),
      Do_10 = fma(D->m12, R->m20, Do_10c);
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11c = fma(D->m11, R->m11, Do_11a),
      Do_11 = fma(D->m12, R->m21, Do_11c);
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12c = fma(D->m11, R->m12, Do_12a),
      Do_12 = fma(D->m12, R->m22, Do_12c);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20c = fma(D->m21, R->m10, Do_20a),
      Do_20 = fma(D->m22, R->m20, Do_20c);
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21c = fma(D->m21, R->m11, Do_21a),
      Do_21 = fma(D->m22, R->m21, Do_21c);
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22c = fma(D->m21, R->m12, Do_22a),
      Do_22 = fma(D->m22, R->m22, Do_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv_fused(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00c = fma(D->m01, R->m01, Do_00a),
      Do_00 = fma(D->m02, R->m02, Do_00c);
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01c = fma(D->m01, R->m11, Do_01a),
      Do_01 = fma(D->m02, R->m12, Do_01c);
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02c = fma(D->m01, R->m21, Do_02a),
      Do_02 = fma(D->m02, R->m22, Do_02c);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10c = fma(D->m11, R->m01, Do_10a),
      Do_10 = fma(D->m12, R->m02, Do_10c);
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11c = fma(D->m11, R->m11, Do_11a),
      Do_11 = fma(D->m12, R->m12, Do_11c);
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12c = fma(D->m11, R->m21, Do_12a),
      Do_12 = fma(D->m12, R->m22, Do_12c);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20c = fma(D->m21, R->m01, Do_20a),
      Do_20 = fma(D->m22, R->m02, Do_20c);
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21c = fma(D->m21, R->m11, Do_21a),
      Do_21 = fma(D->m22, R->m12, Do_21c);
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22c = fma(D->m21, R->m21, Do_22a),
      Do_22 = fma(D->m22, R->m22, Do_22c);
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt_fused(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03c = fma(D->m01, t->y, Do_03a),
      Do_03e = fma(D->m02, t->z, Do_03c), Do_03 = Do_03e + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13c = fma(D->m11, t->y, Do_13a),
      Do_13e = fma(D->m12, t->z, Do_13c), Do_13 = Do_13e + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23c = fma(D->m21, t->y, Do_23a),
      Do_23e = fma(D->m22, t->z, Do_23c), Do_23 = Do_23e + D->m23;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv_fused(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03c = fma(D->m01, t->y, Do_03a),
      Do_03e = fma(D->m02, t->z, Do_03c), Do_03 = D->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13c = fma(D->m11, t->y, Do_13a),
      Do_13e = fma(D->m12, t->z, Do_13c), Do_13 = D->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23c = fma(D->m21, t->y, Do_23a),
      Do_23e = fma(D->m22, t->z, Do_23c), Do_23 = D->m23 - Do_23e;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt_fused(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03c = fma(D->m10, p_1, Do_03a),
      Do_03 = fma(D->m20, p_2, Do_03c);
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13c = fma(D->m11, p_1, Do_13a),
      Do_13 = fma(D->m21, p_2, Do_13c);
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23c = fma(D->m12, p_1, Do_23a),
      Do_23 = fma(D->m22, p_2, Do_23c);
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
static inline void ksl_product_drvtx_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m00, k);
  const double vo_1 = KSL_MUL(R->m10, k);
  const double vo_2 = KSL_MUL(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(R->m02, dc[0], Ro_01a);
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02 = fma(-R->m01, dc[0], Ro_02a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(R->m12, dc[0], Ro_11a);
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12 = fma(-R->m11, dc[0], Ro_12a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(R->m22, dc[0], Ro_21a);
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22 = fma(-R->m21, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(D->m02, dc[0], Do_01a);
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02 = fma(-D->m01, dc[0], Do_02a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(D->m12, dc[0], Do_11a);
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12 = fma(-D->m11, dc[0], Do_12a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(D->m22, dc[0], Do_21a);
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22 = fma(-D->m21, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtx_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m00, k, D->m03);
  const double Do_13 = fma(D->m10, k, D->m13);
  const double Do_23 = fma(D->m20, k, D->m23);
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
static inline void ksl_product_drvtxinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(-R->m02, dc[0], Ro_01a);
  const double Ro_02a = KSL_MUL(R->m01, dc[0]), Ro_02 = fma(R->m02, dc[1], Ro_02a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(-R->m12, dc[0], Ro_11a);
  const double Ro_12a = KSL_MUL(R->m11, dc[0]), Ro_12 = fma(R->m12, dc[1], Ro_12a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(-R->m22, dc[0], Ro_21a);
  const double Ro_22a = KSL_MUL(R->m21, dc[0]), Ro_22 = fma(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(-D->m02, dc[0], Do_01a);
  const double Do_02a = KSL_MUL(D->m01, dc[0]), Do_02 = fma(D->m02, dc[1], Do_02a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(-D->m12, dc[0], Do_11a);
  const double Do_12a = KSL_MUL(D->m11, dc[0]), Do_12 = fma(D->m12, dc[1], Do_12a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(-D->m22, dc[0], Do_21a);
  const double Do_22a = KSL_MUL(D->m21, dc[0]), Do_22 = fma(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m00, k, D->m03);
  const double Do_13 = fma(-D->m10, k, D->m13);
  const double Do_23 = fma(-D->m20, k, D->m23);
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
static inline void ksl_product_drvty_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m01, k);
  const double vo_1 = KSL_MUL(R->m11, k);
  const double vo_2 = KSL_MUL(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(-R->m02, dc[0], Ro_00a);
  const double Ro_02a = KSL_MUL(R->m00, dc[0]), Ro_02 = fma(R->m02, dc[1], Ro_02a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(-R->m12, dc[0], Ro_10a);
  const double Ro_12a = KSL_MUL(R->m10, dc[0]), Ro_12 = fma(R->m12, dc[1], Ro_12a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(-R->m22, dc[0], Ro_20a);
  const double Ro_22a = KSL_MUL(R->m20, dc[0]), Ro_22 = fma(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(-D->m02, dc[0], Do_00a);
  const double Do_02a = KSL_MUL(D->m00, dc[0]), Do_02 = fma(D->m02, dc[1], Do_02a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(-D->m12, dc[0], Do_10a);
  const double Do_12a = KSL_MUL(D->m10, dc[0]), Do_12 = fma(D->m12, dc[1], Do_12a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(-D->m22, dc[0], Do_20a);
  const double Do_22a = KSL_MUL(D->m20, dc[0]), Do_22 = fma(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddty_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m01, k, D->m03);
  const double Do_13 = fma(D->m11, k, D->m13);
  const double Do_23 = fma(D->m21, k, D->m23);
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
static inline void ksl_product_drvtyinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(R->m02, dc[0], Ro_00a);
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02 = fma(-R->m00, dc[0], Ro_02a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(R->m12, dc[0], Ro_10a);
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12 = fma(-R->m10, dc[0], Ro_12a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(R->m22, dc[0], Ro_20a);
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22 = fma(-R->m20, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(D->m02, dc[0], Do_00a);
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02 = fma(-D->m00, dc[0], Do_02a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(D->m12, dc[0], Do_10a);
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12 = fma(-D->m10, dc[0], Do_12a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(D->m22, dc[0], Do_20a);
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22 = fma(-D->m20, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m01, k, D->m03);
  const double Do_13 = fma(-D->m11, k, D->m13);
  const double Do_23 = fma(-D->m21, k, D->m23);
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
static inline void ksl_product_drvtz_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m02, k);
  const double vo_1 = KSL_MUL(R->m12, k);
  const double vo_2 = KSL_MUL(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(R->m01, dc[0], Ro_00a);
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(-R->m00, dc[0], Ro_01a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(R->m11, dc[0], Ro_10a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(-R->m10, dc[0], Ro_11a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(R->m21, dc[0], Ro_20a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(-R->m20, dc[0], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(D->m01, dc[0], Do_00a);
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(-D->m00, dc[0], Do_01a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(D->m11, dc[0], Do_10a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(-D->m10, dc[0], Do_11a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(D->m21, dc[0], Do_20a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(-D->m20, dc[0], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtz_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m02, k, D->m03);
  const double Do_13 = fma(D->m12, k, D->m13);
  const double Do_23 = fma(D->m22, k, D->m23);
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
static inline void ksl_product_drvtzinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(-R->m01, dc[0], Ro_00a);
  const double Ro_01a = KSL_MUL(R->m00, dc[0]), Ro_01 = fma(R->m01, dc[1], Ro_01a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(-R->m11, dc[0], Ro_10a);
  const double Ro_11a = KSL_MUL(R->m10, dc[0]), Ro_11 = fma(R->m11, dc[1], Ro_11a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(-R->m21, dc[0], Ro_20a);
  const double Ro_21a = KSL_MUL(R->m20, dc[0]), Ro_21 = fma(R->m21, dc[1], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(-D->m01, dc[0], Do_00a);
  const double Do_01a = KSL_MUL(D->m00, dc[0]), Do_01 = fma(D->m01, dc[1], Do_01a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(-D->m11, dc[0], Do_10a);
  const double Do_11a = KSL_MUL(D->m10, dc[0]), Do_11 = fma(D->m11, dc[1], Do_11a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(-D->m21, dc[0], Do_20a);
  const double Do_21a = KSL_MUL(D->m20, dc[0]), Do_21 = fma(D->m21, dc[1], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m02, k, D->m03);
  const double Do_13 = fma(-D->m12, k, D->m13);
  const double Do_23 = fma(-D->m22, k, D->m23);
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
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c = fmaf(R->m01, v->y, vo_0a),
      vo_0 = fmaf(R->m02, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1c = fmaf(R->m11, v->y, vo_1a),
      vo_1 = fmaf(R->m12, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2c = fmaf(R->m21, v->y, vo_2a),
      vo_2 = fmaf(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fmaf(-R->m01, v->y, vo_0c_lead), vo_0 = fmaf(-R->m02, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fmaf(-R->m11, v->y, vo_1c_lead), vo_1 = fmaf(-R->m12, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fmaf(-R->m21, v->y, vo_2c_lead), vo_2 = fmaf(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c = fmaf(R->m10, v->y, vo_0a),
      vo_0 = fmaf(R->m20, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1c = fmaf(R->m11, v->y, vo_1a),
      vo_1 = fmaf(R->m21, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2c = fmaf(R->m12, v->y, vo_2a),
      vo_2 = fmaf(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fmaf(-R->m10, v->y, vo_0c_lead), vo_0 = fmaf(-R->m20, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fmaf(-R->m11, v->y, vo_1c_lead), vo_1 = fmaf(-R->m21, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fmaf(-R->m12, v->y, vo_2c_lead), vo_2 = fmaf(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0c = fmaf(D->m01, v->y, vo_0a),
      vo_0e = fmaf(D->m02, v->z, vo_0c), vo_0 = vo_0e + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1c = fmaf(D->m11, v->y, vo_1a),
      vo_1e = fmaf(D->m12, v->z, vo_1c), vo_1 = vo_1e + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2c = fmaf(D->m21, v->y, vo_2a),
      vo_2e = fmaf(D->m22, v->z, vo_2c), vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = KSL_MULF(D->m00, p_0), vo_0c = fmaf(D->m10, p_1, vo_0a),
      vo_0 = fmaf(D->m20, p_2, vo_0c);
  const float vo_1a = KSL_MULF(D->m01, p_0), vo_1c = fmaf(D->m11, p_1, vo_1a),
      vo_1 = fmaf(D->m21, p_2, vo_1c);
  const float vo_2a = KSL_MULF(D->m02, p_0), vo_2c = fmaf(D->m12, p_1, vo_2a),
      vo_2 = fmaf(D->m22, p_2, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m01, R2->m10, Ro_00a),
      Ro_00 = fmaf(R1->m02, R2->m20, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01c = fmaf(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m02, R2->m21, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02c = fmaf(R1->m01, R2->m12, Ro_02a),
      Ro_02 = fmaf(R1->m02, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10c = fmaf(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fmaf(R1->m12, R2->m20, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m10, R2->m01), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m12, R2->m21, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m10, R2->m02), Ro_12c = fmaf(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fmaf(R1->m12, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20c = fmaf(R1->m21, R2->m10, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m20, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m20, R2->m01), Ro_21c = fmaf(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m21, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m20, R2->m02), Ro_22c = fmaf(R1->m21, R2->m12, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinvf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m01, R2->m01, Ro_00a),
      Ro_00 = fmaf(R1->m02, R2->m02, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m10), Ro_01c = fmaf(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m02, R2->m12, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m20), Ro_02c = fmaf(R1->m01, R2->m21, Ro_02a),
      Ro_02 = fmaf(R1->m02, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10c = fmaf(R1->m11, R2->m01, Ro_10a),
      Ro_10 = fmaf(R1->m12, R2->m02, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m10, R2->m10), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m12, R2->m12, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m10, R2->m20), Ro_12c = fmaf(R1->m11, R2->m21, Ro_12a),
      Ro_12 = fmaf(R1->m12, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20c = fmaf(R1->m21, R2->m01, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m02, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m20, R2->m10), Ro_21c = fmaf(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m12, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m20, R2->m20), Ro_22c = fmaf(R1->m21, R2->m21, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdrf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m10, R2->m10, Ro_00a),
      Ro_00 = fmaf(R1->m20, R2->m20, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01c = fmaf(R1->m10, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m20, R2->m21, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02c = fmaf(R1->m10, R2->m12, Ro_02a),
      Ro_02 = fmaf(R1->m20, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m01, R2->m00), Ro_10c = fmaf(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fmaf(R1->m21, R2->m20, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m01, R2->m01), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m21, R2->m21, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m01, R2->m02), Ro_12c = fmaf(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fmaf(R1->m21, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m02, R2->m00), Ro_20c = fmaf(R1->m12, R2->m10, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m20, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m02, R2->m01), Ro_21c = fmaf(R1->m12, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m21, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m02, R2->m02), Ro_22c = fmaf(R1->m12, R2->m12, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00c = fmaf(D1->m01, D2->m10, Do_00a),
      Do_00 = fmaf(D1->m02, D2->m20, Do_00c);
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01c = fmaf(D1->m01, D2->m11, Do_01a),
      Do_01 = fmaf(D1->m02, D2->m21, Do_01c);
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02c = fmaf(D1->m01, D2->m12, Do_02a),
      Do_02 = fmaf(D1->m02, D2->m22, Do_02c);
  const float Do_03a = KSL_MULF(D1->m00, D2->m03), Do_03c = fmaf(D1->m01, D2->m13, Do_03a),
      Do_03e = fmaf(D1->m02, D2->m23, Do_03c), Do_03 = Do_03e + D1->m03;
  const float Do_10a = KSL_MULF(D1->m10, D2->m00), Do_10c = fmaf(D1->m11, D2->m10, Do_10a),
      Do_10 = fmaf(D1->m12, D2->m20, Do_10c);
  const float Do_11a = KSL_MULF(D1->m10, D2->m01), Do_11c = fmaf(D1->m11, D2->m11, Do_11a),
      Do_11 = fmaf(D1->m12, D2->m21, Do_11c);
  const float Do_12a = KSL_MULF(D1->m10, D2->m02), Do_12c = fmaf(D1->m11, D2->m12, Do_12a),
      Do_12 = fmaf(D1->m12, D2->m22, Do_12c);
  const float Do_13a = KSL_MULF(D1->m10, D2->m03), Do_13c = fmaf(D1->m11, D2->m13, Do_13a),
      Do_13e = fmaf(D1->m12, D2->m23, Do_13c), Do_13 = Do_13e + D1->m13;
  const float Do_20a = KSL_MULF(D1->m20, D2->m00), Do_20c = fmaf(D1->m21, D2->m10, Do_20a),
      Do_20 = fmaf(D1->m22, D2->m20, Do_20c);
  const float Do_21a = KSL_MULF(D1->m20, D2->m01), Do_21c = fmaf(D1->m21, D2->m11, Do_21a),
      Do_21 = fmaf(D1->m22, D2->m21, Do_21c);
  const float Do_22a = KSL_MULF(D1->m20, D2->m02), Do_22c = fmaf(D1->m21, D2->m12, Do_22a),
      Do_22 = fmaf(D1->m22, D2->m22, Do_22c);
  const float Do_23a = KSL_MULF(D1->m20, D2->m03), Do_23c = fmaf(D1->m21, D2->m13, Do_23a),
      Do_23e = fmaf(D1->m22, D2->m23, Do_23c), Do_23 = Do_23e + D1->m23;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinvf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float R_0a = KSL_MULF(D1->m00, D2->m00), R_0c = fmaf(D1->m01, D2->m01, R_0a),
      R_0 = fmaf(D1->m02, D2->m02, R_0c);
  const float R_1a = KSL_MULF(D1->m00, D2->m10), R_1c = fmaf(D1->m01, D2->m11, R_1a),
      R_1 = fmaf(D1->m02, D2->m12, R_1c);
  const float R_2a = KSL_MULF(D1->m00, D2->m20), R_2c = fmaf(D1->m01, D2->m21, R_2a),
      R_2 = fmaf(D1->m02, D2->m22, R_2c);
  const float R_3a = KSL_MULF(D1->m10, D2->m00), R_3c = fmaf(D1->m11, D2->m01, R_3a),
      R_3 = fmaf(D1->m12, D2->m02, R_3c);
  const float R_4a = KSL_MULF(D1->m10, D2->m10), R_4c = fmaf(D1->m11, D2->m11, R_4a),
      R_4 = fmaf(D1->m12, D2->m12, R_4c);
  const float R_5a = KSL_MULF(D1->m10, D2->m20), R_5c = fmaf(D1->m11, D2->m21, R_5a),
      R_5 = fmaf(D1->m12, D2->m22, R_5c);
  const float R_6a = KSL_MULF(D1->m20, D2->m00), R_6c = fmaf(D1->m21, D2->m01, R_6a),
      R_6 = fmaf(D1->m22, D2->m02, R_6c);
  const float R_7a = KSL_MULF(D1->m20, D2->m10), R_7c = fmaf(D1->m21, D2->m11, R_7a),
      R_7 = fmaf(D1->m22, D2->m12, R_7c);
  const float R_8a = KSL_MULF(D1->m20, D2->m20), R_8c = fmaf(D1->m21, D2->m21, R_8a),
      R_8 = fmaf(D1->m22, D2->m22, R_8c);
  const float Do_03a = KSL_MULF(D2->m03, R_0), Do_03c = fmaf(D2->m13, R_1, Do_03a),
      Do_03e = fmaf(D2->m23, R_2, Do_03c), Do_03 = D1->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D2->m03, R_3), Do_13c = fmaf(D2->m13, R_4, Do_13a),
      Do_13e = fmaf(D2->m23, R_5, Do_13c), Do_13 = D1->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D2->m03, R_6), Do_23c = fmaf(D2->m13, R_7, Do_23a),
      Do_23e = fmaf(D2->m23, R_8, Do_23c), Do_23 = D1->m23 - Do_23e;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00c = fmaf(D1->m10, D2->m10, Do_00a),
      Do_00 = fmaf(D1->m20, D2->m20, Do_00c);
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01c = fmaf(D1->m10, D2->m11, Do_01a),
      Do_01 = fmaf(D1->m20, D2->m21, Do_01c);
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02c = fmaf(D1->m10, D2->m12, Do_02a),
      Do_02 = fmaf(D1->m20, D2->m22, Do_02c);
  const float Do_03a = KSL_MULF(D1->m00, p_0), Do_03c = fmaf(D1->m10, p_1, Do_03a),
      Do_03 = fmaf(D1->m20, p_2, Do_03c);
  const float Do_10a = KSL_MULF(D1->m01, D2->m00), Do_10c = fmaf(D1->m11, D2->m10, Do_10a),
      Do_10 = fmaf(D1->m21, D2->m20, Do_10c);
  const float Do_11a = KSL_MULF(D1->m01, D2->m01), Do_11c = fmaf(D1->m11, D2->m11, Do_11a),
      Do_11 = fmaf(D1->m21, D2->m21, Do_11c);
  const float Do_12a = KSL_MULF(D1->m01, D2->m02), Do_12c = fmaf(D1->m11, D2->m12, Do_12a),
      Do_12 = fmaf(D1->m21, D2->m22, Do_12c);
  const float Do_13a = KSL_MULF(D1->m01, p_0), Do_13c = fmaf(D1->m11, p_1, Do_13a),
      Do_13 = fmaf(D1->m21, p_2, Do_13c);
  const float Do_20a = KSL_MULF(D1->m02, D2->m00), Do_20c = fmaf(D1->m12, D2->m10, Do_20a),
      Do_20 = fmaf(D1->m22, D2->m20, Do_20c);
  const float Do_21a = KSL_MULF(D1->m02, D2->m01), Do_21c = fmaf(D1->m12, D2->m11, Do_21a),
      Do_21 = fmaf(D1->m22, D2->m21, Do_21c);
  const float Do_22a = KSL_MULF(D1->m02, D2->m02), Do_22c = fmaf(D1->m12, D2->m12, Do_22a),
      Do_22 = fmaf(D1->m22, D2->m22, Do_22c);
  const float Do_23a = KSL_MULF(D1->m02, p_0), Do_23c = fmaf(D1->m12, p_1, Do_23a),
      Do_23 = fmaf(D1->m22, p_2, Do_23c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf_fused(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00c = fmaf(D->m01, R->m10, Do_00a),
      Do_00 = fmaf(D->m02, R->m20, Do_00c);
  const float Do_01a = KSL_MULF(D->m00, R->m01), Do_01c = fmaf(D->m01, R->m11, Do_01a),
      Do_01 = fmaf(D->m02, R->m21, Do_01c);
  const float Do_02a = KSL_MULF(D->m00, R->m02), Do_02c = fmaf(D->m01, R->m12, Do_02a),
      Do_02 = fmaf(D->m02, R->m22, Do_02c);
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10c = fmaf(D->m11, R->m10, Do_10a),
      Do_10 = fmaf(D->m12, R->m20, Do_10c);
  const float Do_11a = KSL_MULF(D->m10, R->m01), Do_11c = fmaf(D->m11, R->m11, Do_11a),
      Do_11 = fmaf(D->m12, R->m21, Do_11c);
  const float Do_12a = KSL_MULF(D->m10, R->m02), Do_12c = fmaf(D->m11, R->m12, Do_12a),
      Do_12 = fmaf(D->m12, R->m22, Do_12c);
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20c = fmaf(D->m21, R->m10, Do_20a),
      Do_20 = fmaf(D->m22, R->m20, Do_20c);
  const float Do_21a = KSL_MULF(D->m20, R->m01), Do_21c = fmaf(D->m21, R->m11, Do_21a),
      Do_21 = fmaf(D->m22, R->m21, Do_21c);
  const float Do_22a = KSL_MULF(D->m20, R->m02), Do_22c = fmaf(D->m21, R->m12, Do_22a),
      Do_22 = fmaf(D->m22, R->m22, Do_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf_fused(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00c = fmaf(D->m01, R->m01, Do_00a),
      Do_00 = fmaf(D->m02, R->m02, Do_00c);
  const float Do_01a = KSL_MULF(D->m00, R->m10), Do_01c = fmaf(D->m01, R->m11, Do_01a),
      Do_01 = fmaf(D->m02, R->m12, Do_01c);
  const float Do_02a = KSL_MULF(D->m00, R->m20), Do_02c = fmaf(D->m01, R->m21, Do_02a),
      Do_02 = fmaf(D->m02, R->m22, Do_02c);
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10c = fmaf(D->m11, R->m01, Do_10a),
      Do_10 = fmaf(D->m12, R->m02, Do_10c);
  const float Do_11a = KSL_MULF(D->m10, R->m10), Do_11c = fmaf(D->m11, R->m11, Do_11a),
      Do_11 = fmaf(D->m12, R->m12, Do_11c);
  const float Do_12a = KSL_MULF(D->m10, R->m20), Do_12c = fmaf(D->m11, R->m21, Do_12a),
      Do_12 = fmaf(D->m12, R->m22, Do_12c);
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20c = fmaf(D->m21, R->m01, Do_20a),
      Do_20 = fmaf(D->m22, R->m02, Do_20c);
  const float Do_21a = KSL_MULF(D->m20, R->m10), Do_21c = fmaf(D->m21, R->m11, Do_21a),
      Do_21 = fmaf(D->m22, R->m12, Do_21c);
  const float Do_22a = KSL_MULF(D->m20, R->m20), Do_22c = fmaf(D->m21, R->m21, Do_22a),
      Do_22 = fmaf(D->m22, R->m22, Do_22c);
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03c = fmaf(D->m01, t->y, Do_03a),
      Do_03e = fmaf(D->m02, t->z, Do_03c), Do_03 = Do_03e + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13c = fmaf(D->m11, t->y, Do_13a),
      Do_13e = fmaf(D->m12, t->z, Do_13c), Do_13 = Do_13e + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23c = fmaf(D->m21, t->y, Do_23a),
      Do_23e = fmaf(D->m22, t->z, Do_23c), Do_23 = Do_23e + D->m23;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03c = fmaf(D->m01, t->y, Do_03a),
      Do_03e = fmaf(D->m02, t->z, Do_03c), Do_03 = D->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13c = fmaf(D->m11, t->y, Do_13a),
      Do_13e = fmaf(D->m12, t->z, Do_13c), Do_13 = D->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23c = fmaf(D->m21, t->y, Do_23a),
      Do_23e = fmaf(D->m22, t->z, Do_23c), Do_23 = D->m23 - Do_23e;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = KSL_MULF(D->m00, p_0), Do_03c = fmaf(D->m10, p_1, Do_03a),
      Do_03 = fmaf(D->m20, p_2, Do_03c);
  const float Do_13a = KSL_MULF(D->m01, p_0), Do_13c = fmaf(D->m11, p_1, Do_13a),
      Do_13 = fmaf(D->m21, p_2, Do_13c);
  const float Do_23a = KSL_MULF(D->m02, p_0), Do_23c = fmaf(D->m12, p_1, Do_23a),
      Do_23 = fmaf(D->m22, p_2, Do_23c);
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
static inline void ksl_product_drvtxf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m00, k);
  const float vo_1 = KSL_MULF(R->m10, k);
  const float vo_2 = KSL_MULF(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(R->m02, dc[0], Ro_01a);
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02 = fmaf(-R->m01, dc[0], Ro_02a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(R->m12, dc[0], Ro_11a);
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12 = fmaf(-R->m11, dc[0], Ro_12a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(R->m22, dc[0], Ro_21a);
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22 = fmaf(-R->m21, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(D->m02, dc[0], Do_01a);
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02 = fmaf(-D->m01, dc[0], Do_02a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(D->m12, dc[0], Do_11a);
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12 = fmaf(-D->m11, dc[0], Do_12a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(D->m22, dc[0], Do_21a);
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22 = fmaf(-D->m21, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m00, k, D->m03);
  const float Do_13 = fmaf(D->m10, k, D->m13);
  const float Do_23 = fmaf(D->m20, k, D->m23);
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
static inline void ksl_product_drvtxinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(-R->m02, dc[0], Ro_01a);
  const float Ro_02a = KSL_MULF(R->m01, dc[0]), Ro_02 = fmaf(R->m02, dc[1], Ro_02a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(-R->m12, dc[0], Ro_11a);
  const float Ro_12a = KSL_MULF(R->m11, dc[0]), Ro_12 = fmaf(R->m12, dc[1], Ro_12a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(-R->m22, dc[0], Ro_21a);
  const float Ro_22a = KSL_MULF(R->m21, dc[0]), Ro_22 = fmaf(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(-D->m02, dc[0], Do_01a);
  const float Do_02a = KSL_MULF(D->m01, dc[0]), Do_02 = fmaf(D->m02, dc[1], Do_02a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(-D->m12, dc[0], Do_11a);
  const float Do_12a = KSL_MULF(D->m11, dc[0]), Do_12 = fmaf(D->m12, dc[1], Do_12a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(-D->m22, dc[0], Do_21a);
  const float Do_22a = KSL_MULF(D->m21, dc[0]), Do_22 = fmaf(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m00, k, D->m03);
  const float Do_13 = fmaf(-D->m10, k, D->m13);
  const float Do_23 = fmaf(-D->m20, k, D->m23);
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
static inline void ksl_product_drvtyf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m01, k);
  const float vo_1 = KSL_MULF(R->m11, k);
  const float vo_2 = KSL_MULF(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(-R->m02, dc[0], Ro_00a);
  const float Ro_02a = KSL_MULF(R->m00, dc[0]), Ro_02 = fmaf(R->m02, dc[1], Ro_02a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(-R->m12, dc[0], Ro_10a);
  const float Ro_12a = KSL_MULF(R->m10, dc[0]), Ro_12 = fmaf(R->m12, dc[1], Ro_12a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(-R->m22, dc[0], Ro_20a);
  const float Ro_22a = KSL_MULF(R->m20, dc[0]), Ro_22 = fmaf(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(-D->m02, dc[0], Do_00a);
  const float Do_02a = KSL_MULF(D->m00, dc[0]), Do_02 = fmaf(D->m02, dc[1], Do_02a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(-D->m12, dc[0], Do_10a);
  const float Do_12a = KSL_MULF(D->m10, dc[0]), Do_12 = fmaf(D->m12, dc[1], Do_12a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(-D->m22, dc[0], Do_20a);
  const float Do_22a = KSL_MULF(D->m20, dc[0]), Do_22 = fmaf(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m01, k, D->m03);
  const float Do_13 = fmaf(D->m11, k, D->m13);
  const float Do_23 = fmaf(D->m21, k, D->m23);
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
static inline void ksl_product_drvtyinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(R->m02, dc[0], Ro_00a);
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02 = fmaf(-R->m00, dc[0], Ro_02a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(R->m12, dc[0], Ro_10a);
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12 = fmaf(-R->m10, dc[0], Ro_12a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(R->m22, dc[0], Ro_20a);
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22 = fmaf(-R->m20, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(D->m02, dc[0], Do_00a);
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02 = fmaf(-D->m00, dc[0], Do_02a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(D->m12, dc[0], Do_10a);
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12 = fmaf(-D->m10, dc[0], Do_12a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(D->m22, dc[0], Do_20a);
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22 = fmaf(-D->m20, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m01, k, D->m03);
  const float Do_13 = fmaf(-D->m11, k, D->m13);
  const float Do_23 = fmaf(-D->m21, k, D->m23);
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
static inline void ksl_product_drvtzf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m02, k);
  const float vo_1 = KSL_MULF(R->m12, k);
  const float vo_2 = KSL_MULF(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(R->m01, dc[0], Ro_00a);
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(-R->m00, dc[0], Ro_01a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(R->m11, dc[0], Ro_10a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(-R->m10, dc[0], Ro_11a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(R->m21, dc[0], Ro_20a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(-R->m20, dc[0], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(D->m01, dc[0], Do_00a);
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(-D->m00, dc[0], Do_01a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(D->m11, dc[0], Do_10a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(-D->m10, dc[0], Do_11a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(D->m21, dc[0], Do_20a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(-D->m20, dc[0], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m02, k, D->m03);
  const float Do_13 = fmaf(D->m12, k, D->m13);
  const float Do_23 = fmaf(D->m22, k, D->m23);
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
static inline void ksl_product_drvtzinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(-R->m01, dc[0], Ro_00a);
  const float Ro_01a = KSL_MULF(R->m00, dc[0]), Ro_01 = fmaf(R->m01, dc[1], Ro_01a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(-R->m11, dc[0], Ro_10a);
  const float Ro_11a = KSL_MULF(R->m10, dc[0]), Ro_11 = fmaf(R->m11, dc[1], Ro_11a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(-R->m21, dc[0], Ro_20a);
  const float Ro_21a = KSL_MULF(R->m20, dc[0]), Ro_21 = fmaf(R->m21, dc[1], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(-D->m01, dc[0], Do_00a);
  const float Do_01a = KSL_MULF(D->m00, dc[0]), Do_01 = fmaf(D->m01, dc[1], Do_01a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(-D->m11, dc[0], Do_10a);
  const float Do_11a = KSL_MULF(D->m10, dc[0]), Do_11 = fmaf(D->m11, dc[1], Do_11a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(-D->m21, dc[0], Do_20a);
  const float Do_21a = KSL_MULF(D->m20, dc[0]), Do_21 = fmaf(D->m21, dc[1], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m02, k, D->m03);
  const float Do_13 = fmaf(-D->m12, k, D->m13);
  const float Do_23 = fmaf(-D->m22, k, D->m23);
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

/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Fused tier: products fused into sums. */
#ifndef KSL_SCREW_FUSED_H
#define KSL_SCREW_FUSED_H


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

/* Coscrews: wrenches and momenta, c = (f; τ).
   Fused tier: products fused into sums. */
#ifndef KSL_COSCREW_FUSED_H
#define KSL_COSCREW_FUSED_H


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

/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Fused tier: products fused into sums. */
#ifndef KSL_QUATERNION_FUSED_H
#define KSL_QUATERNION_FUSED_H


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

/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Fused tier: products fused into sums. */
#ifndef KSL_EXPONENTIAL_FUSED_H
#define KSL_EXPONENTIAL_FUSED_H


/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalize_fused(ksl_mat3x3_t *self) {
  const double defect_0b = fma(-self->m00, self->m00, 1.0),
      defect_0d = fma(-self->m10, self->m10, defect_0b),
      defect_0 = fma(-self->m20, self->m20, defect_0d);
  const double defect_1b = fma(-self->m01, self->m01, 1.0),
      defect_1d = fma(-self->m11, self->m11, defect_1b),
      defect_1 = fma(-self->m21, self->m21, defect_1d);
  const double defect_2b = fma(-self->m02, self->m02, 1.0),
      defect_2d = fma(-self->m12, self->m12, defect_2b),
      defect_2 = fma(-self->m22, self->m22, defect_2d);
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3c_lead = -defect_3a,
      defect_3c = fma(-self->m10, self->m11, defect_3c_lead),
      defect_3 = fma(-self->m20, self->m21, defect_3c);
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4c_lead = -defect_4a,
      defect_4c = fma(-self->m10, self->m12, defect_4c_lead),
      defect_4 = fma(-self->m20, self->m22, defect_4c);
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5c_lead = -defect_5a,
      defect_5c = fma(-self->m11, self->m12, defect_5c_lead),
      defect_5 = fma(-self->m21, self->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_c = fma(self->m01, correction_3, self_00_new_a),
      self_00_new_e = fma(self->m02, correction_4, self_00_new_c),
      self_00_new = self->m00 + self_00_new_e;
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_c = fma(self->m01, correction_1, self_01_new_a),
      self_01_new_e = fma(self->m02, correction_5, self_01_new_c),
      self_01_new = self_01_new_e + self->m01;
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_c = fma(self->m01, correction_5, self_02_new_a),
      self_02_new_e = fma(self->m02, correction_2, self_02_new_c),
      self_02_new = self_02_new_e + self->m02;
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_c = fma(self->m11, correction_3, self_10_new_a),
      self_10_new_e = fma(self->m12, correction_4, self_10_new_c),
      self_10_new = self->m10 + self_10_new_e;
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_c = fma(self->m11, correction_1, self_11_new_a),
      self_11_new_e = fma(self->m12, correction_5, self_11_new_c),
      self_11_new = self_11_new_e + self->m11;
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_c = fma(self->m11, correction_5, self_12_new_a),
      self_12_new_e = fma(self->m12, correction_2, self_12_new_c),
      self_12_new = self_12_new_e + self->m12;
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_c = fma(self->m21, correction_3, self_20_new_a),
      self_20_new_e = fma(self->m22, correction_4, self_20_new_c),
      self_20_new = self->m20 + self_20_new_e;
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_c = fma(self->m21, correction_1, self_21_new_a),
      self_21_new_e = fma(self->m22, correction_5, self_21_new_c),
      self_21_new = self_21_new_e + self->m21;
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_c = fma(self->m21, correction_5, self_22_new_a),
      self_22_new_e = fma(self->m22, correction_2, self_22_new_c),
      self_22_new = self_22_new_e + self->m22;
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

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalized_fused(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0b = fma(-R->m00, R->m00, 1.0), defect_0d = fma(-R->m10, R->m10, defect_0b),
      defect_0 = fma(-R->m20, R->m20, defect_0d);
  const double defect_1b = fma(-R->m01, R->m01, 1.0), defect_1d = fma(-R->m11, R->m11, defect_1b),
      defect_1 = fma(-R->m21, R->m21, defect_1d);
  const double defect_2b = fma(-R->m02, R->m02, 1.0), defect_2d = fma(-R->m12, R->m12, defect_2b),
      defect_2 = fma(-R->m22, R->m22, defect_2d);
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3c_lead = -defect_3a,
      defect_3c = fma(-R->m10, R->m11, defect_3c_lead), defect_3 = fma(-R->m20, R->m21, defect_3c);
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4c_lead = -defect_4a,
      defect_4c = fma(-R->m10, R->m12, defect_4c_lead), defect_4 = fma(-R->m20, R->m22, defect_4c);
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5c_lead = -defect_5a,
      defect_5c = fma(-R->m11, R->m12, defect_5c_lead), defect_5 = fma(-R->m21, R->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00a = KSL_MUL(R->m00, correction_0), Ro_00c = fma(R->m01, correction_3, Ro_00a),
      Ro_00e = fma(R->m02, correction_4, Ro_00c), Ro_00 = R->m00 + Ro_00e;
  const double Ro_01a = KSL_MUL(R->m00, correction_3), Ro_01c = fma(R->m01, correction_1, Ro_01a),
      Ro_01e = fma(R->m02, correction_5, Ro_01c), Ro_01 = Ro_01e + R->m01;
  const double Ro_02a = KSL_MUL(R->m00, correction_4), Ro_02c = fma(R->m01, correction_5, Ro_02a),
      Ro_02e = fma(R->m02, correction_2, Ro_02c), Ro_02 = Ro_02e + R->m02;
  const double Ro_10a = KSL_MUL(R->m10, correction_0), Ro_10c = fma(R->m11, correction_3, Ro_10a),
      Ro_10e = fma(R->m12, correction_4, Ro_10c), Ro_10 = R->m10 + Ro_10e;
  const double Ro_11a = KSL_MUL(R->m10, correction_3), Ro_11c = fma(R->m11, correction_1, Ro_11a),
      Ro_11e = fma(R->m12, correction_5, Ro_11c), Ro_11 = Ro_11e + R->m11;
  const double Ro_12a = KSL_MUL(R->m10, correction_4), Ro_12c = fma(R->m11, correction_5, Ro_12a),
      Ro_12e = fma(R->m12, correction_2, Ro_12c), Ro_12 = Ro_12e + R->m12;
  const double Ro_20a = KSL_MUL(R->m20, correction_0), Ro_20c = fma(R->m21, correction_3, Ro_20a),
      Ro_20e = fma(R->m22, correction_4, Ro_20c), Ro_20 = R->m20 + Ro_20e;
  const double Ro_21a = KSL_MUL(R->m20, correction_3), Ro_21c = fma(R->m21, correction_1, Ro_21a),
      Ro_21e = fma(R->m22, correction_5, Ro_21c), Ro_21 = Ro_21e + R->m21;
  const double Ro_22a = KSL_MUL(R->m20, correction_4), Ro_22c = fma(R->m21, correction_5, Ro_22a),
      Ro_22e = fma(R->m22, correction_2, Ro_22c), Ro_22 = Ro_22e + R->m22;
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

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalize_fused(ksl_mat3x3f_t *self) {
  const float defect_0b = fmaf(-self->m00, self->m00, 1.0f),
      defect_0d = fmaf(-self->m10, self->m10, defect_0b),
      defect_0 = fmaf(-self->m20, self->m20, defect_0d);
  const float defect_1b = fmaf(-self->m01, self->m01, 1.0f),
      defect_1d = fmaf(-self->m11, self->m11, defect_1b),
      defect_1 = fmaf(-self->m21, self->m21, defect_1d);
  const float defect_2b = fmaf(-self->m02, self->m02, 1.0f),
      defect_2d = fmaf(-self->m12, self->m12, defect_2b),
      defect_2 = fmaf(-self->m22, self->m22, defect_2d);
  const float defect_3a = KSL_MULF(self->m00, self->m01), defect_3c_lead = -defect_3a,
      defect_3c = fmaf(-self->m10, self->m11, defect_3c_lead),
      defect_3 = fmaf(-self->m20, self->m21, defect_3c);
  const float defect_4a = KSL_MULF(self->m00, self->m02), defect_4c_lead = -defect_4a,
      defect_4c = fmaf(-self->m10, self->m12, defect_4c_lead),
      defect_4 = fmaf(-self->m20, self->m22, defect_4c);
  const float defect_5a = KSL_MULF(self->m01, self->m02), defect_5c_lead = -defect_5a,
      defect_5c = fmaf(-self->m11, self->m12, defect_5c_lead),
      defect_5 = fmaf(-self->m21, self->m22, defect_5c);
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new_a = KSL_MULF(self->m00, correction_0),
      self_00_new_c = fmaf(self->m01, correction_3, self_00_new_a),
      self_00_new_e = fmaf(self->m02, correction_4, self_00_new_c),
      self_00_new = self->m00 + self_00_new_e;
  const float self_01_new_a = KSL_MULF(self->m00, correction_3),
      self_01_new_c = fmaf(self->m01, correction_1, self_01_new_a),
      self_01_new_e = fmaf(self->m02, correction_5, self_01_new_c),
      self_01_new = self_01_new_e + self->m01;
  const float self_02_new_a = KSL_MULF(self->m00, correction_4),
      self_02_new_c = fmaf(self->m01, correction_5, self_02_new_a),
      self_02_new_e = fmaf(self->m02, correction_2, self_02_new_c),
      self_02_new = self_02_new_e + self->m02;
  const float self_10_new_a = KSL_MULF(self->m10, correction_0),
      self_10_new_c = fmaf(self->m11, correction_3, self_10_new_a),
      self_10_new_e = fmaf(self->m12, correction_4, self_10_new_c),
      self_10_new = self->m10 + self_10_new_e;
  const float self_11_new_a = KSL_MULF(self->m10, correction_3),
      self_11_new_c = fmaf(self->m11, correction_1, self_11_new_a),
      self_11_new_e = fmaf(self->m12, correction_5, self_11_new_c),
      self_11_new = self_11_new_e + self->m11;
  const float self_12_new_a = KSL_MULF(self->m10, correction_4),
      self_12_new_c = fmaf(self->m11, correction_5, self_12_new_a),
      self_12_new_e = fmaf(self->m12, correction_2, self_12_new_c),
      self_12_new = self_12_new_e + self->m12;
  const float self_20_new_a = KSL_MULF(self->m20, correction_0),
      self_20_new_c = fmaf(self->m21, correction_3, self_20_new_a),
      self_20_new_e = fmaf(self->m22, correction_4, self_20_new_c),
      self_20_new = self->m20 + self_20_new_e;
  const float self_21_new_a = KSL_MULF(self->m20, correction_3),
      self_21_new_c = fmaf(self->m21, correction_1, self_21_new_a),
      self_21_new_e = fmaf(self->m22, correction_5, self_21_new_c),
      self_21_new = self_21_new_e + self->m21;
  const float self_22_new_a = KSL_MULF(self->m20, correction_4),
      self_22_new_c = fmaf(self->m21, correction_5, self_22_new_a),
      self_22_new_e = fmaf(self->m22, correction_2, self_22_new_c),
      self_22_new = self_22_new_e + self->m22;
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

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalized_fused(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float defect_0b = fmaf(-R->m00, R->m00, 1.0f), defect_0d = fmaf(-R->m10, R->m10, defect_0b),
      defect_0 = fmaf(-R->m20, R->m20, defect_0d);
  const float defect_1b = fmaf(-R->m01, R->m01, 1.0f), defect_1d = fmaf(-R->m11, R->m11, defect_1b),
      defect_1 = fmaf(-R->m21, R->m21, defect_1d);
  const float defect_2b = fmaf(-R->m02, R->m02, 1.0f), defect_2d = fmaf(-R->m12, R->m12, defect_2b),
      defect_2 = fmaf(-R->m22, R->m22, defect_2d);
  const float defect_3a = KSL_MULF(R->m00, R->m01), defect_3c_lead = -defect_3a,
      defect_3c = fmaf(-R->m10, R->m11, defect_3c_lead),
      defect_3 = fmaf(-R->m20, R->m21, defect_3c);
  const float defect_4a = KSL_MULF(R->m00, R->m02), defect_4c_lead = -defect_4a,
      defect_4c = fmaf(-R->m10, R->m12, defect_4c_lead),
      defect_4 = fmaf(-R->m20, R->m22, defect_4c);
  const float defect_5a = KSL_MULF(R->m01, R->m02), defect_5c_lead = -defect_5a,
      defect_5c = fmaf(-R->m11, R->m12, defect_5c_lead),
      defect_5 = fmaf(-R->m21, R->m22, defect_5c);
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00a = KSL_MULF(R->m00, correction_0), Ro_00c = fmaf(R->m01, correction_3, Ro_00a),
      Ro_00e = fmaf(R->m02, correction_4, Ro_00c), Ro_00 = R->m00 + Ro_00e;
  const float Ro_01a = KSL_MULF(R->m00, correction_3), Ro_01c = fmaf(R->m01, correction_1, Ro_01a),
      Ro_01e = fmaf(R->m02, correction_5, Ro_01c), Ro_01 = Ro_01e + R->m01;
  const float Ro_02a = KSL_MULF(R->m00, correction_4), Ro_02c = fmaf(R->m01, correction_5, Ro_02a),
      Ro_02e = fmaf(R->m02, correction_2, Ro_02c), Ro_02 = Ro_02e + R->m02;
  const float Ro_10a = KSL_MULF(R->m10, correction_0), Ro_10c = fmaf(R->m11, correction_3, Ro_10a),
      Ro_10e = fmaf(R->m12, correction_4, Ro_10c), Ro_10 = R->m10 + Ro_10e;
  const float Ro_11a = KSL_MULF(R->m10, correction_3), Ro_11c = fmaf(R->m11, correction_1, Ro_11a),
      Ro_11e = fmaf(R->m12, correction_5, Ro_11c), Ro_11 = Ro_11e + R->m11;
  const float Ro_12a = KSL_MULF(R->m10, correction_4), Ro_12c = fmaf(R->m11, correction_5, Ro_12a),
      Ro_12e = fmaf(R->m12, correction_2, Ro_12c), Ro_12 = Ro_12e + R->m12;
  const float Ro_20a = KSL_MULF(R->m20, correction_0), Ro_20c = fmaf(R->m21, correction_3, Ro_20a),
      Ro_20e = fmaf(R->m22, correction_4, Ro_20c), Ro_20 = R->m20 + Ro_20e;
  const float Ro_21a = KSL_MULF(R->m20, correction_3), Ro_21c = fmaf(R->m21, correction_1, Ro_21a),
      Ro_21e = fmaf(R->m22, correction_5, Ro_21c), Ro_21 = Ro_21e + R->m21;
  const float Ro_22a = KSL_MULF(R->m20, correction_4), Ro_22c = fmaf(R->m21, correction_5, Ro_22a),
      Ro_22e = fmaf(R->m22, correction_2, Ro_22c), Ro_22 = Ro_22e + R->m22;
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

#endif

/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.
   Fused tier: products fused into sums. */
#ifndef KSL_INERTIA_FUSED_H
#define KSL_INERTIA_FUSED_H


/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertia_t ksl_inertia_fused(const double m, const ksl_vec3_t t,
    const double Ixx, const double Iyy, const double Izz, const double Ixy,
    const double Iyz, const double Izx) {
  const double J_1 = KSL_MUL(m, t.x);
  const double J_2 = KSL_MUL(m, t.y);
  const double J_3 = KSL_MUL(m, t.z);
  ksl_inertia_t J;
  J.m = m;
  J.mt.x = J_1;
  J.mt.y = J_2;
  J.mt.z = J_3;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotated_fused(const ksl_inertia_t *Ji, const ksl_mat3x3_t *R,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, R->m00), RI_0c = fma(Ji->Ixy, R->m01, RI_0a),
      RI_0 = fma(Ji->Izx, R->m02, RI_0c);
  const double RI_1a = KSL_MUL(Ji->Iyy, R->m01), RI_1c = fma(Ji->Ixy, R->m00, RI_1a),
      RI_1 = fma(Ji->Iyz, R->m02, RI_1c);
  const double RI_2a = KSL_MUL(Ji->Izz, R->m02), RI_2c = fma(Ji->Iyz, R->m01, RI_2a),
      RI_2 = fma(Ji->Izx, R->m00, RI_2c);
  const double RI_3a = KSL_MUL(Ji->Ixx, R->m10), RI_3c = fma(Ji->Ixy, R->m11, RI_3a),
      RI_3 = fma(Ji->Izx, R->m12, RI_3c);
  const double RI_4a = KSL_MUL(Ji->Iyy, R->m11), RI_4c = fma(Ji->Ixy, R->m10, RI_4a),
      RI_4 = fma(Ji->Iyz, R->m12, RI_4c);
  const double RI_5a = KSL_MUL(Ji->Izz, R->m12), RI_5c = fma(Ji->Iyz, R->m11, RI_5a),
      RI_5 = fma(Ji->Izx, R->m10, RI_5c);
  const double RI_6a = KSL_MUL(Ji->Ixx, R->m20), RI_6c = fma(Ji->Ixy, R->m21, RI_6a),
      RI_6 = fma(Ji->Izx, R->m22, RI_6c);
  const double RI_7a = KSL_MUL(Ji->Iyy, R->m21), RI_7c = fma(Ji->Ixy, R->m20, RI_7a),
      RI_7 = fma(Ji->Iyz, R->m22, RI_7c);
  const double RI_8a = KSL_MUL(Ji->Izz, R->m22), RI_8c = fma(Ji->Iyz, R->m21, RI_8a),
      RI_8 = fma(Ji->Izx, R->m20, RI_8c);
  const double Jo_1a = KSL_MUL(Ji->mt.x, R->m00), Jo_1c = fma(Ji->mt.y, R->m01, Jo_1a),
      Jo_1 = fma(Ji->mt.z, R->m02, Jo_1c);
  const double Jo_2a = KSL_MUL(Ji->mt.x, R->m10), Jo_2c = fma(Ji->mt.y, R->m11, Jo_2a),
      Jo_2 = fma(Ji->mt.z, R->m12, Jo_2c);
  const double Jo_3a = KSL_MUL(Ji->mt.x, R->m20), Jo_3c = fma(Ji->mt.y, R->m21, Jo_3a),
      Jo_3 = fma(Ji->mt.z, R->m22, Jo_3c);
  const double Jo_4a = KSL_MUL(R->m00, RI_0), Jo_4c = fma(R->m01, RI_1, Jo_4a),
      Jo_4 = fma(R->m02, RI_2, Jo_4c);
  const double Jo_5a = KSL_MUL(R->m10, RI_3), Jo_5c = fma(R->m11, RI_4, Jo_5a),
      Jo_5 = fma(R->m12, RI_5, Jo_5c);
  const double Jo_6a = KSL_MUL(R->m20, RI_6), Jo_6c = fma(R->m21, RI_7, Jo_6a),
      Jo_6 = fma(R->m22, RI_8, Jo_6c);
  const double Jo_7a = KSL_MUL(R->m10, RI_0), Jo_7c = fma(R->m11, RI_1, Jo_7a),
      Jo_7 = fma(R->m12, RI_2, Jo_7c);
  const double Jo_8a = KSL_MUL(R->m20, RI_3), Jo_8c = fma(R->m21, RI_4, Jo_8a),
      Jo_8 = fma(R->m22, RI_5, Jo_8c);
  const double Jo_9a = KSL_MUL(R->m20, RI_0), Jo_9c = fma(R->m21, RI_1, Jo_9a),
      Jo_9 = fma(R->m22, RI_2, Jo_9c);
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotate_fused(ksl_inertia_t *self, const ksl_mat3x3_t *R) {
  const double RI_0a = KSL_MUL(self->Ixx, R->m00), RI_0c = fma(self->Ixy, R->m01, RI_0a),
      RI_0 = fma(self->Izx, R->m02, RI_0c);
  const double RI_1a = KSL_MUL(self->Iyy, R->m01), RI_1c = fma(self->Ixy, R->m00, RI_1a),
      RI_1 = fma(self->Iyz, R->m02, RI_1c);
  const double RI_2a = KSL_MUL(self->Izz, R->m02), RI_2c = fma(self->Iyz, R->m01, RI_2a),
      RI_2 = fma(self->Izx, R->m00, RI_2c);
  const double RI_3a = KSL_MUL(self->Ixx, R->m10), RI_3c = fma(self->Ixy, R->m11, RI_3a),
      RI_3 = fma(self->Izx, R->m12, RI_3c);
  const double RI_4a = KSL_MUL(self->Iyy, R->m11), RI_4c = fma(self->Ixy, R->m10, RI_4a),
      RI_4 = fma(self->Iyz, R->m12, RI_4c);
  const double RI_5a = KSL_MUL(self->Izz, R->m12), RI_5c = fma(self->Iyz, R->m11, RI_5a),
      RI_5 = fma(self->Izx, R->m10, RI_5c);
  const double RI_6a = KSL_MUL(self->Ixx, R->m20), RI_6c = fma(self->Ixy, R->m21, RI_6a),
      RI_6 = fma(self->Izx, R->m22, RI_6c);
  const double RI_7a = KSL_MUL(self->Iyy, R->m21), RI_7c = fma(self->Ixy, R->m20, RI_7a),
      RI_7 = fma(self->Iyz, R->m22, RI_7c);
  const double RI_8a = KSL_MUL(self->Izz, R->m22), RI_8c = fma(self->Iyz, R->m21, RI_8a),
      RI_8 = fma(self->Izx, R->m20, RI_8c);
  const double self_1_new_a = KSL_MUL(self->mt.x, R->m00),
      self_1_new_c = fma(self->mt.y, R->m01, self_1_new_a),
      self_1_new = fma(self->mt.z, R->m02, self_1_new_c);
  const double self_2_new_a = KSL_MUL(self->mt.x, R->m10),
      self_2_new_c = fma(self->mt.y, R->m11, self_2_new_a),
      self_2_new = fma(self->mt.z, R->m12, self_2_new_c);
  const double self_3_new_a = KSL_MUL(self->mt.x, R->m20),
      self_3_new_c = fma(self->mt.y, R->m21, self_3_new_a),
      self_3_new = fma(self->mt.z, R->m22, self_3_new_c);
  const double self_4_new_a = KSL_MUL(R->m00, RI_0), self_4_new_c = fma(R->m01, RI_1, self_4_new_a),
      self_4_new = fma(R->m02, RI_2, self_4_new_c);
  const double self_5_new_a = KSL_MUL(R->m10, RI_3), self_5_new_c = fma(R->m11, RI_4, self_5_new_a),
      self_5_new = fma(R->m12, RI_5, self_5_new_c);
  const double self_6_new_a = KSL_MUL(R->m20, RI_6), self_6_new_c = fma(R->m21, RI_7, self_6_new_a),
      self_6_new = fma(R->m22, RI_8, self_6_new_c);
  const double self_7_new_a = KSL_MUL(R->m10, RI_0), self_7_new_c = fma(R->m11, RI_1, self_7_new_a),
      self_7_new = fma(R->m12, RI_2, self_7_new_c);
  const double self_8_new_a = KSL_MUL(R->m20, RI_3), self_8_new_c = fma(R->m21, RI_4, self_8_new_a),
      self_8_new = fma(R->m22, RI_5, self_8_new_c);
  const double self_9_new_a = KSL_MUL(R->m20, RI_0), self_9_new_c = fma(R->m21, RI_1, self_9_new_a),
      self_9_new = fma(R->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_translated_fused(const ksl_inertia_t *Ji, const ksl_vec3_t *t,
    ksl_inertia_t *Jo) {
  const double Jo_1 = fma(Ji->m, t->x, Ji->mt.x);
  const double Jo_2 = fma(Ji->m, t->y, Ji->mt.y);
  const double Jo_3 = fma(Ji->m, t->z, Ji->mt.z);
  const double Ji_m = Ji->m;
  const double Ji_Ixx = Ji->Ixx;
  const double Ji_Iyy = Ji->Iyy;
  const double Ji_Izz = Ji->Izz;
  const double Ji_Ixy = Ji->Ixy;
  const double Ji_Iyz = Ji->Iyz;
  const double Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_translate_fused(ksl_inertia_t *self, const ksl_vec3_t *t) {
  const double self_1_new = fma(self->m, t->x, self->mt.x);
  const double self_2_new = fma(self->m, t->y, self->mt.y);
  const double self_3_new = fma(self->m, t->z, self->mt.z);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transformed_fused(const ksl_inertia_t *Ji, const ksl_SE3_t *D,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, D->m00), RI_0c = fma(Ji->Ixy, D->m01, RI_0a),
      RI_0 = fma(Ji->Izx, D->m02, RI_0c);
  const double RI_1a = KSL_MUL(Ji->Iyy, D->m01), RI_1c = fma(Ji->Ixy, D->m00, RI_1a),
      RI_1 = fma(Ji->Iyz, D->m02, RI_1c);
  const double RI_2a = KSL_MUL(Ji->Izz, D->m02), RI_2c = fma(Ji->Iyz, D->m01, RI_2a),
      RI_2 = fma(Ji->Izx, D->m00, RI_2c);
  const double RI_3a = KSL_MUL(Ji->Ixx, D->m10), RI_3c = fma(Ji->Ixy, D->m11, RI_3a),
      RI_3 = fma(Ji->Izx, D->m12, RI_3c);
  const double RI_4a = KSL_MUL(Ji->Iyy, D->m11), RI_4c = fma(Ji->Ixy, D->m10, RI_4a),
      RI_4 = fma(Ji->Iyz, D->m12, RI_4c);
  const double RI_5a = KSL_MUL(Ji->Izz, D->m12), RI_5c = fma(Ji->Iyz, D->m11, RI_5a),
      RI_5 = fma(Ji->Izx, D->m10, RI_5c);
  const double RI_6a = KSL_MUL(Ji->Ixx, D->m20), RI_6c = fma(Ji->Ixy, D->m21, RI_6a),
      RI_6 = fma(Ji->Izx, D->m22, RI_6c);
  const double RI_7a = KSL_MUL(Ji->Iyy, D->m21), RI_7c = fma(Ji->Ixy, D->m20, RI_7a),
      RI_7 = fma(Ji->Iyz, D->m22, RI_7c);
  const double RI_8a = KSL_MUL(Ji->Izz, D->m22), RI_8c = fma(Ji->Iyz, D->m21, RI_8a),
      RI_8 = fma(Ji->Izx, D->m20, RI_8c);
  const double Jo_1b = KSL_MUL(Ji->mt.x, D->m00), Jo_1d = fma(Ji->mt.y, D->m01, Jo_1b),
      Jo_1f = fma(Ji->mt.z, D->m02, Jo_1d), Jo_1 = fma(Ji->m, D->m03, Jo_1f);
  const double Jo_2b = KSL_MUL(Ji->mt.x, D->m10), Jo_2d = fma(Ji->mt.y, D->m11, Jo_2b),
      Jo_2f = fma(Ji->mt.z, D->m12, Jo_2d), Jo_2 = fma(Ji->m, D->m13, Jo_2f);
  const double Jo_3b = KSL_MUL(Ji->mt.x, D->m20), Jo_3d = fma(Ji->mt.y, D->m21, Jo_3b),
      Jo_3f = fma(Ji->mt.z, D->m22, Jo_3d), Jo_3 = fma(Ji->m, D->m23, Jo_3f);
  const double Jo_4a = KSL_MUL(D->m00, RI_0), Jo_4c = fma(D->m01, RI_1, Jo_4a),
      Jo_4 = fma(D->m02, RI_2, Jo_4c);
  const double Jo_5a = KSL_MUL(D->m10, RI_3), Jo_5c = fma(D->m11, RI_4, Jo_5a),
      Jo_5 = fma(D->m12, RI_5, Jo_5c);
  const double Jo_6a = KSL_MUL(D->m20, RI_6), Jo_6c = fma(D->m21, RI_7, Jo_6a),
      Jo_6 = fma(D->m22, RI_8, Jo_6c);
  const double Jo_7a = KSL_MUL(D->m10, RI_0), Jo_7c = fma(D->m11, RI_1, Jo_7a),
      Jo_7 = fma(D->m12, RI_2, Jo_7c);
  const double Jo_8a = KSL_MUL(D->m20, RI_3), Jo_8c = fma(D->m21, RI_4, Jo_8a),
      Jo_8 = fma(D->m22, RI_5, Jo_8c);
  const double Jo_9a = KSL_MUL(D->m20, RI_0), Jo_9c = fma(D->m21, RI_1, Jo_9a),
      Jo_9 = fma(D->m22, RI_2, Jo_9c);
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transform_fused(ksl_inertia_t *self, const ksl_SE3_t *D) {
  const double RI_0a = KSL_MUL(self->Ixx, D->m00), RI_0c = fma(self->Ixy, D->m01, RI_0a),
      RI_0 = fma(self->Izx, D->m02, RI_0c);
  const double RI_1a = KSL_MUL(self->Iyy, D->m01), RI_1c = fma(self->Ixy, D->m00, RI_1a),
      RI_1 = fma(self->Iyz, D->m02, RI_1c);
  const double RI_2a = KSL_MUL(self->Izz, D->m02), RI_2c = fma(self->Iyz, D->m01, RI_2a),
      RI_2 = fma(self->Izx, D->m00, RI_2c);
  const double RI_3a = KSL_MUL(self->Ixx, D->m10), RI_3c = fma(self->Ixy, D->m11, RI_3a),
      RI_3 = fma(self->Izx, D->m12, RI_3c);
  const double RI_4a = KSL_MUL(self->Iyy, D->m11), RI_4c = fma(self->Ixy, D->m10, RI_4a),
      RI_4 = fma(self->Iyz, D->m12, RI_4c);
  const double RI_5a = KSL_MUL(self->Izz, D->m12), RI_5c = fma(self->Iyz, D->m11, RI_5a),
      RI_5 = fma(self->Izx, D->m10, RI_5c);
  const double RI_6a = KSL_MUL(self->Ixx, D->m20), RI_6c = fma(self->Ixy, D->m21, RI_6a),
      RI_6 = fma(self->Izx, D->m22, RI_6c);
  const double RI_7a = KSL_MUL(self->Iyy, D->m21), RI_7c = fma(self->Ixy, D->m20, RI_7a),
      RI_7 = fma(self->Iyz, D->m22, RI_7c);
  const double RI_8a = KSL_MUL(self->Izz, D->m22), RI_8c = fma(self->Iyz, D->m21, RI_8a),
      RI_8 = fma(self->Izx, D->m20, RI_8c);
  const double self_1_new_b = KSL_MUL(self->mt.x, D->m00),
      self_1_new_d = fma(self->mt.y, D->m01, self_1_new_b),
      self_1_new_f = fma(self->mt.z, D->m02, self_1_new_d),
      self_1_new = fma(self->m, D->m03, self_1_new_f);
  const double self_2_new_b = KSL_MUL(self->mt.x, D->m10),
      self_2_new_d = fma(self->mt.y, D->m11, self_2_new_b),
      self_2_new_f = fma(self->mt.z, D->m12, self_2_new_d),
      self_2_new = fma(self->m, D->m13, self_2_new_f);
  const double self_3_new_b = KSL_MUL(self->mt.x, D->m20),
      self_3_new_d = fma(self->mt.y, D->m21, self_3_new_b),
      self_3_new_f = fma(self->mt.z, D->m22, self_3_new_d),
      self_3_new = fma(self->m, D->m23, self_3_new_f);
  const double self_4_new_a = KSL_MUL(D->m00, RI_0), self_4_new_c = fma(D->m01, RI_1, self_4_new_a),
      self_4_new = fma(D->m02, RI_2, self_4_new_c);
  const double self_5_new_a = KSL_MUL(D->m10, RI_3), self_5_new_c = fma(D->m11, RI_4, self_5_new_a),
      self_5_new = fma(D->m12, RI_5, self_5_new_c);
  const double self_6_new_a = KSL_MUL(D->m20, RI_6), self_6_new_c = fma(D->m21, RI_7, self_6_new_a),
      self_6_new = fma(D->m22, RI_8, self_6_new_c);
  const double self_7_new_a = KSL_MUL(D->m10, RI_0), self_7_new_c = fma(D->m11, RI_1, self_7_new_a),
      self_7_new = fma(D->m12, RI_2, self_7_new_c);
  const double self_8_new_a = KSL_MUL(D->m20, RI_3), self_8_new_c = fma(D->m21, RI_4, self_8_new_a),
      self_8_new = fma(D->m22, RI_5, self_8_new_c);
  const double self_9_new_a = KSL_MUL(D->m20, RI_0), self_9_new_c = fma(D->m21, RI_1, self_9_new_a),
      self_9_new = fma(D->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertiaf_t ksl_inertiaf_fused(const float m, const ksl_vec3f_t t,
    const float Ixx, const float Iyy, const float Izz, const float Ixy,
    const float Iyz, const float Izx) {
  const float J_1 = KSL_MULF(m, t.x);
  const float J_2 = KSL_MULF(m, t.y);
  const float J_3 = KSL_MULF(m, t.z);
  ksl_inertiaf_t J;
  J.m = m;
  J.mt.x = J_1;
  J.mt.y = J_2;
  J.mt.z = J_3;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotated_fused(const ksl_inertiaf_t *Ji, const ksl_mat3x3f_t *R,
    ksl_inertiaf_t *Jo) {
  const float RI_0a = KSL_MULF(Ji->Ixx, R->m00), RI_0c = fmaf(Ji->Ixy, R->m01, RI_0a),
      RI_0 = fmaf(Ji->Izx, R->m02, RI_0c);
  const float RI_1a = KSL_MULF(Ji->Iyy, R->m01), RI_1c = fmaf(Ji->Ixy, R->m00, RI_1a),
      RI_1 = fmaf(Ji->Iyz, R->m02, RI_1c);
  const float RI_2a = KSL_MULF(Ji->Izz, R->m02), RI_2c = fmaf(Ji->Iyz, R->m01, RI_2a),
      RI_2 = fmaf(Ji->Izx, R->m00, RI_2c);
  const float RI_3a = KSL_MULF(Ji->Ixx, R->m10), RI_3c = fmaf(Ji->Ixy, R->m11, RI_3a),
      RI_3 = fmaf(Ji->Izx, R->m12, RI_3c);
  const float RI_4a = KSL_MULF(Ji->Iyy, R->m11), RI_4c = fmaf(Ji->Ixy, R->m10, RI_4a),
      RI_4 = fmaf(Ji->Iyz, R->m12, RI_4c);
  const float RI_5a = KSL_MULF(Ji->Izz, R->m12), RI_5c = fmaf(Ji->Iyz, R->m11, RI_5a),
      RI_5 = fmaf(Ji->Izx, R->m10, RI_5c);
  const float RI_6a = KSL_MULF(Ji->Ixx, R->m20), RI_6c = fmaf(Ji->Ixy, R->m21, RI_6a),
      RI_6 = fmaf(Ji->Izx, R->m22, RI_6c);
  const float RI_7a = KSL_MULF(Ji->Iyy, R->m21), RI_7c = fmaf(Ji->Ixy, R->m20, RI_7a),
      RI_7 = fmaf(Ji->Iyz, R->m22, RI_7c);
  const float RI_8a = KSL_MULF(Ji->Izz, R->m22), RI_8c = fmaf(Ji->Iyz, R->m21, RI_8a),
      RI_8 = fmaf(Ji->Izx, R->m20, RI_8c);
  const float Jo_1a = KSL_MULF(Ji->mt.x, R->m00), Jo_1c = fmaf(Ji->mt.y, R->m01, Jo_1a),
      Jo_1 = fmaf(Ji->mt.z, R->m02, Jo_1c);
  const float Jo_2a = KSL_MULF(Ji->mt.x, R->m10), Jo_2c = fmaf(Ji->mt.y, R->m11, Jo_2a),
      Jo_2 = fmaf(Ji->mt.z, R->m12, Jo_2c);
  const float Jo_3a = KSL_MULF(Ji->mt.x, R->m20), Jo_3c = fmaf(Ji->mt.y, R->m21, Jo_3a),
      Jo_3 = fmaf(Ji->mt.z, R->m22, Jo_3c);
  const float Jo_4a = KSL_MULF(R->m00, RI_0), Jo_4c = fmaf(R->m01, RI_1, Jo_4a),
      Jo_4 = fmaf(R->m02, RI_2, Jo_4c);
  const float Jo_5a = KSL_MULF(R->m10, RI_3), Jo_5c = fmaf(R->m11, RI_4, Jo_5a),
      Jo_5 = fmaf(R->m12, RI_5, Jo_5c);
  const float Jo_6a = KSL_MULF(R->m20, RI_6), Jo_6c = fmaf(R->m21, RI_7, Jo_6a),
      Jo_6 = fmaf(R->m22, RI_8, Jo_6c);
  const float Jo_7a = KSL_MULF(R->m10, RI_0), Jo_7c = fmaf(R->m11, RI_1, Jo_7a),
      Jo_7 = fmaf(R->m12, RI_2, Jo_7c);
  const float Jo_8a = KSL_MULF(R->m20, RI_3), Jo_8c = fmaf(R->m21, RI_4, Jo_8a),
      Jo_8 = fmaf(R->m22, RI_5, Jo_8c);
  const float Jo_9a = KSL_MULF(R->m20, RI_0), Jo_9c = fmaf(R->m21, RI_1, Jo_9a),
      Jo_9 = fmaf(R->m22, RI_2, Jo_9c);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotate_fused(ksl_inertiaf_t *self, const ksl_mat3x3f_t *R) {
  const float RI_0a = KSL_MULF(self->Ixx, R->m00), RI_0c = fmaf(self->Ixy, R->m01, RI_0a),
      RI_0 = fmaf(self->Izx, R->m02, RI_0c);
  const float RI_1a = KSL_MULF(self->Iyy, R->m01), RI_1c = fmaf(self->Ixy, R->m00, RI_1a),
      RI_1 = fmaf(self->Iyz, R->m02, RI_1c);
  const float RI_2a = KSL_MULF(self->Izz, R->m02), RI_2c = fmaf(self->Iyz, R->m01, RI_2a),
      RI_2 = fmaf(self->Izx, R->m00, RI_2c);
  const float RI_3a = KSL_MULF(self->Ixx, R->m10), RI_3c = fmaf(self->Ixy, R->m11, RI_3a),
      RI_3 = fmaf(self->Izx, R->m12, RI_3c);
  const float RI_4a = KSL_MULF(self->Iyy, R->m11), RI_4c = fmaf(self->Ixy, R->m10, RI_4a),
      RI_4 = fmaf(self->Iyz, R->m12, RI_4c);
  const float RI_5a = KSL_MULF(self->Izz, R->m12), RI_5c = fmaf(self->Iyz, R->m11, RI_5a),
      RI_5 = fmaf(self->Izx, R->m10, RI_5c);
  const float RI_6a = KSL_MULF(self->Ixx, R->m20), RI_6c = fmaf(self->Ixy, R->m21, RI_6a),
      RI_6 = fmaf(self->Izx, R->m22, RI_6c);
  const float RI_7a = KSL_MULF(self->Iyy, R->m21), RI_7c = fmaf(self->Ixy, R->m20, RI_7a),
      RI_7 = fmaf(self->Iyz, R->m22, RI_7c);
  const float RI_8a = KSL_MULF(self->Izz, R->m22), RI_8c = fmaf(self->Iyz, R->m21, RI_8a),
      RI_8 = fmaf(self->Izx, R->m20, RI_8c);
  const float self_1_new_a = KSL_MULF(self->mt.x, R->m00),
      self_1_new_c = fmaf(self->mt.y, R->m01, self_1_new_a),
      self_1_new = fmaf(self->mt.z, R->m02, self_1_new_c);
  const float self_2_new_a = KSL_MULF(self->mt.x, R->m10),
      self_2_new_c = fmaf(self->mt.y, R->m11, self_2_new_a),
      self_2_new = fmaf(self->mt.z, R->m12, self_2_new_c);
  const float self_3_new_a = KSL_MULF(self->mt.x, R->m20),
      self_3_new_c = fmaf(self->mt.y, R->m21, self_3_new_a),
      self_3_new = fmaf(self->mt.z, R->m22, self_3_new_c);
  const float self_4_new_a = KSL_MULF(R->m00, RI_0),
      self_4_new_c = fmaf(R->m01, RI_1, self_4_new_a),
      self_4_new = fmaf(R->m02, RI_2, self_4_new_c);
  const float self_5_new_a = KSL_MULF(R->m10, RI_3),
      self_5_new_c = fmaf(R->m11, RI_4, self_5_new_a),
      self_5_new = fmaf(R->m12, RI_5, self_5_new_c);
  const float self_6_new_a = KSL_MULF(R->m20, RI_6),
      self_6_new_c = fmaf(R->m21, RI_7, self_6_new_a),
      self_6_new = fmaf(R->m22, RI_8, self_6_new_c);
  const float self_7_new_a = KSL_MULF(R->m10, RI_0),
      self_7_new_c = fmaf(R->m11, RI_1, self_7_new_a),
      self_7_new = fmaf(R->m12, RI_2, self_7_new_c);
  const float self_8_new_a = KSL_MULF(R->m20, RI_3),
      self_8_new_c = fmaf(R->m21, RI_4, self_8_new_a),
      self_8_new = fmaf(R->m22, RI_5, self_8_new_c);
  const float self_9_new_a = KSL_MULF(R->m20, RI_0),
      self_9_new_c = fmaf(R->m21, RI_1, self_9_new_a),
      self_9_new = fmaf(R->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_translated_fused(const ksl_inertiaf_t *Ji, const ksl_vec3f_t *t,
    ksl_inertiaf_t *Jo) {
  const float Jo_1 = fmaf(Ji->m, t->x, Ji->mt.x);
  const float Jo_2 = fmaf(Ji->m, t->y, Ji->mt.y);
  const float Jo_3 = fmaf(Ji->m, t->z, Ji->mt.z);
  const float Ji_m = Ji->m;
  const float Ji_Ixx = Ji->Ixx;
  const float Ji_Iyy = Ji->Iyy;
  const float Ji_Izz = Ji->Izz;
  const float Ji_Ixy = Ji->Ixy;
  const float Ji_Iyz = Ji->Iyz;
  const float Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_translate_fused(ksl_inertiaf_t *self, const ksl_vec3f_t *t) {
  const float self_1_new = fmaf(self->m, t->x, self->mt.x);
  const float self_2_new = fmaf(self->m, t->y, self->mt.y);
  const float self_3_new = fmaf(self->m, t->z, self->mt.z);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transformed_fused(const ksl_inertiaf_t *Ji, const ksl_SE3f_t *D,
    ksl_inertiaf_t *Jo) {
  const float RI_0a = KSL_MULF(Ji->Ixx, D->m00), RI_0c = fmaf(Ji->Ixy, D->m01, RI_0a),
      RI_0 = fmaf(Ji->Izx, D->m02, RI_0c);
  const float RI_1a = KSL_MULF(Ji->Iyy, D->m01), RI_1c = fmaf(Ji->Ixy, D->m00, RI_1a),
      RI_1 = fmaf(Ji->Iyz, D->m02, RI_1c);
  const float RI_2a = KSL_MULF(Ji->Izz, D->m02), RI_2c = fmaf(Ji->Iyz, D->m01, RI_2a),
      RI_2 = fmaf(Ji->Izx, D->m00, RI_2c);
  const float RI_3a = KSL_MULF(Ji->Ixx, D->m10), RI_3c = fmaf(Ji->Ixy, D->m11, RI_3a),
      RI_3 = fmaf(Ji->Izx, D->m12, RI_3c);
  const float RI_4a = KSL_MULF(Ji->Iyy, D->m11), RI_4c = fmaf(Ji->Ixy, D->m10, RI_4a),
      RI_4 = fmaf(Ji->Iyz, D->m12, RI_4c);
  const float RI_5a = KSL_MULF(Ji->Izz, D->m12), RI_5c = fmaf(Ji->Iyz, D->m11, RI_5a),
      RI_5 = fmaf(Ji->Izx, D->m10, RI_5c);
  const float RI_6a = KSL_MULF(Ji->Ixx, D->m20), RI_6c = fmaf(Ji->Ixy, D->m21, RI_6a),
      RI_6 = fmaf(Ji->Izx, D->m22, RI_6c);
  const float RI_7a = KSL_MULF(Ji->Iyy, D->m21), RI_7c = fmaf(Ji->Ixy, D->m20, RI_7a),
      RI_7 = fmaf(Ji->Iyz, D->m22, RI_7c);
  const float RI_8a = KSL_MULF(Ji->Izz, D->m22), RI_8c = fmaf(Ji->Iyz, D->m21, RI_8a),
      RI_8 = fmaf(Ji->Izx, D->m20, RI_8c);
  const float Jo_1b = KSL_MULF(Ji->mt.x, D->m00), Jo_1d = fmaf(Ji->mt.y, D->m01, Jo_1b),
      Jo_1f = fmaf(Ji->mt.z, D->m02, Jo_1d), Jo_1 = fmaf(Ji->m, D->m03, Jo_1f);
  const float Jo_2b = KSL_MULF(Ji->mt.x, D->m10), Jo_2d = fmaf(Ji->mt.y, D->m11, Jo_2b),
      Jo_2f = fmaf(Ji->mt.z, D->m12, Jo_2d), Jo_2 = fmaf(Ji->m, D->m13, Jo_2f);
  const float Jo_3b = KSL_MULF(Ji->mt.x, D->m20), Jo_3d = fmaf(Ji->mt.y, D->m21, Jo_3b),
      Jo_3f = fmaf(Ji->mt.z, D->m22, Jo_3d), Jo_3 = fmaf(Ji->m, D->m23, Jo_3f);
  const float Jo_4a = KSL_MULF(D->m00, RI_0), Jo_4c = fmaf(D->m01, RI_1, Jo_4a),
      Jo_4 = fmaf(D->m02, RI_2, Jo_4c);
  const float Jo_5a = KSL_MULF(D->m10, RI_3), Jo_5c = fmaf(D->m11, RI_4, Jo_5a),
      Jo_5 = fmaf(D->m12, RI_5, Jo_5c);
  const float Jo_6a = KSL_MULF(D->m20, RI_6), Jo_6c = fmaf(D->m21, RI_7, Jo_6a),
      Jo_6 = fmaf(D->m22, RI_8, Jo_6c);
  const float Jo_7a = KSL_MULF(D->m10, RI_0), Jo_7c = fmaf(D->m11, RI_1, Jo_7a),
      Jo_7 = fmaf(D->m12, RI_2, Jo_7c);
  const float Jo_8a = KSL_MULF(D->m20, RI_3), Jo_8c = fmaf(D->m21, RI_4, Jo_8a),
      Jo_8 = fmaf(D->m22, RI_5, Jo_8c);
  const float Jo_9a = KSL_MULF(D->m20, RI_0), Jo_9c = fmaf(D->m21, RI_1, Jo_9a),
      Jo_9 = fmaf(D->m22, RI_2, Jo_9c);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transform_fused(ksl_inertiaf_t *self, const ksl_SE3f_t *D) {
  const float RI_0a = KSL_MULF(self->Ixx, D->m00), RI_0c = fmaf(self->Ixy, D->m01, RI_0a),
      RI_0 = fmaf(self->Izx, D->m02, RI_0c);
  const float RI_1a = KSL_MULF(self->Iyy, D->m01), RI_1c = fmaf(self->Ixy, D->m00, RI_1a),
      RI_1 = fmaf(self->Iyz, D->m02, RI_1c);
  const float RI_2a = KSL_MULF(self->Izz, D->m02), RI_2c = fmaf(self->Iyz, D->m01, RI_2a),
      RI_2 = fmaf(self->Izx, D->m00, RI_2c);
  const float RI_3a = KSL_MULF(self->Ixx, D->m10), RI_3c = fmaf(self->Ixy, D->m11, RI_3a),
      RI_3 = fmaf(self->Izx, D->m12, RI_3c);
  const float RI_4a = KSL_MULF(self->Iyy, D->m11), RI_4c = fmaf(self->Ixy, D->m10, RI_4a),
      RI_4 = fmaf(self->Iyz, D->m12, RI_4c);
  const float RI_5a = KSL_MULF(self->Izz, D->m12), RI_5c = fmaf(self->Iyz, D->m11, RI_5a),
      RI_5 = fmaf(self->Izx, D->m10, RI_5c);
  const float RI_6a = KSL_MULF(self->Ixx, D->m20), RI_6c = fmaf(self->Ixy, D->m21, RI_6a),
      RI_6 = fmaf(self->Izx, D->m22, RI_6c);
  const float RI_7a = KSL_MULF(self->Iyy, D->m21), RI_7c = fmaf(self->Ixy, D->m20, RI_7a),
      RI_7 = fmaf(self->Iyz, D->m22, RI_7c);
  const float RI_8a = KSL_MULF(self->Izz, D->m22), RI_8c = fmaf(self->Iyz, D->m21, RI_8a),
      RI_8 = fmaf(self->Izx, D->m20, RI_8c);
  const float self_1_new_b = KSL_MULF(self->mt.x, D->m00),
      self_1_new_d = fmaf(self->mt.y, D->m01, self_1_new_b),
      self_1_new_f = fmaf(self->mt.z, D->m02, self_1_new_d),
      self_1_new = fmaf(self->m, D->m03, self_1_new_f);
  const float self_2_new_b = KSL_MULF(self->mt.x, D->m10),
      self_2_new_d = fmaf(self->mt.y, D->m11, self_2_new_b),
      self_2_new_f = fmaf(self->mt.z, D->m12, self_2_new_d),
      self_2_new = fmaf(self->m, D->m13, self_2_new_f);
  const float self_3_new_b = KSL_MULF(self->mt.x, D->m20),
      self_3_new_d = fmaf(self->mt.y, D->m21, self_3_new_b),
      self_3_new_f = fmaf(self->mt.z, D->m22, self_3_new_d),
      self_3_new = fmaf(self->m, D->m23, self_3_new_f);
  const float self_4_new_a = KSL_MULF(D->m00, RI_0),
      self_4_new_c = fmaf(D->m01, RI_1, self_4_new_a),
      self_4_new = fmaf(D->m02, RI_2, self_4_new_c);
  const float self_5_new_a = KSL_MULF(D->m10, RI_3),
      self_5_new_c = fmaf(D->m11, RI_4, self_5_new_a),
      self_5_new = fmaf(D->m12, RI_5, self_5_new_c);
  const float self_6_new_a = KSL_MULF(D->m20, RI_6),
      self_6_new_c = fmaf(D->m21, RI_7, self_6_new_a),
      self_6_new = fmaf(D->m22, RI_8, self_6_new_c);
  const float self_7_new_a = KSL_MULF(D->m10, RI_0),
      self_7_new_c = fmaf(D->m11, RI_1, self_7_new_a),
      self_7_new = fmaf(D->m12, RI_2, self_7_new_c);
  const float self_8_new_a = KSL_MULF(D->m20, RI_3),
      self_8_new_c = fmaf(D->m21, RI_4, self_8_new_a),
      self_8_new = fmaf(D->m22, RI_5, self_8_new_c);
  const float self_9_new_a = KSL_MULF(D->m20, RI_0),
      self_9_new_c = fmaf(D->m21, RI_1, self_9_new_a),
      self_9_new = fmaf(D->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

#endif

/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.
   Fused tier: products fused into sums. */
#ifndef KSL_SPATIAL_INERTIA_FUSED_H
#define KSL_SPATIAL_INERTIA_FUSED_H


/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_scale_fused(ksl_spatial_inertia_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m, a);
  const double self_1_new = KSL_MUL(self->h.x, a);
  const double self_2_new = KSL_MUL(self->h.y, a);
  const double self_3_new = KSL_MUL(self->h.z, a);
  const double self_4_new = KSL_MUL(self->xx, a);
  const double self_5_new = KSL_MUL(self->yy, a);
  const double self_6_new = KSL_MUL(self->zz, a);
  const double self_7_new = KSL_MUL(self->xy, a);
  const double self_8_new = KSL_MUL(self->xz, a);
  const double self_9_new = KSL_MUL(self->yz, a);
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
static inline void ksl_add_BB_fused(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
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
static inline void ksl_subtract_BB_fused(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
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

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   6 mul, 6 add, 3 fma.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_from_com_fused(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_spatial_inertia_t *Bo) {
  const double h_0 = KSL_MUL(m, com->x);
  const double h_1 = KSL_MUL(m, com->y);
  const double h_2 = KSL_MUL(m, com->z);
  const double squares_0 = KSL_MUL(com->x, h_0);
  const double squares_1 = KSL_MUL(com->y, h_1);
  const double squares_2 = KSL_MUL(com->z, h_2);
  const double Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const double Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const double Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const double Bo_7 = fma(-com->y, h_0, Ic->m01);
  const double Bo_8 = fma(-com->z, h_0, Ic->m02);
  const double Bo_9 = fma(-com->z, h_1, Ic->m12);
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

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bs_fused(const ksl_spatial_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co) {
  const double co_0b = KSL_MUL(B->h.z, s->m4), co_0d = fma(-B->h.y, s->m5, co_0b),
      co_0 = fma(B->m, s->m0, co_0d);
  const double co_1b = KSL_MUL(B->h.x, s->m5), co_1d = fma(-B->h.z, s->m3, co_1b),
      co_1 = fma(B->m, s->m1, co_1d);
  const double co_2b = KSL_MUL(B->h.y, s->m3), co_2d = fma(-B->h.x, s->m4, co_2b),
      co_2 = fma(B->m, s->m2, co_2d);
  const double co_3a = KSL_MUL(B->h.y, s->m2), co_3c = fma(-B->h.z, s->m1, co_3a),
      co_3d = KSL_MUL(B->xx, s->m3), co_3f = fma(B->xy, s->m4, co_3d),
      co_3h = fma(B->xz, s->m5, co_3f), co_3 = co_3c + co_3h;
  const double co_4a = KSL_MUL(B->h.z, s->m0), co_4c = fma(-B->h.x, s->m2, co_4a),
      co_4d = KSL_MUL(B->yy, s->m4), co_4f = fma(B->xy, s->m3, co_4d),
      co_4h = fma(B->yz, s->m5, co_4f), co_4 = co_4c + co_4h;
  const double co_5a = KSL_MUL(B->h.x, s->m1), co_5c = fma(-B->h.y, s->m0, co_5a),
      co_5d = KSL_MUL(B->zz, s->m5), co_5f = fma(B->xz, s->m3, co_5d),
      co_5h = fma(B->yz, s->m4, co_5f), co_5 = co_5c + co_5h;
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
   9 mul, 17 fma.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_spatial_inertia_energy_fused(const ksl_spatial_inertia_t *B,
    const ksl_screw_t *s) {
  const double square_a = KSL_MUL(s->m0, s->m0), square_c = fma(s->m1, s->m1, square_a),
      square = fma(s->m2, s->m2, square_c);
  const double L_0a = KSL_MUL(B->xx, s->m3), L_0c = fma(B->xy, s->m4, L_0a),
      L_0 = fma(B->xz, s->m5, L_0c);
  const double L_1a = KSL_MUL(B->yy, s->m4), L_1c = fma(B->xy, s->m3, L_1a),
      L_1 = fma(B->yz, s->m5, L_1c);
  const double L_2a = KSL_MUL(B->zz, s->m5), L_2c = fma(B->xz, s->m3, L_2a),
      L_2 = fma(B->yz, s->m4, L_2c);
  const double twice_b = KSL_MUL(s->m3, L_0), twice_d = fma(s->m4, L_1, twice_b),
      twice_f = fma(s->m5, L_2, twice_d), twice = fma(B->m, square, twice_f);
  const double across_0a = KSL_MUL(B->h.z, s->m4), across_0 = fma(-B->h.y, s->m5, across_0a);
  const double across_1a = KSL_MUL(B->h.x, s->m5), across_1 = fma(-B->h.z, s->m3, across_1a);
  const double across_2a = KSL_MUL(B->h.y, s->m3), across_2 = fma(-B->h.x, s->m4, across_2a);
  const double energy_a = KSL_MUL(s->m0, across_0), energy_c = fma(s->m1, across_1, energy_a),
      energy_e = fma(s->m2, across_2, energy_c), energy = fma(0.5, twice, energy_e);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   18 mul, 21 add, 21 fma, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertia_net_wrench_fused(const ksl_spatial_inertia_t *B,
    const ksl_vec3_t *w, const ksl_screw_t *ds, ksl_coscrew_t *co) {
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double U_0a_lead = -ww_1, U_0 = U_0a_lead - ww_2;
  const double U_1 = ww_3 - ds->m5;
  const double U_2 = ds->m4 + ww_4;
  const double U_3 = ds->m5 + ww_3;
  const double U_4a_lead = -ww_0, U_4 = U_4a_lead - ww_2;
  const double U_5 = ww_5 - ds->m3;
  const double U_6 = ww_4 - ds->m4;
  const double U_7 = ds->m3 + ww_5;
  const double U_8a_lead = -ww_0, U_8 = U_8a_lead - ww_1;
  const double others_0 = B->zz - B->yy;
  const double others_1 = B->xx - B->zz;
  const double others_2 = B->yy - B->xx;
  const double squares_0 = ww_1 - ww_2;
  const double squares_1 = ww_2 - ww_0;
  const double squares_2 = ww_0 - ww_1;
  const double own_0a = KSL_MUL(B->xx, ds->m3), own_0 = fma(ww_5, others_0, own_0a);
  const double own_1a = KSL_MUL(B->yy, ds->m4), own_1 = fma(ww_4, others_1, own_1a);
  const double own_2a = KSL_MUL(B->zz, ds->m5), own_2 = fma(ww_3, others_2, own_2a);
  const double N_0a = KSL_MUL(B->xz, U_3), N_0c = fma(-B->xy, U_6, N_0a),
      N_0e = fma(B->yz, squares_0, N_0c), N_0 = N_0e + own_0;
  const double N_1a = KSL_MUL(B->xy, U_7), N_1c = fma(-B->yz, U_1, N_1a),
      N_1e = fma(B->xz, squares_1, N_1c), N_1 = N_1e + own_1;
  const double N_2b = KSL_MUL(B->yz, U_2), N_2d = fma(-B->xz, U_5, N_2b),
      N_2e = fma(B->xy, squares_2, N_2d), N_2 = N_2e + own_2;
  const double co_0b = KSL_MUL(B->h.x, U_0), co_0d = fma(B->h.y, U_1, co_0b),
      co_0f = fma(B->h.z, U_2, co_0d), co_0 = fma(B->m, ds->m0, co_0f);
  const double co_1b = KSL_MUL(B->h.x, U_3), co_1d = fma(B->h.y, U_4, co_1b),
      co_1f = fma(B->h.z, U_5, co_1d), co_1 = fma(B->m, ds->m1, co_1f);
  const double co_2b = KSL_MUL(B->h.x, U_6), co_2d = fma(B->h.y, U_7, co_2b),
      co_2f = fma(B->h.z, U_8, co_2d), co_2 = fma(B->m, ds->m2, co_2f);
  const double co_3a = KSL_MUL(B->h.y, ds->m2), co_3c = fma(-B->h.z, ds->m1, co_3a),
      co_3 = co_3c + N_0;
  const double co_4a = KSL_MUL(B->h.z, ds->m0), co_4c = fma(-B->h.x, ds->m2, co_4a),
      co_4 = co_4c + N_1;
  const double co_5a = KSL_MUL(B->h.x, ds->m1), co_5c = fma(-B->h.y, ds->m0, co_5a),
      co_5 = co_5c + N_2;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   12 mul, 12 add, 6 fma.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_shifted_fused(const ksl_vec3_t *t,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double mt_0 = KSL_MUL(t->x, B->m);
  const double mt_1 = KSL_MUL(t->y, B->m);
  const double mt_2 = KSL_MUL(t->z, B->m);
  const double n_0 = fma(0.5, mt_0, B->h.x);
  const double n_1 = fma(0.5, mt_1, B->h.y);
  const double n_2 = fma(0.5, mt_2, B->h.z);
  const double tn0 = KSL_MUL(t->x, n_0);
  const double tn1 = KSL_MUL(t->y, n_1);
  const double tn2 = KSL_MUL(t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(t->x, n_1), pairs_3 = fma(t->y, n_0, pairs_3a);
  const double pairs_4a = KSL_MUL(t->x, n_2), pairs_4 = fma(t->z, n_0, pairs_4a);
  const double pairs_5a = KSL_MUL(t->y, n_2), pairs_5 = fma(t->z, n_1, pairs_5a);
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

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   30 mul, 12 add, 42 fma.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_transformed_fused(const ksl_SE3_t *D,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double RI_0a = KSL_MUL(D->m00, B->xx), RI_0c = fma(D->m01, B->xy, RI_0a),
      RI_0 = fma(D->m02, B->xz, RI_0c);
  const double RI_1a = KSL_MUL(D->m00, B->xy), RI_1c = fma(D->m01, B->yy, RI_1a),
      RI_1 = fma(D->m02, B->yz, RI_1c);
  const double RI_2a = KSL_MUL(D->m00, B->xz), RI_2c = fma(D->m01, B->yz, RI_2a),
      RI_2 = fma(D->m02, B->zz, RI_2c);
  const double RI_3a = KSL_MUL(D->m10, B->xx), RI_3c = fma(D->m11, B->xy, RI_3a),
      RI_3 = fma(D->m12, B->xz, RI_3c);
  const double RI_4a = KSL_MUL(D->m10, B->xy), RI_4c = fma(D->m11, B->yy, RI_4a),
      RI_4 = fma(D->m12, B->yz, RI_4c);
  const double RI_5a = KSL_MUL(D->m10, B->xz), RI_5c = fma(D->m11, B->yz, RI_5a),
      RI_5 = fma(D->m12, B->zz, RI_5c);
  const double RI_6a = KSL_MUL(D->m20, B->xx), RI_6c = fma(D->m21, B->xy, RI_6a),
      RI_6 = fma(D->m22, B->xz, RI_6c);
  const double RI_7a = KSL_MUL(D->m20, B->xy), RI_7c = fma(D->m21, B->yy, RI_7a),
      RI_7 = fma(D->m22, B->yz, RI_7c);
  const double RI_8a = KSL_MUL(D->m20, B->xz), RI_8c = fma(D->m21, B->yz, RI_8a),
      RI_8 = fma(D->m22, B->zz, RI_8c);
  const double turned_1a = KSL_MUL(D->m00, B->h.x), turned_1c = fma(D->m01, B->h.y, turned_1a),
      turned_1 = fma(D->m02, B->h.z, turned_1c);
  const double turned_2a = KSL_MUL(D->m10, B->h.x), turned_2c = fma(D->m11, B->h.y, turned_2a),
      turned_2 = fma(D->m12, B->h.z, turned_2c);
  const double turned_3a = KSL_MUL(D->m20, B->h.x), turned_3c = fma(D->m21, B->h.y, turned_3a),
      turned_3 = fma(D->m22, B->h.z, turned_3c);
  const double turned_4a = KSL_MUL(D->m00, RI_0), turned_4c = fma(D->m01, RI_1, turned_4a),
      turned_4 = fma(D->m02, RI_2, turned_4c);
  const double turned_5a = KSL_MUL(D->m10, RI_3), turned_5c = fma(D->m11, RI_4, turned_5a),
      turned_5 = fma(D->m12, RI_5, turned_5c);
  const double turned_6a = KSL_MUL(D->m20, RI_6), turned_6c = fma(D->m21, RI_7, turned_6a),
      turned_6 = fma(D->m22, RI_8, turned_6c);
  const double turned_7a = KSL_MUL(D->m10, RI_0), turned_7c = fma(D->m11, RI_1, turned_7a),
      turned_7 = fma(D->m12, RI_2, turned_7c);
  const double turned_8a = KSL_MUL(D->m20, RI_0), turned_8c = fma(D->m21, RI_1, turned_8a),
      turned_8 = fma(D->m22, RI_2, turned_8c);
  const double turned_9a = KSL_MUL(D->m20, RI_3), turned_9c = fma(D->m21, RI_4, turned_9a),
      turned_9 = fma(D->m22, RI_5, turned_9c);
  const double mt_0 = KSL_MUL(D->m03, B->m);
  const double mt_1 = KSL_MUL(D->m13, B->m);
  const double mt_2 = KSL_MUL(D->m23, B->m);
  const double n_0 = fma(0.5, mt_0, turned_1);
  const double n_1 = fma(0.5, mt_1, turned_2);
  const double n_2 = fma(0.5, mt_2, turned_3);
  const double tn0 = KSL_MUL(D->m03, n_0);
  const double tn1 = KSL_MUL(D->m13, n_1);
  const double tn2 = KSL_MUL(D->m23, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(D->m03, n_1), pairs_3 = fma(D->m13, n_0, pairs_3a);
  const double pairs_4a = KSL_MUL(D->m03, n_2), pairs_4 = fma(D->m23, n_0, pairs_4a);
  const double pairs_5a = KSL_MUL(D->m13, n_2), pairs_5 = fma(D->m23, n_1, pairs_5a);
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

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_scale_fused(ksl_spatial_inertiaf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->m, a);
  const float self_1_new = KSL_MULF(self->h.x, a);
  const float self_2_new = KSL_MULF(self->h.y, a);
  const float self_3_new = KSL_MULF(self->h.z, a);
  const float self_4_new = KSL_MULF(self->xx, a);
  const float self_5_new = KSL_MULF(self->yy, a);
  const float self_6_new = KSL_MULF(self->zz, a);
  const float self_7_new = KSL_MULF(self->xy, a);
  const float self_8_new = KSL_MULF(self->xz, a);
  const float self_9_new = KSL_MULF(self->yz, a);
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
static inline void ksl_add_BBf_fused(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
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
static inline void ksl_subtract_BBf_fused(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
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

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   6 mul, 6 add, 3 fma.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_com_fused(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_spatial_inertiaf_t *Bo) {
  const float h_0 = KSL_MULF(m, com->x);
  const float h_1 = KSL_MULF(m, com->y);
  const float h_2 = KSL_MULF(m, com->z);
  const float squares_0 = KSL_MULF(com->x, h_0);
  const float squares_1 = KSL_MULF(com->y, h_1);
  const float squares_2 = KSL_MULF(com->z, h_2);
  const float Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const float Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const float Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const float Bo_7 = fmaf(-com->y, h_0, Ic->m01);
  const float Bo_8 = fmaf(-com->z, h_0, Ic->m02);
  const float Bo_9 = fmaf(-com->z, h_1, Ic->m12);
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

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bsf_fused(const ksl_spatial_inertiaf_t *B, const ksl_screwf_t *s,
    ksl_coscrewf_t *co) {
  const float co_0b = KSL_MULF(B->h.z, s->m4), co_0d = fmaf(-B->h.y, s->m5, co_0b),
      co_0 = fmaf(B->m, s->m0, co_0d);
  const float co_1b = KSL_MULF(B->h.x, s->m5), co_1d = fmaf(-B->h.z, s->m3, co_1b),
      co_1 = fmaf(B->m, s->m1, co_1d);
  const float co_2b = KSL_MULF(B->h.y, s->m3), co_2d = fmaf(-B->h.x, s->m4, co_2b),
      co_2 = fmaf(B->m, s->m2, co_2d);
  const float co_3a = KSL_MULF(B->h.y, s->m2), co_3c = fmaf(-B->h.z, s->m1, co_3a),
      co_3d = KSL_MULF(B->xx, s->m3), co_3f = fmaf(B->xy, s->m4, co_3d),
      co_3h = fmaf(B->xz, s->m5, co_3f), co_3 = co_3c + co_3h;
  const float co_4a = KSL_MULF(B->h.z, s->m0), co_4c = fmaf(-B->h.x, s->m2, co_4a),
      co_4d = KSL_MULF(B->yy, s->m4), co_4f = fmaf(B->xy, s->m3, co_4d),
      co_4h = fmaf(B->yz, s->m5, co_4f), co_4 = co_4c + co_4h;
  const float co_5a = KSL_MULF(B->h.x, s->m1), co_5c = fmaf(-B->h.y, s->m0, co_5a),
      co_5d = KSL_MULF(B->zz, s->m5), co_5f = fmaf(B->xz, s->m3, co_5d),
      co_5h = fmaf(B->yz, s->m4, co_5f), co_5 = co_5c + co_5h;
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
   9 mul, 17 fma.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_spatial_inertiaf_energy_fused(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s) {
  const float square_a = KSL_MULF(s->m0, s->m0), square_c = fmaf(s->m1, s->m1, square_a),
      square = fmaf(s->m2, s->m2, square_c);
  const float L_0a = KSL_MULF(B->xx, s->m3), L_0c = fmaf(B->xy, s->m4, L_0a),
      L_0 = fmaf(B->xz, s->m5, L_0c);
  const float L_1a = KSL_MULF(B->yy, s->m4), L_1c = fmaf(B->xy, s->m3, L_1a),
      L_1 = fmaf(B->yz, s->m5, L_1c);
  const float L_2a = KSL_MULF(B->zz, s->m5), L_2c = fmaf(B->xz, s->m3, L_2a),
      L_2 = fmaf(B->yz, s->m4, L_2c);
  const float twice_b = KSL_MULF(s->m3, L_0), twice_d = fmaf(s->m4, L_1, twice_b),
      twice_f = fmaf(s->m5, L_2, twice_d), twice = fmaf(B->m, square, twice_f);
  const float across_0a = KSL_MULF(B->h.z, s->m4), across_0 = fmaf(-B->h.y, s->m5, across_0a);
  const float across_1a = KSL_MULF(B->h.x, s->m5), across_1 = fmaf(-B->h.z, s->m3, across_1a);
  const float across_2a = KSL_MULF(B->h.y, s->m3), across_2 = fmaf(-B->h.x, s->m4, across_2a);
  const float energy_a = KSL_MULF(s->m0, across_0), energy_c = fmaf(s->m1, across_1, energy_a),
      energy_e = fmaf(s->m2, across_2, energy_c), energy = fmaf(0.5f, twice, energy_e);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   18 mul, 21 add, 21 fma, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertiaf_net_wrench_fused(const ksl_spatial_inertiaf_t *B,
    const ksl_vec3f_t *w, const ksl_screwf_t *ds, ksl_coscrewf_t *co) {
  const float ww_0 = KSL_MULF(w->x, w->x);
  const float ww_1 = KSL_MULF(w->y, w->y);
  const float ww_2 = KSL_MULF(w->z, w->z);
  const float ww_3 = KSL_MULF(w->x, w->y);
  const float ww_4 = KSL_MULF(w->x, w->z);
  const float ww_5 = KSL_MULF(w->y, w->z);
  const float U_0a_lead = -ww_1, U_0 = U_0a_lead - ww_2;
  const float U_1 = ww_3 - ds->m5;
  const float U_2 = ds->m4 + ww_4;
  const float U_3 = ds->m5 + ww_3;
  const float U_4a_lead = -ww_0, U_4 = U_4a_lead - ww_2;
  const float U_5 = ww_5 - ds->m3;
  const float U_6 = ww_4 - ds->m4;
  const float U_7 = ds->m3 + ww_5;
  const float U_8a_lead = -ww_0, U_8 = U_8a_lead - ww_1;
  const float others_0 = B->zz - B->yy;
  const float others_1 = B->xx - B->zz;
  const float others_2 = B->yy - B->xx;
  const float squares_0 = ww_1 - ww_2;
  const float squares_1 = ww_2 - ww_0;
  const float squares_2 = ww_0 - ww_1;
  const float own_0a = KSL_MULF(B->xx, ds->m3), own_0 = fmaf(ww_5, others_0, own_0a);
  const float own_1a = KSL_MULF(B->yy, ds->m4), own_1 = fmaf(ww_4, others_1, own_1a);
  const float own_2a = KSL_MULF(B->zz, ds->m5), own_2 = fmaf(ww_3, others_2, own_2a);
  const float N_0a = KSL_MULF(B->xz, U_3), N_0c = fmaf(-B->xy, U_6, N_0a),
      N_0e = fmaf(B->yz, squares_0, N_0c), N_0 = N_0e + own_0;
  const float N_1a = KSL_MULF(B->xy, U_7), N_1c = fmaf(-B->yz, U_1, N_1a),
      N_1e = fmaf(B->xz, squares_1, N_1c), N_1 = N_1e + own_1;
  const float N_2b = KSL_MULF(B->yz, U_2), N_2d = fmaf(-B->xz, U_5, N_2b),
      N_2e = fmaf(B->xy, squares_2, N_2d), N_2 = N_2e + own_2;
  const float co_0b = KSL_MULF(B->h.x, U_0), co_0d = fmaf(B->h.y, U_1, co_0b),
      co_0f = fmaf(B->h.z, U_2, co_0d), co_0 = fmaf(B->m, ds->m0, co_0f);
  const float co_1b = KSL_MULF(B->h.x, U_3), co_1d = fmaf(B->h.y, U_4, co_1b),
      co_1f = fmaf(B->h.z, U_5, co_1d), co_1 = fmaf(B->m, ds->m1, co_1f);
  const float co_2b = KSL_MULF(B->h.x, U_6), co_2d = fmaf(B->h.y, U_7, co_2b),
      co_2f = fmaf(B->h.z, U_8, co_2d), co_2 = fmaf(B->m, ds->m2, co_2f);
  const float co_3a = KSL_MULF(B->h.y, ds->m2), co_3c = fmaf(-B->h.z, ds->m1, co_3a),
      co_3 = co_3c + N_0;
  const float co_4a = KSL_MULF(B->h.z, ds->m0), co_4c = fmaf(-B->h.x, ds->m2, co_4a),
      co_4 = co_4c + N_1;
  const float co_5a = KSL_MULF(B->h.x, ds->m1), co_5c = fmaf(-B->h.y, ds->m0, co_5a),
      co_5 = co_5c + N_2;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   12 mul, 12 add, 6 fma.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_shifted_fused(const ksl_vec3f_t *t,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float mt_0 = KSL_MULF(t->x, B->m);
  const float mt_1 = KSL_MULF(t->y, B->m);
  const float mt_2 = KSL_MULF(t->z, B->m);
  const float n_0 = fmaf(0.5f, mt_0, B->h.x);
  const float n_1 = fmaf(0.5f, mt_1, B->h.y);
  const float n_2 = fmaf(0.5f, mt_2, B->h.z);
  const float tn0 = KSL_MULF(t->x, n_0);
  const float tn1 = KSL_MULF(t->y, n_1);
  const float tn2 = KSL_MULF(t->z, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(t->x, n_1), pairs_3 = fmaf(t->y, n_0, pairs_3a);
  const float pairs_4a = KSL_MULF(t->x, n_2), pairs_4 = fmaf(t->z, n_0, pairs_4a);
  const float pairs_5a = KSL_MULF(t->y, n_2), pairs_5 = fmaf(t->z, n_1, pairs_5a);
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

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   30 mul, 12 add, 42 fma.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_transformed_fused(const ksl_SE3f_t *D,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float RI_0a = KSL_MULF(D->m00, B->xx), RI_0c = fmaf(D->m01, B->xy, RI_0a),
      RI_0 = fmaf(D->m02, B->xz, RI_0c);
  const float RI_1a = KSL_MULF(D->m00, B->xy), RI_1c = fmaf(D->m01, B->yy, RI_1a),
      RI_1 = fmaf(D->m02, B->yz, RI_1c);
  const float RI_2a = KSL_MULF(D->m00, B->xz), RI_2c = fmaf(D->m01, B->yz, RI_2a),
      RI_2 = fmaf(D->m02, B->zz, RI_2c);
  const float RI_3a = KSL_MULF(D->m10, B->xx), RI_3c = fmaf(D->m11, B->xy, RI_3a),
      RI_3 = fmaf(D->m12, B->xz, RI_3c);
  const float RI_4a = KSL_MULF(D->m10, B->xy), RI_4c = fmaf(D->m11, B->yy, RI_4a),
      RI_4 = fmaf(D->m12, B->yz, RI_4c);
  const float RI_5a = KSL_MULF(D->m10, B->xz), RI_5c = fmaf(D->m11, B->yz, RI_5a),
      RI_5 = fmaf(D->m12, B->zz, RI_5c);
  const float RI_6a = KSL_MULF(D->m20, B->xx), RI_6c = fmaf(D->m21, B->xy, RI_6a),
      RI_6 = fmaf(D->m22, B->xz, RI_6c);
  const float RI_7a = KSL_MULF(D->m20, B->xy), RI_7c = fmaf(D->m21, B->yy, RI_7a),
      RI_7 = fmaf(D->m22, B->yz, RI_7c);
  const float RI_8a = KSL_MULF(D->m20, B->xz), RI_8c = fmaf(D->m21, B->yz, RI_8a),
      RI_8 = fmaf(D->m22, B->zz, RI_8c);
  const float turned_1a = KSL_MULF(D->m00, B->h.x), turned_1c = fmaf(D->m01, B->h.y, turned_1a),
      turned_1 = fmaf(D->m02, B->h.z, turned_1c);
  const float turned_2a = KSL_MULF(D->m10, B->h.x), turned_2c = fmaf(D->m11, B->h.y, turned_2a),
      turned_2 = fmaf(D->m12, B->h.z, turned_2c);
  const float turned_3a = KSL_MULF(D->m20, B->h.x), turned_3c = fmaf(D->m21, B->h.y, turned_3a),
      turned_3 = fmaf(D->m22, B->h.z, turned_3c);
  const float turned_4a = KSL_MULF(D->m00, RI_0), turned_4c = fmaf(D->m01, RI_1, turned_4a),
      turned_4 = fmaf(D->m02, RI_2, turned_4c);
  const float turned_5a = KSL_MULF(D->m10, RI_3), turned_5c = fmaf(D->m11, RI_4, turned_5a),
      turned_5 = fmaf(D->m12, RI_5, turned_5c);
  const float turned_6a = KSL_MULF(D->m20, RI_6), turned_6c = fmaf(D->m21, RI_7, turned_6a),
      turned_6 = fmaf(D->m22, RI_8, turned_6c);
  const float turned_7a = KSL_MULF(D->m10, RI_0), turned_7c = fmaf(D->m11, RI_1, turned_7a),
      turned_7 = fmaf(D->m12, RI_2, turned_7c);
  const float turned_8a = KSL_MULF(D->m20, RI_0), turned_8c = fmaf(D->m21, RI_1, turned_8a),
      turned_8 = fmaf(D->m22, RI_2, turned_8c);
  const float turned_9a = KSL_MULF(D->m20, RI_3), turned_9c = fmaf(D->m21, RI_4, turned_9a),
      turned_9 = fmaf(D->m22, RI_5, turned_9c);
  const float mt_0 = KSL_MULF(D->m03, B->m);
  const float mt_1 = KSL_MULF(D->m13, B->m);
  const float mt_2 = KSL_MULF(D->m23, B->m);
  const float n_0 = fmaf(0.5f, mt_0, turned_1);
  const float n_1 = fmaf(0.5f, mt_1, turned_2);
  const float n_2 = fmaf(0.5f, mt_2, turned_3);
  const float tn0 = KSL_MULF(D->m03, n_0);
  const float tn1 = KSL_MULF(D->m13, n_1);
  const float tn2 = KSL_MULF(D->m23, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(D->m03, n_1), pairs_3 = fmaf(D->m13, n_0, pairs_3a);
  const float pairs_4a = KSL_MULF(D->m03, n_2), pairs_4 = fmaf(D->m23, n_0, pairs_4a);
  const float pairs_5a = KSL_MULF(D->m13, n_2), pairs_5 = fmaf(D->m23, n_1, pairs_5a);
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

#endif
