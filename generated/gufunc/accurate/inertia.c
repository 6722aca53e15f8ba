/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/inertia_accurate.h"

/* (),(3),(),(),(),(),(),()->(10) */
OVER(inertia_double) {
  POINTERS_9
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
    LOAD_OTHER(scalar_double, &m);
    LOAD(vec3_double, &t, 1, 0);
    LOAD(scalar_double, &Ixx, 2, 1);
    LOAD(scalar_double, &Iyy, 3, 1);
    LOAD(scalar_double, &Izz, 4, 1);
    LOAD(scalar_double, &Ixy, 5, 1);
    LOAD(scalar_double, &Iyz, 6, 1);
    LOAD(scalar_double, &Izx, 7, 1);
    J = ksl_inertia_accurate(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx);
    STORE(inertia_double, &J, 8, 1);
  }
}
STRIDED_WITH_FMA(inertia_double)
LOOP(inertia_double, 9, DENSE_OR_ONE, 8, 24, 8, 8, 8, 8, 8, 8, 80, 8, 8)

OVER(inertia_single) {
  POINTERS_9
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
    LOAD_OTHER(scalar_single, &m);
    LOAD(vec3_single, &t, 1, 0);
    LOAD(scalar_single, &Ixx, 2, 1);
    LOAD(scalar_single, &Iyy, 3, 1);
    LOAD(scalar_single, &Izz, 4, 1);
    LOAD(scalar_single, &Ixy, 5, 1);
    LOAD(scalar_single, &Iyz, 6, 1);
    LOAD(scalar_single, &Izx, 7, 1);
    J = ksl_inertiaf_accurate(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx);
    STORE(inertia_single, &J, 8, 1);
  }
}
STRIDED(inertia_single)
LOOP(inertia_single, 9, DENSE_OR_ONE, 4, 12, 4, 4, 4, 4, 4, 4, 40, 4, 4)
LOOPS(inertia)

/* (10),(3,3)->(10) */
OVER(inertia_rotated_double) {
  POINTERS_3
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_mat3x3_t R;
    ksl_inertia_t Jo;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(mat3x3_double, &R, 1, 1);
    ksl_inertia_rotated_accurate(&Ji, &R, &Jo);
    STORE(inertia_double, &Jo, 2, 3);
  }
}
STRIDED_WITH_FMA(inertia_rotated_double)
LOOP(inertia_rotated_double, 3, DENSE_OR_ONE, 80, 72, 80, 8, 24, 8, 8)

OVER(inertia_rotated_single) {
  POINTERS_3
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_mat3x3f_t R;
    ksl_inertiaf_t Jo;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(mat3x3_single, &R, 1, 1);
    ksl_inertiaf_rotated_accurate(&Ji, &R, &Jo);
    STORE(inertia_single, &Jo, 2, 3);
  }
}
STRIDED(inertia_rotated_single)
LOOP(inertia_rotated_single, 3, DENSE_OR_ONE, 40, 36, 40, 4, 12, 4, 4)
LOOPS(inertia_rotated)

/* (10),(3,3)->(10) */
OVER(inertia_rotate_double) {
  POINTERS_3
  EACH {
    ksl_inertia_t self;
    ksl_mat3x3_t R;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(mat3x3_double, &R, 1, 1);
    ksl_inertia_rotate_accurate(&self, &R);
    STORE(inertia_double, &self, 2, 3);
  }
}
STRIDED_WITH_FMA(inertia_rotate_double)
LOOP(inertia_rotate_double, 3, ANY, 80, 72, 80, 8, 24, 8, 8)

OVER(inertia_rotate_single) {
  POINTERS_3
  EACH {
    ksl_inertiaf_t self;
    ksl_mat3x3f_t R;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(mat3x3_single, &R, 1, 1);
    ksl_inertiaf_rotate_accurate(&self, &R);
    STORE(inertia_single, &self, 2, 3);
  }
}
STRIDED(inertia_rotate_single)
LOOP(inertia_rotate_single, 3, DENSE, 40, 36, 40, 4, 12, 4, 4)
LOOPS(inertia_rotate)

