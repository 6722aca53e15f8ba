/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the spatial_inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/spatial_inertia_certified.h"
#include <fenv.h>

/* (10),()->(10),(10) */
OVER(spatial_inertia_scale_double) {
  POINTERS_4
  EACH {
    ksl_spatial_inertia_t self;
    double a;
    ksl_spatial_inertia_t self_bound;
    LOAD(spatial_inertia_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_spatial_inertia_scale_certified(&self, a, &self_bound);
    STORE(spatial_inertia_double, &self, 2, 1);
    STORE(spatial_inertia_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_scale_double)
LOOP(spatial_inertia_scale_double, 4, DENSE, 80, 8, 80, 80, 8, 8, 8)

OVER(spatial_inertia_scale_single) {
  POINTERS_4
  EACH {
    ksl_spatial_inertiaf_t self;
    float a;
    ksl_spatial_inertiaf_t self_bound;
    LOAD(spatial_inertia_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_spatial_inertiaf_scale_certified(&self, a, &self_bound);
    STORE(spatial_inertia_single, &self, 2, 1);
    STORE(spatial_inertia_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_scale_single)
LOOP(spatial_inertia_scale_single, 4, DENSE, 40, 4, 40, 40, 4, 4, 4)
LOOPS(spatial_inertia_scale)

/* (10),(10)->(10),(10) */
OVER(add_BB_double) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B1, &B1);
  EACH {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    LOAD_OTHER(spatial_inertia_double, &B1);
    LOAD(spatial_inertia_double, &B2, 1, 1);
    ksl_add_BB_certified(&B1, &B2, &Bo, &Bo_bound);
    STORE(spatial_inertia_double, &Bo, 2, 2);
    STORE(spatial_inertia_double, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_BB_double)
LOOP(add_BB_double, 4, DENSE_OR_ONE, 80, 80, 80, 80, 8, 8, 8, 8)

OVER(add_BB_single) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B1, &B1);
  EACH {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    LOAD_OTHER(spatial_inertia_single, &B1);
    LOAD(spatial_inertia_single, &B2, 1, 1);
    ksl_add_BBf_certified(&B1, &B2, &Bo, &Bo_bound);
    STORE(spatial_inertia_single, &Bo, 2, 2);
    STORE(spatial_inertia_single, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_BB_single)
LOOP(add_BB_single, 4, DENSE_OR_ONE, 40, 40, 40, 40, 4, 4, 4, 4)
LOOPS(add_BB)

/* (10),(10)->(10),(10) */
OVER(subtract_BB_double) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B1, &B1);
  EACH {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    LOAD_OTHER(spatial_inertia_double, &B1);
    LOAD(spatial_inertia_double, &B2, 1, 1);
    ksl_subtract_BB_certified(&B1, &B2, &Bo, &Bo_bound);
    STORE(spatial_inertia_double, &Bo, 2, 2);
    STORE(spatial_inertia_double, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_BB_double)
LOOP(subtract_BB_double, 4, DENSE_OR_ONE, 80, 80, 80, 80, 8, 8, 8, 8)

OVER(subtract_BB_single) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B1, &B1);
  EACH {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    LOAD_OTHER(spatial_inertia_single, &B1);
    LOAD(spatial_inertia_single, &B2, 1, 1);
    ksl_subtract_BBf_certified(&B1, &B2, &Bo, &Bo_bound);
    STORE(spatial_inertia_single, &Bo, 2, 2);
    STORE(spatial_inertia_single, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_BB_single)
LOOP(subtract_BB_single, 4, DENSE_OR_ONE, 40, 40, 40, 40, 4, 4, 4, 4)
LOOPS(subtract_BB)

/* (),(3),(3,3)->(10),(10) */
OVER(spatial_inertia_from_com_double) {
  POINTERS_5
  LOAD_FIRST(scalar_double, double m, &m);
  EACH {
    ksl_vec3_t com;
    ksl_mat3x3_t Ic;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    LOAD_OTHER(scalar_double, &m);
    LOAD(vec3_double, &com, 1, 0);
    LOAD(mat3x3_double, &Ic, 2, 1);
    ksl_spatial_inertia_from_com_certified(m, &com, &Ic, &Bo, &Bo_bound);
    STORE(spatial_inertia_double, &Bo, 3, 3);
    STORE(spatial_inertia_double, &Bo_bound, 4, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_from_com_double)
LOOP(spatial_inertia_from_com_double, 5, DENSE_OR_ONE, 8, 24, 72, 80, 80, 8, 24, 8, 8, 8)

OVER(spatial_inertia_from_com_single) {
  POINTERS_5
  LOAD_FIRST(scalar_single, float m, &m);
  EACH {
    ksl_vec3f_t com;
    ksl_mat3x3f_t Ic;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    LOAD_OTHER(scalar_single, &m);
    LOAD(vec3_single, &com, 1, 0);
    LOAD(mat3x3_single, &Ic, 2, 1);
    ksl_spatial_inertiaf_from_com_certified(m, &com, &Ic, &Bo, &Bo_bound);
    STORE(spatial_inertia_single, &Bo, 3, 3);
    STORE(spatial_inertia_single, &Bo_bound, 4, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_from_com_single)
LOOP(spatial_inertia_from_com_single, 5, DENSE_OR_ONE, 4, 12, 36, 40, 40, 4, 12, 4, 4, 4)
LOOPS(spatial_inertia_from_com)

/* (10),(6)->(6),(6) */
OVER(product_Bs_double) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_screw_t s;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(screw_double, &s, 1, 1);
    ksl_product_Bs_certified(&B, &s, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Bs_double)
LOOP(product_Bs_double, 4, DENSE_OR_ONE, 80, 48, 48, 48, 8, 8, 8, 8)

OVER(product_Bs_single) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_screwf_t s;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(screw_single, &s, 1, 1);
    ksl_product_Bsf_certified(&B, &s, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Bs_single)
LOOP(product_Bs_single, 4, DENSE_OR_ONE, 40, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_Bs)

/* (10),(6)->(),() */
OVER(spatial_inertia_energy_double) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_screw_t s;
    double energy;
    double energy_bound;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(screw_double, &s, 1, 1);
    energy = ksl_spatial_inertia_energy_certified(&B, &s, &energy_bound);
    STORE(scalar_double, &energy, 2, 2);
    STORE(scalar_double, &energy_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_energy_double)
LOOP(spatial_inertia_energy_double, 4, DENSE_OR_ONE, 80, 48, 8, 8, 8, 8)

OVER(spatial_inertia_energy_single) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_screwf_t s;
    float energy;
    float energy_bound;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(screw_single, &s, 1, 1);
    energy = ksl_spatial_inertiaf_energy_certified(&B, &s, &energy_bound);
    STORE(scalar_single, &energy, 2, 2);
    STORE(scalar_single, &energy_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_energy_single)
LOOP(spatial_inertia_energy_single, 4, DENSE_OR_ONE, 40, 24, 4, 4, 4, 4)
LOOPS(spatial_inertia_energy)

/* (10),(3),(6)->(6),(6) */
OVER(spatial_inertia_net_wrench_double) {
  POINTERS_5
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_vec3_t w;
    ksl_screw_t ds;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(vec3_double, &w, 1, 1);
    LOAD(screw_double, &ds, 2, 2);
    ksl_spatial_inertia_net_wrench_certified(&B, &w, &ds, &co, &co_bound);
    STORE(coscrew_double, &co, 3, 3);
    STORE(coscrew_double, &co_bound, 4, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_net_wrench_double)
LOOP(spatial_inertia_net_wrench_double, 5, DENSE_OR_ONE, 80, 24, 48, 48, 48, 8, 8, 8, 8, 8)

OVER(spatial_inertia_net_wrench_single) {
  POINTERS_5
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_vec3f_t w;
    ksl_screwf_t ds;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(vec3_single, &w, 1, 1);
    LOAD(screw_single, &ds, 2, 2);
    ksl_spatial_inertiaf_net_wrench_certified(&B, &w, &ds, &co, &co_bound);
    STORE(coscrew_single, &co, 3, 3);
    STORE(coscrew_single, &co_bound, 4, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_net_wrench_single)
LOOP(spatial_inertia_net_wrench_single, 5, DENSE_OR_ONE, 40, 12, 24, 24, 24, 4, 4, 4, 4, 4)
LOOPS(spatial_inertia_net_wrench)

/* (3),(10)->(10),(10) */
OVER(spatial_inertia_shifted_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(spatial_inertia_double, &B, 1, 1);
    ksl_spatial_inertia_shifted_certified(&t, &B, &Bo, &Bo_bound);
    STORE(spatial_inertia_double, &Bo, 2, 2);
    STORE(spatial_inertia_double, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_shifted_double)
LOOP(spatial_inertia_shifted_double, 4, DENSE_OR_ONE, 24, 80, 80, 80, 8, 8, 8, 8)

OVER(spatial_inertia_shifted_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(spatial_inertia_single, &B, 1, 1);
    ksl_spatial_inertiaf_shifted_certified(&t, &B, &Bo, &Bo_bound);
    STORE(spatial_inertia_single, &Bo, 2, 2);
    STORE(spatial_inertia_single, &Bo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_shifted_single)
LOOP(spatial_inertia_shifted_single, 4, DENSE_OR_ONE, 12, 40, 40, 40, 4, 4, 4, 4)
LOOPS(spatial_inertia_shifted)

/* (3,4),(10)->(10),(10) */
OVER(spatial_inertia_transformed_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    ksl_spatial_inertia_t Bo_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(spatial_inertia_double, &B, 1, 2);
    ksl_spatial_inertia_transformed_certified(&D, &B, &Bo, &Bo_bound);
    STORE(spatial_inertia_double, &Bo, 2, 3);
    STORE(spatial_inertia_double, &Bo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_transformed_double)
LOOP(spatial_inertia_transformed_double, 4, DENSE_OR_ONE, 96, 80, 80, 80, 32, 8, 8, 8, 8)

OVER(spatial_inertia_transformed_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    ksl_spatial_inertiaf_t Bo_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(spatial_inertia_single, &B, 1, 2);
    ksl_spatial_inertiaf_transformed_certified(&D, &B, &Bo, &Bo_bound);
    STORE(spatial_inertia_single, &Bo, 2, 3);
    STORE(spatial_inertia_single, &Bo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(spatial_inertia_transformed_single)
LOOP(spatial_inertia_transformed_single, 4, DENSE_OR_ONE, 48, 40, 40, 40, 16, 4, 4, 4, 4)
LOOPS(spatial_inertia_transformed)

const coscrew_gufunc TABLE(spatial_inertia)[] = {
  {"spatial_inertia_scale", "(10),()->(10),(10)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(10),()->(10),(10).  self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about\n"
    "the origin, xx, yy, zz, xy, xz, yz in kg m^2); a: number.\n"
    "20 mul, 10 add, 10 abs.\n",
   2, 2, "", spatial_inertia_scale_loops},
  {"add_BB", "(10),(10)->(10),(10)",
    "Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I\n"
    "about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "10 mul, 10 add, 10 abs.\n",
   2, 2, "", add_BB_loops},
  {"subtract_BB", "(10),(10)->(10),(10)",
    "Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I\n"
    "about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "10 mul, 10 add, 10 abs.\n",
   2, 2, "", subtract_BB_loops},
  {"spatial_inertia_from_com", "(),(3),(3,3)->(10),(10)",
    "Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle\n"
    "is read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(),(3),(3,3)->(10),(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo,\n"
    "Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,\n"
    "yz in kg m^2).\n"
    "24 mul, 27 add, 12 abs.\n",
   3, 2, "", spatial_inertia_from_com_loops},
  {"product_Bs", "(10),(6)->(6),(6)",
    "co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of\n"
    "co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(10),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,\n"
    "yy, zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in\n"
    "N; τ in N m).\n"
    "30 mul, 42 add, 24 abs.\n",
   2, 2, "", product_Bs_loops},
  {"spatial_inertia_energy", "(10),(6)->(),()",
    "s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=\n"
    "energy_bound unless inf or NaN.\n"
    "\n"
    "(10),(6)->(),().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy, energy_bound: number.\n"
    "35 mul, 43 add, 25 abs.\n",
   2, 2, "", spatial_inertia_energy_loops},
  {"spatial_inertia_net_wrench", "(10),(3),(6)->(6),(6)",
    "co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular\n"
    "velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if\n"
    "a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(10),(3),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co,\n"
    "co_bound: coscrew (f in N; τ in N m).\n"
    "66 mul, 102 add, 3 neg, 30 abs.\n",
   3, 2, "", spatial_inertia_net_wrench_loops},
  {"spatial_inertia_shifted", "(3),(10)->(10),(10)",
    "Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3),(10)->(10),(10).  t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m;\n"
    "I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "42 mul, 54 add, 15 abs.\n",
   2, 2, "", spatial_inertia_shifted_loops},
  {"spatial_inertia_transformed", "(3,4),(10)->(10),(10)",
    "Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of\n"
    "Bo| <= Bo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(10)->(10),(10).  D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound:\n"
    "spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg\n"
    "m^2).\n"
    "114 mul, 135 add, 51 abs.\n",
   2, 2, "R.", spatial_inertia_transformed_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
