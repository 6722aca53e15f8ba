/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the spatial_inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (10),()->(10) */
INLINED void spatial_inertia_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t self;
    double a;
    load_spatial_inertia_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_spatial_inertia_scale_accurate(&self, a);
    store_spatial_inertia_double(&self, p2 + i * step[2], core + 1);
  }
}

static void spatial_inertia_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 8, 80, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_scale_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  spatial_inertia_scale_double_over(data, n[0], step, step + 3);
}

/* (10),()->(10) */
INLINED void spatial_inertia_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t self;
    float a;
    load_spatial_inertia_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_spatial_inertiaf_scale_accurate(&self, a);
    store_spatial_inertia_single(&self, p2 + i * step[2], core + 1);
  }
}

static void spatial_inertia_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 4, 40, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_scale_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  spatial_inertia_scale_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction spatial_inertia_scale_loops[] = {
    spatial_inertia_scale_double, spatial_inertia_scale_single};

/* (10),(10)->(10) */
INLINED void add_BB_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B1;
  load_spatial_inertia_double(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B2, p1 + i * step[1], core + 1);
    ksl_add_BB_accurate(&B1, &B2, &Bo);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
  }
}

static void add_BB_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_BB_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_BB_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_BB_double_over(data, n[0], step, step + 3);
}

/* (10),(10)->(10) */
INLINED void add_BB_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B1;
  load_spatial_inertia_single(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B2, p1 + i * step[1], core + 1);
    ksl_add_BBf_accurate(&B1, &B2, &Bo);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
  }
}

static void add_BB_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_BB_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_BB_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  add_BB_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction add_BB_loops[] = {
    add_BB_double, add_BB_single};

/* (10),(10)->(10) */
INLINED void subtract_BB_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B1;
  load_spatial_inertia_double(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B2, p1 + i * step[1], core + 1);
    ksl_subtract_BB_accurate(&B1, &B2, &Bo);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
  }
}

static void subtract_BB_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_BB_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_BB_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_BB_double_over(data, n[0], step, step + 3);
}

/* (10),(10)->(10) */
INLINED void subtract_BB_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B1;
  load_spatial_inertia_single(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B2, p1 + i * step[1], core + 1);
    ksl_subtract_BBf_accurate(&B1, &B2, &Bo);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
  }
}

static void subtract_BB_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_BB_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_BB_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  subtract_BB_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction subtract_BB_loops[] = {
    subtract_BB_double, subtract_BB_single};

/* (),(3),(3,3)->(10) */
INLINED void spatial_inertia_from_com_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double m;
  load_scalar_double(&m, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t com;
    ksl_mat3x3_t Ic;
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_scalar_double(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&com, p1 + i * step[1], core + 0);
    load_mat3x3_double(&Ic, p2 + i * step[2], core + 1);
    ksl_spatial_inertia_from_com_accurate(m, &com, &Ic, &Bo);
    store_spatial_inertia_double(&Bo, p3 + i * step[3], core + 3);
  }
}

static void spatial_inertia_from_com_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 72, 80, 8, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_com_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 72, 80, 8, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_com_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_from_com_double_over(data, n[0], step, step + 4);
}

/* (),(3),(3,3)->(10) */
INLINED void spatial_inertia_from_com_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float m;
  load_scalar_single(&m, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t com;
    ksl_mat3x3f_t Ic;
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_scalar_single(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&com, p1 + i * step[1], core + 0);
    load_mat3x3_single(&Ic, p2 + i * step[2], core + 1);
    ksl_spatial_inertiaf_from_com_accurate(m, &com, &Ic, &Bo);
    store_spatial_inertia_single(&Bo, p3 + i * step[3], core + 3);
  }
}

static void spatial_inertia_from_com_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 36, 40, 4, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_com_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 36, 40, 4, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_com_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_from_com_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_from_com_loops[] = {
    spatial_inertia_from_com_double, spatial_inertia_from_com_single};

