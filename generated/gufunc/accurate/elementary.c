/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* ()->(),() */
INLINED void sincos_double_over(
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
    double c;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sincos_accurate(x, &c);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
    store_scalar_double(&c, p2 + i * step[2], core + 0);
  }
}

static void sincos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sincos_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sincos_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  sincos_double_over(data, n[0], step, step + 3);
}

/* ()->(),() */
INLINED void sincos_single_over(
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
    float c;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sincosf_accurate(x, &c);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
    store_scalar_single(&c, p2 + i * step[2], core + 0);
  }
}

static void sincos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sincos_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sincos_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  sincos_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction sincos_loops[] = {
    sincos_double, sincos_single};

/* ()->() */
INLINED void sin_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double s;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sin_accurate(x);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
  }
}

static void sin_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sin_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sin_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  sin_double_over(data, n[0], step, step + 2);
}

/* ()->() */
INLINED void sin_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float s;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    s = ksl_sinf_accurate(x);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
  }
}

static void sin_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    sin_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    sin_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  sin_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction sin_loops[] = {
    sin_double, sin_single};

/* ()->() */
INLINED void cos_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double c;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    c = ksl_cos_accurate(x);
    store_scalar_double(&c, p1 + i * step[1], core + 0);
  }
}

static void cos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cos_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cos_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  cos_double_over(data, n[0], step, step + 2);
}

/* ()->() */
INLINED void cos_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float c;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    c = ksl_cosf_accurate(x);
    store_scalar_single(&c, p1 + i * step[1], core + 0);
  }
}

static void cos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    cos_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    cos_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  cos_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction cos_loops[] = {
    cos_double, cos_single};

/* ()->() */
INLINED void exp_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double y;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_exp_accurate(x);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
  }
}

static void exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    exp_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    exp_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  exp_double_over(data, n[0], step, step + 2);
}

/* ()->() */
INLINED void exp_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float y;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_expf_accurate(x);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
  }
}

static void exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    exp_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    exp_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  exp_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction exp_loops[] = {
    exp_double, exp_single};

/* ()->() */
INLINED void tanh_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  double x;
  load_scalar_double(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double y;
    if (step[0] != 0) {
      load_scalar_double(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_tanh_accurate(x);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
  }
}

static void tanh_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    tanh_double_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    tanh_double_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  tanh_double_over(data, n[0], step, step + 2);
}

/* ()->() */
INLINED void tanh_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  if (n <= 0) {
    return;
  }
  float x;
  load_scalar_single(&x, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float y;
    if (step[0] != 0) {
      load_scalar_single(&x, p0 + i * step[0], core + 0);
    }
    y = ksl_tanhf_accurate(x);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
  }
}

static void tanh_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    tanh_single_over(
        data, n[0], dense_1, dense_1 + 2);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    tanh_single_over(
        data, n[0], dense_2, dense_2 + 2);
    return;
  }
  tanh_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction tanh_loops[] = {
    tanh_double, tanh_single};

/* (),()->() */
INLINED void atan2_double_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  double y;
  load_scalar_double(&y, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    double x;
    double angle;
    if (step[0] != 0) {
      load_scalar_double(&y, p0 + i * step[0], core + 0);
    }
    load_scalar_double(&x, p1 + i * step[1], core + 0);
    angle = ksl_atan2_accurate(y, x);
    store_scalar_double(&angle, p2 + i * step[2], core + 0);
  }
}

static void atan2_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 8, 8, 8 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    atan2_double_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 8, 8 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    atan2_double_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  atan2_double_over(data, n[0], step, step + 3);
}

/* (),()->() */
INLINED void atan2_single_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  char *const p0 = data[0];
  char *const p1 = data[1];
  char *const p2 = data[2];
  if (n <= 0) {
    return;
  }
  float y;
  load_scalar_single(&y, p0, core + 0);
  INDEPENDENT
  for (npy_intp i = 0; i < n; i++) {
    float x;
    float angle;
    if (step[0] != 0) {
      load_scalar_single(&y, p0 + i * step[0], core + 0);
    }
    load_scalar_single(&x, p1 + i * step[1], core + 0);
    angle = ksl_atan2f_accurate(y, x);
    store_scalar_single(&angle, p2 + i * step[2], core + 0);
  }
}

static void atan2_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense_1[] = { 4, 4, 4 };
  if (memcmp(step, dense_1, sizeof dense_1) == 0) {
    atan2_single_over(
        data, n[0], dense_1, dense_1 + 3);
    return;
  }
  static const npy_intp dense_2[] = { 0, 4, 4 };
  if (memcmp(step, dense_2, sizeof dense_2) == 0) {
    atan2_single_over(
        data, n[0], dense_2, dense_2 + 3);
    return;
  }
  atan2_single_over(data, n[0], step, step + 3);
}

static PyUFuncGenericFunction atan2_loops[] = {
    atan2_double, atan2_single};

const coscrew_gufunc TABLE(elementary)[] = {
  {"sincos", "()->(),()",
    "s = sin x, c = cos x, x in rad.\n"
    "\n"
    "()->(),().  x, s, c: number.\n"
    "83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 2, "", sincos_loops},
  {"sin", "()->()",
    "s = sin x, x in rad.\n"
    "\n"
    "()->().  x, s: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", sin_loops},
  {"cos", "()->()",
    "c = cos x, x in rad.\n"
    "\n"
    "()->().  x, c: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", cos_loops},
  {"exp", "()->()",
    "y = e^x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "81 mul, 148 add, 14 product error, 5 power of two, 1 abs, 7 less, 2 equal, 10 select.  Error\n"
    "<= 0.501 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", exp_loops},
  {"tanh", "()->()",
    "y = tanh x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "91 mul, 174 add, 15 product error, 2 div, 2 power of two, 4 abs, 2 copysign, 5 less, 1\n"
    "equal, 12 select.  Error <= 0.501 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", tanh_loops},
  {"atan2", "(),()->()",
    "angle of the vector (x, y) to the x axis, in rad, from -π to π.\n"
    "\n"
    "(),()->().  y, x, angle: number.\n"
    "122 mul, 213 add, 21 product error, 2 div, 1 neg, 8 abs, 4 copysign, 13 less, 4 equal, 24\n"
    "select.  Error <= 0.501 ulp, unless a result is subnormal; proved.\n",
   2, 1, "", atan2_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
