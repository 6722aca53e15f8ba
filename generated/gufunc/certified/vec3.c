/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/vec3_certified.h"
#include <fenv.h>

/* (3),()->(3),(3) */
OVER(vec3_scale_double) {
  POINTERS_4
  EACH {
    ksl_vec3_t self;
    double a;
    ksl_vec3_t self_bound;
    LOAD(vec3_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_vec3_scale_certified(&self, a, &self_bound);
    STORE(vec3_double, &self, 2, 1);
    STORE(vec3_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec3_scale_double)
LOOP(vec3_scale_double, 4, DENSE, 24, 8, 24, 24, 8, 8, 8)

OVER(vec3_scale_single) {
  POINTERS_4
  EACH {
    ksl_vec3f_t self;
    float a;
    ksl_vec3f_t self_bound;
    LOAD(vec3_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_vec3f_scale_certified(&self, a, &self_bound);
    STORE(vec3_single, &self, 2, 1);
    STORE(vec3_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec3_scale_single)
LOOP(vec3_scale_single, 4, DENSE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(vec3_scale)

/* (),(3),(3)->(3),(3) */
OVER(axpy_vv_double) {
  POINTERS_5
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t x;
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &x, 1, 0);
    LOAD(vec3_double, &y, 2, 1);
    ksl_axpy_vv_certified(a, &x, &y, &y_bound);
    STORE(vec3_double, &y, 3, 2);
    STORE(vec3_double, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_vv_double)
LOOP(axpy_vv_double, 5, DENSE_OR_ONE, 8, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(axpy_vv_single) {
  POINTERS_5
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t x;
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &x, 1, 0);
    LOAD(vec3_single, &y, 2, 1);
    ksl_axpy_vvf_certified(a, &x, &y, &y_bound);
    STORE(vec3_single, &y, 3, 2);
    STORE(vec3_single, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_vv_single)
LOOP(axpy_vv_single, 5, DENSE_OR_ONE, 4, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(axpy_vv)

/* (3),(3)->(3),(3) */
OVER(xpy_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_xpy_vv_certified(&x, &y, &y_bound);
    STORE(vec3_double, &y, 2, 2);
    STORE(vec3_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_vv_double)
LOOP(xpy_vv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(xpy_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_xpy_vvf_certified(&x, &y, &y_bound);
    STORE(vec3_single, &y, 2, 2);
    STORE(vec3_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(xpy_vv_single)
LOOP(xpy_vv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(xpy_vv)

/* (3),(3)->(3),(3) */
OVER(nxpy_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    ksl_vec3_t y_bound;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_nxpy_vv_certified(&x, &y, &y_bound);
    STORE(vec3_double, &y, 2, 2);
    STORE(vec3_double, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_vv_double)
LOOP(nxpy_vv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(nxpy_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    ksl_vec3f_t y_bound;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_nxpy_vvf_certified(&x, &y, &y_bound);
    STORE(vec3_single, &y, 2, 2);
    STORE(vec3_single, &y_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(nxpy_vv_single)
LOOP(nxpy_vv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(nxpy_vv)

/* (),(3)->(3),(3) */
OVER(product_av_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &vi, 1, 0);
    ksl_product_av_certified(a, &vi, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_av_double)
LOOP(product_av_double, 4, DENSE_OR_ONE, 8, 24, 24, 24, 8, 8, 8)

OVER(product_av_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &vi, 1, 0);
    ksl_product_avf_certified(a, &vi, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_av_single)
LOOP(product_av_single, 4, DENSE_OR_ONE, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_av)

/* (3),(3)->(3),(3) */
OVER(add_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_add_vv_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vv_double)
LOOP(add_vv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(add_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_add_vvf_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vv_single)
LOOP(add_vv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(add_vv)

/* (3),(3)->(3),(3) */
OVER(subtract_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_subtract_vv_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_vv_double)
LOOP(subtract_vv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(subtract_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_subtract_vvf_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_vv_single)
LOOP(subtract_vv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(subtract_vv)

/* (3),()->(3),(3) */
OVER(vec3_scaled_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_vec3_scaled_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec3_scaled_double)
LOOP(vec3_scaled_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(vec3_scaled_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_vec3f_scaled_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(vec3_scaled_single)
LOOP(vec3_scaled_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(vec3_scaled)

/* (3),(3)->(),() */
OVER(angle_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double angle;
    double angle_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    angle = ksl_angle_vv_certified(&v1, &v2, &angle_bound);
    STORE(scalar_double, &angle, 2, 2);
    STORE(scalar_double, &angle_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(angle_vv_double)
LOOP(angle_vv_double, 4, DENSE_OR_ONE, 24, 24, 8, 8, 8, 8)

OVER(angle_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float angle;
    float angle_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    angle = ksl_angle_vvf_certified(&v1, &v2, &angle_bound);
    STORE(scalar_single, &angle, 2, 2);
    STORE(scalar_single, &angle_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(angle_vv_single)
LOOP(angle_vv_single, 4, DENSE_OR_ONE, 12, 12, 4, 4, 4, 4)
LOOPS(angle_vv)

/* (3),(3)->(),() */
OVER(dot_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double dot;
    double dot_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    dot = ksl_dot_vv_certified(&v1, &v2, &dot_bound);
    STORE(scalar_double, &dot, 2, 2);
    STORE(scalar_double, &dot_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_vv_double)
LOOP(dot_vv_double, 4, DENSE_OR_ONE, 24, 24, 8, 8, 8, 8)

OVER(dot_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float dot;
    float dot_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    dot = ksl_dot_vvf_certified(&v1, &v2, &dot_bound);
    STORE(scalar_single, &dot, 2, 2);
    STORE(scalar_single, &dot_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_vv_single)
LOOP(dot_vv_single, 4, DENSE_OR_ONE, 12, 12, 4, 4, 4, 4)
LOOPS(dot_vv)

/* (),(3)->(3),(3) */
OVER(product_avinv_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double k, &k);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(scalar_double, &k);
    LOAD(vec3_double, &v, 1, 0);
    ksl_product_avinv_certified(k, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_avinv_double)
LOOP(product_avinv_double, 4, DENSE_OR_ONE, 8, 24, 24, 24, 8, 8, 8)

OVER(product_avinv_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float k, &k);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(scalar_single, &k);
    LOAD(vec3_single, &v, 1, 0);
    ksl_product_avinvf_certified(k, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(product_avinv_single)
LOOP(product_avinv_single, 4, DENSE_OR_ONE, 4, 12, 12, 12, 4, 4, 4)
LOOPS(product_avinv)

/* (3),(3)->(3),(3) */
OVER(cross_vv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vv_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_vv_double)
LOOP(cross_vv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(cross_vv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvf_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_vv_single)
LOOP(cross_vv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(cross_vv)

/* (3),(3)->(3),(3) */
OVER(cross_vvinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vvinv_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_vvinv_double)
LOOP(cross_vvinv_double, 4, DENSE_OR_ONE, 24, 24, 24, 24, 8, 8, 8, 8)

OVER(cross_vvinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvinvf_certified(&v1, &v2, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(cross_vvinv_single)
LOOP(cross_vvinv_single, 4, DENSE_OR_ONE, 12, 12, 12, 12, 4, 4, 4, 4)
LOOPS(cross_vvinv)

/* (3),()->(3),(3) */
OVER(add_vvx_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvx_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvx_double)
LOOP(add_vvx_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvx_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvx_single)
LOOP(add_vvx_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvx)

/* (3),()->(3),(3) */
OVER(add_vvxinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvxinv_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvxinv_double)
LOOP(add_vvxinv_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvxinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxinvf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvxinv_single)
LOOP(add_vvxinv_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvxinv)

/* (3),()->(3),(3) */
OVER(add_vvy_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvy_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvy_double)
LOOP(add_vvy_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvy_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvy_single)
LOOP(add_vvy_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvy)

/* (3),()->(3),(3) */
OVER(add_vvyinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvyinv_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvyinv_double)
LOOP(add_vvyinv_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvyinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyinvf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvyinv_single)
LOOP(add_vvyinv_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvyinv)

/* (3),()->(3),(3) */
OVER(add_vvz_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvz_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvz_double)
LOOP(add_vvz_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvz_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvz_single)
LOOP(add_vvz_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvz)

/* (3),()->(3),(3) */
OVER(add_vvzinv_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvzinv_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 1);
    STORE(vec3_double, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvzinv_double)
LOOP(add_vvzinv_double, 4, DENSE_OR_ONE, 24, 8, 24, 24, 8, 8, 8)

OVER(add_vvzinv_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzinvf_certified(&v, k, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 1);
    STORE(vec3_single, &vo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_vvzinv_single)
LOOP(add_vvzinv_single, 4, DENSE_OR_ONE, 12, 4, 12, 12, 4, 4, 4)
LOOPS(add_vvzinv)

const coscrew_gufunc TABLE(vec3)[] = {
  {"vec3_scale", "(3),()->(3),(3)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  self, self_bound: vector; a: number.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", vec3_scale_loops},
  {"axpy_vv", "(),(3),(3)->(3),(3)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(3),(3)->(3),(3).  a: number; x, y, y_bound: vector.\n"
    "6 mul, 9 add, 6 abs.\n",
   3, 2, "", axpy_vv_loops},
  {"xpy_vv", "(3),(3)->(3),(3)",
    "y = x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  x, y, y_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", xpy_vv_loops},
  {"nxpy_vv", "(3),(3)->(3),(3)",
    "y = -x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  x, y, y_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", nxpy_vv_loops},
  {"product_av", "(),(3)->(3),(3)",
    "vo = a vi; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(),(3)->(3),(3).  a: number; vi, vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", product_av_loops},
  {"add_vv", "(3),(3)->(3),(3)",
    "vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", add_vv_loops},
  {"subtract_vv", "(3),(3)->(3),(3)",
    "vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "3 mul, 3 add, 3 abs.\n",
   2, 2, "", subtract_vv_loops},
  {"vec3_scaled", "(3),()->(3),(3)",
    "vo = k v; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "6 mul, 3 add, 3 abs.\n",
   2, 2, "", vec3_scaled_loops},
  {"angle_vv", "(3),(3)->(),()",
    "angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or\n"
    "NaN.\n"
    "\n"
    "(3),(3)->(),().  v1, v2: vector; angle, angle_bound: number.\n"
    "196 mul, 311 add, 22 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4\n"
    "copysign, 37 less, 5 equal, 56 select.\n",
   2, 2, "", angle_vv_loops},
  {"dot_vv", "(3),(3)->(),()",
    "v1·v2; |error of dot| <= dot_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(),().  v1, v2: vector; dot, dot_bound: number.\n"
    "4 mul, 5 add, 3 abs.\n",
   2, 2, "", dot_vv_loops},
  {"product_avinv", "(),(3)->(3),(3)",
    "vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(),(3)->(3),(3).  k: number; v, vo, vo_bound: vector.\n"
    "6 mul, 3 add, 3 neg, 3 abs.\n",
   2, 2, "", product_avinv_loops},
  {"cross_vv", "(3),(3)->(3),(3)",
    "vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless\n"
    "products overflow.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_vv_loops},
  {"cross_vvinv", "(3),(3)->(3),(3)",
    "vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.\n"
    "9 mul, 9 add, 6 abs.\n",
   2, 2, "", cross_vvinv_loops},
  {"add_vvx", "(3),()->(3),(3)",
    "vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvx_loops},
  {"add_vvxinv", "(3),()->(3),(3)",
    "vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvxinv_loops},
  {"add_vvy", "(3),()->(3),(3)",
    "vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvy_loops},
  {"add_vvyinv", "(3),()->(3),(3)",
    "vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvyinv_loops},
  {"add_vvz", "(3),()->(3),(3)",
    "vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvz_loops},
  {"add_vvzinv", "(3),()->(3),(3)",
    "vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3),(3).  v, vo, vo_bound: vector; k: number.\n"
    "1 mul, 1 add, 1 abs.\n",
   2, 2, "", add_vvzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