/* (10)->(10) */
INLINED void spatial_inertia_from_inertia_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_inertia_t J;
  load_inertia_double(&J, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_inertia_double(&J, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertia_from_inertia_accurate(&J, &Bo);
    store_spatial_inertia_double(&Bo, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_from_inertia_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_inertia_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_inertia_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_from_inertia_double_over(data, n[0], step, step + 2);
}

/* (10)->(10) */
INLINED void spatial_inertia_from_inertia_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_inertiaf_t J;
  load_inertia_single(&J, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_inertia_single(&J, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertiaf_from_inertia_accurate(&J, &Bo);
    store_spatial_inertia_single(&Bo, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_from_inertia_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_inertia_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_inertia_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_from_inertia_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction spatial_inertia_from_inertia_loops[] = {
    spatial_inertia_from_inertia_double, spatial_inertia_from_inertia_single};

/* (10)->(10) */
INLINED void inertia_from_spatial_inertia_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertia_t Jo;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    ksl_inertia_from_spatial_inertia_accurate(&B, &Jo);
    store_inertia_double(&Jo, p1 + i * step[1], core + 1);
  }
}

static void inertia_from_spatial_inertia_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_from_spatial_inertia_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_from_spatial_inertia_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  inertia_from_spatial_inertia_double_over(data, n[0], step, step + 2);
}

/* (10)->(10) */
INLINED void inertia_from_spatial_inertia_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_inertiaf_t Jo;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    ksl_inertiaf_from_spatial_inertia_accurate(&B, &Jo);
    store_inertia_single(&Jo, p1 + i * step[1], core + 1);
  }
}

static void inertia_from_spatial_inertia_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    inertia_from_spatial_inertia_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    inertia_from_spatial_inertia_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  inertia_from_spatial_inertia_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction inertia_from_spatial_inertia_loops[] = {
    inertia_from_spatial_inertia_double, inertia_from_spatial_inertia_single};

/* (10)->(3) */
INLINED void spatial_inertia_com_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t vo;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertia_com_accurate(&B, &vo);
    store_vec3_double(&vo, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_com_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_com_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_com_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_com_double_over(data, n[0], step, step + 2);
}

/* (10)->(3) */
INLINED void spatial_inertia_com_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t vo;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertiaf_com_accurate(&B, &vo);
    store_vec3_single(&vo, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_com_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_com_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_com_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_com_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction spatial_inertia_com_loops[] = {
    spatial_inertia_com_double, spatial_inertia_com_single};

/* (10)->(3,3) */
INLINED void spatial_inertia_about_com_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3_t Ro;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertia_about_com_accurate(&B, &Ro);
    store_mat3x3_double(&Ro, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_about_com_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 72, 8, 24, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_about_com_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 72, 8, 24, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_about_com_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_about_com_double_over(data, n[0], step, step + 2);
}

/* (10)->(3,3) */
INLINED void spatial_inertia_about_com_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat3x3f_t Ro;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    ksl_spatial_inertiaf_about_com_accurate(&B, &Ro);
    store_mat3x3_single(&Ro, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_about_com_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 36, 4, 12, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_about_com_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 36, 4, 12, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_about_com_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_about_com_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction spatial_inertia_about_com_loops[] = {
    spatial_inertia_about_com_double, spatial_inertia_about_com_single};

/* (10),(6)->(6) */
INLINED void product_Bs_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s, p1 + i * step[1], core + 1);
    ksl_product_Bs_accurate(&B, &s, &co);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
  }
}

static void product_Bs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Bs_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Bs_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Bs_double_over(data, n[0], step, step + 3);
}

/* (10),(6)->(6) */
INLINED void product_Bs_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s, p1 + i * step[1], core + 1);
    ksl_product_Bsf_accurate(&B, &s, &co);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
  }
}

static void product_Bs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Bs_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Bs_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  product_Bs_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction product_Bs_loops[] = {
    product_Bs_double, product_Bs_single};

/* (10),(6)->() */
INLINED void spatial_inertia_energy_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screw_t s;
    double energy;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s, p1 + i * step[1], core + 1);
    energy = ksl_spatial_inertia_energy_accurate(&B, &s);
    store_scalar_double(&energy, p2 + i * step[2], core + 2);
  }
}

static void spatial_inertia_energy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 48, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_energy_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_energy_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_energy_double_over(data, n[0], step, step + 3);
}

/* (10),(6)->() */
INLINED void spatial_inertia_energy_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_screwf_t s;
    float energy;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s, p1 + i * step[1], core + 1);
    energy = ksl_spatial_inertiaf_energy_accurate(&B, &s);
    store_scalar_single(&energy, p2 + i * step[2], core + 2);
  }
}

