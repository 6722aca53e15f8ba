/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (),(3),(),(),(),(),(),()->(10),(10) */
INLINED void inertia_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  char *const p5 = data[5];
  char *const p6 = data[6];
  char *const p7 = data[7];
  char *const p8 = data[8];
  char *const p9 = data[9];
  if (n <= 0) {
    return;
  }
  double m;
  load_scalar_double(&m, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t t;
    double Ixx;
    double Iyy;
    double Izz;
    double Ixy;
    double Iyz;
    double Izx;
    ksl_inertia_t J;
    ksl_inertia_t J_bound;
    if (step[0] != 0) {
      load_scalar_double(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 0);
    load_scalar_double(&Ixx, p2 + i * step[2], core + 1);
    load_scalar_double(&Iyy, p3 + i * step[3], core + 1);
    load_scalar_double(&Izz, p4 + i * step[4], core + 1);
    load_scalar_double(&Ixy, p5 + i * step[5], core + 1);
    load_scalar_double(&Iyz, p6 + i * step[6], core + 1);
    load_scalar_double(&Izx, p7 + i * step[7], core + 1);
    J = ksl_inertia_certified(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx, &J_bound);
    store_inertia_double(&J, p8 + i * step[8], core + 1);
    store_inertia_double(&J_bound, p9 + i * step[9], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 8, 8, 8, 8, 8, 8, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_double_over(
        data, n[0], dense_1, dense_1 + 10);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8, 8, 8, 8, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_double_over(
        data, n[0], dense_2, dense_2 + 10);
    return;
  }
  inertia_double_over(data, n[0], step, step + 10);
}

/* (),(3),(),(),(),(),(),()->(10),(10) */
INLINED void inertia_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  char *const p5 = data[5];
  char *const p6 = data[6];
  char *const p7 = data[7];
  char *const p8 = data[8];
  char *const p9 = data[9];
  if (n <= 0) {
    return;
  }
  float m;
  load_scalar_single(&m, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t t;
    float Ixx;
    float Iyy;
    float Izz;
    float Ixy;
    float Iyz;
    float Izx;
    ksl_inertiaf_t J;
    ksl_inertiaf_t J_bound;
    if (step[0] != 0) {
      load_scalar_single(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 0);
    load_scalar_single(&Ixx, p2 + i * step[2], core + 1);
    load_scalar_single(&Iyy, p3 + i * step[3], core + 1);
    load_scalar_single(&Izz, p4 + i * step[4], core + 1);
    load_scalar_single(&Ixy, p5 + i * step[5], core + 1);
    load_scalar_single(&Iyz, p6 + i * step[6], core + 1);
    load_scalar_single(&Izx, p7 + i * step[7], core + 1);
    J = ksl_inertiaf_certified(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx, &J_bound);
    store_inertia_single(&J, p8 + i * step[8], core + 1);
    store_inertia_single(&J_bound, p9 + i * step[9], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 4, 4, 4, 4, 4, 4, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_single_over(
        data, n[0], dense_1, dense_1 + 10);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4, 4, 4, 4, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_single_over(
        data, n[0], dense_2, dense_2 + 10);
    return;
  }
  inertia_single_over(data, n[0], step, step + 10);
}

static PyUFuncGenericFunction inertia_loops[] = {
    inertia_double, inertia_single};

/* (10),(3,3)->(10),(10) */
INLINED void inertia_rotated_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R, p1 + i * step[1], core + 1);
    ksl_inertia_rotated_certified(&Ji, &R, &Jo, &Jo_bound);
    store_inertia_double(&Jo, p2 + i * step[2], core + 3);
    store_inertia_double(&Jo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_rotated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 72, 80, 80, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotated_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 80, 80, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_rotated_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_rotated_double_over(data, n[0], step, step + 4);
}

/* (10),(3,3)->(10),(10) */
INLINED void inertia_rotated_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R, p1 + i * step[1], core + 1);
    ksl_inertiaf_rotated_certified(&Ji, &R, &Jo, &Jo_bound);
    store_inertia_single(&Jo, p2 + i * step[2], core + 3);
    store_inertia_single(&Jo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_rotated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 36, 40, 40, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotated_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 40, 40, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_rotated_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_rotated_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_rotated_loops[] = {
    inertia_rotated_double, inertia_rotated_single};

/* (10),(3,3)->(10),(10) */
INLINED void inertia_rotate_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_mat3x3_t R;
    ksl_inertia_t self_bound;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_mat3x3_double(&R, p1 + i * step[1], core + 1);
    ksl_inertia_rotate_certified(&self, &R, &self_bound);
    store_inertia_double(&self, p2 + i * step[2], core + 3);
    store_inertia_double(&self_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_rotate_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 72, 80, 80, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotate_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_rotate_double_over(data, n[0], step, step + 4);
}

/* (10),(3,3)->(10),(10) */
INLINED void inertia_rotate_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_mat3x3f_t R;
    ksl_inertiaf_t self_bound;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_mat3x3_single(&R, p1 + i * step[1], core + 1);
    ksl_inertiaf_rotate_certified(&self, &R, &self_bound);
    store_inertia_single(&self, p2 + i * step[2], core + 3);
    store_inertia_single(&self_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_rotate_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 36, 40, 40, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotate_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_rotate_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_rotate_loops[] = {
    inertia_rotate_double, inertia_rotate_single};

/* (10),(3)->(10),(10) */
INLINED void inertia_translated_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t t;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 1);
    ksl_inertia_translated_certified(&Ji, &t, &Jo, &Jo_bound);
    store_inertia_double(&Jo, p2 + i * step[2], core + 2);
    store_inertia_double(&Jo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_translated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translated_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_translated_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_translated_double_over(data, n[0], step, step + 4);
}

/* (10),(3)->(10),(10) */
INLINED void inertia_translated_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t t;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 1);
    ksl_inertiaf_translated_certified(&Ji, &t, &Jo, &Jo_bound);
    store_inertia_single(&Jo, p2 + i * step[2], core + 2);
    store_inertia_single(&Jo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_translated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translated_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_translated_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_translated_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_translated_loops[] = {
    inertia_translated_double, inertia_translated_single};

/* (10),(3)->(10),(10) */
INLINED void inertia_translate_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_vec3_t t;
    ksl_inertia_t self_bound;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_vec3_double(&t, p1 + i * step[1], core + 1);
    ksl_inertia_translate_certified(&self, &t, &self_bound);
    store_inertia_double(&self, p2 + i * step[2], core + 2);
    store_inertia_double(&self_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_translate_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translate_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_translate_double_over(data, n[0], step, step + 4);
}

/* (10),(3)->(10),(10) */
INLINED void inertia_translate_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_vec3f_t t;
    ksl_inertiaf_t self_bound;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_vec3_single(&t, p1 + i * step[1], core + 1);
    ksl_inertiaf_translate_certified(&self, &t, &self_bound);
    store_inertia_single(&self, p2 + i * step[2], core + 2);
    store_inertia_single(&self_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_translate_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translate_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_translate_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_translate_loops[] = {
    inertia_translate_double, inertia_translate_single};

/* (10),(3,4)->(10),(10) */
INLINED void inertia_transformed_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D, p1 + i * step[1], core + 1);
    ksl_inertia_transformed_certified(&Ji, &D, &Jo, &Jo_bound);
    store_inertia_double(&Jo, p2 + i * step[2], core + 3);
    store_inertia_double(&Jo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_transformed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 96, 80, 80, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transformed_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 80, 80, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_transformed_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_transformed_double_over(data, n[0], step, step + 4);
}

/* (10),(3,4)->(10),(10) */
INLINED void inertia_transformed_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D, p1 + i * step[1], core + 1);
    ksl_inertiaf_transformed_certified(&Ji, &D, &Jo, &Jo_bound);
    store_inertia_single(&Jo, p2 + i * step[2], core + 3);
    store_inertia_single(&Jo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_transformed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 48, 40, 40, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transformed_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 40, 40, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_transformed_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  inertia_transformed_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_transformed_loops[] = {
    inertia_transformed_double, inertia_transformed_single};

/* (10),(3,4)->(10),(10) */
INLINED void inertia_transform_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_SE3_t D;
    ksl_inertia_t self_bound;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_SE3_double(&D, p1 + i * step[1], core + 1);
    ksl_inertia_transform_certified(&self, &D, &self_bound);
    store_inertia_double(&self, p2 + i * step[2], core + 3);
    store_inertia_double(&self_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_transform_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 96, 80, 80, 8, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transform_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_transform_double_over(data, n[0], step, step + 4);
}

/* (10),(3,4)->(10),(10) */
INLINED void inertia_transform_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_SE3f_t D;
    ksl_inertiaf_t self_bound;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_SE3_single(&D, p1 + i * step[1], core + 1);
    ksl_inertiaf_transform_certified(&self, &D, &self_bound);
    store_inertia_single(&self, p2 + i * step[2], core + 3);
    store_inertia_single(&self_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void inertia_transform_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 48, 40, 40, 4, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transform_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  inertia_transform_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction inertia_transform_loops[] = {
    inertia_transform_double, inertia_transform_single};

const coscrew_gufunc TABLE(inertia)[] = {
  {"inertia", "(),(3),(),(),(),(),(),()->(10),(10)",
    "J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the\n"
    "moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(),(3),(),(),(),(),(),()->(10),(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J,\n"
    "J_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,\n"
    "yz, zx in kg m^2).\n"
    "6 mul, 3 add, 3 abs.\n",
   8, 2, "", inertia_loops},
  {"inertia_rotated", "(10),(3,3)->(10),(10)",
    "Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.\n"
    "\n"
    "(10),(3,3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "81 mul, 90 add, 45 abs.\n",
   2, 2, ".R", inertia_rotated_loops},
  {"inertia_rotate", "(10),(3,3)->(10),(10)",
    "self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(10),(3,3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "81 mul, 90 add, 45 abs.\n",
   2, 2, ".R", inertia_rotate_loops},
  {"inertia_translated", "(10),(3)->(10),(10)",
    "Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.\n"
    "\n"
    "(10),(3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "", inertia_translated_loops},
  {"inertia_translate", "(10),(3)->(10),(10)",
    "self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(10),(3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "", inertia_translate_loops},
  {"inertia_transformed", "(10),(3,4)->(10),(10)",
    "Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(10),(3,4)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t\n"
    "in m.\n"
    "84 mul, 96 add, 48 abs.\n",
   2, 2, ".R", inertia_transformed_loops},
  {"inertia_transform", "(10),(3,4)->(10),(10)",
    "self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(10),(3,4)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t\n"
    "in m.\n"
    "84 mul, 96 add, 48 abs.\n",
   2, 2, ".R", inertia_transform_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
