/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the trig operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/trig_accurate.h"

/* ()->(2) */
OVER(dc_double) {
  POINTERS_2
  EACH {
    double theta;
    double dc[2];
    LOAD(scalar_double, &theta, 0, 0);
    ksl_dc_accurate(theta, dc);
    STORE(dc_double, dc, 1, 0);
  }
}
STRIDED_WITH_FMA(dc_double)
LOOP(dc_double, 2, ANY, 8, 16, 8)

OVER(dc_single) {
  POINTERS_2
  EACH {
    float theta;
    float dc[2];
    LOAD(scalar_single, &theta, 0, 0);
    ksl_dcf_accurate(theta, dc);
    STORE(dc_single, dc, 1, 0);
  }
}
STRIDED(dc_single)
LOOP(dc_single, 2, DENSE, 4, 8, 4)
LOOPS(dc)

const coscrew_gufunc TABLE(trig)[] = {
  {"dc", "()->(2)",
    "dc = (sin θ, cos θ), θ in rad.\n"
    "\n"
    "()->(2).  theta: number; dc: (sin θ, cos θ).\n"
    "83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
