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
#include <fenv.h>

/* (3,3),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_rotated_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    ksl_mat6x6_t Mo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_mat6x6_double(&M, p1 + i * step[1], core + 2);
    ksl_mat6x6_rotated_certified(&R, &M, &Mo, &Mo_bound);
    store_mat6x6_double(&Mo, p2 + i * step[2], core + 4);
    store_mat6x6_double(&Mo_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat6x6_rotated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 288, 288, 288, 24, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_rotated_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 288, 288, 24, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_rotated_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_rotated_double_over(data, n[0], step, step + 4);
}

/* (3,3),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_rotated_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    ksl_mat6x6f_t Mo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_mat6x6_single(&M, p1 + i * step[1], core + 2);
    ksl_mat6x6f_rotated_certified(&R, &M, &Mo, &Mo_bound);
    store_mat6x6_single(&Mo, p2 + i * step[2], core + 4);
    store_mat6x6_single(&Mo_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat6x6_rotated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 144, 144, 144, 12, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_rotated_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 144, 144, 12, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_rotated_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_rotated_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat6x6_rotated_loops[] = {
    mat6x6_rotated_double, mat6x6_rotated_single};

/* (3),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_shifted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    ksl_mat6x6_t Mo_bound;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_mat6x6_double(&M, p1 + i * step[1], core + 1);
    ksl_mat6x6_shifted_certified(&t, &M, &Mo, &Mo_bound);
    store_mat6x6_double(&Mo, p2 + i * step[2], core + 3);
    store_mat6x6_double(&Mo_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat6x6_shifted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 288, 288, 288, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_shifted_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 288, 288, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_shifted_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_shifted_double_over(data, n[0], step, step + 4);
}

/* (3),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_shifted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    ksl_mat6x6f_t Mo_bound;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_mat6x6_single(&M, p1 + i * step[1], core + 1);
    ksl_mat6x6f_shifted_certified(&t, &M, &Mo, &Mo_bound);
    store_mat6x6_single(&Mo, p2 + i * step[2], core + 3);
    store_mat6x6_single(&Mo_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat6x6_shifted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 144, 144, 144, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_shifted_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 144, 144, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_shifted_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_shifted_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat6x6_shifted_loops[] = {
    mat6x6_shifted_double, mat6x6_shifted_single};

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
