/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (4),()->(4),(4) */
INLINED void quaternion_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t self;
    double a;
    ksl_quaternion_t self_bound;
    load_quaternion_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_quaternion_scale_certified(&self, a, &self_bound);
    store_quaternion_double(&self, p2 + i * step[2], core + 1);
    store_quaternion_double(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_scale_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  quaternion_scale_double_over(data, n[0], step, step + 4);
}

/* (4),()->(4),(4) */
INLINED void quaternion_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t self;
    float a;
    ksl_quaternionf_t self_bound;
    load_quaternion_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_quaternionf_scale_certified(&self, a, &self_bound);
    store_quaternion_single(&self, p2 + i * step[2], core + 1);
    store_quaternion_single(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_scale_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  quaternion_scale_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_scale_loops[] = {
    quaternion_scale_double, quaternion_scale_single};

/* (),(4),(4)->(4),(4) */
INLINED void axpy_qq_double_over(
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
    ksl_quaternion_t x;
    ksl_quaternion_t y;
    ksl_quaternion_t y_bound;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&x, p1 + i * step[1], core + 0);
    load_quaternion_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_qq_certified(a, &x, &y, &y_bound);
    store_quaternion_double(&y, p3 + i * step[3], core + 2);
    store_quaternion_double(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_qq_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_qq_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_qq_double_over(data, n[0], step, step + 5);
}

/* (),(4),(4)->(4),(4) */
INLINED void axpy_qq_single_over(
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
    ksl_quaternionf_t x;
    ksl_quaternionf_t y;
    ksl_quaternionf_t y_bound;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&x, p1 + i * step[1], core + 0);
    load_quaternion_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_qqf_certified(a, &x, &y, &y_bound);
    store_quaternion_single(&y, p3 + i * step[3], core + 2);
    store_quaternion_single(&y_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axpy_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_qq_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_qq_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axpy_qq_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction axpy_qq_loops[] = {
    axpy_qq_double, axpy_qq_single};

/* (4),(3)->(3),(3) */
INLINED void rotate_qv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 1);
    ksl_rotate_qv_certified(&q, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void rotate_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  rotate_qv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(3),(3) */
INLINED void rotate_qv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 1);
    ksl_rotate_qvf_certified(&q, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void rotate_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  rotate_qv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction rotate_qv_loops[] = {
    rotate_qv_double, rotate_qv_single};

/* (4),(3)->(3),(3) */
INLINED void rotate_qconjv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 1);
    ksl_rotate_qconjv_certified(&q, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void rotate_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  rotate_qconjv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(3),(3) */
INLINED void rotate_qconjv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 1);
    ksl_rotate_qconjvf_certified(&q, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void rotate_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  rotate_qconjv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction rotate_qconjv_loops[] = {
    rotate_qconjv_double, rotate_qconjv_single};

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qq_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qq_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qqf_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qq_loops[] = {
    quaternion_product_qq_double, quaternion_product_qq_single};

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqconj_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqconj_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qqconjf_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqconj_loops[] = {
    quaternion_product_qqconj_double, quaternion_product_qqconj_single};

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjq_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjq_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qconjqf_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjq_loops[] = {
    quaternion_product_qconjq_double, quaternion_product_qconjq_single};

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqconj_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqconj_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void quaternion_product_qconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qconjqconjf_certified(&q1i, &q2i, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqconj_loops[] = {
    quaternion_product_qconjqconj_double, quaternion_product_qconjqconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qxq_loops[] = {
    quaternion_product_qxq_double, quaternion_product_qxq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qxqconj_loops[] = {
    quaternion_product_qxqconj_double, quaternion_product_qxqconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxconjq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxconjq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxconjqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxconjq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qxconjq_loops[] = {
    quaternion_product_qxconjq_double, quaternion_product_qxconjq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxconjqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxconjqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qxconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qxconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qxconjqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qxconjqconj_loops[] = {
    quaternion_product_qxconjqconj_double, quaternion_product_qxconjqconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqx_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqx_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqxf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqx_loops[] = {
    quaternion_product_qqx_double, quaternion_product_qqx_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqxconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqxconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqxconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqxconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqxconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqxconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqxconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqxconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqxconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqxconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqxconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqxconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqxconj_loops[] = {
    quaternion_product_qqxconj_double, quaternion_product_qqxconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqx_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqx_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqx_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqx_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqxf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqx_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqx_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqx_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqx_loops[] = {
    quaternion_product_qconjqx_double, quaternion_product_qconjqx_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqxconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqxconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqxconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqxconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqxconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqxconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqxconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqxconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqxconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqxconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqxconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqxconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqxconj_loops[] = {
    quaternion_product_qconjqxconj_double, quaternion_product_qconjqxconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qyq_loops[] = {
    quaternion_product_qyq_double, quaternion_product_qyq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qyqconj_loops[] = {
    quaternion_product_qyqconj_double, quaternion_product_qyqconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyconjq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyconjq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyconjqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyconjq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qyconjq_loops[] = {
    quaternion_product_qyconjq_double, quaternion_product_qyconjq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyconjqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyconjqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qyconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qyconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qyconjqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qyconjqconj_loops[] = {
    quaternion_product_qyconjqconj_double, quaternion_product_qyconjqconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqy_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqy_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqy_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqy_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqyf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqy_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqy_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqy_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqy_loops[] = {
    quaternion_product_qqy_double, quaternion_product_qqy_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqyconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqyconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqyconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqyconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqyconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqyconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqyconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqyconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqyconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqyconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqyconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqyconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqyconj_loops[] = {
    quaternion_product_qqyconj_double, quaternion_product_qqyconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqy_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqy_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqy_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqy_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqyf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqy_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqy_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqy_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqy_loops[] = {
    quaternion_product_qconjqy_double, quaternion_product_qconjqy_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqyconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqyconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqyconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqyconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqyconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqyconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqyconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqyconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqyconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqyconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqyconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqyconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqyconj_loops[] = {
    quaternion_product_qconjqyconj_double, quaternion_product_qconjqyconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qzq_loops[] = {
    quaternion_product_qzq_double, quaternion_product_qzq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qzqconj_loops[] = {
    quaternion_product_qzqconj_double, quaternion_product_qzqconj_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzconjq_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzconjq_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzconjqf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzconjq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qzconjq_loops[] = {
    quaternion_product_qzconjq_double, quaternion_product_qzconjq_single};

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzconjqconj_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzconjqconj_double_over(data, n[0], step, step + 4);
}

/* (2),(4)->(4),(4) */
INLINED void quaternion_product_qzconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qzconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qzconjqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qzconjqconj_loops[] = {
    quaternion_product_qzconjqconj_double, quaternion_product_qzconjqconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqz_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqz_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqzf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqz_loops[] = {
    quaternion_product_qqz_double, quaternion_product_qqz_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqzconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqzconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqzconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqzconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqzconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqzconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qqzconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqzconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qqzconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqzconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqzconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qqzconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qqzconj_loops[] = {
    quaternion_product_qqzconj_double, quaternion_product_qqzconj_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqz_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqz_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqz_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqz_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqzf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqz_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqz_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqz_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqz_loops[] = {
    quaternion_product_qconjqz_double, quaternion_product_qconjqz_single};

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqzconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqzconj_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqzconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqzconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqzconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqzconj_double_over(data, n[0], step, step + 4);
}

/* (4),(2)->(4),(4) */
INLINED void quaternion_product_qconjqzconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqzconjf_certified(&qi, dci, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjqzconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqzconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqzconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjqzconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjqzconj_loops[] = {
    quaternion_product_qconjqzconj_double, quaternion_product_qconjqzconj_single};

/* (4),(3)->(4),(4) */
INLINED void quaternion_product_qv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qv_certified(&qi, &vi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(4),(4) */
INLINED void quaternion_product_qv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 1);
    ksl_product_qvf_certified(&qi, &vi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qv_loops[] = {
    quaternion_product_qv_double, quaternion_product_qv_single};

/* (4),(3)->(4),(4) */
INLINED void quaternion_product_qconjv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjv_certified(&qi, &vi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(4),(4) */
INLINED void quaternion_product_qconjv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 1);
    ksl_product_qconjvf_certified(&qi, &vi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_qconjv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_qconjv_loops[] = {
    quaternion_product_qconjv_double, quaternion_product_qconjv_single};

/* (3),(4)->(4),(4) */
INLINED void quaternion_product_vq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_vq_certified(&vi, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_vq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_vq_double_over(data, n[0], step, step + 4);
}

/* (3),(4)->(4),(4) */
INLINED void quaternion_product_vq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_vqf_certified(&vi, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_vq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_vq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_vq_loops[] = {
    quaternion_product_vq_double, quaternion_product_vq_single};

/* (3),(4)->(4),(4) */
INLINED void quaternion_product_vqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_vqconj_certified(&vi, &qi, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_vqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_vqconj_double_over(data, n[0], step, step + 4);
}

/* (3),(4)->(4),(4) */
INLINED void quaternion_product_vqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_vqconjf_certified(&vi, &qi, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_product_vqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_product_vqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_product_vqconj_loops[] = {
    quaternion_product_vqconj_double, quaternion_product_vqconj_single};

/* (4),(4)->(),() */
INLINED void dot_qq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    double dot;
    double dot_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    dot = ksl_dot_qq_certified(&q1i, &q2i, &dot_bound);
    store_scalar_double(&dot, p2 + i * step[2], core + 2);
    store_scalar_double(&dot_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dot_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_qq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_qq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  dot_qq_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(),() */
INLINED void dot_qq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    float dot;
    float dot_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    dot = ksl_dot_qqf_certified(&q1i, &q2i, &dot_bound);
    store_scalar_single(&dot, p2 + i * step[2], core + 2);
    store_scalar_single(&dot_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void dot_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_qq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_qq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  dot_qq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction dot_qq_loops[] = {
    dot_qq_double, dot_qq_single};

/* (3),(4)->(4),(4) */
INLINED void add_dpiToq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t dpi;
  load_vec3_double(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qi_bound;
    if (step[0] != 0) {
      load_vec3_double(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_add_dpiToq_certified(&dpi, &qi, &qi_bound);
    store_quaternion_double(&qi, p2 + i * step[2], core + 2);
    store_quaternion_double(&qi_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_dpiToq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_dpiToq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_dpiToq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_dpiToq_double_over(data, n[0], step, step + 4);
}

/* (3),(4)->(4),(4) */
INLINED void add_dpiToq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t dpi;
  load_vec3_single(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qi_bound;
    if (step[0] != 0) {
      load_vec3_single(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_add_dpiToqf_certified(&dpi, &qi, &qi_bound);
    store_quaternion_single(&qi, p2 + i * step[2], core + 2);
    store_quaternion_single(&qi_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_dpiToq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_dpiToq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_dpiToq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_dpiToq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_dpiToq_loops[] = {
    add_dpiToq_double, add_dpiToq_single};

/* (3),(4)->(4),(4) */
INLINED void subtract_dpiFromq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t dpi;
  load_vec3_double(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qi_bound;
    if (step[0] != 0) {
      load_vec3_double(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_subtract_dpiFromq_certified(&dpi, &qi, &qi_bound);
    store_quaternion_double(&qi, p2 + i * step[2], core + 2);
    store_quaternion_double(&qi_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_dpiFromq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_dpiFromq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_dpiFromq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_dpiFromq_double_over(data, n[0], step, step + 4);
}

/* (3),(4)->(4),(4) */
INLINED void subtract_dpiFromq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t dpi;
  load_vec3_single(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qi_bound;
    if (step[0] != 0) {
      load_vec3_single(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_subtract_dpiFromqf_certified(&dpi, &qi, &qi_bound);
    store_quaternion_single(&qi, p2 + i * step[2], core + 2);
    store_quaternion_single(&qi_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_dpiFromq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_dpiFromq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_dpiFromq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_dpiFromq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction subtract_dpiFromq_loops[] = {
    subtract_dpiFromq_double, subtract_dpiFromq_single};

/* (3),(4)->(4),(4) */
INLINED void omega_to_dquaternion_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t w;
  load_vec3_double(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t dqo;
    ksl_quaternion_t dqo_bound;
    if (step[0] != 0) {
      load_vec3_double(&w, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_omega_to_dquaternion_certified(&w, &qi, &dqo, &dqo_bound);
    store_quaternion_double(&dqo, p2 + i * step[2], core + 2);
    store_quaternion_double(&dqo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void omega_to_dquaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    omega_to_dquaternion_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    omega_to_dquaternion_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  omega_to_dquaternion_double_over(data, n[0], step, step + 4);
}

/* (3),(4)->(4),(4) */
INLINED void omega_to_dquaternion_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t w;
  load_vec3_single(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t dqo;
    ksl_quaternionf_t dqo_bound;
    if (step[0] != 0) {
      load_vec3_single(&w, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_omega_to_dquaternionf_certified(&w, &qi, &dqo, &dqo_bound);
    store_quaternion_single(&dqo, p2 + i * step[2], core + 2);
    store_quaternion_single(&dqo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void omega_to_dquaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    omega_to_dquaternion_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    omega_to_dquaternion_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  omega_to_dquaternion_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction omega_to_dquaternion_loops[] = {
    omega_to_dquaternion_double, omega_to_dquaternion_single};

/* (3),()->(4),(4) */
INLINED void quaternion_from_axis_angle_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t axis;
  load_vec3_double(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double angle;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_vec3_double(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&angle, p1 + i * step[1], core + 1);
    ksl_quaternion_from_axis_angle_certified(&axis, angle, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 1);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_from_axis_angle_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_axis_angle_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_axis_angle_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_from_axis_angle_double_over(data, n[0], step, step + 4);
}

/* (3),()->(4),(4) */
INLINED void quaternion_from_axis_angle_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t axis;
  load_vec3_single(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float angle;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_vec3_single(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&angle, p1 + i * step[1], core + 1);
    ksl_quaternionf_from_axis_angle_certified(&axis, angle, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 1);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_from_axis_angle_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_axis_angle_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_axis_angle_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_from_axis_angle_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_from_axis_angle_loops[] = {
    quaternion_from_axis_angle_double, quaternion_from_axis_angle_single};

/* (4)->(),(3),(),(3) */
INLINED void axis_angle_from_quaternion_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double angle;
    ksl_vec3_t axis;
    double angle_bound;
    ksl_vec3_t axis_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_quaternion_certified(&q, &axis, &angle_bound, &axis_bound);
    store_scalar_double(&angle, p1 + i * step[1], core + 1);
    store_vec3_double(&axis, p2 + i * step[2], core + 1);
    store_scalar_double(&angle_bound, p3 + i * step[3], core + 2);
    store_vec3_double(&axis_bound, p4 + i * step[4], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axis_angle_from_quaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 24, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_quaternion_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_quaternion_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axis_angle_from_quaternion_double_over(data, n[0], step, step + 5);
}

/* (4)->(),(3),(),(3) */
INLINED void axis_angle_from_quaternion_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float angle;
    ksl_vec3f_t axis;
    float angle_bound;
    ksl_vec3f_t axis_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_quaternionf_certified(&q, &axis, &angle_bound, &axis_bound);
    store_scalar_single(&angle, p1 + i * step[1], core + 1);
    store_vec3_single(&axis, p2 + i * step[2], core + 1);
    store_scalar_single(&angle_bound, p3 + i * step[3], core + 2);
    store_vec3_single(&axis_bound, p4 + i * step[4], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axis_angle_from_quaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 12, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_quaternion_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_quaternion_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axis_angle_from_quaternion_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction axis_angle_from_quaternion_loops[] = {
    axis_angle_from_quaternion_double, axis_angle_from_quaternion_single};

/* (3)->(4),(4) */
INLINED void quaternion_exp_double_over(
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
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_exp_certified(&v, &qo, &qo_bound);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
    store_quaternion_double(&qo_bound, p2 + i * step[2], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_exp_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_exp_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_exp_double_over(data, n[0], step, step + 3);
}

/* (3)->(4),(4) */
INLINED void quaternion_exp_single_over(
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
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_exp_certified(&v, &qo, &qo_bound);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
    store_quaternion_single(&qo_bound, p2 + i * step[2], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_exp_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_exp_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_exp_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_exp_loops[] = {
    quaternion_exp_double, quaternion_exp_single};

/* (4)->(3),(3) */
INLINED void quaternion_log_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_log_certified(&q, &vo, &vo_bound);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
    store_vec3_double(&vo_bound, p2 + i * step[2], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_log_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_log_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_log_double_over(data, n[0], step, step + 3);
}

/* (4)->(3),(3) */
INLINED void quaternion_log_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_log_certified(&q, &vo, &vo_bound);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
    store_vec3_single(&vo_bound, p2 + i * step[2], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void quaternion_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_log_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_log_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_log_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_log_loops[] = {
    quaternion_log_double, quaternion_log_single};

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_scale", "(4),()->(4),(4)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "8 mul, 4 add, 4 abs.\n",
   2, 2, "", quaternion_scale_loops},
  {"axpy_qq", "(),(4),(4)->(4),(4)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(4),(4)->(4),(4).  a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 12 add, 8 abs.\n",
   3, 2, "", axpy_qq_loops},
  {"rotate_qv", "(4),(3)->(3),(3)",
    "vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, "U.", rotate_qv_loops},
  {"rotate_qconjv", "(4),(3)->(3),(3)",
    "vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, "U.", rotate_qconjv_loops},
  {"quaternion_product_qq", "(4),(4)->(4),(4)",
    "qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qq_loops},
  {"quaternion_product_qqconj", "(4),(4)->(4),(4)",
    "qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qqconj_loops},
  {"quaternion_product_qconjq", "(4),(4)->(4),(4)",
    "qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qconjq_loops},
  {"quaternion_product_qconjqconj", "(4),(4)->(4),(4)",
    "qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qconjqconj_loops},
  {"quaternion_product_qxq", "(2),(4)->(4),(4)",
    "qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qxq_loops},
  {"quaternion_product_qxqconj", "(2),(4)->(4),(4)",
    "qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qxqconj_loops},
  {"quaternion_product_qxconjq", "(2),(4)->(4),(4)",
    "qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qxconjq_loops},
  {"quaternion_product_qxconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qxconjqconj_loops},
  {"quaternion_product_qqx", "(4),(2)->(4),(4)",
    "qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqx_loops},
  {"quaternion_product_qqxconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqxconj_loops},
  {"quaternion_product_qconjqx", "(4),(2)->(4),(4)",
    "qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqx_loops},
  {"quaternion_product_qconjqxconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqxconj_loops},
  {"quaternion_product_qyq", "(2),(4)->(4),(4)",
    "qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qyq_loops},
  {"quaternion_product_qyqconj", "(2),(4)->(4),(4)",
    "qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qyqconj_loops},
  {"quaternion_product_qyconjq", "(2),(4)->(4),(4)",
    "qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qyconjq_loops},
  {"quaternion_product_qyconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qyconjqconj_loops},
  {"quaternion_product_qqy", "(4),(2)->(4),(4)",
    "qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqy_loops},
  {"quaternion_product_qqyconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqyconj_loops},
  {"quaternion_product_qconjqy", "(4),(2)->(4),(4)",
    "qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqy_loops},
  {"quaternion_product_qconjqyconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqyconj_loops},
  {"quaternion_product_qzq", "(2),(4)->(4),(4)",
    "qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qzq_loops},
  {"quaternion_product_qzqconj", "(2),(4)->(4),(4)",
    "qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qzqconj_loops},
  {"quaternion_product_qzconjq", "(2),(4)->(4),(4)",
    "qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qzconjq_loops},
  {"quaternion_product_qzconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qzconjqconj_loops},
  {"quaternion_product_qqz", "(4),(2)->(4),(4)",
    "qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqz_loops},
  {"quaternion_product_qqzconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqzconj_loops},
  {"quaternion_product_qconjqz", "(4),(2)->(4),(4)",
    "qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqz_loops},
  {"quaternion_product_qconjqzconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqzconj_loops},
  {"quaternion_product_qv", "(4),(3)->(4),(4)",
    "qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "16 mul, 20 add, 1 neg, 12 abs.\n",
   2, 2, "", quaternion_product_qv_loops},
  {"quaternion_product_qconjv", "(4),(3)->(4),(4)",
    "qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "16 mul, 20 add, 12 abs.\n",
   2, 2, "", quaternion_product_qconjv_loops},
  {"quaternion_product_vq", "(3),(4)->(4),(4)",
    "qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 20 add, 1 neg, 12 abs.\n",
   2, 2, "", quaternion_product_vq_loops},
  {"quaternion_product_vqconj", "(3),(4)->(4),(4)",
    "qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 20 add, 12 abs.\n",
   2, 2, "", quaternion_product_vqconj_loops},
  {"dot_qq", "(4),(4)->(),()",
    "q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(),().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot, dot_bound: number.\n"
    "5 mul, 7 add, 4 abs.\n",
   2, 2, "", dot_qq_loops},
  {"add_dpiToq", "(3),(4)->(4),(4)",
    "qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to\n"
    "first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.\n"
    "31 mul, 31 add, 7 abs.\n",
   2, 2, "", add_dpiToq_loops},
  {"subtract_dpiFromq", "(3),(4)->(4),(4)",
    "qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=\n"
    "qi_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.\n"
    "31 mul, 31 add, 7 abs.\n",
   2, 2, "", subtract_dpiFromq_loops},
  {"omega_to_dquaternion", "(3),(4)->(4),(4)",
    "dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the\n"
    "reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "43 mul, 40 add, 11 abs.\n",
   2, 2, "", omega_to_dquaternion_loops},
  {"quaternion_from_axis_angle", "(3),()->(4),(4)",
    "qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its\n"
    "rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(4),(4).  axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select.\n",
   2, 2, "", quaternion_from_axis_angle_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3),(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the\n"
    "angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|\n"
    "<= axis_bound unless inf or NaN.\n"
    "\n"
    "(4)->(),(3),(),(3).  q: quaternion (x, y, z, w), the scalar last; angle, angle_bound:\n"
    "number; axis, axis_bound: vector.\n"
    "201 mul, 318 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4\n"
    "copysign, 35 less, 10 equal, 69 select.\n",
   1, 4, "N", axis_angle_from_quaternion_loops},
  {"quaternion_exp", "(3)->(4),(4)",
    "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error\n"
    "of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3)->(4),(4).  v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "266 mul, 346 add, 17 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1\n"
    "equal, 24 select.\n",
   1, 2, "", quaternion_exp_loops},
  {"quaternion_log", "(4)->(3),(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.\n"
    "209 mul, 315 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4\n"
    "copysign, 35 less, 10 equal, 65 select.\n",
   1, 2, "N", quaternion_log_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
