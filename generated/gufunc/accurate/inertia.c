/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (),(3),(),(),(),(),(),()->(10) */
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
    J = ksl_inertia_accurate(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx);
    store_inertia_double(&J, p8 + i * step[8], core + 1);
  }
}

static void inertia_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 8, 8, 8, 8, 8, 8, 80, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_double_over(
        data, n[0], dense_1, dense_1 + 9);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8, 8, 8, 8, 8, 80, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_double_over(
        data, n[0], dense_2, dense_2 + 9);
    return;
  }
  inertia_double_over(data, n[0], step, step + 9);
}

/* (),(3),(),(),(),(),(),()->(10) */
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
    J = ksl_inertiaf_accurate(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx);
    store_inertia_single(&J, p8 + i * step[8], core + 1);
  }
}

static void inertia_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 4, 4, 4, 4, 4, 4, 40, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_single_over(
        data, n[0], dense_1, dense_1 + 9);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4, 4, 4, 4, 4, 40, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_single_over(
        data, n[0], dense_2, dense_2 + 9);
    return;
  }
  inertia_single_over(data, n[0], step, step + 9);
}

static PyUFuncGenericFunction inertia_loops[] = {
    inertia_double, inertia_single};

/* (10),(3,3)->(10) */
INLINED void inertia_rotated_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t R;
    ksl_inertia_t Jo;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_mat3x3_double(&R, p1 + i * step[1], core + 1);
    ksl_inertia_rotated_accurate(&Ji, &R, &Jo);
    store_inertia_double(&Jo, p2 + i * step[2], core + 3);
  }
}

static void inertia_rotated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 72, 80, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotated_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 80, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_rotated_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_rotated_double_over(data, n[0], step, step + 3);
}

/* (10),(3,3)->(10) */
INLINED void inertia_rotated_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t R;
    ksl_inertiaf_t Jo;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_mat3x3_single(&R, p1 + i * step[1], core + 1);
    ksl_inertiaf_rotated_accurate(&Ji, &R, &Jo);
    store_inertia_single(&Jo, p2 + i * step[2], core + 3);
  }
}

static void inertia_rotated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 36, 40, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotated_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 40, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_rotated_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_rotated_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_rotated_loops[] = {
    inertia_rotated_double, inertia_rotated_single};

/* (10),(3,3)->(10) */
INLINED void inertia_rotate_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_mat3x3_t R;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_mat3x3_double(&R, p1 + i * step[1], core + 1);
    ksl_inertia_rotate_accurate(&self, &R);
    store_inertia_double(&self, p2 + i * step[2], core + 3);
  }
}

static void inertia_rotate_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 72, 80, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotate_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_rotate_double_over(data, n[0], step, step + 3);
}

/* (10),(3,3)->(10) */
INLINED void inertia_rotate_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_mat3x3f_t R;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_mat3x3_single(&R, p1 + i * step[1], core + 1);
    ksl_inertiaf_rotate_accurate(&self, &R);
    store_inertia_single(&self, p2 + i * step[2], core + 3);
  }
}

static void inertia_rotate_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 36, 40, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_rotate_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_rotate_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_rotate_loops[] = {
    inertia_rotate_double, inertia_rotate_single};

/* (10),(3)->(10) */
INLINED void inertia_translated_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t t;
    ksl_inertia_t Jo;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&t, p1 + i * step[1], core + 1);
    ksl_inertia_translated_accurate(&Ji, &t, &Jo);
    store_inertia_double(&Jo, p2 + i * step[2], core + 2);
  }
}

static void inertia_translated_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translated_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 80, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_translated_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_translated_double_over(data, n[0], step, step + 3);
}

/* (10),(3)->(10) */
INLINED void inertia_translated_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t t;
    ksl_inertiaf_t Jo;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&t, p1 + i * step[1], core + 1);
    ksl_inertiaf_translated_accurate(&Ji, &t, &Jo);
    store_inertia_single(&Jo, p2 + i * step[2], core + 2);
  }
}

