/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "_lanes.h"
#include "../c/include/ksl/quaternion_states.h"

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

/* (),(4),(4)->(4) */
INLINED void axpy_qq_double_over(
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
    ksl_quaternion_t x;
    ksl_quaternion_t y;
    if (step[0] != 0) {
      load_scalar_double(&a, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&x, p1 + i * step[1], core + 0);
    load_quaternion_double(&y, p2 + i * step[2], core + 1);
    ksl_axpy_qq(a, &x, &y);
    store_quaternion_double(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_qq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_qq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_qq_double_over(data, n[0], step, step + 4);
}

/* (),(4),(4)->(4) */
INLINED void axpy_qq_single_over(
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
    ksl_quaternionf_t x;
    ksl_quaternionf_t y;
    if (step[0] != 0) {
      load_scalar_single(&a, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&x, p1 + i * step[1], core + 0);
    load_quaternion_single(&y, p2 + i * step[2], core + 1);
    ksl_axpy_qqf(a, &x, &y);
    store_quaternion_single(&y, p3 + i * step[3], core + 2);
  }
}

static void axpy_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axpy_qq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axpy_qq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  axpy_qq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction axpy_qq_loops[] = {
    axpy_qq_double, axpy_qq_single};

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

/* (4)->() */
INLINED void quaternion_unit_defect_double_over(
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
    double defect;
    if (step[0] != 0) {
      load_quaternion_double(&q, p0 + i * step[0], core + 0);
    }
    defect = ksl_quaternion_unit_defect(&q);
    store_scalar_double(&defect, p1 + i * step[1], core + 1);
  }
}

static void quaternion_unit_defect_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_unit_defect_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_unit_defect_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_unit_defect_double_over(data, n[0], step, step + 2);
}

/* (4)->() */
INLINED void quaternion_unit_defect_single_over(
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
    float defect;
    if (step[0] != 0) {
      load_quaternion_single(&q, p0 + i * step[0], core + 0);
    }
    defect = ksl_quaternionf_unit_defect(&q);
    store_scalar_single(&defect, p1 + i * step[1], core + 1);
  }
}

static void quaternion_unit_defect_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_unit_defect_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_unit_defect_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_unit_defect_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_unit_defect_loops[] = {
    quaternion_unit_defect_double, quaternion_unit_defect_single};

