/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, unless an output
   is an input element by element; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,3)->(3,3) */
INLINED void mat3x3_copy_double_over(
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
    ksl_mat3x3_copy(&R, &Ro);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_copy_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_copy_single_over(
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
    ksl_mat3x3f_copy(&R, &Ro);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_copy_loops[] = {
    mat3x3_copy_double, mat3x3_copy_single};

/* (3,3)->(3,3) */
INLINED void mat3x3_setIdentity_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t self;
    load_mat3x3_double(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3_setIdentity(&self);
    store_mat3x3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_setIdentity_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setIdentity_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_setIdentity_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_setIdentity_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t self;
    load_mat3x3_single(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3f_setIdentity(&self);
    store_mat3x3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_setIdentity_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setIdentity_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_setIdentity_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_setIdentity_loops[] = {
    mat3x3_setIdentity_double, mat3x3_setIdentity_single};

/* (3),(3),(3)->(3,3) */
INLINED void mat3x3_setFromVectors_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t x;
  load_vec3_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t y;
    ksl_vec3_t z;
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_vec3_double(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&y, p1 + i * step[1], core + 1);
    load_vec3_double(&z, p2 + i * step[2], core + 2);
    ksl_mat3x3_setFromVectors(&R, &x, &y, &z);
    store_mat3x3_double(&R, p3 + i * step[3], core + 3);
  }
}

static void mat3x3_setFromVectors_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 24, 72, 8, 8, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setFromVectors_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 72, 8, 8, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_setFromVectors_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_setFromVectors_double_over(data, n[0], step, step + 4);
}

/* (3),(3),(3)->(3,3) */
INLINED void mat3x3_setFromVectors_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t x;
  load_vec3_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t y;
    ksl_vec3f_t z;
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_vec3_single(&x, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&y, p1 + i * step[1], core + 1);
    load_vec3_single(&z, p2 + i * step[2], core + 2);
    ksl_mat3x3f_setFromVectors(&R, &x, &y, &z);
    store_mat3x3_single(&R, p3 + i * step[3], core + 3);
  }
}

static void mat3x3_setFromVectors_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 12, 36, 4, 4, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setFromVectors_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 36, 4, 4, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_setFromVectors_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_setFromVectors_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat3x3_setFromVectors_loops[] = {
    mat3x3_setFromVectors_double, mat3x3_setFromVectors_single};

/* (3)->(3,3) */
INLINED void skew_double_over(
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
    ksl_mat3x3_t Ro;
    if (step[0] != 0) {
      load_vec3_double(&v, p0 + i * step[0], core + 0);
    }
    ksl_skew(&v, &Ro);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 1);
  }
}

static void skew_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    skew_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    skew_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  skew_double_over(data, n[0], step, step + 2);
}

/* (3)->(3,3) */
INLINED void skew_single_over(
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
    ksl_mat3x3f_t Ro;
    if (step[0] != 0) {
      load_vec3_single(&v, p0 + i * step[0], core + 0);
    }
    ksl_skewf(&v, &Ro);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 1);
  }
}

static void skew_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    skew_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    skew_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  skew_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction skew_loops[] = {
    skew_double, skew_single};

/* (3,3)->(3,3) */
INLINED void mat3x3_transpose_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t self;
    load_mat3x3_double(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3_transpose(&self);
    store_mat3x3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_transpose_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_transpose_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_transpose_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_transpose_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t self;
    load_mat3x3_single(&self, p0 + i * step[0], core + 0);
    ksl_mat3x3f_transpose(&self);
    store_mat3x3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_transpose_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_transpose_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat3x3_transpose_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_transpose_loops[] = {
    mat3x3_transpose_double, mat3x3_transpose_single};

/* (3,3)->(3,3) */
INLINED void mat3x3_transposed_double_over(
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
    ksl_mat3x3_transposed(&R, &Ro);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_transposed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_transposed_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_transposed_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_transposed_double_over(data, n[0], step, step + 2);
}

/* (3,3)->(3,3) */
INLINED void mat3x3_transposed_single_over(
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
    ksl_mat3x3f_transposed(&R, &Ro);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_transposed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_transposed_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_transposed_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_transposed_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_transposed_loops[] = {
    mat3x3_transposed_double, mat3x3_transposed_single};

/* (3,3)->() */
INLINED void mat3x3_determinant_double_over(
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
    double det;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3_determinant(&R);
    store_scalar_double(&det, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_determinant_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_determinant_double_over(data, n[0], step, step + 2);
}

/* (3,3)->() */
INLINED void mat3x3_determinant_single_over(
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
    float det;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3f_determinant(&R);
    store_scalar_single(&det, p1 + i * step[1], core + 2);
  }
}

static void mat3x3_determinant_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat3x3_determinant_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat3x3_determinant_loops[] = {
    mat3x3_determinant_double, mat3x3_determinant_single};

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"mat3x3_copy", "(3,3)->(3,3)",
    "Ro = R.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, mat3x3_copy_loops},
  {"mat3x3_setIdentity", "(3,3)->(3,3)",
    "self = I.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, mat3x3_setIdentity_loops},
  {"mat3x3_setFromVectors", "(3),(3),(3)->(3,3)",
    "R = [x y z], the columns.\n"
    "\n"
    "(3),(3),(3)->(3,3).  x, y, z: vector; R: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   3, 1, mat3x3_setFromVectors_loops},
  {"skew", "(3)->(3,3)",
    "Ro = v~, the matrix with v~ y = v × y.\n"
    "\n"
    "(3)->(3,3).  v: vector; Ro: rotation or other 3×3 matrix.\n"
    "3 neg.  Exact.\n",
   1, 1, skew_loops},
  {"mat3x3_transpose", "(3,3)->(3,3)",
    "self = self^T, the inverse of a rotation.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, mat3x3_transpose_loops},
  {"mat3x3_transposed", "(3,3)->(3,3)",
    "Ro = R^T, the inverse of a rotation.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, mat3x3_transposed_loops},
  {"mat3x3_determinant", "(3,3)->()",
    "det R.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; det: number.\n"
    "9 mul, 5 add.  Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   1, 1, mat3x3_determinant_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
