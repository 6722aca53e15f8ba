/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* All headers of certified kernels in one file, for vendoring; it may be included together with
   them. */

/* What keeps every operation rounded once, in the order written, under every flag that compiles.
   KSL_ALLOW_FAST_MATH lets flags through that break that. */
#ifndef KSL_ROUNDING_H
#define KSL_ROUNDING_H

#if !defined(KSL_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "-ffast-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__RECIPROCAL_MATH__)
#error "-freciprocal-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__NO_SIGNED_ZEROS__)
#error "-fno-signed-zeros breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffinite-math-only breaks what is promised of NaN; define KSL_ALLOW_FAST_MATH to accept that"
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "the x87 rounds twice: compile with -msse2 -mfpmath=sse, or define KSL_ALLOW_FAST_MATH"
#elif defined(__GNUC__) && !defined(__clang__) && !defined(__STRICT_ANSI__) && \
    (defined(__x86_64__) || defined(__aarch64__)) && __GCC_IEC_559 == 0
#error "-funsafe-math-optimizations or -fsingle-precision-constant breaks the bits promised here; \
define KSL_ALLOW_FAST_MATH to accept that"
#endif
#endif

/* Whether the target has an instruction that fuses a product into a sum: in double precision, and
   (KSL_HAS_FMAF) in single.  Who includes this may know better. */
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

/* gcc contracts across statements, and must not.  In force to the end of the file that is compiled,
   or nothing would be inlined. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#endif
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 14 && defined(__riscv_vector)
#pragma GCC optimize("no-tree-vectorize") /* the vectoriser contracts in spite of that */
#endif

#ifndef KSL_MUL
/* KSL_MUL(a, b) is a b, rounded to double on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which has no macro, clang fuses any product it sees.  So it sees an fma
   with -0, which changes no bit of the product, and cannot see that it is -0.  Defining
   KSL_CONTRACT_OFF says that the flag is not given, and saves the time. */
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
/* The vectoriser of these contracts in spite of flag and pragma where sums and differences take
   turns. */
#define KSL_MUL(a, b) __builtin_assoc_barrier((a) * (b))
#else
#define KSL_MUL(a, b) ((a) * (b))
#endif
#endif

#ifndef KSL_MULF
/* KSL_MULF(a, b) is a b, rounded to float on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMAF && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which has no macro, clang fuses any product it sees.  So it sees an fma
   with -0, which changes no bit of the product, and cannot see that it is -0.  Defining
   KSL_CONTRACT_OFF says that the flag is not given, and saves the time. */
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
/* The vectoriser of these contracts in spite of flag and pragma where sums and differences take
   turns. */
#define KSL_MULF(a, b) __builtin_assoc_barrier((a) * (b))
#else
#define KSL_MULF(a, b) ((a) * (b))
#endif
#endif

#endif

/* Types of the spatial algebra, in double and single precision.

   Every quantity is a union, so that it can be reached several ways.  Matrices are stored column by
   column.  Screws s = (v; ω) and coscrews c = (f; τ) have the linear part on top, so that power is
   their dot product.

   All functions: pointers must point to valid objects; an output may be the same object as an
   input; nothing else is read or written.  Every operation is rounded once, in the order written, so
   that results are the same bits everywhere, under every flag that compiles.

   Error bounds are derived from that order, to first order in u: u = 2^-53 in double and 2^-24 in
   single precision. */
#ifndef KSL_TYPES_H
#define KSL_TYPES_H

#include <math.h>
#include <string.h>


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

/* Vectors of three components.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_VEC3_CERTIFIED_H
#define KSL_VEC3_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scale_certified(ksl_vec3_t *self, const double a,
    ksl_vec3_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vv_certified(const double a, const ksl_vec3_t *x, ksl_vec3_t *y,
    ksl_vec3_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z;
  const double y_0_new_a_abs = fabs(y_0_new_a), y_0_abs = fabs(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const double y_1_new_a_abs = fabs(y_1_new_a), y_1_abs = fabs(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const double y_2_new_a_abs = fabs(y_2_new_a), y_2_abs = fabs(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const double y_0_new_padded = y_0_new_size + 2.004168360008973e-292,
      y_0_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_padded);
  const double y_1_new_padded = y_1_new_size + 2.004168360008973e-292,
      y_1_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_padded);
  const double y_2_new_padded = y_2_new_size + 2.004168360008973e-292,
      y_2_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = x->x + y->x;
  const double y_1_new = x->y + y->y;
  const double y_2_new = x->z + y->z;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = y->x - x->x;
  const double y_1_new = y->y - x->y;
  const double y_2_new = y->z - x->z;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_av_certified(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(a, vi->x);
  const double vo_1 = KSL_MUL(a, vi->y);
  const double vo_2 = KSL_MUL(a, vi->z);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x + v2->x;
  const double vo_1 = v1->y + v2->y;
  const double vo_2 = v1->z + v2->z;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x - v2->x;
  const double vo_1 = v1->y - v2->y;
  const double vo_2 = v1->z - v2->z;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scaled_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline double ksl_dot_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    double *dot_bound) {
  const double dot_a = KSL_MUL(v1->x, v2->x), dot_b = KSL_MUL(v1->y, v2->y), dot_c = dot_a + dot_b,
      dot_d = KSL_MUL(v1->z, v2->z), dot = dot_c + dot_d;
  const double dot_a_abs = fabs(dot_a), dot_b_abs = fabs(dot_b), dot_c_size = dot_a_abs + dot_b_abs,
      dot_d_abs = fabs(dot_d), dot_size = dot_c_size + dot_d_abs;
  const double dot_padded = dot_size + 2.004168360008973e-292,
      dot_error_bound = KSL_MUL(3.3306690738754706e-16, dot_padded);
  *dot_bound = dot_error_bound;
  return dot;
}

/* vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.
   k: number; v, vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_avinv_certified(const double k, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(k, v->x), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(k, v->y), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(k, v->z), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
     products overflow.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(v1->y, v2->z), vo_0b = KSL_MUL(v1->z, v2->y), vo_0 = vo_0a - vo_0b;
  const double vo_1a = KSL_MUL(v1->z, v2->x), vo_1b = KSL_MUL(v1->x, v2->z), vo_1 = vo_1a - vo_1b;
  const double vo_2a = KSL_MUL(v1->x, v2->y), vo_2b = KSL_MUL(v1->y, v2->x), vo_2 = vo_2a - vo_2b;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(2.2204460492503136e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(2.2204460492503136e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(2.2204460492503136e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(v1->z, v2->y), vo_0b = KSL_MUL(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1b = KSL_MUL(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2b = KSL_MUL(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(2.2204460492503136e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(2.2204460492503136e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(2.2204460492503136e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvx_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x + k;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x - k;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvy_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y + k;
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y - k;
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvz_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z + k;
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z - k;
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scale_certified(ksl_vec3f_t *self, const float a,
    ksl_vec3f_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vvf_certified(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->x), y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = KSL_MULF(a, x->y), y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = KSL_MULF(a, x->z), y_2_new = y_2_new_a + y->z;
  const float y_0_new_a_abs = fabsf(y_0_new_a), y_0_abs = fabsf(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const float y_1_new_a_abs = fabsf(y_1_new_a), y_1_abs = fabsf(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const float y_2_new_a_abs = fabsf(y_2_new_a), y_2_abs = fabsf(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const float y_0_new_padded = y_0_new_size + 1.9721523e-31f,
      y_0_new_error_bound = KSL_MULF(1.192093e-07f, y_0_new_padded);
  const float y_1_new_padded = y_1_new_size + 1.9721523e-31f,
      y_1_new_error_bound = KSL_MULF(1.192093e-07f, y_1_new_padded);
  const float y_2_new_padded = y_2_new_size + 1.9721523e-31f,
      y_2_new_error_bound = KSL_MULF(1.192093e-07f, y_2_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = x->x + y->x;
  const float y_1_new = x->y + y->y;
  const float y_2_new = x->z + y->z;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = y->x - x->x;
  const float y_1_new = y->y - x->y;
  const float y_2_new = y->z - x->z;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_avf_certified(const float a, const ksl_vec3f_t *vi,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(a, vi->x);
  const float vo_1 = KSL_MULF(a, vi->y);
  const float vo_2 = KSL_MULF(a, vi->z);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x + v2->x;
  const float vo_1 = v1->y + v2->y;
  const float vo_2 = v1->z + v2->z;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x - v2->x;
  const float vo_1 = v1->y - v2->y;
  const float vo_2 = v1->z - v2->z;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scaled_certified(const ksl_vec3f_t *v, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline float ksl_dot_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    float *dot_bound) {
  const float dot_a = KSL_MULF(v1->x, v2->x), dot_b = KSL_MULF(v1->y, v2->y), dot_c = dot_a + dot_b,
      dot_d = KSL_MULF(v1->z, v2->z), dot = dot_c + dot_d;
  const float dot_a_abs = fabsf(dot_a), dot_b_abs = fabsf(dot_b),
      dot_c_size = dot_a_abs + dot_b_abs, dot_d_abs = fabsf(dot_d),
      dot_size = dot_c_size + dot_d_abs;
  const float dot_padded = dot_size + 1.9721523e-31f,
      dot_error_bound = KSL_MULF(1.7881396e-07f, dot_padded);
  *dot_bound = dot_error_bound;
  return dot;
}

/* vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.
   k: number; v, vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_avinvf_certified(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(k, v->x), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(k, v->y), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(k, v->z), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
     products overflow.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(v1->y, v2->z), vo_0b = KSL_MULF(v1->z, v2->y), vo_0 = vo_0a - vo_0b;
  const float vo_1a = KSL_MULF(v1->z, v2->x), vo_1b = KSL_MULF(v1->x, v2->z), vo_1 = vo_1a - vo_1b;
  const float vo_2a = KSL_MULF(v1->x, v2->y), vo_2b = KSL_MULF(v1->y, v2->x), vo_2 = vo_2a - vo_2b;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.192093e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.192093e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.192093e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(v1->z, v2->y), vo_0b = KSL_MULF(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const float vo_1a = KSL_MULF(v1->x, v2->z), vo_1b = KSL_MULF(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const float vo_2a = KSL_MULF(v1->y, v2->x), vo_2b = KSL_MULF(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.192093e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.192093e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.192093e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x + k;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x - k;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y + k;
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y - k;
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z + k;
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z - k;
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_error_bound;
}

#endif

/* Vectors of four components: of three dimensions, with a homogeneous coordinate behind them.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_VEC4_CERTIFIED_H
#define KSL_VEC4_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4_scale_certified(ksl_vec4_t *self, const double a,
    ksl_vec4_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4_scaled_certified(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo,
    ksl_vec4_t *vo_bound) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_3 = KSL_MUL(v->w, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  const double vo_3_abs = fabs(vo_3), vo_3_padded = vo_3_abs + 2.004168360008973e-292,
      vo_3_error_bound = KSL_MUL(1.1102230246251568e-16, vo_3_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
  vo_bound->w = vo_3_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4f_scale_certified(ksl_vec4f_t *self, const float a,
    ksl_vec4f_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4f_scaled_certified(const ksl_vec4f_t *v, const float k,
    ksl_vec4f_t *vo, ksl_vec4f_t *vo_bound) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  const float vo_3 = KSL_MULF(v->w, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  const float vo_3_abs = fabsf(vo_3), vo_3_padded = vo_3_abs + 1.9721523e-31f,
      vo_3_error_bound = KSL_MULF(5.960465e-08f, vo_3_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
  vo_bound->w = vo_3_error_bound;
}

#endif

/* 3×3 matrices: rotations, and matrices in general.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_MAT3X3_CERTIFIED_H
#define KSL_MAT3X3_CERTIFIED_H


/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline double ksl_mat3x3_determinant_certified(const ksl_mat3x3_t *R, double *det_bound) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b;
  const double det_a = KSL_MUL(R->m00, n_0), det_b = KSL_MUL(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MUL(R->m20, n_2), det = det_c + det_d;
  const double n_0a_abs = fabs(n_0a), n_0b_abs = fabs(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const double n_1a_abs = fabs(n_1a), n_1b_abs = fabs(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const double n_2a_abs = fabs(n_2a), n_2b_abs = fabs(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), det_a_size = KSL_MUL(R_00_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double R_10_abs = fabs(R->m10), det_b_size = KSL_MUL(R_10_abs, n_1_padded),
      det_c_size = det_a_size + det_b_size;
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double R_20_abs = fabs(R->m20), det_d_size = KSL_MUL(R_20_abs, n_2_padded),
      det_size = det_c_size + det_d_size;
  const double det_padded = det_size + 2.004168360008973e-292,
      det_error_bound = KSL_MUL(5.551115123125785e-16, det_padded);
  *det_bound = det_error_bound;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1, dc = (sin θ, cos θ); |error
     of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3_setFromAxisDC_certified(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2], ksl_mat3x3_t *R_bound) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = KSL_MUL(axis->x, versine);
  const double versine_axis_1 = KSL_MUL(axis->y, versine);
  const double versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, versine_axis_0);
  const double m_1 = KSL_MUL(axis->y, versine_axis_1);
  const double m_2 = KSL_MUL(axis->z, versine_axis_2);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]);
  const double sine_axis_1 = KSL_MUL(axis->y, dc[0]);
  const double sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0;
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = dc[1] + m_1;
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = dc[1] + m_2;
  const double axis_0_abs = fabs(axis->x), versine_abs = fabs(versine),
      versine_axis_0_size = KSL_MUL(axis_0_abs, versine_abs);
  const double axis_1_abs = fabs(axis->y), versine_axis_1_size = KSL_MUL(axis_1_abs, versine_abs);
  const double axis_2_abs = fabs(axis->z), versine_axis_2_size = KSL_MUL(axis_2_abs, versine_abs);
  const double versine_axis_0_padded = versine_axis_0_size + 2.004168360008973e-292;
  const double m_0_size = KSL_MUL(axis_0_abs, versine_axis_0_padded);
  const double versine_axis_1_padded = versine_axis_1_size + 2.004168360008973e-292;
  const double m_1_size = KSL_MUL(axis_1_abs, versine_axis_1_padded);
  const double versine_axis_2_padded = versine_axis_2_size + 2.004168360008973e-292;
  const double m_2_size = KSL_MUL(axis_2_abs, versine_axis_2_padded);
  const double m_3_size = KSL_MUL(axis_1_abs, versine_axis_0_padded);
  const double m_4_size = KSL_MUL(axis_2_abs, versine_axis_0_padded);
  const double m_5_size = KSL_MUL(axis_2_abs, versine_axis_1_padded);
  const double dc_1_abs = fabs(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const double sine_axis_2_abs = fabs(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const double sine_axis_1_abs = fabs(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const double R_10_size = m_3_size + sine_axis_2_abs;
  const double R_11_size = dc_1_abs + m_1_size;
  const double sine_axis_0_abs = fabs(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const double R_20_size = m_4_size + sine_axis_1_abs;
  const double R_21_size = m_5_size + sine_axis_0_abs;
  const double R_22_size = dc_1_abs + m_2_size;
  const double R_00_padded = R_00_size + 2.004168360008973e-292,
      R_00_error_bound = KSL_MUL(4.440892098500628e-16, R_00_padded);
  const double R_01_padded = R_01_size + 2.004168360008973e-292,
      R_01_error_bound = KSL_MUL(4.440892098500628e-16, R_01_padded);
  const double R_02_padded = R_02_size + 2.004168360008973e-292,
      R_02_error_bound = KSL_MUL(4.440892098500628e-16, R_02_padded);
  const double R_10_padded = R_10_size + 2.004168360008973e-292,
      R_10_error_bound = KSL_MUL(4.440892098500628e-16, R_10_padded);
  const double R_11_padded = R_11_size + 2.004168360008973e-292,
      R_11_error_bound = KSL_MUL(4.440892098500628e-16, R_11_padded);
  const double R_12_padded = R_12_size + 2.004168360008973e-292,
      R_12_error_bound = KSL_MUL(4.440892098500628e-16, R_12_padded);
  const double R_20_padded = R_20_size + 2.004168360008973e-292,
      R_20_error_bound = KSL_MUL(4.440892098500628e-16, R_20_padded);
  const double R_21_padded = R_21_size + 2.004168360008973e-292,
      R_21_error_bound = KSL_MUL(4.440892098500628e-16, R_21_padded);
  const double R_22_padded = R_22_size + 2.004168360008973e-292,
      R_22_error_bound = KSL_MUL(4.440892098500628e-16, R_22_padded);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_error_bound;
  R_bound->m01 = R_01_error_bound;
  R_bound->m02 = R_02_error_bound;
  R_bound->m10 = R_10_error_bound;
  R_bound->m11 = R_11_error_bound;
  R_bound->m12 = R_12_error_bound;
  R_bound->m20 = R_20_error_bound;
  R_bound->m21 = R_21_error_bound;
  R_bound->m22 = R_22_error_bound;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline float ksl_mat3x3f_determinant_certified(const ksl_mat3x3f_t *R, float *det_bound) {
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0b = KSL_MULF(R->m12, R->m21), n_0 = n_0a - n_0b;
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1b = KSL_MULF(R->m01, R->m22), n_1 = n_1a - n_1b;
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2b = KSL_MULF(R->m02, R->m11), n_2 = n_2a - n_2b;
  const float det_a = KSL_MULF(R->m00, n_0), det_b = KSL_MULF(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MULF(R->m20, n_2), det = det_c + det_d;
  const float n_0a_abs = fabsf(n_0a), n_0b_abs = fabsf(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const float n_1a_abs = fabsf(n_1a), n_1b_abs = fabsf(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const float n_2a_abs = fabsf(n_2a), n_2b_abs = fabsf(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), det_a_size = KSL_MULF(R_00_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float R_10_abs = fabsf(R->m10), det_b_size = KSL_MULF(R_10_abs, n_1_padded),
      det_c_size = det_a_size + det_b_size;
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float R_20_abs = fabsf(R->m20), det_d_size = KSL_MULF(R_20_abs, n_2_padded),
      det_size = det_c_size + det_d_size;
  const float det_padded = det_size + 1.9721523e-31f,
      det_error_bound = KSL_MULF(2.9802328e-07f, det_padded);
  *det_bound = det_error_bound;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1, dc = (sin θ, cos θ); |error
     of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3f_setFromAxisDC_certified(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2], ksl_mat3x3f_t *R_bound) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = KSL_MULF(axis->x, versine);
  const float versine_axis_1 = KSL_MULF(axis->y, versine);
  const float versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, versine_axis_0);
  const float m_1 = KSL_MULF(axis->y, versine_axis_1);
  const float m_2 = KSL_MULF(axis->z, versine_axis_2);
  const float m_3 = KSL_MULF(axis->y, versine_axis_0);
  const float m_4 = KSL_MULF(axis->z, versine_axis_0);
  const float m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]);
  const float sine_axis_1 = KSL_MULF(axis->y, dc[0]);
  const float sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = dc[1] + m_0;
  const float R_01 = m_3 - sine_axis_2;
  const float R_02 = m_4 + sine_axis_1;
  const float R_10 = m_3 + sine_axis_2;
  const float R_11 = dc[1] + m_1;
  const float R_12 = m_5 - sine_axis_0;
  const float R_20 = m_4 - sine_axis_1;
  const float R_21 = m_5 + sine_axis_0;
  const float R_22 = dc[1] + m_2;
  const float axis_0_abs = fabsf(axis->x), versine_abs = fabsf(versine),
      versine_axis_0_size = KSL_MULF(axis_0_abs, versine_abs);
  const float axis_1_abs = fabsf(axis->y), versine_axis_1_size = KSL_MULF(axis_1_abs, versine_abs);
  const float axis_2_abs = fabsf(axis->z), versine_axis_2_size = KSL_MULF(axis_2_abs, versine_abs);
  const float versine_axis_0_padded = versine_axis_0_size + 1.9721523e-31f;
  const float m_0_size = KSL_MULF(axis_0_abs, versine_axis_0_padded);
  const float versine_axis_1_padded = versine_axis_1_size + 1.9721523e-31f;
  const float m_1_size = KSL_MULF(axis_1_abs, versine_axis_1_padded);
  const float versine_axis_2_padded = versine_axis_2_size + 1.9721523e-31f;
  const float m_2_size = KSL_MULF(axis_2_abs, versine_axis_2_padded);
  const float m_3_size = KSL_MULF(axis_1_abs, versine_axis_0_padded);
  const float m_4_size = KSL_MULF(axis_2_abs, versine_axis_0_padded);
  const float m_5_size = KSL_MULF(axis_2_abs, versine_axis_1_padded);
  const float dc_1_abs = fabsf(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const float sine_axis_2_abs = fabsf(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const float sine_axis_1_abs = fabsf(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const float R_10_size = m_3_size + sine_axis_2_abs;
  const float R_11_size = dc_1_abs + m_1_size;
  const float sine_axis_0_abs = fabsf(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const float R_20_size = m_4_size + sine_axis_1_abs;
  const float R_21_size = m_5_size + sine_axis_0_abs;
  const float R_22_size = dc_1_abs + m_2_size;
  const float R_00_padded = R_00_size + 1.9721523e-31f,
      R_00_error_bound = KSL_MULF(2.3841864e-07f, R_00_padded);
  const float R_01_padded = R_01_size + 1.9721523e-31f,
      R_01_error_bound = KSL_MULF(2.3841864e-07f, R_01_padded);
  const float R_02_padded = R_02_size + 1.9721523e-31f,
      R_02_error_bound = KSL_MULF(2.3841864e-07f, R_02_padded);
  const float R_10_padded = R_10_size + 1.9721523e-31f,
      R_10_error_bound = KSL_MULF(2.3841864e-07f, R_10_padded);
  const float R_11_padded = R_11_size + 1.9721523e-31f,
      R_11_error_bound = KSL_MULF(2.3841864e-07f, R_11_padded);
  const float R_12_padded = R_12_size + 1.9721523e-31f,
      R_12_error_bound = KSL_MULF(2.3841864e-07f, R_12_padded);
  const float R_20_padded = R_20_size + 1.9721523e-31f,
      R_20_error_bound = KSL_MULF(2.3841864e-07f, R_20_padded);
  const float R_21_padded = R_21_size + 1.9721523e-31f,
      R_21_error_bound = KSL_MULF(2.3841864e-07f, R_21_padded);
  const float R_22_padded = R_22_size + 1.9721523e-31f,
      R_22_error_bound = KSL_MULF(2.3841864e-07f, R_22_padded);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_error_bound;
  R_bound->m01 = R_01_error_bound;
  R_bound->m02 = R_02_error_bound;
  R_bound->m10 = R_10_error_bound;
  R_bound->m11 = R_11_error_bound;
  R_bound->m12 = R_12_error_bound;
  R_bound->m20 = R_20_error_bound;
  R_bound->m21 = R_21_error_bound;
  R_bound->m22 = R_22_error_bound;
}

#endif

/* Displacements D = [R | t].
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_SE3_CERTIFIED_H
#define KSL_SE3_CERTIFIED_H


/* self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3_invert_certified(ksl_SE3_t *self, ksl_SE3_t *self_bound) {
  const double self_03_new_a = KSL_MUL(self->m00, self->m03),
      self_03_new_b = KSL_MUL(self->m10, self->m13), self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_d = KSL_MUL(self->m20, self->m23), self_03_new_e = self_03_new_c + self_03_new_d,
      self_03_new = -self_03_new_e;
  const double self_13_new_a = KSL_MUL(self->m01, self->m03),
      self_13_new_b = KSL_MUL(self->m11, self->m13), self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_d = KSL_MUL(self->m21, self->m23), self_13_new_e = self_13_new_c + self_13_new_d,
      self_13_new = -self_13_new_e;
  const double self_23_new_a = KSL_MUL(self->m02, self->m03),
      self_23_new_b = KSL_MUL(self->m12, self->m13), self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_d = KSL_MUL(self->m22, self->m23), self_23_new_e = self_23_new_c + self_23_new_d,
      self_23_new = -self_23_new_e;
  const double self_03_new_a_abs = fabs(self_03_new_a), self_03_new_b_abs = fabs(self_03_new_b),
      self_03_new_c_size = self_03_new_a_abs + self_03_new_b_abs,
      self_03_new_d_abs = fabs(self_03_new_d),
      self_03_new_e_size = self_03_new_c_size + self_03_new_d_abs;
  const double self_13_new_a_abs = fabs(self_13_new_a), self_13_new_b_abs = fabs(self_13_new_b),
      self_13_new_c_size = self_13_new_a_abs + self_13_new_b_abs,
      self_13_new_d_abs = fabs(self_13_new_d),
      self_13_new_e_size = self_13_new_c_size + self_13_new_d_abs;
  const double self_23_new_a_abs = fabs(self_23_new_a), self_23_new_b_abs = fabs(self_23_new_b),
      self_23_new_c_size = self_23_new_a_abs + self_23_new_b_abs,
      self_23_new_d_abs = fabs(self_23_new_d),
      self_23_new_e_size = self_23_new_c_size + self_23_new_d_abs;
  const double self_03_new_e_padded = self_03_new_e_size + 2.004168360008973e-292,
      self_03_new_e_error_bound = KSL_MUL(3.3306690738754706e-16, self_03_new_e_padded);
  const double self_13_new_e_padded = self_13_new_e_size + 2.004168360008973e-292,
      self_13_new_e_error_bound = KSL_MUL(3.3306690738754706e-16, self_13_new_e_padded);
  const double self_23_new_e_padded = self_23_new_e_size + 2.004168360008973e-292,
      self_23_new_e_error_bound = KSL_MUL(3.3306690738754706e-16, self_23_new_e_padded);
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
  self_bound->m00 = 0.0;
  self_bound->m01 = 0.0;
  self_bound->m02 = 0.0;
  self_bound->m03 = self_03_new_e_error_bound;
  self_bound->m10 = 0.0;
  self_bound->m11 = 0.0;
  self_bound->m12 = 0.0;
  self_bound->m13 = self_13_new_e_error_bound;
  self_bound->m20 = 0.0;
  self_bound->m21 = 0.0;
  self_bound->m22 = 0.0;
  self_bound->m23 = self_23_new_e_error_bound;
}

/* Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3_inverted_certified(const ksl_SE3_t *D, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, D->m03), Do_03b = KSL_MUL(D->m10, D->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m20, D->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = -Do_03e;
  const double Do_13a = KSL_MUL(D->m01, D->m03), Do_13b = KSL_MUL(D->m11, D->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m21, D->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = -Do_13e;
  const double Do_23a = KSL_MUL(D->m02, D->m03), Do_23b = KSL_MUL(D->m12, D->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, D->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = -Do_23e;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs;
  const double Do_03e_padded = Do_03e_size + 2.004168360008973e-292,
      Do_03e_error_bound = KSL_MUL(3.3306690738754706e-16, Do_03e_padded);
  const double Do_13e_padded = Do_13e_size + 2.004168360008973e-292,
      Do_13e_error_bound = KSL_MUL(3.3306690738754706e-16, Do_13e_padded);
  const double Do_23e_padded = Do_23e_size + 2.004168360008973e-292,
      Do_23e_error_bound = KSL_MUL(3.3306690738754706e-16, Do_23e_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03e_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13e_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23e_error_bound;
}

/* self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3f_invert_certified(ksl_SE3f_t *self, ksl_SE3f_t *self_bound) {
  const float self_03_new_a = KSL_MULF(self->m00, self->m03),
      self_03_new_b = KSL_MULF(self->m10, self->m13), self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_d = KSL_MULF(self->m20, self->m23), self_03_new_e = self_03_new_c + self_03_new_d,
      self_03_new = -self_03_new_e;
  const float self_13_new_a = KSL_MULF(self->m01, self->m03),
      self_13_new_b = KSL_MULF(self->m11, self->m13), self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_d = KSL_MULF(self->m21, self->m23), self_13_new_e = self_13_new_c + self_13_new_d,
      self_13_new = -self_13_new_e;
  const float self_23_new_a = KSL_MULF(self->m02, self->m03),
      self_23_new_b = KSL_MULF(self->m12, self->m13), self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_d = KSL_MULF(self->m22, self->m23), self_23_new_e = self_23_new_c + self_23_new_d,
      self_23_new = -self_23_new_e;
  const float self_03_new_a_abs = fabsf(self_03_new_a), self_03_new_b_abs = fabsf(self_03_new_b),
      self_03_new_c_size = self_03_new_a_abs + self_03_new_b_abs,
      self_03_new_d_abs = fabsf(self_03_new_d),
      self_03_new_e_size = self_03_new_c_size + self_03_new_d_abs;
  const float self_13_new_a_abs = fabsf(self_13_new_a), self_13_new_b_abs = fabsf(self_13_new_b),
      self_13_new_c_size = self_13_new_a_abs + self_13_new_b_abs,
      self_13_new_d_abs = fabsf(self_13_new_d),
      self_13_new_e_size = self_13_new_c_size + self_13_new_d_abs;
  const float self_23_new_a_abs = fabsf(self_23_new_a), self_23_new_b_abs = fabsf(self_23_new_b),
      self_23_new_c_size = self_23_new_a_abs + self_23_new_b_abs,
      self_23_new_d_abs = fabsf(self_23_new_d),
      self_23_new_e_size = self_23_new_c_size + self_23_new_d_abs;
  const float self_03_new_e_padded = self_03_new_e_size + 1.9721523e-31f,
      self_03_new_e_error_bound = KSL_MULF(1.7881396e-07f, self_03_new_e_padded);
  const float self_13_new_e_padded = self_13_new_e_size + 1.9721523e-31f,
      self_13_new_e_error_bound = KSL_MULF(1.7881396e-07f, self_13_new_e_padded);
  const float self_23_new_e_padded = self_23_new_e_size + 1.9721523e-31f,
      self_23_new_e_error_bound = KSL_MULF(1.7881396e-07f, self_23_new_e_padded);
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
  self_bound->m00 = 0.0f;
  self_bound->m01 = 0.0f;
  self_bound->m02 = 0.0f;
  self_bound->m03 = self_03_new_e_error_bound;
  self_bound->m10 = 0.0f;
  self_bound->m11 = 0.0f;
  self_bound->m12 = 0.0f;
  self_bound->m13 = self_13_new_e_error_bound;
  self_bound->m20 = 0.0f;
  self_bound->m21 = 0.0f;
  self_bound->m22 = 0.0f;
  self_bound->m23 = self_23_new_e_error_bound;
}

/* Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3f_inverted_certified(const ksl_SE3f_t *D, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, D->m03), Do_03b = KSL_MULF(D->m10, D->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m20, D->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = -Do_03e;
  const float Do_13a = KSL_MULF(D->m01, D->m03), Do_13b = KSL_MULF(D->m11, D->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m21, D->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = -Do_13e;
  const float Do_23a = KSL_MULF(D->m02, D->m03), Do_23b = KSL_MULF(D->m12, D->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, D->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = -Do_23e;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs;
  const float Do_03e_padded = Do_03e_size + 1.9721523e-31f,
      Do_03e_error_bound = KSL_MULF(1.7881396e-07f, Do_03e_padded);
  const float Do_13e_padded = Do_13e_size + 1.9721523e-31f,
      Do_13e_error_bound = KSL_MULF(1.7881396e-07f, Do_13e_padded);
  const float Do_23e_padded = Do_23e_size + 1.9721523e-31f,
      Do_23e_error_bound = KSL_MULF(1.7881396e-07f, Do_23e_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03e_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13e_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23e_error_bound;
}

#endif

/* Products between rotations, displacements and vectors.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_MATRIX_CERTIFIED_H
#define KSL_MATRIX_CERTIFIED_H


/* vo = R v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2_size = vo_2c_size + vo_2d_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs;
  const double vo_0e_padded = vo_0e_size + 2.004168360008973e-292,
      vo_0e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0e_padded);
  const double vo_1e_padded = vo_1e_size + 2.004168360008973e-292,
      vo_1e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1e_padded);
  const double vo_2e_padded = vo_2e_size + 2.004168360008973e-292,
      vo_2e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2_size = vo_2c_size + vo_2d_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs;
  const double vo_0e_padded = vo_0e_size + 2.004168360008973e-292,
      vo_0e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0e_padded);
  const double vo_1e_padded = vo_1e_size + 2.004168360008973e-292,
      vo_1e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1e_padded);
  const double vo_2e_padded = vo_2e_size + 2.004168360008973e-292,
      vo_2e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0b = KSL_MUL(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1b = KSL_MUL(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2b = KSL_MUL(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs, D_03_abs = fabs(D->m03),
      vo_0_size = vo_0e_size + D_03_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs, D_13_abs = fabs(D->m13),
      vo_1_size = vo_1e_size + D_13_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs, D_23_abs = fabs(D->m23),
      vo_2_size = vo_2e_size + D_23_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(4.440892098500628e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(4.440892098500628e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(4.440892098500628e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0b = KSL_MUL(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1b = KSL_MUL(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2b = KSL_MUL(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  const double D_00_abs = fabs(D->m00), p_0_abs = fabs(p_0),
      vo_0a_size = KSL_MUL(D_00_abs, p_0_abs), D_10_abs = fabs(D->m10), p_1_abs = fabs(p_1),
      vo_0b_size = KSL_MUL(D_10_abs, p_1_abs), vo_0c_size = vo_0a_size + vo_0b_size,
      D_20_abs = fabs(D->m20), p_2_abs = fabs(p_2), vo_0d_size = KSL_MUL(D_20_abs, p_2_abs),
      vo_0_size = vo_0c_size + vo_0d_size;
  const double D_01_abs = fabs(D->m01), vo_1a_size = KSL_MUL(D_01_abs, p_0_abs),
      D_11_abs = fabs(D->m11), vo_1b_size = KSL_MUL(D_11_abs, p_1_abs),
      vo_1c_size = vo_1a_size + vo_1b_size, D_21_abs = fabs(D->m21),
      vo_1d_size = KSL_MUL(D_21_abs, p_2_abs), vo_1_size = vo_1c_size + vo_1d_size;
  const double D_02_abs = fabs(D->m02), vo_2a_size = KSL_MUL(D_02_abs, p_0_abs),
      D_12_abs = fabs(D->m12), vo_2b_size = KSL_MUL(D_12_abs, p_1_abs),
      vo_2c_size = vo_2a_size + vo_2b_size, D_22_abs = fabs(D->m22),
      vo_2d_size = KSL_MUL(D_22_abs, p_2_abs), vo_2_size = vo_2c_size + vo_2d_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(4.440892098500628e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(4.440892098500628e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(4.440892098500628e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m02, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m02, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m01, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m12, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m12, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22b = KSL_MUL(R1->m21, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinv_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m01),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m02, R2->m02), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m02, R2->m12), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02b = KSL_MUL(R1->m01, R2->m21),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m01),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m12, R2->m02), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m12, R2->m12), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12b = KSL_MUL(R1->m11, R2->m21),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m01),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m02), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m12), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22b = KSL_MUL(R1->m21, R2->m21),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m10, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m20, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m10, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m20, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m10, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m20, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m21, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m21, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m21, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20b = KSL_MUL(R1->m12, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21b = KSL_MUL(R1->m12, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22b = KSL_MUL(R1->m12, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_dd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m01, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D1->m02, D2->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m01, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D1->m02, D2->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m01, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D1->m02, D2->m22), Do_02 = Do_02c + Do_02d;
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03b = KSL_MUL(D1->m01, D2->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D1->m02, D2->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D1->m03;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D1->m12, D2->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D1->m12, D2->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D1->m12, D2->m22), Do_12 = Do_12c + Do_12d;
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13b = KSL_MUL(D1->m11, D2->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D1->m12, D2->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D1->m13;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20b = KSL_MUL(D1->m21, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21b = KSL_MUL(D1->m21, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22b = KSL_MUL(D1->m21, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23b = KSL_MUL(D1->m21, D2->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D1->m22, D2->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D1->m23;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D1_03_abs = fabs(D1->m03),
      Do_03_size = Do_03e_size + D1_03_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D1_13_abs = fabs(D1->m13),
      Do_13_size = Do_13e_size + D1_13_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D1_23_abs = fabs(D1->m23),
      Do_23_size = Do_23e_size + D1_23_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinv_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0b = KSL_MUL(D1->m01, D2->m01),
      R_0c = R_0a + R_0b, R_0d = KSL_MUL(D1->m02, D2->m02), R_0 = R_0c + R_0d;
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1b = KSL_MUL(D1->m01, D2->m11),
      R_1c = R_1a + R_1b, R_1d = KSL_MUL(D1->m02, D2->m12), R_1 = R_1c + R_1d;
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2b = KSL_MUL(D1->m01, D2->m21),
      R_2c = R_2a + R_2b, R_2d = KSL_MUL(D1->m02, D2->m22), R_2 = R_2c + R_2d;
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3b = KSL_MUL(D1->m11, D2->m01),
      R_3c = R_3a + R_3b, R_3d = KSL_MUL(D1->m12, D2->m02), R_3 = R_3c + R_3d;
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4b = KSL_MUL(D1->m11, D2->m11),
      R_4c = R_4a + R_4b, R_4d = KSL_MUL(D1->m12, D2->m12), R_4 = R_4c + R_4d;
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5b = KSL_MUL(D1->m11, D2->m21),
      R_5c = R_5a + R_5b, R_5d = KSL_MUL(D1->m12, D2->m22), R_5 = R_5c + R_5d;
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6b = KSL_MUL(D1->m21, D2->m01),
      R_6c = R_6a + R_6b, R_6d = KSL_MUL(D1->m22, D2->m02), R_6 = R_6c + R_6d;
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7b = KSL_MUL(D1->m21, D2->m11),
      R_7c = R_7a + R_7b, R_7d = KSL_MUL(D1->m22, D2->m12), R_7 = R_7c + R_7d;
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8b = KSL_MUL(D1->m21, D2->m21),
      R_8c = R_8a + R_8b, R_8d = KSL_MUL(D1->m22, D2->m22), R_8 = R_8c + R_8d;
  const double Do_03a = KSL_MUL(D2->m03, R_0), Do_03b = KSL_MUL(D2->m13, R_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D2->m23, R_2), Do_03e = Do_03c + Do_03d,
      Do_03 = D1->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D2->m03, R_3), Do_13b = KSL_MUL(D2->m13, R_4),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D2->m23, R_5), Do_13e = Do_13c + Do_13d,
      Do_13 = D1->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D2->m03, R_6), Do_23b = KSL_MUL(D2->m13, R_7),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D2->m23, R_8), Do_23e = Do_23c + Do_23d,
      Do_23 = D1->m23 - Do_23e;
  const double R_0a_abs = fabs(R_0a), R_0b_abs = fabs(R_0b), R_0c_size = R_0a_abs + R_0b_abs,
      R_0d_abs = fabs(R_0d), R_0_size = R_0c_size + R_0d_abs;
  const double R_1a_abs = fabs(R_1a), R_1b_abs = fabs(R_1b), R_1c_size = R_1a_abs + R_1b_abs,
      R_1d_abs = fabs(R_1d), R_1_size = R_1c_size + R_1d_abs;
  const double R_2a_abs = fabs(R_2a), R_2b_abs = fabs(R_2b), R_2c_size = R_2a_abs + R_2b_abs,
      R_2d_abs = fabs(R_2d), R_2_size = R_2c_size + R_2d_abs;
  const double R_3a_abs = fabs(R_3a), R_3b_abs = fabs(R_3b), R_3c_size = R_3a_abs + R_3b_abs,
      R_3d_abs = fabs(R_3d), R_3_size = R_3c_size + R_3d_abs;
  const double R_4a_abs = fabs(R_4a), R_4b_abs = fabs(R_4b), R_4c_size = R_4a_abs + R_4b_abs,
      R_4d_abs = fabs(R_4d), R_4_size = R_4c_size + R_4d_abs;
  const double R_5a_abs = fabs(R_5a), R_5b_abs = fabs(R_5b), R_5c_size = R_5a_abs + R_5b_abs,
      R_5d_abs = fabs(R_5d), R_5_size = R_5c_size + R_5d_abs;
  const double R_6a_abs = fabs(R_6a), R_6b_abs = fabs(R_6b), R_6c_size = R_6a_abs + R_6b_abs,
      R_6d_abs = fabs(R_6d), R_6_size = R_6c_size + R_6d_abs;
  const double R_7a_abs = fabs(R_7a), R_7b_abs = fabs(R_7b), R_7c_size = R_7a_abs + R_7b_abs,
      R_7d_abs = fabs(R_7d), R_7_size = R_7c_size + R_7d_abs;
  const double R_8a_abs = fabs(R_8a), R_8b_abs = fabs(R_8b), R_8c_size = R_8a_abs + R_8b_abs,
      R_8d_abs = fabs(R_8d), R_8_size = R_8c_size + R_8d_abs;
  const double R_0_padded = R_0_size + 2.004168360008973e-292;
  const double D2_03_abs = fabs(D2->m03), Do_03a_size = KSL_MUL(D2_03_abs, R_0_padded);
  const double R_1_padded = R_1_size + 2.004168360008973e-292;
  const double D2_13_abs = fabs(D2->m13), Do_03b_size = KSL_MUL(D2_13_abs, R_1_padded),
      Do_03c_size = Do_03a_size + Do_03b_size;
  const double R_2_padded = R_2_size + 2.004168360008973e-292;
  const double D2_23_abs = fabs(D2->m23), Do_03d_size = KSL_MUL(D2_23_abs, R_2_padded),
      Do_03e_size = Do_03c_size + Do_03d_size, D1_03_abs = fabs(D1->m03),
      Do_03_size = D1_03_abs + Do_03e_size;
  const double R_3_padded = R_3_size + 2.004168360008973e-292;
  const double Do_13a_size = KSL_MUL(D2_03_abs, R_3_padded);
  const double R_4_padded = R_4_size + 2.004168360008973e-292;
  const double Do_13b_size = KSL_MUL(D2_13_abs, R_4_padded),
      Do_13c_size = Do_13a_size + Do_13b_size;
  const double R_5_padded = R_5_size + 2.004168360008973e-292;
  const double Do_13d_size = KSL_MUL(D2_23_abs, R_5_padded),
      Do_13e_size = Do_13c_size + Do_13d_size, D1_13_abs = fabs(D1->m13),
      Do_13_size = D1_13_abs + Do_13e_size;
  const double R_6_padded = R_6_size + 2.004168360008973e-292;
  const double Do_23a_size = KSL_MUL(D2_03_abs, R_6_padded);
  const double R_7_padded = R_7_size + 2.004168360008973e-292;
  const double Do_23b_size = KSL_MUL(D2_13_abs, R_7_padded),
      Do_23c_size = Do_23a_size + Do_23b_size;
  const double R_8_padded = R_8_size + 2.004168360008973e-292;
  const double Do_23d_size = KSL_MUL(D2_23_abs, R_8_padded),
      Do_23e_size = Do_23c_size + Do_23d_size, D1_23_abs = fabs(D1->m23),
      Do_23_size = D1_23_abs + Do_23e_size;
  const double R_0_error_bound = KSL_MUL(3.3306690738754706e-16, R_0_padded);
  const double R_1_error_bound = KSL_MUL(3.3306690738754706e-16, R_1_padded);
  const double R_2_error_bound = KSL_MUL(3.3306690738754706e-16, R_2_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(7.7715611723761e-16, Do_03_padded);
  const double R_3_error_bound = KSL_MUL(3.3306690738754706e-16, R_3_padded);
  const double R_4_error_bound = KSL_MUL(3.3306690738754706e-16, R_4_padded);
  const double R_5_error_bound = KSL_MUL(3.3306690738754706e-16, R_5_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(7.7715611723761e-16, Do_13_padded);
  const double R_6_error_bound = KSL_MUL(3.3306690738754706e-16, R_6_padded);
  const double R_7_error_bound = KSL_MUL(3.3306690738754706e-16, R_7_padded);
  const double R_8_error_bound = KSL_MUL(3.3306690738754706e-16, R_8_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(7.7715611723761e-16, Do_23_padded);
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
  Do_bound->m00 = R_0_error_bound;
  Do_bound->m01 = R_1_error_bound;
  Do_bound->m02 = R_2_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = R_3_error_bound;
  Do_bound->m11 = R_4_error_bound;
  Do_bound->m12 = R_5_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = R_6_error_bound;
  Do_bound->m21 = R_7_error_bound;
  Do_bound->m22 = R_8_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m10, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D1->m20, D2->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m10, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D1->m20, D2->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m10, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D1->m20, D2->m22), Do_02 = Do_02c + Do_02d;
  const double Do_03a = KSL_MUL(D1->m00, p_0), Do_03b = KSL_MUL(D1->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D1->m20, p_2), Do_03 = Do_03c + Do_03d;
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D1->m21, D2->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D1->m21, D2->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D1->m21, D2->m22), Do_12 = Do_12c + Do_12d;
  const double Do_13a = KSL_MUL(D1->m01, p_0), Do_13b = KSL_MUL(D1->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D1->m21, p_2), Do_13 = Do_13c + Do_13d;
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20b = KSL_MUL(D1->m12, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21b = KSL_MUL(D1->m12, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22b = KSL_MUL(D1->m12, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const double Do_23a = KSL_MUL(D1->m02, p_0), Do_23b = KSL_MUL(D1->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D1->m22, p_2), Do_23 = Do_23c + Do_23d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double D1_00_abs = fabs(D1->m00), p_0_abs = fabs(p_0),
      Do_03a_size = KSL_MUL(D1_00_abs, p_0_abs), D1_10_abs = fabs(D1->m10), p_1_abs = fabs(p_1),
      Do_03b_size = KSL_MUL(D1_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D1_20_abs = fabs(D1->m20), p_2_abs = fabs(p_2), Do_03d_size = KSL_MUL(D1_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double D1_01_abs = fabs(D1->m01), Do_13a_size = KSL_MUL(D1_01_abs, p_0_abs),
      D1_11_abs = fabs(D1->m11), Do_13b_size = KSL_MUL(D1_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D1_21_abs = fabs(D1->m21),
      Do_13d_size = KSL_MUL(D1_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double D1_02_abs = fabs(D1->m02), Do_23a_size = KSL_MUL(D1_02_abs, p_0_abs),
      D1_12_abs = fabs(D1->m12), Do_23b_size = KSL_MUL(D1_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D1_22_abs = fabs(D1->m22),
      Do_23d_size = KSL_MUL(D1_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddr_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D->m02, R->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D->m02, R->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02b = KSL_MUL(D->m01, R->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D->m12, R->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D->m12, R->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12b = KSL_MUL(D->m11, R->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D->m22, R->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D->m22, R->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22b = KSL_MUL(D->m21, R->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinv_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m01),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D->m02, R->m02), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D->m02, R->m12), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02b = KSL_MUL(D->m01, R->m21),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m01),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D->m12, R->m02), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D->m12, R->m12), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12b = KSL_MUL(D->m11, R->m21),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m01),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D->m22, R->m02), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D->m22, R->m12), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22b = KSL_MUL(D->m21, R->m21),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabs(D->m03),
      Do_03_size = Do_03e_size + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabs(D->m13),
      Do_13_size = Do_13e_size + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabs(D->m23),
      Do_23_size = Do_23e_size + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinv_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabs(D->m03),
      Do_03_size = D_03_abs + Do_03e_size;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabs(D->m13),
      Do_13_size = D_13_abs + Do_13e_size;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabs(D->m23),
      Do_23_size = D_23_abs + Do_23e_size;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03b = KSL_MUL(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13b = KSL_MUL(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23b = KSL_MUL(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, p_2), Do_23 = Do_23c + Do_23d;
  const double D_00_abs = fabs(D->m00), p_0_abs = fabs(p_0),
      Do_03a_size = KSL_MUL(D_00_abs, p_0_abs), D_10_abs = fabs(D->m10), p_1_abs = fabs(p_1),
      Do_03b_size = KSL_MUL(D_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D_20_abs = fabs(D->m20), p_2_abs = fabs(p_2), Do_03d_size = KSL_MUL(D_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const double D_01_abs = fabs(D->m01), Do_13a_size = KSL_MUL(D_01_abs, p_0_abs),
      D_11_abs = fabs(D->m11), Do_13b_size = KSL_MUL(D_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D_21_abs = fabs(D->m21),
      Do_13d_size = KSL_MUL(D_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const double D_02_abs = fabs(D->m02), Do_23a_size = KSL_MUL(D_02_abs, p_0_abs),
      D_12_abs = fabs(D->m12), Do_23b_size = KSL_MUL(D_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D_22_abs = fabs(D->m22),
      Do_23d_size = KSL_MUL(D_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtx_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m00, k);
  const double vo_1 = KSL_MUL(R->m10, k);
  const double vo_2 = KSL_MUL(R->m20, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrx_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m01, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m11, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a + Ro_21b;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m21, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = 0.0;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrx_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a + Do_01b;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m01, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a + Do_11b;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m11, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a + Do_21b;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m21, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtx_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = Do_23a + D->m23;
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_02a = KSL_MUL(R->m01, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_12a = KSL_MUL(R->m11, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const double Ro_22a = KSL_MUL(R->m21, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = 0.0;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const double Do_02a = KSL_MUL(D->m01, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const double Do_12a = KSL_MUL(D->m11, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const double Do_22a = KSL_MUL(D->m21, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = D->m23 - Do_23a;
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvty_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m01, k);
  const double vo_1 = KSL_MUL(R->m11, k);
  const double vo_2 = KSL_MUL(R->m21, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdry_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_02a = KSL_MUL(R->m00, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_12a = KSL_MUL(R->m10, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_22a = KSL_MUL(R->m20, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddry_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const double Do_02a = KSL_MUL(D->m00, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const double Do_12a = KSL_MUL(D->m10, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const double Do_22a = KSL_MUL(D->m20, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddty_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = Do_23a + D->m23;
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m00, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m10, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m20, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m00, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m10, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m20, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = D->m23 - Do_23a;
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtz_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m02, k);
  const double vo_1 = KSL_MUL(R->m12, k);
  const double vo_2 = KSL_MUL(R->m22, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrz_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m00, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m10, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m20, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = 0.0;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrz_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m00, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m10, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m20, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtz_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = Do_23a + D->m23;
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_01a = KSL_MUL(R->m00, dc[0]), Ro_01b = KSL_MUL(R->m01, dc[1]),
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_11a = KSL_MUL(R->m10, dc[0]), Ro_11b = KSL_MUL(R->m11, dc[1]),
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_21a = KSL_MUL(R->m20, dc[0]), Ro_21b = KSL_MUL(R->m21, dc[1]),
      Ro_21 = Ro_21a + Ro_21b;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = 0.0;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const double Do_01a = KSL_MUL(D->m00, dc[0]), Do_01b = KSL_MUL(D->m01, dc[1]),
      Do_01 = Do_01a + Do_01b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const double Do_11a = KSL_MUL(D->m10, dc[0]), Do_11b = KSL_MUL(D->m11, dc[1]),
      Do_11 = Do_11a + Do_11b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const double Do_21a = KSL_MUL(D->m20, dc[0]), Do_21b = KSL_MUL(D->m21, dc[1]),
      Do_21 = Do_21a + Do_21b;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = D->m23 - Do_23a;
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2_size = vo_2c_size + vo_2d_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.7881396e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.7881396e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.7881396e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs;
  const float vo_0e_padded = vo_0e_size + 1.9721523e-31f,
      vo_0e_error_bound = KSL_MULF(1.7881396e-07f, vo_0e_padded);
  const float vo_1e_padded = vo_1e_size + 1.9721523e-31f,
      vo_1e_error_bound = KSL_MULF(1.7881396e-07f, vo_1e_padded);
  const float vo_2e_padded = vo_2e_size + 1.9721523e-31f,
      vo_2e_error_bound = KSL_MULF(1.7881396e-07f, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2_size = vo_2c_size + vo_2d_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.7881396e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.7881396e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.7881396e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs;
  const float vo_0e_padded = vo_0e_size + 1.9721523e-31f,
      vo_0e_error_bound = KSL_MULF(1.7881396e-07f, vo_0e_padded);
  const float vo_1e_padded = vo_1e_size + 1.9721523e-31f,
      vo_1e_error_bound = KSL_MULF(1.7881396e-07f, vo_1e_padded);
  const float vo_2e_padded = vo_2e_size + 1.9721523e-31f,
      vo_2e_error_bound = KSL_MULF(1.7881396e-07f, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0b = KSL_MULF(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1b = KSL_MULF(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2b = KSL_MULF(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs, D_03_abs = fabsf(D->m03),
      vo_0_size = vo_0e_size + D_03_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs, D_13_abs = fabsf(D->m13),
      vo_1_size = vo_1e_size + D_13_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs, D_23_abs = fabsf(D->m23),
      vo_2_size = vo_2e_size + D_23_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(2.3841864e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(2.3841864e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(2.3841864e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = KSL_MULF(D->m00, p_0), vo_0b = KSL_MULF(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(D->m01, p_0), vo_1b = KSL_MULF(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(D->m02, p_0), vo_2b = KSL_MULF(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  const float D_00_abs = fabsf(D->m00), p_0_abs = fabsf(p_0),
      vo_0a_size = KSL_MULF(D_00_abs, p_0_abs), D_10_abs = fabsf(D->m10), p_1_abs = fabsf(p_1),
      vo_0b_size = KSL_MULF(D_10_abs, p_1_abs), vo_0c_size = vo_0a_size + vo_0b_size,
      D_20_abs = fabsf(D->m20), p_2_abs = fabsf(p_2), vo_0d_size = KSL_MULF(D_20_abs, p_2_abs),
      vo_0_size = vo_0c_size + vo_0d_size;
  const float D_01_abs = fabsf(D->m01), vo_1a_size = KSL_MULF(D_01_abs, p_0_abs),
      D_11_abs = fabsf(D->m11), vo_1b_size = KSL_MULF(D_11_abs, p_1_abs),
      vo_1c_size = vo_1a_size + vo_1b_size, D_21_abs = fabsf(D->m21),
      vo_1d_size = KSL_MULF(D_21_abs, p_2_abs), vo_1_size = vo_1c_size + vo_1d_size;
  const float D_02_abs = fabsf(D->m02), vo_2a_size = KSL_MULF(D_02_abs, p_0_abs),
      D_12_abs = fabsf(D->m12), vo_2b_size = KSL_MULF(D_12_abs, p_1_abs),
      vo_2c_size = vo_2a_size + vo_2b_size, D_22_abs = fabsf(D->m22),
      vo_2d_size = KSL_MULF(D_22_abs, p_2_abs), vo_2_size = vo_2c_size + vo_2d_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(2.3841864e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(2.3841864e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(2.3841864e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrf_certified(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m02, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m02, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m01, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m12, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m12, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m01), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m02), Ro_22b = KSL_MULF(R1->m21, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinvf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m01),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m02, R2->m02), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m10), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m02, R2->m12), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m20), Ro_02b = KSL_MULF(R1->m01, R2->m21),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m01),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m12, R2->m02), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m10), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m12, R2->m12), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m20), Ro_12b = KSL_MULF(R1->m11, R2->m21),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m01),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m02), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m10), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m12), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m20), Ro_22b = KSL_MULF(R1->m21, R2->m21),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdrf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m10, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m20, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m10, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m20, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m10, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m20, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m01, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m21, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m01, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m21, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m01, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m21, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m02, R2->m00), Ro_20b = KSL_MULF(R1->m12, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m02, R2->m01), Ro_21b = KSL_MULF(R1->m12, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m02, R2->m02), Ro_22b = KSL_MULF(R1->m12, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_ddf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m01, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D1->m02, D2->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m01, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D1->m02, D2->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m01, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D1->m02, D2->m22), Do_02 = Do_02c + Do_02d;
  const float Do_03a = KSL_MULF(D1->m00, D2->m03), Do_03b = KSL_MULF(D1->m01, D2->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D1->m02, D2->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D1->m03;
  const float Do_10a = KSL_MULF(D1->m10, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D1->m12, D2->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D1->m10, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D1->m12, D2->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D1->m10, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D1->m12, D2->m22), Do_12 = Do_12c + Do_12d;
  const float Do_13a = KSL_MULF(D1->m10, D2->m03), Do_13b = KSL_MULF(D1->m11, D2->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D1->m12, D2->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D1->m13;
  const float Do_20a = KSL_MULF(D1->m20, D2->m00), Do_20b = KSL_MULF(D1->m21, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D1->m20, D2->m01), Do_21b = KSL_MULF(D1->m21, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D1->m20, D2->m02), Do_22b = KSL_MULF(D1->m21, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const float Do_23a = KSL_MULF(D1->m20, D2->m03), Do_23b = KSL_MULF(D1->m21, D2->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D1->m22, D2->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D1->m23;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D1_03_abs = fabsf(D1->m03),
      Do_03_size = Do_03e_size + D1_03_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D1_13_abs = fabsf(D1->m13),
      Do_13_size = Do_13e_size + D1_13_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D1_23_abs = fabsf(D1->m23),
      Do_23_size = Do_23e_size + D1_23_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinvf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float R_0a = KSL_MULF(D1->m00, D2->m00), R_0b = KSL_MULF(D1->m01, D2->m01),
      R_0c = R_0a + R_0b, R_0d = KSL_MULF(D1->m02, D2->m02), R_0 = R_0c + R_0d;
  const float R_1a = KSL_MULF(D1->m00, D2->m10), R_1b = KSL_MULF(D1->m01, D2->m11),
      R_1c = R_1a + R_1b, R_1d = KSL_MULF(D1->m02, D2->m12), R_1 = R_1c + R_1d;
  const float R_2a = KSL_MULF(D1->m00, D2->m20), R_2b = KSL_MULF(D1->m01, D2->m21),
      R_2c = R_2a + R_2b, R_2d = KSL_MULF(D1->m02, D2->m22), R_2 = R_2c + R_2d;
  const float R_3a = KSL_MULF(D1->m10, D2->m00), R_3b = KSL_MULF(D1->m11, D2->m01),
      R_3c = R_3a + R_3b, R_3d = KSL_MULF(D1->m12, D2->m02), R_3 = R_3c + R_3d;
  const float R_4a = KSL_MULF(D1->m10, D2->m10), R_4b = KSL_MULF(D1->m11, D2->m11),
      R_4c = R_4a + R_4b, R_4d = KSL_MULF(D1->m12, D2->m12), R_4 = R_4c + R_4d;
  const float R_5a = KSL_MULF(D1->m10, D2->m20), R_5b = KSL_MULF(D1->m11, D2->m21),
      R_5c = R_5a + R_5b, R_5d = KSL_MULF(D1->m12, D2->m22), R_5 = R_5c + R_5d;
  const float R_6a = KSL_MULF(D1->m20, D2->m00), R_6b = KSL_MULF(D1->m21, D2->m01),
      R_6c = R_6a + R_6b, R_6d = KSL_MULF(D1->m22, D2->m02), R_6 = R_6c + R_6d;
  const float R_7a = KSL_MULF(D1->m20, D2->m10), R_7b = KSL_MULF(D1->m21, D2->m11),
      R_7c = R_7a + R_7b, R_7d = KSL_MULF(D1->m22, D2->m12), R_7 = R_7c + R_7d;
  const float R_8a = KSL_MULF(D1->m20, D2->m20), R_8b = KSL_MULF(D1->m21, D2->m21),
      R_8c = R_8a + R_8b, R_8d = KSL_MULF(D1->m22, D2->m22), R_8 = R_8c + R_8d;
  const float Do_03a = KSL_MULF(D2->m03, R_0), Do_03b = KSL_MULF(D2->m13, R_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D2->m23, R_2), Do_03e = Do_03c + Do_03d,
      Do_03 = D1->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D2->m03, R_3), Do_13b = KSL_MULF(D2->m13, R_4),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D2->m23, R_5), Do_13e = Do_13c + Do_13d,
      Do_13 = D1->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D2->m03, R_6), Do_23b = KSL_MULF(D2->m13, R_7),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D2->m23, R_8), Do_23e = Do_23c + Do_23d,
      Do_23 = D1->m23 - Do_23e;
  const float R_0a_abs = fabsf(R_0a), R_0b_abs = fabsf(R_0b), R_0c_size = R_0a_abs + R_0b_abs,
      R_0d_abs = fabsf(R_0d), R_0_size = R_0c_size + R_0d_abs;
  const float R_1a_abs = fabsf(R_1a), R_1b_abs = fabsf(R_1b), R_1c_size = R_1a_abs + R_1b_abs,
      R_1d_abs = fabsf(R_1d), R_1_size = R_1c_size + R_1d_abs;
  const float R_2a_abs = fabsf(R_2a), R_2b_abs = fabsf(R_2b), R_2c_size = R_2a_abs + R_2b_abs,
      R_2d_abs = fabsf(R_2d), R_2_size = R_2c_size + R_2d_abs;
  const float R_3a_abs = fabsf(R_3a), R_3b_abs = fabsf(R_3b), R_3c_size = R_3a_abs + R_3b_abs,
      R_3d_abs = fabsf(R_3d), R_3_size = R_3c_size + R_3d_abs;
  const float R_4a_abs = fabsf(R_4a), R_4b_abs = fabsf(R_4b), R_4c_size = R_4a_abs + R_4b_abs,
      R_4d_abs = fabsf(R_4d), R_4_size = R_4c_size + R_4d_abs;
  const float R_5a_abs = fabsf(R_5a), R_5b_abs = fabsf(R_5b), R_5c_size = R_5a_abs + R_5b_abs,
      R_5d_abs = fabsf(R_5d), R_5_size = R_5c_size + R_5d_abs;
  const float R_6a_abs = fabsf(R_6a), R_6b_abs = fabsf(R_6b), R_6c_size = R_6a_abs + R_6b_abs,
      R_6d_abs = fabsf(R_6d), R_6_size = R_6c_size + R_6d_abs;
  const float R_7a_abs = fabsf(R_7a), R_7b_abs = fabsf(R_7b), R_7c_size = R_7a_abs + R_7b_abs,
      R_7d_abs = fabsf(R_7d), R_7_size = R_7c_size + R_7d_abs;
  const float R_8a_abs = fabsf(R_8a), R_8b_abs = fabsf(R_8b), R_8c_size = R_8a_abs + R_8b_abs,
      R_8d_abs = fabsf(R_8d), R_8_size = R_8c_size + R_8d_abs;
  const float R_0_padded = R_0_size + 1.9721523e-31f;
  const float D2_03_abs = fabsf(D2->m03), Do_03a_size = KSL_MULF(D2_03_abs, R_0_padded);
  const float R_1_padded = R_1_size + 1.9721523e-31f;
  const float D2_13_abs = fabsf(D2->m13), Do_03b_size = KSL_MULF(D2_13_abs, R_1_padded),
      Do_03c_size = Do_03a_size + Do_03b_size;
  const float R_2_padded = R_2_size + 1.9721523e-31f;
  const float D2_23_abs = fabsf(D2->m23), Do_03d_size = KSL_MULF(D2_23_abs, R_2_padded),
      Do_03e_size = Do_03c_size + Do_03d_size, D1_03_abs = fabsf(D1->m03),
      Do_03_size = D1_03_abs + Do_03e_size;
  const float R_3_padded = R_3_size + 1.9721523e-31f;
  const float Do_13a_size = KSL_MULF(D2_03_abs, R_3_padded);
  const float R_4_padded = R_4_size + 1.9721523e-31f;
  const float Do_13b_size = KSL_MULF(D2_13_abs, R_4_padded),
      Do_13c_size = Do_13a_size + Do_13b_size;
  const float R_5_padded = R_5_size + 1.9721523e-31f;
  const float Do_13d_size = KSL_MULF(D2_23_abs, R_5_padded),
      Do_13e_size = Do_13c_size + Do_13d_size, D1_13_abs = fabsf(D1->m13),
      Do_13_size = D1_13_abs + Do_13e_size;
  const float R_6_padded = R_6_size + 1.9721523e-31f;
  const float Do_23a_size = KSL_MULF(D2_03_abs, R_6_padded);
  const float R_7_padded = R_7_size + 1.9721523e-31f;
  const float Do_23b_size = KSL_MULF(D2_13_abs, R_7_padded),
      Do_23c_size = Do_23a_size + Do_23b_size;
  const float R_8_padded = R_8_size + 1.9721523e-31f;
  const float Do_23d_size = KSL_MULF(D2_23_abs, R_8_padded),
      Do_23e_size = Do_23c_size + Do_23d_size, D1_23_abs = fabsf(D1->m23),
      Do_23_size = D1_23_abs + Do_23e_size;
  const float R_0_error_bound = KSL_MULF(1.7881396e-07f, R_0_padded);
  const float R_1_error_bound = KSL_MULF(1.7881396e-07f, R_1_padded);
  const float R_2_error_bound = KSL_MULF(1.7881396e-07f, R_2_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(4.1723263e-07f, Do_03_padded);
  const float R_3_error_bound = KSL_MULF(1.7881396e-07f, R_3_padded);
  const float R_4_error_bound = KSL_MULF(1.7881396e-07f, R_4_padded);
  const float R_5_error_bound = KSL_MULF(1.7881396e-07f, R_5_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(4.1723263e-07f, Do_13_padded);
  const float R_6_error_bound = KSL_MULF(1.7881396e-07f, R_6_padded);
  const float R_7_error_bound = KSL_MULF(1.7881396e-07f, R_7_padded);
  const float R_8_error_bound = KSL_MULF(1.7881396e-07f, R_8_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(4.1723263e-07f, Do_23_padded);
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
  Do_bound->m00 = R_0_error_bound;
  Do_bound->m01 = R_1_error_bound;
  Do_bound->m02 = R_2_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = R_3_error_bound;
  Do_bound->m11 = R_4_error_bound;
  Do_bound->m12 = R_5_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = R_6_error_bound;
  Do_bound->m21 = R_7_error_bound;
  Do_bound->m22 = R_8_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvdf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m10, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D1->m20, D2->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m10, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D1->m20, D2->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m10, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D1->m20, D2->m22), Do_02 = Do_02c + Do_02d;
  const float Do_03a = KSL_MULF(D1->m00, p_0), Do_03b = KSL_MULF(D1->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D1->m20, p_2), Do_03 = Do_03c + Do_03d;
  const float Do_10a = KSL_MULF(D1->m01, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D1->m21, D2->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D1->m01, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D1->m21, D2->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D1->m01, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D1->m21, D2->m22), Do_12 = Do_12c + Do_12d;
  const float Do_13a = KSL_MULF(D1->m01, p_0), Do_13b = KSL_MULF(D1->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D1->m21, p_2), Do_13 = Do_13c + Do_13d;
  const float Do_20a = KSL_MULF(D1->m02, D2->m00), Do_20b = KSL_MULF(D1->m12, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D1->m02, D2->m01), Do_21b = KSL_MULF(D1->m12, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D1->m02, D2->m02), Do_22b = KSL_MULF(D1->m12, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const float Do_23a = KSL_MULF(D1->m02, p_0), Do_23b = KSL_MULF(D1->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D1->m22, p_2), Do_23 = Do_23c + Do_23d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float D1_00_abs = fabsf(D1->m00), p_0_abs = fabsf(p_0),
      Do_03a_size = KSL_MULF(D1_00_abs, p_0_abs), D1_10_abs = fabsf(D1->m10), p_1_abs = fabsf(p_1),
      Do_03b_size = KSL_MULF(D1_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D1_20_abs = fabsf(D1->m20), p_2_abs = fabsf(p_2), Do_03d_size = KSL_MULF(D1_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float D1_01_abs = fabsf(D1->m01), Do_13a_size = KSL_MULF(D1_01_abs, p_0_abs),
      D1_11_abs = fabsf(D1->m11), Do_13b_size = KSL_MULF(D1_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D1_21_abs = fabsf(D1->m21),
      Do_13d_size = KSL_MULF(D1_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float D1_02_abs = fabsf(D1->m02), Do_23a_size = KSL_MULF(D1_02_abs, p_0_abs),
      D1_12_abs = fabsf(D1->m12), Do_23b_size = KSL_MULF(D1_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D1_22_abs = fabsf(D1->m22),
      Do_23d_size = KSL_MULF(D1_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D->m02, R->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m01), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D->m02, R->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m02), Do_02b = KSL_MULF(D->m01, R->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D->m12, R->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m01), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D->m12, R->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m02), Do_12b = KSL_MULF(D->m11, R->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D->m22, R->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m01), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D->m22, R->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m02), Do_22b = KSL_MULF(D->m21, R->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinvf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m01),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D->m02, R->m02), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m10), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D->m02, R->m12), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m20), Do_02b = KSL_MULF(D->m01, R->m21),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m01),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D->m12, R->m02), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m10), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D->m12, R->m12), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m20), Do_12b = KSL_MULF(D->m11, R->m21),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m01),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D->m22, R->m02), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m10), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D->m22, R->m12), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m20), Do_22b = KSL_MULF(D->m21, R->m21),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03e_size + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13e_size + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23e_size + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabsf(D->m03),
      Do_03_size = D_03_abs + Do_03e_size;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabsf(D->m13),
      Do_13_size = D_13_abs + Do_13e_size;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabsf(D->m23),
      Do_23_size = D_23_abs + Do_23e_size;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = KSL_MULF(D->m00, p_0), Do_03b = KSL_MULF(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const float Do_13a = KSL_MULF(D->m01, p_0), Do_13b = KSL_MULF(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const float Do_23a = KSL_MULF(D->m02, p_0), Do_23b = KSL_MULF(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, p_2), Do_23 = Do_23c + Do_23d;
  const float D_00_abs = fabsf(D->m00), p_0_abs = fabsf(p_0),
      Do_03a_size = KSL_MULF(D_00_abs, p_0_abs), D_10_abs = fabsf(D->m10), p_1_abs = fabsf(p_1),
      Do_03b_size = KSL_MULF(D_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D_20_abs = fabsf(D->m20), p_2_abs = fabsf(p_2), Do_03d_size = KSL_MULF(D_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const float D_01_abs = fabsf(D->m01), Do_13a_size = KSL_MULF(D_01_abs, p_0_abs),
      D_11_abs = fabsf(D->m11), Do_13b_size = KSL_MULF(D_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D_21_abs = fabsf(D->m21),
      Do_13d_size = KSL_MULF(D_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const float D_02_abs = fabsf(D->m02), Do_23a_size = KSL_MULF(D_02_abs, p_0_abs),
      D_12_abs = fabsf(D->m12), Do_23b_size = KSL_MULF(D_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D_22_abs = fabsf(D->m22),
      Do_23d_size = KSL_MULF(D_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtxf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m00, k);
  const float vo_1 = KSL_MULF(R->m10, k);
  const float vo_2 = KSL_MULF(R->m20, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m02, dc[0]),
      Ro_01 = Ro_01a + Ro_01b;
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02b = KSL_MULF(R->m01, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m12, dc[0]),
      Ro_11 = Ro_11a + Ro_11b;
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12b = KSL_MULF(R->m11, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m22, dc[0]),
      Ro_21 = Ro_21a + Ro_21b;
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22b = KSL_MULF(R->m21, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = 0.0f;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m02, dc[0]),
      Do_01 = Do_01a + Do_01b;
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02b = KSL_MULF(D->m01, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m12, dc[0]),
      Do_11 = Do_11a + Do_11b;
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12b = KSL_MULF(D->m11, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m22, dc[0]),
      Do_21 = Do_21a + Do_21b;
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22b = KSL_MULF(D->m21, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = Do_23a + D->m23;
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m02, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const float Ro_02a = KSL_MULF(R->m01, dc[0]), Ro_02b = KSL_MULF(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m12, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const float Ro_12a = KSL_MULF(R->m11, dc[0]), Ro_12b = KSL_MULF(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m22, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const float Ro_22a = KSL_MULF(R->m21, dc[0]), Ro_22b = KSL_MULF(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = 0.0f;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m02, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const float Do_02a = KSL_MULF(D->m01, dc[0]), Do_02b = KSL_MULF(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m12, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const float Do_12a = KSL_MULF(D->m11, dc[0]), Do_12b = KSL_MULF(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m22, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const float Do_22a = KSL_MULF(D->m21, dc[0]), Do_22b = KSL_MULF(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = D->m23 - Do_23a;
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtyf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m01, k);
  const float vo_1 = KSL_MULF(R->m11, k);
  const float vo_2 = KSL_MULF(R->m21, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m02, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const float Ro_02a = KSL_MULF(R->m00, dc[0]), Ro_02b = KSL_MULF(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m12, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const float Ro_12a = KSL_MULF(R->m10, dc[0]), Ro_12b = KSL_MULF(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m22, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const float Ro_22a = KSL_MULF(R->m20, dc[0]), Ro_22b = KSL_MULF(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m02, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const float Do_02a = KSL_MULF(D->m00, dc[0]), Do_02b = KSL_MULF(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m12, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const float Do_12a = KSL_MULF(D->m10, dc[0]), Do_12b = KSL_MULF(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m22, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const float Do_22a = KSL_MULF(D->m20, dc[0]), Do_22b = KSL_MULF(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = Do_23a + D->m23;
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m02, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02b = KSL_MULF(R->m00, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m12, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12b = KSL_MULF(R->m10, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m22, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22b = KSL_MULF(R->m20, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m02, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02b = KSL_MULF(D->m00, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m12, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12b = KSL_MULF(D->m10, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m22, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22b = KSL_MULF(D->m20, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = D->m23 - Do_23a;
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtzf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m02, k);
  const float vo_1 = KSL_MULF(R->m12, k);
  const float vo_2 = KSL_MULF(R->m22, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m01, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m00, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m11, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m10, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m21, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m20, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = 0.0f;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m01, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m00, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m11, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m10, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m21, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m20, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = Do_23a + D->m23;
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m01, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const float Ro_01a = KSL_MULF(R->m00, dc[0]), Ro_01b = KSL_MULF(R->m01, dc[1]),
      Ro_01 = Ro_01a + Ro_01b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m11, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const float Ro_11a = KSL_MULF(R->m10, dc[0]), Ro_11b = KSL_MULF(R->m11, dc[1]),
      Ro_11 = Ro_11a + Ro_11b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m21, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const float Ro_21a = KSL_MULF(R->m20, dc[0]), Ro_21b = KSL_MULF(R->m21, dc[1]),
      Ro_21 = Ro_21a + Ro_21b;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = 0.0f;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m01, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const float Do_01a = KSL_MULF(D->m00, dc[0]), Do_01b = KSL_MULF(D->m01, dc[1]),
      Do_01 = Do_01a + Do_01b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m11, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const float Do_11a = KSL_MULF(D->m10, dc[0]), Do_11b = KSL_MULF(D->m11, dc[1]),
      Do_11 = Do_11a + Do_11b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m21, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const float Do_21a = KSL_MULF(D->m20, dc[0]), Do_21b = KSL_MULF(D->m21, dc[1]),
      Do_21 = Do_21a + Do_21b;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = D->m23 - Do_23a;
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

#endif

/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_SCREW_CERTIFIED_H
#define KSL_SCREW_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: screw (v in m/s; ω in rad/s); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_screw_scale_certified(ksl_screw_t *self, const double a,
    ksl_screw_t *self_bound) {
  const double self_0_new = KSL_MUL(self->m0, a);
  const double self_1_new = KSL_MUL(self->m1, a);
  const double self_2_new = KSL_MUL(self->m2, a);
  const double self_3_new = KSL_MUL(self->m3, a);
  const double self_4_new = KSL_MUL(self->m4, a);
  const double self_5_new = KSL_MUL(self->m5, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  const double self_4_new_abs = fabs(self_4_new),
      self_4_new_padded = self_4_new_abs + 2.004168360008973e-292,
      self_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_4_new_padded);
  const double self_5_new_abs = fabs(self_5_new),
      self_5_new_padded = self_5_new_abs + 2.004168360008973e-292,
      self_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_5_new_padded);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_error_bound;
  self_bound->m1 = self_1_new_error_bound;
  self_bound->m2 = self_2_new_error_bound;
  self_bound->m3 = self_3_new_error_bound;
  self_bound->m4 = self_4_new_error_bound;
  self_bound->m5 = self_5_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ss_certified(const double a, const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = KSL_MUL(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = KSL_MUL(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = KSL_MUL(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = KSL_MUL(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = KSL_MUL(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const double y_0_new_a_abs = fabs(y_0_new_a), y_0_abs = fabs(y->m0),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const double y_1_new_a_abs = fabs(y_1_new_a), y_1_abs = fabs(y->m1),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const double y_2_new_a_abs = fabs(y_2_new_a), y_2_abs = fabs(y->m2),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const double y_3_new_a_abs = fabs(y_3_new_a), y_3_abs = fabs(y->m3),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const double y_4_new_a_abs = fabs(y_4_new_a), y_4_abs = fabs(y->m4),
      y_4_new_size = y_4_new_a_abs + y_4_abs;
  const double y_5_new_a_abs = fabs(y_5_new_a), y_5_abs = fabs(y->m5),
      y_5_new_size = y_5_new_a_abs + y_5_abs;
  const double y_0_new_padded = y_0_new_size + 2.004168360008973e-292,
      y_0_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_padded);
  const double y_1_new_padded = y_1_new_size + 2.004168360008973e-292,
      y_1_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_padded);
  const double y_2_new_padded = y_2_new_size + 2.004168360008973e-292,
      y_2_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_padded);
  const double y_3_new_padded = y_3_new_size + 2.004168360008973e-292,
      y_3_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_3_new_padded);
  const double y_4_new_padded = y_4_new_size + 2.004168360008973e-292,
      y_4_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_4_new_padded);
  const double y_5_new_padded = y_5_new_size + 2.004168360008973e-292,
      y_5_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_5_new_padded);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ss_certified(const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new = x->m0 + y->m0;
  const double y_1_new = x->m1 + y->m1;
  const double y_2_new = x->m2 + y->m2;
  const double y_3_new = x->m3 + y->m3;
  const double y_4_new = x->m4 + y->m4;
  const double y_5_new = x->m5 + y->m5;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  const double y_3_new_abs = fabs(y_3_new),
      y_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_3_new_abs);
  const double y_4_new_abs = fabs(y_4_new),
      y_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_4_new_abs);
  const double y_5_new_abs = fabs(y_5_new),
      y_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ss_certified(const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new = y->m0 - x->m0;
  const double y_1_new = y->m1 - x->m1;
  const double y_2_new = y->m2 - x->m2;
  const double y_3_new = y->m3 - x->m3;
  const double y_4_new = y->m4 - x->m4;
  const double y_5_new = y->m5 - x->m5;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  const double y_3_new_abs = fabs(y_3_new),
      y_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_3_new_abs);
  const double y_4_new_abs = fabs(y_4_new),
      y_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_4_new_abs);
  const double y_5_new_abs = fabs(y_5_new),
      y_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* so = a si; |error of so| <= so_bound unless inf or NaN.
   a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_as_certified(const double a, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = KSL_MUL(a, si->m0);
  const double so_1 = KSL_MUL(a, si->m1);
  const double so_2 = KSL_MUL(a, si->m2);
  const double so_3 = KSL_MUL(a, si->m3);
  const double so_4 = KSL_MUL(a, si->m4);
  const double so_5 = KSL_MUL(a, si->m5);
  const double so_0_abs = fabs(so_0), so_0_padded = so_0_abs + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(1.1102230246251568e-16, so_0_padded);
  const double so_1_abs = fabs(so_1), so_1_padded = so_1_abs + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(1.1102230246251568e-16, so_1_padded);
  const double so_2_abs = fabs(so_2), so_2_padded = so_2_abs + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(1.1102230246251568e-16, so_2_padded);
  const double so_3_abs = fabs(so_3), so_3_padded = so_3_abs + 2.004168360008973e-292,
      so_3_error_bound = KSL_MUL(1.1102230246251568e-16, so_3_padded);
  const double so_4_abs = fabs(so_4), so_4_padded = so_4_abs + 2.004168360008973e-292,
      so_4_error_bound = KSL_MUL(1.1102230246251568e-16, so_4_padded);
  const double so_5_abs = fabs(so_5), so_5_padded = so_5_abs + 2.004168360008973e-292,
      so_5_error_bound = KSL_MUL(1.1102230246251568e-16, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = s1 + s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double so_3 = s1->m3 + s2->m3;
  const double so_4 = s1->m4 + s2->m4;
  const double so_5 = s1->m5 + s2->m5;
  const double so_0_abs = fabs(so_0), so_0_error_bound = KSL_MUL(1.1102230246251568e-16, so_0_abs);
  const double so_1_abs = fabs(so_1), so_1_error_bound = KSL_MUL(1.1102230246251568e-16, so_1_abs);
  const double so_2_abs = fabs(so_2), so_2_error_bound = KSL_MUL(1.1102230246251568e-16, so_2_abs);
  const double so_3_abs = fabs(so_3), so_3_error_bound = KSL_MUL(1.1102230246251568e-16, so_3_abs);
  const double so_4_abs = fabs(so_4), so_4_error_bound = KSL_MUL(1.1102230246251568e-16, so_4_abs);
  const double so_5_abs = fabs(so_5), so_5_error_bound = KSL_MUL(1.1102230246251568e-16, so_5_abs);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = s1 - s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 - s2->m0;
  const double so_1 = s1->m1 - s2->m1;
  const double so_2 = s1->m2 - s2->m2;
  const double so_3 = s1->m3 - s2->m3;
  const double so_4 = s1->m4 - s2->m4;
  const double so_5 = s1->m5 - s2->m5;
  const double so_0_abs = fabs(so_0), so_0_error_bound = KSL_MUL(1.1102230246251568e-16, so_0_abs);
  const double so_1_abs = fabs(so_1), so_1_error_bound = KSL_MUL(1.1102230246251568e-16, so_1_abs);
  const double so_2_abs = fabs(so_2), so_2_error_bound = KSL_MUL(1.1102230246251568e-16, so_2_abs);
  const double so_3_abs = fabs(so_3), so_3_error_bound = KSL_MUL(1.1102230246251568e-16, so_3_abs);
  const double so_4_abs = fabs(so_4), so_4_error_bound = KSL_MUL(1.1102230246251568e-16, so_4_abs);
  const double so_5_abs = fabs(so_5), so_5_error_bound = KSL_MUL(1.1102230246251568e-16, so_5_abs);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_sst_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double so_0_abs = fabs(so_0), so_0_error_bound = KSL_MUL(1.1102230246251568e-16, so_0_abs);
  const double so_1_abs = fabs(so_1), so_1_error_bound = KSL_MUL(1.1102230246251568e-16, so_1_abs);
  const double so_2_abs = fabs(so_2), so_2_error_bound = KSL_MUL(1.1102230246251568e-16, so_2_abs);
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adts_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->y, si->m5), so_0b = KSL_MUL(t->z, si->m4), so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = KSL_MUL(t->z, si->m3), so_1b = KSL_MUL(t->x, si->m5), so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = KSL_MUL(t->x, si->m4), so_2b = KSL_MUL(t->y, si->m3), so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      si_0_abs = fabs(si->m0), so_0_size = so_0c_size + si_0_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      si_1_abs = fabs(si->m1), so_1_size = so_1c_size + si_1_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      si_2_abs = fabs(si->m2), so_2_size = so_2c_size + si_2_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtinvs_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      si_0_abs = fabs(si->m0), so_0_size = so_0c_size + si_0_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      si_1_abs = fabs(si->m1), so_1_size = so_1c_size + si_1_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      si_2_abs = fabs(si->m2), so_2_size = so_2c_size + si_2_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_Adtsinv_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2 = so_2c - si->m2;
  const double so_3 = -si->m3;
  const double so_4 = -si->m4;
  const double so_5 = -si->m5;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      si_0_abs = fabs(si->m0), so_0_size = so_0c_size + si_0_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      si_1_abs = fabs(si->m1), so_1_size = so_1c_size + si_1_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      si_2_abs = fabs(si->m2), so_2_size = so_2c_size + si_2_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrs_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MUL(R->m02, si->m2), so_0 = so_0c + so_0d;
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MUL(R->m12, si->m2), so_1 = so_1c + so_1d;
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MUL(R->m22, si->m2), so_2 = so_2c + so_2d;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MUL(R->m02, si->m5), so_3 = so_3c + so_3d;
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MUL(R->m12, si->m5), so_4 = so_4c + so_4d;
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MUL(R->m22, si->m5), so_5 = so_5c + so_5d;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0_size = so_0c_size + so_0d_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1_size = so_1c_size + so_1d_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2_size = so_2c_size + so_2d_abs;
  const double so_3a_abs = fabs(so_3a), so_3b_abs = fabs(so_3b), so_3c_size = so_3a_abs + so_3b_abs,
      so_3d_abs = fabs(so_3d), so_3_size = so_3c_size + so_3d_abs;
  const double so_4a_abs = fabs(so_4a), so_4b_abs = fabs(so_4b), so_4c_size = so_4a_abs + so_4b_abs,
      so_4d_abs = fabs(so_4d), so_4_size = so_4c_size + so_4d_abs;
  const double so_5a_abs = fabs(so_5a), so_5b_abs = fabs(so_5b), so_5c_size = so_5a_abs + so_5b_abs,
      so_5d_abs = fabs(so_5d), so_5_size = so_5c_size + so_5d_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  const double so_3_padded = so_3_size + 2.004168360008973e-292,
      so_3_error_bound = KSL_MUL(3.3306690738754706e-16, so_3_padded);
  const double so_4_padded = so_4_size + 2.004168360008973e-292,
      so_4_error_bound = KSL_MUL(3.3306690738754706e-16, so_4_padded);
  const double so_5_padded = so_5_size + 2.004168360008973e-292,
      so_5_error_bound = KSL_MUL(3.3306690738754706e-16, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrinvs_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m10, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MUL(R->m20, si->m2), so_0 = so_0c + so_0d;
  const double so_1a = KSL_MUL(R->m01, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MUL(R->m21, si->m2), so_1 = so_1c + so_1d;
  const double so_2a = KSL_MUL(R->m02, si->m0), so_2b = KSL_MUL(R->m12, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MUL(R->m22, si->m2), so_2 = so_2c + so_2d;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m10, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MUL(R->m20, si->m5), so_3 = so_3c + so_3d;
  const double so_4a = KSL_MUL(R->m01, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MUL(R->m21, si->m5), so_4 = so_4c + so_4d;
  const double so_5a = KSL_MUL(R->m02, si->m3), so_5b = KSL_MUL(R->m12, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MUL(R->m22, si->m5), so_5 = so_5c + so_5d;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0_size = so_0c_size + so_0d_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1_size = so_1c_size + so_1d_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2_size = so_2c_size + so_2d_abs;
  const double so_3a_abs = fabs(so_3a), so_3b_abs = fabs(so_3b), so_3c_size = so_3a_abs + so_3b_abs,
      so_3d_abs = fabs(so_3d), so_3_size = so_3c_size + so_3d_abs;
  const double so_4a_abs = fabs(so_4a), so_4b_abs = fabs(so_4b), so_4c_size = so_4a_abs + so_4b_abs,
      so_4d_abs = fabs(so_4d), so_4_size = so_4c_size + so_4d_abs;
  const double so_5a_abs = fabs(so_5a), so_5b_abs = fabs(so_5b), so_5c_size = so_5a_abs + so_5b_abs,
      so_5d_abs = fabs(so_5d), so_5_size = so_5c_size + so_5d_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  const double so_3_padded = so_3_size + 2.004168360008973e-292,
      so_3_error_bound = KSL_MUL(3.3306690738754706e-16, so_3_padded);
  const double so_4_padded = so_4_size + 2.004168360008973e-292,
      so_4_error_bound = KSL_MUL(3.3306690738754706e-16, so_4_padded);
  const double so_5_padded = so_5_size + 2.004168360008973e-292,
      so_5_error_bound = KSL_MUL(3.3306690738754706e-16, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_Adrsinv_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MUL(R->m02, si->m2), so_0e = so_0c + so_0d, so_0 = -so_0e;
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MUL(R->m12, si->m2), so_1e = so_1c + so_1d, so_1 = -so_1e;
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MUL(R->m22, si->m2), so_2e = so_2c + so_2d, so_2 = -so_2e;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MUL(R->m02, si->m5), so_3e = so_3c + so_3d, so_3 = -so_3e;
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MUL(R->m12, si->m5), so_4e = so_4c + so_4d, so_4 = -so_4e;
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MUL(R->m22, si->m5), so_5e = so_5c + so_5d, so_5 = -so_5e;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0e_size = so_0c_size + so_0d_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1e_size = so_1c_size + so_1d_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2e_size = so_2c_size + so_2d_abs;
  const double so_3a_abs = fabs(so_3a), so_3b_abs = fabs(so_3b), so_3c_size = so_3a_abs + so_3b_abs,
      so_3d_abs = fabs(so_3d), so_3e_size = so_3c_size + so_3d_abs;
  const double so_4a_abs = fabs(so_4a), so_4b_abs = fabs(so_4b), so_4c_size = so_4a_abs + so_4b_abs,
      so_4d_abs = fabs(so_4d), so_4e_size = so_4c_size + so_4d_abs;
  const double so_5a_abs = fabs(so_5a), so_5b_abs = fabs(so_5b), so_5c_size = so_5a_abs + so_5b_abs,
      so_5d_abs = fabs(so_5d), so_5e_size = so_5c_size + so_5d_abs;
  const double so_0e_padded = so_0e_size + 2.004168360008973e-292,
      so_0e_error_bound = KSL_MUL(3.3306690738754706e-16, so_0e_padded);
  const double so_1e_padded = so_1e_size + 2.004168360008973e-292,
      so_1e_error_bound = KSL_MUL(3.3306690738754706e-16, so_1e_padded);
  const double so_2e_padded = so_2e_size + 2.004168360008973e-292,
      so_2e_error_bound = KSL_MUL(3.3306690738754706e-16, so_2e_padded);
  const double so_3e_padded = so_3e_size + 2.004168360008973e-292,
      so_3e_error_bound = KSL_MUL(3.3306690738754706e-16, so_3e_padded);
  const double so_4e_padded = so_4e_size + 2.004168360008973e-292,
      so_4e_error_bound = KSL_MUL(3.3306690738754706e-16, so_4e_padded);
  const double so_5e_padded = so_5e_size + 2.004168360008973e-292,
      so_5e_error_bound = KSL_MUL(3.3306690738754706e-16, so_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0e_error_bound;
  so_bound->m1 = so_1e_error_bound;
  so_bound->m2 = so_2e_error_bound;
  so_bound->m3 = so_3e_error_bound;
  so_bound->m4 = so_4e_error_bound;
  so_bound->m5 = so_5e_error_bound;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_Ads_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, si->m2), w_0 = w_0c + w_0d;
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, si->m2), w_1 = w_1c + w_1d;
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, si->m2), w_2 = w_2c + w_2d;
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, si->m5), w_3 = w_3c + w_3d;
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, si->m5), w_4 = w_4c + w_4d;
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, si->m5), w_5 = w_5c + w_5d;
  const double so_0a = KSL_MUL(D->m13, w_5), so_0b = KSL_MUL(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = KSL_MUL(D->m23, w_3), so_1b = KSL_MUL(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = KSL_MUL(D->m03, w_4), so_2b = KSL_MUL(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const double w_5_padded = w_5_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), so_0a_size = KSL_MUL(D_13_abs, w_5_padded);
  const double w_4_padded = w_4_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), so_0b_size = KSL_MUL(D_23_abs, w_4_padded),
      so_0c_size = so_0a_size + so_0b_size, so_0_size = so_0c_size + w_0_size;
  const double w_3_padded = w_3_size + 2.004168360008973e-292;
  const double so_1a_size = KSL_MUL(D_23_abs, w_3_padded), D_03_abs = fabs(D->m03),
      so_1b_size = KSL_MUL(D_03_abs, w_5_padded), so_1c_size = so_1a_size + so_1b_size,
      so_1_size = so_1c_size + w_1_size;
  const double so_2a_size = KSL_MUL(D_03_abs, w_4_padded),
      so_2b_size = KSL_MUL(D_13_abs, w_3_padded), so_2c_size = so_2a_size + so_2b_size,
      so_2_size = so_2c_size + w_2_size;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(6.661338147750942e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(6.661338147750942e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(6.661338147750942e-16, so_2_padded);
  const double w_3_error_bound = KSL_MUL(3.3306690738754706e-16, w_3_padded);
  const double w_4_error_bound = KSL_MUL(3.3306690738754706e-16, w_4_padded);
  const double w_5_error_bound = KSL_MUL(3.3306690738754706e-16, w_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = w_3_error_bound;
  so_bound->m4 = w_4_error_bound;
  so_bound->m5 = w_5_error_bound;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_Adinvs_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m23, si->m4), w_0b = KSL_MUL(D->m13, si->m5), w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const double w_1a = KSL_MUL(D->m03, si->m5), w_1b = KSL_MUL(D->m23, si->m3), w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const double w_2a = KSL_MUL(D->m13, si->m3), w_2b = KSL_MUL(D->m03, si->m4), w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const double so_0a = KSL_MUL(D->m00, w_0), so_0b = KSL_MUL(D->m10, w_1), so_0c = so_0a + so_0b,
      so_0d = KSL_MUL(D->m20, w_2), so_0 = so_0c + so_0d;
  const double so_1a = KSL_MUL(D->m01, w_0), so_1b = KSL_MUL(D->m11, w_1), so_1c = so_1a + so_1b,
      so_1d = KSL_MUL(D->m21, w_2), so_1 = so_1c + so_1d;
  const double so_2a = KSL_MUL(D->m02, w_0), so_2b = KSL_MUL(D->m12, w_1), so_2c = so_2a + so_2b,
      so_2d = KSL_MUL(D->m22, w_2), so_2 = so_2c + so_2d;
  const double so_3a = KSL_MUL(D->m00, si->m3), so_3b = KSL_MUL(D->m10, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MUL(D->m20, si->m5), so_3 = so_3c + so_3d;
  const double so_4a = KSL_MUL(D->m01, si->m3), so_4b = KSL_MUL(D->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MUL(D->m21, si->m5), so_4 = so_4c + so_4d;
  const double so_5a = KSL_MUL(D->m02, si->m3), so_5b = KSL_MUL(D->m12, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MUL(D->m22, si->m5), so_5 = so_5c + so_5d;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      si_0_abs = fabs(si->m0), w_0_size = w_0c_size + si_0_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      si_1_abs = fabs(si->m1), w_1_size = w_1c_size + si_1_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      si_2_abs = fabs(si->m2), w_2_size = w_2c_size + si_2_abs;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_00_abs = fabs(D->m00), so_0a_size = KSL_MUL(D_00_abs, w_0_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10), so_0b_size = KSL_MUL(D_10_abs, w_1_padded),
      so_0c_size = so_0a_size + so_0b_size;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_20_abs = fabs(D->m20), so_0d_size = KSL_MUL(D_20_abs, w_2_padded),
      so_0_size = so_0c_size + so_0d_size;
  const double D_01_abs = fabs(D->m01), so_1a_size = KSL_MUL(D_01_abs, w_0_padded),
      D_11_abs = fabs(D->m11), so_1b_size = KSL_MUL(D_11_abs, w_1_padded),
      so_1c_size = so_1a_size + so_1b_size, D_21_abs = fabs(D->m21),
      so_1d_size = KSL_MUL(D_21_abs, w_2_padded), so_1_size = so_1c_size + so_1d_size;
  const double D_02_abs = fabs(D->m02), so_2a_size = KSL_MUL(D_02_abs, w_0_padded),
      D_12_abs = fabs(D->m12), so_2b_size = KSL_MUL(D_12_abs, w_1_padded),
      so_2c_size = so_2a_size + so_2b_size, D_22_abs = fabs(D->m22),
      so_2d_size = KSL_MUL(D_22_abs, w_2_padded), so_2_size = so_2c_size + so_2d_size;
  const double so_3a_abs = fabs(so_3a), so_3b_abs = fabs(so_3b), so_3c_size = so_3a_abs + so_3b_abs,
      so_3d_abs = fabs(so_3d), so_3_size = so_3c_size + so_3d_abs;
  const double so_4a_abs = fabs(so_4a), so_4b_abs = fabs(so_4b), so_4c_size = so_4a_abs + so_4b_abs,
      so_4d_abs = fabs(so_4d), so_4_size = so_4c_size + so_4d_abs;
  const double so_5a_abs = fabs(so_5a), so_5b_abs = fabs(so_5b), so_5c_size = so_5a_abs + so_5b_abs,
      so_5d_abs = fabs(so_5d), so_5_size = so_5c_size + so_5d_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(6.661338147750942e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(6.661338147750942e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(6.661338147750942e-16, so_2_padded);
  const double so_3_padded = so_3_size + 2.004168360008973e-292,
      so_3_error_bound = KSL_MUL(3.3306690738754706e-16, so_3_padded);
  const double so_4_padded = so_4_size + 2.004168360008973e-292,
      so_4_error_bound = KSL_MUL(3.3306690738754706e-16, so_4_padded);
  const double so_5_padded = so_5_size + 2.004168360008973e-292,
      so_5_error_bound = KSL_MUL(3.3306690738754706e-16, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_Adsinv_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, si->m2), w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, si->m2), w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, si->m2), w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, si->m5), w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, si->m5), w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, si->m5), w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double so_0a = KSL_MUL(D->m13, w_5), so_0b = KSL_MUL(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = KSL_MUL(D->m23, w_3), so_1b = KSL_MUL(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = KSL_MUL(D->m03, w_4), so_2b = KSL_MUL(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0e_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1e_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2e_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3e_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4e_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5e_size = w_5c_size + w_5d_abs;
  const double w_5e_padded = w_5e_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), so_0a_size = KSL_MUL(D_13_abs, w_5e_padded);
  const double w_4e_padded = w_4e_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), so_0b_size = KSL_MUL(D_23_abs, w_4e_padded),
      so_0c_size = so_0a_size + so_0b_size, so_0_size = so_0c_size + w_0e_size;
  const double w_3e_padded = w_3e_size + 2.004168360008973e-292;
  const double so_1a_size = KSL_MUL(D_23_abs, w_3e_padded), D_03_abs = fabs(D->m03),
      so_1b_size = KSL_MUL(D_03_abs, w_5e_padded), so_1c_size = so_1a_size + so_1b_size,
      so_1_size = so_1c_size + w_1e_size;
  const double so_2a_size = KSL_MUL(D_03_abs, w_4e_padded),
      so_2b_size = KSL_MUL(D_13_abs, w_3e_padded), so_2c_size = so_2a_size + so_2b_size,
      so_2_size = so_2c_size + w_2e_size;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(6.661338147750942e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(6.661338147750942e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(6.661338147750942e-16, so_2_padded);
  const double w_3e_error_bound = KSL_MUL(3.3306690738754706e-16, w_3e_padded);
  const double w_4e_error_bound = KSL_MUL(3.3306690738754706e-16, w_4e_padded);
  const double w_5e_error_bound = KSL_MUL(3.3306690738754706e-16, w_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = w_3e_error_bound;
  so_bound->m4 = w_4e_error_bound;
  so_bound->m5 = w_5e_error_bound;
}

/* so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrx_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m20, D->m13), so_0b = KSL_MUL(D->m10, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m00, D->m23), so_1b = KSL_MUL(D->m20, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m10, D->m03), so_2b = KSL_MUL(D->m00, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsry_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m21, D->m13), so_0b = KSL_MUL(D->m11, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m01, D->m23), so_1b = KSL_MUL(D->m21, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m11, D->m03), so_2b = KSL_MUL(D->m01, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrz_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m22, D->m13), so_0b = KSL_MUL(D->m12, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m02, D->m23), so_1b = KSL_MUL(D->m22, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m12, D->m03), so_2b = KSL_MUL(D->m02, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrxinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m10, D->m23), so_0b = KSL_MUL(D->m20, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m20, D->m03), so_1b = KSL_MUL(D->m00, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m00, D->m13), so_2b = KSL_MUL(D->m10, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m00;
  const double so_4 = -D->m10;
  const double so_5 = -D->m20;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsryinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m11, D->m23), so_0b = KSL_MUL(D->m21, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m21, D->m03), so_1b = KSL_MUL(D->m01, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m01, D->m13), so_2b = KSL_MUL(D->m11, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m01;
  const double so_4 = -D->m11;
  const double so_5 = -D->m21;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrzinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m12, D->m23), so_0b = KSL_MUL(D->m22, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m22, D->m03), so_1b = KSL_MUL(D->m02, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m02, D->m13), so_2b = KSL_MUL(D->m12, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m02;
  const double so_4 = -D->m12;
  const double so_5 = -D->m22;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* M = [Ad](D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_Ad_certified(const ksl_SE3_t *D, ksl_mat6x6_t *M, ksl_mat6x6_t *M_bound) {
  const double M_03a = KSL_MUL(D->m20, D->m13), M_03b = KSL_MUL(D->m10, D->m23),
      M_03 = M_03a - M_03b;
  const double M_04a = KSL_MUL(D->m21, D->m13), M_04b = KSL_MUL(D->m11, D->m23),
      M_04 = M_04a - M_04b;
  const double M_05a = KSL_MUL(D->m22, D->m13), M_05b = KSL_MUL(D->m12, D->m23),
      M_05 = M_05a - M_05b;
  const double M_13a = KSL_MUL(D->m00, D->m23), M_13b = KSL_MUL(D->m20, D->m03),
      M_13 = M_13a - M_13b;
  const double M_14a = KSL_MUL(D->m01, D->m23), M_14b = KSL_MUL(D->m21, D->m03),
      M_14 = M_14a - M_14b;
  const double M_15a = KSL_MUL(D->m02, D->m23), M_15b = KSL_MUL(D->m22, D->m03),
      M_15 = M_15a - M_15b;
  const double M_23a = KSL_MUL(D->m10, D->m03), M_23b = KSL_MUL(D->m00, D->m13),
      M_23 = M_23a - M_23b;
  const double M_24a = KSL_MUL(D->m11, D->m03), M_24b = KSL_MUL(D->m01, D->m13),
      M_24 = M_24a - M_24b;
  const double M_25a = KSL_MUL(D->m12, D->m03), M_25b = KSL_MUL(D->m02, D->m13),
      M_25 = M_25a - M_25b;
  const double M_03a_abs = fabs(M_03a), M_03b_abs = fabs(M_03b), M_03_size = M_03a_abs + M_03b_abs;
  const double M_04a_abs = fabs(M_04a), M_04b_abs = fabs(M_04b), M_04_size = M_04a_abs + M_04b_abs;
  const double M_05a_abs = fabs(M_05a), M_05b_abs = fabs(M_05b), M_05_size = M_05a_abs + M_05b_abs;
  const double M_13a_abs = fabs(M_13a), M_13b_abs = fabs(M_13b), M_13_size = M_13a_abs + M_13b_abs;
  const double M_14a_abs = fabs(M_14a), M_14b_abs = fabs(M_14b), M_14_size = M_14a_abs + M_14b_abs;
  const double M_15a_abs = fabs(M_15a), M_15b_abs = fabs(M_15b), M_15_size = M_15a_abs + M_15b_abs;
  const double M_23a_abs = fabs(M_23a), M_23b_abs = fabs(M_23b), M_23_size = M_23a_abs + M_23b_abs;
  const double M_24a_abs = fabs(M_24a), M_24b_abs = fabs(M_24b), M_24_size = M_24a_abs + M_24b_abs;
  const double M_25a_abs = fabs(M_25a), M_25b_abs = fabs(M_25b), M_25_size = M_25a_abs + M_25b_abs;
  const double M_03_padded = M_03_size + 2.004168360008973e-292,
      M_03_error_bound = KSL_MUL(2.2204460492503136e-16, M_03_padded);
  const double M_04_padded = M_04_size + 2.004168360008973e-292,
      M_04_error_bound = KSL_MUL(2.2204460492503136e-16, M_04_padded);
  const double M_05_padded = M_05_size + 2.004168360008973e-292,
      M_05_error_bound = KSL_MUL(2.2204460492503136e-16, M_05_padded);
  const double M_13_padded = M_13_size + 2.004168360008973e-292,
      M_13_error_bound = KSL_MUL(2.2204460492503136e-16, M_13_padded);
  const double M_14_padded = M_14_size + 2.004168360008973e-292,
      M_14_error_bound = KSL_MUL(2.2204460492503136e-16, M_14_padded);
  const double M_15_padded = M_15_size + 2.004168360008973e-292,
      M_15_error_bound = KSL_MUL(2.2204460492503136e-16, M_15_padded);
  const double M_23_padded = M_23_size + 2.004168360008973e-292,
      M_23_error_bound = KSL_MUL(2.2204460492503136e-16, M_23_padded);
  const double M_24_padded = M_24_size + 2.004168360008973e-292,
      M_24_error_bound = KSL_MUL(2.2204460492503136e-16, M_24_padded);
  const double M_25_padded = M_25_size + 2.004168360008973e-292,
      M_25_error_bound = KSL_MUL(2.2204460492503136e-16, M_25_padded);
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
  M_bound->at[0][0] = 0.0;
  M_bound->at[1][0] = 0.0;
  M_bound->at[2][0] = 0.0;
  M_bound->at[3][0] = M_03_error_bound;
  M_bound->at[4][0] = M_04_error_bound;
  M_bound->at[5][0] = M_05_error_bound;
  M_bound->at[0][1] = 0.0;
  M_bound->at[1][1] = 0.0;
  M_bound->at[2][1] = 0.0;
  M_bound->at[3][1] = M_13_error_bound;
  M_bound->at[4][1] = M_14_error_bound;
  M_bound->at[5][1] = M_15_error_bound;
  M_bound->at[0][2] = 0.0;
  M_bound->at[1][2] = 0.0;
  M_bound->at[2][2] = 0.0;
  M_bound->at[3][2] = M_23_error_bound;
  M_bound->at[4][2] = M_24_error_bound;
  M_bound->at[5][2] = M_25_error_bound;
  M_bound->at[0][3] = 0.0;
  M_bound->at[1][3] = 0.0;
  M_bound->at[2][3] = 0.0;
  M_bound->at[3][3] = 0.0;
  M_bound->at[4][3] = 0.0;
  M_bound->at[5][3] = 0.0;
  M_bound->at[0][4] = 0.0;
  M_bound->at[1][4] = 0.0;
  M_bound->at[2][4] = 0.0;
  M_bound->at[3][4] = 0.0;
  M_bound->at[4][4] = 0.0;
  M_bound->at[5][4] = 0.0;
  M_bound->at[0][5] = 0.0;
  M_bound->at[1][5] = 0.0;
  M_bound->at[2][5] = 0.0;
  M_bound->at[3][5] = 0.0;
  M_bound->at[4][5] = 0.0;
  M_bound->at[5][5] = 0.0;
}

/* power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power_bound: number.
   7 mul, 11 add, 6 abs. */
static inline double ksl_dot_cs_certified(const ksl_coscrew_t *c, const ksl_screw_t *s,
    double *power_bound) {
  const double power_a = KSL_MUL(c->m0, s->m0), power_b = KSL_MUL(c->m1, s->m1),
      power_c = power_a + power_b, power_d = KSL_MUL(c->m2, s->m2), power_e = power_c + power_d,
      power_f = KSL_MUL(c->m3, s->m3), power_g = KSL_MUL(c->m4, s->m4), power_h = power_f + power_g,
      power_i = KSL_MUL(c->m5, s->m5), power_j = power_h + power_i, power = power_e + power_j;
  const double power_a_abs = fabs(power_a), power_b_abs = fabs(power_b),
      power_c_size = power_a_abs + power_b_abs, power_d_abs = fabs(power_d),
      power_e_size = power_c_size + power_d_abs, power_f_abs = fabs(power_f),
      power_g_abs = fabs(power_g), power_h_size = power_f_abs + power_g_abs,
      power_i_abs = fabs(power_i), power_j_size = power_h_size + power_i_abs,
      power_size = power_e_size + power_j_size;
  const double power_padded = power_size + 2.004168360008973e-292,
      power_error_bound = KSL_MUL(4.440892098500628e-16, power_padded);
  *power_bound = power_error_bound;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
     Exactly zero for s1 = s2, unless products overflow.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(s1->m1, s2->m5), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0c = so_0a - so_0b, so_0d = KSL_MUL(s1->m4, s2->m2), so_0e = KSL_MUL(s1->m2, s2->m4),
      so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m0, s2->m5),
      so_1c = so_1a - so_1b, so_1d = KSL_MUL(s1->m2, s2->m3), so_1e = KSL_MUL(s1->m3, s2->m2),
      so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const double so_2a = KSL_MUL(s1->m0, s2->m4), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2c = so_2a - so_2b, so_2d = KSL_MUL(s1->m3, s2->m1), so_2e = KSL_MUL(s1->m1, s2->m3),
      so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const double so_3a = KSL_MUL(s1->m4, s2->m5), so_3b = KSL_MUL(s1->m5, s2->m4),
      so_3 = so_3a - so_3b;
  const double so_4a = KSL_MUL(s1->m5, s2->m3), so_4b = KSL_MUL(s1->m3, s2->m5),
      so_4 = so_4a - so_4b;
  const double so_5a = KSL_MUL(s1->m3, s2->m4), so_5b = KSL_MUL(s1->m4, s2->m3),
      so_5 = so_5a - so_5b;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0e_abs = fabs(so_0e), so_0f_size = so_0d_abs + so_0e_abs,
      so_0_size = so_0c_size + so_0f_size;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1e_abs = fabs(so_1e), so_1f_size = so_1d_abs + so_1e_abs,
      so_1_size = so_1c_size + so_1f_size;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2e_abs = fabs(so_2e), so_2f_size = so_2d_abs + so_2e_abs,
      so_2_size = so_2c_size + so_2f_size;
  const double so_3a_abs = fabs(so_3a), so_3b_abs = fabs(so_3b), so_3_size = so_3a_abs + so_3b_abs;
  const double so_4a_abs = fabs(so_4a), so_4b_abs = fabs(so_4b), so_4_size = so_4a_abs + so_4b_abs;
  const double so_5a_abs = fabs(so_5a), so_5b_abs = fabs(so_5b), so_5_size = so_5a_abs + so_5b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  const double so_3_padded = so_3_size + 2.004168360008973e-292,
      so_3_error_bound = KSL_MUL(2.2204460492503136e-16, so_3_padded);
  const double so_4_padded = so_4_size + 2.004168360008973e-292,
      so_4_error_bound = KSL_MUL(2.2204460492503136e-16, so_4_padded);
  const double so_5_padded = so_5_size + 2.004168360008973e-292,
      so_5_error_bound = KSL_MUL(2.2204460492503136e-16, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sst_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(s1->m4, s2->m2), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m3, s2->m2),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(s1->m3, s2->m1), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2 = so_2a - so_2b;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(2.2204460492503136e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(2.2204460492503136e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(2.2204460492503136e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 12 abs. */
static inline void ksl_hsra_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y), a_0c = a_0a + a_0b,
      a_0d = KSL_MUL(D->m02, axis->z), a_0 = a_0c + a_0d;
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y), a_1c = a_1a + a_1b,
      a_1d = KSL_MUL(D->m12, axis->z), a_1 = a_1c + a_1d;
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y), a_2c = a_2a + a_2b,
      a_2d = KSL_MUL(D->m22, axis->z), a_2 = a_2c + a_2d;
  const double so_0a = KSL_MUL(D->m13, a_2), so_0b = KSL_MUL(D->m23, a_1), so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m23, a_0), so_1b = KSL_MUL(D->m03, a_2), so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m03, a_1), so_2b = KSL_MUL(D->m13, a_0), so_2 = so_2a - so_2b;
  const double a_0a_abs = fabs(a_0a), a_0b_abs = fabs(a_0b), a_0c_size = a_0a_abs + a_0b_abs,
      a_0d_abs = fabs(a_0d), a_0_size = a_0c_size + a_0d_abs;
  const double a_1a_abs = fabs(a_1a), a_1b_abs = fabs(a_1b), a_1c_size = a_1a_abs + a_1b_abs,
      a_1d_abs = fabs(a_1d), a_1_size = a_1c_size + a_1d_abs;
  const double a_2a_abs = fabs(a_2a), a_2b_abs = fabs(a_2b), a_2c_size = a_2a_abs + a_2b_abs,
      a_2d_abs = fabs(a_2d), a_2_size = a_2c_size + a_2d_abs;
  const double a_2_padded = a_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), so_0a_size = KSL_MUL(D_13_abs, a_2_padded);
  const double a_1_padded = a_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), so_0b_size = KSL_MUL(D_23_abs, a_1_padded),
      so_0_size = so_0a_size + so_0b_size;
  const double a_0_padded = a_0_size + 2.004168360008973e-292;
  const double so_1a_size = KSL_MUL(D_23_abs, a_0_padded), D_03_abs = fabs(D->m03),
      so_1b_size = KSL_MUL(D_03_abs, a_2_padded), so_1_size = so_1a_size + so_1b_size;
  const double so_2a_size = KSL_MUL(D_03_abs, a_1_padded),
      so_2b_size = KSL_MUL(D_13_abs, a_0_padded), so_2_size = so_2a_size + so_2b_size;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(5.551115123125785e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(5.551115123125785e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(5.551115123125785e-16, so_2_padded);
  const double a_0_error_bound = KSL_MUL(3.3306690738754706e-16, a_0_padded);
  const double a_1_error_bound = KSL_MUL(3.3306690738754706e-16, a_1_padded);
  const double a_2_error_bound = KSL_MUL(3.3306690738754706e-16, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = a_0_error_bound;
  so_bound->m4 = a_1_error_bound;
  so_bound->m5 = a_2_error_bound;
}

/* so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 9 abs. */
static inline void ksl_hsta_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0d = KSL_MUL(D->m02, axis->z), so_0 = so_0c + so_0d;
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1d = KSL_MUL(D->m12, axis->z), so_1 = so_1c + so_1d;
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2d = KSL_MUL(D->m22, axis->z), so_2 = so_2c + so_2d;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0_size = so_0c_size + so_0d_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1_size = so_1c_size + so_1d_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2_size = so_2c_size + so_2d_abs;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(3.3306690738754706e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(3.3306690738754706e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(3.3306690738754706e-16, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
     NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 3 neg, 12 abs. */
static inline void ksl_hsrainv_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y), a_0c = a_0a + a_0b,
      a_0d = KSL_MUL(D->m02, axis->z), a_0 = a_0c + a_0d;
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y), a_1c = a_1a + a_1b,
      a_1d = KSL_MUL(D->m12, axis->z), a_1 = a_1c + a_1d;
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y), a_2c = a_2a + a_2b,
      a_2d = KSL_MUL(D->m22, axis->z), a_2 = a_2c + a_2d;
  const double so_0a = KSL_MUL(D->m23, a_1), so_0b = KSL_MUL(D->m13, a_2), so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m03, a_2), so_1b = KSL_MUL(D->m23, a_0), so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m13, a_0), so_2b = KSL_MUL(D->m03, a_1), so_2 = so_2a - so_2b;
  const double so_3 = -a_0;
  const double so_4 = -a_1;
  const double so_5 = -a_2;
  const double a_0a_abs = fabs(a_0a), a_0b_abs = fabs(a_0b), a_0c_size = a_0a_abs + a_0b_abs,
      a_0d_abs = fabs(a_0d), a_0_size = a_0c_size + a_0d_abs;
  const double a_1a_abs = fabs(a_1a), a_1b_abs = fabs(a_1b), a_1c_size = a_1a_abs + a_1b_abs,
      a_1d_abs = fabs(a_1d), a_1_size = a_1c_size + a_1d_abs;
  const double a_2a_abs = fabs(a_2a), a_2b_abs = fabs(a_2b), a_2c_size = a_2a_abs + a_2b_abs,
      a_2d_abs = fabs(a_2d), a_2_size = a_2c_size + a_2d_abs;
  const double a_1_padded = a_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), so_0a_size = KSL_MUL(D_23_abs, a_1_padded);
  const double a_2_padded = a_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), so_0b_size = KSL_MUL(D_13_abs, a_2_padded),
      so_0_size = so_0a_size + so_0b_size;
  const double D_03_abs = fabs(D->m03), so_1a_size = KSL_MUL(D_03_abs, a_2_padded);
  const double a_0_padded = a_0_size + 2.004168360008973e-292;
  const double so_1b_size = KSL_MUL(D_23_abs, a_0_padded), so_1_size = so_1a_size + so_1b_size;
  const double so_2a_size = KSL_MUL(D_13_abs, a_0_padded),
      so_2b_size = KSL_MUL(D_03_abs, a_1_padded), so_2_size = so_2a_size + so_2b_size;
  const double so_0_padded = so_0_size + 2.004168360008973e-292,
      so_0_error_bound = KSL_MUL(5.551115123125785e-16, so_0_padded);
  const double so_1_padded = so_1_size + 2.004168360008973e-292,
      so_1_error_bound = KSL_MUL(5.551115123125785e-16, so_1_padded);
  const double so_2_padded = so_2_size + 2.004168360008973e-292,
      so_2_error_bound = KSL_MUL(5.551115123125785e-16, so_2_padded);
  const double a_0_error_bound = KSL_MUL(3.3306690738754706e-16, a_0_padded);
  const double a_1_error_bound = KSL_MUL(3.3306690738754706e-16, a_1_padded);
  const double a_2_error_bound = KSL_MUL(3.3306690738754706e-16, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = a_0_error_bound;
  so_bound->m4 = a_1_error_bound;
  so_bound->m5 = a_2_error_bound;
}

/* so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_hstainv_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0d = KSL_MUL(D->m02, axis->z), so_0e = so_0c + so_0d, so_0 = -so_0e;
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1d = KSL_MUL(D->m12, axis->z), so_1e = so_1c + so_1d, so_1 = -so_1e;
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2d = KSL_MUL(D->m22, axis->z), so_2e = so_2c + so_2d, so_2 = -so_2e;
  const double so_0a_abs = fabs(so_0a), so_0b_abs = fabs(so_0b), so_0c_size = so_0a_abs + so_0b_abs,
      so_0d_abs = fabs(so_0d), so_0e_size = so_0c_size + so_0d_abs;
  const double so_1a_abs = fabs(so_1a), so_1b_abs = fabs(so_1b), so_1c_size = so_1a_abs + so_1b_abs,
      so_1d_abs = fabs(so_1d), so_1e_size = so_1c_size + so_1d_abs;
  const double so_2a_abs = fabs(so_2a), so_2b_abs = fabs(so_2b), so_2c_size = so_2a_abs + so_2b_abs,
      so_2d_abs = fabs(so_2d), so_2e_size = so_2c_size + so_2d_abs;
  const double so_0e_padded = so_0e_size + 2.004168360008973e-292,
      so_0e_error_bound = KSL_MUL(3.3306690738754706e-16, so_0e_padded);
  const double so_1e_padded = so_1e_size + 2.004168360008973e-292,
      so_1e_error_bound = KSL_MUL(3.3306690738754706e-16, so_1e_padded);
  const double so_2e_padded = so_2e_size + 2.004168360008973e-292,
      so_2e_error_bound = KSL_MUL(3.3306690738754706e-16, so_2e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0e_error_bound;
  so_bound->m1 = so_1e_error_bound;
  so_bound->m2 = so_2e_error_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: screw (v in m/s; ω in rad/s); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_screwf_scale_certified(ksl_screwf_t *self, const float a,
    ksl_screwf_t *self_bound) {
  const float self_0_new = KSL_MULF(self->m0, a);
  const float self_1_new = KSL_MULF(self->m1, a);
  const float self_2_new = KSL_MULF(self->m2, a);
  const float self_3_new = KSL_MULF(self->m3, a);
  const float self_4_new = KSL_MULF(self->m4, a);
  const float self_5_new = KSL_MULF(self->m5, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  const float self_4_new_abs = fabsf(self_4_new),
      self_4_new_padded = self_4_new_abs + 1.9721523e-31f,
      self_4_new_error_bound = KSL_MULF(5.960465e-08f, self_4_new_padded);
  const float self_5_new_abs = fabsf(self_5_new),
      self_5_new_padded = self_5_new_abs + 1.9721523e-31f,
      self_5_new_error_bound = KSL_MULF(5.960465e-08f, self_5_new_padded);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_error_bound;
  self_bound->m1 = self_1_new_error_bound;
  self_bound->m2 = self_2_new_error_bound;
  self_bound->m3 = self_3_new_error_bound;
  self_bound->m4 = self_4_new_error_bound;
  self_bound->m5 = self_5_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ssf_certified(const float a, const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = KSL_MULF(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = KSL_MULF(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = KSL_MULF(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = KSL_MULF(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = KSL_MULF(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const float y_0_new_a_abs = fabsf(y_0_new_a), y_0_abs = fabsf(y->m0),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const float y_1_new_a_abs = fabsf(y_1_new_a), y_1_abs = fabsf(y->m1),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const float y_2_new_a_abs = fabsf(y_2_new_a), y_2_abs = fabsf(y->m2),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const float y_3_new_a_abs = fabsf(y_3_new_a), y_3_abs = fabsf(y->m3),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const float y_4_new_a_abs = fabsf(y_4_new_a), y_4_abs = fabsf(y->m4),
      y_4_new_size = y_4_new_a_abs + y_4_abs;
  const float y_5_new_a_abs = fabsf(y_5_new_a), y_5_abs = fabsf(y->m5),
      y_5_new_size = y_5_new_a_abs + y_5_abs;
  const float y_0_new_padded = y_0_new_size + 1.9721523e-31f,
      y_0_new_error_bound = KSL_MULF(1.192093e-07f, y_0_new_padded);
  const float y_1_new_padded = y_1_new_size + 1.9721523e-31f,
      y_1_new_error_bound = KSL_MULF(1.192093e-07f, y_1_new_padded);
  const float y_2_new_padded = y_2_new_size + 1.9721523e-31f,
      y_2_new_error_bound = KSL_MULF(1.192093e-07f, y_2_new_padded);
  const float y_3_new_padded = y_3_new_size + 1.9721523e-31f,
      y_3_new_error_bound = KSL_MULF(1.192093e-07f, y_3_new_padded);
  const float y_4_new_padded = y_4_new_size + 1.9721523e-31f,
      y_4_new_error_bound = KSL_MULF(1.192093e-07f, y_4_new_padded);
  const float y_5_new_padded = y_5_new_size + 1.9721523e-31f,
      y_5_new_error_bound = KSL_MULF(1.192093e-07f, y_5_new_padded);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ssf_certified(const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new = x->m0 + y->m0;
  const float y_1_new = x->m1 + y->m1;
  const float y_2_new = x->m2 + y->m2;
  const float y_3_new = x->m3 + y->m3;
  const float y_4_new = x->m4 + y->m4;
  const float y_5_new = x->m5 + y->m5;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  const float y_3_new_abs = fabsf(y_3_new),
      y_3_new_error_bound = KSL_MULF(5.960465e-08f, y_3_new_abs);
  const float y_4_new_abs = fabsf(y_4_new),
      y_4_new_error_bound = KSL_MULF(5.960465e-08f, y_4_new_abs);
  const float y_5_new_abs = fabsf(y_5_new),
      y_5_new_error_bound = KSL_MULF(5.960465e-08f, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ssf_certified(const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new = y->m0 - x->m0;
  const float y_1_new = y->m1 - x->m1;
  const float y_2_new = y->m2 - x->m2;
  const float y_3_new = y->m3 - x->m3;
  const float y_4_new = y->m4 - x->m4;
  const float y_5_new = y->m5 - x->m5;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  const float y_3_new_abs = fabsf(y_3_new),
      y_3_new_error_bound = KSL_MULF(5.960465e-08f, y_3_new_abs);
  const float y_4_new_abs = fabsf(y_4_new),
      y_4_new_error_bound = KSL_MULF(5.960465e-08f, y_4_new_abs);
  const float y_5_new_abs = fabsf(y_5_new),
      y_5_new_error_bound = KSL_MULF(5.960465e-08f, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* so = a si; |error of so| <= so_bound unless inf or NaN.
   a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_asf_certified(const float a, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = KSL_MULF(a, si->m0);
  const float so_1 = KSL_MULF(a, si->m1);
  const float so_2 = KSL_MULF(a, si->m2);
  const float so_3 = KSL_MULF(a, si->m3);
  const float so_4 = KSL_MULF(a, si->m4);
  const float so_5 = KSL_MULF(a, si->m5);
  const float so_0_abs = fabsf(so_0), so_0_padded = so_0_abs + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(5.960465e-08f, so_0_padded);
  const float so_1_abs = fabsf(so_1), so_1_padded = so_1_abs + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(5.960465e-08f, so_1_padded);
  const float so_2_abs = fabsf(so_2), so_2_padded = so_2_abs + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(5.960465e-08f, so_2_padded);
  const float so_3_abs = fabsf(so_3), so_3_padded = so_3_abs + 1.9721523e-31f,
      so_3_error_bound = KSL_MULF(5.960465e-08f, so_3_padded);
  const float so_4_abs = fabsf(so_4), so_4_padded = so_4_abs + 1.9721523e-31f,
      so_4_error_bound = KSL_MULF(5.960465e-08f, so_4_padded);
  const float so_5_abs = fabsf(so_5), so_5_padded = so_5_abs + 1.9721523e-31f,
      so_5_error_bound = KSL_MULF(5.960465e-08f, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = s1 + s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float so_3 = s1->m3 + s2->m3;
  const float so_4 = s1->m4 + s2->m4;
  const float so_5 = s1->m5 + s2->m5;
  const float so_0_abs = fabsf(so_0), so_0_error_bound = KSL_MULF(5.960465e-08f, so_0_abs);
  const float so_1_abs = fabsf(so_1), so_1_error_bound = KSL_MULF(5.960465e-08f, so_1_abs);
  const float so_2_abs = fabsf(so_2), so_2_error_bound = KSL_MULF(5.960465e-08f, so_2_abs);
  const float so_3_abs = fabsf(so_3), so_3_error_bound = KSL_MULF(5.960465e-08f, so_3_abs);
  const float so_4_abs = fabsf(so_4), so_4_error_bound = KSL_MULF(5.960465e-08f, so_4_abs);
  const float so_5_abs = fabsf(so_5), so_5_error_bound = KSL_MULF(5.960465e-08f, so_5_abs);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = s1 - s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 - s2->m0;
  const float so_1 = s1->m1 - s2->m1;
  const float so_2 = s1->m2 - s2->m2;
  const float so_3 = s1->m3 - s2->m3;
  const float so_4 = s1->m4 - s2->m4;
  const float so_5 = s1->m5 - s2->m5;
  const float so_0_abs = fabsf(so_0), so_0_error_bound = KSL_MULF(5.960465e-08f, so_0_abs);
  const float so_1_abs = fabsf(so_1), so_1_error_bound = KSL_MULF(5.960465e-08f, so_1_abs);
  const float so_2_abs = fabsf(so_2), so_2_error_bound = KSL_MULF(5.960465e-08f, so_2_abs);
  const float so_3_abs = fabsf(so_3), so_3_error_bound = KSL_MULF(5.960465e-08f, so_3_abs);
  const float so_4_abs = fabsf(so_4), so_4_error_bound = KSL_MULF(5.960465e-08f, so_4_abs);
  const float so_5_abs = fabsf(so_5), so_5_error_bound = KSL_MULF(5.960465e-08f, so_5_abs);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_sstf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float so_0_abs = fabsf(so_0), so_0_error_bound = KSL_MULF(5.960465e-08f, so_0_abs);
  const float so_1_abs = fabsf(so_1), so_1_error_bound = KSL_MULF(5.960465e-08f, so_1_abs);
  const float so_2_abs = fabsf(so_2), so_2_error_bound = KSL_MULF(5.960465e-08f, so_2_abs);
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtsf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->y, si->m5), so_0b = KSL_MULF(t->z, si->m4), so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = KSL_MULF(t->z, si->m3), so_1b = KSL_MULF(t->x, si->m5), so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = KSL_MULF(t->x, si->m4), so_2b = KSL_MULF(t->y, si->m3), so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, si_0_abs = fabsf(si->m0),
      so_0_size = so_0c_size + si_0_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, si_1_abs = fabsf(si->m1),
      so_1_size = so_1c_size + si_1_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, si_2_abs = fabsf(si->m2),
      so_2_size = so_2c_size + si_2_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtinvsf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0b = KSL_MULF(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1b = KSL_MULF(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2b = KSL_MULF(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, si_0_abs = fabsf(si->m0),
      so_0_size = so_0c_size + si_0_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, si_1_abs = fabsf(si->m1),
      so_1_size = so_1c_size + si_1_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, si_2_abs = fabsf(si->m2),
      so_2_size = so_2c_size + si_2_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_Adtsinvf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0b = KSL_MULF(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1b = KSL_MULF(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2b = KSL_MULF(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2 = so_2c - si->m2;
  const float so_3 = -si->m3;
  const float so_4 = -si->m4;
  const float so_5 = -si->m5;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, si_0_abs = fabsf(si->m0),
      so_0_size = so_0c_size + si_0_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, si_1_abs = fabsf(si->m1),
      so_1_size = so_1c_size + si_1_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, si_2_abs = fabsf(si->m2),
      so_2_size = so_2c_size + si_2_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrsf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MULF(R->m02, si->m2), so_0 = so_0c + so_0d;
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MULF(R->m12, si->m2), so_1 = so_1c + so_1d;
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2b = KSL_MULF(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MULF(R->m22, si->m2), so_2 = so_2c + so_2d;
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MULF(R->m02, si->m5), so_3 = so_3c + so_3d;
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MULF(R->m12, si->m5), so_4 = so_4c + so_4d;
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5b = KSL_MULF(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MULF(R->m22, si->m5), so_5 = so_5c + so_5d;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d),
      so_0_size = so_0c_size + so_0d_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d),
      so_1_size = so_1c_size + so_1d_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d),
      so_2_size = so_2c_size + so_2d_abs;
  const float so_3a_abs = fabsf(so_3a), so_3b_abs = fabsf(so_3b),
      so_3c_size = so_3a_abs + so_3b_abs, so_3d_abs = fabsf(so_3d),
      so_3_size = so_3c_size + so_3d_abs;
  const float so_4a_abs = fabsf(so_4a), so_4b_abs = fabsf(so_4b),
      so_4c_size = so_4a_abs + so_4b_abs, so_4d_abs = fabsf(so_4d),
      so_4_size = so_4c_size + so_4d_abs;
  const float so_5a_abs = fabsf(so_5a), so_5b_abs = fabsf(so_5b),
      so_5c_size = so_5a_abs + so_5b_abs, so_5d_abs = fabsf(so_5d),
      so_5_size = so_5c_size + so_5d_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  const float so_3_padded = so_3_size + 1.9721523e-31f,
      so_3_error_bound = KSL_MULF(1.7881396e-07f, so_3_padded);
  const float so_4_padded = so_4_size + 1.9721523e-31f,
      so_4_error_bound = KSL_MULF(1.7881396e-07f, so_4_padded);
  const float so_5_padded = so_5_size + 1.9721523e-31f,
      so_5_error_bound = KSL_MULF(1.7881396e-07f, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrinvsf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m10, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MULF(R->m20, si->m2), so_0 = so_0c + so_0d;
  const float so_1a = KSL_MULF(R->m01, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MULF(R->m21, si->m2), so_1 = so_1c + so_1d;
  const float so_2a = KSL_MULF(R->m02, si->m0), so_2b = KSL_MULF(R->m12, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MULF(R->m22, si->m2), so_2 = so_2c + so_2d;
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m10, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MULF(R->m20, si->m5), so_3 = so_3c + so_3d;
  const float so_4a = KSL_MULF(R->m01, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MULF(R->m21, si->m5), so_4 = so_4c + so_4d;
  const float so_5a = KSL_MULF(R->m02, si->m3), so_5b = KSL_MULF(R->m12, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MULF(R->m22, si->m5), so_5 = so_5c + so_5d;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d),
      so_0_size = so_0c_size + so_0d_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d),
      so_1_size = so_1c_size + so_1d_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d),
      so_2_size = so_2c_size + so_2d_abs;
  const float so_3a_abs = fabsf(so_3a), so_3b_abs = fabsf(so_3b),
      so_3c_size = so_3a_abs + so_3b_abs, so_3d_abs = fabsf(so_3d),
      so_3_size = so_3c_size + so_3d_abs;
  const float so_4a_abs = fabsf(so_4a), so_4b_abs = fabsf(so_4b),
      so_4c_size = so_4a_abs + so_4b_abs, so_4d_abs = fabsf(so_4d),
      so_4_size = so_4c_size + so_4d_abs;
  const float so_5a_abs = fabsf(so_5a), so_5b_abs = fabsf(so_5b),
      so_5c_size = so_5a_abs + so_5b_abs, so_5d_abs = fabsf(so_5d),
      so_5_size = so_5c_size + so_5d_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  const float so_3_padded = so_3_size + 1.9721523e-31f,
      so_3_error_bound = KSL_MULF(1.7881396e-07f, so_3_padded);
  const float so_4_padded = so_4_size + 1.9721523e-31f,
      so_4_error_bound = KSL_MULF(1.7881396e-07f, so_4_padded);
  const float so_5_padded = so_5_size + 1.9721523e-31f,
      so_5_error_bound = KSL_MULF(1.7881396e-07f, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_Adrsinvf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0d = KSL_MULF(R->m02, si->m2), so_0e = so_0c + so_0d, so_0 = -so_0e;
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1d = KSL_MULF(R->m12, si->m2), so_1e = so_1c + so_1d, so_1 = -so_1e;
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2b = KSL_MULF(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2d = KSL_MULF(R->m22, si->m2), so_2e = so_2c + so_2d, so_2 = -so_2e;
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MULF(R->m02, si->m5), so_3e = so_3c + so_3d, so_3 = -so_3e;
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MULF(R->m12, si->m5), so_4e = so_4c + so_4d, so_4 = -so_4e;
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5b = KSL_MULF(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MULF(R->m22, si->m5), so_5e = so_5c + so_5d, so_5 = -so_5e;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d),
      so_0e_size = so_0c_size + so_0d_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d),
      so_1e_size = so_1c_size + so_1d_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d),
      so_2e_size = so_2c_size + so_2d_abs;
  const float so_3a_abs = fabsf(so_3a), so_3b_abs = fabsf(so_3b),
      so_3c_size = so_3a_abs + so_3b_abs, so_3d_abs = fabsf(so_3d),
      so_3e_size = so_3c_size + so_3d_abs;
  const float so_4a_abs = fabsf(so_4a), so_4b_abs = fabsf(so_4b),
      so_4c_size = so_4a_abs + so_4b_abs, so_4d_abs = fabsf(so_4d),
      so_4e_size = so_4c_size + so_4d_abs;
  const float so_5a_abs = fabsf(so_5a), so_5b_abs = fabsf(so_5b),
      so_5c_size = so_5a_abs + so_5b_abs, so_5d_abs = fabsf(so_5d),
      so_5e_size = so_5c_size + so_5d_abs;
  const float so_0e_padded = so_0e_size + 1.9721523e-31f,
      so_0e_error_bound = KSL_MULF(1.7881396e-07f, so_0e_padded);
  const float so_1e_padded = so_1e_size + 1.9721523e-31f,
      so_1e_error_bound = KSL_MULF(1.7881396e-07f, so_1e_padded);
  const float so_2e_padded = so_2e_size + 1.9721523e-31f,
      so_2e_error_bound = KSL_MULF(1.7881396e-07f, so_2e_padded);
  const float so_3e_padded = so_3e_size + 1.9721523e-31f,
      so_3e_error_bound = KSL_MULF(1.7881396e-07f, so_3e_padded);
  const float so_4e_padded = so_4e_size + 1.9721523e-31f,
      so_4e_error_bound = KSL_MULF(1.7881396e-07f, so_4e_padded);
  const float so_5e_padded = so_5e_size + 1.9721523e-31f,
      so_5e_error_bound = KSL_MULF(1.7881396e-07f, so_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0e_error_bound;
  so_bound->m1 = so_1e_error_bound;
  so_bound->m2 = so_2e_error_bound;
  so_bound->m3 = so_3e_error_bound;
  so_bound->m4 = so_4e_error_bound;
  so_bound->m5 = so_5e_error_bound;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_Adsf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0b = KSL_MULF(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, si->m2), w_0 = w_0c + w_0d;
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1b = KSL_MULF(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, si->m2), w_1 = w_1c + w_1d;
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2b = KSL_MULF(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, si->m2), w_2 = w_2c + w_2d;
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3b = KSL_MULF(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, si->m5), w_3 = w_3c + w_3d;
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4b = KSL_MULF(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, si->m5), w_4 = w_4c + w_4d;
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5b = KSL_MULF(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, si->m5), w_5 = w_5c + w_5d;
  const float so_0a = KSL_MULF(D->m13, w_5), so_0b = KSL_MULF(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const float so_1a = KSL_MULF(D->m23, w_3), so_1b = KSL_MULF(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const float so_2a = KSL_MULF(D->m03, w_4), so_2b = KSL_MULF(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const float w_5_padded = w_5_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), so_0a_size = KSL_MULF(D_13_abs, w_5_padded);
  const float w_4_padded = w_4_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), so_0b_size = KSL_MULF(D_23_abs, w_4_padded),
      so_0c_size = so_0a_size + so_0b_size, so_0_size = so_0c_size + w_0_size;
  const float w_3_padded = w_3_size + 1.9721523e-31f;
  const float so_1a_size = KSL_MULF(D_23_abs, w_3_padded), D_03_abs = fabsf(D->m03),
      so_1b_size = KSL_MULF(D_03_abs, w_5_padded), so_1c_size = so_1a_size + so_1b_size,
      so_1_size = so_1c_size + w_1_size;
  const float so_2a_size = KSL_MULF(D_03_abs, w_4_padded),
      so_2b_size = KSL_MULF(D_13_abs, w_3_padded), so_2c_size = so_2a_size + so_2b_size,
      so_2_size = so_2c_size + w_2_size;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(3.5762795e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(3.5762795e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(3.5762795e-07f, so_2_padded);
  const float w_3_error_bound = KSL_MULF(1.7881396e-07f, w_3_padded);
  const float w_4_error_bound = KSL_MULF(1.7881396e-07f, w_4_padded);
  const float w_5_error_bound = KSL_MULF(1.7881396e-07f, w_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = w_3_error_bound;
  so_bound->m4 = w_4_error_bound;
  so_bound->m5 = w_5_error_bound;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_Adinvsf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m23, si->m4), w_0b = KSL_MULF(D->m13, si->m5), w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const float w_1a = KSL_MULF(D->m03, si->m5), w_1b = KSL_MULF(D->m23, si->m3), w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const float w_2a = KSL_MULF(D->m13, si->m3), w_2b = KSL_MULF(D->m03, si->m4), w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const float so_0a = KSL_MULF(D->m00, w_0), so_0b = KSL_MULF(D->m10, w_1), so_0c = so_0a + so_0b,
      so_0d = KSL_MULF(D->m20, w_2), so_0 = so_0c + so_0d;
  const float so_1a = KSL_MULF(D->m01, w_0), so_1b = KSL_MULF(D->m11, w_1), so_1c = so_1a + so_1b,
      so_1d = KSL_MULF(D->m21, w_2), so_1 = so_1c + so_1d;
  const float so_2a = KSL_MULF(D->m02, w_0), so_2b = KSL_MULF(D->m12, w_1), so_2c = so_2a + so_2b,
      so_2d = KSL_MULF(D->m22, w_2), so_2 = so_2c + so_2d;
  const float so_3a = KSL_MULF(D->m00, si->m3), so_3b = KSL_MULF(D->m10, si->m4),
      so_3c = so_3a + so_3b, so_3d = KSL_MULF(D->m20, si->m5), so_3 = so_3c + so_3d;
  const float so_4a = KSL_MULF(D->m01, si->m3), so_4b = KSL_MULF(D->m11, si->m4),
      so_4c = so_4a + so_4b, so_4d = KSL_MULF(D->m21, si->m5), so_4 = so_4c + so_4d;
  const float so_5a = KSL_MULF(D->m02, si->m3), so_5b = KSL_MULF(D->m12, si->m4),
      so_5c = so_5a + so_5b, so_5d = KSL_MULF(D->m22, si->m5), so_5 = so_5c + so_5d;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      si_0_abs = fabsf(si->m0), w_0_size = w_0c_size + si_0_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      si_1_abs = fabsf(si->m1), w_1_size = w_1c_size + si_1_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      si_2_abs = fabsf(si->m2), w_2_size = w_2c_size + si_2_abs;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_00_abs = fabsf(D->m00), so_0a_size = KSL_MULF(D_00_abs, w_0_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10), so_0b_size = KSL_MULF(D_10_abs, w_1_padded),
      so_0c_size = so_0a_size + so_0b_size;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_20_abs = fabsf(D->m20), so_0d_size = KSL_MULF(D_20_abs, w_2_padded),
      so_0_size = so_0c_size + so_0d_size;
  const float D_01_abs = fabsf(D->m01), so_1a_size = KSL_MULF(D_01_abs, w_0_padded),
      D_11_abs = fabsf(D->m11), so_1b_size = KSL_MULF(D_11_abs, w_1_padded),
      so_1c_size = so_1a_size + so_1b_size, D_21_abs = fabsf(D->m21),
      so_1d_size = KSL_MULF(D_21_abs, w_2_padded), so_1_size = so_1c_size + so_1d_size;
  const float D_02_abs = fabsf(D->m02), so_2a_size = KSL_MULF(D_02_abs, w_0_padded),
      D_12_abs = fabsf(D->m12), so_2b_size = KSL_MULF(D_12_abs, w_1_padded),
      so_2c_size = so_2a_size + so_2b_size, D_22_abs = fabsf(D->m22),
      so_2d_size = KSL_MULF(D_22_abs, w_2_padded), so_2_size = so_2c_size + so_2d_size;
  const float so_3a_abs = fabsf(so_3a), so_3b_abs = fabsf(so_3b),
      so_3c_size = so_3a_abs + so_3b_abs, so_3d_abs = fabsf(so_3d),
      so_3_size = so_3c_size + so_3d_abs;
  const float so_4a_abs = fabsf(so_4a), so_4b_abs = fabsf(so_4b),
      so_4c_size = so_4a_abs + so_4b_abs, so_4d_abs = fabsf(so_4d),
      so_4_size = so_4c_size + so_4d_abs;
  const float so_5a_abs = fabsf(so_5a), so_5b_abs = fabsf(so_5b),
      so_5c_size = so_5a_abs + so_5b_abs, so_5d_abs = fabsf(so_5d),
      so_5_size = so_5c_size + so_5d_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(3.5762795e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(3.5762795e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(3.5762795e-07f, so_2_padded);
  const float so_3_padded = so_3_size + 1.9721523e-31f,
      so_3_error_bound = KSL_MULF(1.7881396e-07f, so_3_padded);
  const float so_4_padded = so_4_size + 1.9721523e-31f,
      so_4_error_bound = KSL_MULF(1.7881396e-07f, so_4_padded);
  const float so_5_padded = so_5_size + 1.9721523e-31f,
      so_5_error_bound = KSL_MULF(1.7881396e-07f, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_Adsinvf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0b = KSL_MULF(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, si->m2), w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1b = KSL_MULF(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, si->m2), w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2b = KSL_MULF(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, si->m2), w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3b = KSL_MULF(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, si->m5), w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4b = KSL_MULF(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, si->m5), w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5b = KSL_MULF(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, si->m5), w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float so_0a = KSL_MULF(D->m13, w_5), so_0b = KSL_MULF(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const float so_1a = KSL_MULF(D->m23, w_3), so_1b = KSL_MULF(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const float so_2a = KSL_MULF(D->m03, w_4), so_2b = KSL_MULF(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0e_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1e_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2e_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3e_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4e_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5e_size = w_5c_size + w_5d_abs;
  const float w_5e_padded = w_5e_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), so_0a_size = KSL_MULF(D_13_abs, w_5e_padded);
  const float w_4e_padded = w_4e_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), so_0b_size = KSL_MULF(D_23_abs, w_4e_padded),
      so_0c_size = so_0a_size + so_0b_size, so_0_size = so_0c_size + w_0e_size;
  const float w_3e_padded = w_3e_size + 1.9721523e-31f;
  const float so_1a_size = KSL_MULF(D_23_abs, w_3e_padded), D_03_abs = fabsf(D->m03),
      so_1b_size = KSL_MULF(D_03_abs, w_5e_padded), so_1c_size = so_1a_size + so_1b_size,
      so_1_size = so_1c_size + w_1e_size;
  const float so_2a_size = KSL_MULF(D_03_abs, w_4e_padded),
      so_2b_size = KSL_MULF(D_13_abs, w_3e_padded), so_2c_size = so_2a_size + so_2b_size,
      so_2_size = so_2c_size + w_2e_size;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(3.5762795e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(3.5762795e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(3.5762795e-07f, so_2_padded);
  const float w_3e_error_bound = KSL_MULF(1.7881396e-07f, w_3e_padded);
  const float w_4e_error_bound = KSL_MULF(1.7881396e-07f, w_4e_padded);
  const float w_5e_error_bound = KSL_MULF(1.7881396e-07f, w_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = w_3e_error_bound;
  so_bound->m4 = w_4e_error_bound;
  so_bound->m5 = w_5e_error_bound;
}

/* so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrxf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m20, D->m13), so_0b = KSL_MULF(D->m10, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m00, D->m23), so_1b = KSL_MULF(D->m20, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m10, D->m03), so_2b = KSL_MULF(D->m00, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsryf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m21, D->m13), so_0b = KSL_MULF(D->m11, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m01, D->m23), so_1b = KSL_MULF(D->m21, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m11, D->m03), so_2b = KSL_MULF(D->m01, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrzf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m22, D->m13), so_0b = KSL_MULF(D->m12, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m02, D->m23), so_1b = KSL_MULF(D->m22, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m12, D->m03), so_2b = KSL_MULF(D->m02, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrxinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m10, D->m23), so_0b = KSL_MULF(D->m20, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m20, D->m03), so_1b = KSL_MULF(D->m00, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m00, D->m13), so_2b = KSL_MULF(D->m10, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m00;
  const float so_4 = -D->m10;
  const float so_5 = -D->m20;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsryinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m11, D->m23), so_0b = KSL_MULF(D->m21, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m21, D->m03), so_1b = KSL_MULF(D->m01, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m01, D->m13), so_2b = KSL_MULF(D->m11, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m01;
  const float so_4 = -D->m11;
  const float so_5 = -D->m21;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrzinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m12, D->m23), so_0b = KSL_MULF(D->m22, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m22, D->m03), so_1b = KSL_MULF(D->m02, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m02, D->m13), so_2b = KSL_MULF(D->m12, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m02;
  const float so_4 = -D->m12;
  const float so_5 = -D->m22;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* M = [Ad](D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_Adf_certified(const ksl_SE3f_t *D, ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *M_bound) {
  const float M_03a = KSL_MULF(D->m20, D->m13), M_03b = KSL_MULF(D->m10, D->m23),
      M_03 = M_03a - M_03b;
  const float M_04a = KSL_MULF(D->m21, D->m13), M_04b = KSL_MULF(D->m11, D->m23),
      M_04 = M_04a - M_04b;
  const float M_05a = KSL_MULF(D->m22, D->m13), M_05b = KSL_MULF(D->m12, D->m23),
      M_05 = M_05a - M_05b;
  const float M_13a = KSL_MULF(D->m00, D->m23), M_13b = KSL_MULF(D->m20, D->m03),
      M_13 = M_13a - M_13b;
  const float M_14a = KSL_MULF(D->m01, D->m23), M_14b = KSL_MULF(D->m21, D->m03),
      M_14 = M_14a - M_14b;
  const float M_15a = KSL_MULF(D->m02, D->m23), M_15b = KSL_MULF(D->m22, D->m03),
      M_15 = M_15a - M_15b;
  const float M_23a = KSL_MULF(D->m10, D->m03), M_23b = KSL_MULF(D->m00, D->m13),
      M_23 = M_23a - M_23b;
  const float M_24a = KSL_MULF(D->m11, D->m03), M_24b = KSL_MULF(D->m01, D->m13),
      M_24 = M_24a - M_24b;
  const float M_25a = KSL_MULF(D->m12, D->m03), M_25b = KSL_MULF(D->m02, D->m13),
      M_25 = M_25a - M_25b;
  const float M_03a_abs = fabsf(M_03a), M_03b_abs = fabsf(M_03b), M_03_size = M_03a_abs + M_03b_abs;
  const float M_04a_abs = fabsf(M_04a), M_04b_abs = fabsf(M_04b), M_04_size = M_04a_abs + M_04b_abs;
  const float M_05a_abs = fabsf(M_05a), M_05b_abs = fabsf(M_05b), M_05_size = M_05a_abs + M_05b_abs;
  const float M_13a_abs = fabsf(M_13a), M_13b_abs = fabsf(M_13b), M_13_size = M_13a_abs + M_13b_abs;
  const float M_14a_abs = fabsf(M_14a), M_14b_abs = fabsf(M_14b), M_14_size = M_14a_abs + M_14b_abs;
  const float M_15a_abs = fabsf(M_15a), M_15b_abs = fabsf(M_15b), M_15_size = M_15a_abs + M_15b_abs;
  const float M_23a_abs = fabsf(M_23a), M_23b_abs = fabsf(M_23b), M_23_size = M_23a_abs + M_23b_abs;
  const float M_24a_abs = fabsf(M_24a), M_24b_abs = fabsf(M_24b), M_24_size = M_24a_abs + M_24b_abs;
  const float M_25a_abs = fabsf(M_25a), M_25b_abs = fabsf(M_25b), M_25_size = M_25a_abs + M_25b_abs;
  const float M_03_padded = M_03_size + 1.9721523e-31f,
      M_03_error_bound = KSL_MULF(1.192093e-07f, M_03_padded);
  const float M_04_padded = M_04_size + 1.9721523e-31f,
      M_04_error_bound = KSL_MULF(1.192093e-07f, M_04_padded);
  const float M_05_padded = M_05_size + 1.9721523e-31f,
      M_05_error_bound = KSL_MULF(1.192093e-07f, M_05_padded);
  const float M_13_padded = M_13_size + 1.9721523e-31f,
      M_13_error_bound = KSL_MULF(1.192093e-07f, M_13_padded);
  const float M_14_padded = M_14_size + 1.9721523e-31f,
      M_14_error_bound = KSL_MULF(1.192093e-07f, M_14_padded);
  const float M_15_padded = M_15_size + 1.9721523e-31f,
      M_15_error_bound = KSL_MULF(1.192093e-07f, M_15_padded);
  const float M_23_padded = M_23_size + 1.9721523e-31f,
      M_23_error_bound = KSL_MULF(1.192093e-07f, M_23_padded);
  const float M_24_padded = M_24_size + 1.9721523e-31f,
      M_24_error_bound = KSL_MULF(1.192093e-07f, M_24_padded);
  const float M_25_padded = M_25_size + 1.9721523e-31f,
      M_25_error_bound = KSL_MULF(1.192093e-07f, M_25_padded);
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
  M_bound->at[0][0] = 0.0f;
  M_bound->at[1][0] = 0.0f;
  M_bound->at[2][0] = 0.0f;
  M_bound->at[3][0] = M_03_error_bound;
  M_bound->at[4][0] = M_04_error_bound;
  M_bound->at[5][0] = M_05_error_bound;
  M_bound->at[0][1] = 0.0f;
  M_bound->at[1][1] = 0.0f;
  M_bound->at[2][1] = 0.0f;
  M_bound->at[3][1] = M_13_error_bound;
  M_bound->at[4][1] = M_14_error_bound;
  M_bound->at[5][1] = M_15_error_bound;
  M_bound->at[0][2] = 0.0f;
  M_bound->at[1][2] = 0.0f;
  M_bound->at[2][2] = 0.0f;
  M_bound->at[3][2] = M_23_error_bound;
  M_bound->at[4][2] = M_24_error_bound;
  M_bound->at[5][2] = M_25_error_bound;
  M_bound->at[0][3] = 0.0f;
  M_bound->at[1][3] = 0.0f;
  M_bound->at[2][3] = 0.0f;
  M_bound->at[3][3] = 0.0f;
  M_bound->at[4][3] = 0.0f;
  M_bound->at[5][3] = 0.0f;
  M_bound->at[0][4] = 0.0f;
  M_bound->at[1][4] = 0.0f;
  M_bound->at[2][4] = 0.0f;
  M_bound->at[3][4] = 0.0f;
  M_bound->at[4][4] = 0.0f;
  M_bound->at[5][4] = 0.0f;
  M_bound->at[0][5] = 0.0f;
  M_bound->at[1][5] = 0.0f;
  M_bound->at[2][5] = 0.0f;
  M_bound->at[3][5] = 0.0f;
  M_bound->at[4][5] = 0.0f;
  M_bound->at[5][5] = 0.0f;
}

/* power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power_bound: number.
   7 mul, 11 add, 6 abs. */
static inline float ksl_dot_csf_certified(const ksl_coscrewf_t *c, const ksl_screwf_t *s,
    float *power_bound) {
  const float power_a = KSL_MULF(c->m0, s->m0), power_b = KSL_MULF(c->m1, s->m1),
      power_c = power_a + power_b, power_d = KSL_MULF(c->m2, s->m2), power_e = power_c + power_d,
      power_f = KSL_MULF(c->m3, s->m3), power_g = KSL_MULF(c->m4, s->m4),
      power_h = power_f + power_g, power_i = KSL_MULF(c->m5, s->m5), power_j = power_h + power_i,
      power = power_e + power_j;
  const float power_a_abs = fabsf(power_a), power_b_abs = fabsf(power_b),
      power_c_size = power_a_abs + power_b_abs, power_d_abs = fabsf(power_d),
      power_e_size = power_c_size + power_d_abs, power_f_abs = fabsf(power_f),
      power_g_abs = fabsf(power_g), power_h_size = power_f_abs + power_g_abs,
      power_i_abs = fabsf(power_i), power_j_size = power_h_size + power_i_abs,
      power_size = power_e_size + power_j_size;
  const float power_padded = power_size + 1.9721523e-31f,
      power_error_bound = KSL_MULF(2.3841864e-07f, power_padded);
  *power_bound = power_error_bound;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
     Exactly zero for s1 = s2, unless products overflow.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(s1->m1, s2->m5), so_0b = KSL_MULF(s1->m5, s2->m1),
      so_0c = so_0a - so_0b, so_0d = KSL_MULF(s1->m4, s2->m2), so_0e = KSL_MULF(s1->m2, s2->m4),
      so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1b = KSL_MULF(s1->m0, s2->m5),
      so_1c = so_1a - so_1b, so_1d = KSL_MULF(s1->m2, s2->m3), so_1e = KSL_MULF(s1->m3, s2->m2),
      so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const float so_2a = KSL_MULF(s1->m0, s2->m4), so_2b = KSL_MULF(s1->m4, s2->m0),
      so_2c = so_2a - so_2b, so_2d = KSL_MULF(s1->m3, s2->m1), so_2e = KSL_MULF(s1->m1, s2->m3),
      so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const float so_3a = KSL_MULF(s1->m4, s2->m5), so_3b = KSL_MULF(s1->m5, s2->m4),
      so_3 = so_3a - so_3b;
  const float so_4a = KSL_MULF(s1->m5, s2->m3), so_4b = KSL_MULF(s1->m3, s2->m5),
      so_4 = so_4a - so_4b;
  const float so_5a = KSL_MULF(s1->m3, s2->m4), so_5b = KSL_MULF(s1->m4, s2->m3),
      so_5 = so_5a - so_5b;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d), so_0e_abs = fabsf(so_0e),
      so_0f_size = so_0d_abs + so_0e_abs, so_0_size = so_0c_size + so_0f_size;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d), so_1e_abs = fabsf(so_1e),
      so_1f_size = so_1d_abs + so_1e_abs, so_1_size = so_1c_size + so_1f_size;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d), so_2e_abs = fabsf(so_2e),
      so_2f_size = so_2d_abs + so_2e_abs, so_2_size = so_2c_size + so_2f_size;
  const float so_3a_abs = fabsf(so_3a), so_3b_abs = fabsf(so_3b), so_3_size = so_3a_abs + so_3b_abs;
  const float so_4a_abs = fabsf(so_4a), so_4b_abs = fabsf(so_4b), so_4_size = so_4a_abs + so_4b_abs;
  const float so_5a_abs = fabsf(so_5a), so_5b_abs = fabsf(so_5b), so_5_size = so_5a_abs + so_5b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  const float so_3_padded = so_3_size + 1.9721523e-31f,
      so_3_error_bound = KSL_MULF(1.192093e-07f, so_3_padded);
  const float so_4_padded = so_4_size + 1.9721523e-31f,
      so_4_error_bound = KSL_MULF(1.192093e-07f, so_4_padded);
  const float so_5_padded = so_5_size + 1.9721523e-31f,
      so_5_error_bound = KSL_MULF(1.192093e-07f, so_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = so_3_error_bound;
  so_bound->m4 = so_4_error_bound;
  so_bound->m5 = so_5_error_bound;
}

/* so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sstf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(s1->m4, s2->m2), so_0b = KSL_MULF(s1->m5, s2->m1),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1b = KSL_MULF(s1->m3, s2->m2),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(s1->m3, s2->m1), so_2b = KSL_MULF(s1->m4, s2->m0),
      so_2 = so_2a - so_2b;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b), so_0_size = so_0a_abs + so_0b_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b), so_1_size = so_1a_abs + so_1b_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b), so_2_size = so_2a_abs + so_2b_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.192093e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.192093e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.192093e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 12 abs. */
static inline void ksl_hsraf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0b = KSL_MULF(D->m01, axis->y),
      a_0c = a_0a + a_0b, a_0d = KSL_MULF(D->m02, axis->z), a_0 = a_0c + a_0d;
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1b = KSL_MULF(D->m11, axis->y),
      a_1c = a_1a + a_1b, a_1d = KSL_MULF(D->m12, axis->z), a_1 = a_1c + a_1d;
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2b = KSL_MULF(D->m21, axis->y),
      a_2c = a_2a + a_2b, a_2d = KSL_MULF(D->m22, axis->z), a_2 = a_2c + a_2d;
  const float so_0a = KSL_MULF(D->m13, a_2), so_0b = KSL_MULF(D->m23, a_1), so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m23, a_0), so_1b = KSL_MULF(D->m03, a_2), so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m03, a_1), so_2b = KSL_MULF(D->m13, a_0), so_2 = so_2a - so_2b;
  const float a_0a_abs = fabsf(a_0a), a_0b_abs = fabsf(a_0b), a_0c_size = a_0a_abs + a_0b_abs,
      a_0d_abs = fabsf(a_0d), a_0_size = a_0c_size + a_0d_abs;
  const float a_1a_abs = fabsf(a_1a), a_1b_abs = fabsf(a_1b), a_1c_size = a_1a_abs + a_1b_abs,
      a_1d_abs = fabsf(a_1d), a_1_size = a_1c_size + a_1d_abs;
  const float a_2a_abs = fabsf(a_2a), a_2b_abs = fabsf(a_2b), a_2c_size = a_2a_abs + a_2b_abs,
      a_2d_abs = fabsf(a_2d), a_2_size = a_2c_size + a_2d_abs;
  const float a_2_padded = a_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), so_0a_size = KSL_MULF(D_13_abs, a_2_padded);
  const float a_1_padded = a_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), so_0b_size = KSL_MULF(D_23_abs, a_1_padded),
      so_0_size = so_0a_size + so_0b_size;
  const float a_0_padded = a_0_size + 1.9721523e-31f;
  const float so_1a_size = KSL_MULF(D_23_abs, a_0_padded), D_03_abs = fabsf(D->m03),
      so_1b_size = KSL_MULF(D_03_abs, a_2_padded), so_1_size = so_1a_size + so_1b_size;
  const float so_2a_size = KSL_MULF(D_03_abs, a_1_padded),
      so_2b_size = KSL_MULF(D_13_abs, a_0_padded), so_2_size = so_2a_size + so_2b_size;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(2.9802328e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(2.9802328e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(2.9802328e-07f, so_2_padded);
  const float a_0_error_bound = KSL_MULF(1.7881396e-07f, a_0_padded);
  const float a_1_error_bound = KSL_MULF(1.7881396e-07f, a_1_padded);
  const float a_2_error_bound = KSL_MULF(1.7881396e-07f, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = a_0_error_bound;
  so_bound->m4 = a_1_error_bound;
  so_bound->m5 = a_2_error_bound;
}

/* so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 9 abs. */
static inline void ksl_hstaf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0b = KSL_MULF(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0d = KSL_MULF(D->m02, axis->z), so_0 = so_0c + so_0d;
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1b = KSL_MULF(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1d = KSL_MULF(D->m12, axis->z), so_1 = so_1c + so_1d;
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2b = KSL_MULF(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2d = KSL_MULF(D->m22, axis->z), so_2 = so_2c + so_2d;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d),
      so_0_size = so_0c_size + so_0d_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d),
      so_1_size = so_1c_size + so_1d_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d),
      so_2_size = so_2c_size + so_2d_abs;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(1.7881396e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(1.7881396e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(1.7881396e-07f, so_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
     NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 3 neg, 12 abs. */
static inline void ksl_hsrainvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0b = KSL_MULF(D->m01, axis->y),
      a_0c = a_0a + a_0b, a_0d = KSL_MULF(D->m02, axis->z), a_0 = a_0c + a_0d;
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1b = KSL_MULF(D->m11, axis->y),
      a_1c = a_1a + a_1b, a_1d = KSL_MULF(D->m12, axis->z), a_1 = a_1c + a_1d;
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2b = KSL_MULF(D->m21, axis->y),
      a_2c = a_2a + a_2b, a_2d = KSL_MULF(D->m22, axis->z), a_2 = a_2c + a_2d;
  const float so_0a = KSL_MULF(D->m23, a_1), so_0b = KSL_MULF(D->m13, a_2), so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m03, a_2), so_1b = KSL_MULF(D->m23, a_0), so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m13, a_0), so_2b = KSL_MULF(D->m03, a_1), so_2 = so_2a - so_2b;
  const float so_3 = -a_0;
  const float so_4 = -a_1;
  const float so_5 = -a_2;
  const float a_0a_abs = fabsf(a_0a), a_0b_abs = fabsf(a_0b), a_0c_size = a_0a_abs + a_0b_abs,
      a_0d_abs = fabsf(a_0d), a_0_size = a_0c_size + a_0d_abs;
  const float a_1a_abs = fabsf(a_1a), a_1b_abs = fabsf(a_1b), a_1c_size = a_1a_abs + a_1b_abs,
      a_1d_abs = fabsf(a_1d), a_1_size = a_1c_size + a_1d_abs;
  const float a_2a_abs = fabsf(a_2a), a_2b_abs = fabsf(a_2b), a_2c_size = a_2a_abs + a_2b_abs,
      a_2d_abs = fabsf(a_2d), a_2_size = a_2c_size + a_2d_abs;
  const float a_1_padded = a_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), so_0a_size = KSL_MULF(D_23_abs, a_1_padded);
  const float a_2_padded = a_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), so_0b_size = KSL_MULF(D_13_abs, a_2_padded),
      so_0_size = so_0a_size + so_0b_size;
  const float D_03_abs = fabsf(D->m03), so_1a_size = KSL_MULF(D_03_abs, a_2_padded);
  const float a_0_padded = a_0_size + 1.9721523e-31f;
  const float so_1b_size = KSL_MULF(D_23_abs, a_0_padded), so_1_size = so_1a_size + so_1b_size;
  const float so_2a_size = KSL_MULF(D_13_abs, a_0_padded),
      so_2b_size = KSL_MULF(D_03_abs, a_1_padded), so_2_size = so_2a_size + so_2b_size;
  const float so_0_padded = so_0_size + 1.9721523e-31f,
      so_0_error_bound = KSL_MULF(2.9802328e-07f, so_0_padded);
  const float so_1_padded = so_1_size + 1.9721523e-31f,
      so_1_error_bound = KSL_MULF(2.9802328e-07f, so_1_padded);
  const float so_2_padded = so_2_size + 1.9721523e-31f,
      so_2_error_bound = KSL_MULF(2.9802328e-07f, so_2_padded);
  const float a_0_error_bound = KSL_MULF(1.7881396e-07f, a_0_padded);
  const float a_1_error_bound = KSL_MULF(1.7881396e-07f, a_1_padded);
  const float a_2_error_bound = KSL_MULF(1.7881396e-07f, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_error_bound;
  so_bound->m1 = so_1_error_bound;
  so_bound->m2 = so_2_error_bound;
  so_bound->m3 = a_0_error_bound;
  so_bound->m4 = a_1_error_bound;
  so_bound->m5 = a_2_error_bound;
}

/* so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_hstainvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0b = KSL_MULF(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0d = KSL_MULF(D->m02, axis->z), so_0e = so_0c + so_0d,
      so_0 = -so_0e;
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1b = KSL_MULF(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1d = KSL_MULF(D->m12, axis->z), so_1e = so_1c + so_1d,
      so_1 = -so_1e;
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2b = KSL_MULF(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2d = KSL_MULF(D->m22, axis->z), so_2e = so_2c + so_2d,
      so_2 = -so_2e;
  const float so_0a_abs = fabsf(so_0a), so_0b_abs = fabsf(so_0b),
      so_0c_size = so_0a_abs + so_0b_abs, so_0d_abs = fabsf(so_0d),
      so_0e_size = so_0c_size + so_0d_abs;
  const float so_1a_abs = fabsf(so_1a), so_1b_abs = fabsf(so_1b),
      so_1c_size = so_1a_abs + so_1b_abs, so_1d_abs = fabsf(so_1d),
      so_1e_size = so_1c_size + so_1d_abs;
  const float so_2a_abs = fabsf(so_2a), so_2b_abs = fabsf(so_2b),
      so_2c_size = so_2a_abs + so_2b_abs, so_2d_abs = fabsf(so_2d),
      so_2e_size = so_2c_size + so_2d_abs;
  const float so_0e_padded = so_0e_size + 1.9721523e-31f,
      so_0e_error_bound = KSL_MULF(1.7881396e-07f, so_0e_padded);
  const float so_1e_padded = so_1e_size + 1.9721523e-31f,
      so_1e_error_bound = KSL_MULF(1.7881396e-07f, so_1e_padded);
  const float so_2e_padded = so_2e_size + 1.9721523e-31f,
      so_2e_error_bound = KSL_MULF(1.7881396e-07f, so_2e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0e_error_bound;
  so_bound->m1 = so_1e_error_bound;
  so_bound->m2 = so_2e_error_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

#endif

/* Coscrews: wrenches and momenta, c = (f; τ).
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_COSCREW_CERTIFIED_H
#define KSL_COSCREW_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: coscrew (f in N; τ in N m); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_coscrew_scale_certified(ksl_coscrew_t *self, const double a,
    ksl_coscrew_t *self_bound) {
  const double self_0_new = KSL_MUL(self->m0, a);
  const double self_1_new = KSL_MUL(self->m1, a);
  const double self_2_new = KSL_MUL(self->m2, a);
  const double self_3_new = KSL_MUL(self->m3, a);
  const double self_4_new = KSL_MUL(self->m4, a);
  const double self_5_new = KSL_MUL(self->m5, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  const double self_4_new_abs = fabs(self_4_new),
      self_4_new_padded = self_4_new_abs + 2.004168360008973e-292,
      self_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_4_new_padded);
  const double self_5_new_abs = fabs(self_5_new),
      self_5_new_padded = self_5_new_abs + 2.004168360008973e-292,
      self_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_5_new_padded);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_error_bound;
  self_bound->m1 = self_1_new_error_bound;
  self_bound->m2 = self_2_new_error_bound;
  self_bound->m3 = self_3_new_error_bound;
  self_bound->m4 = self_4_new_error_bound;
  self_bound->m5 = self_5_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: coscrew (f in N; τ in N m).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_cc_certified(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = KSL_MUL(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = KSL_MUL(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = KSL_MUL(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = KSL_MUL(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = KSL_MUL(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const double y_0_new_a_abs = fabs(y_0_new_a), y_0_abs = fabs(y->m0),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const double y_1_new_a_abs = fabs(y_1_new_a), y_1_abs = fabs(y->m1),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const double y_2_new_a_abs = fabs(y_2_new_a), y_2_abs = fabs(y->m2),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const double y_3_new_a_abs = fabs(y_3_new_a), y_3_abs = fabs(y->m3),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const double y_4_new_a_abs = fabs(y_4_new_a), y_4_abs = fabs(y->m4),
      y_4_new_size = y_4_new_a_abs + y_4_abs;
  const double y_5_new_a_abs = fabs(y_5_new_a), y_5_abs = fabs(y->m5),
      y_5_new_size = y_5_new_a_abs + y_5_abs;
  const double y_0_new_padded = y_0_new_size + 2.004168360008973e-292,
      y_0_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_padded);
  const double y_1_new_padded = y_1_new_size + 2.004168360008973e-292,
      y_1_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_padded);
  const double y_2_new_padded = y_2_new_size + 2.004168360008973e-292,
      y_2_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_padded);
  const double y_3_new_padded = y_3_new_size + 2.004168360008973e-292,
      y_3_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_3_new_padded);
  const double y_4_new_padded = y_4_new_size + 2.004168360008973e-292,
      y_4_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_4_new_padded);
  const double y_5_new_padded = y_5_new_size + 2.004168360008973e-292,
      y_5_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_5_new_padded);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_cc_certified(const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
  const double y_0_new = x->m0 + y->m0;
  const double y_1_new = x->m1 + y->m1;
  const double y_2_new = x->m2 + y->m2;
  const double y_3_new = x->m3 + y->m3;
  const double y_4_new = x->m4 + y->m4;
  const double y_5_new = x->m5 + y->m5;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  const double y_3_new_abs = fabs(y_3_new),
      y_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_3_new_abs);
  const double y_4_new_abs = fabs(y_4_new),
      y_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_4_new_abs);
  const double y_5_new_abs = fabs(y_5_new),
      y_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_cc_certified(const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
  const double y_0_new = y->m0 - x->m0;
  const double y_1_new = y->m1 - x->m1;
  const double y_2_new = y->m2 - x->m2;
  const double y_3_new = y->m3 - x->m3;
  const double y_4_new = y->m4 - x->m4;
  const double y_5_new = y->m5 - x->m5;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  const double y_3_new_abs = fabs(y_3_new),
      y_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_3_new_abs);
  const double y_4_new_abs = fabs(y_4_new),
      y_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_4_new_abs);
  const double y_5_new_abs = fabs(y_5_new),
      y_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* co = a ci; |error of co| <= co_bound unless inf or NaN.
   a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_ac_certified(const double a, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = KSL_MUL(a, ci->m0);
  const double co_1 = KSL_MUL(a, ci->m1);
  const double co_2 = KSL_MUL(a, ci->m2);
  const double co_3 = KSL_MUL(a, ci->m3);
  const double co_4 = KSL_MUL(a, ci->m4);
  const double co_5 = KSL_MUL(a, ci->m5);
  const double co_0_abs = fabs(co_0), co_0_padded = co_0_abs + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(1.1102230246251568e-16, co_0_padded);
  const double co_1_abs = fabs(co_1), co_1_padded = co_1_abs + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(1.1102230246251568e-16, co_1_padded);
  const double co_2_abs = fabs(co_2), co_2_padded = co_2_abs + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(1.1102230246251568e-16, co_2_padded);
  const double co_3_abs = fabs(co_3), co_3_padded = co_3_abs + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(1.1102230246251568e-16, co_3_padded);
  const double co_4_abs = fabs(co_4), co_4_padded = co_4_abs + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(1.1102230246251568e-16, co_4_padded);
  const double co_5_abs = fabs(co_5), co_5_padded = co_5_abs + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(1.1102230246251568e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = c1 + c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_cc_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double co_3 = c1->m3 + c2->m3;
  const double co_4 = c1->m4 + c2->m4;
  const double co_5 = c1->m5 + c2->m5;
  const double co_0_abs = fabs(co_0), co_0_error_bound = KSL_MUL(1.1102230246251568e-16, co_0_abs);
  const double co_1_abs = fabs(co_1), co_1_error_bound = KSL_MUL(1.1102230246251568e-16, co_1_abs);
  const double co_2_abs = fabs(co_2), co_2_error_bound = KSL_MUL(1.1102230246251568e-16, co_2_abs);
  const double co_3_abs = fabs(co_3), co_3_error_bound = KSL_MUL(1.1102230246251568e-16, co_3_abs);
  const double co_4_abs = fabs(co_4), co_4_error_bound = KSL_MUL(1.1102230246251568e-16, co_4_abs);
  const double co_5_abs = fabs(co_5), co_5_error_bound = KSL_MUL(1.1102230246251568e-16, co_5_abs);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = c1 - c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_cc_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 - c2->m0;
  const double co_1 = c1->m1 - c2->m1;
  const double co_2 = c1->m2 - c2->m2;
  const double co_3 = c1->m3 - c2->m3;
  const double co_4 = c1->m4 - c2->m4;
  const double co_5 = c1->m5 - c2->m5;
  const double co_0_abs = fabs(co_0), co_0_error_bound = KSL_MUL(1.1102230246251568e-16, co_0_abs);
  const double co_1_abs = fabs(co_1), co_1_error_bound = KSL_MUL(1.1102230246251568e-16, co_1_abs);
  const double co_2_abs = fabs(co_2), co_2_error_bound = KSL_MUL(1.1102230246251568e-16, co_2_abs);
  const double co_3_abs = fabs(co_3), co_3_error_bound = KSL_MUL(1.1102230246251568e-16, co_3_abs);
  const double co_4_abs = fabs(co_4), co_4_error_bound = KSL_MUL(1.1102230246251568e-16, co_4_abs);
  const double co_5_abs = fabs(co_5), co_5_error_bound = KSL_MUL(1.1102230246251568e-16, co_5_abs);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_cct_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double co_0_abs = fabs(co_0), co_0_error_bound = KSL_MUL(1.1102230246251568e-16, co_0_abs);
  const double co_1_abs = fabs(co_1), co_1_error_bound = KSL_MUL(1.1102230246251568e-16, co_1_abs);
  const double co_2_abs = fabs(co_2), co_2_error_bound = KSL_MUL(1.1102230246251568e-16, co_2_abs);
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = 0.0;
  co_bound->m4 = 0.0;
  co_bound->m5 = 0.0;
}

/* co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtc_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(t->y, ci->m2), co_3b = KSL_MUL(t->z, ci->m1), co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = KSL_MUL(t->z, ci->m0), co_4b = KSL_MUL(t->x, ci->m2), co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = KSL_MUL(t->x, ci->m1), co_5b = KSL_MUL(t->y, ci->m0), co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      ci_3_abs = fabs(ci->m3), co_3_size = co_3c_size + ci_3_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      ci_4_abs = fabs(ci->m4), co_4_size = co_4c_size + ci_4_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      ci_5_abs = fabs(ci->m5), co_5_size = co_5c_size + ci_5_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtinvc_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      ci_3_abs = fabs(ci->m3), co_3_size = co_3c_size + ci_3_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      ci_4_abs = fabs(ci->m4), co_4_size = co_4c_size + ci_4_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      ci_5_abs = fabs(ci->m5), co_5_size = co_5c_size + ci_5_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_CoAdtcinv_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5 = co_5c - ci->m5;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      ci_3_abs = fabs(ci->m3), co_3_size = co_3c_size + ci_3_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      ci_4_abs = fabs(ci->m4), co_4_size = co_4c_size + ci_4_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      ci_5_abs = fabs(ci->m5), co_5_size = co_5c_size + ci_5_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrc_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MUL(R->m02, ci->m2), co_0 = co_0c + co_0d;
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MUL(R->m12, ci->m2), co_1 = co_1c + co_1d;
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MUL(R->m22, ci->m2), co_2 = co_2c + co_2d;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MUL(R->m02, ci->m5), co_3 = co_3c + co_3d;
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MUL(R->m12, ci->m5), co_4 = co_4c + co_4d;
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MUL(R->m22, ci->m5), co_5 = co_5c + co_5d;
  const double co_0a_abs = fabs(co_0a), co_0b_abs = fabs(co_0b), co_0c_size = co_0a_abs + co_0b_abs,
      co_0d_abs = fabs(co_0d), co_0_size = co_0c_size + co_0d_abs;
  const double co_1a_abs = fabs(co_1a), co_1b_abs = fabs(co_1b), co_1c_size = co_1a_abs + co_1b_abs,
      co_1d_abs = fabs(co_1d), co_1_size = co_1c_size + co_1d_abs;
  const double co_2a_abs = fabs(co_2a), co_2b_abs = fabs(co_2b), co_2c_size = co_2a_abs + co_2b_abs,
      co_2d_abs = fabs(co_2d), co_2_size = co_2c_size + co_2d_abs;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      co_3d_abs = fabs(co_3d), co_3_size = co_3c_size + co_3d_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      co_4d_abs = fabs(co_4d), co_4_size = co_4c_size + co_4d_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      co_5d_abs = fabs(co_5d), co_5_size = co_5c_size + co_5d_abs;
  const double co_0_padded = co_0_size + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(3.3306690738754706e-16, co_0_padded);
  const double co_1_padded = co_1_size + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(3.3306690738754706e-16, co_1_padded);
  const double co_2_padded = co_2_size + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(3.3306690738754706e-16, co_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrinvc_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MUL(R->m20, ci->m2), co_0 = co_0c + co_0d;
  const double co_1a = KSL_MUL(R->m01, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MUL(R->m21, ci->m2), co_1 = co_1c + co_1d;
  const double co_2a = KSL_MUL(R->m02, ci->m0), co_2b = KSL_MUL(R->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MUL(R->m22, ci->m2), co_2 = co_2c + co_2d;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m10, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MUL(R->m20, ci->m5), co_3 = co_3c + co_3d;
  const double co_4a = KSL_MUL(R->m01, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MUL(R->m21, ci->m5), co_4 = co_4c + co_4d;
  const double co_5a = KSL_MUL(R->m02, ci->m3), co_5b = KSL_MUL(R->m12, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MUL(R->m22, ci->m5), co_5 = co_5c + co_5d;
  const double co_0a_abs = fabs(co_0a), co_0b_abs = fabs(co_0b), co_0c_size = co_0a_abs + co_0b_abs,
      co_0d_abs = fabs(co_0d), co_0_size = co_0c_size + co_0d_abs;
  const double co_1a_abs = fabs(co_1a), co_1b_abs = fabs(co_1b), co_1c_size = co_1a_abs + co_1b_abs,
      co_1d_abs = fabs(co_1d), co_1_size = co_1c_size + co_1d_abs;
  const double co_2a_abs = fabs(co_2a), co_2b_abs = fabs(co_2b), co_2c_size = co_2a_abs + co_2b_abs,
      co_2d_abs = fabs(co_2d), co_2_size = co_2c_size + co_2d_abs;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      co_3d_abs = fabs(co_3d), co_3_size = co_3c_size + co_3d_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      co_4d_abs = fabs(co_4d), co_4_size = co_4c_size + co_4d_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      co_5d_abs = fabs(co_5d), co_5_size = co_5c_size + co_5d_abs;
  const double co_0_padded = co_0_size + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(3.3306690738754706e-16, co_0_padded);
  const double co_1_padded = co_1_size + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(3.3306690738754706e-16, co_1_padded);
  const double co_2_padded = co_2_size + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(3.3306690738754706e-16, co_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_CoAdrcinv_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MUL(R->m02, ci->m2), co_0e = co_0c + co_0d, co_0 = -co_0e;
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MUL(R->m12, ci->m2), co_1e = co_1c + co_1d, co_1 = -co_1e;
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MUL(R->m22, ci->m2), co_2e = co_2c + co_2d, co_2 = -co_2e;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MUL(R->m02, ci->m5), co_3e = co_3c + co_3d, co_3 = -co_3e;
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MUL(R->m12, ci->m5), co_4e = co_4c + co_4d, co_4 = -co_4e;
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MUL(R->m22, ci->m5), co_5e = co_5c + co_5d, co_5 = -co_5e;
  const double co_0a_abs = fabs(co_0a), co_0b_abs = fabs(co_0b), co_0c_size = co_0a_abs + co_0b_abs,
      co_0d_abs = fabs(co_0d), co_0e_size = co_0c_size + co_0d_abs;
  const double co_1a_abs = fabs(co_1a), co_1b_abs = fabs(co_1b), co_1c_size = co_1a_abs + co_1b_abs,
      co_1d_abs = fabs(co_1d), co_1e_size = co_1c_size + co_1d_abs;
  const double co_2a_abs = fabs(co_2a), co_2b_abs = fabs(co_2b), co_2c_size = co_2a_abs + co_2b_abs,
      co_2d_abs = fabs(co_2d), co_2e_size = co_2c_size + co_2d_abs;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      co_3d_abs = fabs(co_3d), co_3e_size = co_3c_size + co_3d_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      co_4d_abs = fabs(co_4d), co_4e_size = co_4c_size + co_4d_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      co_5d_abs = fabs(co_5d), co_5e_size = co_5c_size + co_5d_abs;
  const double co_0e_padded = co_0e_size + 2.004168360008973e-292,
      co_0e_error_bound = KSL_MUL(3.3306690738754706e-16, co_0e_padded);
  const double co_1e_padded = co_1e_size + 2.004168360008973e-292,
      co_1e_error_bound = KSL_MUL(3.3306690738754706e-16, co_1e_padded);
  const double co_2e_padded = co_2e_size + 2.004168360008973e-292,
      co_2e_error_bound = KSL_MUL(3.3306690738754706e-16, co_2e_padded);
  const double co_3e_padded = co_3e_size + 2.004168360008973e-292,
      co_3e_error_bound = KSL_MUL(3.3306690738754706e-16, co_3e_padded);
  const double co_4e_padded = co_4e_size + 2.004168360008973e-292,
      co_4e_error_bound = KSL_MUL(3.3306690738754706e-16, co_4e_padded);
  const double co_5e_padded = co_5e_size + 2.004168360008973e-292,
      co_5e_error_bound = KSL_MUL(3.3306690738754706e-16, co_5e_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0e_error_bound;
  co_bound->m1 = co_1e_error_bound;
  co_bound->m2 = co_2e_error_bound;
  co_bound->m3 = co_3e_error_bound;
  co_bound->m4 = co_4e_error_bound;
  co_bound->m5 = co_5e_error_bound;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_CoAdc_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, ci->m2), w_0 = w_0c + w_0d;
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, ci->m2), w_1 = w_1c + w_1d;
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, ci->m2), w_2 = w_2c + w_2d;
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, ci->m5), w_3 = w_3c + w_3d;
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, ci->m5), w_4 = w_4c + w_4d;
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, ci->m5), w_5 = w_5c + w_5d;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_CoAdinvc_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3a = KSL_MUL(D->m23, ci->m1), w_3b = KSL_MUL(D->m13, ci->m2), w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const double w_4a = KSL_MUL(D->m03, ci->m2), w_4b = KSL_MUL(D->m23, ci->m0), w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const double w_5a = KSL_MUL(D->m13, ci->m0), w_5b = KSL_MUL(D->m03, ci->m1), w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const double co_0a = KSL_MUL(D->m00, ci->m0), co_0b = KSL_MUL(D->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MUL(D->m20, ci->m2), co_0 = co_0c + co_0d;
  const double co_1a = KSL_MUL(D->m01, ci->m0), co_1b = KSL_MUL(D->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MUL(D->m21, ci->m2), co_1 = co_1c + co_1d;
  const double co_2a = KSL_MUL(D->m02, ci->m0), co_2b = KSL_MUL(D->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MUL(D->m22, ci->m2), co_2 = co_2c + co_2d;
  const double co_3a = KSL_MUL(D->m00, w_3), co_3b = KSL_MUL(D->m10, w_4), co_3c = co_3a + co_3b,
      co_3d = KSL_MUL(D->m20, w_5), co_3 = co_3c + co_3d;
  const double co_4a = KSL_MUL(D->m01, w_3), co_4b = KSL_MUL(D->m11, w_4), co_4c = co_4a + co_4b,
      co_4d = KSL_MUL(D->m21, w_5), co_4 = co_4c + co_4d;
  const double co_5a = KSL_MUL(D->m02, w_3), co_5b = KSL_MUL(D->m12, w_4), co_5c = co_5a + co_5b,
      co_5d = KSL_MUL(D->m22, w_5), co_5 = co_5c + co_5d;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      ci_3_abs = fabs(ci->m3), w_3_size = w_3c_size + ci_3_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      ci_4_abs = fabs(ci->m4), w_4_size = w_4c_size + ci_4_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      ci_5_abs = fabs(ci->m5), w_5_size = w_5c_size + ci_5_abs;
  const double co_0a_abs = fabs(co_0a), co_0b_abs = fabs(co_0b), co_0c_size = co_0a_abs + co_0b_abs,
      co_0d_abs = fabs(co_0d), co_0_size = co_0c_size + co_0d_abs;
  const double co_1a_abs = fabs(co_1a), co_1b_abs = fabs(co_1b), co_1c_size = co_1a_abs + co_1b_abs,
      co_1d_abs = fabs(co_1d), co_1_size = co_1c_size + co_1d_abs;
  const double co_2a_abs = fabs(co_2a), co_2b_abs = fabs(co_2b), co_2c_size = co_2a_abs + co_2b_abs,
      co_2d_abs = fabs(co_2d), co_2_size = co_2c_size + co_2d_abs;
  const double w_3_padded = w_3_size + 2.004168360008973e-292;
  const double D_00_abs = fabs(D->m00), co_3a_size = KSL_MUL(D_00_abs, w_3_padded);
  const double w_4_padded = w_4_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10), co_3b_size = KSL_MUL(D_10_abs, w_4_padded),
      co_3c_size = co_3a_size + co_3b_size;
  const double w_5_padded = w_5_size + 2.004168360008973e-292;
  const double D_20_abs = fabs(D->m20), co_3d_size = KSL_MUL(D_20_abs, w_5_padded),
      co_3_size = co_3c_size + co_3d_size;
  const double D_01_abs = fabs(D->m01), co_4a_size = KSL_MUL(D_01_abs, w_3_padded),
      D_11_abs = fabs(D->m11), co_4b_size = KSL_MUL(D_11_abs, w_4_padded),
      co_4c_size = co_4a_size + co_4b_size, D_21_abs = fabs(D->m21),
      co_4d_size = KSL_MUL(D_21_abs, w_5_padded), co_4_size = co_4c_size + co_4d_size;
  const double D_02_abs = fabs(D->m02), co_5a_size = KSL_MUL(D_02_abs, w_3_padded),
      D_12_abs = fabs(D->m12), co_5b_size = KSL_MUL(D_12_abs, w_4_padded),
      co_5c_size = co_5a_size + co_5b_size, D_22_abs = fabs(D->m22),
      co_5d_size = KSL_MUL(D_22_abs, w_5_padded), co_5_size = co_5c_size + co_5d_size;
  const double co_0_padded = co_0_size + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(3.3306690738754706e-16, co_0_padded);
  const double co_1_padded = co_1_size + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(3.3306690738754706e-16, co_1_padded);
  const double co_2_padded = co_2_size + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(3.3306690738754706e-16, co_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_CoAdcinv_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, ci->m2), w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, ci->m2), w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, ci->m2), w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, ci->m5), w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, ci->m5), w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, ci->m5), w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0e_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1e_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2e_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3e_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4e_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5e_size = w_5c_size + w_5d_abs;
  const double w_2e_padded = w_2e_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2e_padded);
  const double w_1e_padded = w_1e_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1e_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3e_size;
  const double w_0e_padded = w_0e_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0e_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2e_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4e_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1e_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0e_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5e_size;
  const double w_0e_error_bound = KSL_MUL(3.3306690738754706e-16, w_0e_padded);
  const double w_1e_error_bound = KSL_MUL(3.3306690738754706e-16, w_1e_padded);
  const double w_2e_error_bound = KSL_MUL(3.3306690738754706e-16, w_2e_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0e_error_bound;
  co_bound->m1 = w_1e_error_bound;
  co_bound->m2 = w_2e_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctx_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m20, D->m13), co_3b = KSL_MUL(D->m10, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m00, D->m23), co_4b = KSL_MUL(D->m20, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m10, D->m03), co_5b = KSL_MUL(D->m00, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hcty_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m21, D->m13), co_3b = KSL_MUL(D->m11, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m01, D->m23), co_4b = KSL_MUL(D->m21, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m11, D->m03), co_5b = KSL_MUL(D->m01, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctz_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m22, D->m13), co_3b = KSL_MUL(D->m12, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m02, D->m23), co_4b = KSL_MUL(D->m22, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m12, D->m03), co_5b = KSL_MUL(D->m02, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctxinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = KSL_MUL(D->m10, D->m23), co_3b = KSL_MUL(D->m20, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m20, D->m03), co_4b = KSL_MUL(D->m00, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m00, D->m13), co_5b = KSL_MUL(D->m10, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctyinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = KSL_MUL(D->m11, D->m23), co_3b = KSL_MUL(D->m21, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m21, D->m03), co_4b = KSL_MUL(D->m01, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m01, D->m13), co_5b = KSL_MUL(D->m11, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctzinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = KSL_MUL(D->m12, D->m23), co_3b = KSL_MUL(D->m22, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m22, D->m03), co_4b = KSL_MUL(D->m02, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m02, D->m13), co_5b = KSL_MUL(D->m12, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_CoAd_certified(const ksl_SE3_t *D, ksl_mat6x6_t *M, ksl_mat6x6_t *M_bound) {
  const double M_30a = KSL_MUL(D->m20, D->m13), M_30b = KSL_MUL(D->m10, D->m23),
      M_30 = M_30a - M_30b;
  const double M_31a = KSL_MUL(D->m21, D->m13), M_31b = KSL_MUL(D->m11, D->m23),
      M_31 = M_31a - M_31b;
  const double M_32a = KSL_MUL(D->m22, D->m13), M_32b = KSL_MUL(D->m12, D->m23),
      M_32 = M_32a - M_32b;
  const double M_40a = KSL_MUL(D->m00, D->m23), M_40b = KSL_MUL(D->m20, D->m03),
      M_40 = M_40a - M_40b;
  const double M_41a = KSL_MUL(D->m01, D->m23), M_41b = KSL_MUL(D->m21, D->m03),
      M_41 = M_41a - M_41b;
  const double M_42a = KSL_MUL(D->m02, D->m23), M_42b = KSL_MUL(D->m22, D->m03),
      M_42 = M_42a - M_42b;
  const double M_50a = KSL_MUL(D->m10, D->m03), M_50b = KSL_MUL(D->m00, D->m13),
      M_50 = M_50a - M_50b;
  const double M_51a = KSL_MUL(D->m11, D->m03), M_51b = KSL_MUL(D->m01, D->m13),
      M_51 = M_51a - M_51b;
  const double M_52a = KSL_MUL(D->m12, D->m03), M_52b = KSL_MUL(D->m02, D->m13),
      M_52 = M_52a - M_52b;
  const double M_30a_abs = fabs(M_30a), M_30b_abs = fabs(M_30b), M_30_size = M_30a_abs + M_30b_abs;
  const double M_31a_abs = fabs(M_31a), M_31b_abs = fabs(M_31b), M_31_size = M_31a_abs + M_31b_abs;
  const double M_32a_abs = fabs(M_32a), M_32b_abs = fabs(M_32b), M_32_size = M_32a_abs + M_32b_abs;
  const double M_40a_abs = fabs(M_40a), M_40b_abs = fabs(M_40b), M_40_size = M_40a_abs + M_40b_abs;
  const double M_41a_abs = fabs(M_41a), M_41b_abs = fabs(M_41b), M_41_size = M_41a_abs + M_41b_abs;
  const double M_42a_abs = fabs(M_42a), M_42b_abs = fabs(M_42b), M_42_size = M_42a_abs + M_42b_abs;
  const double M_50a_abs = fabs(M_50a), M_50b_abs = fabs(M_50b), M_50_size = M_50a_abs + M_50b_abs;
  const double M_51a_abs = fabs(M_51a), M_51b_abs = fabs(M_51b), M_51_size = M_51a_abs + M_51b_abs;
  const double M_52a_abs = fabs(M_52a), M_52b_abs = fabs(M_52b), M_52_size = M_52a_abs + M_52b_abs;
  const double M_30_padded = M_30_size + 2.004168360008973e-292,
      M_30_error_bound = KSL_MUL(2.2204460492503136e-16, M_30_padded);
  const double M_31_padded = M_31_size + 2.004168360008973e-292,
      M_31_error_bound = KSL_MUL(2.2204460492503136e-16, M_31_padded);
  const double M_32_padded = M_32_size + 2.004168360008973e-292,
      M_32_error_bound = KSL_MUL(2.2204460492503136e-16, M_32_padded);
  const double M_40_padded = M_40_size + 2.004168360008973e-292,
      M_40_error_bound = KSL_MUL(2.2204460492503136e-16, M_40_padded);
  const double M_41_padded = M_41_size + 2.004168360008973e-292,
      M_41_error_bound = KSL_MUL(2.2204460492503136e-16, M_41_padded);
  const double M_42_padded = M_42_size + 2.004168360008973e-292,
      M_42_error_bound = KSL_MUL(2.2204460492503136e-16, M_42_padded);
  const double M_50_padded = M_50_size + 2.004168360008973e-292,
      M_50_error_bound = KSL_MUL(2.2204460492503136e-16, M_50_padded);
  const double M_51_padded = M_51_size + 2.004168360008973e-292,
      M_51_error_bound = KSL_MUL(2.2204460492503136e-16, M_51_padded);
  const double M_52_padded = M_52_size + 2.004168360008973e-292,
      M_52_error_bound = KSL_MUL(2.2204460492503136e-16, M_52_padded);
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
  M_bound->at[0][0] = 0.0;
  M_bound->at[1][0] = 0.0;
  M_bound->at[2][0] = 0.0;
  M_bound->at[3][0] = 0.0;
  M_bound->at[4][0] = 0.0;
  M_bound->at[5][0] = 0.0;
  M_bound->at[0][1] = 0.0;
  M_bound->at[1][1] = 0.0;
  M_bound->at[2][1] = 0.0;
  M_bound->at[3][1] = 0.0;
  M_bound->at[4][1] = 0.0;
  M_bound->at[5][1] = 0.0;
  M_bound->at[0][2] = 0.0;
  M_bound->at[1][2] = 0.0;
  M_bound->at[2][2] = 0.0;
  M_bound->at[3][2] = 0.0;
  M_bound->at[4][2] = 0.0;
  M_bound->at[5][2] = 0.0;
  M_bound->at[0][3] = M_30_error_bound;
  M_bound->at[1][3] = M_31_error_bound;
  M_bound->at[2][3] = M_32_error_bound;
  M_bound->at[3][3] = 0.0;
  M_bound->at[4][3] = 0.0;
  M_bound->at[5][3] = 0.0;
  M_bound->at[0][4] = M_40_error_bound;
  M_bound->at[1][4] = M_41_error_bound;
  M_bound->at[2][4] = M_42_error_bound;
  M_bound->at[3][4] = 0.0;
  M_bound->at[4][4] = 0.0;
  M_bound->at[5][4] = 0.0;
  M_bound->at[0][5] = M_50_error_bound;
  M_bound->at[1][5] = M_51_error_bound;
  M_bound->at[2][5] = M_52_error_bound;
  M_bound->at[3][5] = 0.0;
  M_bound->at[4][5] = 0.0;
  M_bound->at[5][5] = 0.0;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
     unless inf or NaN.
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top; power_bound:
     number.
   7 mul, 11 add, 6 abs. */
static inline double ksl_reciprocal_product_certified(const ksl_coscrew_t *c, const double x[6],
    double *power_bound) {
  const double power_a = KSL_MUL(c->m0, x[3]), power_b = KSL_MUL(c->m1, x[4]),
      power_c = power_a + power_b, power_d = KSL_MUL(c->m2, x[5]), power_e = power_c + power_d,
      power_f = KSL_MUL(c->m3, x[0]), power_g = KSL_MUL(c->m4, x[1]), power_h = power_f + power_g,
      power_i = KSL_MUL(c->m5, x[2]), power_j = power_h + power_i, power = power_e + power_j;
  const double power_a_abs = fabs(power_a), power_b_abs = fabs(power_b),
      power_c_size = power_a_abs + power_b_abs, power_d_abs = fabs(power_d),
      power_e_size = power_c_size + power_d_abs, power_f_abs = fabs(power_f),
      power_g_abs = fabs(power_g), power_h_size = power_f_abs + power_g_abs,
      power_i_abs = fabs(power_i), power_j_size = power_h_size + power_i_abs,
      power_size = power_e_size + power_j_size;
  const double power_padded = power_size + 2.004168360008973e-292,
      power_error_bound = KSL_MUL(4.440892098500628e-16, power_padded);
  *power_bound = power_error_bound;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_sc_certified(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(s->m4, c->m2), co_0b = KSL_MUL(s->m5, c->m1), co_0 = co_0a - co_0b;
  const double co_1a = KSL_MUL(s->m5, c->m0), co_1b = KSL_MUL(s->m3, c->m2), co_1 = co_1a - co_1b;
  const double co_2a = KSL_MUL(s->m3, c->m1), co_2b = KSL_MUL(s->m4, c->m0), co_2 = co_2a - co_2b;
  const double co_3a = KSL_MUL(s->m1, c->m2), co_3b = KSL_MUL(s->m2, c->m1), co_3c = co_3a - co_3b,
      co_3d = KSL_MUL(s->m4, c->m5), co_3e = KSL_MUL(s->m5, c->m4), co_3f = co_3d - co_3e,
      co_3 = co_3c + co_3f;
  const double co_4a = KSL_MUL(s->m2, c->m0), co_4b = KSL_MUL(s->m0, c->m2), co_4c = co_4a - co_4b,
      co_4d = KSL_MUL(s->m5, c->m3), co_4e = KSL_MUL(s->m3, c->m5), co_4f = co_4d - co_4e,
      co_4 = co_4c + co_4f;
  const double co_5a = KSL_MUL(s->m0, c->m1), co_5b = KSL_MUL(s->m1, c->m0), co_5c = co_5a - co_5b,
      co_5d = KSL_MUL(s->m3, c->m4), co_5e = KSL_MUL(s->m4, c->m3), co_5f = co_5d - co_5e,
      co_5 = co_5c + co_5f;
  const double co_0a_abs = fabs(co_0a), co_0b_abs = fabs(co_0b), co_0_size = co_0a_abs + co_0b_abs;
  const double co_1a_abs = fabs(co_1a), co_1b_abs = fabs(co_1b), co_1_size = co_1a_abs + co_1b_abs;
  const double co_2a_abs = fabs(co_2a), co_2b_abs = fabs(co_2b), co_2_size = co_2a_abs + co_2b_abs;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      co_3d_abs = fabs(co_3d), co_3e_abs = fabs(co_3e), co_3f_size = co_3d_abs + co_3e_abs,
      co_3_size = co_3c_size + co_3f_size;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      co_4d_abs = fabs(co_4d), co_4e_abs = fabs(co_4e), co_4f_size = co_4d_abs + co_4e_abs,
      co_4_size = co_4c_size + co_4f_size;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      co_5d_abs = fabs(co_5d), co_5e_abs = fabs(co_5e), co_5f_size = co_5d_abs + co_5e_abs,
      co_5_size = co_5c_size + co_5f_size;
  const double co_0_padded = co_0_size + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(2.2204460492503136e-16, co_0_padded);
  const double co_1_padded = co_1_size + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(2.2204460492503136e-16, co_1_padded);
  const double co_2_padded = co_2_size + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(2.2204460492503136e-16, co_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sca_certified(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(s->m4, c->m5), co_3b = KSL_MUL(s->m5, c->m4), co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(s->m5, c->m3), co_4b = KSL_MUL(s->m3, c->m5), co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(s->m3, c->m4), co_5b = KSL_MUL(s->m4, c->m3), co_5 = co_5a - co_5b;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(2.2204460492503136e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(2.2204460492503136e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(2.2204460492503136e-16, co_5_padded);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m01, c->m1), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m11, c->m1), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m21, c->m1), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(5.551115123125785e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(5.551115123125785e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(5.551115123125785e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cty_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(5.551115123125785e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(5.551115123125785e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(5.551115123125785e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabs(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabs(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabs(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(5.551115123125785e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(5.551115123125785e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(5.551115123125785e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d;
  const double w_3a = KSL_MUL(D->m01, c->m4), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m11, c->m4), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m21, c->m4), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cry_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5 = w_5a + w_5b;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const double w_0a_abs = fabs(w_0a), w_0b_abs = fabs(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabs(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const double w_1a_abs = fabs(w_1a), w_1b_abs = fabs(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabs(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const double w_2a_abs = fabs(w_2a), w_2b_abs = fabs(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabs(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const double w_3a_abs = fabs(w_3a), w_3b_abs = fabs(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const double w_4a_abs = fabs(w_4a), w_4b_abs = fabs(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const double w_5a_abs = fabs(w_5a), w_5b_abs = fabs(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const double w_0_error_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(6.661338147750942e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(6.661338147750942e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(6.661338147750942e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m00, c->m0);
  const double w_1 = KSL_MUL(D->m10, c->m0);
  const double w_2 = KSL_MUL(D->m20, c->m0);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b;
  const double w_2_abs = fabs(w_2), w_2_padded = w_2_abs + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_abs = fabs(w_1), w_1_padded = w_1_abs + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const double w_0_abs = fabs(w_0), w_0_padded = w_0_abs + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const double w_0_error_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_cty_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m01, c->m1);
  const double w_1 = KSL_MUL(D->m11, c->m1);
  const double w_2 = KSL_MUL(D->m21, c->m1);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b;
  const double w_2_abs = fabs(w_2), w_2_padded = w_2_abs + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_abs = fabs(w_1), w_1_padded = w_1_abs + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const double w_0_abs = fabs(w_0), w_0_padded = w_0_abs + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const double w_0_error_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m02, c->m2);
  const double w_1 = KSL_MUL(D->m12, c->m2);
  const double w_2 = KSL_MUL(D->m22, c->m2);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b;
  const double w_2_abs = fabs(w_2), w_2_padded = w_2_abs + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), co_3a_size = KSL_MUL(D_13_abs, w_2_padded);
  const double w_1_abs = fabs(w_1), w_1_padded = w_1_abs + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), co_3b_size = KSL_MUL(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const double w_0_abs = fabs(w_0), w_0_padded = w_0_abs + 2.004168360008973e-292;
  const double co_4a_size = KSL_MUL(D_23_abs, w_0_padded), D_03_abs = fabs(D->m03),
      co_4b_size = KSL_MUL(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const double co_5a_size = KSL_MUL(D_03_abs, w_1_padded),
      co_5b_size = KSL_MUL(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const double w_0_error_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded);
  const double w_1_error_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded);
  const double w_2_error_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(3.3306690738754706e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(3.3306690738754706e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(3.3306690738754706e-16, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m00, c->m3);
  const double w_4 = KSL_MUL(D->m10, c->m3);
  const double w_5 = KSL_MUL(D->m20, c->m3);
  const double w_3_abs = fabs(w_3), w_3_padded = w_3_abs + 2.004168360008973e-292,
      w_3_error_bound = KSL_MUL(1.1102230246251568e-16, w_3_padded);
  const double w_4_abs = fabs(w_4), w_4_padded = w_4_abs + 2.004168360008973e-292,
      w_4_error_bound = KSL_MUL(1.1102230246251568e-16, w_4_padded);
  const double w_5_abs = fabs(w_5), w_5_padded = w_5_abs + 2.004168360008973e-292,
      w_5_error_bound = KSL_MUL(1.1102230246251568e-16, w_5_padded);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_cry_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m01, c->m4);
  const double w_4 = KSL_MUL(D->m11, c->m4);
  const double w_5 = KSL_MUL(D->m21, c->m4);
  const double w_3_abs = fabs(w_3), w_3_padded = w_3_abs + 2.004168360008973e-292,
      w_3_error_bound = KSL_MUL(1.1102230246251568e-16, w_3_padded);
  const double w_4_abs = fabs(w_4), w_4_padded = w_4_abs + 2.004168360008973e-292,
      w_4_error_bound = KSL_MUL(1.1102230246251568e-16, w_4_padded);
  const double w_5_abs = fabs(w_5), w_5_padded = w_5_abs + 2.004168360008973e-292,
      w_5_error_bound = KSL_MUL(1.1102230246251568e-16, w_5_padded);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m02, c->m5);
  const double w_4 = KSL_MUL(D->m12, c->m5);
  const double w_5 = KSL_MUL(D->m22, c->m5);
  const double w_3_abs = fabs(w_3), w_3_padded = w_3_abs + 2.004168360008973e-292,
      w_3_error_bound = KSL_MUL(1.1102230246251568e-16, w_3_padded);
  const double w_4_abs = fabs(w_4), w_4_padded = w_4_abs + 2.004168360008973e-292,
      w_4_error_bound = KSL_MUL(1.1102230246251568e-16, w_4_padded);
  const double w_5_abs = fabs(w_5), w_5_padded = w_5_abs + 2.004168360008973e-292,
      w_5_error_bound = KSL_MUL(1.1102230246251568e-16, w_5_padded);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: coscrew (f in N; τ in N m); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_coscrewf_scale_certified(ksl_coscrewf_t *self, const float a,
    ksl_coscrewf_t *self_bound) {
  const float self_0_new = KSL_MULF(self->m0, a);
  const float self_1_new = KSL_MULF(self->m1, a);
  const float self_2_new = KSL_MULF(self->m2, a);
  const float self_3_new = KSL_MULF(self->m3, a);
  const float self_4_new = KSL_MULF(self->m4, a);
  const float self_5_new = KSL_MULF(self->m5, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  const float self_4_new_abs = fabsf(self_4_new),
      self_4_new_padded = self_4_new_abs + 1.9721523e-31f,
      self_4_new_error_bound = KSL_MULF(5.960465e-08f, self_4_new_padded);
  const float self_5_new_abs = fabsf(self_5_new),
      self_5_new_padded = self_5_new_abs + 1.9721523e-31f,
      self_5_new_error_bound = KSL_MULF(5.960465e-08f, self_5_new_padded);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_error_bound;
  self_bound->m1 = self_1_new_error_bound;
  self_bound->m2 = self_2_new_error_bound;
  self_bound->m3 = self_3_new_error_bound;
  self_bound->m4 = self_4_new_error_bound;
  self_bound->m5 = self_5_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: coscrew (f in N; τ in N m).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ccf_certified(const float a, const ksl_coscrewf_t *x,
    ksl_coscrewf_t *y, ksl_coscrewf_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = KSL_MULF(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = KSL_MULF(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = KSL_MULF(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = KSL_MULF(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = KSL_MULF(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const float y_0_new_a_abs = fabsf(y_0_new_a), y_0_abs = fabsf(y->m0),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const float y_1_new_a_abs = fabsf(y_1_new_a), y_1_abs = fabsf(y->m1),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const float y_2_new_a_abs = fabsf(y_2_new_a), y_2_abs = fabsf(y->m2),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const float y_3_new_a_abs = fabsf(y_3_new_a), y_3_abs = fabsf(y->m3),
      y_3_new_size = y_3_new_a_abs + y_3_abs;
  const float y_4_new_a_abs = fabsf(y_4_new_a), y_4_abs = fabsf(y->m4),
      y_4_new_size = y_4_new_a_abs + y_4_abs;
  const float y_5_new_a_abs = fabsf(y_5_new_a), y_5_abs = fabsf(y->m5),
      y_5_new_size = y_5_new_a_abs + y_5_abs;
  const float y_0_new_padded = y_0_new_size + 1.9721523e-31f,
      y_0_new_error_bound = KSL_MULF(1.192093e-07f, y_0_new_padded);
  const float y_1_new_padded = y_1_new_size + 1.9721523e-31f,
      y_1_new_error_bound = KSL_MULF(1.192093e-07f, y_1_new_padded);
  const float y_2_new_padded = y_2_new_size + 1.9721523e-31f,
      y_2_new_error_bound = KSL_MULF(1.192093e-07f, y_2_new_padded);
  const float y_3_new_padded = y_3_new_size + 1.9721523e-31f,
      y_3_new_error_bound = KSL_MULF(1.192093e-07f, y_3_new_padded);
  const float y_4_new_padded = y_4_new_size + 1.9721523e-31f,
      y_4_new_error_bound = KSL_MULF(1.192093e-07f, y_4_new_padded);
  const float y_5_new_padded = y_5_new_size + 1.9721523e-31f,
      y_5_new_error_bound = KSL_MULF(1.192093e-07f, y_5_new_padded);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ccf_certified(const ksl_coscrewf_t *x, ksl_coscrewf_t *y,
    ksl_coscrewf_t *y_bound) {
  const float y_0_new = x->m0 + y->m0;
  const float y_1_new = x->m1 + y->m1;
  const float y_2_new = x->m2 + y->m2;
  const float y_3_new = x->m3 + y->m3;
  const float y_4_new = x->m4 + y->m4;
  const float y_5_new = x->m5 + y->m5;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  const float y_3_new_abs = fabsf(y_3_new),
      y_3_new_error_bound = KSL_MULF(5.960465e-08f, y_3_new_abs);
  const float y_4_new_abs = fabsf(y_4_new),
      y_4_new_error_bound = KSL_MULF(5.960465e-08f, y_4_new_abs);
  const float y_5_new_abs = fabsf(y_5_new),
      y_5_new_error_bound = KSL_MULF(5.960465e-08f, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ccf_certified(const ksl_coscrewf_t *x, ksl_coscrewf_t *y,
    ksl_coscrewf_t *y_bound) {
  const float y_0_new = y->m0 - x->m0;
  const float y_1_new = y->m1 - x->m1;
  const float y_2_new = y->m2 - x->m2;
  const float y_3_new = y->m3 - x->m3;
  const float y_4_new = y->m4 - x->m4;
  const float y_5_new = y->m5 - x->m5;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  const float y_3_new_abs = fabsf(y_3_new),
      y_3_new_error_bound = KSL_MULF(5.960465e-08f, y_3_new_abs);
  const float y_4_new_abs = fabsf(y_4_new),
      y_4_new_error_bound = KSL_MULF(5.960465e-08f, y_4_new_abs);
  const float y_5_new_abs = fabsf(y_5_new),
      y_5_new_error_bound = KSL_MULF(5.960465e-08f, y_5_new_abs);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_error_bound;
  y_bound->m1 = y_1_new_error_bound;
  y_bound->m2 = y_2_new_error_bound;
  y_bound->m3 = y_3_new_error_bound;
  y_bound->m4 = y_4_new_error_bound;
  y_bound->m5 = y_5_new_error_bound;
}

/* co = a ci; |error of co| <= co_bound unless inf or NaN.
   a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_acf_certified(const float a, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = KSL_MULF(a, ci->m0);
  const float co_1 = KSL_MULF(a, ci->m1);
  const float co_2 = KSL_MULF(a, ci->m2);
  const float co_3 = KSL_MULF(a, ci->m3);
  const float co_4 = KSL_MULF(a, ci->m4);
  const float co_5 = KSL_MULF(a, ci->m5);
  const float co_0_abs = fabsf(co_0), co_0_padded = co_0_abs + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(5.960465e-08f, co_0_padded);
  const float co_1_abs = fabsf(co_1), co_1_padded = co_1_abs + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(5.960465e-08f, co_1_padded);
  const float co_2_abs = fabsf(co_2), co_2_padded = co_2_abs + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(5.960465e-08f, co_2_padded);
  const float co_3_abs = fabsf(co_3), co_3_padded = co_3_abs + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(5.960465e-08f, co_3_padded);
  const float co_4_abs = fabsf(co_4), co_4_padded = co_4_abs + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(5.960465e-08f, co_4_padded);
  const float co_5_abs = fabsf(co_5), co_5_padded = co_5_abs + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(5.960465e-08f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = c1 + c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ccf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float co_3 = c1->m3 + c2->m3;
  const float co_4 = c1->m4 + c2->m4;
  const float co_5 = c1->m5 + c2->m5;
  const float co_0_abs = fabsf(co_0), co_0_error_bound = KSL_MULF(5.960465e-08f, co_0_abs);
  const float co_1_abs = fabsf(co_1), co_1_error_bound = KSL_MULF(5.960465e-08f, co_1_abs);
  const float co_2_abs = fabsf(co_2), co_2_error_bound = KSL_MULF(5.960465e-08f, co_2_abs);
  const float co_3_abs = fabsf(co_3), co_3_error_bound = KSL_MULF(5.960465e-08f, co_3_abs);
  const float co_4_abs = fabsf(co_4), co_4_error_bound = KSL_MULF(5.960465e-08f, co_4_abs);
  const float co_5_abs = fabsf(co_5), co_5_error_bound = KSL_MULF(5.960465e-08f, co_5_abs);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = c1 - c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ccf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 - c2->m0;
  const float co_1 = c1->m1 - c2->m1;
  const float co_2 = c1->m2 - c2->m2;
  const float co_3 = c1->m3 - c2->m3;
  const float co_4 = c1->m4 - c2->m4;
  const float co_5 = c1->m5 - c2->m5;
  const float co_0_abs = fabsf(co_0), co_0_error_bound = KSL_MULF(5.960465e-08f, co_0_abs);
  const float co_1_abs = fabsf(co_1), co_1_error_bound = KSL_MULF(5.960465e-08f, co_1_abs);
  const float co_2_abs = fabsf(co_2), co_2_error_bound = KSL_MULF(5.960465e-08f, co_2_abs);
  const float co_3_abs = fabsf(co_3), co_3_error_bound = KSL_MULF(5.960465e-08f, co_3_abs);
  const float co_4_abs = fabsf(co_4), co_4_error_bound = KSL_MULF(5.960465e-08f, co_4_abs);
  const float co_5_abs = fabsf(co_5), co_5_error_bound = KSL_MULF(5.960465e-08f, co_5_abs);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_cctf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float co_0_abs = fabsf(co_0), co_0_error_bound = KSL_MULF(5.960465e-08f, co_0_abs);
  const float co_1_abs = fabsf(co_1), co_1_error_bound = KSL_MULF(5.960465e-08f, co_1_abs);
  const float co_2_abs = fabsf(co_2), co_2_error_bound = KSL_MULF(5.960465e-08f, co_2_abs);
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = 0.0f;
  co_bound->m4 = 0.0f;
  co_bound->m5 = 0.0f;
}

/* co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtcf_certified(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(t->y, ci->m2), co_3b = KSL_MULF(t->z, ci->m1), co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = KSL_MULF(t->z, ci->m0), co_4b = KSL_MULF(t->x, ci->m2), co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = KSL_MULF(t->x, ci->m1), co_5b = KSL_MULF(t->y, ci->m0), co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, ci_3_abs = fabsf(ci->m3),
      co_3_size = co_3c_size + ci_3_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, ci_4_abs = fabsf(ci->m4),
      co_4_size = co_4c_size + ci_4_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, ci_5_abs = fabsf(ci->m5),
      co_5_size = co_5c_size + ci_5_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtinvcf_certified(const ksl_vec3f_t *t,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3b = KSL_MULF(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4b = KSL_MULF(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5b = KSL_MULF(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, ci_3_abs = fabsf(ci->m3),
      co_3_size = co_3c_size + ci_3_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, ci_4_abs = fabsf(ci->m4),
      co_4_size = co_4c_size + ci_4_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, ci_5_abs = fabsf(ci->m5),
      co_5_size = co_5c_size + ci_5_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_CoAdtcinvf_certified(const ksl_vec3f_t *t,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3b = KSL_MULF(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4b = KSL_MULF(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5b = KSL_MULF(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5 = co_5c - ci->m5;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, ci_3_abs = fabsf(ci->m3),
      co_3_size = co_3c_size + ci_3_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, ci_4_abs = fabsf(ci->m4),
      co_4_size = co_4c_size + ci_4_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, ci_5_abs = fabsf(ci->m5),
      co_5_size = co_5c_size + ci_5_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrcf_certified(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MULF(R->m02, ci->m2), co_0 = co_0c + co_0d;
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MULF(R->m12, ci->m2), co_1 = co_1c + co_1d;
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2b = KSL_MULF(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MULF(R->m22, ci->m2), co_2 = co_2c + co_2d;
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MULF(R->m02, ci->m5), co_3 = co_3c + co_3d;
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MULF(R->m12, ci->m5), co_4 = co_4c + co_4d;
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5b = KSL_MULF(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MULF(R->m22, ci->m5), co_5 = co_5c + co_5d;
  const float co_0a_abs = fabsf(co_0a), co_0b_abs = fabsf(co_0b),
      co_0c_size = co_0a_abs + co_0b_abs, co_0d_abs = fabsf(co_0d),
      co_0_size = co_0c_size + co_0d_abs;
  const float co_1a_abs = fabsf(co_1a), co_1b_abs = fabsf(co_1b),
      co_1c_size = co_1a_abs + co_1b_abs, co_1d_abs = fabsf(co_1d),
      co_1_size = co_1c_size + co_1d_abs;
  const float co_2a_abs = fabsf(co_2a), co_2b_abs = fabsf(co_2b),
      co_2c_size = co_2a_abs + co_2b_abs, co_2d_abs = fabsf(co_2d),
      co_2_size = co_2c_size + co_2d_abs;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, co_3d_abs = fabsf(co_3d),
      co_3_size = co_3c_size + co_3d_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, co_4d_abs = fabsf(co_4d),
      co_4_size = co_4c_size + co_4d_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, co_5d_abs = fabsf(co_5d),
      co_5_size = co_5c_size + co_5d_abs;
  const float co_0_padded = co_0_size + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(1.7881396e-07f, co_0_padded);
  const float co_1_padded = co_1_size + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(1.7881396e-07f, co_1_padded);
  const float co_2_padded = co_2_size + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(1.7881396e-07f, co_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrinvcf_certified(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MULF(R->m20, ci->m2), co_0 = co_0c + co_0d;
  const float co_1a = KSL_MULF(R->m01, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MULF(R->m21, ci->m2), co_1 = co_1c + co_1d;
  const float co_2a = KSL_MULF(R->m02, ci->m0), co_2b = KSL_MULF(R->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MULF(R->m22, ci->m2), co_2 = co_2c + co_2d;
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m10, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MULF(R->m20, ci->m5), co_3 = co_3c + co_3d;
  const float co_4a = KSL_MULF(R->m01, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MULF(R->m21, ci->m5), co_4 = co_4c + co_4d;
  const float co_5a = KSL_MULF(R->m02, ci->m3), co_5b = KSL_MULF(R->m12, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MULF(R->m22, ci->m5), co_5 = co_5c + co_5d;
  const float co_0a_abs = fabsf(co_0a), co_0b_abs = fabsf(co_0b),
      co_0c_size = co_0a_abs + co_0b_abs, co_0d_abs = fabsf(co_0d),
      co_0_size = co_0c_size + co_0d_abs;
  const float co_1a_abs = fabsf(co_1a), co_1b_abs = fabsf(co_1b),
      co_1c_size = co_1a_abs + co_1b_abs, co_1d_abs = fabsf(co_1d),
      co_1_size = co_1c_size + co_1d_abs;
  const float co_2a_abs = fabsf(co_2a), co_2b_abs = fabsf(co_2b),
      co_2c_size = co_2a_abs + co_2b_abs, co_2d_abs = fabsf(co_2d),
      co_2_size = co_2c_size + co_2d_abs;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, co_3d_abs = fabsf(co_3d),
      co_3_size = co_3c_size + co_3d_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, co_4d_abs = fabsf(co_4d),
      co_4_size = co_4c_size + co_4d_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, co_5d_abs = fabsf(co_5d),
      co_5_size = co_5c_size + co_5d_abs;
  const float co_0_padded = co_0_size + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(1.7881396e-07f, co_0_padded);
  const float co_1_padded = co_1_size + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(1.7881396e-07f, co_1_padded);
  const float co_2_padded = co_2_size + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(1.7881396e-07f, co_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_CoAdrcinvf_certified(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MULF(R->m02, ci->m2), co_0e = co_0c + co_0d, co_0 = -co_0e;
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MULF(R->m12, ci->m2), co_1e = co_1c + co_1d, co_1 = -co_1e;
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2b = KSL_MULF(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MULF(R->m22, ci->m2), co_2e = co_2c + co_2d, co_2 = -co_2e;
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3d = KSL_MULF(R->m02, ci->m5), co_3e = co_3c + co_3d, co_3 = -co_3e;
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4d = KSL_MULF(R->m12, ci->m5), co_4e = co_4c + co_4d, co_4 = -co_4e;
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5b = KSL_MULF(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5d = KSL_MULF(R->m22, ci->m5), co_5e = co_5c + co_5d, co_5 = -co_5e;
  const float co_0a_abs = fabsf(co_0a), co_0b_abs = fabsf(co_0b),
      co_0c_size = co_0a_abs + co_0b_abs, co_0d_abs = fabsf(co_0d),
      co_0e_size = co_0c_size + co_0d_abs;
  const float co_1a_abs = fabsf(co_1a), co_1b_abs = fabsf(co_1b),
      co_1c_size = co_1a_abs + co_1b_abs, co_1d_abs = fabsf(co_1d),
      co_1e_size = co_1c_size + co_1d_abs;
  const float co_2a_abs = fabsf(co_2a), co_2b_abs = fabsf(co_2b),
      co_2c_size = co_2a_abs + co_2b_abs, co_2d_abs = fabsf(co_2d),
      co_2e_size = co_2c_size + co_2d_abs;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, co_3d_abs = fabsf(co_3d),
      co_3e_size = co_3c_size + co_3d_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, co_4d_abs = fabsf(co_4d),
      co_4e_size = co_4c_size + co_4d_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, co_5d_abs = fabsf(co_5d),
      co_5e_size = co_5c_size + co_5d_abs;
  const float co_0e_padded = co_0e_size + 1.9721523e-31f,
      co_0e_error_bound = KSL_MULF(1.7881396e-07f, co_0e_padded);
  const float co_1e_padded = co_1e_size + 1.9721523e-31f,
      co_1e_error_bound = KSL_MULF(1.7881396e-07f, co_1e_padded);
  const float co_2e_padded = co_2e_size + 1.9721523e-31f,
      co_2e_error_bound = KSL_MULF(1.7881396e-07f, co_2e_padded);
  const float co_3e_padded = co_3e_size + 1.9721523e-31f,
      co_3e_error_bound = KSL_MULF(1.7881396e-07f, co_3e_padded);
  const float co_4e_padded = co_4e_size + 1.9721523e-31f,
      co_4e_error_bound = KSL_MULF(1.7881396e-07f, co_4e_padded);
  const float co_5e_padded = co_5e_size + 1.9721523e-31f,
      co_5e_error_bound = KSL_MULF(1.7881396e-07f, co_5e_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0e_error_bound;
  co_bound->m1 = co_1e_error_bound;
  co_bound->m2 = co_2e_error_bound;
  co_bound->m3 = co_3e_error_bound;
  co_bound->m4 = co_4e_error_bound;
  co_bound->m5 = co_5e_error_bound;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_CoAdcf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0b = KSL_MULF(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, ci->m2), w_0 = w_0c + w_0d;
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1b = KSL_MULF(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, ci->m2), w_1 = w_1c + w_1d;
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2b = KSL_MULF(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, ci->m2), w_2 = w_2c + w_2d;
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3b = KSL_MULF(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, ci->m5), w_3 = w_3c + w_3d;
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4b = KSL_MULF(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, ci->m5), w_4 = w_4c + w_4d;
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5b = KSL_MULF(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, ci->m5), w_5 = w_5c + w_5d;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.7881396e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.7881396e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_CoAdinvcf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3a = KSL_MULF(D->m23, ci->m1), w_3b = KSL_MULF(D->m13, ci->m2), w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const float w_4a = KSL_MULF(D->m03, ci->m2), w_4b = KSL_MULF(D->m23, ci->m0), w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const float w_5a = KSL_MULF(D->m13, ci->m0), w_5b = KSL_MULF(D->m03, ci->m1), w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const float co_0a = KSL_MULF(D->m00, ci->m0), co_0b = KSL_MULF(D->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0d = KSL_MULF(D->m20, ci->m2), co_0 = co_0c + co_0d;
  const float co_1a = KSL_MULF(D->m01, ci->m0), co_1b = KSL_MULF(D->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1d = KSL_MULF(D->m21, ci->m2), co_1 = co_1c + co_1d;
  const float co_2a = KSL_MULF(D->m02, ci->m0), co_2b = KSL_MULF(D->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2d = KSL_MULF(D->m22, ci->m2), co_2 = co_2c + co_2d;
  const float co_3a = KSL_MULF(D->m00, w_3), co_3b = KSL_MULF(D->m10, w_4), co_3c = co_3a + co_3b,
      co_3d = KSL_MULF(D->m20, w_5), co_3 = co_3c + co_3d;
  const float co_4a = KSL_MULF(D->m01, w_3), co_4b = KSL_MULF(D->m11, w_4), co_4c = co_4a + co_4b,
      co_4d = KSL_MULF(D->m21, w_5), co_4 = co_4c + co_4d;
  const float co_5a = KSL_MULF(D->m02, w_3), co_5b = KSL_MULF(D->m12, w_4), co_5c = co_5a + co_5b,
      co_5d = KSL_MULF(D->m22, w_5), co_5 = co_5c + co_5d;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      ci_3_abs = fabsf(ci->m3), w_3_size = w_3c_size + ci_3_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      ci_4_abs = fabsf(ci->m4), w_4_size = w_4c_size + ci_4_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      ci_5_abs = fabsf(ci->m5), w_5_size = w_5c_size + ci_5_abs;
  const float co_0a_abs = fabsf(co_0a), co_0b_abs = fabsf(co_0b),
      co_0c_size = co_0a_abs + co_0b_abs, co_0d_abs = fabsf(co_0d),
      co_0_size = co_0c_size + co_0d_abs;
  const float co_1a_abs = fabsf(co_1a), co_1b_abs = fabsf(co_1b),
      co_1c_size = co_1a_abs + co_1b_abs, co_1d_abs = fabsf(co_1d),
      co_1_size = co_1c_size + co_1d_abs;
  const float co_2a_abs = fabsf(co_2a), co_2b_abs = fabsf(co_2b),
      co_2c_size = co_2a_abs + co_2b_abs, co_2d_abs = fabsf(co_2d),
      co_2_size = co_2c_size + co_2d_abs;
  const float w_3_padded = w_3_size + 1.9721523e-31f;
  const float D_00_abs = fabsf(D->m00), co_3a_size = KSL_MULF(D_00_abs, w_3_padded);
  const float w_4_padded = w_4_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10), co_3b_size = KSL_MULF(D_10_abs, w_4_padded),
      co_3c_size = co_3a_size + co_3b_size;
  const float w_5_padded = w_5_size + 1.9721523e-31f;
  const float D_20_abs = fabsf(D->m20), co_3d_size = KSL_MULF(D_20_abs, w_5_padded),
      co_3_size = co_3c_size + co_3d_size;
  const float D_01_abs = fabsf(D->m01), co_4a_size = KSL_MULF(D_01_abs, w_3_padded),
      D_11_abs = fabsf(D->m11), co_4b_size = KSL_MULF(D_11_abs, w_4_padded),
      co_4c_size = co_4a_size + co_4b_size, D_21_abs = fabsf(D->m21),
      co_4d_size = KSL_MULF(D_21_abs, w_5_padded), co_4_size = co_4c_size + co_4d_size;
  const float D_02_abs = fabsf(D->m02), co_5a_size = KSL_MULF(D_02_abs, w_3_padded),
      D_12_abs = fabsf(D->m12), co_5b_size = KSL_MULF(D_12_abs, w_4_padded),
      co_5c_size = co_5a_size + co_5b_size, D_22_abs = fabsf(D->m22),
      co_5d_size = KSL_MULF(D_22_abs, w_5_padded), co_5_size = co_5c_size + co_5d_size;
  const float co_0_padded = co_0_size + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(1.7881396e-07f, co_0_padded);
  const float co_1_padded = co_1_size + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(1.7881396e-07f, co_1_padded);
  const float co_2_padded = co_2_size + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(1.7881396e-07f, co_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_CoAdcinvf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0b = KSL_MULF(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, ci->m2), w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1b = KSL_MULF(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, ci->m2), w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2b = KSL_MULF(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, ci->m2), w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3b = KSL_MULF(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, ci->m5), w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4b = KSL_MULF(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, ci->m5), w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5b = KSL_MULF(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, ci->m5), w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0e_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1e_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2e_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3e_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4e_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5e_size = w_5c_size + w_5d_abs;
  const float w_2e_padded = w_2e_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2e_padded);
  const float w_1e_padded = w_1e_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1e_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3e_size;
  const float w_0e_padded = w_0e_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0e_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2e_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4e_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1e_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0e_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5e_size;
  const float w_0e_error_bound = KSL_MULF(1.7881396e-07f, w_0e_padded);
  const float w_1e_error_bound = KSL_MULF(1.7881396e-07f, w_1e_padded);
  const float w_2e_error_bound = KSL_MULF(1.7881396e-07f, w_2e_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0e_error_bound;
  co_bound->m1 = w_1e_error_bound;
  co_bound->m2 = w_2e_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctxf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m20, D->m13), co_3b = KSL_MULF(D->m10, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m00, D->m23), co_4b = KSL_MULF(D->m20, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m10, D->m03), co_5b = KSL_MULF(D->m00, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctyf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m21, D->m13), co_3b = KSL_MULF(D->m11, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m01, D->m23), co_4b = KSL_MULF(D->m21, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m11, D->m03), co_5b = KSL_MULF(D->m01, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctzf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m22, D->m13), co_3b = KSL_MULF(D->m12, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m02, D->m23), co_4b = KSL_MULF(D->m22, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m12, D->m03), co_5b = KSL_MULF(D->m02, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctxinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m00;
  const float co_1 = -D->m10;
  const float co_2 = -D->m20;
  const float co_3a = KSL_MULF(D->m10, D->m23), co_3b = KSL_MULF(D->m20, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m20, D->m03), co_4b = KSL_MULF(D->m00, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m00, D->m13), co_5b = KSL_MULF(D->m10, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctyinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m01;
  const float co_1 = -D->m11;
  const float co_2 = -D->m21;
  const float co_3a = KSL_MULF(D->m11, D->m23), co_3b = KSL_MULF(D->m21, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m21, D->m03), co_4b = KSL_MULF(D->m01, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m01, D->m13), co_5b = KSL_MULF(D->m11, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctzinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m02;
  const float co_1 = -D->m12;
  const float co_2 = -D->m22;
  const float co_3a = KSL_MULF(D->m12, D->m23), co_3b = KSL_MULF(D->m22, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m22, D->m03), co_4b = KSL_MULF(D->m02, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m02, D->m13), co_5b = KSL_MULF(D->m12, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_CoAdf_certified(const ksl_SE3f_t *D, ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *M_bound) {
  const float M_30a = KSL_MULF(D->m20, D->m13), M_30b = KSL_MULF(D->m10, D->m23),
      M_30 = M_30a - M_30b;
  const float M_31a = KSL_MULF(D->m21, D->m13), M_31b = KSL_MULF(D->m11, D->m23),
      M_31 = M_31a - M_31b;
  const float M_32a = KSL_MULF(D->m22, D->m13), M_32b = KSL_MULF(D->m12, D->m23),
      M_32 = M_32a - M_32b;
  const float M_40a = KSL_MULF(D->m00, D->m23), M_40b = KSL_MULF(D->m20, D->m03),
      M_40 = M_40a - M_40b;
  const float M_41a = KSL_MULF(D->m01, D->m23), M_41b = KSL_MULF(D->m21, D->m03),
      M_41 = M_41a - M_41b;
  const float M_42a = KSL_MULF(D->m02, D->m23), M_42b = KSL_MULF(D->m22, D->m03),
      M_42 = M_42a - M_42b;
  const float M_50a = KSL_MULF(D->m10, D->m03), M_50b = KSL_MULF(D->m00, D->m13),
      M_50 = M_50a - M_50b;
  const float M_51a = KSL_MULF(D->m11, D->m03), M_51b = KSL_MULF(D->m01, D->m13),
      M_51 = M_51a - M_51b;
  const float M_52a = KSL_MULF(D->m12, D->m03), M_52b = KSL_MULF(D->m02, D->m13),
      M_52 = M_52a - M_52b;
  const float M_30a_abs = fabsf(M_30a), M_30b_abs = fabsf(M_30b), M_30_size = M_30a_abs + M_30b_abs;
  const float M_31a_abs = fabsf(M_31a), M_31b_abs = fabsf(M_31b), M_31_size = M_31a_abs + M_31b_abs;
  const float M_32a_abs = fabsf(M_32a), M_32b_abs = fabsf(M_32b), M_32_size = M_32a_abs + M_32b_abs;
  const float M_40a_abs = fabsf(M_40a), M_40b_abs = fabsf(M_40b), M_40_size = M_40a_abs + M_40b_abs;
  const float M_41a_abs = fabsf(M_41a), M_41b_abs = fabsf(M_41b), M_41_size = M_41a_abs + M_41b_abs;
  const float M_42a_abs = fabsf(M_42a), M_42b_abs = fabsf(M_42b), M_42_size = M_42a_abs + M_42b_abs;
  const float M_50a_abs = fabsf(M_50a), M_50b_abs = fabsf(M_50b), M_50_size = M_50a_abs + M_50b_abs;
  const float M_51a_abs = fabsf(M_51a), M_51b_abs = fabsf(M_51b), M_51_size = M_51a_abs + M_51b_abs;
  const float M_52a_abs = fabsf(M_52a), M_52b_abs = fabsf(M_52b), M_52_size = M_52a_abs + M_52b_abs;
  const float M_30_padded = M_30_size + 1.9721523e-31f,
      M_30_error_bound = KSL_MULF(1.192093e-07f, M_30_padded);
  const float M_31_padded = M_31_size + 1.9721523e-31f,
      M_31_error_bound = KSL_MULF(1.192093e-07f, M_31_padded);
  const float M_32_padded = M_32_size + 1.9721523e-31f,
      M_32_error_bound = KSL_MULF(1.192093e-07f, M_32_padded);
  const float M_40_padded = M_40_size + 1.9721523e-31f,
      M_40_error_bound = KSL_MULF(1.192093e-07f, M_40_padded);
  const float M_41_padded = M_41_size + 1.9721523e-31f,
      M_41_error_bound = KSL_MULF(1.192093e-07f, M_41_padded);
  const float M_42_padded = M_42_size + 1.9721523e-31f,
      M_42_error_bound = KSL_MULF(1.192093e-07f, M_42_padded);
  const float M_50_padded = M_50_size + 1.9721523e-31f,
      M_50_error_bound = KSL_MULF(1.192093e-07f, M_50_padded);
  const float M_51_padded = M_51_size + 1.9721523e-31f,
      M_51_error_bound = KSL_MULF(1.192093e-07f, M_51_padded);
  const float M_52_padded = M_52_size + 1.9721523e-31f,
      M_52_error_bound = KSL_MULF(1.192093e-07f, M_52_padded);
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
  M_bound->at[0][0] = 0.0f;
  M_bound->at[1][0] = 0.0f;
  M_bound->at[2][0] = 0.0f;
  M_bound->at[3][0] = 0.0f;
  M_bound->at[4][0] = 0.0f;
  M_bound->at[5][0] = 0.0f;
  M_bound->at[0][1] = 0.0f;
  M_bound->at[1][1] = 0.0f;
  M_bound->at[2][1] = 0.0f;
  M_bound->at[3][1] = 0.0f;
  M_bound->at[4][1] = 0.0f;
  M_bound->at[5][1] = 0.0f;
  M_bound->at[0][2] = 0.0f;
  M_bound->at[1][2] = 0.0f;
  M_bound->at[2][2] = 0.0f;
  M_bound->at[3][2] = 0.0f;
  M_bound->at[4][2] = 0.0f;
  M_bound->at[5][2] = 0.0f;
  M_bound->at[0][3] = M_30_error_bound;
  M_bound->at[1][3] = M_31_error_bound;
  M_bound->at[2][3] = M_32_error_bound;
  M_bound->at[3][3] = 0.0f;
  M_bound->at[4][3] = 0.0f;
  M_bound->at[5][3] = 0.0f;
  M_bound->at[0][4] = M_40_error_bound;
  M_bound->at[1][4] = M_41_error_bound;
  M_bound->at[2][4] = M_42_error_bound;
  M_bound->at[3][4] = 0.0f;
  M_bound->at[4][4] = 0.0f;
  M_bound->at[5][4] = 0.0f;
  M_bound->at[0][5] = M_50_error_bound;
  M_bound->at[1][5] = M_51_error_bound;
  M_bound->at[2][5] = M_52_error_bound;
  M_bound->at[3][5] = 0.0f;
  M_bound->at[4][5] = 0.0f;
  M_bound->at[5][5] = 0.0f;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
     unless inf or NaN.
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top; power_bound:
     number.
   7 mul, 11 add, 6 abs. */
static inline float ksl_reciprocal_productf_certified(const ksl_coscrewf_t *c, const float x[6],
    float *power_bound) {
  const float power_a = KSL_MULF(c->m0, x[3]), power_b = KSL_MULF(c->m1, x[4]),
      power_c = power_a + power_b, power_d = KSL_MULF(c->m2, x[5]), power_e = power_c + power_d,
      power_f = KSL_MULF(c->m3, x[0]), power_g = KSL_MULF(c->m4, x[1]), power_h = power_f + power_g,
      power_i = KSL_MULF(c->m5, x[2]), power_j = power_h + power_i, power = power_e + power_j;
  const float power_a_abs = fabsf(power_a), power_b_abs = fabsf(power_b),
      power_c_size = power_a_abs + power_b_abs, power_d_abs = fabsf(power_d),
      power_e_size = power_c_size + power_d_abs, power_f_abs = fabsf(power_f),
      power_g_abs = fabsf(power_g), power_h_size = power_f_abs + power_g_abs,
      power_i_abs = fabsf(power_i), power_j_size = power_h_size + power_i_abs,
      power_size = power_e_size + power_j_size;
  const float power_padded = power_size + 1.9721523e-31f,
      power_error_bound = KSL_MULF(2.3841864e-07f, power_padded);
  *power_bound = power_error_bound;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_scf_certified(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(s->m4, c->m2), co_0b = KSL_MULF(s->m5, c->m1), co_0 = co_0a - co_0b;
  const float co_1a = KSL_MULF(s->m5, c->m0), co_1b = KSL_MULF(s->m3, c->m2), co_1 = co_1a - co_1b;
  const float co_2a = KSL_MULF(s->m3, c->m1), co_2b = KSL_MULF(s->m4, c->m0), co_2 = co_2a - co_2b;
  const float co_3a = KSL_MULF(s->m1, c->m2), co_3b = KSL_MULF(s->m2, c->m1), co_3c = co_3a - co_3b,
      co_3d = KSL_MULF(s->m4, c->m5), co_3e = KSL_MULF(s->m5, c->m4), co_3f = co_3d - co_3e,
      co_3 = co_3c + co_3f;
  const float co_4a = KSL_MULF(s->m2, c->m0), co_4b = KSL_MULF(s->m0, c->m2), co_4c = co_4a - co_4b,
      co_4d = KSL_MULF(s->m5, c->m3), co_4e = KSL_MULF(s->m3, c->m5), co_4f = co_4d - co_4e,
      co_4 = co_4c + co_4f;
  const float co_5a = KSL_MULF(s->m0, c->m1), co_5b = KSL_MULF(s->m1, c->m0), co_5c = co_5a - co_5b,
      co_5d = KSL_MULF(s->m3, c->m4), co_5e = KSL_MULF(s->m4, c->m3), co_5f = co_5d - co_5e,
      co_5 = co_5c + co_5f;
  const float co_0a_abs = fabsf(co_0a), co_0b_abs = fabsf(co_0b), co_0_size = co_0a_abs + co_0b_abs;
  const float co_1a_abs = fabsf(co_1a), co_1b_abs = fabsf(co_1b), co_1_size = co_1a_abs + co_1b_abs;
  const float co_2a_abs = fabsf(co_2a), co_2b_abs = fabsf(co_2b), co_2_size = co_2a_abs + co_2b_abs;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, co_3d_abs = fabsf(co_3d), co_3e_abs = fabsf(co_3e),
      co_3f_size = co_3d_abs + co_3e_abs, co_3_size = co_3c_size + co_3f_size;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, co_4d_abs = fabsf(co_4d), co_4e_abs = fabsf(co_4e),
      co_4f_size = co_4d_abs + co_4e_abs, co_4_size = co_4c_size + co_4f_size;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, co_5d_abs = fabsf(co_5d), co_5e_abs = fabsf(co_5e),
      co_5f_size = co_5d_abs + co_5e_abs, co_5_size = co_5c_size + co_5f_size;
  const float co_0_padded = co_0_size + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(1.192093e-07f, co_0_padded);
  const float co_1_padded = co_1_size + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(1.192093e-07f, co_1_padded);
  const float co_2_padded = co_2_size + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(1.192093e-07f, co_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_scaf_certified(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(s->m4, c->m5), co_3b = KSL_MULF(s->m5, c->m4), co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(s->m5, c->m3), co_4b = KSL_MULF(s->m3, c->m5), co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(s->m3, c->m4), co_5b = KSL_MULF(s->m4, c->m3), co_5 = co_5a - co_5b;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b), co_3_size = co_3a_abs + co_3b_abs;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b), co_4_size = co_4a_abs + co_4b_abs;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b), co_5_size = co_5a_abs + co_5b_abs;
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.192093e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.192093e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.192093e-07f, co_5_padded);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m01, c->m1), w_0b = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m11, c->m1), w_1b = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m21, c->m1), w_2b = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3c + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4c + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5c + w_5d;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.192093e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.192093e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(2.9802328e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(2.9802328e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(2.9802328e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctyf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3c + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4c + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5c + w_5d;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.192093e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.192093e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(2.9802328e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(2.9802328e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(2.9802328e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3c + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4c + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5c + w_5d;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0_size = w_0a_abs + w_0b_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1_size = w_1a_abs + w_1b_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2_size = w_2a_abs + w_2b_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3c_size = w_3a_abs + w_3b_abs,
      w_3d_abs = fabsf(w_3d), w_3_size = w_3c_size + w_3d_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4c_size = w_4a_abs + w_4b_abs,
      w_4d_abs = fabsf(w_4d), w_4_size = w_4c_size + w_4d_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5c_size = w_5a_abs + w_5b_abs,
      w_5d_abs = fabsf(w_5d), w_5_size = w_5c_size + w_5d_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.192093e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.192093e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(2.9802328e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(2.9802328e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(2.9802328e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0c + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1c + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2c + w_2d;
  const float w_3a = KSL_MULF(D->m01, c->m4), w_3b = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m11, c->m4), w_4b = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m21, c->m4), w_5b = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.7881396e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.7881396e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cryf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0c + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1c + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2c + w_2d;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.7881396e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.7881396e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0c + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1c + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2c + w_2d;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4), w_5 = w_5a + w_5b;
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  const float w_0a_abs = fabsf(w_0a), w_0b_abs = fabsf(w_0b), w_0c_size = w_0a_abs + w_0b_abs,
      w_0d_abs = fabsf(w_0d), w_0_size = w_0c_size + w_0d_abs;
  const float w_1a_abs = fabsf(w_1a), w_1b_abs = fabsf(w_1b), w_1c_size = w_1a_abs + w_1b_abs,
      w_1d_abs = fabsf(w_1d), w_1_size = w_1c_size + w_1d_abs;
  const float w_2a_abs = fabsf(w_2a), w_2b_abs = fabsf(w_2b), w_2c_size = w_2a_abs + w_2b_abs,
      w_2d_abs = fabsf(w_2d), w_2_size = w_2c_size + w_2d_abs;
  const float w_3a_abs = fabsf(w_3a), w_3b_abs = fabsf(w_3b), w_3_size = w_3a_abs + w_3b_abs;
  const float w_4a_abs = fabsf(w_4a), w_4b_abs = fabsf(w_4b), w_4_size = w_4a_abs + w_4b_abs;
  const float w_5a_abs = fabsf(w_5a), w_5b_abs = fabsf(w_5b), w_5_size = w_5a_abs + w_5b_abs;
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3c_size = co_3a_size + co_3b_size, co_3_size = co_3c_size + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4c_size = co_4a_size + co_4b_size,
      co_4_size = co_4c_size + w_4_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5c_size = co_5a_size + co_5b_size,
      co_5_size = co_5c_size + w_5_size;
  const float w_0_error_bound = KSL_MULF(1.7881396e-07f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(1.7881396e-07f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(3.5762795e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(3.5762795e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(3.5762795e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m00, c->m0);
  const float w_1 = KSL_MULF(D->m10, c->m0);
  const float w_2 = KSL_MULF(D->m20, c->m0);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5 = co_5a - co_5b;
  const float w_2_abs = fabsf(w_2), w_2_padded = w_2_abs + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_abs = fabsf(w_1), w_1_padded = w_1_abs + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const float w_0_abs = fabsf(w_0), w_0_padded = w_0_abs + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const float w_0_error_bound = KSL_MULF(5.960465e-08f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(5.960465e-08f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctyf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m01, c->m1);
  const float w_1 = KSL_MULF(D->m11, c->m1);
  const float w_2 = KSL_MULF(D->m21, c->m1);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5 = co_5a - co_5b;
  const float w_2_abs = fabsf(w_2), w_2_padded = w_2_abs + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_abs = fabsf(w_1), w_1_padded = w_1_abs + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const float w_0_abs = fabsf(w_0), w_0_padded = w_0_abs + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const float w_0_error_bound = KSL_MULF(5.960465e-08f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(5.960465e-08f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m02, c->m2);
  const float w_1 = KSL_MULF(D->m12, c->m2);
  const float w_2 = KSL_MULF(D->m22, c->m2);
  const float co_3a = KSL_MULF(D->m13, w_2), co_3b = KSL_MULF(D->m23, w_1), co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m23, w_0), co_4b = KSL_MULF(D->m03, w_2), co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m03, w_1), co_5b = KSL_MULF(D->m13, w_0), co_5 = co_5a - co_5b;
  const float w_2_abs = fabsf(w_2), w_2_padded = w_2_abs + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), co_3a_size = KSL_MULF(D_13_abs, w_2_padded);
  const float w_1_abs = fabsf(w_1), w_1_padded = w_1_abs + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), co_3b_size = KSL_MULF(D_23_abs, w_1_padded),
      co_3_size = co_3a_size + co_3b_size;
  const float w_0_abs = fabsf(w_0), w_0_padded = w_0_abs + 1.9721523e-31f;
  const float co_4a_size = KSL_MULF(D_23_abs, w_0_padded), D_03_abs = fabsf(D->m03),
      co_4b_size = KSL_MULF(D_03_abs, w_2_padded), co_4_size = co_4a_size + co_4b_size;
  const float co_5a_size = KSL_MULF(D_03_abs, w_1_padded),
      co_5b_size = KSL_MULF(D_13_abs, w_0_padded), co_5_size = co_5a_size + co_5b_size;
  const float w_0_error_bound = KSL_MULF(5.960465e-08f, w_0_padded);
  const float w_1_error_bound = KSL_MULF(5.960465e-08f, w_1_padded);
  const float w_2_error_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(1.7881396e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(1.7881396e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(1.7881396e-07f, co_5_padded);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_error_bound;
  co_bound->m1 = w_1_error_bound;
  co_bound->m2 = w_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m00, c->m3);
  const float w_4 = KSL_MULF(D->m10, c->m3);
  const float w_5 = KSL_MULF(D->m20, c->m3);
  const float w_3_abs = fabsf(w_3), w_3_padded = w_3_abs + 1.9721523e-31f,
      w_3_error_bound = KSL_MULF(5.960465e-08f, w_3_padded);
  const float w_4_abs = fabsf(w_4), w_4_padded = w_4_abs + 1.9721523e-31f,
      w_4_error_bound = KSL_MULF(5.960465e-08f, w_4_padded);
  const float w_5_abs = fabsf(w_5), w_5_padded = w_5_abs + 1.9721523e-31f,
      w_5_error_bound = KSL_MULF(5.960465e-08f, w_5_padded);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_cryf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m01, c->m4);
  const float w_4 = KSL_MULF(D->m11, c->m4);
  const float w_5 = KSL_MULF(D->m21, c->m4);
  const float w_3_abs = fabsf(w_3), w_3_padded = w_3_abs + 1.9721523e-31f,
      w_3_error_bound = KSL_MULF(5.960465e-08f, w_3_padded);
  const float w_4_abs = fabsf(w_4), w_4_padded = w_4_abs + 1.9721523e-31f,
      w_4_error_bound = KSL_MULF(5.960465e-08f, w_4_padded);
  const float w_5_abs = fabsf(w_5), w_5_padded = w_5_abs + 1.9721523e-31f,
      w_5_error_bound = KSL_MULF(5.960465e-08f, w_5_padded);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m02, c->m5);
  const float w_4 = KSL_MULF(D->m12, c->m5);
  const float w_5 = KSL_MULF(D->m22, c->m5);
  const float w_3_abs = fabsf(w_3), w_3_padded = w_3_abs + 1.9721523e-31f,
      w_3_error_bound = KSL_MULF(5.960465e-08f, w_3_padded);
  const float w_4_abs = fabsf(w_4), w_4_padded = w_4_abs + 1.9721523e-31f,
      w_4_error_bound = KSL_MULF(5.960465e-08f, w_4_padded);
  const float w_5_abs = fabsf(w_5), w_5_padded = w_5_abs + 1.9721523e-31f,
      w_5_error_bound = KSL_MULF(5.960465e-08f, w_5_padded);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_error_bound;
  co_bound->m4 = w_4_error_bound;
  co_bound->m5 = w_5_error_bound;
}

#endif

/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_QUATERNION_CERTIFIED_H
#define KSL_QUATERNION_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_quaternion_scale_certified(ksl_quaternion_t *self, const double a,
    ksl_quaternion_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
}

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf or
     NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qq_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->x, q2->w), qo_0b = KSL_MUL(q1->y, q2->z),
      qo_0c = KSL_MUL(q1->z, q2->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MUL(q1->w, q2->x), qo_0 = qo_0e + qo_0f;
  const double qo_1a = KSL_MUL(q1->z, q2->x), qo_1b = KSL_MUL(q1->x, q2->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->y, q2->w), qo_1e = qo_1c + qo_1d, qo_1f = KSL_MUL(q1->w, q2->y),
      qo_1 = qo_1e + qo_1f;
  const double qo_2a = KSL_MUL(q1->x, q2->y), qo_2b = KSL_MUL(q1->y, q2->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->z, q2->w), qo_2e = qo_2c + qo_2d, qo_2f = KSL_MUL(q1->w, q2->z),
      qo_2 = qo_2e + qo_2f;
  const double qo_3a = KSL_MUL(q1->w, q2->w), qo_3b = KSL_MUL(q1->x, q2->x),
      qo_3c = KSL_MUL(q1->y, q2->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MUL(q1->z, q2->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const double qo_0b_abs = fabs(qo_0b), qo_0c_abs = fabs(qo_0c), qo_0d_size = qo_0b_abs + qo_0c_abs,
      qo_0a_abs = fabs(qo_0a), qo_0e_size = qo_0a_abs + qo_0d_size, qo_0f_abs = fabs(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabs(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabs(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const double qo_3b_abs = fabs(qo_3b), qo_3c_abs = fabs(qo_3c), qo_3d_size = qo_3b_abs + qo_3c_abs,
      qo_3e_abs = fabs(qo_3e), qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabs(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(4.440892098500628e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(4.440892098500628e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(4.440892098500628e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjq_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->w, q2->x), qo_0b = KSL_MUL(q1->x, q2->w), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0e = KSL_MUL(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1b = KSL_MUL(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->w, q2->y), qo_1e = KSL_MUL(q1->y, q2->w), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2b = KSL_MUL(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->w, q2->z), qo_2e = KSL_MUL(q1->z, q2->w), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3b = KSL_MUL(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MUL(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0e_abs = fabs(qo_0e), qo_0f_size = qo_0d_abs + qo_0e_abs,
      qo_0_size = qo_0c_size + qo_0f_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_abs = fabs(qo_1e), qo_1f_size = qo_1d_abs + qo_1e_abs,
      qo_1_size = qo_1c_size + qo_1f_size;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_abs = fabs(qo_2e), qo_2f_size = qo_2d_abs + qo_2e_abs,
      qo_2_size = qo_2c_size + qo_2f_size;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabs(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconj_certified(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo, ksl_quaternion_t *qo_bound) {
  const double qo_0a = KSL_MUL(q1->x, q2->w), qo_0b = KSL_MUL(q1->w, q2->x), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MUL(q1->z, q2->y), qo_0e = KSL_MUL(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const double qo_1a = KSL_MUL(q1->x, q2->z), qo_1b = KSL_MUL(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MUL(q1->y, q2->w), qo_1e = KSL_MUL(q1->w, q2->y), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const double qo_2a = KSL_MUL(q1->y, q2->x), qo_2b = KSL_MUL(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MUL(q1->z, q2->w), qo_2e = KSL_MUL(q1->w, q2->z), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const double qo_3a = KSL_MUL(q1->x, q2->x), qo_3b = KSL_MUL(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MUL(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MUL(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
  const double qo_0a_abs = fabs(qo_0a), qo_0b_abs = fabs(qo_0b), qo_0c_size = qo_0a_abs + qo_0b_abs,
      qo_0d_abs = fabs(qo_0d), qo_0e_abs = fabs(qo_0e), qo_0f_size = qo_0d_abs + qo_0e_abs,
      qo_0_size = qo_0c_size + qo_0f_size;
  const double qo_1a_abs = fabs(qo_1a), qo_1b_abs = fabs(qo_1b), qo_1c_size = qo_1a_abs + qo_1b_abs,
      qo_1d_abs = fabs(qo_1d), qo_1e_abs = fabs(qo_1e), qo_1f_size = qo_1d_abs + qo_1e_abs,
      qo_1_size = qo_1c_size + qo_1f_size;
  const double qo_2a_abs = fabs(qo_2a), qo_2b_abs = fabs(qo_2b), qo_2c_size = qo_2a_abs + qo_2b_abs,
      qo_2d_abs = fabs(qo_2d), qo_2e_abs = fabs(qo_2e), qo_2f_size = qo_2d_abs + qo_2e_abs,
      qo_2_size = qo_2c_size + qo_2f_size;
  const double qo_3a_abs = fabs(qo_3a), qo_3b_abs = fabs(qo_3b), qo_3c_size = qo_3a_abs + qo_3b_abs,
      qo_3d_abs = fabs(qo_3d), qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabs(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const double qo_0_padded = qo_0_size + 2.004168360008973e-292,
      qo_0_error_bound = KSL_MUL(3.3306690738754706e-16, qo_0_padded);
  const double qo_1_padded = qo_1_size + 2.004168360008973e-292,
      qo_1_error_bound = KSL_MUL(3.3306690738754706e-16, qo_1_padded);
  const double qo_2_padded = qo_2_size + 2.004168360008973e-292,
      qo_2_error_bound = KSL_MUL(3.3306690738754706e-16, qo_2_padded);
  const double qo_3_padded = qo_3_size + 2.004168360008973e-292,
      qo_3_error_bound = KSL_MUL(4.440892098500628e-16, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->y, v->z), c_0b = KSL_MUL(q->z, v->y), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->z, v->x), c_1b = KSL_MUL(q->x, v->z), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->x, v->y), c_2b = KSL_MUL(q->y, v->x), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->y, t_2), turn_0b = KSL_MUL(q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL(q->z, t_0), turn_1b = KSL_MUL(q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL(q->x, t_1), turn_2b = KSL_MUL(q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  const double c_0a_abs = fabs(c_0a), c_0b_abs = fabs(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const double c_1a_abs = fabs(c_1a), c_1b_abs = fabs(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const double c_2a_abs = fabs(c_2a), c_2b_abs = fabs(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const double c_0_padded = c_0_size + 2.004168360008973e-292;
  const double t_0_size = KSL_MUL(2.0, c_0_padded);
  const double c_1_padded = c_1_size + 2.004168360008973e-292;
  const double t_1_size = KSL_MUL(2.0, c_1_padded);
  const double c_2_padded = c_2_size + 2.004168360008973e-292;
  const double t_2_size = KSL_MUL(2.0, c_2_padded);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y), turn_0a_size = KSL_MUL(q_1_abs, t_2_padded);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z), turn_0b_size = KSL_MUL(q_2_abs, t_1_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w), turn_0d_size = KSL_MUL(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const double turn_1a_size = KSL_MUL(q_2_abs, t_0_padded), q_0_abs = fabs(q->x),
      turn_1b_size = KSL_MUL(q_0_abs, t_2_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MUL(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const double turn_2a_size = KSL_MUL(q_0_abs, t_1_padded),
      turn_2b_size = KSL_MUL(q_1_abs, t_0_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MUL(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const double v_0_abs = fabs(v->x), vo_0_size = v_0_abs + turn_0_size;
  const double v_1_abs = fabs(v->y), vo_1_size = v_1_abs + turn_1_size;
  const double v_2_abs = fabs(v->z), vo_2_size = v_2_abs + turn_2_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(7.7715611723761e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(7.7715611723761e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(7.7715611723761e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qconjv_certified(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double c_0a = KSL_MUL(q->z, v->y), c_0b = KSL_MUL(q->y, v->z), c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(q->x, v->z), c_1b = KSL_MUL(q->z, v->x), c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(q->y, v->x), c_2b = KSL_MUL(q->x, v->y), c_2 = c_2a - c_2b;
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL(q->z, t_1), turn_0b = KSL_MUL(q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL(q->x, t_2), turn_1b = KSL_MUL(q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL(q->y, t_0), turn_2b = KSL_MUL(q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = v->x + turn_0;
  const double vo_1 = v->y + turn_1;
  const double vo_2 = v->z + turn_2;
  const double c_0a_abs = fabs(c_0a), c_0b_abs = fabs(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const double c_1a_abs = fabs(c_1a), c_1b_abs = fabs(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const double c_2a_abs = fabs(c_2a), c_2b_abs = fabs(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const double c_0_padded = c_0_size + 2.004168360008973e-292;
  const double t_0_size = KSL_MUL(2.0, c_0_padded);
  const double c_1_padded = c_1_size + 2.004168360008973e-292;
  const double t_1_size = KSL_MUL(2.0, c_1_padded);
  const double c_2_padded = c_2_size + 2.004168360008973e-292;
  const double t_2_size = KSL_MUL(2.0, c_2_padded);
  const double t_1_padded = t_1_size + 2.004168360008973e-292;
  const double q_2_abs = fabs(q->z), turn_0a_size = KSL_MUL(q_2_abs, t_1_padded);
  const double t_2_padded = t_2_size + 2.004168360008973e-292;
  const double q_1_abs = fabs(q->y), turn_0b_size = KSL_MUL(q_1_abs, t_2_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const double t_0_padded = t_0_size + 2.004168360008973e-292;
  const double q_3_abs = fabs(q->w), turn_0d_size = KSL_MUL(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const double q_0_abs = fabs(q->x), turn_1a_size = KSL_MUL(q_0_abs, t_2_padded),
      turn_1b_size = KSL_MUL(q_2_abs, t_0_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MUL(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const double turn_2a_size = KSL_MUL(q_1_abs, t_0_padded),
      turn_2b_size = KSL_MUL(q_0_abs, t_1_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MUL(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const double v_0_abs = fabs(v->x), vo_0_size = v_0_abs + turn_0_size;
  const double v_1_abs = fabs(v->y), vo_1_size = v_1_abs + turn_1_size;
  const double v_2_abs = fabs(v->z), vo_2_size = v_2_abs + turn_2_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(7.7715611723761e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(7.7715611723761e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(7.7715611723761e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_quaternionf_scale_certified(ksl_quaternionf_t *self, const float a,
    ksl_quaternionf_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
  self_bound->w = self_3_new_error_bound;
}

/* qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf or
     NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->x, q2->w), qo_0b = KSL_MULF(q1->y, q2->z),
      qo_0c = KSL_MULF(q1->z, q2->y), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MULF(q1->w, q2->x), qo_0 = qo_0e + qo_0f;
  const float qo_1a = KSL_MULF(q1->z, q2->x), qo_1b = KSL_MULF(q1->x, q2->z), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->y, q2->w), qo_1e = qo_1c + qo_1d, qo_1f = KSL_MULF(q1->w, q2->y),
      qo_1 = qo_1e + qo_1f;
  const float qo_2a = KSL_MULF(q1->x, q2->y), qo_2b = KSL_MULF(q1->y, q2->x), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->z, q2->w), qo_2e = qo_2c + qo_2d, qo_2f = KSL_MULF(q1->w, q2->z),
      qo_2 = qo_2e + qo_2f;
  const float qo_3a = KSL_MULF(q1->w, q2->w), qo_3b = KSL_MULF(q1->x, q2->x),
      qo_3c = KSL_MULF(q1->y, q2->y), qo_3d = qo_3b + qo_3c, qo_3e = KSL_MULF(q1->z, q2->z),
      qo_3f = qo_3d + qo_3e, qo_3 = qo_3a - qo_3f;
  const float qo_0b_abs = fabsf(qo_0b), qo_0c_abs = fabsf(qo_0c),
      qo_0d_size = qo_0b_abs + qo_0c_abs, qo_0a_abs = fabsf(qo_0a),
      qo_0e_size = qo_0a_abs + qo_0d_size, qo_0f_abs = fabsf(qo_0f),
      qo_0_size = qo_0e_size + qo_0f_abs;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d),
      qo_1e_size = qo_1c_size + qo_1d_abs, qo_1f_abs = fabsf(qo_1f),
      qo_1_size = qo_1e_size + qo_1f_abs;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d),
      qo_2e_size = qo_2c_size + qo_2d_abs, qo_2f_abs = fabsf(qo_2f),
      qo_2_size = qo_2e_size + qo_2f_abs;
  const float qo_3b_abs = fabsf(qo_3b), qo_3c_abs = fabsf(qo_3c),
      qo_3d_size = qo_3b_abs + qo_3c_abs, qo_3e_abs = fabsf(qo_3e),
      qo_3f_size = qo_3d_size + qo_3e_abs, qo_3a_abs = fabsf(qo_3a),
      qo_3_size = qo_3a_abs + qo_3f_size;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(2.3841864e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(2.3841864e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(2.3841864e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qconjqf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->w, q2->x), qo_0b = KSL_MULF(q1->x, q2->w), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0e = KSL_MULF(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1b = KSL_MULF(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->w, q2->y), qo_1e = KSL_MULF(q1->y, q2->w), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2b = KSL_MULF(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->w, q2->z), qo_2e = KSL_MULF(q1->z, q2->w), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3b = KSL_MULF(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MULF(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d), qo_0e_abs = fabsf(qo_0e),
      qo_0f_size = qo_0d_abs + qo_0e_abs, qo_0_size = qo_0c_size + qo_0f_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d), qo_1e_abs = fabsf(qo_1e),
      qo_1f_size = qo_1d_abs + qo_1e_abs, qo_1_size = qo_1c_size + qo_1f_size;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d), qo_2e_abs = fabsf(qo_2e),
      qo_2f_size = qo_2d_abs + qo_2e_abs, qo_2_size = qo_2c_size + qo_2f_size;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabsf(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.
   q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
   20 mul, 28 add, 16 abs. */
static inline void ksl_product_qqconjf_certified(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo, ksl_quaternionf_t *qo_bound) {
  const float qo_0a = KSL_MULF(q1->x, q2->w), qo_0b = KSL_MULF(q1->w, q2->x), qo_0c = qo_0a - qo_0b,
      qo_0d = KSL_MULF(q1->z, q2->y), qo_0e = KSL_MULF(q1->y, q2->z), qo_0f = qo_0d - qo_0e,
      qo_0 = qo_0c + qo_0f;
  const float qo_1a = KSL_MULF(q1->x, q2->z), qo_1b = KSL_MULF(q1->z, q2->x), qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_MULF(q1->y, q2->w), qo_1e = KSL_MULF(q1->w, q2->y), qo_1f = qo_1d - qo_1e,
      qo_1 = qo_1c + qo_1f;
  const float qo_2a = KSL_MULF(q1->y, q2->x), qo_2b = KSL_MULF(q1->x, q2->y), qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_MULF(q1->z, q2->w), qo_2e = KSL_MULF(q1->w, q2->z), qo_2f = qo_2d - qo_2e,
      qo_2 = qo_2c + qo_2f;
  const float qo_3a = KSL_MULF(q1->x, q2->x), qo_3b = KSL_MULF(q1->y, q2->y), qo_3c = qo_3a + qo_3b,
      qo_3d = KSL_MULF(q1->z, q2->z), qo_3e = qo_3c + qo_3d, qo_3f = KSL_MULF(q1->w, q2->w),
      qo_3 = qo_3e + qo_3f;
  const float qo_0a_abs = fabsf(qo_0a), qo_0b_abs = fabsf(qo_0b),
      qo_0c_size = qo_0a_abs + qo_0b_abs, qo_0d_abs = fabsf(qo_0d), qo_0e_abs = fabsf(qo_0e),
      qo_0f_size = qo_0d_abs + qo_0e_abs, qo_0_size = qo_0c_size + qo_0f_size;
  const float qo_1a_abs = fabsf(qo_1a), qo_1b_abs = fabsf(qo_1b),
      qo_1c_size = qo_1a_abs + qo_1b_abs, qo_1d_abs = fabsf(qo_1d), qo_1e_abs = fabsf(qo_1e),
      qo_1f_size = qo_1d_abs + qo_1e_abs, qo_1_size = qo_1c_size + qo_1f_size;
  const float qo_2a_abs = fabsf(qo_2a), qo_2b_abs = fabsf(qo_2b),
      qo_2c_size = qo_2a_abs + qo_2b_abs, qo_2d_abs = fabsf(qo_2d), qo_2e_abs = fabsf(qo_2e),
      qo_2f_size = qo_2d_abs + qo_2e_abs, qo_2_size = qo_2c_size + qo_2f_size;
  const float qo_3a_abs = fabsf(qo_3a), qo_3b_abs = fabsf(qo_3b),
      qo_3c_size = qo_3a_abs + qo_3b_abs, qo_3d_abs = fabsf(qo_3d),
      qo_3e_size = qo_3c_size + qo_3d_abs, qo_3f_abs = fabsf(qo_3f),
      qo_3_size = qo_3e_size + qo_3f_abs;
  const float qo_0_padded = qo_0_size + 1.9721523e-31f,
      qo_0_error_bound = KSL_MULF(1.7881396e-07f, qo_0_padded);
  const float qo_1_padded = qo_1_size + 1.9721523e-31f,
      qo_1_error_bound = KSL_MULF(1.7881396e-07f, qo_1_padded);
  const float qo_2_padded = qo_2_size + 1.9721523e-31f,
      qo_2_error_bound = KSL_MULF(1.7881396e-07f, qo_2_padded);
  const float qo_3_padded = qo_3_size + 1.9721523e-31f,
      qo_3_error_bound = KSL_MULF(2.3841864e-07f, qo_3_padded);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
  qo_bound->x = qo_0_error_bound;
  qo_bound->y = qo_1_error_bound;
  qo_bound->z = qo_2_error_bound;
  qo_bound->w = qo_3_error_bound;
}

/* vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->y, v->z), c_0b = KSL_MULF(q->z, v->y), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->z, v->x), c_1b = KSL_MULF(q->x, v->z), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->x, v->y), c_2b = KSL_MULF(q->y, v->x), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->y, t_2), turn_0b = KSL_MULF(q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MULF(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const float turn_1a = KSL_MULF(q->z, t_0), turn_1b = KSL_MULF(q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MULF(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const float turn_2a = KSL_MULF(q->x, t_1), turn_2b = KSL_MULF(q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MULF(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  const float c_0a_abs = fabsf(c_0a), c_0b_abs = fabsf(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const float c_1a_abs = fabsf(c_1a), c_1b_abs = fabsf(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const float c_2a_abs = fabsf(c_2a), c_2b_abs = fabsf(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const float c_0_padded = c_0_size + 1.9721523e-31f;
  const float t_0_size = KSL_MULF(2.0f, c_0_padded);
  const float c_1_padded = c_1_size + 1.9721523e-31f;
  const float t_1_size = KSL_MULF(2.0f, c_1_padded);
  const float c_2_padded = c_2_size + 1.9721523e-31f;
  const float t_2_size = KSL_MULF(2.0f, c_2_padded);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y), turn_0a_size = KSL_MULF(q_1_abs, t_2_padded);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z), turn_0b_size = KSL_MULF(q_2_abs, t_1_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w), turn_0d_size = KSL_MULF(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const float turn_1a_size = KSL_MULF(q_2_abs, t_0_padded), q_0_abs = fabsf(q->x),
      turn_1b_size = KSL_MULF(q_0_abs, t_2_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MULF(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const float turn_2a_size = KSL_MULF(q_0_abs, t_1_padded),
      turn_2b_size = KSL_MULF(q_1_abs, t_0_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MULF(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const float v_0_abs = fabsf(v->x), vo_0_size = v_0_abs + turn_0_size;
  const float v_1_abs = fabsf(v->y), vo_1_size = v_1_abs + turn_1_size;
  const float v_2_abs = fabsf(v->z), vo_2_size = v_2_abs + turn_2_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(4.1723263e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(4.1723263e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(4.1723263e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.
   q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
   33 mul, 33 add, 13 abs. */
static inline void ksl_product_qconjvf_certified(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float c_0a = KSL_MULF(q->z, v->y), c_0b = KSL_MULF(q->y, v->z), c_0 = c_0a - c_0b;
  const float c_1a = KSL_MULF(q->x, v->z), c_1b = KSL_MULF(q->z, v->x), c_1 = c_1a - c_1b;
  const float c_2a = KSL_MULF(q->y, v->x), c_2b = KSL_MULF(q->x, v->y), c_2 = c_2a - c_2b;
  const float t_0 = KSL_MULF(2.0f, c_0);
  const float t_1 = KSL_MULF(2.0f, c_1);
  const float t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0a = KSL_MULF(q->z, t_1), turn_0b = KSL_MULF(q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MULF(q->w, t_0), turn_0 = turn_0c + turn_0d;
  const float turn_1a = KSL_MULF(q->x, t_2), turn_1b = KSL_MULF(q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MULF(q->w, t_1), turn_1 = turn_1c + turn_1d;
  const float turn_2a = KSL_MULF(q->y, t_0), turn_2b = KSL_MULF(q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MULF(q->w, t_2), turn_2 = turn_2c + turn_2d;
  const float vo_0 = v->x + turn_0;
  const float vo_1 = v->y + turn_1;
  const float vo_2 = v->z + turn_2;
  const float c_0a_abs = fabsf(c_0a), c_0b_abs = fabsf(c_0b), c_0_size = c_0a_abs + c_0b_abs;
  const float c_1a_abs = fabsf(c_1a), c_1b_abs = fabsf(c_1b), c_1_size = c_1a_abs + c_1b_abs;
  const float c_2a_abs = fabsf(c_2a), c_2b_abs = fabsf(c_2b), c_2_size = c_2a_abs + c_2b_abs;
  const float c_0_padded = c_0_size + 1.9721523e-31f;
  const float t_0_size = KSL_MULF(2.0f, c_0_padded);
  const float c_1_padded = c_1_size + 1.9721523e-31f;
  const float t_1_size = KSL_MULF(2.0f, c_1_padded);
  const float c_2_padded = c_2_size + 1.9721523e-31f;
  const float t_2_size = KSL_MULF(2.0f, c_2_padded);
  const float t_1_padded = t_1_size + 1.9721523e-31f;
  const float q_2_abs = fabsf(q->z), turn_0a_size = KSL_MULF(q_2_abs, t_1_padded);
  const float t_2_padded = t_2_size + 1.9721523e-31f;
  const float q_1_abs = fabsf(q->y), turn_0b_size = KSL_MULF(q_1_abs, t_2_padded),
      turn_0c_size = turn_0a_size + turn_0b_size;
  const float t_0_padded = t_0_size + 1.9721523e-31f;
  const float q_3_abs = fabsf(q->w), turn_0d_size = KSL_MULF(q_3_abs, t_0_padded),
      turn_0_size = turn_0c_size + turn_0d_size;
  const float q_0_abs = fabsf(q->x), turn_1a_size = KSL_MULF(q_0_abs, t_2_padded),
      turn_1b_size = KSL_MULF(q_2_abs, t_0_padded), turn_1c_size = turn_1a_size + turn_1b_size,
      turn_1d_size = KSL_MULF(q_3_abs, t_1_padded), turn_1_size = turn_1c_size + turn_1d_size;
  const float turn_2a_size = KSL_MULF(q_1_abs, t_0_padded),
      turn_2b_size = KSL_MULF(q_0_abs, t_1_padded), turn_2c_size = turn_2a_size + turn_2b_size,
      turn_2d_size = KSL_MULF(q_3_abs, t_2_padded), turn_2_size = turn_2c_size + turn_2d_size;
  const float v_0_abs = fabsf(v->x), vo_0_size = v_0_abs + turn_0_size;
  const float v_1_abs = fabsf(v->y), vo_1_size = v_1_abs + turn_1_size;
  const float v_2_abs = fabsf(v->z), vo_2_size = v_2_abs + turn_2_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(4.1723263e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(4.1723263e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(4.1723263e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

#endif

/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_EXPONENTIAL_CERTIFIED_H
#define KSL_EXPONENTIAL_CERTIFIED_H


/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalize_certified(ksl_mat3x3_t *self,
    ksl_mat3x3_t *self_bound) {
  const double defect_0a = KSL_MUL(self->m00, self->m00), defect_0b = 1.0 - defect_0a,
      defect_0c = KSL_MUL(self->m10, self->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MUL(self->m20, self->m20), defect_0 = defect_0d - defect_0e;
  const double defect_1a = KSL_MUL(self->m01, self->m01), defect_1b = 1.0 - defect_1a,
      defect_1c = KSL_MUL(self->m11, self->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MUL(self->m21, self->m21), defect_1 = defect_1d - defect_1e;
  const double defect_2a = KSL_MUL(self->m02, self->m02), defect_2b = 1.0 - defect_2a,
      defect_2c = KSL_MUL(self->m12, self->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MUL(self->m22, self->m22), defect_2 = defect_2d - defect_2e;
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3b = KSL_MUL(self->m10, self->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MUL(self->m20, self->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4b = KSL_MUL(self->m10, self->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MUL(self->m20, self->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5b = KSL_MUL(self->m11, self->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MUL(self->m21, self->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_b = KSL_MUL(self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = KSL_MUL(self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_b = KSL_MUL(self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = KSL_MUL(self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_b = KSL_MUL(self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = KSL_MUL(self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_b = KSL_MUL(self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = KSL_MUL(self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_b = KSL_MUL(self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = KSL_MUL(self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_b = KSL_MUL(self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = KSL_MUL(self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_b = KSL_MUL(self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = KSL_MUL(self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_b = KSL_MUL(self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = KSL_MUL(self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_b = KSL_MUL(self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = KSL_MUL(self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  const double defect_0a_abs = fabs(defect_0a), defect_0b_size = 1.0 + defect_0a_abs,
      defect_0c_abs = fabs(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabs(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const double defect_1a_abs = fabs(defect_1a), defect_1b_size = 1.0 + defect_1a_abs,
      defect_1c_abs = fabs(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabs(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const double defect_2a_abs = fabs(defect_2a), defect_2b_size = 1.0 + defect_2a_abs,
      defect_2c_abs = fabs(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabs(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const double defect_3a_abs = fabs(defect_3a), defect_3b_abs = fabs(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabs(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const double defect_4a_abs = fabs(defect_4a), defect_4b_abs = fabs(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabs(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const double defect_5a_abs = fabs(defect_5a), defect_5b_abs = fabs(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabs(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const double defect_0_padded = defect_0_size + 2.004168360008973e-292;
  const double correction_0_size = KSL_MUL(0.5, defect_0_padded);
  const double defect_1_padded = defect_1_size + 2.004168360008973e-292;
  const double correction_1_size = KSL_MUL(0.5, defect_1_padded);
  const double defect_2_padded = defect_2_size + 2.004168360008973e-292;
  const double correction_2_size = KSL_MUL(0.5, defect_2_padded);
  const double defect_3e_padded = defect_3e_size + 2.004168360008973e-292;
  const double correction_3_size = KSL_MUL(0.5, defect_3e_padded);
  const double defect_4e_padded = defect_4e_size + 2.004168360008973e-292;
  const double correction_4_size = KSL_MUL(0.5, defect_4e_padded);
  const double defect_5e_padded = defect_5e_size + 2.004168360008973e-292;
  const double correction_5_size = KSL_MUL(0.5, defect_5e_padded);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double self_00_abs = fabs(self->m00),
      self_00_new_a_size = KSL_MUL(self_00_abs, correction_0_padded);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double self_01_abs = fabs(self->m01),
      self_00_new_b_size = KSL_MUL(self_01_abs, correction_3_padded),
      self_00_new_c_size = self_00_new_a_size + self_00_new_b_size;
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double self_02_abs = fabs(self->m02),
      self_00_new_d_size = KSL_MUL(self_02_abs, correction_4_padded),
      self_00_new_e_size = self_00_new_c_size + self_00_new_d_size,
      self_00_new_size = self_00_abs + self_00_new_e_size;
  const double self_01_new_a_size = KSL_MUL(self_00_abs, correction_3_padded);
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292;
  const double self_01_new_b_size = KSL_MUL(self_01_abs, correction_1_padded),
      self_01_new_c_size = self_01_new_a_size + self_01_new_b_size;
  const double correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double self_01_new_d_size = KSL_MUL(self_02_abs, correction_5_padded),
      self_01_new_e_size = self_01_new_c_size + self_01_new_d_size,
      self_01_new_size = self_01_new_e_size + self_01_abs;
  const double self_02_new_a_size = KSL_MUL(self_00_abs, correction_4_padded),
      self_02_new_b_size = KSL_MUL(self_01_abs, correction_5_padded),
      self_02_new_c_size = self_02_new_a_size + self_02_new_b_size;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double self_02_new_d_size = KSL_MUL(self_02_abs, correction_2_padded),
      self_02_new_e_size = self_02_new_c_size + self_02_new_d_size,
      self_02_new_size = self_02_new_e_size + self_02_abs;
  const double self_10_abs = fabs(self->m10),
      self_10_new_a_size = KSL_MUL(self_10_abs, correction_0_padded), self_11_abs = fabs(self->m11),
      self_10_new_b_size = KSL_MUL(self_11_abs, correction_3_padded),
      self_10_new_c_size = self_10_new_a_size + self_10_new_b_size, self_12_abs = fabs(self->m12),
      self_10_new_d_size = KSL_MUL(self_12_abs, correction_4_padded),
      self_10_new_e_size = self_10_new_c_size + self_10_new_d_size,
      self_10_new_size = self_10_abs + self_10_new_e_size;
  const double self_11_new_a_size = KSL_MUL(self_10_abs, correction_3_padded),
      self_11_new_b_size = KSL_MUL(self_11_abs, correction_1_padded),
      self_11_new_c_size = self_11_new_a_size + self_11_new_b_size,
      self_11_new_d_size = KSL_MUL(self_12_abs, correction_5_padded),
      self_11_new_e_size = self_11_new_c_size + self_11_new_d_size,
      self_11_new_size = self_11_new_e_size + self_11_abs;
  const double self_12_new_a_size = KSL_MUL(self_10_abs, correction_4_padded),
      self_12_new_b_size = KSL_MUL(self_11_abs, correction_5_padded),
      self_12_new_c_size = self_12_new_a_size + self_12_new_b_size,
      self_12_new_d_size = KSL_MUL(self_12_abs, correction_2_padded),
      self_12_new_e_size = self_12_new_c_size + self_12_new_d_size,
      self_12_new_size = self_12_new_e_size + self_12_abs;
  const double self_20_abs = fabs(self->m20),
      self_20_new_a_size = KSL_MUL(self_20_abs, correction_0_padded), self_21_abs = fabs(self->m21),
      self_20_new_b_size = KSL_MUL(self_21_abs, correction_3_padded),
      self_20_new_c_size = self_20_new_a_size + self_20_new_b_size, self_22_abs = fabs(self->m22),
      self_20_new_d_size = KSL_MUL(self_22_abs, correction_4_padded),
      self_20_new_e_size = self_20_new_c_size + self_20_new_d_size,
      self_20_new_size = self_20_abs + self_20_new_e_size;
  const double self_21_new_a_size = KSL_MUL(self_20_abs, correction_3_padded),
      self_21_new_b_size = KSL_MUL(self_21_abs, correction_1_padded),
      self_21_new_c_size = self_21_new_a_size + self_21_new_b_size,
      self_21_new_d_size = KSL_MUL(self_22_abs, correction_5_padded),
      self_21_new_e_size = self_21_new_c_size + self_21_new_d_size,
      self_21_new_size = self_21_new_e_size + self_21_abs;
  const double self_22_new_a_size = KSL_MUL(self_20_abs, correction_4_padded),
      self_22_new_b_size = KSL_MUL(self_21_abs, correction_5_padded),
      self_22_new_c_size = self_22_new_a_size + self_22_new_b_size,
      self_22_new_d_size = KSL_MUL(self_22_abs, correction_2_padded),
      self_22_new_e_size = self_22_new_c_size + self_22_new_d_size,
      self_22_new_size = self_22_new_e_size + self_22_abs;
  const double self_00_new_padded = self_00_new_size + 2.004168360008973e-292,
      self_00_new_error_bound = KSL_MUL(9.992007221626415e-16, self_00_new_padded);
  const double self_01_new_padded = self_01_new_size + 2.004168360008973e-292,
      self_01_new_error_bound = KSL_MUL(9.992007221626415e-16, self_01_new_padded);
  const double self_02_new_padded = self_02_new_size + 2.004168360008973e-292,
      self_02_new_error_bound = KSL_MUL(8.881784197001258e-16, self_02_new_padded);
  const double self_10_new_padded = self_10_new_size + 2.004168360008973e-292,
      self_10_new_error_bound = KSL_MUL(9.992007221626415e-16, self_10_new_padded);
  const double self_11_new_padded = self_11_new_size + 2.004168360008973e-292,
      self_11_new_error_bound = KSL_MUL(9.992007221626415e-16, self_11_new_padded);
  const double self_12_new_padded = self_12_new_size + 2.004168360008973e-292,
      self_12_new_error_bound = KSL_MUL(8.881784197001258e-16, self_12_new_padded);
  const double self_20_new_padded = self_20_new_size + 2.004168360008973e-292,
      self_20_new_error_bound = KSL_MUL(9.992007221626415e-16, self_20_new_padded);
  const double self_21_new_padded = self_21_new_size + 2.004168360008973e-292,
      self_21_new_error_bound = KSL_MUL(9.992007221626415e-16, self_21_new_padded);
  const double self_22_new_padded = self_22_new_size + 2.004168360008973e-292,
      self_22_new_error_bound = KSL_MUL(8.881784197001258e-16, self_22_new_padded);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_error_bound;
  self_bound->m01 = self_01_new_error_bound;
  self_bound->m02 = self_02_new_error_bound;
  self_bound->m10 = self_10_new_error_bound;
  self_bound->m11 = self_11_new_error_bound;
  self_bound->m12 = self_12_new_error_bound;
  self_bound->m20 = self_20_new_error_bound;
  self_bound->m21 = self_21_new_error_bound;
  self_bound->m22 = self_22_new_error_bound;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2; |error of
     Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalized_certified(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro,
    ksl_mat3x3_t *Ro_bound) {
  const double defect_0a = KSL_MUL(R->m00, R->m00), defect_0b = 1.0 - defect_0a,
      defect_0c = KSL_MUL(R->m10, R->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MUL(R->m20, R->m20), defect_0 = defect_0d - defect_0e;
  const double defect_1a = KSL_MUL(R->m01, R->m01), defect_1b = 1.0 - defect_1a,
      defect_1c = KSL_MUL(R->m11, R->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MUL(R->m21, R->m21), defect_1 = defect_1d - defect_1e;
  const double defect_2a = KSL_MUL(R->m02, R->m02), defect_2b = 1.0 - defect_2a,
      defect_2c = KSL_MUL(R->m12, R->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MUL(R->m22, R->m22), defect_2 = defect_2d - defect_2e;
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3b = KSL_MUL(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MUL(R->m20, R->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4b = KSL_MUL(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MUL(R->m20, R->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5b = KSL_MUL(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MUL(R->m21, R->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00a = KSL_MUL(R->m00, correction_0), Ro_00b = KSL_MUL(R->m01, correction_3),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const double Ro_01a = KSL_MUL(R->m00, correction_3), Ro_01b = KSL_MUL(R->m01, correction_1),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const double Ro_02a = KSL_MUL(R->m00, correction_4), Ro_02b = KSL_MUL(R->m01, correction_5),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const double Ro_10a = KSL_MUL(R->m10, correction_0), Ro_10b = KSL_MUL(R->m11, correction_3),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const double Ro_11a = KSL_MUL(R->m10, correction_3), Ro_11b = KSL_MUL(R->m11, correction_1),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const double Ro_12a = KSL_MUL(R->m10, correction_4), Ro_12b = KSL_MUL(R->m11, correction_5),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const double Ro_20a = KSL_MUL(R->m20, correction_0), Ro_20b = KSL_MUL(R->m21, correction_3),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const double Ro_21a = KSL_MUL(R->m20, correction_3), Ro_21b = KSL_MUL(R->m21, correction_1),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const double Ro_22a = KSL_MUL(R->m20, correction_4), Ro_22b = KSL_MUL(R->m21, correction_5),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  const double defect_0a_abs = fabs(defect_0a), defect_0b_size = 1.0 + defect_0a_abs,
      defect_0c_abs = fabs(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabs(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const double defect_1a_abs = fabs(defect_1a), defect_1b_size = 1.0 + defect_1a_abs,
      defect_1c_abs = fabs(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabs(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const double defect_2a_abs = fabs(defect_2a), defect_2b_size = 1.0 + defect_2a_abs,
      defect_2c_abs = fabs(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabs(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const double defect_3a_abs = fabs(defect_3a), defect_3b_abs = fabs(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabs(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const double defect_4a_abs = fabs(defect_4a), defect_4b_abs = fabs(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabs(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const double defect_5a_abs = fabs(defect_5a), defect_5b_abs = fabs(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabs(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const double defect_0_padded = defect_0_size + 2.004168360008973e-292;
  const double correction_0_size = KSL_MUL(0.5, defect_0_padded);
  const double defect_1_padded = defect_1_size + 2.004168360008973e-292;
  const double correction_1_size = KSL_MUL(0.5, defect_1_padded);
  const double defect_2_padded = defect_2_size + 2.004168360008973e-292;
  const double correction_2_size = KSL_MUL(0.5, defect_2_padded);
  const double defect_3e_padded = defect_3e_size + 2.004168360008973e-292;
  const double correction_3_size = KSL_MUL(0.5, defect_3e_padded);
  const double defect_4e_padded = defect_4e_size + 2.004168360008973e-292;
  const double correction_4_size = KSL_MUL(0.5, defect_4e_padded);
  const double defect_5e_padded = defect_5e_size + 2.004168360008973e-292;
  const double correction_5_size = KSL_MUL(0.5, defect_5e_padded);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), Ro_00a_size = KSL_MUL(R_00_abs, correction_0_padded);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double R_01_abs = fabs(R->m01), Ro_00b_size = KSL_MUL(R_01_abs, correction_3_padded),
      Ro_00c_size = Ro_00a_size + Ro_00b_size;
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double R_02_abs = fabs(R->m02), Ro_00d_size = KSL_MUL(R_02_abs, correction_4_padded),
      Ro_00e_size = Ro_00c_size + Ro_00d_size, Ro_00_size = R_00_abs + Ro_00e_size;
  const double Ro_01a_size = KSL_MUL(R_00_abs, correction_3_padded);
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292;
  const double Ro_01b_size = KSL_MUL(R_01_abs, correction_1_padded),
      Ro_01c_size = Ro_01a_size + Ro_01b_size;
  const double correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double Ro_01d_size = KSL_MUL(R_02_abs, correction_5_padded),
      Ro_01e_size = Ro_01c_size + Ro_01d_size, Ro_01_size = Ro_01e_size + R_01_abs;
  const double Ro_02a_size = KSL_MUL(R_00_abs, correction_4_padded),
      Ro_02b_size = KSL_MUL(R_01_abs, correction_5_padded), Ro_02c_size = Ro_02a_size + Ro_02b_size;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double Ro_02d_size = KSL_MUL(R_02_abs, correction_2_padded),
      Ro_02e_size = Ro_02c_size + Ro_02d_size, Ro_02_size = Ro_02e_size + R_02_abs;
  const double R_10_abs = fabs(R->m10), Ro_10a_size = KSL_MUL(R_10_abs, correction_0_padded),
      R_11_abs = fabs(R->m11), Ro_10b_size = KSL_MUL(R_11_abs, correction_3_padded),
      Ro_10c_size = Ro_10a_size + Ro_10b_size, R_12_abs = fabs(R->m12),
      Ro_10d_size = KSL_MUL(R_12_abs, correction_4_padded), Ro_10e_size = Ro_10c_size + Ro_10d_size,
      Ro_10_size = R_10_abs + Ro_10e_size;
  const double Ro_11a_size = KSL_MUL(R_10_abs, correction_3_padded),
      Ro_11b_size = KSL_MUL(R_11_abs, correction_1_padded), Ro_11c_size = Ro_11a_size + Ro_11b_size,
      Ro_11d_size = KSL_MUL(R_12_abs, correction_5_padded), Ro_11e_size = Ro_11c_size + Ro_11d_size,
      Ro_11_size = Ro_11e_size + R_11_abs;
  const double Ro_12a_size = KSL_MUL(R_10_abs, correction_4_padded),
      Ro_12b_size = KSL_MUL(R_11_abs, correction_5_padded), Ro_12c_size = Ro_12a_size + Ro_12b_size,
      Ro_12d_size = KSL_MUL(R_12_abs, correction_2_padded), Ro_12e_size = Ro_12c_size + Ro_12d_size,
      Ro_12_size = Ro_12e_size + R_12_abs;
  const double R_20_abs = fabs(R->m20), Ro_20a_size = KSL_MUL(R_20_abs, correction_0_padded),
      R_21_abs = fabs(R->m21), Ro_20b_size = KSL_MUL(R_21_abs, correction_3_padded),
      Ro_20c_size = Ro_20a_size + Ro_20b_size, R_22_abs = fabs(R->m22),
      Ro_20d_size = KSL_MUL(R_22_abs, correction_4_padded), Ro_20e_size = Ro_20c_size + Ro_20d_size,
      Ro_20_size = R_20_abs + Ro_20e_size;
  const double Ro_21a_size = KSL_MUL(R_20_abs, correction_3_padded),
      Ro_21b_size = KSL_MUL(R_21_abs, correction_1_padded), Ro_21c_size = Ro_21a_size + Ro_21b_size,
      Ro_21d_size = KSL_MUL(R_22_abs, correction_5_padded), Ro_21e_size = Ro_21c_size + Ro_21d_size,
      Ro_21_size = Ro_21e_size + R_21_abs;
  const double Ro_22a_size = KSL_MUL(R_20_abs, correction_4_padded),
      Ro_22b_size = KSL_MUL(R_21_abs, correction_5_padded), Ro_22c_size = Ro_22a_size + Ro_22b_size,
      Ro_22d_size = KSL_MUL(R_22_abs, correction_2_padded), Ro_22e_size = Ro_22c_size + Ro_22d_size,
      Ro_22_size = Ro_22e_size + R_22_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(9.992007221626415e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(9.992007221626415e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(8.881784197001258e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(9.992007221626415e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(9.992007221626415e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(8.881784197001258e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(9.992007221626415e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(9.992007221626415e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(8.881784197001258e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* self = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalize_certified(ksl_mat3x3f_t *self,
    ksl_mat3x3f_t *self_bound) {
  const float defect_0a = KSL_MULF(self->m00, self->m00), defect_0b = 1.0f - defect_0a,
      defect_0c = KSL_MULF(self->m10, self->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MULF(self->m20, self->m20), defect_0 = defect_0d - defect_0e;
  const float defect_1a = KSL_MULF(self->m01, self->m01), defect_1b = 1.0f - defect_1a,
      defect_1c = KSL_MULF(self->m11, self->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MULF(self->m21, self->m21), defect_1 = defect_1d - defect_1e;
  const float defect_2a = KSL_MULF(self->m02, self->m02), defect_2b = 1.0f - defect_2a,
      defect_2c = KSL_MULF(self->m12, self->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MULF(self->m22, self->m22), defect_2 = defect_2d - defect_2e;
  const float defect_3a = KSL_MULF(self->m00, self->m01),
      defect_3b = KSL_MULF(self->m10, self->m11), defect_3c = defect_3a + defect_3b,
      defect_3d = KSL_MULF(self->m20, self->m21), defect_3e = defect_3c + defect_3d,
      defect_3 = -defect_3e;
  const float defect_4a = KSL_MULF(self->m00, self->m02),
      defect_4b = KSL_MULF(self->m10, self->m12), defect_4c = defect_4a + defect_4b,
      defect_4d = KSL_MULF(self->m20, self->m22), defect_4e = defect_4c + defect_4d,
      defect_4 = -defect_4e;
  const float defect_5a = KSL_MULF(self->m01, self->m02),
      defect_5b = KSL_MULF(self->m11, self->m12), defect_5c = defect_5a + defect_5b,
      defect_5d = KSL_MULF(self->m21, self->m22), defect_5e = defect_5c + defect_5d,
      defect_5 = -defect_5e;
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new_a = KSL_MULF(self->m00, correction_0),
      self_00_new_b = KSL_MULF(self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = KSL_MULF(self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const float self_01_new_a = KSL_MULF(self->m00, correction_3),
      self_01_new_b = KSL_MULF(self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = KSL_MULF(self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const float self_02_new_a = KSL_MULF(self->m00, correction_4),
      self_02_new_b = KSL_MULF(self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = KSL_MULF(self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const float self_10_new_a = KSL_MULF(self->m10, correction_0),
      self_10_new_b = KSL_MULF(self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = KSL_MULF(self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const float self_11_new_a = KSL_MULF(self->m10, correction_3),
      self_11_new_b = KSL_MULF(self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = KSL_MULF(self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const float self_12_new_a = KSL_MULF(self->m10, correction_4),
      self_12_new_b = KSL_MULF(self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = KSL_MULF(self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const float self_20_new_a = KSL_MULF(self->m20, correction_0),
      self_20_new_b = KSL_MULF(self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = KSL_MULF(self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const float self_21_new_a = KSL_MULF(self->m20, correction_3),
      self_21_new_b = KSL_MULF(self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = KSL_MULF(self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const float self_22_new_a = KSL_MULF(self->m20, correction_4),
      self_22_new_b = KSL_MULF(self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = KSL_MULF(self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  const float defect_0a_abs = fabsf(defect_0a), defect_0b_size = 1.0f + defect_0a_abs,
      defect_0c_abs = fabsf(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabsf(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const float defect_1a_abs = fabsf(defect_1a), defect_1b_size = 1.0f + defect_1a_abs,
      defect_1c_abs = fabsf(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabsf(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const float defect_2a_abs = fabsf(defect_2a), defect_2b_size = 1.0f + defect_2a_abs,
      defect_2c_abs = fabsf(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabsf(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const float defect_3a_abs = fabsf(defect_3a), defect_3b_abs = fabsf(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabsf(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const float defect_4a_abs = fabsf(defect_4a), defect_4b_abs = fabsf(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabsf(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const float defect_5a_abs = fabsf(defect_5a), defect_5b_abs = fabsf(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabsf(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const float defect_0_padded = defect_0_size + 1.9721523e-31f;
  const float correction_0_size = KSL_MULF(0.5f, defect_0_padded);
  const float defect_1_padded = defect_1_size + 1.9721523e-31f;
  const float correction_1_size = KSL_MULF(0.5f, defect_1_padded);
  const float defect_2_padded = defect_2_size + 1.9721523e-31f;
  const float correction_2_size = KSL_MULF(0.5f, defect_2_padded);
  const float defect_3e_padded = defect_3e_size + 1.9721523e-31f;
  const float correction_3_size = KSL_MULF(0.5f, defect_3e_padded);
  const float defect_4e_padded = defect_4e_size + 1.9721523e-31f;
  const float correction_4_size = KSL_MULF(0.5f, defect_4e_padded);
  const float defect_5e_padded = defect_5e_size + 1.9721523e-31f;
  const float correction_5_size = KSL_MULF(0.5f, defect_5e_padded);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float self_00_abs = fabsf(self->m00),
      self_00_new_a_size = KSL_MULF(self_00_abs, correction_0_padded);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float self_01_abs = fabsf(self->m01),
      self_00_new_b_size = KSL_MULF(self_01_abs, correction_3_padded),
      self_00_new_c_size = self_00_new_a_size + self_00_new_b_size;
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float self_02_abs = fabsf(self->m02),
      self_00_new_d_size = KSL_MULF(self_02_abs, correction_4_padded),
      self_00_new_e_size = self_00_new_c_size + self_00_new_d_size,
      self_00_new_size = self_00_abs + self_00_new_e_size;
  const float self_01_new_a_size = KSL_MULF(self_00_abs, correction_3_padded);
  const float correction_1_padded = correction_1_size + 1.9721523e-31f;
  const float self_01_new_b_size = KSL_MULF(self_01_abs, correction_1_padded),
      self_01_new_c_size = self_01_new_a_size + self_01_new_b_size;
  const float correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float self_01_new_d_size = KSL_MULF(self_02_abs, correction_5_padded),
      self_01_new_e_size = self_01_new_c_size + self_01_new_d_size,
      self_01_new_size = self_01_new_e_size + self_01_abs;
  const float self_02_new_a_size = KSL_MULF(self_00_abs, correction_4_padded),
      self_02_new_b_size = KSL_MULF(self_01_abs, correction_5_padded),
      self_02_new_c_size = self_02_new_a_size + self_02_new_b_size;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float self_02_new_d_size = KSL_MULF(self_02_abs, correction_2_padded),
      self_02_new_e_size = self_02_new_c_size + self_02_new_d_size,
      self_02_new_size = self_02_new_e_size + self_02_abs;
  const float self_10_abs = fabsf(self->m10),
      self_10_new_a_size = KSL_MULF(self_10_abs, correction_0_padded),
      self_11_abs = fabsf(self->m11),
      self_10_new_b_size = KSL_MULF(self_11_abs, correction_3_padded),
      self_10_new_c_size = self_10_new_a_size + self_10_new_b_size, self_12_abs = fabsf(self->m12),
      self_10_new_d_size = KSL_MULF(self_12_abs, correction_4_padded),
      self_10_new_e_size = self_10_new_c_size + self_10_new_d_size,
      self_10_new_size = self_10_abs + self_10_new_e_size;
  const float self_11_new_a_size = KSL_MULF(self_10_abs, correction_3_padded),
      self_11_new_b_size = KSL_MULF(self_11_abs, correction_1_padded),
      self_11_new_c_size = self_11_new_a_size + self_11_new_b_size,
      self_11_new_d_size = KSL_MULF(self_12_abs, correction_5_padded),
      self_11_new_e_size = self_11_new_c_size + self_11_new_d_size,
      self_11_new_size = self_11_new_e_size + self_11_abs;
  const float self_12_new_a_size = KSL_MULF(self_10_abs, correction_4_padded),
      self_12_new_b_size = KSL_MULF(self_11_abs, correction_5_padded),
      self_12_new_c_size = self_12_new_a_size + self_12_new_b_size,
      self_12_new_d_size = KSL_MULF(self_12_abs, correction_2_padded),
      self_12_new_e_size = self_12_new_c_size + self_12_new_d_size,
      self_12_new_size = self_12_new_e_size + self_12_abs;
  const float self_20_abs = fabsf(self->m20),
      self_20_new_a_size = KSL_MULF(self_20_abs, correction_0_padded),
      self_21_abs = fabsf(self->m21),
      self_20_new_b_size = KSL_MULF(self_21_abs, correction_3_padded),
      self_20_new_c_size = self_20_new_a_size + self_20_new_b_size, self_22_abs = fabsf(self->m22),
      self_20_new_d_size = KSL_MULF(self_22_abs, correction_4_padded),
      self_20_new_e_size = self_20_new_c_size + self_20_new_d_size,
      self_20_new_size = self_20_abs + self_20_new_e_size;
  const float self_21_new_a_size = KSL_MULF(self_20_abs, correction_3_padded),
      self_21_new_b_size = KSL_MULF(self_21_abs, correction_1_padded),
      self_21_new_c_size = self_21_new_a_size + self_21_new_b_size,
      self_21_new_d_size = KSL_MULF(self_22_abs, correction_5_padded),
      self_21_new_e_size = self_21_new_c_size + self_21_new_d_size,
      self_21_new_size = self_21_new_e_size + self_21_abs;
  const float self_22_new_a_size = KSL_MULF(self_20_abs, correction_4_padded),
      self_22_new_b_size = KSL_MULF(self_21_abs, correction_5_padded),
      self_22_new_c_size = self_22_new_a_size + self_22_new_b_size,
      self_22_new_d_size = KSL_MULF(self_22_abs, correction_2_padded),
      self_22_new_e_size = self_22_new_c_size + self_22_new_d_size,
      self_22_new_size = self_22_new_e_size + self_22_abs;
  const float self_00_new_padded = self_00_new_size + 1.9721523e-31f,
      self_00_new_error_bound = KSL_MULF(5.36442e-07f, self_00_new_padded);
  const float self_01_new_padded = self_01_new_size + 1.9721523e-31f,
      self_01_new_error_bound = KSL_MULF(5.36442e-07f, self_01_new_padded);
  const float self_02_new_padded = self_02_new_size + 1.9721523e-31f,
      self_02_new_error_bound = KSL_MULF(4.7683733e-07f, self_02_new_padded);
  const float self_10_new_padded = self_10_new_size + 1.9721523e-31f,
      self_10_new_error_bound = KSL_MULF(5.36442e-07f, self_10_new_padded);
  const float self_11_new_padded = self_11_new_size + 1.9721523e-31f,
      self_11_new_error_bound = KSL_MULF(5.36442e-07f, self_11_new_padded);
  const float self_12_new_padded = self_12_new_size + 1.9721523e-31f,
      self_12_new_error_bound = KSL_MULF(4.7683733e-07f, self_12_new_padded);
  const float self_20_new_padded = self_20_new_size + 1.9721523e-31f,
      self_20_new_error_bound = KSL_MULF(5.36442e-07f, self_20_new_padded);
  const float self_21_new_padded = self_21_new_size + 1.9721523e-31f,
      self_21_new_error_bound = KSL_MULF(5.36442e-07f, self_21_new_padded);
  const float self_22_new_padded = self_22_new_size + 1.9721523e-31f,
      self_22_new_error_bound = KSL_MULF(4.7683733e-07f, self_22_new_padded);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_error_bound;
  self_bound->m01 = self_01_new_error_bound;
  self_bound->m02 = self_02_new_error_bound;
  self_bound->m10 = self_10_new_error_bound;
  self_bound->m11 = self_11_new_error_bound;
  self_bound->m12 = self_12_new_error_bound;
  self_bound->m20 = self_20_new_error_bound;
  self_bound->m21 = self_21_new_error_bound;
  self_bound->m22 = self_22_new_error_bound;
}

/* Ro = the rotation R + R (I - R^T R)/2 next to R: a defect d of R becomes 3/4 d^2; |error of
     Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalized_certified(const ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float defect_0a = KSL_MULF(R->m00, R->m00), defect_0b = 1.0f - defect_0a,
      defect_0c = KSL_MULF(R->m10, R->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MULF(R->m20, R->m20), defect_0 = defect_0d - defect_0e;
  const float defect_1a = KSL_MULF(R->m01, R->m01), defect_1b = 1.0f - defect_1a,
      defect_1c = KSL_MULF(R->m11, R->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MULF(R->m21, R->m21), defect_1 = defect_1d - defect_1e;
  const float defect_2a = KSL_MULF(R->m02, R->m02), defect_2b = 1.0f - defect_2a,
      defect_2c = KSL_MULF(R->m12, R->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MULF(R->m22, R->m22), defect_2 = defect_2d - defect_2e;
  const float defect_3a = KSL_MULF(R->m00, R->m01), defect_3b = KSL_MULF(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MULF(R->m20, R->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const float defect_4a = KSL_MULF(R->m00, R->m02), defect_4b = KSL_MULF(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MULF(R->m20, R->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const float defect_5a = KSL_MULF(R->m01, R->m02), defect_5b = KSL_MULF(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MULF(R->m21, R->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00a = KSL_MULF(R->m00, correction_0), Ro_00b = KSL_MULF(R->m01, correction_3),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const float Ro_01a = KSL_MULF(R->m00, correction_3), Ro_01b = KSL_MULF(R->m01, correction_1),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const float Ro_02a = KSL_MULF(R->m00, correction_4), Ro_02b = KSL_MULF(R->m01, correction_5),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const float Ro_10a = KSL_MULF(R->m10, correction_0), Ro_10b = KSL_MULF(R->m11, correction_3),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const float Ro_11a = KSL_MULF(R->m10, correction_3), Ro_11b = KSL_MULF(R->m11, correction_1),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const float Ro_12a = KSL_MULF(R->m10, correction_4), Ro_12b = KSL_MULF(R->m11, correction_5),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const float Ro_20a = KSL_MULF(R->m20, correction_0), Ro_20b = KSL_MULF(R->m21, correction_3),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const float Ro_21a = KSL_MULF(R->m20, correction_3), Ro_21b = KSL_MULF(R->m21, correction_1),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const float Ro_22a = KSL_MULF(R->m20, correction_4), Ro_22b = KSL_MULF(R->m21, correction_5),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  const float defect_0a_abs = fabsf(defect_0a), defect_0b_size = 1.0f + defect_0a_abs,
      defect_0c_abs = fabsf(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabsf(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const float defect_1a_abs = fabsf(defect_1a), defect_1b_size = 1.0f + defect_1a_abs,
      defect_1c_abs = fabsf(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabsf(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const float defect_2a_abs = fabsf(defect_2a), defect_2b_size = 1.0f + defect_2a_abs,
      defect_2c_abs = fabsf(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabsf(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const float defect_3a_abs = fabsf(defect_3a), defect_3b_abs = fabsf(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabsf(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const float defect_4a_abs = fabsf(defect_4a), defect_4b_abs = fabsf(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabsf(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const float defect_5a_abs = fabsf(defect_5a), defect_5b_abs = fabsf(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabsf(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const float defect_0_padded = defect_0_size + 1.9721523e-31f;
  const float correction_0_size = KSL_MULF(0.5f, defect_0_padded);
  const float defect_1_padded = defect_1_size + 1.9721523e-31f;
  const float correction_1_size = KSL_MULF(0.5f, defect_1_padded);
  const float defect_2_padded = defect_2_size + 1.9721523e-31f;
  const float correction_2_size = KSL_MULF(0.5f, defect_2_padded);
  const float defect_3e_padded = defect_3e_size + 1.9721523e-31f;
  const float correction_3_size = KSL_MULF(0.5f, defect_3e_padded);
  const float defect_4e_padded = defect_4e_size + 1.9721523e-31f;
  const float correction_4_size = KSL_MULF(0.5f, defect_4e_padded);
  const float defect_5e_padded = defect_5e_size + 1.9721523e-31f;
  const float correction_5_size = KSL_MULF(0.5f, defect_5e_padded);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), Ro_00a_size = KSL_MULF(R_00_abs, correction_0_padded);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float R_01_abs = fabsf(R->m01), Ro_00b_size = KSL_MULF(R_01_abs, correction_3_padded),
      Ro_00c_size = Ro_00a_size + Ro_00b_size;
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float R_02_abs = fabsf(R->m02), Ro_00d_size = KSL_MULF(R_02_abs, correction_4_padded),
      Ro_00e_size = Ro_00c_size + Ro_00d_size, Ro_00_size = R_00_abs + Ro_00e_size;
  const float Ro_01a_size = KSL_MULF(R_00_abs, correction_3_padded);
  const float correction_1_padded = correction_1_size + 1.9721523e-31f;
  const float Ro_01b_size = KSL_MULF(R_01_abs, correction_1_padded),
      Ro_01c_size = Ro_01a_size + Ro_01b_size;
  const float correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float Ro_01d_size = KSL_MULF(R_02_abs, correction_5_padded),
      Ro_01e_size = Ro_01c_size + Ro_01d_size, Ro_01_size = Ro_01e_size + R_01_abs;
  const float Ro_02a_size = KSL_MULF(R_00_abs, correction_4_padded),
      Ro_02b_size = KSL_MULF(R_01_abs, correction_5_padded),
      Ro_02c_size = Ro_02a_size + Ro_02b_size;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float Ro_02d_size = KSL_MULF(R_02_abs, correction_2_padded),
      Ro_02e_size = Ro_02c_size + Ro_02d_size, Ro_02_size = Ro_02e_size + R_02_abs;
  const float R_10_abs = fabsf(R->m10), Ro_10a_size = KSL_MULF(R_10_abs, correction_0_padded),
      R_11_abs = fabsf(R->m11), Ro_10b_size = KSL_MULF(R_11_abs, correction_3_padded),
      Ro_10c_size = Ro_10a_size + Ro_10b_size, R_12_abs = fabsf(R->m12),
      Ro_10d_size = KSL_MULF(R_12_abs, correction_4_padded),
      Ro_10e_size = Ro_10c_size + Ro_10d_size, Ro_10_size = R_10_abs + Ro_10e_size;
  const float Ro_11a_size = KSL_MULF(R_10_abs, correction_3_padded),
      Ro_11b_size = KSL_MULF(R_11_abs, correction_1_padded),
      Ro_11c_size = Ro_11a_size + Ro_11b_size,
      Ro_11d_size = KSL_MULF(R_12_abs, correction_5_padded),
      Ro_11e_size = Ro_11c_size + Ro_11d_size, Ro_11_size = Ro_11e_size + R_11_abs;
  const float Ro_12a_size = KSL_MULF(R_10_abs, correction_4_padded),
      Ro_12b_size = KSL_MULF(R_11_abs, correction_5_padded),
      Ro_12c_size = Ro_12a_size + Ro_12b_size,
      Ro_12d_size = KSL_MULF(R_12_abs, correction_2_padded),
      Ro_12e_size = Ro_12c_size + Ro_12d_size, Ro_12_size = Ro_12e_size + R_12_abs;
  const float R_20_abs = fabsf(R->m20), Ro_20a_size = KSL_MULF(R_20_abs, correction_0_padded),
      R_21_abs = fabsf(R->m21), Ro_20b_size = KSL_MULF(R_21_abs, correction_3_padded),
      Ro_20c_size = Ro_20a_size + Ro_20b_size, R_22_abs = fabsf(R->m22),
      Ro_20d_size = KSL_MULF(R_22_abs, correction_4_padded),
      Ro_20e_size = Ro_20c_size + Ro_20d_size, Ro_20_size = R_20_abs + Ro_20e_size;
  const float Ro_21a_size = KSL_MULF(R_20_abs, correction_3_padded),
      Ro_21b_size = KSL_MULF(R_21_abs, correction_1_padded),
      Ro_21c_size = Ro_21a_size + Ro_21b_size,
      Ro_21d_size = KSL_MULF(R_22_abs, correction_5_padded),
      Ro_21e_size = Ro_21c_size + Ro_21d_size, Ro_21_size = Ro_21e_size + R_21_abs;
  const float Ro_22a_size = KSL_MULF(R_20_abs, correction_4_padded),
      Ro_22b_size = KSL_MULF(R_21_abs, correction_5_padded),
      Ro_22c_size = Ro_22a_size + Ro_22b_size,
      Ro_22d_size = KSL_MULF(R_22_abs, correction_2_padded),
      Ro_22e_size = Ro_22c_size + Ro_22d_size, Ro_22_size = Ro_22e_size + R_22_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(5.36442e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(5.36442e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(4.7683733e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(5.36442e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(5.36442e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(4.7683733e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(5.36442e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(5.36442e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(4.7683733e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

#endif

/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_INERTIA_CERTIFIED_H
#define KSL_INERTIA_CERTIFIED_H


/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2); a: number.
   20 mul, 10 add, 10 abs. */
static inline void ksl_inertia_scale_certified(ksl_inertia_t *self, const double a,
    ksl_inertia_t *self_bound) {
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
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  const double self_3_new_abs = fabs(self_3_new),
      self_3_new_padded = self_3_new_abs + 2.004168360008973e-292,
      self_3_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_3_new_padded);
  const double self_4_new_abs = fabs(self_4_new),
      self_4_new_padded = self_4_new_abs + 2.004168360008973e-292,
      self_4_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_4_new_padded);
  const double self_5_new_abs = fabs(self_5_new),
      self_5_new_padded = self_5_new_abs + 2.004168360008973e-292,
      self_5_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_5_new_padded);
  const double self_6_new_abs = fabs(self_6_new),
      self_6_new_padded = self_6_new_abs + 2.004168360008973e-292,
      self_6_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_6_new_padded);
  const double self_7_new_abs = fabs(self_7_new),
      self_7_new_padded = self_7_new_abs + 2.004168360008973e-292,
      self_7_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_7_new_padded);
  const double self_8_new_abs = fabs(self_8_new),
      self_8_new_padded = self_8_new_abs + 2.004168360008973e-292,
      self_8_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_8_new_padded);
  const double self_9_new_abs = fabs(self_9_new),
      self_9_new_padded = self_9_new_abs + 2.004168360008973e-292,
      self_9_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_9_new_padded);
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
  self_bound->m = self_0_new_error_bound;
  self_bound->h.x = self_1_new_error_bound;
  self_bound->h.y = self_2_new_error_bound;
  self_bound->h.z = self_3_new_error_bound;
  self_bound->xx = self_4_new_error_bound;
  self_bound->yy = self_5_new_error_bound;
  self_bound->zz = self_6_new_error_bound;
  self_bound->xy = self_7_new_error_bound;
  self_bound->xz = self_8_new_error_bound;
  self_bound->yz = self_9_new_error_bound;
}

/* Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_add_BB_certified(const ksl_inertia_t *B1, const ksl_inertia_t *B2,
    ksl_inertia_t *Bo, ksl_inertia_t *Bo_bound) {
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
  const double Bo_0_abs = fabs(Bo_0), Bo_0_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_0_abs);
  const double Bo_1_abs = fabs(Bo_1), Bo_1_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_1_abs);
  const double Bo_2_abs = fabs(Bo_2), Bo_2_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_2_abs);
  const double Bo_3_abs = fabs(Bo_3), Bo_3_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_3_abs);
  const double Bo_4_abs = fabs(Bo_4), Bo_4_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_4_abs);
  const double Bo_5_abs = fabs(Bo_5), Bo_5_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_5_abs);
  const double Bo_6_abs = fabs(Bo_6), Bo_6_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_6_abs);
  const double Bo_7_abs = fabs(Bo_7), Bo_7_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_7_abs);
  const double Bo_8_abs = fabs(Bo_8), Bo_8_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_8_abs);
  const double Bo_9_abs = fabs(Bo_9), Bo_9_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_9_abs);
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
  Bo_bound->m = Bo_0_error_bound;
  Bo_bound->h.x = Bo_1_error_bound;
  Bo_bound->h.y = Bo_2_error_bound;
  Bo_bound->h.z = Bo_3_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_subtract_BB_certified(const ksl_inertia_t *B1, const ksl_inertia_t *B2,
    ksl_inertia_t *Bo, ksl_inertia_t *Bo_bound) {
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
  const double Bo_0_abs = fabs(Bo_0), Bo_0_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_0_abs);
  const double Bo_1_abs = fabs(Bo_1), Bo_1_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_1_abs);
  const double Bo_2_abs = fabs(Bo_2), Bo_2_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_2_abs);
  const double Bo_3_abs = fabs(Bo_3), Bo_3_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_3_abs);
  const double Bo_4_abs = fabs(Bo_4), Bo_4_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_4_abs);
  const double Bo_5_abs = fabs(Bo_5), Bo_5_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_5_abs);
  const double Bo_6_abs = fabs(Bo_6), Bo_6_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_6_abs);
  const double Bo_7_abs = fabs(Bo_7), Bo_7_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_7_abs);
  const double Bo_8_abs = fabs(Bo_8), Bo_8_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_8_abs);
  const double Bo_9_abs = fabs(Bo_9), Bo_9_error_bound = KSL_MUL(1.1102230246251568e-16, Bo_9_abs);
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
  Bo_bound->m = Bo_0_error_bound;
  Bo_bound->h.x = Bo_1_error_bound;
  Bo_bound->h.y = Bo_2_error_bound;
  Bo_bound->h.z = Bo_3_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; of the symmetric matrix
     the upper triangle): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf
     or NaN.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo, Bo_bound: spatial inertia (m in
     kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   24 mul, 27 add, 12 abs. */
static inline void ksl_inertia_from_com_certified(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_inertia_t *Bo, ksl_inertia_t *Bo_bound) {
  const double h_0 = KSL_MUL(m, com->x);
  const double h_1 = KSL_MUL(m, com->y);
  const double h_2 = KSL_MUL(m, com->z);
  const double squares_0 = KSL_MUL(com->x, h_0);
  const double squares_1 = KSL_MUL(com->y, h_1);
  const double squares_2 = KSL_MUL(com->z, h_2);
  const double Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const double Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const double Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const double Bo_7a = KSL_MUL(com->y, h_0), Bo_7 = Ic->m01 - Bo_7a;
  const double Bo_8a = KSL_MUL(com->z, h_0), Bo_8 = Ic->m02 - Bo_8a;
  const double Bo_9a = KSL_MUL(com->z, h_1), Bo_9 = Ic->m12 - Bo_9a;
  const double h_0_abs = fabs(h_0), h_0_padded = h_0_abs + 2.004168360008973e-292;
  const double com_0_abs = fabs(com->x), squares_0_size = KSL_MUL(com_0_abs, h_0_padded);
  const double h_1_abs = fabs(h_1), h_1_padded = h_1_abs + 2.004168360008973e-292;
  const double com_1_abs = fabs(com->y), squares_1_size = KSL_MUL(com_1_abs, h_1_padded);
  const double h_2_abs = fabs(h_2), h_2_padded = h_2_abs + 2.004168360008973e-292;
  const double com_2_abs = fabs(com->z), squares_2_size = KSL_MUL(com_2_abs, h_2_padded);
  const double Bo_4a_size = squares_1_size + squares_2_size, Ic_00_abs = fabs(Ic->m00),
      Bo_4_size = Ic_00_abs + Bo_4a_size;
  const double Bo_5a_size = squares_0_size + squares_2_size, Ic_11_abs = fabs(Ic->m11),
      Bo_5_size = Ic_11_abs + Bo_5a_size;
  const double Bo_6a_size = squares_0_size + squares_1_size, Ic_22_abs = fabs(Ic->m22),
      Bo_6_size = Ic_22_abs + Bo_6a_size;
  const double Bo_7a_size = KSL_MUL(com_1_abs, h_0_padded), Ic_01_abs = fabs(Ic->m01),
      Bo_7_size = Ic_01_abs + Bo_7a_size;
  const double Bo_8a_size = KSL_MUL(com_2_abs, h_0_padded), Ic_02_abs = fabs(Ic->m02),
      Bo_8_size = Ic_02_abs + Bo_8a_size;
  const double Bo_9a_size = KSL_MUL(com_2_abs, h_1_padded), Ic_12_abs = fabs(Ic->m12),
      Bo_9_size = Ic_12_abs + Bo_9a_size;
  const double h_0_error_bound = KSL_MUL(1.1102230246251568e-16, h_0_padded);
  const double h_1_error_bound = KSL_MUL(1.1102230246251568e-16, h_1_padded);
  const double h_2_error_bound = KSL_MUL(1.1102230246251568e-16, h_2_padded);
  const double Bo_4_padded = Bo_4_size + 2.004168360008973e-292,
      Bo_4_error_bound = KSL_MUL(4.440892098500628e-16, Bo_4_padded);
  const double Bo_5_padded = Bo_5_size + 2.004168360008973e-292,
      Bo_5_error_bound = KSL_MUL(4.440892098500628e-16, Bo_5_padded);
  const double Bo_6_padded = Bo_6_size + 2.004168360008973e-292,
      Bo_6_error_bound = KSL_MUL(4.440892098500628e-16, Bo_6_padded);
  const double Bo_7_padded = Bo_7_size + 2.004168360008973e-292,
      Bo_7_error_bound = KSL_MUL(3.3306690738754706e-16, Bo_7_padded);
  const double Bo_8_padded = Bo_8_size + 2.004168360008973e-292,
      Bo_8_error_bound = KSL_MUL(3.3306690738754706e-16, Bo_8_padded);
  const double Bo_9_padded = Bo_9_size + 2.004168360008973e-292,
      Bo_9_error_bound = KSL_MUL(3.3306690738754706e-16, Bo_9_padded);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = h_0_error_bound;
  Bo_bound->h.y = h_1_error_bound;
  Bo_bound->h.z = h_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of co|
     <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   30 mul, 42 add, 24 abs. */
static inline void ksl_product_Bs_certified(const ksl_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(B->m, s->m0), co_0b = KSL_MUL(B->h.z, s->m4),
      co_0c = KSL_MUL(B->h.y, s->m5), co_0d = co_0b - co_0c, co_0 = co_0a + co_0d;
  const double co_1a = KSL_MUL(B->m, s->m1), co_1b = KSL_MUL(B->h.x, s->m5),
      co_1c = KSL_MUL(B->h.z, s->m3), co_1d = co_1b - co_1c, co_1 = co_1a + co_1d;
  const double co_2a = KSL_MUL(B->m, s->m2), co_2b = KSL_MUL(B->h.y, s->m3),
      co_2c = KSL_MUL(B->h.x, s->m4), co_2d = co_2b - co_2c, co_2 = co_2a + co_2d;
  const double co_3a = KSL_MUL(B->h.y, s->m2), co_3b = KSL_MUL(B->h.z, s->m1),
      co_3c = co_3a - co_3b, co_3d = KSL_MUL(B->xx, s->m3), co_3e = KSL_MUL(B->xy, s->m4),
      co_3f = co_3d + co_3e, co_3g = KSL_MUL(B->xz, s->m5), co_3h = co_3f + co_3g,
      co_3 = co_3c + co_3h;
  const double co_4a = KSL_MUL(B->h.z, s->m0), co_4b = KSL_MUL(B->h.x, s->m2),
      co_4c = co_4a - co_4b, co_4d = KSL_MUL(B->yy, s->m4), co_4e = KSL_MUL(B->xy, s->m3),
      co_4f = co_4d + co_4e, co_4g = KSL_MUL(B->yz, s->m5), co_4h = co_4f + co_4g,
      co_4 = co_4c + co_4h;
  const double co_5a = KSL_MUL(B->h.x, s->m1), co_5b = KSL_MUL(B->h.y, s->m0),
      co_5c = co_5a - co_5b, co_5d = KSL_MUL(B->zz, s->m5), co_5e = KSL_MUL(B->xz, s->m3),
      co_5f = co_5d + co_5e, co_5g = KSL_MUL(B->yz, s->m4), co_5h = co_5f + co_5g,
      co_5 = co_5c + co_5h;
  const double co_0b_abs = fabs(co_0b), co_0c_abs = fabs(co_0c), co_0d_size = co_0b_abs + co_0c_abs,
      co_0a_abs = fabs(co_0a), co_0_size = co_0a_abs + co_0d_size;
  const double co_1b_abs = fabs(co_1b), co_1c_abs = fabs(co_1c), co_1d_size = co_1b_abs + co_1c_abs,
      co_1a_abs = fabs(co_1a), co_1_size = co_1a_abs + co_1d_size;
  const double co_2b_abs = fabs(co_2b), co_2c_abs = fabs(co_2c), co_2d_size = co_2b_abs + co_2c_abs,
      co_2a_abs = fabs(co_2a), co_2_size = co_2a_abs + co_2d_size;
  const double co_3a_abs = fabs(co_3a), co_3b_abs = fabs(co_3b), co_3c_size = co_3a_abs + co_3b_abs,
      co_3d_abs = fabs(co_3d), co_3e_abs = fabs(co_3e), co_3f_size = co_3d_abs + co_3e_abs,
      co_3g_abs = fabs(co_3g), co_3h_size = co_3f_size + co_3g_abs,
      co_3_size = co_3c_size + co_3h_size;
  const double co_4a_abs = fabs(co_4a), co_4b_abs = fabs(co_4b), co_4c_size = co_4a_abs + co_4b_abs,
      co_4d_abs = fabs(co_4d), co_4e_abs = fabs(co_4e), co_4f_size = co_4d_abs + co_4e_abs,
      co_4g_abs = fabs(co_4g), co_4h_size = co_4f_size + co_4g_abs,
      co_4_size = co_4c_size + co_4h_size;
  const double co_5a_abs = fabs(co_5a), co_5b_abs = fabs(co_5b), co_5c_size = co_5a_abs + co_5b_abs,
      co_5d_abs = fabs(co_5d), co_5e_abs = fabs(co_5e), co_5f_size = co_5d_abs + co_5e_abs,
      co_5g_abs = fabs(co_5g), co_5h_size = co_5f_size + co_5g_abs,
      co_5_size = co_5c_size + co_5h_size;
  const double co_0_padded = co_0_size + 2.004168360008973e-292,
      co_0_error_bound = KSL_MUL(3.3306690738754706e-16, co_0_padded);
  const double co_1_padded = co_1_size + 2.004168360008973e-292,
      co_1_error_bound = KSL_MUL(3.3306690738754706e-16, co_1_padded);
  const double co_2_padded = co_2_size + 2.004168360008973e-292,
      co_2_error_bound = KSL_MUL(3.3306690738754706e-16, co_2_padded);
  const double co_3_padded = co_3_size + 2.004168360008973e-292,
      co_3_error_bound = KSL_MUL(4.440892098500628e-16, co_3_padded);
  const double co_4_padded = co_4_size + 2.004168360008973e-292,
      co_4_error_bound = KSL_MUL(4.440892098500628e-16, co_4_padded);
  const double co_5_padded = co_5_size + 2.004168360008973e-292,
      co_5_error_bound = KSL_MUL(4.440892098500628e-16, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
     energy_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); energy_bound: number.
   39 mul, 45 add, 24 abs. */
static inline double ksl_inertia_energy_certified(const ksl_inertia_t *B, const ksl_screw_t *s,
    double *energy_bound) {
  const double across_0a = KSL_MUL(B->h.z, s->m4), across_0b = KSL_MUL(B->h.y, s->m5),
      across_0 = across_0a - across_0b;
  const double across_1a = KSL_MUL(B->h.x, s->m5), across_1b = KSL_MUL(B->h.z, s->m3),
      across_1 = across_1a - across_1b;
  const double across_2a = KSL_MUL(B->h.y, s->m3), across_2b = KSL_MUL(B->h.x, s->m4),
      across_2 = across_2a - across_2b;
  const double twice_across_0 = KSL_MUL(2.0, across_0);
  const double twice_across_1 = KSL_MUL(2.0, across_1);
  const double twice_across_2 = KSL_MUL(2.0, across_2);
  const double p_0a = KSL_MUL(B->m, s->m0), p_0 = p_0a + twice_across_0;
  const double p_1a = KSL_MUL(B->m, s->m1), p_1 = p_1a + twice_across_1;
  const double p_2a = KSL_MUL(B->m, s->m2), p_2 = p_2a + twice_across_2;
  const double L_0a = KSL_MUL(B->xx, s->m3), L_0b = KSL_MUL(B->xy, s->m4), L_0c = L_0a + L_0b,
      L_0d = KSL_MUL(B->xz, s->m5), L_0 = L_0c + L_0d;
  const double L_1a = KSL_MUL(B->yy, s->m4), L_1b = KSL_MUL(B->xy, s->m3), L_1c = L_1a + L_1b,
      L_1d = KSL_MUL(B->yz, s->m5), L_1 = L_1c + L_1d;
  const double L_2a = KSL_MUL(B->zz, s->m5), L_2b = KSL_MUL(B->xz, s->m3), L_2c = L_2a + L_2b,
      L_2d = KSL_MUL(B->yz, s->m4), L_2 = L_2c + L_2d;
  const double twice_a = KSL_MUL(s->m0, p_0), twice_b = KSL_MUL(s->m1, p_1),
      twice_c = twice_a + twice_b, twice_d = KSL_MUL(s->m2, p_2), twice_e = twice_c + twice_d,
      twice_f = KSL_MUL(s->m3, L_0), twice_g = KSL_MUL(s->m4, L_1), twice_h = twice_f + twice_g,
      twice_i = KSL_MUL(s->m5, L_2), twice_j = twice_h + twice_i, twice = twice_e + twice_j;
  const double energy = KSL_MUL(0.5, twice);
  const double across_0a_abs = fabs(across_0a), across_0b_abs = fabs(across_0b),
      across_0_size = across_0a_abs + across_0b_abs;
  const double across_1a_abs = fabs(across_1a), across_1b_abs = fabs(across_1b),
      across_1_size = across_1a_abs + across_1b_abs;
  const double across_2a_abs = fabs(across_2a), across_2b_abs = fabs(across_2b),
      across_2_size = across_2a_abs + across_2b_abs;
  const double across_0_padded = across_0_size + 2.004168360008973e-292;
  const double twice_across_0_size = KSL_MUL(2.0, across_0_padded);
  const double across_1_padded = across_1_size + 2.004168360008973e-292;
  const double twice_across_1_size = KSL_MUL(2.0, across_1_padded);
  const double across_2_padded = across_2_size + 2.004168360008973e-292;
  const double twice_across_2_size = KSL_MUL(2.0, across_2_padded);
  const double p_0a_abs = fabs(p_0a), p_0_size = p_0a_abs + twice_across_0_size;
  const double p_1a_abs = fabs(p_1a), p_1_size = p_1a_abs + twice_across_1_size;
  const double p_2a_abs = fabs(p_2a), p_2_size = p_2a_abs + twice_across_2_size;
  const double L_0a_abs = fabs(L_0a), L_0b_abs = fabs(L_0b), L_0c_size = L_0a_abs + L_0b_abs,
      L_0d_abs = fabs(L_0d), L_0_size = L_0c_size + L_0d_abs;
  const double L_1a_abs = fabs(L_1a), L_1b_abs = fabs(L_1b), L_1c_size = L_1a_abs + L_1b_abs,
      L_1d_abs = fabs(L_1d), L_1_size = L_1c_size + L_1d_abs;
  const double L_2a_abs = fabs(L_2a), L_2b_abs = fabs(L_2b), L_2c_size = L_2a_abs + L_2b_abs,
      L_2d_abs = fabs(L_2d), L_2_size = L_2c_size + L_2d_abs;
  const double p_0_padded = p_0_size + 2.004168360008973e-292;
  const double s_0_abs = fabs(s->m0), twice_a_size = KSL_MUL(s_0_abs, p_0_padded);
  const double p_1_padded = p_1_size + 2.004168360008973e-292;
  const double s_1_abs = fabs(s->m1), twice_b_size = KSL_MUL(s_1_abs, p_1_padded),
      twice_c_size = twice_a_size + twice_b_size;
  const double p_2_padded = p_2_size + 2.004168360008973e-292;
  const double s_2_abs = fabs(s->m2), twice_d_size = KSL_MUL(s_2_abs, p_2_padded),
      twice_e_size = twice_c_size + twice_d_size;
  const double L_0_padded = L_0_size + 2.004168360008973e-292;
  const double s_3_abs = fabs(s->m3), twice_f_size = KSL_MUL(s_3_abs, L_0_padded);
  const double L_1_padded = L_1_size + 2.004168360008973e-292;
  const double s_4_abs = fabs(s->m4), twice_g_size = KSL_MUL(s_4_abs, L_1_padded),
      twice_h_size = twice_f_size + twice_g_size;
  const double L_2_padded = L_2_size + 2.004168360008973e-292;
  const double s_5_abs = fabs(s->m5), twice_i_size = KSL_MUL(s_5_abs, L_2_padded),
      twice_j_size = twice_h_size + twice_i_size, twice_size = twice_e_size + twice_j_size;
  const double twice_padded = twice_size + 2.004168360008973e-292;
  const double energy_size = KSL_MUL(0.5, twice_padded);
  const double energy_padded = energy_size + 2.004168360008973e-292,
      energy_error_bound = KSL_MUL(9.992007221626415e-16, energy_padded);
  *energy_bound = energy_error_bound;
  return energy;
}

/* Bo: the body moved by t: h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless
     inf or NaN.
   t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
     yy, zz, xy, xz, yz in kg m^2).
   42 mul, 54 add, 15 abs. */
static inline void ksl_inertia_shifted_certified(const ksl_vec3_t *t, const ksl_inertia_t *B,
    ksl_inertia_t *Bo, ksl_inertia_t *Bo_bound) {
  const double mt_0 = KSL_MUL(t->x, B->m);
  const double mt_1 = KSL_MUL(t->y, B->m);
  const double mt_2 = KSL_MUL(t->z, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0);
  const double half_1 = KSL_MUL(0.5, mt_1);
  const double half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = B->h.x + half_0;
  const double n_1 = B->h.y + half_1;
  const double n_2 = B->h.z + half_2;
  const double tn0 = KSL_MUL(t->x, n_0);
  const double tn1 = KSL_MUL(t->y, n_1);
  const double tn2 = KSL_MUL(t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(t->x, n_1), pairs_3b = KSL_MUL(t->y, n_0),
      pairs_3 = pairs_3a + pairs_3b;
  const double pairs_4a = KSL_MUL(t->x, n_2), pairs_4b = KSL_MUL(t->z, n_0),
      pairs_4 = pairs_4a + pairs_4b;
  const double pairs_5a = KSL_MUL(t->y, n_2), pairs_5b = KSL_MUL(t->z, n_1),
      pairs_5 = pairs_5a + pairs_5b;
  const double moved_0 = B->h.x + mt_0;
  const double moved_1 = B->h.y + mt_1;
  const double moved_2 = B->h.z + mt_2;
  const double Bo_4 = B->xx + pairs_0;
  const double Bo_5 = B->yy + pairs_1;
  const double Bo_6 = B->zz + pairs_2;
  const double Bo_7 = B->xy - pairs_3;
  const double Bo_8 = B->xz - pairs_4;
  const double Bo_9 = B->yz - pairs_5;
  const double mt_0_abs = fabs(mt_0), mt_0_padded = mt_0_abs + 2.004168360008973e-292;
  const double half_0_size = KSL_MUL(0.5, mt_0_padded);
  const double mt_1_abs = fabs(mt_1), mt_1_padded = mt_1_abs + 2.004168360008973e-292;
  const double half_1_size = KSL_MUL(0.5, mt_1_padded);
  const double mt_2_abs = fabs(mt_2), mt_2_padded = mt_2_abs + 2.004168360008973e-292;
  const double half_2_size = KSL_MUL(0.5, mt_2_padded);
  const double B_1_abs = fabs(B->h.x), n_0_size = B_1_abs + half_0_size;
  const double B_2_abs = fabs(B->h.y), n_1_size = B_2_abs + half_1_size;
  const double B_3_abs = fabs(B->h.z), n_2_size = B_3_abs + half_2_size;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double t_0_abs = fabs(t->x), tn0_size = KSL_MUL(t_0_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double t_1_abs = fabs(t->y), tn1_size = KSL_MUL(t_1_abs, n_1_padded);
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double t_2_abs = fabs(t->z), tn2_size = KSL_MUL(t_2_abs, n_2_padded);
  const double tn0_padded = tn0_size + 2.004168360008973e-292;
  const double own_0_size = KSL_MUL(2.0, tn0_padded);
  const double tn1_padded = tn1_size + 2.004168360008973e-292;
  const double own_1_size = KSL_MUL(2.0, tn1_padded);
  const double tn2_padded = tn2_size + 2.004168360008973e-292;
  const double own_2_size = KSL_MUL(2.0, tn2_padded);
  const double pairs_0_size = own_1_size + own_2_size;
  const double pairs_1_size = own_0_size + own_2_size;
  const double pairs_2_size = own_0_size + own_1_size;
  const double pairs_3a_size = KSL_MUL(t_0_abs, n_1_padded),
      pairs_3b_size = KSL_MUL(t_1_abs, n_0_padded), pairs_3_size = pairs_3a_size + pairs_3b_size;
  const double pairs_4a_size = KSL_MUL(t_0_abs, n_2_padded),
      pairs_4b_size = KSL_MUL(t_2_abs, n_0_padded), pairs_4_size = pairs_4a_size + pairs_4b_size;
  const double pairs_5a_size = KSL_MUL(t_1_abs, n_2_padded),
      pairs_5b_size = KSL_MUL(t_2_abs, n_1_padded), pairs_5_size = pairs_5a_size + pairs_5b_size;
  const double moved_0_size = B_1_abs + mt_0_abs;
  const double moved_1_size = B_2_abs + mt_1_abs;
  const double moved_2_size = B_3_abs + mt_2_abs;
  const double B_4_abs = fabs(B->xx), Bo_4_size = B_4_abs + pairs_0_size;
  const double B_5_abs = fabs(B->yy), Bo_5_size = B_5_abs + pairs_1_size;
  const double B_6_abs = fabs(B->zz), Bo_6_size = B_6_abs + pairs_2_size;
  const double B_7_abs = fabs(B->xy), Bo_7_size = B_7_abs + pairs_3_size;
  const double B_8_abs = fabs(B->xz), Bo_8_size = B_8_abs + pairs_4_size;
  const double B_9_abs = fabs(B->yz), Bo_9_size = B_9_abs + pairs_5_size;
  const double moved_0_padded = moved_0_size + 2.004168360008973e-292,
      moved_0_error_bound = KSL_MUL(2.2204460492503136e-16, moved_0_padded);
  const double moved_1_padded = moved_1_size + 2.004168360008973e-292,
      moved_1_error_bound = KSL_MUL(2.2204460492503136e-16, moved_1_padded);
  const double moved_2_padded = moved_2_size + 2.004168360008973e-292,
      moved_2_error_bound = KSL_MUL(2.2204460492503136e-16, moved_2_padded);
  const double Bo_4_padded = Bo_4_size + 2.004168360008973e-292,
      Bo_4_error_bound = KSL_MUL(7.7715611723761e-16, Bo_4_padded);
  const double Bo_5_padded = Bo_5_size + 2.004168360008973e-292,
      Bo_5_error_bound = KSL_MUL(7.7715611723761e-16, Bo_5_padded);
  const double Bo_6_padded = Bo_6_size + 2.004168360008973e-292,
      Bo_6_error_bound = KSL_MUL(7.7715611723761e-16, Bo_6_padded);
  const double Bo_7_padded = Bo_7_size + 2.004168360008973e-292,
      Bo_7_error_bound = KSL_MUL(6.661338147750942e-16, Bo_7_padded);
  const double Bo_8_padded = Bo_8_size + 2.004168360008973e-292,
      Bo_8_error_bound = KSL_MUL(6.661338147750942e-16, Bo_8_padded);
  const double Bo_9_padded = Bo_9_size + 2.004168360008973e-292,
      Bo_9_error_bound = KSL_MUL(6.661338147750942e-16, Bo_9_padded);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = moved_0_error_bound;
  Bo_bound->h.y = moved_1_error_bound;
  Bo_bound->h.z = moved_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): the inertia in the frame D takes its own to; |error of Bo| <=
     Bo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   114 mul, 135 add, 51 abs. */
static inline void ksl_inertia_transformed_certified(const ksl_SE3_t *D, const ksl_inertia_t *B,
    ksl_inertia_t *Bo, ksl_inertia_t *Bo_bound) {
  const double RI_0a = KSL_MUL(D->m00, B->xx), RI_0b = KSL_MUL(D->m01, B->xy),
      RI_0c = RI_0a + RI_0b, RI_0d = KSL_MUL(D->m02, B->xz), RI_0 = RI_0c + RI_0d;
  const double RI_1a = KSL_MUL(D->m00, B->xy), RI_1b = KSL_MUL(D->m01, B->yy),
      RI_1c = RI_1a + RI_1b, RI_1d = KSL_MUL(D->m02, B->yz), RI_1 = RI_1c + RI_1d;
  const double RI_2a = KSL_MUL(D->m00, B->xz), RI_2b = KSL_MUL(D->m01, B->yz),
      RI_2c = RI_2a + RI_2b, RI_2d = KSL_MUL(D->m02, B->zz), RI_2 = RI_2c + RI_2d;
  const double RI_3a = KSL_MUL(D->m10, B->xx), RI_3b = KSL_MUL(D->m11, B->xy),
      RI_3c = RI_3a + RI_3b, RI_3d = KSL_MUL(D->m12, B->xz), RI_3 = RI_3c + RI_3d;
  const double RI_4a = KSL_MUL(D->m10, B->xy), RI_4b = KSL_MUL(D->m11, B->yy),
      RI_4c = RI_4a + RI_4b, RI_4d = KSL_MUL(D->m12, B->yz), RI_4 = RI_4c + RI_4d;
  const double RI_5a = KSL_MUL(D->m10, B->xz), RI_5b = KSL_MUL(D->m11, B->yz),
      RI_5c = RI_5a + RI_5b, RI_5d = KSL_MUL(D->m12, B->zz), RI_5 = RI_5c + RI_5d;
  const double RI_6a = KSL_MUL(D->m20, B->xx), RI_6b = KSL_MUL(D->m21, B->xy),
      RI_6c = RI_6a + RI_6b, RI_6d = KSL_MUL(D->m22, B->xz), RI_6 = RI_6c + RI_6d;
  const double RI_7a = KSL_MUL(D->m20, B->xy), RI_7b = KSL_MUL(D->m21, B->yy),
      RI_7c = RI_7a + RI_7b, RI_7d = KSL_MUL(D->m22, B->yz), RI_7 = RI_7c + RI_7d;
  const double RI_8a = KSL_MUL(D->m20, B->xz), RI_8b = KSL_MUL(D->m21, B->yz),
      RI_8c = RI_8a + RI_8b, RI_8d = KSL_MUL(D->m22, B->zz), RI_8 = RI_8c + RI_8d;
  const double turned_1a = KSL_MUL(D->m00, B->h.x), turned_1b = KSL_MUL(D->m01, B->h.y),
      turned_1c = turned_1a + turned_1b, turned_1d = KSL_MUL(D->m02, B->h.z),
      turned_1 = turned_1c + turned_1d;
  const double turned_2a = KSL_MUL(D->m10, B->h.x), turned_2b = KSL_MUL(D->m11, B->h.y),
      turned_2c = turned_2a + turned_2b, turned_2d = KSL_MUL(D->m12, B->h.z),
      turned_2 = turned_2c + turned_2d;
  const double turned_3a = KSL_MUL(D->m20, B->h.x), turned_3b = KSL_MUL(D->m21, B->h.y),
      turned_3c = turned_3a + turned_3b, turned_3d = KSL_MUL(D->m22, B->h.z),
      turned_3 = turned_3c + turned_3d;
  const double turned_4a = KSL_MUL(D->m00, RI_0), turned_4b = KSL_MUL(D->m01, RI_1),
      turned_4c = turned_4a + turned_4b, turned_4d = KSL_MUL(D->m02, RI_2),
      turned_4 = turned_4c + turned_4d;
  const double turned_5a = KSL_MUL(D->m10, RI_3), turned_5b = KSL_MUL(D->m11, RI_4),
      turned_5c = turned_5a + turned_5b, turned_5d = KSL_MUL(D->m12, RI_5),
      turned_5 = turned_5c + turned_5d;
  const double turned_6a = KSL_MUL(D->m20, RI_6), turned_6b = KSL_MUL(D->m21, RI_7),
      turned_6c = turned_6a + turned_6b, turned_6d = KSL_MUL(D->m22, RI_8),
      turned_6 = turned_6c + turned_6d;
  const double turned_7a = KSL_MUL(D->m10, RI_0), turned_7b = KSL_MUL(D->m11, RI_1),
      turned_7c = turned_7a + turned_7b, turned_7d = KSL_MUL(D->m12, RI_2),
      turned_7 = turned_7c + turned_7d;
  const double turned_8a = KSL_MUL(D->m20, RI_0), turned_8b = KSL_MUL(D->m21, RI_1),
      turned_8c = turned_8a + turned_8b, turned_8d = KSL_MUL(D->m22, RI_2),
      turned_8 = turned_8c + turned_8d;
  const double turned_9a = KSL_MUL(D->m20, RI_3), turned_9b = KSL_MUL(D->m21, RI_4),
      turned_9c = turned_9a + turned_9b, turned_9d = KSL_MUL(D->m22, RI_5),
      turned_9 = turned_9c + turned_9d;
  const double mt_0 = KSL_MUL(D->m03, B->m);
  const double mt_1 = KSL_MUL(D->m13, B->m);
  const double mt_2 = KSL_MUL(D->m23, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0);
  const double half_1 = KSL_MUL(0.5, mt_1);
  const double half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = turned_1 + half_0;
  const double n_1 = turned_2 + half_1;
  const double n_2 = turned_3 + half_2;
  const double tn0 = KSL_MUL(D->m03, n_0);
  const double tn1 = KSL_MUL(D->m13, n_1);
  const double tn2 = KSL_MUL(D->m23, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(D->m03, n_1), pairs_3b = KSL_MUL(D->m13, n_0),
      pairs_3 = pairs_3a + pairs_3b;
  const double pairs_4a = KSL_MUL(D->m03, n_2), pairs_4b = KSL_MUL(D->m23, n_0),
      pairs_4 = pairs_4a + pairs_4b;
  const double pairs_5a = KSL_MUL(D->m13, n_2), pairs_5b = KSL_MUL(D->m23, n_1),
      pairs_5 = pairs_5a + pairs_5b;
  const double moved_0 = turned_1 + mt_0;
  const double moved_1 = turned_2 + mt_1;
  const double moved_2 = turned_3 + mt_2;
  const double Bo_4 = turned_4 + pairs_0;
  const double Bo_5 = turned_5 + pairs_1;
  const double Bo_6 = turned_6 + pairs_2;
  const double Bo_7 = turned_7 - pairs_3;
  const double Bo_8 = turned_8 - pairs_4;
  const double Bo_9 = turned_9 - pairs_5;
  const double RI_0a_abs = fabs(RI_0a), RI_0b_abs = fabs(RI_0b), RI_0c_size = RI_0a_abs + RI_0b_abs,
      RI_0d_abs = fabs(RI_0d), RI_0_size = RI_0c_size + RI_0d_abs;
  const double RI_1a_abs = fabs(RI_1a), RI_1b_abs = fabs(RI_1b), RI_1c_size = RI_1a_abs + RI_1b_abs,
      RI_1d_abs = fabs(RI_1d), RI_1_size = RI_1c_size + RI_1d_abs;
  const double RI_2a_abs = fabs(RI_2a), RI_2b_abs = fabs(RI_2b), RI_2c_size = RI_2a_abs + RI_2b_abs,
      RI_2d_abs = fabs(RI_2d), RI_2_size = RI_2c_size + RI_2d_abs;
  const double RI_3a_abs = fabs(RI_3a), RI_3b_abs = fabs(RI_3b), RI_3c_size = RI_3a_abs + RI_3b_abs,
      RI_3d_abs = fabs(RI_3d), RI_3_size = RI_3c_size + RI_3d_abs;
  const double RI_4a_abs = fabs(RI_4a), RI_4b_abs = fabs(RI_4b), RI_4c_size = RI_4a_abs + RI_4b_abs,
      RI_4d_abs = fabs(RI_4d), RI_4_size = RI_4c_size + RI_4d_abs;
  const double RI_5a_abs = fabs(RI_5a), RI_5b_abs = fabs(RI_5b), RI_5c_size = RI_5a_abs + RI_5b_abs,
      RI_5d_abs = fabs(RI_5d), RI_5_size = RI_5c_size + RI_5d_abs;
  const double RI_6a_abs = fabs(RI_6a), RI_6b_abs = fabs(RI_6b), RI_6c_size = RI_6a_abs + RI_6b_abs,
      RI_6d_abs = fabs(RI_6d), RI_6_size = RI_6c_size + RI_6d_abs;
  const double RI_7a_abs = fabs(RI_7a), RI_7b_abs = fabs(RI_7b), RI_7c_size = RI_7a_abs + RI_7b_abs,
      RI_7d_abs = fabs(RI_7d), RI_7_size = RI_7c_size + RI_7d_abs;
  const double RI_8a_abs = fabs(RI_8a), RI_8b_abs = fabs(RI_8b), RI_8c_size = RI_8a_abs + RI_8b_abs,
      RI_8d_abs = fabs(RI_8d), RI_8_size = RI_8c_size + RI_8d_abs;
  const double turned_1a_abs = fabs(turned_1a), turned_1b_abs = fabs(turned_1b),
      turned_1c_size = turned_1a_abs + turned_1b_abs, turned_1d_abs = fabs(turned_1d),
      turned_1_size = turned_1c_size + turned_1d_abs;
  const double turned_2a_abs = fabs(turned_2a), turned_2b_abs = fabs(turned_2b),
      turned_2c_size = turned_2a_abs + turned_2b_abs, turned_2d_abs = fabs(turned_2d),
      turned_2_size = turned_2c_size + turned_2d_abs;
  const double turned_3a_abs = fabs(turned_3a), turned_3b_abs = fabs(turned_3b),
      turned_3c_size = turned_3a_abs + turned_3b_abs, turned_3d_abs = fabs(turned_3d),
      turned_3_size = turned_3c_size + turned_3d_abs;
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292;
  const double D_00_abs = fabs(D->m00), turned_4a_size = KSL_MUL(D_00_abs, RI_0_padded);
  const double RI_1_padded = RI_1_size + 2.004168360008973e-292;
  const double D_01_abs = fabs(D->m01), turned_4b_size = KSL_MUL(D_01_abs, RI_1_padded),
      turned_4c_size = turned_4a_size + turned_4b_size;
  const double RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double D_02_abs = fabs(D->m02), turned_4d_size = KSL_MUL(D_02_abs, RI_2_padded),
      turned_4_size = turned_4c_size + turned_4d_size;
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10), turned_5a_size = KSL_MUL(D_10_abs, RI_3_padded);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double D_11_abs = fabs(D->m11), turned_5b_size = KSL_MUL(D_11_abs, RI_4_padded),
      turned_5c_size = turned_5a_size + turned_5b_size;
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double D_12_abs = fabs(D->m12), turned_5d_size = KSL_MUL(D_12_abs, RI_5_padded),
      turned_5_size = turned_5c_size + turned_5d_size;
  const double RI_6_padded = RI_6_size + 2.004168360008973e-292;
  const double D_20_abs = fabs(D->m20), turned_6a_size = KSL_MUL(D_20_abs, RI_6_padded);
  const double RI_7_padded = RI_7_size + 2.004168360008973e-292;
  const double D_21_abs = fabs(D->m21), turned_6b_size = KSL_MUL(D_21_abs, RI_7_padded),
      turned_6c_size = turned_6a_size + turned_6b_size;
  const double RI_8_padded = RI_8_size + 2.004168360008973e-292;
  const double D_22_abs = fabs(D->m22), turned_6d_size = KSL_MUL(D_22_abs, RI_8_padded),
      turned_6_size = turned_6c_size + turned_6d_size;
  const double turned_7a_size = KSL_MUL(D_10_abs, RI_0_padded),
      turned_7b_size = KSL_MUL(D_11_abs, RI_1_padded),
      turned_7c_size = turned_7a_size + turned_7b_size,
      turned_7d_size = KSL_MUL(D_12_abs, RI_2_padded),
      turned_7_size = turned_7c_size + turned_7d_size;
  const double turned_8a_size = KSL_MUL(D_20_abs, RI_0_padded),
      turned_8b_size = KSL_MUL(D_21_abs, RI_1_padded),
      turned_8c_size = turned_8a_size + turned_8b_size,
      turned_8d_size = KSL_MUL(D_22_abs, RI_2_padded),
      turned_8_size = turned_8c_size + turned_8d_size;
  const double turned_9a_size = KSL_MUL(D_20_abs, RI_3_padded),
      turned_9b_size = KSL_MUL(D_21_abs, RI_4_padded),
      turned_9c_size = turned_9a_size + turned_9b_size,
      turned_9d_size = KSL_MUL(D_22_abs, RI_5_padded),
      turned_9_size = turned_9c_size + turned_9d_size;
  const double mt_0_abs = fabs(mt_0), mt_0_padded = mt_0_abs + 2.004168360008973e-292;
  const double half_0_size = KSL_MUL(0.5, mt_0_padded);
  const double mt_1_abs = fabs(mt_1), mt_1_padded = mt_1_abs + 2.004168360008973e-292;
  const double half_1_size = KSL_MUL(0.5, mt_1_padded);
  const double mt_2_abs = fabs(mt_2), mt_2_padded = mt_2_abs + 2.004168360008973e-292;
  const double half_2_size = KSL_MUL(0.5, mt_2_padded);
  const double n_0_size = turned_1_size + half_0_size;
  const double n_1_size = turned_2_size + half_1_size;
  const double n_2_size = turned_3_size + half_2_size;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03), tn0_size = KSL_MUL(D_03_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), tn1_size = KSL_MUL(D_13_abs, n_1_padded);
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), tn2_size = KSL_MUL(D_23_abs, n_2_padded);
  const double tn0_padded = tn0_size + 2.004168360008973e-292;
  const double own_0_size = KSL_MUL(2.0, tn0_padded);
  const double tn1_padded = tn1_size + 2.004168360008973e-292;
  const double own_1_size = KSL_MUL(2.0, tn1_padded);
  const double tn2_padded = tn2_size + 2.004168360008973e-292;
  const double own_2_size = KSL_MUL(2.0, tn2_padded);
  const double pairs_0_size = own_1_size + own_2_size;
  const double pairs_1_size = own_0_size + own_2_size;
  const double pairs_2_size = own_0_size + own_1_size;
  const double pairs_3a_size = KSL_MUL(D_03_abs, n_1_padded),
      pairs_3b_size = KSL_MUL(D_13_abs, n_0_padded), pairs_3_size = pairs_3a_size + pairs_3b_size;
  const double pairs_4a_size = KSL_MUL(D_03_abs, n_2_padded),
      pairs_4b_size = KSL_MUL(D_23_abs, n_0_padded), pairs_4_size = pairs_4a_size + pairs_4b_size;
  const double pairs_5a_size = KSL_MUL(D_13_abs, n_2_padded),
      pairs_5b_size = KSL_MUL(D_23_abs, n_1_padded), pairs_5_size = pairs_5a_size + pairs_5b_size;
  const double moved_0_size = turned_1_size + mt_0_abs;
  const double moved_1_size = turned_2_size + mt_1_abs;
  const double moved_2_size = turned_3_size + mt_2_abs;
  const double Bo_4_size = turned_4_size + pairs_0_size;
  const double Bo_5_size = turned_5_size + pairs_1_size;
  const double Bo_6_size = turned_6_size + pairs_2_size;
  const double Bo_7_size = turned_7_size + pairs_3_size;
  const double Bo_8_size = turned_8_size + pairs_4_size;
  const double Bo_9_size = turned_9_size + pairs_5_size;
  const double moved_0_padded = moved_0_size + 2.004168360008973e-292,
      moved_0_error_bound = KSL_MUL(4.440892098500628e-16, moved_0_padded);
  const double moved_1_padded = moved_1_size + 2.004168360008973e-292,
      moved_1_error_bound = KSL_MUL(4.440892098500628e-16, moved_1_padded);
  const double moved_2_padded = moved_2_size + 2.004168360008973e-292,
      moved_2_error_bound = KSL_MUL(4.440892098500628e-16, moved_2_padded);
  const double Bo_4_padded = Bo_4_size + 2.004168360008973e-292,
      Bo_4_error_bound = KSL_MUL(8.881784197001258e-16, Bo_4_padded);
  const double Bo_5_padded = Bo_5_size + 2.004168360008973e-292,
      Bo_5_error_bound = KSL_MUL(8.881784197001258e-16, Bo_5_padded);
  const double Bo_6_padded = Bo_6_size + 2.004168360008973e-292,
      Bo_6_error_bound = KSL_MUL(8.881784197001258e-16, Bo_6_padded);
  const double Bo_7_padded = Bo_7_size + 2.004168360008973e-292,
      Bo_7_error_bound = KSL_MUL(7.7715611723761e-16, Bo_7_padded);
  const double Bo_8_padded = Bo_8_size + 2.004168360008973e-292,
      Bo_8_error_bound = KSL_MUL(7.7715611723761e-16, Bo_8_padded);
  const double Bo_9_padded = Bo_9_size + 2.004168360008973e-292,
      Bo_9_error_bound = KSL_MUL(7.7715611723761e-16, Bo_9_padded);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = moved_0_error_bound;
  Bo_bound->h.y = moved_1_error_bound;
  Bo_bound->h.z = moved_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2); a: number.
   20 mul, 10 add, 10 abs. */
static inline void ksl_inertiaf_scale_certified(ksl_inertiaf_t *self, const float a,
    ksl_inertiaf_t *self_bound) {
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
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  const float self_3_new_abs = fabsf(self_3_new),
      self_3_new_padded = self_3_new_abs + 1.9721523e-31f,
      self_3_new_error_bound = KSL_MULF(5.960465e-08f, self_3_new_padded);
  const float self_4_new_abs = fabsf(self_4_new),
      self_4_new_padded = self_4_new_abs + 1.9721523e-31f,
      self_4_new_error_bound = KSL_MULF(5.960465e-08f, self_4_new_padded);
  const float self_5_new_abs = fabsf(self_5_new),
      self_5_new_padded = self_5_new_abs + 1.9721523e-31f,
      self_5_new_error_bound = KSL_MULF(5.960465e-08f, self_5_new_padded);
  const float self_6_new_abs = fabsf(self_6_new),
      self_6_new_padded = self_6_new_abs + 1.9721523e-31f,
      self_6_new_error_bound = KSL_MULF(5.960465e-08f, self_6_new_padded);
  const float self_7_new_abs = fabsf(self_7_new),
      self_7_new_padded = self_7_new_abs + 1.9721523e-31f,
      self_7_new_error_bound = KSL_MULF(5.960465e-08f, self_7_new_padded);
  const float self_8_new_abs = fabsf(self_8_new),
      self_8_new_padded = self_8_new_abs + 1.9721523e-31f,
      self_8_new_error_bound = KSL_MULF(5.960465e-08f, self_8_new_padded);
  const float self_9_new_abs = fabsf(self_9_new),
      self_9_new_padded = self_9_new_abs + 1.9721523e-31f,
      self_9_new_error_bound = KSL_MULF(5.960465e-08f, self_9_new_padded);
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
  self_bound->m = self_0_new_error_bound;
  self_bound->h.x = self_1_new_error_bound;
  self_bound->h.y = self_2_new_error_bound;
  self_bound->h.z = self_3_new_error_bound;
  self_bound->xx = self_4_new_error_bound;
  self_bound->yy = self_5_new_error_bound;
  self_bound->zz = self_6_new_error_bound;
  self_bound->xy = self_7_new_error_bound;
  self_bound->xz = self_8_new_error_bound;
  self_bound->yz = self_9_new_error_bound;
}

/* Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_add_BBf_certified(const ksl_inertiaf_t *B1, const ksl_inertiaf_t *B2,
    ksl_inertiaf_t *Bo, ksl_inertiaf_t *Bo_bound) {
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
  const float Bo_0_abs = fabsf(Bo_0), Bo_0_error_bound = KSL_MULF(5.960465e-08f, Bo_0_abs);
  const float Bo_1_abs = fabsf(Bo_1), Bo_1_error_bound = KSL_MULF(5.960465e-08f, Bo_1_abs);
  const float Bo_2_abs = fabsf(Bo_2), Bo_2_error_bound = KSL_MULF(5.960465e-08f, Bo_2_abs);
  const float Bo_3_abs = fabsf(Bo_3), Bo_3_error_bound = KSL_MULF(5.960465e-08f, Bo_3_abs);
  const float Bo_4_abs = fabsf(Bo_4), Bo_4_error_bound = KSL_MULF(5.960465e-08f, Bo_4_abs);
  const float Bo_5_abs = fabsf(Bo_5), Bo_5_error_bound = KSL_MULF(5.960465e-08f, Bo_5_abs);
  const float Bo_6_abs = fabsf(Bo_6), Bo_6_error_bound = KSL_MULF(5.960465e-08f, Bo_6_abs);
  const float Bo_7_abs = fabsf(Bo_7), Bo_7_error_bound = KSL_MULF(5.960465e-08f, Bo_7_abs);
  const float Bo_8_abs = fabsf(Bo_8), Bo_8_error_bound = KSL_MULF(5.960465e-08f, Bo_8_abs);
  const float Bo_9_abs = fabsf(Bo_9), Bo_9_error_bound = KSL_MULF(5.960465e-08f, Bo_9_abs);
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
  Bo_bound->m = Bo_0_error_bound;
  Bo_bound->h.x = Bo_1_error_bound;
  Bo_bound->h.y = Bo_2_error_bound;
  Bo_bound->h.z = Bo_3_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_subtract_BBf_certified(const ksl_inertiaf_t *B1, const ksl_inertiaf_t *B2,
    ksl_inertiaf_t *Bo, ksl_inertiaf_t *Bo_bound) {
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
  const float Bo_0_abs = fabsf(Bo_0), Bo_0_error_bound = KSL_MULF(5.960465e-08f, Bo_0_abs);
  const float Bo_1_abs = fabsf(Bo_1), Bo_1_error_bound = KSL_MULF(5.960465e-08f, Bo_1_abs);
  const float Bo_2_abs = fabsf(Bo_2), Bo_2_error_bound = KSL_MULF(5.960465e-08f, Bo_2_abs);
  const float Bo_3_abs = fabsf(Bo_3), Bo_3_error_bound = KSL_MULF(5.960465e-08f, Bo_3_abs);
  const float Bo_4_abs = fabsf(Bo_4), Bo_4_error_bound = KSL_MULF(5.960465e-08f, Bo_4_abs);
  const float Bo_5_abs = fabsf(Bo_5), Bo_5_error_bound = KSL_MULF(5.960465e-08f, Bo_5_abs);
  const float Bo_6_abs = fabsf(Bo_6), Bo_6_error_bound = KSL_MULF(5.960465e-08f, Bo_6_abs);
  const float Bo_7_abs = fabsf(Bo_7), Bo_7_error_bound = KSL_MULF(5.960465e-08f, Bo_7_abs);
  const float Bo_8_abs = fabsf(Bo_8), Bo_8_error_bound = KSL_MULF(5.960465e-08f, Bo_8_abs);
  const float Bo_9_abs = fabsf(Bo_9), Bo_9_error_bound = KSL_MULF(5.960465e-08f, Bo_9_abs);
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
  Bo_bound->m = Bo_0_error_bound;
  Bo_bound->h.x = Bo_1_error_bound;
  Bo_bound->h.y = Bo_2_error_bound;
  Bo_bound->h.z = Bo_3_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; of the symmetric matrix
     the upper triangle): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf
     or NaN.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo, Bo_bound: spatial inertia (m in
     kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   24 mul, 27 add, 12 abs. */
static inline void ksl_inertiaf_from_com_certified(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_inertiaf_t *Bo, ksl_inertiaf_t *Bo_bound) {
  const float h_0 = KSL_MULF(m, com->x);
  const float h_1 = KSL_MULF(m, com->y);
  const float h_2 = KSL_MULF(m, com->z);
  const float squares_0 = KSL_MULF(com->x, h_0);
  const float squares_1 = KSL_MULF(com->y, h_1);
  const float squares_2 = KSL_MULF(com->z, h_2);
  const float Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const float Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const float Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const float Bo_7a = KSL_MULF(com->y, h_0), Bo_7 = Ic->m01 - Bo_7a;
  const float Bo_8a = KSL_MULF(com->z, h_0), Bo_8 = Ic->m02 - Bo_8a;
  const float Bo_9a = KSL_MULF(com->z, h_1), Bo_9 = Ic->m12 - Bo_9a;
  const float h_0_abs = fabsf(h_0), h_0_padded = h_0_abs + 1.9721523e-31f;
  const float com_0_abs = fabsf(com->x), squares_0_size = KSL_MULF(com_0_abs, h_0_padded);
  const float h_1_abs = fabsf(h_1), h_1_padded = h_1_abs + 1.9721523e-31f;
  const float com_1_abs = fabsf(com->y), squares_1_size = KSL_MULF(com_1_abs, h_1_padded);
  const float h_2_abs = fabsf(h_2), h_2_padded = h_2_abs + 1.9721523e-31f;
  const float com_2_abs = fabsf(com->z), squares_2_size = KSL_MULF(com_2_abs, h_2_padded);
  const float Bo_4a_size = squares_1_size + squares_2_size, Ic_00_abs = fabsf(Ic->m00),
      Bo_4_size = Ic_00_abs + Bo_4a_size;
  const float Bo_5a_size = squares_0_size + squares_2_size, Ic_11_abs = fabsf(Ic->m11),
      Bo_5_size = Ic_11_abs + Bo_5a_size;
  const float Bo_6a_size = squares_0_size + squares_1_size, Ic_22_abs = fabsf(Ic->m22),
      Bo_6_size = Ic_22_abs + Bo_6a_size;
  const float Bo_7a_size = KSL_MULF(com_1_abs, h_0_padded), Ic_01_abs = fabsf(Ic->m01),
      Bo_7_size = Ic_01_abs + Bo_7a_size;
  const float Bo_8a_size = KSL_MULF(com_2_abs, h_0_padded), Ic_02_abs = fabsf(Ic->m02),
      Bo_8_size = Ic_02_abs + Bo_8a_size;
  const float Bo_9a_size = KSL_MULF(com_2_abs, h_1_padded), Ic_12_abs = fabsf(Ic->m12),
      Bo_9_size = Ic_12_abs + Bo_9a_size;
  const float h_0_error_bound = KSL_MULF(5.960465e-08f, h_0_padded);
  const float h_1_error_bound = KSL_MULF(5.960465e-08f, h_1_padded);
  const float h_2_error_bound = KSL_MULF(5.960465e-08f, h_2_padded);
  const float Bo_4_padded = Bo_4_size + 1.9721523e-31f,
      Bo_4_error_bound = KSL_MULF(2.3841864e-07f, Bo_4_padded);
  const float Bo_5_padded = Bo_5_size + 1.9721523e-31f,
      Bo_5_error_bound = KSL_MULF(2.3841864e-07f, Bo_5_padded);
  const float Bo_6_padded = Bo_6_size + 1.9721523e-31f,
      Bo_6_error_bound = KSL_MULF(2.3841864e-07f, Bo_6_padded);
  const float Bo_7_padded = Bo_7_size + 1.9721523e-31f,
      Bo_7_error_bound = KSL_MULF(1.7881396e-07f, Bo_7_padded);
  const float Bo_8_padded = Bo_8_size + 1.9721523e-31f,
      Bo_8_error_bound = KSL_MULF(1.7881396e-07f, Bo_8_padded);
  const float Bo_9_padded = Bo_9_size + 1.9721523e-31f,
      Bo_9_error_bound = KSL_MULF(1.7881396e-07f, Bo_9_padded);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = h_0_error_bound;
  Bo_bound->h.y = h_1_error_bound;
  Bo_bound->h.z = h_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of co|
     <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   30 mul, 42 add, 24 abs. */
static inline void ksl_product_Bsf_certified(const ksl_inertiaf_t *B, const ksl_screwf_t *s,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(B->m, s->m0), co_0b = KSL_MULF(B->h.z, s->m4),
      co_0c = KSL_MULF(B->h.y, s->m5), co_0d = co_0b - co_0c, co_0 = co_0a + co_0d;
  const float co_1a = KSL_MULF(B->m, s->m1), co_1b = KSL_MULF(B->h.x, s->m5),
      co_1c = KSL_MULF(B->h.z, s->m3), co_1d = co_1b - co_1c, co_1 = co_1a + co_1d;
  const float co_2a = KSL_MULF(B->m, s->m2), co_2b = KSL_MULF(B->h.y, s->m3),
      co_2c = KSL_MULF(B->h.x, s->m4), co_2d = co_2b - co_2c, co_2 = co_2a + co_2d;
  const float co_3a = KSL_MULF(B->h.y, s->m2), co_3b = KSL_MULF(B->h.z, s->m1),
      co_3c = co_3a - co_3b, co_3d = KSL_MULF(B->xx, s->m3), co_3e = KSL_MULF(B->xy, s->m4),
      co_3f = co_3d + co_3e, co_3g = KSL_MULF(B->xz, s->m5), co_3h = co_3f + co_3g,
      co_3 = co_3c + co_3h;
  const float co_4a = KSL_MULF(B->h.z, s->m0), co_4b = KSL_MULF(B->h.x, s->m2),
      co_4c = co_4a - co_4b, co_4d = KSL_MULF(B->yy, s->m4), co_4e = KSL_MULF(B->xy, s->m3),
      co_4f = co_4d + co_4e, co_4g = KSL_MULF(B->yz, s->m5), co_4h = co_4f + co_4g,
      co_4 = co_4c + co_4h;
  const float co_5a = KSL_MULF(B->h.x, s->m1), co_5b = KSL_MULF(B->h.y, s->m0),
      co_5c = co_5a - co_5b, co_5d = KSL_MULF(B->zz, s->m5), co_5e = KSL_MULF(B->xz, s->m3),
      co_5f = co_5d + co_5e, co_5g = KSL_MULF(B->yz, s->m4), co_5h = co_5f + co_5g,
      co_5 = co_5c + co_5h;
  const float co_0b_abs = fabsf(co_0b), co_0c_abs = fabsf(co_0c),
      co_0d_size = co_0b_abs + co_0c_abs, co_0a_abs = fabsf(co_0a),
      co_0_size = co_0a_abs + co_0d_size;
  const float co_1b_abs = fabsf(co_1b), co_1c_abs = fabsf(co_1c),
      co_1d_size = co_1b_abs + co_1c_abs, co_1a_abs = fabsf(co_1a),
      co_1_size = co_1a_abs + co_1d_size;
  const float co_2b_abs = fabsf(co_2b), co_2c_abs = fabsf(co_2c),
      co_2d_size = co_2b_abs + co_2c_abs, co_2a_abs = fabsf(co_2a),
      co_2_size = co_2a_abs + co_2d_size;
  const float co_3a_abs = fabsf(co_3a), co_3b_abs = fabsf(co_3b),
      co_3c_size = co_3a_abs + co_3b_abs, co_3d_abs = fabsf(co_3d), co_3e_abs = fabsf(co_3e),
      co_3f_size = co_3d_abs + co_3e_abs, co_3g_abs = fabsf(co_3g),
      co_3h_size = co_3f_size + co_3g_abs, co_3_size = co_3c_size + co_3h_size;
  const float co_4a_abs = fabsf(co_4a), co_4b_abs = fabsf(co_4b),
      co_4c_size = co_4a_abs + co_4b_abs, co_4d_abs = fabsf(co_4d), co_4e_abs = fabsf(co_4e),
      co_4f_size = co_4d_abs + co_4e_abs, co_4g_abs = fabsf(co_4g),
      co_4h_size = co_4f_size + co_4g_abs, co_4_size = co_4c_size + co_4h_size;
  const float co_5a_abs = fabsf(co_5a), co_5b_abs = fabsf(co_5b),
      co_5c_size = co_5a_abs + co_5b_abs, co_5d_abs = fabsf(co_5d), co_5e_abs = fabsf(co_5e),
      co_5f_size = co_5d_abs + co_5e_abs, co_5g_abs = fabsf(co_5g),
      co_5h_size = co_5f_size + co_5g_abs, co_5_size = co_5c_size + co_5h_size;
  const float co_0_padded = co_0_size + 1.9721523e-31f,
      co_0_error_bound = KSL_MULF(1.7881396e-07f, co_0_padded);
  const float co_1_padded = co_1_size + 1.9721523e-31f,
      co_1_error_bound = KSL_MULF(1.7881396e-07f, co_1_padded);
  const float co_2_padded = co_2_size + 1.9721523e-31f,
      co_2_error_bound = KSL_MULF(1.7881396e-07f, co_2_padded);
  const float co_3_padded = co_3_size + 1.9721523e-31f,
      co_3_error_bound = KSL_MULF(2.3841864e-07f, co_3_padded);
  const float co_4_padded = co_4_size + 1.9721523e-31f,
      co_4_error_bound = KSL_MULF(2.3841864e-07f, co_4_padded);
  const float co_5_padded = co_5_size + 1.9721523e-31f,
      co_5_error_bound = KSL_MULF(2.3841864e-07f, co_5_padded);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_error_bound;
  co_bound->m1 = co_1_error_bound;
  co_bound->m2 = co_2_error_bound;
  co_bound->m3 = co_3_error_bound;
  co_bound->m4 = co_4_error_bound;
  co_bound->m5 = co_5_error_bound;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
     energy_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); energy_bound: number.
   39 mul, 45 add, 24 abs. */
static inline float ksl_inertiaf_energy_certified(const ksl_inertiaf_t *B, const ksl_screwf_t *s,
    float *energy_bound) {
  const float across_0a = KSL_MULF(B->h.z, s->m4), across_0b = KSL_MULF(B->h.y, s->m5),
      across_0 = across_0a - across_0b;
  const float across_1a = KSL_MULF(B->h.x, s->m5), across_1b = KSL_MULF(B->h.z, s->m3),
      across_1 = across_1a - across_1b;
  const float across_2a = KSL_MULF(B->h.y, s->m3), across_2b = KSL_MULF(B->h.x, s->m4),
      across_2 = across_2a - across_2b;
  const float twice_across_0 = KSL_MULF(2.0f, across_0);
  const float twice_across_1 = KSL_MULF(2.0f, across_1);
  const float twice_across_2 = KSL_MULF(2.0f, across_2);
  const float p_0a = KSL_MULF(B->m, s->m0), p_0 = p_0a + twice_across_0;
  const float p_1a = KSL_MULF(B->m, s->m1), p_1 = p_1a + twice_across_1;
  const float p_2a = KSL_MULF(B->m, s->m2), p_2 = p_2a + twice_across_2;
  const float L_0a = KSL_MULF(B->xx, s->m3), L_0b = KSL_MULF(B->xy, s->m4), L_0c = L_0a + L_0b,
      L_0d = KSL_MULF(B->xz, s->m5), L_0 = L_0c + L_0d;
  const float L_1a = KSL_MULF(B->yy, s->m4), L_1b = KSL_MULF(B->xy, s->m3), L_1c = L_1a + L_1b,
      L_1d = KSL_MULF(B->yz, s->m5), L_1 = L_1c + L_1d;
  const float L_2a = KSL_MULF(B->zz, s->m5), L_2b = KSL_MULF(B->xz, s->m3), L_2c = L_2a + L_2b,
      L_2d = KSL_MULF(B->yz, s->m4), L_2 = L_2c + L_2d;
  const float twice_a = KSL_MULF(s->m0, p_0), twice_b = KSL_MULF(s->m1, p_1),
      twice_c = twice_a + twice_b, twice_d = KSL_MULF(s->m2, p_2), twice_e = twice_c + twice_d,
      twice_f = KSL_MULF(s->m3, L_0), twice_g = KSL_MULF(s->m4, L_1), twice_h = twice_f + twice_g,
      twice_i = KSL_MULF(s->m5, L_2), twice_j = twice_h + twice_i, twice = twice_e + twice_j;
  const float energy = KSL_MULF(0.5f, twice);
  const float across_0a_abs = fabsf(across_0a), across_0b_abs = fabsf(across_0b),
      across_0_size = across_0a_abs + across_0b_abs;
  const float across_1a_abs = fabsf(across_1a), across_1b_abs = fabsf(across_1b),
      across_1_size = across_1a_abs + across_1b_abs;
  const float across_2a_abs = fabsf(across_2a), across_2b_abs = fabsf(across_2b),
      across_2_size = across_2a_abs + across_2b_abs;
  const float across_0_padded = across_0_size + 1.9721523e-31f;
  const float twice_across_0_size = KSL_MULF(2.0f, across_0_padded);
  const float across_1_padded = across_1_size + 1.9721523e-31f;
  const float twice_across_1_size = KSL_MULF(2.0f, across_1_padded);
  const float across_2_padded = across_2_size + 1.9721523e-31f;
  const float twice_across_2_size = KSL_MULF(2.0f, across_2_padded);
  const float p_0a_abs = fabsf(p_0a), p_0_size = p_0a_abs + twice_across_0_size;
  const float p_1a_abs = fabsf(p_1a), p_1_size = p_1a_abs + twice_across_1_size;
  const float p_2a_abs = fabsf(p_2a), p_2_size = p_2a_abs + twice_across_2_size;
  const float L_0a_abs = fabsf(L_0a), L_0b_abs = fabsf(L_0b), L_0c_size = L_0a_abs + L_0b_abs,
      L_0d_abs = fabsf(L_0d), L_0_size = L_0c_size + L_0d_abs;
  const float L_1a_abs = fabsf(L_1a), L_1b_abs = fabsf(L_1b), L_1c_size = L_1a_abs + L_1b_abs,
      L_1d_abs = fabsf(L_1d), L_1_size = L_1c_size + L_1d_abs;
  const float L_2a_abs = fabsf(L_2a), L_2b_abs = fabsf(L_2b), L_2c_size = L_2a_abs + L_2b_abs,
      L_2d_abs = fabsf(L_2d), L_2_size = L_2c_size + L_2d_abs;
  const float p_0_padded = p_0_size + 1.9721523e-31f;
  const float s_0_abs = fabsf(s->m0), twice_a_size = KSL_MULF(s_0_abs, p_0_padded);
  const float p_1_padded = p_1_size + 1.9721523e-31f;
  const float s_1_abs = fabsf(s->m1), twice_b_size = KSL_MULF(s_1_abs, p_1_padded),
      twice_c_size = twice_a_size + twice_b_size;
  const float p_2_padded = p_2_size + 1.9721523e-31f;
  const float s_2_abs = fabsf(s->m2), twice_d_size = KSL_MULF(s_2_abs, p_2_padded),
      twice_e_size = twice_c_size + twice_d_size;
  const float L_0_padded = L_0_size + 1.9721523e-31f;
  const float s_3_abs = fabsf(s->m3), twice_f_size = KSL_MULF(s_3_abs, L_0_padded);
  const float L_1_padded = L_1_size + 1.9721523e-31f;
  const float s_4_abs = fabsf(s->m4), twice_g_size = KSL_MULF(s_4_abs, L_1_padded),
      twice_h_size = twice_f_size + twice_g_size;
  const float L_2_padded = L_2_size + 1.9721523e-31f;
  const float s_5_abs = fabsf(s->m5), twice_i_size = KSL_MULF(s_5_abs, L_2_padded),
      twice_j_size = twice_h_size + twice_i_size, twice_size = twice_e_size + twice_j_size;
  const float twice_padded = twice_size + 1.9721523e-31f;
  const float energy_size = KSL_MULF(0.5f, twice_padded);
  const float energy_padded = energy_size + 1.9721523e-31f,
      energy_error_bound = KSL_MULF(5.36442e-07f, energy_padded);
  *energy_bound = energy_error_bound;
  return energy;
}

/* Bo: the body moved by t: h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless
     inf or NaN.
   t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
     yy, zz, xy, xz, yz in kg m^2).
   42 mul, 54 add, 15 abs. */
static inline void ksl_inertiaf_shifted_certified(const ksl_vec3f_t *t, const ksl_inertiaf_t *B,
    ksl_inertiaf_t *Bo, ksl_inertiaf_t *Bo_bound) {
  const float mt_0 = KSL_MULF(t->x, B->m);
  const float mt_1 = KSL_MULF(t->y, B->m);
  const float mt_2 = KSL_MULF(t->z, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0);
  const float half_1 = KSL_MULF(0.5f, mt_1);
  const float half_2 = KSL_MULF(0.5f, mt_2);
  const float n_0 = B->h.x + half_0;
  const float n_1 = B->h.y + half_1;
  const float n_2 = B->h.z + half_2;
  const float tn0 = KSL_MULF(t->x, n_0);
  const float tn1 = KSL_MULF(t->y, n_1);
  const float tn2 = KSL_MULF(t->z, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(t->x, n_1), pairs_3b = KSL_MULF(t->y, n_0),
      pairs_3 = pairs_3a + pairs_3b;
  const float pairs_4a = KSL_MULF(t->x, n_2), pairs_4b = KSL_MULF(t->z, n_0),
      pairs_4 = pairs_4a + pairs_4b;
  const float pairs_5a = KSL_MULF(t->y, n_2), pairs_5b = KSL_MULF(t->z, n_1),
      pairs_5 = pairs_5a + pairs_5b;
  const float moved_0 = B->h.x + mt_0;
  const float moved_1 = B->h.y + mt_1;
  const float moved_2 = B->h.z + mt_2;
  const float Bo_4 = B->xx + pairs_0;
  const float Bo_5 = B->yy + pairs_1;
  const float Bo_6 = B->zz + pairs_2;
  const float Bo_7 = B->xy - pairs_3;
  const float Bo_8 = B->xz - pairs_4;
  const float Bo_9 = B->yz - pairs_5;
  const float mt_0_abs = fabsf(mt_0), mt_0_padded = mt_0_abs + 1.9721523e-31f;
  const float half_0_size = KSL_MULF(0.5f, mt_0_padded);
  const float mt_1_abs = fabsf(mt_1), mt_1_padded = mt_1_abs + 1.9721523e-31f;
  const float half_1_size = KSL_MULF(0.5f, mt_1_padded);
  const float mt_2_abs = fabsf(mt_2), mt_2_padded = mt_2_abs + 1.9721523e-31f;
  const float half_2_size = KSL_MULF(0.5f, mt_2_padded);
  const float B_1_abs = fabsf(B->h.x), n_0_size = B_1_abs + half_0_size;
  const float B_2_abs = fabsf(B->h.y), n_1_size = B_2_abs + half_1_size;
  const float B_3_abs = fabsf(B->h.z), n_2_size = B_3_abs + half_2_size;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float t_0_abs = fabsf(t->x), tn0_size = KSL_MULF(t_0_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float t_1_abs = fabsf(t->y), tn1_size = KSL_MULF(t_1_abs, n_1_padded);
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float t_2_abs = fabsf(t->z), tn2_size = KSL_MULF(t_2_abs, n_2_padded);
  const float tn0_padded = tn0_size + 1.9721523e-31f;
  const float own_0_size = KSL_MULF(2.0f, tn0_padded);
  const float tn1_padded = tn1_size + 1.9721523e-31f;
  const float own_1_size = KSL_MULF(2.0f, tn1_padded);
  const float tn2_padded = tn2_size + 1.9721523e-31f;
  const float own_2_size = KSL_MULF(2.0f, tn2_padded);
  const float pairs_0_size = own_1_size + own_2_size;
  const float pairs_1_size = own_0_size + own_2_size;
  const float pairs_2_size = own_0_size + own_1_size;
  const float pairs_3a_size = KSL_MULF(t_0_abs, n_1_padded),
      pairs_3b_size = KSL_MULF(t_1_abs, n_0_padded), pairs_3_size = pairs_3a_size + pairs_3b_size;
  const float pairs_4a_size = KSL_MULF(t_0_abs, n_2_padded),
      pairs_4b_size = KSL_MULF(t_2_abs, n_0_padded), pairs_4_size = pairs_4a_size + pairs_4b_size;
  const float pairs_5a_size = KSL_MULF(t_1_abs, n_2_padded),
      pairs_5b_size = KSL_MULF(t_2_abs, n_1_padded), pairs_5_size = pairs_5a_size + pairs_5b_size;
  const float moved_0_size = B_1_abs + mt_0_abs;
  const float moved_1_size = B_2_abs + mt_1_abs;
  const float moved_2_size = B_3_abs + mt_2_abs;
  const float B_4_abs = fabsf(B->xx), Bo_4_size = B_4_abs + pairs_0_size;
  const float B_5_abs = fabsf(B->yy), Bo_5_size = B_5_abs + pairs_1_size;
  const float B_6_abs = fabsf(B->zz), Bo_6_size = B_6_abs + pairs_2_size;
  const float B_7_abs = fabsf(B->xy), Bo_7_size = B_7_abs + pairs_3_size;
  const float B_8_abs = fabsf(B->xz), Bo_8_size = B_8_abs + pairs_4_size;
  const float B_9_abs = fabsf(B->yz), Bo_9_size = B_9_abs + pairs_5_size;
  const float moved_0_padded = moved_0_size + 1.9721523e-31f,
      moved_0_error_bound = KSL_MULF(1.192093e-07f, moved_0_padded);
  const float moved_1_padded = moved_1_size + 1.9721523e-31f,
      moved_1_error_bound = KSL_MULF(1.192093e-07f, moved_1_padded);
  const float moved_2_padded = moved_2_size + 1.9721523e-31f,
      moved_2_error_bound = KSL_MULF(1.192093e-07f, moved_2_padded);
  const float Bo_4_padded = Bo_4_size + 1.9721523e-31f,
      Bo_4_error_bound = KSL_MULF(4.1723263e-07f, Bo_4_padded);
  const float Bo_5_padded = Bo_5_size + 1.9721523e-31f,
      Bo_5_error_bound = KSL_MULF(4.1723263e-07f, Bo_5_padded);
  const float Bo_6_padded = Bo_6_size + 1.9721523e-31f,
      Bo_6_error_bound = KSL_MULF(4.1723263e-07f, Bo_6_padded);
  const float Bo_7_padded = Bo_7_size + 1.9721523e-31f,
      Bo_7_error_bound = KSL_MULF(3.5762795e-07f, Bo_7_padded);
  const float Bo_8_padded = Bo_8_size + 1.9721523e-31f,
      Bo_8_error_bound = KSL_MULF(3.5762795e-07f, Bo_8_padded);
  const float Bo_9_padded = Bo_9_size + 1.9721523e-31f,
      Bo_9_error_bound = KSL_MULF(3.5762795e-07f, Bo_9_padded);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = moved_0_error_bound;
  Bo_bound->h.y = moved_1_error_bound;
  Bo_bound->h.z = moved_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): the inertia in the frame D takes its own to; |error of Bo| <=
     Bo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   114 mul, 135 add, 51 abs. */
static inline void ksl_inertiaf_transformed_certified(const ksl_SE3f_t *D,
    const ksl_inertiaf_t *B, ksl_inertiaf_t *Bo, ksl_inertiaf_t *Bo_bound) {
  const float RI_0a = KSL_MULF(D->m00, B->xx), RI_0b = KSL_MULF(D->m01, B->xy),
      RI_0c = RI_0a + RI_0b, RI_0d = KSL_MULF(D->m02, B->xz), RI_0 = RI_0c + RI_0d;
  const float RI_1a = KSL_MULF(D->m00, B->xy), RI_1b = KSL_MULF(D->m01, B->yy),
      RI_1c = RI_1a + RI_1b, RI_1d = KSL_MULF(D->m02, B->yz), RI_1 = RI_1c + RI_1d;
  const float RI_2a = KSL_MULF(D->m00, B->xz), RI_2b = KSL_MULF(D->m01, B->yz),
      RI_2c = RI_2a + RI_2b, RI_2d = KSL_MULF(D->m02, B->zz), RI_2 = RI_2c + RI_2d;
  const float RI_3a = KSL_MULF(D->m10, B->xx), RI_3b = KSL_MULF(D->m11, B->xy),
      RI_3c = RI_3a + RI_3b, RI_3d = KSL_MULF(D->m12, B->xz), RI_3 = RI_3c + RI_3d;
  const float RI_4a = KSL_MULF(D->m10, B->xy), RI_4b = KSL_MULF(D->m11, B->yy),
      RI_4c = RI_4a + RI_4b, RI_4d = KSL_MULF(D->m12, B->yz), RI_4 = RI_4c + RI_4d;
  const float RI_5a = KSL_MULF(D->m10, B->xz), RI_5b = KSL_MULF(D->m11, B->yz),
      RI_5c = RI_5a + RI_5b, RI_5d = KSL_MULF(D->m12, B->zz), RI_5 = RI_5c + RI_5d;
  const float RI_6a = KSL_MULF(D->m20, B->xx), RI_6b = KSL_MULF(D->m21, B->xy),
      RI_6c = RI_6a + RI_6b, RI_6d = KSL_MULF(D->m22, B->xz), RI_6 = RI_6c + RI_6d;
  const float RI_7a = KSL_MULF(D->m20, B->xy), RI_7b = KSL_MULF(D->m21, B->yy),
      RI_7c = RI_7a + RI_7b, RI_7d = KSL_MULF(D->m22, B->yz), RI_7 = RI_7c + RI_7d;
  const float RI_8a = KSL_MULF(D->m20, B->xz), RI_8b = KSL_MULF(D->m21, B->yz),
      RI_8c = RI_8a + RI_8b, RI_8d = KSL_MULF(D->m22, B->zz), RI_8 = RI_8c + RI_8d;
  const float turned_1a = KSL_MULF(D->m00, B->h.x), turned_1b = KSL_MULF(D->m01, B->h.y),
      turned_1c = turned_1a + turned_1b, turned_1d = KSL_MULF(D->m02, B->h.z),
      turned_1 = turned_1c + turned_1d;
  const float turned_2a = KSL_MULF(D->m10, B->h.x), turned_2b = KSL_MULF(D->m11, B->h.y),
      turned_2c = turned_2a + turned_2b, turned_2d = KSL_MULF(D->m12, B->h.z),
      turned_2 = turned_2c + turned_2d;
  const float turned_3a = KSL_MULF(D->m20, B->h.x), turned_3b = KSL_MULF(D->m21, B->h.y),
      turned_3c = turned_3a + turned_3b, turned_3d = KSL_MULF(D->m22, B->h.z),
      turned_3 = turned_3c + turned_3d;
  const float turned_4a = KSL_MULF(D->m00, RI_0), turned_4b = KSL_MULF(D->m01, RI_1),
      turned_4c = turned_4a + turned_4b, turned_4d = KSL_MULF(D->m02, RI_2),
      turned_4 = turned_4c + turned_4d;
  const float turned_5a = KSL_MULF(D->m10, RI_3), turned_5b = KSL_MULF(D->m11, RI_4),
      turned_5c = turned_5a + turned_5b, turned_5d = KSL_MULF(D->m12, RI_5),
      turned_5 = turned_5c + turned_5d;
  const float turned_6a = KSL_MULF(D->m20, RI_6), turned_6b = KSL_MULF(D->m21, RI_7),
      turned_6c = turned_6a + turned_6b, turned_6d = KSL_MULF(D->m22, RI_8),
      turned_6 = turned_6c + turned_6d;
  const float turned_7a = KSL_MULF(D->m10, RI_0), turned_7b = KSL_MULF(D->m11, RI_1),
      turned_7c = turned_7a + turned_7b, turned_7d = KSL_MULF(D->m12, RI_2),
      turned_7 = turned_7c + turned_7d;
  const float turned_8a = KSL_MULF(D->m20, RI_0), turned_8b = KSL_MULF(D->m21, RI_1),
      turned_8c = turned_8a + turned_8b, turned_8d = KSL_MULF(D->m22, RI_2),
      turned_8 = turned_8c + turned_8d;
  const float turned_9a = KSL_MULF(D->m20, RI_3), turned_9b = KSL_MULF(D->m21, RI_4),
      turned_9c = turned_9a + turned_9b, turned_9d = KSL_MULF(D->m22, RI_5),
      turned_9 = turned_9c + turned_9d;
  const float mt_0 = KSL_MULF(D->m03, B->m);
  const float mt_1 = KSL_MULF(D->m13, B->m);
  const float mt_2 = KSL_MULF(D->m23, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0);
  const float half_1 = KSL_MULF(0.5f, mt_1);
  const float half_2 = KSL_MULF(0.5f, mt_2);
  const float n_0 = turned_1 + half_0;
  const float n_1 = turned_2 + half_1;
  const float n_2 = turned_3 + half_2;
  const float tn0 = KSL_MULF(D->m03, n_0);
  const float tn1 = KSL_MULF(D->m13, n_1);
  const float tn2 = KSL_MULF(D->m23, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(D->m03, n_1), pairs_3b = KSL_MULF(D->m13, n_0),
      pairs_3 = pairs_3a + pairs_3b;
  const float pairs_4a = KSL_MULF(D->m03, n_2), pairs_4b = KSL_MULF(D->m23, n_0),
      pairs_4 = pairs_4a + pairs_4b;
  const float pairs_5a = KSL_MULF(D->m13, n_2), pairs_5b = KSL_MULF(D->m23, n_1),
      pairs_5 = pairs_5a + pairs_5b;
  const float moved_0 = turned_1 + mt_0;
  const float moved_1 = turned_2 + mt_1;
  const float moved_2 = turned_3 + mt_2;
  const float Bo_4 = turned_4 + pairs_0;
  const float Bo_5 = turned_5 + pairs_1;
  const float Bo_6 = turned_6 + pairs_2;
  const float Bo_7 = turned_7 - pairs_3;
  const float Bo_8 = turned_8 - pairs_4;
  const float Bo_9 = turned_9 - pairs_5;
  const float RI_0a_abs = fabsf(RI_0a), RI_0b_abs = fabsf(RI_0b),
      RI_0c_size = RI_0a_abs + RI_0b_abs, RI_0d_abs = fabsf(RI_0d),
      RI_0_size = RI_0c_size + RI_0d_abs;
  const float RI_1a_abs = fabsf(RI_1a), RI_1b_abs = fabsf(RI_1b),
      RI_1c_size = RI_1a_abs + RI_1b_abs, RI_1d_abs = fabsf(RI_1d),
      RI_1_size = RI_1c_size + RI_1d_abs;
  const float RI_2a_abs = fabsf(RI_2a), RI_2b_abs = fabsf(RI_2b),
      RI_2c_size = RI_2a_abs + RI_2b_abs, RI_2d_abs = fabsf(RI_2d),
      RI_2_size = RI_2c_size + RI_2d_abs;
  const float RI_3a_abs = fabsf(RI_3a), RI_3b_abs = fabsf(RI_3b),
      RI_3c_size = RI_3a_abs + RI_3b_abs, RI_3d_abs = fabsf(RI_3d),
      RI_3_size = RI_3c_size + RI_3d_abs;
  const float RI_4a_abs = fabsf(RI_4a), RI_4b_abs = fabsf(RI_4b),
      RI_4c_size = RI_4a_abs + RI_4b_abs, RI_4d_abs = fabsf(RI_4d),
      RI_4_size = RI_4c_size + RI_4d_abs;
  const float RI_5a_abs = fabsf(RI_5a), RI_5b_abs = fabsf(RI_5b),
      RI_5c_size = RI_5a_abs + RI_5b_abs, RI_5d_abs = fabsf(RI_5d),
      RI_5_size = RI_5c_size + RI_5d_abs;
  const float RI_6a_abs = fabsf(RI_6a), RI_6b_abs = fabsf(RI_6b),
      RI_6c_size = RI_6a_abs + RI_6b_abs, RI_6d_abs = fabsf(RI_6d),
      RI_6_size = RI_6c_size + RI_6d_abs;
  const float RI_7a_abs = fabsf(RI_7a), RI_7b_abs = fabsf(RI_7b),
      RI_7c_size = RI_7a_abs + RI_7b_abs, RI_7d_abs = fabsf(RI_7d),
      RI_7_size = RI_7c_size + RI_7d_abs;
  const float RI_8a_abs = fabsf(RI_8a), RI_8b_abs = fabsf(RI_8b),
      RI_8c_size = RI_8a_abs + RI_8b_abs, RI_8d_abs = fabsf(RI_8d),
      RI_8_size = RI_8c_size + RI_8d_abs;
  const float turned_1a_abs = fabsf(turned_1a), turned_1b_abs = fabsf(turned_1b),
      turned_1c_size = turned_1a_abs + turned_1b_abs, turned_1d_abs = fabsf(turned_1d),
      turned_1_size = turned_1c_size + turned_1d_abs;
  const float turned_2a_abs = fabsf(turned_2a), turned_2b_abs = fabsf(turned_2b),
      turned_2c_size = turned_2a_abs + turned_2b_abs, turned_2d_abs = fabsf(turned_2d),
      turned_2_size = turned_2c_size + turned_2d_abs;
  const float turned_3a_abs = fabsf(turned_3a), turned_3b_abs = fabsf(turned_3b),
      turned_3c_size = turned_3a_abs + turned_3b_abs, turned_3d_abs = fabsf(turned_3d),
      turned_3_size = turned_3c_size + turned_3d_abs;
  const float RI_0_padded = RI_0_size + 1.9721523e-31f;
  const float D_00_abs = fabsf(D->m00), turned_4a_size = KSL_MULF(D_00_abs, RI_0_padded);
  const float RI_1_padded = RI_1_size + 1.9721523e-31f;
  const float D_01_abs = fabsf(D->m01), turned_4b_size = KSL_MULF(D_01_abs, RI_1_padded),
      turned_4c_size = turned_4a_size + turned_4b_size;
  const float RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float D_02_abs = fabsf(D->m02), turned_4d_size = KSL_MULF(D_02_abs, RI_2_padded),
      turned_4_size = turned_4c_size + turned_4d_size;
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10), turned_5a_size = KSL_MULF(D_10_abs, RI_3_padded);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float D_11_abs = fabsf(D->m11), turned_5b_size = KSL_MULF(D_11_abs, RI_4_padded),
      turned_5c_size = turned_5a_size + turned_5b_size;
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float D_12_abs = fabsf(D->m12), turned_5d_size = KSL_MULF(D_12_abs, RI_5_padded),
      turned_5_size = turned_5c_size + turned_5d_size;
  const float RI_6_padded = RI_6_size + 1.9721523e-31f;
  const float D_20_abs = fabsf(D->m20), turned_6a_size = KSL_MULF(D_20_abs, RI_6_padded);
  const float RI_7_padded = RI_7_size + 1.9721523e-31f;
  const float D_21_abs = fabsf(D->m21), turned_6b_size = KSL_MULF(D_21_abs, RI_7_padded),
      turned_6c_size = turned_6a_size + turned_6b_size;
  const float RI_8_padded = RI_8_size + 1.9721523e-31f;
  const float D_22_abs = fabsf(D->m22), turned_6d_size = KSL_MULF(D_22_abs, RI_8_padded),
      turned_6_size = turned_6c_size + turned_6d_size;
  const float turned_7a_size = KSL_MULF(D_10_abs, RI_0_padded),
      turned_7b_size = KSL_MULF(D_11_abs, RI_1_padded),
      turned_7c_size = turned_7a_size + turned_7b_size,
      turned_7d_size = KSL_MULF(D_12_abs, RI_2_padded),
      turned_7_size = turned_7c_size + turned_7d_size;
  const float turned_8a_size = KSL_MULF(D_20_abs, RI_0_padded),
      turned_8b_size = KSL_MULF(D_21_abs, RI_1_padded),
      turned_8c_size = turned_8a_size + turned_8b_size,
      turned_8d_size = KSL_MULF(D_22_abs, RI_2_padded),
      turned_8_size = turned_8c_size + turned_8d_size;
  const float turned_9a_size = KSL_MULF(D_20_abs, RI_3_padded),
      turned_9b_size = KSL_MULF(D_21_abs, RI_4_padded),
      turned_9c_size = turned_9a_size + turned_9b_size,
      turned_9d_size = KSL_MULF(D_22_abs, RI_5_padded),
      turned_9_size = turned_9c_size + turned_9d_size;
  const float mt_0_abs = fabsf(mt_0), mt_0_padded = mt_0_abs + 1.9721523e-31f;
  const float half_0_size = KSL_MULF(0.5f, mt_0_padded);
  const float mt_1_abs = fabsf(mt_1), mt_1_padded = mt_1_abs + 1.9721523e-31f;
  const float half_1_size = KSL_MULF(0.5f, mt_1_padded);
  const float mt_2_abs = fabsf(mt_2), mt_2_padded = mt_2_abs + 1.9721523e-31f;
  const float half_2_size = KSL_MULF(0.5f, mt_2_padded);
  const float n_0_size = turned_1_size + half_0_size;
  const float n_1_size = turned_2_size + half_1_size;
  const float n_2_size = turned_3_size + half_2_size;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03), tn0_size = KSL_MULF(D_03_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), tn1_size = KSL_MULF(D_13_abs, n_1_padded);
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), tn2_size = KSL_MULF(D_23_abs, n_2_padded);
  const float tn0_padded = tn0_size + 1.9721523e-31f;
  const float own_0_size = KSL_MULF(2.0f, tn0_padded);
  const float tn1_padded = tn1_size + 1.9721523e-31f;
  const float own_1_size = KSL_MULF(2.0f, tn1_padded);
  const float tn2_padded = tn2_size + 1.9721523e-31f;
  const float own_2_size = KSL_MULF(2.0f, tn2_padded);
  const float pairs_0_size = own_1_size + own_2_size;
  const float pairs_1_size = own_0_size + own_2_size;
  const float pairs_2_size = own_0_size + own_1_size;
  const float pairs_3a_size = KSL_MULF(D_03_abs, n_1_padded),
      pairs_3b_size = KSL_MULF(D_13_abs, n_0_padded), pairs_3_size = pairs_3a_size + pairs_3b_size;
  const float pairs_4a_size = KSL_MULF(D_03_abs, n_2_padded),
      pairs_4b_size = KSL_MULF(D_23_abs, n_0_padded), pairs_4_size = pairs_4a_size + pairs_4b_size;
  const float pairs_5a_size = KSL_MULF(D_13_abs, n_2_padded),
      pairs_5b_size = KSL_MULF(D_23_abs, n_1_padded), pairs_5_size = pairs_5a_size + pairs_5b_size;
  const float moved_0_size = turned_1_size + mt_0_abs;
  const float moved_1_size = turned_2_size + mt_1_abs;
  const float moved_2_size = turned_3_size + mt_2_abs;
  const float Bo_4_size = turned_4_size + pairs_0_size;
  const float Bo_5_size = turned_5_size + pairs_1_size;
  const float Bo_6_size = turned_6_size + pairs_2_size;
  const float Bo_7_size = turned_7_size + pairs_3_size;
  const float Bo_8_size = turned_8_size + pairs_4_size;
  const float Bo_9_size = turned_9_size + pairs_5_size;
  const float moved_0_padded = moved_0_size + 1.9721523e-31f,
      moved_0_error_bound = KSL_MULF(2.3841864e-07f, moved_0_padded);
  const float moved_1_padded = moved_1_size + 1.9721523e-31f,
      moved_1_error_bound = KSL_MULF(2.3841864e-07f, moved_1_padded);
  const float moved_2_padded = moved_2_size + 1.9721523e-31f,
      moved_2_error_bound = KSL_MULF(2.3841864e-07f, moved_2_padded);
  const float Bo_4_padded = Bo_4_size + 1.9721523e-31f,
      Bo_4_error_bound = KSL_MULF(4.7683733e-07f, Bo_4_padded);
  const float Bo_5_padded = Bo_5_size + 1.9721523e-31f,
      Bo_5_error_bound = KSL_MULF(4.7683733e-07f, Bo_5_padded);
  const float Bo_6_padded = Bo_6_size + 1.9721523e-31f,
      Bo_6_error_bound = KSL_MULF(4.7683733e-07f, Bo_6_padded);
  const float Bo_7_padded = Bo_7_size + 1.9721523e-31f,
      Bo_7_error_bound = KSL_MULF(4.1723263e-07f, Bo_7_padded);
  const float Bo_8_padded = Bo_8_size + 1.9721523e-31f,
      Bo_8_error_bound = KSL_MULF(4.1723263e-07f, Bo_8_padded);
  const float Bo_9_padded = Bo_9_size + 1.9721523e-31f,
      Bo_9_error_bound = KSL_MULF(4.1723263e-07f, Bo_9_padded);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = moved_0_error_bound;
  Bo_bound->h.y = moved_1_error_bound;
  Bo_bound->h.z = moved_2_error_bound;
  Bo_bound->xx = Bo_4_error_bound;
  Bo_bound->yy = Bo_5_error_bound;
  Bo_bound->zz = Bo_6_error_bound;
  Bo_bound->xy = Bo_7_error_bound;
  Bo_bound->xz = Bo_8_error_bound;
  Bo_bound->yz = Bo_9_error_bound;
}

#endif
