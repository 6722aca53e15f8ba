/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the coscrew operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (6)->(6) */
INLINED void coscrew_copy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t ci;
  load_coscrew_double(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrew_copy(&ci, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_copy_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_copy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t ci;
  load_coscrew_single(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrewf_copy(&ci, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_copy_loops[] = {
    coscrew_copy_double, coscrew_copy_single};

/* (6),()->(6) */
INLINED void coscrew_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t self;
    double a;
    load_coscrew_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_coscrew_scale(&self, a);
    store_coscrew_double(&self, p2 + i * step[2], core + 1);
  }
}

static void coscrew_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  coscrew_scale_double_over(data, n[0], step, step + 3);
}

/* (6),()->(6) */
INLINED void coscrew_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t self;
    float a;
    load_coscrew_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_coscrewf_scale(&self, a);
    store_coscrew_single(&self, p2 + i * step[2], core + 1);
  }
}

static void coscrew_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 4, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  coscrew_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction coscrew_scale_loops[] = {
    coscrew_scale_double, coscrew_scale_single};

/* (6)->(6) */
INLINED void coscrew_inverted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t ci;
  load_coscrew_double(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrew_inverted(&ci, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_inverted_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_inverted_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_inverted_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_inverted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t ci;
  load_coscrew_single(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrewf_inverted(&ci, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_inverted_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_inverted_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_inverted_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_inverted_loops[] = {
    coscrew_inverted_double, coscrew_inverted_single};

/* (6)->(6) */
INLINED void coscrew_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t self;
    load_coscrew_double(&self, p0 + i * step[0], core + 0);
    ksl_coscrew_invert(&self);
    store_coscrew_double(&self, p1 + i * step[1], core + 1);
  }
}

static void coscrew_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_invert_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  coscrew_invert_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t self;
    load_coscrew_single(&self, p0 + i * step[0], core + 0);
    ksl_coscrewf_invert(&self);
    store_coscrew_single(&self, p1 + i * step[1], core + 1);
  }
}

static void coscrew_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_invert_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  coscrew_invert_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_invert_loops[] = {
    coscrew_invert_double, coscrew_invert_single};

/* (),(6),(6)->(6) */
INLINED void axpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double a;
  load_scalar_double(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t x;
    ksl_coscrew_t y;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&x, p1 + i * step[1], core + 0);
    load_coscrew_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_cc(a, &x, &y);
    store_coscrew_double(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_cc_double_over(data, n[0], step, step + 4);
}

