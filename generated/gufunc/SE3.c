/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the SE3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/SE3.h"

/* (3,3),(3)->(3,4) */
OVER(SE3_fromRt_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t D;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &t, 1, 2);
    D = ksl_SE3_fromRt(R, t);
    STORE(SE3_double, &D, 2, 3);
  }
}
STRIDED(SE3_fromRt_double)
LOOP(SE3_fromRt_double, 3, DENSE_OR_ONE, 72, 24, 96, 24, 8, 8, 32, 8)

OVER(SE3_fromRt_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t D;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &t, 1, 2);
    D = ksl_SE3f_fromRt(R, t);
    STORE(SE3_single, &D, 2, 3);
  }
}
STRIDED(SE3_fromRt_single)
LOOP(SE3_fromRt_single, 3, DENSE_OR_ONE, 36, 12, 48, 12, 4, 4, 16, 4)
LOOPS(SE3_fromRt)

/* (3,4)->(3,4) */
OVER(SE3_copy_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_SE3_t Do;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_copy(&D, &Do);
    STORE(SE3_double, &Do, 1, 2);
  }
}
STRIDED(SE3_copy_double)
LOOP(SE3_copy_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_copy_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_SE3f_t Do;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_copy(&D, &Do);
    STORE(SE3_single, &Do, 1, 2);
  }
}
STRIDED(SE3_copy_single)
LOOP(SE3_copy_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_copy)

/* (3,4)->(3,4) */
OVER(SE3_setIdentity_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t self;
    LOAD(SE3_double, &self, 0, 0);
    ksl_SE3_setIdentity(&self);
    STORE(SE3_double, &self, 1, 2);
  }
}
STRIDED(SE3_setIdentity_double)
LOOP(SE3_setIdentity_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_setIdentity_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t self;
    LOAD(SE3_single, &self, 0, 0);
    ksl_SE3f_setIdentity(&self);
    STORE(SE3_single, &self, 1, 2);
  }
}
STRIDED(SE3_setIdentity_single)
LOOP(SE3_setIdentity_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_setIdentity)

/* (3,4)->(3) */
OVER(SE3_getTranslation_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_vec3_t t;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_getTranslation(&D, &t);
    STORE(vec3_double, &t, 1, 2);
  }
}
STRIDED(SE3_getTranslation_double)
LOOP(SE3_getTranslation_double, 2, DENSE, 96, 24, 32, 8, 8)

OVER(SE3_getTranslation_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_vec3f_t t;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_getTranslation(&D, &t);
    STORE(vec3_single, &t, 1, 2);
  }
}
STRIDED(SE3_getTranslation_single)
LOOP(SE3_getTranslation_single, 2, DENSE, 48, 12, 16, 4, 4)
LOOPS(SE3_getTranslation)

/* (3,4)->(3,3) */
OVER(SE3_getRotation_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat3x3_t R;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_getRotation(&D, &R);
    STORE(mat3x3_double, &R, 1, 2);
  }
}
STRIDED(SE3_getRotation_double)
LOOP(SE3_getRotation_double, 2, DENSE, 96, 72, 32, 8, 24, 8)

OVER(SE3_getRotation_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat3x3f_t R;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_getRotation(&D, &R);
    STORE(mat3x3_single, &R, 1, 2);
  }
}
STRIDED(SE3_getRotation_single)
LOOP(SE3_getRotation_single, 2, DENSE, 48, 36, 16, 4, 12, 4)
LOOPS(SE3_getRotation)

/* (3,4)->(3,4) */
OVER(SE3_invert_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t self;
    LOAD(SE3_double, &self, 0, 0);
    ksl_SE3_invert(&self);
    STORE(SE3_double, &self, 1, 2);
  }
}
STRIDED(SE3_invert_double)
LOOP(SE3_invert_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_invert_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t self;
    LOAD(SE3_single, &self, 0, 0);
    ksl_SE3f_invert(&self);
    STORE(SE3_single, &self, 1, 2);
  }
}
STRIDED(SE3_invert_single)
LOOP(SE3_invert_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_invert)

/* (3,4)->(4,4) */
OVER(SE3_toMat4x4_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat4x4_t M;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_toMat4x4(&D, &M);
    STORE(mat4x4_double, &M, 1, 2);
  }
}
STRIDED(SE3_toMat4x4_double)
LOOP(SE3_toMat4x4_double, 2, DENSE, 96, 128, 32, 8, 32, 8)

OVER(SE3_toMat4x4_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat4x4f_t M;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_toMat4x4f(&D, &M);
    STORE(mat4x4_single, &M, 1, 2);
  }
}
STRIDED(SE3_toMat4x4_single)
LOOP(SE3_toMat4x4_single, 2, DENSE, 48, 64, 16, 4, 16, 4)
LOOPS(SE3_toMat4x4)

/* (3,4)->(3,4) */
OVER(SE3_inverted_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_SE3_t Do;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_inverted(&D, &Do);
    STORE(SE3_double, &Do, 1, 2);
  }
}
STRIDED(SE3_inverted_double)
LOOP(SE3_inverted_double, 2, DENSE, 96, 96, 32, 8, 32, 8)

OVER(SE3_inverted_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_SE3f_t Do;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_inverted(&D, &Do);
    STORE(SE3_single, &Do, 1, 2);
  }
}
STRIDED(SE3_inverted_single)
LOOP(SE3_inverted_single, 2, DENSE, 48, 48, 16, 4, 16, 4)
LOOPS(SE3_inverted)

const coscrew_gufunc TABLE(SE3)[] = {
  {"SE3_fromRt", "(3,3),(3)->(3,4)",
    "D = [R | t].\n"
    "\n"
    "(3,3),(3)->(3,4).  R: rotation or other 3×3 matrix; t: vector; D: displacement [R | t], R\n"
    "rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   2, 1, "R.", SE3_fromRt_loops},
  {"SE3_copy", "(3,4)->(3,4)",
    "Do = D.\n"
    "\n"
    "(3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_copy_loops},
  {"SE3_setIdentity", "(3,4)->(3,4)",
    "self = [I | 0].\n"
    "\n"
    "(3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_setIdentity_loops},
  {"SE3_getTranslation", "(3,4)->(3)",
    "t of D = [R | t].\n"
    "\n"
    "(3,4)->(3).  D: displacement [R | t], R rotation, t in m; t: vector.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_getTranslation_loops},
  {"SE3_getRotation", "(3,4)->(3,3)",
    "R of D = [R | t].\n"
    "\n"
    "(3,4)->(3,3).  D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_getRotation_loops},
  {"SE3_invert", "(3,4)->(3,4)",
    "self = self^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_invert_loops},
  {"SE3_toMat4x4", "(3,4)->(4,4)",
    "M = [[R, t], [0, 1]] of D = [R | t].\n"
    "\n"
    "(3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", SE3_toMat4x4_loops},
  {"SE3_inverted", "(3,4)->(3,4)",
    "Do = D^-1 = [R^T | -R^T t].\n"
    "\n"
    "(3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", SE3_inverted_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
