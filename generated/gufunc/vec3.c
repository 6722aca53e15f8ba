/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "_lanes.h"
#include "../c/include/ksl/vec3_states.h"

/* (3)->(3) */
INLINED void vec3_copy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec3_copy(&vi, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_copy_double_over(data, n[0], step, step + 2);
}

/* (3)->(3) */
INLINED void vec3_copy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec3f_copy(&vi, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_copy_loops[] = {
    vec3_copy_double, vec3_copy_single};

/* (3),()->(3) */
INLINED void vec3_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t self;
    double a;
    load_vec3_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_vec3_scale(&self, a);
    store_vec3_double(&self, p2 + i * step[2], core + 1);
  }
}

static void vec3_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  vec3_scale_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void vec3_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t self;
    float a;
    load_vec3_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_vec3f_scale(&self, a);
    store_vec3_single(&self, p2 + i * step[2], core + 1);
  }
}

static void vec3_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  vec3_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction vec3_scale_loops[] = {
    vec3_scale_double, vec3_scale_single};

/* (3)->(3) */
INLINED void vec3_inverted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec3_inverted(&vi, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_inverted_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_inverted_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_inverted_double_over(data, n[0], step, step + 2);
}

/* (3)->(3) */
INLINED void vec3_inverted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec3f_inverted(&vi, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_inverted_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_inverted_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_inverted_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_inverted_loops[] = {
    vec3_inverted_double, vec3_inverted_single};

/* (3)->(3) */
INLINED void vec3_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t self;
    load_vec3_double(&self, p0 + i * step[0], core + 0);
    ksl_vec3_invert(&self);
    store_vec3_double(&self, p1 + i * step[1], core + 1);
  }
}

static void vec3_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_invert_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec3_invert_double_over(data, n[0], step, step + 2);
}

/* (3)->(3) */
INLINED void vec3_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t self;
    load_vec3_single(&self, p0 + i * step[0], core + 0);
    ksl_vec3f_invert(&self);
    store_vec3_single(&self, p1 + i * step[1], core + 1);
  }
}

static void vec3_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_invert_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec3_invert_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_invert_loops[] = {
    vec3_invert_double, vec3_invert_single};

/* (),(3),(3)->(3) */
INLINED void axpy_vv_double_over(
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
    ksl_vec3_t x;
    ksl_vec3_t y;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&x, p1 + i * step[1], core + 0);
    load_vec3_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_vv(a, &x, &y);
    store_vec3_double(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_vv_double_over(data, n[0], step, step + 4);
}

