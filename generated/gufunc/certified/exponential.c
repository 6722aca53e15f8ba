/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (3)->(3,3),(3,3) */
INLINED void SO3_exp_double_over(
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
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_exp_certified(&v, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_exp_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_exp_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_exp_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void SO3_exp_single_over(
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
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_expf_certified(&v, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_exp_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_exp_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_exp_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_exp_loops[] = {
    SO3_exp_double, SO3_exp_single};

/* (3,3)->(3),(3) */
INLINED void SO3_log_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_SO3_log_certified(&R, &vo, &vo_bound);
    store_vec3_double(&vo, p1 + i * step[1], core + 2);
    store_vec3_double(&vo_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_log_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_log_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_log_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3),(3) */
INLINED void SO3_log_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_SO3_logf_certified(&R, &vo, &vo_bound);
    store_vec3_single(&vo, p1 + i * step[1], core + 2);
    store_vec3_single(&vo_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_log_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_log_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_log_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_log_loops[] = {
    SO3_log_double, SO3_log_single};

/* (3)->(3,3),(3,3) */
INLINED void SO3_leftJacobian_double_over(
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
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobian_certified(&v, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_leftJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobian_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobian_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_leftJacobian_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void SO3_leftJacobian_single_over(
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
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianf_certified(&v, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_leftJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobian_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobian_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_leftJacobian_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_leftJacobian_loops[] = {
    SO3_leftJacobian_double, SO3_leftJacobian_single};

/* (3)->(3,3),(3,3) */
INLINED void SO3_rightJacobian_double_over(
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
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobian_certified(&v, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_rightJacobian_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobian_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobian_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_rightJacobian_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void SO3_rightJacobian_single_over(
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
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianf_certified(&v, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_rightJacobian_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobian_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobian_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_rightJacobian_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_rightJacobian_loops[] = {
    SO3_rightJacobian_double, SO3_rightJacobian_single};

/* (3)->(3,3),(3,3) */
INLINED void SO3_leftJacobianInverse_double_over(
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
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianInverse_certified(&v, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_leftJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_leftJacobianInverse_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void SO3_leftJacobianInverse_single_over(
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
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_leftJacobianInversef_certified(&v, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_leftJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_leftJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_leftJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_leftJacobianInverse_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_leftJacobianInverse_loops[] = {
    SO3_leftJacobianInverse_double, SO3_leftJacobianInverse_single};

/* (3)->(3,3),(3,3) */
INLINED void SO3_rightJacobianInverse_double_over(
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
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianInverse_certified(&v, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_rightJacobianInverse_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobianInverse_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobianInverse_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_rightJacobianInverse_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void SO3_rightJacobianInverse_single_over(
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
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_SO3_rightJacobianInversef_certified(&v, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SO3_rightJacobianInverse_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SO3_rightJacobianInverse_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SO3_rightJacobianInverse_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SO3_rightJacobianInverse_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SO3_rightJacobianInverse_loops[] = {
    SO3_rightJacobianInverse_double, SO3_rightJacobianInverse_single};

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalize_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t self;
    ksl_mat3x3_t self_bound;
    load_mat3x3_double(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3_orthonormalize_certified(&self, &self_bound);
    store_mat3x3_double(&self, p1 + i * step[1], core + 2);
    store_mat3x3_double(&self_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_orthonormalize_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  mat3x3_orthonormalize_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalize_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t self;
    ksl_mat3x3f_t self_bound;
    load_mat3x3_single(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3f_orthonormalize_certified(&self, &self_bound);
    store_mat3x3_single(&self, p1 + i * step[1], core + 2);
    store_mat3x3_single(&self_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_orthonormalize_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalize_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  mat3x3_orthonormalize_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_orthonormalize_loops[] = {
    mat3x3_orthonormalize_double, mat3x3_orthonormalize_single};

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalized_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_orthonormalized_certified(&R, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 2);
    store_mat3x3_double(&Ro_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_orthonormalized_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 24, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_orthonormalized_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3,3),(3,3) */
INLINED void mat3x3_orthonormalized_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_orthonormalized_certified(&R, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 2);
    store_mat3x3_single(&Ro_bound, p2 + i * step[2], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_orthonormalized_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 12, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_orthonormalized_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_orthonormalized_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_orthonormalized_loops[] = {
    mat3x3_orthonormalized_double, mat3x3_orthonormalized_single};

/* (6)->(3,4),(3,4) */
INLINED void SE3_exp_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screw_t s;
  load_screw_double(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D;
    ksl_SE3_t D_bound;
    if (step[0] != 0) {
      load_screw_double(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3_exp_certified(&s, &D, &D_bound);
    store_SE3_double(&D, p1 + i * step[1], core + 1);
    store_SE3_double(&D_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 96, 96, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_exp_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 96, 8, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_exp_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_exp_double_over(data, n[0], step, step + 3);
}

/* (6)->(3,4),(3,4) */
INLINED void SE3_exp_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_screwf_t s;
  load_screw_single(&s, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D;
    ksl_SE3f_t D_bound;
    if (step[0] != 0) {
      load_screw_single(&s, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_exp_certified(&s, &D, &D_bound);
    store_SE3_single(&D, p1 + i * step[1], core + 1);
    store_SE3_single(&D_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 48, 48, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_exp_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 4, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_exp_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_exp_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SE3_exp_loops[] = {
    SE3_exp_double, SE3_exp_single};

/* (3,4)->(6),(6) */
INLINED void SE3_log_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D;
  load_SE3_double(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t so;
    ksl_screw_t so_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_log_certified(&D, &so, &so_bound);
    store_screw_double(&so, p1 + i * step[1], core + 2);
    store_screw_double(&so_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_log_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_log_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_log_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_log_double_over(data, n[0], step, step + 3);
}

/* (3,4)->(6),(6) */
INLINED void SE3_log_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D;
  load_SE3_single(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_log_certified(&D, &so, &so_bound);
    store_screw_single(&so, p1 + i * step[1], core + 2);
    store_screw_single(&so_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void SE3_log_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_log_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_log_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_log_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SE3_log_loops[] = {
    SE3_log_double, SE3_log_single};

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_exp", "(3)->(3,3),(3,3)",
    "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "336 mul, 494 add, 17 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1\n"
    "equal, 29 select.\n",
   1, 2, "", SO3_exp_loops},
  {"SO3_log", "(3,3)->(3),(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;\n"
    "|error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; vo, vo_bound: vector.\n"
    "244 mul, 466 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4\n"
    "copysign, 41 less, 7 equal, 107 select.\n",
   1, 2, "R", SO3_log_loops},
  {"SO3_leftJacobian", "(3)->(3,3),(3,3)",
    "R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1\n"
    "equal, 45 select.\n",
   1, 2, "", SO3_leftJacobian_loops},
  {"SO3_rightJacobian", "(3)->(3,3),(3,3)",
    "R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20\n"
    "less, 1 equal, 45 select.\n",
   1, 2, "", SO3_rightJacobian_loops},
  {"SO3_leftJacobianInverse", "(3)->(3,3),(3,3)",
    "R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less,\n"
    "1 equal, 47 select.\n",
   1, 2, "", SO3_leftJacobianInverse_loops},
  {"SO3_rightJacobianInverse", "(3)->(3,3),(3,3)",
    "R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1\n"
    "equal, 47 select.\n",
   1, 2, "", SO3_rightJacobianInverse_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3),(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  self, self_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, "", mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3),(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, "", mat3x3_orthonormalized_loops},
  {"SE3_exp", "(6)->(3,4),(3,4)",
    "D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.\n"
    "\n"
    "(6)->(3,4),(3,4).  s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R\n"
    "rotation, t in m.\n"
    "524 mul, 876 add, 24 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1\n"
    "equal, 46 select.\n",
   1, 2, "", SE3_exp_loops},
  {"SE3_log", "(3,4)->(6),(6)",
    "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "599 mul, 986 add, 36 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6\n"
    "copysign, 72 less, 10 equal, 171 select.\n",
   1, 2, "R", SE3_log_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
