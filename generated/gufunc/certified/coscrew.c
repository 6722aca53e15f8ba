/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the coscrew operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (6),()->(6),(6) */
INLINED void coscrew_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t self;
    double a;
    ksl_coscrew_t self_bound;
    load_coscrew_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_coscrew_scale_certified(&self, a, &self_bound);
    store_coscrew_double(&self, p2 + i * step[2], core + 1);
    store_coscrew_double(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void coscrew_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_scale_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  coscrew_scale_double_over(data, n[0], step, step + 4);
}

/* (6),()->(6),(6) */
INLINED void coscrew_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t self;
    float a;
    ksl_coscrewf_t self_bound;
    load_coscrew_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_coscrewf_scale_certified(&self, a, &self_bound);
    store_coscrew_single(&self, p2 + i * step[2], core + 1);
    store_coscrew_single(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void coscrew_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 4, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    coscrew_scale_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  coscrew_scale_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction coscrew_scale_loops[] = {
    coscrew_scale_double, coscrew_scale_single};

/* (),(6),(6)->(6),(6) */
INLINED void axpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  double a;
  load_scalar_double(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t x;
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&x, p1 + i * step[1], core + 0);
    load_coscrew_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_cc_certified(a, &x, &y, &y_bound);
    store_coscrew_double(&y, p3 + i * step[3], core + 2);
    store_coscrew_double(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_cc_double_over(data, n[0], step, step + 5);
}

/* (),(6),(6)->(6),(6) */
INLINED void axpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  float a;
  load_scalar_single(&a, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t x;
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&x, p1 + i * step[1], core + 0);
    load_coscrew_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_ccf_certified(a, &x, &y, &y_bound);
    store_coscrew_single(&y, p3 + i * step[3], core + 2);
    store_coscrew_single(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_cc_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction axpy_cc_loops[] = {
    axpy_cc_double, axpy_cc_single};

/* (6),(6)->(6),(6) */
INLINED void xpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t x;
  load_coscrew_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    if (step[0] != 0) {
      load_coscrew_double(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&y, p1 + i * step[1], core + 1);
    ksl_xpy_cc_certified(&x, &y, &y_bound);
    store_coscrew_double(&y, p2 + i * step[2], core + 2);
    store_coscrew_double(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void xpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  xpy_cc_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void xpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t x;
  load_coscrew_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    if (step[0] != 0) {
      load_coscrew_single(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&y, p1 + i * step[1], core + 1);
    ksl_xpy_ccf_certified(&x, &y, &y_bound);
    store_coscrew_single(&y, p2 + i * step[2], core + 2);
    store_coscrew_single(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void xpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  xpy_cc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction xpy_cc_loops[] = {
    xpy_cc_double, xpy_cc_single};

/* (6),(6)->(6),(6) */
INLINED void nxpy_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t x;
  load_coscrew_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    if (step[0] != 0) {
      load_coscrew_double(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_cc_certified(&x, &y, &y_bound);
    store_coscrew_double(&y, p2 + i * step[2], core + 2);
    store_coscrew_double(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void nxpy_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_cc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_cc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  nxpy_cc_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void nxpy_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t x;
  load_coscrew_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    if (step[0] != 0) {
      load_coscrew_single(&x, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_ccf_certified(&x, &y, &y_bound);
    store_coscrew_single(&y, p2 + i * step[2], core + 2);
    store_coscrew_single(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void nxpy_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_cc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_cc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  nxpy_cc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction nxpy_cc_loops[] = {
    nxpy_cc_double, nxpy_cc_single};

/* (),(6)->(6),(6) */
INLINED void product_ac_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 0);
    ksl_product_ac_certified(a, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 1);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ac_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ac_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ac_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ac_double_over(data, n[0], step, step + 4);
}

/* (),(6)->(6),(6) */
INLINED void product_ac_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 0);
    ksl_product_acf_certified(a, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 1);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ac_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ac_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ac_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ac_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ac_loops[] = {
    product_ac_double, product_ac_single};

/* (6),(6)->(6),(6) */
INLINED void add_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_add_cc_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_cc_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void add_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_add_ccf_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_cc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_cc_loops[] = {
    add_cc_double, add_cc_single};

/* (6),(6)->(6),(6) */
INLINED void subtract_cc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_subtract_cc_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_cc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_cc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_cc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_cc_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void subtract_cc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_subtract_ccf_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_cc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_cc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_cc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_cc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction subtract_cc_loops[] = {
    subtract_cc_double, subtract_cc_single};

/* (6),(6)->(6),(6) */
INLINED void add_cct_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c1;
  load_coscrew_double(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_coscrew_double(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c2, p1 + i * step[1], core + 1);
    ksl_add_cct_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_cct_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cct_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cct_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_cct_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void add_cct_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c1;
  load_coscrew_single(&c1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_coscrew_single(&c1, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c2, p1 + i * step[1], core + 1);
    ksl_add_cctf_certified(&c1, &c2, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_cct_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_cct_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_cct_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_cct_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_cct_loops[] = {
    add_cct_double, add_cct_single};

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtc_certified(&t, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtc_double_over(data, n[0], step, step + 4);
}

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcf_certified(&t, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdtc_loops[] = {
    product_CoAdtc_double, product_CoAdtc_single};

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtinvc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtinvc_certified(&t, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtinvc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtinvc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtinvc_double_over(data, n[0], step, step + 4);
}

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtinvc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtinvcf_certified(&t, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtinvc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtinvc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtinvc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdtinvc_loops[] = {
    product_CoAdtinvc_double, product_CoAdtinvc_single};

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtcinv_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcinv_certified(&t, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtcinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtcinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtcinv_double_over(data, n[0], step, step + 4);
}

/* (3),(6)->(6),(6) */
INLINED void product_CoAdtcinv_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 1);
    ksl_product_CoAdtcinvf_certified(&t, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdtcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdtcinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdtcinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdtcinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdtcinv_loops[] = {
    product_CoAdtcinv_double, product_CoAdtcinv_single};

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrc_certified(&R, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrc_double_over(data, n[0], step, step + 4);
}

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcf_certified(&R, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdrc_loops[] = {
    product_CoAdrc_double, product_CoAdrc_single};

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrinvc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrinvc_certified(&R, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrinvc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrinvc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrinvc_double_over(data, n[0], step, step + 4);
}

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrinvc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrinvcf_certified(&R, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrinvc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrinvc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrinvc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdrinvc_loops[] = {
    product_CoAdrinvc_double, product_CoAdrinvc_single};

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrcinv_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcinv_certified(&R, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrcinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrcinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrcinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(6)->(6),(6) */
INLINED void product_CoAdrcinv_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdrcinvf_certified(&R, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdrcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdrcinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdrcinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdrcinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdrcinv_loops[] = {
    product_CoAdrcinv_double, product_CoAdrcinv_single};

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdc_certified(&D, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdc_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcf_certified(&D, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdc_loops[] = {
    product_CoAdc_double, product_CoAdc_single};

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdinvc_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdinvc_certified(&D, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdinvc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdinvc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdinvc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdinvc_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdinvc_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdinvcf_certified(&D, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdinvc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdinvc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdinvc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdinvc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdinvc_loops[] = {
    product_CoAdinvc_double, product_CoAdinvc_single};

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdcinv_double_over(
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
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcinv_certified(&D, &ci, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdcinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdcinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdcinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdcinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void product_CoAdcinv_single_over(
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
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&ci, p1 + i * step[1], core + 2);
    ksl_product_CoAdcinvf_certified(&D, &ci, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_CoAdcinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_CoAdcinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_CoAdcinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_CoAdcinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_CoAdcinv_loops[] = {
    product_CoAdcinv_double, product_CoAdcinv_single};

/* (3,4)->(6),(6) */
INLINED void hctx_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctx_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctx_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hctx_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hctx_loops[] = {
    hctx_double, hctx_single};

/* (3,4)->(6),(6) */
INLINED void hcty_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hcty_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hcty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcty_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcty_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hcty_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hcty_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hcty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hcty_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hcty_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hcty_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hcty_loops[] = {
    hcty_double, hcty_single};

/* (3,4)->(6),(6) */
INLINED void hctz_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctz_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctz_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hctz_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hctz_loops[] = {
    hctz_double, hctz_single};

/* (3,4)->(6),(6) */
INLINED void hctxinv_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxinv_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctxinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctxinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctxinv_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hctxinv_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctxinvf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctxinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctxinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctxinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hctxinv_loops[] = {
    hctxinv_double, hctxinv_single};

/* (3,4)->(6),(6) */
INLINED void hctyinv_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyinv_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctyinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctyinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctyinv_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hctyinv_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctyinvf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctyinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctyinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctyinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hctyinv_loops[] = {
    hctyinv_double, hctyinv_single};

/* (3,4)->(6),(6) */
INLINED void hctzinv_double_over(
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
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzinv_certified(&D, &co, &co_bound);
    store_coscrew_double(&co, p1 + i * step[1], core + 2);
    store_coscrew_double(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctzinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctzinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctzinv_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void hctzinv_single_over(
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
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hctzinvf_certified(&D, &co, &co_bound);
    store_coscrew_single(&co, p1 + i * step[1], core + 2);
    store_coscrew_single(&co_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void hctzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hctzinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hctzinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hctzinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hctzinv_loops[] = {
    hctzinv_double, hctzinv_single};

/* (3,4)->(6,6),(6,6) */
INLINED void CoAd_double_over(
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
    ksl_mat6x6_t M;
    ksl_mat6x6_t M_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_CoAd_certified(&D, &M, &M_bound);
    store_mat6x6_double(&M, p1 + i * step[1], core + 2);
    store_mat6x6_double(&M_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void CoAd_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 288, 288, 32, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    CoAd_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 288, 32, 8, 48, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    CoAd_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  CoAd_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6,6),(6,6) */
INLINED void CoAd_single_over(
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
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t M_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_CoAdf_certified(&D, &M, &M_bound);
    store_mat6x6_single(&M, p1 + i * step[1], core + 2);
    store_mat6x6_single(&M_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void CoAd_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 144, 144, 16, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    CoAd_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 144, 16, 4, 24, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    CoAd_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  CoAd_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction CoAd_loops[] = {
    CoAd_double, CoAd_single};

/* (6),(6)->(),() */
INLINED void reciprocal_product_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrew_t c;
  load_coscrew_double(&c, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double x[6];
    double power;
    double power_bound;
    if (step[0] != 0) {
      load_coscrew_double(&c, p0 + i * step[0], core + 0);
    }
    load_angular_first_double(x, p1 + i * step[1], core + 1);
    power = ksl_reciprocal_product_certified(&c, x, &power_bound);
    store_scalar_double(&power, p2 + i * step[2], core + 2);
    store_scalar_double(&power_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void reciprocal_product_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    reciprocal_product_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    reciprocal_product_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  reciprocal_product_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(),() */
INLINED void reciprocal_product_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_coscrewf_t c;
  load_coscrew_single(&c, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float x[6];
    float power;
    float power_bound;
    if (step[0] != 0) {
      load_coscrew_single(&c, p0 + i * step[0], core + 0);
    }
    load_angular_first_single(x, p1 + i * step[1], core + 1);
    power = ksl_reciprocal_productf_certified(&c, x, &power_bound);
    store_scalar_single(&power, p2 + i * step[2], core + 2);
    store_scalar_single(&power_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void reciprocal_product_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    reciprocal_product_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    reciprocal_product_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  reciprocal_product_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction reciprocal_product_loops[] = {
    reciprocal_product_double, reciprocal_product_single};

/* (6),(6)->(6),(6) */
INLINED void cross_sc_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 1);
    ksl_cross_sc_certified(&s, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_sc_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sc_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sc_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_sc_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void cross_sc_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 1);
    ksl_cross_scf_certified(&s, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_sc_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sc_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sc_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_sc_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction cross_sc_loops[] = {
    cross_sc_double, cross_sc_single};

/* (6),(6)->(6),(6) */
INLINED void cross_sca_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 1);
    ksl_cross_sca_certified(&s, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_sca_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sca_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sca_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_sca_double_over(data, n[0], step, step + 4);
}

/* (6),(6)->(6),(6) */
INLINED void cross_sca_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 1);
    ksl_cross_scaf_certified(&s, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_sca_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sca_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sca_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_sca_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction cross_sca_loops[] = {
    cross_sca_double, cross_sca_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_ctx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctx_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_ctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_ctx_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_ctx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctxf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_ctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_ctx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_ctx_loops[] = {
    constraint_ctx_double, constraint_ctx_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_cty_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cty_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_cty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cty_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cty_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_cty_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_cty_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctyf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_cty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cty_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cty_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_cty_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_cty_loops[] = {
    constraint_cty_double, constraint_cty_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_ctz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctz_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_ctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_ctz_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_ctz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_ctzf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_ctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_ctz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_ctz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_ctz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_ctz_loops[] = {
    constraint_ctz_double, constraint_ctz_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_crx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crx_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_crx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_crx_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_crx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crxf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_crx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_crx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_crx_loops[] = {
    constraint_crx_double, constraint_crx_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_cry_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cry_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_cry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cry_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cry_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_cry_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_cry_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_cryf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_cry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_cry_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_cry_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_cry_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_cry_loops[] = {
    constraint_cry_double, constraint_cry_single};

/* (3,4),(6)->(6),(6) */
INLINED void constraint_crz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crz_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_crz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_crz_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void constraint_crz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_constraint_crzf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void constraint_crz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    constraint_crz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    constraint_crz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  constraint_crz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction constraint_crz_loops[] = {
    constraint_crz_double, constraint_crz_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_ctx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_ctx_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_ctx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_ctx_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_ctx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctxf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_ctx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_ctx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_ctx_loops[] = {
    working_ctx_double, working_ctx_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_cty_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_cty_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_cty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cty_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cty_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_cty_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_cty_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctyf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_cty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cty_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cty_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_cty_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_cty_loops[] = {
    working_cty_double, working_cty_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_ctz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_ctz_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_ctz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_ctz_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_ctz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_ctzf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_ctz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_ctz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_ctz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_ctz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_ctz_loops[] = {
    working_ctz_double, working_ctz_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_crx_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_crx_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_crx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_crx_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_crx_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_crxf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_crx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_crx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_crx_loops[] = {
    working_crx_double, working_crx_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_cry_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_cry_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_cry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cry_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cry_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_cry_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_cry_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_cryf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_cry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_cry_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_cry_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_cry_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_cry_loops[] = {
    working_cry_double, working_cry_single};

/* (3,4),(6)->(6),(6) */
INLINED void working_crz_double_over(
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
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_double(&c, p1 + i * step[1], core + 2);
    ksl_working_crz_certified(&D, &c, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 3);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_crz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_crz_double_over(data, n[0], step, step + 4);
}

/* (3,4),(6)->(6),(6) */
INLINED void working_crz_single_over(
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
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_coscrew_single(&c, p1 + i * step[1], core + 2);
    ksl_working_crzf_certified(&D, &c, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 3);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void working_crz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    working_crz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    working_crz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  working_crz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction working_crz_loops[] = {
    working_crz_double, working_crz_single};

const coscrew_gufunc TABLE(coscrew)[] = {
  {"coscrew_scale", "(6),()->(6),(6)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(6),()->(6),(6).  self, self_bound: coscrew (f in N; τ in N m); a: number.\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", coscrew_scale_loops},
  {"axpy_cc", "(),(6),(6)->(6),(6)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(6),(6)->(6),(6).  a: number; x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "12 mul, 18 add, 12 abs.\n",
   3, 2, "", axpy_cc_loops},
  {"xpy_cc", "(6),(6)->(6),(6)",
    "y = x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", xpy_cc_loops},
  {"nxpy_cc", "(6),(6)->(6),(6)",
    "y = -x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", nxpy_cc_loops},
  {"product_ac", "(),(6)->(6),(6)",
    "co = a ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(),(6)->(6),(6).  a: number; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", product_ac_loops},
  {"add_cc", "(6),(6)->(6),(6)",
    "co = c1 + c2; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", add_cc_loops},
  {"subtract_cc", "(6),(6)->(6),(6)",
    "co = c1 - c2; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", subtract_cc_loops},
  {"add_cct", "(6),(6)->(6),(6)",
    "co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", add_cct_loops},
  {"product_CoAdtc", "(3),(6)->(6),(6)",
    "co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_CoAdtc_loops},
  {"product_CoAdtinvc", "(3),(6)->(6),(6)",
    "co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_CoAdtinvc_loops},
  {"product_CoAdtcinv", "(3),(6)->(6),(6)",
    "co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_CoAdtcinv_loops},
  {"product_CoAdrc", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_CoAdrc_loops},
  {"product_CoAdrinvc", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_CoAdrinvc_loops},
  {"product_CoAdrcinv", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 6 neg, 18 abs.\n",
   2, 2, "R.", product_CoAdrcinv_loops},
  {"product_CoAdc", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "36 mul, 42 add, 21 abs.\n",
   2, 2, "R.", product_CoAdc_loops},
  {"product_CoAdinvc", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "39 mul, 45 add, 27 abs.\n",
   2, 2, "R.", product_CoAdinvc_loops},
  {"product_CoAdcinv", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "36 mul, 42 add, 6 neg, 21 abs.\n",
   2, 2, "R.", product_CoAdcinv_loops},
  {"hctx", "(3,4)->(6),(6)",
    "co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hctx_loops},
  {"hcty", "(3,4)->(6),(6)",
    "co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hcty_loops},
  {"hctz", "(3,4)->(6),(6)",
    "co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hctz_loops},
  {"hctxinv", "(3,4)->(6),(6)",
    "co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctxinv_loops},
  {"hctyinv", "(3,4)->(6),(6)",
    "co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctyinv_loops},
  {"hctzinv", "(3,4)->(6),(6)",
    "co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctzinv_loops},
  {"CoAd", "(3,4)->(6,6),(6,6)",
    "M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.\n"
    "27 mul, 27 add, 18 abs.\n",
   1, 2, "R", CoAd_loops},
  {"reciprocal_product", "(6),(6)->(),()",
    "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(6),(6)->(),().  c: coscrew (f in N; τ in N m); x: six components with the angular part on\n"
    "top; power, power_bound: number.\n"
    "7 mul, 11 add, 6 abs.\n",
   2, 2, "", reciprocal_product_loops},
  {"cross_sc", "(6),(6)->(6),(6)",
    "co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N\n"
    "m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "", cross_sc_loops},
  {"cross_sca", "(6),(6)->(6),(6)",
    "co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_sca_loops},
  {"constraint_ctx", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_ctx_loops},
  {"constraint_cty", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_cty_loops},
  {"constraint_ctz", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_ctz_loops},
  {"constraint_crx", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_crx_loops},
  {"constraint_cry", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_cry_loops},
  {"constraint_crz", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_crz_loops},
  {"working_ctx", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_ctx_loops},
  {"working_cty", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_cty_loops},
  {"working_ctz", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_ctz_loops},
  {"working_crx", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_crx_loops},
  {"working_cry", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_cry_loops},
  {"working_crz", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_crz_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