/* (),(3),(3)->(3) */
INLINED void axpy_vv_single_over(
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
    ksl_vec3f_t x;
    ksl_vec3f_t y;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&x, p1 + i * step[1], core + 0);
    load_vec3_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_vvf(a, &x, &y);
    store_vec3_single(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_vv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction axpy_vv_loops[] = {
    axpy_vv_double, axpy_vv_single};

/* (3),(3)->(3) */
INLINED void xpy_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t x;
  load_vec3_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t y;
    if (step[0] != 0) {
      load_vec3_double(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&y, p1 + i * step[1], core + 1);
    ksl_xpy_vv(&x, &y);
    store_vec3_double(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void xpy_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t x;
  load_vec3_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t y;
    if (step[0] != 0) {
      load_vec3_single(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&y, p1 + i * step[1], core + 1);
    ksl_xpy_vvf(&x, &y);
    store_vec3_single(&y, p2 + i * step[2], core + 2);
  }
}

static void xpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    xpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    xpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  xpy_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction xpy_vv_loops[] = {
    xpy_vv_double, xpy_vv_single};

/* (3),(3)->(3) */
INLINED void nxpy_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t x;
  load_vec3_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t y;
    if (step[0] != 0) {
      load_vec3_double(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_vv(&x, &y);
    store_vec3_double(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void nxpy_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t x;
  load_vec3_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t y;
    if (step[0] != 0) {
      load_vec3_single(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&y, p1 + i * step[1], core + 1);
    ksl_nxpy_vvf(&x, &y);
    store_vec3_single(&y, p2 + i * step[2], core + 2);
  }
}

static void nxpy_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    nxpy_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    nxpy_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  nxpy_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction nxpy_vv_loops[] = {
    nxpy_vv_double, nxpy_vv_single};

/* (),(3)->(3) */
INLINED void product_av_double_over(
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
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 0);
    ksl_product_av(a, &vi, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_av_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_av_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_av_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_av_double_over(data, n[0], step, step + 3);
}

/* (),(3)->(3) */
INLINED void product_av_single_over(
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
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 0);
    ksl_product_avf(a, &vi, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_av_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_av_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_av_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_av_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_av_loops[] = {
    product_av_double, product_av_single};

/* (3),(3)->(3) */
INLINED void add_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_add_vv(&v1, &v2, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void add_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void add_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_add_vvf(&v1, &v2, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void add_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vv_loops[] = {
    add_vv_double, add_vv_single};

/* (3),(3)->(3) */
INLINED void subtract_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_subtract_vv(&v1, &v2, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void subtract_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void subtract_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_subtract_vvf(&v1, &v2, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void subtract_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction subtract_vv_loops[] = {
    subtract_vv_double, subtract_vv_single};

/* (3),()->(3) */
INLINED void vec3_scaled_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_vec3_scaled(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void vec3_scaled_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scaled_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_scaled_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  vec3_scaled_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void vec3_scaled_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_vec3f_scaled(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void vec3_scaled_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_scaled_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_scaled_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  vec3_scaled_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction vec3_scaled_loops[] = {
    vec3_scaled_double, vec3_scaled_single};

/* (3),(3)->(3),(3) */
INLINED void vec3_swap_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v1;
    ksl_vec3_t v2;
    load_vec3_double(&v1, p0 + i * step[0], core + 0);
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_vec3_swap(&v1, &v2);
    store_vec3_double(&v1, p2 + i * step[2], core + 2);
    store_vec3_double(&v2, p3 + i * step[3], core + 3);
  }
}

static void vec3_swap_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_swap_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec3_swap_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3),(3) */
INLINED void vec3_swap_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v1;
    ksl_vec3f_t v2;
    load_vec3_single(&v1, p0 + i * step[0], core + 0);
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_vec3f_swap(&v1, &v2);
    store_vec3_single(&v1, p2 + i * step[2], core + 2);
    store_vec3_single(&v2, p3 + i * step[3], core + 3);
  }
}

static void vec3_swap_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_swap_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec3_swap_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec3_swap_loops[] = {
    vec3_swap_double, vec3_swap_single};

/* (3)->() */
INLINED void vec3_l2norm_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double norm;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    norm = ksl_vec3_l2norm(&v);
    store_scalar_double(&norm, p1 + i * step[1], core + 1);
  }
}

static void vec3_l2norm_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_l2norm_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_l2norm_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_l2norm_double_over(data, n[0], step, step + 2);
}

/* (3)->() */
INLINED void vec3_l2norm_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float norm;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    norm = ksl_vec3f_l2norm(&v);
    store_scalar_single(&norm, p1 + i * step[1], core + 1);
  }
}

static void vec3_l2norm_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_l2norm_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_l2norm_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_l2norm_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_l2norm_loops[] = {
    vec3_l2norm_double, vec3_l2norm_single};

/* (3)->(3) */
INLINED void vec3_normalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t self;
    load_vec3_double(&self, p0 + i * step[0], core + 0);
    ksl_vec3_normalize(&self);
    store_vec3_double(&self, p1 + i * step[1], core + 1);
  }
}

static void vec3_normalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_normalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec3_normalize_double_over(data, n[0], step, step + 2);
}

/* (3)->(3) */
INLINED void vec3_normalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t self;
    load_vec3_single(&self, p0 + i * step[0], core + 0);
    ksl_vec3f_normalize(&self);
    store_vec3_single(&self, p1 + i * step[1], core + 1);
  }
}

static void vec3_normalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_normalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec3_normalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_normalize_loops[] = {
    vec3_normalize_double, vec3_normalize_single};

/* (3)->(3) */
INLINED void vec3_normalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_vec3_normalized(&v, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_normalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_normalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_normalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_normalized_double_over(data, n[0], step, step + 2);
}

