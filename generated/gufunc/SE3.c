/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3,3),(3)->(3,4) */
INLINED void SE3_fromRt_double_over(
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
    ksl_SE3_t D;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 2);
    D = ksl_SE3_fromRt(R, t);
    store_SE3_double(&D, p2 + i * step[2], core + 3);
  }
}

static void SE3_fromRt_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 96, 24, 8, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_fromRt_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 96, 24, 8, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_fromRt_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_fromRt_double_over(data, n[0], step, step + 3);
}

/* (3,3),(3)->(3,4) */
INLINED void SE3_fromRt_single_over(
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
    ksl_SE3f_t D;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 2);
    D = ksl_SE3f_fromRt(R, t);
    store_SE3_single(&D, p2 + i * step[2], core + 3);
  }
}

static void SE3_fromRt_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 48, 12, 4, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_fromRt_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 48, 12, 4, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_fromRt_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  SE3_fromRt_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction SE3_fromRt_loops[] = {
    SE3_fromRt_double, SE3_fromRt_single};

/* (3,4)->(3,4) */
INLINED void SE3_copy_double_over(
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
    ksl_SE3_t Do;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_copy(&D, &Do);
    store_SE3_double(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_copy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_copy_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_copy_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_copy_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_copy_single_over(
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
    ksl_SE3f_t Do;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_copy(&D, &Do);
    store_SE3_single(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_copy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_copy_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_copy_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_copy_loops[] = {
    SE3_copy_double, SE3_copy_single};

/* (3,4)->(3,4) */
INLINED void SE3_setIdentity_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t self;
    load_SE3_double(&self, p0 + i * step[0], core + 0);
    ksl_SE3_setIdentity(&self);
    store_SE3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_setIdentity_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_setIdentity_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_setIdentity_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_setIdentity_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t self;
    load_SE3_single(&self, p0 + i * step[0], core + 0);
    ksl_SE3f_setIdentity(&self);
    store_SE3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_setIdentity_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_setIdentity_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_setIdentity_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_setIdentity_loops[] = {
    SE3_setIdentity_double, SE3_setIdentity_single};

/* (3,4)->(3) */
INLINED void SE3_getTranslation_double_over(
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
    ksl_vec3_t t;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_getTranslation(&D, &t);
    store_vec3_double(&t, p1 + i * step[1], core + 2);
  }
}

static void SE3_getTranslation_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 24, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_getTranslation_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_getTranslation_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_getTranslation_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3) */
INLINED void SE3_getTranslation_single_over(
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
    ksl_vec3f_t t;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_getTranslation(&D, &t);
    store_vec3_single(&t, p1 + i * step[1], core + 2);
  }
}

static void SE3_getTranslation_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 12, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_getTranslation_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_getTranslation_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_getTranslation_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_getTranslation_loops[] = {
    SE3_getTranslation_double, SE3_getTranslation_single};

/* (3,4)->(3,3) */
INLINED void SE3_getRotation_double_over(
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
    ksl_mat3x3_t R;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_getRotation(&D, &R);
    store_mat3x3_double(&R, p1 + i * step[1], core + 2);
  }
}

static void SE3_getRotation_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 72, 32, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_getRotation_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 32, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_getRotation_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_getRotation_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,3) */
INLINED void SE3_getRotation_single_over(
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
    ksl_mat3x3f_t R;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_getRotation(&D, &R);
    store_mat3x3_single(&R, p1 + i * step[1], core + 2);
  }
}

static void SE3_getRotation_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 36, 16, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_getRotation_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 16, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_getRotation_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_getRotation_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_getRotation_loops[] = {
    SE3_getRotation_double, SE3_getRotation_single};

/* (3,4)->(3,4) */
INLINED void SE3_invert_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t self;
    load_SE3_double(&self, p0 + i * step[0], core + 0);
    ksl_SE3_invert(&self);
    store_SE3_double(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_invert_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_invert_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_invert_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t self;
    load_SE3_single(&self, p0 + i * step[0], core + 0);
    ksl_SE3f_invert(&self);
    store_SE3_single(&self, p1 + i * step[1], core + 2);
  }
}

static void SE3_invert_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_invert_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  SE3_invert_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_invert_loops[] = {
    SE3_invert_double, SE3_invert_single};

/* (3,4)->(4,4) */
INLINED void SE3_toMat4x4_double_over(
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
    ksl_SE3_toMat4x4(&D, &M);
    store_mat4x4_double(&M, p1 + i * step[1], core + 2);
  }
}

static void SE3_toMat4x4_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 128, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_toMat4x4_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 128, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_toMat4x4_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_toMat4x4_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(4,4) */
INLINED void SE3_toMat4x4_single_over(
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
    ksl_SE3f_toMat4x4f(&D, &M);
    store_mat4x4_single(&M, p1 + i * step[1], core + 2);
  }
}

static void SE3_toMat4x4_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 64, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_toMat4x4_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 64, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_toMat4x4_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_toMat4x4_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_toMat4x4_loops[] = {
    SE3_toMat4x4_double, SE3_toMat4x4_single};

/* (3,4)->(3,4) */
INLINED void SE3_inverted_double_over(
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
    ksl_SE3_t Do;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3_inverted(&D, &Do);
    store_SE3_double(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_inverted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 32, 8, 32, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_inverted_double_over(data, n[0], step, step + 2);
}

/* (3,4)->(3,4) */
INLINED void SE3_inverted_single_over(
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
    ksl_SE3f_t Do;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    ksl_SE3f_inverted(&D, &Do);
    store_SE3_single(&Do, p1 + i * step[1], core + 2);
  }
}

static void SE3_inverted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 16, 4, 16, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    SE3_inverted_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  SE3_inverted_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction SE3_inverted_loops[] = {
    SE3_inverted_double, SE3_inverted_single};

const coscrew_gufunc TABLE(SE3)[] = {
  {"SE3_fromRt", "(3,3),(3)->(3,4)",
    "D = [R | t].\n"
    "\n"
    "(3,3),(3)->(3,4).  R: rotation or other 3×3 matrix; t: vector; D: displacement [R | t], R\n"
    "rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   2, 1, "R.", SE3_fromRt_loops},
  {"SE3_copy", "(3,4)->(3,4)",
    "Do = D.\n"
    "\n"
    "(3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_copy_loops},
  {"SE3_setIdentity", "(3,4)->(3,4)",
    "self = [I | 0].\n"
    "\n"
    "(3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_setIdentity_loops},
  {"SE3_getTranslation", "(3,4)->(3)",
    "t of D = [R | t].\n"
    "\n"
    "(3,4)->(3).  D: displacement [R | t], R rotation, t in m; t: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_getTranslation_loops},
  {"SE3_getRotation", "(3,4)->(3,3)",
    "R of D = [R | t].\n"
    "\n"
    "(3,4)->(3,3).  D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_getRotation_loops},
  {"SE3_invert", "(3,4)->(3,4)",
    "self = self^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_invert_loops},
  {"SE3_toMat4x4", "(3,4)->(4,4)",
    "M = [[R, t], [0, 1]] of D = [R | t].\n"
    "\n"
    "(3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_toMat4x4_loops},
  {"SE3_inverted", "(3,4)->(3,4)",
    "Do = D^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_inverted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
