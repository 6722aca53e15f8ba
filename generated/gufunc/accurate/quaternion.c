/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (4),()->(4) */
INLINED void quaternion_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t self;
    double a;
    load_quaternion_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_quaternion_scale_accurate(&self, a);
    store_quaternion_double(&self, p2 + i * step[2], core + 1);
  }
}

static void quaternion_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  quaternion_scale_double_over(data, n[0], step, step + 3);
}

/* (4),()->(4) */
INLINED void quaternion_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t self;
    float a;
    load_quaternion_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_quaternionf_scale_accurate(&self, a);
    store_quaternion_single(&self, p2 + i * step[2], core + 1);
  }
}

static void quaternion_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  quaternion_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_scale_loops[] = {
    quaternion_scale_double, quaternion_scale_single};

/* (4)->() */
INLINED void quaternion_norm_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double norm;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    norm = ksl_quaternion_norm_accurate(&q);
    store_scalar_double(&norm, p1 + i * step[1], core + 1);
  }
}

static void quaternion_norm_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_norm_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_norm_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_norm_double_over(data, n[0], step, step + 2);
}

/* (4)->() */
INLINED void quaternion_norm_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float norm;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    norm = ksl_quaternionf_norm_accurate(&q);
    store_scalar_single(&norm, p1 + i * step[1], core + 1);
  }
}

static void quaternion_norm_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_norm_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_norm_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_norm_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_norm_loops[] = {
    quaternion_norm_double, quaternion_norm_single};

/* (4)->(4) */
INLINED void quaternion_normalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t self;
    load_quaternion_double(&self, p0 + i * step[0], core + 0);
    ksl_quaternion_normalize_accurate(&self);
    store_quaternion_double(&self, p1 + i * step[1], core + 1);
  }
}

static void quaternion_normalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_normalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  quaternion_normalize_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_normalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t self;
    load_quaternion_single(&self, p0 + i * step[0], core + 0);
    ksl_quaternionf_normalize_accurate(&self);
    store_quaternion_single(&self, p1 + i * step[1], core + 1);
  }
}

static void quaternion_normalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_normalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  quaternion_normalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_normalize_loops[] = {
    quaternion_normalize_double, quaternion_normalize_single};

