/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/mat3x3.h"
#include "_lanes.h"
#include "../c/include/ksl/mat3x3_states.h"

/* (3,3)->(3,3) */
OVER(mat3x3_copy_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_copy(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_copy_double)
LOOP(mat3x3_copy_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_copy_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_copy(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_copy_single)
LOOP(mat3x3_copy_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_copy)

/* (3,3)->(3,3) */
OVER(mat3x3_setIdentity_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_setIdentity(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED(mat3x3_setIdentity_double)
LOOP(mat3x3_setIdentity_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_setIdentity_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_setIdentity(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_setIdentity_single)
LOOP(mat3x3_setIdentity_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_setIdentity)

/* (3),(3),(3)->(3,3) */
OVER(mat3x3_setFromVectors_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    ksl_vec3_t z;
    ksl_mat3x3_t R;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    LOAD(vec3_double, &z, 2, 2);
    ksl_mat3x3_setFromVectors(&R, &x, &y, &z);
    STORE(mat3x3_double, &R, 3, 3);
  }
}
STRIDED(mat3x3_setFromVectors_double)
LOOP(mat3x3_setFromVectors_double, 4, DENSE_OR_ONE, 24, 24, 24, 72, 8, 8, 8, 24, 8)

OVER(mat3x3_setFromVectors_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    ksl_vec3f_t z;
    ksl_mat3x3f_t R;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    LOAD(vec3_single, &z, 2, 2);
    ksl_mat3x3f_setFromVectors(&R, &x, &y, &z);
    STORE(mat3x3_single, &R, 3, 3);
  }
}
STRIDED(mat3x3_setFromVectors_single)
LOOP(mat3x3_setFromVectors_single, 4, DENSE_OR_ONE, 12, 12, 12, 36, 4, 4, 4, 12, 4)
LOOPS(mat3x3_setFromVectors)

/* (3)->(3,3) */
OVER(skew_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t Ro;
    LOAD(vec3_double, &v, 0, 0);
    ksl_skew(&v, &Ro);
    STORE(mat3x3_double, &Ro, 1, 1);
  }
}
STRIDED(skew_double)
LOOP(skew_double, 2, DENSE, 24, 72, 8, 24, 8)

OVER(skew_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t Ro;
    LOAD(vec3_single, &v, 0, 0);
    ksl_skewf(&v, &Ro);
    STORE(mat3x3_single, &Ro, 1, 1);
  }
}
STRIDED(skew_single)
LOOP(skew_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(skew)

/* (3),(3)->(3,3) */
OVER(acceleration_tensor_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t w, &w);
  EACH {
    ksl_vec3_t dw;
    ksl_mat3x3_t Ro;
    LOAD_OTHER(vec3_double, &w);
    LOAD(vec3_double, &dw, 1, 1);
    ksl_acceleration_tensor(&w, &dw, &Ro);
    STORE(mat3x3_double, &Ro, 2, 2);
  }
}
STRIDED(acceleration_tensor_double)
LOOP(acceleration_tensor_double, 3, DENSE_OR_ONE, 24, 24, 72, 8, 8, 24, 8)

OVER(acceleration_tensor_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t w, &w);
  EACH {
    ksl_vec3f_t dw;
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(vec3_single, &w);
    LOAD(vec3_single, &dw, 1, 1);
    ksl_acceleration_tensorf(&w, &dw, &Ro);
    STORE(mat3x3_single, &Ro, 2, 2);
  }
}
STRIDED(acceleration_tensor_single)
LOOP(acceleration_tensor_single, 3, DENSE_OR_ONE, 12, 12, 36, 4, 4, 12, 4)
LOOPS(acceleration_tensor)

