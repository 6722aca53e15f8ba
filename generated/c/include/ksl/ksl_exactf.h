/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exact rounding errors of products in single precision, without double.

   Exact where a product does not overflow and is zero or at least 2^-102 = 2.0e-31; the error of a
   smaller product is rounded to a multiple of the least subnormal number. */
#ifndef KSL_EXACTF_H
#define KSL_EXACTF_H

#include "ksl_types.h"

#include <stdint.h>

/* Functions that a file need not call.  Rare paths are never inlined; sine and cosine always are,
   unless the compiler optimises for size, so that processors compute several at the same time. */
#ifndef KSL_COLD
#ifdef __GNUC__
#define KSL_COLD __attribute__((noinline, cold, unused))
#define KSL_INLINE inline __attribute__((unused))
#define KSL_LIKELY(test) __builtin_expect(test, 1)
#else
#define KSL_COLD
#define KSL_INLINE inline
#define KSL_LIKELY(test) (test)
#endif
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define KSL_INLINED inline __attribute__((always_inline, unused))
#else
#define KSL_INLINED KSL_INLINE
#endif
#endif

#ifndef KSL_PRODUCT_ERRORF
#define KSL_PRODUCT_ERRORF
#if !KSL_HAS_FMAF
/* The upper half of x, rounded to 12 bits; what is left has 12 bits as well. */
static KSL_INLINE float ksl_upper_halff(const float x) {
  uint32_t bits;
  float half;
  memcpy(&bits, &x, sizeof bits);
  bits = (bits + 0x800u) & 0xfffff000u;
  memcpy(&half, &bits, sizeof half);
  return half;
}

/* p - a b, p the rounded product, by halves, whose products are exact: fused into sums or not, they
   give the same bits.  *high is the product of the upper ones.  Source: Dekker. */
static KSL_INLINE float ksl_product_excessf(
    const float a, const float b, const float p, float *high) {
  const float a_high = ksl_upper_halff(a), a_low = a - a_high;
  const float b_high = ksl_upper_halff(b), b_low = b - b_high;
  const float cross1 = a_high * b_low, cross2 = a_low * b_high, low = a_low * b_low;
  *high = a_high * b_high;
  const float c = p - *high, d = c - cross1, e = d - cross2;
  return e - low;
}

/* Whether halves and their products neither overflow nor underflow: 2^-100 <= |high| <= 2^100. */
static KSL_INLINE int ksl_halvedf(const float high) {
  const uint32_t least = (uint32_t)27 << 24, most = (uint32_t)227 << 24;
  uint32_t bits, above;
  memcpy(&bits, &high, sizeof bits);
  above = (bits << 1) - least;
  return above <= most - least;
}

/* a b - c rounded once, where they do: the C standard requires it of fmaf. */
static KSL_COLD float ksl_fusedf(const float a, const float b, const float c) {
  const float zero = a * b; /* if a or b is */
  return a == 0.0f || b == 0.0f ? zero - c : fmaf(a, b, -c);
}
#endif

/* a b - p in single precision, rounded once, p the rounded product: by fmaf where that is an
   instruction, else by halves.  Both give the same bits. */
static KSL_INLINE float ksl_product_errorf(const float a, const float b, const float p) {
#if KSL_HAS_FMAF
  return fmaf(a, b, -p);
#else
  float high;
  const float excess = ksl_product_excessf(a, b, p, &high);
  return KSL_LIKELY(ksl_halvedf(high)) ? 0.0f - excess : ksl_fusedf(a, b, p);
#endif
}
#endif

#ifndef KSL_PRODUCT_RESTF
#define KSL_PRODUCT_RESTF
/* a b - h in single precision, rounded once, where p is a b rounded and p - h is exact. */
static KSL_INLINE float ksl_product_restf(
    const float a, const float b, const float p, const float h) {
#if KSL_HAS_FMAF
  (void)p;
  return fmaf(a, b, -h);
#else
  float high;
  const float excess = ksl_product_excessf(a, b, p, &high); /* never -0: so -0 stays -0 */
  const float rest = p - h;
  return KSL_LIKELY(ksl_halvedf(high)) ? rest - excess : ksl_fusedf(a, b, h);
#endif
}
#endif

#endif
