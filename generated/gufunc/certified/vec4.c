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
#include "../../c/include/ksl/vec4_certified.h"
#include <fenv.h>

/* (4),()->(4),(4) */
OVER(vec4_scale_double) {
  POINTERS_4
  EACH {
    ksl_vec4_t self;
    double a;
    ksl_vec4_t self_bound;
    LOAD(vec4_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_vec4_scale_certified(&self, a, &self_bound);
    STORE(vec4_double, &self, 2, 1);
    STORE(vec4_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec4_scale_double)
LOOP(vec4_scale_double, 4, DENSE, 32, 8, 32, 32, 8, 8, 8)

OVER(vec4_scale_single) {
  POINTERS_4
  EACH {
    ksl_vec4f_t self;
    float a;
    ksl_vec4f_t self_bound;
    LOAD(vec4_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_vec4f_scale_certified(&self, a, &self_bound);
    STORE(vec4_single, &self, 2, 1);
    STORE(vec4_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec4_scale_single)
LOOP(vec4_scale_single, 4, DENSE, 16, 4, 16, 16, 4, 4, 4)
LOOPS(vec4_scale)

/* (4),()->(4),(4) */
OVER(vec4_scaled_double) {
  POINTERS_4
  LOAD_FIRST(vec4_double, ksl_vec4_t v, &v);
  EACH {
    double k;
    ksl_vec4_t vo;
    ksl_vec4_t vo_bound;
    LOAD_OTHER(vec4_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_vec4_scaled_certified(&v, k, &vo, &vo_bound);
    STORE(vec4_double, &vo, 2, 1);
    STORE(vec4_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec4_scaled_double)
LOOP(vec4_scaled_double, 4, DENSE_OR_ONE, 32, 8, 32, 32, 8, 8, 8)

OVER(vec4_scaled_single) {
  POINTERS_4
  LOAD_FIRST(vec4_single, ksl_vec4f_t v, &v);
  EACH {
    float k;
    ksl_vec4f_t vo;
    ksl_vec4f_t vo_bound;
    LOAD_OTHER(vec4_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_vec4f_scaled_certified(&v, k, &vo, &vo_bound);
    STORE(vec4_single, &vo, 2, 1);
    STORE(vec4_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec4_scaled_single)
LOOP(vec4_scaled_single, 4, DENSE_OR_ONE, 16, 4, 16, 16, 4, 4, 4)
LOOPS(vec4_scaled)

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
