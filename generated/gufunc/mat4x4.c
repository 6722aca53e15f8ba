/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat4x4 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,4)->(4,4) */
INLINED void mat4x4_fromSE3_double_over(
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
    ksl_mat4x4_t M;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    M = ksl_mat4x4_fromSE3(D);
    store_mat4x4_double(&M, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_fromSE3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 128, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_fromSE3_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 128, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_fromSE3_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_fromSE3_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(4,4) */
INLINED void mat4x4_fromSE3_single_over(
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
    ksl_mat4x4f_t M;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    M = ksl_mat4x4f_fromSE3f(D);
    store_mat4x4_single(&M, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_fromSE3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 64, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_fromSE3_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 64, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_fromSE3_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_fromSE3_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat4x4_fromSE3_loops[] = {
    mat4x4_fromSE3_double, mat4x4_fromSE3_single};

/* (3,3),(3)->(4,4) */
INLINED void mat4x4_fromRt_double_over(
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
    ksl_vec3_t t;
    ksl_mat4x4_t M;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 2);
    M = ksl_mat4x4_fromRt(R, t);
    store_mat4x4_double(&M, p2 + i * step[2], core + 3);
  }
}

static void mat4x4_fromRt_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 128, 24, 8, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_fromRt_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 128, 24, 8, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_fromRt_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat4x4_fromRt_double_over(data, n[0], step, step + 3);
}

/* (3,3),(3)->(4,4) */
INLINED void mat4x4_fromRt_single_over(
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
    ksl_vec3f_t t;
    ksl_mat4x4f_t M;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 2);
    M = ksl_mat4x4f_fromRt(R, t);
    store_mat4x4_single(&M, p2 + i * step[2], core + 3);
  }
}

static void mat4x4_fromRt_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 64, 12, 4, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_fromRt_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 64, 12, 4, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_fromRt_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat4x4_fromRt_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat4x4_fromRt_loops[] = {
    mat4x4_fromRt_double, mat4x4_fromRt_single};

/* (4,4)->(3,4) */
INLINED void mat4x4_toSE3_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat4x4_t M;
  load_mat4x4_double(&M, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D;
    if (step[0] != 0) {
      load_mat4x4_double(&M, p0 + i * step[0], core + 0);
    }
    ksl_mat4x4_toSE3(&M, &D);
    store_SE3_double(&D, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_toSE3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 128, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_toSE3_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_toSE3_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_toSE3_double_over(data, n[0], step, step + 2);
}

/* (4,4)->(3,4) */
INLINED void mat4x4_toSE3_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat4x4f_t M;
  load_mat4x4_single(&M, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D;
    if (step[0] != 0) {
      load_mat4x4_single(&M, p0 + i * step[0], core + 0);
    }
    ksl_mat4x4f_toSE3f(&M, &D);
    store_SE3_single(&D, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_toSE3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 64, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_toSE3_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_toSE3_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_toSE3_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat4x4_toSE3_loops[] = {
    mat4x4_toSE3_double, mat4x4_toSE3_single};

/* (4,4)->(4,4) */
INLINED void mat4x4_setIdentity_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat4x4_t self;
    load_mat4x4_double(&self, p0 + i * step[0], core + 0);
    ksl_mat4x4_setIdentity(&self);
    store_mat4x4_double(&self, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_setIdentity_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 128, 128, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_setIdentity_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat4x4_setIdentity_double_over(data, n[0], step, step + 2);
}

/* (4,4)->(4,4) */
INLINED void mat4x4_setIdentity_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat4x4f_t self;
    load_mat4x4_single(&self, p0 + i * step[0], core + 0);
    ksl_mat4x4f_setIdentity(&self);
    store_mat4x4_single(&self, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_setIdentity_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 64, 64, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_setIdentity_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  mat4x4_setIdentity_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat4x4_setIdentity_loops[] = {
    mat4x4_setIdentity_double, mat4x4_setIdentity_single};

/* (4,4)->(3) */
INLINED void mat4x4_getTranslation_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat4x4_t M;
  load_mat4x4_double(&M, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t t;
    if (step[0] != 0) {
      load_mat4x4_double(&M, p0 + i * step[0], core + 0);
    }
    ksl_mat4x4_getTranslation(&M, &t);
    store_vec3_double(&t, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_getTranslation_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 128, 24, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_getTranslation_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_getTranslation_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_getTranslation_double_over(data, n[0], step, step + 2);
}

/* (4,4)->(3) */
INLINED void mat4x4_getTranslation_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_mat4x4f_t M;
  load_mat4x4_single(&M, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t t;
    if (step[0] != 0) {
      load_mat4x4_single(&M, p0 + i * step[0], core + 0);
    }
    ksl_mat4x4f_getTranslation(&M, &t);
    store_vec3_single(&t, p1 + i * step[1], core + 2);
  }
}

static void mat4x4_getTranslation_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 64, 12, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat4x4_getTranslation_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat4x4_getTranslation_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  mat4x4_getTranslation_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat4x4_getTranslation_loops[] = {
    mat4x4_getTranslation_double, mat4x4_getTranslation_single};

const coscrew_gufunc TABLE(mat4x4)[] = {
  {"mat4x4_fromSE3", "(3,4)->(4,4)",
    "M = [[R, t], [0, 1]] of D = [R | t].\n"
    "\n"
    "(3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_fromSE3_loops},
  {"mat4x4_fromRt", "(3,3),(3)->(4,4)",
    "M = [[R, t], [0, 1]].\n"
    "\n"
    "(3,3),(3)->(4,4).  R: rotation or other 3×3 matrix; t: vector; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   2, 1, "R.", mat4x4_fromRt_loops},
  {"mat4x4_toSE3", "(4,4)->(3,4)",
    "D = [R | t], the first three rows of M.\n"
    "\n"
    "(4,4)->(3,4).  M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_toSE3_loops},
  {"mat4x4_setIdentity", "(4,4)->(4,4)",
    "self = I.\n"
    "\n"
    "(4,4)->(4,4).  self: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_setIdentity_loops},
  {"mat4x4_getTranslation", "(4,4)->(3)",
    "t, the first three entries of the last column of M.\n"
    "\n"
    "(4,4)->(3).  M: 4×4 matrix; t: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_getTranslation_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
