/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the spatial_inertia operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/spatial_inertia_accurate.h"

/* (10),()->(10) */
OVER(spatial_inertia_scale_double) {
  POINTERS_3
  EACH {
    ksl_spatial_inertia_t self;
    double a;
    LOAD(spatial_inertia_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_spatial_inertia_scale_accurate(&self, a);
    STORE(spatial_inertia_double, &self, 2, 1);
  }
}
STRIDED_WITH_FMA(spatial_inertia_scale_double)
LOOP(spatial_inertia_scale_double, 3, DENSE, 80, 8, 80, 8, 8)

OVER(spatial_inertia_scale_single) {
  POINTERS_3
  EACH {
    ksl_spatial_inertiaf_t self;
    float a;
    LOAD(spatial_inertia_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_spatial_inertiaf_scale_accurate(&self, a);
    STORE(spatial_inertia_single, &self, 2, 1);
  }
}
STRIDED(spatial_inertia_scale_single)
LOOP(spatial_inertia_scale_single, 3, DENSE, 40, 4, 40, 4, 4)
LOOPS(spatial_inertia_scale)

/* (10),(10)->(10) */
OVER(add_BB_double) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B1, &B1);
  EACH {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    LOAD_OTHER(spatial_inertia_double, &B1);
    LOAD(spatial_inertia_double, &B2, 1, 1);
    ksl_add_BB_accurate(&B1, &B2, &Bo);
    STORE(spatial_inertia_double, &Bo, 2, 2);
  }
}
STRIDED(add_BB_double)
LOOP(add_BB_double, 3, DENSE_OR_ONE, 80, 80, 80, 8, 8, 8)

OVER(add_BB_single) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B1, &B1);
  EACH {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    LOAD_OTHER(spatial_inertia_single, &B1);
    LOAD(spatial_inertia_single, &B2, 1, 1);
    ksl_add_BBf_accurate(&B1, &B2, &Bo);
    STORE(spatial_inertia_single, &Bo, 2, 2);
  }
}
STRIDED(add_BB_single)
LOOP(add_BB_single, 3, DENSE_OR_ONE, 40, 40, 40, 4, 4, 4)
LOOPS(add_BB)

/* (10),(10)->(10) */
OVER(subtract_BB_double) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B1, &B1);
  EACH {
    ksl_spatial_inertia_t B2;
    ksl_spatial_inertia_t Bo;
    LOAD_OTHER(spatial_inertia_double, &B1);
    LOAD(spatial_inertia_double, &B2, 1, 1);
    ksl_subtract_BB_accurate(&B1, &B2, &Bo);
    STORE(spatial_inertia_double, &Bo, 2, 2);
  }
}
STRIDED(subtract_BB_double)
LOOP(subtract_BB_double, 3, DENSE_OR_ONE, 80, 80, 80, 8, 8, 8)

OVER(subtract_BB_single) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B1, &B1);
  EACH {
    ksl_spatial_inertiaf_t B2;
    ksl_spatial_inertiaf_t Bo;
    LOAD_OTHER(spatial_inertia_single, &B1);
    LOAD(spatial_inertia_single, &B2, 1, 1);
    ksl_subtract_BBf_accurate(&B1, &B2, &Bo);
    STORE(spatial_inertia_single, &Bo, 2, 2);
  }
}
STRIDED(subtract_BB_single)
LOOP(subtract_BB_single, 3, DENSE_OR_ONE, 40, 40, 40, 4, 4, 4)
LOOPS(subtract_BB)

/* (),(3),(3,3)->(10) */
OVER(spatial_inertia_from_com_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double m, &m);
  EACH {
    ksl_vec3_t com;
    ksl_mat3x3_t Ic;
    ksl_spatial_inertia_t Bo;
    LOAD_OTHER(scalar_double, &m);
    LOAD(vec3_double, &com, 1, 0);
    LOAD(mat3x3_double, &Ic, 2, 1);
    ksl_spatial_inertia_from_com_accurate(m, &com, &Ic, &Bo);
    STORE(spatial_inertia_double, &Bo, 3, 3);
  }
}
STRIDED_WITH_FMA(spatial_inertia_from_com_double)
LOOP(spatial_inertia_from_com_double, 4, DENSE_OR_ONE, 8, 24, 72, 80, 8, 24, 8, 8)

