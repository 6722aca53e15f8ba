/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the screw operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/screw_certified.h"
#include <fenv.h>

/* (6),()->(6),(6) */
OVER(screw_scale_double) {
  POINTERS_4
  EACH {
    ksl_screw_t self;
    double a;
    ksl_screw_t self_bound;
    LOAD(screw_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_screw_scale_certified(&self, a, &self_bound);
    STORE(screw_double, &self, 2, 1);
    STORE(screw_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(screw_scale_double)
LOOP(screw_scale_double, 4, DENSE, 48, 8, 48, 48, 8, 8, 8)

OVER(screw_scale_single) {
  POINTERS_4
  EACH {
    ksl_screwf_t self;
    float a;
    ksl_screwf_t self_bound;
    LOAD(screw_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_screwf_scale_certified(&self, a, &self_bound);
    STORE(screw_single, &self, 2, 1);
    STORE(screw_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(screw_scale_single)
LOOP(screw_scale_single, 4, DENSE, 24, 4, 24, 24, 4, 4, 4)
LOOPS(screw_scale)

/* (),(6),(6)->(6),(6) */
OVER(axpy_ss_double) {
  POINTERS_5
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_screw_t x;
    ksl_screw_t y;
    ksl_screw_t y_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(screw_double, &x, 1, 0);
    LOAD(screw_double, &y, 2, 1);
    ksl_axpy_ss_certified(a, &x, &y, &y_bound);
    STORE(screw_double, &y, 3, 2);
    STORE(screw_double, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_ss_double)
LOOP(axpy_ss_double, 5, DENSE_OR_ONE, 8, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(axpy_ss_single) {
  POINTERS_5
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_screwf_t x;
    ksl_screwf_t y;
    ksl_screwf_t y_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(screw_single, &x, 1, 0);
    LOAD(screw_single, &y, 2, 1);
    ksl_axpy_ssf_certified(a, &x, &y, &y_bound);
    STORE(screw_single, &y, 3, 2);
    STORE(screw_single, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_ss_single)
LOOP(axpy_ss_single, 5, DENSE_OR_ONE, 4, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(axpy_ss)

/* (6),(6)->(6),(6) */
OVER(xpy_ss_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t x, &x);
  EACH {
    ksl_screw_t y;
    ksl_screw_t y_bound;
    LOAD_OTHER(screw_double, &x);
    LOAD(screw_double, &y, 1, 1);
    ksl_xpy_ss_certified(&x, &y, &y_bound);
    STORE(screw_double, &y, 2, 2);
    STORE(screw_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_ss_double)
LOOP(xpy_ss_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(xpy_ss_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t x, &x);
  EACH {
    ksl_screwf_t y;
    ksl_screwf_t y_bound;
    LOAD_OTHER(screw_single, &x);
    LOAD(screw_single, &y, 1, 1);
    ksl_xpy_ssf_certified(&x, &y, &y_bound);
    STORE(screw_single, &y, 2, 2);
    STORE(screw_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_ss_single)
LOOP(xpy_ss_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(xpy_ss)

/* (6),(6)->(6),(6) */
OVER(nxpy_ss_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t x, &x);
  EACH {
    ksl_screw_t y;
    ksl_screw_t y_bound;
    LOAD_OTHER(screw_double, &x);
    LOAD(screw_double, &y, 1, 1);
    ksl_nxpy_ss_certified(&x, &y, &y_bound);
    STORE(screw_double, &y, 2, 2);
    STORE(screw_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_ss_double)
LOOP(nxpy_ss_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(nxpy_ss_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t x, &x);
  EACH {
    ksl_screwf_t y;
    ksl_screwf_t y_bound;
    LOAD_OTHER(screw_single, &x);
    LOAD(screw_single, &y, 1, 1);
    ksl_nxpy_ssf_certified(&x, &y, &y_bound);
    STORE(screw_single, &y, 2, 2);
    STORE(screw_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_ss_single)
LOOP(nxpy_ss_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(nxpy_ss)

/* (),(6)->(6),(6) */
OVER(product_as_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(screw_double, &si, 1, 0);
    ksl_product_as_certified(a, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 1);
    STORE(screw_double, &so_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_as_double)
LOOP(product_as_double, 4, DENSE_OR_ONE, 8, 48, 48, 48, 8, 8, 8)

OVER(product_as_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(screw_single, &si, 1, 0);
    ksl_product_asf_certified(a, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 1);
    STORE(screw_single, &so_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_as_single)
LOOP(product_as_single, 4, DENSE_OR_ONE, 4, 24, 24, 24, 4, 4, 4)
LOOPS(product_as)

/* (6),(6)->(6),(6) */
OVER(add_ss_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_add_ss_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_ss_double)
LOOP(add_ss_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(add_ss_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_add_ssf_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_ss_single)
LOOP(add_ss_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(add_ss)

/* (6),(6)->(6),(6) */
OVER(subtract_ss_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_subtract_ss_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_ss_double)
LOOP(subtract_ss_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(subtract_ss_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_subtract_ssf_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_ss_single)
LOOP(subtract_ss_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(subtract_ss)

/* (6),(6)->(6),(6) */
OVER(add_sst_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_add_sst_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_sst_double)
LOOP(add_sst_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(add_sst_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_add_sstf_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_sst_single)
LOOP(add_sst_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(add_sst)

/* (3),(6)->(6),(6) */
OVER(product_Adts_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adts_certified(&t, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adts_double)
LOOP(product_Adts_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_Adts_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtsf_certified(&t, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adts_single)
LOOP(product_Adts_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_Adts)

/* (3),(6)->(6),(6) */
OVER(product_Adtinvs_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adtinvs_certified(&t, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adtinvs_double)
LOOP(product_Adtinvs_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_Adtinvs_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtinvsf_certified(&t, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adtinvs_single)
LOOP(product_Adtinvs_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_Adtinvs)

/* (3),(6)->(6),(6) */
OVER(product_Adtsinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adtsinv_certified(&t, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adtsinv_double)
LOOP(product_Adtsinv_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_Adtsinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtsinvf_certified(&t, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adtsinv_single)
LOOP(product_Adtsinv_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_Adtsinv)

/* (3,3),(6)->(6),(6) */
OVER(product_Adrs_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrs_certified(&R, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrs_double)
LOOP(product_Adrs_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_Adrs_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrsf_certified(&R, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrs_single)
LOOP(product_Adrs_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_Adrs)

/* (3,3),(6)->(6),(6) */
OVER(product_Adrinvs_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrinvs_certified(&R, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrinvs_double)
LOOP(product_Adrinvs_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_Adrinvs_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrinvsf_certified(&R, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrinvs_single)
LOOP(product_Adrinvs_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_Adrinvs)

/* (3,3),(6)->(6),(6) */
OVER(product_Adrsinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrsinv_certified(&R, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrsinv_double)
LOOP(product_Adrsinv_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_Adrsinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrsinvf_certified(&R, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adrsinv_single)
LOOP(product_Adrsinv_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_Adrsinv)

/* (3,4),(6)->(6),(6) */
OVER(product_Ads_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Ads_certified(&D, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Ads_double)
LOOP(product_Ads_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_Ads_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adsf_certified(&D, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Ads_single)
LOOP(product_Ads_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_Ads)

/* (3,4),(6)->(6),(6) */
OVER(product_Adinvs_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adinvs_certified(&D, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adinvs_double)
LOOP(product_Adinvs_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_Adinvs_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adinvsf_certified(&D, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adinvs_single)
LOOP(product_Adinvs_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_Adinvs)

/* (3,4),(6)->(6),(6) */
OVER(product_Adsinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adsinv_certified(&D, &si, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adsinv_double)
LOOP(product_Adsinv_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_Adsinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adsinvf_certified(&D, &si, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_Adsinv_single)
LOOP(product_Adsinv_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_Adsinv)

/* (3,4)->(6),(6) */
OVER(hsrx_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrx_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrx_double)
LOOP(hsrx_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsrx_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrxf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrx_single)
LOOP(hsrx_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsrx)

/* (3,4)->(6),(6) */
OVER(hsry_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsry_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsry_double)
LOOP(hsry_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsry_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsryf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsry_single)
LOOP(hsry_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsry)

/* (3,4)->(6),(6) */
OVER(hsrz_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrz_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrz_double)
LOOP(hsrz_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsrz_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrzf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrz_single)
LOOP(hsrz_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsrz)

/* (3,4)->(6),(6) */
OVER(hsrxinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrxinv_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrxinv_double)
LOOP(hsrxinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsrxinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrxinvf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrxinv_single)
LOOP(hsrxinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsrxinv)

/* (3,4)->(6),(6) */
OVER(hsryinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsryinv_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsryinv_double)
LOOP(hsryinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsryinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsryinvf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsryinv_single)
LOOP(hsryinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsryinv)

/* (3,4)->(6),(6) */
OVER(hsrzinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrzinv_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrzinv_double)
LOOP(hsrzinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hsrzinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrzinvf_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrzinv_single)
LOOP(hsrzinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hsrzinv)

/* (3,4)->(6,6),(6,6) */
OVER(Ad_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_mat6x6_t M;
    ksl_mat6x6_t M_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_Ad_certified(&D, &M, &M_bound);
    STORE(mat6x6_double, &M, 1, 2);
    STORE(mat6x6_double, &M_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(Ad_double)
LOOP(Ad_double, 3, DENSE, 96, 288, 288, 32, 8, 48, 8, 48, 8)

OVER(Ad_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t M_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_Adf_certified(&D, &M, &M_bound);
    STORE(mat6x6_single, &M, 1, 2);
    STORE(mat6x6_single, &M_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(Ad_single)
LOOP(Ad_single, 3, DENSE, 48, 144, 144, 16, 4, 24, 4, 24, 4)
LOOPS(Ad)

/* (6),(6)->(),() */
OVER(dot_cs_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c, &c);
  EACH {
    ksl_screw_t s;
    double power;
    double power_bound;
    LOAD_OTHER(coscrew_double, &c);
    LOAD(screw_double, &s, 1, 1);
    power = ksl_dot_cs_certified(&c, &s, &power_bound);
    STORE(scalar_double, &power, 2, 2);
    STORE(scalar_double, &power_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_cs_double)
LOOP(dot_cs_double, 4, DENSE_OR_ONE, 48, 48, 8, 8, 8, 8)

OVER(dot_cs_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c, &c);
  EACH {
    ksl_screwf_t s;
    float power;
    float power_bound;
    LOAD_OTHER(coscrew_single, &c);
    LOAD(screw_single, &s, 1, 1);
    power = ksl_dot_csf_certified(&c, &s, &power_bound);
    STORE(scalar_single, &power, 2, 2);
    STORE(scalar_single, &power_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_cs_single)
LOOP(dot_cs_single, 4, DENSE_OR_ONE, 24, 24, 4, 4, 4, 4)
LOOPS(dot_cs)

/* (6),(6)->(6),(6) */
OVER(cross_ss_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_cross_ss_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_ss_double)
LOOP(cross_ss_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(cross_ss_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_cross_ssf_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_ss_single)
LOOP(cross_ss_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(cross_ss)

/* (6),(6)->(6),(6) */
OVER(cross_sst_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_cross_sst_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_double, &so, 2, 2);
    STORE(screw_double, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sst_double)
LOOP(cross_sst_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(cross_sst_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_cross_sstf_certified(&s1, &s2, &so, &so_bound);
    STORE(screw_single, &so, 2, 2);
    STORE(screw_single, &so_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sst_single)
LOOP(cross_sst_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(cross_sst)

/* (3,4),(3)->(6),(6) */
OVER(hsra_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsra_certified(&D, &axis, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsra_double)
LOOP(hsra_double, 4, DENSE_OR_ONE, 96, 24, 48, 48, 32, 8, 8, 8, 8)

OVER(hsra_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hsraf_certified(&D, &axis, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsra_single)
LOOP(hsra_single, 4, DENSE_OR_ONE, 48, 12, 24, 24, 16, 4, 4, 4, 4)
LOOPS(hsra)

/* (3,4),(3)->(6),(6) */
OVER(hsta_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsta_certified(&D, &axis, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsta_double)
LOOP(hsta_double, 4, DENSE_OR_ONE, 96, 24, 48, 48, 32, 8, 8, 8, 8)

OVER(hsta_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hstaf_certified(&D, &axis, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsta_single)
LOOP(hsta_single, 4, DENSE_OR_ONE, 48, 12, 24, 24, 16, 4, 4, 4, 4)
LOOPS(hsta)

/* (3,4),(3)->(6),(6) */
OVER(hsrainv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsrainv_certified(&D, &axis, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrainv_double)
LOOP(hsrainv_double, 4, DENSE_OR_ONE, 96, 24, 48, 48, 32, 8, 8, 8, 8)

OVER(hsrainv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hsrainvf_certified(&D, &axis, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hsrainv_single)
LOOP(hsrainv_single, 4, DENSE_OR_ONE, 48, 12, 24, 24, 16, 4, 4, 4, 4)
LOOPS(hsrainv)

/* (3,4),(3)->(6),(6) */
OVER(hstainv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hstainv_certified(&D, &axis, &so, &so_bound);
    STORE(screw_double, &so, 2, 3);
    STORE(screw_double, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hstainv_double)
LOOP(hstainv_double, 4, DENSE_OR_ONE, 96, 24, 48, 48, 32, 8, 8, 8, 8)

OVER(hstainv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hstainvf_certified(&D, &axis, &so, &so_bound);
    STORE(screw_single, &so, 2, 3);
    STORE(screw_single, &so_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hstainv_single)
LOOP(hstainv_single, 4, DENSE_OR_ONE, 48, 12, 24, 24, 16, 4, 4, 4, 4)
LOOPS(hstainv)

const coscrew_gufunc TABLE(screw)[] = {
  {"screw_scale", "(6),()->(6),(6)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(6),()->(6),(6).  self, self_bound: screw (v in m/s; ω in rad/s); a: number.\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", screw_scale_loops},
  {"axpy_ss", "(),(6),(6)->(6),(6)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(6),(6)->(6),(6).  a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).\n"
    "12 mul, 18 add, 12 abs.\n",
   3, 2, "", axpy_ss_loops},
  {"xpy_ss", "(6),(6)->(6),(6)",
    "y = x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", xpy_ss_loops},
  {"nxpy_ss", "(6),(6)->(6),(6)",
    "y = -x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", nxpy_ss_loops},
  {"product_as", "(),(6)->(6),(6)",
    "so = a si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(),(6)->(6),(6).  a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", product_as_loops},
  {"add_ss", "(6),(6)->(6),(6)",
    "so = s1 + s2; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", add_ss_loops},
  {"subtract_ss", "(6),(6)->(6),(6)",
    "so = s1 - s2; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", subtract_ss_loops},
  {"add_sst", "(6),(6)->(6),(6)",
    "so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", add_sst_loops},
  {"product_Adts", "(3),(6)->(6),(6)",
    "so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_Adts_loops},
  {"product_Adtinvs", "(3),(6)->(6),(6)",
    "so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_Adtinvs_loops},
  {"product_Adtsinv", "(3),(6)->(6),(6)",
    "so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "9 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_Adtsinv_loops},
  {"product_Adrs", "(3,3),(6)->(6),(6)",
    "so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω\n"
    "in rad/s).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_Adrs_loops},
  {"product_Adrinvs", "(3,3),(6)->(6),(6)",
    "so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω\n"
    "in rad/s).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_Adrinvs_loops},
  {"product_Adrsinv", "(3,3),(6)->(6),(6)",
    "so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω\n"
    "in rad/s).\n"
    "24 mul, 30 add, 6 neg, 18 abs.\n",
   2, 2, "R.", product_Adrsinv_loops},
  {"product_Ads", "(3,4),(6)->(6),(6)",
    "so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v\n"
    "in m/s; ω in rad/s).\n"
    "36 mul, 42 add, 21 abs.\n",
   2, 2, "R.", product_Ads_loops},
  {"product_Adinvs", "(3,4),(6)->(6),(6)",
    "so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v\n"
    "in m/s; ω in rad/s).\n"
    "39 mul, 45 add, 27 abs.\n",
   2, 2, "R.", product_Adinvs_loops},
  {"product_Adsinv", "(3,4),(6)->(6),(6)",
    "so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v\n"
    "in m/s; ω in rad/s).\n"
    "36 mul, 42 add, 6 neg, 21 abs.\n",
   2, 2, "R.", product_Adsinv_loops},
  {"hsrx", "(3,4)->(6),(6)",
    "so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hsrx_loops},
  {"hsry", "(3,4)->(6),(6)",
    "so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hsry_loops},
  {"hsrz", "(3,4)->(6),(6)",
    "so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hsrz_loops},
  {"hsrxinv", "(3,4)->(6),(6)",
    "so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hsrxinv_loops},
  {"hsryinv", "(3,4)->(6),(6)",
    "so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hsryinv_loops},
  {"hsrzinv", "(3,4)->(6),(6)",
    "so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hsrzinv_loops},
  {"Ad", "(3,4)->(6,6),(6,6)",
    "M = [Ad](D); |error of M| <= M_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.\n"
    "27 mul, 27 add, 18 abs.\n",
   1, 2, "R", Ad_loops},
  {"dot_cs", "(6),(6)->(),()",
    "power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(),().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power,\n"
    "power_bound: number.\n"
    "7 mul, 11 add, 6 abs.\n",
   2, 2, "", dot_cs_loops},
  {"cross_ss", "(6),(6)->(6),(6)",
    "so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.\n"
    "Exactly zero for s1 = s2, unless products overflow.\n"
    "\n"
    "(6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "", cross_ss_loops},
  {"cross_sst", "(6),(6)->(6),(6)",
    "so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_sst_loops},
  {"hsra", "(3,4),(3)->(6),(6)",
    "so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,\n"
    "so_bound: screw (v in m/s; ω in rad/s).\n"
    "27 mul, 24 add, 12 abs.\n",
   2, 2, "R.", hsra_loops},
  {"hsta", "(3,4),(3)->(6),(6)",
    "so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,\n"
    "so_bound: screw (v in m/s; ω in rad/s).\n"
    "12 mul, 15 add, 9 abs.\n",
   2, 2, "R.", hsta_loops},
  {"hsrainv", "(3,4),(3)->(6),(6)",
    "so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,\n"
    "so_bound: screw (v in m/s; ω in rad/s).\n"
    "27 mul, 24 add, 3 neg, 12 abs.\n",
   2, 2, "R.", hsrainv_loops},
  {"hstainv", "(3,4),(3)->(6),(6)",
    "so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,\n"
    "so_bound: screw (v in m/s; ω in rad/s).\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "R.", hstainv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
