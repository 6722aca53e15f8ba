/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/SE3_accurate.h"

/* (3,4)->(3,4) */
OVER(SE3_invert_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t self;
    LOAD(SE3_double, &self, 0, 0);
    ksl_SE3_invert_accurate(&self);
    STORE(SE3_double, &self, 1, 2);
  }
}
STRIDED_WITH_FMA(SE3_invert_double)
LOOP(SE3_invert_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_invert_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t self;
    LOAD(SE3_single, &self, 0, 0);
    ksl_SE3f_invert_accurate(&self);
    STORE(SE3_single, &self, 1, 2);
  }
}
STRIDED(SE3_invert_single)
LOOP(SE3_invert_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_invert)

/* (3,4)->(3,4) */
OVER(SE3_inverted_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_SE3_t Do;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_inverted_accurate(&D, &Do);
    STORE(SE3_double, &Do, 1, 2);
  }
}
STRIDED_WITH_FMA(SE3_inverted_double)
LOOP(SE3_inverted_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_inverted_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_SE3f_t Do;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_inverted_accurate(&D, &Do);
    STORE(SE3_single, &Do, 1, 2);
  }
}
STRIDED(SE3_inverted_single)
LOOP(SE3_inverted_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_inverted)

const coscrew_gufunc TABLE(SE3)[] = {
  {"SE3_invert", "(3,4)->(3,4)",
    "self = self^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_invert_loops},
  {"SE3_inverted", "(3,4)->(3,4)",
    "Do = D^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_inverted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