OVER(spatial_inertia_from_com_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float m, &m);
  EACH {
    ksl_vec3f_t com;
    ksl_mat3x3f_t Ic;
    ksl_spatial_inertiaf_t Bo;
    LOAD_OTHER(scalar_single, &m);
    LOAD(vec3_single, &com, 1, 0);
    LOAD(mat3x3_single, &Ic, 2, 1);
    ksl_spatial_inertiaf_from_com_accurate(m, &com, &Ic, &Bo);
    STORE(spatial_inertia_single, &Bo, 3, 3);
  }
}
STRIDED(spatial_inertia_from_com_single)
LOOP(spatial_inertia_from_com_single, 4, DENSE_OR_ONE, 4, 12, 36, 40, 4, 12, 4, 4)
LOOPS(spatial_inertia_from_com)

/* (10)->(10) */
OVER(spatial_inertia_from_inertia_double) {
  POINTERS_2
  EACH {
    ksl_inertia_t J;
    ksl_spatial_inertia_t Bo;
    LOAD(inertia_double, &J, 0, 0);
    ksl_spatial_inertia_from_inertia_accurate(&J, &Bo);
    STORE(spatial_inertia_double, &Bo, 1, 1);
  }
}
STRIDED_WITH_FMA(spatial_inertia_from_inertia_double)
LOOP(spatial_inertia_from_inertia_double, 2, DENSE, 80, 80, 8, 8)

OVER(spatial_inertia_from_inertia_single) {
  POINTERS_2
  EACH {
    ksl_inertiaf_t J;
    ksl_spatial_inertiaf_t Bo;
    LOAD(inertia_single, &J, 0, 0);
    ksl_spatial_inertiaf_from_inertia_accurate(&J, &Bo);
    STORE(spatial_inertia_single, &Bo, 1, 1);
  }
}
STRIDED(spatial_inertia_from_inertia_single)
LOOP(spatial_inertia_from_inertia_single, 2, DENSE, 40, 40, 4, 4)
LOOPS(spatial_inertia_from_inertia)

/* (10)->(10) */
OVER(inertia_from_spatial_inertia_double) {
  POINTERS_2
  EACH {
    ksl_spatial_inertia_t B;
    ksl_inertia_t Jo;
    LOAD(spatial_inertia_double, &B, 0, 0);
    ksl_inertia_from_spatial_inertia_accurate(&B, &Jo);
    STORE(inertia_double, &Jo, 1, 1);
  }
}
STRIDED_WITH_FMA(inertia_from_spatial_inertia_double)
LOOP(inertia_from_spatial_inertia_double, 2, DENSE, 80, 80, 8, 8)

OVER(inertia_from_spatial_inertia_single) {
  POINTERS_2
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_inertiaf_t Jo;
    LOAD(spatial_inertia_single, &B, 0, 0);
    ksl_inertiaf_from_spatial_inertia_accurate(&B, &Jo);
    STORE(inertia_single, &Jo, 1, 1);
  }
}
STRIDED(inertia_from_spatial_inertia_single)
LOOP(inertia_from_spatial_inertia_single, 2, DENSE, 40, 40, 4, 4)
LOOPS(inertia_from_spatial_inertia)

