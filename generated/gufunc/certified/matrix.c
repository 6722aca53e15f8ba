/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the matrix operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (3,3),(3)->(3),(3) */
INLINED void product_drv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_drv_certified(&R, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3)->(3),(3) */
INLINED void product_drv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_drvf_certified(&R, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drv_loops[] = {
    product_drv_double, product_drv_single};

/* (3,3),(3)->(3),(3) */
INLINED void product_drvinv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_drvinv_certified(&R, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3)->(3),(3) */
INLINED void product_drvinv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_drvinvf_certified(&R, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvinv_loops[] = {
    product_drvinv_double, product_drvinv_single};

/* (3,3),(3)->(3),(3) */
INLINED void product_drinvv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_drinvv_certified(&R, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3)->(3),(3) */
INLINED void product_drinvv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_drinvvf_certified(&R, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drinvv_loops[] = {
    product_drinvv_double, product_drinvv_single};

/* (3,3),(3)->(3),(3) */
INLINED void product_drinvvinv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_drinvvinv_certified(&R, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvvinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvvinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvvinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvvinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3)->(3),(3) */
INLINED void product_drinvvinv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_drinvvinvf_certified(&R, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvvinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvvinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvvinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvvinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drinvvinv_loops[] = {
    product_drinvvinv_double, product_drinvvinv_single};

/* (3,4),(3)->(3),(3) */
INLINED void product_dv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_dv_certified(&D, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 24, 24, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3)->(3),(3) */
INLINED void product_dv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_dvf_certified(&D, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 12, 12, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_dv_loops[] = {
    product_dv_double, product_dv_single};

/* (3,4),(3)->(3),(3) */
INLINED void product_dinvv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 2);
    ksl_product_dinvv_certified(&D, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 3);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 24, 24, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3)->(3),(3) */
INLINED void product_dinvv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 2);
    ksl_product_dinvvf_certified(&D, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 3);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 12, 12, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_dinvv_loops[] = {
    product_dinvv_double, product_dinvv_single};

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drdr_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R1;
  load_mat3x3_double(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R2, p1 + i * step[1], core + 2);
    ksl_product_drdr_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdr_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdr_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdr_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdr_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drdr_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R1;
  load_mat3x3_single(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R2, p1 + i * step[1], core + 2);
    ksl_product_drdrf_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdr_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdr_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdr_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdr_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdr_loops[] = {
    product_drdr_double, product_drdr_single};

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drdrinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R1;
  load_mat3x3_double(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R2, p1 + i * step[1], core + 2);
    ksl_product_drdrinv_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drdrinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R1;
  load_mat3x3_single(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R2, p1 + i * step[1], core + 2);
    ksl_product_drdrinvf_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdrinv_loops[] = {
    product_drdrinv_double, product_drdrinv_single};

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drinvdr_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R1;
  load_mat3x3_double(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R2, p1 + i * step[1], core + 2);
    ksl_product_drinvdr_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvdr_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvdr_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvdr_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvdr_double_over(data, n[0], step, step + 4);
}

/* (3,3),(3,3)->(3,3),(3,3) */
INLINED void product_drinvdr_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R1;
  load_mat3x3_single(&R1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R1, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R2, p1 + i * step[1], core + 2);
    ksl_product_drinvdrf_certified(&R1, &R2, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 4);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drinvdr_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drinvdr_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drinvdr_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drinvdr_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drinvdr_loops[] = {
    product_drinvdr_double, product_drinvdr_single};

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_dd_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D1;
  load_SE3_double(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D2, p1 + i * step[1], core + 2);
    ksl_product_dd_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 4);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dd_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dd_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dd_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dd_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_dd_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D1;
  load_SE3_single(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D2, p1 + i * step[1], core + 2);
    ksl_product_ddf_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 4);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dd_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dd_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dd_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dd_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_dd_loops[] = {
    product_dd_double, product_dd_single};

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_ddinv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D1;
  load_SE3_double(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D2, p1 + i * step[1], core + 2);
    ksl_product_ddinv_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 4);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_ddinv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D1;
  load_SE3_single(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D2, p1 + i * step[1], core + 2);
    ksl_product_ddinvf_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 4);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddinv_loops[] = {
    product_ddinv_double, product_ddinv_single};

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_dinvd_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D1;
  load_SE3_double(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D2, p1 + i * step[1], core + 2);
    ksl_product_dinvd_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 4);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvd_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvd_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvd_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvd_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,4)->(3,4),(3,4) */
