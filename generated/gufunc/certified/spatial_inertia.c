/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the spatial_inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (10),()->(10),(10) */
INLINED void spatial_inertia_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t self;
    double a;
    ksl_spatial_inertia_t self_bound;
    load_spatial_inertia_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_spatial_inertia_scale_certified(&self, a, &self_bound);
    store_spatial_inertia_double(&self, p2 + i * step[2], core + 1);
    store_spatial_inertia_double(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 8, 80, 80, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_scale_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  spatial_inertia_scale_double_over(data, n[0], step, step + 4);
}

/* (10),()->(10),(10) */
INLINED void spatial_inertia_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t self;
    float a;
    ksl_spatial_inertiaf_t self_bound;
    load_spatial_inertia_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_spatial_inertiaf_scale_certified(&self, a, &self_bound);
    store_spatial_inertia_single(&self, p2 + i * step[2], core + 1);
    store_spatial_inertia_single(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 4, 40, 40, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_scale_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  spatial_inertia_scale_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_scale_loops[] = {
    spatial_inertia_scale_double, spatial_inertia_scale_single};

/* (10),(10)->(10),(10) */
INLINED void add_BB_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B1;
  load_spatial_inertia_double(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B2, p1 + i * step[1], core + 1);
    ksl_add_BB_certified(&B1, &B2, &Bo, &Bo_bound);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_double(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_BB_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_BB_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_BB_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_BB_double_over(data, n[0], step, step + 4);
}

/* (10),(10)->(10),(10) */
INLINED void add_BB_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B1;
  load_spatial_inertia_single(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B2, p1 + i * step[1], core + 1);
    ksl_add_BBf_certified(&B1, &B2, &Bo, &Bo_bound);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_single(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void add_BB_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    add_BB_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    add_BB_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  add_BB_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction add_BB_loops[] = {
    add_BB_double, add_BB_single};

/* (10),(10)->(10),(10) */
INLINED void subtract_BB_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertia_t B1;
  load_spatial_inertia_double(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B2, p1 + i * step[1], core + 1);
    ksl_subtract_BB_certified(&B1, &B2, &Bo, &Bo_bound);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_double(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_BB_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_BB_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_BB_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_BB_double_over(data, n[0], step, step + 4);
}

/* (10),(10)->(10),(10) */
INLINED void subtract_BB_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_spatial_inertiaf_t B1;
  load_spatial_inertia_single(&B1, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B1, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B2, p1 + i * step[1], core + 1);
    ksl_subtract_BBf_certified(&B1, &B2, &Bo, &Bo_bound);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_single(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void subtract_BB_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    subtract_BB_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    subtract_BB_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  subtract_BB_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction subtract_BB_loops[] = {
    subtract_BB_double, subtract_BB_single};

/* (),(3),(3,3)->(10),(10) */
INLINED void spatial_inertia_from_com_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
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
    ksl_spatial_inertia_t Bo_bound;
    if (step[0] != 0) {
      load_scalar_double(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&com, p1 + i * step[1], core + 0);
    load_mat3x3_double(&Ic, p2 + i * step[2], core + 1);
    ksl_spatial_inertia_from_com_certified(m, &com, &Ic, &Bo, &Bo_bound);
    store_spatial_inertia_double(&Bo, p3 + i * step[3], core + 3);
    store_spatial_inertia_double(&Bo_bound, p4 + i * step[4], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_from_com_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 24, 72, 80, 80, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_com_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 72, 80, 80, 8, 24, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_com_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  spatial_inertia_from_com_double_over(data, n[0], step, step + 5);
}

/* (),(3),(3,3)->(10),(10) */
INLINED void spatial_inertia_from_com_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
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
    ksl_spatial_inertiaf_t Bo_bound;
    if (step[0] != 0) {
      load_scalar_single(&m, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&com, p1 + i * step[1], core + 0);
    load_mat3x3_single(&Ic, p2 + i * step[2], core + 1);
    ksl_spatial_inertiaf_from_com_certified(m, &com, &Ic, &Bo, &Bo_bound);
    store_spatial_inertia_single(&Bo, p3 + i * step[3], core + 3);
    store_spatial_inertia_single(&Bo_bound, p4 + i * step[4], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_from_com_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 12, 36, 40, 40, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_from_com_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 36, 40, 40, 4, 12, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_from_com_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  spatial_inertia_from_com_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction spatial_inertia_from_com_loops[] = {
    spatial_inertia_from_com_double, spatial_inertia_from_com_single};

/* (10),(6)->(6),(6) */
INLINED void product_Bs_double_over(
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
    ksl_screw_t s;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s, p1 + i * step[1], core + 1);
    ksl_product_Bs_certified(&B, &s, &co, &co_bound);
    store_coscrew_double(&co, p2 + i * step[2], core + 2);
    store_coscrew_double(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_Bs_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Bs_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 48, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Bs_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_Bs_double_over(data, n[0], step, step + 4);
}

/* (10),(6)->(6),(6) */
INLINED void product_Bs_single_over(
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
    ksl_screwf_t s;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s, p1 + i * step[1], core + 1);
    ksl_product_Bsf_certified(&B, &s, &co, &co_bound);
    store_coscrew_single(&co, p2 + i * step[2], core + 2);
    store_coscrew_single(&co_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void product_Bs_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    product_Bs_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 24, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    product_Bs_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  product_Bs_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction product_Bs_loops[] = {
    product_Bs_double, product_Bs_single};

/* (10),(6)->(),() */
INLINED void spatial_inertia_energy_double_over(
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
    ksl_screw_t s;
    double energy;
    double energy_bound;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_screw_double(&s, p1 + i * step[1], core + 1);
    energy = ksl_spatial_inertia_energy_certified(&B, &s, &energy_bound);
    store_scalar_double(&energy, p2 + i * step[2], core + 2);
    store_scalar_double(&energy_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_energy_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_energy_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 48, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_energy_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_energy_double_over(data, n[0], step, step + 4);
}

/* (10),(6)->(),() */
INLINED void spatial_inertia_energy_single_over(
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
    ksl_screwf_t s;
    float energy;
    float energy_bound;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_screw_single(&s, p1 + i * step[1], core + 1);
    energy = ksl_spatial_inertiaf_energy_certified(&B, &s, &energy_bound);
    store_scalar_single(&energy, p2 + i * step[2], core + 2);
    store_scalar_single(&energy_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_energy_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_energy_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_energy_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_energy_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_energy_loops[] = {
    spatial_inertia_energy_double, spatial_inertia_energy_single};

/* (10),(3),(6)->(6),(6) */
INLINED void spatial_inertia_net_wrench_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
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
    ksl_coscrew_t co_bound;
    if (step[0] != 0) {
      load_spatial_inertia_double(&B, p0 + i * step[0], core + 0);
    }
    load_vec3_double(&w, p1 + i * step[1], core + 1);
    load_screw_double(&ds, p2 + i * step[2], core + 2);
    ksl_spatial_inertia_net_wrench_certified(&B, &w, &ds, &co, &co_bound);
    store_coscrew_double(&co, p3 + i * step[3], core + 3);
    store_coscrew_double(&co_bound, p4 + i * step[4], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_net_wrench_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 80, 24, 48, 48, 48, 8, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_net_wrench_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 24, 48, 48, 48, 8, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_net_wrench_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  spatial_inertia_net_wrench_double_over(data, n[0], step, step + 5);
}

/* (10),(3),(6)->(6),(6) */
INLINED void spatial_inertia_net_wrench_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
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
    ksl_coscrewf_t co_bound;
    if (step[0] != 0) {
      load_spatial_inertia_single(&B, p0 + i * step[0], core + 0);
    }
    load_vec3_single(&w, p1 + i * step[1], core + 1);
    load_screw_single(&ds, p2 + i * step[2], core + 2);
    ksl_spatial_inertiaf_net_wrench_certified(&B, &w, &ds, &co, &co_bound);
    store_coscrew_single(&co, p3 + i * step[3], core + 3);
    store_coscrew_single(&co_bound, p4 + i * step[4], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_net_wrench_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 40, 12, 24, 24, 24, 4, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_net_wrench_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 12, 24, 24, 24, 4, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_net_wrench_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  spatial_inertia_net_wrench_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction spatial_inertia_net_wrench_loops[] = {
    spatial_inertia_net_wrench_double, spatial_inertia_net_wrench_single};

/* (3),(10)->(10),(10) */
INLINED void spatial_inertia_shifted_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3_t t;
  load_vec3_double(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    if (step[0] != 0) {
      load_vec3_double(&t, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B, p1 + i * step[1], core + 1);
    ksl_spatial_inertia_shifted_certified(&t, &B, &Bo, &Bo_bound);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_double(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_shifted_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 24, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_shifted_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 80, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_shifted_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_shifted_double_over(data, n[0], step, step + 4);
}

/* (3),(10)->(10),(10) */
INLINED void spatial_inertia_shifted_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec3f_t t;
  load_vec3_single(&t, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    if (step[0] != 0) {
      load_vec3_single(&t, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B, p1 + i * step[1], core + 1);
    ksl_spatial_inertiaf_shifted_certified(&t, &B, &Bo, &Bo_bound);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 2);
    store_spatial_inertia_single(&Bo_bound, p3 + i * step[3], core + 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_shifted_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 12, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_shifted_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 40, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_shifted_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_shifted_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_shifted_loops[] = {
    spatial_inertia_shifted_double, spatial_inertia_shifted_single};

/* (3,4),(10)->(10),(10) */
INLINED void spatial_inertia_transformed_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3_t D;
  load_SE3_double(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    if (step[0] != 0) {
      load_SE3_double(&D, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_double(&B, p1 + i * step[1], core + 2);
    ksl_spatial_inertia_transformed_certified(&D, &B, &Bo, &Bo_bound);
    store_spatial_inertia_double(&Bo, p2 + i * step[2], core + 3);
    store_spatial_inertia_double(&Bo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_transformed_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 96, 80, 80, 80, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_transformed_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 80, 80, 80, 32, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_transformed_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_transformed_double_over(data, n[0], step, step + 4);
}

/* (3,4),(10)->(10),(10) */
INLINED void spatial_inertia_transformed_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_SE3f_t D;
  load_SE3_single(&D, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    if (step[0] != 0) {
      load_SE3_single(&D, p0 + i * step[0], core + 0);
    }
    load_spatial_inertia_single(&B, p1 + i * step[1], core + 2);
    ksl_spatial_inertiaf_transformed_certified(&D, &B, &Bo, &Bo_bound);
    store_spatial_inertia_single(&Bo, p2 + i * step[2], core + 3);
    store_spatial_inertia_single(&Bo_bound, p3 + i * step[3], core + 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void spatial_inertia_transformed_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 48, 40, 40, 40, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    spatial_inertia_transformed_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 40, 40, 40, 16, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    spatial_inertia_transformed_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  spatial_inertia_transformed_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction spatial_inertia_transformed_loops[] = {
    spatial_inertia_transformed_double, spatial_inertia_transformed_single};

const coscrew_gufunc TABLE(spatial_inertia)[] = {
  {"spatial_inertia_scale", "(10),()->(10),(10)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(10),()->(10),(10).  self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about\n"
    "the origin, xx, yy, zz, xy, xz, yz in kg m^2); a: number.\n"
    "20 mul, 10 add, 10 abs.\n",
   2, 2, "", spatial_inertia_scale_loops},
  {"add_BB", "(10),(10)->(10),(10)",
    "Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I\n"
    "about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "10 mul, 10 add, 10 abs.\n",
   2, 2, "", add_BB_loops},
  {"subtract_BB", "(10),(10)->(10),(10)",
    "Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I\n"
    "about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "10 mul, 10 add, 10 abs.\n",
   2, 2, "", subtract_BB_loops},
  {"spatial_inertia_from_com", "(),(3),(3,3)->(10),(10)",
    "Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle\n"
    "is read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(),(3),(3,3)->(10),(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo,\n"
    "Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,\n"
    "yz in kg m^2).\n"
    "24 mul, 27 add, 12 abs.\n",
   3, 2, "", spatial_inertia_from_com_loops},
  {"product_Bs", "(10),(6)->(6),(6)",
    "co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of\n"
    "co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(10),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,\n"
    "yy, zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in\n"
    "N; τ in N m).\n"
    "30 mul, 42 add, 24 abs.\n",
   2, 2, "", product_Bs_loops},
  {"spatial_inertia_energy", "(10),(6)->(),()",
    "s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=\n"
    "energy_bound unless inf or NaN.\n"
    "\n"
    "(10),(6)->(),().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy, energy_bound: number.\n"
    "35 mul, 43 add, 25 abs.\n",
   2, 2, "", spatial_inertia_energy_loops},
  {"spatial_inertia_net_wrench", "(10),(3),(6)->(6),(6)",
    "co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular\n"
    "velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if\n"
    "a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(10),(3),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co,\n"
    "co_bound: coscrew (f in N; τ in N m).\n"
    "66 mul, 102 add, 3 neg, 30 abs.\n",
   3, 2, "", spatial_inertia_net_wrench_loops},
  {"spatial_inertia_shifted", "(3),(10)->(10),(10)",
    "Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3),(10)->(10),(10).  t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m;\n"
    "I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "42 mul, 54 add, 15 abs.\n",
   2, 2, "", spatial_inertia_shifted_loops},
  {"spatial_inertia_transformed", "(3,4),(10)->(10),(10)",
    "Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of\n"
    "Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(10)->(10),(10).  D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound:\n"
    "spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg\n"
    "m^2).\n"
    "114 mul, 135 add, 51 abs.\n",
   2, 2, "R.", spatial_inertia_transformed_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