static void spatial_inertia_energy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 24, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_energy_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_energy_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_energy_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction spatial_inertia_energy_loops[] = {
    spatial_inertia_energy_double, spatial_inertia_energy_single};

/* (10),(3),(6)->(6) */
INLINED void spatial_inertia_net_wrench_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3_t w;
    ksl_screw_t ds;
    ksl_coscrew_t co;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&w, p1 + i * step[1], core + 1);
    load_screw_double(&ds, p2 + i * step[2], core + 2);
    ksl_spatial_inertia_net_wrench_accurate(&B, &w, &ds, &co);
    store_coscrew_double(&co, p3 + i * step[3], core + 3);
  }
}

static void spatial_inertia_net_wrench_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_net_wrench_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_net_wrench_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_net_wrench_double_over(data, n[0], step, step + 4);
}

/* (10),(3),(6)->(6) */
INLINED void spatial_inertia_net_wrench_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec3f_t w;
    ksl_screwf_t ds;
    ksl_coscrewf_t co;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&w, p1 + i * step[1], core + 1);
    load_screw_single(&ds, p2 + i * step[2], core + 2);
    ksl_spatial_inertiaf_net_wrench_accurate(&B, &w, &ds, &co);
    store_coscrew_single(&co, p3 + i * step[3], core + 3);
  }
}

static void spatial_inertia_net_wrench_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_net_wrench_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_net_wrench_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_net_wrench_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_net_wrench_loops[] = {
    spatial_inertia_net_wrench_double, spatial_inertia_net_wrench_single};

/* (3),(10)->(10) */
INLINED void spatial_inertia_shifted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B, p1 + i * step[1], core + 1);
    ksl_spatial_inertia_shifted_accurate(&t, &B, &Bo);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
  }
}

static void spatial_inertia_shifted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_shifted_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_shifted_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_shifted_double_over(data, n[0], step, step + 3);
}

/* (3),(10)->(10) */
INLINED void spatial_inertia_shifted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B, p1 + i * step[1], core + 1);
    ksl_spatial_inertiaf_shifted_accurate(&t, &B, &Bo);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
  }
}

static void spatial_inertia_shifted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_shifted_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_shifted_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_shifted_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction spatial_inertia_shifted_loops[] = {
    spatial_inertia_shifted_double, spatial_inertia_shifted_single};

/* (3,4),(10)->(10) */
INLINED void spatial_inertia_transformed_double_over(
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
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B, p1 + i * step[1], core + 2);
    ksl_spatial_inertia_transformed_accurate(&D, &B, &Bo);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 3);
  }
}

static void spatial_inertia_transformed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 80, 80, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_transformed_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_transformed_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_transformed_double_over(data, n[0], step, step + 3);
}

/* (3,4),(10)->(10) */
INLINED void spatial_inertia_transformed_single_over(
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
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B, p1 + i * step[1], core + 2);
    ksl_spatial_inertiaf_transformed_accurate(&D, &B, &Bo);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 3);
  }
}

static void spatial_inertia_transformed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 40, 40, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_transformed_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_transformed_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  spatial_inertia_transformed_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction spatial_inertia_transformed_loops[] = {
    spatial_inertia_transformed_double, spatial_inertia_transformed_single};

/* (10)->() */
INLINED void spatial_inertia_consistency_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B;
  load_spatial_inertia_double(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double pivot;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    pivot = ksl_spatial_inertia_consistency_accurate(&B);
    store_scalar_double(&pivot, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_consistency_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_consistency_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_consistency_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_consistency_double_over(data, n[0], step, step + 2);
}

/* (10)->() */
INLINED void spatial_inertia_consistency_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B;
  load_spatial_inertia_single(&B, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float pivot;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    pivot = ksl_spatial_inertiaf_consistency_accurate(&B);
    store_scalar_single(&pivot, p1 + i * step[1], core + 1);
  }
}

static void spatial_inertia_consistency_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_consistency_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_consistency_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  spatial_inertia_consistency_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction spatial_inertia_consistency_loops[] = {
    spatial_inertia_consistency_double, spatial_inertia_consistency_single};

