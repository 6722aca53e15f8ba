/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat6x6 operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,4),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_transformed_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D;
  load_SE3_double(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    ksl_mat6x6_t Mo;
    ksl_mat6x6_t Mo_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_mat6x6_double(&M, p1 + i * step[1], core + 2);
    ksl_mat6x6_transformed_certified(&D, &M, &Mo, &Mo_bound);
    store_mat6x6_double(&Mo, p2 + i * step[2], core + 4);
    store_mat6x6_double(&Mo_bound, p3 + i * step[3], core + 6);
  }
}

static void mat6x6_transformed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 288, 288, 288, 32, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_transformed_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 288, 288, 32, 8, 48, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_transformed_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_transformed_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6,6)->(6,6),(6,6) */
INLINED void mat6x6_transformed_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D;
  load_SE3_single(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t Mo;
    ksl_mat6x6f_t Mo_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_mat6x6_single(&M, p1 + i * step[1], core + 2);
    ksl_mat6x6f_transformed_certified(&D, &M, &Mo, &Mo_bound);
    store_mat6x6_single(&Mo, p2 + i * step[2], core + 4);
    store_mat6x6_single(&Mo_bound, p3 + i * step[3], core + 6);
  }
}

static void mat6x6_transformed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 144, 144, 144, 16, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat6x6_transformed_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 144, 144, 16, 4, 24, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat6x6_transformed_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat6x6_transformed_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat6x6_transformed_loops[] = {
    mat6x6_transformed_double, mat6x6_transformed_single};

const coscrew_gufunc TABLE(mat6x6)[] = {
  {"mat6x6_transformed", "(3,4),(6,6)->(6,6),(6,6)",
    "Mo = [Ad]*(D) M [Ad]^-1(D), M symmetric, of which the lower triangle is read: an articulated\n"
    "inertia in the frame D takes its own to; |error of Mo| <= Mo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6,6)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, Mo, Mo_bound: 6×6\n"
    "operator.\n"
    "306 mul, 332 add, 93 abs.\n",
   2, 2, mat6x6_transformed_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