/* (10)->(3) */
OVER(spatial_inertia_com_double) {
  POINTERS_2
  EACH {
    ksl_spatial_inertia_t B;
    ksl_vec3_t vo;
    LOAD(spatial_inertia_double, &B, 0, 0);
    ksl_spatial_inertia_com_accurate(&B, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED_WITH_FMA(spatial_inertia_com_double)
LOOP(spatial_inertia_com_double, 2, DENSE, 80, 24, 8, 8)

OVER(spatial_inertia_com_single) {
  POINTERS_2
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_vec3f_t vo;
    LOAD(spatial_inertia_single, &B, 0, 0);
    ksl_spatial_inertiaf_com_accurate(&B, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(spatial_inertia_com_single)
LOOP(spatial_inertia_com_single, 2, DENSE, 40, 12, 4, 4)
LOOPS(spatial_inertia_com)

/* (10)->(3,3) */
OVER(spatial_inertia_about_com_double) {
  POINTERS_2
  EACH {
    ksl_spatial_inertia_t B;
    ksl_mat3x3_t Ro;
    LOAD(spatial_inertia_double, &B, 0, 0);
    ksl_spatial_inertia_about_com_accurate(&B, &Ro);
    STORE(mat3x3_double, &Ro, 1, 1);
  }
}
STRIDED_WITH_FMA(spatial_inertia_about_com_double)
LOOP(spatial_inertia_about_com_double, 2, DENSE, 80, 72, 8, 24, 8)

OVER(spatial_inertia_about_com_single) {
  POINTERS_2
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_mat3x3f_t Ro;
    LOAD(spatial_inertia_single, &B, 0, 0);
    ksl_spatial_inertiaf_about_com_accurate(&B, &Ro);
    STORE(mat3x3_single, &Ro, 1, 1);
  }
}
STRIDED(spatial_inertia_about_com_single)
LOOP(spatial_inertia_about_com_single, 2, DENSE, 40, 36, 4, 12, 4)
LOOPS(spatial_inertia_about_com)

/* (10),(6)->(6) */
OVER(product_Bs_double) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_screw_t s;
    ksl_coscrew_t co;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(screw_double, &s, 1, 1);
    ksl_product_Bs_accurate(&B, &s, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(product_Bs_double)
LOOP(product_Bs_double, 3, DENSE_OR_ONE, 80, 48, 48, 8, 8, 8)

OVER(product_Bs_single) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_screwf_t s;
    ksl_coscrewf_t co;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(screw_single, &s, 1, 1);
    ksl_product_Bsf_accurate(&B, &s, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_Bs_single)
LOOP(product_Bs_single, 3, DENSE_OR_ONE, 40, 24, 24, 4, 4, 4)
LOOPS(product_Bs)

/* (10),(6)->() */
OVER(spatial_inertia_energy_double) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_screw_t s;
    double energy;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(screw_double, &s, 1, 1);
    energy = ksl_spatial_inertia_energy_accurate(&B, &s);
    STORE(scalar_double, &energy, 2, 2);
  }
}
STRIDED_WITH_FMA(spatial_inertia_energy_double)
LOOP(spatial_inertia_energy_double, 3, DENSE_OR_ONE, 80, 48, 8, 8, 8)

OVER(spatial_inertia_energy_single) {
  POINTERS_3
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_screwf_t s;
    float energy;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(screw_single, &s, 1, 1);
    energy = ksl_spatial_inertiaf_energy_accurate(&B, &s);
    STORE(scalar_single, &energy, 2, 2);
  }
}
STRIDED(spatial_inertia_energy_single)
LOOP(spatial_inertia_energy_single, 3, DENSE_OR_ONE, 40, 24, 4, 4, 4)
LOOPS(spatial_inertia_energy)

/* (10),(3),(6)->(6) */
OVER(spatial_inertia_net_wrench_double) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_double, ksl_spatial_inertia_t B, &B);
  EACH {
    ksl_vec3_t w;
    ksl_screw_t ds;
    ksl_coscrew_t co;
    LOAD_OTHER(spatial_inertia_double, &B);
    LOAD(vec3_double, &w, 1, 1);
    LOAD(screw_double, &ds, 2, 2);
    ksl_spatial_inertia_net_wrench_accurate(&B, &w, &ds, &co);
    STORE(coscrew_double, &co, 3, 3);
  }
}
STRIDED_WITH_FMA(spatial_inertia_net_wrench_double)
LOOP(spatial_inertia_net_wrench_double, 4, DENSE_OR_ONE, 80, 24, 48, 48, 8, 8, 8, 8)

OVER(spatial_inertia_net_wrench_single) {
  POINTERS_4
  LOAD_FIRST(spatial_inertia_single, ksl_spatial_inertiaf_t B, &B);
  EACH {
    ksl_vec3f_t w;
    ksl_screwf_t ds;
    ksl_coscrewf_t co;
    LOAD_OTHER(spatial_inertia_single, &B);
    LOAD(vec3_single, &w, 1, 1);
    LOAD(screw_single, &ds, 2, 2);
    ksl_spatial_inertiaf_net_wrench_accurate(&B, &w, &ds, &co);
    STORE(coscrew_single, &co, 3, 3);
  }
}
STRIDED(spatial_inertia_net_wrench_single)
LOOP(spatial_inertia_net_wrench_single, 4, DENSE_OR_ONE, 40, 12, 24, 24, 4, 4, 4, 4)
LOOPS(spatial_inertia_net_wrench)

