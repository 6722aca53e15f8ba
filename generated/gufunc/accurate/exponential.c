/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3)->(3,3) */
INLINED void SO3_exp_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_exp_accurate(&v, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_exp_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_exp_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_exp_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void SO3_exp_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_expf_accurate(&v, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_exp_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_exp_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_exp_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_exp_loops[] = {
    SO3_exp_double, SO3_exp_single};

/* (3,3)->(3) */
INLINED void SO3_log_double_over(
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
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_SO3_log_accurate(&R, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 2);
  }
}

static void SO3_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_log_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_log_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_log_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3) */
INLINED void SO3_log_single_over(
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
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_SO3_logf_accurate(&R, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 2);
  }
}

static void SO3_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_log_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_log_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_log_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_log_loops[] = {
    SO3_log_double, SO3_log_single};

/* (3)->(3,3) */
INLINED void SO3_leftJacobian_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobian_accurate(&v, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_leftJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobian_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobian_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_leftJacobian_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void SO3_leftJacobian_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianf_accurate(&v, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_leftJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobian_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobian_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_leftJacobian_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_leftJacobian_loops[] = {
    SO3_leftJacobian_double, SO3_leftJacobian_single};

/* (3)->(3,3) */
INLINED void SO3_rightJacobian_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobian_accurate(&v, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_rightJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobian_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobian_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_rightJacobian_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void SO3_rightJacobian_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianf_accurate(&v, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_rightJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobian_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobian_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_rightJacobian_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_rightJacobian_loops[] = {
    SO3_rightJacobian_double, SO3_rightJacobian_single};

/* (3)->(3,3) */
INLINED void SO3_leftJacobianInverse_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianInverse_accurate(&v, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_leftJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_leftJacobianInverse_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void SO3_leftJacobianInverse_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianInversef_accurate(&v, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_leftJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_leftJacobianInverse_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_leftJacobianInverse_loops[] = {
    SO3_leftJacobianInverse_double, SO3_leftJacobianInverse_single};

/* (3)->(3,3) */
INLINED void SO3_rightJacobianInverse_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianInverse_accurate(&v, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_rightJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_rightJacobianInverse_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void SO3_rightJacobianInverse_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianInversef_accurate(&v, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
  }
}

static void SO3_rightJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SO3_rightJacobianInverse_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SO3_rightJacobianInverse_loops[] = {
    SO3_rightJacobianInverse_double, SO3_rightJacobianInverse_single};

/* (3,3)->(3,3) */
INLINED void mat3x3_orthonormalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t self;
    load_mat3x3_double(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3_orthonormalize_accurate(&self);
    store_mat3x3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_orthonormalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_orthonormalize_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_orthonormalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t self;
    load_mat3x3_single(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3f_orthonormalize_accurate(&self);
    store_mat3x3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_orthonormalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_orthonormalize_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_orthonormalize_loops[] = {
    mat3x3_orthonormalize_double, mat3x3_orthonormalize_single};

/* (3,3)->(3,3) */
INLINED void mat3x3_orthonormalized_double_over(
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
    ksl_mat3x3_t Ro;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_orthonormalized_accurate(&R, &Ro);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_orthonormalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_orthonormalized_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_orthonormalized_single_over(
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
    ksl_mat3x3f_t Ro;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_orthonormalized_accurate(&R, &Ro);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_orthonormalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_orthonormalized_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_orthonormalized_loops[] = {
    mat3x3_orthonormalized_double, mat3x3_orthonormalized_single};

/* (6)->(3,4) */
INLINED void SE3_exp_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_exp_accurate(&s, &D);
    store_SE3_double(&D, p1 + i * step[1], core + 1);
  }
}

static void SE3_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 96, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_exp_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_exp_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_exp_double_over(data, n[0], step, step + 2);
}

/* (6)->(3,4) */
INLINED void SE3_exp_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_exp_accurate(&s, &D);
    store_SE3_single(&D, p1 + i * step[1], core + 1);
  }
}

static void SE3_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_exp_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_exp_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_exp_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_exp_loops[] = {
    SE3_exp_double, SE3_exp_single};

/* (3,4)->(6) */
INLINED void SE3_log_double_over(
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
    ksl_SE3_log_accurate(&D, &so);
    store_screw_double(&so, p1 + i * step[1], core + 2);
  }
}

static void SE3_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_log_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_log_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_log_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(6) */
INLINED void SE3_log_single_over(
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
    ksl_SE3f_log_accurate(&D, &so);
    store_screw_single(&so, p1 + i * step[1], core + 2);
  }
}

static void SE3_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_log_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_log_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_log_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_log_loops[] = {
    SE3_log_double, SE3_log_single};

/* (6)->(6,6) */
INLINED void SE3_leftJacobian_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_leftJacobian_accurate(&s, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_leftJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 288, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_leftJacobian_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_leftJacobian_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_leftJacobian_double_over(data, n[0], step, step + 2);
}

/* (6)->(6,6) */
INLINED void SE3_leftJacobian_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_leftJacobian_accurate(&s, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_leftJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 144, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_leftJacobian_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_leftJacobian_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_leftJacobian_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_leftJacobian_loops[] = {
    SE3_leftJacobian_double, SE3_leftJacobian_single};

/* (6)->(6,6) */
INLINED void SE3_rightJacobian_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_rightJacobian_accurate(&s, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_rightJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 288, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_rightJacobian_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_rightJacobian_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_rightJacobian_double_over(data, n[0], step, step + 2);
}

/* (6)->(6,6) */
INLINED void SE3_rightJacobian_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_rightJacobian_accurate(&s, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_rightJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 144, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_rightJacobian_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_rightJacobian_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_rightJacobian_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_rightJacobian_loops[] = {
    SE3_rightJacobian_double, SE3_rightJacobian_single};

/* (6)->(6,6) */
INLINED void SE3_leftJacobianInverse_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_leftJacobianInverse_accurate(&s, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_leftJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 288, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_leftJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_leftJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_leftJacobianInverse_double_over(data, n[0], step, step + 2);
}

/* (6)->(6,6) */
INLINED void SE3_leftJacobianInverse_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_leftJacobianInverse_accurate(&s, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_leftJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 144, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_leftJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_leftJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_leftJacobianInverse_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_leftJacobianInverse_loops[] = {
    SE3_leftJacobianInverse_double, SE3_leftJacobianInverse_single};

/* (6)->(6,6) */
INLINED void SE3_rightJacobianInverse_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_rightJacobianInverse_accurate(&s, &M);
    store_mat6x6_double(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_rightJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 288, 8, 48, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_rightJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 288, 8, 48, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_rightJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_rightJacobianInverse_double_over(data, n[0], step, step + 2);
}

/* (6)->(6,6) */
INLINED void SE3_rightJacobianInverse_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_rightJacobianInverse_accurate(&s, &M);
    store_mat6x6_single(&M, p1 + i * step[1], core + 1);
  }
}

static void SE3_rightJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 144, 4, 24, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_rightJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 144, 4, 24, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_rightJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_rightJacobianInverse_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_rightJacobianInverse_loops[] = {
    SE3_rightJacobianInverse_double, SE3_rightJacobianInverse_single};

/* (3,4),(3,4),()->(3,4) */
INLINED void SE3_interpolated_double_over(
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
    double k;
    ksl_SE3_t Do;
    if (step[0] != 0) {
      load_SE3_double(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D2, p1 + i * step[1], core + 2);
    load_scalar_double(&k, p2 + i * step[2], core + 4);
    ksl_SE3_interpolated_accurate(&D1, &D2, k, &Do);
    store_SE3_double(&Do, p3 + i * step[3], core + 4);
  }
}

static void SE3_interpolated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 8, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_interpolated_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 8, 96, 32, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_interpolated_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  SE3_interpolated_double_over(data, n[0], step, step + 4);
}

/* (3,4),(3,4),()->(3,4) */
INLINED void SE3_interpolated_single_over(
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
    float k;
    ksl_SE3f_t Do;
    if (step[0] != 0) {
      load_SE3_single(&D1, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D2, p1 + i * step[1], core + 2);
    load_scalar_single(&k, p2 + i * step[2], core + 4);
    ksl_SE3f_interpolated_accurate(&D1, &D2, k, &Do);
    store_SE3_single(&Do, p3 + i * step[3], core + 4);
  }
}

static void SE3_interpolated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 4, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_interpolated_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 4, 48, 16, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_interpolated_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  SE3_interpolated_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction SE3_interpolated_loops[] = {
    SE3_interpolated_double, SE3_interpolated_single};

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_exp", "(3)->(3,3)",
    "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "178 mul, 320 add, 17 product error, 22 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 10 equal,\n"
    "19 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision\n"
    "1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "", SO3_exp_loops},
  {"SO3_log", "(3,3)->(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.\n"
    "162 mul, 433 add, 26 product error, 3 product rest, 10 div, 1 sqrt, 13 neg, 13 abs, 4\n"
    "copysign, 29 less, 9 equal, 77 select.  Error <= vo: 1 u of its largest component for R a\n"
    "rotation; searched, not proved.  Each component is within 1 ulp as long as its condition is\n"
    "below 1e13; in single precision it is the nearest number, except near ties, as long as that\n"
    "is below 1e5; searched, not proved.\n",
   1, 1, "R", SO3_log_loops},
  {"SO3_leftJacobian", "(3)->(3,3)",
    "R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,\n"
    "25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision\n"
    "1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "", SO3_leftJacobian_loops},
  {"SO3_rightJacobian", "(3)->(3,3)",
    "R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 9 neg, 4 abs, 6 less, 10\n"
    "equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single\n"
    "precision 1e5; searched, not proved.  Each component is within 1 ulp as long as its\n"
    "condition is below 1e13; in single precision it is the nearest number, except near ties, as\n"
    "long as that is below 1e5; searched, not proved.\n",
   1, 1, "", SO3_rightJacobian_loops},
  {"SO3_leftJacobianInverse", "(3)->(3,3)",
    "R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,\n"
    "10 equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not\n"
    "proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", SO3_leftJacobianInverse_loops},
  {"SO3_rightJacobianInverse", "(3)->(3,3)",
    "R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 4 abs, 6 less, 10\n"
    "equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not\n"
    "proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", SO3_rightJacobianInverse_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalized_loops},
  {"SE3_exp", "(6)->(3,4)",
    "D = exp s = [exp ω~ | J_l(ω) v].\n"
    "\n"
    "(6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.\n"
    "246 mul, 553 add, 24 product error, 58 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 13 equal,\n"
    "28 select.  Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger,\n"
    "for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Each component is\n"
    "within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest\n"
    "number, except near ties, as long as that is below 1e5; searched, not proved.  Intermediate\n"
    "sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_exp_loops},
  {"SE3_log", "(3,4)->(6)",
    "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "285 mul, 748 add, 36 product error, 36 product rest, 23 div, 2 sqrt, 12 neg, 14 abs, 4\n"
    "copysign, 32 less, 13 equal, 88 select.  Error <= lin: 1 u, ang: 1 u of its largest\n"
    "component for R of D a rotation; searched, not proved.  Each component is within 1 ulp as\n"
    "long as its condition is below 1e13; in single precision it is the nearest number, except\n"
    "near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may\n"
    "overflow where |t| is above 2e306, in single precision 5e36.\n",
   1, 1, "R", SE3_log_loops},
  {"SE3_leftJacobian", "(6)->(6,6)",
    "M = J_l(s) = Σ ([ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,\n"
    "19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_leftJacobian_loops},
  {"SE3_rightJacobian", "(6)->(6,6)",
    "M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 36 neg, 4 abs, 6 less,\n"
    "19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_rightJacobian_loops},
  {"SE3_leftJacobianInverse", "(6)->(6,6)",
    "M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 9 neg, 4 abs, 6 less,\n"
    "19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_leftJacobianInverse_loops},
  {"SE3_rightJacobianInverse", "(6)->(6,6)",
    "M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 21 neg, 4 abs, 6 less,\n"
    "19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_rightJacobianInverse_loops},
  {"SE3_interpolated", "(3,4),(3,4),()->(3,4)",
    "Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.\n"
    "\n"
    "(3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "717 mul, 1706 add, 66 product error, 166 product rest, 29 div, 3 sqrt, 13 neg, 18 abs, 4\n"
    "copysign, 38 less, 20 equal, 110 select.  Error <= R: 1 u, t: 1 u of its largest component,\n"
    "or of D1.t or D2.t if that is larger, for R of D1 a rotation and R of D2 a rotation and 0 <=\n"
    "k <= 1; searched, not proved.  Each component is within 1 ulp as long as its condition is\n"
    "below 1e13; in single precision it is the nearest number, except near ties, as long as that\n"
    "is below 1e5; searched, not proved.  Intermediate sums may overflow where |t| of D1 or D2 is\n"
    "above 2e306, in single precision 5e36.\n",
   3, 1, "RR.", SE3_interpolated_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
