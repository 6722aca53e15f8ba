/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exact rounding errors in double precision, for compensated kernels.

   Exact where a product does not overflow and is zero or at least 2^-968 = 4.1e-292; the error of a
   smaller product is rounded to a multiple of the least subnormal number. */
#ifndef KSL_EXACT_H
#define KSL_EXACT_H

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

#ifndef KSL_PRODUCT_ERROR
#define KSL_PRODUCT_ERROR
#if !KSL_HAS_FMA
/* The upper half of x, rounded to 26 bits; what is left has 26 bits as well. */
static KSL_INLINE double ksl_upper_half(const double x) {
  uint64_t bits;
  double half;
  memcpy(&bits, &x, sizeof bits);
  bits = (bits + 0x4000000u) & 0xfffffffff8000000u;
  memcpy(&half, &bits, sizeof half);
  return half;
}

/* p - a b, p the rounded product, by halves, whose products are exact: fused into sums or not, they
   give the same bits.  *high is the product of the upper ones.  Source: Dekker. */
static KSL_INLINE double ksl_product_excess(
    const double a, const double b, const double p, double *high) {
  const double a_high = ksl_upper_half(a), a_low = a - a_high;
  const double b_high = ksl_upper_half(b), b_low = b - b_high;
  const double cross1 = a_high * b_low, cross2 = a_low * b_high, low = a_low * b_low;
  *high = a_high * b_high;
  const double c = p - *high, d = c - cross1, e = d - cross2;
  return e - low;
}

/* Whether halves and their products neither overflow nor underflow: 2^-967 <= |high| <= 2^996. */
static KSL_INLINE int ksl_halved(const double high) {
  const uint64_t least = (uint64_t)56 << 53, most = (uint64_t)2019 << 53;
  uint64_t bits, above;
  memcpy(&bits, &high, sizeof bits);
  above = (bits << 1) - least;
  return above <= most - least;
}

/* a b - c rounded once, where they do: the C standard requires it of fma. */
static KSL_COLD double ksl_fused(const double a, const double b, const double c) {
  const double zero = a * b; /* if a or b is */
  return a == 0.0 || b == 0.0 ? zero - c : fma(a, b, -c);
}
#endif

/* a b - p rounded once, p the rounded product: by fma where that is an instruction, else by halves.
   Both give the same bits. */
static KSL_INLINE double ksl_product_error(const double a, const double b, const double p) {
#if KSL_HAS_FMA
  return fma(a, b, -p);
#else
  double high;
  const double excess = ksl_product_excess(a, b, p, &high);
  return KSL_LIKELY(ksl_halved(high)) ? 0.0 - excess : ksl_fused(a, b, p);
#endif
}
#endif

/* a b + c rounded once, where a b is exact; the same bits with fma and without. */
static inline double ksl_product_sum(const double a, const double b, const double c) {
#if KSL_HAS_FMA
  return fma(a, b, c);
#else
  const double product = KSL_MUL(a, b);
  return product + c;
#endif
}

#ifndef KSL_PRODUCT_REST
#define KSL_PRODUCT_REST
/* a b - h rounded once, where p is a b rounded and p - h is exact. */
static KSL_INLINE double ksl_product_rest(
    const double a, const double b, const double p, const double h) {
#if KSL_HAS_FMA
  (void)p;
  return fma(a, b, -h);
#else
  double high;
  const double excess = ksl_product_excess(a, b, p, &high); /* never -0: so -0 stays -0 */
  const double rest = p - h;
  return KSL_LIKELY(ksl_halved(high)) ? rest - excess : ksl_fused(a, b, h);
#endif
}
#endif

#endif
