/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the trig operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* ()->(2) */
INLINED void dc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double theta;
  load_scalar_double(&theta, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dc[2];
    if (step[0] != 0) {
      load_scalar_double(&theta, p0 + i * step[0], core + 0);
    }
    ksl_dc_accurate(theta, dc);
    store_dc_double(dc, p1 + i * step[1], core + 0);
  }
}

static void dc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dc_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dc_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  dc_double_over(data, n[0], step, step + 2);
}

/* ()->(2) */
INLINED void dc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float theta;
  load_scalar_single(&theta, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dc[2];
    if (step[0] != 0) {
      load_scalar_single(&theta, p0 + i * step[0], core + 0);
    }
    ksl_dcf_accurate(theta, dc);
    store_dc_single(dc, p1 + i * step[1], core + 0);
  }
}

static void dc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 8, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dc_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dc_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  dc_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction dc_loops[] = {
    dc_double, dc_single};

const coscrew_gufunc TABLE(trig)[] = {
  {"dc", "()->(2)",
    "dc = (sin θ, cos θ), θ in rad.\n"
    "\n"
    "()->(2).  theta: number; dc: (sin θ, cos θ).\n"
    "83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