/* (3)->(3) */
INLINED void vec3_normalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_vec3f_normalized(&v, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec3_normalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec3_normalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec3_normalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec3_normalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec3_normalized_loops[] = {
    vec3_normalized_double, vec3_normalized_single};

/* (3),(3)->() */
INLINED void angle_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    double angle;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    angle = ksl_angle_vv(&v1, &v2);
    store_scalar_double(&angle, p2 + i * step[2], core + 2);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void angle_vv_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  angle_vv_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int angle_vv_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v1[3];
  ksl_states v2[3];
  ksl_states angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v1, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_vec3_double(v2, data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      load_lanes_vec3_double(v1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_vec3_double(v2, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_angle_vv_states(v1, v2, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 2, KSL_LANES);
    } else {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void angle_vv_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!angle_vv_double_on_vectors(data, i, m, step, core, raised)) {
      angle_vv_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  angle_vv_double_from(data, i, n - i, step, core);
}
#endif

static void angle_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    angle_vv_double_many(data, n[0], step, step + 3);
    return;
  }
#endif
  static const npy_intp dense_1[] = { 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    angle_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    angle_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  angle_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->() */
INLINED void angle_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    float angle;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    angle = ksl_angle_vvf(&v1, &v2);
    store_scalar_single(&angle, p2 + i * step[2], core + 2);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void angle_vv_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  angle_vv_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int angle_vv_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v1[3];
  ksl_statesf v2[3];
  ksl_statesf angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v1, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_vec3_single(v2, data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_vec3_single(v2, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_angle_vvf_states(v1, v2, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 2, KSL_LANESF);
    } else {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void angle_vv_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!angle_vv_single_on_vectors(data, i, m, step, core, raised)) {
      angle_vv_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  angle_vv_single_from(data, i, n - i, step, core);
}
#endif

static void angle_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    angle_vv_single_many(data, n[0], step, step + 3);
    return;
  }
#endif
  static const npy_intp dense_1[] = { 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    angle_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    angle_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  angle_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction angle_vv_loops[] = {
    angle_vv_double, angle_vv_single};

/* (3),(3)->() */
INLINED void dot_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    double dot;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    dot = ksl_dot_vv(&v1, &v2);
    store_scalar_double(&dot, p2 + i * step[2], core + 2);
  }
}

static void dot_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->() */
INLINED void dot_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    float dot;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    dot = ksl_dot_vvf(&v1, &v2);
    store_scalar_single(&dot, p2 + i * step[2], core + 2);
  }
}

static void dot_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction dot_vv_loops[] = {
    dot_vv_double, dot_vv_single};

