/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,3)->() */
INLINED void mat3x3_determinant_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double det;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3_determinant_accurate(&R);
    store_scalar_double(&det, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_determinant_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_determinant_double_over(data, n[0], step, step + 2);
}

/* (3,3)->() */
INLINED void mat3x3_determinant_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float det;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3f_determinant_accurate(&R);
    store_scalar_single(&det, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_determinant_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_determinant_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_determinant_loops[] = {
    mat3x3_determinant_double, mat3x3_determinant_single};

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"mat3x3_determinant", "(3,3)->()",
    "det R.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; det: number.\n"
    "12 mul, 26 add, 9 product rest.  Error <= u |result| + 28 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, mat3x3_determinant_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