static void inertia_translated_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translated_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 40, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_translated_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_translated_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_translated_loops[] = {
    inertia_translated_double, inertia_translated_single};

/* (10),(3)->(10) */
INLINED void inertia_translate_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_vec3_t t;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_vec3_double(&t, p1 + i * step[1], core + 1);
    ksl_inertia_translate_accurate(&self, &t);
    store_inertia_double(&self, p2 + i * step[2], core + 2);
  }
}

static void inertia_translate_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translate_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_translate_double_over(data, n[0], step, step + 3);
}

/* (10),(3)->(10) */
INLINED void inertia_translate_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_vec3f_t t;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_vec3_single(&t, p1 + i * step[1], core + 1);
    ksl_inertiaf_translate_accurate(&self, &t);
    store_inertia_single(&self, p2 + i * step[2], core + 2);
  }
}

static void inertia_translate_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_translate_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_translate_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_translate_loops[] = {
    inertia_translate_double, inertia_translate_single};

/* (10),(3,4)->(10) */
INLINED void inertia_transformed_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t Ji;
  load_inertia_double(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3_t D;
    ksl_inertia_t Jo;
    if (step[0] != 0) {
      load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    }
    load_SE3_double(&D, p1 + i * step[1], core + 1);
    ksl_inertia_transformed_accurate(&Ji, &D, &Jo);
    store_inertia_double(&Jo, p2 + i * step[2], core + 3);
  }
}

static void inertia_transformed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 96, 80, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transformed_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 96, 80, 8, 32, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_transformed_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_transformed_double_over(data, n[0], step, step + 3);
}

/* (10),(3,4)->(10) */
INLINED void inertia_transformed_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t Ji;
  load_inertia_single(&Ji, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_SE3f_t D;
    ksl_inertiaf_t Jo;
    if (step[0] != 0) {
      load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    }
    load_SE3_single(&D, p1 + i * step[1], core + 1);
    ksl_inertiaf_transformed_accurate(&Ji, &D, &Jo);
    store_inertia_single(&Jo, p2 + i * step[2], core + 3);
  }
}

static void inertia_transformed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 48, 40, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transformed_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 40, 4, 16, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_transformed_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  inertia_transformed_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_transformed_loops[] = {
    inertia_transformed_double, inertia_transformed_single};

/* (10),(3,4)->(10) */
INLINED void inertia_transform_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t self;
    ksl_SE3_t D;
    load_inertia_double(&self, p0 + i * step[0], core + 0);
    load_SE3_double(&D, p1 + i * step[1], core + 1);
    ksl_inertia_transform_accurate(&self, &D);
    store_inertia_double(&self, p2 + i * step[2], core + 3);
  }
}

static void inertia_transform_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 96, 80, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transform_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_transform_double_over(data, n[0], step, step + 3);
}

/* (10),(3,4)->(10) */
INLINED void inertia_transform_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t self;
    ksl_SE3f_t D;
    load_inertia_single(&self, p0 + i * step[0], core + 0);
    load_SE3_single(&D, p1 + i * step[1], core + 1);
    ksl_inertiaf_transform_accurate(&self, &D);
    store_inertia_single(&self, p2 + i * step[2], core + 3);
  }
}

static void inertia_transform_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 48, 40, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_transform_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  inertia_transform_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction inertia_transform_loops[] = {
    inertia_transform_double, inertia_transform_single};

/* (10),(3),(10),(3),(3,4)->(10) */
INLINED void inertia_merge_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  char *const p5 = data[5];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t Ji;
    ksl_vec3_t t_ic;
    ksl_inertia_t Jj;
    ksl_vec3_t t_jc;
    ksl_SE3_t D_ij;
    load_inertia_double(&Ji, p0 + i * step[0], core + 0);
    load_vec3_double(&t_ic, p1 + i * step[1], core + 1);
    load_inertia_double(&Jj, p2 + i * step[2], core + 2);
    load_vec3_double(&t_jc, p3 + i * step[3], core + 3);
    load_SE3_double(&D_ij, p4 + i * step[4], core + 4);
    ksl_inertia_merge_accurate(&Ji, &t_ic, &Jj, &t_jc, &D_ij);
    store_inertia_double(&Ji, p5 + i * step[5], core + 6);
  }
}

