/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,4)->(3,4) */
INLINED void SE3_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t self;
    load_SE3_double(&self, p0 + i * step[0], core + 0);
    ksl_SE3_invert_accurate(&self);
    store_SE3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_invert_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t self;
    load_SE3_single(&self, p0 + i * step[0], core + 0);
    ksl_SE3f_invert_accurate(&self);
    store_SE3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_invert_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_invert_loops[] = {
    SE3_invert_double, SE3_invert_single};

/* (3,4)->(3,4) */
INLINED void SE3_inverted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D;
  load_SE3_double(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t Do;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_inverted_accurate(&D, &Do);
    store_SE3_double(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_inverted_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_inverted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D;
  load_SE3_single(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t Do;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_inverted_accurate(&D, &Do);
    store_SE3_single(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_inverted_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_inverted_loops[] = {
    SE3_inverted_double, SE3_inverted_single};

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
