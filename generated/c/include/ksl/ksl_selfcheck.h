/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Detects a build that breaks the promised bits. */
#ifndef KSL_SELFCHECK_H
#define KSL_SELFCHECK_H

#include "ksl_types.h"

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
