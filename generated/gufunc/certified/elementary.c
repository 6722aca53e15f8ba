/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include <fenv.h>

/* ()->(),(),(),() */
INLINED void sincos_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double s;
    double c;
    double s_bound;
    double c_bound;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sincos_certified(x, &c, &s_bound, &c_bound);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
    store_scalar_double(&c, p2 + i * step[2], core + 0);
    store_scalar_double(&s_bound, p3 + i * step[3], core + 0);
    store_scalar_double(&c_bound, p4 + i * step[4], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void sincos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sincos_double_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sincos_double_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  sincos_double_over(data, n[0], step, step + 5);
}

/* ()->(),(),(),() */
INLINED void sincos_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  char *const p4 = data[4];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float s;
    float c;
    float s_bound;
    float c_bound;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sincosf_certified(x, &c, &s_bound, &c_bound);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
    store_scalar_single(&c, p2 + i * step[2], core + 0);
    store_scalar_single(&s_bound, p3 + i * step[3], core + 0);
    store_scalar_single(&c_bound, p4 + i * step[4], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void sincos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sincos_single_over(
        data, n[0], dense_1, dense_1 + 5);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sincos_single_over(
        data, n[0], dense_2, dense_2 + 5);
    return;
  }
  sincos_single_over(data, n[0], step, step + 5);
}

static PyUFuncGenericFunction sincos_loops[] = {
    sincos_double, sincos_single};

/* ()->(),() */
INLINED void sin_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double s;
    double s_bound;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sin_certified(x, &s_bound);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
    store_scalar_double(&s_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void sin_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sin_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sin_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  sin_double_over(data, n[0], step, step + 3);
}

/* ()->(),() */
INLINED void sin_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float s;
    float s_bound;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sinf_certified(x, &s_bound);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
    store_scalar_single(&s_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void sin_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sin_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sin_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  sin_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction sin_loops[] = {
    sin_double, sin_single};

/* ()->(),() */
INLINED void cos_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double c;
    double c_bound;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    c = ksl_cos_certified(x, &c_bound);
    store_scalar_double(&c, p1 + i * step[1], core + 0);
    store_scalar_double(&c_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cos_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cos_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cos_double_over(data, n[0], step, step + 3);
}

/* ()->(),() */
INLINED void cos_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float c;
    float c_bound;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    c = ksl_cosf_certified(x, &c_bound);
    store_scalar_single(&c, p1 + i * step[1], core + 0);
    store_scalar_single(&c_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void cos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cos_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cos_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  cos_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction cos_loops[] = {
    cos_double, cos_single};

/* ()->(),() */
INLINED void exp_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double y;
    double y_bound;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_exp_certified(x, &y_bound);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
    store_scalar_double(&y_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    exp_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    exp_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  exp_double_over(data, n[0], step, step + 3);
}

/* ()->(),() */
INLINED void exp_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float y;
    float y_bound;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_expf_certified(x, &y_bound);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
    store_scalar_single(&y_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    exp_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    exp_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  exp_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction exp_loops[] = {
    exp_double, exp_single};

/* ()->(),() */
INLINED void tanh_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double y;
    double y_bound;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_tanh_certified(x, &y_bound);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
    store_scalar_double(&y_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void tanh_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    tanh_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    tanh_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  tanh_double_over(data, n[0], step, step + 3);
}

/* ()->(),() */
INLINED void tanh_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float y;
    float y_bound;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_tanhf_certified(x, &y_bound);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
    store_scalar_single(&y_bound, p2 + i * step[2], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void tanh_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    tanh_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    tanh_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  tanh_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction tanh_loops[] = {
    tanh_double, tanh_single};

/* (),()->(),() */
INLINED void atan2_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  double y;
  load_scalar_double(&y, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double x;
    double angle;
    double angle_bound;
    if (step[0] != 0) {
      load_scalar_double(&y, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&x, p1 + i * step[1], core + 0);
    angle = ksl_atan2_certified(y, x, &angle_bound);
    store_scalar_double(&angle, p2 + i * step[2], core + 0);
    store_scalar_double(&angle_bound, p3 + i * step[3], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void atan2_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    atan2_double_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    atan2_double_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  atan2_double_over(data, n[0], step, step + 4);
}

/* (),()->(),() */
INLINED void atan2_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  char *const p3 = data[3];
  if (n <= 0) {
    return;
  }
  float y;
  load_scalar_single(&y, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float x;
    float angle;
    float angle_bound;
    if (step[0] != 0) {
      load_scalar_single(&y, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&x, p1 + i * step[1], core + 0);
    angle = ksl_atan2f_certified(y, x, &angle_bound);
    store_scalar_single(&angle, p2 + i * step[2], core + 0);
    store_scalar_single(&angle_bound, p3 + i * step[3], core + 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}

static void atan2_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    atan2_single_over(
        data, n[0], dense_1, dense_1 + 4);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    atan2_single_over(
        data, n[0], dense_2, dense_2 + 4);
    return;
  }
  atan2_single_over(data, n[0], step, step + 4);
}

static PyUFuncGenericFunction atan2_loops[] = {
    atan2_double, atan2_single};

const coscrew_gufunc TABLE(elementary)[] = {
  {"sincos", "()->(),(),(),()",
    "s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf\n"
    "or NaN.\n"
    "\n"
    "()->(),(),(),().  x, s, c, s_bound, c_bound: number.\n"
    "83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.\n",
   1, 4, "", sincos_loops},
  {"sin", "()->(),()",
    "s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, s, s_bound: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.\n",
   1, 2, "", sin_loops},
  {"cos", "()->(),()",
    "c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, c, c_bound: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.\n",
   1, 2, "", cos_loops},
  {"exp", "()->(),()",
    "y = e^x; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, y, y_bound: number.\n"
    "82 mul, 149 add, 14 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.\n",
   1, 2, "", exp_loops},
  {"tanh", "()->(),()",
    "y = tanh x; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, y, y_bound: number.\n"
    "92 mul, 175 add, 15 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11\n"
    "select.\n",
   1, 2, "", tanh_loops},
  {"atan2", "(),()->(),()",
    "angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=\n"
    "angle_bound unless inf or NaN.\n"
    "\n"
    "(),()->(),().  y, x, angle, angle_bound: number.\n"
    "123 mul, 214 add, 21 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23\n"
    "select.\n",
   2, 2, "", atan2_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
