/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/vec3_accurate.h"

/* (3),()->(3) */
OVER(vec3_scale_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t self;
    double a;
    LOAD(vec3_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_vec3_scale_accurate(&self, a);
    STORE(vec3_double, &self, 2, 1);
  }
}
STRIDED_WITH_FMA(vec3_scale_double)
LOOP(vec3_scale_double, 3, DENSE, 24, 8, 24, 8, 8)

OVER(vec3_scale_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t self;
    float a;
    LOAD(vec3_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_vec3f_scale_accurate(&self, a);
    STORE(vec3_single, &self, 2, 1);
  }
}
STRIDED(vec3_scale_single)
LOOP(vec3_scale_single, 3, DENSE, 12, 4, 12, 4, 4)
LOOPS(vec3_scale)

/* (),(3),(3)->(3) */
OVER(axpy_vv_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t x;
    ksl_vec3_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &x, 1, 0);
    LOAD(vec3_double, &y, 2, 1);
    ksl_axpy_vv_accurate(a, &x, &y);
    STORE(vec3_double, &y, 3, 2);
  }
}
STRIDED_WITH_FMA(axpy_vv_double)
LOOP(axpy_vv_double, 4, DENSE_OR_ONE, 8, 24, 24, 24, 8, 8, 8)

OVER(axpy_vv_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t x;
    ksl_vec3f_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &x, 1, 0);
    LOAD(vec3_single, &y, 2, 1);
    ksl_axpy_vvf_accurate(a, &x, &y);
    STORE(vec3_single, &y, 3, 2);
  }
}
STRIDED(axpy_vv_single)
LOOP(axpy_vv_single, 4, DENSE_OR_ONE, 4, 12, 12, 12, 4, 4, 4)
LOOPS(axpy_vv)