/* (),(6),(6)->(6) */
INLINED void axpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float a;
  load_scalar_single(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t x;
    ksl_coscrewf_t y;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&x, p1 + i * step[1], core + 0);
    load_coscrew_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_ccf(a, &x, &y);
    store_coscrew_single(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_cc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction axpy_cc_loops[] = {
    axpy_cc_double, axpy_cc_single};

/* (6),(6)->(6) */
INLINED void xpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t x;
  load_coscrew_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t y;
    if (step[0] != 0) {
      load_coscrew_double(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&y, p1 + i * step[1], core + 1);
    ksl_xpy_cc(&x, &y);
    store_coscrew_double(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_cc_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void xpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t x;
  load_coscrew_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t y;
    if (step[0] != 0) {
      load_coscrew_single(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&y, p1 + i * step[1], core + 1);
    ksl_xpy_ccf(&x, &y);
    store_coscrew_single(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_cc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction xpy_cc_loops[] = {
    xpy_cc_double, xpy_cc_single};

/* (6),(6)->(6) */
INLINED void nxpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t x;
  load_coscrew_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t y;
    if (step[0] != 0) {
      load_coscrew_double(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_cc(&x, &y);
    store_coscrew_double(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_cc_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void nxpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t x;
  load_coscrew_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t y;
    if (step[0] != 0) {
      load_coscrew_single(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_ccf(&x, &y);
    store_coscrew_single(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_cc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction nxpy_cc_loops[] = {
    nxpy_cc_double, nxpy_cc_single};

/* (),(6)->(6) */
INLINED void product_ac_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double a;
  load_scalar_double(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 0);
    ksl_product_ac(a, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 1);
  }
}

static void product_ac_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ac_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ac_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_ac_double_over(data, n[0], step, step + 3);
}

/* (),(6)->(6) */
INLINED void product_ac_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float a;
  load_scalar_single(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 0);
    ksl_product_acf(a, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 1);
  }
}

static void product_ac_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ac_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ac_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_ac_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_ac_loops[] = {
    product_ac_double, product_ac_single};

/* (6),(6)->(6) */
INLINED void add_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_add_cc(&c1, &c2, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void add_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_cc_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void add_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_add_ccf(&c1, &c2, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void add_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_cc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_cc_loops[] = {
    add_cc_double, add_cc_single};

/* (6),(6)->(6) */
INLINED void subtract_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_subtract_cc(&c1, &c2, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void subtract_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_cc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_cc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_cc_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void subtract_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_subtract_ccf(&c1, &c2, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void subtract_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_cc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_cc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_cc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction subtract_cc_loops[] = {
    subtract_cc_double, subtract_cc_single};

/* (6)->() */
INLINED void coscrew_norm_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t ci;
  load_coscrew_double(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double norm;
    if (step[0] != 0) {
      load_coscrew_double(&ci, p0 + i * step[0], core + 0);
    }
    norm = ksl_coscrew_norm(&ci);
    store_scalar_double(&norm, p1 + i * step[1], core + 1);
  }
}

static void coscrew_norm_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_norm_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_norm_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_norm_double_over(data, n[0], step, step + 2);
}

/* (6)->() */
INLINED void coscrew_norm_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t ci;
  load_coscrew_single(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float norm;
    if (step[0] != 0) {
      load_coscrew_single(&ci, p0 + i * step[0], core + 0);
    }
    norm = ksl_coscrewf_norm(&ci);
    store_scalar_single(&norm, p1 + i * step[1], core + 1);
  }
}

static void coscrew_norm_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_norm_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_norm_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_norm_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_norm_loops[] = {
    coscrew_norm_double, coscrew_norm_single};

/* (6)->(6) */
INLINED void coscrew_normalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t self;
    load_coscrew_double(&self, p0 + i * step[0], core + 0);
    ksl_coscrew_normalize(&self);
    store_coscrew_double(&self, p1 + i * step[1], core + 1);
  }
}

static void coscrew_normalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_normalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  coscrew_normalize_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_normalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t self;
    load_coscrew_single(&self, p0 + i * step[0], core + 0);
    ksl_coscrewf_normalize(&self);
    store_coscrew_single(&self, p1 + i * step[1], core + 1);
  }
}

static void coscrew_normalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_normalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  coscrew_normalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_normalize_loops[] = {
    coscrew_normalize_double, coscrew_normalize_single};

/* (6)->(6) */
INLINED void coscrew_normalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t ci;
  load_coscrew_double(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrew_normalized(&ci, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_normalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_normalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_normalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_normalized_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_normalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t ci;
  load_coscrew_single(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrewf_normalized(&ci, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_normalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_normalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_normalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_normalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_normalized_loops[] = {
    coscrew_normalized_double, coscrew_normalized_single};

/* (3),(3)->(6) */
INLINED void coscrew_from_lin_ang_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t lin;
  load_vec3_double(&lin, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t ang;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_vec3_double(&lin, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&ang, p1 + i * step[1], core + 1);
    ksl_coscrew_from_lin_ang(&lin, &ang, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void coscrew_from_lin_ang_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_from_lin_ang_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_from_lin_ang_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  coscrew_from_lin_ang_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(6) */
INLINED void coscrew_from_lin_ang_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t lin;
  load_vec3_single(&lin, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t ang;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_vec3_single(&lin, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&ang, p1 + i * step[1], core + 1);
    ksl_coscrewf_from_lin_ang(&lin, &ang, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void coscrew_from_lin_ang_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_from_lin_ang_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_from_lin_ang_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  coscrew_from_lin_ang_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction coscrew_from_lin_ang_loops[] = {
    coscrew_from_lin_ang_double, coscrew_from_lin_ang_single};

/* (6)->(6) */
INLINED void coscrew_to_angular_first_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t ci;
  load_coscrew_double(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double x[6];
    if (step[0] != 0) {
      load_coscrew_double(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrew_to_angular_first(&ci, x);
    store_angular_first_double(x, p1 + i * step[1], core + 1);
  }
}

static void coscrew_to_angular_first_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_to_angular_first_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_to_angular_first_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_to_angular_first_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_to_angular_first_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t ci;
  load_coscrew_single(&ci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float x[6];
    if (step[0] != 0) {
      load_coscrew_single(&ci, p0 + i * step[0], core + 0);
    }
    ksl_coscrewf_to_angular_first(&ci, x);
    store_angular_first_single(x, p1 + i * step[1], core + 1);
  }
}

static void coscrew_to_angular_first_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_to_angular_first_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_to_angular_first_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_to_angular_first_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_to_angular_first_loops[] = {
    coscrew_to_angular_first_double, coscrew_to_angular_first_single};

/* (6)->(6) */
INLINED void coscrew_from_angular_first_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double x[6];
  load_angular_first_double(x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_angular_first_double(x, p0 + i * step[0], core + 0);
    }
    ksl_coscrew_from_angular_first(x, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_from_angular_first_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_from_angular_first_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_from_angular_first_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_from_angular_first_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void coscrew_from_angular_first_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float x[6];
  load_angular_first_single(x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_angular_first_single(x, p0 + i * step[0], core + 0);
    }
    ksl_coscrewf_from_angular_first(x, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 1);
  }
}

static void coscrew_from_angular_first_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_from_angular_first_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coscrew_from_angular_first_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coscrew_from_angular_first_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coscrew_from_angular_first_loops[] = {
    coscrew_from_angular_first_double, coscrew_from_angular_first_single};

/* (6),(6)->(6) */
INLINED void add_cct_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_add_cct(&c1, &c2, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void add_cct_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cct_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cct_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_cct_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void add_cct_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_add_cctf(&c1, &c2, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void add_cct_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cct_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cct_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_cct_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_cct_loops[] = {
    add_cct_double, add_cct_single};

/* (3),(6)->(6) */
INLINED void product_CoAdtc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtc(&t, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtc_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_CoAdtc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcf(&t, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdtc_loops[] = {
    product_CoAdtc_double, product_CoAdtc_single};

/* (3),(6)->(6) */
INLINED void product_CoAdtinvc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtinvc(&t, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtinvc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtinvc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtinvc_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_CoAdtinvc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtinvcf(&t, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtinvc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtinvc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtinvc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdtinvc_loops[] = {
    product_CoAdtinvc_double, product_CoAdtinvc_single};

/* (3),(6)->(6) */
INLINED void product_CoAdtcinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcinv(&t, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtcinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtcinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtcinv_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_CoAdtcinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcinvf(&t, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void product_CoAdtcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtcinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtcinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdtcinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdtcinv_loops[] = {
    product_CoAdtcinv_double, product_CoAdtcinv_single};

/* (3,3),(6)->(6) */
INLINED void product_CoAdrc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrc(&R, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrc_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_CoAdrc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcf(&R, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdrc_loops[] = {
    product_CoAdrc_double, product_CoAdrc_single};

/* (3,3),(6)->(6) */
INLINED void product_CoAdrinvc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrinvc(&R, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrinvc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrinvc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrinvc_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_CoAdrinvc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrinvcf(&R, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrinvc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrinvc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrinvc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdrinvc_loops[] = {
    product_CoAdrinvc_double, product_CoAdrinvc_single};

/* (3,3),(6)->(6) */
INLINED void product_CoAdrcinv_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcinv(&R, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrcinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrcinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrcinv_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_CoAdrcinv_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcinvf(&R, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdrcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrcinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrcinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdrcinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdrcinv_loops[] = {
    product_CoAdrcinv_double, product_CoAdrcinv_single};

/* (3,4),(6)->(6) */
INLINED void product_CoAdc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdc(&D, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdc_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_CoAdc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcf(&D, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdc_loops[] = {
    product_CoAdc_double, product_CoAdc_single};

/* (3,4),(6)->(6) */
INLINED void product_CoAdinvc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdinvc(&D, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdinvc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdinvc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdinvc_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_CoAdinvc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdinvcf(&D, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdinvc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdinvc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdinvc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdinvc_loops[] = {
    product_CoAdinvc_double, product_CoAdinvc_single};

/* (3,4),(6)->(6) */
INLINED void product_CoAdcinv_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcinv(&D, &ci, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdcinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdcinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdcinv_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_CoAdcinv_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcinvf(&D, &ci, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void product_CoAdcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdcinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdcinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_CoAdcinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_CoAdcinv_loops[] = {
    product_CoAdcinv_double, product_CoAdcinv_single};

/* (3,4)->(6) */
INLINED void hctx_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctx(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctx_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctx_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctx_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hctx_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctx_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctx_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctx_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hctx_loops[] = {
    hctx_double, hctx_single};

/* (3,4)->(6) */
INLINED void hcty_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcty(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcty_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcty_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcty_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcty_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcty_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcty_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcty_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcty_loops[] = {
    hcty_double, hcty_single};

/* (3,4)->(6) */
INLINED void hctz_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctz(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctz_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctz_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctz_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hctz_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctz_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctz_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctz_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hctz_loops[] = {
    hctz_double, hctz_single};

/* (3,4)->(6) */
INLINED void hcrx_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrx(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrx_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrx_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrx_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcrx_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrxf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrx_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrx_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrx_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcrx_loops[] = {
    hcrx_double, hcrx_single};

/* (3,4)->(6) */
INLINED void hcry_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcry(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcry_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcry_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcry_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcry_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcryf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcry_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcry_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcry_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcry_loops[] = {
    hcry_double, hcry_single};

/* (3,4)->(6) */
INLINED void hcrz_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrz(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrz_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrz_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrz_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcrz_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrzf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrz_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrz_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrz_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcrz_loops[] = {
    hcrz_double, hcrz_single};

/* (3,4)->(6) */
INLINED void hctxinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hctxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctxinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctxinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctxinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hctxinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hctxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctxinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctxinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctxinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hctxinv_loops[] = {
    hctxinv_double, hctxinv_single};

/* (3,4)->(6) */
INLINED void hctyinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hctyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctyinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctyinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctyinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hctyinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hctyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctyinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctyinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctyinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hctyinv_loops[] = {
    hctyinv_double, hctyinv_single};

/* (3,4)->(6) */
INLINED void hctzinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hctzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctzinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctzinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctzinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hctzinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hctzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctzinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctzinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hctzinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hctzinv_loops[] = {
    hctzinv_double, hctzinv_single};

/* (3,4)->(6) */
INLINED void hcrxinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrxinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrxinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrxinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrxinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcrxinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrxinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrxinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrxinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrxinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcrxinv_loops[] = {
    hcrxinv_double, hcrxinv_single};

/* (3,4)->(6) */
INLINED void hcryinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcryinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcryinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcryinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcryinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcryinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcryinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcryinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcryinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcryinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcryinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcryinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcryinv_loops[] = {
    hcryinv_double, hcryinv_single};

/* (3,4)->(6) */
INLINED void hcrzinv_double_over(
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
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrzinv(&D, &co);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrzinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrzinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrzinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hcrzinv_single_over(
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
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcrzinvf(&D, &co);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
  }
}

static void hcrzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcrzinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcrzinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hcrzinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hcrzinv_loops[] = {
    hcrzinv_double, hcrzinv_single};

/* (3,4)->(6,6) */
INLINED void CoAd_double_over(
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
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_CoAd(&D, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 2);
  }
}

static void CoAd_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 288, 32, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    CoAd_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 32, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    CoAd_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  CoAd_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6,6) */
INLINED void CoAd_single_over(
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
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_CoAdf(&D, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 2);
  }
}

static void CoAd_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 144, 16, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    CoAd_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 16, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    CoAd_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  CoAd_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction CoAd_loops[] = {
    CoAd_double, CoAd_single};

/* (6),(6)->() */
INLINED void reciprocal_product_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c;
  load_coscrew_double(&c, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double x[6];
    double power;
    if (step[0] != 0) {
      load_coscrew_double(&c, p0 + i * step[0], core + 0);
    }
    load_angular_first_double(x, p1 + i * step[1], core + 1);
    power = ksl_reciprocal_product(&c, x);
    store_scalar_double(&power, p2 + i * step[2], core + 2);
  }
}

static void reciprocal_product_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    reciprocal_product_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    reciprocal_product_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  reciprocal_product_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->() */
INLINED void reciprocal_product_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c;
  load_coscrew_single(&c, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float x[6];
    float power;
    if (step[0] != 0) {
      load_coscrew_single(&c, p0 + i * step[0], core + 0);
    }
    load_angular_first_single(x, p1 + i * step[1], core + 1);
    power = ksl_reciprocal_productf(&c, x);
    store_scalar_single(&power, p2 + i * step[2], core + 2);
  }
}

static void reciprocal_product_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    reciprocal_product_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    reciprocal_product_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  reciprocal_product_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction reciprocal_product_loops[] = {
    reciprocal_product_double, reciprocal_product_single};

/* (6),(6)->(6) */
INLINED void cross_sc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 1);
    ksl_cross_sc(&s, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void cross_sc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sc_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sc_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sc_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void cross_sc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 1);
    ksl_cross_scf(&s, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void cross_sc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sc_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sc_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sc_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_sc_loops[] = {
    cross_sc_double, cross_sc_single};

/* (6),(6)->(6) */
INLINED void cross_sca_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 1);
    ksl_cross_sca(&s, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void cross_sca_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sca_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sca_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sca_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void cross_sca_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 1);
    ksl_cross_scaf(&s, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void cross_sca_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sca_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sca_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sca_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_sca_loops[] = {
    cross_sca_double, cross_sca_single};

/* (3,4),(6)->(6) */
INLINED void constraint_ctx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctx(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_ctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_ctx_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_ctx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctxf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_ctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_ctx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_ctx_loops[] = {
    constraint_ctx_double, constraint_ctx_single};

/* (3,4),(6)->(6) */
INLINED void constraint_cty_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cty(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_cty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cty_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cty_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_cty_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_cty_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctyf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_cty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cty_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cty_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_cty_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_cty_loops[] = {
    constraint_cty_double, constraint_cty_single};

/* (3,4),(6)->(6) */
INLINED void constraint_ctz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctz(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_ctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_ctz_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_ctz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctzf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_ctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_ctz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_ctz_loops[] = {
    constraint_ctz_double, constraint_ctz_single};

/* (3,4),(6)->(6) */
INLINED void constraint_crx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crx(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_crx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_crx_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_crx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crxf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_crx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_crx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_crx_loops[] = {
    constraint_crx_double, constraint_crx_single};

/* (3,4),(6)->(6) */
INLINED void constraint_cry_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cry(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_cry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cry_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cry_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_cry_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_cry_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cryf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_cry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cry_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cry_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_cry_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_cry_loops[] = {
    constraint_cry_double, constraint_cry_single};

/* (3,4),(6)->(6) */
INLINED void constraint_crz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crz(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_crz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_crz_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void constraint_crz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crzf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void constraint_crz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  constraint_crz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction constraint_crz_loops[] = {
    constraint_crz_double, constraint_crz_single};

/* (3,4),(6)->(6) */
INLINED void working_ctx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_ctx(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_ctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_ctx_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_ctx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctxf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_ctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_ctx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_ctx_loops[] = {
    working_ctx_double, working_ctx_single};

/* (3,4),(6)->(6) */
INLINED void working_cty_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_cty(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_cty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cty_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cty_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_cty_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_cty_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctyf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_cty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cty_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cty_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_cty_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_cty_loops[] = {
    working_cty_double, working_cty_single};

/* (3,4),(6)->(6) */
INLINED void working_ctz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_ctz(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_ctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_ctz_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_ctz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctzf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_ctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_ctz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_ctz_loops[] = {
    working_ctz_double, working_ctz_single};

/* (3,4),(6)->(6) */
INLINED void working_crx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_crx(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_crx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_crx_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_crx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_crxf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_crx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_crx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_crx_loops[] = {
    working_crx_double, working_crx_single};

/* (3,4),(6)->(6) */
INLINED void working_cry_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_cry(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_cry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cry_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cry_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_cry_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_cry_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_cryf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_cry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cry_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cry_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_cry_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_cry_loops[] = {
    working_cry_double, working_cry_single};

/* (3,4),(6)->(6) */
INLINED void working_crz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_crz(&D, &c, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
  }
}

static void working_crz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_crz_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void working_crz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_crzf(&D, &c, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
  }
}

static void working_crz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  working_crz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction working_crz_loops[] = {
    working_crz_double, working_crz_single};

/* (6)->(6,6) */
INLINED void coad_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_coad(&s, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 1);
  }
}

static void coad_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 288, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coad_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coad_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coad_double_over(data, n[0], step, step + 2);
}

/* (6)->(6,6) */
INLINED void coad_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_coadf(&s, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 1);
  }
}

static void coad_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 144, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coad_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    coad_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  coad_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction coad_loops[] = {
    coad_double, coad_single};

const coscrew_gufunc TABLE(coscrew)[] = {
  {"coscrew_copy", "(6)->(6)",
    "co = ci.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_copy_loops},
  {"coscrew_scale", "(6),()->(6)",
    "self = a self.\n"
    "\n"
    "(6),()->(6).  self: coscrew (f in N; τ in N m); a: number.\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", coscrew_scale_loops},
  {"coscrew_inverted", "(6)->(6)",
    "co = -ci.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "6 neg.  Exact.\n",
   1, 1, "", coscrew_inverted_loops},
  {"coscrew_invert", "(6)->(6)",
    "self = -self.\n"
    "\n"
    "(6)->(6).  self: coscrew (f in N; τ in N m).\n"
    "6 neg.  Exact.\n",
   1, 1, "", coscrew_invert_loops},
  {"axpy_cc", "(),(6),(6)->(6)",
    "y = a x + y.\n"
    "\n"
    "(),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_cc_loops},
  {"xpy_cc", "(6),(6)->(6)",
    "y = x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_cc_loops},
  {"nxpy_cc", "(6),(6)->(6)",
    "y = -x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_cc_loops},
  {"product_ac", "(),(6)->(6)",
    "co = a ci.\n"
    "\n"
    "(),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_ac_loops},
  {"add_cc", "(6),(6)->(6)",
    "co = c1 + c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cc_loops},
  {"subtract_cc", "(6),(6)->(6)",
    "co = c1 - c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_cc_loops},
  {"coscrew_norm", "(6)->()",
    "|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).\n"
    "\n"
    "(6)->().  ci: coscrew (f in N; τ in N m); norm: number.\n"
    "7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.\n",
   1, 1, "", coscrew_norm_loops},
  {"coscrew_normalize", "(6)->(6)",
    "self = self / |self|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  self: coscrew (f in N; τ in N m).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", coscrew_normalize_loops},
  {"coscrew_normalized", "(6)->(6)",
    "co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", coscrew_normalized_loops},
  {"coscrew_from_lin_ang", "(3),(3)->(6)",
    "co = (lin; ang).\n"
    "\n"
    "(3),(3)->(6).  lin, ang: vector; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   2, 1, "", coscrew_from_lin_ang_loops},
  {"coscrew_to_angular_first", "(6)->(6)",
    "x = (ang; lin) of ci.\n"
    "\n"
    "(6)->(6).  ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_to_angular_first_loops},
  {"coscrew_from_angular_first", "(6)->(6)",
    "co = (lin; ang) of x = (ang; lin).\n"
    "\n"
    "(6)->(6).  x: six components with the angular part on top; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_from_angular_first_loops},
  {"add_cct", "(6),(6)->(6)",
    "co = (c1.lin + c2.lin ; c1.ang).\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cct_loops},
  {"product_CoAdtc", "(3),(6)->(6)",
    "co = [Ad]*(t) ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtc_loops},
  {"product_CoAdtinvc", "(3),(6)->(6)",
    "co = [Ad]*(t)^-1 ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtinvc_loops},
  {"product_CoAdtcinv", "(3),(6)->(6)",
    "co = [Ad]*(t) (-ci).\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtcinv_loops},
  {"product_CoAdrc", "(3,3),(6)->(6)",
    "co = [Ad]*(R) ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrc_loops},
  {"product_CoAdrinvc", "(3,3),(6)->(6)",
    "co = [Ad]*(R)^-1 ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrinvc_loops},
  {"product_CoAdrcinv", "(3,3),(6)->(6)",
    "co = [Ad]*(R) (-ci).\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrcinv_loops},
  {"product_CoAdc", "(3,4),(6)->(6)",
    "co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdc_loops},
  {"product_CoAdinvc", "(3,4),(6)->(6)",
    "co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdinvc_loops},
  {"product_CoAdcinv", "(3,4),(6)->(6)",
    "co = [Ad]*(D) (-ci).\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdcinv_loops},
  {"hctx", "(3,4)->(6)",
    "co = h_tx: column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctx_loops},
  {"hcty", "(3,4)->(6)",
    "co = h_ty: column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hcty_loops},
  {"hctz", "(3,4)->(6)",
    "co = h_tz: column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctz_loops},
  {"hcrx", "(3,4)->(6)",
    "co = h_rx: column 3 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcrx_loops},
  {"hcry", "(3,4)->(6)",
    "co = h_ry: column 4 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcry_loops},
  {"hcrz", "(3,4)->(6)",
    "co = h_rz: column 5 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcrz_loops},
  {"hctxinv", "(3,4)->(6)",
    "co = -h_tx: -column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctxinv_loops},
  {"hctyinv", "(3,4)->(6)",
    "co = -h_ty: -column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctyinv_loops},
  {"hctzinv", "(3,4)->(6)",
    "co = -h_tz: -column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctzinv_loops},
  {"hcrxinv", "(3,4)->(6)",
    "co = -h_rx: -column 3 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcrxinv_loops},
  {"hcryinv", "(3,4)->(6)",
    "co = -h_ry: -column 4 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcryinv_loops},
  {"hcrzinv", "(3,4)->(6)",
    "co = -h_rz: -column 5 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcrzinv_loops},
  {"CoAd", "(3,4)->(6,6)",
    "M = [Ad]*(D).\n"
    "\n"
    "(3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.\n"
    "18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   1, 1, "R", CoAd_loops},
  {"reciprocal_product", "(6),(6)->()",
    "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).\n"
    "\n"
    "(6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;\n"
    "power: number.\n"
    "6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", reciprocal_product_loops},
  {"cross_sc", "(6),(6)->(6)",
    "co = [ad]*(s) c = (ω×f ; v×f + ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sc_loops},
  {"cross_sca", "(6),(6)->(6)",
    "co = (0 ; ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sca_loops},
  {"constraint_ctx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctx_loops},
  {"constraint_cty", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cty_loops},
  {"constraint_ctz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctz_loops},
  {"constraint_crx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crx_loops},
  {"constraint_cry", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cry_loops},
  {"constraint_crz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crz_loops},
  {"working_ctx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctx_loops},
  {"working_cty", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_cty_loops},
  {"working_ctz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctz_loops},
  {"working_crx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crx_loops},
  {"working_cry", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_cry_loops},
  {"working_crz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crz_loops},
  {"coad", "(6)->(6,6)",
    "M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "6 neg.  Exact.\n",
   1, 1, "", coad_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
