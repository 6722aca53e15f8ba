/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the screw operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/screw.h"

/* (6)->(6) */
OVER(screw_copy_double) {
  POINTERS_2
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD(screw_double, &si, 0, 0);
    ksl_screw_copy(&si, &so);
    STORE(screw_double, &so, 1, 1);
  }
}
STRIDED(screw_copy_double)
LOOP(screw_copy_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_copy_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD(screw_single, &si, 0, 0);
    ksl_screwf_copy(&si, &so);
    STORE(screw_single, &so, 1, 1);
  }
}
STRIDED(screw_copy_single)
LOOP(screw_copy_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_copy)

/* (6),()->(6) */
OVER(screw_scale_double) {
  POINTERS_3
  EACH {
    ksl_screw_t self;
    double a;
    LOAD(screw_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_screw_scale(&self, a);
    STORE(screw_double, &self, 2, 1);
  }
}
STRIDED(screw_scale_double)
LOOP(screw_scale_double, 3, DENSE, 48, 8, 48, 8, 8)

OVER(screw_scale_single) {
  POINTERS_3
  EACH {
    ksl_screwf_t self;
    float a;
    LOAD(screw_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_screwf_scale(&self, a);
    STORE(screw_single, &self, 2, 1);
  }
}
STRIDED(screw_scale_single)
LOOP(screw_scale_single, 3, DENSE, 24, 4, 24, 4, 4)
LOOPS(screw_scale)

/* (6)->(6) */
OVER(screw_inverted_double) {
  POINTERS_2
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD(screw_double, &si, 0, 0);
    ksl_screw_inverted(&si, &so);
    STORE(screw_double, &so, 1, 1);
  }
}
STRIDED(screw_inverted_double)
LOOP(screw_inverted_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_inverted_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD(screw_single, &si, 0, 0);
    ksl_screwf_inverted(&si, &so);
    STORE(screw_single, &so, 1, 1);
  }
}
STRIDED(screw_inverted_single)
LOOP(screw_inverted_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_inverted)

/* (6)->(6) */
OVER(screw_invert_double) {
  POINTERS_2
  EACH {
    ksl_screw_t self;
    LOAD(screw_double, &self, 0, 0);
    ksl_screw_invert(&self);
    STORE(screw_double, &self, 1, 1);
  }
}
STRIDED(screw_invert_double)
LOOP(screw_invert_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_invert_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t self;
    LOAD(screw_single, &self, 0, 0);
    ksl_screwf_invert(&self);
    STORE(screw_single, &self, 1, 1);
  }
}
STRIDED(screw_invert_single)
LOOP(screw_invert_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_invert)

/* (),(6),(6)->(6) */
OVER(axpy_ss_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_screw_t x;
    ksl_screw_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(screw_double, &x, 1, 0);
    LOAD(screw_double, &y, 2, 1);
    ksl_axpy_ss(a, &x, &y);
    STORE(screw_double, &y, 3, 2);
  }
}
STRIDED(axpy_ss_double)
LOOP(axpy_ss_double, 4, DENSE_OR_ONE, 8, 48, 48, 48, 8, 8, 8)

OVER(axpy_ss_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_screwf_t x;
    ksl_screwf_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(screw_single, &x, 1, 0);
    LOAD(screw_single, &y, 2, 1);
    ksl_axpy_ssf(a, &x, &y);
    STORE(screw_single, &y, 3, 2);
  }
}
STRIDED(axpy_ss_single)
LOOP(axpy_ss_single, 4, DENSE_OR_ONE, 4, 24, 24, 24, 4, 4, 4)
LOOPS(axpy_ss)

