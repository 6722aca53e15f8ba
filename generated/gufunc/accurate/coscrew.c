/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the coscrew operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/coscrew_accurate.h"

/* (6),()->(6) */
OVER(coscrew_scale_double) {
  POINTERS_3
  EACH {
    ksl_coscrew_t self;
    double a;
    LOAD(coscrew_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_coscrew_scale_accurate(&self, a);
    STORE(coscrew_double, &self, 2, 1);
  }
}
STRIDED_WITH_FMA(coscrew_scale_double)
LOOP(coscrew_scale_double, 3, DENSE, 48, 8, 48, 8, 8)

OVER(coscrew_scale_single) {
  POINTERS_3
  EACH {
    ksl_coscrewf_t self;
    float a;
    LOAD(coscrew_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_coscrewf_scale_accurate(&self, a);
    STORE(coscrew_single, &self, 2, 1);
  }
}
STRIDED(coscrew_scale_single)
LOOP(coscrew_scale_single, 3, DENSE, 24, 4, 24, 4, 4)
LOOPS(coscrew_scale)

/* (),(6),(6)->(6) */
OVER(axpy_cc_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t x;
    ksl_coscrew_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &x, 1, 0);
    LOAD(coscrew_double, &y, 2, 1);
    ksl_axpy_cc_accurate(a, &x, &y);
    STORE(coscrew_double, &y, 3, 2);
  }
}
STRIDED_WITH_FMA(axpy_cc_double)
LOOP(axpy_cc_double, 4, DENSE_OR_ONE, 8, 48, 48, 48, 8, 8, 8)

OVER(axpy_cc_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t x;
    ksl_coscrewf_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &x, 1, 0);
    LOAD(coscrew_single, &y, 2, 1);
    ksl_axpy_ccf_accurate(a, &x, &y);
    STORE(coscrew_single, &y, 3, 2);
  }
}
STRIDED(axpy_cc_single)
LOOP(axpy_cc_single, 4, DENSE_OR_ONE, 4, 24, 24, 24, 4, 4, 4)
LOOPS(axpy_cc)

/* (6),(6)->(6) */
OVER(xpy_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_xpy_cc_accurate(&x, &y);
    STORE(coscrew_double, &y, 2, 2);
  }
}
STRIDED(xpy_cc_double)
LOOP(xpy_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(xpy_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_xpy_ccf_accurate(&x, &y);
    STORE(coscrew_single, &y, 2, 2);
  }
}
STRIDED(xpy_cc_single)
LOOP(xpy_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(xpy_cc)

/* (6),(6)->(6) */
OVER(nxpy_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_nxpy_cc_accurate(&x, &y);
    STORE(coscrew_double, &y, 2, 2);
  }
}
STRIDED(nxpy_cc_double)
LOOP(nxpy_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(nxpy_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_nxpy_ccf_accurate(&x, &y);
    STORE(coscrew_single, &y, 2, 2);
  }
}
STRIDED(nxpy_cc_single)
LOOP(nxpy_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(nxpy_cc)

/* (),(6)->(6) */
OVER(product_ac_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &ci, 1, 0);
    ksl_product_ac_accurate(a, &ci, &co);
    STORE(coscrew_double, &co, 2, 1);
  }
}
STRIDED_WITH_FMA(product_ac_double)
LOOP(product_ac_double, 3, DENSE_OR_ONE, 8, 48, 48, 8, 8)

OVER(product_ac_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &ci, 1, 0);
    ksl_product_acf_accurate(a, &ci, &co);
    STORE(coscrew_single, &co, 2, 1);
  }
}
STRIDED(product_ac_single)
LOOP(product_ac_single, 3, DENSE_OR_ONE, 4, 24, 24, 4, 4)
LOOPS(product_ac)