/* (3),(10)->(10) */
OVER(spatial_inertia_shifted_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    LOAD_OTHER(vec3_double, &t);
    LOAD(spatial_inertia_double, &B, 1, 1);
    ksl_spatial_inertia_shifted_accurate(&t, &B, &Bo);
    STORE(spatial_inertia_double, &Bo, 2, 2);
  }
}
STRIDED_WITH_FMA(spatial_inertia_shifted_double)
LOOP(spatial_inertia_shifted_double, 3, DENSE_OR_ONE, 24, 80, 80, 8, 8, 8)

OVER(spatial_inertia_shifted_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    LOAD_OTHER(vec3_single, &t);
    LOAD(spatial_inertia_single, &B, 1, 1);
    ksl_spatial_inertiaf_shifted_accurate(&t, &B, &Bo);
    STORE(spatial_inertia_single, &Bo, 2, 2);
  }
}
STRIDED(spatial_inertia_shifted_single)
LOOP(spatial_inertia_shifted_single, 3, DENSE_OR_ONE, 12, 40, 40, 4, 4, 4)
LOOPS(spatial_inertia_shifted)

/* (3,4),(10)->(10) */
OVER(spatial_inertia_transformed_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_spatial_inertia_t B;
    ksl_spatial_inertia_t Bo;
    LOAD_OTHER(SE3_double, &D);
    LOAD(spatial_inertia_double, &B, 1, 2);
    ksl_spatial_inertia_transformed_accurate(&D, &B, &Bo);
    STORE(spatial_inertia_double, &Bo, 2, 3);
  }
}
STRIDED_WITH_FMA(spatial_inertia_transformed_double)
LOOP(spatial_inertia_transformed_double, 3, DENSE_OR_ONE, 96, 80, 80, 32, 8, 8, 8)

OVER(spatial_inertia_transformed_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_spatial_inertiaf_t B;
    ksl_spatial_inertiaf_t Bo;
    LOAD_OTHER(SE3_single, &D);
    LOAD(spatial_inertia_single, &B, 1, 2);
    ksl_spatial_inertiaf_transformed_accurate(&D, &B, &Bo);
    STORE(spatial_inertia_single, &Bo, 2, 3);
  }
}
STRIDED(spatial_inertia_transformed_single)
LOOP(spatial_inertia_transformed_single, 3, DENSE_OR_ONE, 48, 40, 40, 16, 4, 4, 4)
LOOPS(spatial_inertia_transformed)

/* (10)->() */
OVER(spatial_inertia_consistency_double) {
  POINTERS_2
  EACH {
    ksl_spatial_inertia_t B;
    double pivot;
    LOAD(spatial_inertia_double, &B, 0, 0);
    pivot = ksl_spatial_inertia_consistency_accurate(&B);
    STORE(scalar_double, &pivot, 1, 1);
  }
}
STRIDED_WITH_FMA(spatial_inertia_consistency_double)
LOOP(spatial_inertia_consistency_double, 2, ANY, 80, 8, 8)

OVER(spatial_inertia_consistency_single) {
  POINTERS_2
  EACH {
    ksl_spatial_inertiaf_t B;
    float pivot;
    LOAD(spatial_inertia_single, &B, 0, 0);
    pivot = ksl_spatial_inertiaf_consistency_accurate(&B);
    STORE(scalar_single, &pivot, 1, 1);
  }
}
STRIDED(spatial_inertia_consistency_single)
LOOP(spatial_inertia_consistency_single, 2, DENSE, 40, 4, 4)
LOOPS(spatial_inertia_consistency)

