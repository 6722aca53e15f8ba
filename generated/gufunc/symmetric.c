/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the symmetric operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/symmetric.h"

/* (3,3)->(),(3,3) */
OVER(mat3x3_ldl_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t A;
    double pivot;
    ksl_mat3x3_t L;
    LOAD(mat3x3_double, &A, 0, 0);
    pivot = ksl_mat3x3_ldl(&A, &L);
    STORE(scalar_double, &pivot, 1, 2);
    STORE(mat3x3_double, &L, 2, 2);
  }
}
STRIDED(mat3x3_ldl_double)
LOOP(mat3x3_ldl_double, 3, DENSE, 72, 8, 72, 24, 8, 24, 8)

OVER(mat3x3_ldl_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t A;
    float pivot;
    ksl_mat3x3f_t L;
    LOAD(mat3x3_single, &A, 0, 0);
    pivot = ksl_mat3x3f_ldl(&A, &L);
    STORE(scalar_single, &pivot, 1, 2);
    STORE(mat3x3_single, &L, 2, 2);
  }
}
STRIDED(mat3x3_ldl_single)
LOOP(mat3x3_ldl_single, 3, DENSE, 36, 4, 36, 12, 4, 12, 4)
LOOPS(mat3x3_ldl)

/* (3,3),(3)->(3) */
OVER(mat3x3_ldl_solve_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t L, &L);
  EACH {
    ksl_vec3_t b;
    ksl_vec3_t x;
    LOAD_OTHER(mat3x3_double, &L);
    LOAD(vec3_double, &b, 1, 2);
    ksl_mat3x3_ldl_solve(&L, &b, &x);
    STORE(vec3_double, &x, 2, 3);
  }
}
STRIDED(mat3x3_ldl_solve_double)
LOOP(mat3x3_ldl_solve_double, 3, DENSE_OR_ONE, 72, 24, 24, 24, 8, 8, 8)

OVER(mat3x3_ldl_solve_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t L, &L);
  EACH {
    ksl_vec3f_t b;
    ksl_vec3f_t x;
    LOAD_OTHER(mat3x3_single, &L);
    LOAD(vec3_single, &b, 1, 2);
    ksl_mat3x3f_ldl_solve(&L, &b, &x);
    STORE(vec3_single, &x, 2, 3);
  }
}
STRIDED(mat3x3_ldl_solve_single)
LOOP(mat3x3_ldl_solve_single, 3, DENSE_OR_ONE, 36, 12, 12, 12, 4, 4, 4)
LOOPS(mat3x3_ldl_solve)

/* (3,3),(3)->(),(3) */
OVER(mat3x3_solve_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t A, &A);
  EACH {
    ksl_vec3_t b;
    double pivot;
    ksl_vec3_t x;
    LOAD_OTHER(mat3x3_double, &A);
    LOAD(vec3_double, &b, 1, 2);
    pivot = ksl_mat3x3_solve(&A, &b, &x);
    STORE(scalar_double, &pivot, 2, 3);
    STORE(vec3_double, &x, 3, 3);
  }
}
STRIDED(mat3x3_solve_double)
LOOP(mat3x3_solve_double, 4, DENSE_OR_ONE, 72, 24, 8, 24, 24, 8, 8, 8)

OVER(mat3x3_solve_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t A, &A);
  EACH {
    ksl_vec3f_t b;
    float pivot;
    ksl_vec3f_t x;
    LOAD_OTHER(mat3x3_single, &A);
    LOAD(vec3_single, &b, 1, 2);
    pivot = ksl_mat3x3f_solve(&A, &b, &x);
    STORE(scalar_single, &pivot, 2, 3);
    STORE(vec3_single, &x, 3, 3);
  }
}
STRIDED(mat3x3_solve_single)
LOOP(mat3x3_solve_single, 4, DENSE_OR_ONE, 36, 12, 4, 12, 12, 4, 4, 4)
LOOPS(mat3x3_solve)

/* (6,6)->(),(6,6) */
OVER(mat6x6_ldl_double) {
  POINTERS_3
  EACH {
    ksl_mat6x6_t A;
    double pivot;
    ksl_mat6x6_t L;
    LOAD(mat6x6_double, &A, 0, 0);
    pivot = ksl_mat6x6_ldl(&A, &L);
    STORE(scalar_double, &pivot, 1, 2);
    STORE(mat6x6_double, &L, 2, 2);
  }
}
STRIDED(mat6x6_ldl_double)
LOOP(mat6x6_ldl_double, 3, DENSE, 288, 8, 288, 48, 8, 48, 8)

OVER(mat6x6_ldl_single) {
  POINTERS_3
  EACH {
    ksl_mat6x6f_t A;
    float pivot;
    ksl_mat6x6f_t L;
    LOAD(mat6x6_single, &A, 0, 0);
    pivot = ksl_mat6x6f_ldl(&A, &L);
    STORE(scalar_single, &pivot, 1, 2);
    STORE(mat6x6_single, &L, 2, 2);
  }
}
STRIDED(mat6x6_ldl_single)
LOOP(mat6x6_ldl_single, 3, DENSE, 144, 4, 144, 24, 4, 24, 4)
LOOPS(mat6x6_ldl)

/* (6,6),(6)->(6) */
OVER(mat6x6_ldl_solve_double) {
  POINTERS_3
  LOAD_FIRST(mat6x6_double, ksl_mat6x6_t L, &L);
  EACH {
    ksl_coscrew_t b;
    ksl_screw_t x;
    LOAD_OTHER(mat6x6_double, &L);
    LOAD(coscrew_double, &b, 1, 2);
    ksl_mat6x6_ldl_solve(&L, &b, &x);
    STORE(screw_double, &x, 2, 3);
  }
}
STRIDED(mat6x6_ldl_solve_double)
LOOP(mat6x6_ldl_solve_double, 3, DENSE_OR_ONE, 288, 48, 48, 48, 8, 8, 8)

