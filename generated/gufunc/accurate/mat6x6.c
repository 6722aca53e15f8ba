/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat6x6 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/mat6x6_accurate.h"

/* (3,3),(6,6)->(6,6) */
OVER(mat6x6_rotated_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(mat6x6_double, &M, 1, 2);
    ksl_mat6x6_rotated_accurate(&R, &M, &Mo);
    STORE(mat6x6_double, &Mo, 2, 4);
  }
}
STRIDED_WITH_FMA(mat6x6_rotated_double)
LOOP(mat6x6_rotated_double, 3, DENSE_OR_ONE, 72, 288, 288, 24, 8, 48, 8, 48, 8)

OVER(mat6x6_rotated_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(mat6x6_single, &M, 1, 2);
    ksl_mat6x6f_rotated_accurate(&R, &M, &Mo);
    STORE(mat6x6_single, &Mo, 2, 4);
  }
}
STRIDED(mat6x6_rotated_single)
LOOP(mat6x6_rotated_single, 3, DENSE_OR_ONE, 36, 144, 144, 12, 4, 24, 4, 24, 4)
LOOPS(mat6x6_rotated)

/* (3),(6,6)->(6,6) */
OVER(mat6x6_shifted_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    LOAD_OTHER(vec3_double, &t);
    LOAD(mat6x6_double, &M, 1, 1);
    ksl_mat6x6_shifted_accurate(&t, &M, &Mo);
    STORE(mat6x6_double, &Mo, 2, 3);
  }
}
STRIDED_WITH_FMA(mat6x6_shifted_double)
LOOP(mat6x6_shifted_double, 3, DENSE_OR_ONE, 24, 288, 288, 8, 48, 8, 48, 8)

OVER(mat6x6_shifted_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD_OTHER(vec3_single, &t);
    LOAD(mat6x6_single, &M, 1, 1);
    ksl_mat6x6f_shifted_accurate(&t, &M, &Mo);
    STORE(mat6x6_single, &Mo, 2, 3);
  }
}
STRIDED(mat6x6_shifted_single)
LOOP(mat6x6_shifted_single, 3, DENSE_OR_ONE, 12, 144, 144, 4, 24, 4, 24, 4)
LOOPS(mat6x6_shifted)

const coscrew_gufunc TABLE(mat6x6)[] = {
  {"mat6x6_rotated", "(3,3),(6,6)->(6,6)",
    "Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its\n"
    "lower triangle is read.\n"
    "\n"
    "(3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.\n"
    "207 mul, 564 add, 144 product rest.  Error <= u |result| + 37 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", mat6x6_rotated_loops},
  {"mat6x6_shifted", "(3),(6,6)->(6,6)",
    "Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its\n"
    "lower triangle is read.\n"
    "\n"
    "(3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.\n"
    "51 mul, 264 add, 42 product rest.  Error <= u |result| + 45 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", mat6x6_shifted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