/* (3),(3)->(3) */
OVER(xpy_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_xpy_vv_accurate(&x, &y);
    STORE(vec3_double, &y, 2, 2);
  }
}
STRIDED(xpy_vv_double)
LOOP(xpy_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(xpy_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_xpy_vvf_accurate(&x, &y);
    STORE(vec3_single, &y, 2, 2);
  }
}
STRIDED(xpy_vv_single)
LOOP(xpy_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(xpy_vv)

/* (3),(3)->(3) */
OVER(nxpy_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t x, &x);
  EACH {
    ksl_vec3_t y;
    LOAD_OTHER(vec3_double, &x);
    LOAD(vec3_double, &y, 1, 1);
    ksl_nxpy_vv_accurate(&x, &y);
    STORE(vec3_double, &y, 2, 2);
  }
}
STRIDED(nxpy_vv_double)
LOOP(nxpy_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(nxpy_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t x, &x);
  EACH {
    ksl_vec3f_t y;
    LOAD_OTHER(vec3_single, &x);
    LOAD(vec3_single, &y, 1, 1);
    ksl_nxpy_vvf_accurate(&x, &y);
    STORE(vec3_single, &y, 2, 2);
  }
}
STRIDED(nxpy_vv_single)
LOOP(nxpy_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(nxpy_vv)

/* (),(3)->(3) */
OVER(product_av_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_vec3_t vi;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &a);
    LOAD(vec3_double, &vi, 1, 0);
    ksl_product_av_accurate(a, &vi, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED_WITH_FMA(product_av_double)
LOOP(product_av_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_av_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_vec3f_t vi;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &a);
    LOAD(vec3_single, &vi, 1, 0);
    ksl_product_avf_accurate(a, &vi, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_av_single)
LOOP(product_av_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_av)

/* (3),(3)->(3) */
OVER(add_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_add_vv_accurate(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(add_vv_double)
LOOP(add_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(add_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_add_vvf_accurate(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(add_vv_single)
LOOP(add_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(add_vv)

/* (3),(3)->(3) */
OVER(subtract_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_subtract_vv_accurate(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED(subtract_vv_double)
LOOP(subtract_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(subtract_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_subtract_vvf_accurate(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(subtract_vv_single)
LOOP(subtract_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(subtract_vv)

/* (3),()->(3) */
OVER(vec3_scaled_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_vec3_scaled_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED_WITH_FMA(vec3_scaled_double)
LOOP(vec3_scaled_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(vec3_scaled_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_vec3f_scaled_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(vec3_scaled_single)
LOOP(vec3_scaled_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(vec3_scaled)

/* (3)->() */
OVER(vec3_l2norm_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    double norm;
    LOAD(vec3_double, &v, 0, 0);
    norm = ksl_vec3_l2norm_accurate(&v);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED_WITH_FMA(vec3_l2norm_double)
LOOP(vec3_l2norm_double, 2, DENSE, 24, 8, 8)

OVER(vec3_l2norm_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    float norm;
    LOAD(vec3_single, &v, 0, 0);
    norm = ksl_vec3f_l2norm_accurate(&v);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(vec3_l2norm_single)
LOOP(vec3_l2norm_single, 2, DENSE, 12, 4, 4)
LOOPS(vec3_l2norm)

/* (3)->(3) */
OVER(vec3_normalize_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t self;
    LOAD(vec3_double, &self, 0, 0);
    ksl_vec3_normalize_accurate(&self);
    STORE(vec3_double, &self, 1, 1);
  }
}
STRIDED_WITH_FMA(vec3_normalize_double)
LOOP(vec3_normalize_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_normalize_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t self;
    LOAD(vec3_single, &self, 0, 0);
    ksl_vec3f_normalize_accurate(&self);
    STORE(vec3_single, &self, 1, 1);
  }
}
STRIDED(vec3_normalize_single)
LOOP(vec3_normalize_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_normalize)

/* (3)->(3) */
OVER(vec3_normalized_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD(vec3_double, &v, 0, 0);
    ksl_vec3_normalized_accurate(&v, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED_WITH_FMA(vec3_normalized_double)
LOOP(vec3_normalized_double, 2, DENSE, 24, 24, 8, 8)

OVER(vec3_normalized_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD(vec3_single, &v, 0, 0);
    ksl_vec3f_normalized_accurate(&v, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(vec3_normalized_single)
LOOP(vec3_normalized_single, 2, DENSE, 12, 12, 4, 4)
LOOPS(vec3_normalized)

/* (3),(3)->() */
OVER(angle_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double angle;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    angle = ksl_angle_vv_accurate(&v1, &v2);
    STORE(scalar_double, &angle, 2, 2);
  }
}
STRIDED_WITH_FMA(angle_vv_double)
LOOP(angle_vv_double, 3, DENSE_OR_ONE, 24, 24, 8, 8, 8)

OVER(angle_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float angle;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    angle = ksl_angle_vvf_accurate(&v1, &v2);
    STORE(scalar_single, &angle, 2, 2);
  }
}
STRIDED(angle_vv_single)
LOOP(angle_vv_single, 3, DENSE_OR_ONE, 12, 12, 4, 4, 4)
LOOPS(angle_vv)

/* (3),(3)->() */
OVER(dot_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    double dot;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    dot = ksl_dot_vv_accurate(&v1, &v2);
    STORE(scalar_double, &dot, 2, 2);
  }
}
STRIDED_WITH_FMA(dot_vv_double)
LOOP(dot_vv_double, 3, DENSE_OR_ONE, 24, 24, 8, 8, 8)

OVER(dot_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    float dot;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    dot = ksl_dot_vvf_accurate(&v1, &v2);
    STORE(scalar_single, &dot, 2, 2);
  }
}
STRIDED(dot_vv_single)
LOOP(dot_vv_single, 3, DENSE_OR_ONE, 12, 12, 4, 4, 4)
LOOPS(dot_vv)

/* (),(3)->(3) */
OVER(product_avinv_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double k, &k);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &k);
    LOAD(vec3_double, &v, 1, 0);
    ksl_product_avinv_accurate(k, &v, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED_WITH_FMA(product_avinv_double)
LOOP(product_avinv_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_avinv_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float k, &k);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &k);
    LOAD(vec3_single, &v, 1, 0);
    ksl_product_avinvf_accurate(k, &v, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_avinv_single)
LOOP(product_avinv_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_avinv)

/* (),(3)->(3) */
OVER(product_ainvv_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double k, &k);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(scalar_double, &k);
    LOAD(vec3_double, &v, 1, 0);
    ksl_product_ainvv_accurate(k, &v, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED_WITH_FMA(product_ainvv_double)
LOOP(product_ainvv_double, 3, DENSE_OR_ONE, 8, 24, 24, 8, 8)

OVER(product_ainvv_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float k, &k);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(scalar_single, &k);
    LOAD(vec3_single, &v, 1, 0);
    ksl_product_ainvvf_accurate(k, &v, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(product_ainvv_single)
LOOP(product_ainvv_single, 3, DENSE_OR_ONE, 4, 12, 12, 4, 4)
LOOPS(product_ainvv)

/* (3),(3)->(3) */
OVER(cross_vv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vv_accurate(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED_WITH_FMA(cross_vv_double)
LOOP(cross_vv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(cross_vv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvf_accurate(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(cross_vv_single)
LOOP(cross_vv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(cross_vv)

/* (3),(3)->(3) */
OVER(cross_vvinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v1, &v1);
  EACH {
    ksl_vec3_t v2;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v1);
    LOAD(vec3_double, &v2, 1, 1);
    ksl_cross_vvinv_accurate(&v1, &v2, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED_WITH_FMA(cross_vvinv_double)
LOOP(cross_vvinv_double, 3, DENSE_OR_ONE, 24, 24, 24, 8, 8, 8)

OVER(cross_vvinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v1, &v1);
  EACH {
    ksl_vec3f_t v2;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v1);
    LOAD(vec3_single, &v2, 1, 1);
    ksl_cross_vvinvf_accurate(&v1, &v2, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(cross_vvinv_single)
LOOP(cross_vvinv_single, 3, DENSE_OR_ONE, 12, 12, 12, 4, 4, 4)
LOOPS(cross_vvinv)

/* (3),()->(3) */
OVER(add_vvx_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvx_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvx_double)
LOOP(add_vvx_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvx_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvx_single)
LOOP(add_vvx_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvx)

/* (3),()->(3) */
OVER(add_vvxinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvxinv_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvxinv_double)
LOOP(add_vvxinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvxinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvxinvf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvxinv_single)
LOOP(add_vvxinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvxinv)

/* (3),()->(3) */
OVER(add_vvy_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvy_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvy_double)
LOOP(add_vvy_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvy_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvy_single)
LOOP(add_vvy_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvy)

/* (3),()->(3) */
OVER(add_vvyinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvyinv_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvyinv_double)
LOOP(add_vvyinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvyinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvyinvf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvyinv_single)
LOOP(add_vvyinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvyinv)

/* (3),()->(3) */
OVER(add_vvz_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvz_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvz_double)
LOOP(add_vvz_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvz_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvz_single)
LOOP(add_vvz_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvz)

/* (3),()->(3) */
OVER(add_vvzinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t v, &v);
  EACH {
    double k;
    ksl_vec3_t vo;
    LOAD_OTHER(vec3_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_add_vvzinv_accurate(&v, k, &vo);
    STORE(vec3_double, &vo, 2, 1);
  }
}
STRIDED(add_vvzinv_double)
LOOP(add_vvzinv_double, 3, DENSE_OR_ONE, 24, 8, 24, 8, 8)

OVER(add_vvzinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t v, &v);
  EACH {
    float k;
    ksl_vec3f_t vo;
    LOAD_OTHER(vec3_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_add_vvzinvf_accurate(&v, k, &vo);
    STORE(vec3_single, &vo, 2, 1);
  }
}
STRIDED(add_vvzinv_single)
LOOP(add_vvzinv_single, 3, DENSE_OR_ONE, 12, 4, 12, 4, 4)
LOOPS(add_vvzinv)

const coscrew_gufunc TABLE(vec3)[] = {
  {"vec3_scale", "(3),()->(3)",
    "self = a self.\n"
    "\n"
    "(3),()->(3).  self: vector; a: number.\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scale_loops},
  {"axpy_vv", "(),(3),(3)->(3)",
    "y = a x + y.\n"
    "\n"
    "(),(3),(3)->(3).  a: number; x, y: vector.\n"
    "3 mul, 18 add, 3 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   3, 1, "", axpy_vv_loops},
  {"xpy_vv", "(3),(3)->(3)",
    "y = x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_vv_loops},
  {"nxpy_vv", "(3),(3)->(3)",
    "y = -x + y.\n"
    "\n"
    "(3),(3)->(3).  x, y: vector.\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_vv_loops},
  {"product_av", "(),(3)->(3)",
    "vo = a vi.\n"
    "\n"
    "(),(3)->(3).  a: number; vi, vo: vector.\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_av_loops},
  {"add_vv", "(3),(3)->(3)",
    "vo = v1 + v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vv_loops},
  {"subtract_vv", "(3),(3)->(3)",
    "vo = v1 - v2.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "21 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_vv_loops},
  {"vec3_scaled", "(3),()->(3)",
    "vo = k v.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec3_scaled_loops},
  {"vec3_l2norm", "(3)->()",
    "|v| = sqrt(v·v).\n"
    "\n"
    "(3)->().  v: vector; norm: number.\n"
    "10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 3 abs, 8 less, 2 equal, 10\n"
    "select.\n",
   1, 1, "", vec3_l2norm_loops},
  {"vec3_normalize", "(3)->(3)",
    "self = self / |self|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  self: vector.\n"
    "25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13\n"
    "select.\n",
   1, 1, "", vec3_normalize_loops},
  {"vec3_normalized", "(3)->(3)",
    "vo = v / |v|; the zero vector stays zero.\n"
    "\n"
    "(3)->(3).  v, vo: vector.\n"
    "25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13\n"
    "select.\n",
   1, 1, "", vec3_normalized_loops},
  {"angle_vv", "(3),(3)->()",
    "angle = atan2(|v1 × v2|, v1·v2), in [0, π].\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; angle: number.\n"
    "164 mul, 333 add, 22 product error, 12 product rest, 8 div, 1 sqrt, 4 neg, 19 abs, 4\n"
    "copysign, 35 less, 6 equal, 51 select.  Each component is within 1 ulp as long as its\n"
    "condition is below 1e13; in single precision it is the nearest number, except near ties, as\n"
    "long as that is below 1e5; searched, not proved.\n",
   2, 1, "", angle_vv_loops},
  {"dot_vv", "(3),(3)->()",
    "v1·v2.\n"
    "\n"
    "(3),(3)->().  v1, v2: vector; dot: number.\n"
    "3 mul, 11 add, 3 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", dot_vv_loops},
  {"product_avinv", "(),(3)->(3)",
    "vo = k (-v).\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_avinv_loops},
  {"product_ainvv", "(),(3)->(3)",
    "vo = v / k.\n"
    "\n"
    "(),(3)->(3).  k: number; v, vo: vector.\n"
    "3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.\n",
   2, 1, "", product_ainvv_loops},
  {"cross_vv", "(3),(3)->(3)",
    "vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_vv_loops},
  {"cross_vvinv", "(3),(3)->(3)",
    "vo = v1 × (-v2).\n"
    "\n"
    "(3),(3)->(3).  v1, v2, vo: vector.\n"
    "6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_vvinv_loops},
  {"add_vvx", "(3),()->(3)",
    "vo = v + k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvx_loops},
  {"add_vvxinv", "(3),()->(3)",
    "vo = v - k e_x.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvxinv_loops},
  {"add_vvy", "(3),()->(3)",
    "vo = v + k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvy_loops},
  {"add_vvyinv", "(3),()->(3)",
    "vo = v - k e_y.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvyinv_loops},
  {"add_vvz", "(3),()->(3)",
    "vo = v + k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvz_loops},
  {"add_vvzinv", "(3),()->(3)",
    "vo = v - k e_z.\n"
    "\n"
    "(3),()->(3).  v, vo: vector; k: number.\n"
    "7 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_vvzinv_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
