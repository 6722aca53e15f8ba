/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat4x4 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/mat4x4.h"

/* (3,4)->(4,4) */
OVER(mat4x4_fromSE3_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat4x4_t M;
    LOAD(SE3_double, &D, 0, 0);
    M = ksl_mat4x4_fromSE3(D);
    STORE(mat4x4_double, &M, 1, 2);
  }
}
STRIDED(mat4x4_fromSE3_double)
LOOP(mat4x4_fromSE3_double, 2, DENSE, 96, 128, 32, 8, 32, 8)

OVER(mat4x4_fromSE3_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat4x4f_t M;
    LOAD(SE3_single, &D, 0, 0);
    M = ksl_mat4x4f_fromSE3f(D);
    STORE(mat4x4_single, &M, 1, 2);
  }
}
STRIDED(mat4x4_fromSE3_single)
LOOP(mat4x4_fromSE3_single, 2, DENSE, 48, 64, 16, 4, 16, 4)
LOOPS(mat4x4_fromSE3)

/* (3,3),(3)->(4,4) */
OVER(mat4x4_fromRt_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t t;
    ksl_mat4x4_t M;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &t, 1, 2);
    M = ksl_mat4x4_fromRt(R, t);
    STORE(mat4x4_double, &M, 2, 3);
  }
}
STRIDED(mat4x4_fromRt_double)
LOOP(mat4x4_fromRt_double, 3, DENSE_OR_ONE, 72, 24, 128, 24, 8, 8, 32, 8)

OVER(mat4x4_fromRt_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t t;
    ksl_mat4x4f_t M;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &t, 1, 2);
    M = ksl_mat4x4f_fromRt(R, t);
    STORE(mat4x4_single, &M, 2, 3);
  }
}
STRIDED(mat4x4_fromRt_single)
LOOP(mat4x4_fromRt_single, 3, DENSE_OR_ONE, 36, 12, 64, 12, 4, 4, 16, 4)
LOOPS(mat4x4_fromRt)

/* (4,4)->(3,4) */
OVER(mat4x4_toSE3_double) {
  POINTERS_2
  EACH {
    ksl_mat4x4_t M;
    ksl_SE3_t D;
    LOAD(mat4x4_double, &M, 0, 0);
    ksl_mat4x4_toSE3(&M, &D);
    STORE(SE3_double, &D, 1, 2);
  }
}
STRIDED(mat4x4_toSE3_double)
LOOP(mat4x4_toSE3_double, 2, DENSE, 128, 96, 32, 8, 32, 8)

OVER(mat4x4_toSE3_single) {
  POINTERS_2
  EACH {
    ksl_mat4x4f_t M;
    ksl_SE3f_t D;
    LOAD(mat4x4_single, &M, 0, 0);
    ksl_mat4x4f_toSE3f(&M, &D);
    STORE(SE3_single, &D, 1, 2);
  }
}
STRIDED(mat4x4_toSE3_single)
LOOP(mat4x4_toSE3_single, 2, DENSE, 64, 48, 16, 4, 16, 4)
LOOPS(mat4x4_toSE3)

/* (4,4)->(4,4) */
OVER(mat4x4_setIdentity_double) {
  POINTERS_2
  EACH {
    ksl_mat4x4_t self;
    LOAD(mat4x4_double, &self, 0, 0);
    ksl_mat4x4_setIdentity(&self);
    STORE(mat4x4_double, &self, 1, 2);
  }
}
STRIDED(mat4x4_setIdentity_double)
LOOP(mat4x4_setIdentity_double, 2, DENSE, 128, 128, 32, 8, 32, 8)

OVER(mat4x4_setIdentity_single) {
  POINTERS_2
  EACH {
    ksl_mat4x4f_t self;
    LOAD(mat4x4_single, &self, 0, 0);
    ksl_mat4x4f_setIdentity(&self);
    STORE(mat4x4_single, &self, 1, 2);
  }
}
STRIDED(mat4x4_setIdentity_single)
LOOP(mat4x4_setIdentity_single, 2, DENSE, 64, 64, 16, 4, 16, 4)
LOOPS(mat4x4_setIdentity)

/* (4,4)->(3) */
OVER(mat4x4_getTranslation_double) {
  POINTERS_2
  EACH {
    ksl_mat4x4_t M;
    ksl_vec3_t t;
    LOAD(mat4x4_double, &M, 0, 0);
    ksl_mat4x4_getTranslation(&M, &t);
    STORE(vec3_double, &t, 1, 2);
  }
}
STRIDED(mat4x4_getTranslation_double)
LOOP(mat4x4_getTranslation_double, 2, DENSE, 128, 24, 32, 8, 8)

OVER(mat4x4_getTranslation_single) {
  POINTERS_2
  EACH {
    ksl_mat4x4f_t M;
    ksl_vec3f_t t;
    LOAD(mat4x4_single, &M, 0, 0);
    ksl_mat4x4f_getTranslation(&M, &t);
    STORE(vec3_single, &t, 1, 2);
  }
}
STRIDED(mat4x4_getTranslation_single)
LOOP(mat4x4_getTranslation_single, 2, DENSE, 64, 12, 16, 4, 4)
LOOPS(mat4x4_getTranslation)

const coscrew_gufunc TABLE(mat4x4)[] = {
  {"mat4x4_fromSE3", "(3,4)->(4,4)",
    "M = [[R, t], [0, 1]] of D = [R | t].\n"
    "\n"
    "(3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_fromSE3_loops},
  {"mat4x4_fromRt", "(3,3),(3)->(4,4)",
    "M = [[R, t], [0, 1]].\n"
    "\n"
    "(3,3),(3)->(4,4).  R: rotation or other 3×3 matrix; t: vector; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   2, 1, "R.", mat4x4_fromRt_loops},
  {"mat4x4_toSE3", "(4,4)->(3,4)",
    "D = [R | t], the first three rows of M.\n"
    "\n"
    "(4,4)->(3,4).  M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_toSE3_loops},
  {"mat4x4_setIdentity", "(4,4)->(4,4)",
    "self = I.\n"
    "\n"
    "(4,4)->(4,4).  self: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_setIdentity_loops},
  {"mat4x4_getTranslation", "(4,4)->(3)",
    "t, the first three entries of the last column of M.\n"
    "\n"
    "(4,4)->(3).  M: 4×4 matrix; t: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", mat4x4_getTranslation_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
