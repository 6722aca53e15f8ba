/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
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
#elif (defined(__GNUC__) && !defined(__clang__)) || !KSL_HAS_FMA
#define KSL_MUL(a, b) ((a) * (b))
#else
/* Compilers that contract do so within an expression: the product is the result of a function. */
static inline double ksl_mul(const double a, const double b) {
  return a * b;
}
#define KSL_MUL(a, b) ksl_mul(a, b)
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
#elif (defined(__GNUC__) && !defined(__clang__)) || !KSL_HAS_FMAF
#define KSL_MULF(a, b) ((a) * (b))
#else
/* Compilers that contract do so within an expression: the product is the result of a function. */
static inline float ksl_mulf(const float a, const float b) {
  return a * b;
}
#define KSL_MULF(a, b) ksl_mulf(a, b)
#endif
#endif

#endif
