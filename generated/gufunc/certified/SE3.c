/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (3,4)->(3,4),(3,4) */
INLINED void SE3_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t self;
    ksl_SE3_t self_bound;
    load_SE3_double(&self, p0 + i * step[0], core + 0);
    ksl_SE3_invert_certified(&self, &self_bound);
    store_SE3_double(&self, p1 + i * step[1], core + 2);
    store_SE3_double(&self_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  SE3_invert_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(3,4),(3,4) */
INLINED void SE3_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t self;
    ksl_SE3f_t self_bound;
    load_SE3_single(&self, p0 + i * step[0], core + 0);
    ksl_SE3f_invert_certified(&self, &self_bound);
    store_SE3_single(&self, p1 + i * step[1], core + 2);
    store_SE3_single(&self_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  SE3_invert_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SE3_invert_loops[] = {
    SE3_invert_double, SE3_invert_single};

/* (3,4)->(3,4),(3,4) */
INLINED void SE3_inverted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D;
  load_SE3_double(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_inverted_certified(&D, &Do, &Do_bound);
    store_SE3_double(&Do, p1 + i * step[1], core + 2);
    store_SE3_double(&Do_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_inverted_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(3,4),(3,4) */
INLINED void SE3_inverted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D;
  load_SE3_single(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_inverted_certified(&D, &Do, &Do_bound);
    store_SE3_single(&Do, p1 + i * step[1], core + 2);
    store_SE3_single(&Do_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_inverted_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SE3_inverted_loops[] = {
    SE3_inverted_double, SE3_inverted_single};

const coscrew_gufunc TABLE(SE3)[] = {
  {"SE3_invert", "(3,4)->(3,4),(3,4)",
    "self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(3,4),(3,4).  self, self_bound: displacement [R | t], R rotation, t in m.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   1, 2, "R", SE3_invert_loops},
  {"SE3_inverted", "(3,4)->(3,4),(3,4)",
    "Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   1, 2, "R", SE3_inverted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
