/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/SE3_certified.h"
#include <fenv.h>

/* (3,4)->(3,4),(3,4) */
OVER(SE3_invert_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t self;
    ksl_SE3_t self_bound;
    LOAD(SE3_double, &self, 0, 0);
    ksl_SE3_invert_certified(&self, &self_bound);
    STORE(SE3_double, &self, 1, 2);
    STORE(SE3_double, &self_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(SE3_invert_double)
LOOP(SE3_invert_double, 3, DENSE, 96, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(SE3_invert_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t self;
    ksl_SE3f_t self_bound;
    LOAD(SE3_single, &self, 0, 0);
    ksl_SE3f_invert_certified(&self, &self_bound);
    STORE(SE3_single, &self, 1, 2);
    STORE(SE3_single, &self_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(SE3_invert_single)
LOOP(SE3_invert_single, 3, DENSE, 48, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(SE3_invert)

/* (3,4)->(3,4),(3,4) */
OVER(SE3_inverted_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_inverted_certified(&D, &Do, &Do_bound);
    STORE(SE3_double, &Do, 1, 2);
    STORE(SE3_double, &Do_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(SE3_inverted_double)
LOOP(SE3_inverted_double, 3, DENSE, 96, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(SE3_inverted_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_inverted_certified(&D, &Do, &Do_bound);
    STORE(SE3_single, &Do, 1, 2);
    STORE(SE3_single, &Do_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(SE3_inverted_single)
LOOP(SE3_inverted_single, 3, DENSE, 48, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(SE3_inverted)

const coscrew_gufunc TABLE(SE3)[] = {
  {"SE3_invert", "(3,4)->(3,4),(3,4)",
    "self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(3,4),(3,4).  self, self_bound: displacement [R | t], R rotation, t in m.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   1, 2, "R", SE3_invert_loops},
  {"SE3_inverted", "(3,4)->(3,4),(3,4)",
    "Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   1, 2, "R", SE3_inverted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
