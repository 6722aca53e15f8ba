/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the matrix operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/matrix_certified.h"
#include <fenv.h>

/* (3,3),(3)->(3),(3) */
OVER(product_drv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drv_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drv_double)
LOOP(product_drv_double, 4, DENSE_OR_ONE, 72, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(product_drv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drvf_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drv_single)
LOOP(product_drv_single, 4, DENSE_OR_ONE, 36, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(product_drv)

/* (3,3),(3)->(3),(3) */
OVER(product_drvinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drvinv_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvinv_double)
LOOP(product_drvinv_double, 4, DENSE_OR_ONE, 72, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(product_drvinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drvinvf_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvinv_single)
LOOP(product_drvinv_single, 4, DENSE_OR_ONE, 36, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(product_drvinv)

/* (3,3),(3)->(3),(3) */
OVER(product_drinvv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drinvv_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvv_double)
LOOP(product_drinvv_double, 4, DENSE_OR_ONE, 72, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(product_drinvv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drinvvf_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvv_single)
LOOP(product_drinvv_single, 4, DENSE_OR_ONE, 36, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(product_drinvv)

/* (3,3),(3)->(3),(3) */
OVER(product_drinvvinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drinvvinv_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvvinv_double)
LOOP(product_drinvvinv_double, 4, DENSE_OR_ONE, 72, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(product_drinvvinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drinvvinvf_certified(&R, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvvinv_single)
LOOP(product_drinvvinv_single, 4, DENSE_OR_ONE, 36, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(product_drinvvinv)

/* (3,4),(3)->(3),(3) */
OVER(product_dv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_dv_certified(&D, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dv_double)
LOOP(product_dv_double, 4, DENSE_OR_ONE, 96, 24, 24, 24, 32, 8, 8, 8, 8)

OVER(product_dv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_dvf_certified(&D, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dv_single)
LOOP(product_dv_single, 4, DENSE_OR_ONE, 48, 12, 12, 12, 16, 4, 4, 4, 4)
LOOPS(product_dv)

/* (3,4),(3)->(3),(3) */
OVER(product_dinvv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_dinvv_certified(&D, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 3);
    STORE(vec3_double, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvv_double)
LOOP(product_dinvv_double, 4, DENSE_OR_ONE, 96, 24, 24, 24, 32, 8, 8, 8, 8)

OVER(product_dinvv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_dinvvf_certified(&D, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 3);
    STORE(vec3_single, &vo_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvv_single)
LOOP(product_dinvv_single, 4, DENSE_OR_ONE, 48, 12, 12, 12, 16, 4, 4, 4, 4)
LOOPS(product_dinvv)

/* (3,3),(3,3)->(3,3),(3,3) */
OVER(product_drdr_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drdr_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 4);
    STORE(mat3x3_double, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdr_double)
LOOP(product_drdr_double, 4, DENSE_OR_ONE, 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8)

OVER(product_drdr_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drdrf_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 4);
    STORE(mat3x3_single, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdr_single)
LOOP(product_drdr_single, 4, DENSE_OR_ONE, 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4)
LOOPS(product_drdr)

/* (3,3),(3,3)->(3,3),(3,3) */
OVER(product_drdrinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drdrinv_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 4);
    STORE(mat3x3_double, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrinv_double)
LOOP(product_drdrinv_double, 4, DENSE_OR_ONE, 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8)

OVER(product_drdrinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drdrinvf_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 4);
    STORE(mat3x3_single, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrinv_single)
LOOP(product_drdrinv_single, 4, DENSE_OR_ONE, 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4)
LOOPS(product_drdrinv)

/* (3,3),(3,3)->(3,3),(3,3) */
OVER(product_drinvdr_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drinvdr_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 4);
    STORE(mat3x3_double, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvdr_double)
LOOP(product_drinvdr_double, 4, DENSE_OR_ONE, 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8)

OVER(product_drinvdr_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drinvdrf_certified(&R1, &R2, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 4);
    STORE(mat3x3_single, &Ro_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drinvdr_single)
LOOP(product_drinvdr_single, 4, DENSE_OR_ONE, 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4)
LOOPS(product_drinvdr)

/* (3,4),(3,4)->(3,4),(3,4) */
OVER(product_dd_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_dd_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 4);
    STORE(SE3_double, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dd_double)
LOOP(product_dd_double, 4, DENSE_OR_ONE, 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8)

OVER(product_dd_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_ddf_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 4);
    STORE(SE3_single, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dd_single)
LOOP(product_dd_single, 4, DENSE_OR_ONE, 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4)
LOOPS(product_dd)

/* (3,4),(3,4)->(3,4),(3,4) */
OVER(product_ddinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_ddinv_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 4);
    STORE(SE3_double, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddinv_double)
LOOP(product_ddinv_double, 4, DENSE_OR_ONE, 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8)

OVER(product_ddinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_ddinvf_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 4);
    STORE(SE3_single, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddinv_single)
LOOP(product_ddinv_single, 4, DENSE_OR_ONE, 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddinv)

/* (3,4),(3,4)->(3,4),(3,4) */
OVER(product_dinvd_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_dinvd_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 4);
    STORE(SE3_double, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvd_double)
LOOP(product_dinvd_double, 4, DENSE_OR_ONE, 96, 96, 96, 96, 32, 8, 32, 8, 32, 8, 32, 8)

OVER(product_dinvd_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_dinvdf_certified(&D1, &D2, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 4);
    STORE(SE3_single, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvd_single)
LOOP(product_dinvd_single, 4, DENSE_OR_ONE, 48, 48, 48, 48, 16, 4, 16, 4, 16, 4, 16, 4)
LOOPS(product_dinvd)

/* (3,4),(3,3)->(3,4),(3,4) */
OVER(product_ddr_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(mat3x3_double, &R, 1, 2);
    ksl_product_ddr_certified(&D, &R, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 4);
    STORE(SE3_double, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddr_double)
LOOP(product_ddr_double, 4, DENSE_OR_ONE, 96, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8)

OVER(product_ddr_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(mat3x3_single, &R, 1, 2);
    ksl_product_ddrf_certified(&D, &R, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 4);
    STORE(SE3_single, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddr_single)
LOOP(product_ddr_single, 4, DENSE_OR_ONE, 48, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4)
LOOPS(product_ddr)

/* (3,4),(3,3)->(3,4),(3,4) */
OVER(product_ddrinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(mat3x3_double, &R, 1, 2);
    ksl_product_ddrinv_certified(&D, &R, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 4);
    STORE(SE3_double, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrinv_double)
LOOP(product_ddrinv_double, 4, DENSE_OR_ONE, 96, 72, 96, 96, 32, 8, 24, 8, 32, 8, 32, 8)

OVER(product_ddrinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(mat3x3_single, &R, 1, 2);
    ksl_product_ddrinvf_certified(&D, &R, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 4);
    STORE(SE3_single, &Do_bound, 3, 6);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrinv_single)
LOOP(product_ddrinv_single, 4, DENSE_OR_ONE, 48, 36, 48, 48, 16, 4, 12, 4, 16, 4, 16, 4)
LOOPS(product_ddrinv)

/* (3,4),(3)->(3,4),(3,4) */
OVER(product_ddt_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_ddt_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddt_double)
LOOP(product_ddt_double, 4, DENSE_OR_ONE, 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddt_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_ddtf_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddt_single)
LOOP(product_ddt_single, 4, DENSE_OR_ONE, 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddt)

/* (3,4),(3)->(3,4),(3,4) */
OVER(product_ddtinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_ddtinv_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtinv_double)
LOOP(product_ddtinv_double, 4, DENSE_OR_ONE, 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddtinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_ddtinvf_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtinv_single)
LOOP(product_ddtinv_single, 4, DENSE_OR_ONE, 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddtinv)

/* (3,4),(3)->(3,4),(3,4) */
OVER(product_dinvdt_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_dinvdt_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvdt_double)
LOOP(product_dinvdt_double, 4, DENSE_OR_ONE, 96, 24, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_dinvdt_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_dinvdtf_certified(&D, &t, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_dinvdt_single)
LOOP(product_dinvdt_single, 4, DENSE_OR_ONE, 48, 12, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_dinvdt)

/* (3,3),()->(3),(3) */
OVER(product_drvtx_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtx_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtx_double)
LOOP(product_drvtx_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvtx_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtxf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtx_single)
LOOP(product_drvtx_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvtx)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdrx_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrx_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrx_double)
LOOP(product_drdrx_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdrx_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrxf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrx_single)
LOOP(product_drdrx_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdrx)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddrx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrx_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrx_double)
LOOP(product_ddrx_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddrx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrxf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrx_single)
LOOP(product_ddrx_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddrx)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddtx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtx_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtx_double)
LOOP(product_ddtx_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddtx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtxf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtx_single)
LOOP(product_ddtx_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddtx)

/* (3,3),()->(3),(3) */
OVER(product_drvtxinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtxinv_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtxinv_double)
LOOP(product_drvtxinv_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvtxinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtxinvf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtxinv_single)
LOOP(product_drvtxinv_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvtxinv)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdrxinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrxinv_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrxinv_double)
LOOP(product_drdrxinv_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdrxinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrxinvf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrxinv_single)
LOOP(product_drdrxinv_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdrxinv)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddrxinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrxinv_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrxinv_double)
LOOP(product_ddrxinv_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddrxinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrxinvf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrxinv_single)
LOOP(product_ddrxinv_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddrxinv)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddtxinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtxinv_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtxinv_double)
LOOP(product_ddtxinv_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddtxinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtxinvf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtxinv_single)
LOOP(product_ddtxinv_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddtxinv)

/* (3,3),()->(3),(3) */
OVER(product_drvty_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvty_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvty_double)
LOOP(product_drvty_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvty_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtyf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvty_single)
LOOP(product_drvty_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvty)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdry_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdry_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdry_double)
LOOP(product_drdry_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdry_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdryf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdry_single)
LOOP(product_drdry_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdry)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddry_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddry_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddry_double)
LOOP(product_ddry_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddry_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddryf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddry_single)
LOOP(product_ddry_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddry)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddty_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddty_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddty_double)
LOOP(product_ddty_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddty_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtyf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddty_single)
LOOP(product_ddty_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddty)

/* (3,3),()->(3),(3) */
OVER(product_drvtyinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtyinv_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtyinv_double)
LOOP(product_drvtyinv_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvtyinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtyinvf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtyinv_single)
LOOP(product_drvtyinv_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvtyinv)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdryinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdryinv_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdryinv_double)
LOOP(product_drdryinv_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdryinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdryinvf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdryinv_single)
LOOP(product_drdryinv_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdryinv)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddryinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddryinv_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddryinv_double)
LOOP(product_ddryinv_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddryinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddryinvf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddryinv_single)
LOOP(product_ddryinv_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddryinv)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddtyinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtyinv_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtyinv_double)
LOOP(product_ddtyinv_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddtyinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtyinvf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtyinv_single)
LOOP(product_ddtyinv_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddtyinv)

/* (3,3),()->(3),(3) */
OVER(product_drvtz_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtz_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtz_double)
LOOP(product_drvtz_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvtz_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtzf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtz_single)
LOOP(product_drvtz_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvtz)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdrz_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrz_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrz_double)
LOOP(product_drdrz_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdrz_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrzf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrz_single)
LOOP(product_drdrz_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdrz)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddrz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrz_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrz_double)
LOOP(product_ddrz_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddrz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrzf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrz_single)
LOOP(product_ddrz_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddrz)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddtz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtz_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtz_double)
LOOP(product_ddtz_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddtz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtzf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtz_single)
LOOP(product_ddtz_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddtz)

/* (3,3),()->(3),(3) */
OVER(product_drvtzinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtzinv_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtzinv_double)
LOOP(product_drvtzinv_double, 4, DENSE_OR_ONE, 72, 8, 24, 24, 24, 8, 8, 8)

OVER(product_drvtzinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtzinvf_certified(&R, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drvtzinv_single)
LOOP(product_drvtzinv_single, 4, DENSE_OR_ONE, 36, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvtzinv)

/* (3,3),(2)->(3,3),(3,3) */
OVER(product_drdrzinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrzinv_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 3);
    STORE(mat3x3_double, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrzinv_double)
LOOP(product_drdrzinv_double, 4, DENSE_OR_ONE, 72, 16, 72, 72, 24, 8, 8, 24, 8, 24, 8)

OVER(product_drdrzinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrzinvf_certified(&R, dc, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 3);
    STORE(mat3x3_single, &Ro_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_drdrzinv_single)
LOOP(product_drdrzinv_single, 4, DENSE_OR_ONE, 36, 8, 36, 36, 12, 4, 4, 12, 4, 12, 4)
LOOPS(product_drdrzinv)

/* (3,4),(2)->(3,4),(3,4) */
OVER(product_ddrzinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrzinv_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 3);
    STORE(SE3_double, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrzinv_double)
LOOP(product_ddrzinv_double, 4, DENSE_OR_ONE, 96, 16, 96, 96, 32, 8, 8, 32, 8, 32, 8)

OVER(product_ddrzinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrzinvf_certified(&D, dc, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 3);
    STORE(SE3_single, &Do_bound, 3, 5);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddrzinv_single)
LOOP(product_ddrzinv_single, 4, DENSE_OR_ONE, 48, 8, 48, 48, 16, 4, 4, 16, 4, 16, 4)
LOOPS(product_ddrzinv)

/* (3,4),()->(3,4),(3,4) */
OVER(product_ddtzinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    ksl_SE3_t Do_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtzinv_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_double, &Do, 2, 2);
    STORE(SE3_double, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtzinv_double)
LOOP(product_ddtzinv_double, 4, DENSE_OR_ONE, 96, 8, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddtzinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    ksl_SE3f_t Do_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtzinvf_certified(&D, k, &Do, &Do_bound);
    STORE(SE3_single, &Do, 2, 2);
    STORE(SE3_single, &Do_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ddtzinv_single)
LOOP(product_ddtzinv_single, 4, DENSE_OR_ONE, 48, 4, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddtzinv)

const coscrew_gufunc TABLE(matrix)[] = {
  {"product_drv", "(3,3),(3)->(3),(3)",
    "vo = R v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 9 abs.\n",
   2, 2, "", product_drv_loops},
  {"product_drvinv", "(3,3),(3)->(3),(3)",
    "vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_drvinv_loops},
  {"product_drinvv", "(3,3),(3)->(3),(3)",
    "vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 9 abs.\n",
   2, 2, "", product_drinvv_loops},
  {"product_drinvvinv", "(3,3),(3)->(3),(3)",
    "vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.\n"
    "12 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_drinvvinv_loops},
  {"product_dv", "(3,4),(3)->(3),(3)",
    "vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_dv_loops},
  {"product_dinvv", "(3,4),(3)->(3),(3)",
    "vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.\n"
    "21 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_dinvv_loops},
  {"product_drdr", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drdr_loops},
  {"product_drdrinv", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drdrinv_loops},
  {"product_drinvdr", "(3,3),(3,3)->(3,3),(3,3)",
    "Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "", product_drinvdr_loops},
  {"product_dd", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "48 mul, 66 add, 39 abs.\n",
   2, 2, "RR", product_dd_loops},
  {"product_ddinv", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "57 mul, 66 add, 33 abs.\n",
   2, 2, "RR", product_ddinv_loops},
  {"product_dinvd", "(3,4),(3,4)->(3,4),(3,4)",
    "Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.\n"
    "57 mul, 63 add, 39 abs.\n",
   2, 2, "RR", product_dinvd_loops},
  {"product_ddr", "(3,4),(3,3)->(3,4),(3,4)",
    "Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:\n"
    "rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "RR", product_ddr_loops},
  {"product_ddrinv", "(3,4),(3,3)->(3,4),(3,4)",
    "Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:\n"
    "rotation or other 3×3 matrix.\n"
    "36 mul, 45 add, 27 abs.\n",
   2, 2, "RR", product_ddrinv_loops},
  {"product_ddt", "(3,4),(3)->(3,4),(3,4)",
    "Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_ddt_loops},
  {"product_ddtinv", "(3,4),(3)->(3,4),(3,4)",
    "Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "12 mul, 21 add, 12 abs.\n",
   2, 2, "R.", product_ddtinv_loops},
  {"product_dinvdt", "(3,4),(3)->(3,4),(3,4)",
    "Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:\n"
    "vector.\n"
    "21 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_dinvdt_loops},
  {"product_drvtx", "(3,3),()->(3),(3)",
    "vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvtx_loops},
  {"product_drdrx", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrx_loops},
  {"product_ddrx", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrx_loops},
  {"product_ddtx", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtx_loops},
  {"product_drvtxinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtxinv_loops},
  {"product_drdrxinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrxinv_loops},
  {"product_ddrxinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrxinv_loops},
  {"product_ddtxinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtxinv_loops},
  {"product_drvty", "(3,3),()->(3),(3)",
    "vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvty_loops},
  {"product_drdry", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdry_loops},
  {"product_ddry", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddry_loops},
  {"product_ddty", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddty_loops},
  {"product_drvtyinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtyinv_loops},
  {"product_drdryinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdryinv_loops},
  {"product_ddryinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddryinv_loops},
  {"product_ddtyinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtyinv_loops},
  {"product_drvtz", "(3,3),()->(3),(3)",
    "vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_drvtz_loops},
  {"product_drdrz", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrz_loops},
  {"product_ddrz", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrz_loops},
  {"product_ddtz", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtz_loops},
  {"product_drvtzinv", "(3,3),()->(3),(3)",
    "vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_drvtzinv_loops},
  {"product_drdrzinv", "(3,3),(2)->(3,3),(3,3)",
    "Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "", product_drdrzinv_loops},
  {"product_ddrzinv", "(3,4),(2)->(3,4),(3,4)",
    "Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin\n"
    "θ, cos θ).\n"
    "18 mul, 18 add, 12 abs.\n",
   2, 2, "R.", product_ddrzinv_loops},
  {"product_ddtzinv", "(3,4),()->(3,4),(3,4)",
    "Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.\n"
    "\n"
    "(3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:\n"
    "number.\n"
    "6 mul, 9 add, 6 abs.\n",
   2, 2, "R.", product_ddtzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