/* (6),(6)->(6) */
OVER(add_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cc_accurate(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(add_cc_double)
LOOP(add_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_ccf_accurate(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(add_cc_single)
LOOP(add_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_cc)

/* (6),(6)->(6) */
OVER(subtract_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_subtract_cc_accurate(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(subtract_cc_double)
LOOP(subtract_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(subtract_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_subtract_ccf_accurate(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(subtract_cc_single)
LOOP(subtract_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(subtract_cc)

/* (6)->() */
OVER(coscrew_norm_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    double norm;
    LOAD(coscrew_double, &ci, 0, 0);
    norm = ksl_coscrew_norm_accurate(&ci);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED_WITH_FMA(coscrew_norm_double)
LOOP(coscrew_norm_double, 2, DENSE, 48, 8, 8)

OVER(coscrew_norm_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    float norm;
    LOAD(coscrew_single, &ci, 0, 0);
    norm = ksl_coscrewf_norm_accurate(&ci);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(coscrew_norm_single)
LOOP(coscrew_norm_single, 2, DENSE, 24, 4, 4)
LOOPS(coscrew_norm)

/* (6)->(6) */
OVER(coscrew_normalize_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t self;
    LOAD(coscrew_double, &self, 0, 0);
    ksl_coscrew_normalize_accurate(&self);
    STORE(coscrew_double, &self, 1, 1);
  }
}
STRIDED_WITH_FMA(coscrew_normalize_double)
LOOP(coscrew_normalize_double, 2, ANY, 48, 48, 8, 8)

OVER(coscrew_normalize_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t self;
    LOAD(coscrew_single, &self, 0, 0);
    ksl_coscrewf_normalize_accurate(&self);
    STORE(coscrew_single, &self, 1, 1);
  }
}
STRIDED(coscrew_normalize_single)
LOOP(coscrew_normalize_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_normalize)

/* (6)->(6) */
OVER(coscrew_normalized_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD(coscrew_double, &ci, 0, 0);
    ksl_coscrew_normalized_accurate(&ci, &co);
    STORE(coscrew_double, &co, 1, 1);
  }
}
STRIDED_WITH_FMA(coscrew_normalized_double)
LOOP(coscrew_normalized_double, 2, ANY, 48, 48, 8, 8)

OVER(coscrew_normalized_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD(coscrew_single, &ci, 0, 0);
    ksl_coscrewf_normalized_accurate(&ci, &co);
    STORE(coscrew_single, &co, 1, 1);
  }
}
STRIDED(coscrew_normalized_single)
LOOP(coscrew_normalized_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_normalized)

/* (6),(6)->(6) */
OVER(add_cct_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cct_accurate(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(add_cct_double)
LOOP(add_cct_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_cct_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_cctf_accurate(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(add_cct_single)
LOOP(add_cct_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_cct)

/* (3),(6)->(6) */
OVER(product_CoAdtc_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtc_accurate(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(product_CoAdtc_double)
LOOP(product_CoAdtc_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtc_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcf_accurate(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtc_single)
LOOP(product_CoAdtc_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtc)

/* (3),(6)->(6) */
OVER(product_CoAdtinvc_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtinvc_accurate(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(product_CoAdtinvc_double)
LOOP(product_CoAdtinvc_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtinvc_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtinvcf_accurate(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtinvc_single)
LOOP(product_CoAdtinvc_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtinvc)

/* (3),(6)->(6) */
OVER(product_CoAdtcinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtcinv_accurate(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(product_CoAdtcinv_double)
LOOP(product_CoAdtcinv_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtcinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcinvf_accurate(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtcinv_single)
LOOP(product_CoAdtcinv_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtcinv)

/* (3,3),(6)->(6) */
OVER(product_CoAdrc_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrc_accurate(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdrc_double)
LOOP(product_CoAdrc_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrc_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcf_accurate(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrc_single)
LOOP(product_CoAdrc_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrc)

/* (3,3),(6)->(6) */
OVER(product_CoAdrinvc_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrinvc_accurate(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdrinvc_double)
LOOP(product_CoAdrinvc_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrinvc_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrinvcf_accurate(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrinvc_single)
LOOP(product_CoAdrinvc_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrinvc)

/* (3,3),(6)->(6) */
OVER(product_CoAdrcinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrcinv_accurate(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdrcinv_double)
LOOP(product_CoAdrcinv_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrcinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcinvf_accurate(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrcinv_single)
LOOP(product_CoAdrcinv_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrcinv)

/* (3,4),(6)->(6) */
OVER(product_CoAdc_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdc_accurate(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdc_double)
LOOP(product_CoAdc_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdc_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcf_accurate(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdc_single)
LOOP(product_CoAdc_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdc)

/* (3,4),(6)->(6) */
OVER(product_CoAdinvc_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdinvc_accurate(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdinvc_double)
LOOP(product_CoAdinvc_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdinvc_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdinvcf_accurate(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdinvc_single)
LOOP(product_CoAdinvc_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdinvc)

/* (3,4),(6)->(6) */
OVER(product_CoAdcinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdcinv_accurate(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(product_CoAdcinv_double)
LOOP(product_CoAdcinv_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdcinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcinvf_accurate(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdcinv_single)
LOOP(product_CoAdcinv_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdcinv)

/* (3,4)->(6) */
OVER(hctx_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctx_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hctx_double)
LOOP(hctx_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctx_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctx_single)
LOOP(hctx_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctx)

/* (3,4)->(6) */
OVER(hcty_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcty_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hcty_double)
LOOP(hcty_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcty_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcty_single)
LOOP(hcty_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcty)

/* (3,4)->(6) */
OVER(hctz_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctz_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hctz_double)
LOOP(hctz_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctz_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctz_single)
LOOP(hctz_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctz)

/* (3,4)->(6) */
OVER(hctxinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctxinv_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hctxinv_double)
LOOP(hctxinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctxinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxinvf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctxinv_single)
LOOP(hctxinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctxinv)

/* (3,4)->(6) */
OVER(hctyinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctyinv_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hctyinv_double)
LOOP(hctyinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctyinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyinvf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctyinv_single)
LOOP(hctyinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctyinv)

/* (3,4)->(6) */
OVER(hctzinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctzinv_accurate(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED_WITH_FMA(hctzinv_double)
LOOP(hctzinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctzinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzinvf_accurate(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctzinv_single)
LOOP(hctzinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctzinv)

/* (3,4)->(6,6) */
OVER(CoAd_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat6x6_t M;
    LOAD(SE3_double, &D, 0, 0);
    ksl_CoAd_accurate(&D, &M);
    STORE(mat6x6_double, &M, 1, 2);
  }
}
STRIDED_WITH_FMA(CoAd_double)
LOOP(CoAd_double, 2, DENSE, 96, 288, 32, 8, 48, 8)

OVER(CoAd_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat6x6f_t M;
    LOAD(SE3_single, &D, 0, 0);
    ksl_CoAdf_accurate(&D, &M);
    STORE(mat6x6_single, &M, 1, 2);
  }
}
STRIDED(CoAd_single)
LOOP(CoAd_single, 2, DENSE, 48, 144, 16, 4, 24, 4)
LOOPS(CoAd)

/* (6),(6)->() */
OVER(reciprocal_product_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c, &c);
  EACH {
    double x[6];
    double power;
    LOAD_OTHER(coscrew_double, &c);
    LOAD(angular_first_double, x, 1, 1);
    power = ksl_reciprocal_product_accurate(&c, x);
    STORE(scalar_double, &power, 2, 2);
  }
}
STRIDED_WITH_FMA(reciprocal_product_double)
LOOP(reciprocal_product_double, 3, DENSE_OR_ONE, 48, 48, 8, 8, 8)

OVER(reciprocal_product_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c, &c);
  EACH {
    float x[6];
    float power;
    LOAD_OTHER(coscrew_single, &c);
    LOAD(angular_first_single, x, 1, 1);
    power = ksl_reciprocal_productf_accurate(&c, x);
    STORE(scalar_single, &power, 2, 2);
  }
}
STRIDED(reciprocal_product_single)
LOOP(reciprocal_product_single, 3, DENSE_OR_ONE, 24, 24, 4, 4, 4)
LOOPS(reciprocal_product)

/* (6),(6)->(6) */
OVER(cross_sc_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sc_accurate(&s, &c, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(cross_sc_double)
LOOP(cross_sc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_sc_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scf_accurate(&s, &c, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(cross_sc_single)
LOOP(cross_sc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_sc)

/* (6),(6)->(6) */
OVER(cross_sca_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sca_accurate(&s, &c, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED_WITH_FMA(cross_sca_double)
LOOP(cross_sca_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_sca_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scaf_accurate(&s, &c, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(cross_sca_single)
LOOP(cross_sca_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_sca)

/* (3,4),(6)->(6) */
OVER(constraint_ctx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctx_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_ctx_double)
LOOP(constraint_ctx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_ctx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctxf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_ctx_single)
LOOP(constraint_ctx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_ctx)

/* (3,4),(6)->(6) */
OVER(constraint_cty_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cty_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_cty_double)
LOOP(constraint_cty_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_cty_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctyf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_cty_single)
LOOP(constraint_cty_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_cty)

/* (3,4),(6)->(6) */
OVER(constraint_ctz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctz_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_ctz_double)
LOOP(constraint_ctz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_ctz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctzf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_ctz_single)
LOOP(constraint_ctz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_ctz)

/* (3,4),(6)->(6) */
OVER(constraint_crx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crx_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_crx_double)
LOOP(constraint_crx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_crx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crxf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_crx_single)
LOOP(constraint_crx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_crx)

/* (3,4),(6)->(6) */
OVER(constraint_cry_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cry_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_cry_double)
LOOP(constraint_cry_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_cry_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_cryf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_cry_single)
LOOP(constraint_cry_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_cry)

/* (3,4),(6)->(6) */
OVER(constraint_crz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crz_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(constraint_crz_double)
LOOP(constraint_crz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_crz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crzf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_crz_single)
LOOP(constraint_crz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_crz)

/* (3,4),(6)->(6) */
OVER(working_ctx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctx_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_ctx_double)
LOOP(working_ctx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_ctx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctxf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_ctx_single)
LOOP(working_ctx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_ctx)

/* (3,4),(6)->(6) */
OVER(working_cty_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cty_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_cty_double)
LOOP(working_cty_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_cty_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctyf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_cty_single)
LOOP(working_cty_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_cty)

/* (3,4),(6)->(6) */
OVER(working_ctz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctz_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_ctz_double)
LOOP(working_ctz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_ctz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctzf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_ctz_single)
LOOP(working_ctz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_ctz)

/* (3,4),(6)->(6) */
OVER(working_crx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crx_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_crx_double)
LOOP(working_crx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_crx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crxf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_crx_single)
LOOP(working_crx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_crx)

/* (3,4),(6)->(6) */
OVER(working_cry_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cry_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_cry_double)
LOOP(working_cry_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_cry_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_cryf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_cry_single)
LOOP(working_cry_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_cry)

/* (3,4),(6)->(6) */
OVER(working_crz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crz_accurate(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED_WITH_FMA(working_crz_double)
LOOP(working_crz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_crz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crzf_accurate(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_crz_single)
LOOP(working_crz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_crz)

const coscrew_gufunc TABLE(coscrew)[] = {
  {"coscrew_scale", "(6),()->(6)",
    "self = a self.\n"
    "\n"
    "(6),()->(6).  self: coscrew (f in N; τ in N m); a: number.\n"
    "6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", coscrew_scale_loops},
  {"axpy_cc", "(),(6),(6)->(6)",
    "y = a x + y.\n"
    "\n"
    "(),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   3, 1, "", axpy_cc_loops},
  {"xpy_cc", "(6),(6)->(6)",
    "y = x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_cc_loops},
  {"nxpy_cc", "(6),(6)->(6)",
    "y = -x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_cc_loops},
  {"product_ac", "(),(6)->(6)",
    "co = a ci.\n"
    "\n"
    "(),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_ac_loops},
  {"add_cc", "(6),(6)->(6)",
    "co = c1 + c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cc_loops},
  {"subtract_cc", "(6),(6)->(6)",
    "co = c1 - c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "42 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_cc_loops},
  {"coscrew_norm", "(6)->()",
    "|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).\n"
    "\n"
    "(6)->().  ci: coscrew (f in N; τ in N m); norm: number.\n"
    "10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16\n"
    "select.\n",
   1, 1, "", coscrew_norm_loops},
  {"coscrew_normalize", "(6)->(6)",
    "self = self / |self|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  self: coscrew (f in N; τ in N m).\n"
    "43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,\n"
    "34 select.\n",
   1, 1, "", coscrew_normalize_loops},
  {"coscrew_normalized", "(6)->(6)",
    "co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,\n"
    "34 select.\n",
   1, 1, "", coscrew_normalized_loops},
  {"add_cct", "(6),(6)->(6)",
    "co = (c1.lin + c2.lin ; c1.ang).\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cct_loops},
  {"product_CoAdtc", "(3),(6)->(6)",
    "co = [Ad]*(t) ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtc_loops},
  {"product_CoAdtinvc", "(3),(6)->(6)",
    "co = [Ad]*(t)^-1 ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtinvc_loops},
  {"product_CoAdtcinv", "(3),(6)->(6)",
    "co = [Ad]*(t) (-ci).\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtcinv_loops},
  {"product_CoAdrc", "(3,3),(6)->(6)",
    "co = [Ad]*(R) ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrc_loops},
  {"product_CoAdrinvc", "(3,3),(6)->(6)",
    "co = [Ad]*(R)^-1 ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrinvc_loops},
  {"product_CoAdrcinv", "(3,3),(6)->(6)",
    "co = [Ad]*(R) (-ci).\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrcinv_loops},
  {"product_CoAdc", "(3,4),(6)->(6)",
    "co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdc_loops},
  {"product_CoAdinvc", "(3,4),(6)->(6)",
    "co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdinvc_loops},
  {"product_CoAdcinv", "(3,4),(6)->(6)",
    "co = [Ad]*(D) (-ci).\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S\n"
    "the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdcinv_loops},
  {"hctx", "(3,4)->(6)",
    "co = h_tx: column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctx_loops},
  {"hcty", "(3,4)->(6)",
    "co = h_ty: column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hcty_loops},
  {"hctz", "(3,4)->(6)",
    "co = h_tz: column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctz_loops},
  {"hctxinv", "(3,4)->(6)",
    "co = -h_tx: -column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctxinv_loops},
  {"hctyinv", "(3,4)->(6)",
    "co = -h_ty: -column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctyinv_loops},
  {"hctzinv", "(3,4)->(6)",
    "co = -h_tz: -column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the\n"
    "sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctzinv_loops},
  {"CoAd", "(3,4)->(6,6)",
    "M = [Ad]*(D).\n"
    "\n"
    "(3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.\n"
    "18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "R", CoAd_loops},
  {"reciprocal_product", "(6),(6)->()",
    "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).\n"
    "\n"
    "(6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;\n"
    "power: number.\n"
    "6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", reciprocal_product_loops},
  {"cross_sc", "(6),(6)->(6)",
    "co = [ad]*(s) c = (ω×f ; v×f + ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 6, ang: 12) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sc_loops},
  {"cross_sca", "(6),(6)->(6)",
    "co = (0 ; ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sca_loops},
  {"constraint_ctx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctx_loops},
  {"constraint_cty", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cty_loops},
  {"constraint_ctz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctz_loops},
  {"constraint_crx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crx_loops},
  {"constraint_cry", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cry_loops},
  {"constraint_crz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crz_loops},
  {"working_ctx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctx_loops},
  {"working_cty", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_cty_loops},
  {"working_ctz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)\n"
    "u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctz_loops},
  {"working_crx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crx_loops},
  {"working_cry", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_cry_loops},
  {"working_crz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crz_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
