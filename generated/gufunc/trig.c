/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the trig operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/trig.h"
#include "_lanes.h"
#include "../c/include/ksl/trig_states.h"

/* ()->(2) */
OVER(dc_double) {
  POINTERS_2
  EACH {
    double theta;
    double dc[2];
    LOAD(scalar_double, &theta, 0, 0);
    ksl_dc(theta, dc);
    STORE(dc_double, dc, 1, 0);
  }
}
STRIDED(dc_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int dc_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states theta[1];
  ksl_states dc[128][2];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_scalar_double(theta, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_scalar_double(theta, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_dc_states(theta, dc[g]);
  }
  COMPUTED(dc);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_dc_double(dc[g], data[1] + j * step[1], step[1], core + 0, KSL_LANES);
    } else {
      store_lanes_dc_double(dc[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void dc_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { dc_double_strided, dc_double_on_vectors, 2,
    KSL_LANES, 128 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(dc_double, 2, DENSE, 8, 16, 8)

OVER(dc_single) {
  POINTERS_2
  EACH {
    float theta;
    float dc[2];
    LOAD(scalar_single, &theta, 0, 0);
    ksl_dcf(theta, dc);
    STORE(dc_single, dc, 1, 0);
  }
}
STRIDED(dc_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int dc_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf theta[1];
  ksl_statesf dc[128][2];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_scalar_single(theta, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_scalar_single(theta, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_dcf_states(theta, dc[g]);
  }
  COMPUTED(dc);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_dc_single(dc[g], data[1] + j * step[1], step[1], core + 0, KSL_LANESF);
    } else {
      store_lanes_dc_single(dc[g], data[1] + j * step[1], step[1], core + 0, left);
    }
  }
  return 1;
}

static APART void dc_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { dc_single_strided, dc_single_on_vectors, 2,
    KSL_LANESF, 128 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(dc_single, 2, DENSE, 4, 8, 4)
LOOPS(dc)

const coscrew_gufunc TABLE(trig)[] = {
  {"dc", "()->(2)",
    "dc = (sin θ, cos θ), θ in rad.\n"
    "\n"
    "()->(2).  theta: number; dc: (sin θ, cos θ).\n"
    "28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is\n"
    "subnormal; proved.\n",
   1, 1, "", dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