const coscrew_gufunc TABLE(spatial_inertia)[] = {
  {"spatial_inertia_scale", "(10),()->(10)",
    "self = a self.\n"
    "\n"
    "(10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); a: number.\n"
    "10 mul, 10 add, 10 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", spatial_inertia_scale_loops},
  {"add_BB", "(10),(10)->(10)",
    "Bo = B1 + B2.\n"
    "\n"
    "(10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "70 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_BB_loops},
  {"subtract_BB", "(10),(10)->(10)",
    "Bo = B1 - B2.\n"
    "\n"
    "(10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,\n"
    "xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "70 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_BB_loops},
  {"spatial_inertia_from_com", "(),(3),(3,3)->(10)",
    "Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle\n"
    "is read): h = m com, I = Ic - m com~ com~.\n"
    "\n"
    "(),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial\n"
    "inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "15 mul, 66 add, 3 product error, 9 product rest.  Error <= u |result| + (m: 0, h: 0, I: 15)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   3, 1, "", spatial_inertia_from_com_loops},
  {"spatial_inertia_from_inertia", "(10)->(10)",
    "Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of\n"
    "mass; NaN where m = 0.\n"
    "\n"
    "(10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,\n"
    "zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the\n"
    "origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a\n"
    "moment <= 4 u times the sum of its |terms|, barring over- and underflow.\n",
   1, 1, "", spatial_inertia_from_inertia_loops},
  {"inertia_from_spatial_inertia", "(10)->(10)",
    "Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of\n"
    "mass; NaN where m = 0.\n"
    "\n"
    "(10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,\n"
    "xx, yy, zz, xy, yz, zx in kg m^2).\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a\n"
    "moment <= 4 u times the sum of its |terms|, barring over- and underflow.\n",
   1, 1, "", inertia_from_spatial_inertia_loops},
  {"spatial_inertia_com", "(10)->(3)",
    "vo = h / m, the centre of mass in m.\n"
    "\n"
    "(10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); vo: vector.\n"
    "3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.  Error <= u |result|, barring over-\n"
    "and underflow.\n",
   1, 1, "", spatial_inertia_com_loops},
  {"spatial_inertia_about_com", "(10)->(3,3)",
    "Ro = I + h~ h~ / m, the second moments about the centre of mass.\n"
    "\n"
    "(10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.\n"
    "15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.\n",
   1, 1, "", spatial_inertia_about_com_loops},
  {"product_Bs", "(10),(6)->(6)",
    "co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.\n"
    "\n"
    "(10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,\n"
    "zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).\n"
    "24 mul, 102 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 19) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Bs_loops},
  {"spatial_inertia_energy", "(10),(6)->()",
    "s·B s / 2, the kinetic energy in J of a body that moves with s.\n"
    "\n"
    "(10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,\n"
    "xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.\n"
    "34 mul, 142 add, 25 product rest.  Error <= u |result| + 44 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", spatial_inertia_energy_loops},
  {"spatial_inertia_net_wrench", "(10),(3),(6)->(6)",
    "co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular\n"
    "velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if\n"
    "a is less gravity's, so is the wrench.\n"
    "\n"
    "(10),(3),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,\n"
    "yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f\n"
    "in N; τ in N m).\n"
    "63 mul, 324 add, 3 product error, 51 product rest, 6 neg.  Error <= u |result| + (lin: 36,\n"
    "ang: 42) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and\n"
    "underflow.\n",
   3, 1, "", spatial_inertia_net_wrench_loops},
  {"spatial_inertia_shifted", "(3),(10)->(10)",
    "Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.\n"
    "\n"
    "(3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the\n"
    "origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "33 mul, 138 add, 6 product error, 6 product rest.  Error <= u |result| + (m: 0, h: 2, I: 20)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", spatial_inertia_shifted_loops},
  {"spatial_inertia_transformed", "(3,4),(10)->(10)",
    "Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.\n"
    "\n"
    "(3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in\n"
    "kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).\n"
    "105 mul, 420 add, 6 product error, 60 product rest.  Error <= u |result| + (m: 0, h: 16, I:\n"
    "35) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", spatial_inertia_transformed_loops},
  {"spatial_inertia_consistency", "(10)->()",
    "the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:\n"
    "positive exactly if a body of positive density has this inertia.\n"
    "\n"
    "(10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,\n"
    "xz, yz in kg m^2); pivot: number.\n"
    "42 mul, 258 add, 10 product error, 10 product rest, 20 div, 6 neg, 9 less, 1 equal, 26\n"
    "select.\n",
   1, 1, "", spatial_inertia_consistency_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
