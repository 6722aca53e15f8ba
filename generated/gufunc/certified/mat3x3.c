/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (3),(3)->(3,3),(3,3) */
INLINED void acceleration_tensor_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t w;
  load_vec3_double(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t dw;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    if (step[0] != 0) {
      load_vec3_double(&w, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&dw, p1 + i * step[1], core + 1);
    ksl_acceleration_tensor_certified(&w, &dw, &Ro, &Ro_bound);
    store_mat3x3_double(&Ro, p2 + i * step[2], core + 2);
    store_mat3x3_double(&Ro_bound, p3 + i * step[3], core + 4);
  }
}

static void acceleration_tensor_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 24, 72, 72, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    acceleration_tensor_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 72, 72, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    acceleration_tensor_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  acceleration_tensor_double_over(data, n[0], step, step + 4);
}

/* (3),(3)->(3,3),(3,3) */
INLINED void acceleration_tensor_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t w;
  load_vec3_single(&w, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t dw;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    if (step[0] != 0) {
      load_vec3_single(&w, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&dw, p1 + i * step[1], core + 1);
    ksl_acceleration_tensorf_certified(&w, &dw, &Ro, &Ro_bound);
    store_mat3x3_single(&Ro, p2 + i * step[2], core + 2);
    store_mat3x3_single(&Ro_bound, p3 + i * step[3], core + 4);
  }
}

static void acceleration_tensor_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 12, 36, 36, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    acceleration_tensor_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 36, 36, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    acceleration_tensor_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  acceleration_tensor_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction acceleration_tensor_loops[] = {
    acceleration_tensor_double, acceleration_tensor_single};

/* (3,3)->(),() */
INLINED void mat3x3_determinant_double_over(
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
    double det;
    double det_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3_determinant_certified(&R, &det_bound);
    store_scalar_double(&det, p1 + i * step[1], core + 2);
    store_scalar_double(&det_bound, p2 + i * step[2], core + 2);
  }
}

static void mat3x3_determinant_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_determinant_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(),() */
INLINED void mat3x3_determinant_single_over(
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
    float det;
    float det_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    det = ksl_mat3x3f_determinant_certified(&R, &det_bound);
    store_scalar_single(&det, p1 + i * step[1], core + 2);
    store_scalar_single(&det_bound, p2 + i * step[2], core + 2);
  }
}

static void mat3x3_determinant_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_determinant_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_determinant_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_determinant_loops[] = {
    mat3x3_determinant_double, mat3x3_determinant_single};

/* (3),(2)->(3,3),(3,3) */
INLINED void mat3x3_setFromAxisDC_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t axis;
  load_vec3_double(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double dc[2];
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&axis, p0 + i * step[0], core + 0);
    }
    load_dc_double(dc, p1 + i * step[1], core + 1);
    ksl_mat3x3_setFromAxisDC_certified(&R, &axis, dc, &R_bound);
    store_mat3x3_double(&R, p2 + i * step[2], core + 2);
    store_mat3x3_double(&R_bound, p3 + i * step[3], core + 4);
  }
}

static void mat3x3_setFromAxisDC_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 16, 72, 72, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setFromAxisDC_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 16, 72, 72, 8, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_setFromAxisDC_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_setFromAxisDC_double_over(data, n[0], step, step + 4);
}

/* (3),(2)->(3,3),(3,3) */
INLINED void mat3x3_setFromAxisDC_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t axis;
  load_vec3_single(&axis, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float dc[2];
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&axis, p0 + i * step[0], core + 0);
    }
    load_dc_single(dc, p1 + i * step[1], core + 1);
    ksl_mat3x3f_setFromAxisDC_certified(&R, &axis, dc, &R_bound);
    store_mat3x3_single(&R, p2 + i * step[2], core + 2);
    store_mat3x3_single(&R_bound, p3 + i * step[3], core + 4);
  }
}

static void mat3x3_setFromAxisDC_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 8, 36, 36, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_setFromAxisDC_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 36, 36, 4, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_setFromAxisDC_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_setFromAxisDC_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat3x3_setFromAxisDC_loops[] = {
    mat3x3_setFromAxisDC_double, mat3x3_setFromAxisDC_single};

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"acceleration_tensor", "(3),(3)->(3,3),(3,3)",
    "Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the\n"
    "acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3,3),(3,3).  w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "15 mul, 27 add, 3 neg, 9 abs.\n",
   2, 2, acceleration_tensor_loops},
  {"mat3x3_determinant", "(3,3)->(),()",
    "det R; |error of det| <= det_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.\n"
    "13 mul, 14 add, 9 abs.\n",
   1, 2, mat3x3_determinant_loops},
  {"mat3x3_setFromAxisDC", "(3),(2)->(3,3),(3,3)",
    "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),\n"
    "dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3),(2)->(3,3),(3,3).  axis: vector; dc: (sin θ, cos θ); R, R_bound: rotation or other 3×3\n"
    "matrix.\n"
    "30 mul, 31 add, 8 abs.\n",
   2, 2, mat3x3_setFromAxisDC_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
