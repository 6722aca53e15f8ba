/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (4)->(4) */
INLINED void quaternion_copy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_copy(&qi, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_copy_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_copy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_copy(&qi, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_copy_loops[] = {
    quaternion_copy_double, quaternion_copy_single};

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
    ksl_quaternion_scale(&self, a);
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
    ksl_quaternionf_scale(&self, a);
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

/* (4)->(4) */
INLINED void quaternion_setIdentity_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t self;
    load_quaternion_double(&self, p0 + i * step[0], core + 0);
    ksl_quaternion_setIdentity(&self);
    store_quaternion_double(&self, p1 + i * step[1], core + 1);
  }
}

static void quaternion_setIdentity_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_setIdentity_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  quaternion_setIdentity_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_setIdentity_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t self;
    load_quaternion_single(&self, p0 + i * step[0], core + 0);
    ksl_quaternionf_setIdentity(&self);
    store_quaternion_single(&self, p1 + i * step[1], core + 1);
  }
}

static void quaternion_setIdentity_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_setIdentity_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  quaternion_setIdentity_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_setIdentity_loops[] = {
    quaternion_setIdentity_double, quaternion_setIdentity_single};

/* (4)->(4) */
INLINED void quaternion_conjugated_double_over(
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
    ksl_quaternion_conjugated(&q, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_conjugated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_conjugated_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_conjugated_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_conjugated_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_conjugated_single_over(
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
    ksl_quaternionf_conjugated(&q, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_conjugated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_conjugated_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_conjugated_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_conjugated_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_conjugated_loops[] = {
    quaternion_conjugated_double, quaternion_conjugated_single};

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
    norm = ksl_quaternion_norm(&q);
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
    norm = ksl_quaternionf_norm(&q);
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
    ksl_quaternion_normalize(&self);
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
    ksl_quaternionf_normalize(&self);
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
    ksl_quaternion_normalized(&q, &qo);
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
    ksl_quaternionf_normalized(&q, &qo);
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
    ksl_product_qq(&q1, &q2, &qo);
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
    ksl_product_qqf(&q1, &q2, &qo);
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
    ksl_product_qconjq(&q1, &q2, &qo);
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
    ksl_product_qconjqf(&q1, &q2, &qo);
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
    ksl_product_qqconj(&q1, &q2, &qo);
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
    ksl_product_qqconjf(&q1, &q2, &qo);
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
    ksl_product_qv(&q, &v, &vo);
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
    ksl_product_qvf(&q, &v, &vo);
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
    ksl_product_qconjv(&q, &v, &vo);
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
    ksl_product_qconjvf(&q, &v, &vo);
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
    ksl_mat3x3_from_quaternion(&q, &R);
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
    ksl_mat3x3f_from_quaternion(&q, &R);
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
    ksl_quaternion_from_mat3x3(&R, &qo);
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
    ksl_quaternionf_from_mat3x3(&R, &qo);
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

/* (3),()->(4) */
INLINED void quaternion_from_axis_angle_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t axis;
  load_vec3_double(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double angle;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_vec3_double(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&angle, p1 + i * step[1], core + 1);
    ksl_quaternion_from_axis_angle(&axis, angle, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 1);
  }
}

static void quaternion_from_axis_angle_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_axis_angle_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_axis_angle_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_from_axis_angle_double_over(data, n[0], step, step + 3);
}

/* (3),()->(4) */
INLINED void quaternion_from_axis_angle_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t axis;
  load_vec3_single(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float angle;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_vec3_single(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&angle, p1 + i * step[1], core + 1);
    ksl_quaternionf_from_axis_angle(&axis, angle, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 1);
  }
}

static void quaternion_from_axis_angle_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_from_axis_angle_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_from_axis_angle_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_from_axis_angle_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_from_axis_angle_loops[] = {
    quaternion_from_axis_angle_double, quaternion_from_axis_angle_single};

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
    angle = ksl_axis_angle_from_quaternion(&q, &axis);
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
    angle = ksl_axis_angle_from_quaternionf(&q, &axis);
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

/* (3)->(4) */
INLINED void quaternion_exp_double_over(
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
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_quaternion_exp(&v, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_exp_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_exp_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_exp_double_over(data, n[0], step, step + 2);
}

/* (3)->(4) */
INLINED void quaternion_exp_single_over(
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
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_quaternionf_exp(&v, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_exp_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_exp_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_exp_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_exp_loops[] = {
    quaternion_exp_double, quaternion_exp_single};

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
    ksl_quaternion_log(&q, &vo);
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
    ksl_quaternionf_log(&q, &vo);
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

/* (4),(4),()->(4) */
INLINED void quaternion_slerp_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1;
  load_quaternion_double(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2;
    double k;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    load_scalar_double(&k, p2 + i * step[2], core + 2);
    ksl_quaternion_slerp(&q1, &q2, k, &qo);
    store_quaternion_double(&qo, p3 + i * step[3], core + 2);
  }
}

static void quaternion_slerp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_slerp_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_slerp_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_slerp_double_over(data, n[0], step, step + 4);
}

/* (4),(4),()->(4) */
INLINED void quaternion_slerp_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1;
  load_quaternion_single(&q1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2;
    float k;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    load_scalar_single(&k, p2 + i * step[2], core + 2);
    ksl_quaternionf_slerp(&q1, &q2, k, &qo);
    store_quaternion_single(&qo, p3 + i * step[3], core + 2);
  }
}

static void quaternion_slerp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_slerp_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_slerp_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_slerp_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_slerp_loops[] = {
    quaternion_slerp_double, quaternion_slerp_single};

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_copy", "(4)->(4)",
    "qo = qi.\n"
    "\n"
    "(4)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "No arithmetic.  Exact.\n",
   1, 1, quaternion_copy_loops},
  {"quaternion_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, quaternion_scale_loops},
  {"quaternion_setIdentity", "(4)->(4)",
    "self = (0; 1).\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "No arithmetic.  Exact.\n",
   1, 1, quaternion_setIdentity_loops},
  {"quaternion_conjugated", "(4)->(4)",
    "qo = (-v; w), the inverse of q if |q| = 1.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "3 neg.  Exact.\n",
   1, 1, quaternion_conjugated_loops},
  {"quaternion_norm", "(4)->()",
    "|q| = sqrt(v·v + w^2).\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.\n"
    "9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.\n",
   1, 1, quaternion_norm_loops},
  {"quaternion_normalize", "(4)->(4)",
    "self = self / |self|; zero stays zero.\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, quaternion_normalize_loops},
  {"quaternion_normalized", "(4)->(4)",
    "qo = q / |q|; zero stays zero.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, quaternion_normalized_loops},
  {"product_qq", "(4),(4)->(4)",
    "qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2).\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, product_qq_loops},
  {"product_qconjq", "(4),(4)->(4)",
    "qo = q1* q2, q1* the conjugate.\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, product_qconjq_loops},
  {"product_qqconj", "(4),(4)->(4)",
    "qo = q1 q2*, q2* the conjugate.\n"
    "\n"
    "(4),(4)->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, product_qqconj_loops},
  {"product_qv", "(4),(3)->(3)",
    "vo = R(q) v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, product_qv_loops},
  {"product_qconjv", "(4),(3)->(3)",
    "vo = R(q)^T v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, product_qconjv_loops},
  {"mat3x3_from_quaternion", "(4)->(3,3)",
    "R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.\n"
    "\n"
    "(4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.\n"
    "20 mul, 16 add, 1 div.  Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511,\n"
    "in single precision 2^-45 < |q| < 2^63; searched, not proved.\n",
   1, 1, mat3x3_from_quaternion_loops},
  {"quaternion_from_mat3x3", "(3,3)->(4)",
    "qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.\n"
    "\n"
    "(3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.\n"
    "4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.  Error <= qo: 5 u of its largest\n"
    "component for R a rotation; searched, not proved.\n",
   1, 1, quaternion_from_mat3x3_loops},
  {"quaternion_from_axis_angle", "(3),()->(4)",
    "qo = (axis sin angle/2; cos angle/2); axis of length 1.\n"
    "\n"
    "(3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.\n"
    "4 mul, 1 sin, 1 cos.  Error <= qo: 3 u of its largest component for |axis| = 1; searched,\n"
    "not proved.\n",
   2, 1, quaternion_from_axis_angle_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where\n"
    "nothing turns; any multiple of a quaternion.\n"
    "\n"
    "(4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.\n"
    "12 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 20 select.  Error <=\n"
    "angle: 6 u, axis: 4 u of its largest component; searched, not proved.\n",
   1, 2, axis_angle_from_quaternion_loops},
  {"quaternion_exp", "(3)->(4)",
    "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.\n"
    "\n"
    "(3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.\n"
    "43 mul, 53 add, 2 div, 1 sqrt, 1 sin, 1 cos, 4 abs, 2 less, 6 select.  Error <= qo: (7 +\n"
    "θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5; searched, not\n"
    "proved.\n",
   1, 1, quaternion_exp_loops},
  {"quaternion_log", "(4)->(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it.\n"
    "\n"
    "(4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.\n"
    "15 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 7 abs, 15 less, 1 equal, 19 select.  Error <=\n"
    "vo: 6 u of its largest component; searched, not proved.\n",
   1, 1, quaternion_log_loops},
  {"quaternion_slerp", "(4),(4),()->(4)",
    "qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.\n"
    "\n"
    "(4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.\n"
    "85 mul, 79 add, 3 div, 2 sqrt, 1 sin, 1 cos, 1 atan2, 4 neg, 7 abs, 11 less, 1 equal, 19\n"
    "select.  Error <= qo: 12 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <=\n"
    "1; searched, not proved.\n",
   3, 1, quaternion_slerp_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
