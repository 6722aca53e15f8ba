/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/elementary.h"
#include "_lanes.h"
#include "../c/include/ksl/elementary_states.h"

/* ()->(),() */
OVER(sincos_double) {
  POINTERS_3
  EACH {
    double x;
    double s;
    double c;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sincos(x, &c);
    STORE(scalar_double, &s, 1, 0);
    STORE(scalar_double, &c, 2, 0);
  }
}
STRIDED(sincos_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { sincos_double_strided, sincos_double_on_vectors, 3,
    KSL_LANES, 128 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(sincos_double, 3, DENSE, 8, 8, 8)

OVER(sincos_single) {
  POINTERS_3
  EACH {
    float x;
    float s;
    float c;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sincosf(x, &c);
    STORE(scalar_single, &s, 1, 0);
    STORE(scalar_single, &c, 2, 0);
  }
}
STRIDED(sincos_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { sincos_single_strided, sincos_single_on_vectors, 3,
    KSL_LANESF, 128 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(sincos_single, 3, DENSE, 4, 4, 4)
LOOPS(sincos)

/* ()->() */
OVER(sin_double) {
  POINTERS_2
  EACH {
    double x;
    double s;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sin(x);
    STORE(scalar_double, &s, 1, 0);
  }
}
STRIDED(sin_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { sin_double_strided, sin_double_on_vectors, 2,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(sin_double, 2, DENSE, 8, 8)

OVER(sin_single) {
  POINTERS_2
  EACH {
    float x;
    float s;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sinf(x);
    STORE(scalar_single, &s, 1, 0);
  }
}
STRIDED(sin_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { sin_single_strided, sin_single_on_vectors, 2,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(sin_single, 2, DENSE, 4, 4)
LOOPS(sin)

/* ()->() */
OVER(cos_double) {
  POINTERS_2
  EACH {
    double x;
    double c;
    LOAD(scalar_double, &x, 0, 0);
    c = ksl_cos(x);
    STORE(scalar_double, &c, 1, 0);
  }
}
STRIDED(cos_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { cos_double_strided, cos_double_on_vectors, 2,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(cos_double, 2, DENSE, 8, 8)

OVER(cos_single) {
  POINTERS_2
  EACH {
    float x;
    float c;
    LOAD(scalar_single, &x, 0, 0);
    c = ksl_cosf(x);
    STORE(scalar_single, &c, 1, 0);
  }
}
STRIDED(cos_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { cos_single_strided, cos_single_on_vectors, 2,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(cos_single, 2, DENSE, 4, 4)
LOOPS(cos)

/* ()->() */
OVER(exp_double) {
  POINTERS_2
  EACH {
    double x;
    double y;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_exp(x);
    STORE(scalar_double, &y, 1, 0);
  }
}
STRIDED(exp_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { exp_double_strided, exp_double_on_vectors, 2,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(exp_double, 2, DENSE, 8, 8)

OVER(exp_single) {
  POINTERS_2
  EACH {
    float x;
    float y;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_expf(x);
    STORE(scalar_single, &y, 1, 0);
  }
}
STRIDED(exp_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { exp_single_strided, exp_single_on_vectors, 2,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(exp_single, 2, DENSE, 4, 4)
LOOPS(exp)

/* ()->() */
OVER(tanh_double) {
  POINTERS_2
  EACH {
    double x;
    double y;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_tanh(x);
    STORE(scalar_double, &y, 1, 0);
  }
}
STRIDED(tanh_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { tanh_double_strided, tanh_double_on_vectors, 2,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(tanh_double, 2, DENSE, 8, 8)

OVER(tanh_single) {
  POINTERS_2
  EACH {
    float x;
    float y;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_tanhf(x);
    STORE(scalar_single, &y, 1, 0);
  }
}
STRIDED(tanh_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { tanh_single_strided, tanh_single_on_vectors, 2,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(tanh_single, 2, DENSE, 4, 4)
LOOPS(tanh)

/* (),()->() */
OVER(atan2_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double y, &y);
  EACH {
    double x;
    double angle;
    LOAD_OTHER(scalar_double, &y);
    LOAD(scalar_double, &x, 1, 0);
    angle = ksl_atan2(y, x);
    STORE(scalar_double, &angle, 2, 0);
  }
}
STRIDED(atan2_double)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { atan2_double_strided, atan2_double_on_vectors, 3,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(atan2_double, 3, DENSE_OR_ONE, 8, 8, 8)

OVER(atan2_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float y, &y);
  EACH {
    float x;
    float angle;
    LOAD_OTHER(scalar_single, &y);
    LOAD(scalar_single, &x, 1, 0);
    angle = ksl_atan2f(y, x);
    STORE(scalar_single, &angle, 2, 0);
  }
}
STRIDED(atan2_single)

#if KSL_LANE_BYTES
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
  const vector_loop loop = { atan2_single_strided, atan2_single_on_vectors, 3,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(atan2_single, 3, DENSE_OR_ONE, 4, 4, 4)
LOOPS(atan2)

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
