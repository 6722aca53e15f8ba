/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/exponential.h"
#include "_lanes.h"
#include "../c/include/ksl/exponential_states.h"

/* (3)->(3,3) */
OVER(SO3_exp_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_exp(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(SO3_exp_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_exp_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_exp_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_exp_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_exp_double_strided, SO3_exp_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_exp_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_exp_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_expf(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_exp_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_exp_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_expf_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_exp_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_exp_single_strided, SO3_exp_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_exp_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_exp)

/* (3,3)->(3) */
OVER(SO3_log_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t vo;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_SO3_log(&R, &vo);
    STORE(vec3_double, &vo, 1, 2);
  }
}
STRIDED(SO3_log_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_log_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states R[9];
  ksl_states vo[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_log_states(R, vo[g]);
  }
  COMPUTED(vo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_vec3_double(vo[g], data[1] + j * step[1], step[1], core + 2, KSL_LANES);
    } else {
      store_lanes_vec3_double(vo[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void SO3_log_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_log_double_strided, SO3_log_double_on_vectors, 2,
    KSL_LANES, 85 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_log_double, 2, DENSE, 72, 24, 24, 8, 8)

OVER(SO3_log_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t vo;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_SO3_logf(&R, &vo);
    STORE(vec3_single, &vo, 1, 2);
  }
}
STRIDED(SO3_log_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_log_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf R[9];
  ksl_statesf vo[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_logf_states(R, vo[g]);
  }
  COMPUTED(vo);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_vec3_single(vo[g], data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
    } else {
      store_lanes_vec3_single(vo[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void SO3_log_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_log_single_strided, SO3_log_single_on_vectors, 2,
    KSL_LANESF, 85 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_log_single, 2, DENSE, 36, 12, 12, 4, 4)
LOOPS(SO3_log)

/* (3)->(3,3) */
OVER(SO3_leftJacobian_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobian(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobian_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_leftJacobian_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_leftJacobian_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_leftJacobian_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_leftJacobian_double_strided, SO3_leftJacobian_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_leftJacobian_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_leftJacobian_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianf(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobian_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_leftJacobian_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_leftJacobianf_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_leftJacobian_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_leftJacobian_single_strided, SO3_leftJacobian_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_leftJacobian_single, 2, ANY, 12, 36, 4, 12, 4)
LOOPS(SO3_leftJacobian)

/* (3)->(3,3) */
OVER(SO3_rightJacobian_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobian(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobian_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_rightJacobian_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_rightJacobian_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_rightJacobian_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_rightJacobian_double_strided, SO3_rightJacobian_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_rightJacobian_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_rightJacobian_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianf(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobian_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_rightJacobian_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_rightJacobianf_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_rightJacobian_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_rightJacobian_single_strided, SO3_rightJacobian_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_rightJacobian_single, 2, ANY, 12, 36, 4, 12, 4)
LOOPS(SO3_rightJacobian)

/* (3)->(3,3) */
OVER(SO3_leftJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobianInverse(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobianInverse_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_leftJacobianInverse_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_leftJacobianInverse_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_leftJacobianInverse_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_leftJacobianInverse_double_strided, SO3_leftJacobianInverse_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_leftJacobianInverse_double, 2, DENSE, 24, 72, 8, 24, 8)

OVER(SO3_leftJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianInversef(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobianInverse_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_leftJacobianInverse_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_leftJacobianInversef_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_leftJacobianInverse_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_leftJacobianInverse_single_strided, SO3_leftJacobianInverse_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_leftJacobianInverse_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_leftJacobianInverse)

/* (3)->(3,3) */
OVER(SO3_rightJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobianInverse(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobianInverse_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_rightJacobianInverse_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_rightJacobianInverse_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_rightJacobianInverse_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_rightJacobianInverse_double_strided, SO3_rightJacobianInverse_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_rightJacobianInverse_double, 2, DENSE, 24, 72, 8, 24, 8)

OVER(SO3_rightJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianInversef(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobianInverse_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SO3_rightJacobianInverse_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SO3_rightJacobianInversef_states(v, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SO3_rightJacobianInverse_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SO3_rightJacobianInverse_single_strided, SO3_rightJacobianInverse_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SO3_rightJacobianInverse_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_rightJacobianInverse)

/* (3,3)->(3,3) */
OVER(mat3x3_orthonormalize_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_orthonormalize(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalize_double)
LOOP(mat3x3_orthonormalize_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_orthonormalize_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_orthonormalize(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalize_single)
LOOP(mat3x3_orthonormalize_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalize)

/* (3,3)->(3,3) */
OVER(mat3x3_orthonormalized_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_orthonormalized(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalized_double)
LOOP(mat3x3_orthonormalized_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_orthonormalized_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_orthonormalized(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalized_single)
LOOP(mat3x3_orthonormalized_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalized)

/* (6)->(3,4) */
OVER(SE3_exp_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_SE3_t D;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_exp(&s, &D);
    STORE(SE3_double, &D, 1, 1);
  }
}
STRIDED(SE3_exp_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_exp_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states s[6];
  ksl_states D[21][12];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_exp_states(s, D[g]);
  }
  COMPUTED(D);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_SE3_double(D[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_SE3_double(D[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_exp_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_exp_double_strided, SE3_exp_double_on_vectors, 2,
    KSL_LANES, 21 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_exp_double, 2, ANY, 48, 96, 8, 32, 8)

OVER(SE3_exp_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_SE3f_t D;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_exp(&s, &D);
    STORE(SE3_single, &D, 1, 1);
  }
}
STRIDED(SE3_exp_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_exp_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf s[6];
  ksl_statesf D[21][12];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_exp_states(s, D[g]);
  }
  COMPUTED(D);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_SE3_single(D[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_SE3_single(D[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_exp_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_exp_single_strided, SE3_exp_single_on_vectors, 2,
    KSL_LANESF, 21 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_exp_single, 2, ANY, 24, 48, 4, 16, 4)
LOOPS(SE3_exp)

/* (3,4)->(6) */
OVER(SE3_log_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_log(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(SE3_log_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_log_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states D[12];
  ksl_states so[42][6];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_SE3_double(D, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_SE3_double(D, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_log_states(D, so[g]);
  }
  COMPUTED(so);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_screw_double(so[g], data[1] + j * step[1], step[1], core + 2, KSL_LANES);
    } else {
      store_lanes_screw_double(so[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void SE3_log_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_log_double_strided, SE3_log_double_on_vectors, 2,
    KSL_LANES, 42 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_log_double, 2, ANY, 96, 48, 32, 8, 8)

OVER(SE3_log_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_log(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(SE3_log_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_log_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf D[12];
  ksl_statesf so[42][6];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_SE3_single(D, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_SE3_single(D, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_log_states(D, so[g]);
  }
  COMPUTED(so);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_screw_single(so[g], data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
    } else {
      store_lanes_screw_single(so[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void SE3_log_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_log_single_strided, SE3_log_single_on_vectors, 2,
    KSL_LANESF, 42 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_log_single, 2, ANY, 48, 24, 16, 4, 4)
LOOPS(SE3_log)

/* (6)->(6,6) */
OVER(SE3_leftJacobian_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_leftJacobian(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobian_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_leftJacobian_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states s[6];
  ksl_states M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_leftJacobian_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_leftJacobian_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_leftJacobian_double_strided, SE3_leftJacobian_double_on_vectors, 2,
    KSL_LANES, 7 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_leftJacobian_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_leftJacobian_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_leftJacobian(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobian_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_leftJacobian_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf s[6];
  ksl_statesf M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_leftJacobian_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_leftJacobian_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_leftJacobian_single_strided, SE3_leftJacobian_single_on_vectors, 2,
    KSL_LANESF, 7 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_leftJacobian_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_leftJacobian)

/* (6)->(6,6) */
OVER(SE3_rightJacobian_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_rightJacobian(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobian_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_rightJacobian_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states s[6];
  ksl_states M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_rightJacobian_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_rightJacobian_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_rightJacobian_double_strided, SE3_rightJacobian_double_on_vectors, 2,
    KSL_LANES, 7 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_rightJacobian_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_rightJacobian_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_rightJacobian(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobian_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_rightJacobian_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf s[6];
  ksl_statesf M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_rightJacobian_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_rightJacobian_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_rightJacobian_single_strided, SE3_rightJacobian_single_on_vectors, 2,
    KSL_LANESF, 7 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_rightJacobian_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_rightJacobian)

/* (6)->(6,6) */
OVER(SE3_leftJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_leftJacobianInverse(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobianInverse_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_leftJacobianInverse_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states s[6];
  ksl_states M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_leftJacobianInverse_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_leftJacobianInverse_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_leftJacobianInverse_double_strided, SE3_leftJacobianInverse_double_on_vectors, 2,
    KSL_LANES, 7 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_leftJacobianInverse_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_leftJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_leftJacobianInverse(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobianInverse_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_leftJacobianInverse_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf s[6];
  ksl_statesf M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_leftJacobianInverse_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_leftJacobianInverse_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_leftJacobianInverse_single_strided, SE3_leftJacobianInverse_single_on_vectors, 2,
    KSL_LANESF, 7 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_leftJacobianInverse_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_leftJacobianInverse)

/* (6)->(6,6) */
OVER(SE3_rightJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_rightJacobianInverse(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobianInverse_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_rightJacobianInverse_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states s[6];
  ksl_states M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_screw_double(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3_rightJacobianInverse_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      store_lanes_mat6x6_double(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_rightJacobianInverse_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_rightJacobianInverse_double_strided, SE3_rightJacobianInverse_double_on_vectors, 2,
    KSL_LANES, 7 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_rightJacobianInverse_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_rightJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_rightJacobianInverse(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobianInverse_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_rightJacobianInverse_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf s[6];
  ksl_statesf M[7][36];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_screw_single(s, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_SE3f_rightJacobianInverse_states(s, M[g]);
  }
  COMPUTED(M);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat6x6_single(M[g], data[1] + j * step[1], step[1], core + 1, left);
    }
  }
  return 1;
}

static APART void SE3_rightJacobianInverse_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_rightJacobianInverse_single_strided, SE3_rightJacobianInverse_single_on_vectors, 2,
    KSL_LANESF, 7 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_rightJacobianInverse_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_rightJacobianInverse)

/* (3,4),(3,4),()->(3,4) */
OVER(SE3_interpolated_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    LOAD(scalar_double, &k, 2, 4);
    ksl_SE3_interpolated(&D1, &D2, k, &Do);
    STORE(SE3_double, &Do, 3, 4);
  }
}
STRIDED(SE3_interpolated_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_interpolated_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states D1[12];
  ksl_states D2[12];
  ksl_states k[1];
  ksl_states Do[21][12];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_SE3_double(D1, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_SE3_double(D2, data[1] + j * step[1], step[1], core + 2, KSL_LANES);
      load_lanes_scalar_double(k, data[2] + j * step[2], step[2], core + 4, KSL_LANES);
    } else {
      load_lanes_SE3_double(D1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_SE3_double(D2, data[1] + j * step[1], step[1], core + 2, left);
      load_lanes_scalar_double(k, data[2] + j * step[2], step[2], core + 4, left);
    }
    ksl_SE3_interpolated_states(D1, D2, k, Do[g]);
  }
  COMPUTED(Do);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_SE3_double(Do[g], data[3] + j * step[3], step[3], core + 4, KSL_LANES);
    } else {
      store_lanes_SE3_double(Do[g], data[3] + j * step[3], step[3], core + 4, left);
    }
  }
  return 1;
}

static APART void SE3_interpolated_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_interpolated_double_strided, SE3_interpolated_double_on_vectors, 4,
    KSL_LANES, 21 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_interpolated_double, 4, DENSE_OR_ONE, 96, 96, 8, 96, 32, 8, 32, 8, 32, 8)

OVER(SE3_interpolated_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    LOAD(scalar_single, &k, 2, 4);
    ksl_SE3f_interpolated(&D1, &D2, k, &Do);
    STORE(SE3_single, &Do, 3, 4);
  }
}
STRIDED(SE3_interpolated_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int SE3_interpolated_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf D1[12];
  ksl_statesf D2[12];
  ksl_statesf k[1];
  ksl_statesf Do[21][12];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_SE3_single(D1, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_SE3_single(D2, data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
      load_lanes_scalar_single(k, data[2] + j * step[2], step[2], core + 4, KSL_LANESF);
    } else {
      load_lanes_SE3_single(D1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_SE3_single(D2, data[1] + j * step[1], step[1], core + 2, left);
      load_lanes_scalar_single(k, data[2] + j * step[2], step[2], core + 4, left);
    }
    ksl_SE3f_interpolated_states(D1, D2, k, Do[g]);
  }
  COMPUTED(Do);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_SE3_single(Do[g], data[3] + j * step[3], step[3], core + 4, KSL_LANESF);
    } else {
      store_lanes_SE3_single(Do[g], data[3] + j * step[3], step[3], core + 4, left);
    }
  }
  return 1;
}

static APART void SE3_interpolated_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { SE3_interpolated_single_strided, SE3_interpolated_single_on_vectors, 4,
    KSL_LANESF, 21 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(SE3_interpolated_single, 4, DENSE_OR_ONE, 48, 48, 4, 48, 16, 4, 16, 4, 16, 4)
LOOPS(SE3_interpolated)

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_exp", "(3)->(3,3)",
    "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "77 mul, 102 add, 3 div, 1 sqrt, 5 abs, 5 less, 11 select.  Error <= R: (6 + θ/200) u of its\n"
    "largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.\n",
   1, 1, "", SO3_exp_loops},
  {"SO3_log", "(3,3)->(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.\n"
    "40 mul, 51 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.  Error\n"
    "<= vo: 7 u of its largest component for R a rotation; searched, not proved.\n",
   1, 1, "R", SO3_log_loops},
  {"SO3_leftJacobian", "(3)->(3,3)",
    "R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "88 mul, 114 add, 4 div, 1 sqrt, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u of its\n"
    "largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.\n",
   1, 1, "", SO3_leftJacobian_loops},
  {"SO3_rightJacobian", "(3)->(3,3)",
    "R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "88 mul, 114 add, 4 div, 1 sqrt, 3 neg, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u\n"
    "of its largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.\n",
   1, 1, "", SO3_rightJacobian_loops},
  {"SO3_leftJacobianInverse", "(3)->(3,3)",
    "R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "71 mul, 96 add, 3 div, 1 sqrt, 3 neg, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its\n"
    "largest component for |v| <= π; searched, not proved.\n",
   1, 1, "", SO3_leftJacobianInverse_loops},
  {"SO3_rightJacobianInverse", "(3)->(3,3)",
    "R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "71 mul, 96 add, 3 div, 1 sqrt, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its largest\n"
    "component for |v| <= π; searched, not proved.\n",
   1, 1, "", SO3_rightJacobianInverse_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "51 mul, 42 add, 3 neg.  Error <= u |result| + 7 u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "51 mul, 42 add, 3 neg.  Error <= u |result| + 7 u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalized_loops},
  {"SE3_exp", "(6)->(3,4)",
    "D = exp s = [exp ω~ | J_l(ω) v].\n"
    "\n"
    "(6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.\n"
    "108 mul, 126 add, 4 div, 1 sqrt, 5 abs, 6 less, 13 select.  Error <= R: (6 + θ/200) u, t:\n"
    "(14 + θ/200) u of its largest component, or of s.lin if that is larger, for |ω of s| <=\n"
    "1e13, in single precision 1e5; searched, not proved.  Intermediate sums may overflow where\n"
    "|v|, or |ω| |v|, is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_exp_loops},
  {"SE3_log", "(3,4)->(6)",
    "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "79 mul, 80 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 20 less, 2 equal, 43 select.  Error\n"
    "<= lin: 18 u, ang: 8 u of its largest component for R of D a rotation; searched, not proved.\n"
    "Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36.\n",
   1, 1, "R", SE3_log_loops},
  {"SE3_leftJacobian", "(6)->(6,6)",
    "M = J_l(s) = Σ ([ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "149 mul, 166 add, 6 div, 1 sqrt, 1 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its\n"
    "largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow\n"
    "where |v| is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_leftJacobian_loops},
  {"SE3_rightJacobian", "(6)->(6,6)",
    "M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "149 mul, 166 add, 6 div, 1 sqrt, 13 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its\n"
    "largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow\n"
    "where |v| is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_rightJacobian_loops},
  {"SE3_leftJacobianInverse", "(6)->(6,6)",
    "M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its\n"
    "largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow\n"
    "where |v| is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_leftJacobianInverse_loops},
  {"SE3_rightJacobianInverse", "(6)->(6,6)",
    "M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its\n"
    "largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow\n"
    "where |v| is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_rightJacobianInverse_loops},
  {"SE3_interpolated", "(3,4),(3,4),()->(3,4)",
    "Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.\n"
    "\n"
    "(3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "265 mul, 260 add, 8 div, 2 sqrt, 6 neg, 10 abs, 2 copysign, 26 less, 2 equal, 56 select.\n"
    "Error <= R: 22 u, t: 60 u of its largest component, or of D1.t or D2.t if that is larger,\n"
    "for R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.\n"
    "Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision\n"
    "5e36.\n",
   3, 1, "RR.", SE3_interpolated_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