/* (3,3)->(3,3) */
OVER(mat3x3_transpose_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_transpose(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED(mat3x3_transpose_double)
LOOP(mat3x3_transpose_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_transpose_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_transpose(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_transpose_single)
LOOP(mat3x3_transpose_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_transpose)

/* (3,3)->(3,3) */
OVER(mat3x3_transposed_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_transposed(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_transposed_double)
LOOP(mat3x3_transposed_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_transposed_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_transposed(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_transposed_single)
LOOP(mat3x3_transposed_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_transposed)

/* (3,3)->() */
OVER(mat3x3_determinant_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    double det;
    LOAD(mat3x3_double, &R, 0, 0);
    det = ksl_mat3x3_determinant(&R);
    STORE(scalar_double, &det, 1, 2);
  }
}
STRIDED(mat3x3_determinant_double)
LOOP(mat3x3_determinant_double, 2, DENSE, 72, 8, 24, 8)

OVER(mat3x3_determinant_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    float det;
    LOAD(mat3x3_single, &R, 0, 0);
    det = ksl_mat3x3f_determinant(&R);
    STORE(scalar_single, &det, 1, 2);
  }
}
STRIDED(mat3x3_determinant_single)
LOOP(mat3x3_determinant_single, 2, DENSE, 36, 4, 12, 4)
LOOPS(mat3x3_determinant)

/* (3,3)->(),(3,3) */
OVER(mat3x3_inverse_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    double det;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    det = ksl_mat3x3_inverse(&R, &Ro);
    STORE(scalar_double, &det, 1, 2);
    STORE(mat3x3_double, &Ro, 2, 2);
  }
}
STRIDED(mat3x3_inverse_double)
LOOP(mat3x3_inverse_double, 3, DENSE, 72, 8, 72, 24, 8, 24, 8)

OVER(mat3x3_inverse_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    float det;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    det = ksl_mat3x3f_inverse(&R, &Ro);
    STORE(scalar_single, &det, 1, 2);
    STORE(mat3x3_single, &Ro, 2, 2);
  }
}
STRIDED(mat3x3_inverse_single)
LOOP(mat3x3_inverse_single, 3, DENSE, 36, 4, 36, 12, 4, 12, 4)
LOOPS(mat3x3_inverse)

/* (3,3)->(3,3) */
OVER(mat3x3_normalize_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_normalize(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED(mat3x3_normalize_double)
LOOP(mat3x3_normalize_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_normalize_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_normalize(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_normalize_single)
LOOP(mat3x3_normalize_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_normalize)

/* (3,3)->(3,3) */
OVER(mat3x3_normalized_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_normalized(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_normalized_double)
LOOP(mat3x3_normalized_double, 2, DENSE, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_normalized_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_normalized(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_normalized_single)
LOOP(mat3x3_normalized_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_normalized)

/* (3),(2)->(3,3) */
OVER(mat3x3_setFromAxisDC_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double dc[2];
    ksl_mat3x3_t R;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(dc_double, dc, 1, 1);
    ksl_mat3x3_setFromAxisDC(&R, &axis, dc);
    STORE(mat3x3_double, &R, 2, 2);
  }
}
STRIDED(mat3x3_setFromAxisDC_double)
LOOP(mat3x3_setFromAxisDC_double, 3, DENSE_OR_ONE, 24, 16, 72, 8, 8, 24, 8)

OVER(mat3x3_setFromAxisDC_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float dc[2];
    ksl_mat3x3f_t R;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(dc_single, dc, 1, 1);
    ksl_mat3x3f_setFromAxisDC(&R, &axis, dc);
    STORE(mat3x3_single, &R, 2, 2);
  }
}
STRIDED(mat3x3_setFromAxisDC_single)
LOOP(mat3x3_setFromAxisDC_single, 3, DENSE_OR_ONE, 12, 8, 36, 4, 4, 12, 4)
LOOPS(mat3x3_setFromAxisDC)

/* (3)->(3,3) */
OVER(mat3x3_from_euler_xyz_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyz(&angles, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyz_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_euler_xyz_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states angles[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(angles, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(angles, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_mat3x3_from_euler_xyz_states(angles, R[g]);
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

static APART void mat3x3_from_euler_xyz_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_euler_xyz_double_strided, mat3x3_from_euler_xyz_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_euler_xyz_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(mat3x3_from_euler_xyz_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyz(&angles, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyz_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_euler_xyz_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf angles[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(angles, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(angles, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_mat3x3f_from_euler_xyz_states(angles, R[g]);
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

static APART void mat3x3_from_euler_xyz_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_euler_xyz_single_strided, mat3x3_from_euler_xyz_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_euler_xyz_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyz)

/* (3,3)->(3) */
OVER(euler_xyz_from_mat3x3_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3(&R, &angles);
    STORE(vec3_double, &angles, 1, 2);
  }
}
STRIDED(euler_xyz_from_mat3x3_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int euler_xyz_from_mat3x3_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states R[9];
  ksl_states angles[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_euler_xyz_from_mat3x3_states(R, angles[g]);
  }
  COMPUTED(angles);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_vec3_double(angles[g], data[1] + j * step[1], step[1], core + 2, KSL_LANES);
    } else {
      store_lanes_vec3_double(angles[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void euler_xyz_from_mat3x3_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { euler_xyz_from_mat3x3_double_strided, euler_xyz_from_mat3x3_double_on_vectors, 2,
    KSL_LANES, 85 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(euler_xyz_from_mat3x3_double, 2, ANY, 72, 24, 24, 8, 8)

OVER(euler_xyz_from_mat3x3_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3f(&R, &angles);
    STORE(vec3_single, &angles, 1, 2);
  }
}
STRIDED(euler_xyz_from_mat3x3_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int euler_xyz_from_mat3x3_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf R[9];
  ksl_statesf angles[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_euler_xyz_from_mat3x3f_states(R, angles[g]);
  }
  COMPUTED(angles);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_vec3_single(angles[g], data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
    } else {
      store_lanes_vec3_single(angles[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void euler_xyz_from_mat3x3_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { euler_xyz_from_mat3x3_single_strided, euler_xyz_from_mat3x3_single_on_vectors, 2,
    KSL_LANESF, 85 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(euler_xyz_from_mat3x3_single, 2, ANY, 36, 12, 12, 4, 4)
LOOPS(euler_xyz_from_mat3x3)

/* (3)->(3,3) */
OVER(mat3x3_from_euler_xyx_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyx(&angles, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyx_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_euler_xyx_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states angles[3];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(angles, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_vec3_double(angles, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_mat3x3_from_euler_xyx_states(angles, R[g]);
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

static APART void mat3x3_from_euler_xyx_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_euler_xyx_double_strided, mat3x3_from_euler_xyx_double_on_vectors, 2,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_euler_xyx_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(mat3x3_from_euler_xyx_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyx(&angles, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyx_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_euler_xyx_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf angles[3];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(angles, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_vec3_single(angles, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_mat3x3f_from_euler_xyx_states(angles, R[g]);
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

static APART void mat3x3_from_euler_xyx_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_euler_xyx_single_strided, mat3x3_from_euler_xyx_single_on_vectors, 2,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_euler_xyx_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyx)

/* (3,3)->(3) */
OVER(euler_xyx_from_mat3x3_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3(&R, &angles);
    STORE(vec3_double, &angles, 1, 2);
  }
}
STRIDED(euler_xyx_from_mat3x3_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int euler_xyx_from_mat3x3_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states R[9];
  ksl_states angles[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_euler_xyx_from_mat3x3_states(R, angles[g]);
  }
  COMPUTED(angles);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_vec3_double(angles[g], data[1] + j * step[1], step[1], core + 2, KSL_LANES);
    } else {
      store_lanes_vec3_double(angles[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void euler_xyx_from_mat3x3_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { euler_xyx_from_mat3x3_double_strided, euler_xyx_from_mat3x3_double_on_vectors, 2,
    KSL_LANES, 85 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(euler_xyx_from_mat3x3_double, 2, ANY, 72, 24, 24, 8, 8)

OVER(euler_xyx_from_mat3x3_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3f(&R, &angles);
    STORE(vec3_single, &angles, 1, 2);
  }
}
STRIDED(euler_xyx_from_mat3x3_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int euler_xyx_from_mat3x3_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf R[9];
  ksl_statesf angles[85][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_euler_xyx_from_mat3x3f_states(R, angles[g]);
  }
  COMPUTED(angles);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_vec3_single(angles[g], data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
    } else {
      store_lanes_vec3_single(angles[g], data[1] + j * step[1], step[1], core + 2, left);
    }
  }
  return 1;
}

static APART void euler_xyx_from_mat3x3_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { euler_xyx_from_mat3x3_single_strided, euler_xyx_from_mat3x3_single_on_vectors, 2,
    KSL_LANESF, 85 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(euler_xyx_from_mat3x3_single, 2, ANY, 36, 12, 12, 4, 4)
LOOPS(euler_xyx_from_mat3x3)

/* (3,3),(3,3)->(3,3),(3,3) */
OVER(mat3x3_jacobi_double) {
  POINTERS_4
  EACH {
    ksl_mat3x3_t A;
    ksl_mat3x3_t V;
    LOAD(mat3x3_double, &A, 0, 0);
    LOAD(mat3x3_double, &V, 1, 2);
    ksl_mat3x3_jacobi(&A, &V);
    STORE(mat3x3_double, &A, 2, 4);
    STORE(mat3x3_double, &V, 3, 6);
  }
}
STRIDED(mat3x3_jacobi_double)
LOOP(mat3x3_jacobi_double, 4, DENSE, 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8)

OVER(mat3x3_jacobi_single) {
  POINTERS_4
  EACH {
    ksl_mat3x3f_t A;
    ksl_mat3x3f_t V;
    LOAD(mat3x3_single, &A, 0, 0);
    LOAD(mat3x3_single, &V, 1, 2);
    ksl_mat3x3f_jacobi(&A, &V);
    STORE(mat3x3_single, &A, 2, 4);
    STORE(mat3x3_single, &V, 3, 6);
  }
}
STRIDED(mat3x3_jacobi_single)
LOOP(mat3x3_jacobi_single, 4, DENSE, 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4)
LOOPS(mat3x3_jacobi)

/* (3,3)->() */
OVER(mat3x3_rotation_defect_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    double defect;
    LOAD(mat3x3_double, &R, 0, 0);
    defect = ksl_mat3x3_rotation_defect(&R);
    STORE(scalar_double, &defect, 1, 2);
  }
}
STRIDED(mat3x3_rotation_defect_double)
LOOP(mat3x3_rotation_defect_double, 2, DENSE, 72, 8, 24, 8)

OVER(mat3x3_rotation_defect_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    float defect;
    LOAD(mat3x3_single, &R, 0, 0);
    defect = ksl_mat3x3f_rotation_defect(&R);
    STORE(scalar_single, &defect, 1, 2);
  }
}
STRIDED(mat3x3_rotation_defect_single)
LOOP(mat3x3_rotation_defect_single, 2, DENSE, 36, 4, 12, 4)
LOOPS(mat3x3_rotation_defect)

/* (3,3)->(3,3) */
OVER(mat3x3_nearest_rotation_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t A;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &A, 0, 0);
    ksl_mat3x3_nearest_rotation(&A, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_nearest_rotation_double)
LOOP(mat3x3_nearest_rotation_double, 2, ANY, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_nearest_rotation_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t A;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &A, 0, 0);
    ksl_mat3x3f_nearest_rotation(&A, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_nearest_rotation_single)
LOOP(mat3x3_nearest_rotation_single, 2, ANY, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_nearest_rotation)

/* (3),()->(3,3) */
OVER(mat3x3_from_axis_angle_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double angle;
    ksl_mat3x3_t R;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(scalar_double, &angle, 1, 1);
    ksl_mat3x3_from_axis_angle(&axis, angle, &R);
    STORE(mat3x3_double, &R, 2, 1);
  }
}
STRIDED(mat3x3_from_axis_angle_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_axis_angle_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states axis[3];
  ksl_states angle[1];
  ksl_states R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(axis, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_scalar_double(angle, data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      load_lanes_vec3_double(axis, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_double(angle, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_mat3x3_from_axis_angle_states(axis, angle, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_mat3x3_double(R[g], data[2] + j * step[2], step[2], core + 1, KSL_LANES);
    } else {
      store_lanes_mat3x3_double(R[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void mat3x3_from_axis_angle_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_axis_angle_double_strided, mat3x3_from_axis_angle_double_on_vectors, 3,
    KSL_LANES, 28 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_axis_angle_double, 3, DENSE_OR_ONE, 24, 8, 72, 8, 24, 8)

OVER(mat3x3_from_axis_angle_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float angle;
    ksl_mat3x3f_t R;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(scalar_single, &angle, 1, 1);
    ksl_mat3x3f_from_axis_angle(&axis, angle, &R);
    STORE(mat3x3_single, &R, 2, 1);
  }
}
STRIDED(mat3x3_from_axis_angle_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int mat3x3_from_axis_angle_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf axis[3];
  ksl_statesf angle[1];
  ksl_statesf R[28][9];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(axis, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_scalar_single(angle, data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      load_lanes_vec3_single(axis, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_scalar_single(angle, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_mat3x3f_from_axis_angle_states(axis, angle, R[g]);
  }
  COMPUTED(R);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_mat3x3_single(R[g], data[2] + j * step[2], step[2], core + 1, KSL_LANESF);
    } else {
      store_lanes_mat3x3_single(R[g], data[2] + j * step[2], step[2], core + 1, left);
    }
  }
  return 1;
}

static APART void mat3x3_from_axis_angle_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { mat3x3_from_axis_angle_single_strided, mat3x3_from_axis_angle_single_on_vectors, 3,
    KSL_LANESF, 28 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(mat3x3_from_axis_angle_single, 3, DENSE_OR_ONE, 12, 4, 36, 4, 12, 4)
LOOPS(mat3x3_from_axis_angle)

/* (3,3)->(),(3) */
OVER(axis_angle_from_mat3x3_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    double angle;
    ksl_vec3_t axis;
    LOAD(mat3x3_double, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3(&R, &axis);
    STORE(scalar_double, &angle, 1, 2);
    STORE(vec3_double, &axis, 2, 2);
  }
}
STRIDED(axis_angle_from_mat3x3_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int axis_angle_from_mat3x3_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states R[9];
  ksl_states angle[64][1];
  ksl_states axis[64][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
    } else {
      load_lanes_mat3x3_double(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_axis_angle_from_mat3x3_states(R, angle[g], axis[g]);
  }
  COMPUTED(angle);
  COMPUTED(axis);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(angle[g], data[1] + j * step[1], step[1], core + 2, KSL_LANES);
      store_lanes_vec3_double(axis[g], data[2] + j * step[2], step[2], core + 2, KSL_LANES);
    } else {
      store_lanes_scalar_double(angle[g], data[1] + j * step[1], step[1], core + 2, left);
      store_lanes_vec3_double(axis[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void axis_angle_from_mat3x3_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { axis_angle_from_mat3x3_double_strided, axis_angle_from_mat3x3_double_on_vectors, 3,
    KSL_LANES, 64 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(axis_angle_from_mat3x3_double, 3, DENSE, 72, 8, 24, 24, 8, 8)

OVER(axis_angle_from_mat3x3_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    float angle;
    ksl_vec3f_t axis;
    LOAD(mat3x3_single, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3f(&R, &axis);
    STORE(scalar_single, &angle, 1, 2);
    STORE(vec3_single, &axis, 2, 2);
  }
}
STRIDED(axis_angle_from_mat3x3_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int axis_angle_from_mat3x3_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf R[9];
  ksl_statesf angle[64][1];
  ksl_statesf axis[64][3];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
    } else {
      load_lanes_mat3x3_single(R, data[0] + j * step[0], step[0], core + 0, left);
    }
    ksl_axis_angle_from_mat3x3f_states(R, angle[g], axis[g]);
  }
  COMPUTED(angle);
  COMPUTED(axis);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(angle[g], data[1] + j * step[1], step[1], core + 2, KSL_LANESF);
      store_lanes_vec3_single(axis[g], data[2] + j * step[2], step[2], core + 2, KSL_LANESF);
    } else {
      store_lanes_scalar_single(angle[g], data[1] + j * step[1], step[1], core + 2, left);
      store_lanes_vec3_single(axis[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void axis_angle_from_mat3x3_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { axis_angle_from_mat3x3_single_strided, axis_angle_from_mat3x3_single_on_vectors, 3,
    KSL_LANESF, 64 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(axis_angle_from_mat3x3_single, 3, DENSE, 36, 4, 12, 12, 4, 4)
LOOPS(axis_angle_from_mat3x3)

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"mat3x3_copy", "(3,3)->(3,3)",
    "Ro = R.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat3x3_copy_loops},
  {"mat3x3_setIdentity", "(3,3)->(3,3)",
    "self = I.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat3x3_setIdentity_loops},
  {"mat3x3_setFromVectors", "(3),(3),(3)->(3,3)",
    "R = [x y z], the columns.\n"
    "\n"
    "(3),(3),(3)->(3,3).  x, y, z: vector; R: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   3, 1, "", mat3x3_setFromVectors_loops},
  {"skew", "(3)->(3,3)",
    "Ro = v~, the matrix with v~ y = v × y.\n"
    "\n"
    "(3)->(3,3).  v: vector; Ro: rotation or other 3×3 matrix.\n"
    "3 neg.  Exact.\n",
   1, 1, "", skew_loops},
  {"acceleration_tensor", "(3),(3)->(3,3)",
    "Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the\n"
    "acceleration of its point x, less that of its origin, is Ro x.\n"
    "\n"
    "(3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.\n"
    "6 mul, 9 add, 3 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", acceleration_tensor_loops},
  {"mat3x3_transpose", "(3,3)->(3,3)",
    "self = self^T, the inverse of a rotation.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat3x3_transpose_loops},
  {"mat3x3_transposed", "(3,3)->(3,3)",
    "Ro = R^T, the inverse of a rotation.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat3x3_transposed_loops},
  {"mat3x3_determinant", "(3,3)->()",
    "det R.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; det: number.\n"
    "9 mul, 5 add.  Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_determinant_loops},
  {"mat3x3_inverse", "(3,3)->(),(3,3)",
    "Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or\n"
    "overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3\n"
    "(double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.\n"
    "\n"
    "(3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.\n"
    "56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.  Error of Ro_ij <= 2 u\n"
    "m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of the cofactor, or\n"
    "2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow of Ro_ij itself.\n",
   1, 2, "", mat3x3_inverse_loops},
  {"mat3x3_normalize", "(3,3)->(3,3)",
    "self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on\n"
    "its side of the first, the third on its side of both; NaN where the rows are linearly\n"
    "dependent to rounding.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij\n"
    "<= 8 u for the result R; searched, not proved.\n",
   1, 1, "", mat3x3_normalize_loops},
  {"mat3x3_normalized", "(3,3)->(3,3)",
    "Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on\n"
    "its side of the first, the third on its side of both; NaN where the rows are linearly\n"
    "dependent to rounding.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij\n"
    "<= 8 u for the result R; searched, not proved.\n",
   1, 1, "", mat3x3_normalized_loops},
  {"mat3x3_setFromAxisDC", "(3),(2)->(3,3)",
    "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),\n"
    "dc = (sin θ, cos θ).\n"
    "\n"
    "(3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.\n"
    "12 mul, 10 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", mat3x3_setFromAxisDC_loops},
  {"mat3x3_from_euler_xyz", "(3)->(3,3)",
    "R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).\n"
    "\n"
    "(3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.\n"
    "98 mul, 103 add, 3 neg, 3 abs.\n",
   1, 1, "", mat3x3_from_euler_xyz_loops},
  {"euler_xyz_from_mat3x3", "(3,3)->(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[-π/2, π/2]; c = 0 in gimbal lock.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.\n"
    "93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The\n"
    "rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;\n"
    "searched, not proved.\n",
   1, 1, "R", euler_xyz_from_mat3x3_loops},
  {"mat3x3_from_euler_xyx", "(3)->(3,3)",
    "R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).\n"
    "\n"
    "(3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.\n"
    "98 mul, 103 add, 2 neg, 3 abs.\n",
   1, 1, "", mat3x3_from_euler_xyx_loops},
  {"euler_xyx_from_mat3x3", "(3,3)->(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[0, π]; c = 0 in gimbal lock.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.\n"
    "93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The\n"
    "rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;\n"
    "searched, not proved.\n",
   1, 1, "R", euler_xyx_from_mat3x3_loops},
  {"mat3x3_jacobi", "(3,3),(3,3)->(3,3),(3,3)",
    "A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes\n"
    "A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.\n"
    "Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.\n"
    "21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.  V A V^T changes by\n"
    "at most 28 u max |A| for orthonormal V; searched, not proved.\n",
   2, 2, ".R", mat3x3_jacobi_loops},
  {"mat3x3_rotation_defect", "(3,3)->()",
    "the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if\n"
    "an entry is NaN.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; defect: number.\n"
    "27 mul, 21 add, 7 abs, 6 less, 6 select.  Error <= 6 u near a rotation; measured, not\n"
    "proved.\n",
   1, 1, "", mat3x3_rotation_defect_loops},
  {"mat3x3_nearest_rotation", "(3,3)->(3,3)",
    "Ro = the rotation nearest to A, U diag(1, 1, ±1) V^T of A = U diag(s1, s2, s3) V^T: no\n"
    "rotation R has a larger tr R^T A or a smaller |R - A|.  For every finite A but 0, for which\n"
    "it is NaN; where several are equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices\n"
    "of rank 1) one of them.\n"
    "\n"
    "(3,3)->(3,3).  A, Ro: rotation or other 3×3 matrix.\n"
    "649 mul, 400 add, 51 div, 32 sqrt, 37 neg, 42 abs, 60 less, 34 equal, 169 select.  |Ro -\n"
    "nearest|_F <= 16 u s1 / (s2 ± s3), + if det A > 0, and |Ro^T Ro - I|_ij <= 6 u; measured,\n"
    "not proved.\n",
   1, 1, "M", mat3x3_nearest_rotation_loops},
  {"mat3x3_from_axis_angle", "(3),()->(3,3)",
    "R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is\n"
    "not a rotation.\n"
    "\n"
    "(3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.\n"
    "71 mul, 79 add, 2 abs, 1 less, 1 select.  Error <= R: 9 u of its largest component for\n"
    "|axis| = 1; searched, not proved.\n",
   2, 1, "", mat3x3_from_axis_angle_loops},
  {"axis_angle_from_mat3x3", "(3,3)->(),(3)",
    "angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.\n"
    "\n"
    "(3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.\n"
    "37 mul, 51 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.  Error\n"
    "<= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not proved.\n",
   1, 2, "R", axis_angle_from_mat3x3_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
