/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

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

/* (4),(4)->(4),(4) */
INLINED void product_qq_double_over(
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
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qq_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qq_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void product_qq_single_over(
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
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqf_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_qq_loops[] = {
    product_qq_double, product_qq_single};

/* (4),(4)->(4),(4) */
INLINED void product_qconjq_double_over(
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
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qconjq_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qconjq_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjq_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjq_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qconjq_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void product_qconjq_single_over(
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
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qconjqf_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qconjq_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjq_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjq_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qconjq_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_qconjq_loops[] = {
    product_qconjq_double, product_qconjq_single};

/* (4),(4)->(4),(4) */
INLINED void product_qqconj_double_over(
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
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_double(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_double(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqconj_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_double(&qo, p2 + i * step[2], core + 2);
    store_quaternion_double(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qqconj_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qqconj_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qqconj_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qqconj_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void product_qqconj_single_over(
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
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    if (step[0] != 0) {
      load_quaternion_single(&q1, p0 + i * step[0], core + 0);
    }
    load_quaternion_single(&q2, p1 + i * step[1], core + 1);
    ksl_product_qqconjf_certified(&q1, &q2, &qo, &qo_bound);
    store_quaternion_single(&qo, p2 + i * step[2], core + 2);
    store_quaternion_single(&qo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qqconj_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qqconj_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qqconj_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qqconj_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_qqconj_loops[] = {
    product_qqconj_double, product_qqconj_single};

/* (4),(3)->(3),(3) */
INLINED void product_qv_double_over(
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
    ksl_product_qv_certified(&q, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(3),(3) */
INLINED void product_qv_single_over(
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
    ksl_product_qvf_certified(&q, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_qv_loops[] = {
    product_qv_double, product_qv_single};

/* (4),(3)->(3),(3) */
INLINED void product_qconjv_double_over(
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
    ksl_product_qconjv_certified(&q, &v, &vo, &vo_bound);
    store_vec3_double(&vo, p2 + i * step[2], core + 2);
    store_vec3_double(&vo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qconjv_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjv_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjv_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qconjv_double_over(data, n[0], step, step + 4);
}

/* (4),(3)->(3),(3) */
INLINED void product_qconjv_single_over(
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
    ksl_product_qconjvf_certified(&q, &v, &vo, &vo_bound);
    store_vec3_single(&vo, p2 + i * step[2], core + 2);
    store_vec3_single(&vo_bound, p3 + i * step[3], core + 3);
  }
}

static void product_qconjv_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_qconjv_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_qconjv_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_qconjv_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_qconjv_loops[] = {
    product_qconjv_double, product_qconjv_single};

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_scale", "(4),()->(4),(4)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "8 mul, 4 add, 4 abs.\n",
   2, 2, quaternion_scale_loops},
  {"product_qq", "(4),(4)->(4),(4)",
    "qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf\n"
    "or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, product_qq_loops},
  {"product_qconjq", "(4),(4)->(4),(4)",
    "qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, product_qconjq_loops},
  {"product_qqconj", "(4),(4)->(4),(4)",
    "qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, product_qqconj_loops},
  {"product_qv", "(4),(3)->(3),(3)",
    "vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, product_qv_loops},
  {"product_qconjv", "(4),(3)->(3),(3)",
    "vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, product_qconjv_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
