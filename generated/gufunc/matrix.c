/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the matrix operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/matrix.h"

/* (3,3),(3)->(3) */
OVER(product_drv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drv(&R, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_drv_double)
LOOP(product_drv_double, 3, DENSE_OR_ONE, 72, 24, 24, 24, 8, 8, 8)

OVER(product_drv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drvf(&R, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_drv_single)
LOOP(product_drv_single, 3, DENSE_OR_ONE, 36, 12, 12, 12, 4, 4, 4)
LOOPS(product_drv)

/* (3,3),(3)->(3) */
OVER(product_drvinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drvinv(&R, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_drvinv_double)
LOOP(product_drvinv_double, 3, DENSE_OR_ONE, 72, 24, 24, 24, 8, 8, 8)

OVER(product_drvinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drvinvf(&R, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_drvinv_single)
LOOP(product_drvinv_single, 3, DENSE_OR_ONE, 36, 12, 12, 12, 4, 4, 4)
LOOPS(product_drvinv)

/* (3,3),(3)->(3) */
OVER(product_drinvv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drinvv(&R, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_drinvv_double)
LOOP(product_drinvv_double, 3, DENSE_OR_ONE, 72, 24, 24, 24, 8, 8, 8)

OVER(product_drinvv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drinvvf(&R, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_drinvv_single)
LOOP(product_drinvv_single, 3, DENSE_OR_ONE, 36, 12, 12, 12, 4, 4, 4)
LOOPS(product_drinvv)

/* (3,3),(3)->(3) */
OVER(product_drinvvinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_drinvvinv(&R, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_drinvvinv_double)
LOOP(product_drinvvinv_double, 3, DENSE_OR_ONE, 72, 24, 24, 24, 8, 8, 8)

OVER(product_drinvvinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_drinvvinvf(&R, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_drinvvinv_single)
LOOP(product_drinvvinv_single, 3, DENSE_OR_ONE, 36, 12, 12, 12, 4, 4, 4)
LOOPS(product_drinvvinv)

/* (3,4),(3)->(3) */
OVER(product_dv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_dv(&D, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_dv_double)
LOOP(product_dv_double, 3, DENSE_OR_ONE, 96, 24, 24, 32, 8, 8, 8)

OVER(product_dv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_dvf(&D, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_dv_single)
LOOP(product_dv_single, 3, DENSE_OR_ONE, 48, 12, 12, 16, 4, 4, 4)
LOOPS(product_dv)

/* (3,4),(3)->(3) */
OVER(product_dinvv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &v, 1, 2);
    ksl_product_dinvv(&D, &v, &vo);
    STORE(vec3_double, &vo, 2, 3);
  }
}
STRIDED(product_dinvv_double)
LOOP(product_dinvv_double, 3, DENSE_OR_ONE, 96, 24, 24, 32, 8, 8, 8)

OVER(product_dinvv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &v, 1, 2);
    ksl_product_dinvvf(&D, &v, &vo);
    STORE(vec3_single, &vo, 2, 3);
  }
}
STRIDED(product_dinvv_single)
LOOP(product_dinvv_single, 3, DENSE_OR_ONE, 48, 12, 12, 16, 4, 4, 4)
LOOPS(product_dinvv)

/* (3,3),(3,3)->(3,3) */
OVER(product_drdr_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drdr(&R1, &R2, &Ro);
    STORE(mat3x3_double, &Ro, 2, 4);
  }
}
STRIDED(product_drdr_double)
LOOP(product_drdr_double, 3, DENSE_OR_ONE, 72, 72, 72, 24, 8, 24, 8, 24, 8)

OVER(product_drdr_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drdrf(&R1, &R2, &Ro);
    STORE(mat3x3_single, &Ro, 2, 4);
  }
}
STRIDED(product_drdr_single)
LOOP(product_drdr_single, 3, DENSE_OR_ONE, 36, 36, 36, 12, 4, 12, 4, 12, 4)
LOOPS(product_drdr)

/* (3,3),(3,3)->(3,3) */
OVER(product_drdrinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drdrinv(&R1, &R2, &Ro);
    STORE(mat3x3_double, &Ro, 2, 4);
  }
}
STRIDED(product_drdrinv_double)
LOOP(product_drdrinv_double, 3, DENSE_OR_ONE, 72, 72, 72, 24, 8, 24, 8, 24, 8)

OVER(product_drdrinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drdrinvf(&R1, &R2, &Ro);
    STORE(mat3x3_single, &Ro, 2, 4);
  }
}
STRIDED(product_drdrinv_single)
LOOP(product_drdrinv_single, 3, DENSE_OR_ONE, 36, 36, 36, 12, 4, 12, 4, 12, 4)
LOOPS(product_drdrinv)

/* (3,3),(3,3)->(3,3) */
OVER(product_drinvdr_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R1, &R1);
  EACH {
    ksl_mat3x3_t R2;
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R1);
    LOAD(mat3x3_double, &R2, 1, 2);
    ksl_product_drinvdr(&R1, &R2, &Ro);
    STORE(mat3x3_double, &Ro, 2, 4);
  }
}
STRIDED(product_drinvdr_double)
LOOP(product_drinvdr_double, 3, DENSE_OR_ONE, 72, 72, 72, 24, 8, 24, 8, 24, 8)

