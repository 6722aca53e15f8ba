/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

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

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_log", "(3,3)->(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.\n"
    "40 mul, 221 add, 5 product error, 3 product rest, 8 div, 1 sqrt, 1 atan2, 1 atan2 error, 12\n"
    "neg, 5 abs, 16 less, 10 equal, 58 select.  Error <= vo: 7 u of its largest component for R a\n"
    "rotation; searched, not proved.\n",
   1, 1, SO3_log_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, mat3x3_orthonormalized_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