/* (6),(6)->(6) */
OVER(xpy_ss_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t x, &x);
  EACH {
    ksl_screw_t y;
    LOAD_OTHER(screw_double, &x);
    LOAD(screw_double, &y, 1, 1);
    ksl_xpy_ss(&x, &y);
    STORE(screw_double, &y, 2, 2);
  }
}
STRIDED(xpy_ss_double)
LOOP(xpy_ss_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(xpy_ss_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t x, &x);
  EACH {
    ksl_screwf_t y;
    LOAD_OTHER(screw_single, &x);
    LOAD(screw_single, &y, 1, 1);
    ksl_xpy_ssf(&x, &y);
    STORE(screw_single, &y, 2, 2);
  }
}
STRIDED(xpy_ss_single)
LOOP(xpy_ss_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(xpy_ss)

/* (6),(6)->(6) */
OVER(nxpy_ss_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t x, &x);
  EACH {
    ksl_screw_t y;
    LOAD_OTHER(screw_double, &x);
    LOAD(screw_double, &y, 1, 1);
    ksl_nxpy_ss(&x, &y);
    STORE(screw_double, &y, 2, 2);
  }
}
STRIDED(nxpy_ss_double)
LOOP(nxpy_ss_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(nxpy_ss_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t x, &x);
  EACH {
    ksl_screwf_t y;
    LOAD_OTHER(screw_single, &x);
    LOAD(screw_single, &y, 1, 1);
    ksl_nxpy_ssf(&x, &y);
    STORE(screw_single, &y, 2, 2);
  }
}
STRIDED(nxpy_ss_single)
LOOP(nxpy_ss_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(nxpy_ss)

/* (),(6)->(6) */
OVER(product_as_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(scalar_double, &a);
    LOAD(screw_double, &si, 1, 0);
    ksl_product_as(a, &si, &so);
    STORE(screw_double, &so, 2, 1);
  }
}
STRIDED(product_as_double)
LOOP(product_as_double, 3, DENSE_OR_ONE, 8, 48, 48, 8, 8)

OVER(product_as_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(scalar_single, &a);
    LOAD(screw_single, &si, 1, 0);
    ksl_product_asf(a, &si, &so);
    STORE(screw_single, &so, 2, 1);
  }
}
STRIDED(product_as_single)
LOOP(product_as_single, 3, DENSE_OR_ONE, 4, 24, 24, 4, 4)
LOOPS(product_as)

