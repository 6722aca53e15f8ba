/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (3),()->(3),(3) */
INLINED void vec3_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t self;
    double a;
    ksl_vec3_t self_bound;
    load_vec3_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_vec3_scale_certified(&self, a, &self_bound);
    store_vec3_double(&self, p2 + i * step[2], core + 1);
    store_vec3_double(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec3_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scale_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec3_scale_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void vec3_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t self;
    float a;
    ksl_vec3f_t self_bound;
    load_vec3_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_vec3f_scale_certified(&self, a, &self_bound);
    store_vec3_single(&self, p2 + i * step[2], core + 1);
    store_vec3_single(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec3_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scale_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec3_scale_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec3_scale_loops[] = {
    vec3_scale_double, vec3_scale_single};

/* (),(3),(3)->(3),(3) */
INLINED void axpy_vv_double_over(
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
    ksl_vec3_t x;
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&x, p1 + i * step[1], core + 0);
    load_vec3_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_vv_certified(a, &x, &y, &y_bound);
    store_vec3_double(&y, p3 + i * step[3], core + 2);
    store_vec3_double(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_vv_double_over(data, n[0], step, step + 5);
}

/* (),(3),(3)->(3),(3) */
INLINED void axpy_vv_single_over(
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
    ksl_vec3f_t x;
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&x, p1 + i * step[1], core + 0);
    load_vec3_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_vvf_certified(a, &x, &y, &y_bound);
    store_vec3_single(&y, p3 + i * step[3], core + 2);
    store_vec3_single(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_vv_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction axpy_vv_loops[] = {
    axpy_vv_double, axpy_vv_single};

/* (3),(3)->(3),(3) */
INLINED void xpy_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t x;
  load_vec3_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    if (step[0] != 0) {
      load_vec3_double(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&y, p1 + i * step[1], core + 1);
    ksl_xpy_vv_certified(&x, &y, &y_bound);
    store_vec3_double(&y, p2 + i * step[2], core + 2);
    store_vec3_double(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void xpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  xpy_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void xpy_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t x;
  load_vec3_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    if (step[0] != 0) {
      load_vec3_single(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&y, p1 + i * step[1], core + 1);
    ksl_xpy_vvf_certified(&x, &y, &y_bound);
    store_vec3_single(&y, p2 + i * step[2], core + 2);
    store_vec3_single(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void xpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  xpy_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction xpy_vv_loops[] = {
    xpy_vv_double, xpy_vv_single};

/* (3),(3)->(3),(3) */
INLINED void nxpy_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t x;
  load_vec3_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    if (step[0] != 0) {
      load_vec3_double(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_vv_certified(&x, &y, &y_bound);
    store_vec3_double(&y, p2 + i * step[2], core + 2);
    store_vec3_double(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void nxpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  nxpy_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void nxpy_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t x;
  load_vec3_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    if (step[0] != 0) {
      load_vec3_single(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_vvf_certified(&x, &y, &y_bound);
    store_vec3_single(&y, p2 + i * step[2], core + 2);
    store_vec3_single(&y_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void nxpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  nxpy_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction nxpy_vv_loops[] = {
    nxpy_vv_double, nxpy_vv_single};

/* (),(3)->(3),(3) */
INLINED void product_av_double_over(
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
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 0);
    ksl_product_av_certified(a, &vi, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_av_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_av_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_av_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_av_double_over(data, n[0], step, step + 4);
}

/* (),(3)->(3),(3) */
INLINED void product_av_single_over(
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
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 0);
    ksl_product_avf_certified(a, &vi, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_av_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_av_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_av_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_av_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_av_loops[] = {
    product_av_double, product_av_single};

/* (3),(3)->(3),(3) */
INLINED void add_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_add_vv_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void add_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_add_vvf_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vv_loops[] = {
    add_vv_double, add_vv_single};

/* (3),(3)->(3),(3) */
INLINED void subtract_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_subtract_vv_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void subtract_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_subtract_vvf_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction subtract_vv_loops[] = {
    subtract_vv_double, subtract_vv_single};

/* (3),()->(3),(3) */
INLINED void vec3_scaled_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_vec3_scaled_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec3_scaled_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scaled_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_scaled_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  vec3_scaled_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void vec3_scaled_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_vec3f_scaled_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec3_scaled_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scaled_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_scaled_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  vec3_scaled_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec3_scaled_loops[] = {
    vec3_scaled_double, vec3_scaled_single};

/* (3),(3)->(),() */
INLINED void angle_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    double angle;
    double angle_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    angle = ksl_angle_vv_certified(&v1, &v2, &angle_bound);
    store_scalar_double(&angle, p2 + i * step[2], core + 2);
    store_scalar_double(&angle_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void angle_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    angle_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    angle_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  angle_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(),() */
INLINED void angle_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    float angle;
    float angle_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    angle = ksl_angle_vvf_certified(&v1, &v2, &angle_bound);
    store_scalar_single(&angle, p2 + i * step[2], core + 2);
    store_scalar_single(&angle_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void angle_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    angle_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    angle_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  angle_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction angle_vv_loops[] = {
    angle_vv_double, angle_vv_single};

/* (3),(3)->(),() */
INLINED void dot_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    double dot;
    double dot_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    dot = ksl_dot_vv_certified(&v1, &v2, &dot_bound);
    store_scalar_double(&dot, p2 + i * step[2], core + 2);
    store_scalar_double(&dot_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dot_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  dot_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(),() */
INLINED void dot_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    float dot;
    float dot_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    dot = ksl_dot_vvf_certified(&v1, &v2, &dot_bound);
    store_scalar_single(&dot, p2 + i * step[2], core + 2);
    store_scalar_single(&dot_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dot_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  dot_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction dot_vv_loops[] = {
    dot_vv_double, dot_vv_single};

/* (),(3)->(3),(3) */
INLINED void product_avinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double k;
  load_scalar_double(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_scalar_double(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 0);
    ksl_product_avinv_certified(k, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_avinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_avinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_avinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_avinv_double_over(data, n[0], step, step + 4);
}

/* (),(3)->(3),(3) */
INLINED void product_avinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float k;
  load_scalar_single(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_scalar_single(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 0);
    ksl_product_avinvf_certified(k, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_avinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_avinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_avinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_avinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_avinv_loops[] = {
    product_avinv_double, product_avinv_single};

/* (3),(3)->(3),(3) */
INLINED void cross_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vv_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_vv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void cross_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvf_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction cross_vv_loops[] = {
    cross_vv_double, cross_vv_single};

/* (3),(3)->(3),(3) */
INLINED void cross_vvinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvinv_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_vvinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vvinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vvinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_vvinv_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void cross_vvinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvinvf_certified(&v1, &v2, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cross_vvinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vvinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vvinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  cross_vvinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction cross_vvinv_loops[] = {
    cross_vvinv_double, cross_vvinv_single};

/* (3),()->(3),(3) */
INLINED void add_vvx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvx_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvx_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvx_loops[] = {
    add_vvx_double, add_vvx_single};

/* (3),()->(3),(3) */
INLINED void add_vvxinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxinv_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvxinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvxinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvxinv_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvxinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxinvf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvxinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvxinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvxinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvxinv_loops[] = {
    add_vvxinv_double, add_vvxinv_single};

/* (3),()->(3),(3) */
INLINED void add_vvy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvy_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvy_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvy_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvy_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvy_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvy_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvy_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvy_loops[] = {
    add_vvy_double, add_vvy_single};

/* (3),()->(3),(3) */
INLINED void add_vvyinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyinv_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvyinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvyinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvyinv_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvyinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyinvf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvyinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvyinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvyinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvyinv_loops[] = {
    add_vvyinv_double, add_vvyinv_single};

/* (3),()->(3),(3) */
INLINED void add_vvz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvz_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvz_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvz_loops[] = {
    add_vvz_double, add_vvz_single};

/* (3),()->(3),(3) */
INLINED void add_vvzinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzinv_certified(&v, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvzinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvzinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvzinv_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3),(3) */
INLINED void add_vvzinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzinvf_certified(&v, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_vvzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvzinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvzinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_vvzinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_vvzinv_loops[] = {
    add_vvzinv_double, add_vvzinv_single};

const coscrew_gufunc TABLE(vec3)[] = {
  {"vec3_scale", "(3),()->(3),(3)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  self, self_bound: vector; a: number.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", vec3_scale_loops},
  {"axpy_vv", "(),(3),(3)->(3),(3)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(3),(3)->(3),(3).  a: number; x, y, y_bound: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   3, 2, "", axpy_vv_loops},
  {"xpy_vv", "(3),(3)->(3),(3)",
    "y = x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  x, y, y_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", xpy_vv_loops},
  {"nxpy_vv", "(3),(3)->(3),(3)",
    "y = -x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  x, y, y_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", nxpy_vv_loops},
  {"product_av", "(),(3)->(3),(3)",
    "vo = a vi; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(),(3)->(3),(3).  a: number; vi, vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_av_loops},
  {"add_vv", "(3),(3)->(3),(3)",
    "vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", add_vv_loops},
  {"subtract_vv", "(3),(3)->(3),(3)",
    "vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", subtract_vv_loops},
  {"vec3_scaled", "(3),()->(3),(3)",
    "vo = k v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", vec3_scaled_loops},
  {"angle_vv", "(3),(3)->(),()",
    "angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(3),(3)->(),().  v1, v2: vector; angle, angle_bound: number.\n"
    "196 mul, 311 add, 22 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4\n"
    "copysign, 37 less, 5 equal, 56 select.\n",
   2, 2, "", angle_vv_loops},
  {"dot_vv", "(3),(3)->(),()",
    "v1·v2; |error of dot| <= dot_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(),().  v1, v2: vector; dot, dot_bound: number.\n"
    "4 mul, 5 add, 3 abs.\n",
   2, 2, "", dot_vv_loops},
  {"product_avinv", "(),(3)->(3),(3)",
    "vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(),(3)->(3),(3).  k: number; v, vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_avinv_loops},
  {"cross_vv", "(3),(3)->(3),(3)",
    "vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless\n"
    "products overflow.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_vv_loops},
  {"cross_vvinv", "(3),(3)->(3),(3)",
    "vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_vvinv_loops},
  {"add_vvx", "(3),()->(3),(3)",
    "vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvx_loops},
  {"add_vvxinv", "(3),()->(3),(3)",
    "vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvxinv_loops},
  {"add_vvy", "(3),()->(3),(3)",
    "vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvy_loops},
  {"add_vvyinv", "(3),()->(3),(3)",
    "vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvyinv_loops},
  {"add_vvz", "(3),()->(3),(3)",
    "vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvz_loops},
  {"add_vvzinv", "(3),()->(3),(3)",
    "vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
