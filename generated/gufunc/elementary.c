/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "_lanes.h"
#include "../c/include/ksl/elementary_states.h"

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
    s = ksl_sincos(x, &c);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
    store_scalar_double(&c, p2 + i * step[2], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void sincos_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  sincos_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int sincos_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states x[1];
  ksl_states s[128][1];
  ksl_states c[128][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_sincos_states(x, s[g], c[g]);
  }
  COMPUTED(s);
  COMPUTED(c);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(s[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
      store_lanes_scalar_double(c[g], data[2] + j * step[2], step[2], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(s[g], data[1] + j * step[1], step[1], core + 0, left);
      store_lanes_scalar_double(c[g], data[2] + j * step[2], step[2], core + 0, left);
    }
  }
  return 1;
}

static APART void sincos_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 128 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!sincos_double_on_vectors(data, i, m, step, core, raised)) {
      sincos_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  sincos_double_from(data, i, n - i, step, core);
}
#endif

static void sincos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    sincos_double_many(data, n[0], step, step + 3);
    return;
  }
#endif
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
    s = ksl_sincosf(x, &c);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
    store_scalar_single(&c, p2 + i * step[2], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void sincos_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  sincos_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int sincos_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf x[1];
  ksl_statesf s[128][1];
  ksl_statesf c[128][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_sincosf_states(x, s[g], c[g]);
  }
  COMPUTED(s);
  COMPUTED(c);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(s[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
      store_lanes_scalar_single(c[g], data[2] + j * step[2], step[2], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(s[g], data[1] + j * step[1], step[1], core + 0, left);
      store_lanes_scalar_single(c[g], data[2] + j * step[2], step[2], core + 0, left);
    }
  }
  return 1;
}

static APART void sincos_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 128 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!sincos_single_on_vectors(data, i, m, step, core, raised)) {
      sincos_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  sincos_single_from(data, i, n - i, step, core);
}
#endif

static void sincos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    sincos_single_many(data, n[0], step, step + 3);
    return;
  }