/* (4)->(4) */
INLINED void quaternion_normalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_normalized_accurate(&q, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_normalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_normalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_normalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_normalized_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_normalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_normalized_accurate(&q, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_normalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_normalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_normalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_normalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_normalized_loops[] = {
    quaternion_normalized_double, quaternion_normalized_single};

/* (4),(4)->(4) */
INLINED void product_qq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1;
  load_quaternion_double(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qq_accurate(&q1, &q2, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qq_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void product_qq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1;
  load_quaternion_single(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqf_accurate(&q1, &q2, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_qq_loops[] = {
    product_qq_double, product_qq_single};

/* (4),(4)->(4) */
INLINED void product_qconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1;
  load_quaternion_double(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qconjq_accurate(&q1, &q2, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qconjq_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void product_qconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1;
  load_quaternion_single(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qconjqf_accurate(&q1, &q2, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qconjq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_qconjq_loops[] = {
    product_qconjq_double, product_qconjq_single};

/* (4),(4)->(4) */
INLINED void product_qqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1;
  load_quaternion_double(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqconj_accurate(&q1, &q2, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qqconj_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void product_qqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1;
  load_quaternion_single(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqconjf_accurate(&q1, &q2, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void product_qqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_qqconj_loops[] = {
    product_qqconj_double, product_qqconj_single};

/* (4),(3)->(3) */
INLINED void product_qv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 1);
    ksl_product_qv_accurate(&q, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void product_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(3) */
INLINED void product_qv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 1);
    ksl_product_qvf_accurate(&q, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void product_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_qv_loops[] = {
    product_qv_double, product_qv_single};

/* (4),(3)->(3) */
INLINED void product_qconjv_double_over(
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
    ksl_vec3_t v;
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&v, p1 + i * step[1], core + 1);
    ksl_product_qconjv_accurate(&q, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void product_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qconjv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(3) */
INLINED void product_qconjv_single_over(
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
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&v, p1 + i * step[1], core + 1);
    ksl_product_qconjvf_accurate(&q, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void product_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_qconjv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_qconjv_loops[] = {
    product_qconjv_double, product_qconjv_single};

/* (4)->(3,3) */
INLINED void mat3x3_from_quaternion_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_from_quaternion_accurate(&q, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void mat3x3_from_quaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_quaternion_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_quaternion_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_from_quaternion_double_over(data, n[0], step, step + 2);
}

/* (4)->(3,3) */
INLINED void mat3x3_from_quaternion_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_from_quaternion_accurate(&q, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void mat3x3_from_quaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_quaternion_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_quaternion_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_from_quaternion_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_from_quaternion_loops[] = {
    mat3x3_from_quaternion_double, mat3x3_from_quaternion_single};

/* (3,3)->(4) */
INLINED void quaternion_from_mat3x3_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_from_mat3x3_accurate(&R, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 2);
  }
}

static void quaternion_from_mat3x3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 32, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_mat3x3_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_mat3x3_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_from_mat3x3_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(4) */
INLINED void quaternion_from_mat3x3_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_from_mat3x3_accurate(&R, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 2);
  }
}

static void quaternion_from_mat3x3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 16, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_mat3x3_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_mat3x3_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_from_mat3x3_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_from_mat3x3_loops[] = {
    quaternion_from_mat3x3_double, quaternion_from_mat3x3_single};

/* (4)->(),(3) */
INLINED void axis_angle_from_quaternion_double_over(
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
    double angle;
    ksl_vec3_t axis;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_quaternion_accurate(&q, &axis);
    store_scalar_double(&angle, p1 + i * step[1], core + 1);
    store_vec3_double(&axis, p2 + i * step[2], core + 1);
  }
}

static void axis_angle_from_quaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_quaternion_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_quaternion_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  axis_angle_from_quaternion_double_over(data, n[0], step, step + 3);
}

/* (4)->(),(3) */
INLINED void axis_angle_from_quaternion_single_over(
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
    float angle;
    ksl_vec3f_t axis;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_quaternionf_accurate(&q, &axis);
    store_scalar_single(&angle, p1 + i * step[1], core + 1);
    store_vec3_single(&axis, p2 + i * step[2], core + 1);
  }
}

static void axis_angle_from_quaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_quaternion_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_quaternion_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  axis_angle_from_quaternion_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction axis_angle_from_quaternion_loops[] = {
    axis_angle_from_quaternion_double, axis_angle_from_quaternion_single};

/* (4)->(3) */
INLINED void quaternion_log_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q;
  load_quaternion_double(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_log_accurate(&q, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_log_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_log_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_log_double_over(data, n[0], step, step + 2);
}

/* (4)->(3) */
INLINED void quaternion_log_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q;
  load_quaternion_single(&q, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_log_accurate(&q, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_log_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_log_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_log_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_log_loops[] = {
    quaternion_log_double, quaternion_log_single};

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, quaternion_scale_loops},
  {"quaternion_norm", "(4)->()",
    "|q| = sqrt(v·v + w^2).\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.\n"
    "12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 3 equal, 12\n"
    "select.\n",
   1, 1, quaternion_norm_loops},
  {"quaternion_normalize", "(4)->(4)",
    "self = self / |self|; zero stays zero.\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 10 equal, 19\n"
    "select.\n",
   1, 1, quaternion_normalize_loops},
  {"quaternion_normalized", "(4)->(4)",
    "qo = q / |q|; zero stays zero.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 10 equal, 19\n"
    "select.\n",
   1, 1, quaternion_normalized_loops},
  {"product_qq", "(4),(4)->(4)",
    "qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, product_qq_loops},
  {"product_qconjq", "(4),(4)->(4)",
    "qo = q1* q2, q1* the conjugate.\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, product_qconjq_loops},
  {"product_qqconj", "(4),(4)->(4)",
    "qo = q1 q2*, q2* the conjugate.\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, product_qqconj_loops},
  {"product_qv", "(4),(3)->(3)",
    "vo = R(q) v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, product_qv_loops},
  {"product_qconjv", "(4),(3)->(3)",
    "vo = R(q)^T v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, product_qconjv_loops},
  {"mat3x3_from_quaternion", "(4)->(3,3)",
    "R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.\n"
    "\n"
    "(4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.\n"
    "41 mul, 116 add, 10 product error, 24 product rest, 2 div, 9 equal, 9 select.  Error <= R: 8\n"
    "u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 < |q| < 2^63;\n"
    "searched, not proved.\n",
   1, 1, mat3x3_from_quaternion_loops},
  {"quaternion_from_mat3x3", "(3,3)->(4)",
    "qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.\n"
    "\n"
    "(3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.\n"
    "21 mul, 182 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37\n"
    "select.  Error <= qo: 5 u of its largest component for R a rotation; searched, not proved.\n",
   1, 1, quaternion_from_mat3x3_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where\n"
    "nothing turns; any multiple of a quaternion.\n"
    "\n"
    "(4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.\n"
    "27 mul, 55 add, 4 product error, 3 product rest, 11 div, 1 sqrt, 1 atan2, 4 neg, 9 abs, 16\n"
    "less, 8 equal, 31 select.  Error <= angle: 6 u, axis: 4 u of its largest component;\n"
    "searched, not proved.\n",
   1, 2, axis_angle_from_quaternion_loops},
  {"quaternion_log", "(4)->(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it.\n"
    "\n"
    "(4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.\n"
    "29 mul, 58 add, 5 product error, 3 product rest, 7 div, 1 sqrt, 1 atan2, 4 neg, 9 abs, 16\n"
    "less, 7 equal, 28 select.  Error <= vo: 6 u of its largest component; searched, not proved.\n",
   1, 1, quaternion_log_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
