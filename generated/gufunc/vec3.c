/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/vec3.h"
#include "_lanes.h"
#include "../c/include/ksl/vec3_states.h"

/* (3)->(3) */
OVER(vec3_copy_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    LOAD(vec3_double, &vi, 0, 0);
    ksl_vec3_copy(&vi, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED(vec3_copy_double)
LOOP(vec3_copy_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_copy_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    LOAD(vec3_single, &vi, 0, 0);
    ksl_vec3f_copy(&vi, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(vec3_copy_single)
LOOP(vec3_copy_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_copy)

/* (3),()->(3) */
OVER(vec3_scale_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t self;
    double a;
    LOAD(vec3_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_vec3_scale(&self, a);
    STORE(vec3_double, &self, 2, 1);
  }
}
STRIDED(vec3_scale_double)
LOOP(vec3_scale_double, 3, DENSE, 24, 8, 24, 8, 8)

OVER(vec3_scale_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t self;
    float a;
    LOAD(vec3_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_vec3f_scale(&self, a);
    STORE(vec3_single, &self, 2, 1);
  }
}
STRIDED(vec3_scale_single)
LOOP(vec3_scale_single, 3, DENSE, 12, 4, 12, 4, 4)
LOOPS(vec3_scale)

/* (3)->(3) */
OVER(vec3_inverted_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    LOAD(vec3_double, &vi, 0, 0);
    ksl_vec3_inverted(&vi, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED(vec3_inverted_double)
LOOP(vec3_inverted_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_inverted_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    LOAD(vec3_single, &vi, 0, 0);
    ksl_vec3f_inverted(&vi, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(vec3_inverted_single)
LOOP(vec3_inverted_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_inverted)

/* (3)->(3) */
OVER(vec3_invert_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t self;
    LOAD(vec3_double, &self, 0, 0);
    ksl_vec3_invert(&self);
    STORE(vec3_double, &self, 1, 1);
  }
}
STRIDED(vec3_invert_double)
LOOP(vec3_invert_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_invert_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t self;
    LOAD(vec3_single, &self, 0, 0);
    ksl_vec3f_invert(&self);
    STORE(vec3_single, &self, 1, 1);
  }
}
STRIDED(vec3_invert_single)
LOOP(vec3_invert_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_invert)

/* (),(3),(3)->(3) */
OVER(axpy_vv_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t x;
    ksl_vec3_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &x, 1, 0);
    LOAD(vec3_double, &y, 2, 1);
    ksl_axpy_vv(a, &x, &y);
    STORE(vec3_double, &y, 3, 2);
  }
}
STRIDED(axpy_vv_double)
LOOP(axpy_vv_double, 4, DENSE_OR_ONE, 8, 24, 24, 24, 8, 8, 8)

OVER(axpy_vv_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t x;
    ksl_vec3f_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &x, 1, 0);
    LOAD(vec3_single, &y, 2, 1);
    ksl_axpy_vvf(a, &x, &y);
    STORE(vec3_single, &y, 3, 2);
  }
}
STRIDED(axpy_vv_single)
LOOP(axpy_vv_single, 4, DENSE_OR_ONE, 4, 12, 12, 12, 4, 4, 4)
LOOPS(axpy_vv)

/* (3),(3)->(3) */
OVER(xpy_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_xpy_vv(&x, &y);
    STORE(vec3_double, &y, 2, 2);
  }
}
STRIDED(xpy_vv_double)
LOOP(xpy_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(xpy_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_xpy_vvf(&x, &y);
    STORE(vec3_single, &y, 2, 2);
  }
}
STRIDED(xpy_vv_single)
LOOP(xpy_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(xpy_vv)

/* (3),(3)->(3) */
OVER(nxpy_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_nxpy_vv(&x, &y);
    STORE(vec3_double, &y, 2, 2);
  }
}
STRIDED(nxpy_vv_double)
LOOP(nxpy_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(nxpy_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_nxpy_vvf(&x, &y);
    STORE(vec3_single, &y, 2, 2);
  }
}
STRIDED(nxpy_vv_single)
LOOP(nxpy_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(nxpy_vv)

/* (),(3)->(3) */
OVER(product_av_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &vi, 1, 0);
    ksl_product_av(a, &vi, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(product_av_double)
LOOP(product_av_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_av_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &vi, 1, 0);
    ksl_product_avf(a, &vi, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_av_single)
LOOP(product_av_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_av)

/* (3),(3)->(3) */
OVER(add_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_add_vv(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(add_vv_double)
LOOP(add_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(add_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_add_vvf(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(add_vv_single)
LOOP(add_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(add_vv)

/* (3),(3)->(3) */
OVER(subtract_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_subtract_vv(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(subtract_vv_double)
LOOP(subtract_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(subtract_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_subtract_vvf(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(subtract_vv_single)
LOOP(subtract_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(subtract_vv)

/* (3),()->(3) */
OVER(vec3_scaled_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_vec3_scaled(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(vec3_scaled_double)
LOOP(vec3_scaled_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(vec3_scaled_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_vec3f_scaled(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(vec3_scaled_single)
LOOP(vec3_scaled_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(vec3_scaled)

/* (3),(3)->(3),(3) */
OVER(vec3_swap_double) {
  POINTERS_4
  EACH {
    ksl_vec3_t v1;
    ksl_vec3_t v2;
    LOAD(vec3_double, &v1, 0, 0);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_vec3_swap(&v1, &v2);
    STORE(vec3_double, &v1, 2, 2);
    STORE(vec3_double, &v2, 3, 3);
  }
}
STRIDED(vec3_swap_double)
LOOP(vec3_swap_double, 4, DENSE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(vec3_swap_single) {
  POINTERS_4
  EACH {
    ksl_vec3f_t v1;
    ksl_vec3f_t v2;
    LOAD(vec3_single, &v1, 0, 0);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_vec3f_swap(&v1, &v2);
    STORE(vec3_single, &v1, 2, 2);
    STORE(vec3_single, &v2, 3, 3);
  }
}
STRIDED(vec3_swap_single)
LOOP(vec3_swap_single, 4, DENSE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(vec3_swap)

/* (3)->() */
OVER(vec3_l2norm_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    double norm;
    LOAD(vec3_double, &v, 0, 0);
    norm = ksl_vec3_l2norm(&v);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED(vec3_l2norm_double)
LOOP(vec3_l2norm_double, 2, DENSE, 24, 8, 8)

OVER(vec3_l2norm_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    float norm;
    LOAD(vec3_single, &v, 0, 0);
    norm = ksl_vec3f_l2norm(&v);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(vec3_l2norm_single)
LOOP(vec3_l2norm_single, 2, DENSE, 12, 4, 4)
LOOPS(vec3_l2norm)

/* (3)->(3) */
OVER(vec3_normalize_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t self;
    LOAD(vec3_double, &self, 0, 0);
    ksl_vec3_normalize(&self);
    STORE(vec3_double, &self, 1, 1);
  }
}
STRIDED(vec3_normalize_double)
LOOP(vec3_normalize_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_normalize_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t self;
    LOAD(vec3_single, &self, 0, 0);
    ksl_vec3f_normalize(&self);
    STORE(vec3_single, &self, 1, 1);
  }
}
STRIDED(vec3_normalize_single)
LOOP(vec3_normalize_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_normalize)

/* (3)->(3) */
OVER(vec3_normalized_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD(vec3_double, &v, 0, 0);
    ksl_vec3_normalized(&v, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED(vec3_normalized_double)
LOOP(vec3_normalized_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_normalized_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD(vec3_single, &v, 0, 0);
    ksl_vec3f_normalized(&v, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(vec3_normalized_single)
LOOP(vec3_normalized_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_normalized)

/* (3),(3)->() */
OVER(angle_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double angle;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    angle = ksl_angle_vv(&v1, &v2);
    STORE(scalar_double, &angle, 2, 2);
  }
}
STRIDED(angle_vv_double)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int angle_vv_double_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_states v1[3];
  ksl_states v2[3];
  ksl_states angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      load_lanes_vec3_double(v1, data[0] + j * step[0], step[0], core + 0, KSL_LANES);
      load_lanes_vec3_double(v2, data[1] + j * step[1], step[1], core + 1, KSL_LANES);
    } else {
      load_lanes_vec3_double(v1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_vec3_double(v2, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_angle_vv_states(v1, v2, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANES) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANES) {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 2, KSL_LANES);
    } else {
      store_lanes_scalar_double(angle[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void angle_vv_double_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { angle_vv_double_strided, angle_vv_double_on_vectors, 3,
    KSL_LANES, 256 * KSL_LANES };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(angle_vv_double, 3, DENSE_OR_ONE, 24, 24, 8, 8, 8)

OVER(angle_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float angle;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    angle = ksl_angle_vvf(&v1, &v2);
    STORE(scalar_single, &angle, 2, 2);
  }
}
STRIDED(angle_vv_single)

#if KSL_LANE_BYTES
/* The same on vectors; 0, and nothing is written, if that raises flags that are not yet raised. */
INLINED int angle_vv_single_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised) {
  ksl_statesf v1[3];
  ksl_statesf v2[3];
  ksl_statesf angle[256][1];
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      load_lanes_vec3_single(v1, data[0] + j * step[0], step[0], core + 0, KSL_LANESF);
      load_lanes_vec3_single(v2, data[1] + j * step[1], step[1], core + 1, KSL_LANESF);
    } else {
      load_lanes_vec3_single(v1, data[0] + j * step[0], step[0], core + 0, left);
      load_lanes_vec3_single(v2, data[1] + j * step[1], step[1], core + 1, left);
    }
    ksl_angle_vvf_states(v1, v2, angle[g]);
  }
  COMPUTED(angle);
  if (lowered(raised)) {
    return 0;
  }
  for (npy_intp g = 0, left = m; left > 0; g++, left -= KSL_LANESF) {
    const npy_intp j = i + m - left;
    if (left >= KSL_LANESF) {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 2, KSL_LANESF);
    } else {
      store_lanes_scalar_single(angle[g], data[2] + j * step[2], step[2], core + 2, left);
    }
  }
  return 1;
}

static APART void angle_vv_single_many(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  const vector_loop loop = { angle_vv_single_strided, angle_vv_single_on_vectors, 3,
    KSL_LANESF, 256 * KSL_LANESF };
  many_elements(&loop, data, n, step, core);
}
#endif
LOOP_ON_VECTORS(angle_vv_single, 3, DENSE_OR_ONE, 12, 12, 4, 4, 4)
LOOPS(angle_vv)

/* (3),(3)->() */
OVER(dot_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double dot;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    dot = ksl_dot_vv(&v1, &v2);
    STORE(scalar_double, &dot, 2, 2);
  }
}
STRIDED(dot_vv_double)
LOOP(dot_vv_double, 3, DENSE_OR_ONE, 24, 24, 8, 8, 8)

OVER(dot_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float dot;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    dot = ksl_dot_vvf(&v1, &v2);
    STORE(scalar_single, &dot, 2, 2);
  }
}
STRIDED(dot_vv_single)
LOOP(dot_vv_single, 3, DENSE_OR_ONE, 12, 12, 4, 4, 4)
LOOPS(dot_vv)

/* (),(3)->(3) */
OVER(product_avinv_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double k, &k);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &k);
    LOAD(vec3_double, &v, 1, 0);
    ksl_product_avinv(k, &v, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(product_avinv_double)
LOOP(product_avinv_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_avinv_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float k, &k);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &k);
    LOAD(vec3_single, &v, 1, 0);
    ksl_product_avinvf(k, &v, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_avinv_single)
LOOP(product_avinv_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_avinv)

/* (),(3)->(3) */
OVER(product_ainvv_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double k, &k);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &k);
    LOAD(vec3_double, &v, 1, 0);
    ksl_product_ainvv(k, &v, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(product_ainvv_double)
LOOP(product_ainvv_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_ainvv_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float k, &k);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &k);
    LOAD(vec3_single, &v, 1, 0);
    ksl_product_ainvvf(k, &v, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_ainvv_single)
LOOP(product_ainvv_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_ainvv)

/* (3),(3)->(3) */
OVER(cross_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vv(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(cross_vv_double)
LOOP(cross_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(cross_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvf(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(cross_vv_single)
LOOP(cross_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(cross_vv)

/* (3),(3)->(3) */
OVER(cross_vvinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vvinv(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(cross_vvinv_double)
LOOP(cross_vvinv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(cross_vvinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvinvf(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(cross_vvinv_single)
LOOP(cross_vvinv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(cross_vvinv)

/* (3),()->(3) */
OVER(add_vvx_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvx(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvx_double)
LOOP(add_vvx_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvx_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvx_single)
LOOP(add_vvx_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvx)

/* (3),()->(3) */
OVER(add_vvxinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvxinv(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvxinv_double)
LOOP(add_vvxinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvxinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxinvf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvxinv_single)
LOOP(add_vvxinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvxinv)

/* (3),()->(3) */
OVER(add_vvy_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvy(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvy_double)
LOOP(add_vvy_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvy_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvy_single)
LOOP(add_vvy_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvy)

/* (3),()->(3) */
OVER(add_vvyinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvyinv(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvyinv_double)
LOOP(add_vvyinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvyinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyinvf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvyinv_single)
LOOP(add_vvyinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvyinv)

/* (3),()->(3) */
OVER(add_vvz_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvz(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvz_double)
LOOP(add_vvz_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvz_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvz_single)
LOOP(add_vvz_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvz)

/* (3),()->(3) */
OVER(add_vvzinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvzinv(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvzinv_double)
LOOP(add_vvzinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvzinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzinvf(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvzinv_single)
LOOP(add_vvzinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvzinv)

const coscrew_gufunc TABLE(vec3)[] = {
  {"vec3_copy", "(3)->(3)",
    "vo = vi.\n"
    "\n"
    "(3)->(3).  vi, vo: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", vec3_copy_loops},
  {"vec3_scale", "(3),()->(3)",
    "self = a self.\n"
    "\n"
    "(3),()->(3).  self: vector; a: number.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scale_loops},
  {"vec3_inverted", "(3)->(3)",
    "vo = -vi.\n"
    "\n"
    "(3)->(3).  vi, vo: vector.\n"
    "3 neg.  Exact.\n",
   1, 1, "", vec3_inverted_loops},
  {"vec3_invert", "(3)->(3)",
    "self = -self.\n"
    "\n"
    "(3)->(3).  self: vector.\n"
    "3 neg.  Exact.\n",
   1, 1, "", vec3_invert_loops},
  {"axpy_vv", "(),(3),(3)->(3)",
    "y = a x + y.\n"
    "\n"
    "(),(3),(3)->(3).  a: number; x, y: vector.\n"
    "3 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_vv_loops},
  {"xpy_vv", "(3),(3)->(3)",
    "y = x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_vv_loops},
  {"nxpy_vv", "(3),(3)->(3)",
    "y = -x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_vv_loops},
  {"product_av", "(),(3)->(3)",
    "vo = a vi.\n"
    "\n"
    "(),(3)->(3).  a: number; vi, vo: vector.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_av_loops},
  {"add_vv", "(3),(3)->(3)",
    "vo = v1 + v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vv_loops},
  {"subtract_vv", "(3),(3)->(3)",
    "vo = v1 - v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_vv_loops},
  {"vec3_scaled", "(3),()->(3)",
    "vo = k v.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scaled_loops},
  {"vec3_swap", "(3),(3)->(3),(3)",
    "v1, v2 = v2, v1.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2: vector.\n"
    "No arithmetic.  Exact.\n",
   2, 2, "", vec3_swap_loops},
  {"vec3_l2norm", "(3)->()",
    "|v| = sqrt(v·v).\n"
    "\n"
    "(3)->().  v: vector; norm: number.\n"
    "7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select.\n",
   1, 1, "", vec3_l2norm_loops},
  {"vec3_normalize", "(3)->(3)",
    "self = self / |self|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  self: vector.\n"
    "12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.\n",
   1, 1, "", vec3_normalize_loops},
  {"vec3_normalized", "(3)->(3)",
    "vo = v / |v|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  v, vo: vector.\n"
    "12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.\n",
   1, 1, "", vec3_normalized_loops},
  {"angle_vv", "(3),(3)->()",
    "angle = atan2(|v1 × v2|, v1·v2), in [0, π].\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; angle: number.\n"
    "51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select.\n",
   2, 1, "", angle_vv_loops},
  {"dot_vv", "(3),(3)->()",
    "v1·v2.\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; dot: number.\n"
    "3 mul, 2 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", dot_vv_loops},
  {"product_avinv", "(),(3)->(3)",
    "vo = k (-v).\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_avinv_loops},
  {"product_ainvv", "(),(3)->(3)",
    "vo = v / k.\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 div.\n",
   2, 1, "", product_ainvv_loops},
  {"cross_vv", "(3),(3)->(3)",
    "vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", cross_vv_loops},
  {"cross_vvinv", "(3),(3)->(3)",
    "vo = v1 × (-v2).\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", cross_vvinv_loops},
  {"add_vvx", "(3),()->(3)",
    "vo = v + k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvx_loops},
  {"add_vvxinv", "(3),()->(3)",
    "vo = v - k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvxinv_loops},
  {"add_vvy", "(3),()->(3)",
    "vo = v + k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvy_loops},
  {"add_vvyinv", "(3),()->(3)",
    "vo = v - k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvyinv_loops},
  {"add_vvz", "(3),()->(3)",
    "vo = v + k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvz_loops},
  {"add_vvzinv", "(3),()->(3)",
    "vo = v - k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "1 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