INLINED void product_dinvd_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D1;
  load_SE3_single(&D1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D2, p1 + i * step[1], core + 2);
    ksl_product_dinvdf_certified(&D1, &D2, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 4);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvd_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvd_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvd_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvd_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_dinvd_loops[] = {
    product_dinvd_double, product_dinvd_single};

/* (3,4),(3,3)->(3,4),(3,4) */
INLINED void product_ddr_double_over(
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
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R, p1 + i * step[1], core + 2);
    ksl_product_ddr_certified(&D, &R, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 4);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddr_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddr_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddr_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddr_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,3)->(3,4),(3,4) */
INLINED void product_ddr_single_over(
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
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R, p1 + i * step[1], core + 2);
    ksl_product_ddrf_certified(&D, &R, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 4);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddr_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddr_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddr_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddr_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddr_loops[] = {
    product_ddr_double, product_ddr_single};

/* (3,4),(3,3)->(3,4),(3,4) */
INLINED void product_ddrinv_double_over(
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
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R, p1 + i * step[1], core + 2);
    ksl_product_ddrinv_certified(&D, &R, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 4);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,3)->(3,4),(3,4) */
INLINED void product_ddrinv_single_over(
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
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R, p1 + i * step[1], core + 2);
    ksl_product_ddrinvf_certified(&D, &R, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 4);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddrinv_loops[] = {
    product_ddrinv_double, product_ddrinv_single};

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_ddt_double_over(
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
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 2);
    ksl_product_ddt_certified(&D, &t, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddt_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddt_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddt_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddt_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_ddt_single_over(
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
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 2);
    ksl_product_ddtf_certified(&D, &t, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddt_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddt_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddt_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddt_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddt_loops[] = {
    product_ddt_double, product_ddt_single};

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_ddtinv_double_over(
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
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 2);
    ksl_product_ddtinv_certified(&D, &t, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_ddtinv_single_over(
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
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 2);
    ksl_product_ddtinvf_certified(&D, &t, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtinv_loops[] = {
    product_ddtinv_double, product_ddtinv_single};

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_dinvdt_double_over(
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
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 2);
    ksl_product_dinvdt_certified(&D, &t, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvdt_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvdt_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvdt_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvdt_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3)->(3,4),(3,4) */
INLINED void product_dinvdt_single_over(
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
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 2);
    ksl_product_dinvdtf_certified(&D, &t, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_dinvdt_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_dinvdt_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_dinvdt_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_dinvdt_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_dinvdt_loops[] = {
    product_dinvdt_double, product_dinvdt_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvtx_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtx_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtx_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvtx_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtxf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvtx_loops[] = {
    product_drvtx_double, product_drvtx_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrx_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrx_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrx_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrx_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrxf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdrx_loops[] = {
    product_drdrx_double, product_drdrx_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrx_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrx_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrx_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrx_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrxf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddrx_loops[] = {
    product_ddrx_double, product_ddrx_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtx_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtx_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtx_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtx_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtxf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtx_loops[] = {
    product_ddtx_double, product_ddtx_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvtxinv_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtxinv_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtxinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtxinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtxinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvtxinv_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtxinvf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtxinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtxinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtxinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvtxinv_loops[] = {
    product_drvtxinv_double, product_drvtxinv_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrxinv_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrxinv_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrxinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrxinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrxinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrxinv_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrxinvf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrxinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrxinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrxinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdrxinv_loops[] = {
    product_drdrxinv_double, product_drdrxinv_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrxinv_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrxinv_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrxinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrxinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrxinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrxinv_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrxinvf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrxinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrxinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrxinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddrxinv_loops[] = {
    product_ddrxinv_double, product_ddrxinv_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtxinv_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtxinv_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtxinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtxinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtxinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtxinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtxinv_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtxinvf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtxinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtxinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtxinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtxinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtxinv_loops[] = {
    product_ddtxinv_double, product_ddtxinv_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvty_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvty_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvty_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvty_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvty_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvty_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtyf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvty_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvty_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvty_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvty_loops[] = {
    product_drvty_double, product_drvty_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdry_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdry_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdry_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdry_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdry_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdry_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdryf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdry_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdry_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdry_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdry_loops[] = {
    product_drdry_double, product_drdry_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddry_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddry_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddry_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddry_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddry_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddry_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddry_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddryf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddry_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddry_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddry_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddry_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddry_loops[] = {
    product_ddry_double, product_ddry_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddty_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddty_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddty_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddty_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddty_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddty_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddty_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtyf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddty_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddty_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddty_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddty_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddty_loops[] = {
    product_ddty_double, product_ddty_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvtyinv_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtyinv_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtyinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtyinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtyinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvtyinv_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtyinvf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtyinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtyinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtyinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvtyinv_loops[] = {
    product_drvtyinv_double, product_drvtyinv_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdryinv_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdryinv_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdryinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdryinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdryinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdryinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdryinv_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdryinvf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdryinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdryinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdryinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdryinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdryinv_loops[] = {
    product_drdryinv_double, product_drdryinv_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddryinv_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddryinv_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddryinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddryinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddryinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddryinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddryinv_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddryinvf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddryinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddryinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddryinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddryinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddryinv_loops[] = {
    product_ddryinv_double, product_ddryinv_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtyinv_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtyinv_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtyinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtyinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtyinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtyinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtyinv_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtyinvf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtyinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtyinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtyinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtyinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtyinv_loops[] = {
    product_ddtyinv_double, product_ddtyinv_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvtz_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtz_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtz_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvtz_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtzf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvtz_loops[] = {
    product_drvtz_double, product_drvtz_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrz_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrz_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrz_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrz_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrzf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdrz_loops[] = {
    product_drdrz_double, product_drdrz_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrz_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrz_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrz_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrz_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrzf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddrz_loops[] = {
    product_ddrz_double, product_ddrz_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtz_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtz_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtz_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtz_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtzf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtz_loops[] = {
    product_ddtz_double, product_ddtz_single};

/* (3,3),()->(3),(3) */
INLINED void product_drvtzinv_double_over(
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
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtzinv_certified(&R, k, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtzinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtzinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtzinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),()->(3),(3) */
INLINED void product_drvtzinv_single_over(
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
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_drvtzinvf_certified(&R, k, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drvtzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drvtzinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drvtzinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drvtzinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drvtzinv_loops[] = {
    product_drvtzinv_double, product_drvtzinv_single};

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrzinv_double_over(
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
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrzinv_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrzinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrzinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrzinv_double_over(data, n[0], step, step + 4);
}

/* (3,3),(2)->(3,3),(3,3) */
INLINED void product_drdrzinv_single_over(
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
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_drdrzinvf_certified(&R, dc, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 3);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_drdrzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_drdrzinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_drdrzinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_drdrzinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_drdrzinv_loops[] = {
    product_drdrzinv_double, product_drdrzinv_single};

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrzinv_double_over(
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
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrzinv_certified(&D, dc, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 3);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrzinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrzinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrzinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),(2)->(3,4),(3,4) */
INLINED void product_ddrzinv_single_over(
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
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 2);
    ksl_product_ddrzinvf_certified(&D, dc, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 3);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddrzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddrzinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddrzinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddrzinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddrzinv_loops[] = {
    product_ddrzinv_double, product_ddrzinv_single};

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtzinv_double_over(
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
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtzinv_certified(&D, k, &Do, &Do_bound);
    store_SE3_double(&Do, p2 + i * step[2], core + 2);
    store_SE3_double(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtzinv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtzinv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 96, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtzinv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtzinv_double_over(data, n[0], step, step + 4);
}

/* (3,4),()->(3,4),(3,4) */
INLINED void product_ddtzinv_single_over(
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
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 2);
    ksl_product_ddtzinvf_certified(&D, k, &Do, &Do_bound);
    store_SE3_single(&Do, p2 + i * step[2], core + 2);
    store_SE3_single(&Do_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_ddtzinv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_ddtzinv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 48, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_ddtzinv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_ddtzinv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_ddtzinv_loops[] = {
    product_ddtzinv_double, product_ddtzinv_single};

const coscrew_gufunc TABLE(matrix)[] = {
  {"product_drv", "(3,3),(3)->(3),(3)",
    "vo = R v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 9 abs.\n",
   2, 2, "", product_drv_loops},
  {"product_drvinv", "(3,3),(3)->(3),(3)",
    "vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_drvinv_loops},
  {"product_drinvv", "(3,3),(3)->(3),(3)",
    "vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 9 abs.\n",
   2, 2, "", product_drinvv_loops},
  {"product_drinvvinv", "(3,3),(3)->(3),(3)",
    "vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_drinvvinv_loops},
  {"product_dv", "(3,4),(3)->(3),(3)",
    "vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_dv_loops},
  {"product_dinvv", "(3,4),(3)->(3),(3)",
    "vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.\n"
    "21 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_dinvv_loops},
  {"product_drdr", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drdr_loops},
  {"product_drdrinv", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drdrinv_loops},
  {"product_drinvdr", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drinvdr_loops},
  {"product_dd", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "48 mul, 66 add, 39 abs.\n",
   2, 2, "RR", product_dd_loops},
  {"product_ddinv", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "57 mul, 66 add, 33 abs.\n",
   2, 2, "RR", product_ddinv_loops},
  {"product_dinvd", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "57 mul, 63 add, 39 abs.\n",
   2, 2, "RR", product_dinvd_loops},
  {"product_ddr", "(3,4),(3,3)->(3,4),(3,4)",
    "Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:\n"
    "rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "RR", product_ddr_loops},
  {"product_ddrinv", "(3,4),(3,3)->(3,4),(3,4)",
    "Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:\n"
    "rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "RR", product_ddrinv_loops},
  {"product_ddt", "(3,4),(3)->(3,4),(3,4)",
    "Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_ddt_loops},
  {"product_ddtinv", "(3,4),(3)->(3,4),(3,4)",
    "Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_ddtinv_loops},
  {"product_dinvdt", "(3,4),(3)->(3,4),(3,4)",
    "Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "21 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_dinvdt_loops},
  {"product_drvtx", "(3,3),()->(3),(3)",
    "vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvtx_loops},
  {"product_drdrx", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrx_loops},
  {"product_ddrx", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrx_loops},
  {"product_ddtx", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtx_loops},
  {"product_drvtxinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtxinv_loops},
  {"product_drdrxinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrxinv_loops},
  {"product_ddrxinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrxinv_loops},
  {"product_ddtxinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtxinv_loops},
  {"product_drvty", "(3,3),()->(3),(3)",
    "vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvty_loops},
  {"product_drdry", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdry_loops},
  {"product_ddry", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddry_loops},
  {"product_ddty", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddty_loops},
  {"product_drvtyinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtyinv_loops},
  {"product_drdryinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdryinv_loops},
  {"product_ddryinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddryinv_loops},
  {"product_ddtyinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtyinv_loops},
  {"product_drvtz", "(3,3),()->(3),(3)",
    "vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvtz_loops},
  {"product_drdrz", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrz_loops},
  {"product_ddrz", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrz_loops},
  {"product_ddtz", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtz_loops},
  {"product_drvtzinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtzinv_loops},
  {"product_drdrzinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrzinv_loops},
  {"product_ddrzinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrzinv_loops},
  {"product_ddtzinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
