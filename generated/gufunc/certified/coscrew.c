/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the coscrew operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/coscrew_certified.h"
#include <fenv.h>

/* (6),()->(6),(6) */
OVER(coscrew_scale_double) {
  POINTERS_4
  EACH {
    ksl_coscrew_t self;
    double a;
    ksl_coscrew_t self_bound;
    LOAD(coscrew_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_coscrew_scale_certified(&self, a, &self_bound);
    STORE(coscrew_double, &self, 2, 1);
    STORE(coscrew_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(coscrew_scale_double)
LOOP(coscrew_scale_double, 4, DENSE, 48, 8, 48, 48, 8, 8, 8)

OVER(coscrew_scale_single) {
  POINTERS_4
  EACH {
    ksl_coscrewf_t self;
    float a;
    ksl_coscrewf_t self_bound;
    LOAD(coscrew_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_coscrewf_scale_certified(&self, a, &self_bound);
    STORE(coscrew_single, &self, 2, 1);
    STORE(coscrew_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(coscrew_scale_single)
LOOP(coscrew_scale_single, 4, DENSE, 24, 4, 24, 24, 4, 4, 4)
LOOPS(coscrew_scale)

/* (),(6),(6)->(6),(6) */
OVER(axpy_cc_double) {
  POINTERS_5
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t x;
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &x, 1, 0);
    LOAD(coscrew_double, &y, 2, 1);
    ksl_axpy_cc_certified(a, &x, &y, &y_bound);
    STORE(coscrew_double, &y, 3, 2);
    STORE(coscrew_double, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_cc_double)
LOOP(axpy_cc_double, 5, DENSE_OR_ONE, 8, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(axpy_cc_single) {
  POINTERS_5
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t x;
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &x, 1, 0);
    LOAD(coscrew_single, &y, 2, 1);
    ksl_axpy_ccf_certified(a, &x, &y, &y_bound);
    STORE(coscrew_single, &y, 3, 2);
    STORE(coscrew_single, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_cc_single)
LOOP(axpy_cc_single, 5, DENSE_OR_ONE, 4, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(axpy_cc)

/* (6),(6)->(6),(6) */
OVER(xpy_cc_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_xpy_cc_certified(&x, &y, &y_bound);
    STORE(coscrew_double, &y, 2, 2);
    STORE(coscrew_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_cc_double)
LOOP(xpy_cc_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(xpy_cc_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_xpy_ccf_certified(&x, &y, &y_bound);
    STORE(coscrew_single, &y, 2, 2);
    STORE(coscrew_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_cc_single)
LOOP(xpy_cc_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(xpy_cc)

/* (6),(6)->(6),(6) */
OVER(nxpy_cc_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    ksl_coscrew_t y_bound;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_nxpy_cc_certified(&x, &y, &y_bound);
    STORE(coscrew_double, &y, 2, 2);
    STORE(coscrew_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_cc_double)
LOOP(nxpy_cc_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(nxpy_cc_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    ksl_coscrewf_t y_bound;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_nxpy_ccf_certified(&x, &y, &y_bound);
    STORE(coscrew_single, &y, 2, 2);
    STORE(coscrew_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_cc_single)
LOOP(nxpy_cc_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(nxpy_cc)

/* (),(6)->(6),(6) */
OVER(product_ac_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &ci, 1, 0);
    ksl_product_ac_certified(a, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 1);
    STORE(coscrew_double, &co_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ac_double)
LOOP(product_ac_double, 4, DENSE_OR_ONE, 8, 48, 48, 48, 8, 8, 8)

OVER(product_ac_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &ci, 1, 0);
    ksl_product_acf_certified(a, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 1);
    STORE(coscrew_single, &co_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_ac_single)
LOOP(product_ac_single, 4, DENSE_OR_ONE, 4, 24, 24, 24, 4, 4, 4)
LOOPS(product_ac)

/* (6),(6)->(6),(6) */
OVER(add_cc_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cc_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_cc_double)
LOOP(add_cc_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(add_cc_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_ccf_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_cc_single)
LOOP(add_cc_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(add_cc)

/* (6),(6)->(6),(6) */
OVER(subtract_cc_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_subtract_cc_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_cc_double)
LOOP(subtract_cc_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(subtract_cc_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_subtract_ccf_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_cc_single)
LOOP(subtract_cc_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(subtract_cc)

/* (6),(6)->(6),(6) */
OVER(add_cct_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cct_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_cct_double)
LOOP(add_cct_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(add_cct_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_cctf_certified(&c1, &c2, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_cct_single)
LOOP(add_cct_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(add_cct)

/* (3),(6)->(6),(6) */
OVER(product_CoAdtc_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtc_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtc_double)
LOOP(product_CoAdtc_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_CoAdtc_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcf_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtc_single)
LOOP(product_CoAdtc_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_CoAdtc)

/* (3),(6)->(6),(6) */
OVER(product_CoAdtinvc_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtinvc_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtinvc_double)
LOOP(product_CoAdtinvc_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_CoAdtinvc_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtinvcf_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtinvc_single)
LOOP(product_CoAdtinvc_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_CoAdtinvc)

/* (3),(6)->(6),(6) */
OVER(product_CoAdtcinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtcinv_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtcinv_double)
LOOP(product_CoAdtcinv_double, 4, DENSE_OR_ONE, 24, 48, 48, 48, 8, 8, 8, 8)

OVER(product_CoAdtcinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcinvf_certified(&t, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdtcinv_single)
LOOP(product_CoAdtcinv_single, 4, DENSE_OR_ONE, 12, 24, 24, 24, 4, 4, 4, 4)
LOOPS(product_CoAdtcinv)

/* (3,3),(6)->(6),(6) */
OVER(product_CoAdrc_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrc_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrc_double)
LOOP(product_CoAdrc_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_CoAdrc_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcf_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrc_single)
LOOP(product_CoAdrc_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_CoAdrc)

/* (3,3),(6)->(6),(6) */
OVER(product_CoAdrinvc_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrinvc_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrinvc_double)
LOOP(product_CoAdrinvc_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_CoAdrinvc_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrinvcf_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrinvc_single)
LOOP(product_CoAdrinvc_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_CoAdrinvc)

/* (3,3),(6)->(6),(6) */
OVER(product_CoAdrcinv_double) {
  POINTERS_4
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrcinv_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrcinv_double)
LOOP(product_CoAdrcinv_double, 4, DENSE_OR_ONE, 72, 48, 48, 48, 24, 8, 8, 8, 8)

OVER(product_CoAdrcinv_single) {
  POINTERS_4
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcinvf_certified(&R, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdrcinv_single)
LOOP(product_CoAdrcinv_single, 4, DENSE_OR_ONE, 36, 24, 24, 24, 12, 4, 4, 4, 4)
LOOPS(product_CoAdrcinv)

/* (3,4),(6)->(6),(6) */
OVER(product_CoAdc_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdc_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdc_double)
LOOP(product_CoAdc_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_CoAdc_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcf_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdc_single)
LOOP(product_CoAdc_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_CoAdc)

/* (3,4),(6)->(6),(6) */
OVER(product_CoAdinvc_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdinvc_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdinvc_double)
LOOP(product_CoAdinvc_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_CoAdinvc_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdinvcf_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdinvc_single)
LOOP(product_CoAdinvc_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_CoAdinvc)

/* (3,4),(6)->(6),(6) */
OVER(product_CoAdcinv_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdcinv_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdcinv_double)
LOOP(product_CoAdcinv_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(product_CoAdcinv_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcinvf_certified(&D, &ci, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_CoAdcinv_single)
LOOP(product_CoAdcinv_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(product_CoAdcinv)

/* (3,4)->(6),(6) */
OVER(hctx_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctx_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctx_double)
LOOP(hctx_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hctx_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctx_single)
LOOP(hctx_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hctx)

/* (3,4)->(6),(6) */
OVER(hcty_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcty_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hcty_double)
LOOP(hcty_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hcty_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hcty_single)
LOOP(hcty_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hcty)

/* (3,4)->(6),(6) */
OVER(hctz_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctz_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctz_double)
LOOP(hctz_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hctz_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctz_single)
LOOP(hctz_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hctz)

/* (3,4)->(6),(6) */
OVER(hctxinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctxinv_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctxinv_double)
LOOP(hctxinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hctxinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxinvf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctxinv_single)
LOOP(hctxinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hctxinv)

/* (3,4)->(6),(6) */
OVER(hctyinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctyinv_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctyinv_double)
LOOP(hctyinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hctyinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyinvf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctyinv_single)
LOOP(hctyinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hctyinv)

/* (3,4)->(6),(6) */
OVER(hctzinv_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctzinv_certified(&D, &co, &co_bound);
    STORE(coscrew_double, &co, 1, 2);
    STORE(coscrew_double, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctzinv_double)
LOOP(hctzinv_double, 3, DENSE, 96, 48, 48, 32, 8, 8, 8)

OVER(hctzinv_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzinvf_certified(&D, &co, &co_bound);
    STORE(coscrew_single, &co, 1, 2);
    STORE(coscrew_single, &co_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(hctzinv_single)
LOOP(hctzinv_single, 3, DENSE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(hctzinv)

/* (3,4)->(6,6),(6,6) */
OVER(CoAd_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_mat6x6_t M;
    ksl_mat6x6_t M_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_CoAd_certified(&D, &M, &M_bound);
    STORE(mat6x6_double, &M, 1, 2);
    STORE(mat6x6_double, &M_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(CoAd_double)
LOOP(CoAd_double, 3, DENSE, 96, 288, 288, 32, 8, 48, 8, 48, 8)

OVER(CoAd_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_mat6x6f_t M;
    ksl_mat6x6f_t M_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_CoAdf_certified(&D, &M, &M_bound);
    STORE(mat6x6_single, &M, 1, 2);
    STORE(mat6x6_single, &M_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(CoAd_single)
LOOP(CoAd_single, 3, DENSE, 48, 144, 144, 16, 4, 24, 4, 24, 4)
LOOPS(CoAd)

/* (6),(6)->(),() */
OVER(reciprocal_product_double) {
  POINTERS_4
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c, &c);
  EACH {
    double x[6];
    double power;
    double power_bound;
    LOAD_OTHER(coscrew_double, &c);
    LOAD(angular_first_double, x, 1, 1);
    power = ksl_reciprocal_product_certified(&c, x, &power_bound);
    STORE(scalar_double, &power, 2, 2);
    STORE(scalar_double, &power_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(reciprocal_product_double)
LOOP(reciprocal_product_double, 4, DENSE_OR_ONE, 48, 48, 8, 8, 8, 8)

OVER(reciprocal_product_single) {
  POINTERS_4
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c, &c);
  EACH {
    float x[6];
    float power;
    float power_bound;
    LOAD_OTHER(coscrew_single, &c);
    LOAD(angular_first_single, x, 1, 1);
    power = ksl_reciprocal_productf_certified(&c, x, &power_bound);
    STORE(scalar_single, &power, 2, 2);
    STORE(scalar_single, &power_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(reciprocal_product_single)
LOOP(reciprocal_product_single, 4, DENSE_OR_ONE, 24, 24, 4, 4, 4, 4)
LOOPS(reciprocal_product)

/* (6),(6)->(6),(6) */
OVER(cross_sc_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sc_certified(&s, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sc_double)
LOOP(cross_sc_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(cross_sc_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scf_certified(&s, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sc_single)
LOOP(cross_sc_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(cross_sc)

/* (6),(6)->(6),(6) */
OVER(cross_sca_double) {
  POINTERS_4
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sca_certified(&s, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 2);
    STORE(coscrew_double, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sca_double)
LOOP(cross_sca_double, 4, DENSE_OR_ONE, 48, 48, 48, 48, 8, 8, 8, 8)

OVER(cross_sca_single) {
  POINTERS_4
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scaf_certified(&s, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 2);
    STORE(coscrew_single, &co_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_sca_single)
LOOP(cross_sca_single, 4, DENSE_OR_ONE, 24, 24, 24, 24, 4, 4, 4, 4)
LOOPS(cross_sca)

/* (3,4),(6)->(6),(6) */
OVER(constraint_ctx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctx_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_ctx_double)
LOOP(constraint_ctx_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_ctx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctxf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_ctx_single)
LOOP(constraint_ctx_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_ctx)

/* (3,4),(6)->(6),(6) */
OVER(constraint_cty_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cty_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_cty_double)
LOOP(constraint_cty_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_cty_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctyf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_cty_single)
LOOP(constraint_cty_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_cty)

/* (3,4),(6)->(6),(6) */
OVER(constraint_ctz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctz_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_ctz_double)
LOOP(constraint_ctz_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_ctz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctzf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_ctz_single)
LOOP(constraint_ctz_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_ctz)

/* (3,4),(6)->(6),(6) */
OVER(constraint_crx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crx_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_crx_double)
LOOP(constraint_crx_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_crx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crxf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_crx_single)
LOOP(constraint_crx_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_crx)

/* (3,4),(6)->(6),(6) */
OVER(constraint_cry_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cry_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_cry_double)
LOOP(constraint_cry_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_cry_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_cryf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_cry_single)
LOOP(constraint_cry_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_cry)

/* (3,4),(6)->(6),(6) */
OVER(constraint_crz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crz_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_crz_double)
LOOP(constraint_crz_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(constraint_crz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crzf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(constraint_crz_single)
LOOP(constraint_crz_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(constraint_crz)

/* (3,4),(6)->(6),(6) */
OVER(working_ctx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctx_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_ctx_double)
LOOP(working_ctx_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_ctx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctxf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_ctx_single)
LOOP(working_ctx_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_ctx)

/* (3,4),(6)->(6),(6) */
OVER(working_cty_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cty_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_cty_double)
LOOP(working_cty_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_cty_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctyf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_cty_single)
LOOP(working_cty_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_cty)

/* (3,4),(6)->(6),(6) */
OVER(working_ctz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctz_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_ctz_double)
LOOP(working_ctz_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_ctz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctzf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_ctz_single)
LOOP(working_ctz_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_ctz)

/* (3,4),(6)->(6),(6) */
OVER(working_crx_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crx_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_crx_double)
LOOP(working_crx_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_crx_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crxf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_crx_single)
LOOP(working_crx_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_crx)

/* (3,4),(6)->(6),(6) */
OVER(working_cry_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cry_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_cry_double)
LOOP(working_cry_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_cry_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_cryf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_cry_single)
LOOP(working_cry_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_cry)

/* (3,4),(6)->(6),(6) */
OVER(working_crz_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    ksl_coscrew_t co_bound;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crz_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_double, &co, 2, 3);
    STORE(coscrew_double, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_crz_double)
LOOP(working_crz_double, 4, DENSE_OR_ONE, 96, 48, 48, 48, 32, 8, 8, 8, 8)

OVER(working_crz_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    ksl_coscrewf_t co_bound;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crzf_certified(&D, &c, &co, &co_bound);
    STORE(coscrew_single, &co, 2, 3);
    STORE(coscrew_single, &co_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(working_crz_single)
LOOP(working_crz_single, 4, DENSE_OR_ONE, 48, 24, 24, 24, 16, 4, 4, 4, 4)
LOOPS(working_crz)

const coscrew_gufunc TABLE(coscrew)[] = {
  {"coscrew_scale", "(6),()->(6),(6)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(6),()->(6),(6).  self, self_bound: coscrew (f in N; τ in N m); a: number.\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", coscrew_scale_loops},
  {"axpy_cc", "(),(6),(6)->(6),(6)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(6),(6)->(6),(6).  a: number; x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "12 mul, 18 add, 12 abs.\n",
   3, 2, "", axpy_cc_loops},
  {"xpy_cc", "(6),(6)->(6),(6)",
    "y = x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", xpy_cc_loops},
  {"nxpy_cc", "(6),(6)->(6),(6)",
    "y = -x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", nxpy_cc_loops},
  {"product_ac", "(),(6)->(6),(6)",
    "co = a ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(),(6)->(6),(6).  a: number; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "12 mul, 6 add, 6 abs.\n",
   2, 2, "", product_ac_loops},
  {"add_cc", "(6),(6)->(6),(6)",
    "co = c1 + c2; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", add_cc_loops},
  {"subtract_cc", "(6),(6)->(6),(6)",
    "co = c1 - c2; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 6 abs.\n",
   2, 2, "", subtract_cc_loops},
  {"add_cct", "(6),(6)->(6),(6)",
    "co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", add_cct_loops},
  {"product_CoAdtc", "(3),(6)->(6),(6)",
    "co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_CoAdtc_loops},
  {"product_CoAdtinvc", "(3),(6)->(6),(6)",
    "co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 9 abs.\n",
   2, 2, "", product_CoAdtinvc_loops},
  {"product_CoAdtcinv", "(3),(6)->(6),(6)",
    "co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).\n"
    "9 mul, 15 add, 3 neg, 9 abs.\n",
   2, 2, "", product_CoAdtcinv_loops},
  {"product_CoAdrc", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_CoAdrc_loops},
  {"product_CoAdrinvc", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "R.", product_CoAdrinvc_loops},
  {"product_CoAdrcinv", "(3,3),(6)->(6),(6)",
    "co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ\n"
    "in N m).\n"
    "24 mul, 30 add, 6 neg, 18 abs.\n",
   2, 2, "R.", product_CoAdrcinv_loops},
  {"product_CoAdc", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "36 mul, 42 add, 21 abs.\n",
   2, 2, "R.", product_CoAdc_loops},
  {"product_CoAdinvc", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "39 mul, 45 add, 27 abs.\n",
   2, 2, "R.", product_CoAdinvc_loops},
  {"product_CoAdcinv", "(3,4),(6)->(6),(6)",
    "co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "36 mul, 42 add, 6 neg, 21 abs.\n",
   2, 2, "R.", product_CoAdcinv_loops},
  {"hctx", "(3,4)->(6),(6)",
    "co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hctx_loops},
  {"hcty", "(3,4)->(6),(6)",
    "co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hcty_loops},
  {"hctz", "(3,4)->(6),(6)",
    "co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 6 abs.\n",
   1, 2, "R", hctz_loops},
  {"hctxinv", "(3,4)->(6),(6)",
    "co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctxinv_loops},
  {"hctyinv", "(3,4)->(6),(6)",
    "co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctyinv_loops},
  {"hctzinv", "(3,4)->(6),(6)",
    "co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;\n"
    "τ in N m).\n"
    "9 mul, 9 add, 3 neg, 6 abs.\n",
   1, 2, "R", hctzinv_loops},
  {"CoAd", "(3,4)->(6,6),(6,6)",
    "M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.\n"
    "\n"
    "(3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.\n"
    "27 mul, 27 add, 18 abs.\n",
   1, 2, "R", CoAd_loops},
  {"reciprocal_product", "(6),(6)->(),()",
    "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(6),(6)->(),().  c: coscrew (f in N; τ in N m); x: six components with the angular part on\n"
    "top; power, power_bound: number.\n"
    "7 mul, 11 add, 6 abs.\n",
   2, 2, "", reciprocal_product_loops},
  {"cross_sc", "(6),(6)->(6),(6)",
    "co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N\n"
    "m).\n"
    "24 mul, 30 add, 18 abs.\n",
   2, 2, "", cross_sc_loops},
  {"cross_sca", "(6),(6)->(6),(6)",
    "co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_sca_loops},
  {"constraint_ctx", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_ctx_loops},
  {"constraint_cty", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_cty_loops},
  {"constraint_ctz", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_ctz_loops},
  {"constraint_crx", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_crx_loops},
  {"constraint_cry", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_cry_loops},
  {"constraint_crz", "(3,4),(6)->(6),(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "33 mul, 36 add, 18 abs.\n",
   2, 2, "R.", constraint_crz_loops},
  {"working_ctx", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_ctx_loops},
  {"working_cty", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_cty_loops},
  {"working_ctz", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "21 mul, 12 add, 6 abs.\n",
   2, 2, "R.", working_ctz_loops},
  {"working_crx", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_crx_loops},
  {"working_cry", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_cry_loops},
  {"working_crz", "(3,4),(6)->(6),(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;\n"
    "|error of co| <= co_bound unless inf or NaN.\n"
    "\n"
    "(3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew\n"
    "(f in N; τ in N m).\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "R.", working_crz_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