/* (),(3)->(3) */
INLINED void product_avinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double k;
  load_scalar_double(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_scalar_double(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 0);
    ksl_product_avinv(k, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_avinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_avinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_avinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_avinv_double_over(data, n[0], step, step + 3);
}

/* (),(3)->(3) */
INLINED void product_avinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float k;
  load_scalar_single(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_scalar_single(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 0);
    ksl_product_avinvf(k, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_avinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_avinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_avinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_avinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_avinv_loops[] = {
    product_avinv_double, product_avinv_single};

/* (),(3)->(3) */
INLINED void product_ainvv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double k;
  load_scalar_double(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_scalar_double(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 0);
    ksl_product_ainvv(k, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_ainvv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ainvv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ainvv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_ainvv_double_over(data, n[0], step, step + 3);
}

/* (),(3)->(3) */
INLINED void product_ainvv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float k;
  load_scalar_single(&k, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_scalar_single(&k, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 0);
    ksl_product_ainvvf(k, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void product_ainvv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ainvv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ainvv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_ainvv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_ainvv_loops[] = {
    product_ainvv_double, product_ainvv_single};

/* (3),(3)->(3) */
INLINED void cross_vv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vv(&v1, &v2, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void cross_vv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_vv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void cross_vv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvf(&v1, &v2, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void cross_vv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_vv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_vv_loops[] = {
    cross_vv_double, cross_vv_single};

/* (3),(3)->(3) */
INLINED void cross_vvinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v1;
  load_vec3_double(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvinv(&v1, &v2, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void cross_vvinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vvinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vvinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_vvinv_double_over(data, n[0], step, step + 3);
}

/* (3),(3)->(3) */
INLINED void cross_vvinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v1;
  load_vec3_single(&v1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v1, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v2, p1 + i * step[1], core + 1);
    ksl_cross_vvinvf(&v1, &v2, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void cross_vvinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cross_vvinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cross_vvinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cross_vvinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cross_vvinv_loops[] = {
    cross_vvinv_double, cross_vvinv_single};

/* (3),()->(3) */
INLINED void add_vvx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvx(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvx_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvx_loops[] = {
    add_vvx_double, add_vvx_single};

/* (3),()->(3) */
INLINED void add_vvxinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxinv(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvxinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvxinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvxinv_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvxinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvxinvf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvxinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvxinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvxinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvxinv_loops[] = {
    add_vvxinv_double, add_vvxinv_single};

/* (3),()->(3) */
INLINED void add_vvy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvy(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvy_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvy_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvy_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvy_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvy_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvy_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvy_loops[] = {
    add_vvy_double, add_vvy_single};

/* (3),()->(3) */
INLINED void add_vvyinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyinv(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvyinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvyinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvyinv_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvyinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvyinvf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvyinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvyinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvyinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvyinv_loops[] = {
    add_vvyinv_double, add_vvyinv_single};

/* (3),()->(3) */
INLINED void add_vvz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvz(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvz_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvz_loops[] = {
    add_vvz_double, add_vvz_single};

/* (3),()->(3) */
INLINED void add_vvzinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t v;
  load_vec3_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzinv(&v, k, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvzinv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvzinv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvzinv_double_over(data, n[0], step, step + 3);
}

/* (3),()->(3) */
INLINED void add_vvzinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t v;
  load_vec3_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_add_vvzinvf(&v, k, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void add_vvzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_vvzinv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_vvzinv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_vvzinv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_vvzinv_loops[] = {
    add_vvzinv_double, add_vvzinv_single};

const coscrew_gufunc TABLE(vec3)[] = {
  {"vec3_copy", "(3)->(3)",
    "vo = vi.\n"
    "\n"
    "(3)->(3).  vi, vo: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", vec3_copy_loops},
  {"vec3_scale", "(3),()->(3)",
    "self = a self.\n"
    "\n"
    "(3),()->(3).  self: vector; a: number.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scale_loops},
  {"vec3_inverted", "(3)->(3)",
    "vo = -vi.\n"
    "\n"
    "(3)->(3).  vi, vo: vector.\n"
    "3 neg.  Exact.\n",
   1, 1, "", vec3_inverted_loops},
  {"vec3_invert", "(3)->(3)",
    "self = -self.\n"
    "\n"
    "(3)->(3).  self: vector.\n"
    "3 neg.  Exact.\n",
   1, 1, "", vec3_invert_loops},
  {"axpy_vv", "(),(3),(3)->(3)",
    "y = a x + y.\n"
    "\n"
    "(),(3),(3)->(3).  a: number; x, y: vector.\n"
    "3 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_vv_loops},
  {"xpy_vv", "(3),(3)->(3)",
    "y = x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_vv_loops},
  {"nxpy_vv", "(3),(3)->(3)",
    "y = -x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_vv_loops},
  {"product_av", "(),(3)->(3)",
    "vo = a vi.\n"
    "\n"
    "(),(3)->(3).  a: number; vi, vo: vector.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_av_loops},
  {"add_vv", "(3),(3)->(3)",
    "vo = v1 + v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vv_loops},
  {"subtract_vv", "(3),(3)->(3)",
    "vo = v1 - v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_vv_loops},
  {"vec3_scaled", "(3),()->(3)",
    "vo = k v.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scaled_loops},
  {"vec3_swap", "(3),(3)->(3),(3)",
    "v1, v2 = v2, v1.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2: vector.\n"
    "No arithmetic.  Exact.\n",
   2, 2, "", vec3_swap_loops},
  {"vec3_l2norm", "(3)->()",
    "|v| = sqrt(v·v).\n"
    "\n"
    "(3)->().  v: vector; norm: number.\n"
    "7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select.\n",
   1, 1, "", vec3_l2norm_loops},
  {"vec3_normalize", "(3)->(3)",
    "self = self / |self|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  self: vector.\n"
    "12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.\n",
   1, 1, "", vec3_normalize_loops},
  {"vec3_normalized", "(3)->(3)",
    "vo = v / |v|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  v, vo: vector.\n"
    "12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.\n",
   1, 1, "", vec3_normalized_loops},
  {"angle_vv", "(3),(3)->()",
    "angle = atan2(|v1 × v2|, v1·v2), in [0, π].\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; angle: number.\n"
    "51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select.\n",
   2, 1, "", angle_vv_loops},
  {"dot_vv", "(3),(3)->()",
    "v1·v2.\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; dot: number.\n"
    "3 mul, 2 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", dot_vv_loops},
  {"product_avinv", "(),(3)->(3)",
    "vo = k (-v).\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_avinv_loops},
  {"product_ainvv", "(),(3)->(3)",
    "vo = v / k.\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 div.\n",
   2, 1, "", product_ainvv_loops},
  {"cross_vv", "(3),(3)->(3)",
    "vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", cross_vv_loops},
  {"cross_vvinv", "(3),(3)->(3)",
    "vo = v1 × (-v2).\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", cross_vvinv_loops},
  {"add_vvx", "(3),()->(3)",
    "vo = v + k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvx_loops},
  {"add_vvxinv", "(3),()->(3)",
    "vo = v - k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvxinv_loops},
  {"add_vvy", "(3),()->(3)",
    "vo = v + k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvy_loops},
  {"add_vvyinv", "(3),()->(3)",
    "vo = v - k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvyinv_loops},
  {"add_vvz", "(3),()->(3)",
    "vo = v + k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvz_loops},
  {"add_vvzinv", "(3),()->(3)",
    "vo = v - k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