/* (10),(3)->(10) */
OVER(inertia_translated_double) {
  POINTERS_3
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_vec3_t t;
    ksl_inertia_t Jo;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(vec3_double, &t, 1, 1);
    ksl_inertia_translated_accurate(&Ji, &t, &Jo);
    STORE(inertia_double, &Jo, 2, 2);
  }
}
STRIDED_WITH_FMA(inertia_translated_double)
LOOP(inertia_translated_double, 3, DENSE_OR_ONE, 80, 24, 80, 8, 8, 8)

OVER(inertia_translated_single) {
  POINTERS_3
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_vec3f_t t;
    ksl_inertiaf_t Jo;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(vec3_single, &t, 1, 1);
    ksl_inertiaf_translated_accurate(&Ji, &t, &Jo);
    STORE(inertia_single, &Jo, 2, 2);
  }
}
STRIDED(inertia_translated_single)
LOOP(inertia_translated_single, 3, DENSE_OR_ONE, 40, 12, 40, 4, 4, 4)
LOOPS(inertia_translated)

/* (10),(3)->(10) */
OVER(inertia_translate_double) {
  POINTERS_3
  EACH {
    ksl_inertia_t self;
    ksl_vec3_t t;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(vec3_double, &t, 1, 1);
    ksl_inertia_translate_accurate(&self, &t);
    STORE(inertia_double, &self, 2, 2);
  }
}
STRIDED_WITH_FMA(inertia_translate_double)
LOOP(inertia_translate_double, 3, DENSE, 80, 24, 80, 8, 8, 8)

OVER(inertia_translate_single) {
  POINTERS_3
  EACH {
    ksl_inertiaf_t self;
    ksl_vec3f_t t;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(vec3_single, &t, 1, 1);
    ksl_inertiaf_translate_accurate(&self, &t);
    STORE(inertia_single, &self, 2, 2);
  }
}
STRIDED(inertia_translate_single)
LOOP(inertia_translate_single, 3, DENSE, 40, 12, 40, 4, 4, 4)
LOOPS(inertia_translate)

/* (10),(3,4)->(10) */
OVER(inertia_transformed_double) {
  POINTERS_3
  LOAD_FIRST(inertia_double, ksl_inertia_t Ji, &Ji);
  EACH {
    ksl_SE3_t D;
    ksl_inertia_t Jo;
    LOAD_OTHER(inertia_double, &Ji);
    LOAD(SE3_double, &D, 1, 1);
    ksl_inertia_transformed_accurate(&Ji, &D, &Jo);
    STORE(inertia_double, &Jo, 2, 3);
  }
}
STRIDED_WITH_FMA(inertia_transformed_double)
LOOP(inertia_transformed_double, 3, DENSE_OR_ONE, 80, 96, 80, 8, 32, 8, 8)

OVER(inertia_transformed_single) {
  POINTERS_3
  LOAD_FIRST(inertia_single, ksl_inertiaf_t Ji, &Ji);
  EACH {
    ksl_SE3f_t D;
    ksl_inertiaf_t Jo;
    LOAD_OTHER(inertia_single, &Ji);
    LOAD(SE3_single, &D, 1, 1);
    ksl_inertiaf_transformed_accurate(&Ji, &D, &Jo);
    STORE(inertia_single, &Jo, 2, 3);
  }
}
STRIDED(inertia_transformed_single)
LOOP(inertia_transformed_single, 3, DENSE_OR_ONE, 40, 48, 40, 4, 16, 4, 4)
LOOPS(inertia_transformed)

/* (10),(3,4)->(10) */
OVER(inertia_transform_double) {
  POINTERS_3
  EACH {
    ksl_inertia_t self;
    ksl_SE3_t D;
    LOAD(inertia_double, &self, 0, 0);
    LOAD(SE3_double, &D, 1, 1);
    ksl_inertia_transform_accurate(&self, &D);
    STORE(inertia_double, &self, 2, 3);
  }
}
STRIDED_WITH_FMA(inertia_transform_double)
LOOP(inertia_transform_double, 3, ANY, 80, 96, 80, 8, 32, 8, 8)

OVER(inertia_transform_single) {
  POINTERS_3
  EACH {
    ksl_inertiaf_t self;
    ksl_SE3f_t D;
    LOAD(inertia_single, &self, 0, 0);
    LOAD(SE3_single, &D, 1, 1);
    ksl_inertiaf_transform_accurate(&self, &D);
    STORE(inertia_single, &self, 2, 3);
  }
}
STRIDED(inertia_transform_single)
LOOP(inertia_transform_single, 3, DENSE, 40, 48, 40, 4, 16, 4, 4)
LOOPS(inertia_transform)

