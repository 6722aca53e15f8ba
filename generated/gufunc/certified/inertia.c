/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/inertia_certified.h"
#include <fenv.h>

/* (),(3),(),(),(),(),(),()->(10),(10) */
OVER(inertia_double) {
  POINTERS_10
  LOAD_FIRST(scalar_double, double m, &m);
  EACH {
    ksl_vec3_t t;
    double Ixx;
    double Iyy;
    double Izz;
    double Ixy;
    double Iyz;
    double Izx;
    ksl_inertia_t J;
    ksl_inertia_t J_bound;
    LOAD_OTHER(scalar_double, &m);
    LOAD(vec3_double, &t, 1, 0);
    LOAD(scalar_double, &Ixx, 2, 1);
    LOAD(scalar_double, &Iyy, 3, 1);
    LOAD(scalar_double, &Izz, 4, 1);
    LOAD(scalar_double, &Ixy, 5, 1);
    LOAD(scalar_double, &Iyz, 6, 1);
    LOAD(scalar_double, &Izx, 7, 1);
    J = ksl_inertia_certified(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx, &J_bound);
    STORE(inertia_double, &J, 8, 1);
    STORE(inertia_double, &J_bound, 9, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_double)
LOOP(inertia_double, 10, DENSE_OR_ONE, 8, 24, 8, 8, 8, 8, 8, 8, 80, 80, 8, 8, 8)

OVER(inertia_single) {
  POINTERS_10
  LOAD_FIRST(scalar_single, float m, &m);
  EACH {
    ksl_vec3f_t t;
    float Ixx;
    float Iyy;
    float Izz;
    float Ixy;
    float Iyz;
    float Izx;
    ksl_inertiaf_t J;
    ksl_inertiaf_t J_bound;
    LOAD_OTHER(scalar_single, &m);
    LOAD(vec3_single, &t, 1, 0);
    LOAD(scalar_single, &Ixx, 2, 1);
    LOAD(scalar_single, &Iyy, 3, 1);
    LOAD(scalar_single, &Izz, 4, 1);
    LOAD(scalar_single, &Ixy, 5, 1);
    LOAD(scalar_single, &Iyz, 6, 1);
    LOAD(scalar_single, &Izx, 7, 1);
    J = ksl_inertiaf_certified(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx, &J_bound);
    STORE(inertia_single, &J, 8, 1);
    STORE(inertia_single, &J_bound, 9, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_single)
LOOP(inertia_single, 10, DENSE_OR_ONE, 4, 12, 4, 4, 4, 4, 4, 4, 40, 40, 4, 4, 4)
LOOPS(inertia)

/* (10),(3,3)->(10),(10) */
OVER(inertia_rotated_double) {
  POINTERS_4
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_mat3x3_t R;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(mat3x3_double, &R, 1, 1);
    ksl_inertia_rotated_certified(&Ji, &R, &Jo, &Jo_bound);
    STORE(inertia_double, &Jo, 2, 3);
    STORE(inertia_double, &Jo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_rotated_double)
LOOP(inertia_rotated_double, 4, DENSE_OR_ONE, 80, 72, 80, 80, 8, 24, 8, 8, 8)

OVER(inertia_rotated_single) {
  POINTERS_4
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_mat3x3f_t R;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(mat3x3_single, &R, 1, 1);
    ksl_inertiaf_rotated_certified(&Ji, &R, &Jo, &Jo_bound);
    STORE(inertia_single, &Jo, 2, 3);
    STORE(inertia_single, &Jo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_rotated_single)
LOOP(inertia_rotated_single, 4, DENSE_OR_ONE, 40, 36, 40, 40, 4, 12, 4, 4, 4)
LOOPS(inertia_rotated)

/* (10),(3,3)->(10),(10) */
OVER(inertia_rotate_double) {
  POINTERS_4
  EACH {
    ksl_inertia_t self;
    ksl_mat3x3_t R;
    ksl_inertia_t self_bound;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(mat3x3_double, &R, 1, 1);
    ksl_inertia_rotate_certified(&self, &R, &self_bound);
    STORE(inertia_double, &self, 2, 3);
    STORE(inertia_double, &self_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_rotate_double)
LOOP(inertia_rotate_double, 4, ANY, 80, 72, 80, 80, 8, 24, 8, 8, 8)

OVER(inertia_rotate_single) {
  POINTERS_4
  EACH {
    ksl_inertiaf_t self;
    ksl_mat3x3f_t R;
    ksl_inertiaf_t self_bound;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(mat3x3_single, &R, 1, 1);
    ksl_inertiaf_rotate_certified(&self, &R, &self_bound);
    STORE(inertia_single, &self, 2, 3);
    STORE(inertia_single, &self_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_rotate_single)
LOOP(inertia_rotate_single, 4, ANY, 40, 36, 40, 40, 4, 12, 4, 4, 4)
LOOPS(inertia_rotate)

/* (10),(3)->(10),(10) */
OVER(inertia_translated_double) {
  POINTERS_4
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_vec3_t t;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(vec3_double, &t, 1, 1);
    ksl_inertia_translated_certified(&Ji, &t, &Jo, &Jo_bound);
    STORE(inertia_double, &Jo, 2, 2);
    STORE(inertia_double, &Jo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_translated_double)
LOOP(inertia_translated_double, 4, DENSE_OR_ONE, 80, 24, 80, 80, 8, 8, 8, 8)

OVER(inertia_translated_single) {
  POINTERS_4
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_vec3f_t t;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(vec3_single, &t, 1, 1);
    ksl_inertiaf_translated_certified(&Ji, &t, &Jo, &Jo_bound);
    STORE(inertia_single, &Jo, 2, 2);
    STORE(inertia_single, &Jo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_translated_single)
LOOP(inertia_translated_single, 4, DENSE_OR_ONE, 40, 12, 40, 40, 4, 4, 4, 4)
LOOPS(inertia_translated)

/* (10),(3)->(10),(10) */
OVER(inertia_translate_double) {
  POINTERS_4
  EACH {
    ksl_inertia_t self;
    ksl_vec3_t t;
    ksl_inertia_t self_bound;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(vec3_double, &t, 1, 1);
    ksl_inertia_translate_certified(&self, &t, &self_bound);
    STORE(inertia_double, &self, 2, 2);
    STORE(inertia_double, &self_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_translate_double)
LOOP(inertia_translate_double, 4, DENSE, 80, 24, 80, 80, 8, 8, 8, 8)

OVER(inertia_translate_single) {
  POINTERS_4
  EACH {
    ksl_inertiaf_t self;
    ksl_vec3f_t t;
    ksl_inertiaf_t self_bound;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(vec3_single, &t, 1, 1);
    ksl_inertiaf_translate_certified(&self, &t, &self_bound);
    STORE(inertia_single, &self, 2, 2);
    STORE(inertia_single, &self_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_translate_single)
LOOP(inertia_translate_single, 4, DENSE, 40, 12, 40, 40, 4, 4, 4, 4)
LOOPS(inertia_translate)

/* (10),(3,4)->(10),(10) */
OVER(inertia_transformed_double) {
  POINTERS_4
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_SE3_t D;
    ksl_inertia_t Jo;
    ksl_inertia_t Jo_bound;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(SE3_double, &D, 1, 1);
    ksl_inertia_transformed_certified(&Ji, &D, &Jo, &Jo_bound);
    STORE(inertia_double, &Jo, 2, 3);
    STORE(inertia_double, &Jo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_transformed_double)
LOOP(inertia_transformed_double, 4, DENSE_OR_ONE, 80, 96, 80, 80, 8, 32, 8, 8, 8)

OVER(inertia_transformed_single) {
  POINTERS_4
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_SE3f_t D;
    ksl_inertiaf_t Jo;
    ksl_inertiaf_t Jo_bound;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(SE3_single, &D, 1, 1);
    ksl_inertiaf_transformed_certified(&Ji, &D, &Jo, &Jo_bound);
    STORE(inertia_single, &Jo, 2, 3);
    STORE(inertia_single, &Jo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_transformed_single)
LOOP(inertia_transformed_single, 4, DENSE_OR_ONE, 40, 48, 40, 40, 4, 16, 4, 4, 4)
LOOPS(inertia_transformed)

/* (10),(3,4)->(10),(10) */
OVER(inertia_transform_double) {
  POINTERS_4
  EACH {
    ksl_inertia_t self;
    ksl_SE3_t D;
    ksl_inertia_t self_bound;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(SE3_double, &D, 1, 1);
    ksl_inertia_transform_certified(&self, &D, &self_bound);
    STORE(inertia_double, &self, 2, 3);
    STORE(inertia_double, &self_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_transform_double)
LOOP(inertia_transform_double, 4, ANY, 80, 96, 80, 80, 8, 32, 8, 8, 8)

OVER(inertia_transform_single) {
  POINTERS_4
  EACH {
    ksl_inertiaf_t self;
    ksl_SE3f_t D;
    ksl_inertiaf_t self_bound;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(SE3_single, &D, 1, 1);
    ksl_inertiaf_transform_certified(&self, &D, &self_bound);
    STORE(inertia_single, &self, 2, 3);
    STORE(inertia_single, &self_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(inertia_transform_single)
LOOP(inertia_transform_single, 4, ANY, 40, 48, 40, 40, 4, 16, 4, 4, 4)
LOOPS(inertia_transform)

const coscrew_gufunc TABLE(inertia)[] = {
  {"inertia", "(),(3),(),(),(),(),(),()->(10),(10)",
    "J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the\n"
    "moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(),(3),(),(),(),(),(),()->(10),(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J,\n"
    "J_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,\n"
    "yz, zx in kg m^2).\n"
    "6 mul, 3 add, 3 abs.\n",
   8, 2, "", inertia_loops},
  {"inertia_rotated", "(10),(3,3)->(10),(10)",
    "Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.\n"
    "\n"
    "(10),(3,3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "81 mul, 90 add, 45 abs.\n",
   2, 2, ".R", inertia_rotated_loops},
  {"inertia_rotate", "(10),(3,3)->(10),(10)",
    "self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(10),(3,3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "81 mul, 90 add, 45 abs.\n",
   2, 2, ".R", inertia_rotate_loops},
  {"inertia_translated", "(10),(3)->(10),(10)",
    "Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.\n"
    "\n"
    "(10),(3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "", inertia_translated_loops},
  {"inertia_translate", "(10),(3)->(10),(10)",
    "self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(10),(3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "", inertia_translate_loops},
  {"inertia_transformed", "(10),(3,4)->(10),(10)",
    "Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(10),(3,4)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t\n"
    "in m.\n"
    "84 mul, 96 add, 48 abs.\n",
   2, 2, ".R", inertia_transformed_loops},
  {"inertia_transform", "(10),(3,4)->(10),(10)",
    "self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(10),(3,4)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t\n"
    "in m.\n"
    "84 mul, 96 add, 48 abs.\n",
   2, 2, ".R", inertia_transform_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
