/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat6x6 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/mat6x6_certified.h"
#include <fenv.h>

/* (3,3),(6,6)->(6,6),(6,6) */
OVER(mat6x6_rotated_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    ksl_mat6x6_t Mo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(mat6x6_double, &M, 1, 2);
    ksl_mat6x6_rotated_certified(&R, &M, &Mo, &Mo_bound);
    STORE(mat6x6_double, &Mo, 2, 4);
    STORE(mat6x6_double, &Mo_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat6x6_rotated_double)
LOOP(mat6x6_rotated_double, 4, DENSE_OR_ONE, 72, 288, 288, 288, 24, 8, 48, 8, 48, 8, 48, 8)

OVER(mat6x6_rotated_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    ksl_mat6x6f_t Mo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(mat6x6_single, &M, 1, 2);
    ksl_mat6x6f_rotated_certified(&R, &M, &Mo, &Mo_bound);
    STORE(mat6x6_single, &Mo, 2, 4);
    STORE(mat6x6_single, &Mo_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat6x6_rotated_single)
LOOP(mat6x6_rotated_single, 4, DENSE_OR_ONE, 36, 144, 144, 144, 12, 4, 24, 4, 24, 4, 24, 4)
LOOPS(mat6x6_rotated)

/* (3),(6,6)->(6,6),(6,6) */
OVER(mat6x6_shifted_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    ksl_mat6x6_t Mo_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(mat6x6_double, &M, 1, 1);
    ksl_mat6x6_shifted_certified(&t, &M, &Mo, &Mo_bound);
    STORE(mat6x6_double, &Mo, 2, 3);
    STORE(mat6x6_double, &Mo_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat6x6_shifted_double)
LOOP(mat6x6_shifted_double, 4, DENSE_OR_ONE, 24, 288, 288, 288, 8, 48, 8, 48, 8, 48, 8)

OVER(mat6x6_shifted_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    ksl_mat6x6f_t Mo_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(mat6x6_single, &M, 1, 1);
    ksl_mat6x6f_shifted_certified(&t, &M, &Mo, &Mo_bound);
    STORE(mat6x6_single, &Mo, 2, 3);
    STORE(mat6x6_single, &Mo_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat6x6_shifted_single)
LOOP(mat6x6_shifted_single, 4, DENSE_OR_ONE, 12, 144, 144, 144, 4, 24, 4, 24, 4, 24, 4)
LOOPS(mat6x6_shifted)

const coscrew_gufunc TABLE(mat6x6)[] = {
  {"mat6x6_rotated", "(3,3),(6,6)->(6,6),(6,6)",
    "Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its\n"
    "lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6,6)->(6,6),(6,6).  R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.\n"
    "228 mul, 240 add, 90 abs.\n",
   2, 2, "R.", mat6x6_rotated_loops},
  {"mat6x6_shifted", "(3),(6,6)->(6,6),(6,6)",
    "Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its\n"
    "lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.\n"
    "\n"
    "(3),(6,6)->(6,6),(6,6).  t: vector; M, Mo, Mo_bound: 6×6 operator.\n"
    "66 mul, 99 add, 45 abs.\n",
   2, 2, "", mat6x6_shifted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
