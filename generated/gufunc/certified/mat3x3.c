/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

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
  feclearexcept(FE_ALL_EXCEPT);
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
  feclearexcept(FE_ALL_EXCEPT);
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
  feclearexcept(FE_ALL_EXCEPT);
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
  feclearexcept(FE_ALL_EXCEPT);
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
  feclearexcept(FE_ALL_EXCEPT);
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
  feclearexcept(FE_ALL_EXCEPT);
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

/* (3)->(3,3),(3,3) */
INLINED void mat3x3_from_euler_xyz_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t angles;
  load_vec3_double(&angles, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&angles, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_from_euler_xyz_certified(&angles, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_euler_xyz_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_euler_xyz_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_euler_xyz_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_from_euler_xyz_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void mat3x3_from_euler_xyz_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t angles;
  load_vec3_single(&angles, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&angles, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_from_euler_xyz_certified(&angles, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_euler_xyz_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_euler_xyz_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_euler_xyz_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_from_euler_xyz_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_from_euler_xyz_loops[] = {
    mat3x3_from_euler_xyz_double, mat3x3_from_euler_xyz_single};

/* (3,3)->(3),(3) */
INLINED void euler_xyz_from_mat3x3_double_over(
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
    ksl_vec3_t angles;
    ksl_vec3_t angles_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_euler_xyz_from_mat3x3_certified(&R, &angles, &angles_bound);
    store_vec3_double(&angles, p1 + i * step[1], core + 2);
    store_vec3_double(&angles_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void euler_xyz_from_mat3x3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    euler_xyz_from_mat3x3_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    euler_xyz_from_mat3x3_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  euler_xyz_from_mat3x3_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3),(3) */
INLINED void euler_xyz_from_mat3x3_single_over(
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
    ksl_vec3f_t angles;
    ksl_vec3f_t angles_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_euler_xyz_from_mat3x3f_certified(&R, &angles, &angles_bound);
    store_vec3_single(&angles, p1 + i * step[1], core + 2);
    store_vec3_single(&angles_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void euler_xyz_from_mat3x3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    euler_xyz_from_mat3x3_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    euler_xyz_from_mat3x3_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  euler_xyz_from_mat3x3_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction euler_xyz_from_mat3x3_loops[] = {
    euler_xyz_from_mat3x3_double, euler_xyz_from_mat3x3_single};

/* (3)->(3,3),(3,3) */
INLINED void mat3x3_from_euler_xyx_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t angles;
  load_vec3_double(&angles, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&angles, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3_from_euler_xyx_certified(&angles, &R, &R_bound);
    store_mat3x3_double(&R, p1 + i * step[1], core + 1);
    store_mat3x3_double(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_euler_xyx_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_euler_xyx_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_euler_xyx_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_from_euler_xyx_double_over(data, n[0], step, step + 3);
}

/* (3)->(3,3),(3,3) */
INLINED void mat3x3_from_euler_xyx_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t angles;
  load_vec3_single(&angles, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&angles, p0 + i * step[0], core + 0);
    }
    ksl_mat3x3f_from_euler_xyx_certified(&angles, &R, &R_bound);
    store_mat3x3_single(&R, p1 + i * step[1], core + 1);
    store_mat3x3_single(&R_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_euler_xyx_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_euler_xyx_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_euler_xyx_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  mat3x3_from_euler_xyx_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction mat3x3_from_euler_xyx_loops[] = {
    mat3x3_from_euler_xyx_double, mat3x3_from_euler_xyx_single};

/* (3,3)->(3),(3) */
INLINED void euler_xyx_from_mat3x3_double_over(
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
    ksl_vec3_t angles;
    ksl_vec3_t angles_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    ksl_euler_xyx_from_mat3x3_certified(&R, &angles, &angles_bound);
    store_vec3_double(&angles, p1 + i * step[1], core + 2);
    store_vec3_double(&angles_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void euler_xyx_from_mat3x3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    euler_xyx_from_mat3x3_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    euler_xyx_from_mat3x3_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  euler_xyx_from_mat3x3_double_over(data, n[0], step, step + 3);
}

/* (3,3)->(3),(3) */
INLINED void euler_xyx_from_mat3x3_single_over(
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
    ksl_vec3f_t angles;
    ksl_vec3f_t angles_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    ksl_euler_xyx_from_mat3x3f_certified(&R, &angles, &angles_bound);
    store_vec3_single(&angles, p1 + i * step[1], core + 2);
    store_vec3_single(&angles_bound, p2 + i * step[2], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void euler_xyx_from_mat3x3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    euler_xyx_from_mat3x3_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    euler_xyx_from_mat3x3_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  euler_xyx_from_mat3x3_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction euler_xyx_from_mat3x3_loops[] = {
    euler_xyx_from_mat3x3_double, euler_xyx_from_mat3x3_single};

/* (3),()->(3,3),(3,3) */
INLINED void mat3x3_from_axis_angle_double_over(
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
    double angle;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    if (step[0] != 0) {
      load_vec3_double(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&angle, p1 + i * step[1], core + 1);
    ksl_mat3x3_from_axis_angle_certified(&axis, angle, &R, &R_bound);
    store_mat3x3_double(&R, p2 + i * step[2], core + 1);
    store_mat3x3_double(&R_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_axis_angle_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 8, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_axis_angle_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 72, 72, 8, 24, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_axis_angle_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_from_axis_angle_double_over(data, n[0], step, step + 4);
}

/* (3),()->(3,3),(3,3) */
INLINED void mat3x3_from_axis_angle_single_over(
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
    float angle;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    if (step[0] != 0) {
      load_vec3_single(&axis, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&angle, p1 + i * step[1], core + 1);
    ksl_mat3x3f_from_axis_angle_certified(&axis, angle, &R, &R_bound);
    store_mat3x3_single(&R, p2 + i * step[2], core + 1);
    store_mat3x3_single(&R_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void mat3x3_from_axis_angle_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 4, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    mat3x3_from_axis_angle_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 36, 36, 4, 12, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    mat3x3_from_axis_angle_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  mat3x3_from_axis_angle_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction mat3x3_from_axis_angle_loops[] = {
    mat3x3_from_axis_angle_double, mat3x3_from_axis_angle_single};

/* (3,3)->(),(3),(),(3) */
INLINED void axis_angle_from_mat3x3_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3_t R;
  load_mat3x3_double(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double angle;
    ksl_vec3_t axis;
    double angle_bound;
    ksl_vec3_t axis_bound;
    if (step[0] != 0) {
      load_mat3x3_double(&R, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_mat3x3_certified(&R, &axis, &angle_bound, &axis_bound);
    store_scalar_double(&angle, p1 + i * step[1], core + 2);
    store_vec3_double(&axis, p2 + i * step[2], core + 2);
    store_scalar_double(&angle_bound, p3 + i * step[3], core + 3);
    store_vec3_double(&axis_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axis_angle_from_mat3x3_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 72, 8, 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_mat3x3_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 24, 8, 24, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_mat3x3_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axis_angle_from_mat3x3_double_over(data, n[0], step, step + 5);
}

/* (3,3)->(),(3),(),(3) */
INLINED void axis_angle_from_mat3x3_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  ksl_mat3x3f_t R;
  load_mat3x3_single(&R, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float angle;
    ksl_vec3f_t axis;
    float angle_bound;
    ksl_vec3f_t axis_bound;
    if (step[0] != 0) {
      load_mat3x3_single(&R, p0 + i * step[0], core + 0);
    }
    angle = ksl_axis_angle_from_mat3x3f_certified(&R, &axis, &angle_bound, &axis_bound);
    store_scalar_single(&angle, p1 + i * step[1], core + 2);
    store_vec3_single(&axis, p2 + i * step[2], core + 2);
    store_scalar_single(&angle_bound, p3 + i * step[3], core + 3);
    store_vec3_single(&axis_bound, p4 + i * step[4], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void axis_angle_from_mat3x3_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 36, 4, 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    axis_angle_from_mat3x3_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 12, 4, 12, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    axis_angle_from_mat3x3_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  axis_angle_from_mat3x3_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction axis_angle_from_mat3x3_loops[] = {
    axis_angle_from_mat3x3_double, axis_angle_from_mat3x3_single};

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"acceleration_tensor", "(3),(3)->(3,3),(3,3)",
    "Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the\n"
    "acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3,3),(3,3).  w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "15 mul, 27 add, 3 neg, 9 abs.\n",
   2, 2, "", acceleration_tensor_loops},
  {"mat3x3_determinant", "(3,3)->(),()",
    "det R; |error of det| <= det_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.\n"
    "13 mul, 14 add, 9 abs.\n",
   1, 2, "", mat3x3_determinant_loops},
  {"mat3x3_setFromAxisDC", "(3),(2)->(3,3),(3,3)",
    "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),\n"
    "dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3),(2)->(3,3),(3,3).  axis: vector; dc: (sin θ, cos θ); R, R_bound: rotation or other 3×3\n"
    "matrix.\n"
    "30 mul, 31 add, 8 abs.\n",
   2, 2, "", mat3x3_setFromAxisDC_loops},
  {"mat3x3_from_euler_xyz", "(3)->(3,3),(3,3)",
    "R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select.\n",
   1, 2, "", mat3x3_from_euler_xyz_loops},
  {"euler_xyz_from_mat3x3", "(3,3)->(3),(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.\n"
    "455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12\n"
    "copysign, 59 less, 14 equal, 108 select.\n",
   1, 2, "R", euler_xyz_from_mat3x3_loops},
  {"mat3x3_from_euler_xyx", "(3)->(3,3),(3,3)",
    "R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select.\n",
   1, 2, "", mat3x3_from_euler_xyx_loops},
  {"euler_xyx_from_mat3x3", "(3,3)->(3),(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[0, π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.\n"
    "455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12\n"
    "copysign, 61 less, 14 equal, 110 select.\n",
   1, 2, "R", euler_xyx_from_mat3x3_loops},
  {"mat3x3_from_axis_angle", "(3),()->(3,3),(3,3)",
    "R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is\n"
    "not a rotation; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3,3),(3,3).  axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.\n"
    "216 mul, 380 add, 26 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select.\n",
   2, 2, "", mat3x3_from_axis_angle_loops},
  {"axis_angle_from_mat3x3", "(3,3)->(),(3),(),(3)",
    "angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;\n"
    "|error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(),(3),(),(3).  R: rotation or other 3×3 matrix; angle, angle_bound: number; axis,\n"
    "axis_bound: vector.\n"
    "233 mul, 467 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4\n"
    "copysign, 41 less, 7 equal, 111 select.\n",
   1, 4, "R", axis_angle_from_mat3x3_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
