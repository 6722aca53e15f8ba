/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec4 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (4)->(4) */
INLINED void vec4_copy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t vi;
  load_vec4_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t vo;
    if (step[0] != 0) {
      load_vec4_double(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec4_copy(&vi, &vo);
    store_vec4_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_copy_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void vec4_copy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t vi;
  load_vec4_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t vo;
    if (step[0] != 0) {
      load_vec4_single(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec4f_copy(&vi, &vo);
    store_vec4_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_copy_loops[] = {
    vec4_copy_double, vec4_copy_single};

/* (4),()->(4) */
INLINED void vec4_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t self;
    double a;
    load_vec4_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_vec4_scale(&self, a);
    store_vec4_double(&self, p2 + i * step[2], core + 1);
  }
}

static void vec4_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  vec4_scale_double_over(data, n[0], step, step + 3);
}

/* (4),()->(4) */
INLINED void vec4_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t self;
    float a;
    load_vec4_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_vec4f_scale(&self, a);
    store_vec4_single(&self, p2 + i * step[2], core + 1);
  }
}

static void vec4_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  vec4_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction vec4_scale_loops[] = {
    vec4_scale_double, vec4_scale_single};

/* (4)->(4) */
INLINED void vec4_inverted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t vi;
  load_vec4_double(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t vo;
    if (step[0] != 0) {
      load_vec4_double(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec4_inverted(&vi, &vo);
    store_vec4_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_inverted_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_inverted_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_inverted_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void vec4_inverted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t vi;
  load_vec4_single(&vi, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t vo;
    if (step[0] != 0) {
      load_vec4_single(&vi, p0 + i * step[0], core + 0);
    }
    ksl_vec4f_inverted(&vi, &vo);
    store_vec4_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_inverted_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_inverted_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_inverted_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_inverted_loops[] = {
    vec4_inverted_double, vec4_inverted_single};

/* (4)->(4) */
INLINED void vec4_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t self;
    load_vec4_double(&self, p0 + i * step[0], core + 0);
    ksl_vec4_invert(&self);
    store_vec4_double(&self, p1 + i * step[1], core + 1);
  }
}

static void vec4_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_invert_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec4_invert_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void vec4_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t self;
    load_vec4_single(&self, p0 + i * step[0], core + 0);
    ksl_vec4f_invert(&self);
    store_vec4_single(&self, p1 + i * step[1], core + 1);
  }
}

static void vec4_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_invert_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec4_invert_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_invert_loops[] = {
    vec4_invert_double, vec4_invert_single};

/* (4),()->(4) */
INLINED void vec4_scaled_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t v;
  load_vec4_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec4_t vo;
    if (step[0] != 0) {
      load_vec4_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_vec4_scaled(&v, k, &vo);
    store_vec4_double(&vo, p2 + i * step[2], core + 1);
  }
}

static void vec4_scaled_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scaled_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_scaled_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  vec4_scaled_double_over(data, n[0], step, step + 3);
}

/* (4),()->(4) */
INLINED void vec4_scaled_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t v;
  load_vec4_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec4f_t vo;
    if (step[0] != 0) {
      load_vec4_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_vec4f_scaled(&v, k, &vo);
    store_vec4_single(&vo, p2 + i * step[2], core + 1);
  }
}

static void vec4_scaled_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scaled_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_scaled_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  vec4_scaled_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction vec4_scaled_loops[] = {
    vec4_scaled_double, vec4_scaled_single};

/* (4),(4)->(4),(4) */
INLINED void vec4_swap_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t v1;
    ksl_vec4_t v2;
    load_vec4_double(&v1, p0 + i * step[0], core + 0);
    load_vec4_double(&v2, p1 + i * step[1], core + 1);
    ksl_vec4_swap(&v1, &v2);
    store_vec4_double(&v1, p2 + i * step[2], core + 2);
    store_vec4_double(&v2, p3 + i * step[3], core + 3);
  }
}

static void vec4_swap_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 32, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_swap_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec4_swap_double_over(data, n[0], step, step + 4);
}

/* (4),(4)->(4),(4) */
INLINED void vec4_swap_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t v1;
    ksl_vec4f_t v2;
    load_vec4_single(&v1, p0 + i * step[0], core + 0);
    load_vec4_single(&v2, p1 + i * step[1], core + 1);
    ksl_vec4f_swap(&v1, &v2);
    store_vec4_single(&v1, p2 + i * step[2], core + 2);
    store_vec4_single(&v2, p3 + i * step[3], core + 3);
  }
}

