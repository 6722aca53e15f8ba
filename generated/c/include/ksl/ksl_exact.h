/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Exact rounding errors in double precision, for compensated kernels.

   Exact while nothing over- or underflows: products of numbers below 2^996 in magnitude whose own
   magnitude is above 2^-969.  Needs every operation rounded to double on its own: compile with
   -ffp-contract=off, and not for the x87. */
#ifndef KSL_EXACT_H
#define KSL_EXACT_H

#include "ksl_types.h"

#if defined(__FAST_MATH__)
#error "-ffast-math undoes compensated arithmetic"
#endif

#if defined(KSL_HAS_FMA)
/* as whoever includes this says */
#elif defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(FP_FAST_FMA)
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
