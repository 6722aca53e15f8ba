/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the trig operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/trig_certified.h"
#include <fenv.h>

/* ()->(2),(2) */
OVER(dc_double) {
  POINTERS_3
  EACH {
    double theta;
    double dc[2];
    double dc_bound[2];
    LOAD(scalar_double, &theta, 0, 0);
    ksl_dc_certified(theta, dc, dc_bound);
    STORE(dc_double, dc, 1, 0);
    STORE(dc_double, dc_bound, 2, 1);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(dc_double)
LOOP(dc_double, 3, ANY, 8, 16, 16, 8, 8)

OVER(dc_single) {
  POINTERS_3
  EACH {
    float theta;
    float dc[2];
    float dc_bound[2];
    LOAD(scalar_single, &theta, 0, 0);
    ksl_dcf_certified(theta, dc, dc_bound);
    STORE(dc_single, dc, 1, 0);
    STORE(dc_single, dc_bound, 2, 1);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(dc_single)
LOOP(dc_single, 3, DENSE, 4, 8, 8, 4, 4)
LOOPS(dc)

const coscrew_gufunc TABLE(trig)[] = {
  {"dc", "()->(2),(2)",
    "dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.\n"
    "\n"
    "()->(2),(2).  theta: number; dc, dc_bound: (sin θ, cos θ).\n"
    "83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.\n",
   1, 2, "", dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