static void vec4_swap_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 16, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_swap_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec4_swap_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec4_swap_loops[] = {
    vec4_swap_double, vec4_swap_single};

/* (4)->() */
INLINED void vec4_l2norm_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t v;
  load_vec4_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double norm;
    if (step[0] != 0) {
      load_vec4_double(&v, p0 + i * step[0], core + 0);
    }
    norm = ksl_vec4_l2norm(&v);
    store_scalar_double(&norm, p1 + i * step[1], core + 1);
  }
}

static void vec4_l2norm_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_l2norm_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_l2norm_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_l2norm_double_over(data, n[0], step, step + 2);
}

/* (4)->() */
INLINED void vec4_l2norm_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t v;
  load_vec4_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float norm;
    if (step[0] != 0) {
      load_vec4_single(&v, p0 + i * step[0], core + 0);
    }
    norm = ksl_vec4f_l2norm(&v);
    store_scalar_single(&norm, p1 + i * step[1], core + 1);
  }
}

static void vec4_l2norm_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_l2norm_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_l2norm_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_l2norm_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_l2norm_loops[] = {
    vec4_l2norm_double, vec4_l2norm_single};

/* (4)->(4) */
INLINED void vec4_normalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t self;
    load_vec4_double(&self, p0 + i * step[0], core + 0);
    ksl_vec4_normalize(&self);
    store_vec4_double(&self, p1 + i * step[1], core + 1);
  }
}

static void vec4_normalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_normalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec4_normalize_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void vec4_normalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t self;
    load_vec4_single(&self, p0 + i * step[0], core + 0);
    ksl_vec4f_normalize(&self);
    store_vec4_single(&self, p1 + i * step[1], core + 1);
  }
}

static void vec4_normalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_normalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  vec4_normalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_normalize_loops[] = {
    vec4_normalize_double, vec4_normalize_single};

/* (4)->(4) */
INLINED void vec4_normalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t v;
  load_vec4_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t vo;
    if (step[0] != 0) {
      load_vec4_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_vec4_normalized(&v, &vo);
    store_vec4_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_normalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_normalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_normalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_normalized_double_over(data, n[0], step, step + 2);
}

/* (4)->(4) */
INLINED void vec4_normalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t v;
  load_vec4_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t vo;
    if (step[0] != 0) {
      load_vec4_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_vec4f_normalized(&v, &vo);
    store_vec4_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void vec4_normalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_normalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_normalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  vec4_normalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction vec4_normalized_loops[] = {
    vec4_normalized_double, vec4_normalized_single};

const coscrew_gufunc TABLE(vec4)[] = {
  {"vec4_copy", "(4)->(4)",
    "vo = vi.\n"
    "\n"
    "(4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", vec4_copy_loops},
  {"vec4_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec4_scale_loops},
  {"vec4_inverted", "(4)->(4)",
    "vo = -vi.\n"
    "\n"
    "(4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "4 neg.  Exact.\n",
   1, 1, "", vec4_inverted_loops},
  {"vec4_invert", "(4)->(4)",
    "self = -self.\n"
    "\n"
    "(4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.\n"
    "4 neg.  Exact.\n",
   1, 1, "", vec4_invert_loops},
  {"vec4_scaled", "(4),()->(4)",
    "vo = k v.\n"
    "\n"
    "(4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec4_scaled_loops},
  {"vec4_swap", "(4),(4)->(4),(4)",
    "v1, v2 = v2, v1.\n"
    "\n"
    "(4),(4)->(4),(4).  v1, v2: vector (x, y, z) and a homogeneous coordinate w.\n"
    "No arithmetic.  Exact.\n",
   2, 2, "", vec4_swap_loops},
  {"vec4_l2norm", "(4)->()",
    "|v| = sqrt(v·v), all four components.\n"
    "\n"
    "(4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.\n"
    "9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.\n",
   1, 1, "", vec4_l2norm_loops},
  {"vec4_normalize", "(4)->(4)",
    "self = self / |self|; the zero vector stays zero.\n"
    "\n"
    "(4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", vec4_normalize_loops},
  {"vec4_normalized", "(4)->(4)",
    "vo = v / |v|; the zero vector stays zero.\n"
    "\n"
    "(4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", vec4_normalized_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
