/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat6x6 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/mat6x6.h"

/* (6,6)->(6,6) */
OVER(mat6x6_copy_double) {
  POINTERS_2
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    LOAD(mat6x6_double, &M, 0, 0);
    ksl_mat6x6_copy(&M, &Mo);
    STORE(mat6x6_double, &Mo, 1, 2);
  }
}
STRIDED(mat6x6_copy_double)
LOOP(mat6x6_copy_double, 2, DENSE, 288, 288, 48, 8, 48, 8)

OVER(mat6x6_copy_single) {
  POINTERS_2
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD(mat6x6_single, &M, 0, 0);
    ksl_mat6x6f_copy(&M, &Mo);
    STORE(mat6x6_single, &Mo, 1, 2);
  }
}
STRIDED(mat6x6_copy_single)
LOOP(mat6x6_copy_single, 2, DENSE, 144, 144, 24, 4, 24, 4)
LOOPS(mat6x6_copy)

/* (6,6)->(6,6) */
OVER(mat6x6_setIdentity_double) {
  POINTERS_2
  EACH {
    ksl_mat6x6_t self;
    LOAD(mat6x6_double, &self, 0, 0);
    ksl_mat6x6_setIdentity(&self);
    STORE(mat6x6_double, &self, 1, 2);
  }
}
STRIDED(mat6x6_setIdentity_double)
LOOP(mat6x6_setIdentity_double, 2, DENSE, 288, 288, 48, 8, 48, 8)

OVER(mat6x6_setIdentity_single) {
  POINTERS_2
  EACH {
    ksl_mat6x6f_t self;
    LOAD(mat6x6_single, &self, 0, 0);
    ksl_mat6x6f_setIdentity(&self);
    STORE(mat6x6_single, &self, 1, 2);
  }
}
STRIDED(mat6x6_setIdentity_single)
LOOP(mat6x6_setIdentity_single, 2, DENSE, 144, 144, 24, 4, 24, 4)
LOOPS(mat6x6_setIdentity)

/* (6,6)->(6,6) */
OVER(mat6x6_transposed_double) {
  POINTERS_2
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    LOAD(mat6x6_double, &M, 0, 0);
    ksl_mat6x6_transposed(&M, &Mo);
    STORE(mat6x6_double, &Mo, 1, 2);
  }
}
STRIDED(mat6x6_transposed_double)
LOOP(mat6x6_transposed_double, 2, DENSE, 288, 288, 48, 8, 48, 8)

OVER(mat6x6_transposed_single) {
  POINTERS_2
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD(mat6x6_single, &M, 0, 0);
    ksl_mat6x6f_transposed(&M, &Mo);
    STORE(mat6x6_single, &Mo, 1, 2);
  }
}
STRIDED(mat6x6_transposed_single)
LOOP(mat6x6_transposed_single, 2, DENSE, 144, 144, 24, 4, 24, 4)
LOOPS(mat6x6_transposed)

/* (3,3),(6,6)->(6,6) */
OVER(mat6x6_rotated_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(mat6x6_double, &M, 1, 2);
    ksl_mat6x6_rotated(&R, &M, &Mo);
    STORE(mat6x6_double, &Mo, 2, 4);
  }
}
STRIDED(mat6x6_rotated_double)
LOOP(mat6x6_rotated_double, 3, DENSE_OR_ONE, 72, 288, 288, 24, 8, 48, 8, 48, 8)

OVER(mat6x6_rotated_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(mat6x6_single, &M, 1, 2);
    ksl_mat6x6f_rotated(&R, &M, &Mo);
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
    ksl_mat6x6_shifted(&t, &M, &Mo);
    STORE(mat6x6_double, &Mo, 2, 3);
  }
}
STRIDED(mat6x6_shifted_double)
LOOP(mat6x6_shifted_double, 3, DENSE_OR_ONE, 24, 288, 288, 8, 48, 8, 48, 8)

OVER(mat6x6_shifted_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    LOAD_OTHER(vec3_single, &t);
    LOAD(mat6x6_single, &M, 1, 1);
    ksl_mat6x6f_shifted(&t, &M, &Mo);
    STORE(mat6x6_single, &Mo, 2, 3);
  }
}
STRIDED(mat6x6_shifted_single)
LOOP(mat6x6_shifted_single, 3, DENSE_OR_ONE, 12, 144, 144, 4, 24, 4, 24, 4)
LOOPS(mat6x6_shifted)

const coscrew_gufunc TABLE(mat6x6)[] = {
  {"mat6x6_copy", "(6,6)->(6,6)",
    "Mo = M.\n"
    "\n"
    "(6,6)->(6,6).  M, Mo: 6×6 operator.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat6x6_copy_loops},
  {"mat6x6_setIdentity", "(6,6)->(6,6)",
    "self = I.\n"
    "\n"
    "(6,6)->(6,6).  self: 6×6 operator.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat6x6_setIdentity_loops},
  {"mat6x6_transposed", "(6,6)->(6,6)",
    "Mo = M^T.\n"
    "\n"
    "(6,6)->(6,6).  M, Mo: 6×6 operator.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat6x6_transposed_loops},
  {"mat6x6_rotated", "(3,3),(6,6)->(6,6)",
    "Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its\n"
    "lower triangle is read.\n"
    "\n"
    "(3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.\n"
    "144 mul, 96 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", mat6x6_rotated_loops},
  {"mat6x6_shifted", "(3),(6,6)->(6,6)",
    "Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its\n"
    "lower triangle is read.\n"
    "\n"
    "(3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.\n"
    "39 mul, 42 add.  Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", mat6x6_shifted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