/* (4)->(4) */
INLINED void quaternion_nearest_unit_double_over(
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
    ksl_quaternion_nearest_unit(&q, &qo);
    store_quaternion_double(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_nearest_unit_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_nearest_unit_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_nearest_unit_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_nearest_unit_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void quaternion_nearest_unit_single_over(
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
    ksl_quaternionf_nearest_unit(&q, &qo);
    store_quaternion_single(&qo, p1 + i * step[1], core + 1);
  }
}

static void quaternion_nearest_unit_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_nearest_unit_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_nearest_unit_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  quaternion_nearest_unit_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction quaternion_nearest_unit_loops[] = {
    quaternion_nearest_unit_double, quaternion_nearest_unit_single};

/* (4),(3)->(3) */
INLINED void rotate_qv_double_over(
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
    ksl_rotate_qv(&q, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void rotate_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  rotate_qv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(3) */
INLINED void rotate_qv_single_over(
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
    ksl_rotate_qvf(&q, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void rotate_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  rotate_qv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction rotate_qv_loops[] = {
    rotate_qv_double, rotate_qv_single};

/* (4),(3)->(3) */
INLINED void rotate_qconjv_double_over(
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
    ksl_rotate_qconjv(&q, &v, &vo);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
  }
}

static void rotate_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  rotate_qconjv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(3) */
INLINED void rotate_qconjv_single_over(
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
    ksl_rotate_qconjvf(&q, &v, &vo);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
  }
}

static void rotate_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    rotate_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    rotate_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  rotate_qconjv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction rotate_qconjv_loops[] = {
    rotate_qconjv_double, rotate_qconjv_single};

/* (4),(4)->(4) */
INLINED void quaternion_product_qq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qq(&q1i, &q2i, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qq_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void quaternion_product_qq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qqf(&q1i, &q2i, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qq_loops[] = {
    quaternion_product_qq_double, quaternion_product_qq_single};

/* (4),(4)->(4) */
INLINED void quaternion_product_qqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqconj(&q1i, &q2i, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqconj_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void quaternion_product_qqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qqconjf(&q1i, &q2i, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqconj_loops[] = {
    quaternion_product_qqconj_double, quaternion_product_qqconj_single};

/* (4),(4)->(4) */
INLINED void quaternion_product_qconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjq(&q1i, &q2i, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjq_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void quaternion_product_qconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qconjqf(&q1i, &q2i, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjq_loops[] = {
    quaternion_product_qconjq_double, quaternion_product_qconjq_single};

/* (4),(4)->(4) */
INLINED void quaternion_product_qconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqconj(&q1i, &q2i, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqconj_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->(4) */
INLINED void quaternion_product_qconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    ksl_product_qconjqconjf(&q1i, &q2i, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqconj_loops[] = {
    quaternion_product_qconjqconj_double, quaternion_product_qconjqconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qxq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qxq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qxq_loops[] = {
    quaternion_product_qxq_double, quaternion_product_qxq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qxqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qxqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qxqconj_loops[] = {
    quaternion_product_qxqconj_double, quaternion_product_qxqconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qxconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxconjq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxconjq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qxconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxconjqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxconjq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qxconjq_loops[] = {
    quaternion_product_qxconjq_double, quaternion_product_qxconjq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qxconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qxconjqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxconjqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qxconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qxconjqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qxconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qxconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qxconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qxconjqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qxconjqconj_loops[] = {
    quaternion_product_qxconjqconj_double, quaternion_product_qxconjqconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqx(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqx_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqxf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqx_loops[] = {
    quaternion_product_qqx_double, quaternion_product_qqx_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqxconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqxconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqxconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqxconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqxconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqxconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqxconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqxconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqxconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqxconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqxconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqxconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqxconj_loops[] = {
    quaternion_product_qqxconj_double, quaternion_product_qqxconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqx(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqx_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqxf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqx_loops[] = {
    quaternion_product_qconjqx_double, quaternion_product_qconjqx_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqxconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqxconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqxconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqxconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqxconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqxconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqxconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqxconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqxconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqxconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqxconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqxconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqxconj_loops[] = {
    quaternion_product_qconjqxconj_double, quaternion_product_qconjqxconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qyq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qyq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qyq_loops[] = {
    quaternion_product_qyq_double, quaternion_product_qyq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qyqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qyqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qyqconj_loops[] = {
    quaternion_product_qyqconj_double, quaternion_product_qyqconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qyconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyconjq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyconjq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qyconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyconjqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyconjq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qyconjq_loops[] = {
    quaternion_product_qyconjq_double, quaternion_product_qyconjq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qyconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qyconjqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyconjqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qyconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qyconjqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qyconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qyconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qyconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qyconjqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qyconjqconj_loops[] = {
    quaternion_product_qyconjqconj_double, quaternion_product_qyconjqconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqy(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqy_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqy_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqy_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqyf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqy_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqy_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqy_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqy_loops[] = {
    quaternion_product_qqy_double, quaternion_product_qqy_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqyconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqyconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqyconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqyconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqyconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqyconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqyconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqyconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqyconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqyconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqyconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqyconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqyconj_loops[] = {
    quaternion_product_qqyconj_double, quaternion_product_qqyconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqy(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqy_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqy_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqy_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqyf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqy_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqy_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqy_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqy_loops[] = {
    quaternion_product_qconjqy_double, quaternion_product_qconjqy_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqyconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqyconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqyconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqyconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqyconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqyconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqyconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqyconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqyconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqyconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqyconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqyconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqyconj_loops[] = {
    quaternion_product_qconjqyconj_double, quaternion_product_qconjqyconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qzq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qzq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qzq_loops[] = {
    quaternion_product_qzq_double, quaternion_product_qzq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qzqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qzqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qzqconj_loops[] = {
    quaternion_product_qzqconj_double, quaternion_product_qzqconj_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qzconjq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzconjq(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzconjq_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qzconjq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzconjqf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzconjq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qzconjq_loops[] = {
    quaternion_product_qzconjq_double, quaternion_product_qzconjq_single};

/* (2),(4)->(4) */
INLINED void quaternion_product_qzconjqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double dci[2];
  load_dc_double(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_dc_double(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qzconjqconj(dci, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzconjqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzconjqconj_double_over(data, n[0], step, step + 3);
}

/* (2),(4)->(4) */
INLINED void quaternion_product_qzconjqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float dci[2];
  load_dc_single(dci, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_dc_single(dci, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_qzconjqconjf(dci, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qzconjqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qzconjqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qzconjqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qzconjqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qzconjqconj_loops[] = {
    quaternion_product_qzconjqconj_double, quaternion_product_qzconjqconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqz(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqz_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqzf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqz_loops[] = {
    quaternion_product_qqz_double, quaternion_product_qqz_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qqzconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qqzconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqzconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqzconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqzconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqzconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qqzconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qqzconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qqzconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qqzconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qqzconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qqzconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qqzconj_loops[] = {
    quaternion_product_qqzconj_double, quaternion_product_qqzconj_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqz(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqz_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqzf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqz_loops[] = {
    quaternion_product_qconjqz_double, quaternion_product_qconjqz_single};

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqzconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dci[2];
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_double(dci, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjqzconj(&qi, dci, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqzconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqzconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqzconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqzconj_double_over(data, n[0], step, step + 3);
}

/* (4),(2)->(4) */
INLINED void quaternion_product_qconjqzconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dci[2];
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_dc_single(dci, p1 + i * step[1], core + 1);
    ksl_product_qconjqzconjf(&qi, dci, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjqzconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjqzconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjqzconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjqzconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjqzconj_loops[] = {
    quaternion_product_qconjqzconj_double, quaternion_product_qconjqzconj_single};

/* (4),(3)->(4) */
INLINED void quaternion_product_qv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qv(&qi, &vi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(4) */
INLINED void quaternion_product_qv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 1);
    ksl_product_qvf(&qi, &vi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qv_loops[] = {
    quaternion_product_qv_double, quaternion_product_qv_single};

/* (4),(3)->(4) */
INLINED void quaternion_product_qconjv_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t qi;
  load_quaternion_double(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_quaternion_double(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&vi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_qconjv(&qi, &vi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjv_double_over(data, n[0], step, step + 3);
}

/* (4),(3)->(4) */
INLINED void quaternion_product_qconjv_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t qi;
  load_quaternion_single(&qi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_quaternion_single(&qi, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&vi, p1 + i * step[1], core + 1);
    ksl_product_qconjvf(&qi, &vi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_qconjv_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_qconjv_loops[] = {
    quaternion_product_qconjv_double, quaternion_product_qconjv_single};

/* (3),(4)->(4) */
INLINED void quaternion_product_vq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_vq(&vi, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_vq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_vq_double_over(data, n[0], step, step + 3);
}

/* (3),(4)->(4) */
INLINED void quaternion_product_vq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_vqf(&vi, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_vq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_vq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_vq_loops[] = {
    quaternion_product_vq_double, quaternion_product_vq_single};

/* (3),(4)->(4) */
INLINED void quaternion_product_vqconj_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t vi;
  load_vec3_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    if (step[0] != 0) {
      load_vec3_double(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_quaternion_product_vqconj(&vi, &qi, &qo);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_vqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vqconj_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vqconj_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_vqconj_double_over(data, n[0], step, step + 3);
}

/* (3),(4)->(4) */
INLINED void quaternion_product_vqconj_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t vi;
  load_vec3_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    if (step[0] != 0) {
      load_vec3_single(&vi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_product_vqconjf(&vi, &qi, &qo);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
  }
}

static void quaternion_product_vqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_product_vqconj_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_product_vqconj_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  quaternion_product_vqconj_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction quaternion_product_vqconj_loops[] = {
    quaternion_product_vqconj_double, quaternion_product_vqconj_single};

/* (4),(4)->() */
INLINED void dot_qq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternion_t q1i;
  load_quaternion_double(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t q2i;
    double dot;
    if (step[0] != 0) {
      load_quaternion_double(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2i, p1 + i * step[1], core + 1);
    dot = ksl_dot_qq(&q1i, &q2i);
    store_scalar_double(&dot, p2 + i * step[2], core + 2);
  }
}

static void dot_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_qq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_qq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_qq_double_over(data, n[0], step, step + 3);
}

/* (4),(4)->() */
INLINED void dot_qq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_quaternionf_t q1i;
  load_quaternion_single(&q1i, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t q2i;
    float dot;
    if (step[0] != 0) {
      load_quaternion_single(&q1i, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2i, p1 + i * step[1], core + 1);
    dot = ksl_dot_qqf(&q1i, &q2i);
    store_scalar_single(&dot, p2 + i * step[2], core + 2);
  }
}

static void dot_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    dot_qq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    dot_qq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  dot_qq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction dot_qq_loops[] = {
    dot_qq_double, dot_qq_single};

/* (3),(4)->(4) */
INLINED void add_dpiToq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t dpi;
  load_vec3_double(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    if (step[0] != 0) {
      load_vec3_double(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_add_dpiToq(&dpi, &qi);
    store_quaternion_double(&qi, p2 + i * step[2], core + 2);
  }
}

static void add_dpiToq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_dpiToq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_dpiToq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_dpiToq_double_over(data, n[0], step, step + 3);
}

/* (3),(4)->(4) */
INLINED void add_dpiToq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t dpi;
  load_vec3_single(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    if (step[0] != 0) {
      load_vec3_single(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_add_dpiToqf(&dpi, &qi);
    store_quaternion_single(&qi, p2 + i * step[2], core + 2);
  }
}

static void add_dpiToq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_dpiToq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_dpiToq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_dpiToq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_dpiToq_loops[] = {
    add_dpiToq_double, add_dpiToq_single};

/* (3),(4)->(4) */
INLINED void subtract_dpiFromq_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t dpi;
  load_vec3_double(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    if (step[0] != 0) {
      load_vec3_double(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_subtract_dpiFromq(&dpi, &qi);
    store_quaternion_double(&qi, p2 + i * step[2], core + 2);
  }
}

static void subtract_dpiFromq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_dpiFromq_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_dpiFromq_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_dpiFromq_double_over(data, n[0], step, step + 3);
}

/* (3),(4)->(4) */
INLINED void subtract_dpiFromq_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t dpi;
  load_vec3_single(&dpi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    if (step[0] != 0) {
      load_vec3_single(&dpi, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_subtract_dpiFromqf(&dpi, &qi);
    store_quaternion_single(&qi, p2 + i * step[2], core + 2);
  }
}

static void subtract_dpiFromq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_dpiFromq_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_dpiFromq_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_dpiFromq_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction subtract_dpiFromq_loops[] = {
    subtract_dpiFromq_double, subtract_dpiFromq_single};

/* (3),(4)->(4) */
INLINED void omega_to_dquaternion_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t w;
  load_vec3_double(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternion_t qi;
    ksl_quaternion_t dqo;
    if (step[0] != 0) {
      load_vec3_double(&w, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&qi, p1 + i * step[1], core + 1);
    ksl_omega_to_dquaternion(&w, &qi, &dqo);
    store_quaternion_double(&dqo, p2 + i * step[2], core + 2);
  }
}

static void omega_to_dquaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    omega_to_dquaternion_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    omega_to_dquaternion_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  omega_to_dquaternion_double_over(data, n[0], step, step + 3);
}

/* (3),(4)->(4) */
INLINED void omega_to_dquaternion_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t w;
  load_vec3_single(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t dqo;
    if (step[0] != 0) {
      load_vec3_single(&w, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&qi, p1 + i * step[1], core + 1);
    ksl_omega_to_dquaternionf(&w, &qi, &dqo);
    store_quaternion_single(&dqo, p2 + i * step[2], core + 2);
  }
}

static void omega_to_dquaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    omega_to_dquaternion_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    omega_to_dquaternion_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  omega_to_dquaternion_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction omega_to_dquaternion_loops[] = {
    omega_to_dquaternion_double, omega_to_dquaternion_single};

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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_from_axis_angle_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_from_axis_angle_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_from_axis_angle_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states axis[3];
  ksl_states angle[1];
  ksl_states qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(axis, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_scalar_double(angle, data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      load_lanes_vec3_double(axis, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_double(angle, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_quaternion_from_axis_angle_states(axis, angle, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_quaternion_double(qo[g], data[2] + j * step[2], step[2], core + 1, KSL_LANES);
    } else {
      store_lanes_quaternion_double(qo[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_from_axis_angle_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!quaternion_from_axis_angle_double_on_vectors(data, i, m, step, core, raised)) {
      quaternion_from_axis_angle_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_from_axis_angle_double_from(data, i, n - i, step, core);
}
#endif

static void quaternion_from_axis_angle_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_from_axis_angle_double_many(data, n[0], step, step + 3);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_from_axis_angle_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_from_axis_angle_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_from_axis_angle_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf axis[3];
  ksl_statesf angle[1];
  ksl_statesf qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(axis, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_scalar_single(angle, data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      load_lanes_vec3_single(axis, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_single(angle, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_quaternionf_from_axis_angle_states(axis, angle, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_quaternion_single(qo[g], data[2] + j * step[2], step[2], core + 1, KSL_LANESF);
    } else {
      store_lanes_quaternion_single(qo[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_from_axis_angle_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!quaternion_from_axis_angle_single_on_vectors(data, i, m, step, core, raised)) {
      quaternion_from_axis_angle_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_from_axis_angle_single_from(data, i, n - i, step, core);
}
#endif

static void quaternion_from_axis_angle_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_from_axis_angle_single_many(data, n[0], step, step + 3);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void axis_angle_from_quaternion_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  axis_angle_from_quaternion_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int axis_angle_from_quaternion_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states q[4];
  ksl_states angle[64][1];
  ksl_states axis[64][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_quaternion_double(q, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_quaternion_double(q, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_axis_angle_from_quaternion_states(q, angle[g], axis[g]);
  }
  COMPUTED(angle);
  COMPUTED(axis);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(angle[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
      store_lanes_vec3_double(axis[g], data[2] + j * step[2], step[2], core + 1, KSL_LANES);
    } else {
      store_lanes_scalar_double(angle[g], data[1] + j * step[1], step[1], core + 1, left);
      store_lanes_vec3_double(axis[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void axis_angle_from_quaternion_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!axis_angle_from_quaternion_double_on_vectors(data, i, m, step, core, raised)) {
      axis_angle_from_quaternion_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  axis_angle_from_quaternion_double_from(data, i, n - i, step, core);
}
#endif

static void axis_angle_from_quaternion_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    axis_angle_from_quaternion_double_many(data, n[0], step, step + 3);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void axis_angle_from_quaternion_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  axis_angle_from_quaternion_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int axis_angle_from_quaternion_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf q[4];
  ksl_statesf angle[64][1];
  ksl_statesf axis[64][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_quaternion_single(q, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_quaternion_single(q, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_axis_angle_from_quaternionf_states(q, angle[g], axis[g]);
  }
  COMPUTED(angle);
  COMPUTED(axis);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(angle[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
      store_lanes_vec3_single(axis[g], data[2] + j * step[2], step[2], core + 1, KSL_LANESF);
    } else {
      store_lanes_scalar_single(angle[g], data[1] + j * step[1], step[1], core + 1, left);
      store_lanes_vec3_single(axis[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void axis_angle_from_quaternion_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!axis_angle_from_quaternion_single_on_vectors(data, i, m, step, core, raised)) {
      axis_angle_from_quaternion_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  axis_angle_from_quaternion_single_from(data, i, n - i, step, core);
}
#endif

static void axis_angle_from_quaternion_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    axis_angle_from_quaternion_single_many(data, n[0], step, step + 3);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_exp_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_exp_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_exp_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_quaternion_exp_states(v, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_quaternion_double(qo[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_quaternion_double(qo[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_exp_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!quaternion_exp_double_on_vectors(data, i, m, step, core, raised)) {
      quaternion_exp_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_exp_double_from(data, i, n - i, step, core);
}
#endif

static void quaternion_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_exp_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_exp_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_exp_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_exp_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_quaternionf_exp_states(v, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_quaternion_single(qo[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_quaternion_single(qo[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_exp_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!quaternion_exp_single_on_vectors(data, i, m, step, core, raised)) {
      quaternion_exp_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_exp_single_from(data, i, n - i, step, core);
}
#endif

static void quaternion_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_exp_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_log_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_log_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_log_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states q[4];
  ksl_states vo[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_quaternion_double(q, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_quaternion_double(q, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_quaternion_log_states(q, vo[g]);
  }
  COMPUTED(vo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_vec3_double(vo[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_vec3_double(vo[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_log_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 85 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!quaternion_log_double_on_vectors(data, i, m, step, core, raised)) {
      quaternion_log_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_log_double_from(data, i, n - i, step, core);
}
#endif

static void quaternion_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_log_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_log_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_log_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_log_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf q[4];
  ksl_statesf vo[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_quaternion_single(q, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_quaternion_single(q, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_quaternionf_log_states(q, vo[g]);
  }
  COMPUTED(vo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_vec3_single(vo[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_vec3_single(vo[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void quaternion_log_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 85 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!quaternion_log_single_on_vectors(data, i, m, step, core, raised)) {
      quaternion_log_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_log_single_from(data, i, n - i, step, core);
}
#endif

static void quaternion_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_log_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
INLINED void quaternion_interpolated_double_over(
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
    ksl_quaternion_interpolated(&q1, &q2, k, &qo);
    store_quaternion_double(&qo, p3 + i * step[3], core + 2);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_interpolated_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[4];
  for (int k = 0; k < 4; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_interpolated_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_interpolated_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states q1[4];
  ksl_states q2[4];
  ksl_states k[1];
  ksl_states qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_quaternion_double(q1, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_quaternion_double(q2, data[1] + j * step[1], step[1], core + 1, KSL_LANES);
      load_lanes_scalar_double(k, data[2] + j * step[2], step[2], core + 2, KSL_LANES);
    } else {
      load_lanes_quaternion_double(q1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_quaternion_double(q2, data[1] + j * step[1], step[1], core + 1, left);
      load_lanes_scalar_double(k, data[2] + j * step[2], step[2], core + 2, left);
    }
    ksl_quaternion_interpolated_states(q1, q2, k, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_quaternion_double(qo[g], data[3] + j * step[3], step[3], core + 2, KSL_LANES);
    } else {
      store_lanes_quaternion_double(qo[g], data[3] + j * step[3], step[3], core + 2, left);
    }
  }
  return 1;
}

static APART void quaternion_interpolated_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!quaternion_interpolated_double_on_vectors(data, i, m, step, core, raised)) {
      quaternion_interpolated_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_interpolated_double_from(data, i, n - i, step, core);
}
#endif

static void quaternion_interpolated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_interpolated_double_many(data, n[0], step, step + 4);
    return;
  }
#endif
  static const npy_intp dense_1[] = { 32, 32, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_interpolated_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_interpolated_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_interpolated_double_over(data, n[0], step, step + 4);
}

/* (4),(4),()->(4) */
INLINED void quaternion_interpolated_single_over(
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
    ksl_quaternionf_interpolated(&q1, &q2, k, &qo);
    store_quaternion_single(&qo, p3 + i * step[3], core + 2);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void quaternion_interpolated_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[4];
  for (int k = 0; k < 4; k++) {
    from[k] = data[k] + i * step[k];
  }
  quaternion_interpolated_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int quaternion_interpolated_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf q1[4];
  ksl_statesf q2[4];
  ksl_statesf k[1];
  ksl_statesf qo[64][4];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_quaternion_single(q1, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_quaternion_single(q2, data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
      load_lanes_scalar_single(k, data[2] + j * step[2], step[2], core + 2, KSL_LANESF);
    } else {
      load_lanes_quaternion_single(q1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_quaternion_single(q2, data[1] + j * step[1], step[1], core + 1, left);
      load_lanes_scalar_single(k, data[2] + j * step[2], step[2], core + 2, left);
    }
    ksl_quaternionf_interpolated_states(q1, q2, k, qo[g]);
  }
  COMPUTED(qo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_quaternion_single(qo[g], data[3] + j * step[3], step[3], core + 2, KSL_LANESF);
    } else {
      store_lanes_quaternion_single(qo[g], data[3] + j * step[3], step[3], core + 2, left);
    }
  }
  return 1;
}

static APART void quaternion_interpolated_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 64 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!quaternion_interpolated_single_on_vectors(data, i, m, step, core, raised)) {
      quaternion_interpolated_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  quaternion_interpolated_single_from(data, i, n - i, step, core);
}
#endif

static void quaternion_interpolated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    quaternion_interpolated_single_many(data, n[0], step, step + 4);
    return;
  }
#endif
  static const npy_intp dense_1[] = { 16, 16, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    quaternion_interpolated_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    quaternion_interpolated_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  quaternion_interpolated_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction quaternion_interpolated_loops[] = {
    quaternion_interpolated_double, quaternion_interpolated_single};

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_copy", "(4)->(4)",
    "qo = qi.\n"
    "\n"
    "(4)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", quaternion_copy_loops},
  {"quaternion_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", quaternion_scale_loops},
  {"axpy_qq", "(),(4),(4)->(4)",
    "y = a x + y.\n"
    "\n"
    "(),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.\n"
    "4 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_qq_loops},
  {"quaternion_setIdentity", "(4)->(4)",
    "self = (0; 1).\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", quaternion_setIdentity_loops},
  {"quaternion_conjugated", "(4)->(4)",
    "qo = (-v; w), the inverse of q if |q| = 1.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "3 neg.  Exact.\n",
   1, 1, "", quaternion_conjugated_loops},
  {"quaternion_norm", "(4)->()",
    "|q| = sqrt(v·v + w^2).\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.\n"
    "9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.\n",
   1, 1, "", quaternion_norm_loops},
  {"quaternion_normalize", "(4)->(4)",
    "self = self / |self|; zero stays zero.\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", quaternion_normalize_loops},
  {"quaternion_normalized", "(4)->(4)",
    "qo = q / |q|; zero stays zero.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", quaternion_normalized_loops},
  {"quaternion_unit_defect", "(4)->()",
    "|q| - 1: 0 for a unit quaternion, negative for a shorter one.\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.\n"
    "9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select.\n",
   1, 1, "", quaternion_unit_defect_loops},
  {"quaternion_nearest_unit", "(4)->(4)",
    "qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select.\n",
   1, 1, "N", quaternion_nearest_unit_loops},
  {"rotate_qv", "(4),(3)->(3)",
    "vo = R(q) v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "U.", rotate_qv_loops},
  {"rotate_qconjv", "(4),(3)->(3)",
    "vo = R(q)^T v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "U.", rotate_qconjv_loops},
  {"quaternion_product_qq", "(4),(4)->(4)",
    "qo = q1i q2i.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qq_loops},
  {"quaternion_product_qqconj", "(4),(4)->(4)",
    "qo = q1i q2i*.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqconj_loops},
  {"quaternion_product_qconjq", "(4),(4)->(4)",
    "qo = q1i* q2i.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjq_loops},
  {"quaternion_product_qconjqconj", "(4),(4)->(4)",
    "qo = q1i* q2i*.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqconj_loops},
  {"quaternion_product_qxq", "(2),(4)->(4)",
    "qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxq_loops},
  {"quaternion_product_qxqconj", "(2),(4)->(4)",
    "qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxqconj_loops},
  {"quaternion_product_qxconjq", "(2),(4)->(4)",
    "qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxconjq_loops},
  {"quaternion_product_qxconjqconj", "(2),(4)->(4)",
    "qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxconjqconj_loops},
  {"quaternion_product_qqx", "(4),(2)->(4)",
    "qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqx_loops},
  {"quaternion_product_qqxconj", "(4),(2)->(4)",
    "qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqxconj_loops},
  {"quaternion_product_qconjqx", "(4),(2)->(4)",
    "qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqx_loops},
  {"quaternion_product_qconjqxconj", "(4),(2)->(4)",
    "qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqxconj_loops},
  {"quaternion_product_qyq", "(2),(4)->(4)",
    "qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyq_loops},
  {"quaternion_product_qyqconj", "(2),(4)->(4)",
    "qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyqconj_loops},
  {"quaternion_product_qyconjq", "(2),(4)->(4)",
    "qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyconjq_loops},
  {"quaternion_product_qyconjqconj", "(2),(4)->(4)",
    "qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyconjqconj_loops},
  {"quaternion_product_qqy", "(4),(2)->(4)",
    "qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqy_loops},
  {"quaternion_product_qqyconj", "(4),(2)->(4)",
    "qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqyconj_loops},
  {"quaternion_product_qconjqy", "(4),(2)->(4)",
    "qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqy_loops},
  {"quaternion_product_qconjqyconj", "(4),(2)->(4)",
    "qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqyconj_loops},
  {"quaternion_product_qzq", "(2),(4)->(4)",
    "qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzq_loops},
  {"quaternion_product_qzqconj", "(2),(4)->(4)",
    "qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzqconj_loops},
  {"quaternion_product_qzconjq", "(2),(4)->(4)",
    "qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzconjq_loops},
  {"quaternion_product_qzconjqconj", "(2),(4)->(4)",
    "qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzconjqconj_loops},
  {"quaternion_product_qqz", "(4),(2)->(4)",
    "qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqz_loops},
  {"quaternion_product_qqzconj", "(4),(2)->(4)",
    "qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqzconj_loops},
  {"quaternion_product_qconjqz", "(4),(2)->(4)",
    "qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqz_loops},
  {"quaternion_product_qconjqzconj", "(4),(2)->(4)",
    "qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqzconj_loops},
  {"quaternion_product_qv", "(4),(3)->(4)",
    "qo = qi (vi; 0).\n"
    "\n"
    "(4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qv_loops},
  {"quaternion_product_qconjv", "(4),(3)->(4)",
    "qo = qi* (vi; 0).\n"
    "\n"
    "(4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjv_loops},
  {"quaternion_product_vq", "(3),(4)->(4)",
    "qo = (vi; 0) qi.\n"
    "\n"
    "(3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_vq_loops},
  {"quaternion_product_vqconj", "(3),(4)->(4)",
    "qo = (vi; 0) qi*.\n"
    "\n"
    "(3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_vqconj_loops},
  {"dot_qq", "(4),(4)->()",
    "q1i·q2i.\n"
    "\n"
    "(4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.\n"
    "4 mul, 3 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", dot_qq_loops},
  {"add_dpiToq", "(3),(4)->(4)",
    "qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to\n"
    "first order; not normalized.\n"
    "\n"
    "(3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.\n"
    "15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", add_dpiToq_loops},
  {"subtract_dpiFromq", "(3),(4)->(4)",
    "qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.\n"
    "\n"
    "(3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.\n"
    "15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", subtract_dpiFromq_loops},
  {"omega_to_dquaternion", "(3),(4)->(4)",
    "dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the\n"
    "reference frame, rad/s, and a term that draws its norm to 1.\n"
    "\n"
    "(3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.\n"
    "23 mul, 16 add.  Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", omega_to_dquaternion_loops},
  {"mat3x3_from_quaternion", "(4)->(3,3)",
    "R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.\n"
    "\n"
    "(4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.\n"
    "20 mul, 16 add, 1 div.  Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511,\n"
    "in single precision 2^-45 < |q| < 2^63; searched, not proved.\n",
   1, 1, "N", mat3x3_from_quaternion_loops},
  {"quaternion_from_mat3x3", "(3,3)->(4)",
    "qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.\n"
    "\n"
    "(3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.\n"
    "4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.  Error <= qo: 6 u of its largest\n"
    "component for R a rotation; searched, not proved.\n",
   1, 1, "R", quaternion_from_mat3x3_loops},
  {"quaternion_from_axis_angle", "(3),()->(4)",
    "qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its\n"
    "rotation is by another angle.\n"
    "\n"
    "(3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.\n"
    "32 mul, 33 add, 1 abs.  Error <= qo: 3 u of its largest component for |axis| = 1; searched,\n"
    "not proved.\n",
   2, 1, "", quaternion_from_axis_angle_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the\n"
    "angle is 0; any multiple of a quaternion.\n"
    "\n"
    "(4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.\n"
    "41 mul, 37 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.  Error\n"
    "<= angle: 6 u, axis: 4 u of its largest component; searched, not proved.\n",
   1, 2, "N", axis_angle_from_quaternion_loops},
  {"quaternion_exp", "(3)->(4)",
    "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.\n"
    "\n"
    "(3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.\n"
    "71 mul, 86 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.  Error <= qo: (7 + θ/200) u of its\n"
    "largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.\n",
   1, 1, "", quaternion_exp_loops},
  {"quaternion_log", "(4)->(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it.\n"
    "\n"
    "(4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.\n"
    "44 mul, 37 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.  Error\n"
    "<= vo: 6 u of its largest component; searched, not proved.\n",
   1, 1, "N", quaternion_log_loops},
  {"quaternion_interpolated", "(4),(4),()->(4)",
    "qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.\n"
    "\n"
    "(4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.\n"
    "142 mul, 147 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.\n"
    "Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;\n"
    "searched, not proved.\n",
   3, 1, "UU.", quaternion_interpolated_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