OVER(product_drinvdr_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R1, &R1);
  EACH {
    ksl_mat3x3f_t R2;
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R1);
    LOAD(mat3x3_single, &R2, 1, 2);
    ksl_product_drinvdrf(&R1, &R2, &Ro);
    STORE(mat3x3_single, &Ro, 2, 4);
  }
}
STRIDED(product_drinvdr_single)
LOOP(product_drinvdr_single, 3, DENSE_OR_ONE, 36, 36, 36, 12, 4, 12, 4, 12, 4)
LOOPS(product_drinvdr)

/* (3,4),(3,4)->(3,4) */
OVER(product_dd_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_dd(&D1, &D2, &Do);
    STORE(SE3_double, &Do, 2, 4);
  }
}
STRIDED(product_dd_double)
LOOP(product_dd_double, 3, DENSE_OR_ONE, 96, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_dd_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_ddf(&D1, &D2, &Do);
    STORE(SE3_single, &Do, 2, 4);
  }
}
STRIDED(product_dd_single)
LOOP(product_dd_single, 3, DENSE_OR_ONE, 48, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_dd)

/* (3,4),(3,4)->(3,4) */
OVER(product_ddinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_ddinv(&D1, &D2, &Do);
    STORE(SE3_double, &Do, 2, 4);
  }
}
STRIDED(product_ddinv_double)
LOOP(product_ddinv_double, 3, DENSE_OR_ONE, 96, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_ddinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_ddinvf(&D1, &D2, &Do);
    STORE(SE3_single, &Do, 2, 4);
  }
}
STRIDED(product_ddinv_single)
LOOP(product_ddinv_single, 3, DENSE_OR_ONE, 48, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_ddinv)

/* (3,4),(3,4)->(3,4) */
OVER(product_dinvd_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    ksl_product_dinvd(&D1, &D2, &Do);
    STORE(SE3_double, &Do, 2, 4);
  }
}
STRIDED(product_dinvd_double)
LOOP(product_dinvd_double, 3, DENSE_OR_ONE, 96, 96, 96, 32, 8, 32, 8, 32, 8)

OVER(product_dinvd_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    ksl_product_dinvdf(&D1, &D2, &Do);
    STORE(SE3_single, &Do, 2, 4);
  }
}
STRIDED(product_dinvd_single)
LOOP(product_dinvd_single, 3, DENSE_OR_ONE, 48, 48, 48, 16, 4, 16, 4, 16, 4)
LOOPS(product_dinvd)

/* (3,4),(3,3)->(3,4) */
OVER(product_ddr_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(mat3x3_double, &R, 1, 2);
    ksl_product_ddr(&D, &R, &Do);
    STORE(SE3_double, &Do, 2, 4);
  }
}
STRIDED(product_ddr_double)
LOOP(product_ddr_double, 3, DENSE_OR_ONE, 96, 72, 96, 32, 8, 24, 8, 32, 8)

OVER(product_ddr_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(mat3x3_single, &R, 1, 2);
    ksl_product_ddrf(&D, &R, &Do);
    STORE(SE3_single, &Do, 2, 4);
  }
}
STRIDED(product_ddr_single)
LOOP(product_ddr_single, 3, DENSE_OR_ONE, 48, 36, 48, 16, 4, 12, 4, 16, 4)
LOOPS(product_ddr)

