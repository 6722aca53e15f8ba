/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Detects at run time a build that breaks the promised bits. */
#ifndef KSL_SELFCHECK_H
#define KSL_SELFCHECK_H

#include "ksl_types.h"

/* NULL if every operation on double is rounded once in the file that includes this; else what is
   wrong.  Looks for contraction, reassociation, reciprocals in place of quotients, lost signs of zero
   and lost NaN, approximate functions, flush-to-zero, excess precision, and an fma (which the
   accurate tier calls) that rounds twice. */
static inline const char *ksl_selfcheck(void) {
  const volatile double given[] = {0.0, 0.5, 1.0, 2.0, 1.0000000074505806, 1.0000000149011612,
      2.2250738585072014e-308, 1.7976931348623157e+308, 1.110223057712381e-16, 1.4142135623730951,
      49.0, 134217729.0, 2.417851693272454e+24};
  const double zero = given[0], half = given[1], one = given[2], two = given[3], x = given[4],
      nearly_square = given[5], smallest = given[6], largest = given[7], above_half_ulp = given[8],
      root = given[9], n = given[10], m = given[11], rounded_twice = given[12];
  const double square = KSL_MUL(x, x), low = square - nearly_square;
  const double sum = one + smallest, difference = sum - one;
  const double first = n / n, twice = n + n, second = twice / n, third = twice + twice;
  const double fourth = third / n, positive = -zero + 0.0, nan = zero / zero;
  const double smaller = KSL_MUL(smallest, half), normal = KSL_MUL(smaller, two);
  const double infinity = largest + largest, back = KSL_MUL(infinity, half);
  const double next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -fassociative-math, -ffast-math";
  }
  if (first != 1 || second != 2 || fourth != 4) {
    return "reciprocals: quotients are products; compile without -freciprocal-math, -ffast-math";
  }
  if (memcmp(&positive, &zero, sizeof zero) != 0) {
    return "signed zeros: -0 + 0 is -0; compile without -fno-signed-zeros, -ffast-math";
  }
  if (nan == nan || infinity != (double)INFINITY) {
    return "finite math: NaN or infinity is not what it is; compile without -ffinite-math-only, "
           "-fno-honor-nans, -fno-honor-infinities, -ffast-math";
  }
  if (pow(m, 3.0) == rounded_twice || sqrt(two) != root) {
    return "approximate functions: compile without -fapprox-func, -ffast-math";
  }
  if (smaller == 0 || normal != smallest) {
    return "flush-to-zero: subnormal numbers become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  if (fma(x, x, -nearly_square) == 0) {
    return "fma: the C library's rounds twice, and the accurate tier calls it";
  }
  return NULL;
}

/* NULL if every operation on float is rounded once in the file that includes this; else what is
   wrong.  Looks for contraction, reassociation, reciprocals in place of quotients, lost signs of zero
   and lost NaN, approximate functions, flush-to-zero, excess precision, and an fma (which the
   accurate tier calls) that rounds twice. */
static inline const char *ksl_selfcheckf(void) {
  const volatile float given[] = {0.0f, 0.5f, 1.0f, 2.0f, 1.0002441f, 1.0004883f, 1.1754944e-38f,
      3.4028235e+38f, 5.963375e-08f, 1.4142135f, 41.0f, 4109.0f, 6.937586e+10f};
  const float zero = given[0], half = given[1], one = given[2], two = given[3], x = given[4],
      nearly_square = given[5], smallest = given[6], largest = given[7], above_half_ulp = given[8],
      root = given[9], n = given[10], m = given[11], rounded_twice = given[12];
  const float square = KSL_MULF(x, x), low = square - nearly_square;
  const float sum = one + smallest, difference = sum - one;
  const float first = n / n, twice = n + n, second = twice / n, third = twice + twice;
  const float fourth = third / n, positive = -zero + 0.0f, nan = zero / zero;
  const float smaller = KSL_MULF(smallest, half), normal = KSL_MULF(smaller, two);
  const float infinity = largest + largest, back = KSL_MULF(infinity, half);
  const float next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -fassociative-math, -ffast-math";
  }
  if (first != 1 || second != 2 || fourth != 4) {
    return "reciprocals: quotients are products; compile without -freciprocal-math, -ffast-math";
  }
  if (memcmp(&positive, &zero, sizeof zero) != 0) {
    return "signed zeros: -0 + 0 is -0; compile without -fno-signed-zeros, -ffast-math";
  }
  if (nan == nan || infinity != (float)INFINITY) {
    return "finite math: NaN or infinity is not what it is; compile without -ffinite-math-only, "
           "-fno-honor-nans, -fno-honor-infinities, -ffast-math";
  }
  if (powf(m, 3.0f) == rounded_twice || sqrtf(two) != root) {
    return "approximate functions: compile without -fapprox-func, -ffast-math";
  }
  if (smaller == 0 || normal != smallest) {
    return "flush-to-zero: subnormal numbers become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  if (fmaf(x, x, -nearly_square) == 0) {
    return "fma: the C library's rounds twice, and the accurate tier calls it";
  }
  return NULL;
}

#endif