const coscrew_gufunc TABLE(spatial_inertia)[] = {
  {"spatial_inertia_scale", "(10),()->(10)",
    "self = a self.\n"
    "\n"
    "(10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); a: number.\n"
    "10 mul, 10 add, 10 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", spatial_inertia_scale_loops},
  {"add_BB", "(10),(10)->(10)",
    "Bo = B1 + B2.\n"
    "\n"
    "(10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "70 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_BB_loops},
  {"subtract_BB", "(10),(10)->(10)",
    "Bo = B1 - B2.\n"
    "\n"
    "(10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "70 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_BB_loops},
  {"spatial_inertia_from_com", "(),(3),(3,3)->(10)",
    "Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle\n"
    "is read): h = m com, I = Ic - m com~ com~.\n"
    "\n"
    "(),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial\n"
    "inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "15 mul, 66 add, 3 product error, 9 product rest.  Error <= u |result| + (m: 0, h: 0, I: 15)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   3, 1, "", spatial_inertia_from_com_loops},
  {"spatial_inertia_from_inertia", "(10)->(10)",
    "Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of\n"
    "mass; NaN where m = 0.\n"
    "\n"
    "(10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,\n"
    "zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the\n"
    "origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a\n"
    "moment <= 4 u times the sum of its |terms|, barring over- and underflow.\n",
   1, 1, "", spatial_inertia_from_inertia_loops},
  {"inertia_from_spatial_inertia", "(10)->(10)",
    "Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of\n"
    "mass; NaN where m = 0.\n"
    "\n"
    "(10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2).\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a\n"
    "moment <= 4 u times the sum of its |terms|, barring over- and underflow.\n",
   1, 1, "", inertia_from_spatial_inertia_loops},
  {"spatial_inertia_com", "(10)->(3)",
    "vo = h / m, the centre of mass in m.\n"
    "\n"
    "(10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); vo: vector.\n"
    "3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.  Error <= u |result|, barring over-\n"
    "and underflow.\n",
   1, 1, "", spatial_inertia_com_loops},
  {"spatial_inertia_about_com", "(10)->(3,3)",
    "Ro = I + h~ h~ / m, the second moments about the centre of mass.\n"
    "\n"
    "(10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.\n",
   1, 1, "", spatial_inertia_about_com_loops},
  {"product_Bs", "(10),(6)->(6)",
    "co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.\n"
    "\n"
    "(10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).\n"
    "24 mul, 102 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 19) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Bs_loops},
  {"spatial_inertia_energy", "(10),(6)->()",
    "s·B s / 2, the kinetic energy in J of a body that moves with s.\n"
    "\n"
    "(10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.\n"
    "34 mul, 142 add, 25 product rest.  Error <= u |result| + 44 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", spatial_inertia_energy_loops},
  {"spatial_inertia_net_wrench", "(10),(3),(6)->(6)",
    "co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular\n"
    "velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if\n"
    "a is less gravity's, so is the wrench.\n"
    "\n"
    "(10),(3),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,\n"
    "yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f\n"
    "in N; τ in N m).\n"
    "63 mul, 324 add, 3 product error, 51 product rest, 6 neg.  Error <= u |result| + (lin: 36,\n"
    "ang: 42) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and\n"
    "underflow.\n",
   3, 1, "", spatial_inertia_net_wrench_loops},
  {"spatial_inertia_shifted", "(3),(10)->(10)",
    "Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.\n"
    "\n"
    "(3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the\n"
    "origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "33 mul, 138 add, 6 product error, 6 product rest.  Error <= u |result| + (m: 0, h: 2, I: 20)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", spatial_inertia_shifted_loops},
  {"spatial_inertia_transformed", "(3,4),(10)->(10)",
    "Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.\n"
    "\n"
    "(3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in\n"
    "kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "105 mul, 420 add, 6 product error, 60 product rest.  Error <= u |result| + (m: 0, h: 16, I:\n"
    "35) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", spatial_inertia_transformed_loops},
  {"spatial_inertia_consistency", "(10)->()",
    "the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:\n"
    "positive exactly if a body of positive density has this inertia.\n"
    "\n"
    "(10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,\n"
    "xz, yz in kg m^2); pivot: number.\n"
    "42 mul, 258 add, 10 product error, 10 product rest, 20 div, 6 neg, 9 less, 1 equal, 26\n"
    "select.\n",
   1, 1, "", spatial_inertia_consistency_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
