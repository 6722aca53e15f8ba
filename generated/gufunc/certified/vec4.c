/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec4 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* (4),()->(4),(4) */
INLINED void vec4_scale_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4_t self;
    double a;
    ksl_vec4_t self_bound;
    load_vec4_double(&self, p0 + i * step[0], core + 0);
    load_scalar_double(&a, p1 + i * step[1], core + 1);
    ksl_vec4_scale_certified(&self, a, &self_bound);
    store_vec4_double(&self, p2 + i * step[2], core + 1);
    store_vec4_double(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec4_scale_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scale_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec4_scale_double_over(data, n[0], step, step + 4);
}

/* (4),()->(4),(4) */
INLINED void vec4_scale_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    ksl_vec4f_t self;
    float a;
    ksl_vec4f_t self_bound;
    load_vec4_single(&self, p0 + i * step[0], core + 0);
    load_scalar_single(&a, p1 + i * step[1], core + 1);
    ksl_vec4f_scale_certified(&self, a, &self_bound);
    store_vec4_single(&self, p2 + i * step[2], core + 1);
    store_vec4_single(&self_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec4_scale_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scale_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  vec4_scale_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec4_scale_loops[] = {
    vec4_scale_double, vec4_scale_single};

/* (4),()->(4),(4) */
INLINED void vec4_scaled_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec4_t v;
  load_vec4_double(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double k;
    ksl_vec4_t vo;
    ksl_vec4_t vo_bound;
    if (step[0] != 0) {
      load_vec4_double(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&k, p1 + i * step[1], core + 1);
    ksl_vec4_scaled_certified(&v, k, &vo, &vo_bound);
    store_vec4_double(&vo, p2 + i * step[2], core + 1);
    store_vec4_double(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec4_scaled_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 32, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scaled_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 32, 32, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_scaled_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  vec4_scaled_double_over(data, n[0], step, step + 4);
}

/* (4),()->(4),(4) */
INLINED void vec4_scaled_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  ksl_vec4f_t v;
  load_vec4_single(&v, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float k;
    ksl_vec4f_t vo;
    ksl_vec4f_t vo_bound;
    if (step[0] != 0) {
      load_vec4_single(&v, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&k, p1 + i * step[1], core + 1);
    ksl_vec4f_scaled_certified(&v, k, &vo, &vo_bound);
    store_vec4_single(&vo, p2 + i * step[2], core + 1);
    store_vec4_single(&vo_bound, p3 + i * step[3], core + 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void vec4_scaled_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 16, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    vec4_scaled_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 16, 16, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    vec4_scaled_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  vec4_scaled_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction vec4_scaled_loops[] = {
    vec4_scaled_double, vec4_scaled_single};

const coscrew_gufunc TABLE(vec4)[] = {
  {"vec4_scale", "(4),()->(4),(4)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(4),()->(4),(4).  self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a:\n"
    "number.\n"
    "8 mul, 4 add, 4 abs.\n",
   2, 2, "", vec4_scale_loops},
  {"vec4_scaled", "(4),()->(4),(4)",
    "vo = k v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),()->(4),(4).  v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k:\n"
    "number.\n"
    "8 mul, 4 add, 4 abs.\n",
   2, 2, "", vec4_scaled_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
