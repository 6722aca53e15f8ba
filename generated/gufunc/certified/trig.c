/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the trig operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* ()->(2),(2) */
INLINED void dc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double theta;
  load_scalar_double(&theta, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dc[2];
    double dc_bound[2];
    if (step[0] != 0) {
      load_scalar_double(&theta, p0 + i * step[0], core + 0);
    }
    ksl_dc_certified(theta, dc, dc_bound);
    store_dc_double(dc, p1 + i * step[1], core + 0);
    store_dc_double(dc_bound, p2 + i * step[2], core + 1);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dc_double_over(data, n[0], step, step + 3);
}

/* ()->(2),(2) */
INLINED void dc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float theta;
  load_scalar_single(&theta, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dc[2];
    float dc_bound[2];
    if (step[0] != 0) {
      load_scalar_single(&theta, p0 + i * step[0], core + 0);
    }
    ksl_dcf_certified(theta, dc, dc_bound);
    store_dc_single(dc, p1 + i * step[1], core + 0);
    store_dc_single(dc_bound, p2 + i * step[2], core + 1);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 8, 8, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction dc_loops[] = {
    dc_double, dc_single};

const coscrew_gufunc TABLE(trig)[] = {
  {"dc", "()->(2),(2)",
    "dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.\n"
    "\n"
    "()->(2),(2).  theta: number; dc, dc_bound: (sin θ, cos θ).\n"
    "83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.\n",
   1, 2, "", dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