/* (3,4),(3,3)->(3,4) */
OVER(product_ddrinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_mat3x3_t R;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(mat3x3_double, &R, 1, 2);
    ksl_product_ddrinv(&D, &R, &Do);
    STORE(SE3_double, &Do, 2, 4);
  }
}
STRIDED(product_ddrinv_double)
LOOP(product_ddrinv_double, 3, DENSE_OR_ONE, 96, 72, 96, 32, 8, 24, 8, 32, 8)

OVER(product_ddrinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_mat3x3f_t R;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(mat3x3_single, &R, 1, 2);
    ksl_product_ddrinvf(&D, &R, &Do);
    STORE(SE3_single, &Do, 2, 4);
  }
}
STRIDED(product_ddrinv_single)
LOOP(product_ddrinv_single, 3, DENSE_OR_ONE, 48, 36, 48, 16, 4, 12, 4, 16, 4)
LOOPS(product_ddrinv)

/* (3,4),(3)->(3,4) */
OVER(product_ddt_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_ddt(&D, &t, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddt_double)
LOOP(product_ddt_double, 3, DENSE_OR_ONE, 96, 24, 96, 32, 8, 8, 32, 8)

OVER(product_ddt_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_ddtf(&D, &t, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddt_single)
LOOP(product_ddt_single, 3, DENSE_OR_ONE, 48, 12, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddt)

/* (3,4),(3)->(3,4) */
OVER(product_ddtinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_ddtinv(&D, &t, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddtinv_double)
LOOP(product_ddtinv_double, 3, DENSE_OR_ONE, 96, 24, 96, 32, 8, 8, 32, 8)

OVER(product_ddtinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_ddtinvf(&D, &t, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddtinv_single)
LOOP(product_ddtinv_single, 3, DENSE_OR_ONE, 48, 12, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddtinv)

/* (3,4),(3)->(3,4) */
OVER(product_dinvdt_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_vec3_t t;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(vec3_double, &t, 1, 2);
    ksl_product_dinvdt(&D, &t, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_dinvdt_double)
LOOP(product_dinvdt_double, 3, DENSE_OR_ONE, 96, 24, 96, 32, 8, 8, 32, 8)

OVER(product_dinvdt_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_vec3f_t t;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(vec3_single, &t, 1, 2);
    ksl_product_dinvdtf(&D, &t, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_dinvdt_single)
LOOP(product_dinvdt_single, 3, DENSE_OR_ONE, 48, 12, 48, 16, 4, 4, 16, 4)
LOOPS(product_dinvdt)

/* (3,3),()->(3) */
OVER(product_drvtx_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtx(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvtx_double)
LOOP(product_drvtx_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvtx_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtxf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvtx_single)
LOOP(product_drvtx_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvtx)

/* (3,3),(2)->(3,3) */
OVER(product_drdrx_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrx(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdrx_double)
LOOP(product_drdrx_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdrx_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrxf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdrx_single)
LOOP(product_drdrx_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdrx)

/* (3,4),(2)->(3,4) */
OVER(product_ddrx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrx(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddrx_double)
LOOP(product_ddrx_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddrx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrxf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddrx_single)
LOOP(product_ddrx_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddrx)

/* (3,4),()->(3,4) */
OVER(product_ddtx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtx(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddtx_double)
LOOP(product_ddtx_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddtx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtxf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddtx_single)
LOOP(product_ddtx_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddtx)

/* (3,3),()->(3) */
OVER(product_drvtxinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtxinv(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvtxinv_double)
LOOP(product_drvtxinv_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvtxinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtxinvf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvtxinv_single)
LOOP(product_drvtxinv_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvtxinv)

/* (3,3),(2)->(3,3) */
OVER(product_drdrxinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrxinv(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdrxinv_double)
LOOP(product_drdrxinv_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdrxinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrxinvf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdrxinv_single)
LOOP(product_drdrxinv_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdrxinv)

/* (3,4),(2)->(3,4) */
OVER(product_ddrxinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrxinv(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddrxinv_double)
LOOP(product_ddrxinv_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddrxinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrxinvf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddrxinv_single)
LOOP(product_ddrxinv_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddrxinv)

/* (3,4),()->(3,4) */
OVER(product_ddtxinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtxinv(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddtxinv_double)
LOOP(product_ddtxinv_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddtxinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtxinvf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddtxinv_single)
LOOP(product_ddtxinv_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddtxinv)

/* (3,3),()->(3) */
OVER(product_drvty_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvty(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvty_double)
LOOP(product_drvty_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvty_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtyf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvty_single)
LOOP(product_drvty_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvty)

/* (3,3),(2)->(3,3) */
OVER(product_drdry_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdry(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdry_double)
LOOP(product_drdry_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdry_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdryf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdry_single)
LOOP(product_drdry_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdry)

/* (3,4),(2)->(3,4) */
OVER(product_ddry_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddry(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddry_double)
LOOP(product_ddry_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddry_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddryf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddry_single)
LOOP(product_ddry_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddry)

/* (3,4),()->(3,4) */
OVER(product_ddty_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddty(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddty_double)
LOOP(product_ddty_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddty_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtyf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddty_single)
LOOP(product_ddty_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddty)

/* (3,3),()->(3) */
OVER(product_drvtyinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtyinv(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvtyinv_double)
LOOP(product_drvtyinv_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvtyinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtyinvf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvtyinv_single)
LOOP(product_drvtyinv_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvtyinv)

/* (3,3),(2)->(3,3) */
OVER(product_drdryinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdryinv(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdryinv_double)
LOOP(product_drdryinv_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdryinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdryinvf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdryinv_single)
LOOP(product_drdryinv_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdryinv)

/* (3,4),(2)->(3,4) */
OVER(product_ddryinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddryinv(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddryinv_double)
LOOP(product_ddryinv_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddryinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddryinvf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddryinv_single)
LOOP(product_ddryinv_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddryinv)

/* (3,4),()->(3,4) */
OVER(product_ddtyinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtyinv(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddtyinv_double)
LOOP(product_ddtyinv_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddtyinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtyinvf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddtyinv_single)
LOOP(product_ddtyinv_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddtyinv)

/* (3,3),()->(3) */
OVER(product_drvtz_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtz(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvtz_double)
LOOP(product_drvtz_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvtz_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtzf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvtz_single)
LOOP(product_drvtz_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvtz)

/* (3,3),(2)->(3,3) */
OVER(product_drdrz_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrz(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdrz_double)
LOOP(product_drdrz_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdrz_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrzf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdrz_single)
LOOP(product_drdrz_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdrz)

/* (3,4),(2)->(3,4) */
OVER(product_ddrz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrz(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddrz_double)
LOOP(product_ddrz_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddrz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrzf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddrz_single)
LOOP(product_ddrz_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddrz)

/* (3,4),()->(3,4) */
OVER(product_ddtz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtz(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddtz_double)
LOOP(product_ddtz_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddtz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtzf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddtz_single)
LOOP(product_ddtz_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddtz)

/* (3,3),()->(3) */
OVER(product_drvtzinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_drvtzinv(&R, k, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(product_drvtzinv_double)
LOOP(product_drvtzinv_double, 3, DENSE_OR_ONE, 72, 8, 24, 24, 8, 8)

OVER(product_drvtzinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_drvtzinvf(&R, k, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(product_drvtzinv_single)
LOOP(product_drvtzinv_single, 3, DENSE_OR_ONE, 36, 4, 12, 12, 4, 4)
LOOPS(product_drvtzinv)

/* (3,3),(2)->(3,3) */
OVER(product_drdrzinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    double dc[2];
    ksl_mat3x3_t Ro;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_drdrzinv(&R, dc, &Ro);
    STORE(mat3x3_double, &Ro, 2, 3);
  }
}
STRIDED(product_drdrzinv_double)
LOOP(product_drdrzinv_double, 3, DENSE_OR_ONE, 72, 16, 72, 24, 8, 8, 24, 8)

OVER(product_drdrzinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    float dc[2];
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_drdrzinvf(&R, dc, &Ro);
    STORE(mat3x3_single, &Ro, 2, 3);
  }
}
STRIDED(product_drdrzinv_single)
LOOP(product_drdrzinv_single, 3, DENSE_OR_ONE, 36, 8, 36, 12, 4, 4, 12, 4)
LOOPS(product_drdrzinv)

/* (3,4),(2)->(3,4) */
OVER(product_ddrzinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double dc[2];
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(dc_double, dc, 1, 2);
    ksl_product_ddrzinv(&D, dc, &Do);
    STORE(SE3_double, &Do, 2, 3);
  }
}
STRIDED(product_ddrzinv_double)
LOOP(product_ddrzinv_double, 3, DENSE_OR_ONE, 96, 16, 96, 32, 8, 8, 32, 8)

OVER(product_ddrzinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float dc[2];
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(dc_single, dc, 1, 2);
    ksl_product_ddrzinvf(&D, dc, &Do);
    STORE(SE3_single, &Do, 2, 3);
  }
}
STRIDED(product_ddrzinv_single)
LOOP(product_ddrzinv_single, 3, DENSE_OR_ONE, 48, 8, 48, 16, 4, 4, 16, 4)
LOOPS(product_ddrzinv)

/* (3,4),()->(3,4) */
OVER(product_ddtzinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D);
    LOAD(scalar_double, &k, 1, 2);
    ksl_product_ddtzinv(&D, k, &Do);
    STORE(SE3_double, &Do, 2, 2);
  }
}
STRIDED(product_ddtzinv_double)
LOOP(product_ddtzinv_double, 3, DENSE_OR_ONE, 96, 8, 96, 32, 8, 32, 8)

OVER(product_ddtzinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D);
    LOAD(scalar_single, &k, 1, 2);
    ksl_product_ddtzinvf(&D, k, &Do);
    STORE(SE3_single, &Do, 2, 2);
  }
}
STRIDED(product_ddtzinv_single)
LOOP(product_ddtzinv_single, 3, DENSE_OR_ONE, 48, 4, 48, 16, 4, 16, 4)
LOOPS(product_ddtzinv)

const coscrew_gufunc TABLE(matrix)[] = {
  {"product_drv", "(3,3),(3)->(3)",
    "vo = R v.\n"
    "\n"
    "(3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.\n"
    "9 mul, 6 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drv_loops},
  {"product_drvinv", "(3,3),(3)->(3)",
    "vo = R (-v).\n"
    "\n"
    "(3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drvinv_loops},
  {"product_drinvv", "(3,3),(3)->(3)",
    "vo = R^T v.\n"
    "\n"
    "(3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.\n"
    "9 mul, 6 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drinvv_loops},
  {"product_drinvvinv", "(3,3),(3)->(3)",
    "vo = R^T (-v).\n"
    "\n"
    "(3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.\n"
    "9 mul, 6 add, 3 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drinvvinv_loops},
  {"product_dv", "(3,4),(3)->(3)",
    "vo = R v + t.\n"
    "\n"
    "(3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.\n"
    "9 mul, 9 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_dv_loops},
  {"product_dinvv", "(3,4),(3)->(3)",
    "vo = R^T (v - t).\n"
    "\n"
    "(3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.\n"
    "9 mul, 9 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_dinvv_loops},
  {"product_drdr", "(3,3),(3,3)->(3,3)",
    "Ro = R1 R2.\n"
    "\n"
    "(3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.\n"
    "27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdr_loops},
  {"product_drdrinv", "(3,3),(3,3)->(3,3)",
    "Ro = R1 R2^T.\n"
    "\n"
    "(3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.\n"
    "27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdrinv_loops},
  {"product_drinvdr", "(3,3),(3,3)->(3,3)",
    "Ro = R1^T R2.\n"
    "\n"
    "(3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.\n"
    "27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drinvdr_loops},
  {"product_dd", "(3,4),(3,4)->(3,4)",
    "Do = D1 D2 = [R1 R2 | R1 t2 + t1].\n"
    "\n"
    "(3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.\n"
    "36 mul, 27 add.  Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "RR", product_dd_loops},
  {"product_ddinv", "(3,4),(3,4)->(3,4)",
    "Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.\n"
    "\n"
    "(3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.\n"
    "36 mul, 27 add.  Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "RR", product_ddinv_loops},
  {"product_dinvd", "(3,4),(3,4)->(3,4)",
    "Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].\n"
    "\n"
    "(3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.\n"
    "36 mul, 27 add.  Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "RR", product_dinvd_loops},
  {"product_ddr", "(3,4),(3,3)->(3,4)",
    "Do = D [R | 0].\n"
    "\n"
    "(3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other\n"
    "3×3 matrix.\n"
    "27 mul, 18 add.  Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "RR", product_ddr_loops},
  {"product_ddrinv", "(3,4),(3,3)->(3,4)",
    "Do = D [R^T | 0].\n"
    "\n"
    "(3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other\n"
    "3×3 matrix.\n"
    "27 mul, 18 add.  Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "RR", product_ddrinv_loops},
  {"product_ddt", "(3,4),(3)->(3,4)",
    "Do = D [I | t].\n"
    "\n"
    "(3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.\n"
    "9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddt_loops},
  {"product_ddtinv", "(3,4),(3)->(3,4)",
    "Do = D [I | -t].\n"
    "\n"
    "(3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.\n"
    "9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtinv_loops},
  {"product_dinvdt", "(3,4),(3)->(3,4)",
    "Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].\n"
    "\n"
    "(3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.\n"
    "9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_dinvdt_loops},
  {"product_drvtx", "(3,3),()->(3)",
    "vo = R (k e_x).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvtx_loops},
  {"product_drdrx", "(3,3),(2)->(3,3)",
    "Ro = R R_x(θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdrx_loops},
  {"product_ddrx", "(3,4),(2)->(3,4)",
    "Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddrx_loops},
  {"product_ddtx", "(3,4),()->(3,4)",
    "Do = D [I | k e_x].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtx_loops},
  {"product_drvtxinv", "(3,3),()->(3)",
    "vo = R (-k e_x).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvtxinv_loops},
  {"product_drdrxinv", "(3,3),(2)->(3,3)",
    "Ro = R R_x(-θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdrxinv_loops},
  {"product_ddrxinv", "(3,4),(2)->(3,4)",
    "Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddrxinv_loops},
  {"product_ddtxinv", "(3,4),()->(3,4)",
    "Do = D [I | -k e_x].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtxinv_loops},
  {"product_drvty", "(3,3),()->(3)",
    "vo = R (k e_y).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvty_loops},
  {"product_drdry", "(3,3),(2)->(3,3)",
    "Ro = R R_y(θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdry_loops},
  {"product_ddry", "(3,4),(2)->(3,4)",
    "Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddry_loops},
  {"product_ddty", "(3,4),()->(3,4)",
    "Do = D [I | k e_y].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddty_loops},
  {"product_drvtyinv", "(3,3),()->(3)",
    "vo = R (-k e_y).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvtyinv_loops},
  {"product_drdryinv", "(3,3),(2)->(3,3)",
    "Ro = R R_y(-θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdryinv_loops},
  {"product_ddryinv", "(3,4),(2)->(3,4)",
    "Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddryinv_loops},
  {"product_ddtyinv", "(3,4),()->(3,4)",
    "Do = D [I | -k e_y].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtyinv_loops},
  {"product_drvtz", "(3,3),()->(3)",
    "vo = R (k e_z).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvtz_loops},
  {"product_drdrz", "(3,3),(2)->(3,3)",
    "Ro = R R_z(θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdrz_loops},
  {"product_ddrz", "(3,4),(2)->(3,4)",
    "Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddrz_loops},
  {"product_ddtz", "(3,4),()->(3,4)",
    "Do = D [I | k e_z].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtz_loops},
  {"product_drvtzinv", "(3,3),()->(3)",
    "vo = R (-k e_z).\n"
    "\n"
    "(3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.\n"
    "3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_drvtzinv_loops},
  {"product_drdrzinv", "(3,3),(2)->(3,3)",
    "Ro = R R_z(-θ), dc = (sin θ, cos θ).\n"
    "\n"
    "(3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", product_drdrzinv_loops},
  {"product_ddrzinv", "(3,4),(2)->(3,4)",
    "Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).\n"
    "\n"
    "(3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).\n"
    "12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddrzinv_loops},
  {"product_ddtzinv", "(3,4),()->(3,4)",
    "Do = D [I | -k e_z].\n"
    "\n"
    "(3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_ddtzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
