/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t self;
    ksl_mat3x3_t self_bound;
    load_mat3x3_double(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3_orthonormalize_certified(&self, &self_bound);
    store_mat3x3_double(&self, p1 + i * step[1], core + 2);
    store_mat3x3_double(&self_bound, p2 + i * step[2], core + 4);
  }
}

static void mat3x3_orthonormalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  mat3x3_orthonormalize_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t self;
    ksl_mat3x3f_t self_bound;
    load_mat3x3_single(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3f_orthonormalize_certified(&self, &self_bound);
    store_mat3x3_single(&self, p1 + i * step[1], core + 2);
    store_mat3x3_single(&self_bound, p2 + i * step[2], core + 4);
  }
}

static void mat3x3_orthonormalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  mat3x3_orthonormalize_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_orthonormalize_loops[] = {
    mat3x3_orthonormalize_double, mat3x3_orthonormalize_single};

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_orthonormalized_certified(&R, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 2);
    store_mat3x3_double(&Ro_bound, p2 + i * step[2], core + 4);
  }
}

static void mat3x3_orthonormalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_orthonormalized_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_orthonormalized_certified(&R, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 2);
    store_mat3x3_single(&Ro_bound, p2 + i * step[2], core + 4);
  }
}

static void mat3x3_orthonormalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_orthonormalized_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_orthonormalized_loops[] = {
    mat3x3_orthonormalized_double, mat3x3_orthonormalized_single};

const coscrew_gufunc TABLE(exponential)[] = {
  {"mat3x3_orthonormalize", "(3,3)->(3,3),(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  self, self_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3),(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, mat3x3_orthonormalized_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
