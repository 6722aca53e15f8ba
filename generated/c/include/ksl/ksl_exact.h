/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exact rounding errors in double precision, for compensated kernels.

   Exact where a product does not overflow and is zero or at least 2^-968 = 4.1e-292; the error of a
   smaller product is rounded to a multiple of the least subnormal number. */
#ifndef KSL_EXACT_H
#define KSL_EXACT_H

#include "ksl_types.h"

#if !KSL_HAS_FMA
/* Whether the halves of 26 bits, their products and their sums neither overflow nor underflow. */
static inline int ksl_splits(const double a, const double b, const double p) {
  const double least = 4.008336720017946e-292; /* 2^-968 */
  const double most = 6.696928794914171e+299;  /* 2^996 */
  const double size = fabs(p);
  return (size >= least || a == 0.0 || b == 0.0) && size <= most && fabs(a) <= most
         && fabs(b) <= most;
}
#endif

/* a b - p rounded once, p the rounded product: by fma where that is an instruction, else by halves
   (Veltkamp, Dekker), or where these overflow or underflow by the C library's fma, which the C
   standard requires to round once.  All give the same bits. */
static inline double ksl_product_error(const double a, const double b, const double p) {
#if KSL_HAS_FMA
  return fma(a, b, -p);
#else
  if (!ksl_splits(a, b, p)) { return fma(a, b, -p); }
  const double splitter = 134217729.0; /* 2^27 + 1 */
  const double c = KSL_MUL(splitter, a), d = c - a, a_high = c - d, a_low = a - a_high;
  const double e = KSL_MUL(splitter, b), f = e - b, b_high = e - f, b_low = b - b_high;
  const double high = KSL_MUL(a_high, b_high), cross1 = KSL_MUL(a_high, b_low);
  const double cross2 = KSL_MUL(a_low, b_high), low = KSL_MUL(a_low, b_low);
  const double g = high - p, h = g + cross1, i = h + cross2;
  return i + low;
#endif
}

/* The same in single precision, where a b is exact in double. */
static inline float ksl_product_errorf(const float a, const float b, const float p) {
#if KSL_HAS_FMAF
  return fmaf(a, b, -p);
#else
  const double product = (double)a * (double)b;
  return (float)(product - (double)p);
#endif
}

/* a b + c rounded once, where a b is exact; the same bits with fma and without. */
static inline double ksl_product_sum(const double a, const double b, const double c) {
#if KSL_HAS_FMA
  return fma(a, b, c);
#else
  const double product = KSL_MUL(a, b);
  return product + c;
#endif
}

/* a b - h rounded once, where p is a b rounded and p - h is exact. */
static inline double ksl_product_rest(
    const double a, const double b, const double p, const double h) {
#if KSL_HAS_FMA
  (void)p;
  return fma(a, b, -h);
#else
  if (!ksl_splits(a, b, p)) { return fma(a, b, -h); }
  const double rest = p - h, error = ksl_product_error(a, b, p);
  return error == 0.0 ? rest : rest + error; /* -0 stays -0 */
#endif
}

#endif
