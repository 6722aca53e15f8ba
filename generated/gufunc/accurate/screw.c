/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the screw operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (6),()->(6) */
INLINED void screw_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t self;
    double a;
    load_screw_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_screw_scale_accurate(&self, a);
    store_screw_double(&self, p2 + i * step[2], core + 1);
  }
}

static void screw_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  screw_scale_double_over(data, n[0], step, step + 3);
}

/* (6),()->(6) */
INLINED void screw_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t self;
    float a;
    load_screw_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_screwf_scale_accurate(&self, a);
    store_screw_single(&self, p2 + i * step[2], core + 1);
  }
}

static void screw_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 4, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  screw_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction screw_scale_loops[] = {
    screw_scale_double, screw_scale_single};

/* (),(6),(6)->(6) */
INLINED void axpy_ss_double_over(
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
    ksl_screw_t x;
    ksl_screw_t y;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_screw_double(&x, p1 + i * step[1], core + 0);
    load_screw_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_ss_accurate(a, &x, &y);
    store_screw_double(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_ss_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_ss_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_ss_double_over(data, n[0], step, step + 4);
}

/* (),(6),(6)->(6) */
INLINED void axpy_ss_single_over(
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
    ksl_screwf_t x;
    ksl_screwf_t y;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_screw_single(&x, p1 + i * step[1], core + 0);
    load_screw_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_ssf_accurate(a, &x, &y);
    store_screw_single(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_ss_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_ss_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_ss_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction axpy_ss_loops[] = {
    axpy_ss_double, axpy_ss_single};

/* (6),(6)->(6) */
INLINED void xpy_ss_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t x;
  load_screw_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t y;
    if (step[0] != 0) {
      load_screw_double(&x, p0 + i * step[0], core + 0);
    }
    load_screw_double(&y, p1 + i * step[1], core + 1);
    ksl_xpy_ss_accurate(&x, &y);
    store_screw_double(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_ss_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_ss_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_ss_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void xpy_ss_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t x;
  load_screw_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t y;
    if (step[0] != 0) {
      load_screw_single(&x, p0 + i * step[0], core + 0);
    }
    load_screw_single(&y, p1 + i * step[1], core + 1);
    ksl_xpy_ssf_accurate(&x, &y);
    store_screw_single(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_ss_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_ss_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_ss_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction xpy_ss_loops[] = {
    xpy_ss_double, xpy_ss_single};

/* (6),(6)->(6) */
INLINED void nxpy_ss_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t x;
  load_screw_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t y;
    if (step[0] != 0) {
      load_screw_double(&x, p0 + i * step[0], core + 0);
    }
    load_screw_double(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_ss_accurate(&x, &y);
    store_screw_double(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_ss_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_ss_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_ss_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void nxpy_ss_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t x;
  load_screw_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t y;
    if (step[0] != 0) {
      load_screw_single(&x, p0 + i * step[0], core + 0);
    }
    load_screw_single(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_ssf_accurate(&x, &y);
    store_screw_single(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_ss_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_ss_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_ss_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction nxpy_ss_loops[] = {
    nxpy_ss_double, nxpy_ss_single};

/* (),(6)->(6) */
INLINED void product_as_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 0);
    ksl_product_as_accurate(a, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 1);
  }
}

static void product_as_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_as_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_as_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_as_double_over(data, n[0], step, step + 3);
}

/* (),(6)->(6) */
INLINED void product_as_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 0);
    ksl_product_asf_accurate(a, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 1);
  }
}

static void product_as_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_as_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_as_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_as_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_as_loops[] = {
    product_as_double, product_as_single};

/* (6),(6)->(6) */
INLINED void add_ss_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s1;
  load_screw_double(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s2;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s2, p1 + i * step[1], core + 1);
    ksl_add_ss_accurate(&s1, &s2, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void add_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_ss_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_ss_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_ss_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void add_ss_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s1;
  load_screw_single(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s2, p1 + i * step[1], core + 1);
    ksl_add_ssf_accurate(&s1, &s2, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void add_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_ss_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_ss_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_ss_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_ss_loops[] = {
    add_ss_double, add_ss_single};

/* (6),(6)->(6) */
INLINED void subtract_ss_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s1;
  load_screw_double(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s2;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s2, p1 + i * step[1], core + 1);
    ksl_subtract_ss_accurate(&s1, &s2, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void subtract_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_ss_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_ss_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_ss_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void subtract_ss_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s1;
  load_screw_single(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s2, p1 + i * step[1], core + 1);
    ksl_subtract_ssf_accurate(&s1, &s2, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void subtract_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_ss_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_ss_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_ss_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction subtract_ss_loops[] = {
    subtract_ss_double, subtract_ss_single};

/* (6)->() */
INLINED void screw_norm_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t si;
  load_screw_double(&si, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double norm;
    if (step[0] != 0) {
      load_screw_double(&si, p0 + i * step[0], core + 0);
    }
    norm = ksl_screw_norm_accurate(&si);
    store_scalar_double(&norm, p1 + i * step[1], core + 1);
  }
}

static void screw_norm_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_norm_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    screw_norm_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  screw_norm_double_over(data, n[0], step, step + 2);
}

/* (6)->() */
INLINED void screw_norm_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t si;
  load_screw_single(&si, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float norm;
    if (step[0] != 0) {
      load_screw_single(&si, p0 + i * step[0], core + 0);
    }
    norm = ksl_screwf_norm_accurate(&si);
    store_scalar_single(&norm, p1 + i * step[1], core + 1);
  }
}

static void screw_norm_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_norm_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    screw_norm_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  screw_norm_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction screw_norm_loops[] = {
    screw_norm_double, screw_norm_single};

/* (6)->(6) */
INLINED void screw_normalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t self;
    load_screw_double(&self, p0 + i * step[0], core + 0);
    ksl_screw_normalize_accurate(&self);
    store_screw_double(&self, p1 + i * step[1], core + 1);
  }
}

static void screw_normalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_normalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  screw_normalize_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void screw_normalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t self;
    load_screw_single(&self, p0 + i * step[0], core + 0);
    ksl_screwf_normalize_accurate(&self);
    store_screw_single(&self, p1 + i * step[1], core + 1);
  }
}