#endif
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
    s = ksl_sin(x);
    store_scalar_double(&s, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void sin_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  sin_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int sin_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states x[1];
  ksl_states s[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_sin_states(x, s[g]);
  }
  COMPUTED(s);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(s[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(s[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void sin_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!sin_double_on_vectors(data, i, m, step, core, raised)) {
      sin_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  sin_double_from(data, i, n - i, step, core);
}
#endif

static void sin_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    sin_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    s = ksl_sinf(x);
    store_scalar_single(&s, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void sin_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  sin_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int sin_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf x[1];
  ksl_statesf s[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_sinf_states(x, s[g]);
  }
  COMPUTED(s);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(s[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(s[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void sin_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!sin_single_on_vectors(data, i, m, step, core, raised)) {
      sin_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  sin_single_from(data, i, n - i, step, core);
}
#endif

static void sin_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    sin_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    c = ksl_cos(x);
    store_scalar_double(&c, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void cos_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  cos_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int cos_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states x[1];
  ksl_states c[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_cos_states(x, c[g]);
  }
  COMPUTED(c);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(c[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(c[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void cos_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!cos_double_on_vectors(data, i, m, step, core, raised)) {
      cos_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  cos_double_from(data, i, n - i, step, core);
}
#endif

static void cos_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    cos_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    c = ksl_cosf(x);
    store_scalar_single(&c, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void cos_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  cos_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int cos_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf x[1];
  ksl_statesf c[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_cosf_states(x, c[g]);
  }
  COMPUTED(c);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(c[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(c[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void cos_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!cos_single_on_vectors(data, i, m, step, core, raised)) {
      cos_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  cos_single_from(data, i, n - i, step, core);
}
#endif

static void cos_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    cos_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    y = ksl_exp(x);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void exp_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  exp_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int exp_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states x[1];
  ksl_states y[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_exp_states(x, y[g]);
  }
  COMPUTED(y);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(y[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(y[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void exp_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!exp_double_on_vectors(data, i, m, step, core, raised)) {
      exp_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  exp_double_from(data, i, n - i, step, core);
}
#endif

static void exp_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    exp_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    y = ksl_expf(x);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void exp_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  exp_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int exp_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf x[1];
  ksl_statesf y[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_expf_states(x, y[g]);
  }
  COMPUTED(y);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(y[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(y[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void exp_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!exp_single_on_vectors(data, i, m, step, core, raised)) {
      exp_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  exp_single_from(data, i, n - i, step, core);
}
#endif

static void exp_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    exp_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    y = ksl_tanh(x);
    store_scalar_double(&y, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void tanh_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  tanh_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int tanh_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states x[1];
  ksl_states y[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_tanh_states(x, y[g]);
  }
  COMPUTED(y);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(y[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(y[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void tanh_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!tanh_double_on_vectors(data, i, m, step, core, raised)) {
      tanh_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  tanh_double_from(data, i, n - i, step, core);
}
#endif

static void tanh_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    tanh_double_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    y = ksl_tanhf(x);
    store_scalar_single(&y, p1 + i * step[1], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void tanh_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[2];
  for (int k = 0; k < 2; k++) {
    from[k] = data[k] + i * step[k];
  }
  tanh_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int tanh_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf x[1];
  ksl_statesf y[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(x, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_tanhf_states(x, y[g]);
  }
  COMPUTED(y);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(y[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(y[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void tanh_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!tanh_single_on_vectors(data, i, m, step, core, raised)) {
      tanh_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  tanh_single_from(data, i, n - i, step, core);
}
#endif

static void tanh_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    tanh_single_many(data, n[0], step, step + 2);
    return;
  }
#endif
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
    angle = ksl_atan2(y, x);
    store_scalar_double(&angle, p2 + i * step[2], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void atan2_double_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  atan2_double_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int atan2_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states y[1];
  ksl_states x[1];
  ksl_states angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(y, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_scalar_double(x, data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(y, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_double(x, data[1] + j * step[1], step[1], core + 0, left);
    }
    ksl_atan2_states(y, x, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 0, KSL_LANES);
    } else {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 0, left);
    }
  }
  return 1;
}

static APART void atan2_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANES;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANES, most)) > 0; i += m) {
    if (!atan2_double_on_vectors(data, i, m, step, core, raised)) {
      atan2_double_from(data, i, m, step, core);
      raised = flags();
    }
  }
  atan2_double_from(data, i, n - i, step, core);
}
#endif

static void atan2_double(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    atan2_double_many(data, n[0], step, step + 3);
    return;
  }
#endif
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
    angle = ksl_atan2f(y, x);
    store_scalar_single(&angle, p2 + i * step[2], core + 0);
  }
}

#if KSL_LANE_BYTES
/* m elements, from the one numbered i. */
static void atan2_single_from(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core) {
  char *from[3];
  for (int k = 0; k < 3; k++) {
    from[k] = data[k] + i * step[k];
  }
  atan2_single_over(from, m, step, core);
}

/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int atan2_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf y[1];
  ksl_statesf x[1];
  ksl_statesf angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(y, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_scalar_single(x, data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(y, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_single(x, data[1] + j * step[1], step[1], core + 0, left);
    }
    ksl_atan2f_states(y, x, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 0, KSL_LANESF);
    } else {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 0, left);
    }
  }
  return 1;
}

static APART void atan2_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const npy_intp most = 256 * KSL_LANESF;
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, KSL_LANESF, most)) > 0; i += m) {
    if (!atan2_single_on_vectors(data, i, m, step, core, raised)) {
      atan2_single_from(data, i, m, step, core);
      raised = flags();
    }
  }
  atan2_single_from(data, i, n - i, step, core);
}
#endif

static void atan2_single(
    char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
#if KSL_LANE_BYTES
  if (n[0] >= SEVERAL) {
    atan2_single_many(data, n[0], step, step + 3);
    return;
  }
#endif
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
    "28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is\n"
    "subnormal; proved.\n",
   1, 2, "", sincos_loops},
  {"sin", "()->()",
    "s = sin x, x in rad.\n"
    "\n"
    "()->().  x, s: number.\n"
    "28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is\n"
    "subnormal; proved.\n",
   1, 1, "", sin_loops},
  {"cos", "()->()",
    "c = cos x, x in rad.\n"
    "\n"
    "()->().  x, c: number.\n"
    "28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is\n"
    "subnormal; proved.\n",
   1, 1, "", cos_loops},
  {"exp", "()->()",
    "y = e^x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "19 mul, 20 add, 1 power of two, 3 less, 4 select.  Error <= 0.755 ulp, in single precision\n"
    "0.757 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", exp_loops},
  {"tanh", "()->()",
    "y = tanh x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "29 mul, 30 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.  Error <= 0.979\n"
    "ulp, in single precision 0.967 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", tanh_loops},
  {"atan2", "(),()->()",
    "angle of the vector (x, y) to the x axis, in rad, from -π to π.\n"
    "\n"
    "(),()->().  y, x, angle: number.\n"
    "29 mul, 35 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select.  Error <= 0.934\n"
    "ulp, in single precision 0.896 ulp, unless a result is subnormal; proved.\n",
   2, 1, "", atan2_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