static void inertia_merge_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 80, 24, 96, 80, 8, 8, 8, 8, 32, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_merge_double_over(
        data, n[0], dense_1, dense_1 + 6);
    return;
  }
  inertia_merge_double_over(data, n[0], step, step + 6);
}

/* (10),(3),(10),(3),(3,4)->(10) */
INLINED void inertia_merge_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  char *const p5 = data[5];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t Ji;
    ksl_vec3f_t t_ic;
    ksl_inertiaf_t Jj;
    ksl_vec3f_t t_jc;
    ksl_SE3f_t D_ij;
    load_inertia_single(&Ji, p0 + i * step[0], core + 0);
    load_vec3_single(&t_ic, p1 + i * step[1], core + 1);
    load_inertia_single(&Jj, p2 + i * step[2], core + 2);
    load_vec3_single(&t_jc, p3 + i * step[3], core + 3);
    load_SE3_single(&D_ij, p4 + i * step[4], core + 4);
    ksl_inertiaf_merge_accurate(&Ji, &t_ic, &Jj, &t_jc, &D_ij);
    store_inertia_single(&Ji, p5 + i * step[5], core + 6);
  }
}

static void inertia_merge_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 40, 12, 48, 40, 4, 4, 4, 4, 16, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_merge_single_over(
        data, n[0], dense_1, dense_1 + 6);
    return;
  }
  inertia_merge_single_over(data, n[0], step, step + 6);
}

static PyUFuncGenericFunction inertia_merge_loops[] = {
    inertia_merge_double, inertia_merge_single};

const coscrew_gufunc TABLE(inertia)[] = {
  {"inertia", "(),(3),(),(),(),(),(),()->(10)",
    "J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the\n"
    "moments' matrix about it in kg m^2, Ixy = -∫ x y dm.\n"
    "\n"
    "(),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:\n"
    "inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in\n"
    "kg m^2).\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   8, 1, "", inertia_loops},
  {"inertia_rotated", "(10),(3,3)->(10)",
    "Jo = Ji rotated by R: m, R mt, R I R^T.\n"
    "\n"
    "(10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_rotated_loops},
  {"inertia_rotate", "(10),(3,3)->(10)",
    "self = self rotated by R: m, R mt, R I R^T.\n"
    "\n"
    "(10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_rotate_loops},
  {"inertia_translated", "(10),(3)->(10)",
    "Jo = Ji translated by t: m, mt + m t, I.\n"
    "\n"
    "(10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", inertia_translated_loops},
  {"inertia_translate", "(10),(3)->(10)",
    "self = self translated by t: m, mt + m t, I.\n"
    "\n"
    "(10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,\n"
    "yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", inertia_translate_loops},
  {"inertia_transformed", "(10),(3,4)->(10)",
    "Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.\n"
    "\n"
    "(10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.\n"
    "75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_transformed_loops},
  {"inertia_transform", "(10),(3,4)->(10)",
    "self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.\n"
    "\n"
    "(10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.\n"
    "75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_transform_loops},
  {"inertia_merge", "(10),(3),(10),(3),(3,4)->(10)",
    "Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,\n"
    "mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =\n"
    "c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own\n"
    "frame; NaN where m_i + m_j = 0.\n"
    "\n"
    "(10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement\n"
    "[R | t], R rotation, t in m.\n"
    "109 mul, 401 add, 5 product error, 66 product rest, 2 div, 10 equal, 10 select.  Error <= 18\n"
    "u times the sum of the absolute values of all terms, for masses that are not negative,\n"
    "barring over- and underflow.\n",
   5, 1, "....R", inertia_merge_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