static void screw_normalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_normalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  screw_normalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction screw_normalize_loops[] = {
    screw_normalize_double, screw_normalize_single};

/* (6)->(6) */
INLINED void screw_normalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t si;
  load_screw_double(&si, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&si, p0 + i * step[0], core + 0);
    }
    ksl_screw_normalized_accurate(&si, &so);
    store_screw_double(&so, p1 + i * step[1], core + 1);
  }
}

static void screw_normalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_normalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    screw_normalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  screw_normalized_double_over(data, n[0], step, step + 2);
}

/* (6)->(6) */
INLINED void screw_normalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t si;
  load_screw_single(&si, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&si, p0 + i * step[0], core + 0);
    }
    ksl_screwf_normalized_accurate(&si, &so);
    store_screw_single(&so, p1 + i * step[1], core + 1);
  }
}

static void screw_normalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    screw_normalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    screw_normalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  screw_normalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction screw_normalized_loops[] = {
    screw_normalized_double, screw_normalized_single};

/* (6),(6)->(6) */
INLINED void add_sst_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s1;
  load_screw_double(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s2;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s2, p1 + i * step[1], core + 1);
    ksl_add_sst_accurate(&s1, &s2, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void add_sst_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_sst_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_sst_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_sst_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void add_sst_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s1;
  load_screw_single(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s2, p1 + i * step[1], core + 1);
    ksl_add_sstf_accurate(&s1, &s2, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void add_sst_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_sst_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_sst_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_sst_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_sst_loops[] = {
    add_sst_double, add_sst_single};

/* (3),(6)->(6) */
INLINED void product_Adts_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 1);
    ksl_product_Adts_accurate(&t, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adts_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adts_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adts_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adts_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_Adts_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 1);
    ksl_product_Adtsf_accurate(&t, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adts_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adts_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adts_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adts_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adts_loops[] = {
    product_Adts_double, product_Adts_single};

/* (3),(6)->(6) */
INLINED void product_Adtinvs_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 1);
    ksl_product_Adtinvs_accurate(&t, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adtinvs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adtinvs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adtinvs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adtinvs_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_Adtinvs_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 1);
    ksl_product_Adtinvsf_accurate(&t, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adtinvs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adtinvs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adtinvs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adtinvs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adtinvs_loops[] = {
    product_Adtinvs_double, product_Adtinvs_single};

/* (3),(6)->(6) */
INLINED void product_Adtsinv_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 1);
    ksl_product_Adtsinv_accurate(&t, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adtsinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adtsinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adtsinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adtsinv_double_over(data, n[0], step, step + 3);
}

/* (3),(6)->(6) */
INLINED void product_Adtsinv_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 1);
    ksl_product_Adtsinvf_accurate(&t, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void product_Adtsinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adtsinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adtsinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adtsinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adtsinv_loops[] = {
    product_Adtsinv_double, product_Adtsinv_single};

/* (3,3),(6)->(6) */
INLINED void product_Adrs_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrs_accurate(&R, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrs_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_Adrs_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrsf_accurate(&R, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adrs_loops[] = {
    product_Adrs_double, product_Adrs_single};

/* (3,3),(6)->(6) */
INLINED void product_Adrinvs_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrinvs_accurate(&R, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrinvs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrinvs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrinvs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrinvs_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_Adrinvs_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrinvsf_accurate(&R, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrinvs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrinvs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrinvs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrinvs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adrinvs_loops[] = {
    product_Adrinvs_double, product_Adrinvs_single};

/* (3,3),(6)->(6) */
INLINED void product_Adrsinv_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrsinv_accurate(&R, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrsinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrsinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrsinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrsinv_double_over(data, n[0], step, step + 3);
}

/* (3,3),(6)->(6) */
INLINED void product_Adrsinv_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adrsinvf_accurate(&R, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adrsinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adrsinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adrsinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adrsinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adrsinv_loops[] = {
    product_Adrsinv_double, product_Adrsinv_single};

/* (3,4),(6)->(6) */
INLINED void product_Ads_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Ads_accurate(&D, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Ads_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Ads_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Ads_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Ads_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_Ads_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adsf_accurate(&D, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Ads_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Ads_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Ads_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Ads_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Ads_loops[] = {
    product_Ads_double, product_Ads_single};

/* (3,4),(6)->(6) */
INLINED void product_Adinvs_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Adinvs_accurate(&D, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adinvs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adinvs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adinvs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adinvs_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_Adinvs_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adinvsf_accurate(&D, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adinvs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adinvs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adinvs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adinvs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adinvs_loops[] = {
    product_Adinvs_double, product_Adinvs_single};

/* (3,4),(6)->(6) */
INLINED void product_Adsinv_double_over(
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
    ksl_screw_t si;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_screw_double(&si, p1 + i * step[1], core + 2);
    ksl_product_Adsinv_accurate(&D, &si, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adsinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adsinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adsinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adsinv_double_over(data, n[0], step, step + 3);
}

/* (3,4),(6)->(6) */
INLINED void product_Adsinv_single_over(
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
    ksl_screwf_t si;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_screw_single(&si, p1 + i * step[1], core + 2);
    ksl_product_Adsinvf_accurate(&D, &si, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void product_Adsinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Adsinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Adsinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Adsinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Adsinv_loops[] = {
    product_Adsinv_double, product_Adsinv_single};

/* (3,4)->(6) */
INLINED void hsrx_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrx_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrx_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrx_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrx_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsrx_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrxf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrx_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrx_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrx_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsrx_loops[] = {
    hsrx_double, hsrx_single};

/* (3,4)->(6) */
INLINED void hsry_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsry_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsry_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsry_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsry_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsry_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsryf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsry_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsry_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsry_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsry_loops[] = {
    hsry_double, hsry_single};

/* (3,4)->(6) */
INLINED void hsrz_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrz_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrz_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrz_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrz_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsrz_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrzf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrz_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrz_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrz_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsrz_loops[] = {
    hsrz_double, hsrz_single};

/* (3,4)->(6) */
INLINED void hsrxinv_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrxinv_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrxinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrxinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrxinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsrxinv_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrxinvf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrxinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrxinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrxinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsrxinv_loops[] = {
    hsrxinv_double, hsrxinv_single};

/* (3,4)->(6) */
INLINED void hsryinv_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsryinv_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsryinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsryinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsryinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsryinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsryinv_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsryinvf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsryinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsryinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsryinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsryinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsryinv_loops[] = {
    hsryinv_double, hsryinv_single};

/* (3,4)->(6) */
INLINED void hsrzinv_double_over(
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
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrzinv_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrzinv_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrzinv_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrzinv_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void hsrzinv_single_over(
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
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_hsrzinvf_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void hsrzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrzinv_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrzinv_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  hsrzinv_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction hsrzinv_loops[] = {
    hsrzinv_double, hsrzinv_single};

/* (3,4)->(6,6) */
INLINED void Ad_double_over(
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
    ksl_Ad_accurate(&D, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 2);
  }
}

static void Ad_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 288, 32, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    Ad_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 32, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    Ad_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  Ad_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6,6) */
INLINED void Ad_single_over(
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
    ksl_Adf_accurate(&D, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 2);
  }
}

static void Ad_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 144, 16, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    Ad_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 16, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    Ad_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  Ad_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction Ad_loops[] = {
    Ad_double, Ad_single};

/* (6),(6)->() */
INLINED void dot_cs_double_over(
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
    ksl_screw_t s;
    double power;
    if (step[0] != 0) {
      load_coscrew_double(&c, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s, p1 + i * step[1], core + 1);
    power = ksl_dot_cs_accurate(&c, &s);
    store_scalar_double(&power, p2 + i * step[2], core + 2);
  }
}

static void dot_cs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_cs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_cs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_cs_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->() */
INLINED void dot_cs_single_over(
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
    ksl_screwf_t s;
    float power;
    if (step[0] != 0) {
      load_coscrew_single(&c, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s, p1 + i * step[1], core + 1);
    power = ksl_dot_csf_accurate(&c, &s);
    store_scalar_single(&power, p2 + i * step[2], core + 2);
  }
}

static void dot_cs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_cs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_cs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_cs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction dot_cs_loops[] = {
    dot_cs_double, dot_cs_single};

/* (6),(6)->(6) */
INLINED void cross_ss_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s1;
  load_screw_double(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s2;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s2, p1 + i * step[1], core + 1);
    ksl_cross_ss_accurate(&s1, &s2, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void cross_ss_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_ss_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_ss_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_ss_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void cross_ss_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s1;
  load_screw_single(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s2, p1 + i * step[1], core + 1);
    ksl_cross_ssf_accurate(&s1, &s2, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void cross_ss_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_ss_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_ss_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_ss_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_ss_loops[] = {
    cross_ss_double, cross_ss_single};

/* (6),(6)->(6) */
INLINED void cross_sst_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s1;
  load_screw_double(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s2;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_screw_double(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s2, p1 + i * step[1], core + 1);
    ksl_cross_sst_accurate(&s1, &s2, &so);
    store_screw_double(&so, p2 + i * step[2], core + 2);
  }
}

static void cross_sst_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sst_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sst_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sst_double_over(data, n[0], step, step + 3);
}

/* (6),(6)->(6) */
INLINED void cross_sst_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s1;
  load_screw_single(&s1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_screw_single(&s1, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s2, p1 + i * step[1], core + 1);
    ksl_cross_sstf_accurate(&s1, &s2, &so);
    store_screw_single(&so, p2 + i * step[2], core + 2);
  }
}

static void cross_sst_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_sst_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_sst_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_sst_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_sst_loops[] = {
    cross_sst_double, cross_sst_single};

/* (3,4),(3)->(6) */
INLINED void hsra_double_over(
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
    ksl_vec3_t axis;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&axis, p1 + i * step[1], core + 2);
    ksl_hsra_accurate(&D, &axis, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void hsra_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsra_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsra_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsra_double_over(data, n[0], step, step + 3);
}

/* (3,4),(3)->(6) */
INLINED void hsra_single_over(
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
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&axis, p1 + i * step[1], core + 2);
    ksl_hsraf_accurate(&D, &axis, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void hsra_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsra_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsra_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsra_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hsra_loops[] = {
    hsra_double, hsra_single};

/* (3,4),(3)->(6) */
INLINED void hsta_double_over(
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
    ksl_vec3_t axis;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&axis, p1 + i * step[1], core + 2);
    ksl_hsta_accurate(&D, &axis, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void hsta_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsta_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsta_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsta_double_over(data, n[0], step, step + 3);
}

/* (3,4),(3)->(6) */
INLINED void hsta_single_over(
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
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&axis, p1 + i * step[1], core + 2);
    ksl_hstaf_accurate(&D, &axis, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void hsta_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsta_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsta_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsta_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hsta_loops[] = {
    hsta_double, hsta_single};

/* (3,4),(3)->(6) */
INLINED void hsrainv_double_over(
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
    ksl_vec3_t axis;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&axis, p1 + i * step[1], core + 2);
    ksl_hsrainv_accurate(&D, &axis, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void hsrainv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrainv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrainv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsrainv_double_over(data, n[0], step, step + 3);
}

/* (3,4),(3)->(6) */
INLINED void hsrainv_single_over(
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
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&axis, p1 + i * step[1], core + 2);
    ksl_hsrainvf_accurate(&D, &axis, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void hsrainv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hsrainv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hsrainv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hsrainv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hsrainv_loops[] = {
    hsrainv_double, hsrainv_single};

/* (3,4),(3)->(6) */
INLINED void hstainv_double_over(
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
    ksl_vec3_t axis;
    ksl_screw_t so;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&axis, p1 + i * step[1], core + 2);
    ksl_hstainv_accurate(&D, &axis, &so);
    store_screw_double(&so, p2 + i * step[2], core + 3);
  }
}

static void hstainv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hstainv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hstainv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hstainv_double_over(data, n[0], step, step + 3);
}

/* (3,4),(3)->(6) */
INLINED void hstainv_single_over(
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
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&axis, p1 + i * step[1], core + 2);
    ksl_hstainvf_accurate(&D, &axis, &so);
    store_screw_single(&so, p2 + i * step[2], core + 3);
  }
}

static void hstainv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    hstainv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    hstainv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  hstainv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction hstainv_loops[] = {
    hstainv_double, hstainv_single};

const coscrew_gufunc TABLE(screw)[] = {
  {"screw_scale", "(6),()->(6)",
    "self = a self.\n"
    "\n"
    "(6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.\n"
    "6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", screw_scale_loops},
  {"axpy_ss", "(),(6),(6)->(6)",
    "y = a x + y.\n"
    "\n"
    "(),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   3, 1, "", axpy_ss_loops},
  {"xpy_ss", "(6),(6)->(6)",
    "y = x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_ss_loops},
  {"nxpy_ss", "(6),(6)->(6)",
    "y = -x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_ss_loops},
  {"product_as", "(),(6)->(6)",
    "so = a si.\n"
    "\n"
    "(),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_as_loops},
  {"add_ss", "(6),(6)->(6)",
    "so = s1 + s2.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_ss_loops},
  {"subtract_ss", "(6),(6)->(6)",
    "so = s1 - s2.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_ss_loops},
  {"screw_norm", "(6)->()",
    "|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).\n"
    "\n"
    "(6)->().  si: screw (v in m/s; ω in rad/s); norm: number.\n"
    "10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16\n"
    "select.\n",
   1, 1, "", screw_norm_loops},
  {"screw_normalize", "(6)->(6)",
    "self = self / |self|, with screw_norm; the zero screw stays zero.\n"
    "\n"
    "(6)->(6).  self: screw (v in m/s; ω in rad/s).\n"
    "43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,\n"
    "34 select.\n",
   1, 1, "", screw_normalize_loops},
  {"screw_normalized", "(6)->(6)",
    "so = si / |si|, with screw_norm; the zero screw stays zero.\n"
    "\n"
    "(6)->(6).  si, so: screw (v in m/s; ω in rad/s).\n"
    "43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,\n"
    "34 select.\n",
   1, 1, "", screw_normalized_loops},
  {"add_sst", "(6),(6)->(6)",
    "so = (s1.lin + s2.lin ; s1.ang).\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_sst_loops},
  {"product_Adts", "(3),(6)->(6)",
    "so = [Ad](t) si.\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adts_loops},
  {"product_Adtinvs", "(3),(6)->(6)",
    "so = [Ad](t)^-1 si.\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adtinvs_loops},
  {"product_Adtsinv", "(3),(6)->(6)",
    "so = [Ad](t) (-si).\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adtsinv_loops},
  {"product_Adrs", "(3,3),(6)->(6)",
    "so = [Ad](R) si.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrs_loops},
  {"product_Adrinvs", "(3,3),(6)->(6)",
    "so = [Ad](R)^-1 si.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrinvs_loops},
  {"product_Adrsinv", "(3,3),(6)->(6)",
    "so = [Ad](R) (-si).\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrsinv_loops},
  {"product_Ads", "(3,4),(6)->(6)",
    "so = [Ad](D) si = [Ad](t) [Ad](R) si.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Ads_loops},
  {"product_Adinvs", "(3,4),(6)->(6)",
    "so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adinvs_loops},
  {"product_Adsinv", "(3,4),(6)->(6)",
    "so = [Ad](D) (-si).\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S\n"
    "the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adsinv_loops},
  {"hsrx", "(3,4)->(6)",
    "so = h_rx: column 3 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrx_loops},
  {"hsry", "(3,4)->(6)",
    "so = h_ry: column 4 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsry_loops},
  {"hsrz", "(3,4)->(6)",
    "so = h_rz: column 5 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrz_loops},
  {"hsrxinv", "(3,4)->(6)",
    "so = -h_rx: -column 3 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrxinv_loops},
  {"hsryinv", "(3,4)->(6)",
    "so = -h_ry: -column 4 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsryinv_loops},
  {"hsrzinv", "(3,4)->(6)",
    "so = -h_rz: -column 5 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrzinv_loops},
  {"Ad", "(3,4)->(6,6)",
    "M = [Ad](D).\n"
    "\n"
    "(3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.\n"
    "18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", Ad_loops},
  {"dot_cs", "(6),(6)->()",
    "power = f·v + τ·ω, in W.\n"
    "\n"
    "(6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.\n"
    "6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", dot_cs_loops},
  {"cross_ss", "(6),(6)->(6)",
    "so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products\n"
    "overflow.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 12, ang: 6) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_ss_loops},
  {"cross_sst", "(6),(6)->(6)",
    "so = (ω1×v2 ; 0).\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sst_loops},
  {"hsra", "(3,4),(3)->(6)",
    "so = (t×R a ; R a), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "21 mul, 54 add, 15 product rest.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsra_loops},
  {"hsta", "(3,4),(3)->(6)",
    "so = (R a ; 0), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "9 mul, 33 add, 9 product rest.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsta_loops},
  {"hsrainv", "(3,4),(3)->(6)",
    "so = -(t×R a ; R a), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "21 mul, 54 add, 15 product rest, 6 neg.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S\n"
    "the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsrainv_loops},
  {"hstainv", "(3,4),(3)->(6)",
    "so = -(R a ; 0), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hstainv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