OVER(mat6x6_ldl_solve_single) {
  POINTERS_3
  LOAD_FIRST(mat6x6_single, ksl_mat6x6f_t L, &L);
  EACH {
    ksl_coscrewf_t b;
    ksl_screwf_t x;
    LOAD_OTHER(mat6x6_single, &L);
    LOAD(coscrew_single, &b, 1, 2);
    ksl_mat6x6f_ldl_solve(&L, &b, &x);
    STORE(screw_single, &x, 2, 3);
  }
}
STRIDED(mat6x6_ldl_solve_single)
LOOP(mat6x6_ldl_solve_single, 3, DENSE_OR_ONE, 144, 24, 24, 24, 4, 4, 4)
LOOPS(mat6x6_ldl_solve)

/* (6,6),(6)->(),(6) */
OVER(mat6x6_solve_double) {
  POINTERS_4
  LOAD_FIRST(mat6x6_double, ksl_mat6x6_t A, &A);
  EACH {
    ksl_coscrew_t b;
    double pivot;
    ksl_screw_t x;
    LOAD_OTHER(mat6x6_double, &A);
    LOAD(coscrew_double, &b, 1, 2);
    pivot = ksl_mat6x6_solve(&A, &b, &x);
    STORE(scalar_double, &pivot, 2, 3);
    STORE(screw_double, &x, 3, 3);
  }
}
STRIDED(mat6x6_solve_double)
LOOP(mat6x6_solve_double, 4, DENSE_OR_ONE, 288, 48, 8, 48, 48, 8, 8, 8)

OVER(mat6x6_solve_single) {
  POINTERS_4
  LOAD_FIRST(mat6x6_single, ksl_mat6x6f_t A, &A);
  EACH {
    ksl_coscrewf_t b;
    float pivot;
    ksl_screwf_t x;
    LOAD_OTHER(mat6x6_single, &A);
    LOAD(coscrew_single, &b, 1, 2);
    pivot = ksl_mat6x6f_solve(&A, &b, &x);
    STORE(scalar_single, &pivot, 2, 3);
    STORE(screw_single, &x, 3, 3);
  }
}
STRIDED(mat6x6_solve_single)
LOOP(mat6x6_solve_single, 4, DENSE_OR_ONE, 144, 24, 4, 24, 24, 4, 4, 4)
LOOPS(mat6x6_solve)

const coscrew_gufunc TABLE(symmetric)[] = {
  {"mat3x3_ldl", "(3,3)->(),(3,3)",
    "L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower\n"
    "triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is\n"
    "not positive definite, and L is meaningless.\n"
    "\n"
    "(3,3)->(),(3,3).  A, L: rotation or other 3×3 matrix; pivot: number.\n"
    "4 mul, 4 add, 6 div, 6 less, 9 select.  |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the\n"
    "pivot is positive, barring over- and underflow.\n",
   1, 2, "", mat3x3_ldl_loops},
  {"mat3x3_ldl_solve", "(3,3),(3)->(3)",
    "x = A^-1 b, L of mat3x3_ldl with a positive pivot.\n"
    "\n"
    "(3,3),(3)->(3).  L: rotation or other 3×3 matrix; b, x: vector.\n"
    "6 mul, 6 add, 3 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj)\n"
    "|x_j|; measured, not proved; barring over- and underflow.\n",
   2, 1, "", mat3x3_ldl_solve_loops},
  {"mat3x3_solve", "(3,3),(3)->(),(3)",
    "x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.\n"
    "Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to\n"
    "rounding or indefinite (A - 50 u diag A is not positive definite).\n"
    "\n"
    "(3,3),(3)->(),(3).  A: rotation or other 3×3 matrix; b, x: vector; pivot: number.\n"
    "32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.  Backward error, of A: |b - A x|_i <= 4\n"
    "u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.\n",
   2, 2, "", mat3x3_solve_loops},
  {"mat6x6_ldl", "(6,6)->(),(6,6)",
    "L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower\n"
    "triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is\n"
    "not positive definite, and L is meaningless.\n"
    "\n"
    "(6,6)->(),(6,6).  A, L: 6×6 operator; pivot: number.\n"
    "35 mul, 35 add, 21 div, 15 less, 21 select.  |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where\n"
    "the pivot is positive, barring over- and underflow.\n",
   1, 2, "", mat6x6_ldl_loops},
  {"mat6x6_ldl_solve", "(6,6),(6)->(6)",
    "x = A^-1 b, L of mat6x6_ldl with a positive pivot.\n"
    "\n"
    "(6,6),(6)->(6).  L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "30 mul, 30 add, 6 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii\n"
    "a_jj) |x_j|; measured, not proved; barring over- and underflow.\n",
   2, 1, "", mat6x6_ldl_solve_loops},
  {"mat6x6_solve", "(6,6),(6)->(),(6)",
    "x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.\n"
    "Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to\n"
    "rounding or indefinite (A - 50 u diag A is not positive definite).\n"
    "\n"
    "(6,6),(6)->(),(6).  A: 6×6 operator; b: coscrew (f in N; τ in N m); pivot: number; x: screw\n"
    "(v in m/s; ω in rad/s).\n"
    "172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.  Backward error, of A: |b - A x|_i <=\n"
    "4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.\n",
   2, 2, "", mat6x6_solve_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