/* (10),(3),(10),(3),(3,4)->(10) */
OVER(inertia_merge_double) {
  POINTERS_6
  EACH {
    ksl_inertia_t Ji;
    ksl_vec3_t t_ic;
    ksl_inertia_t Jj;
    ksl_vec3_t t_jc;
    ksl_SE3_t D_ij;
    LOAD(inertia_double, &Ji, 0, 0);
    LOAD(vec3_double, &t_ic, 1, 1);
    LOAD(inertia_double, &Jj, 2, 2);
    LOAD(vec3_double, &t_jc, 3, 3);
    LOAD(SE3_double, &D_ij, 4, 4);
    ksl_inertia_merge_accurate(&Ji, &t_ic, &Jj, &t_jc, &D_ij);
    STORE(inertia_double, &Ji, 5, 6);
  }
}
STRIDED_WITH_FMA(inertia_merge_double)
LOOP(inertia_merge_double, 6, ANY, 80, 24, 80, 24, 96, 80, 8, 8, 8, 8, 32, 8, 8)

OVER(inertia_merge_single) {
  POINTERS_6
  EACH {
    ksl_inertiaf_t Ji;
    ksl_vec3f_t t_ic;
    ksl_inertiaf_t Jj;
    ksl_vec3f_t t_jc;
    ksl_SE3f_t D_ij;
    LOAD(inertia_single, &Ji, 0, 0);
    LOAD(vec3_single, &t_ic, 1, 1);
    LOAD(inertia_single, &Jj, 2, 2);
    LOAD(vec3_single, &t_jc, 3, 3);
    LOAD(SE3_single, &D_ij, 4, 4);
    ksl_inertiaf_merge_accurate(&Ji, &t_ic, &Jj, &t_jc, &D_ij);
    STORE(inertia_single, &Ji, 5, 6);
  }
}
STRIDED(inertia_merge_single)
LOOP(inertia_merge_single, 6, DENSE, 40, 12, 40, 12, 48, 40, 4, 4, 4, 4, 16, 4, 4)
LOOPS(inertia_merge)

const coscrew_gufunc TABLE(inertia)[] = {
  {"inertia", "(),(3),(),(),(),(),(),()->(10)",
    "J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the\n"
    "moments' matrix about it in kg m^2, Ixy = -∫ x y dm.\n"
    "\n"
    "(),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:\n"
    "inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in\n"
    "kg m^2).\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   8, 1, "", inertia_loops},
  {"inertia_rotated", "(10),(3,3)->(10)",
    "Jo = Ji rotated by R: m, R mt, R I R^T.\n"
    "\n"
    "(10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_rotated_loops},
  {"inertia_rotate", "(10),(3,3)->(10)",
    "self = self rotated by R: m, R mt, R I R^T.\n"
    "\n"
    "(10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.\n"
    "72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_rotate_loops},
  {"inertia_translated", "(10),(3)->(10)",
    "Jo = Ji translated by t: m, mt + m t, I.\n"
    "\n"
    "(10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", inertia_translated_loops},
  {"inertia_translate", "(10),(3)->(10)",
    "self = self translated by t: m, mt + m t, I.\n"
    "\n"
    "(10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,\n"
    "yy, zz, xy, yz, zx in kg m^2); t: vector.\n"
    "3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", inertia_translate_loops},
  {"inertia_transformed", "(10),(3,4)->(10)",
    "Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.\n"
    "\n"
    "(10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.\n"
    "75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_transformed_loops},
  {"inertia_transform", "(10),(3,4)->(10)",
    "self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.\n"
    "\n"
    "(10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.\n"
    "75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, ".R", inertia_transform_loops},
  {"inertia_merge", "(10),(3),(10),(3),(3,4)->(10)",
    "Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,\n"
    "mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =\n"
    "c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own\n"
    "frame; NaN where m_i + m_j = 0.\n"
    "\n"
    "(10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the\n"
    "centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement\n"
    "[R | t], R rotation, t in m.\n"
    "109 mul, 401 add, 5 product error, 66 product rest, 2 div, 10 equal, 10 select.  Error <= 18\n"
    "u times the sum of the absolute values of all terms, for masses that are not negative,\n"
    "barring over- and underflow.\n",
   5, 1, "....R", inertia_merge_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