/* (6),(6)->(6) */
OVER(add_ss_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_add_ss(&s1, &s2, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(add_ss_double)
LOOP(add_ss_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_ss_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_add_ssf(&s1, &s2, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(add_ss_single)
LOOP(add_ss_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_ss)

/* (6),(6)->(6) */
OVER(subtract_ss_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_subtract_ss(&s1, &s2, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(subtract_ss_double)
LOOP(subtract_ss_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(subtract_ss_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_subtract_ssf(&s1, &s2, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(subtract_ss_single)
LOOP(subtract_ss_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(subtract_ss)

/* (6)->() */
OVER(screw_norm_double) {
  POINTERS_2
  EACH {
    ksl_screw_t si;
    double norm;
    LOAD(screw_double, &si, 0, 0);
    norm = ksl_screw_norm(&si);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED(screw_norm_double)
LOOP(screw_norm_double, 2, DENSE, 48, 8, 8)

OVER(screw_norm_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t si;
    float norm;
    LOAD(screw_single, &si, 0, 0);
    norm = ksl_screwf_norm(&si);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(screw_norm_single)
LOOP(screw_norm_single, 2, DENSE, 24, 4, 4)
LOOPS(screw_norm)

/* (6)->(6) */
OVER(screw_normalize_double) {
  POINTERS_2
  EACH {
    ksl_screw_t self;
    LOAD(screw_double, &self, 0, 0);
    ksl_screw_normalize(&self);
    STORE(screw_double, &self, 1, 1);
  }
}
STRIDED(screw_normalize_double)
LOOP(screw_normalize_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_normalize_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t self;
    LOAD(screw_single, &self, 0, 0);
    ksl_screwf_normalize(&self);
    STORE(screw_single, &self, 1, 1);
  }
}
STRIDED(screw_normalize_single)
LOOP(screw_normalize_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_normalize)

/* (6)->(6) */
OVER(screw_normalized_double) {
  POINTERS_2
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD(screw_double, &si, 0, 0);
    ksl_screw_normalized(&si, &so);
    STORE(screw_double, &so, 1, 1);
  }
}
STRIDED(screw_normalized_double)
LOOP(screw_normalized_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_normalized_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD(screw_single, &si, 0, 0);
    ksl_screwf_normalized(&si, &so);
    STORE(screw_single, &so, 1, 1);
  }
}
STRIDED(screw_normalized_single)
LOOP(screw_normalized_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_normalized)

/* (3),(3)->(6) */
OVER(screw_from_lin_ang_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t lin, &lin);
  EACH {
    ksl_vec3_t ang;
    ksl_screw_t so;
    LOAD_OTHER(vec3_double, &lin);
    LOAD(vec3_double, &ang, 1, 1);
    ksl_screw_from_lin_ang(&lin, &ang, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(screw_from_lin_ang_double)
LOOP(screw_from_lin_ang_double, 3, DENSE_OR_ONE, 24, 24, 48, 8, 8, 8)

OVER(screw_from_lin_ang_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t lin, &lin);
  EACH {
    ksl_vec3f_t ang;
    ksl_screwf_t so;
    LOAD_OTHER(vec3_single, &lin);
    LOAD(vec3_single, &ang, 1, 1);
    ksl_screwf_from_lin_ang(&lin, &ang, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(screw_from_lin_ang_single)
LOOP(screw_from_lin_ang_single, 3, DENSE_OR_ONE, 12, 12, 24, 4, 4, 4)
LOOPS(screw_from_lin_ang)

/* (6)->(6) */
OVER(screw_to_angular_first_double) {
  POINTERS_2
  EACH {
    ksl_screw_t si;
    double x[6];
    LOAD(screw_double, &si, 0, 0);
    ksl_screw_to_angular_first(&si, x);
    STORE(angular_first_double, x, 1, 1);
  }
}
STRIDED(screw_to_angular_first_double)
LOOP(screw_to_angular_first_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_to_angular_first_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t si;
    float x[6];
    LOAD(screw_single, &si, 0, 0);
    ksl_screwf_to_angular_first(&si, x);
    STORE(angular_first_single, x, 1, 1);
  }
}
STRIDED(screw_to_angular_first_single)
LOOP(screw_to_angular_first_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_to_angular_first)

/* (6)->(6) */
OVER(screw_from_angular_first_double) {
  POINTERS_2
  EACH {
    double x[6];
    ksl_screw_t so;
    LOAD(angular_first_double, x, 0, 0);
    ksl_screw_from_angular_first(x, &so);
    STORE(screw_double, &so, 1, 1);
  }
}
STRIDED(screw_from_angular_first_double)
LOOP(screw_from_angular_first_double, 2, DENSE, 48, 48, 8, 8)

OVER(screw_from_angular_first_single) {
  POINTERS_2
  EACH {
    float x[6];
    ksl_screwf_t so;
    LOAD(angular_first_single, x, 0, 0);
    ksl_screwf_from_angular_first(x, &so);
    STORE(screw_single, &so, 1, 1);
  }
}
STRIDED(screw_from_angular_first_single)
LOOP(screw_from_angular_first_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(screw_from_angular_first)

/* (6),(6)->(6) */
OVER(add_sst_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_add_sst(&s1, &s2, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(add_sst_double)
LOOP(add_sst_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_sst_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_add_sstf(&s1, &s2, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(add_sst_single)
LOOP(add_sst_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_sst)

/* (3),(6)->(6) */
OVER(product_Adts_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adts(&t, &si, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(product_Adts_double)
LOOP(product_Adts_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_Adts_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtsf(&t, &si, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(product_Adts_single)
LOOP(product_Adts_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_Adts)

/* (3),(6)->(6) */
OVER(product_Adtinvs_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adtinvs(&t, &si, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(product_Adtinvs_double)
LOOP(product_Adtinvs_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_Adtinvs_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtinvsf(&t, &si, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(product_Adtinvs_single)
LOOP(product_Adtinvs_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_Adtinvs)

/* (3),(6)->(6) */
OVER(product_Adtsinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(vec3_double, &t);
    LOAD(screw_double, &si, 1, 1);
    ksl_product_Adtsinv(&t, &si, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(product_Adtsinv_double)
LOOP(product_Adtsinv_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_Adtsinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(vec3_single, &t);
    LOAD(screw_single, &si, 1, 1);
    ksl_product_Adtsinvf(&t, &si, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(product_Adtsinv_single)
LOOP(product_Adtsinv_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_Adtsinv)

/* (3,3),(6)->(6) */
OVER(product_Adrs_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrs(&R, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Adrs_double)
LOOP(product_Adrs_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_Adrs_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrsf(&R, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Adrs_single)
LOOP(product_Adrs_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_Adrs)

/* (3,3),(6)->(6) */
OVER(product_Adrinvs_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrinvs(&R, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Adrinvs_double)
LOOP(product_Adrinvs_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_Adrinvs_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrinvsf(&R, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Adrinvs_single)
LOOP(product_Adrinvs_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_Adrinvs)

/* (3,3),(6)->(6) */
OVER(product_Adrsinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adrsinv(&R, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Adrsinv_double)
LOOP(product_Adrsinv_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_Adrsinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adrsinvf(&R, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Adrsinv_single)
LOOP(product_Adrsinv_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_Adrsinv)

/* (3,4),(6)->(6) */
OVER(product_Ads_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Ads(&D, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Ads_double)
LOOP(product_Ads_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_Ads_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adsf(&D, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Ads_single)
LOOP(product_Ads_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_Ads)

/* (3,4),(6)->(6) */
OVER(product_Adinvs_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adinvs(&D, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Adinvs_double)
LOOP(product_Adinvs_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_Adinvs_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adinvsf(&D, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Adinvs_single)
LOOP(product_Adinvs_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_Adinvs)

/* (3,4),(6)->(6) */
OVER(product_Adsinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_screw_t si;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(screw_double, &si, 1, 2);
    ksl_product_Adsinv(&D, &si, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(product_Adsinv_double)
LOOP(product_Adsinv_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_Adsinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_screwf_t si;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(screw_single, &si, 1, 2);
    ksl_product_Adsinvf(&D, &si, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(product_Adsinv_single)
LOOP(product_Adsinv_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_Adsinv)

/* (3,4)->(6) */
OVER(hstx_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hstx(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hstx_double)
LOOP(hstx_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hstx_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstxf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hstx_single)
LOOP(hstx_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hstx)

/* (3,4)->(6) */
OVER(hsty_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsty(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsty_double)
LOOP(hsty_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsty_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstyf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsty_single)
LOOP(hsty_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsty)

/* (3,4)->(6) */
OVER(hstz_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hstz(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hstz_double)
LOOP(hstz_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hstz_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstzf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hstz_single)
LOOP(hstz_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hstz)

/* (3,4)->(6) */
OVER(hsrx_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrx(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsrx_double)
LOOP(hsrx_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsrx_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrxf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsrx_single)
LOOP(hsrx_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsrx)

/* (3,4)->(6) */
OVER(hsry_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsry(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsry_double)
LOOP(hsry_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsry_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsryf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsry_single)
LOOP(hsry_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsry)

/* (3,4)->(6) */
OVER(hsrz_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrz(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsrz_double)
LOOP(hsrz_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsrz_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrzf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsrz_single)
LOOP(hsrz_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsrz)

/* (3,4)->(6) */
OVER(hstxinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hstxinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hstxinv_double)
LOOP(hstxinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hstxinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstxinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hstxinv_single)
LOOP(hstxinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hstxinv)

/* (3,4)->(6) */
OVER(hstyinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hstyinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hstyinv_double)
LOOP(hstyinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hstyinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstyinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hstyinv_single)
LOOP(hstyinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hstyinv)

/* (3,4)->(6) */
OVER(hstzinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hstzinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hstzinv_double)
LOOP(hstzinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hstzinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hstzinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hstzinv_single)
LOOP(hstzinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hstzinv)

/* (3,4)->(6) */
OVER(hsrxinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrxinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsrxinv_double)
LOOP(hsrxinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsrxinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrxinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsrxinv_single)
LOOP(hsrxinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsrxinv)

/* (3,4)->(6) */
OVER(hsryinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsryinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsryinv_double)
LOOP(hsryinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsryinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsryinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsryinv_single)
LOOP(hsryinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsryinv)

/* (3,4)->(6) */
OVER(hsrzinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hsrzinv(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED(hsrzinv_double)
LOOP(hsrzinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hsrzinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hsrzinvf(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(hsrzinv_single)
LOOP(hsrzinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hsrzinv)

/* (3,4)->(6,6) */
OVER(Ad_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat6x6_t M;
    LOAD(SE3_double, &D, 0, 0);
    ksl_Ad(&D, &M);
    STORE(mat6x6_double, &M, 1, 2);
  }
}
STRIDED(Ad_double)
LOOP(Ad_double, 2, DENSE, 96, 288, 32, 8, 48, 8)

OVER(Ad_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat6x6f_t M;
    LOAD(SE3_single, &D, 0, 0);
    ksl_Adf(&D, &M);
    STORE(mat6x6_single, &M, 1, 2);
  }
}
STRIDED(Ad_single)
LOOP(Ad_single, 2, DENSE, 48, 144, 16, 4, 24, 4)
LOOPS(Ad)

/* (6),(6)->() */
OVER(dot_cs_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c, &c);
  EACH {
    ksl_screw_t s;
    double power;
    LOAD_OTHER(coscrew_double, &c);
    LOAD(screw_double, &s, 1, 1);
    power = ksl_dot_cs(&c, &s);
    STORE(scalar_double, &power, 2, 2);
  }
}
STRIDED(dot_cs_double)
LOOP(dot_cs_double, 3, DENSE_OR_ONE, 48, 48, 8, 8, 8)

OVER(dot_cs_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c, &c);
  EACH {
    ksl_screwf_t s;
    float power;
    LOAD_OTHER(coscrew_single, &c);
    LOAD(screw_single, &s, 1, 1);
    power = ksl_dot_csf(&c, &s);
    STORE(scalar_single, &power, 2, 2);
  }
}
STRIDED(dot_cs_single)
LOOP(dot_cs_single, 3, DENSE_OR_ONE, 24, 24, 4, 4, 4)
LOOPS(dot_cs)

/* (6),(6)->(6) */
OVER(cross_ss_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_cross_ss(&s1, &s2, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(cross_ss_double)
LOOP(cross_ss_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_ss_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_cross_ssf(&s1, &s2, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(cross_ss_single)
LOOP(cross_ss_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_ss)

/* (6),(6)->(6) */
OVER(cross_sst_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s1, &s1);
  EACH {
    ksl_screw_t s2;
    ksl_screw_t so;
    LOAD_OTHER(screw_double, &s1);
    LOAD(screw_double, &s2, 1, 1);
    ksl_cross_sst(&s1, &s2, &so);
    STORE(screw_double, &so, 2, 2);
  }
}
STRIDED(cross_sst_double)
LOOP(cross_sst_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_sst_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s1, &s1);
  EACH {
    ksl_screwf_t s2;
    ksl_screwf_t so;
    LOAD_OTHER(screw_single, &s1);
    LOAD(screw_single, &s2, 1, 1);
    ksl_cross_sstf(&s1, &s2, &so);
    STORE(screw_single, &so, 2, 2);
  }
}
STRIDED(cross_sst_single)
LOOP(cross_sst_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_sst)

/* (3,4),(3)->(6) */
OVER(hsra_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsra(&D, &axis, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(hsra_double)
LOOP(hsra_double, 3, DENSE_OR_ONE, 96, 24, 48, 32, 8, 8, 8)

OVER(hsra_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hsraf(&D, &axis, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(hsra_single)
LOOP(hsra_single, 3, DENSE_OR_ONE, 48, 12, 24, 16, 4, 4, 4)
LOOPS(hsra)

/* (3,4),(3)->(6) */
OVER(hsta_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsta(&D, &axis, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(hsta_double)
LOOP(hsta_double, 3, DENSE_OR_ONE, 96, 24, 48, 32, 8, 8, 8)

OVER(hsta_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hstaf(&D, &axis, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(hsta_single)
LOOP(hsta_single, 3, DENSE_OR_ONE, 48, 12, 24, 16, 4, 4, 4)
LOOPS(hsta)

/* (3,4),(3)->(6) */
OVER(hsrainv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hsrainv(&D, &axis, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(hsrainv_double)
LOOP(hsrainv_double, 3, DENSE_OR_ONE, 96, 24, 48, 32, 8, 8, 8)

OVER(hsrainv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hsrainvf(&D, &axis, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(hsrainv_single)
LOOP(hsrainv_single, 3, DENSE_OR_ONE, 48, 12, 24, 16, 4, 4, 4)
LOOPS(hsrainv)

/* (3,4),(3)->(6) */
OVER(hstainv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t axis;
    ksl_screw_t so;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &axis, 1, 2);
    ksl_hstainv(&D, &axis, &so);
    STORE(screw_double, &so, 2, 3);
  }
}
STRIDED(hstainv_double)
LOOP(hstainv_double, 3, DENSE_OR_ONE, 96, 24, 48, 32, 8, 8, 8)

OVER(hstainv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t axis;
    ksl_screwf_t so;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &axis, 1, 2);
    ksl_hstainvf(&D, &axis, &so);
    STORE(screw_single, &so, 2, 3);
  }
}
STRIDED(hstainv_single)
LOOP(hstainv_single, 3, DENSE_OR_ONE, 48, 12, 24, 16, 4, 4, 4)
LOOPS(hstainv)

/* (6)->(6,6) */
OVER(ad_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_ad(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(ad_double)
LOOP(ad_double, 2, DENSE, 48, 288, 8, 48, 8)

OVER(ad_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_adf(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(ad_single)
LOOP(ad_single, 2, DENSE, 24, 144, 4, 24, 4)
LOOPS(ad)

const coscrew_gufunc TABLE(screw)[] = {
  {"screw_copy", "(6)->(6)",
    "so = si.\n"
    "\n"
    "(6)->(6).  si, so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", screw_copy_loops},
  {"screw_scale", "(6),()->(6)",
    "self = a self.\n"
    "\n"
    "(6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", screw_scale_loops},
  {"screw_inverted", "(6)->(6)",
    "so = -si.\n"
    "\n"
    "(6)->(6).  si, so: screw (v in m/s; ω in rad/s).\n"
    "6 neg.  Exact.\n",
   1, 1, "", screw_inverted_loops},
  {"screw_invert", "(6)->(6)",
    "self = -self.\n"
    "\n"
    "(6)->(6).  self: screw (v in m/s; ω in rad/s).\n"
    "6 neg.  Exact.\n",
   1, 1, "", screw_invert_loops},
  {"axpy_ss", "(),(6),(6)->(6)",
    "y = a x + y.\n"
    "\n"
    "(),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_ss_loops},
  {"xpy_ss", "(6),(6)->(6)",
    "y = x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_ss_loops},
  {"nxpy_ss", "(6),(6)->(6)",
    "y = -x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_ss_loops},
  {"product_as", "(),(6)->(6)",
    "so = a si.\n"
    "\n"
    "(),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_as_loops},
  {"add_ss", "(6),(6)->(6)",
    "so = s1 + s2.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_ss_loops},
  {"subtract_ss", "(6),(6)->(6)",
    "so = s1 - s2.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_ss_loops},
  {"screw_norm", "(6)->()",
    "|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).\n"
    "\n"
    "(6)->().  si: screw (v in m/s; ω in rad/s); norm: number.\n"
    "7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.\n",
   1, 1, "", screw_norm_loops},
  {"screw_normalize", "(6)->(6)",
    "self = self / |self|, with screw_norm; the zero screw stays zero.\n"
    "\n"
    "(6)->(6).  self: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", screw_normalize_loops},
  {"screw_normalized", "(6)->(6)",
    "so = si / |si|, with screw_norm; the zero screw stays zero.\n"
    "\n"
    "(6)->(6).  si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", screw_normalized_loops},
  {"screw_from_lin_ang", "(3),(3)->(6)",
    "so = (lin; ang).\n"
    "\n"
    "(3),(3)->(6).  lin, ang: vector; so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   2, 1, "", screw_from_lin_ang_loops},
  {"screw_to_angular_first", "(6)->(6)",
    "x = (ang; lin) of si.\n"
    "\n"
    "(6)->(6).  si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", screw_to_angular_first_loops},
  {"screw_from_angular_first", "(6)->(6)",
    "so = (lin; ang) of x = (ang; lin).\n"
    "\n"
    "(6)->(6).  x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", screw_from_angular_first_loops},
  {"add_sst", "(6),(6)->(6)",
    "so = (s1.lin + s2.lin ; s1.ang).\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_sst_loops},
  {"product_Adts", "(3),(6)->(6)",
    "so = [Ad](t) si.\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adts_loops},
  {"product_Adtinvs", "(3),(6)->(6)",
    "so = [Ad](t)^-1 si.\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adtinvs_loops},
  {"product_Adtsinv", "(3),(6)->(6)",
    "so = [Ad](t) (-si).\n"
    "\n"
    "(3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_Adtsinv_loops},
  {"product_Adrs", "(3,3),(6)->(6)",
    "so = [Ad](R) si.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrs_loops},
  {"product_Adrinvs", "(3,3),(6)->(6)",
    "so = [Ad](R)^-1 si.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrinvs_loops},
  {"product_Adrsinv", "(3,3),(6)->(6)",
    "so = [Ad](R) (-si).\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adrsinv_loops},
  {"product_Ads", "(3,4),(6)->(6)",
    "so = [Ad](D) si = [Ad](t) [Ad](R) si.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Ads_loops},
  {"product_Adinvs", "(3,4),(6)->(6)",
    "so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adinvs_loops},
  {"product_Adsinv", "(3,4),(6)->(6)",
    "so = [Ad](D) (-si).\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in\n"
    "rad/s).\n"
    "24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_Adsinv_loops},
  {"hstx", "(3,4)->(6)",
    "so = h_tx: column 0 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hstx_loops},
  {"hsty", "(3,4)->(6)",
    "so = h_ty: column 1 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hsty_loops},
  {"hstz", "(3,4)->(6)",
    "so = h_tz: column 2 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hstz_loops},
  {"hsrx", "(3,4)->(6)",
    "so = h_rx: column 3 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrx_loops},
  {"hsry", "(3,4)->(6)",
    "so = h_ry: column 4 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsry_loops},
  {"hsrz", "(3,4)->(6)",
    "so = h_rz: column 5 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrz_loops},
  {"hstxinv", "(3,4)->(6)",
    "so = -h_tx: -column 0 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hstxinv_loops},
  {"hstyinv", "(3,4)->(6)",
    "so = -h_ty: -column 1 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hstyinv_loops},
  {"hstzinv", "(3,4)->(6)",
    "so = -h_tz: -column 2 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hstzinv_loops},
  {"hsrxinv", "(3,4)->(6)",
    "so = -h_rx: -column 3 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrxinv_loops},
  {"hsryinv", "(3,4)->(6)",
    "so = -h_ry: -column 4 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsryinv_loops},
  {"hsrzinv", "(3,4)->(6)",
    "so = -h_rz: -column 5 of [Ad](D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hsrzinv_loops},
  {"Ad", "(3,4)->(6,6)",
    "M = [Ad](D).\n"
    "\n"
    "(3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.\n"
    "18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   1, 1, "R", Ad_loops},
  {"dot_cs", "(6),(6)->()",
    "power = f·v + τ·ω, in W.\n"
    "\n"
    "(6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.\n"
    "6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", dot_cs_loops},
  {"cross_ss", "(6),(6)->(6)",
    "so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products\n"
    "overflow.\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "18 mul, 12 add.  Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_ss_loops},
  {"cross_sst", "(6),(6)->(6)",
    "so = (ω1×v2 ; 0).\n"
    "\n"
    "(6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sst_loops},
  {"hsra", "(3,4),(3)->(6)",
    "so = (t×R a ; R a), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "15 mul, 9 add.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsra_loops},
  {"hsta", "(3,4),(3)->(6)",
    "so = (R a ; 0), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "9 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsta_loops},
  {"hsrainv", "(3,4),(3)->(6)",
    "so = -(t×R a ; R a), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "15 mul, 9 add, 3 neg.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hsrainv_loops},
  {"hstainv", "(3,4),(3)->(6)",
    "so = -(R a ; 0), a = axis in the body's frame.\n"
    "\n"
    "(3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in\n"
    "m/s; ω in rad/s).\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", hstainv_loops},
  {"ad", "(6)->(6,6)",
    "M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "6 neg.  Exact.\n",
   1, 1, "", ad_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
